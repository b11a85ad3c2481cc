//! The results that STruC++ and RuSTy state: in the tests of their repositories, and by the tables of the standard whose functions
//! they say to have.

use super::{BITS_AND_NUMBERS, BITS_TO_BITS, DATES, ROUNDED, Rules, STANDARD_INTEGERS, UnaryCall};
use crate::{integer, moment, real};
use stickler_types::{ElementaryType, Family, MomentUnits};

// The tests of STruC++.
pub(super) const STRUCPP_TIME: &str = "strucpp-tests: tests/st-validation/data_types/test_time_types.st";
pub(super) const STRUCPP_TO_TIME: &str = "strucpp-tests: tests/backend/codegen-functions.test.ts";
const STRUCPP_NUMBERS: &str = "strucpp-tests: tests/st-validation/expressions/test_type_conversion.st";
pub(super) const STRUCPP_TEXTS: &str =
    "strucpp-tests: tests/st-validation/data_types/test_string_conversions.st";

// The tests of RuSTy.
const RUSTY_NUMBERS: &str = "rusty-tests: libs/stdlib/tests/num_conversion_tests.rs";
const RUSTY_BITS: &str = "rusty-tests: libs/stdlib/tests/bit_conversion_tests.rs";
const RUSTY_BITS_AND_NUMBERS: &str = "rusty-tests: libs/stdlib/tests/bit_num_conversion_tests.rs";
const RUSTY_DATES: &str = "rusty-tests: libs/stdlib/tests/date_time_conversion_tests.rs";
const RUSTY_TO_NUMBER: &str = "rusty-tests: tests/lit/single/conversion/to_num.st";
const RUSTY_TO_BITS: &str = "rusty-tests: tests/lit/single/conversion/to_bit.st";

impl UnaryCall<'_> {
    /// Returns the basis of `TO_<DST>`, which is the conversion from the operand's type: by RuSTy's tests among integers and among
    /// bit strings; in STruC++ by the standard among integers, and by its tests from durations and times of day.
    pub(super) fn of_overloaded(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Boolean, Duration, Signed, TimeOfDay, Unsigned};
        match (self.rules, self.from.family(), self.to.family()) {
            (Rules::Plcnext, ..) => self.of_plcnext_conversion(raw),
            (Rules::Rusty, Signed | Unsigned, Signed | Unsigned) => Some(RUSTY_TO_NUMBER),
            (Rules::Rusty, BitString | Boolean, BitString | Boolean) => Some(RUSTY_TO_BITS),
            (Rules::Strucpp, Signed | Unsigned | Duration | TimeOfDay, Signed | Unsigned) => {
                self.of_conversion(raw)
            }
            _ => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in RuSTy, whose library has tests for nearly every pair. It has few functions between
    /// durations and numbers, and these count nanoseconds.
    pub(super) fn of_rusty_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Boolean, Date, DateAndTime, Duration, Real, Signed, TimeOfDay, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, Signed | Unsigned) => Some(RUSTY_NUMBERS),
            (BitString, BitString) | (Boolean, BitString) | (BitString, Boolean) => Some(RUSTY_BITS),
            (Boolean, Signed | Unsigned) => Some(RUSTY_BITS_AND_NUMBERS),
            (BitString, Signed | Unsigned) => Some(BITS_AND_NUMBERS),
            (Signed | Unsigned, BitString) => (!self.extends_sign(raw)).then_some(BITS_AND_NUMBERS),
            (BitString, Real) | (Real, BitString) if self.from.bits() == self.to.bits() => {
                let real = if self.to.is_real() { self.to } else { self.from };
                (real::decode(raw, real) != real::Real::NotANumber).then_some(RUSTY_BITS_AND_NUMBERS)
            }
            (Signed | Unsigned, Real) => Some(ROUNDED),
            (Real, Real) => Some(self.of_real_to_real(raw)),
            (DateAndTime, Date) if self.to == ElementaryType::Date => {
                moment::has_day(raw).then_some(RUSTY_DATES)
            }
            (DateAndTime, DateAndTime | TimeOfDay) | (Duration, Duration) | (TimeOfDay, TimeOfDay) => {
                Some(RUSTY_DATES)
            }
            _ => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in STruC++: its tests, and the tables of the standard whose functions it says to have. What its tests say
    /// of DATE and DT as numbers, its makers later called wrong (<https://github.com/Autonomy-Logic/STruCpp/pull/234>).
    pub(super) fn of_strucpp_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Boolean, Date, DateAndTime, Duration, Real, Signed, TimeOfDay, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, Signed | Unsigned) => self
                .to
                .holds(integer::number(raw, self.from))
                .then_some(STANDARD_INTEGERS),
            (Boolean, Signed | Unsigned) => Some(STRUCPP_NUMBERS),
            (BitString, BitString) => Some(BITS_TO_BITS),
            (BitString, Signed | Unsigned) => Some(BITS_AND_NUMBERS),
            (Signed | Unsigned, BitString) => (!self.extends_sign(raw)).then_some(BITS_AND_NUMBERS),
            (Signed | Unsigned, Real) => Some(ROUNDED),
            (Real, Real) => Some(self.of_real_to_real(raw)),
            (TimeOfDay, Signed | Unsigned) if !self.from.is_third_edition() => {
                let units = moment::units(raw, self.from, MomentUnits::DaysAndMilliseconds);
                let is_whole = moment::has_whole_units(raw, self.from, MomentUnits::DaysAndMilliseconds);
                (is_whole && self.to.holds(units)).then_some(STRUCPP_TIME)
            }
            (DateAndTime, Date) if self.to == ElementaryType::Date => moment::has_day(raw).then_some(DATES),
            (DateAndTime, DateAndTime | TimeOfDay) | (Duration, Duration) | (TimeOfDay, TimeOfDay) => {
                Some(DATES)
            }
            _ if self.from == ElementaryType::Time || self.to == ElementaryType::Time => self.of_time(raw),
            _ => None,
        }
    }
}
