//! Duration literals: `1d2h3m4s5ms6us7ns`, `-1.5ms`.

use super::LiteralError;
use super::number::digit_run;
use std::fmt;

/// The units of a duration from the greatest to the least, with their nanoseconds.
pub const UNITS: [(&str, u64); 7] = [
    ("d", 86_400_000_000_000),
    ("h", 3_600_000_000_000),
    ("m", 60_000_000_000),
    ("s", 1_000_000_000),
    ("ms", 1_000_000),
    ("us", 1_000),
    ("ns", 1),
];

/// Reads a duration into nanoseconds, such as `1d2h3m4s5ms6us7ns`, `-25h_15m` or `1.5d`.
///
/// Units in any case, from the greatest to the least, each at most once; a fraction only in the last; one underscore may stand
/// between two digits and between two parts. The standard says that the first unit may overflow (`25h_15m`) and is silent on the
/// others, and its grammar sets no bound: `5m70s` is read as 370 s. The sum is exact; what is left below one nanosecond is cut
/// off toward zero.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the duration does not fit 64 bits with sign.
///
/// Basis: iec-61131-3: Table 8 (duration literals) and the production `Interval`.
pub fn duration(text: &str) -> Result<i64, LiteralError> {
    i64::try_from(wide_duration(text)?).map_err(|_| LiteralError::overflow(0, "a duration"))
}

/// Reads a duration as [`duration`] does, also one that does not fit 64 bits.
///
/// # Errors
/// `Malformed` as [`duration`]; `Overflow` where the duration does not fit 128 bits with sign.
pub fn wide_duration(text: &str) -> Result<i128, LiteralError> {
    let bytes = text.as_bytes();
    let negative = bytes.first() == Some(&b'-');
    let mut at = usize::from(matches!(bytes.first(), Some(b'+' | b'-')));
    let mut total = 0_u128;
    let mut units = &UNITS[..];
    loop {
        let part = DurationPart::read(bytes, at, units)?;
        total = total.saturating_add(part.nanoseconds);
        units = part.lesser;
        at = part.end;
        if at == bytes.len() {
            break;
        }
        if part.has_fraction {
            return Err(LiteralError::malformed(
                at,
                "the end of the duration, for only its last unit has a fraction",
            ));
        }
        at += usize::from(bytes[at] == b'_');
    }
    let magnitude = i128::try_from(total).map_err(|_| LiteralError::overflow(0, "a duration"))?;
    Ok(if negative { -magnitude } else { magnitude })
}

/// One number of a duration with its unit.
struct DurationPart {
    /// The amount, cut off toward zero, and saturated far beyond what a duration can hold.
    nanoseconds: u128,
    has_fraction: bool,
    /// The units that may still follow this part.
    lesser: &'static [(&'static str, u64)],
    /// The offset after the unit.
    end: usize,
}

impl DurationPart {
    fn read(bytes: &[u8], start: usize, units: &'static [(&'static str, u64)]) -> Result<Self, LiteralError> {
        let whole = digits_at(bytes, start)?;
        let mut at = start + whole.len();
        let mut fraction: &[u8] = &[];
        if bytes.get(at) == Some(&b'.') {
            fraction = digits_at(bytes, at + 1)?;
            at += 1 + fraction.len();
        }
        let letters = bytes[at..]
            .iter()
            .take_while(|byte| byte.is_ascii_alphabetic())
            .count();
        let word = &bytes[at..at + letters];
        let place = units
            .iter()
            .position(|(unit, _)| unit.as_bytes().eq_ignore_ascii_case(word))
            .ok_or(LiteralError::malformed(
                at,
                "a unit of time, in the order d, h, m, s, ms, us, ns",
            ))?;
        let (_, unit) = units[place];
        let whole = whole.iter().filter(|byte| byte.is_ascii_digit());
        let whole = whole.fold(0_u128, |value, digit| {
            value.saturating_mul(10).saturating_add(u128::from(digit - b'0'))
        });
        Ok(DurationPart {
            nanoseconds: whole
                .saturating_mul(u128::from(unit))
                .saturating_add(u128::from(fraction_of(fraction, unit))),
            has_fraction: !fraction.is_empty(),
            lesser: &units[place + 1..],
            end: at + letters,
        })
    }
}

/// Returns the decimal digits, with underscores between them, that must be present at `at`.
pub(super) fn digits_at(bytes: &[u8], at: usize) -> Result<&[u8], LiteralError> {
    let rest = &bytes[at..];
    match digit_run(rest, 10) {
        0 => Err(LiteralError::malformed(at, "a digit")),
        length => Ok(&rest[..length]),
    }
}

/// Returns the decimal fraction with these digits of `unit`, rounded down to a whole number; exact for any number of
/// digits.
///
/// Horner's rule from the last digit, on whole numbers: ⌊(n + x) / 10⌋ = ⌊(n + ⌊x⌋) / 10⌋ for a whole n, so that cutting off at
/// each step loses nothing.
pub(super) fn fraction_of(digits: &[u8], unit: u64) -> u64 {
    let digits = digits.iter().rev().filter(|byte| byte.is_ascii_digit());
    digits.fold(0, |rest, digit| (rest + u64::from(digit - b'0') * unit) / 10)
}

/// Writes nanoseconds as canonical milliseconds: `1500ms`, `-1.5ms`, `0.000001ms`.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_milliseconds(out: &mut impl fmt::Write, nanoseconds: i64) -> fmt::Result {
    let sign = if nanoseconds < 0 { "-" } else { "" };
    let magnitude = nanoseconds.unsigned_abs();
    write!(out, "{sign}{}", magnitude / 1_000_000)?;
    write_fraction(out, magnitude % 1_000_000, 6)?;
    out.write_str("ms")
}

/// Writes nanoseconds as canonical nanoseconds: `1500000000ns`.
///
/// Basis: harness/engines/README.md (how values are written).
pub fn write_nanoseconds(out: &mut impl fmt::Write, nanoseconds: i128) -> fmt::Result {
    write!(out, "{nanoseconds}ns")
}

/// Writes `.` and `fraction` as `digits` decimal digits without trailing zeros; writes nothing if the fraction is zero.
pub(super) fn write_fraction(out: &mut impl fmt::Write, mut fraction: u64, mut digits: usize) -> fmt::Result {
    if fraction == 0 {
        return Ok(());
    }
    while fraction.is_multiple_of(10) {
        fraction /= 10;
        digits -= 1;
    }
    write!(out, ".{fraction:0digits$}")
}
