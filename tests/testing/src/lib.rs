//! What the tests of all crates share: external tools, data outside the repository, and the switch for long tests.
//!
//! A test that cannot run says so on its output and passes. Where `CI` is set, a missing tool is a failure.
//!
//! ```
//! use std::sync::atomic::{AtomicU32, Ordering};
//!
//! let sum = AtomicU32::new(0);
//! testing::tools::in_parallel([1, 2, 3], |n| { sum.fetch_add(n, Ordering::Relaxed); });
//! assert_eq!(sum.into_inner(), 6);
//!
//! if testing::long("the example's long part") {
//!     println!("DUALSPLIT_LONG or CI is set");
//! }
//! ```

pub mod python;
pub mod tools;

use std::path::PathBuf;

/// The path of a file or folder of the data that `DUALSPLIT_DATA` names. If the variable is not set, prints a message
/// and returns `None`.
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

/// Whether the long tests run: those in volume, those that synthesise, and long proofs. They run where `DUALSPLIT_LONG` or `CI`
/// is set. Otherwise the function prints that `what` was left out.
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
