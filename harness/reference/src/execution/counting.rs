//! The control variable of a FOR loop.
//!
//! Basis: iec-61131-3: FOR statement. The test is made on the numbers themselves, so that a loop to the greatest value
//! of its type ends instead of wrapping around, but where the dialect says that it does not.

use crate::instruction::LoopTypes;

/// The control value, the limit and the step of a loop, as numbers of any size.
#[derive(Clone, Copy, Debug)]
pub(super) struct LoopCounter {
    types: LoopTypes,
    control: i128,
    limit: i128,
    step: i128,
}

impl LoopCounter {
    /// Takes the raw forms of the three.
    pub fn new(types: LoopTypes, [control, limit, step]: [u64; 3]) -> LoopCounter {
        LoopCounter {
            types,
            control: types.control.integer_value(control),
            limit: types.limit.integer_value(limit),
            step: types.step.integer_value(step),
        }
    }

    /// Returns whether a control value has not passed the limit.
    fn goes_on_with(self, control: i128) -> bool {
        if self.step < 0 {
            control >= self.limit
        } else {
            control <= self.limit
        }
    }

    /// Returns whether the loop begins at all.
    pub fn begins(self) -> bool {
        self.goes_on_with(self.control)
    }

    /// The next control value, wrapped to its type, and whether the loop goes on with it.
    pub fn next(self) -> (u64, bool) {
        let sum = self.control + self.step;
        let raw = self.types.control.wrap(sum);
        let fits = self.types.control.holds(sum);
        let goes_on = match self.types.wraps {
            true => self.goes_on_with(self.types.control.integer_value(raw)),
            false => fits && self.goes_on_with(sum),
        };
        (raw, goes_on)
    }
}
