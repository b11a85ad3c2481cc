//! Classifies texts by the ForgeIEC page: those that certainly spell a number, and those that certainly do not.
//!
//! The page says that STRING_TO_INT and STRING_TO_REAL read a number, and give 0 "on parse failure". It does not say what a number
//! looks like. So only what everybody would call a number is one here, and only what nobody would is none; all between is open:
//! blanks, a plus, zeros in front, underscores, bases, exponents, trailing text, numbers that do not fit.

use stickler_types::ElementaryType;

/// Returns whether a text is a number in plain notation that the type holds.
pub(super) fn is_plain_number(units: &[u16], to: ElementaryType) -> bool {
    let is_number = if to.is_real() {
        is_plain_real
    } else {
        is_plain_integer
    };
    ascii(units).is_some_and(|text| is_number(&text, to))
}

/// Returns the text as bytes, if it has ASCII characters only.
fn ascii(units: &[u16]) -> Option<Vec<u8>> {
    let bytes = units.iter().map(|&unit| u8::try_from(unit).ok());
    bytes.map(|byte| byte.filter(u8::is_ascii)).collect()
}

/// Returns whether the text is a whole number in plain notation, with an optional minus, in the range of the type. `-0` is
/// not.
fn is_plain_integer(text: &[u8], to: ElementaryType) -> bool {
    // No integer type has more digits.
    const MAX_DIGITS: usize = 20;
    let (negative, digits) = sign(text);
    if !is_plain_whole(digits) || digits.len() > MAX_DIGITS || (negative && digits == b"0") {
        return false;
    }
    let magnitude = digits
        .iter()
        .fold(0_i128, |number, digit| number * 10 + i128::from(digit - b'0'));
    to.holds(if negative { -magnitude } else { magnitude })
}

/// Returns whether the text is a number with a point and a fraction in plain notation, with an optional minus, and no more
/// digits than every number of the type has: 6 for REAL, 15 for LREAL. Such digits identify one number of the type. `-0.0`
/// is excluded, because no page says whether zero has a sign.
fn is_plain_real(text: &[u8], to: ElementaryType) -> bool {
    // Ten to the power of this, and of less, is a normal number of either type.
    const MAX_PLACES: usize = 30;
    let significant = if to == ElementaryType::Real { 6 } else { 15 };
    let (negative, digits) = sign(text);
    let Some(point) = digits.iter().position(|&byte| byte == b'.') else {
        return false;
    };
    let (whole, fraction) = (&digits[..point], &digits[point + 1..]);
    let is_plain = is_plain_whole(whole) && !fraction.is_empty() && fraction.iter().all(u8::is_ascii_digit);
    if !is_plain || whole.len() > MAX_PLACES || fraction.len() > MAX_PLACES {
        return false;
    }
    let digits = [whole, fraction].concat();
    let Some(first) = digits.iter().position(|&digit| digit != b'0') else {
        return !negative;
    };
    let last = digits.iter().rposition(|&digit| digit != b'0').unwrap_or(first);
    last - first < significant
}

/// Returns whether these are decimal digits without a leading zero; `0` alone is allowed.
fn is_plain_whole(digits: &[u8]) -> bool {
    match digits {
        [b'0'] => true,
        [b'1'..=b'9', rest @ ..] => rest.iter().all(u8::is_ascii_digit),
        _ => false,
    }
}

fn sign(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', digits @ ..] => (true, digits),
        digits => (false, digits),
    }
}

/// Returns whether the text has no digit, or begins with a letter; `false` for a typed literal (`INT#5`), and for a real
/// also for the words that some systems read (`inf`, `nan`), with or without a sign or blanks.
pub(super) fn is_no_number(units: &[u16], to: ElementaryType) -> bool {
    let Some(text) = ascii(units) else { return false };
    let text = &text[..];
    let has_digits = text.iter().any(u8::is_ascii_digit);
    let begins_with_letter = text.first().is_some_and(u8::is_ascii_alphabetic);
    if has_digits && (!begins_with_letter || text.contains(&b'#')) {
        return false;
    }
    !(to.is_real() && begins_with_a_word(text))
}

fn begins_with_a_word(text: &[u8]) -> bool {
    let start = text
        .iter()
        .position(|byte| !matches!(byte, b' ' | b'\t' | b'\n' | b'\r' | b'+' | b'-'));
    let text = &text[start.unwrap_or(text.len())..];
    [b"inf", b"nan"].iter().any(|word| {
        text.get(..word.len())
            .is_some_and(|beginning| beginning.eq_ignore_ascii_case(*word))
    })
}
