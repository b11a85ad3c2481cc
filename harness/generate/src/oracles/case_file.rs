//! Oracle `case_file`: the input is a case file, or a file of places, and its reader returns cases or located errors.

use super::{InputOutcome, Judged, failed};
use std::collections::HashSet;
use std::sync::LazyLock;
use stickler_suite::{Case, CaseFileError, Dialects, Places, read_case_file};

/// The names of dialects and groups that a case file may use, as in the `dialects.toml` of the suite.
static DIALECTS: LazyLock<Dialects> = LazyLock::new(|| {
    let groups = "[groups]
        ironplc = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\"]
        all = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\", \"matiec\", \"plcnext\"]";
    Dialects::of_file("dialects.toml", groups).0
});

/// The places of which a table may be put together: two for a source, two for a target, one around both.
static PLACES: LazyLock<Places> = LazyLock::new(|| Places::of_file("places.toml", PLACES_FILE, &DIALECTS).0);

/// The text of a `places.toml`.
const PLACES_FILE: &str = include_str!("case_file/places.toml");

/// The beginning of an input that is a `places.toml`.
const BEGINS_PLACES: &str = "# The places";

/// The maximum number of cases that a file may expand into: for each of its bytes, and for any file, which is the budget of
/// the suite.
const MAX_CASES: usize = 200_000;

/// Checks the promises of the readers of case files: a text that begins with `(*!` is a program, one that begins with
/// `# The places` a `places.toml`, of which a small table is put together, and any other a table.
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
pub(super) fn judge(data: &[u8]) -> Judged {
    let Ok(text) = std::str::from_utf8(data) else {
        // The reader of files refuses these bytes before this reader sees them.
        return Ok(InputOutcome::Skipped("no text"));
    };
    if text.starts_with(BEGINS_PLACES) {
        return check_places(text);
    }
    let name = if text
        .trim_start_matches('\u{FEFF}')
        .trim_start()
        .starts_with("(*!")
    {
        "language/fuzzed.st"
    } else {
        "language/fuzzed.toml"
    };
    let (cases, errors) = read_case_file(name, text, &DIALECTS, &PLACES);
    let lines = lines(text);
    errors.iter().try_for_each(|error| check_error(error, lines))?;
    check_cases(&cases, lines)?;
    if cases.is_empty() && errors.is_empty() {
        return failed("nothing", "the file has neither a case nor an error");
    }
    // A difference between two readings would come from the order of a hash table, which a small file shows too.
    if text.len() < 1024 && read_case_file(name, text, &DIALECTS, &PLACES) != (cases, errors) {
        return failed("changes", "reading the file again gives something else");
    }
    Ok(InputOutcome::Checked)
}

/// A table that is put together of places.
const PLACED: &str = include_str!("case_file/placed.toml");

fn check_places(text: &str) -> Judged {
    let (places, errors) = Places::of_file("places.toml", text, &DIALECTS);
    let own = lines(text);
    errors.iter().try_for_each(|error| check_error(error, own))?;
    let (cases, errors) = read_case_file("language/placed.toml", PLACED, &DIALECTS, &places);
    let lines = lines(PLACED);
    errors.iter().try_for_each(|error| check_error(error, lines))?;
    check_cases(&cases, lines)?;
    Ok(InputOutcome::Checked)
}

/// Returns the number of lines that a mistake may lie in: one more than the text has, for what is missing at its end.
fn lines(text: &str) -> usize {
    text.lines().count().max(1) + 1
}

fn check_error(error: &CaseFileError, lines: usize) -> Judged<()> {
    if error.line == 0 || error.line as usize > lines {
        let message = format!("the error does not lie in the file's {lines} lines: {error}");
        return failed("error:place", message);
    }
    if error.message.is_empty() {
        return failed("error:message", format!("the error says nothing: {error:?}"));
    }
    Ok(())
}

fn check_cases(cases: &[Case], lines: usize) -> Judged<()> {
    if cases.len() > MAX_CASES {
        return failed("size", format!("the file expands into {} cases", cases.len()));
    }
    let mut ids = HashSet::with_capacity(cases.len());
    for case in cases {
        let wrong = |symptom: &str, what: &str| failed(symptom, format!("{what}: {case:?}"));
        if case.id.is_empty() || !case.id.is_ascii() || !ids.insert((&case.id, case.dialect)) {
            return wrong("case:id", "the id is empty, not ASCII, or another case's");
        }
        if case.line == 0 || case.line as usize > lines {
            return wrong("case:place", "the case does not lie in the file");
        }
        // Marks become blanks, so that a text without a program has its lines all the same.
        if case.source.is_empty() {
            return wrong("case:source", "the case has no text");
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
        let (cases, errors) = read_case_file("language/fuzzed.st", PROGRAM, &DIALECTS, &PLACES);
        assert_eq!((cases.len(), errors), (5, vec![]));
    }

    #[test]
    fn a_table_is_put_together_of_places() {
        let (places, errors) = Places::of_file("places.toml", PLACES_FILE, &DIALECTS);
        assert_eq!(errors, []);
        assert_eq!(judge(PLACED.as_bytes()), Ok(InputOutcome::Checked));
        let (cases, errors) = read_case_file("language/placed.toml", PLACED, &DIALECTS, &places);
        assert_eq!(errors, []);
        assert!(cases.iter().any(|case| case.source.contains("list[1] := data;")));
        let rejected = |case: &&Case| !case.expectation.diagnostics.is_empty();
        assert!(cases.iter().filter(rejected).count() > 5, "{}", cases.len());
    }

    #[test]
    fn a_file_of_places_gives_places_or_errors() {
        let whole = format!("{BEGINS_PLACES}\n{PLACES_FILE}");
        for text in [
            whole.as_str(),
            BEGINS_PLACES,
            &whole.replace("ANY_NUM", "ANY_NUMB"),
            &whole.replace("{statement}", "{statment}"),
            &whole.replace("matiec", "no-dialect"),
            &whole[..whole.len() / 2],
        ] {
            assert_eq!(judge(text.as_bytes()), Ok(InputOutcome::Checked), "{text}");
        }
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
