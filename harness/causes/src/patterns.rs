//! Patterns of numbers: what of its origin a wrong value shows by its number alone.

use crate::alone::binary;
use crate::forms::named_types;
use crate::loop_limits::{TO_LAST_VALUE, loop_beyond_limit};
use crate::malformed::{SIZES, number_of_literal, size_of_integer};
use crate::program::ReadProgram;
use crate::question::{Deviation, wrong_values};
use crate::words::{converted, elementary, has_word, is_number, kind, type_of_word, valued_types, words};
use crate::work::operations;
use std::collections::BTreeSet;
use stickler_syntax::tree::BinaryOperator;
use stickler_syntax::visitor::Place;
use stickler_types::{ElementaryType, Family, Value};

/// The pattern of a text of which no escape is read.
pub(crate) const UNREAD_ESCAPES: &str = "text with its escapes as they are written";

/// The pattern of a real number that becomes an integer whose type does not hold it.
pub(crate) const OUT_OF_RANGE: &str = "conversion of a real number outside the range of its target";

/// The pattern of an integer that the engine reads as an LREAL.
pub(crate) const BITS_OF_LREAL: &str = "integer literal with the bits of an LREAL";

/// The milliseconds of a second.
const MILLISECONDS: f64 = 1000.0;

/// The nanoseconds of a second.
const NANOSECONDS: i64 = 1_000_000_000;

/// Returns what a wrong value says by its number alone of how it came about, whatever types and sizes the program has; `None` where it
/// says nothing.
pub(crate) fn number_pattern(program: &ReadProgram<'_, '_>, deviation: &Deviation) -> Option<&'static str> {
    let wrong = WrongNumber { program, deviation };
    let patterns = [
        (
            wrong.rereads_bits() || wrong.extends_sign(),
            "value that is not converted to the type it is read in",
        ),
        (
            wrong.is_no_moment(),
            "conversion to a date or a time of day that gives none",
        ),
        (wrong.rounds_twice(), "REAL literal that is rounded twice"),
        (wrong.exceeds_milliseconds(), "milliseconds beyond 32 bits"),
        (
            wrong.has_date_beyond_seconds(),
            "date that 32 bits of seconds do not hold",
        ),
        (wrong.loses_fraction(), "fraction of a second that is lost"),
        (wrong.rounds_to_real(), "LREAL literal with the digits of a REAL"),
        (wrong.counts_seconds(), "seconds in the place of milliseconds"),
        (
            wrong.counts_nanoseconds(),
            "nanoseconds in the place of milliseconds",
        ),
        (wrong.converts_out_of_range(), OUT_OF_RANGE),
        (wrong.counts_to_limit(), TO_LAST_VALUE),
        (
            wrong.keeps_range(),
            "conversion to an integer that does not bring it into its range",
        ),
        (wrong.becomes_zero(), SIZES[1]),
        (
            wrong.rounds_to_lreal() || wrong.compares_beyond_lreal(),
            BITS_OF_LREAL,
        ),
        (wrong.keeps_lreal(), "REAL literal with the bits of an LREAL"),
        (wrong.keeps_escapes(), UNREAD_ESCAPES),
    ];
    patterns
        .into_iter()
        .find(|(shows, _)| *shows)
        .map(|(_, pattern)| pattern)
}

/// Returns whether the first value that a program has wrong must be another number than each literal of the program, as where a
/// conversion wraps, or a negative number becomes one without a sign. Where the program has no number, none left a range.
pub(crate) fn leaves_range(program: &ReadProgram<'_, '_>, deviation: &Deviation) -> bool {
    WrongNumber { program, deviation }.leaves_range()
}

/// Returns whether a program has a number with the first bit of an unsigned type, which is the sign of a signed type of the same size.
pub(crate) fn has_first_bit(program: &ReadProgram<'_, '_>) -> bool {
    program.literals().any(|(part, literal)| {
        let ty = program.type_of(part.id).or_else(|| program.target(part));
        let is_unsigned = |ty: &ElementaryType| kind(*ty) == Some("integer") && ty.family() != Family::Signed;
        let number = amount(literal).zip(ty.filter(is_unsigned));
        number.is_some_and(|(number, ty)| number >= 2_f64.powi(ty.bits() as i32 - 1))
    })
}

/// Returns what a comparison gives; `None` for another operator, and where no order is known.
fn compared<N: PartialOrd>(operator: BinaryOperator, left: &N, right: &N) -> Option<bool> {
    let order = left.partial_cmp(right)?;
    match operator {
        BinaryOperator::Equal => Some(order.is_eq()),
        BinaryOperator::NotEqual => Some(order.is_ne()),
        BinaryOperator::Less => Some(order.is_lt()),
        BinaryOperator::LessOrEqual => Some(order.is_le()),
        BinaryOperator::Greater => Some(order.is_gt()),
        BinaryOperator::GreaterOrEqual => Some(order.is_ge()),
        _ => None,
    }
}

