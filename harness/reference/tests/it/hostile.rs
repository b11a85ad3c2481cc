//! Input that nobody would write: diagnostics, never a panic, a hang or memory without bound. Most of it is in
//! `tests/enormous`.

use stickler_mdtest::Difference;
use stickler_reference::{Limits, RequestError, check, check_bytes, render, run};
use stickler_types::{
    Diagnostic, Dialect, DialectName, Fault, Observation, Outcome, RunRequest, TextReading, Value,
};

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
    let text = stickler_mdtest::expanded(text);
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
    let text = stickler_mdtest::expanded(text);
    for dialect in DialectName::ALL {
        let _ = (check(&text, dialect), render(&text, dialect));
    }
    let observe = [Observation::last("x", "")];
    let request = RunRequest::once(DialectName::IRONPLC_ED3, &text, &observe);
    let outcome = run(&request, Limits { steps: 100_000 });
    let found = check(&text, DialectName::IRONPLC_ED3);
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

#[test]
fn the_longest_texts_are_converted_in_constants_and_as_the_program_runs() {
    let digits = format!("{}12", "0".repeat(65_533));
    let spoilt = format!("{}x", "9".repeat(65_534));
    let source = format!(
        "PROGRAM main
         VAR CONSTANT k : STRING[65535] := '{digits}'; END_VAR
         VAR s : STRING[65535] := '{digits}'; t : STRING[65535] := '{spoilt}'; w : WSTRING[65535];
             a : ARRAY[0..STRING_TO_INT('{digits}')] OF INT; i, j, n, c : INT; r : REAL; l : LREAL; d : TIME; hit : BOOL;
         END_VAR
             i := STRING_TO_INT(s); j := STRING_TO_INT(k); n := STRING_TO_INT(t); r := STRING_TO_REAL(s);
             l := STRING_TO_LREAL(t); d := STRING_TO_TIME(t); w := STRING_TO_WSTRING(s); c := WSTRING_TO_INT(w);
             CASE i OF STRING_TO_INT('{digits}'): hit := TRUE; END_CASE; a[12] := 1;
         END_PROGRAM"
    );
    let expected = [
        ("i", "INT#12"),
        ("j", "INT#12"),
        ("n", "INT#0"),
        ("c", "INT#12"),
        ("r", "REAL#12.0"),
        ("l", "LREAL#0.0"),
        ("d", "TIME#0ms"),
        ("hit", "BOOL#TRUE"),
        ("a[12]", "INT#1"),
    ];
    // Some read the number before the letter.
    let reads_whole_texts =
        |dialect: &DialectName| Dialect::of(*dialect).conversions.text_reading == TextReading::WholeText;
    for dialect in DialectName::ALL.into_iter().filter(reads_whole_texts) {
        let observe = expected.map(|(name, _)| Observation::last(name, ""));
        let outcome = run(&RunRequest::once(dialect, &source, &observe), Limits::default());
        let values = expected.map(|(name, value)| {
            let value = Value::parse(value).expect("a typed literal");
            (name.to_owned(), value)
        });
        let values = values.to_vec();
        assert!(outcome == Ok(Outcome::executed(values)), "{dialect}");
    }
}
