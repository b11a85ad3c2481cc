//! What an engine does otherwise than expected, in a word, from what was expected and what came.

use super::gist::gist;
use crate::fact::{Diagnostic, Fact, Fault};
use std::fmt;
use stickler_run::{CaseEvent, Grade, Verdict};

/// A symptom; cases of one rule with the same symptom most probably have one cause. Its words are those of findings.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(super) enum Symptom {
    /// It died, with these words.
    Crash(String),
    /// It gave no answer in time.
    Hang,
    /// It answered nonsense.
    Error,
    /// It rejects what must be accepted, with this code, or for this reason; empty where it tells neither.
    Rejected(String),
    /// It accepts what must be rejected with this code; empty where any will do.
    NotRejected(String),
    /// It rejects for another reason than this code, which must come.
    OtherCode(String),
    /// It finds what this code means, and names another place.
    OtherLine(String),
    /// It finds some of what is wrong, and not this.
    Incomplete(String),
    /// It finds all that is wrong, and this too, which is not.
    Surplus(String),
    /// It stops with this fault where it must not, or must with another one.
    Fault(String),
    /// It stops with this fault as it must, and names another line, or none.
    FaultLine(String),
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
    /// The symptom of a case that did not come out as expected, on an engine whose rejections had to be so exact.
    pub(super) fn of(case: &CaseEvent, strict: Grade) -> Symptom {
        match case.came() {
            Verdict::Crash => {
                return Symptom::Crash(gist(case.got.strip_prefix("crashed: ").unwrap_or(&case.got)));
            }
            Verdict::Timeout => return Symptom::Hang,
            Verdict::Error => return Symptom::Error,
            _ => {}
        }
        let (expected, got) = (Fact::all(&case.expected), Fact::all(&case.got));
        match (rejects(&expected), rejects(&got)) {
            (true, true) => rejection(&diagnostics(&expected), &diagnostics(&got), strict),
            (true, false) => Symptom::NotRejected(first_reason(&expected)),
            // The program may be rejected, and what is said names a line where nothing is wrong.
            (false, true) if expected.contains(&Fact::Open) => Symptom::Surplus(first_reason(&got)),
            (false, true) => Symptom::Rejected(first_reason(&got)),
            (false, false) => fault(&expected, &got)
                .or_else(|| value(&expected, &got))
                .or_else(|| fault_line(&expected, &got, strict))
                .or_else(|| got.contains(&Fact::Missing).then_some(Symptom::Missing))
                .unwrap_or(Symptom::Text),
        }
    }

    /// A word for the name of a file.
    pub(super) fn word(&self) -> String {
        let (word, about) = self.words();
        match about {
            "" => word.to_owned(),
            about => format!("{word}-{about}"),
        }
    }

    /// The word, and what it is about.
    fn words(&self) -> (&'static str, &str) {
        match self {
            // Its words would fill the name of the file.
            Symptom::Crash(_) => ("crash", ""),
            Symptom::Hang => ("hang", ""),
            Symptom::Error => ("error", ""),
            Symptom::Rejected(reason) => ("rejected", reason),
            Symptom::NotRejected(code) => ("not-rejected", code),
            Symptom::OtherCode(code) => ("not", code),
            Symptom::OtherLine(code) => ("line-of", code),
            Symptom::Incomplete(code) => ("incomplete", code),
            Symptom::Surplus(reason) => ("surplus", reason),
            Symptom::Fault(fault) => ("fault", fault),
            Symptom::FaultLine(fault) => ("line-of", fault),
            Symptom::NotFaulted(fault) => ("not-faulted", fault),
            Symptom::Value => ("value", ""),
            Symptom::Missing => ("missing", ""),
            Symptom::Text => ("text", ""),
        }
    }

    /// Whether it is about where, and by which codes, a program is rejected.
    pub(super) const fn is_of_a_rejection(&self) -> bool {
        matches!(
            self,
            Symptom::OtherCode(_) | Symptom::OtherLine(_) | Symptom::Incomplete(_) | Symptom::Surplus(_)
        )
    }
}

