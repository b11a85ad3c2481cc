//! Compares the answers of an engine with the expectation of a case. Basis: conformance-cases/README.md
//! (marks) and reports/README.md (the words).

mod bodies;
mod diagnostics;
mod rendered;
mod values;

use crate::clip::clip_answer;
use crate::{Answers, Fact, Grade, Observed, Verdict};
pub use bodies::rendered_bodies;
pub use diagnostics::tells_otherwise_only;
pub use rendered::renders_bit_access;
use stickler_engines::{Diagnostic, NamedValue, Outcome};
use stickler_suite::{Acceptance, Case, Expectation, ExpectedFault, ExpectedText};
use stickler_types::Fault;

/// The result of comparing an engine's answers with the expectation of a case.
#[derive(Clone, PartialEq, Debug)]
pub struct Judgement {
    /// The verdict.
    pub verdict: Verdict,
    /// The grade of an expected rejection or fault; `None` where none was expected or none came.
    pub grade: Option<Grade>,
    /// The expected facts, in a fixed order.
    pub expected: Vec<Fact>,
    /// The actual facts, in the order of `expected`.
    pub got: Vec<Fact>,
    /// The observations, which are recorded and not judged.
    pub observations: Vec<Observed>,
}

/// Judges a case by what an engine answered. `strict` is the worst grade of a rejection or fault that still
/// passes; the reference must meet [`Grade::Code`].
pub fn judge(case: &Case, answers: &Answers, strict: Grade) -> Judgement {
    let expectation = &*case.expectation;
    let expected = expected(expectation);
    if let Some((verdict, got)) = no_answer(expectation, answers) {
        return Judgement {
            verdict,
            grade: None,
            expected,
            got: clip_answer(vec![got]),
            observations: Vec::new(),
        };
    }
    let mut findings = Findings::default();
    let grade = match &answers.run {
        Outcome::Rejected { diagnostics } => rejected(expectation, diagnostics, strict, &mut findings),
        Outcome::Faulted {
            fault, line, values, ..
        } => faulted(case, (*fault, *line), values, strict, &mut findings),
        Outcome::Executed { values, .. } => executed(expectation, values, &mut findings),
        _ => accepted(expectation, &mut findings),
    };
    if let (Some(text), Some(rendering)) = (&expectation.rendered, &answers.rendering) {
        rendered::compare(text, &answers.run, rendering, &mut findings);
    }
    if let Some(warnings) = answers.run.warnings() {
        diagnostics::warnings(expectation, warnings, strict, &mut findings);
    }
    let (verdict, got) = findings.finish();
    Judgement {
        verdict,
        grade,
        expected,
        got: clip_answer(got),
        observations: observations(case, &answers.run),
    }
}

/// Returns the facts that a case expects, in a fixed order: those of its [`Judgement::expected`].
pub fn expected_facts(case: &Case) -> Vec<Fact> {
    expected(&case.expectation)
}

/// Returns the verdict and the fact where a request of the case went unanswered: nothing else of the case counts then. A program
/// that must be rejected is accepted wrongly, whatever becomes of it.
fn no_answer(expectation: &Expectation, answers: &Answers) -> Option<(Verdict, Fact)> {
    if expectation.accepted == Acceptance::Rejected && matches!(answers.run, Outcome::Unusable { .. }) {
        return None;
    }
    if let Outcome::Rendered { .. } = answers.run {
        let message = "answered `run` with rendered text".to_owned();
        return Some((Verdict::Error, Fact::Error { message }));
    }
    answers.outcomes().find_map(unanswered)
}

fn unanswered(outcome: &Outcome) -> Option<(Verdict, Fact)> {
    let (verdict, fact) = match outcome {
        Outcome::Unsupported { reason } => {
            let reason = reason.clone();
            (Verdict::Unsupported, Fact::Unsupported { reason })
        }
        Outcome::NotImplemented { reason } => {
            let reason = reason.clone();
            let promised_by = None;
            (Verdict::Unsupported, Fact::NotImplemented { reason, promised_by })
        }
        Outcome::Unusable { reason } => {
            let reason = reason.clone();
            (Verdict::Crash, Fact::Unusable { reason })
        }
        Outcome::Crashed { reason } => {
            let reason = reason.clone();
            (Verdict::Crash, Fact::Crashed { reason })
        }
        Outcome::TimedOut { after_ms } => {
            let after_ms = *after_ms;
            (Verdict::Timeout, Fact::TimedOut { after_ms })
        }
        Outcome::Error { message } => {
            let message = message.clone();
            (Verdict::Error, Fact::Error { message })
        }
        _ => return None,
    };
    Some((verdict, fact))
}

