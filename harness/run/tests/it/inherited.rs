//! Tests on the real suite that inherited cases of a custom dialect are dropped where its overrides change their result.

use crate::fixtures::go;
use std::collections::BTreeSet;
use std::path::Path;
use stickler_engines::Reference;
use stickler_run::{Event, Fact, Filter, Plan, Verdict, drop_changed_cases};
use stickler_suite::{Suite, Wanted};
use stickler_types::{Dialect, DialectName};

#[test]
fn what_changes_and_nobody_states_is_left_out_and_all_else_is_as_expected() {
    let dialect = Dialect::custom("unstated", DialectName::IRONPLC_ED3, "here")
        .stating("flags.nested-comments", "false", "unstated: test")
        .and_then(|dialect| dialect.stating("conversions.rounding", "'half-to-even'", "unstated: test"));
    let dialect = DialectName::define(dialect.unwrap()).unwrap();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let is_wanted = |id: &str, _| {
        ["language/comments", "conversion/idiom-round", "widening/bool"]
            .iter()
            .any(|begin| id.starts_with(begin))
            || id.ends_with("real-to-integer")
    };
    let mut suite = Suite::load_files(
        &root,
        Wanted {
            defined: &[dialect],
            ..Wanted::default()
        },
        is_wanted,
    );
    let plan = Plan {
        filters: [
            "language/comments*",
            "*real-to-integer::*REAL,SINT*",
            "conversion/idiom-round::*",
            "widening/bool*",
        ]
        .map(Filter::new)
        .to_vec(),
        dialects: vec![dialect],
        ..Plan::default()
    };
    let all = suite.cases.len();
    let left_out = drop_changed_cases(&plan, &mut suite.cases).unwrap();
    assert_eq!(suite.cases.len() + left_out.len(), all);
    assert!(
        left_out
            .iter()
            .all(|case| case.dialect == dialect && !case.is_stated())
    );
    let files: BTreeSet<&str> = left_out
        .iter()
        .filter_map(|case| case.id.split("::").next())
        .collect();
    assert_eq!(
        Vec::from_iter(files),
        ["conversion/idiom-round", "language/comments-nested"]
    );
    let (summary, events) = go(&plan, &suite, &[&Reference::new()]);
    let mut stated = 0;
    for event in events {
        if let Event::Case(case) = event {
            let got = Fact::text(&case.got);
            assert_eq!(case.verdict, Verdict::Pass, "{} {got}", case.id);
            stated += usize::from(case.basis.starts_with("unstated:"));
        }
    }
    let run = summary.unwrap().cases;
    assert!(run > 100, "only {run} cases");
    assert!(stated > 10, "only {stated} cases are stated");
}

#[test]
fn of_dialects_of_documented_systems_nothing_is_left_out() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases/language");
    let mut suite = Suite::load(&root);
    let before = suite.cases.clone();
    assert!(
        drop_changed_cases(&Plan::default(), &mut suite.cases)
            .unwrap()
            .is_empty()
    );
    assert_eq!(suite.cases, before);
}
