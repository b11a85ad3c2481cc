//! Tests of the whole catalogue: the number of functions, and that each name means what it says.

use crate::all_signatures;
use std::collections::HashSet;
use stickler_exact::{Signature, functions, signatures};
use stickler_types::{DialectName, ElementaryType};

/// Returns the number of functions of a dialect with 15 number types, two texts, `forms` forms of each duration and date
/// type, and `characters` character types.
fn counted(forms: usize, characters: usize) -> usize {
    let numbers = 15 * 14;
    // Durations, dates, times of day, and dates with a time, each with every number, in both directions.
    let with_moments = 2 * 15 * (4 * forms);
    // Durations, dates, times of day, and dates with a time among each other.
    let among_moments = 4 * forms * (4 * forms - 1);
    // With twelve integers and bit strings in both directions, and among each other.
    let with_characters = 2 * 12 * characters + characters * characters.saturating_sub(1);
    // Every pair in which there is a text.
    let others = 15 + 4 * forms + characters;
    let with_texts = 2 * 2 * others + 2;
    let pairs = numbers + with_moments + among_moments + with_characters + with_texts;
    let overloaded = others + 2;
    let truncations = 1 + 8 + 2 * 8;
    // The page's two, BCD_TO_<UNSIGNED>, TO_BCD_<BITS>, and each of four with each of four in both directions.
    let decimals = 2 + 4 + 4 + 2 * 4 * 4;
    pairs + overloaded + truncations + decimals
}

#[test]
fn each_dialect_has_as_many_functions_as_can_be_counted() {
    let [second, third, no_characters] = [counted(1, 0), counted(2, 2), counted(2, 0)];
    // Without LDATE, LTOD and LDT: with each number and text in both directions, overloaded, and among the eight.
    let no_long_dates = no_characters - 3 * (2 * (15 + 2) + 1) - (8 * 7 - 5 * 4);
    for dialect in DialectName::ALL {
        // One CONCAT and four roundings, three and four; none of the roundings in matiec.
        let number = match dialect.as_str() {
            "matiec" => second + 1,
            "ironplc-ed2" | "ironplc-rusty" | "iec-ed2" => second + 5,
            "ironplc-ed3" | "codesys" => no_characters + 7,
            "twincat" => no_long_dates + 5,
            // These lack numbers or texts, which nobody has counted.
            "control-expert" | "omron" | "siemens-s7" => functions(dialect).len(),
            _ => third + 7,
        };
        assert_eq!(functions(dialect).len(), number, "{dialect}");
        for found in all_signatures(dialect) {
            let mut types = found.operands.iter().chain([&found.result]);
            assert!(types.all(|ty| dialect.rules().may_name(*ty)), "{found:?}");
        }
    }
    assert_eq!([second + 5, third + 7], [513, 759]);
}

#[test]
fn no_name_appears_twice_and_every_signature_is_found_by_its_own_name() {
    for dialect in DialectName::ALL {
        let names = functions(dialect);
        let different: HashSet<&String> = names.iter().collect();
        assert_eq!(different.len(), names.len(), "{dialect}");
        for name in &names {
            let found = signatures(name, dialect);
            assert!(!found.is_empty(), "{dialect} {name}");
            let different: HashSet<&Signature> = found.iter().collect();
            assert_eq!(different.len(), found.len(), "{dialect} {name}");
            for signature in &found {
                assert_eq!(&signature.function, name);
            }
            let in_lower_case = signatures(&name.to_ascii_lowercase(), dialect);
            assert_eq!(in_lower_case, found, "{name}");
        }
    }
}

#[test]
fn a_name_with_types_takes_and_gives_these_types() {
    for name in functions(DialectName::IRONPLC_ED3) {
        let found = signatures(&name, DialectName::IRONPLC_ED3);
        // These two have INT in their names, but take or give DINT too.
        let Some((from, to)) = name
            .split_once("_TO_")
            .filter(|_| !matches!(&name[..], "BCD_TO_INT" | "INT_TO_BCD"))
        else {
            continue;
        };
        let types = [from, to].map(ElementaryType::from_name);
        for signature in &found {
            assert!(types[0].is_none_or(|from| signature.operands == [from]), "{name}");
            assert!(types[1].is_none_or(|to| signature.result == to), "{name}");
        }
        if types.iter().all(Option::is_some) {
            assert_eq!(found.len(), 1, "{name}");
        }
    }
}

#[test]
fn signatures_are_ordered_by_their_types() {
    for dialect in DialectName::ALL {
        for name in functions(dialect) {
            let found = signatures(&name, dialect);
            assert!(
                found.is_sorted_by_key(|signature| (signature.operands.clone(), signature.result)),
                "{name}"
            );
        }
    }
}

#[test]
fn a_dialect_has_only_functions_of_types_that_it_has() {
    let second_edition = [DialectName::IRONPLC_ED2, DialectName::MATIEC];
    for signature in second_edition.into_iter().flat_map(all_signatures) {
        let mut types = signature.operands.iter().chain([&signature.result]);
        assert!(types.all(|ty| !ty.is_third_edition()), "{signature}");
    }
}

#[test]
fn a_name_of_any_length_is_looked_up() {
    assert_eq!(signatures(&"INT_TO_".repeat(100_000), DialectName::MATIEC), []);
}
