//! Writes what a request sets between scans into its program, for compilers whose variables are not written from outside.
//!
//! A variable counts the scans, and the body of the main program begins with the assignments of its scan. No line moves.

use super::locate::unsupported;
use super::source::main_program;
use crate::{Outcome, RunRequest};
use std::collections::BTreeMap;
use std::fmt::Write;
use stickler_types::Value;

/// The variable that counts the scans.
const SCAN: &str = "stickler_scan";

/// Returns the program of a request with what is set in it; `None` where nothing is, or there is no main program.
pub(super) fn with_settings(request: &RunRequest<'_>) -> Option<String> {
    if request.set.is_empty() {
        return None;
    }
    let main = main_program(request)?;
    let mut by_scan: BTreeMap<u32, String> = BTreeMap::new();
    for setting in request.set {
        // Writing into a String does not fail.
        let statements = by_scan.entry(setting.before).or_default();
        let _ = write!(statements, " {} := {};", setting.name, literal(&setting.value));
    }
    let cases: String = by_scan
        .iter()
        .map(|(scan, statements)| format!(" {scan}:{statements}"))
        .collect();
    let source = request.source;
    Some(format!(
        "{} VAR {SCAN} : DINT; END_VAR{} {SCAN} := {SCAN} + 1; CASE {SCAN} OF{cases} END_CASE;{}",
        &source[..main.inside.start],
        &source[main.inside.start..main.body],
        &source[main.body..],
    ))
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

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::{DialectName, Setting};

    #[test]
    fn settings_move_no_line() {
        let of = |source: &str| {
            let set = [
                (1, "a", "BOOL#TRUE"),
                (3, "w", "WORD#16#00FF"),
                (3, "s[1].x", "INT#-5"),
            ];
            let set = set.map(|(before, name, value)| Setting {
                before,
                name: name.into(),
                value: Value::parse(value).unwrap(),
            });
            with_settings(&RunRequest {
                set: &set,
                ..RunRequest::once(DialectName::MATIEC, source, &[])
            })
        };
        let assigned = " stickler_scan := stickler_scan + 1; CASE stickler_scan OF 1: a := TRUE; 3: w := WORD#16#00FF; s[1].x := -5; END_CASE;";
        assert_eq!(
            of("PROGRAM p\nVAR a : BOOL; END_VAR\nVAR\nEND_VAR\n  x := a;\nEND_PROGRAM").unwrap(),
            format!(
                "PROGRAM p VAR stickler_scan : DINT; END_VAR\nVAR a : BOOL; END_VAR\nVAR\nEND_VAR{assigned}\n  x := a;\nEND_PROGRAM"
            )
        );
        let bare = of("PROGRAM p END_PROGRAM").unwrap();
        assert_eq!(
            bare,
            format!("PROGRAM p VAR stickler_scan : DINT; END_VAR{assigned} END_PROGRAM")
        );
        assert_eq!(of("FUNCTION f : INT END_FUNCTION"), None);
    }
}
