//! The answer of an engine to a question about a conversion, in a word or a value, from the case that asks.

use stickler_conversions::overview::ComparedAnswer;
use stickler_run::{CaseEvent, Fact, Observed, Verdict};
use stickler_types::{Diagnostic, Value};

/// The maximum number of characters of an answer.
const MAX_CHARACTERS: usize = 80;

/// Returns what an engine answered to a case; `None` where the case asserts nothing and nothing was recorded.
pub(crate) fn answer_of(case: &CaseEvent) -> Option<ComparedAnswer> {
    Some(match case.verdict {
        Verdict::Pass | Verdict::Xpass if case.open => ComparedAnswer::Open(recorded(case)?.to_owned()),
        Verdict::Pass | Verdict::Xpass => ComparedAnswer::Met,
        _ => ComparedAnswer::Other(other(case)),
    })
}

/// Returns what was recorded of a case: the value of a variable, or else whether it was accepted, or the fault.
fn recorded(case: &CaseEvent) -> Option<&str> {
    let is_value = |observed: &&Observed| Value::parse(&observed.value).is_ok();
    let value = case.observations.iter().find(is_value);
    let observed = value.or_else(|| case.observations.first())?;
    Some(shortened(&observed.value))
}

/// Returns what an engine did, in a word or a value: `rejected P4035`, or else what it did otherwise than expected.
fn other(case: &CaseEvent) -> String {
    let diagnostic = case.got.iter().find_map(Fact::diagnostic);
    if let Some(diagnostic) = diagnostic {
        return with_code("rejected", diagnostic);
    }
    let deviating = case.got.iter().find(|fact| !case.expected.contains(fact));
    let missing = |fact: &Fact| matches!(fact, Fact::Warning(_)) && !case.got.contains(fact);
    if deviating.is_none() && case.expected.iter().any(missing) {
        return "no warning".to_owned();
    }
    match deviating.or(case.got.first()) {
        Some(Fact::Value { value, .. }) => shortened(&value.to_string()).to_owned(),
        Some(Fact::Warning(warning)) => with_code("warned", warning),
        Some(Fact::Unsupported { .. }) => "unsupported".to_owned(),
        Some(Fact::Lacks { .. }) => "waiting".to_owned(),
        Some(Fact::Crashed { .. }) => "crashed".to_owned(),
        Some(fact) => {
            let text = fact.to_string();
            let (first, _) = text.split_once([':', '\n']).unwrap_or((&text, ""));
            shortened(first).to_owned()
        }
        None => "nothing".to_owned(),
    }
}

/// Returns a word with the code of a diagnostic behind it, if it has one.
fn with_code(word: &str, diagnostic: &Diagnostic) -> String {
    let code = diagnostic.code.as_deref().unwrap_or_default();
    format!("{word} {code}").trim_end().to_owned()
}

/// Shortens an answer to what a cell of a table has room for.
pub(crate) fn shortened(text: &str) -> &str {
    let end = text
        .char_indices()
        .nth(MAX_CHARACTERS)
        .map_or(text.len(), |(end, _)| end);
    &text[..end]
}

#[cfg(test)]
mod tests {
    use super::other;
    use crate::sample;
    use stickler_run::{CaseEvent, Fact, Verdict};
    use stickler_types::Diagnostic;

    #[test]
    fn an_answer_names_what_departs_from_the_expectation() {
        let fact = |word: &str| match word {
            "accepted" => Fact::Accepted,
            "rejected" => sample::reported(6, "P4035", ""),
            "warned" => Fact::Warning(Diagnostic {
                code: Some("C0195".to_owned()),
                ..Diagnostic::default()
            }),
            literal => sample::value("into", literal),
        };
        for (expected, got, answer) in [
            ("accepted", "accepted warned", "warned C0195"),
            ("accepted warned", "accepted", "no warning"),
            ("INT#3 warned", "INT#3", "no warning"),
            ("INT#3 warned", "INT#4", "INT#4"),
            ("INT#3 warned", "INT#4 warned", "INT#4"),
            ("accepted warned", "rejected", "rejected P4035"),
        ] {
            let case = CaseEvent {
                expected: expected.split(' ').map(fact).collect(),
                got: got.split(' ').map(fact).collect(),
                ..sample::case("a::p(1)", Verdict::Fail)
            };
            assert_eq!(other(&case), answer, "{expected}: {got}");
        }
    }
}
