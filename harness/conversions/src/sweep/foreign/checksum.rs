//! The checksum of results, implemented twice: in ST for the generated programs, and in Rust for the expected sum.
//!
//! Each result becomes one or two whole numbers from 0 below 2^53, its parts, and each of these goes into the sum by
//! `total := (total * FACTOR + part) MOD MODULUS`. No step exceeds 2^62, so a LINT never overflows.
//!
//! The modulus is a prime: a wrong part that is no multiple of the modulus away from the right one changes the sum,
//! whatever follows. The factor is a primitive root: no two places in a block weigh the same, so that errors which
//! follow a pattern do not cancel each other. And the modulus is far from all sums and differences of powers of two, by
//! which results are wrong: modulo 2147483647, for instance, a DINT that stays at its limit would look like 0.
//!
//! A real number is taken apart by comparisons and by products with powers of two, which are exact in every format and
//! by every rounding of IEC 60559 that holds the number at all; no sum of real numbers is formed, so nothing is lost.

use stickler_types::{ElementaryType, Family};

const FACTOR: u64 = 1_234_567_891;
const MODULUS: u64 = 1_999_999_973;
/// The number of values that 32 bits hold, half of the width of LINT.
const HALF: u64 = 1 << 32;

/// The checksum of results of one type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Checksum {
    result: ElementaryType,
}

impl Checksum {
    /// Returns the checksum of results that are integers, bit strings, BOOL or real numbers; `None` for other types.
    pub const fn new(result: ElementaryType) -> Option<Checksum> {
        match result.family() {
            Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Real => {
                Some(Checksum { result })
            }
            _ => None,
        }
    }

    /// Returns the sum after one more result, given in its raw form.
    ///
    /// Zeros of either sign count the same, and so do a NaN, the infinities and all numbers far outside the range of REAL.
    pub fn add(self, total: u64, raw: u64) -> u64 {
        let step = |total, part| (total * FACTOR + part) % MODULUS;
        match (self.result.family(), self.result.bits()) {
            (Family::Real, _) => {
                let (code, mantissa) = self.real(raw);
                step(step(total, code), mantissa)
            }
            // The raw form of a signed integer is its sign-extended one; the sum has it counted from the type's lower limit.
            (Family::Signed, 64) => {
                let counted = raw ^ 1 << 63;
                step(step(total, counted / HALF), counted % HALF)
            }
            (Family::Signed, bits) => step(total, raw.wrapping_add(1 << (bits - 1))),
            (_, 64) => step(step(total, raw / HALF), raw % HALF),
            _ => step(total, raw),
        }
    }

    /// Returns the parts of a real number's raw form: the code of sign and exponent, and the 53 bits of the mantissa.
    fn real(self, raw: u64) -> (u64, u64) {
        let double = self.result.real_value(raw).map_or(raw, f64::to_bits);
        let (negative, bits) = (double >> 63, double << 1 >> 1);
        let (exponent, fraction) = (bits >> 52, bits & ((1 << 52) - 1));
        match exponent {
            _ if bits == 0 => (0, 0),
            ..LEAST_EXPONENT | GREATEST_EXPONENT.. => (1, 0),
            _ => (2 * (exponent + 1) + negative, fraction | 1 << 52),
        }
    }

    /// Returns the ST declarations of the checksum's variables besides `given`, which holds the result.
    pub fn declarations(self) -> String {
        let more = match (self.result.family(), self.result) {
            (Family::Real, _) => {
                "    number   : LREAL;\n    exponent : LINT;\n    negative : LINT;\n    mantissa : LINT;\n"
            }
            (_, ElementaryType::Lint) => "    high : LINT;\n    low  : LINT;\n",
            (_, ElementaryType::Ulint | ElementaryType::Lword) => "    whole : ULINT;\n",
            _ => "",
        };
        format!("    part  : LINT;\n    total : LINT := LINT#0;\n{more}")
    }

