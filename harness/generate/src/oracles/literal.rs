//! Oracle `literal`: a literal that reads has one canonical spelling, which reads to the same value.

use super::numerals::{self, DecimalNumber};
use super::{InputOutcome, Judged, failed};
use num_bigint::BigInt;
use stickler_types::{ElementaryType, Family, LiteralError, Value, literal};

/// Judges a literal by a reader of this crate's own, and its canonical spelling by both readers.
///
/// If the first byte names a type by its index in [`ElementaryType::ALL`] (a control character, with which no literal
/// begins), the following bytes are a value, which is written and read back; otherwise the bytes are a text.
///
/// Basis: harness/engines/README.md (how values are written); iec-61131-3: Tables 5 to 9.
///
/// # Errors
/// Symptoms, each followed by the type: `value`, `accepted`, `rejected`, `canonical`; `place` for the offset of an error.
pub(super) fn judge(data: &[u8]) -> Judged {
    if let Some((first, rest)) = data.split_first()
        && let Some(ty) = ElementaryType::ALL.get(usize::from(*first))
    {
        check_written(&value_of(*ty, rest))?;
        return Ok(InputOutcome::Checked);
    }
    let Ok(text) = std::str::from_utf8(data) else {
        return Ok(InputOutcome::Skipped("no text"));
    };
    check_typed(text)?;
    check_untyped(text)?;
    Ok(InputOutcome::Checked)
}

/// Creates a value of a type in its canonical raw form from any bytes.
fn value_of(ty: ElementaryType, bytes: &[u8]) -> Value {
    const DAY: i64 = 86_400_000_000_000;
    if ty.is_text() {
        let wide = ty == ElementaryType::Wstring;
        let units = bytes.chunks(1 + usize::from(wide));
        return Value::text(
            ty,
            units
                .map(|unit| unit.iter().fold(0, |all, byte| all << 8 | u16::from(*byte)))
                .collect(),
        );
    }
    let mut eight = [0; 8];
    eight.iter_mut().zip(bytes).for_each(|(to, from)| *to = *from);
    let raw = i64::from_le_bytes(eight);
    let raw = match ty.family() {
        Family::Date => raw / DAY * DAY,
        Family::TimeOfDay => raw.rem_euclid(DAY),
        _ => raw,
    };
    Value::plain(ty, ty.wrap(raw.into()))
}

/// Checks that the canonical spelling of a value reads to that value.
fn check_written(value: &Value) -> Judged<()> {
    let written = value.to_string();
    let wrong = |what: &str| {
        failed(
            format!("canonical:{}", value.type_name().to_ascii_uppercase()),
            format!("the canonical spelling {written} {what}"),
        )
    };
    match Value::parse(&written) {
        Err(error) => wrong(&format!("of {value:?} is not read: {error}")),
        Ok(again) if again != *value => wrong(&format!("of {value:?} reads to {again:?}")),
        Ok(again) if again.to_string() != written => wrong(&format!("is spelled {again} when read")),
        Ok(_) if expected_spelling(value).is_some_and(|spelling| spelling != written) => {
            wrong(&format!("of {value:?} is not the canonical one"))
        }
        Ok(_) => Ok(()),
    }
}

/// Returns the canonical spelling of an integer or bit string.
///
/// Basis: harness/engines/README.md (how values are written: `INT#-5`; upper-case digits, full width).
fn expected_spelling(value: &Value) -> Option<String> {
    let &Value::Plain { ty, raw } = value else {
        return None;
    };
    match ty.family() {
        Family::Signed => Some(format!("{ty}#{}", raw.cast_signed())),
        Family::Unsigned => Some(format!("{ty}#{raw}")),
        Family::BitString => Some(format!("{ty}#16#{raw:0width$X}", width = ty.bits() as usize / 4)),
        Family::Boolean => Some(format!("{ty}#{}", if raw == 1 { "TRUE" } else { "FALSE" })),
        _ => None,
    }
}

