//! Short ways to run a program and to say what must come of it.

use stickler_reference::{Limits, RequestError, check, run};
use stickler_types::{
    Code, Diagnostic, DialectName, Fault, Observation, Outcome, RunRequest, Setting, Value,
};

/// The dialect of tests that are not about dialects.
pub const DIALECT: DialectName = DialectName::IRONPLC_ED3;

/// A request for one scan that observes these names at the end.
pub fn attempt(dialect: DialectName, source: &str, observe: &[&str]) -> Result<Outcome, RequestError> {
    attempt_scans(
        dialect,
        source,
        1,
        &observe.iter().map(|name| (*name, None)).collect::<Vec<_>>(),
        &[],
    )
}

/// A request with everything.
pub fn attempt_scans(
    dialect: DialectName,
    source: &str,
    scans: u32,
    observe: &[(&str, Option<u32>)],
    set: &[(u32, &str, &str)],
) -> Result<Outcome, RequestError> {
    let observe: Vec<_> = observe
        .iter()
        .map(|&(name, after)| Observation {
            after,
            ..Observation::last(name, "")
        })
        .collect();
    let set: Vec<_> = set
        .iter()
        .map(|&(before, name, literal)| Setting {
            before,
            name: name.into(),
            value: Value::parse(literal).expect("a typed literal"),
        })
        .collect();
    let request = RunRequest {
        scans,
        set: &set,
        ..RunRequest::once(dialect, source, &observe)
    };
    run(&request, Limits { steps: 100_000 })
}

/// The values in their canonical spelling, each with its name.
pub fn spelled(values: &[(String, Value)]) -> Vec<String> {
    values
        .iter()
        .map(|(name, value)| format!("{name} = {value}"))
        .collect()
}

/// Asserts that a program runs, and that the variables then have these values: `"a = INT#5"`.
#[track_caller]
pub fn assert_values_in(dialect: DialectName, source: &str, expected: &[&str]) {
    let names: Vec<_> = expected
        .iter()
        .map(|line| line.split_once(" = ").expect("name = value").0)
        .collect();
    match attempt(dialect, source, &names) {
        Ok(Outcome::Executed { values, .. }) => assert_eq!(spelled(&values), expected),
        other => panic!("not executed: {other:#?}"),
    }
}

/// Asserts in the ordinary dialect that a program runs, and that the variables then have these values.
#[track_caller]
pub fn assert_values(source: &str, expected: &[&str]) {
    assert_values_in(DIALECT, source, expected);
}

/// Asserts the values after `PROGRAM main VAR {variables} END_VAR {body} END_PROGRAM`.
#[track_caller]
pub fn assert_body(variables: &str, body: &str, expected: &[&str]) {
    assert_values(&program(variables, body), expected);
}

/// `PROGRAM main` around declarations and statements.
pub fn program(variables: &str, body: &str) -> String {
    format!("PROGRAM main\nVAR\n{variables}\nEND_VAR\n{body}\nEND_PROGRAM\n")
}

/// Asserts that a program faults on a line, with these values so far.
#[track_caller]
pub fn assert_fault(source: &str, expected: (Fault, u32), values_so_far: &[&str]) {
    let names: Vec<_> = values_so_far
        .iter()
        .map(|line| line.split_once(" = ").expect("name = value").0)
        .collect();
    match attempt(DIALECT, source, &names) {
        Ok(Outcome::Faulted {
            fault, line, values, ..
        }) => {
            assert_eq!((fault, line), (expected.0, Some(expected.1)));
            assert_eq!(spelled(&values), values_so_far);
        }
        other => panic!("no fault: {other:#?}"),
    }
}

/// Asserts the codes and lines of everything that is wrong with a program.
#[track_caller]
pub fn assert_diagnostics_in(dialect: DialectName, source: &str, expected: &[(Code, u32)]) {
    let found = check(source, dialect);
    let places: Vec<_> = found.iter().map(code_and_line).collect();
    assert_eq!(places, expected, "{found:#?}");
}

/// The code of a diagnostic and the line on which it begins. The reference always gives both.
pub fn code_and_line(diagnostic: &Diagnostic) -> (Code, u32) {
    (code(diagnostic), diagnostic.line.expect("a line"))
}

/// The code of a diagnostic.
pub fn code(diagnostic: &Diagnostic) -> Code {
    diagnostic.registered_code().expect("a code of the registry")
}

/// Asserts the codes and lines of the diagnostics of a program in the ordinary dialect.
#[track_caller]
pub fn assert_diagnostics(source: &str, expected: &[(Code, u32)]) {
    assert_diagnostics_in(DIALECT, source, expected);
}

/// The text that a diagnostic's place covers, on one line.
pub fn place<'s>(source: &'s str, diagnostic: &Diagnostic) -> &'s str {
    let line = source
        .lines()
        .nth(code_and_line(diagnostic).1 as usize - 1)
        .expect("the line exists");
    let byte = |column: Option<u32>| {
        line.char_indices()
            .nth(column.expect("a column") as usize - 1)
            .map_or(line.len(), |(at, _)| at)
    };
    &line[byte(diagnostic.column)..byte(diagnostic.end_column)]
}