    /// Returns the ST statements that add `given` to `total`, each line indented twice.
    pub fn statements(self) -> String {
        use ElementaryType::{Bool, Lint, Lreal, Lword, Real, Ulint};
        let ty = self.result;
        let part = |part: &str| format!("        part := {part};\n{STEP}");
        match ty {
            Bool => include_str!("checksum/bool.st").to_owned(),
            Lint => include_str!("checksum/lint.st").to_owned(),
            Ulint => format!("        whole := given;\n{HALVES}"),
            Lword => format!("        whole := LWORD_TO_ULINT(given);\n{HALVES}"),
            Real => format!("        number := REAL_TO_LREAL(given);\n{DIGITS}"),
            Lreal => format!("        number := given;\n{DIGITS}"),
            _ if ty.is_signed() => part(&format!(
                "{ty}_TO_LINT(given) + LINT#{}",
                1_u64 << (ty.bits() - 1)
            )),
            // A dialect may copy the highest bit of a bit string into a LINT.
            _ if ty.is_bit_string() => part(&format!("ULINT_TO_LINT({ty}_TO_ULINT(given))")),
            _ => part(&format!("{ty}_TO_LINT(given)")),
        }
    }
}

/// The statement that adds `part` to the sum; a test holds that its numbers are those of Rust.
const STEP: &str = "        total := (total * LINT#1234567891 + part) MOD LINT#1999999973;\n";

/// The statements that split a ULINT into its halves and add them. A signed LINT is split in `lint.st`, the low half never negative, whatever
/// the sign of the engine's `MOD` of a negative number.
const HALVES: &str = include_str!("checksum/ulint.st");

/// The statements that split `number` into sign, exponent and mantissa. Products with powers of two, each of them
/// exact, bring its magnitude between 1 and 2; the mantissa is then a whole number of 53 bits. A NaN passes every comparison
/// as false.
const DIGITS: &str = include_str!("checksum/lreal.st");

/// The least of the biased exponents that the program can tell apart: from that of 2^-255 up to, and without, that of 2^128.
/// All exponents of REALs are in that range, and no other is ever expected.
const LEAST_EXPONENT: u64 = 1023 - 255;
const GREATEST_EXPONENT: u64 = 1023 + 128;

#[cfg(test)]
mod tests {
    use super::{Checksum, FACTOR, MODULUS};
    use stickler_types::{ElementaryType, sorted};

    /// The modulus is a prime, and the powers of the factor take every value but 0 before they return to 1.
    #[test]
    fn the_factor_is_a_primitive_root_of_the_modulus() {
        let power = |exponent: u64| {
            (0..64).rev().fold(1, |power, bit| {
                let square = power * power % MODULUS;
                if exponent >> bit & 1 == 1 {
                    square * FACTOR % MODULUS
                } else {
                    square
                }
            })
        };
        assert!((2..46_341).all(|divisor| !MODULUS.is_multiple_of(divisor)));
        assert_eq!(MODULUS - 1, 2 * 2 * 499_999_993);
        assert_eq!(power(MODULUS - 1), 1);
        for prime in [2, 499_999_993] {
            assert_ne!(power((MODULUS - 1) / prime), 1);
        }
    }

    /// The differences of typical errors (a wrap instead of a limit, a sign, a bit, one more or less) are no multiples of the
    /// modulus.
    #[test]
    fn no_usual_difference_vanishes() {
        let edges: Vec<i128> = (0..=64)
            .flat_map(|bits| (-2..=2).map(move |near| (1 << bits) + near))
            .collect();
        for one in &edges {
            for other in &edges {
                for difference in [one - other, one + other] {
                    let small = difference.abs() < 1 << 33;
                    assert!(
                        difference == 0 || !small || difference % i128::from(MODULUS) != 0,
                        "{one} {other}"
                    );
                }
            }
        }
    }

    #[test]
    fn every_wrong_result_changes_the_sum() {
        for (ty, raws) in [
            (
                ElementaryType::Dint,
                [0, 1, (-1_i64).cast_unsigned(), 0x7FFF_FFFF],
            ),
            (ElementaryType::Lint, [0, 1, u64::MAX, i64::MAX.cast_unsigned()]),
            (ElementaryType::Lword, [0, 1, u64::MAX, 1 << 32]),
            (ElementaryType::Real, [0, 0x3F80_0000, 0x3F80_0001, 0xBF80_0000]),
            (
                ElementaryType::Lreal,
                [0, 1.0_f64.to_bits(), 1.0_f64.to_bits() + 1, 2.0_f64.to_bits()],
            ),
        ] {
            let checksum = Checksum::new(ty).expect("a checksum");
            let sums = sorted(raws.iter().map(|raw| checksum.add(7, *raw)));
            assert_eq!(sums.len(), raws.len(), "{ty}");
        }
    }
}