/// Checks the text as a typed literal.
fn check_typed(text: &str) -> Judged<()> {
    let got = Value::parse(text);
    match &got {
        Ok(value) => check_written(value)?,
        Err(error) => check_offset(text, error)?,
    }
    let Some((prefix, rest)) = text.split_once('#') else {
        return Ok(());
    };
    let Some(ty) = NUMBERS
        .into_iter()
        .find(|ty| ty.name().eq_ignore_ascii_case(prefix))
    else {
        return Ok(());
    };
    let got = got.map(|value| match value {
        Value::Plain { ty: of, raw } if of == ty => Some(raw),
        _ => None,
    });
    if ty.is_real() {
        let is_word = ["NaN", "Infinity", "-Infinity"]
            .iter()
            .any(|word| word.eq_ignore_ascii_case(rest));
        return if is_word {
            Ok(())
        } else {
            check_real(text, numerals::real(rest), ty, got)
        };
    }
    let said = match ty.family() {
        Family::BitString => numerals::unsigned(rest),
        _ => numerals::integer(rest),
    };
    let (least, greatest) = ty.integer_range().unwrap_or_default();
    let raw = |number: BigInt| {
        (number >= least.into() && number <= greatest.into()).then(|| ty.wrap(low_bits(&number)))
    };
    check_number(text, ty.name(), said.map(raw), got)
}

/// The types whose literals the second reader knows.
const NUMBERS: [ElementaryType; 14] = {
    use ElementaryType::*;
    [
        Sint, Int, Dint, Lint, Usint, Uint, Udint, Ulint, Byte, Word, Dword, Lword, Real, Lreal,
    ]
};

/// Truncates a number to 128 bits.
fn low_bits(number: &BigInt) -> i128 {
    i128::try_from(number).unwrap_or_default()
}

/// Checks the text as an untyped literal.
fn check_untyped(text: &str) -> Judged<()> {
    let fits = |number: BigInt| i128::try_from(number).ok();
    let got = literal::integer(text).map(Some);
    check_number(text, "integer", numerals::integer(text).map(fits), got)?;
    let fits = |number: BigInt| u128::try_from(number).ok();
    let got = literal::unsigned_integer(text).map(Some);
    check_number(text, "unsigned", numerals::unsigned(text).map(fits), got)?;
    let said = numerals::real(text);
    for ty in [ElementaryType::Real, ElementaryType::Lreal] {
        check_real(text, said.clone(), ty, literal::real(text, ty).map(Some))?;
    }
    Ok(())
}

/// Compares the result of the second reader (`None`: no number; `Some(None)`: one that does not fit) with that of the first.
fn check_number<T: PartialEq + std::fmt::Debug>(
    text: &str,
    ty: &str,
    said: Option<Option<T>>,
    got: Result<Option<T>, LiteralError>,
) -> Judged<()> {
    let symptom = match (&said, &got) {
        (None, Err(LiteralError::Malformed { .. })) | (Some(None), Err(LiteralError::Overflow { .. })) => {
            return Ok(());
        }
        (Some(Some(said)), Ok(Some(got))) if said == got => return Ok(()),
        (Some(Some(_)), Ok(_)) => "value",
        (_, Ok(_)) => "accepted",
        (_, Err(_)) => "rejected",
    };
    let message = format!("`{text}` as {ty} is {said:?} by exact arithmetic, and {got:?}");
    failed(format!("{symptom}:{ty}"), message)
}

fn check_real(
    text: &str,
    said: Option<DecimalNumber>,
    ty: ElementaryType,
    got: Result<Option<u64>, LiteralError>,
) -> Judged<()> {
    check_number(text, ty.name(), said.map(|decimal| decimal.raw(ty)), got)
}

/// Checks that an error points into the text.
fn check_offset(text: &str, error: &LiteralError) -> Judged<()> {
    if text.is_char_boundary(error.offset()) {
        return Ok(());
    }
    let message = format!("the error `{error}` of `{text}` does not lie between its characters");
    failed("place", message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn literals_of_every_kind_hold() {
        for text in include_str!("literals.txt").lines() {
            assert_eq!(judge(text.as_bytes()), Ok(InputOutcome::Checked), "{text}");
        }
    }

    #[test]
    fn every_value_is_written_and_read_back() {
        for (place, _) in ElementaryType::ALL.iter().enumerate() {
            for raw in [0, 1, 1 << 31, i64::MIN, i64::MAX, -1, -86_400_000_000_001] {
                let mut data = vec![place as u8];
                data.extend(raw.to_le_bytes());
                assert_eq!(judge(&data), Ok(InputOutcome::Checked), "{data:?}");
            }
        }
    }

    #[test]
    fn another_number_is_a_failure() {
        let failure = check_number("5", "INT", Some(Some(5)), Ok(Some(6))).expect_err("another number");
        assert_eq!(failure.symptom, "value:INT");
        let failure = check_number("5", "INT", None, Ok(Some(5))).expect_err("no number at all");
        assert_eq!(failure.symptom, "accepted:INT");
        let one = numerals::real("1.0");
        assert!(check_real("1.0", one, ElementaryType::Real, Ok(Some(0))).is_err());
    }
}
