//! What is counted over the pixels of a frame.

use crate::execute::Difference;

/// Totals of pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Totals {
    /// Rays traced.
    pub rays: u64,
    /// Triangle tests that single precision did not decide.
    pub exact_tests: u64,
    /// All triangle tests.
    pub triangle_tests: u64,
    /// Steps and box tests that the pipeline's netlist executed.
    pub rtl_operations: u64,
    /// Those whose results are not golden's, bit for bit.
    pub rtl_differences: u64,
    /// Pixels that are not golden's, of a kernel that may differ.
    pub different_pixels: u64,
    /// The first of them, row by row from the top.
    pub first_difference: Option<Difference>,
}

impl Totals {
    /// Counts a pixel that differs.
    pub(super) fn differs(&mut self, found: Difference) {
        let place = |difference: &Difference| [difference.pixel[1], difference.pixel[0]];
        self.different_pixels += 1;
        if self.first_difference.is_none_or(|first| place(&found) < place(&first)) {
            self.first_difference = Some(found);
        }
    }
}