/// Returns the expected facts of a case. The acceptance of the program is among them only where there is no other fact.
fn expected(expectation: &Expectation) -> Vec<Fact> {
    let mut facts = diagnostics::expected(&expectation.diagnostics);
    if let Some(ExpectedFault { fault, line }) = expectation.fault {
        let line = Some(line);
        facts.push(Fact::Fault { fault, line });
    }
    facts.extend(expectation.values.iter().map(values::expected));
    if let Some(ExpectedText { lines, .. }) = &expectation.rendered {
        facts.extend(rendered::lines(lines.iter().map(AsRef::as_ref)));
    }
    if facts.is_empty() {
        facts.push(acceptance(expectation));
    }
    facts.extend(diagnostics::expected(&expectation.warnings));
    facts
}

fn acceptance(expectation: &Expectation) -> Fact {
    match expectation.accepted {
        Acceptance::Required => Fact::Accepted,
        Acceptance::Rejected => Fact::Rejected,
        Acceptance::Observed => Fact::AcceptedOrRejected,
    }
}

fn rejected(
    expectation: &Expectation,
    diagnostics: &[Diagnostic],
    strict: Grade,
    findings: &mut Findings,
) -> Option<Grade> {
    let matching = diagnostics::matching(&expectation.diagnostics, diagnostics);
    matching.write(findings);
    let on_clean_line = diagnostics::any_on(&expectation.clean_lines, diagnostics);
    match expectation.accepted {
        Acceptance::Observed => {
            findings.require(!on_clean_line);
            None
        }
        Acceptance::Required => {
            findings.require(false);
            None
        }
        Acceptance::Rejected => {
            let grade = matching.grade();
            findings.require(grade.suffices(strict) && !on_clean_line);
            Some(grade)
        }
    }
}

fn faulted(
    case: &Case,
    (fault, line): (Fault, Option<u32>),
    values: &[NamedValue],
    strict: Grade,
    findings: &mut Findings,
) -> Option<Grade> {
    let expectation = &*case.expectation;
    findings.add(Fact::Fault { fault, line });
    values::compare(&expectation.values, values, findings);
    let Some(expected) = expectation.fault else {
        // A case that asserts nothing records how the program ends. So does one whose acceptance is open, unless values are asserted.
        findings.require(expectation.accepted == Acceptance::Observed || case.is_open());
        return None;
    };
    if expected.fault != fault {
        findings.require(false);
        return None;
    }
    let grade = if line == Some(expected.line) {
        Grade::Code
    } else {
        Grade::Rejected
    };
    findings.require(grade.suffices(strict));
    Some(grade)
}

fn executed(expectation: &Expectation, values: &[NamedValue], findings: &mut Findings) -> Option<Grade> {
    let may_run = expectation.accepted != Acceptance::Rejected && expectation.fault.is_none();
    findings.require(may_run);
    if !may_run || (expectation.values.is_empty() && expectation.rendered.is_none()) {
        findings.add(Fact::Accepted);
    }
    values::compare(&expectation.values, values, findings);
    None
}

/// Judges a program that was accepted by an engine that did not execute it.
fn accepted(expectation: &Expectation, findings: &mut Findings) -> Option<Grade> {
    let may_be = expectation.accepted != Acceptance::Rejected;
    findings.require(may_be);
    if may_be && (expectation.fault.is_some() || !expectation.values.is_empty()) {
        findings.unsupported();
        findings.add(Fact::NotExecuted);
    } else if !may_be || expectation.rendered.is_none() {
        findings.add(Fact::Accepted);
    }
    None
}

/// Returns the results that a case records without judging them.
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
    }
    if let Outcome::Faulted { fault, .. } = run
        && (case.expectation.accepted == Acceptance::Observed || case.is_open())
    {
        observations.push(Observed {
            name: "fault".to_owned(),
            value: fault.to_string(),
        });
    }
    if case.observe.len() > case.expectation.values.len()
        && let Outcome::Executed { values, .. } | Outcome::Faulted { values, .. } = run
    {
        values::unasserted(case, values, &mut observations);
    }
    observations
}

/// The actual facts of a case, and whether they meet the expectation.
#[derive(Default)]
struct Findings {
    got: Vec<Fact>,
    missed: bool,
    unsupported: bool,
}

impl Findings {
    /// Adds an actual fact.
    fn add(&mut self, fact: Fact) {
        self.got.push(fact);
    }

    /// Fails the case unless the condition holds.
    fn require(&mut self, holds: bool) {
        self.missed |= !holds;
    }

    /// Records that the engine does not support a part of the case.
    fn unsupported(&mut self) {
        self.unsupported = true;
    }

    /// Returns the verdict and the actual facts.
    fn finish(self) -> (Verdict, Vec<Fact>) {
        let verdict = match (self.missed, self.unsupported) {
            (true, _) => Verdict::Fail,
            (false, true) => Verdict::Unsupported,
            (false, false) => Verdict::Pass,
        };
        (verdict, self.got)
    }
}
