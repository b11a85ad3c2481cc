//! The ST statements by which a program counts from one operand to the next, and the programs that count through operands: one that
//! adds the results up, and one that keeps each result.

use super::plan::Counting;
use crate::literals;
use crate::program::ConversionProgram;
use std::ops::Range;
use stickler_exact::Signature;
use stickler_types::{ElementaryType, Family, Value};

/// The number of bits of a REAL's fraction.
const FRACTION: u32 = 23;
/// The number of REALs of one sign, NaNs among them.
const SIGN: u64 = 1 << 31;
/// The place of infinity among the REALs of one sign; the NaNs follow.
const INFINITY: u64 = 0xFF << FRACTION;

/// A counter through the values of a type of at most 32 bits, in the order of [`Domain::Every`](crate::sweep::Domain::Every).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Counter {
    operand: ElementaryType,
    /// The type in which the program counts: that of the operand, or for a bit string the unsigned integer type of the same width.
    counted: ElementaryType,
}

impl Counter {
    /// Returns the counter of an integer, a bit string or REAL; `None` for any other type and for those of more than 32 bits.
    pub const fn new(operand: ElementaryType) -> Option<Counter> {
        use ElementaryType::{Byte, Dint, Dword, Int, Real, Sint, Udint, Uint, Usint, Word};
        let counted = match operand {
            Sint | Int | Dint | Usint | Uint | Udint | Real => operand,
            Byte => Usint,
            Word => Uint,
            Dword => Udint,
            _ => return None,
        };
        Some(Counter { operand, counted })
    }

    /// Returns the ranges of places whose operands are one step apart, in order. Leaves out the infinities and NaNs, which no
    /// program can count. Each zero of a REAL is a range of its own, so that the sign of its result can be observed.
    pub fn stretches(self) -> Vec<Range<u64>> {
        if self.operand == ElementaryType::Real {
            return [0, SIGN].into_iter().flat_map(binades).collect();
        }
        let all = 1_u64 << self.operand.bits();
        match self.operand.family() {
            Family::Signed => vec![0..1, 1..all / 2, all / 2..all],
            _ => vec![0..1, 1..all],
        }
    }

    /// Returns the number of values of the type that are in no stretch.
    pub const fn left_out(self) -> u64 {
        match self.operand {
            ElementaryType::Real => 2 * (SIGN - INFINITY),
            _ => 0,
        }
    }

    /// Returns the ST declarations of the counter's variables, `operand` among them, initialized for a place.
    pub fn declarations(self, place: u64) -> String {
        let Counter { operand, counted } = self;
        let start = literal(counted, place);
        match operand {
            ElementaryType::Real => {
                format!(
                    "    operand : REAL := {start};\n    ulp     : REAL := {};\n",
                    ulp(place)
                )
            }
            _ if operand == counted => format!("    operand : {operand} := {start};\n"),
            _ => format!("    counted : {counted} := {start};\n    operand : {operand};\n"),
        }
    }

    /// Returns the ST statement that converts the counted variable to the operand; empty where both are the same variable.
    pub fn making(self) -> String {
        let Counter { operand, counted } = self;
        if operand == counted {
            return String::new();
        }
        format!("operand := {counted}_TO_{operand}(counted);")
    }

    /// Returns the ST statement that advances to the next operand.
    pub fn advancing(self) -> String {
        let Counter { operand, counted } = self;
        match operand {
            ElementaryType::Real => "operand := operand + ulp;".to_owned(),
            _ if operand == counted => format!("operand := operand + {operand}#1;"),
            _ => format!("counted := counted + {counted}#1;"),
        }
    }
}

/// Returns the stretches of the REALs of one sign, from its zero on.
fn binades(sign: u64) -> impl Iterator<Item = Range<u64>> {
    let binade = move |exponent: u64| sign + (exponent << FRACTION)..sign + ((exponent + 1) << FRACTION);
    // The subnormal numbers are as far apart as those of the binade after them.
    [sign..sign + 1, sign + 1..sign + (2 << FRACTION)]
        .into_iter()
        .chain((2..0xFF).map(binade))
}

fn literal(ty: ElementaryType, place: u64) -> String {
    let value = Value::plain(ty, ty.wrap(place.into()));
    literals::literal(&value)
}

