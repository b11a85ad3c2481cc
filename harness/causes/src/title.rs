//! The title of a cause: what the engine does, in the words in which developers of compilers report defects, and the line of the
//! program that shows it.

mod wrong_value;

#[cfg(test)]
pub(crate) use wrong_value::condition;

use crate::compiler_place::compiler_place;
use crate::failure_sign::differing_lines;
use crate::lines::{LinePlace, clipped, described, line_with_number, place_of, unit_of};
use crate::program::{Program, ReadProgram};
use crate::reduction::Smallest;
use crate::suspect::{self, unimplemented};
use crate::words::{LOOPS, has_word, words};
use stickler_engines::OTHER_TYPE;
use stickler_reference::errors;
use stickler_run::{Fact, Reduced, Symptom};
use stickler_syntax::source::Span;
use stickler_syntax::tree::Pou;
use stickler_types::{Code, Diagnostic, DialectName};

/// Returns the title of a cause, by the smallest program that shows it. Stickler's own codes, which an adapter gives to the
/// diagnostics of an engine without codes, are left out; codes of the engine's own stay.
pub(crate) fn title(smallest: &Smallest, has_codes: bool) -> String {
    let program = Program::new(&smallest.program);
    let (expected, got) = (&smallest.deviation.expected[..], &smallest.deviation.got[..]);
    let titled = Titled {
        program: program.read(),
        expected,
        got,
        has_codes,
    };
    let told = titled.sentence(&smallest.deviation.sign.symptom);
    // What nothing uses stays in a small program because it matters.
    let beside = titled
        .unused()
        .filter(|_| smallest.reduction == Reduced::Smallest);
    beside.map_or(told.clone(), |code| format!("{told}, beside `{}`", clipped(code)))
}

/// A small program of which a title tells.
struct Titled<'t, 's> {
    program: ReadProgram<'t, 's>,
    expected: &'t [Fact],
    got: &'t [Fact],
    has_codes: bool,
}

impl Titled<'_, '_> {
    /// Returns a declaration that nothing uses and that is no mistake: of another variable in the section of the line of a mistake, or of a type
    /// where an engine reports a line of a valid program.
    fn unused(&self) -> Option<&str> {
        let (expected, got) = (first(self.expected).line, first(self.got).line);
        let line = expected.or(got)?;
        let all = words(self.program.text);
        let number = |name: &str| all.iter().filter(|word| word.eq_ignore_ascii_case(name)).count();
        let covers =
            |span: Span| (self.program.line(span)..=self.program.lines.line(span.end)).contains(&line);
        let sections = self.program.unit.pous().flat_map(|pou| &pou.blocks);
        let groups = sections
            .filter(|section| expected.is_some() && covers(section.span))
            .flat_map(|section| &section.groups);
        let variables = groups.filter_map(|group| Some((*group.names.first()?, group.specification.span)));
        let types = self.program.unit.types().filter(|_| expected.is_none());
        let mut all = variables.chain(types.map(|one| (one.name, one.specification.span)));
        let (unused, _) = all.find(|(name, span)| number(name.text) == 1 && !covers(*span))?;
        self.statement_on(self.program.line(unused.span))
    }

