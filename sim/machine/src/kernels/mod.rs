//! The programs' sources and listings, as they are given to those who write their own.

mod tidy;

pub use tidy::statement;

/// Numbers of the words of the parameter block at the start of memory, as `trax.h` has them behind `PARAM_`.
pub(crate) mod parameter {
    pub const RAYS: usize = 1;
    pub const BOUNCES: usize = 2;
    pub const INVERSE_WIDTH: usize = 3;
    pub const WIDTH: usize = 4;
    pub const OUT: usize = 7;
    pub const NODES: usize = 8;
    pub const TRIANGLES: usize = 9;
    pub const PADDING: usize = 10;
    pub const EXTENT: usize = 11;
    pub const RAY_BASE: usize = 14;
    pub const CAMERA: usize = 16;
    pub const LIGHT: usize = 28;
    pub const BACKGROUND: usize = 34;
    pub const ROOT: usize = 40;
    /// Words of the block.
    pub const COUNT: usize = 64;
}

/// Options with which programs are compiled.
pub const OPTIONS: &str = include_str!("../../kernels/clang.options");

/// Listings, sources and definitions, one listing a line.
const LISTINGS: &str = include_str!("../../kernels/listings.txt");

macro_rules! files {
    ($($name:literal)*) => { [$(($name, include_str!(concat!("../../kernels/", $name)))),*] };
}

/// Names and contents of the files: what programs include, the example, and the listings of all structures.
pub const FILES: [(&str, &str); 15] = files! {
    "trax.h" "frame.c" "traversal.h" "clang.options" "examples/no-t-min.c"
    "dst.s" "dst-sw.s" "bvh2.s" "bvh2-parallel.s" "bvh-wide.s" "bvh-wide-parallel.s"
    "bvh2-words.s" "bvh2-parallel-words.s" "bvh-wide-words.s" "bvh-wide-parallel-words.s"
};

/// The content of the file `name` of [`FILES`].
#[must_use]
pub fn file(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(known, _)| *known == name).map(|(_, content)| *content)
}

/// What is defined where the listing `name` is compiled, each as `NAME` or `NAME=VALUE`.
#[must_use]
pub fn defines(name: &str) -> Vec<&'static str> {
    let mut lines = LISTINGS.lines().map(str::split_whitespace);
    lines.find_map(|mut line| (line.next() == Some(name)).then(|| line.skip(1).collect())).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::description::{Bytes, NodeLayout};
    use crate::frame::MachineStructure;

    #[test]
    fn every_structure_has_a_listing_and_a_definition() {
        for structure in MachineStructure::ALL {
            for layout in [NodeLayout::default(), NodeLayout { alignment: Bytes(64) }] {
                assert!(structure.listing(layout).contains("main:"), "{structure}");
                let defines = structure.defines(layout);
                let is_bvh = defines.iter().any(|name| name.starts_with("BVH="));
                assert!(is_bvh || defines.iter().any(|name| name.starts_with("DST")));
                assert_eq!(defines.contains(&"PARALLEL"), structure.name().ends_with('+'), "{structure}");
                assert_eq!(defines.contains(&"WORD_OFFSETS"), is_bvh && !layout.is_packed(), "{structure}");
            }
        }
    }

    #[test]
    fn parameters_have_the_numbers_of_the_header() {
        let header = file("trax.h").unwrap();
        let of = |line: &str| -> Option<(String, usize)> {
            let (name, number) = line.trim().strip_prefix("PARAM_")?.split_once(" = ")?;
            Some((name.to_owned(), number.split(',').next()?.parse().ok()?))
        };
        let found: Vec<(String, usize)> = header.lines().filter_map(of).collect();
        let expected = [
            ("RAYS", parameter::RAYS),
            ("BOUNCES", parameter::BOUNCES),
            ("INVERSE_WIDTH", parameter::INVERSE_WIDTH),
            ("WIDTH", parameter::WIDTH),
            ("OUT", parameter::OUT),
            ("NODES", parameter::NODES),
            ("TRIANGLES", parameter::TRIANGLES),
            ("PADDING", parameter::PADDING),
            ("EXTENT", parameter::EXTENT),
            ("RAY_BASE", parameter::RAY_BASE),
            ("CAMERA", parameter::CAMERA),
            ("LIGHT", parameter::LIGHT),
            ("BACKGROUND", parameter::BACKGROUND),
            ("ROOT", parameter::ROOT),
        ];
        assert_eq!(found, expected.map(|(name, number)| (name.to_owned(), number)));
        const { assert!(parameter::ROOT + 7 <= parameter::COUNT) }
    }

    #[test]
    fn a_tidied_listing_is_tidy() {
        let again: String = file("dst.s").unwrap().lines().filter_map(statement).collect();
        assert_eq!(again, file("dst.s").unwrap());
        assert_eq!(statement("\t.word\t5\t# five"), Some("    .word 5\n".to_owned()));
        assert_eq!(statement("$tmp12:"), None);
    }
}
