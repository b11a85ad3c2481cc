//! Whether the claim of a case still speaks of the program that became of the case's.

use crate::assignments::computation;
use crate::features::is_unread;
use crate::literals::type_of_token;
use crate::operations::{operations, operations_of};
use crate::reduction::Smallest;
use crate::shape::own_functions;
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::BTreeSet;
use stickler_run::{CaseEvent, Fact, Symptom};
use stickler_types::{Diagnostic, ElementaryType};

/// Returns whether the claim of a case still speaks of a program that was made from the case's: whether the program has the
/// operations of that line of the case in which its expectation shows, and is not rejected for another line. A claim about a value
/// says nothing of a program without an operation that the engine cannot read or makes nothing of use of, and one about a mistake nothing of a program without it.
pub(crate) fn keeps_claim(case: &CaseEvent, smallest: &Smallest) -> bool {
    let is_mistake = case.expected.iter().any(|fact| fact.diagnostic().is_some());
    // What must be rejected says nothing of what must be accepted.
    if is_mistake && smallest.deviation.sign.rejects_valid() {
        return false;
    }
    let program = case.program.as_deref().unwrap_or_default();
    let all = tokens(program);
    let wanted = case
        .expected
        .iter()
        .zip(case.got.iter().map(Some).chain(std::iter::repeat(None)));
    let mut differing = wanted
        .filter(|(wanted, reported)| Some(*wanted) != *reported)
        .map(|(wanted, _)| wanted);
    let line = match differing.next() {
        Some(Fact::Value { name, .. }) => computation(program, name).map(|line| {
            let number = line.as_ptr() as usize - program.as_ptr() as usize;
            let number = program[..number].lines().count() as u32 + 1;
            all.iter().filter(|token| token.line == number).copied().collect()
        }),
        Some(
            Fact::Diagnostic(Diagnostic { line, .. })
            | Fact::Warning(Diagnostic { line, .. })
            | Fact::Fault { line, .. },
        ) => {
            let on_line = |token: &&ProgramToken<'_>| Some(token.line) == *line;
            Some(all.iter().filter(on_line).copied().collect())
        }
        _ => None,
    };
    let line: Option<Vec<ProgramToken<'_>>> = line;
    let reported = case.got.iter().find_map(|fact| fact.diagnostic()?.line);
    let focus = line
        .as_ref()
        .and_then(|line| line.first())
        .map(|token| token.line);
    let is_elsewhere = reported.is_some_and(|reported| reported > 1) && focus.is_some() && reported != focus;
    if is_elsewhere && matches!(smallest.deviation.sign.symptom, Symptom::Rejected(_)) {
        return false;
    }
    let own = own_functions(&all);
    let claimed = line
        .as_ref()
        .map(|line| operations(line, &own))
        .unwrap_or_default();
    let is_value = matches!(case.expected[..], [Fact::Value { .. }, ..]);
    let sign = &smallest.deviation.sign;
    let is_unusable = matches!(sign.symptom, Symptom::Unusable(_));
    if is_value && claimed.is_empty() && (is_unusable || is_unread(&smallest.deviation.got)) {
        return false;
    }
    let kept = operations_of(&smallest.program);
    claimed.is_subset(&kept)
        && has_signed_literal(&line.unwrap_or_default()) <= has_signed_literal(&tokens(&smallest.program))
        && (!(is_unusable || sign.rejects_valid()) || keeps_work(program, &smallest.program, &kept))
}

