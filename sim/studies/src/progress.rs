//! How far a long computation is, told to whoever shows it.

/// Is told how far a computation is. Parts may lie within parts; the one that began last is the one that goes on.
pub trait Progress: Sync {
    /// A part of `total` steps begins, or one of an unknown number of steps if that is 0.
    fn begin(&self, total: u64, what: &str);

    /// So many more steps are done.
    fn advance(&self, steps: u64);

    /// So many steps are done in all, some of them by an earlier run.
    fn at(&self, steps: u64);

    /// What the next steps are about.
    fn next(&self, what: &str);

    /// Something that is worth a line of its own.
    fn note(&self, line: &str);

    /// The part that began last has ended.
    fn end(&self);
}

/// Tells nobody.
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

/// A part of a computation, which ends when this is dropped.
pub struct Part<'a>(&'a dyn Progress);

impl<'a> Part<'a> {
    /// Begins a part of `total` steps.
    pub fn begin(progress: &'a dyn Progress, total: u64, what: &str) -> Self {
        progress.begin(total, what);
        Self(progress)
    }

    /// Begins a part whose number of steps nobody knows.
    pub fn endless(progress: &'a dyn Progress, what: &str) -> Self {
        Self::begin(progress, 0, what)
    }

    /// So many more steps are done.
    pub fn advance(&self, steps: u64) {
        self.0.advance(steps);
    }

    /// So many steps are done in all.
    pub fn at(&self, steps: u64) {
        self.0.at(steps);
    }

    /// What the next steps are about.
    pub fn next(&self, what: &str) {
        self.0.next(what);
    }
}

impl Drop for Part<'_> {
    fn drop(&mut self) {
        self.0.end();
    }
}
