//! What is exported, and where.

use super::*;

#[test]
fn a_folder_of_something_else_is_left_alone_and_one_of_an_export_is_replaced() {
    let cases = cases(&["widening/integer.toml"]);
    let cases: Vec<&Case> = cases.iter().collect();
    let folder = tempfile::tempdir().expect("a folder");
    let plan = plan(DialectName::IronplcEd2);
    let first = export(&plan, &cases, folder.path()).expect("exported");
    fs::write(folder.path().join(crate::ANSWERS), "rejected x\n").expect("written");
    let fewer = ExportPlan {
        sample: Some(3),
        ..plan.clone()
    };
    let second = export(&fewer, &cases, folder.path()).expect("exported again");
    assert_eq!((second.cases, second.pages), (3, 1));
    assert_eq!(
        second.left_out[&Reason::Sampled],
        first.cases + first.left_out.get(&Reason::Sampled).copied().unwrap_or(0) - 3
    );
    let pages = fs::read_dir(folder.path())
        .expect("the folder")
        .filter_map(Result::ok);
    let pages = pages.filter(|entry| entry.file_name().to_string_lossy().starts_with("page-"));
    assert_eq!(pages.count(), 1);
    assert_eq!(
        fs::read_to_string(folder.path().join(crate::ANSWERS)).expect("answers"),
        "rejected x\n"
    );
    let other = tempfile::tempdir().expect("a folder");
    fs::write(other.path().join("notes.txt"), "").expect("written");
    let error = export(&plan, &cases, other.path())
        .expect_err("it is not empty")
        .to_string();
    assert!(
        error.contains("is not empty and holds no earlier export"),
        "{error}"
    );
    let error = Export::read(other.path()).expect_err("no export").to_string();
    assert!(error.contains("holds no export"), "{error}");
}

#[test]
fn pages_are_named_by_their_text() {
    let cases = cases(&["widening/integer.toml"]);
    let identities = |plan: &ExportPlan| {
        let exported = Exported::of(plan, &cases);
        exported.arrays.iter().map(|array| array[1]).collect::<Vec<i32>>()
    };
    let plan = plan(DialectName::IronplcEd2);
    let first = identities(&plan);
    assert_eq!(first, identities(&plan));
    let other = identities(&ExportPlan {
        cases_per_page: 15,
        ..plan
    });
    assert!(other.iter().all(|identity| !first.contains(identity)));
    assert!(first.iter().all(|identity| *identity > 0 && identity % 1000 == 0));
}

#[test]
fn programs_that_may_be_accepted_have_pages_of_their_own() {
    let cases = cases(&[
        "conversion/bit-string-to-real.toml",
        "conversion/real-to-integer-edges.toml",
    ]);
    let with = ExportPlan {
        with: BTreeSet::from([With::Open]),
        sample: None,
        cases_per_page: 1000,
        ..plan(DialectName::Plcnext)
    };
    let folder = tempfile::tempdir().expect("a folder");
    let cases: Vec<&Case> = cases.iter().collect();
    let all = export(&with, &cases, folder.path()).expect("exported");
    let without = export(
        &ExportPlan {
            with: BTreeSet::new(),
            ..with
        },
        &cases,
        folder.path(),
    )
    .expect("exported");
    assert_eq!(without.cases + without.left_out[&Reason::Open], all.cases);
    assert!(!all.left_out.contains_key(&Reason::Open));
}