/// Returns whether a program that an engine does not take still does what the whole one did with its values: conversions by name
/// and accesses of bits, or else the conversion between two types; and whether it still has a text where that has one.
fn keeps_work(whole: &str, program: &str, kept: &BTreeSet<String>) -> bool {
    let has_text = |program: &str| {
        let tokens = tokens(program);
        tokens.iter().any(|token| token.kind == ProgramTokenKind::Text)
    };
    let is_work = |operation: &&String| operation.contains("_TO_") || *operation == "bit access";
    let operations = operations_of(whole);
    let work: Vec<&String> = operations.iter().filter(is_work).collect();
    // What a function converts does not matter where there is no such function.
    let converts = work.iter().any(|operation| operation.contains("_TO_"));
    if has_text(whole) && !has_text(program) && !converts {
        return false;
    }
    let types = |program: &str| {
        let tokens = tokens(program);
        let types: BTreeSet<ElementaryType> = tokens.iter().filter_map(type_of_token).collect();
        types.iter().filter(|ty| **ty != ElementaryType::Bool).count()
    };
    match work.is_empty() {
        true => types(whole) < 2 || types(program) > 1,
        false => work.into_iter().all(|operation| kept.contains(operation)),
    }
}

/// Returns whether a minus stands before a literal with a type.
fn has_signed_literal(tokens: &[ProgramToken<'_>]) -> bool {
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[0].text == "-" && pair[1].kind == ProgramTokenKind::Typed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_run::Verdict;

    #[test]
    fn a_program_that_is_not_taken_still_does_the_work_of_the_whole_one() {
        let keeps = |whole: &str, program: &str| keeps_work(whole, program, &operations_of(program));
        let converting = "x : DINT; b : BOOL; x := INT#5;";
        assert!(!keeps(converting, "x : DINT; b : BOOL; x := x;"));
        assert!(keeps(converting, "x : REAL; x := INT#5;"));
        assert!(!keeps(
            "x : DINT; x := x.3; y : INT;",
            "x : DINT; y : INT; x := y;"
        ));
        assert!(keeps("x : DINT; x := x.3; y : INT;", "x : DINT; x := x.3;"));
        let converting = "b : BOOL; s : STRING; b := STRING_TO_BOOL('TRUE');";
        assert!(keeps(converting, &converting.replace("'TRUE'", "s")));
        assert!(keeps("n : INT; n := LEN('a$L');", "n : INT; n := LEN('');"));
        assert!(!keeps(
            "n : INT; s : STRING; s := '$L'; n := LEN(s);",
            "n : INT; s : STRING; n := LEN(s);"
        ));
    }

    #[test]
    fn a_claim_about_a_value_says_nothing_of_a_program_that_cannot_be_read_or_built() {
        let program = "PROGRAM p\nVAR\nx : INT := INT#-5;\nEND_VAR\nx := x;\nEND_PROGRAM\n";
        let with_claim = |expected: Fact, smallest: &Smallest| {
            let case = CaseEvent {
                id: "a".to_owned(),
                dialect: "matiec".to_owned(),
                engine: "e".to_owned(),
                verdict: Verdict::Fail,
                open: false,
                grade: None,
                basis: "document: a".to_owned(),
                file: "a.toml".to_owned(),
                line: None,
                area: "a".to_owned(),
                title: "t".to_owned(),
                expectation: 0,
                expected: vec![expected],
                got: smallest.deviation.got.clone(),
                duration_us: 0,
                observations: Vec::new(),
                question: None,
                program: Some(program.to_owned()),
                baseline: None,
            };
            keeps_claim(&case, smallest)
        };
        let keeps = |expected: Fact, code: &str| with_claim(expected, &Smallest::rejected(program, 5, code));
        let value = || Fact::Value {
            name: "x".to_owned(),
            value: stickler_types::Value::plain(ElementaryType::Int, 65531),
        };
        assert!(!keeps(value(), "P0002"));
        assert!(keeps(value(), "P4035"));
        assert!(keeps(Fact::Accepted, "P0002"));
        let mut useless = Smallest::rejected(program, 5, "P4035");
        useless.deviation.sign.symptom = Symptom::Unusable("the C cannot be built".to_owned());
        assert!(!with_claim(value(), &useless));
        assert!(with_claim(Fact::Accepted, &useless));
        let mistake = || Fact::Diagnostic(Diagnostic::default());
        assert!(!keeps(mistake(), "P4035"), "a valid program is rejected");
    }
}
