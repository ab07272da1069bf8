//! The listings of the machine's programs are what their sources give.

use std::process::Command;

#[test]
fn listings_are_what_the_sources_give() {
    if !testing::tools::available("clang-14") {
        return;
    }
    let output = Command::new(env!("CARGO_BIN_EXE_xtask")).args(["kernels", "--check"]).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
}
