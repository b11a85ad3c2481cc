//! Holding what an engine answered against what a case expects. Basis: design, sections 3.1 and 6.

mod bodies;
mod diagnostics;
mod rendered;
mod sheet;
mod values;

pub use bodies::rendered_bodies;

use crate::{Answers, Grade, Observed, Verdict};
use sheet::Sheet;
use stickler_engines::{NamedValue, Outcome};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedFault};
use stickler_types::Fault;

/// What is to be said of a case on an engine.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Judgement {
    /// What came of it.
    pub verdict: Verdict,
    /// How exactly an expected rejection or fault was right; `None` where none was expected or none came.
    pub grade: Option<Grade>,
    /// What had to happen, one expectation a line.
    pub expected: String,
    /// What happened, in the same form and order.
    pub got: String,
    /// What was recorded and not judged.
    pub observations: Vec<Observed>,
}

/// Judges a case by what an engine answered. `strict` is the worst grade of a rejection or fault that still
/// passes; the reference must meet [`Grade::Code`].
#[must_use]
pub fn judge(case: &Case, answers: &Answers, strict: Grade) -> Judgement {
    let expectation = &*case.expectation;
    let expected = expected(expectation);
    if let Some((verdict, got)) = no_answer(answers) {
        return Judgement {
            verdict,
            grade: None,
            expected,
            got,
            observations: Vec::new(),
        };
    }
    let mut sheet = Sheet::default();
    let grade = match &answers.run {
        Outcome::Rejected { diagnostics } => rejected(expectation, diagnostics, strict, &mut sheet),
        Outcome::Faulted { fault, line, values } => {
            faulted(expectation, (*fault, *line), values, strict, &mut sheet)
        }
        Outcome::Executed { values } => executed(expectation, values, &mut sheet),
        _ => accepted(expectation, &mut sheet),
    };
    if let (Some(text), Some(rendering)) = (&expectation.rendered, &answers.rendering) {
        rendered::compare(text, &answers.run, rendering, &mut sheet);
    }
    let (verdict, got) = sheet.finish();
    Judgement {
        verdict,
        grade,
        expected,
        got,
        observations: observations(case, &answers.run),
    }
}

/// Whether a case only records: nothing that it says could fail but that the program is accepted.
#[must_use]
pub fn is_open(case: &Case) -> bool {
    let Expectation {
        accepted,
        diagnostics,
        clean_lines,
        values,
        fault,
        rendered,
    } = &*case.expectation;
    let asserts = !(diagnostics.is_empty() && clean_lines.is_empty() && values.is_empty())
        || fault.is_some()
        || rendered.is_some();
    match accepted {
        _ if asserts => false,
        Acceptance::Required => !case.observe.is_empty(),
        Acceptance::Rejected => false,
        Acceptance::Observed => true,
    }
}

/// The verdict where some question went unanswered: nothing else of the case counts then.
fn no_answer(answers: &Answers) -> Option<(Verdict, String)> {
    if let Outcome::Rendered { .. } = answers.run {
        return Some((
            Verdict::Error,
            "error: answered `run` with rendered text".to_owned(),
        ));
    }
    answers.outcomes().find_map(unanswered)
}

fn unanswered(outcome: &Outcome) -> Option<(Verdict, String)> {
    match outcome {
        Outcome::Unsupported { reason } => Some((Verdict::Unsupported, format!("unsupported: {reason}"))),
        Outcome::Crashed { reason } => Some((Verdict::Crash, format!("crashed: {reason}"))),
        Outcome::TimedOut { after_ms } => Some((
            Verdict::Timeout,
            format!("no answer within {}", Outcome::limit(*after_ms)),
        )),
        Outcome::Error { message } => Some((Verdict::Error, format!("error: {message}"))),
        Outcome::Accepted
        | Outcome::Executed { .. }
        | Outcome::Rejected { .. }
        | Outcome::Faulted { .. }
        | Outcome::Rendered { .. } => None,
    }
}

