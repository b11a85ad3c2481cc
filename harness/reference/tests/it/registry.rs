//! The registry's programs: each example earns its code in its dialect, and each repaired program is accepted.

use stickler_reference::check;
use stickler_types::{Code, DialectName};

#[test]
fn every_example_that_the_registry_promises_a_code_for_gets_it() {
    for &code in Code::ALL {
        let Some(dialect) = code.example_dialect() else {
            continue;
        };
        let given: Vec<Code> = check(code.example(), dialect)
            .into_iter()
            .filter_map(|diagnostic| diagnostic.registered_code())
            .collect();
        assert!(
            given.contains(&code),
            "{dialect} gives {given:?} for the example of {code}:\n{}",
            code.example()
        );
    }
}

#[test]
fn every_repaired_program_is_accepted() {
    for &code in Code::ALL {
        let Some(repaired) = code.repaired() else { continue };
        let dialect = code.example_dialect().unwrap_or(DialectName::IRONPLC_ED2);
        assert_eq!(
            check(repaired, dialect),
            [],
            "{dialect} rejects the repaired program of {code}:\n{repaired}"
        );
    }
}

#[test]
fn an_example_that_the_registry_promises_no_code_for_does_not_get_it() {
    for &code in Code::ALL {
        if code.example_dialect().is_none() {
            let given = check(code.example(), DialectName::IRONPLC_ED2);
            assert!(
                given
                    .iter()
                    .all(|diagnostic| diagnostic.registered_code() != Some(code)),
                "{code} is given after all"
            );
        }
    }
}
