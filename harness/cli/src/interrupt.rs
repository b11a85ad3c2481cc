//! Ctrl-C: the first stops a run in an orderly way, the second ends the process.

use crate::exit::Exit;
use anyhow::Context;
use std::sync::atomic::{AtomicBool, Ordering};

static STOP: AtomicBool = AtomicBool::new(false);

/// The flag that Ctrl-C raises, from now on.
///
/// # Errors
/// Where the system lets no handler be set.
pub fn flag() -> anyhow::Result<&'static AtomicBool> {
    ctrlc::set_handler(|| {
        if STOP.swap(true, Ordering::Relaxed) {
            std::process::exit(i32::from(Exit::Interrupted.number()));
        }
    })
    .context("cannot listen for Ctrl-C")?;
    Ok(&STOP)
}
