//! Which colour a series has.

use plotters::prelude::RGBColor;

/// The colours of structures, which are the same in all charts. Okabe and Ito chose the lighter ones, which colour-blind readers can
/// tell apart; a variant of a structure is a darker or lighter shade.
const STRUCTURES: [(&str, RGBColor); 13] = [
    ("dst", RGBColor(0, 114, 178)),
    ("dst-sw", RGBColor(86, 180, 233)),
    ("dst_scratch", RGBColor(0, 58, 92)),
    ("bvh2", RGBColor(230, 159, 0)),
    ("bvh2+", RGBColor(158, 104, 0)),
    ("bvh4", RGBColor(0, 158, 115)),
    ("bvh4+", RGBColor(0, 86, 62)),
    ("bvh8", RGBColor(204, 121, 167)),
    ("bvh8+", RGBColor(132, 52, 96)),
    ("bvh16", RGBColor(120, 120, 120)),
    ("qbvh2", RGBColor(240, 228, 66)),
    ("qbvh4", RGBColor(102, 204, 170)),
    ("qbvh8", RGBColor(236, 178, 210)),
];

/// The colours of all other series, in their order. None is the colour of a structure.
const OTHERS: [RGBColor; 6] = [
    RGBColor(213, 94, 0),
    RGBColor(70, 70, 70),
    RGBColor(110, 140, 40),
    RGBColor(120, 80, 180),
    RGBColor(0, 150, 160),
    RGBColor(170, 170, 170),
];

/// Colour of the series `name`, the `index`th of its chart.
pub fn colour(name: &str, index: usize) -> RGBColor {
    let structure = STRUCTURES.iter().find(|(structure, _)| *structure == name);
    structure.map_or(OTHERS[index % OTHERS.len()], |(_, colour)| *colour)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn no_two_series_share_a_colour() {
        let all = STRUCTURES.iter().map(|(_, colour)| colour).chain(&OTHERS);
        let distinct: BTreeSet<(u8, u8, u8)> = all.map(|colour| (colour.0, colour.1, colour.2)).collect();
        assert_eq!(distinct.len(), STRUCTURES.len() + OTHERS.len());
        assert_eq!(colour("bvh2", 0), colour("bvh2", 5));
        assert_ne!(colour("DRAM", 0), colour("cache", 1));
    }
}
