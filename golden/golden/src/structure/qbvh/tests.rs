//! Grids, and what validation finds.

use super::*;
use crate::build::{BinaryTree, BuildOptions, Quality, build, collapse_wide};
use crate::bvh::Bvh;
use crate::structure::pack_triangles;
use proptest::prelude::*;
use scenes::{MAX_COORDINATE, Scene};

fn hairball() -> (BinaryTree, Arc<[Triangle]>) {
    let scene = Scene::load("hairball", 0.001, 0).unwrap();
    let tree = build(&scene.mesh, &BuildOptions::new(Quality::Fast)).unwrap();
    let triangles = pack_triangles(&scene.mesh, &tree);
    (tree, triangles)
}

fn encoded<const N: usize>() -> QBvh<N> {
    let (tree, triangles) = hairball();
    QBvh::encode(&collapse_wide(&tree), &triangles)
}

/// Compares the boxes of `narrow` with those of the exact hierarchy of the same shape.
fn compare<const N: usize>() {
    let (tree, triangles) = hairball();
    let wide = collapse_wide::<N>(&tree);
    let (exact, narrow) = (Bvh::<N>::encode(&wide, Arc::clone(&triangles)), QBvh::encode(&wide, &triangles));
    narrow.validate().unwrap();
    let mut stack = vec![(exact.root, narrow.root)];
    while let Some((exact_word, narrow_word)) = stack.pop() {
        assert_eq!(LEAF.get(exact_word), LEAF.get(narrow_word));
        if LEAF.get(exact_word) == 1 {
            let first = |triangles: &[Triangle], slot: u32| triangles[slot as usize].index();
            let slots = (Bvh::<N>::INDEX.get(exact_word), QBvh::<N>::INDEX.get(narrow_word));
            assert_eq!(first(&exact.triangles, slots.0), first(&narrow.triangles, slots.1));
            continue;
        }
        let (exact, narrow) = (exact.children(exact_word), narrow.siblings(narrow_word));
        assert_eq!(exact.len(), narrow.len());
        for (exact, narrow) in exact.iter().zip(narrow.iter()) {
            assert!(narrow.aabb.contains(&exact.aabb), "{:?} in {:?}", exact.aabb, narrow.aabb);
            stack.push((exact.word, narrow.word));
        }
    }
}

#[test]
fn every_box_contains_that_of_the_exact_hierarchy() {
    compare::<2>();
    compare::<4>();
    compare::<8>();
}

#[test]
fn sizes_are_those_of_the_format() {
    assert_eq!([Node::<2>::BYTES, Node::<4>::BYTES, Node::<8>::BYTES], [40, 52, 80]);
    let tree = encoded::<8>();
    let bytes = tree.node_bytes() as f64 / tree.triangles.len() as f64;
    assert!(bytes < 12.0, "{bytes} bytes a triangle");
}

/// Bits all over the nodes, turned over one at a time.
#[test]
fn damage_is_found() {
    let tree = encoded::<4>();
    let damaged = |change: &dyn Fn(&mut QBvh<4>)| {
        let mut tree = tree.clone();
        change(&mut tree);
        tree.validate().is_err()
    };
    let bits = 32 * tree.words.len();
    // An odd distance, so that every place in a word is met.
    for bit in (0..bits).step_by((bits / 500) | 1) {
        assert!(damaged(&|tree| tree.words[bit / 32] ^= 1 << (bit % 32)), "bit {bit}");
    }
    for bit in 0..32 {
        assert!(damaged(&|tree| tree.root ^= 1 << bit), "bit {bit} of the root");
        assert!(damaged(
            &|tree| tree.root_box.min[0] = f32::from_bits(tree.root_box.min[0].to_bits() ^ 1 << bit)
        ));
    }
    assert!(damaged(&|tree| tree.words.truncate(Node::<4>::WORDS)));
    assert!(damaged(&|tree| tree.words.extend_from_within(..Node::<4>::WORDS)));
}

/// Two coordinates in order, of any size and distance.
fn interval() -> impl Strategy<Value = [f32; 2]> {
    let coordinate = || {
        prop_oneof![
            any::<f32>().prop_filter("a coordinate", |x| x.abs() <= MAX_COORDINATE),
            -1000.0f32..1000.0,
            (-100i8..100).prop_map(f32::from),
        ]
    };
    let near = (coordinate(), 0u32..1000).prop_map(|(low, ulps)| {
        let high = f32::from_bits(low.to_bits().saturating_add(ulps));
        if high.abs() <= MAX_COORDINATE { [low.min(high), low.max(high)] } else { [low; 2] }
    });
    prop_oneof![(coordinate(), coordinate()).prop_map(|(a, b)| [a.min(b), a.max(b)]), near]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    /// Decoded planes are exact numbers around the box, none can be moved inward, and no step can be halved.
    #[test]
    fn planes_are_the_nearest_outside_on_the_finest_grid(
        outer in prop::array::uniform3(interval()),
        shares in prop::array::uniform3([0.0f64..=1.0, 0.0f64..=1.0]),
    ) {
        let bounds = Aabb { min: outer.map(|[low, _]| low + 0.0), max: outer.map(|[_, high]| high + 0.0) };
        let inside = |axis: usize, share: f64| {
            let [low, high] = outer[axis].map(f64::from);
            ((low + (high - low) * share) as f32).clamp(outer[axis][0], outer[axis][1]) + 0.0
        };
        let sides: [[f32; 2]; 3] = std::array::from_fn(|axis| {
            let [a, b] = shares[axis].map(|share| inside(axis, share));
            [a.min(b), a.max(b)]
        });
        let inner = Aabb { min: sides.map(|side| side[0]), max: sides.map(|side| side[1]) };
        let children = [bounds, inner].map(|aabb| Child { triangles: 1, aabb });
        let words = node::encode::<2>(&children, 1, 0);
        let node = Node::<2>::new(&words);
        for (child, exact) in [bounds, inner].into_iter().enumerate() {
            let found = node.aabb(child);
            prop_assert!(found.contains(&exact));
            for axis in 0..3 {
                let step = f64::from(f32::from_bits((words[3] >> (8 * axis) & 0xff) << 23));
                let [min, max, low, high] =
                    [found.min[axis], found.max[axis], exact.min[axis], exact.max[axis]].map(f64::from);
                prop_assert_eq!([min / step, max / step], [(low / step).floor(), (high / step).ceil()]);
                // The decoded numbers are the planes themselves.
                let origin = f64::from(f32::from_bits(words[axis])) / step;
                for steps in [min / step - origin, max / step - origin] {
                    prop_assert_eq!(steps, steps.round());
                    prop_assert!((0.0..=255.0).contains(&steps));
                }
                // Half of the step would not reach around the box, or have planes that are no binary32 numbers.
                let [first, last] = [bounds.min[axis], bounds.max[axis]].map(|x| f64::from(x) * 2.0 / step);
                let reaches = last.ceil() - first.floor() <= 255.0;
                let fits = (first.floor() + 255.0).abs().max(first.floor().abs()) <= 16_777_216.0;
                prop_assert!(!(reaches && fits) || step == f64::from(f32::MIN_POSITIVE), "{} steps", last - first);
            }
        }
    }
}