    fn sentence(&self, symptom: &Symptom) -> String {
        let (expected, got) = (self.expected, self.got);
        let wanted = first(expected);
        let reported = self.reported(first(got));
        let (line, somewhere) = (self.line_in_unit(wanted.line), self.line_in_unit(None));
        let (mistake, message) = (named(&wanted), said(&reported));
        match symptom {
            // The line does not show the mistake, so the title names it.
            Symptom::NotRejected(code) => {
                let is_warned = got.iter().any(|fact| matches!(fact, Fact::Warning(_)));
                let warned = if is_warned { " with a warning" } else { "" };
                match (self.wrong(code), wanted.code) {
                    (Some(wrong), Some(code)) => {
                        format!("{line} is accepted{warned}, though {wrong} ({code})")
                    }
                    (Some(wrong), None) => format!("{line} is accepted{warned}, though {wrong}"),
                    (None, _) => format!("{line} is accepted{warned}, not rejected"),
                }
            }
            Symptom::Rejected(_) => {
                let by_number = || line_with_number(&self.program, &reported.message);
                let place = reported.line.or_else(by_number);
                format!("{} is rejected: {message}", self.line_in_unit(place))
            }
            Symptom::NotImplemented(_) => {
                let line = unimplemented(&self.program, got);
                let unit = unit_of(&self.program, line).map_or(String::new(), |unit| format!(" in {unit}"));
                let line = described(&self.program, line);
                // Who promises it stands below, and does not decide.
                let reason = || {
                    got.iter().find_map(|fact| match fact {
                        Fact::NotImplemented { reason, .. } => Some(format!(": {}", clipped(reason))),
                        _ => None,
                    })
                };
                let place = compiler_place(got).map(|place| format!(" at {place}"));
                format!(
                    "{line}{unit} is not implemented{}",
                    place.or_else(reason).unwrap_or_default()
                )
            }
            Symptom::OtherCode { code, .. } => {
                let wrong = summary(code).map_or(String::new(), |wrong| format!(" ({wrong})"));
                format!("{line} is rejected with {message}, not with {code}{wrong}")
            }
            Symptom::NoPlace(_) => {
                format!("{line} is rejected without the place of the mistake: {message}")
            }
            Symptom::OtherLine(_) => {
                format!("{line}: {mistake} is reported on another line")
            }
            Symptom::Incomplete(code) => {
                let missing = self.missing(code);
                let (line, mistake) = (self.line(missing.line), named(&missing));
                let other = self.line(first(got).line);
                format!("{line}: {mistake} is not reported beside the mistake in {other}")
            }
            Symptom::Surplus(reported) => self.surplus(reported, &wanted),
            Symptom::Value | Symptom::Missing => self.wrong_value(),
            Symptom::OtherType => format!("values have {OTHER_TYPE}"),
            Symptom::NotWarned(_) => {
                let missing = warning(expected, got);
                let wrong = missing.code.as_deref().and_then(summary);
                let wrong = wrong.map_or(String::new(), |wrong| format!(" that {wrong}"));
                format!("{} is accepted without a warning{wrong}", self.line(missing.line))
            }
            Symptom::Warned(_) => {
                let extra = warning(got, expected);
                let (line, message) = (self.line(extra.line), said(&extra));
                format!("{line} is accepted with a warning: {message}")
            }
            // What is wrong with a program may be what the engine does not bear.
            Symptom::Crash(words) => {
                let reason = self.reason(words);
                let says = panic(&reason).map_or(String::new(), |says| format!(": {says}"));
                let place = compiler_place(got).map(|place| format!(" at {place}{says}"));
                let reason = place.unwrap_or_else(|| format!(": {reason}"));
                let wrong = wanted.code.as_deref().and_then(|code| self.wrong(code));
                let is_there = |error: &Diagnostic| error.line.is_some() && error.line == wanted.line;
                let errors = errors(self.program.text, DialectName::IEC_ED3);
                let on_line = || Some(errors.into_iter().find(is_there)?.message);
                let wrong = wrong.or_else(on_line);
                let wrong = wrong.map_or(String::new(), |wrong| format!(", where {wrong},"));
                format!("{}{wrong} makes it crash{reason}", self.line_in_unit(wanted.line))
            }
            Symptom::Unusable(words) => format!("{somewhere} is accepted, but {}", self.reason(words)),
            Symptom::Hang => {
                let is_loop = |text: &str| LOOPS.iter().any(|word| has_word(text, word));
                let mut lines = self.program.text.lines().zip(1..);
                let found = lines.find(|(text, _)| is_loop(text)).map(|(_, number)| number);
                format!("{}: {}", self.line(found), clipped(&Fact::text(got)))
            }
            Symptom::Error(words) => format!("its answer makes no sense: {}", clipped(words)),
            Symptom::Fault(_) => {
                let line = self.line_in_unit(Some(suspect::stopping(&self.program)));
                format!("{line} {}", stops(got))
            }
            Symptom::FaultLine(fault) if matches!(got, [Fact::Fault { line: None, .. }, ..]) => {
                format!("faults are reported without their lines, such as {fault}")
            }
            Symptom::FaultLine(fault) => format!("the fault {fault} is reported with another line"),
            Symptom::NotFaulted(fault) => format!("{somewhere} does not stop with the fault {fault}"),
            Symptom::Text => rendered(expected, got),
        }
    }

