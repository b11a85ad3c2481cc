//! The options that choose the rules of a dialect: a preset of the compiler, and single features beside it.
//!
//! Basis: ironplc: "Enabling Dialects and Features" ("a dialect is a preset … `--allow-*` flags layer on top"); `ironplcc dialects` of
//! version 0.239.

use crate::Outcome;
use stickler_types::{Dialect, DialectName};

/// The preset without any feature.
const PLAIN: &str = "iec61131-3-ed2";

/// The features of the preset `iec61131-3-ed3`.
const EDITION_3: &str = "--allow-long-time-types --allow-ref-to --allow-partial-access-syntax";

/// The features of the preset `rusty`.
const RUSTY: &str = "--allow-c-style-comments --allow-missing-semicolon --allow-top-level-var-global \
    --allow-constant-type-params --allow-empty-var-blocks --allow-time-as-function-name --allow-ref-to \
    --allow-ref-arithmetic --allow-ref-stack-variables --allow-ref-type-punning \
    --allow-int-to-bool-initializer --allow-sizeof --allow-system-uptime-global \
    --allow-cross-family-widening --allow-partial-access-syntax --allow-pragmas \
    --allow-short-circuit-operators --allow-mixed-located-var-declarations \
    --allow-constant-initializer-expressions --allow-bit-string-case-labels --allow-paren-string-length \
    --allow-struct-initializer-expressions --allow-fb-inheritance";

/// Returns the arguments behind `--dialect` for a dialect: the name of the preset, and the features that the definition of the
/// dialect adds to it. Features can only be added, so a preset without one of its own is the plain one with all others.
///
/// # Errors
/// [`Outcome::Unsupported`] for a dialect that the compiler does not speak.
pub(super) fn options(dialect: DialectName) -> Result<Vec<&'static str>, Outcome> {
    let (preset, features) = match dialect.base() {
        DialectName::IRONPLC_ED2 => (PLAIN, ""),
        DialectName::IRONPLC_ED3 => ("iec61131-3-ed3", EDITION_3),
        DialectName::IRONPLC_RUSTY => ("rusty", RUSTY),
        _ => {
            return Err(Outcome::Unsupported {
                reason: format!("it does not speak {dialect}"),
            });
        }
    };
    let features: Vec<&str> = features.split_whitespace().collect();
    let stated = dialect.definition().map(stated).unwrap_or_default();
    let is_off = |feature: &str| stated.contains(&(feature, false));
    let added = stated
        .iter()
        .filter(|(feature, on)| *on && !features.contains(feature))
        .map(|(feature, _)| *feature);
    let mut options = match features.iter().any(|feature| is_off(feature)) {
        false => vec![preset],
        true => {
            let others = features.iter().copied().filter(|feature| !is_off(feature));
            [PLAIN].into_iter().chain(others).collect()
        }
    };
    options.extend(added);
    Ok(options)
}

/// Returns the features for which the compiler has an option, and whether a definition turns them on.
fn stated(definition: &Dialect) -> Vec<(&'static str, bool)> {
    let feature = |key: &str| match key {
        "flags.allow-cross-family-widening" => Some("--allow-cross-family-widening"),
        "flags.allow-partial-access-syntax" => Some("--allow-partial-access-syntax"),
        "flags.third-edition-types" => Some("--allow-long-time-types"),
        "flags.line-comments" => Some("--allow-c-style-comments"),
        // A literal as a bit string comes with the widening; the others have no option.
        _ => None,
    };
    let stated = definition.statements();
    stated
        .filter_map(|(key, value)| Some((feature(key)?, value == "true")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PARTIAL: &str = "flags.allow-partial-access-syntax";
    const WIDENING: &str = "flags.allow-cross-family-widening";

    fn of(name: &str, base: DialectName, flag: &str, value: bool) -> Vec<&'static str> {
        let definition = Dialect::custom(name, base, "here").stating(flag, &value.to_string(), "a page");
        options(DialectName::define(definition.unwrap()).unwrap()).unwrap()
    }

    #[test]
    fn a_feature_is_added_to_the_preset_that_does_not_have_it() {
        assert_eq!(options(DialectName::IRONPLC_ED3).unwrap(), ["iec61131-3-ed3"]);
        assert_eq!(
            of("options-add", DialectName::IRONPLC_ED2, PARTIAL, true),
            ["iec61131-3-ed2", "--allow-partial-access-syntax"]
        );
        assert_eq!(
            of("options-has", DialectName::IRONPLC_RUSTY, PARTIAL, true),
            ["rusty"]
        );
    }

    #[test]
    fn a_preset_without_one_of_its_features_is_the_plain_one_with_the_others() {
        let without = of("options-less", DialectName::IRONPLC_ED3, PARTIAL, false);
        assert_eq!(
            without,
            ["iec61131-3-ed2", "--allow-long-time-types", "--allow-ref-to"]
        );
        let without = of("options-rusty", DialectName::IRONPLC_RUSTY, WIDENING, false);
        assert_eq!(without.len(), RUSTY.split_whitespace().count());
        assert!(!without.contains(&"--allow-cross-family-widening"));
        assert_eq!(
            of("options-same", DialectName::IRONPLC_ED2, WIDENING, false),
            ["iec61131-3-ed2"]
        );
    }

    #[test]
    fn a_dialect_of_another_compiler_has_no_options() {
        assert!(options(DialectName::MATIEC).is_err());
    }
}
