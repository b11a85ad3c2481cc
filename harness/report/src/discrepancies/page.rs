//! The parts of a page about an engine: its name, blocks of code, and what was expected beside what came.

use crate::basis::Basis;
use crate::markdown::{fence, inline};
use crate::text::visible;
use stickler_run::{EngineHeader, Fact, Grade};
use stickler_types::{Diagnostic, counted, join};

/// The words about what no program may make of a compiler.
const NO_CRASH: &str = "an answer, no crash";

/// Adds the expected and the actual facts; `by` stands before the expected ones. Of a compiler that crashes, a rule of Stickler demands
/// no more than an answer.
pub(super) fn expected_and_got(
    text: &mut String,
    by: &str,
    (basis, expected, got): (&str, &[Fact], &[Fact]),
    told: &Told<'_>,
) {
    let no_answer = |fact: &Fact| matches!(fact, Fact::Crashed { .. } | Fact::TimedOut { .. });
    let is_fault = |fact: &Fact| matches!(fact, Fact::Fault { .. });
    let is_unusable = |fact: &Fact| matches!(fact, Fact::Unusable { .. });
    let is_rule = Basis::of(basis).is_rule();
    let (wanted, reported) = (without_agreeing(expected, got), without_agreeing(got, expected));
    if is_rule && got.iter().any(no_answer) {
        block(text, "Expected:", "", NO_CRASH);
    } else if got.iter().any(no_answer) && matches!(expected, [Fact::Accepted]) {
        block(text, by, "", NO_CRASH);
    } else if got.iter().any(is_fault) && matches!(expected, [Fact::Accepted]) {
        block(text, by, "", "the program runs to its end");
    } else if is_rule && got.iter().any(is_unusable) {
        block(text, "Expected:", "", "a rejection, or a program that runs");
    } else {
        block(text, by, "", &visible(&Fact::text(&wanted)));
    }
    block(text, "Got:", "", &visible(&told.text(&reported)));
    let agreeing = (expected.len() - wanted.len()) as u64;
    if agreeing > 0 {
        let values = counted(agreeing, "other value is", "other values are");
        text.push_str(&format!("{values} as expected.\n\n"));
    }
}

/// The codes, lines and texts that a compiler is known to have printed, so that a page tells its answer by no others.
pub(super) struct Told<'p> {
    /// The text that the commands of the page print; empty where nobody ran them.
    pub(super) printed: &'p str,
    /// The worst grade of a rejection by the compiler that still passed.
    pub(super) strict: Grade,
}

impl Told<'_> {
    /// Returns what a compiler did, as text: without codes and lines that an adapter gave to its diagnostics, and where it names no fault
    /// with what it printed last.
    pub(super) fn text(&self, got: &[Fact]) -> String {
        join(got.iter().map(|fact| self.line(fact)), "\n")
    }

    fn line(&self, fact: &Fact) -> String {
        let reported = match fact {
            Fact::Diagnostic(reported) | Fact::Warning(reported) if !reported.message.is_empty() => reported,
            Fact::Fault { line: None, .. } => {
                return match self.printed.lines().last() {
                    Some(last) => format!("the program stops: {last}"),
                    None => fact.to_string(),
                };
            }
            Fact::Crashed { reason } | Fact::Unusable { reason } => {
                return match self.printed_line(reason) {
                    Some(line) => fact.to_string().replace(reason, &line),
                    None => fact.to_string(),
                };
            }
            // A rejection without a word has no code of the compiler's own.
            Fact::Diagnostic(silent) if self.strict != Grade::Code => {
                let code = None;
                let silent = Diagnostic {
                    code,
                    ..silent.clone()
                };
                return Fact::Diagnostic(silent).to_string();
            }
            _ => return fact.to_string(),
        };
        let number = |line: &u32| {
            let mut numbers = self.printed.split(|sign: char| !sign.is_ascii_digit());
            self.printed.is_empty() || numbers.any(|number| number == line.to_string())
        };
        let is_own = |code: &&String| match self.printed {
            "" => self.strict == Grade::Code || reported.registered_code().is_none(),
            printed => printed.contains(code.as_str()),
        };
        let line = reported.line.filter(number);
        let code = reported.code.as_ref().filter(is_own);
        format!(
            "{}{}{}: {}",
            line.map_or(String::new(), |line| format!("line {line}: ")),
            reported.severity.as_str(),
            code.map_or(String::new(), |code| format!(" {code}")),
            reported.message
        )
    }

    /// Returns why a compiler died, or wrote what cannot be built, with the line that it printed, in which files have the names that they have
    /// beside the page; `None` where it printed none.
    fn printed_line(&self, reason: &str) -> Option<String> {
        const SIGN: &str = "rror: ";
        let tells = |line: &&str| {
            line.split_once(SIGN)
                .is_some_and(|(_, message)| !message.is_empty() && reason.contains(message))
        };
        let line = self.printed.lines().find(tells)?;
        let what = reason.split_once(": ").map_or("", |(what, _)| what);
        Some(match reason.split_once(line) {
            Some((before, _)) => format!("{before}{line}"),
            None if line.contains(what) => line.to_owned(),
            None => format!("{what}: {line}"),
        })
    }
}

/// Returns the facts without those values that the other facts have too, where all that differs are values.
pub(super) fn without_agreeing(facts: &[Fact], others: &[Fact]) -> Vec<Fact> {
    let is_value = |fact: &Fact| {
        matches!(
            fact,
            Fact::Value { .. } | Fact::MissingValue { .. } | Fact::OtherValue { .. }
        )
    };
    let are_values = facts.iter().chain(others).all(is_value);
    let differs = |fact: &&Fact| !others.contains(fact);
    match are_values && facts.iter().any(|fact| differs(&fact)) {
        true => facts.iter().filter(differs).cloned().collect(),
        false => facts.to_vec(),
    }
}

/// Returns the sentence about the parts of a diagnostic that were not compared.
pub(super) const fn not_compared(strict: Grade) -> &'static str {
    match strict {
        Grade::Code => "",
        Grade::Line => "Codes are Stickler's own and were not compared, only lines. ",
        Grade::Rejected => "Codes are Stickler's own; neither they nor lines were compared. ",
    }
}

pub(super) fn called(name: &str, about: Option<&EngineHeader>) -> String {
    let version = about.map_or("", |about| about.version.as_str());
    inline(format!("{name} {version}").trim_end())
}

/// Adds a sentence and a code block, with a fence that the code cannot close.
pub(super) fn block(text: &mut String, before: &str, language: &str, code: &str) {
    let fence = fence(code);
    let code = code.trim_end_matches('\n');
    text.push_str(&format!("{before}\n\n{fence}{language}\n{code}\n{fence}\n\n"));
}
