//! Dialects that override rules of another one.

use stickler_types::dialect::{PartialAccess, ThirdEditionTypes};
use stickler_types::{Dialect, DialectName, ElementaryType, MatrixWord, OutOfRange, RealText, Rounding};

#[test]
fn a_definition_overrides_its_base_and_nothing_else() {
    let stated =
        |dialect: Dialect, (key, value): (&str, &str)| dialect.stating(key, value, "mine: test").expect(key);
    let mine = [
        ("flags.line-comments", "true"),
        ("flags.nested-comments", "false"),
        ("flags.bit-access", "false"),
        ("flags.rounding-functions", "false"),
        ("flags.integer-literal-as-real", "false"),
        ("flags.third-edition-types", "false"),
        ("flags.allow-partial-access-syntax", "false"),
        ("conversions.rounding", "'half-away-from-zero'"),
        ("conversions.out-of-range", "'saturate'"),
    ]
    .into_iter()
    .fold(
        Dialect::custom("reference-overrides", DialectName::IRONPLC_ED3, "here"),
        stated,
    );
    let mine = [
        ((ElementaryType::Int, ElementaryType::Bool), MatrixWord::Yes),
        ((ElementaryType::Sint, ElementaryType::Int), MatrixWord::No),
        ((ElementaryType::Bool, ElementaryType::Int), MatrixWord::Open),
    ]
    .into_iter()
    .fold(mine, |mine, (pair, word)| {
        mine.stating_cell(pair, word, "mine: test")
    });
    let name = DialectName::define(mine).expect("the name is free");
    let mine = Dialect::of(name);
    assert!(mine.line_comments && !mine.nested_comments && !mine.bit_access && !mine.rounding_functions);
    assert!(!mine.integer_literal_as_real && mine.third_edition_types == ThirdEditionTypes::None);
    assert_eq!(mine.partial_access, PartialAccess::Disabled);
    assert_eq!(mine.conversions.rounding, Rounding::HalfAwayFromZero);
    assert_eq!(mine.conversions.out_of_range, OutOfRange::Saturate);
    assert_eq!(mine.conversions.real_text, RealText::Shortest);
    let accepts = |from: &str, into: &str, dialect| {
        let text = format!("PROGRAM main\nVAR\n a : {from};\n b : {into};\nEND_VAR\n b := a;\nEND_PROGRAM\n");
        stickler_reference::errors(&text, dialect).is_empty()
    };
    for (from, into, in_mine, in_base) in [
        ("INT", "BOOL", true, false),
        ("SINT", "INT", false, true),
        ("BOOL", "INT", true, false),
        ("INT", "DINT", true, true),
        ("DINT", "INT", false, false),
    ] {
        assert_eq!(accepts(from, into, name), in_mine, "{from} to {into}");
        assert_eq!(
            accepts(from, into, DialectName::IRONPLC_ED3),
            in_base,
            "{from} to {into}"
        );
    }
}
