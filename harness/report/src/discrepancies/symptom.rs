//! What an engine does otherwise than expected, in a word, from what was expected and what came.
//!
//! Both texts have one fact a line, in the forms that a judgement writes: `line 6: error P4025`, `line 6: fault subrange`,
//! `r = INT#5`, `r is missing`, `accepted`, `crashed: …`.

use std::fmt;
use stickler_run::{CaseEvent, Verdict};

/// How many words of a message tell one kind of crash from another.
const WORDS: usize = 8;

/// A symptom; cases of one rule with the same symptom most probably have one cause. Its words are those of findings.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Symptom {
    /// It died, with these words.
    Crash(String),
    /// It gave no answer in time.
    Hang,
    /// It answered nonsense.
    Error,
    /// It rejects what must be accepted, with this code, or for this reason.
    Rejected(String),
    /// It rejects for another reason than this code, which must come.
    OtherCode(String),
    /// It finds what this code means, and names another place.
    OtherLine(String),
    /// It accepts what must be rejected with this code.
    NotRejected(String),
    /// It finds some of what is wrong, and not this.
    Incomplete(String),
    /// It stops with this fault, or another one than expected.
    Fault,
    /// It goes on where the program must stop with this fault.
    NotFaulted(String),
    /// A value is wrong.
    Value,
    /// A value is not told.
    Missing,
    /// Its normalised source is another.
    Text,
}

impl Symptom {
    /// The symptom of a case that did not come out as expected.
    pub(super) fn of(case: &CaseEvent) -> Symptom {
        match case.came() {
            Verdict::Crash => return Symptom::Crash(gist(&case.got)),
            Verdict::Timeout => return Symptom::Hang,
            Verdict::Error => return Symptom::Error,
            _ => {}
        }
        let expected: Vec<&str> = case.expected.lines().collect();
        let got: Vec<&str> = case.got.lines().collect();
        let lacking = |line: &&&str| !got.contains(*line);
        let missing: Vec<&str> = expected.iter().filter(lacking).copied().collect();
        let extra: Vec<&str> = got
            .iter()
            .filter(|line| !expected.contains(*line))
            .copied()
            .collect();
        rejection(&expected, &missing, &extra)
            .or_else(|| fault(&missing, &extra))
            .or_else(|| value(&missing, &extra))
            .unwrap_or(Symptom::Text)
    }

    /// A word for the name of a file.
    pub(super) fn word(&self) -> String {
        match self {
            Symptom::Crash(_) => "crash".to_owned(),
            Symptom::Hang => "hang".to_owned(),
            Symptom::Error => "error".to_owned(),
            Symptom::Rejected(code) => format!("rejected-{code}"),
            Symptom::OtherCode(code) => format!("not-{code}"),
            Symptom::OtherLine(code) => format!("line-of-{code}"),
            Symptom::NotRejected(code) => format!("not-rejected-{code}"),
            Symptom::Incomplete(code) => format!("incomplete-{code}"),
            Symptom::Fault => "fault".to_owned(),
            Symptom::NotFaulted(fault) => format!("not-faulted-{fault}"),
            Symptom::Value => "value".to_owned(),
            Symptom::Missing => "missing".to_owned(),
            Symptom::Text => "text".to_owned(),
        }
    }
}

impl fmt::Display for Symptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Symptom::Crash(words) => write!(f, "it dies ({words})"),
            Symptom::Hang => f.write_str("it gives no answer"),
            Symptom::Error => f.write_str("its answer makes no sense"),
            Symptom::Rejected(code) => write!(f, "it rejects ({code}) what must be accepted"),
            Symptom::OtherCode(code) => write!(f, "it rejects, but for another reason than {code}"),
            Symptom::OtherLine(code) => write!(f, "it names another place for {code}"),
            Symptom::NotRejected(code) => write!(f, "it accepts what must be rejected ({code})"),
            Symptom::Incomplete(code) => write!(f, "it does not tell every mistake ({code} is not told)"),
            Symptom::Fault => f.write_str("it stops where the program must not, or with another fault"),
            Symptom::NotFaulted(fault) => write!(f, "it goes on where the program must stop ({fault})"),
            Symptom::Value => f.write_str("it computes another value"),
            Symptom::Missing => f.write_str("it does not tell a value"),
            Symptom::Text => f.write_str("it gives back another text"),
        }
    }
}

