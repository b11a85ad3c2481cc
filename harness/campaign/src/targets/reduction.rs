//! Reduces a mismatch of the reference, judges it once more, and makes a finding of it.
//!
//! Where the input stands for a program it is made small by the model of that, which takes a hundred tries and not thousands; otherwise by its
//! bytes.

use super::TargetOracle;
use super::planted;
use crate::basis::basis;
use crate::differential::{EvaluatedProgram, expected};
use crate::finding::{Confirmation, ExpectedBehavior, Finding};
use crate::oracle::Mismatch;
use crate::shrink;
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_generate::features::distinctive;
use stickler_generate::model::Program;
use stickler_generate::oracles::execute::{judge_program, program_of};
use stickler_generate::oracles::{FuzzTarget, OracleFailure};
use stickler_generate::reduce;
use stickler_reduce::{Interestingness, ReductionBudget, StopReason};

impl TargetOracle {
    /// Reduces the input of a mismatch, and makes a finding of it.
    pub(super) fn finding(&self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        let target = self.target(mismatch.place);
        let input = self.input(mismatch.place);
        let found = target.judge(&input).err();
        let mut finding = Finding {
            expected: ExpectedBehavior::Property {
                claim: claim(target).to_owned(),
            },
            original: text(target, found.as_ref(), &input),
            input: input.clone(),
            ..Finding::begin(target.as_str(), mismatch, self.inputs.seed())
        };
        let failure = reduce(&mut finding, target, going);
        if failure.is_some() {
            finding.standing = Confirmation::Confirmed;
        }
        // What is not seen again is kept as it was found.
        let failure = failure.or(found);
        finding.program = text(target, failure.as_ref(), &finding.input);
        finding.origin.size_found = size(finding.original.as_deref(), &input);
        finding.origin.size = size(finding.program.as_deref(), &finding.input);
        finding.message = match failure {
            Some(failure) => failure.message,
            None => format!("{}, but not when it was judged again", mismatch.symptom),
        };
        let finding = finding.named();
        Finding {
            reproduce: self.commands.of(&finding),
            ..finding
        }
    }
}

/// Returns the program that an input stands for, or the text that it is.
fn text(target: FuzzTarget, failure: Option<&OracleFailure>, input: &[u8]) -> Option<String> {
    let reads_text = matches!(
        target,
        FuzzTarget::Parse | FuzzTarget::Literal | FuzzTarget::CaseFile | FuzzTarget::Protocol
    );
    let program = failure.and_then(|failure| failure.program.clone());
    program.or_else(|| reads_text.then(|| String::from_utf8_lossy(input).into_owned()))
}

fn size(program: Option<&str>, input: &[u8]) -> u64 {
    program.map_or(input.len(), |program| program.lines().count()) as u64
}

/// Returns the property that holds for every input of a target.
const fn claim(target: FuzzTarget) -> &'static str {
    match target {
        FuzzTarget::Parse => {
            "any text is read without harm, and what can be read keeps its tree when it is rendered"
        }
        FuzzTarget::Literal => {
            "a literal's canonical spelling reads to the same value, which an independent reader finds too"
        }
        FuzzTarget::Convert => "the reference converts as exact arithmetic does",
        FuzzTarget::Check => "a planted error is reported with its code on its line, and nothing else is",
        FuzzTarget::Execute => {
            "a well-typed program is accepted and ends, and it and its variants give the evaluator's values"
        }
        FuzzTarget::CaseFile => "any case file gives cases or located errors",
        FuzzTarget::Protocol => "every line is answered",
    }
}

/// The number of smaller inputs that are tried at most, and of smaller programs: an oracle takes some microseconds.
const MAX_TRIES: u64 = 5000;

/// Makes the input of a finding small, and enters what is known of the smaller one. Returns how that fails; `None` where the input
/// passes when it is judged again.
fn reduce(finding: &mut Finding, target: FuzzTarget, going: &dyn Fn() -> bool) -> Option<OracleFailure> {
    let stop = || !going();
    let budget = ReductionBudget {
        tries: MAX_TRIES,
        stop: &stop,
    };
    let symptom = finding.symptom.clone();
    let failing = |bytes: &[u8]| {
        let failure = target.judge(bytes).err();
        failure.filter(|failure| failure.symptom == symptom)
    };
    let again = failing(&finding.input)?;
    match target {
        FuzzTarget::Execute => return Some(reduce_program(finding, &budget).unwrap_or(again)),
        FuzzTarget::Check => {
            if let Some(failure) = planted::reduce(finding, &budget) {
                return Some(failure);
            }
        }
        _ => {}
    }
    let reduced = shrink::bytes(finding.input.clone(), |bytes| failing(bytes).is_some(), &budget);
    finding.origin.smallest = reduced.ended == StopReason::Smallest;
    finding.origin.tries = reduced.tries;
    finding.input = reduced.value;
    failing(&finding.input)
}

/// Makes the program that the input of a finding stands for small.
fn reduce_program(finding: &mut Finding, budget: &ReductionBudget<'_>) -> Option<OracleFailure> {
    let (input, symptom) = (&finding.input, &finding.symptom);
    let failing = |program: &Program| judged(program, input).filter(|failure| failure.symptom == *symptom);
    let mut shows = |program: &Program| Interestingness::from(failing(program).is_some());
    let reduced = reduce::program(&program_of(input), &mut shows, budget);
    let failure = failing(&reduced.value);
    // A variant fails where the program itself does not.
    if !symptom.starts_with("variant")
        && let Ok(subject) = EvaluatedProgram::new(reduced.value.clone())
    {
        finding.expected = expected(&subject, basis(&reduced.value));
    }
    finding.rule = distinctive(&reduced.value);
    finding.enter(&reduced);
    failure
}

/// Returns how a program fails; a panic is a failure, as it is for [`FuzzTarget::judge`].
fn judged(program: &Program, rest: &[u8]) -> Option<OracleFailure> {
    let judged = catch_unwind(AssertUnwindSafe(|| judge_program(program, rest)));
    judged
        .unwrap_or_else(|_| Err(OracleFailure::new("panic", "a panic")))
        .err()
}
