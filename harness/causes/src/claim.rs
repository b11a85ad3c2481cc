//! Whether the claim of a case still speaks of the program that became of the case's.

use crate::failure_sign::is_unread;
use crate::program::Program;
use crate::reduction::Smallest;
use crate::words::{type_of_word, valued_types, valued_types_among, words, words_in_use};
use crate::work::{Role, operations, words_of, works};
use std::collections::BTreeSet;
use stickler_run::{CaseEvent, Fact, Symptom};
use stickler_types::Diagnostic;

/// Returns whether the claim of a case still speaks of a program that was made from the case's: whether the program has the
/// operations of that line of the case in which its expectation shows, and is not rejected for another line. A claim about a value
/// says nothing of a program without an operation that the engine cannot read, makes nothing of use of or stops in, and one about a mistake nothing of a
/// program without it.
pub(crate) fn keeps_claim(case: &CaseEvent, smallest: &Smallest) -> bool {
    let is_mistake = case.expected.iter().any(|fact| fact.diagnostic().is_some());
    // What must be rejected says nothing of what must be accepted.
    if is_mistake && smallest.deviation.sign.rejects_valid() {
        return false;
    }
    let text = case.program.as_deref().unwrap_or_default();
    let program = Program::new(text);
    let program = program.read();
    let got = case.got.iter().map(Some).chain(std::iter::repeat(None));
    let mut differing = case
        .expected
        .iter()
        .zip(got)
        .filter(|(wanted, reported)| Some(*wanted) != *reported);
    let line = match differing.next().map(|(wanted, _)| wanted) {
        Some(Fact::Value { name, .. }) => program.computation(name),
        Some(
            Fact::Diagnostic(Diagnostic { line, .. })
            | Fact::Warning(Diagnostic { line, .. })
            | Fact::Fault { line, .. },
        ) => *line,
        _ => None,
    };
    let sign = &smallest.deviation.sign;
    let reported = case.got.iter().find_map(|fact| fact.diagnostic()?.line);
    let is_elsewhere = reported.is_some_and(|reported| reported > 1) && line.is_some() && reported != line;
    if is_elsewhere && matches!(sign.symptom, Symptom::Rejected(_)) {
        return false;
    }
    let works = works(text);
    let on_line = works.iter().filter(|work| Some(program.line(work.span)) == line);
    let claimed = words_of(on_line, Role::Operation);
    let is_value = matches!(case.expected[..], [Fact::Value { .. }, ..]);
    let is_unusable = matches!(sign.symptom, Symptom::Unusable(_));
    let is_stopped = matches!(sign.symptom, Symptom::Fault(_));
    // A call only leads to what the claim is about.
    let has_none = claimed.iter().all(|operation| is_stopped && operation == "call");
    if is_value && has_none && (is_unusable || is_stopped || is_unread(&smallest.deviation.got)) {
        return false;
    }
    let kept = operations(&smallest.program);
    let line = line.and_then(|line| program.line_text(line)).unwrap_or_default();
    claimed.is_subset(&kept)
        && has_signed_literal(line) <= has_signed_literal(&smallest.program)
        && (!(is_unusable || sign.rejects_valid()) || keeps_work(text, &smallest.program, &kept))
}

/// Returns whether a program that an engine does not take still does what the whole one did with its values: conversions by name
/// and accesses of bits, or else the conversion between two types; and whether it still has a text where that has one.
pub(crate) fn keeps_work(whole: &str, program: &str, kept: &BTreeSet<String>) -> bool {
    let has_text = |text: &str| words(text).iter().any(|word| word.starts_with(['\'', '"']));
    let is_work = |operation: &&String| operation.contains("_TO_") || *operation == "bit access";
    let operations = operations(whole);
    let work: Vec<&String> = operations.iter().filter(is_work).collect();
    // What a function converts does not matter where there is no such function.
    let converts = work.iter().any(|operation| operation.contains("_TO_"));
    if has_text(whole) && !has_text(program) && !converts {
        return false;
    }
    match work.is_empty() {
        true => valued_types(whole).len() < 2 || valued_types_among(words_in_use(program)).len() > 1,
        false => work.into_iter().all(|operation| kept.contains(operation)),
    }
}

/// Returns whether a minus stands before a literal with a type.
fn has_signed_literal(text: &str) -> bool {
    let words = words(text);
    words
        .windows(2)
        .any(|pair| pair[0] == "-" && pair[1].contains('#') && type_of_word(pair[1]).is_some())
}
