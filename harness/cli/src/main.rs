//! `stickler`: the conformance suite for compilers of IEC 61131-3 Structured Text, as a command line.
//!
//! *Architecture invariant.* A command parses its arguments, calls the layers below, and shows what they answer; what
//! another crate can do is done there. Exit codes are decided in [`exit`] alone, and only this file ends the process.
//!
//! [`arguments`] declares the command line, [`commands`] has one module for each command, [`engines`] finds engines by
//! their names, and [`case_folder`] finds and reads the cases.

mod arguments;
mod baselines;
mod caches;
mod carried_cases;
mod case_folder;
mod cause_stage;
mod commands;
mod contradicted;
mod documented;
mod engines;
mod exit;
mod interrupt;
mod matrix_table;
mod named_case;
mod output;
mod progress;
mod reduction_engine;
mod run_plan;
mod shell;
mod snippet;
mod source_file;

use arguments::Arguments;
use clap::Parser;
use std::io::Write;
use std::process::ExitCode;
#[cfg(unix)]
use std::sync::Arc;

/// The allocator of the whole program.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

/// Makes a file that must not grow any more (`ulimit -f`) an ordinary error instead of a signal that ends the process.
#[cfg(unix)]
fn ignore_file_size_signal() {
    let whether_it_came = Arc::default();
    // Where no handler can be set, the signal ends the process as before.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, whether_it_came);
}

/// Does nothing on systems that have no such signal.
#[cfg(not(unix))]
fn ignore_file_size_signal() {}

fn main() -> ExitCode {
    ignore_file_size_signal();
    // The command line may name the dialects of stickler.toml and the variants of the suite.
    let configured = engines::configure();
    if let Some(cases) = engines::named_cases() {
        case_folder::define_dialects(cases.as_deref());
    }
    let arguments = match (Arguments::try_parse(), configured) {
        (Ok(arguments), Ok(())) => arguments,
        (Err(usage), Ok(())) => usage.exit(),
        // Help is shown even where stickler.toml cannot be used.
        (Err(usage), Err(_)) if !usage.use_stderr() => usage.exit(),
        (_, Err(error)) => {
            output::error(&error);
            return exit::of_error(&error).into();
        }
    };
    let mut out = output::stdout();
    let result = commands::execute(arguments, &mut out).and_then(|exit| {
        out.flush()?;
        Ok(exit)
    });
    match result {
        Ok(exit) => exit.into(),
        Err(error) => {
            // Results so far are written before the error; nothing can be done where both streams fail.
            let _ = out.flush();
            output::error(&error);
            exit::of_error(&error).into()
        }
    }
}