/// Returns the distance from the REAL at a place to the next one away from zero, as a literal with its sign.
fn ulp(place: u64) -> String {
    let exponent = (place >> FRACTION & 0xFF).max(1) as i32;
    let magnitude = literals::power_of_two(exponent - 150).replacen("LREAL#", "", 1);
    let sign = if place & SIGN == 0 { "" } else { "-" };
    format!("REAL#{sign}{magnitude}")
}

/// Writes a program that adds up the results for the operands at the given places of a stretch, fewer than 2^31.
pub fn summed(signature: &Signature, counting: &Counting, places: &Range<u64>) -> ConversionProgram {
    let Signature { function, result, .. } = signature;
    let inputs = places.end - places.start;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let making = if making.is_empty() {
        making
    } else {
        format!("        {making}\n")
    };
    let declarations = format!(
        "{}    given  : {result};\n    passed : DINT := DINT#0;\n{}",
        counting.counter.declarations(places.start),
        counting.checksum.declarations(),
    );
    let statements = format!(
        "    REPEAT\n\
         {making}        given := {function}(operand);\n{}        passed := passed + DINT#1;\n        \
         IF passed < DINT#{inputs} THEN\n            {advancing}\n        END_IF;\n    \
         UNTIL passed >= DINT#{inputs}\n    END_REPEAT;\n",
        counting.checksum.statements(),
    );
    ConversionProgram {
        declarations,
        statements,
        observed: vec!["total".to_owned()],
        ty: ElementaryType::Lint,
    }
}

/// Writes a program that counts through the given places of a stretch and keeps each result in a variable of its own.
pub fn unrolled(signature: &Signature, counting: &Counting, places: &Range<u64>) -> ConversionProgram {
    let Signature { function, result, .. } = signature;
    let (making, advancing) = (counting.counter.making(), counting.counter.advancing());
    let observed: Vec<String> = (1..=places.end - places.start)
        .map(|number| format!("given{number}"))
        .collect();
    let mut declarations = counting.counter.declarations(places.start);
    let mut statements = String::new();
    for name in &observed {
        declarations.push_str(&format!("    {name} : {result};\n"));
    }
    for (index, name) in observed.iter().enumerate() {
        if index > 0 {
            statements.push_str(&format!("    {advancing}\n"));
        }
        if !making.is_empty() {
            statements.push_str(&format!("    {making}\n"));
        }
        statements.push_str(&format!("    {name} := {function}(operand);\n"));
    }
    ConversionProgram {
        declarations,
        statements,
        observed,
        ty: *result,
    }
}

#[cfg(test)]
mod tests {
    use super::{Counter, ulp};
    use stickler_types::{ElementaryType, Value};

    fn counters() -> impl Iterator<Item = (ElementaryType, Counter)> {
        let all = ElementaryType::ALL.into_iter();
        all.filter_map(|ty| Counter::new(ty).map(|counter| (ty, counter)))
    }

    #[test]
    fn every_value_is_in_one_stretch_or_left_out() {
        for (ty, counter) in counters() {
            let stretches = counter.stretches();
            let counted: u64 = stretches.iter().map(|stretch| stretch.end - stretch.start).sum();
            assert_eq!(counted + counter.left_out(), 1 << ty.bits(), "{ty}");
            assert!(
                stretches.is_sorted_by(|one, other| one.end <= other.start),
                "{ty}"
            );
        }
        assert_eq!(counters().count(), 10);
    }

    /// The increments of the program are checked in the arithmetic of REAL itself, at both ends of each stretch.
    #[test]
    fn adding_the_unit_in_the_last_place_gives_the_next_real() {
        let counter = Counter::new(ElementaryType::Real).expect("a counter");
        let real = |place: u64| f32::from_bits(u32::try_from(place).expect("32 bits"));
        for stretch in counter.stretches() {
            let Ok(Value::Plain { raw, .. }) = Value::parse(&ulp(stretch.start)) else {
                panic!("no literal")
            };
            let step = real(raw);
            let middle = u64::midpoint(stretch.start, stretch.end);
            for place in [stretch.start, middle, stretch.end.saturating_sub(2)] {
                if stretch.contains(&place) && stretch.contains(&(place + 1)) {
                    assert_eq!((real(place) + step).to_bits(), real(place + 1).to_bits());
                }
            }
        }
    }
}
