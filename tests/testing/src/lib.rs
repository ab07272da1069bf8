//! What tests of all crates share: external tools, data outside the repository, and the switch for long tests.
//!
//! A test that cannot run says so on its output. Where `CI` is set, a missing tool is a failure.

pub mod tools;

use std::path::PathBuf;

/// The path of a file or folder of the data that `DUALSPLIT_DATA` names, or `None` with a word on the output where the
/// variable is not set.
///
/// # Panics
/// If the variable is set and there is no such file.
#[must_use]
pub fn data(name: &str) -> Option<PathBuf> {
    let Some(folder) = std::env::var_os("DUALSPLIT_DATA") else {
        println!("skipped: DUALSPLIT_DATA does not name a folder that holds {name}");
        return None;
    };
    let path = PathBuf::from(folder).join(name);
    assert!(path.exists(), "{} is missing, and DUALSPLIT_DATA is set", path.display());
    Some(path)
}

/// Whether tests that take long are to be run: in volume, with synthesis, or by long proofs. They are where `DUALSPLIT_LONG` or
/// `CI` is set; otherwise a word on the output says that `what` was left out.
#[must_use]
pub fn long(what: &str) -> bool {
    let long = is_long();
    if !long {
        println!("skipped: {what}, as DUALSPLIT_LONG is not set");
    }
    long
}

/// How many cases a test tries: `long` where `DUALSPLIT_LONG` or `CI` is set, otherwise `short`.
#[must_use]
pub fn cases(long: u64, short: u64) -> u64 {
    if is_long() { long } else { short }
}

fn is_long() -> bool {
    ["DUALSPLIT_LONG", "CI"].iter().any(|name| std::env::var_os(name).is_some())
}
