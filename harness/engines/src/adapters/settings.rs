//! Writes what a request sets between scans into its program, for compilers whose variables are not written from outside.
//!
//! A variable counts the scans, and the body of the main program begins with the assignments of its scan. No line moves. In the same way values of
//! many scans are copied at the end of the body, for compilers that show variables only once.

use super::locate::unsupported;
use super::source::{MainProgram, main_program, observed_scans};
use crate::{Observation, Outcome, RunRequest};
use std::collections::BTreeMap;
use stickler_types::{ElementaryType, Value};

/// Returns the program of a request with what is set in it; `None` where nothing is, or there is no main program.
pub(super) fn with_settings(request: &RunRequest<'_>) -> Option<String> {
    if request.set.is_empty() {
        return None;
    }
    let main = main_program(request)?;
    let mut by_scan: BTreeMap<u32, String> = BTreeMap::new();
    for setting in request.set {
        let statements = by_scan.entry(setting.before).or_default();
        statements.push_str(&format!(" {} := {};", setting.name, literal(&setting.value)));
    }
    let program = (request.source, &main);
    Some(with_cases(program, "stickler_scan", "", main.body, &by_scan))
}

/// Returns a program with statements at an offset of its body, by the scan in which they are executed. `counter` is the variable that counts
/// the scans; `declared` are further variables.
fn with_cases(
    (source, main): (&str, &MainProgram),
    counter: &str,
    declared: &str,
    at: usize,
    by_scan: &BTreeMap<u32, String>,
) -> String {
    let start = main.inside.start;
    let cases = by_scan.iter().map(|(scan, text)| format!(" {scan}:{text}"));
    format!(
        "{} VAR {counter} : DINT;{declared} END_VAR{} {counter} := {counter} + 1; CASE {counter} OF{} END_CASE;{}",
        &source[..start],
        &source[start..at],
        cases.collect::<String>(),
        &source[at..],
    )
}

/// Returns the request with another program, which sets what the request does.
pub(super) fn written<'t>(request: &RunRequest<'t>, text: Option<&'t String>) -> RunRequest<'t> {
    match text {
        Some(source) => RunRequest {
            source,
            set: &[],
            ..*request
        },
        None => *request,
    }
}

/// The number of scans after which values are observed, from which on it is quicker to copy them than to run the program for each.
const MANY_SCANS: usize = 4;

/// A program that copies the values of its scans into variables.
pub(super) struct CopiedByScan {
    /// The text of the program.
    pub(super) text: String,
    /// The copies, in the order of the values that the request observes.
    pub(super) observe: Vec<Observation>,
}

/// Returns the program of a request with copies of the values that are observed after many scans; `None` where there are few, or a value is of no
/// elementary type, or the program may return before its end.
pub(super) fn copied_by_scan(request: &RunRequest<'_>) -> Option<CopiedByScan> {
    let main =
        main_program(request).filter(|main| !main.returns && observed_scans(request).len() > MANY_SCANS)?;
    let (mut declared, mut by_scan) = (String::new(), BTreeMap::<u32, String>::new());
    let mut observe = Vec::with_capacity(request.observe.len());
    for (number, asked) in request.observe.iter().enumerate() {
        ElementaryType::from_name(&asked.type_name)?;
        let copy = format!("stickler_copy_{number}");
        declared.push_str(&format!(" {copy} : {};", asked.type_name));
        let statements = by_scan.entry(asked.after.unwrap_or(request.scans)).or_default();
        statements.push_str(&format!(" {copy} := {};", asked.name));
        observe.push(Observation::last(&copy, &asked.type_name));
    }
    let program = (request.source, &main);
    let text = with_cases(
        program,
        "stickler_scan_copied",
        &declared,
        main.inside.end,
        &by_scan,
    );
    Some(CopiedByScan { text, observe })
}

/// Executes a program by `run` with what is set in it. Where the compiler does not accept that, the program is given to `check` alone, to
/// tell whether it is accepted itself.
///
/// # Errors
/// The error of `run` or of `check`; [`Outcome::Unsupported`] where only the program alone is accepted.
pub(super) fn run_written<T>(
    request: &RunRequest<'_>,
    run: impl FnOnce(&RunRequest<'_>) -> Result<Outcome, Outcome>,
    check: impl FnOnce(&RunRequest<'_>) -> Result<T, Outcome>,
) -> Result<Outcome, Outcome> {
    let text = with_settings(request);
    match run(&written(request, text.as_ref())) {
        Ok(rejected @ Outcome::Rejected { .. }) | Err(rejected @ Outcome::Rejected { .. })
            if text.is_some() =>
        {
            check(request)?;
            Err(unsupported(format!("with what is set between scans: {rejected}")))
        }
        outcome => outcome,
    }
}

/// Returns a literal that every compiler takes: bit strings have their type, for not all of them take a number for one.
fn literal(value: &Value) -> String {
    match value {
        Value::Plain { ty, .. } if ty.is_bit_string() => value.to_string(),
        _ => value.literal(),
    }
}
