//! The smallest input with the same symptom: where it stands for a program, by the model of that, which takes a hundred tries
//! and not thousands; otherwise by its bytes.

use super::planted::{self, SmallPlant};
use crate::basis::basis;
use crate::differential::{EvaluatedProgram, expected};
use crate::finding::ExpectedBehavior;
use crate::shrink;
use std::panic::{AssertUnwindSafe, catch_unwind};
use stickler_generate::model::Program;
use stickler_generate::oracles::execute::{judge_program, program_of};
use stickler_generate::oracles::{FuzzTarget, OracleFailure};
use stickler_generate::reduce;
use stickler_reduce::{Interestingness, ReductionBudget, StopReason};
use stickler_types::DialectName;

/// The number of smaller inputs that are tried at most, and of smaller programs: an oracle takes some microseconds.
const MAX_TRIES: u64 = 5000;

/// An input after its reduction.
pub(super) struct Small {
    /// The bytes.
    pub(super) input: Vec<u8>,
    /// The failure of the reduced input; `None` where it passes when it is judged again.
    pub(super) failure: Option<OracleFailure>,
    /// Whether nothing smaller was left to try.
    pub(super) smallest: bool,
    /// The number of smaller inputs and programs that were tried.
    pub(super) tries: u64,
    /// The parts of the language that the program uses; empty where the input is no program.
    pub(super) rule: Vec<String>,
    /// The dialect of the program, where there is one.
    pub(super) dialect: Option<DialectName>,
    /// The result that the reduced program must have, where it can be computed.
    pub(super) expected: Option<ExpectedBehavior>,
}

impl Small {
    /// Reduces an input that fails with this symptom.
    pub(super) fn of(target: FuzzTarget, input: &[u8], symptom: &str, going: &dyn Fn() -> bool) -> Small {
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
