//! Input that nobody would write: diagnostics, never a panic, a hang or memory without bound. Most of it is in
//! `tests/enormous`.

use stickler_mdtest::Difference;
use stickler_reference::{Limits, RequestError, check, check_bytes, render, run};
use stickler_types::{Diagnostic, DialectName, Fault, Observation, Outcome, RunRequest};

#[test]
fn enormous_texts_give_diagnostics_alone() {
    stickler_mdtest::check(
        concat!(env!("CARGO_MANIFEST_DIR"), "/tests/enormous"),
        |block| match block.kind() {
            "enormous" => block.rows(|text, found| enormous(&block.framed(text), found)),
            "hostile" => block.rows(|text, found| hostile(&block.framed(text), found)),
            _ => vec![Difference::new(1, "no test reads such a block")],
        },
    );
}

/// Checks a text on a thread with the stack of a test, and compares how much is wrong with it: a row of `enormous`.
fn enormous(text: &str, answer: &str) -> Result<(), String> {
    let text = text.to_owned();
    let checked = std::thread::Builder::new()
        .stack_size(2 << 20)
        .spawn(move || check(&text, DialectName::IRONPLC_ED3));
    let found = checked
        .map_err(|error| error.to_string())?
        .join()
        .map_err(|_| "it panics")?;
    answered(&found, answer)
}

/// Asks everything that can be asked about a text, in every dialect, and compares how much is wrong with it in one: a row of
/// `hostile`.
fn hostile(text: &str, answer: &str) -> Result<(), String> {
    for dialect in DialectName::ALL {
        let _ = (check(text, dialect), render(text, dialect));
    }
    let observe = [Observation::last("x", "")];
    let request = RunRequest::once(DialectName::IRONPLC_ED3, text, &observe);
    let outcome = run(&request, Limits { steps: 100_000 });
    let found = check(text, DialectName::IRONPLC_ED3);
    let is_consistent = match &outcome {
        Ok(Outcome::Rejected { .. }) => !found.is_empty(),
        Ok(
            Outcome::Executed { .. }
            | Outcome::Faulted {
                fault: Fault::StepLimit,
                ..
            },
        ) => found.is_empty(),
        outcome => found.is_empty() && matches!(outcome, Err(RequestError::UnknownName { .. })),
    };
    if !is_consistent {
        return Err(format!(
            "{} diagnostics, and the run gives {outcome:?}",
            found.len()
        ));
    }
    answered(&found, answer)
}

/// Compares diagnostics with how many there are, or with the only one.
fn answered(found: &[Diagnostic], answer: &str) -> Result<(), String> {
    let given = match found {
        [only] if answer.contains(':') => {
            let place = (only.line.unwrap_or(0), only.column.unwrap_or(0));
            format!(
                "{}:{} {}",
                place.0,
                place.1,
                only.code.as_deref().unwrap_or_default()
            )
        }
        many => match answer.strip_suffix('+').map(str::parse) {
            Some(Ok(least)) if many.len() > least => answer.to_owned(),
            _ => many.len().to_string(),
        },
    };
    stickler_mdtest::same(given, answer.to_owned())
}

#[test]
fn bytes_of_all_kinds_are_diagnosed() {
    let all_bytes: Vec<u8> = (0..=255).cycle().take(5_000).collect();
    for bytes in [
        &all_bytes[..],
        b"\0\0\0",
        b"\xEF\xBB\xBF",
        b"\xFF\xFE",
        b"PROGRAM main\r\n\0END_PROGRAM",
        b"'",
        b"\"$",
        b"16#",
    ] {
        for dialect in DialectName::ALL {
            let (_, found) = check_bytes(bytes, dialect);
            assert_eq!(found.is_empty(), bytes == b"\xEF\xBB\xBF", "{bytes:?}: {found:?}");
        }
    }
    let source = "PROGRAM main\r\nVAR x : INT; END_VAR\r\nx := 1;\r\nEND_PROGRAM\r\n";
    assert_eq!(check(source, DialectName::IRONPLC_ED3), []);
}
