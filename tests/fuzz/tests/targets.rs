//! Every reader survives damaged files, and the search finds planted faults.

use fuzz::{Target, duration, fuzz, targets};
use std::time::Duration;

/// Tests of the targets by name, so that a failure names one and one can be chosen.
macro_rules! targets {
    ($($name:ident),*) => {
        const NAMES: &[&str] = &[$(stringify!($name)),*];
        $(#[test]
        fn $name() {
            let target = targets::ALL.iter().find(|target| target.name == stringify!($name)).expect("in the list");
            let files = fuzz(target, duration()).unwrap_or_else(|fault| panic!("{fault}"));
            println!("{}: {files} files", target.name);
        })*
    };
}

targets!(obj, ply, stl, gltf, compressed, view, tree, rays, hits, machine, liberty, exr, png, listing, sweep);

#[test]
fn every_target_is_fuzzed() {
    let names: Vec<&str> = targets::ALL.iter().map(|target| target.name).collect();
    assert_eq!(names, NAMES);
}

/// A reader with a fault is one of which a search of a second finds it, in its smallest form.
fn found(read: fn(&[u8])) -> String {
    let target =
        Target { name: "planted", seeds: || vec![b"count 3\nx 1 2 3\n".to_vec()], read, most_bytes: 1 << 20 };
    fuzz(&target, Duration::from_secs(20)).expect_err("the fault")
}

#[test]
fn a_panic_is_found() {
    let fault = found(|bytes| assert!(!bytes.windows(3).any(|word| word == b"nan"), "it is no number"));
    assert!(fault.contains("panics") && fault.contains("nan"), "{fault}");
}

#[test]
fn memory_by_a_declared_count_is_found() {
    let fault = found(|bytes| {
        let text = String::from_utf8_lossy(bytes);
        let count = text.split_whitespace().nth(1).and_then(|word| word.parse::<usize>().ok());
        let count = count.filter(|count| *count < 1 << 33).unwrap_or(0);
        drop(Vec::<u8>::with_capacity(count));
    });
    assert!(fault.contains("takes 42949"), "{fault}");
}
