//! Hints to the host's processor that something will be needed soon.
//!
//! A multiprocessor's threads come by in turn and are more than the host's nearest cache holds, so a thread's state has left it
//! by the time that the thread comes back. Which one is next is known, and asking for it early hides the way to the next
//! cache. It changes no result.

/// Bytes of a line of the host's caches.
const LINE: usize = 64;

/// Asks for the first `lines` lines from `place` on, which may be any address. Hosts other than x86-64 are not asked.
#[inline(always)]
pub fn prefetch<T>(place: *const T, lines: usize) {
    #[cfg(target_arch = "x86_64")]
    for line in 0..lines {
        use std::arch::x86_64::{_MM_HINT_T0, _mm_prefetch};
        // SAFETY: a hint reads nothing and never faults, whatever the address.
        unsafe { _mm_prefetch::<_MM_HINT_T0>(place.cast::<i8>().wrapping_add(LINE * line)) }
    }
    #[cfg(not(target_arch = "x86_64"))]
    let _ = (place, lines);
}
