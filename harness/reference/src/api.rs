//! The public face: a source text and a dialect in, diagnostics, values or rendered text out.

mod diagnose;
mod located;
mod observe;
mod run;
mod settings;

pub use diagnose::{check, check_bytes, errors, render, variables};
pub use located::locate;
pub use run::{Limits, RequestError, execute, run};