/// The first number that a program has wrong, beside those of its text.
struct WrongNumber<'p, 't, 's> {
    program: &'p ReadProgram<'t, 's>,
    deviation: &'p Deviation,
}

impl WrongNumber<'_, '_, '_> {
    /// Returns the first wrong value: what it must be, and what it is.
    fn values(&self) -> Option<(&Value, &Value)> {
        let first = wrong_values(&self.deviation.expected, &self.deviation.got).next();
        first.map(|(_, values)| values)
    }

    /// Returns whether the first wrong value is a text with a `$`, as a literal of the program has it between its quotes, or the length of
    /// that.
    fn keeps_escapes(&self) -> bool {
        let Some((_, got)) = self.values() else {
            return false;
        };
        let measures = has_word(self.program.text, "LEN");
        let is_written = |literal: &str| {
            let inside = literal
                .get(1..literal.len().saturating_sub(1))
                .unwrap_or_default();
            let written = inside.encode_utf16();
            inside.contains('$')
                && match got {
                    Value::Text { units, .. } => written.eq(units.iter().copied()),
                    Value::Plain { raw, .. } => measures && *raw == written.count() as u64,
                    _ => false,
                }
        };
        self.program.literals().any(|(_, literal)| is_written(literal))
    }

    /// Returns the bits of the first wrong value with its type.
    fn bits(&self) -> Option<(ElementaryType, u64, u64)> {
        match self.values()? {
            (Value::Plain { ty, raw }, Value::Plain { raw: got, .. }) => Some((*ty, *raw, *got)),
            _ => None,
        }
    }

    /// Returns the first wrong number: what it must be, and what it is.
    fn numbers(&self) -> Option<(f64, f64)> {
        let number = |value: &Value| {
            let text = value.to_string();
            let sign = if text.contains("#-") { -1.0 } else { 1.0 };
            // A duration beyond 64 bits is written in nanoseconds, whatever its type counts.
            let unit = if matches!(value, Value::OutOfRange { .. }) {
                1e-6
            } else {
                1.0
            };
            Some(amount(&text)? * sign * unit)
        };
        let (value, other) = self.values()?;
        Some((number(value)?, number(other)?))
    }

    /// Returns the amounts of the literals of the program.
    fn amounts(&self) -> impl Iterator<Item = f64> {
        self.program.literals().filter_map(|(_, literal)| amount(literal))
    }

    fn leaves_range(&self) -> bool {
        let Some((expected, _)) = self.numbers() else {
            return false;
        };
        // A fraction is dropped or rounded, and a REAL has 24 bits.
        let is_near = |number: f64| (number - expected.abs()).abs() <= 1.0 + expected.abs() * 1e-6;
        self.amounts().next().is_some() && (!self.amounts().any(is_near) || self.converts_negative())
    }

    /// Returns whether the program converts by name to a type without a sign, and has a negative number.
    fn converts_negative(&self) -> bool {
        let is_signed = |literal: &str| literal.starts_with('-') || literal.contains("#-");
        let mut literals = self.program.literals();
        let unsigned =
            |into: ElementaryType| kind(into) == Some("integer") && into.family() != Family::Signed;
        literals.any(|(_, literal)| is_signed(literal)) && self.conversions().any(|(_, into)| unsigned(into))
    }

    /// Returns the number of operations with which the program computes. Calls, elements, conditions and the sign of an operand are none.
    fn computed(&self) -> usize {
        let beside = [
            "sign",
            "call",
            "output argument",
            "subscript or list",
            "condition",
        ];
        let operations = operations(self.program.text).into_iter();
        operations.filter(|one| !beside.contains(&one.as_str())).count()
    }

    /// Returns the types between which the program converts by name.
    fn conversions(&self) -> impl Iterator<Item = (ElementaryType, ElementaryType)> {
        let callees = self
            .program
            .at(Place::Callee)
            .map(|part| self.program.text(part.id));
        callees.filter_map(converted)
    }

    /// Returns whether the program does nothing but convert a real number to an integer by name, and the number is outside the range.
    fn converts_out_of_range(&self) -> bool {
        let written = words(self.program.text);
        let is_negative = written.iter().any(|word| *word == "-" || word.contains("#-"));
        let leaves = |from: ElementaryType, into: ElementaryType| {
            // Of an unsigned type the least number is 0, and a minus stands before a number.
            let is_outside = |number: f64| {
                let number = match from {
                    ElementaryType::Real => f64::from(number as f32),
                    _ => number,
                };
                let most = into.integer_range();
                let most = most.is_some_and(|(_, most)| number >= most as f64 + 1.0);
                most || number != 0.0 && is_negative && into.family() != Family::Signed
            };
            self.leaves_range() || self.amounts().any(is_outside)
        };
        let mut conversions = self.conversions();
        self.computed() == 1
            && conversions
                .any(|(from, into)| from.is_real() && kind(into) == Some("integer") && leaves(from, into))
    }

    /// Returns whether the program does nothing but count in a FOR loop, with numbers of one type and the greatest amount of that type.
    fn counts_to_limit(&self) -> bool {
        let controls = self.program.at(Place::Control);
        let mut counted = controls.map(|part| self.program.type_of(part.id));
        let most = |ty: ElementaryType| ty.integer_range().map(|(_, most)| most as f64);
        let counts = |ty: Option<ElementaryType>| {
            let most = ty.and_then(most);
            self.amounts().any(|number| Some(number) == most)
        };
        let is_plain = self.computed() == 0 && valued_types(self.program.text).len() < 2;
        is_plain && counted.any(counts) || self.is_counted_on()
    }

    /// Returns whether the wrong value has the bits that a literal of the program has in another type, and no function converts it.
    fn rereads_bits(&self) -> bool {
        let Some((ty, _, got)) = self.bits().filter(|(ty, _, got)| is_number(*ty) && *got != 0) else {
            return false;
        };
        let types = valued_types(self.program.text).into_iter();
        let mut others = types.filter(|other| *other != ty && (other.is_real() || ty.is_real()));
        let is_nan = |bits: u64| ty.real_value(bits).is_some_and(f64::is_nan);
        let has_bits = |other: ElementaryType| {
            let mut values = self.amounts().flat_map(|amount| [amount, -amount]);
            values.any(|value| {
                let bits = match other {
                    ElementaryType::Real => u64::from((value as f32).to_bits()),
                    ElementaryType::Lreal => value.to_bits(),
                    _ if value < 0.0 => (value as i64).cast_unsigned(),
                    _ => value as u64,
                };
                // The amounts of literals have 53 bits.
                let near = if value.abs() < 2_f64.powi(53) { 0 } else { 2048 };
                (mask(ty) & bits).abs_diff(mask(ty) & got) <= near || is_nan(bits) && is_nan(got)
            })
        };
        self.conversions().next().is_none() && others.any(has_bits)
    }

    /// Returns whether the first bit of an unsigned number was taken for a sign where the number became a wider one.
    fn extends_sign(&self) -> bool {
        let Some((ty, raw, got)) = self.bits().filter(|(ty, ..)| kind(*ty) == Some("integer")) else {
            return false;
        };
        let mut types = valued_types(self.program.text).into_iter();
        types.any(|narrow| {
            let first = || 1_u64 << (narrow.bits() - 1);
            kind(narrow) == Some("integer")
                && narrow.family() != Family::Signed
                && narrow.bits() < ty.bits()
                && raw & first() != 0
                && raw & !mask(narrow) & mask(ty) == 0
                && (raw | !mask(narrow)) & mask(ty) == got & mask(ty)
        })
    }

    /// Returns whether a literal of the type REAL is the one that its nearest LREAL is nearest to.
    fn rounds_twice(&self) -> bool {
        let bits = self.bits().filter(|(ty, ..)| *ty == ElementaryType::Real);
        let mut rounded = self.amounts().map(|amount| u64::from((amount as f32).to_bits()));
        let is_near =
            |(_, raw, got): (_, u64, u64)| raw.abs_diff(got) == 1 && rounded.any(|bits| bits == got);
        self.conversions().next().is_none() && bits.is_some_and(is_near)
    }

    /// Returns whether a duration must have more milliseconds than 32 bits hold, and has not.
    fn exceeds_milliseconds(&self) -> bool {
        let fits = |nanoseconds: u64| i32::try_from(nanoseconds.cast_signed() / 1_000_000).is_ok();
        let bits = self.bits().filter(|(ty, ..)| *ty == ElementaryType::Time);
        bits.is_some_and(|(_, raw, got)| !fits(raw) && fits(got))
    }

    /// Returns whether the program converts by name to a type of dates or times, and the wrong value has a count that is none of the type.
    fn is_no_moment(&self) -> bool {
        self.conversions().next().is_some() && self.values().is_some_and(|(_, got)| is_no_moment(got))
    }

    /// Returns whether the program has a date before 1970 or after 2105, and a wrong date or time.
    fn has_date_beyond_seconds(&self) -> bool {
        let year = |literal: &str| {
            let (year, _) = literal.split_once('#')?.1.split_once('-')?;
            year.parse::<u32>().ok()
        };
        let is_beyond = |year: u32| !(1970..=2105).contains(&year);
        let mut years = self.program.literals().filter_map(|(_, literal)| year(literal));
        let is_moment = self.bits().is_some_and(|(ty, ..)| ty.is_date_or_time());
        is_moment && years.any(is_beyond)
    }

    /// Returns whether a wrong time of day, or date and time, is the right one without its fraction of a second.
    fn loses_fraction(&self) -> bool {
        let bits = self.bits().filter(|(ty, ..)| ty.is_date_or_time());
        bits.is_some_and(|(_, raw, got)| {
            let (raw, got) = (raw.cast_signed(), got.cast_signed());
            raw != got && raw - raw.rem_euclid(NANOSECONDS) == got
        })
    }

    /// Returns whether a literal of the type LREAL has no more digits than a REAL has.
    fn rounds_to_real(&self) -> bool {
        let bits = self.bits().filter(|(ty, ..)| *ty == ElementaryType::Lreal);
        let is_rounded = |(_, raw, got): (ElementaryType, u64, u64)| {
            let (expected, got) = (f64::from_bits(raw), f64::from_bits(got));
            f64::from(expected as f32) == got && self.amounts().any(|amount| amount == expected.abs())
        };
        self.conversions().next().is_none() && bits.is_some_and(is_rounded)
    }

    /// Returns whether the program converts to an integer by name, and the wrong value has the bits that the result has, with others
    /// before them.
    fn keeps_range(&self) -> bool {
        let Some((ty, raw, got)) = self.bits().filter(|(ty, ..)| kind(*ty) == Some("integer")) else {
            return false;
        };
        self.conversions().any(|(_, narrow)| {
            let is_narrow = kind(narrow) == Some("integer") && narrow.bits() < ty.bits();
            is_narrow && (raw ^ got) & ((1 << narrow.bits()) - 1) == 0
        })
    }

    /// Returns whether an integer literal of 64 bits is off by no more than an LREAL, which has 53 bits, can be off at its size.
    fn rounds_to_lreal(&self) -> bool {
        let Some((ty, raw, got)) = self.bits().filter(|(ty, ..)| kind(*ty) == Some("integer")) else {
            return false;
        };
        let magnitude = match ty.family() {
            Family::Signed => raw.cast_signed().unsigned_abs(),
            _ => raw,
        };
        let error = raw.wrapping_sub(got).cast_signed().unsigned_abs();
        let is_copied = operations(self.program.text).is_empty()
            && magnitude > 1 << f64::MANTISSA_DIGITS
            && error <= 1 << (u64::BITS - f64::MANTISSA_DIGITS);
        is_copied || self.has_rounded_literal((ty, raw, got))
    }

    /// Returns whether the wrong number is too great and computed in a loop that counts beyond the limit of its variable.
    fn is_counted_on(&self) -> bool {
        let name = wrong_values(&self.deviation.expected, &self.deviation.got).next();
        let line = name.and_then(|(name, _)| self.program.computation(name));
        let around = line.and_then(|line| self.program.loop_around(line));
        let is_greater = self.numbers().is_some_and(|(wanted, got)| got > wanted);
        is_greater && around.is_some() && around == loop_beyond_limit(self.program)
    }

    /// Returns whether the first wrong value is zero in the place of an integer literal of 64 bits: an LREAL that is too large may become
    /// that, and a literal that is not read.
    fn becomes_zero(&self) -> bool {
        let is_zero = self
            .bits()
            .is_some_and(|(ty, _, got)| got == 0 && ty.bits() == 64);
        let mut literals = self.program.literals();
        is_zero && literals.any(|(_, literal)| size_of_integer(literal) == Some(SIZES[1]))
    }

    /// Returns whether the wrong truth value is what a comparison of two integer literals gives with the nearest LREAL of each.
    fn compares_beyond_lreal(&self) -> bool {
        let Some((ElementaryType::Bool, _, got)) = self.bits() else {
            return false;
        };
        let number = |id| number_of_literal(self.program.literal(id)?);
        self.program.at(Place::Value).any(|part| {
            let Some((operator, left, right)) = binary(self.program, part.id) else {
                return false;
            };
            let (Some(left), Some(right)) = (number(left), number(right)) else {
                return false;
            };
            let given = compared(operator, &left, &right);
            let rounded = compared(operator, &(left as f64), &(right as f64));
            given != rounded && rounded == Some(got != 0)
        })
    }

    /// Returns whether the wrong value has the last bits of an integer literal with the digits of its nearest LREAL, where it must have
    /// those of the literal: what is done with it is right.
    fn has_rounded_literal(&self, (ty, raw, got): (ElementaryType, u64, u64)) -> bool {
        let mut literals = self.program.literals();
        literals.any(|(_, literal)| {
            let digits = literal.rsplit('#').next().unwrap_or(literal).replace('_', "");
            let Ok(number) = digits.parse::<i128>() else {
                return false;
            };
            let (nearest, mask) = (number as f64, mask(ty));
            // A number is written with the digits that tell it from its neighbours, and zeros.
            let written = format!("{nearest}").parse::<i128>().unwrap_or(nearest as i128);
            let is_got = [nearest as i128, written]
                .iter()
                .any(|rounded| (*rounded as u64) & mask == got & mask);
            number.unsigned_abs() > 1 << f64::MANTISSA_DIGITS
                && (number as u64) & mask == raw & mask
                && is_got
        })
    }

    /// Returns whether a literal of the type REAL is not rounded to one.
    fn keeps_lreal(&self) -> bool {
        let mut literals = self.program.literals().map(|(_, literal)| literal);
        let is_rounded = |(expected, got): (f64, f64)| f64::from(got as f32) == expected;
        operations(self.program.text).is_empty()
            && literals
                .any(|literal| type_of_word(literal) == Some(ElementaryType::Real) && literal.contains('#'))
            && self.numbers().is_some_and(is_rounded)
    }

    /// Returns whether the program converts between durations and numbers.
    fn converts_duration(&self) -> bool {
        let types = named_types(self.program.text).into_iter().filter_map(elementary);
        let kinds: BTreeSet<&str> = types.filter_map(kind).collect();
        let is_by_name = self
            .conversions()
            .any(|(from, into)| from.is_duration() != into.is_duration());
        is_by_name || kinds.contains("duration") && (kinds.contains("integer") || kinds.contains("real"))
    }

    /// Returns whether the engine counts durations in nanoseconds where milliseconds are expected.
    fn counts_nanoseconds(&self) -> bool {
        let is_million = |more: f64, less: f64| less != 0.0 && (more / less / 1e6 - 1.0).abs() < 1e-6;
        let numbers = self.numbers().filter(|_| self.converts_duration());
        numbers.is_some_and(|(expected, got)| is_million(got, expected) || is_million(expected, got))
    }

    /// Returns whether the engine counts durations in seconds where milliseconds are expected.
    fn counts_seconds(&self) -> bool {
        let Some((expected, got)) = self.numbers() else {
            return false;
        };
        // Below a second the number of seconds is 0, which a conversion by its name gives for no other reason.
        let is_second = expected.abs() >= MILLISECONDS || got == 0.0 && self.conversions().next().is_some();
        let counts_seconds = expected != 0.0 && is_second && (got - expected / MILLISECONDS).abs() < 1.0;
        let takes_seconds = expected != 0.0 && (got / MILLISECONDS - expected).abs() < 0.01;
        self.converts_duration() && (counts_seconds || takes_seconds)
    }
}

