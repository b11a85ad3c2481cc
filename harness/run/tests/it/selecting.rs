//! Tests of the selection of cases by a plan.

use crate::fixtures::case;
use stickler_run::{Filter, Plan, select};
use stickler_suite::Case;
use stickler_types::DialectName;
use stickler_workers::Shard;

fn cases() -> Vec<Case> {
    let ids = ["a/b", "a/b2", "a/b::p(INT,-1)", "a/b::p(INT,-10)", "c/it's"];
    let dialects = [DialectName::MATIEC, DialectName::PLCNEXT];
    let both = |id| dialects.map(|dialect| Case { dialect, ..case(id) });
    ids.into_iter().flat_map(both).collect()
}

fn keys(plan: &Plan) -> Vec<String> {
    select(plan, &cases()).into_iter().map(Case::key).collect()
}

fn filtered(filters: &[&str]) -> Vec<String> {
    keys(&Plan {
        filters: filters.iter().copied().map(Filter::new).collect(),
        ..Plan::default()
    })
}

#[test]
fn the_default_plan_selects_all_in_order() {
    assert_eq!(keys(&Plan::default()).len(), 10);
    assert_eq!(
        keys(&Plan::default())[..3],
        ["a/b@matiec", "a/b@plcnext", "a/b2@matiec"]
    );
}

#[test]
fn a_filter_that_is_an_id_or_a_key_selects_nothing_else() {
    assert_eq!(filtered(&["a/b"]), ["a/b@matiec", "a/b@plcnext"]);
    assert_eq!(filtered(&["a/b@plcnext"]), ["a/b@plcnext"]);
    assert_eq!(filtered(&["a/b::p(INT,-1"]).len(), 4);
    assert_eq!(filtered(&["/b"]).len(), 8);
}

#[test]
fn filters_add_up_and_dialects_take_away() {
    assert_eq!(
        filtered(&["c/*@matiec", "a/b2@matiec"]),
        ["a/b2@matiec", "c/it's@matiec"]
    );
    let plan = Plan {
        filters: vec![Filter::new("a/b")],
        dialects: vec![DialectName::PLCNEXT],
        ..Plan::default()
    };
    assert_eq!(keys(&plan), ["a/b@plcnext"]);
}

#[test]
fn shards_divide_what_the_filters_leave() {
    let part = |index| {
        let shard = Some(Shard::new(index, 3).unwrap());
        keys(&Plan {
            filters: vec![Filter::new("a/")],
            shard,
            ..Plan::default()
        })
    };
    let mut all: Vec<String> = (1..=3).flat_map(part).collect();
    all.sort();
    let mut expected = filtered(&["a/"]);
    expected.sort();
    assert_eq!(all, expected);
}

#[test]
fn the_rerun_command_of_a_case_selects_that_case_alone() {
    let plan = Plan {
        rerun_prefix: "stickler run".to_owned(),
        ..Plan::default()
    };
    let cases = cases();
    assert_eq!(
        plan.rerun(&cases[0], "reference"),
        "stickler run --filter 'a/b' --dialect matiec"
    );
    let other = r"stickler run --engine other --filter 'c/it'\''s' --dialect plcnext";
    assert_eq!(plan.rerun(&cases[9], "other"), other);
    let asked_for = [("other".to_owned(), "'cmd:other --quiet'".to_owned())].into();
    let plan = Plan { asked_for, ..plan };
    assert!(
        plan.rerun(&cases[9], "other")
            .contains(" --engine 'cmd:other --quiet' ")
    );
    for case in &cases {
        let again = Plan {
            filters: vec![Filter::new(&*case.id)],
            dialects: vec![case.dialect],
            ..Plan::default()
        };
        assert_eq!(keys(&again), [case.key()]);
    }
}
