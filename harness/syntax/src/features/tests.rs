//! The places of features; which features programs have is tested by `tests/syntax/features.md` and in the crate `suite`.

use super::*;
use stickler_types::DialectName;

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
