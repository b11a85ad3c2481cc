//! Dialects that override rules of another one.

use std::collections::BTreeMap;
use stickler_types::definition::ConversionOverrides;
use stickler_types::definition::Flag;
use stickler_types::dialect::{PartialAccess, ThirdEditionTypes};
use stickler_types::{
    Definition, Dialect, DialectName, ElementaryType, MatrixWord, OutOfRange, RealText, Rounding, Stated,
};

#[test]
fn a_definition_overrides_its_base_and_nothing_else() {
    fn stated<T>(value: T) -> Stated<T> {
        Stated {
            value,
            basis: Some("mine: test".to_owned()),
        }
    }
    let flags = Flag::ALL
        .iter()
        .map(|flag| (*flag, stated(*flag == Flag::LineComments)));
    let pair = |from, to, cell| ((from, to), stated(cell));
    let name = DialectName::define(Definition {
        implicit: BTreeMap::from([
            pair(ElementaryType::Int, ElementaryType::Bool, MatrixWord::Yes),
            pair(ElementaryType::Sint, ElementaryType::Int, MatrixWord::No),
            pair(ElementaryType::Bool, ElementaryType::Int, MatrixWord::Open),
        ]),
        flags: flags.collect(),
        conversions: ConversionOverrides {
            rounding: Some(stated(Rounding::HalfAwayFromZero)),
            out_of_range: Some(stated(OutOfRange::Saturate)),
            ..ConversionOverrides::default()
        },
        ..Definition::new("reference-overrides", DialectName::IRONPLC_ED3, "here")
    })
    .expect("the name is free");
    let mine = Dialect::of(name);
    assert!(mine.line_comments && !mine.nested_comments && !mine.bit_access && mine.only_standard_rounding);
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