/// What a case expects, one expectation a line.
fn expected(expectation: &Expectation) -> String {
    let mut text = sheet::Lines::default();
    diagnostics::expected(&expectation.diagnostics, &mut text);
    if let Some(ExpectedFault { fault, line }) = expectation.fault {
        text.line(format_args!("line {line}: fault {fault}"));
    }
    values::expected(&expectation.values, &mut text);
    if let Some(rendered) = &expectation.rendered {
        rendered
            .lines
            .iter()
            .for_each(|line| text.line(format_args!("{line}")));
    }
    if text.is_empty() {
        text.line(format_args!("{}", acceptance(expectation)));
    }
    text.finish()
}

fn acceptance(expectation: &Expectation) -> &'static str {
    match expectation.accepted {
        Acceptance::Required => "accepted",
        Acceptance::Rejected => "rejected",
        Acceptance::Observed => "accepted or rejected",
    }
}

fn rejected(
    expectation: &Expectation,
    diagnostics: &[stickler_engines::Diagnostic],
    strict: Grade,
    sheet: &mut Sheet,
) -> Option<Grade> {
    let matching = diagnostics::matching(&expectation.diagnostics, diagnostics);
    matching.write(sheet);
    let on_clean_line = diagnostics::any_on(&expectation.clean_lines, diagnostics);
    match expectation.accepted {
        Acceptance::Observed => {
            sheet.require(!on_clean_line);
            None
        }
        Acceptance::Required => {
            sheet.require(false);
            None
        }
        Acceptance::Rejected => {
            let grade = matching.grade();
            sheet.require(grade.suffices(strict) && !on_clean_line);
            Some(grade)
        }
    }
}

fn faulted(
    expectation: &Expectation,
    (fault, line): (Fault, Option<u32>),
    values: &[NamedValue],
    strict: Grade,
    sheet: &mut Sheet,
) -> Option<Grade> {
    match line {
        Some(line) => sheet.line(format_args!("line {line}: fault {fault}")),
        None => sheet.line(format_args!("fault {fault}")),
    }
    values::compare(&expectation.values, values, sheet);
    let Some(expected) = expectation.fault else {
        // Where acceptance itself is open, how the program ends is open as well, unless values are asserted.
        sheet.require(expectation.accepted == Acceptance::Observed);
        return None;
    };
    if expected.fault != fault {
        sheet.require(false);
        return None;
    }
    let grade = if line == Some(expected.line) {
        Grade::Code
    } else {
        Grade::Rejected
    };
    sheet.require(grade.suffices(strict));
    Some(grade)
}

fn executed(expectation: &Expectation, values: &[NamedValue], sheet: &mut Sheet) -> Option<Grade> {
    let may_run = expectation.accepted != Acceptance::Rejected && expectation.fault.is_none();
    sheet.require(may_run);
    if !may_run || (expectation.values.is_empty() && expectation.rendered.is_none()) {
        sheet.line(format_args!("accepted"));
    }
    values::compare(&expectation.values, values, sheet);
    None
}

/// The program was accepted by an engine that did not execute it.
fn accepted(expectation: &Expectation, sheet: &mut Sheet) -> Option<Grade> {
    let may_be = expectation.accepted != Acceptance::Rejected;
    sheet.require(may_be);
    if may_be && (expectation.fault.is_some() || !expectation.values.is_empty()) {
        sheet.unsupported();
        sheet.line(format_args!("accepted, and not executed"));
    } else if !may_be || expectation.rendered.is_none() {
        sheet.line(format_args!("accepted"));
    }
    None
}

/// What a case wants recorded.
fn observations(case: &Case, run: &Outcome) -> Vec<Observed> {
    let mut observations = Vec::new();
    if case.expectation.accepted == Acceptance::Observed {
        let value = if matches!(run, Outcome::Rejected { .. }) {
            "rejected"
        } else {
            "accepted"
        };
        observations.push(Observed {
            name: "acceptance".to_owned(),
            value: value.to_owned(),
        });
        if let Outcome::Faulted { fault, .. } = run {
            observations.push(Observed {
                name: "fault".to_owned(),
                value: fault.to_string(),
            });
        }
    }
    if case.observe.len() > case.expectation.values.len()
        && let Outcome::Executed { values } | Outcome::Faulted { values, .. } = run
    {
        values::unasserted(case, values, &mut observations);
    }
    observations
}
