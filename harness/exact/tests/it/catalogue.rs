//! Tests of the whole catalogue: the number of functions, and that each name means what it says.

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
fn dialects_have_as_many_functions_as_can_be_counted() {
    let [second, third] = [counted(1, 0), counted(2, 2)];
    // One CONCAT and four roundings, three and four; none of the roundings in matiec.
    for (dialect, number) in [
        (DialectName::IRONPLC_ED2, second + 5),
        (DialectName::MATIEC, second + 1),
        (DialectName::PLCNEXT, third + 7),
        (DialectName::IEC_ED3, third + 7),
    ] {
        assert_eq!(functions(dialect).len(), number, "{dialect}");
    }
    assert_eq!([second + 5, third + 7], [513, 759]);
}

#[test]
fn no_function_has_a_type_that_its_dialect_lacks() {
    for dialect in DialectName::ALL {
        let names = functions(dialect).into_iter();
        for found in names.flat_map(|name| signatures(&name, dialect)) {
            let mut types = found.operands.iter().chain([&found.result]);
            assert!(
                types.all(|ty| dialect.rules().may_name(*ty)),
                "{dialect}: {found:?}"
            );
        }
    }
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
            if let Some(from) = types[0] {
                assert_eq!(signature.operands, [from], "{name}");
            }
            if let Some(to) = types[1] {
                assert_eq!(signature.result, to, "{name}");
            }
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
    for dialect in second_edition {
        for name in functions(dialect) {
            for signature in signatures(&name, dialect) {
                let types = signature.operands.iter().chain([&signature.result]);
                assert!(types.copied().all(|ty| !ty.is_third_edition()), "{name}");
            }
        }
    }
}

#[test]
fn a_name_of_any_length_is_looked_up() {
    assert_eq!(signatures(&"INT_TO_".repeat(100_000), DialectName::MATIEC), []);
}