/// Returns whether a value is one of a type of dates or times of day with a count that is no date and no time of day, as its text says.
pub(crate) fn is_no_moment(value: &Value) -> bool {
    let is_moment = elementary(value.type_name()).is_some_and(ElementaryType::is_date_or_time);
    is_moment && value.to_string().ends_with("ns")
}

/// Returns the bits that the values of a type have.
fn mask(ty: ElementaryType) -> u64 {
    u64::MAX >> u64::BITS.saturating_sub(ty.bits())
}

/// Returns the amount that a literal says, without its sign: of a number with or without a base, or of a duration with one unit.
pub(crate) fn amount(literal: &str) -> Option<f64> {
    let value = match literal.split_once('#') {
        Some((prefix, value)) if !prefix.starts_with(|first: char| first.is_ascii_digit()) => value,
        _ => literal,
    };
    let plain = value.trim_start_matches(['-', '+', ' ']).replace('_', "");
    match plain.split_once('#') {
        Some((base, digits)) => {
            let base = base.parse().ok().filter(|base| matches!(base, 2 | 8 | 16))?;
            Some(u64::from_str_radix(digits, base).ok()? as f64)
        }
        None => {
            let is_unit = |unit: char| unit.is_ascii_lowercase();
            plain.trim_end_matches(is_unit).parse().ok()
        }
    }
}
