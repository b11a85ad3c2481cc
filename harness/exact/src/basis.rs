//! Tells which document states the result of a call, if one does: the suite asserts stated results and only observes the
//! others.
//!
//! A result without a document is open. An overloaded name (`TO_INT`) is open for every operand except in STruC++ and RuSTy,
//! whose tests have it, and in PLCnext Engineer, whose pages have no other: the ForgeIEC page says that every conversion is `<SRC>_TO_<DST>`, and so does IronPLC's.

mod stated;
mod tested;
mod texts;
mod vendors;

use crate::real::{self, Real, Whole};
use crate::signature::{Operation, Signature};
use crate::value::value;
use crate::{bcd, integer, moment};
use stickler_types::documents::DocumentedFunctions as Rules;
use stickler_types::{DialectName, ElementaryType, Family, MomentUnits, Rounding, Value};
use tested::{STRUCPP_TEXTS, STRUCPP_TIME, STRUCPP_TO_TIME};
use vendors::OMRON_ROUNDING;
pub use vendors::stated_by_vendor;

/// The expected result of a call, and the document that states it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Expected {
    /// The result of the call.
    pub value: Value,
    /// The document and section that say so, as the suite writes a basis: `source: section`. `None` where the call is open.
    pub basis: Option<&'static str>,
}

/// Returns the expected result of a call of a conversion function in a dialect, and the document that states it.
///
/// Takes a signature of [`crate::signatures`] and one operand for each of its types. Where no document states the result,
/// the basis is `None` and the value is that of IEC 60559 and of two's complement. In a user-defined dialect, a statement of
/// its definition takes precedence over the documents of its base, and the basis is that of the definition. See [`value`]
/// for operands that do not fit.
#[must_use]
pub fn expected(signature: &Signature, operands: &[Value], dialect: DialectName) -> Expected {
    let choices = dialect.rules().conversions;
    let call = UnaryCall::of(signature, operands, dialect);
    let basis = call.and_then(|(call, operand)| match dialect.definition() {
        None => call.basis(operand),
        Some(definition) => call.stated(operand, definition, &choices),
    });
    Expected {
        value: value(signature, operands, &choices),
        basis,
    }
}

/// Returns whether the ForgeIEC page has a truncation whose name tells its result, of an operand of this type.
///
/// Basis: forgeiec-conversion-functions: The naming pattern (TRUNC_INT of REAL, TRUNC_LINT of LREAL), TRUNC vs. ROUND (TRUNC_DINT of a REAL).
#[must_use]
pub fn page_has_truncation(signature: &Signature) -> bool {
    matches!(
        (&signature.function[..], &signature.operands[..]),
        ("TRUNC_INT" | "TRUNC_DINT", [ElementaryType::Real]) | ("TRUNC_LINT", [ElementaryType::Lreal])
    )
}

/// Returns whether an override in the definition of a dialect decides the result of a call: with another choice in its
/// place, the result would differ. Always `false` in a dialect of a documented system, and for operands that do not fit.
#[must_use]
pub fn is_overridden(signature: &Signature, operands: &[Value], dialect: DialectName) -> bool {
    let call = UnaryCall::of(signature, operands, dialect);
    call.zip(dialect.definition())
        .is_some_and(|((call, operand), definition)| {
            call.is_overridden(operand, definition, &dialect.rules().conversions)
        })
}

// The ForgeIEC page, which speaks for matiec.
const NAMING: &str = "forgeiec-conversion-functions: The naming pattern";
const RANGE: &str = "forgeiec-conversion-functions: Range and precision";
const MATIEC_TEXTS: &str = "forgeiec-conversion-functions: matiec conformance";
const BCD: &str = "forgeiec-conversion-functions: BCD encoding";
const MATIEC_TRUNC: &str = "forgeiec-conversion-functions: TRUNC vs. ROUND";

