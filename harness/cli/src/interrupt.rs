//! Handles Ctrl-C and SIGTERM: the first signal stops a run in an orderly way, the second ends it at once. Both end the engines
//! too.

use crate::exit::Exit;
use anyhow::Context;
use std::io::Write;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use stickler_workers::Cancellation;

/// Whether the first Ctrl-C requests an orderly end; otherwise it ends the process at once.
static ORDERLY: AtomicBool = AtomicBool::new(false);

/// The cancellation that Ctrl-C requests.
static STOP: Cancellation = Cancellation::new();

/// Whether the signal handler is set; it is set once in the life of the process.
static LISTENING: OnceLock<()> = OnceLock::new();

/// Whether the first Ctrl-C also ends the requests that the engines are working on.
static ENDS_ENGINES: AtomicBool = AtomicBool::new(false);

/// Returns the cancellation that Ctrl-C requests from now on. Ctrl-C also ends the requests that the engines are working on, each
/// of which may take minutes for many programs; answers after that are meaningless.
///
/// # Errors
/// A system that does not allow a signal handler to be set.
pub fn cancellation_ending_engines() -> anyhow::Result<&'static Cancellation> {
    ENDS_ENGINES.store(true, Ordering::Relaxed);
    cancellation()
}

/// Returns the cancellation that Ctrl-C requests from now on.
///
/// # Errors
/// A system that does not allow a signal handler to be set.
pub fn cancellation() -> anyhow::Result<&'static Cancellation> {
    at_once()?;
    ORDERLY.store(true, Ordering::Relaxed);
    Ok(&STOP)
}

/// Makes Ctrl-C end the process at once from now on, with the processes of its engines, which do not receive the signal.
///
/// # Errors
/// A system that does not allow a signal handler to be set.
pub fn at_once() -> anyhow::Result<()> {
    if LISTENING.get().is_none() {
        ctrlc::set_handler(|| {
            if !ORDERLY.load(Ordering::Relaxed) || STOP.is_requested() {
                end();
            }
            let ends_engines = ENDS_ENGINES.load(Ordering::Relaxed);
            // What stops may end the process before anything more is written.
            report(ends_engines);
            STOP.request();
            if ends_engines {
                stickler_engines::stop_all_processes();
            }
        })
        .context("cannot listen for Ctrl-C")?;
        LISTENING.get_or_init(|| ());
    }
    Ok(())
}

/// Reports the signal on stderr: an engine may take its whole time limit for its current request.
fn report(ends_engines: bool) {
    let when = match ends_engines {
        true => "stopping",
        false => "stopping after what is under way",
    };
    let mut stderr = anstream::stderr();
    // A terminal shows `^C`, and perhaps a bar, on the line where the cursor stands.
    let start = if stderr.is_terminal() { "\n" } else { "" };
    // The work stops even where stderr cannot be written.
    let _ = writeln!(stderr, "{start}{when}; Ctrl-C again ends at once");
}

fn end() {
    stickler_engines::kill_all_processes();
    std::process::exit(i32::from(Exit::Interrupted.number()));
}
