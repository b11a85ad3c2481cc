//! Tests that written texts read back, that the literals of the types crate are read alike, and that texts keep their
//! limit.

use stickler_exact::{expected, signatures, value};
use stickler_types::{
    BitStringText, ConversionChoices, DialectName, ElementaryType, Family, RealText, SplitMix64, TextReading,
    Value, literal,
};

const DIALECT: DialectName = DialectName::IEC_ED3;

fn call(function: &str, operand: &Value, choices: &ConversionChoices) -> Value {
    let found = signatures(function, DIALECT);
    value(&found[0], std::slice::from_ref(operand), choices)
}

fn string(text: &str) -> Value {
    Value::text(ElementaryType::String, text.bytes().map(u16::from).collect())
}

/// Returns raw forms of a type that is not a text: all where it has at most 16 bits, and otherwise its limits, powers of two, and
/// scattered ones of any size.
fn raw_forms(ty: ElementaryType) -> Vec<u64> {
    if ty.bits() <= 16 {
        return (0..1_i128 << ty.bits()).map(|bits| ty.wrap(bits)).collect();
    }
    const DAY: i64 = 86_400_000_000_000;
    let powers = (0..64).flat_map(|bit| [1 << bit, (1_u64 << bit).wrapping_neg(), (1 << bit) - 1]);
    let some = SplitMix64::new(1)
        .numbers()
        .take(3_000)
        .enumerate()
        .map(|(n, bits)| (bits.cast_signed() >> (n % 64)).cast_unsigned());
    let fitting = |raw: u64| match ty.family() {
        Family::Date => (raw.cast_signed() / DAY * DAY).cast_unsigned(),
        Family::TimeOfDay => raw.cast_signed().rem_euclid(DAY).cast_unsigned(),
        _ => ty.wrap(raw.into()),
    };
    powers.chain(some).map(fitting).collect()
}

#[test]
fn what_is_written_reads_back() {
    let long = DIALECT.rules().conversions;
    let short = ConversionChoices {
        real_text: RealText::SignificantDigits(17),
        bit_string_text: BitStringText::Shortest,
        text_reading: TextReading::LeadingNumber,
        ..long
    };
    for ty in ElementaryType::ALL.into_iter().filter(|ty| !ty.is_text()) {
        for text in [ElementaryType::String, ElementaryType::Wstring] {
            let (write, read) = (format!("{ty}_TO_{text}"), format!("{text}_TO_{ty}"));
            for raw in raw_forms(ty) {
                if (ty, text) == (ElementaryType::Wchar, ElementaryType::String) && raw > 0xFF {
                    continue;
                }
                let original = Value::plain(ty, raw);
                for choices in [&long, &short] {
                    let written = call(&write, &original, choices);
                    assert_eq!(call(&read, &written, choices), original, "{written}");
                }
            }
        }
    }
}

#[test]
fn what_is_written_is_the_canonical_literal_but_for_the_prefix() {
    let choices = DIALECT.rules().conversions;
    for ty in ElementaryType::ALL {
        if ty.is_text() || ty.is_character() {
            continue;
        }
        for raw in raw_forms(ty) {
            let original = Value::plain(ty, raw);
            let Value::Text { units, .. } = call(&format!("{ty}_TO_STRING"), &original, &choices) else {
                panic!("{original} gave no text");
            };
            let text = String::from_utf16(&units).unwrap();
            let canonical = original.to_string();
            let literal = canonical.strip_prefix(&format!("{ty}#")).unwrap();
            let bare = if ty.is_moment() {
                text.split_once('#').unwrap().1
            } else {
                &text
            };
            assert_eq!(bare, literal);
        }
    }
}

/// Returns texts composed from pieces of literals; most of them are not literals.
fn concoctions() -> impl Iterator<Item = String> {
    const PIECES: [&str; 40] = [
        "1", "2", "0", "9", "-", "+", ".", "e", "E", "16#", "2#", "8#", "_", " ", ":", "ms", "s", "h", "d",
        "ns", "us", "m", "2024", "1970", "-02-", "-2-", "29", "12:", "34:", "56", "TRUE", "NaN", "Infinity",
        "a", "F", "#", "00", "5", "3.5", "_0",
    ];
    let mut source = SplitMix64::new(1).numbers();
    let mut next = move || source.next().unwrap_or_default() >> 7;
    std::iter::repeat_with(move || {
        let pieces = (0..next() % 8).map(|_| PIECES[(next() % 40) as usize]);
        pieces.collect::<String>()
    })
}

