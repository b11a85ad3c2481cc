//! A request to stop before the end.

use std::sync::atomic::{AtomicBool, Ordering};

/// A flag that asks work to stop before its end. It is raised once and never lowered.
#[derive(Debug, Default)]
pub struct Cancellation(AtomicBool);

impl Cancellation {
    /// A flag that is not raised.
    pub const fn new() -> Cancellation {
        Cancellation(AtomicBool::new(false))
    }

    /// Raises the flag. Returns whether it was raised before.
    pub fn request(&self) -> bool {
        self.0.swap(true, Ordering::Relaxed)
    }

    /// Returns whether the flag is raised.
    pub fn is_requested(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}
