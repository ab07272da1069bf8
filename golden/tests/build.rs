//! Properties of every tree that the builder makes.

mod support;

use golden::build::{BuildOptions, Quality, build};
use support::soup;

const QUALITIES: [Quality; 3] = [Quality::Fast, Quality::Medium, Quality::High];

#[test]
fn adversarial_meshes_give_valid_trees() {
    let identical = soup((0..100_000).map(|_| [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]]));
    for quality in QUALITIES {
        let tree = build(&identical, &BuildOptions::new(quality)).expect("a tree");
        tree.validate(&identical).expect("a hierarchy");
    }
}