/// Returns the value of a text without its blanks by the literal parsers of the types crate, which have other limits.
fn by_literals(text: &str, ty: ElementaryType) -> Value {
    let text = text.trim_matches(' ');
    let parsed = |text: &str| Value::parse(&format!("{ty}#{text}")).unwrap_or(Value::plain(ty, 0));
    match ty.family() {
        Family::Boolean => {
            let is_true = text.eq_ignore_ascii_case("TRUE");
            let number = literal::integer(text);
            Value::plain(ty, u64::from(is_true || number.is_ok_and(|number| number != 0)))
        }
        Family::Signed | Family::Unsigned | Family::BitString => {
            Value::plain(ty, literal::integer(text).map_or(0, |number| ty.wrap(number)))
        }
        Family::Real => {
            // A point is at will where a number is read, but not in a literal.
            let (digits, exponent) = text.find(['e', 'E']).map_or((text, ""), |at| text.split_at(at));
            let needs_point = digits.ends_with(|last: char| last.is_ascii_digit()) && !digits.contains('.');
            let with_point = format!("{digits}{}{exponent}", if needs_point { ".0" } else { "" });
            match literal::real(&with_point, ty) {
                Err(literal::LiteralError::Overflow { .. }) if text.starts_with('-') => parsed("-Infinity"),
                Err(literal::LiteralError::Overflow { .. }) => parsed("Infinity"),
                _ => parsed(&with_point),
            }
        }
        Family::Date => moment(ty, literal::date(text)),
        Family::TimeOfDay => moment(ty, literal::time_of_day(text)),
        _ => parsed(text),
    }
}

/// Returns the date or time of day that a literal stands for, and 0 where there is none.
fn moment(ty: ElementaryType, nanoseconds: Result<i64, literal::LiteralError>) -> Value {
    Value::plain(ty, nanoseconds.map_or(0, i64::cast_unsigned))
}

#[test]
fn texts_are_read_as_the_literals_of_the_types_crate_are() {
    let choices = DIALECT.rules().conversions;
    let mut readable = 0;
    for text in concoctions().take(220_000) {
        for ty in [
            ElementaryType::Bool,
            ElementaryType::Int,
            ElementaryType::Lword,
            ElementaryType::Real,
            ElementaryType::Lreal,
            ElementaryType::Time,
            ElementaryType::Date,
            ElementaryType::Tod,
            ElementaryType::Ldt,
        ] {
            let given = call(&format!("STRING_TO_{ty}"), &string(&text), &choices);
            assert_eq!(given, by_literals(&text, ty), "{text:?} as {ty}");
            readable += u32::from(given != Value::plain(ty, 0));
        }
    }
    assert!(readable > 50_000, "only {readable}");
}

#[test]
fn joining_and_taking_apart_are_inverse() {
    let choices = DIALECT.rules().conversions;
    for step in -200..=200_i64 {
        // A prime number of nanoseconds, so that all kinds of days and times come up.
        let nanoseconds = step * 45_999_999_999_999_997;
        let moment = Value::plain(ElementaryType::Ldt, nanoseconds.cast_unsigned());
        let parts = ["LDT_TO_LDATE", "LDT_TO_LTOD"].map(|function| call(function, &moment, &choices));
        let join = &signatures("CONCAT_LDATE_LTOD", DIALECT)[0];
        assert_eq!(value(join, &parts, &choices), moment);
    }
}

#[test]
fn operands_that_do_not_fit_give_the_default() {
    let literal = |text: &str| Value::parse(text).expect("a typed literal");
    let signature = &signatures("INT_TO_DINT", DIALECT)[0];
    for operands in [
        vec![],
        vec![literal("REAL#5.0")],
        vec![literal("INT#5"), literal("INT#5")],
        vec![Value::enumerated("COLOR", "RED")],
    ] {
        let given = value(signature, &operands, &DIALECT.rules().conversions);
        assert_eq!(given, Value::plain(ElementaryType::Dint, 0));
        assert_eq!(expected(signature, &operands, DIALECT).basis, None);
    }
}
