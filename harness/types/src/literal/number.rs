//! Integer literals: `1_000`, `16#FF_FF`, `-5`.

use super::LiteralError;

/// Reads an unsigned integer: decimal, or with base 2, 8 or 16 (`2#1010_0101`, `8#17`, `16#Ff`).
///
/// One underscore may stand between two digits. There is no sign, and no base but those three.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the value does not fit 128 bits.
///
/// Basis: iec-61131-3: Table 5 (numeric literals).
pub fn unsigned_integer(text: &str) -> Result<u128, LiteralError> {
    match text.as_bytes() {
        [b'1', b'6', b'#', digits @ ..] => digits_of_base(digits, 16, 3),
        [b'8', b'#', digits @ ..] => digits_of_base(digits, 8, 2),
        [b'2', b'#', digits @ ..] => digits_of_base(digits, 2, 2),
        digits => digits_of_base(digits, 10, 0),
    }
}

/// Reads an integer: an [`unsigned_integer`], or a decimal one with `+` or `-` directly in front.
///
/// A sign cannot stand before a base: the grammar has `signed_integer | binary_integer | octal_integer | hex_integer`, and only
/// the first of them is signed. So `INT#-16#5` is malformed. A based number is the number that its digits say, never a bit
/// pattern: `INT#16#FFFF` is 65535 and no `INT`.
///
/// # Errors
/// `Malformed` where the text is anything else; `Overflow` where the value does not fit 128 bits with sign.
///
/// Basis: iec-61131-3: Table 5 and the production `Int_Literal`.
pub fn integer(text: &str) -> Result<i128, LiteralError> {
    let (negative, magnitude) = match text.as_bytes() {
        [b'-', digits @ ..] => (true, digits_of_base(digits, 10, 1)?),
        [b'+', digits @ ..] => (false, digits_of_base(digits, 10, 1)?),
        _ => (false, unsigned_integer(text)?),
    };
    let value = if negative {
        0_i128.checked_sub_unsigned(magnitude)
    } else {
        i128::try_from(magnitude).ok()
    };
    value.ok_or(LiteralError::overflow(0, "128 bits"))
}

/// Returns the value of digits, where `at` is the offset of the first digit, for errors.
fn digits_of_base(digits: &[u8], base: u32, at: usize) -> Result<u128, LiteralError> {
    // Nineteen decimal digits always fit 64 bits, and nearly every literal is that short and has no underscore.
    if base == 10 && (1..=19).contains(&digits.len()) && digits.iter().all(u8::is_ascii_digit) {
        let value = digits
            .iter()
            .fold(0_u64, |value, digit| value * 10 + u64::from(digit - b'0'));
        return Ok(u128::from(value));
    }
    let length = digit_run(digits, base);
    if length == 0 || length < digits.len() {
        return Err(LiteralError::malformed(at + length, digit_name(base)));
    }
    let mut digits = digits.iter().filter_map(|&byte| digit_of(byte, base));
    let value = digits.try_fold(0_u128, |value, digit| {
        value.checked_mul(base.into())?.checked_add(digit.into())
    });
    value.ok_or(LiteralError::overflow(0, "128 bits"))
}

fn digit_of(byte: u8, base: u32) -> Option<u32> {
    char::from(byte).to_digit(base)
}

fn digit_name(base: u32) -> &'static str {
    match base {
        2 => "a binary digit",
        8 => "an octal digit",
        16 => "a hexadecimal digit",
        _ => "a digit",
    }
}

/// Returns the number of bytes at the start of `bytes` that are digits of `base`, with single underscores between them.
pub(super) fn digit_run(bytes: &[u8], base: u32) -> usize {
    let is_digit = |at: usize| bytes.get(at).is_some_and(|&byte| digit_of(byte, base).is_some());
    let mut end = 0;
    while is_digit(end) || end > 0 && bytes.get(end) == Some(&b'_') && is_digit(end + 1) {
        end += 1;
    }
    end
}
