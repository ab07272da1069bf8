//! The knee of a curve of diminishing returns.

/// Index of the point that lies farthest below the straight line between both ends, with positions and values scaled to 0..1.
///
/// The method is that of Satopaa, Albrecht, Irwin, Raghavan, "Finding a 'Kneedle' in a haystack", ICDCSW 2011, for one falling
/// curve without noise. Among equally far points the first is returned, and for a curve that does not fall its first point.
///
/// # Panics
/// If there is no point.
#[must_use]
pub fn of_falling(points: &[(f64, f64)]) -> usize {
    let (first, last) = (points[0], points[points.len() - 1]);
    let (width, height) = (last.0 - first.0, first.1 - last.1);
    if width <= 0.0 || height <= 0.0 {
        return 0;
    }
    let below = |&(x, y): &(f64, f64)| (last.0 - x) / width - (y - last.1) / height;
    (0..points.len()).fold(0, |best, i| if below(&points[i]) > below(&points[best]) { i } else { best })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_bend_is_found() {
        let curve = [(0.0, 1.0), (1.0, 0.5), (2.0, 0.1), (3.0, 0.09), (4.0, 0.08)];
        assert_eq!(of_falling(&curve), 2);
        assert_eq!(of_falling(&[(0.0, 1.0), (1.0, 1.0)]), 0);
        assert_eq!(of_falling(&[(5.0, 2.0)]), 0);
    }
}
