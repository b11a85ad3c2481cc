//! Parses the diagnostics that `iec2c` writes to stderr about a program.
//!
//! Basis: matiec: measured. A syntax error: `file:LINE: error: message`; any other: `file:L-C..L-C: error: message`, from 1,
//! the last column within the range; `warning:` in place of `error:` rejects nothing. There are no codes; the first form is
//! Stickler's P0002. Where the parser gives up at once, it says [`GAVE_UP`] and nothing else.

use crate::adapters::codes::sorted;
use crate::process::Ended;
use crate::{Diagnostic, Outcome, Severity};
use stickler_types::Code;

/// The message of the compiler for a program that it cannot read at all.
const GAVE_UP: &str = "Parsing failed because of too many consecutive syntax errors. Bailing out!";

/// Returns the warnings of a program that is accepted.
///
/// # Errors
/// [`Outcome::Rejected`]; [`Outcome::Crashed`] where the compiler reports an internal error, or does not say what is wrong.
pub(super) fn accepted(ended: &Ended) -> Result<Vec<Diagnostic>, Outcome> {
    let code = ended.code()?;
    if ended.stderr.contains("Internal compiler error") || ended.stdout.contains("Internal compiler error") {
        return Err(ended.crashed());
    }
    let (mut diagnostics, warnings) = diagnostics(&ended.stderr);
    if code == 0 {
        return Ok(warnings);
    }
    if diagnostics.is_empty() {
        diagnostics.extend(gave_up(&ended.stderr));
    }
    match diagnostics.is_empty() {
        true => Err(ended.crashed()),
        false => Err(rejected(diagnostics)),
    }
}

/// Returns the diagnostic, without a place, of a program that cannot be read at all; `None` where the compiler says something else.
fn gave_up(stderr: &str) -> Option<Diagnostic> {
    let is_told = stderr.lines().any(|line| line.trim() == GAVE_UP);
    is_told.then(|| Diagnostic {
        code: Some(Code::SyntaxError.as_str().to_owned()),
        message: GAVE_UP.to_owned(),
        ..Diagnostic::default()
    })
}

/// Returns the errors and the warnings in the output, in its order.
pub(super) fn diagnostics(stderr: &str) -> (Vec<Diagnostic>, Vec<Diagnostic>) {
    let reported = stderr.lines().filter_map(diagnostic);
    reported.partition(Diagnostic::is_error)
}

/// Returns the rejection with these diagnostics.
pub(super) fn rejected(diagnostics: Vec<Diagnostic>) -> Outcome {
    Outcome::rejected(sorted(diagnostics))
}

/// Tells whether these are all mistakes of programs that were read to their end. Then every mistake of every program is among
/// them: the compiler looks for all kinds of mistakes, and none hides another.
pub(super) fn are_complete(diagnostics: &[Diagnostic], stderr: &str) -> bool {
    let counted = format!("{} error(s) found. Bailing out!", diagnostics.len());
    diagnostics.iter().all(|diagnostic| diagnostic.code.is_none())
        && stderr.lines().any(|line| line.trim() == counted)
}

fn diagnostic(line: &str) -> Option<Diagnostic> {
    let of = |severity: Severity| Some((severity, line.split_once(&format!(": {}: ", severity.as_str()))?));
    let (severity, (place, message)) = of(Severity::Error).or_else(|| of(Severity::Warning))?;
    let (_, place) = place.rsplit_once(':')?;
    let message = message.trim().to_owned();
    if let Some((from, to)) = place.split_once("..") {
        let (line, column) = pair(from)?;
        let (end_line, end_column) = pair(to)?;
        return Some(Diagnostic {
            severity,
            line: Some(line),
            column: Some(column),
            end_line: Some(end_line),
            end_column: Some(end_column + 1),
            message,
            ..Diagnostic::default()
        });
    }
    // Only the parser names no column.
    Some(Diagnostic {
        severity,
        code: severity.is_error().then(|| Code::SyntaxError.as_str().to_owned()),
        line: Some(place.parse().ok()?),
        message,
        ..Diagnostic::default()
    })
}

fn pair(place: &str) -> Option<(u32, u32)> {
    let (line, column) = place.split_once('-')?;
    Some((line.parse().ok()?, column.parse().ok()?))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_mistakes_of_which_all_are_told_are_complete() {
        let complete = |stderr: &str| are_complete(&diagnostics(stderr).0, stderr);
        let meant = "a.st:3-4..3-9: error: one\na.st:7-4..7-9: error: two\n";
        assert!(complete(&format!("{meant}2 error(s) found. Bailing out!\n")));
        assert!(!complete(&format!("{meant}3 error(s) found. Bailing out!\n")));
        assert!(!complete(meant));
        assert!(!complete(
            "a.st:3: error: one\n\n1 error(s) found. Bailing out!\n"
        ));
    }
}
