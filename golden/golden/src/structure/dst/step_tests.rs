//! Every node code in every octant, by the table of the module's header.

use super::super::header::{HEADER, Header};
use super::*;
use crate::{Mode, Ray, TraversalRay};

/// The rays from the zero point along all diagonals, on which the plane at `signs[k] * t` of axis `k` is met at `t`.
fn diagonals() -> impl Iterator<Item = ([f32; 3], TraversalRay)> {
    (0..8).map(|octant| {
        let signs = [0, 1, 2].map(|axis| if octant >> axis & 1 == 0 { 1.0 } else { -1.0 });
        (signs, TraversalRay::new(&Ray::new([0.0; 3], signs), Mode::Fast).unwrap())
    })
}

fn visit(header: Header, planes: [f32; 2], ray: &TraversalRay, [t_min, t_max]: [f32; 2]) -> Step {
    step([header.encode(), planes[0].to_bits(), planes[1].to_bits()], ray, t_min, t_max)
}

#[test]
fn a_split_orders_its_children_and_cuts_their_intervals() {
    for (signs, ray) in diagonals() {
        for (axis, left_words) in [(0, 1), (1, 3), (2, 1)] {
            let header = Header::Split { axis, left_words, offset: 7 };
            let sign = signs[axis as usize];
            let (first, second) = if sign > 0.0 { (7, 7 + left_words) } else { (7 + left_words, 7) };
            // The near child ends at `exit`, and the far one begins at `entry`.
            let at = |exit: f32, entry: f32| {
                let planes = if sign > 0.0 { [exit, entry] } else { [-entry, -exit] };
                visit(header, planes, &ray, [1.0, 9.0])
            };
            let near = |t_max: f32| Child { offset: first, t_min: 1.0, t_max };
            let far = |t_min: f32| Child { offset: second, t_min, t_max: 9.0 };
            assert_eq!(at(4.0, 3.0), Step { code: Code::Two, near: near(4.0), far: far(3.0) });
            assert_eq!(at(3.0, 4.0), Step { code: Code::Two, near: near(3.0), far: far(4.0) });
            assert_eq!(at(1.0, 9.0), Step { code: Code::Two, near: near(1.0), far: far(9.0) });
            assert_eq!(at(10.0, 0.5), Step { code: Code::Two, near: near(9.0), far: far(1.0) });
            let one = at(3.0, 9.5);
            assert_eq!((one.code, one.near), (Code::One, near(3.0)));
            let one = at(0.5, 4.0);
            assert_eq!((one.code, one.near), (Code::One, far(4.0)));
            assert_eq!(at(0.5, 9.5).code, Code::Miss);
        }
    }
}

#[test]
fn a_carve_of_one_axis_cuts_both_ends() {
    for (signs, ray) in diagonals() {
        for axis in 0..3 {
            for (leaf, found) in [(false, Code::One), (true, Code::Leaf)] {
                let header = Header::CarveSingle { axis, leaf, offset: 5 };
                let sign = signs[axis as usize];
                let at = |entry: f32, exit: f32| {
                    let planes = if sign > 0.0 { [exit, entry] } else { [-entry, -exit] };
                    visit(header, planes, &ray, [1.0, 9.0])
                };
                for ([entry, exit], [t_min, t_max]) in
                    [([2.0, 4.0], [2.0, 4.0]), ([3.0, 3.0], [3.0, 3.0]), ([0.5, 9.5], [1.0, 9.0])]
                {
                    let outcome = at(entry, exit);
                    assert_eq!((outcome.code, outcome.near), (found, Child { offset: 5, t_min, t_max }));
                }
                assert_eq!(at(4.0, 2.0).code, Code::Miss);
                assert_eq!(at(0.0, 0.5).code, Code::Miss);
                assert_eq!(at(9.5, 10.0).code, Code::Miss);
            }
        }
    }
}

/// A min side is entered by a ray towards greater coordinates, and left by one towards smaller ones.
#[test]
fn a_carve_of_two_axes_cuts_the_end_that_each_side_is() {
    for (signs, ray) in diagonals() {
        for axes in [[0, 1], [0, 2], [1, 2]] {
            for is_min in [[false, false], [false, true], [true, false], [true, true]] {
                for (leaf, found) in [(false, Code::One), (true, Code::Leaf)] {
                    let header = Header::CarveDual { axes, is_min, leaf, offset: 5 };
                    let sign = axes.map(|axis| signs[axis as usize]);
                    let outcome = visit(header, [2.0 * sign[0], 3.0 * sign[1]], &ray, [1.0, 9.0]);
                    let is_entry = [0, 1].map(|i| is_min[i] == (sign[i] > 0.0));
                    let expected = match is_entry {
                        [true, true] => Some((3.0, 9.0)),
                        [true, false] => Some((2.0, 3.0)),
                        [false, true] => None,
                        [false, false] => Some((1.0, 2.0)),
                    };
                    match expected {
                        None => assert_eq!(outcome.code, Code::Miss),
                        Some((t_min, t_max)) => {
                            assert_eq!(
                                (outcome.code, outcome.near),
                                (found, Child { offset: 5, t_min, t_max })
                            );
                        }
                    }
                }
            }
        }
    }
}

#[test]
fn a_bare_leaf_keeps_the_interval() {
    let (_, ray) = diagonals().next().unwrap();
    let here = Child { offset: 11, t_min: 1.0, t_max: 9.0 };
    let outcome = visit(Header::Leaf { first_triangle: 11 }, [f32::NAN; 2], &ray, [1.0, 9.0]);
    assert_eq!(outcome, Step { code: Code::Leaf, near: here, far: here });
}

/// A ray in the plane that it runs along meets that plane at no distance.
#[test]
fn a_plane_that_the_ray_lies_in_cuts_nothing() {
    let ray = TraversalRay::new(&Ray::new([2.0, 0.0, 0.0], [0.0, 1.0, 0.0]), Mode::Fast).unwrap();
    let outcome = visit(Header::CarveSingle { axis: 0, leaf: true, offset: 5 }, [2.0; 2], &ray, [1.0, 9.0]);
    assert_eq!((outcome.code, outcome.near), (Code::Leaf, Child { offset: 5, t_min: 1.0, t_max: 9.0 }));
    let outcome = visit(Header::Split { axis: 0, left_words: 3, offset: 5 }, [2.0; 2], &ray, [1.0, 9.0]);
    assert_eq!(outcome.code, Code::Two);
}

/// The reserved axis 3 is z, as in hardware; other reserved codes end in some result.
#[test]
fn reserved_codes_do_not_panic() {
    for (_, ray) in diagonals() {
        for code in 0..1u32 << HEADER.width {
            let words = |code: u32| [code << HEADER.low | 9, 3.0f32.to_bits(), 4.0f32.to_bits()];
            let outcome = step(words(code), &ray, 1.0, 9.0);
            if Header::decode(words(code)[0]).is_none() && code >> 3 == 0b011 {
                assert_eq!(outcome, step(words(code & !0b001_000), &ray, 1.0, 9.0), "{code:06b}");
            }
        }
    }
}
