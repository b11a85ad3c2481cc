//! A program that runs a translated one and prints what is observed of it.

use super::locate::{self, failed};
use super::printed::{self, Kind};
use crate::process::Folder;
use crate::{NamedValue, Outcome, RunRequest};
use stickler_types::{Fault, Value};

/// The program, and how to read what it prints.
pub(super) struct Driver<'r> {
    /// The program in C or C++.
    pub(super) text: String,
    /// What it prints of each observed variable.
    pub(super) kinds: Vec<Kind<'r>>,
    /// Reads one value; gives nothing where it is nonsense.
    pub(super) read: fn(&Kind<'_>, &str) -> Option<Value>,
    /// The exit codes by which it tells faults.
    pub(super) faults: &'static [(i32, Fault)],
}

impl Driver<'_> {
    /// Runs the program that was built of it in a folder.
    ///
    /// # Errors
    /// As [`locate::execute`], and [`Outcome::Error`] for what is no value.
    pub(super) fn execute(&self, folder: &Folder, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let nothing: [&str; 0] = [];
        let ended = locate::execute(&folder.path().join("driver"), &nothing, folder)?;
        let faulted = |fault| Outcome::Faulted {
            fault,
            line: None,
            values: Vec::new(),
        };
        if ended.stopped_by_arithmetic() {
            return Ok(faulted(Fault::DivisionByZero));
        }
        let code = ended.code()?;
        if code == 0 {
            let values = self.values(&ended.stdout, request).map_err(failed)?;
            return Ok(Outcome::Executed { values });
        }
        let told = self.faults.iter().find(|(of, _)| *of == code);
        told.map(|(_, fault)| faulted(*fault))
            .ok_or_else(|| ended.crashed())
    }

    /// The values that it printed.
    ///
    /// # Errors
    /// A fragment that says what is wrong with what it printed.
    pub(super) fn values(&self, printed: &str, request: &RunRequest<'_>) -> Result<Vec<NamedValue>, String> {
        printed::values(printed, request, &self.kinds, self.read)
    }
}
