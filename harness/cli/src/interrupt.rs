//! Ctrl-C, and the signal that ends a process: the first stops a run in an orderly way, the second ends it at once. Neither
//! leaves an engine behind.

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

/// Whether the handler is set; it is set once in the life of the process.
static LISTENING: OnceLock<()> = OnceLock::new();

/// Whether the first Ctrl-C also ends what the engines have under way.
static ENDS_ENGINES: AtomicBool = AtomicBool::new(false);

/// Returns the cancellation that Ctrl-C requests from now on. Ctrl-C also ends what the engines have under way, for one may
/// take minutes over many programs; what they answer after that is meaningless.
///
/// # Errors
/// Where the system lets no handler be set.
pub fn cancellation_ending_engines() -> anyhow::Result<&'static Cancellation> {
    ENDS_ENGINES.store(true, Ordering::Relaxed);
    cancellation()
}

/// Returns the cancellation that Ctrl-C requests from now on.
///
/// # Errors
/// Where the system lets no handler be set.
pub fn cancellation() -> anyhow::Result<&'static Cancellation> {
    listen()?;
    ORDERLY.store(true, Ordering::Relaxed);
    Ok(&STOP)
}

/// Lets Ctrl-C end the process at once from now on, and the processes of its engines, which would not notice it themselves.
///
/// # Errors
/// Where the system lets no handler be set.
pub fn at_once() -> anyhow::Result<()> {
    listen()
}

fn listen() -> anyhow::Result<()> {
    if LISTENING.get().is_none() {
        ctrlc::set_handler(|| {
            if !ORDERLY.load(Ordering::Relaxed) || STOP.request() {
                end();
            }
            let ends_engines = ENDS_ENGINES.load(Ordering::Relaxed);
            if ends_engines {
                stickler_engines::stop_all_processes();
            }
            report(ends_engines);
        })
        .context("cannot listen for Ctrl-C")?;
        LISTENING.get_or_init(|| ());
    }
    Ok(())
}

/// Says that the signal came through: an engine may take its whole time limit for the request that it works on.
fn report(ends_engines: bool) {
    let when = match ends_engines {
        true => "stopping",
        false => "stopping after what is under way",
    };
    let mut stderr = anstream::stderr();
    // A terminal shows `^C`, and perhaps a bar, on the line where the cursor stands.
    let start = if stderr.is_terminal() { "\n" } else { "" };
    // Where nobody can be told, the work still stops.
    let _ = writeln!(stderr, "{start}{when}; Ctrl-C again ends at once");
}

fn end() {
    stickler_engines::kill_all_processes();
    std::process::exit(i32::from(Exit::Interrupted.number()));
}
