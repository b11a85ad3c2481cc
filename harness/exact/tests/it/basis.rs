//! Tests which results the suite asserts in each dialect, and which it leaves open.

use crate::all_signatures;
use stickler_exact::{expected, value};
use stickler_types::{DialectName, ElementaryType, Value};

#[test]
fn the_three_dialects_of_ironplc_agree() {
    for signature in all_signatures(DialectName::IRONPLC_ED2) {
        let operands: Vec<Value> = signature.operands.iter().map(|&ty| some_value(ty)).collect();
        let of = |dialect| expected(&signature, &operands, dialect);
        let second = of(DialectName::IRONPLC_ED2);
        assert_eq!(of(DialectName::IRONPLC_ED3), second, "{signature}");
        assert_eq!(of(DialectName::IRONPLC_RUSTY), second, "{signature}");
    }
}

/// Returns some value of a type, other than zero.
fn some_value(ty: ElementaryType) -> Value {
    match ty {
        ElementaryType::String | ElementaryType::Wstring => Value::text(ty, vec![u16::from(b'1')]),
        ElementaryType::Real => Value::parse("REAL#1.5").unwrap(),
        ElementaryType::Lreal => Value::parse("LREAL#1.5").unwrap(),
        _ => Value::plain(ty, 1),
    }
}

#[test]
fn what_is_asserted_does_not_hang_on_open_choices() {
    // Where no document of a dialect chooses, an asserted value must be the same whatever is chosen.
    use stickler_types::{
        BitStringAsBool, BitStringText, BitsAsReal, ConversionChoices, MomentText, MomentUnits, OutOfRange,
        RealText, TextReading,
    };
    let texts = ["", " 7"]
        .into_iter()
        .chain("x 0 -1 42 1.5 -2.25 12abc 1e3 nan 99999999999999999999".split(' '));
    // The documents of the others state a few rows, or nothing.
    let states_all = |dialect: &DialectName| {
        use stickler_types::documents::DocumentedFunctions::{Ironplc, Matiec, Plcnext, Rusty, Strucpp};
        let functions = dialect.rules().documents.functions;
        matches!(functions, Ironplc | Matiec | Plcnext | Rusty | Strucpp)
    };
    for dialect in DialectName::ALL.into_iter().filter(states_all) {
        let own = dialect.rules().conversions;
        // matiec and PLCnext Engineer document what lies outside.
        let out_of_range = match dialect {
            DialectName::MATIEC | DialectName::PLCNEXT => own.out_of_range,
            _ => OutOfRange::Saturate,
        };
        let other = ConversionChoices {
            text_reading: TextReading::LeadingNumber,
            real_text: RealText::SignificantDigits(3),
            moment_text: MomentText::Components,
            bit_string_text: match own.bit_string_text {
                BitStringText::FullWidth => BitStringText::Shortest,
                BitStringText::Shortest | BitStringText::Decimal => BitStringText::FullWidth,
            },
            out_of_range,
            truncation_out_of_range: out_of_range,
            rounding: own.rounding,
            bits_as_integer: own.bits_as_integer,
            // RuSTy documents the first two, STruC++ the third, PLCnext Engineer all; a rule of ours and the ForgeIEC page speak of the second.
            bits_as_real: if matches!(dialect, DialectName::RUSTY | DialectName::PLCNEXT) {
                own.bits_as_real
            } else {
                BitsAsReal::Copy
            },
            bit_string_as_bool: if dialect == DialectName::STRUCPP {
                BitStringAsBool::LowestBit
            } else {
                own.bit_string_as_bool
            },
            moment_units: if matches!(dialect, DialectName::STRUCPP | DialectName::PLCNEXT) {
                own.moment_units
            } else {
                MomentUnits::DaysAndMilliseconds
            },
        };
        let mut asserted = 0;
        for signature in all_signatures(dialect) {
            let [from] = signature.operands[..] else { continue };
            let operands: Vec<Value> = if from.is_text() {
                let text = |text: &str| Value::text(from, text.encode_utf16().collect());
                texts.clone().map(text).collect()
            } else {
                let bits =
                    (0..64).flat_map(|bit| [1_i128 << bit, (1 << bit) - 1, -(1 << bit), (0x7FF << bit) + 3]);
                bits.map(|bits| Value::plain(from, from.wrap(bits))).collect()
            };
            for operand in &operands {
                let operands = std::slice::from_ref(operand);
                let given = expected(&signature, operands, dialect);
                if given.basis.is_some() {
                    let by_others = value(&signature, operands, &other);
                    assert_eq!(by_others, given.value, "{dialect} {signature} {operand}");
                    asserted += 1;
                }
            }
        }
        assert!(asserted > 5_000, "{dialect}: only {asserted}");
    }
}
