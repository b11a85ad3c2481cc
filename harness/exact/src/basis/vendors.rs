//! The results that the vendors of PLCnext Engineer and of Omron NJ state, on a page for each group of functions; and those on the page of a
//! vendor whose system's recordings count for more, so that both can be shown where they differ.

use super::{ROUNDED, Rules, UnaryCall, WholePosition, texts};
use crate::integer;
use crate::real::{self, Real, Whole};
use crate::signature::{Operation, Signature};
use crate::value::value;
use stickler_types::{ConversionChoices, DialectName, ElementaryType, Family, Rounding, Value};

/// The pages of PLCnext Engineer's help that were read, each on the functions that give one type.
const PLCNEXT_PAGES: [&str; 10] = [
    "plcnext-conversions: TO_BOOL",
    "plcnext-conversions: TO_SINT",
    "plcnext-conversions: TO_DINT",
    "plcnext-conversions: TO_USINT",
    "plcnext-conversions: TO_UINT",
    "plcnext-conversions: TO_REAL",
    "plcnext-conversions: TO_LREAL",
    "plcnext-conversions: TO_DWORD",
    "plcnext-conversions: TO_LWORD",
    "plcnext-conversions: TO_TIME",
];

/// The page of Omron's manual on real numbers that become integers.
pub(super) const OMRON_ROUNDING: &str = "omron-instructions: 296";

fn plcnext_page(to: ElementaryType) -> Option<&'static str> {
    let function = format!(" TO_{to}");
    PLCNEXT_PAGES.into_iter().find(|page| page.ends_with(&function))
}

impl UnaryCall<'_> {
    /// Returns the basis of `TO_<DST>` and of `<SRC>_TO_<DST>` in PLCnext Engineer. Infinities as integers are not spoken of, nor the bits of a NaN,
    /// and a REAL that cannot hold an LREAL "depends on the target".
    pub(super) fn of_plcnext_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Boolean, Duration, Real as RealNumber, Signed, Unsigned};
        let same_width = self.from.bits() == self.to.bits();
        let operand = real::decode(raw, self.from);
        let is_stated = match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, RealNumber) => return Some(ROUNDED),
            // Within 2^-126 and 2^127.
            (RealNumber, RealNumber) => {
                let is_near = self.to == ElementaryType::Lreal
                    || !matches!(operand, Real::Finite(number) if number.significand > 0 && !(-178..=74).contains(&number.exponent));
                return is_near.then(|| self.of_real_to_real(raw));
            }
            (Boolean | BitString | Signed | Unsigned, Signed | Unsigned | BitString)
            | (BitString | Signed | Unsigned | RealNumber, Boolean)
            | (Boolean, RealNumber) => true,
            (RealNumber, Signed | Unsigned) => !matches!(operand, Real::Infinite { .. }),
            (BitString, RealNumber) => same_width,
            (RealNumber, BitString) => same_width && operand != Real::NotANumber,
            (Signed | Unsigned | Duration, Duration) => self.to == ElementaryType::Time,
            _ if [self.from, self.to].contains(&ElementaryType::Time) => return self.of_time(raw),
            _ => false,
        };
        plcnext_page(self.to).filter(|_| is_stated && self.from != self.to)
    }

    /// Returns the basis of reading a STRING as a real in PLCnext Engineer, and as a number in Omron NJ, where a text that is none changes nothing.
    pub(super) fn of_vendor_text(self, units: &[u16]) -> Option<&'static str> {
        let is_plain = texts::is_plain_number(units, self.to);
        match self.rules {
            Rules::Plcnext if self.to.is_real() => {
                texts::basis(units, self.to).and_then(|_| plcnext_page(self.to))
            }
            Rules::Omron if !is_plain => None,
            Rules::Omron if self.to.is_real() => Some("omron-instructions: 323"),
            Rules::Omron => Some("omron-instructions: 319"),
            _ => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in Omron NJ, where a number that the target does not hold gives "an illegal value"; a bit string holds those
    /// of an integer with a sign.
    pub(super) fn of_omron_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Real as RealNumber, Signed, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, RealNumber) => Some("omron-instructions: 286"),
            (BitString, RealNumber) => Some("omron-instructions: 293"),
            (RealNumber, Signed | Unsigned) => {
                (self.rounded(raw, Rounding::HalfToEven) == WholePosition::Inside).then_some(OMRON_ROUNDING)
            }
            (RealNumber, BitString) => match self.whole(raw, Rounding::HalfToEven) {
                Some(Whole::Number(number)) => {
                    let signed = integer::of_bits(number, self.to.bits(), ElementaryType::Lint);
                    (signed == number).then_some("omron-instructions: 298")
                }
                _ => None,
            },
            _ => None,
        }
    }
}

/// Returns the result that the vendor's page states of a call in a dialect whose cases rest on recordings, with its basis; `None` where the
/// page does not speak of the call, or there is no such page.
///
/// Takes what [`crate::expected`] takes. What the page says decides no case.
#[must_use]
pub fn stated_by_vendor(
    signature: &Signature,
    operands: &[Value],
    dialect: DialectName,
) -> Option<(Value, &'static str)> {
    let documented = dialect.definition().is_none().then(|| dialect.rules());
    let page = documented?.documents.page_on_reals.as_ref()?;
    if !is_of_finite_real(signature, operands) {
        return None;
    }
    let choices = ConversionChoices {
        rounding: page.rounding,
        out_of_range: page.out_of_range,
        ..dialect.rules().conversions
    };
    Some((value(signature, operands, &choices), &page.basis))
}

/// Returns whether a call is one of `REAL_TO_x` or `LREAL_TO_x` to an integer or bit string, with a number.
fn is_of_finite_real(signature: &Signature, operands: &[Value]) -> bool {
    let (&[from], &[Value::Plain { raw, .. }]) = (&signature.operands[..], operands) else {
        return false;
    };
    let to = signature.result;
    signature.operation == Operation::Convert
        && from.is_real()
        && !signature.function.starts_with("TO_")
        && (to.is_integer() || (to.is_bit_string() && to.bits() > 1))
        && signature.takes(operands)
        && matches!(real::decode(raw, from), real::Real::Finite(_))
}