    /// Returns a diagnostic as the title tells it: without a code that is not the engine's own, unless the title keeps codes, and without
    /// line 1. That line is dropped because compilers say it when they have lost the place.
    fn reported(&self, mut reported: Diagnostic) -> Diagnostic {
        if !self.has_codes && reported.registered_code().is_some() {
            reported.code = None;
        }
        reported.line = reported.line.filter(|line| *line > 1);
        reported
    }

    /// Returns the reason of a crash with its numbers, which `words` have lost; of what a compiler of C says the message, without its place.
    fn reason(&self, words: &str) -> String {
        let mut got = self.got.iter();
        let reason = got.find_map(|fact| match fact {
            Fact::Crashed { reason } => Some(clipped(reason)),
            Fact::Unusable { reason } => Some(match reason.split_once(" error: ") {
                Some((before, message)) => {
                    let what = before.split(": ").next().unwrap_or_default();
                    format!("{what}: {}", clipped(message))
                }
                None => match (panic(reason), reason.split_once(';')) {
                    (Some(says), Some((what, _))) => format!("{what}: {}", clipped(says)),
                    _ => clipped(reason),
                },
            }),
            _ => None,
        });
        reason.unwrap_or_else(|| clipped(words))
    }

    /// Returns a line in words; where it is not known or says nothing, the one that most probably matters.
    fn line(&self, number: Option<u32>) -> String {
        described(&self.program, self.telling(number))
    }

    /// Returns a line in words like [`Titled::line`], with the IF, CASE or loop around it, without which the defect does not come, and the kind
    /// of the unit that it stands in where that is no PROGRAM.
    fn line_in_unit(&self, number: Option<u32>) -> String {
        let number = self.telling(number);
        let told = described(&self.program, number);
        let guard = suspect::guard_of(&self.program, number)
            .filter(|guard| !told.contains(*guard) && !told.starts_with("`ELS"));
        let guard = guard.map_or(String::new(), |guard| format!(" behind `{}`", clipped(guard)));
        told + &guard + &self.unit(number)
    }

    /// Returns what is wrong by the words of the reference, or else by those of the code. How large an array may be is the reference's own
    /// limit.
    fn wrong(&self, code: &str) -> Option<String> {
        let is_limit = code == Code::ArraySizeOverflow.as_str();
        let errors = errors(self.program.text, DialectName::IEC_ED3).into_iter();
        let mut of_code = errors.filter(|error| error.code.as_deref() == Some(code));
        let said = of_code.next().filter(|_| !is_limit).map(|error| error.message);
        said.or_else(|| summary(code).map(str::to_owned))
    }

    fn telling(&self, number: Option<u32>) -> u32 {
        let known = number.filter(|number| suspect::is_telling(&self.program, *number));
        known.unwrap_or_else(|| suspect::culprit(&self.program))
    }

    /// Returns the words about the unit that a line stands in; none of a PROGRAM, and of a line among the types.
    fn unit(&self, number: u32) -> String {
        let is_head = |pou: &Pou<'_>| self.program.line(pou.name.span) == number;
        let is_inside = !matches!(place_of(&self.program, number), LinePlace::Types)
            && !self.program.unit.pous().any(is_head);
        let unit = unit_of(&self.program, number).filter(|_| is_inside);
        unit.map_or(String::new(), |unit| format!(" in {unit}"))
    }

    /// Returns the expected diagnostic with this code that did not come on its line; where codes are not compared, the first on whose
    /// line nothing came.
    fn missing(&self, code: &str) -> Diagnostic {
        // Consumed across the calls: both lists go by line.
        let mut reported = self.got.iter().filter_map(Fact::diagnostic);
        let mut is_missing = |one: &&Diagnostic| match &one.code {
            Some(own) => {
                own == code
                    && !self
                        .got
                        .iter()
                        .filter_map(Fact::diagnostic)
                        .any(|reported| (reported.line, &reported.code) == (one.line, &one.code))
            }
            None => !reported.any(|reported| reported.line == one.line),
        };
        let found = self
            .expected
            .iter()
            .filter_map(Fact::diagnostic)
            .find(|one| is_missing(one));
        found.cloned().unwrap_or_default()
    }

