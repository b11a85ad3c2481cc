//! The options that choose the rules of a dialect: a preset of the compiler, and single features beside it.

use crate::Outcome;
use crate::adapters::Compiler;
use crate::adapters::described::Parsed;
use crate::adapters::locate::speaks_not;
use stickler_types::DialectName;

/// Returns the preset of a dialect, and the features that it has.
fn preset(dialect: DialectName) -> Option<(&'static str, Vec<&'static str>)> {
    let mut words = Compiler::Ironplc
        .data()
        .dialects
        .get(&Parsed(dialect))?
        .split_whitespace();
    Some((words.next()?, words.collect()))
}

/// Returns the arguments behind `--dialect` for a dialect: the name of the preset, and the features that the definition of the
/// dialect adds to it. Features can only be added, so a preset without one of its own is the plain one with all others.
///
/// # Errors
/// [`Outcome::Unsupported`] for a dialect that the compiler does not speak.
pub(super) fn options(dialect: DialectName) -> Result<Vec<&'static str>, Outcome> {
    let (name, features) = preset(dialect.base()).ok_or_else(|| speaks_not(dialect))?;
    // What the definition says of the features for which the compiler has an option.
    let known = &Compiler::Ironplc.data().options;
    let statements = dialect
        .definition()
        .into_iter()
        .flat_map(|definition| definition.statements());
    let stated: Vec<(&str, bool)> = statements
        .filter_map(|(key, value)| Some((known.get(key)?.as_str(), value == "true")))
        .collect();
    let is_off = |feature: &str| stated.contains(&(feature, false));
    let mut options = match features.iter().any(|feature| is_off(feature)) {
        false => vec![name],
        true => {
            let plain = preset(DialectName::IRONPLC_ED2).map(|(name, _)| name);
            let others = features.iter().copied().filter(|feature| !is_off(feature));
            plain.into_iter().chain(others).collect()
        }
    };
    let added = stated
        .iter()
        .filter(|(feature, on)| *on && !features.contains(feature));
    options.extend(added.map(|(feature, _)| *feature));
    Ok(options)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Dialect;

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
        assert_eq!(without.len(), preset(DialectName::IRONPLC_RUSTY).unwrap().1.len());
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
