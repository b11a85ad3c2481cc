//! Oracle `case_file`: the input is a case file, and its reader returns cases or located errors.

use super::{InputOutcome, OracleFailure};
use std::collections::HashSet;
use std::sync::LazyLock;
use stickler_suite::{Case, CaseFileError, Dialects, read_case_file};

/// The names of dialects and groups that a case file may use, as in the `dialects.toml` of the suite.
static DIALECTS: LazyLock<Dialects> = LazyLock::new(|| {
    let groups = "[groups]
        ironplc = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\"]
        all = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\", \"matiec\", \"plcnext\"]";
    Dialects::of_file("dialects.toml", groups).0
});

/// The maximum number of cases that a file may expand into: for each of its bytes, and for any file, which is the budget of
/// the suite.
const MAX_CASES: usize = 200_000;

/// Checks the promises of the reader of case files: a text that begins with `(*!` is a program, any other a table.
///
/// 1. The reader gives cases or errors, and never neither.
/// 2. Each error has a line of the file and a message.
/// 3. Each case has an id of its own in its dialect, a line of the file, a program, and a basis.
/// 4. Reading the file again gives the same.
///
/// Basis: conformance-cases/README.md (the case format; ids are ASCII and never change their meaning).
///
/// # Errors
/// Symptoms: `nothing`, `error:place`, `error:message`, `case:id`, `case:place`, `case:source`, `case:basis`, `size`, `changes`.
pub(super) fn judge(data: &[u8]) -> Result<InputOutcome, OracleFailure> {
    let Ok(text) = std::str::from_utf8(data) else {
        // The reader of files refuses these bytes before this reader sees them.
        return Ok(InputOutcome::Skipped("no text"));
    };
    let name = if text
        .trim_start_matches('\u{FEFF}')
        .trim_start()
        .starts_with("(*!")
    {
        "language/fuzzed.st"
    } else {
        "language/fuzzed.toml"
    };
    let (cases, errors) = read_case_file(name, text, &DIALECTS);
    let lines = text.lines().count().max(1) + 1;
    errors.iter().try_for_each(|error| check_error(error, lines))?;
    check_cases(&cases, lines)?;
    if cases.is_empty() && errors.is_empty() {
        return Err(OracleFailure::new(
            "nothing",
            "the file has neither a case nor an error",
        ));
    }
    // A difference between two readings would come from the order of a hash table, which a small file shows too.
    if text.len() < 1024 && read_case_file(name, text, &DIALECTS) != (cases, errors) {
        return Err(OracleFailure::new(
            "changes",
            "reading the file again gives something else",
        ));
    }
    Ok(InputOutcome::Checked)
}

fn check_error(error: &CaseFileError, lines: usize) -> Result<(), OracleFailure> {
    if error.line == 0 || error.line as usize > lines {
        let message = format!("the error does not lie in the file's {lines} lines: {error}");
        return Err(OracleFailure::new("error:place", message));
    }
    if error.message.is_empty() {
        return Err(OracleFailure::new(
            "error:message",
            format!("the error says nothing: {error:?}"),
        ));
    }
    Ok(())
}

fn check_cases(cases: &[Case], lines: usize) -> Result<(), OracleFailure> {
    if cases.len() > MAX_CASES {
        return Err(OracleFailure::new(
            "size",
            format!("the file expands into {} cases", cases.len()),
        ));
    }
    let mut ids = HashSet::with_capacity(cases.len());
    for case in cases {
        let wrong = |symptom: &str, what: &str| Err(OracleFailure::new(symptom, format!("{what}: {case:?}")));
        if case.id.is_empty() || !case.id.is_ascii() || !ids.insert((&case.id, case.dialect)) {
            return wrong("case:id", "the id is empty, not ASCII, or another case's");
        }
        if case.line == 0 || case.line as usize > lines {
            return wrong("case:place", "the case does not lie in the file");
        }
        if case.source.trim().is_empty() {
            return wrong("case:source", "the case has no program");
        }
        if case.basis.trim().is_empty() {
            return wrong("case:basis", "the case has no basis");
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const PROGRAM: &str = "(*!\ntitle = \"Bits\"\nbasis = \"rule: not-stated\"\ndialects = [\"all\"]\n*)\n\
        PROGRAM main\nVAR\n    r : INT;\nEND_VAR\n    r := 1;\nEND_PROGRAM\n(*! values\nr = INT#1\n*)\n";

    #[test]
    fn a_case_that_asserts_something_has_a_basis() {
        for basis in [
            "",
            "basis = \"\"\n",
            "basis = [\"\", \"b: c\"]\n",
            "basis = \" | \"\n",
        ] {
            let text = PROGRAM.replace("basis = \"rule: not-stated\"\n", basis);
            assert_eq!(judge(text.as_bytes()), Ok(InputOutcome::Checked), "{basis}");
        }
    }

    #[test]
    fn a_program_gives_a_case_for_each_dialect() {
        assert_eq!(judge(PROGRAM.as_bytes()), Ok(InputOutcome::Checked));
        let (cases, errors) = read_case_file("language/fuzzed.st", PROGRAM, &DIALECTS);
        assert_eq!((cases.len(), errors), (5, vec![]));
    }

    #[test]
    fn what_is_no_case_file_gives_errors() {
        for text in [
            "",
            "x",
            "(*!",
            "(*! *)",
            "title = 1",
            "\u{FEFF}(*!\n*)",
            "[[probe]]\n",
        ] {
            assert_eq!(judge(text.as_bytes()), Ok(InputOutcome::Checked), "{text}");
        }
        assert_eq!(judge(b"\xFF"), Ok(InputOutcome::Skipped("no text")));
    }
}