impl fmt::Display for Symptom {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Symptom::Crash(words) => write!(f, "it dies{}", behind(words)),
            Symptom::Hang => f.write_str("it gives no answer"),
            Symptom::Error => f.write_str("its answer makes no sense"),
            Symptom::Rejected(reason) => write!(f, "it rejects what must be accepted{}", behind(reason)),
            Symptom::NotRejected(code) => write!(f, "it accepts what must be rejected{}", behind(code)),
            Symptom::OtherCode(code) => write!(f, "it rejects, but for another reason than {code}"),
            Symptom::OtherLine(code) => write!(f, "it names another place for {code}"),
            Symptom::Incomplete(code) => write!(f, "it does not tell every mistake ({code} is not told)"),
            Symptom::Surplus(reason) => write!(f, "it tells more mistakes than there are{}", behind(reason)),
            Symptom::Fault(fault) => {
                write!(
                    f,
                    "it stops ({fault}) where the program must not, or with another fault"
                )
            }
            Symptom::FaultLine(fault) => {
                write!(f, "it does not tell the line where the program stops ({fault})")
            }
            Symptom::NotFaulted(fault) => write!(f, "it goes on where the program must stop ({fault})"),
            Symptom::Value => f.write_str("it computes another value"),
            Symptom::Missing => f.write_str("it does not tell a value"),
            Symptom::Text => f.write_str("it gives back another text"),
        }
    }
}

/// What a sentence is about, in brackets behind it.
fn behind(words: &str) -> String {
    if words.is_empty() {
        String::new()
    } else {
        format!(" ({words})")
    }
}

fn rejects(facts: &[Fact<'_>]) -> bool {
    let rejects = |fact: &Fact<'_>| matches!(fact, Fact::Diagnostic(_) | Fact::Rejected);
    facts.iter().any(rejects)
}

fn diagnostics<'t>(facts: &[Fact<'t>]) -> Vec<Diagnostic<'t>> {
    let diagnostics = facts.iter().filter_map(|fact| match fact {
        Fact::Diagnostic(diagnostic) => Some(*diagnostic),
        _ => None,
    });
    diagnostics.collect()
}

/// The code of a diagnostic; of a compiler without codes the gist of its message.
fn reason(diagnostic: &Diagnostic<'_>) -> String {
    match diagnostic.code {
        Some(code) => code.to_owned(),
        None => gist(diagnostic.message),
    }
}

fn first_reason(facts: &[Fact<'_>]) -> String {
    diagnostics(facts).first().map(reason).unwrap_or_default()
}

/// What is wrong with a rejection of what must be rejected, by as much of it as was compared.
fn rejection(expected: &[Diagnostic<'_>], got: &[Diagnostic<'_>], strict: Grade) -> Symptom {
    let (missing, extra) = unmet(expected, got, strict);
    // Where the place does not count, only a line on which nothing is wrong is too much.
    let Some(first) = missing.first().filter(|_| strict != Grade::Rejected) else {
        return Symptom::Surplus(extra.first().map(reason).unwrap_or_default());
    };
    let code = reason(first);
    let nothing_met = missing.len() == expected.len() && !extra.is_empty();
    match strict {
        Grade::Code if extra.iter().any(|told| told.code == first.code) => Symptom::OtherLine(code),
        Grade::Code if nothing_met || extra.iter().any(|told| told.line == first.line) => {
            Symptom::OtherCode(code)
        }
        Grade::Line | Grade::Rejected if nothing_met => Symptom::OtherLine(code),
        _ => Symptom::Incomplete(code),
    }
}

/// What is expected and did not come, and what came and is not expected. By the code each counts; by the line all that are on
/// one count once.
fn unmet<'t>(
    expected: &[Diagnostic<'t>],
    got: &[Diagnostic<'t>],
    strict: Grade,
) -> (Vec<Diagnostic<'t>>, Vec<Diagnostic<'t>>) {
    let on_line_of_any =
        |among: &[Diagnostic<'_>], one: &Diagnostic<'_>| among.iter().any(|other| other.line == one.line);
    if strict != Grade::Code {
        let missing = expected.iter().filter(|wanted| !on_line_of_any(got, wanted));
        let extra = got.iter().filter(|told| !on_line_of_any(expected, told));
        return (missing.copied().collect(), extra.copied().collect());
    }
    let mut extra = got.to_vec();
    let mut missing = expected.to_vec();
    missing.retain(|wanted| {
        let same = |told: &Diagnostic<'_>| (told.line, told.code) == (wanted.line, wanted.code);
        let met = extra.iter().position(same);
        met.map(|at| extra.remove(at)).is_none()
    });
    (missing, extra)
}

fn fault_of<'t>(facts: &[Fact<'t>]) -> Option<Fault<'t>> {
    facts.iter().find_map(|fact| match fact {
        Fact::Fault(fault) => Some(*fault),
        _ => None,
    })
}

