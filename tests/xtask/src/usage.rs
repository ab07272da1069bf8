//! Processor time and wall time of child processes.

use std::time::{Duration, Instant};

/// What something took.
#[derive(Clone, Copy, Debug)]
pub struct Usage {
    /// Of all child processes that ended and were waited for, and of theirs.
    pub processor: Duration,
    /// By the clock on the wall.
    pub wall: Duration,
}

/// What `work` takes, and its result.
pub fn measure<T>(work: impl FnOnce() -> anyhow::Result<T>) -> anyhow::Result<(T, Usage)> {
    let (before, start) = (children()?, Instant::now());
    let result = work()?;
    let wall = start.elapsed();
    Ok((result, Usage { processor: children()?.saturating_sub(before), wall }))
}

/// Time in user and in system mode of the child processes that were waited for so far.
#[cfg(unix)]
fn children() -> anyhow::Result<Duration> {
    let mut usage = std::mem::MaybeUninit::<libc::rusage>::zeroed();
    // SAFETY: the pointer is to memory of the right size that is ours.
    let result = unsafe { libc::getrusage(libc::RUSAGE_CHILDREN, usage.as_mut_ptr()) };
    if result != 0 {
        return Err(std::io::Error::last_os_error().into());
    }
    // SAFETY: the system has filled it in, and zeros are a valid value, too.
    let usage = unsafe { usage.assume_init() };
    let duration = |time: libc::timeval| {
        // The types differ between systems.
        let seconds = u64::try_from(time.tv_sec).unwrap_or(0);
        let microseconds = u64::try_from(time.tv_usec).unwrap_or(0);
        Duration::from_secs(seconds) + Duration::from_micros(microseconds)
    };
    Ok(duration(usage.ru_utime) + duration(usage.ru_stime))
}

#[cfg(not(unix))]
fn children() -> anyhow::Result<Duration> {
    anyhow::bail!("processor time of child processes is known on Unix only")
}

#[cfg(all(test, unix))]
mod tests {
    use super::*;
    use std::process::Command;

    #[test]
    fn a_busy_child_takes_processor_time() {
        let busy = "i=0; while [ $i -lt 100000 ]; do i=$((i+1)); done";
        let (status, usage) = measure(|| Ok(Command::new("sh").args(["-c", busy]).status()?)).unwrap();
        assert!(status.success());
        assert!(usage.processor > Duration::ZERO);
        assert!(usage.wall > Duration::ZERO);
    }
}
