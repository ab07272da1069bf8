//! Finds and runs the Verilog tools.

use std::path::Path;
use std::process::Command;
use std::sync::Mutex;

/// Whether a tool can be run. If it cannot, prints a message, or panics where `CI` is set.
///
/// # Panics
/// Where `CI` is set and the tool is missing.
#[must_use]
pub fn available(tool: &str) -> bool {
    let found = Command::new(tool).arg("-V").output().is_ok();
    assert!(found || std::env::var_os("CI").is_none(), "{tool} is missing, and CI is set");
    if !found {
        println!("skipped: {tool} is not installed");
    }
    found
}

/// Runs a command in a folder, and returns what it printed on both streams.
///
/// # Errors
/// The same text when it fails.
///
/// # Panics
/// If it cannot be started.
pub fn run(folder: &Path, command: &str, arguments: &[&str]) -> Result<String, String> {
    let output = Command::new(command).args(arguments).current_dir(folder).output().unwrap();
    let text =
        String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
    if output.status.success() { Ok(text) } else { Err(text) }
}

/// Whether yosys and ABC can be run, as [`available`].
///
/// # Panics
/// Where `CI` is set and one is missing.
#[must_use]
pub fn provers_available() -> bool {
    available("yosys") && available(abc())
}

/// The name under which ABC is installed.
fn abc() -> &'static str {
    let names = ["yosys-abc", "berkeley-abc"];
    let starts = |name: &&str| Command::new(name).args(["-q", "quit"]).output().is_ok();
    names.into_iter().find(starts).unwrap_or(names[0])
}

/// Runs a yosys script that writes `gold.aig` and `gate.aig` into `folder`, and asks ABC whether they are equivalent: by
/// the command `cec` for logic, by `dsec` for circuits that start with all registers zero.
///
/// # Errors
/// The output of ABC if the circuits differ, and the output of yosys if it fails.
///
/// # Panics
/// If a tool cannot be started.
pub fn prove(folder: &Path, script: &str, command: &str) -> Result<(), String> {
    run(folder, "yosys", &["-q", "-s", script])?;
    let answer = run(folder, abc(), &["-c", &format!("{command} gold.aig gate.aig")])?;
    // ABC ends with success even if the circuits differ, or if it cannot read a file.
    if answer.contains("Networks are equivalent") { Ok(()) } else { Err(answer) }
}

/// Calls `work` for each item, on as many threads as there are processors; the first items first.
///
/// # Panics
/// If `work` does.
pub fn in_parallel<T: Send>(items: impl IntoIterator<Item = T>, work: impl Fn(T) + Sync) {
    let queue = Mutex::new(items.into_iter().collect::<std::collections::VecDeque<T>>());
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                loop {
                    let item = queue.lock().expect("no panic while it is held").pop_front();
                    let Some(item) = item else { break };
                    work(item);
                }
            });
        }
    });
}