// IronPLC's own pages, and the design of its conversion functions.
const IRONPLC_INTEGERS: &str = "ironplc-conversion-design: Conversion Categories at the VM Level";
const IRONPLC_ROUTING: &str = "ironplc-conversion-design: Codegen Routing";
const IRONPLC_BOOLEAN: &str = "ironplc-conversion-functions: Boolean Conversions";
const IRONPLC_REAL_TO_INTEGER: &str = "ironplc-conversion-functions: Real to Integer";
const IRONPLC_TIME: &str = "ironplc-conversion-functions: Time/Duration Conversions";
const IRONPLC_TRUNC: &str = "ironplc-standard-functions: trunc";

// The page of Control Expert.
const CONTROL_EXPERT_ROUNDING: &str = "control-expert-real-to: Example";

// The standards, which speak for every dialect.
const BITS_TO_BITS: &str = "iec-61131-3: Table 24";
const BITS_AND_NUMBERS: &str = "iec-61131-3: Table 25";
const STANDARD_ROUNDING: &str = "iec-61131-3: Table 22";
const STANDARD_INTEGERS: &str = "iec-61131-3: Table 23";
const DATES: &str = "iec-61131-3: Table 26";
const ROUNDED: &str = "iec-60559: Operations";
const SPECIAL: &str = "iec-60559: Special Quantities";

// Rules of our own.
const BOOL_RULE: &str = "rule: bool-is-zero-or-one";
const MILLISECONDS_RULE: &str = "rule: time-in-milliseconds";
const NOT_FINITE_RULE: &str = "rule: not-finite-to-zero";

/// Returns the basis of a result that IronPLC and the ForgeIEC page state, each in its own document; `None` for the other
/// systems, whose documents do not state it.
fn documented(rules: Rules, ironplc: &'static str, matiec: &'static str) -> Option<&'static str> {
    match rules {
        Rules::Ironplc => Some(ironplc),
        Rules::Matiec => Some(matiec),
        _ => None,
    }
}

/// Returns the basis of a result that only the ForgeIEC page states; `None` for the other systems.
fn only_matiec(rules: Rules, basis: &'static str) -> Option<&'static str> {
    (rules == Rules::Matiec).then_some(basis)
}

/// A call with one argument.
#[derive(Clone, Copy)]
struct UnaryCall<'s> {
    signature: &'s Signature,
    from: ElementaryType,
    to: ElementaryType,
    rules: Rules,
}