fn rejection(expected: &[&str], missing: &[&str], extra: &[&str]) -> Option<Symptom> {
    let wanted = missing.iter().find_map(|line| code(line));
    let told: Vec<String> = extra.iter().filter_map(|line| code(line)).collect();
    let must_reject = expected.iter().any(|line| code(line).is_some());
    match (wanted, told.first()) {
        (Some(wanted), Some(_)) if told.contains(&wanted) => Some(Symptom::OtherLine(wanted)),
        (Some(wanted), Some(_)) => Some(Symptom::OtherCode(wanted)),
        (Some(wanted), None) if extra.contains(&"accepted") => Some(Symptom::NotRejected(wanted)),
        (Some(wanted), None) => Some(Symptom::Incomplete(wanted)),
        (None, Some(told)) => Some(Symptom::Rejected(told.clone())),
        (None, None) if !must_reject && extra.contains(&"rejected") => Some(Symptom::Rejected(String::new())),
        (None, None) => None,
    }
}

/// The code of `line 6: error P4025: Bit access …`; of a compiler without codes the gist of its message.
fn code(line: &str) -> Option<String> {
    let (_, after) = line
        .split_once("error")
        .filter(|(before, _)| before.is_empty() || (before.starts_with("line ") && before.ends_with(": ")))?;
    match after.strip_prefix(": ") {
        Some(message) => Some(gist(message)),
        None => {
            let code = after.trim_start().split(':').next().unwrap_or_default();
            Some(code.to_owned())
        }
    }
}

fn fault(missing: &[&str], extra: &[&str]) -> Option<Symptom> {
    let fault = |line: &&&str| line.starts_with("fault ") || line.contains(": fault ");
    if extra.iter().any(|line| fault(&line)) {
        return Some(Symptom::Fault);
    }
    let wanted = missing.iter().find(|line| fault(line))?;
    let name = wanted.rsplit("fault ").next().unwrap_or_default();
    Some(Symptom::NotFaulted(name.to_owned()))
}

fn value(missing: &[&str], extra: &[&str]) -> Option<Symptom> {
    let name = |line: &str| line.split_once(" = ").map(|(name, _)| name.to_owned());
    let wanted: Vec<String> = missing.iter().filter_map(|line| name(line)).collect();
    let told = |line: &&str| name(line).is_some_and(|name| wanted.contains(&name));
    if extra.iter().any(told) {
        return Some(Symptom::Value);
    }
    (!wanted.is_empty()).then_some(Symptom::Missing)
}

/// The first words of a message, without what changes from program to program: numbers and what stands in quotes or
/// brackets.
fn gist(message: &str) -> String {
    let first = message.lines().next().unwrap_or_default();
    let plain = first.split(['(', '`', '\'', '"']).next().unwrap_or_default();
    let words = plain
        .split_whitespace()
        .filter(|word| !word.contains(|character: char| character.is_ascii_digit()));
    let words: Vec<&str> = words.take(WORDS).collect();
    words.join(" ").trim_end_matches([':', ',', '.']).to_owned()
}

#[cfg(test)]
mod tests {
    use super::Symptom;
    use crate::sample;
    use stickler_run::{CaseEvent, Verdict};

    fn symptom(expected: &str, got: &str) -> String {
        let case = CaseEvent {
            expected: expected.to_owned(),
            got: got.to_owned(),
            ..sample::case("a", Verdict::Fail)
        };
        Symptom::of(&case).word()
    }

    #[test]
    fn what_differs_decides_and_not_the_values_or_the_lines() {
        for (expected, got, word) in [
            ("line 6: error P4069", "accepted", "not-rejected-P4069"),
            (
                "line 6: error P4025",
                "line 1: error P4025: out of range",
                "line-of-P4025",
            ),
            (
                "line 11: error P4069",
                "line 11: error P0002: Syntax error",
                "not-P4069",
            ),
            (
                "line 6: error P4033\nline 7: error P4033",
                "line 6: error P4033",
                "incomplete-P4033",
            ),
            ("r = INT#5", "line 3: error P4018: wrong number", "rejected-P4018"),
            ("r = INT#5", "line 3: error: no `r` here (at 7)", "rejected-no"),
            ("r = INT#5\nq = INT#1", "r = INT#6\nq = INT#1", "value"),
            ("r = INT#5", "r is missing", "missing"),
            (
                "line 16: fault subrange\nr = INT#7",
                "accepted\nr = INT#0",
                "not-faulted-subrange",
            ),
            ("r = INT#7", "line 5: fault division-by-zero\nr = INT#0", "fault"),
            ("a := b;", "a:=b;", "text"),
        ] {
            assert_eq!(symptom(expected, got), word, "{expected} / {got}");
        }
    }

    #[test]
    fn crashes_are_told_apart_by_their_words_and_not_by_their_numbers() {
        let crash = |got: &str| {
            Symptom::of(&CaseEvent {
                got: got.to_owned(),
                ..sample::case("a", Verdict::Crash)
            })
        };
        assert_eq!(
            crash("crashed: signal 11 in stage 3"),
            crash("crashed: signal 6 in stage 4")
        );
        assert_ne!(
            crash("crashed: stack overflow"),
            crash("crashed: assertion failed")
        );
    }
}