fn fault(expected: &[Fact<'_>], got: &[Fact<'_>]) -> Option<Symptom> {
    match (fault_of(expected), fault_of(got)) {
        (None, None) => None,
        (Some(wanted), Some(told)) if wanted.name == told.name => None,
        (_, Some(told)) => Some(Symptom::Fault(told.name.to_owned())),
        (Some(wanted), None) => Some(Symptom::NotFaulted(wanted.name.to_owned())),
    }
}

/// A fault that is right but for its line, where the line counts.
fn fault_line(expected: &[Fact<'_>], got: &[Fact<'_>], strict: Grade) -> Option<Symptom> {
    let (wanted, told) = (fault_of(expected)?, fault_of(got)?);
    (strict != Grade::Rejected && wanted.line != told.line)
        .then(|| Symptom::FaultLine(wanted.name.to_owned()))
}

fn value(expected: &[Fact<'_>], got: &[Fact<'_>]) -> Option<Symptom> {
    let differ = |wanted: &Fact<'_>, told: &Fact<'_>| match (wanted, told) {
        (
            Fact::Value { name, value },
            Fact::Value {
                name: same,
                value: other,
            },
        ) => name == same && value != other,
        _ => false,
    };
    let wrong = |wanted: &Fact<'_>| got.iter().any(|told| differ(wanted, told));
    expected.iter().any(wrong).then_some(Symptom::Value)
}

#[cfg(test)]
mod tests {
    use super::Symptom;
    use crate::sample;
    use stickler_run::{CaseEvent, Grade, Verdict};

    fn symptom(expected: &str, got: &str, strict: Grade) -> Symptom {
        let case = CaseEvent {
            expected: expected.to_owned(),
            got: got.to_owned(),
            ..sample::case("a", Verdict::Fail)
        };
        Symptom::of(&case, strict)
    }

    /// Rows of what must come, what came, and the word for it.
    fn are(rows: &[[&str; 3]]) {
        for [expected, got, word] in rows {
            assert_eq!(
                symptom(expected, got, Grade::Code).word(),
                *word,
                "{expected} / {got}"
            );
        }
    }

    #[test]
    fn what_must_be_rejected_is_accepted_or_rejected_wrongly() {
        const ONE: &str = "line 6: error P4025";
        const TWO: &str = "line 6: error P4033\nline 7: error P4033";
        are(&[
            [ONE, "accepted", "not-rejected-P4025"],
            ["rejected", "accepted", "not-rejected"],
            [ONE, "line 1: error P4025: out of range", "line-of-P4025"],
            [ONE, "somewhere: error P4025: out of range", "line-of-P4025"],
            [ONE, "line 9: error P0002: m", "not-P4025"],
            [TWO, "line 6: error P0002: m\nline 7: error P4033", "not-P4033"],
            [TWO, "line 6: error P4033", "incomplete-P4033"],
            [
                TWO,
                "line 6: error P4033\nline 9: error P0002: m",
                "incomplete-P4033",
            ],
            [TWO, "rejected, with no diagnostic", "incomplete-P4033"],
            [
                ONE,
                "line 6: error P4025\nline 9: error P0002: m",
                "surplus-P0002",
            ],
            [
                ONE,
                "line 6: error P4025\nline 6: error P4025: m",
                "surplus-P4025",
            ],
            ["accepted or rejected", "line 6: error P4026: m", "surplus-P4026"],
        ]);
    }

