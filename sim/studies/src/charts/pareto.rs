//! The Pareto front: the points that no other point dominates.

/// For each point, whether no other point is at least as good in every quantity and better in one. Less is better.
#[must_use]
pub fn front<const N: usize>(points: &[[f64; N]]) -> Vec<bool> {
    let dominates = |a: &[f64; N], b: &[f64; N]| a.iter().zip(b).all(|(a, b)| a <= b) && a != b;
    points.iter().map(|point| !points.iter().any(|other| dominates(other, point))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dominated_points_are_not_on_the_front() {
        let points = [[1.0, 5.0], [2.0, 3.0], [3.0, 3.0], [4.0, 1.0], [4.0, 1.0], [5.0, 0.5]];
        assert_eq!(front(&points), [true, true, false, true, true, true]);
        assert_eq!(front::<2>(&[]), [false; 0]);
    }
}
