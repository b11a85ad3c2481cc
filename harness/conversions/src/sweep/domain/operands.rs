//! Lists of chosen inputs followed by sampled ones, each found by its place.

use super::texts;
use stickler_types::{ElementaryType, Family, SplitMix64, Value};

/// The inputs of an operand, which are chosen as raw forms or as texts.
#[derive(Clone, PartialEq, Debug)]
pub struct Operands<C = u64> {
    ty: ElementaryType,
    chosen: Vec<C>,
    sampled: u64,
    random: SplitMix64,
}

/// The inputs of an operand of type STRING or WSTRING.
pub type TextOperands = Operands<Vec<u16>>;

impl<C> Operands<C> {
    /// Makes a list of chosen inputs, followed by a number of sampled ones.
    pub const fn new(ty: ElementaryType, chosen: Vec<C>, sampled: u64, random: SplitMix64) -> Operands<C> {
        Operands {
            ty,
            chosen,
            sampled,
            random,
        }
    }

    /// Returns the number of chosen inputs.
    pub fn chosen(&self) -> u64 {
        self.chosen.len() as u64
    }

    /// Returns the number of sampled inputs.
    pub const fn sampled(&self) -> u64 {
        self.sampled
    }

    /// Returns the number of inputs, chosen and sampled.
    pub fn count(&self) -> u64 {
        self.chosen().saturating_add(self.sampled)
    }

    /// Returns the chosen input at a place; `None` where the place is of a sampled one.
    fn chosen_at(&self, place: u64) -> Option<&C> {
        self.chosen.get(usize::try_from(place).ok()?)
    }
}

impl Operands {
    /// Returns the raw form at a place.
    pub fn raw(&self, place: u64) -> u64 {
        match self.chosen_at(place) {
            Some(raw) => *raw,
            None => sampled(self.ty, self.random, place),
        }
    }

    /// Returns the value at a place.
    pub fn value(&self, place: u64) -> Value {
        Value::plain(self.ty, self.raw(place))
    }
}

impl TextOperands {
    /// Returns the text at a place.
    pub fn value(&self, place: u64) -> Value {
        let units = match self.chosen_at(place) {
            Some(units) => units.clone(),
            None => texts::made_up(self.random.split(place)),
        };
        Value::text(self.ty, units)
    }
}

const MILLISECOND: i64 = 1_000_000;
const SECOND: i64 = 1_000 * MILLISECOND;
const DAY: i64 = 86_400 * SECOND;

/// Returns the raw form of the sampled value of a type at a place; the same source of random numbers gives the same value.
pub fn sampled(ty: ElementaryType, random: SplitMix64, place: u64) -> u64 {
    raw(ty, random.at(2 * place), random.at(2 * place + 1))
}

/// Returns the raw form of a value made from two random numbers, the first of which decides its kind and the other its digits;
/// 0 for a text. Random bits alone would seldom give a small integer or a real number near the integers.
fn raw(ty: ElementaryType, kind: u64, digits: u64) -> u64 {
    match ty.family() {
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString | Family::Character => {
            ty.wrap(any_length(kind, digits).into())
        }
        Family::Real => real(ty, kind, digits),
        Family::Duration | Family::DateAndTime => moment(kind, digits).cast_unsigned(),
        Family::Date => (moment(kind, digits) / DAY * DAY).cast_unsigned(),
        Family::TimeOfDay => moment(kind, digits).rem_euclid(DAY).cast_unsigned(),
        Family::Text => 0,
    }
}

/// Returns a random number of either sign and of any magnitude, each number of bits being equally likely.
fn any_length(kind: u64, digits: u64) -> i64 {
    let magnitude = (digits >> (kind % 64)).cast_signed();
    if kind & 64 == 0 {
        magnitude
    } else {
        magnitude.wrapping_neg()
    }
}

/// Returns the raw form of a random real number: a fourth of them are any bits at all, a fourth halves of integers, the rest
/// numbers that round to an integer of up to 70 bits.
fn real(ty: ElementaryType, kind: u64, digits: u64) -> u64 {
    let (fraction_bits, bias, sign) = match ty {
        ElementaryType::Real => (23, 127, 31),
        _ => (52, 1023, 63),
    };
    let all = if sign == 63 { u64::MAX } else { u32::MAX.into() };
    let choice = kind >> 8;
    let exponent = bias - 4 + choice % 74;
    let fraction = digits & ((1 << fraction_bits) - 1);
    match kind & 3 {
        0 => digits & all,
        1 => {
            // So many low bits of the fraction are cleared that the last one left stands for a half.
            let below_half = (fraction_bits + bias)
                .saturating_sub(exponent + 1)
                .min(fraction_bits);
            let cleared = fraction >> below_half << below_half;
            (kind >> 2 & 1) << sign | exponent << fraction_bits | cleared
        }
        _ => (kind >> 2 & 1) << sign | exponent << fraction_bits | fraction,
    }
}

/// Returns a random number of nanoseconds, whole milliseconds or whole seconds, of any magnitude.
fn moment(kind: u64, digits: u64) -> i64 {
    let any = any_length(kind >> 2, digits);
    match kind & 3 {
        0 => any,
        1 => any / SECOND * SECOND,
        _ => any / MILLISECOND * MILLISECOND,
    }
}