    #[test]
    fn what_must_be_accepted_is_rejected_for_a_reason() {
        const VALUE: &str = "r = INT#5";
        are(&[
            [VALUE, "line 3: error P4018: wrong number", "rejected-P4018"],
            ["accepted", "line 3: error P4018: wrong number", "rejected-P4018"],
            [
                VALUE,
                "line 3: error without a code: no `r` here (at 7)",
                "rejected-no here",
            ],
            [
                VALUE,
                "somewhere: error without a code: don't know 'r'",
                "rejected-don't know",
            ],
            [
                VALUE,
                "somewhere: error without a code: unexpected character at 71",
                "rejected-unexpected character at",
            ],
            [VALUE, "somewhere: error P0002: Syntax error", "rejected-P0002"],
            [VALUE, "rejected, with no diagnostic", "rejected"],
        ]);
        let silent = symptom(VALUE, "rejected, with no diagnostic", Grade::Code);
        assert_eq!(silent.to_string(), "it rejects what must be accepted");
    }

    #[test]
    fn what_is_computed_is_another_value_or_none() {
        are(&[
            ["r = INT#5\nq = INT#1", "r = INT#6\nq = INT#1", "value"],
            [
                "error = INT#5\nfault = INT#1",
                "error = INT#6\nfault = INT#1",
                "value",
            ],
            ["r = INT#5", "r is missing", "missing"],
            ["a := b;\nc := a = b;", "a:=b;\nc := a = b;", "text"],
        ]);
    }

    #[test]
    fn a_program_stops_otherwise_than_it_must() {
        const STOPS: &str = "line 16: fault subrange\nr = INT#7";
        are(&[
            [STOPS, "accepted\nr = INT#0", "not-faulted-subrange"],
            [STOPS, "line 16: fault step-limit\nr = INT#7", "fault-step-limit"],
            [
                "r = INT#7",
                "line 5: fault step-limit\nr = INT#0",
                "fault-step-limit",
            ],
            [STOPS, "fault subrange\nr is missing", "line-of-subrange"],
            [STOPS, "fault subrange\nr = INT#0", "value"],
        ]);
        let missing = symptom(STOPS, "fault subrange\nr is missing", Grade::Rejected);
        assert_eq!(missing, Symptom::Missing, "the line does not count");
    }

    #[test]
    fn what_is_not_compared_is_no_symptom() {
        const TWO: &str = "line 6: error P4049\nline 7: error P4049";
        let of = |got: &str, strict| symptom(TWO, got, strict).word();
        let told = "line 6: error without a code: no number";
        assert_eq!(of(told, Grade::Line), "incomplete-P4049");
        let elsewhere = "line 9: error without a code: no sum";
        assert_eq!(of(elsewhere, Grade::Line), "line-of-P4049");
        let more = format!("{told}\nline 7: error without a code: m\n{elsewhere}");
        assert_eq!(of(&more, Grade::Line), "surplus-no sum");
        assert_eq!(of(elsewhere, Grade::Rejected), "surplus-no sum");
        assert_eq!(of("accepted", Grade::Rejected), "not-rejected-P4049");
    }

    #[test]
    fn crashes_are_told_apart_by_their_words_and_not_by_their_numbers() {
        let crash = |got: &str| {
            let case = CaseEvent {
                got: format!("crashed: {got}"),
                ..sample::case("a", Verdict::Crash)
            };
            Symptom::of(&case, Grade::Code)
        };
        assert_eq!(crash("signal 11 in stage 3"), crash("signal 6 in stage 4"));
        let ended = |words: &str| crash(&format!("it ended (exit status: 3); its last words: {words}"));
        assert_ne!(ended("stack overflow"), ended("the pool isn't there"));
        assert_eq!(
            ended("Error: V9009 - the pool isn't there (task 0)").to_string(),
            "it dies (it ended; its last words: Error: - the pool isn't there)"
        );
    }
}
