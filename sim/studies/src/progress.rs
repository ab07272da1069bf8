//! Reports of the progress of a long computation.

/// Receives the reports of a computation. Parts may be nested: all reports refer to the part that began last and has not ended.
pub trait Progress: Sync {
    /// Reports that a part of `total` steps begins. The number of steps is unknown if `total` is 0.
    fn begin(&self, total: u64, what: &str);

    /// Reports that `steps` more steps are done.
    fn advance(&self, steps: u64);

    /// Reports that `steps` steps are done in all, some of them by an earlier run.
    fn at(&self, steps: u64);

    /// Reports the subject of the next steps.
    fn next(&self, what: &str);

    /// Reports a message, which gets a line of its own.
    fn note(&self, line: &str);

    /// Reports that the part ends.
    fn end(&self);
}

/// Ignores all reports.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn begin(&self, _: u64, _: &str) {}
    fn advance(&self, _: u64) {}
    fn at(&self, _: u64) {}
    fn next(&self, _: &str) {}
    fn note(&self, _: &str) {}
    fn end(&self) {}
}

/// A part of a computation. The part ends when this value is dropped.
pub struct Part<'a>(&'a dyn Progress);

impl<'a> Part<'a> {
    /// Begins a part of `total` steps.
    pub fn begin(progress: &'a dyn Progress, total: u64, what: &str) -> Self {
        progress.begin(total, what);
        Self(progress)
    }

    /// Begins a part with an unknown number of steps.
    pub fn endless(progress: &'a dyn Progress, what: &str) -> Self {
        Self::begin(progress, 0, what)
    }

    /// Reports that `steps` more steps are done.
    pub fn advance(&self, steps: u64) {
        self.0.advance(steps);
    }

    /// Reports that `steps` steps are done in all.
    pub fn at(&self, steps: u64) {
        self.0.at(steps);
    }

    /// Reports the subject of the next steps.
    pub fn next(&self, what: &str) {
        self.0.next(what);
    }
}

impl Drop for Part<'_> {
    fn drop(&mut self) {
        self.0.end();
    }
}
