//! Features of single constructs; those of the minimal programs of `features.toml` are tested in the crate `suite`.

use super::*;
use stickler_types::DialectName;

fn of(declarations: &str, statements: &str) -> Vec<String> {
    let text = format!("PROGRAM p {declarations} {statements} END_PROGRAM");
    let found = features(&text, Dialect::of(DialectName::IRONPLC_ED2));
    found.into_iter().map(Cow::into_owned).collect()
}

#[test]
fn a_plain_program_uses_no_feature() {
    assert_eq!(
        of("VAR x : INT; b : BOOL; END_VAR", "x := 5; b := TRUE; x := -1;"),
        [] as [&str; 0]
    );
}

#[test]
fn features_do_not_depend_on_what_a_dialect_has() {
    assert_eq!(of("", "x := y.%X3; // c"), ["line-comment", "partial-access-bit"]);
    assert_eq!(
        of("VAR t : LTIME; END_VAR", "x := a & b ** c;"),
        ["ampersand", "and", "ltime", "power"]
    );
}

#[test]
fn calls_are_told_by_what_is_called() {
    for (call, key) in [
        ("x := INT_TO_REAL(y);", "conversion"),
        ("x := REAL_TRUNC_INT(y);", "trunc-typed"),
        ("x := CONCAT_DATE_TOD(y, z);", "concat-date-time"),
        ("x := TO_INT(y);", "conversion-overloaded"),
        ("x := TRUNC_INT(y);", "trunc-typed"),
        ("x := WORD_BCD_TO_UINT(y);", "conversion-bcd"),
        ("x := SEL(a, b, c);", "sel"),
    ] {
        assert_eq!(of("", call), [key]);
    }
}

#[test]
fn a_use_has_its_place() {
    let text = "PROGRAM p x := MAX(a.3, INT#-5); END_PROGRAM";
    let found = feature_uses(text, Dialect::of(DialectName::IRONPLC_ED2));
    let described: Vec<String> = found
        .iter()
        .map(|one| format!("{} {}", one.key, one.span.text(text)))
        .collect();
    assert_eq!(
        described,
        [
            "max MAX(a.3, INT#-5)",
            "bit-access a.3",
            "typed-literal INT#-5",
            "typed-literal-sign INT#-5"
        ]
    );
}