impl<'s> UnaryCall<'s> {
    /// Returns a call with one operand, and that operand, if it fits.
    fn of<'v>(
        signature: &'s Signature,
        operands: &'v [Value],
        dialect: DialectName,
    ) -> Option<(UnaryCall<'s>, &'v Value)> {
        let (&[from], [operand]) = (&signature.operands[..], operands) else {
            return None;
        };
        let call = UnaryCall {
            signature,
            from,
            to: signature.result,
            rules: dialect.rules().documents.functions,
        };
        signature.takes(operands).then_some((call, operand))
    }

    fn basis(self, operand: &Value) -> Option<&'static str> {
        let name = &self.signature.function[..];
        match (self.signature.operation, operand) {
            (Operation::Convert, &Value::Plain { raw, .. }) if name.starts_with("TO_") => {
                self.of_overloaded(raw)
            }
            (Operation::Convert, _) if name.starts_with("TO_") && self.rules != Rules::Plcnext => None,
            (Operation::Convert, &Value::Plain { raw, .. }) => self.of_conversion(raw),
            (Operation::Convert, Value::Text { ty, units }) => self.of_text(*ty, units),
            (Operation::Truncate, &Value::Plain { raw, .. }) => self.of_truncation(name, raw),
            (Operation::FromBcd | Operation::ToBcd, &Value::Plain { raw, .. }) => self.of_bcd(name, raw),
            _ => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>`.
    fn of_conversion(self, raw: u64) -> Option<&'static str> {
        match self.rules {
            Rules::Rusty => self.of_rusty_conversion(raw),
            Rules::Strucpp => self.of_strucpp_conversion(raw),
            Rules::Ironplc | Rules::Matiec => self.of_page_conversion(raw),
            Rules::Plcnext => self.of_plcnext_conversion(raw),
            Rules::ControlExpert => self.of_control_expert_conversion(raw),
            Rules::Omron => self.of_omron_conversion(raw),
            Rules::ThirdEdition => self.of_standard_conversion(raw),
            Rules::InTables => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in the systems that describe their functions on a page.
    fn of_page_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Boolean, Date, DateAndTime, Real, Signed, Text, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, Signed | Unsigned) => documented(self.rules, IRONPLC_INTEGERS, RANGE),
            (BitString, Signed | Unsigned) => documented(self.rules, BITS_AND_NUMBERS, RANGE),
            (Signed | Unsigned, BitString) => self.of_integer_to_bits(raw),
            (BitString, BitString) => documented(self.rules, BITS_TO_BITS, BITS_TO_BITS),
            (Boolean, Signed | Unsigned) | (Signed | Unsigned, Boolean) => {
                documented(self.rules, IRONPLC_BOOLEAN, NAMING)
            }
            (Boolean, BitString | Real) | (BitString, Boolean) => documented(self.rules, BOOL_RULE, NAMING),
            // "0 → FALSE, anything else → TRUE" speaks of numbers, and a NaN is none.
            (Real, Boolean) if real::decode(raw, self.from) == real::Real::NotANumber => None,
            (Real, Boolean) => documented(self.rules, BOOL_RULE, NAMING),
            (Signed | Unsigned, Real) => Some(ROUNDED),
            (Real, Real) => Some(self.of_real_to_real(raw)),
            (Real, Signed | Unsigned) => self.of_real_to_integer(raw),
            (Signed | Unsigned, Text) if self.to == ElementaryType::String => only_matiec(self.rules, NAMING),
            (Date | DateAndTime, _) => self.of_date(raw),
            _ if self.from == ElementaryType::Time || self.to == ElementaryType::Time => self.of_time(raw),
            _ => None,
        }
    }

    /// Returns the basis of a conversion from an integer to a bit string. The standard's Table 25 does not say what the other
    /// bits of a wider bit string are where the integer is negative; IronPLC's design does.
    fn of_integer_to_bits(self, raw: u64) -> Option<&'static str> {
        let ironplc = if self.extends_sign(raw) {
            IRONPLC_ROUTING
        } else {
            BITS_AND_NUMBERS
        };
        documented(self.rules, ironplc, RANGE)
    }

    /// Returns whether the integer is negative and the target has more bits.
    fn extends_sign(self, raw: u64) -> bool {
        integer::number(raw, self.from) < 0 && self.to.bits() > self.from.bits()
    }

    /// Returns the basis of a conversion from one real type to the other.
    fn of_real_to_real(self, raw: u64) -> &'static str {
        match real::decode(raw, self.from) {
            Real::Finite(_) if self.rules == Rules::Matiec && self.to == ElementaryType::Real => RANGE,
            Real::Finite(_) => ROUNDED,
            _ => SPECIAL,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` from a real number to an integer.
    fn of_real_to_integer(self, raw: u64) -> Option<&'static str> {
        match self.rounded(raw, Rounding::Truncate) {
            WholePosition::Inside => documented(self.rules, IRONPLC_REAL_TO_INTEGER, RANGE),
            WholePosition::Outside => only_matiec(self.rules, RANGE),
            WholePosition::NoNumber => only_matiec(self.rules, NOT_FINITE_RULE),
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in Control Expert: REAL to the four integers of the page, where they hold the nearest one.
    /// "Negative input values cannot be converted" to those without a sign.
    fn of_control_expert_conversion(self, raw: u64) -> Option<&'static str> {
        use ElementaryType::{Dint, Int, Real, Udint, Uint};
        let is_on_the_page = match (self.from, self.to) {
            (Real, Int | Dint) => true,
            (Real, Uint | Udint) => {
                !matches!(real::decode(raw, self.from), real::Real::Finite(number) if number.negative)
            }
            _ => false,
        };
        (is_on_the_page && self.rounded(raw, Rounding::HalfToEven) == WholePosition::Inside)
            .then_some(CONTROL_EXPERT_ROUNDING)
    }

    /// Returns the basis of a conversion among numbers and bit strings in the third edition, which leaves numbers outside the range of the
    /// target to the implementer.
    fn of_standard_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Real, Signed, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Real, Signed) => (self.rounded(raw, Rounding::HalfToEven) == WholePosition::Inside)
                .then_some(STANDARD_ROUNDING),
            (Signed | Unsigned, Signed | Unsigned) => self
                .to
                .holds(integer::number(raw, self.from))
                .then_some(STANDARD_INTEGERS),
            (BitString, BitString) => Some(BITS_TO_BITS),
            // Of other widths, nothing that we can read says which bits are taken over.
            (BitString, Signed | Unsigned) | (Signed | Unsigned, BitString) => {
                (self.from.bits() == self.to.bits()).then_some(BITS_AND_NUMBERS)
            }
            (Signed | Unsigned, Real) => Some(ROUNDED),
            _ => None,
        }
    }

    /// Returns the basis of TIME to and from a number: whole milliseconds that the target holds exactly or as the nearest
    /// real. No document states another conversion of a duration, and IronPLC documents a TIME of 32 bits. Its page names bit strings
    /// beside the numbers, and the ForgeIEC page excepts no type; FALSE is 0 and TRUE is 1 there.
    fn of_time(self, raw: u64) -> Option<&'static str> {
        let milliseconds = self.whole_milliseconds(raw)?;
        let other = if self.to.is_duration() { self.from } else { self.to };
        match self.rules {
            Rules::Matiec => Some(NAMING),
            _ if other == ElementaryType::Bool => None,
            Rules::Ironplc => i32::try_from(milliseconds).is_ok().then_some(IRONPLC_TIME),
            _ if other.is_bit_string() => None,
            Rules::Plcnext => i32::try_from(milliseconds).is_ok().then_some(MILLISECONDS_RULE),
            Rules::Strucpp if self.from == ElementaryType::Time => Some(STRUCPP_TIME),
            // "TO_TIME(integer) already scales ms → ns"; of reals it says nothing.
            Rules::Strucpp if self.from.is_integer() => Some(STRUCPP_TO_TIME),
            Rules::Strucpp => Some(MILLISECONDS_RULE),
            Rules::Rusty | Rules::ControlExpert | Rules::Omron | Rules::ThirdEdition | Rules::InTables => {
                None
            }
        }
    }

    /// Returns the milliseconds that TIME and a number have in common, if both hold them.
    fn whole_milliseconds(self, raw: u64) -> Option<i128> {
        // The unit of a duration is the same, whatever counts a date.
        let calendar = MomentUnits::Seconds;
        match (self.from.family(), self.to.family()) {
            (
                Family::Duration,
                Family::Signed | Family::Unsigned | Family::Real | Family::BitString | Family::Boolean,
            ) => {
                let units = moment::units(raw, self.from, calendar);
                let holds = self.to.is_real() || self.to == ElementaryType::Bool || self.to.holds(units);
                (holds && moment::has_whole_units(raw, self.from, calendar)).then_some(units)
            }
            (Family::Signed | Family::Unsigned | Family::BitString | Family::Boolean, Family::Duration) => {
                let number = integer::number(raw, self.from);
                moment::fits(moment::of_units(number, self.to, calendar)).then_some(number)
            }
            (Family::Real, Family::Duration)
                if moment::is_whole_moment(raw, self.from, self.to, calendar) =>
            {
                let duration = moment::from_real_units(raw, self.from, self.to, calendar);
                Some(moment::units(duration, self.to, calendar))
            }
            _ => None,
        }
    }

    /// Returns the basis of `DATE_TO_DT`, `DT_TO_DATE` and `DT_TO_TOD`; the page does not list other conversions of dates, and says
    /// nothing of the range and precision of these types, which the standard leaves to the implementer (Table 10).
    fn of_date(self, raw: u64) -> Option<&'static str> {
        use ElementaryType::{Date, Dt, Tod};
        match (self.from, self.to) {
            (Date, Dt) | (Dt, Tod | Date) if moment::is_in_every_range(raw) => {
                only_matiec(self.rules, NAMING)
            }
            _ => None,
        }
    }

    /// Returns the basis of `STRING_TO_<INTEGER>` and `STRING_TO_<REAL>`.
    fn of_text(self, from: ElementaryType, units: &[u16]) -> Option<&'static str> {
        let is_listed = from == ElementaryType::String && self.to.is_number();
        match self.rules {
            Rules::Matiec if is_listed => texts::basis(units, self.to),
            Rules::Strucpp if is_listed && texts::is_plain_number(units, self.to) => Some(STRUCPP_TEXTS),
            _ if is_listed => self.of_vendor_text(units),
            _ => None,
        }
    }

    /// Returns the basis of `BCD_TO_INT` of decimal digits, and of `INT_TO_BCD` of a number with no more digits than the
    /// target.
    fn of_bcd(self, name: &str, raw: u64) -> Option<&'static str> {
        let says = match name {
            "BCD_TO_INT" => bcd::is_decimal(raw, self.from),
            "INT_TO_BCD" => (0..=bcd::greatest(self.to)).contains(&integer::number(raw, self.from)),
            _ => false,
        };
        says.then_some(BCD).filter(|_| self.rules == Rules::Matiec)
    }

    /// Returns the basis of TRUNC and its variants. What the ForgeIEC page does not have is open.
    fn of_truncation(self, name: &str, raw: u64) -> Option<&'static str> {
        let truncated = self.rounded(raw, Rounding::Truncate);
        match name {
            "TRUNC" if truncated == WholePosition::Inside && self.rules == Rules::Omron => {
                Some(OMRON_ROUNDING)
            }
            "TRUNC" if truncated == WholePosition::Inside => {
                documented(self.rules, IRONPLC_TRUNC, MATIEC_TRUNC)
            }
            "TRUNC_INT" | "TRUNC_DINT" | "TRUNC_LINT" => match truncated {
                WholePosition::NoNumber => only_matiec(self.rules, NOT_FINITE_RULE),
                _ if !page_has_truncation(self.signature) => None,
                WholePosition::Outside => only_matiec(self.rules, RANGE),
                WholePosition::Inside if name == "TRUNC_DINT" => only_matiec(self.rules, MATIEC_TRUNC),
                WholePosition::Inside => only_matiec(self.rules, NAMING),
            },
            _ => None,
        }
    }

    /// Returns where the rounded operand lies relative to the range of the result type.
    fn rounded(self, raw: u64, rounding: Rounding) -> WholePosition {
        match self.whole(raw, rounding) {
            None => WholePosition::NoNumber,
            Some(Whole::Number(number)) if self.to.holds(number) => WholePosition::Inside,
            Some(_) => WholePosition::Outside,
        }
    }

    /// Returns the operand, rounded to an integer; `None` for a NaN and the infinities.
    fn whole(self, raw: u64, rounding: Rounding) -> Option<Whole> {
        match real::decode(raw, self.from) {
            Real::Finite(number) => Some(real::to_whole(number, rounding)),
            _ => None,
        }
    }
}

/// The position of a rounded real number relative to the range of the target.
#[derive(Clone, Copy, PartialEq, Eq)]
enum WholePosition {
    /// Within the range of the target.
    Inside,
    /// Outside the range of the target.
    Outside,
    /// The operand is a NaN or an infinity, which has no truncated value.
    NoNumber,
}
