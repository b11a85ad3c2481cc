//! The plan of a sweep through programs: the kind of program, and the inputs that it can take.

use super::checksum::Checksum;
use super::counter::Counter;
use crate::sweep::agenda::Sweep;
use crate::sweep::domain::Domain;
use std::ops::Range;
use stickler_exact::Bulk;
use stickler_types::{Dialect, DialectName, ElementaryType};

/// The parts of a program that counts.
#[derive(Clone, Copy, Debug)]
pub struct Counting {
    /// The statements that go through the operands.
    pub counter: Counter,
    /// The statements that add up the results.
    pub checksum: Checksum,
    /// The bulk form of exact arithmetic, for the expected sum.
    pub bulk: Bulk,
}

/// The plan by which the inputs of a sweep are given to an engine.
#[derive(Clone, Debug)]
pub struct SweepPlan {
    /// The program that counts; `None` where operands are listed as literals.
    pub counting: Option<Counting>,
    /// The places that may go into one program, in order.
    pub stretches: Vec<Range<u64>>,
    /// The number of inputs that are in no stretch, since no program can make them.
    pub left_out: u64,
}

/// Returns whether a program can count through all operands of a type and add up results of another.
pub const fn has_digest(operand: ElementaryType, result: ElementaryType) -> bool {
    Counter::new(operand).is_some() && Checksum::new(result).is_some()
}

impl SweepPlan {
    /// Makes the plan of a sweep.
    pub fn of(sweep: &Sweep) -> SweepPlan {
        match SweepPlan::counting(sweep) {
            Some(counting) => SweepPlan {
                stretches: counting.counter.stretches(),
                left_out: counting.counter.left_out(),
                counting: Some(counting),
            },
            None => {
                let all = 0..sweep.domain.len();
                SweepPlan {
                    counting: None,
                    stretches: vec![all],
                    left_out: 0,
                }
            }
        }
    }

    fn counting(sweep: &Sweep) -> Option<Counting> {
        let Domain::Every(operand) = sweep.domain else {
            return None;
        };
        // Results are added up in a LINT.
        let has_sum = |dialect: &DialectName| Dialect::of(*dialect).may_name(ElementaryType::Lint);
        if !sweep.dialects.iter().all(has_sum) {
            return None;
        }
        Some(Counting {
            counter: Counter::new(operand)?,
            checksum: Checksum::new(sweep.signature.result)?,
            bulk: Bulk::new(&sweep.signature, &sweep.choices)?,
        })
    }
}
