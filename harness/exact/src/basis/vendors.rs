//! The results that the vendors of PLCnext Engineer and of Omron NJ state, on a page for each group of functions.

use super::{ROUNDED, Rules, UnaryCall, WholePosition, texts};
use crate::integer;
use crate::real::{self, Real, Whole};
use stickler_types::{ElementaryType, Family, Rounding};

// Omron's pages: integers to reals, bit strings to reals, reals to integers, reals to bit strings, and texts to integers and to reals.
const OMRON_TO_REAL: &str = "omron-instructions: 286";
const OMRON_BITS: &str = "omron-instructions: 293";
pub(super) const OMRON_ROUNDING: &str = "omron-instructions: 296";
const OMRON_TO_BITS: &str = "omron-instructions: 298";
const OMRON_INTEGER_TEXTS: &str = "omron-instructions: 319";
const OMRON_REAL_TEXTS: &str = "omron-instructions: 323";

/// Returns the page of PLCnext Engineer's help on the functions that give a type; `None` of those that were not read.
fn plcnext_page(to: ElementaryType) -> Option<&'static str> {
    Some(match to {
        ElementaryType::Bool => "plcnext-conversions: TO_BOOL",
        ElementaryType::Sint => "plcnext-conversions: TO_SINT",
        ElementaryType::Dint => "plcnext-conversions: TO_DINT",
        ElementaryType::Usint => "plcnext-conversions: TO_USINT",
        ElementaryType::Uint => "plcnext-conversions: TO_UINT",
        ElementaryType::Real => "plcnext-conversions: TO_REAL",
        ElementaryType::Lreal => "plcnext-conversions: TO_LREAL",
        ElementaryType::Dword => "plcnext-conversions: TO_DWORD",
        ElementaryType::Lword => "plcnext-conversions: TO_LWORD",
        ElementaryType::Time => "plcnext-conversions: TO_TIME",
        _ => return None,
    })
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
            (RealNumber, RealNumber) if self.is_normal_as_real(raw) => return Some(self.of_real_to_real(raw)),
            (Boolean | BitString | Signed | Unsigned, Signed | Unsigned | BitString)
            | (BitString | Signed | Unsigned | RealNumber, Boolean)
            | (Boolean, RealNumber) => true,
            (RealNumber, Signed | Unsigned) => !matches!(operand, Real::Infinite { .. }),
            (BitString, RealNumber) => same_width,
            (RealNumber, BitString) => same_width && operand != Real::NotANumber,
            (Signed | Unsigned | Duration, Duration) => self.to == ElementaryType::Time,
            _ => return self.of_time(raw),
        };
        plcnext_page(self.to).filter(|_| is_stated && self.from != self.to)
    }

    /// Returns whether REAL has a number next to an LREAL, neither too large nor with fewer digits than others; true of NaN and the infinities.
    fn is_normal_as_real(self, raw: u64) -> bool {
        let nearest = match real::decode(raw, self.from) {
            Real::Finite { significand: 1.., .. } => real::between(raw, self.from, ElementaryType::Real),
            _ => return true,
        };
        self.to == ElementaryType::Lreal
            || matches!(real::decode(nearest, ElementaryType::Real), Real::Finite { significand, .. } if significand >> 23 == 1)
    }

    /// Returns the basis of reading a STRING as a real in PLCnext Engineer, and as a number in Omron NJ, where a text that is none changes nothing.
    pub(super) fn of_vendor_text(self, units: &[u16]) -> Option<&'static str> {
        let is_plain = texts::is_plain_number(units, self.to);
        match self.rules {
            Rules::Plcnext if self.to.is_real() => {
                texts::basis(units, self.to).and_then(|_| plcnext_page(self.to))
            }
            Rules::Omron if self.to.is_real() => is_plain.then_some(OMRON_REAL_TEXTS),
            Rules::Omron => is_plain.then_some(OMRON_INTEGER_TEXTS),
            _ => None,
        }
    }

    /// Returns the basis of `<SRC>_TO_<DST>` in Omron NJ, where a number that the target does not hold gives "an illegal value"; a bit string holds those
    /// of an integer with a sign.
    pub(super) fn of_omron_conversion(self, raw: u64) -> Option<&'static str> {
        use Family::{BitString, Real as RealNumber, Signed, Unsigned};
        match (self.from.family(), self.to.family()) {
            (Signed | Unsigned, RealNumber) => Some(OMRON_TO_REAL),
            (BitString, RealNumber) => Some(OMRON_BITS),
            (RealNumber, Signed | Unsigned) => (self.rounded(raw, Rounding::HalfToEven)
                == WholePosition::Inside)
                .then_some(OMRON_ROUNDING),
            (RealNumber, BitString) => match self.whole(raw, Rounding::HalfToEven) {
                Some(Whole::Number(number)) => {
                    let signed = integer::of_bits(number, self.to.bits(), ElementaryType::Lint);
                    (signed == number).then_some(OMRON_TO_BITS)
                }
                _ => None,
            },
            _ => None,
        }
    }
}
