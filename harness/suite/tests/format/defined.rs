//! The cases of a dialect that was defined: taken over, but for what its definition states.

use crate::folders::{files, folder};
use crate::listing::listing;
use stickler_mdtest::{Example, check_examples};
use stickler_suite::{Case, Suite, Wanted};
use stickler_types::{Dialect, DialectName, ElementaryType, MatrixWord};

/// Returns the dialect of the block `stated`, which extends `ironplc-ed3`: lines such as `INT.BOOL = yes` and
/// `conversions.rounding = 'half-to-even'`. Examples define dialects of different names, for they stay defined.
fn define(example: &Example, name: &str) -> DialectName {
    let mut dialect = Dialect::custom(name, DialectName::IRONPLC_ED3, "here");
    for line in example.text("stated").lines() {
        let (key, value) = line.split_once(" = ").unwrap();
        let types = key
            .split_once('.')
            .and_then(|(from, to)| Some((ElementaryType::from_name(from)?, ElementaryType::from_name(to)?)));
        let basis = format!("{name}: {key}");
        dialect = match types {
            Some(pair) => dialect.stating_cell(pair, MatrixWord::from_word(value).unwrap(), &basis),
            None => dialect.stating(key, value, &basis).unwrap(),
        };
    }
    DialectName::define(dialect).unwrap()
}

#[test]
fn golden_defined_dialects() {
    let mut number = 0;
    check_examples("tests/format/defined.md", |example| {
        number += 1;
        let dialect = define(example, &format!("defined-{number}"));
        let folder = folder(&files(example));
        let root = folder.path().join("cases");
        let suite = Suite::load_with(
            &root,
            Wanted {
                defined: &[dialect],
                ..Wanted::default()
            },
        );
        assert_eq!(suite.errors, []);
        let (own, others): (Vec<Case>, Vec<Case>) =
            suite.cases.into_iter().partition(|case| case.dialect == dialect);
        let without = Suite::load(&root).cases;
        assert_eq!(others, without, "the cases of other dialects stay what they are");
        let base = without
            .iter()
            .find(|case| case.dialect == DialectName::IRONPLC_ED3);
        assert!(base.is_some());
        // A case that is taken over is that of the base but for its dialect.
        let is_taken_over = |case: &Case| {
            let of_base = Case {
                dialect: DialectName::IRONPLC_ED3,
                ..case.clone()
            };
            without.contains(&of_base)
        };
        let mut text = String::new();
        for case in own {
            assert_eq!(case.is_stated(), case.basis.starts_with(dialect.as_str()));
            text += &match is_taken_over(&case) {
                true => format!("{} as it was\n", case.id),
                false => listing(std::slice::from_ref(&case), false).replacen(
                    '\n',
                    &format!(" by {}: {}\n", case.basis, case.title),
                    1,
                ),
            };
        }
        text.replace(dialect.as_str(), "DIALECT")
    });
}
