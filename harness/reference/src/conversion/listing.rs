//! The names of all conversion functions, for lists and for guesses at what was meant. Which of them a dialect
//! has, and what they mean, is for [`super::function`] and [`super::concatenation()`] to say.

use super::concatenation::{CONCATENATIONS, concatenation};
use super::{ConversionRule, function};
use std::sync::LazyLock;
use stickler_types::{ConversionChoices, Dialect, ElementaryType, MomentUnits};

static NAMES: LazyLock<Vec<String>> = LazyLock::new(|| {
    let mut names = of_pairs();
    names.extend(of_truncation());
    names.extend(of_bcd());
    names.extend(["ROUND", "CEIL", "CEILING", "FLOOR"].map(str::to_owned));
    names.extend(CONCATENATIONS.map(|(name, _)| name.to_owned()));
    names
});

/// Every name, each once, always in the same order, in upper case and with the types' short names, whatever the
/// dialect.
pub fn catalogue_names() -> &'static [String] {
    &NAMES
}

/// The names that a dialect has.
pub fn functions(dialect: &Dialect) -> Vec<&'static str> {
    let known = |name: &str| function(name, dialect).is_some() || concatenation(name, dialect).is_some();
    let names = catalogue_names().iter().map(String::as_str);
    names.filter(|name| known(name)).collect()
}

/// `<SRC>_TO_<DST>`, `TO_<DST>`; of a dialect that has all of them.
fn of_pairs() -> Vec<String> {
    let mut names = Vec::new();
    let choices = ConversionChoices {
        moment_units: MomentUnits::Counts,
        ..ConversionChoices::DEFAULT
    };
    for to in ElementaryType::ALL {
        names.push(format!("TO_{}", to.name()));
        for from in ElementaryType::ALL {
            let converts = ConversionRule::between(from, to, &choices).is_some();
            if from != to && converts {
                names.push(format!("{}_TO_{}", from.name(), to.name()));
            }
        }
    }
    names
}

/// `TRUNC`, `TRUNC_<INTEGER>`, `<REAL>_TRUNC_<INTEGER>`.
fn of_truncation() -> Vec<String> {
    let mut names = vec!["TRUNC".to_owned()];
    for to in ElementaryType::ALL.into_iter().filter(|ty| ty.is_integer()) {
        names.push(format!("TRUNC_{}", to.name()));
        for from in ElementaryType::ALL.into_iter().filter(|ty| ty.is_real()) {
            names.push(format!("{}_TRUNC_{}", from.name(), to.name()));
        }
    }
    names
}

/// The names with BCD in them.
fn of_bcd() -> Vec<String> {
    let mut names = vec!["BCD_TO_INT".to_owned(), "INT_TO_BCD".to_owned()];
    let all = ElementaryType::ALL;
    let bits = all.into_iter().filter(|ty| ty.is_bit_string());
    let integers = || all.into_iter().filter(|ty| ty.is_integer() && !ty.is_signed());
    names.extend(integers().map(|to| format!("BCD_TO_{}", to.name())));
    for bits in bits {
        names.push(format!("TO_BCD_{}", bits.name()));
        for integer in integers() {
            names.push(format!("{}_BCD_TO_{}", bits.name(), integer.name()));
            names.push(format!("{}_TO_BCD_{}", integer.name(), bits.name()));
        }
    }
    names
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;
    use stickler_types::DialectName;

    #[test]
    fn every_name_is_a_function_and_stands_there_once() {
        let all = functions(Dialect::of(DialectName::IEC_ED3));
        assert_eq!(all.len(), catalogue_names().len(), "this dialect has them all");
        assert_eq!(all.iter().collect::<HashSet<_>>().len(), all.len());
        let matiec = functions(Dialect::of(DialectName::MATIEC));
        assert!(matiec.contains(&"TRUNC_INT") && !matiec.contains(&"ROUND"));
        assert!(
            !matiec
                .iter()
                .any(|name| name.contains("LTIME") || name.contains("CHAR"))
        );
    }
}
