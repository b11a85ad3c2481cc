//! Ctrl-C: the first stops a run in an orderly way, the second ends the process. Neither leaves an engine behind.

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
            end();
        }
    })
    .context("cannot listen for Ctrl-C")?;
    Ok(&STOP)
}

/// From now on Ctrl-C ends the process at once, and those of its engines with it: they would not notice it themselves.
///
/// # Errors
/// Where the system lets no handler be set.
pub fn at_once() -> anyhow::Result<()> {
    ctrlc::set_handler(end).context("cannot listen for Ctrl-C")
}

fn end() {
    stickler_engines::kill_all_processes();
    std::process::exit(i32::from(Exit::Interrupted.number()));
}