    fn surplus(&self, reported: &str, wanted: &Diagnostic) -> String {
        let extra = || self.got.iter().filter(|fact| !self.expected.contains(fact));
        let has_code = |one: &&Diagnostic| one.code.as_deref() == Some(reported);
        let of_code = || extra().filter_map(Fact::diagnostic).filter(has_code);
        // The first on the line of the mistake may be the mistake.
        let elsewhere = of_code().find(|one| one.line != wanted.line);
        let of_code = elsewhere.or_else(|| of_code().next_back());
        let extra = of_code.or_else(|| extra().find_map(Fact::diagnostic));
        let extra = extra.cloned().unwrap_or_default();
        if extra.line.is_none() && extra.code.is_some() && extra.code == wanted.code {
            let (line, mistake) = (self.line(wanted.line), named(wanted));
            return format!("{line}: {mistake} is reported once more, without its place");
        }
        let (line, message) = (self.line(extra.line), said(&extra));
        match extra.line == wanted.line {
            true => format!("{line}: the mistake is reported twice, also as {message}"),
            false => format!("{line} is reported beside the mistake: {message}"),
        }
    }
}

/// Returns what a panic says, which stands behind its place.
fn panic(reason: &str) -> Option<&str> {
    let mut parts = reason
        .split(" | ")
        .skip_while(|part| !part.contains("panicked at"));
    parts.nth(1)
}

/// Returns what a program does that stops with a fault, in the words of the engine.
pub(crate) fn stops(got: &[Fact]) -> String {
    let mut faults = got.iter().filter_map(|fact| match fact {
        Fact::Fault { fault, .. } => Some(fault),
        _ => None,
    });
    faults.next().map_or_else(
        || "stops".to_owned(),
        |fault| format!("stops with the fault {fault}"),
    )
}

/// Returns the error among some facts that says most.
fn first(facts: &[Fact]) -> Diagnostic {
    Fact::first_error(facts).cloned().unwrap_or_default()
}

/// Returns the first warning of `these` that the others do not have.
fn warning(these: &[Fact], others: &[Fact]) -> Diagnostic {
    let unmet = these.iter().find_map(|fact| match fact {
        Fact::Warning(warning) if !others.contains(fact) => Some(warning.clone()),
        _ => None,
    });
    unmet.unwrap_or_default()
}

fn rendered(expected: &[Fact], got: &[Fact]) -> String {
    let rejected = got.iter().find_map(|fact| match fact {
        Fact::NotRendered {
            again: true,
            rejection,
        } => Some(rejection.as_deref().unwrap_or("no text")),
        _ => None,
    });
    let number = |facts: &[Fact]| {
        let mut lines = facts.iter().filter_map(|fact| match fact {
            Fact::Rendered { lines } => Some(lines.len()),
            _ => None,
        });
        lines.next()
    };
    match (differing_lines(expected, got), rejected) {
        (Some((wanted, _)), _) if number(got) < number(expected) => {
            format!("`{}` is left out of what is rendered", clipped(wanted))
        }
        (Some((wanted, reported)), _) => {
            format!("`{}` is rendered as `{}`", clipped(wanted), clipped(reported))
        }
        (None, Some(message)) => {
            let message = clipped(message);
            format!("what it renders is rejected when that is rendered again: {message}")
        }
        (None, None) => "a rendered program has other lines".to_owned(),
    }
}

/// Returns what a code of the registry says is wrong; `None` for another code.
fn summary(code: &str) -> Option<&'static str> {
    Some(code.parse::<Code>().ok()?.summary())
}

/// Returns what an expected diagnostic says is wrong, with its code; nothing certain where codes are not compared.
fn named(wanted: &Diagnostic) -> String {
    let code = wanted.code.as_deref();
    match code.and_then(|code| Some((code, summary(code)?))) {
        Some((code, wrong)) => format!("that {wrong} ({code})"),
        None => code.unwrap_or("the mistake").to_owned(),
    }
}

/// Returns the code and the message of a diagnostic.
fn said(reported: &Diagnostic) -> String {
    let parts = [reported.code.as_deref().unwrap_or_default(), &reported.message];
    let parts: Vec<&str> = parts.into_iter().filter(|part| !part.is_empty()).collect();
    match parts.is_empty() {
        true => "no reason is given".to_owned(),
        false => clipped(&parts.join(" ")),
    }
}
