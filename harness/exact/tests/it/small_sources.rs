//! Converts every value of every type of at most 16 bits by every function, and compares with the simplest possible
//! computation.

use crate::all_signatures;
use stickler_exact::{Operation, Signature, value};
use stickler_types::{DialectName, ElementaryType, Family, Value};

const DIALECT: DialectName = DialectName::IRONPLC_ED3;

/// Returns the number that a source of at most 16 bits represents.
fn number(raw: u64) -> i64 {
    raw.cast_signed()
}

/// Returns the raw form of a number in an integer, bit string or character, by adding or subtracting 2^n until it fits.
fn wrapped(mut number: i64, to: ElementaryType) -> u64 {
    let modulus = 1_i64.checked_shl(to.bits()).filter(|_| to.bits() < 64);
    let Some(modulus) = modulus else {
        // In 64 bits a negative number is its own two's complement, and every other number is itself.
        return number.cast_unsigned();
    };
    let least = if to.is_signed() { -(modulus / 2) } else { 0 };
    while number < least {
        number += modulus;
    }
    while number >= least + modulus {
        number -= modulus;
    }
    number.cast_unsigned()
}

/// Returns the raw form of a number that needs no rounding, by doubling it until its highest bit is where the format has
/// it.
fn as_real(number: i64, to: ElementaryType) -> u64 {
    let (fraction_bits, bias, sign_bit) = match to {
        ElementaryType::Real => (23, 127, 31),
        _ => (52, 1023, 63),
    };
    if number == 0 {
        return 0;
    }
    let (mut significand, mut exponent) = (number.unsigned_abs(), bias + fraction_bits);
    while significand < 1 << fraction_bits {
        significand *= 2;
        exponent -= 1;
    }
    u64::from(number < 0) << sign_bit | exponent << fraction_bits | (significand - (1 << fraction_bits))
}

/// Returns the result of a conversion of a number between types that are not texts.
fn simple(number: i64, to: ElementaryType) -> u64 {
    const DAY: i64 = 86_400_000_000_000;
    match to.family() {
        Family::Boolean => u64::from(number != 0),
        Family::Signed | Family::Unsigned | Family::BitString | Family::Character => wrapped(number, to),
        Family::Real => as_real(number, to),
        Family::Duration => (number * 1_000_000).cast_unsigned(),
        Family::TimeOfDay => {
            let mut time = number * 1_000_000;
            while time < 0 {
                time += DAY;
            }
            time.cast_unsigned()
        }
        Family::DateAndTime => (number * 1_000_000_000).cast_unsigned(),
        Family::Date => {
            // 16 bits of seconds reach no farther than the day before and the epoch itself.
            if number < 0 { (-DAY).cast_unsigned() } else { 0 }
        }
        Family::Text => unreachable!("texts are looked at apart"),
    }
}

/// Returns the decimal digits of a number modulo 10^n, where n is the number of digits of the bit string; adds 10^n to a
/// negative number until it is not negative.
fn as_bcd(mut number: i64, to: ElementaryType) -> u64 {
    let digits = to.bits() as usize / 4;
    while number < 0 {
        number += 10_i64.pow(to.bits() / 4);
    }
    let written = format!("{number:0>digits$}");
    u64::from_str_radix(&written[written.len() - digits..], 16).unwrap()
}

/// Returns the number that hexadecimal digits spell when read as decimal ones, each with its value.
fn from_bcd(raw: u64) -> i64 {
    format!("{raw:X}").chars().fold(0, |number, digit| {
        number * 10 + i64::from(digit.to_digit(16).unwrap())
    })
}

fn by_hand(signature: &Signature, raw: u64) -> Value {
    let (from, to) = (signature.operands[0], signature.result);
    match signature.operation {
        Operation::FromBcd => Value::plain(to, wrapped(from_bcd(raw), to)),
        Operation::ToBcd => Value::plain(to, as_bcd(number(raw), to)),
        _ if to.is_text() => Value::text(to, text(raw, from, to)),
        _ if from.is_character() && to.is_character() => {
            let unit = if to == ElementaryType::Char && raw > 255 {
                u64::from(b'?')
            } else {
                raw
            };
            Value::plain(to, unit)
        }
        _ => Value::plain(to, simple(number(raw), to)),
    }
}

fn text(raw: u64, from: ElementaryType, to: ElementaryType) -> Vec<u16> {
    let text = match from.family() {
        Family::Character if to == ElementaryType::String && raw > 255 => "?".to_owned(),
        Family::Character => return vec![u16::try_from(raw).unwrap()],
        Family::Boolean => ["FALSE", "TRUE"][usize::try_from(raw).unwrap()].to_owned(),
        _ if from == ElementaryType::Byte => format!("16#{raw:02X}"),
        _ if from == ElementaryType::Word => format!("16#{raw:04X}"),
        _ => number(raw).to_string(),
    };
    text.bytes().map(u16::from).collect()
}

#[test]
fn every_value_of_every_small_type_through_every_function() {
    let choices = DIALECT.rules().conversions;
    let mut count = 0;
    for signature in all_signatures(DIALECT) {
        let from = signature.operands[0];
        if !(1..=16).contains(&from.bits()) || signature.operands.len() > 1 {
            continue;
        }
        let name = &signature.function;
        // The overloaded names do the same as the others, which a sample shows.
        let step = if name.starts_with("TO_") { 97 } else { 1 };
        for bits in (0..1_i128 << from.bits()).step_by(step) {
            let raw = from.wrap(bits);
            let given = value(&signature, &[Value::plain(from, raw)], &choices);
            assert_eq!(given, by_hand(&signature, raw), "{name} of {raw:X}");
            count += 1;
        }
    }
    assert!(count > 5_000_000, "{count}");
}
