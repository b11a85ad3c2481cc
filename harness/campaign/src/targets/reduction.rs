//! Reduces a mismatch of the reference, judges it once more, and makes a finding of it.
//!
//! Where the input stands for a program it is made small by the model of that, which takes a hundred tries and not thousands; otherwise by its
//! bytes.

use super::TargetOracle;
use super::planted::{self, SmallPlant};
use crate::basis::basis;
use crate::differential::{EvaluatedProgram, expected};
use crate::finding::{Confirmation, ExpectedBehavior, FORMAT, Finding, FindingOrigin};
use crate::oracle::Mismatch;
use crate::shrink;
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_generate::model::Program;
use stickler_generate::oracles::execute::{judge_program, program_of};
use stickler_generate::oracles::{FuzzTarget, OracleFailure};
use stickler_generate::reduce;
use stickler_reduce::{Interestingness, ReductionBudget, StopReason};
use stickler_types::DialectName;

impl TargetOracle {
    /// Reduces the input of a mismatch, and makes a finding of it.
    pub(super) fn finding(&self, mismatch: &Mismatch, going: &dyn Fn() -> bool) -> Finding {
        let target = self.target(mismatch.place);
        let input = self.input(mismatch.place);
        let found = target.judge(&input).err();
        let small = Small::of(target, &input, &mismatch.symptom, going);
        let standing = match small.failure {
            Some(_) => Confirmation::Confirmed,
            None => Confirmation::Flaky,
        };
        let original = text(target, found.as_ref(), &input);
        // What is not seen again is kept as it was found.
        let failure = small.failure.as_ref().or(found.as_ref());
        let program = text(target, failure, &small.input);
        let origin = FindingOrigin {
            seed: self.inputs.seed(),
            place: mismatch.place,
            open: false,
            smallest: small.smallest,
            tries: small.tries,
            size_found: size(original.as_deref(), &input),
            size: size(program.as_deref(), &small.input),
        };
        let message = match failure {
            Some(failure) => failure.message.clone(),
            None => format!("{}, but not when it was judged again", mismatch.symptom),
        };
        let finding = Finding {
            format: FORMAT,
            id: String::new(),
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            target: target.as_str().to_owned(),
            engine: None,
            symptom: mismatch.symptom.clone(),
            rule: small.rule,
            cause: None,
            dialect: small.dialect.map(|dialect| dialect.as_str().to_owned()),
            standing,
            origin,
            message,
            expected: small.expected.unwrap_or_else(|| ExpectedBehavior::Property {
                claim: claim(target).to_owned(),
            }),
            outcomes: Vec::new(),
            reproduce: Vec::new(),
            fingerprint: String::new(),
            program,
            original,
            input: small.input,
        }
        .named();
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

/// An input after its reduction.
struct Small {
    /// The bytes.
    input: Vec<u8>,
    /// The failure of the reduced input; `None` where it passes when it is judged again.
    failure: Option<OracleFailure>,
    /// Whether nothing smaller was left to try.
    smallest: bool,
    /// The number of smaller inputs and programs that were tried.
    tries: u64,
    /// The parts of the language that the program uses; empty where the input is no program.
    rule: Vec<String>,
    /// The dialect of the program, where there is one.
    dialect: Option<DialectName>,
    /// The result that the reduced program must have, where it can be computed.
    expected: Option<ExpectedBehavior>,
}

impl Small {
    /// Reduces an input that fails with this symptom.
    fn of(target: FuzzTarget, input: &[u8], symptom: &str, going: &dyn Fn() -> bool) -> Small {
        let stop = || !going();
        let budget = ReductionBudget {
            tries: MAX_TRIES,
            stop: &stop,
        };
        let failing = |bytes: &[u8]| {
            let failure = target.judge(bytes).err();
            failure.filter(|failure| failure.symptom == symptom)
        };
        let found = Small {
            failure: failing(input),
            input: input.to_vec(),
            smallest: false,
            tries: 1,
            rule: Vec::new(),
            dialect: None,
            expected: None,
        };
        match (target, &found.failure) {
            // What does not fail any more cannot be made small.
            (_, None) => return found,
            (FuzzTarget::Execute, _) => return found.with_program(symptom, &budget),
            (FuzzTarget::Check, _) => {
                if let Some(planted) = planted::small(input, symptom, &budget) {
                    return found.with_error(planted);
                }
            }
            _ => {}
        }
        let reduced = shrink::bytes(input.to_vec(), |bytes| failing(bytes).is_some(), &budget);
        Small {
            failure: failing(&reduced.value),
            input: reduced.value,
            smallest: reduced.ended == StopReason::Smallest,
            tries: reduced.tries,
            ..found
        }
    }

    fn with_error(self, planted: SmallPlant) -> Small {
        Small {
            failure: Some(planted.failure),
            smallest: planted.reduced.ended == StopReason::Smallest,
            tries: self.tries.saturating_add(planted.reduced.tries),
            // What stands around the error is there because a program needs it.
            rule: vec![planted.kind.to_owned()],
            dialect: Some(planted.reduced.value.dialect),
            expected: planted.expected,
            input: self.input,
        }
    }

    fn with_program(self, symptom: &str, budget: &ReductionBudget<'_>) -> Small {
        let input = &self.input;
        let failing = |program: &Program| judged(program, input).filter(|failure| failure.symptom == symptom);
        let start = program_of(input);
        let reduced = reduce::program(
            &start,
            |program| Interestingness::from(failing(program).is_some()),
            budget,
        );
        let failure = failing(&reduced.value);
        // A variant fails where the program itself does not.
        let variant = symptom.starts_with("variant");
        let subject = EvaluatedProgram::new(reduced.value.clone());
        let expected = subject
            .ok()
            .filter(|_| !variant)
            .map(|subject| expected(&subject, basis(&reduced.value)));
        Small {
            smallest: reduced.ended == StopReason::Smallest,
            tries: self.tries.saturating_add(reduced.tries),
            rule: stickler_generate::features::distinctive(&reduced.value),
            dialect: Some(reduced.value.dialect),
            expected,
            failure: failure.or(self.failure),
            input: self.input,
        }
    }
}

/// Returns how a program fails; a panic is a failure, as it is for [`FuzzTarget::judge`].
fn judged(program: &Program, rest: &[u8]) -> Option<OracleFailure> {
    let judged = catch_unwind(AssertUnwindSafe(|| judge_program(program, rest)));
    judged
        .unwrap_or_else(|_| Err(OracleFailure::new("panic", "a panic")))
        .err()
}
