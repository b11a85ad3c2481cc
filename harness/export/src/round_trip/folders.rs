//! Tests the choice of cases for an export, and its folder.

use super::*;
use stickler_mdtest::assert_fits;

#[test]
fn a_folder_of_something_else_is_left_alone_and_one_of_an_export_is_replaced() {
    let cases = cases(&["widening/integer.toml"]);
    let cases: Vec<&Case> = cases.iter().collect();
    let folder = tempfile::tempdir().expect("a folder");
    let plan = plan(DialectName::IRONPLC_ED2);
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
    let refused = || {
        let error = export(&plan, &cases, other.path()).expect_err("it is not empty");
        let error = error.to_string();
        assert_fits(&error, "…is not empty and holds no earlier export…");
    };
    let notes = other.path().join("notes.txt");
    fs::write(&notes, "").expect("written");
    refused();
    let error = Export::read(other.path()).expect_err("no export").to_string();
    assert!(error.contains("holds no export"), "{error}");
    // Programs for browsers have a file of this name.
    let manifest = other.path().join(crate::MANIFEST);
    fs::write(&manifest, "{\"name\": \"Something else\"}").expect("written");
    refused();
    fs::remove_file(notes).expect("removed");
    refused();
    assert_fits(&fs::read_to_string(manifest).expect("there"), "…Something else…");
    // The files of an interrupted export may be replaced.
    let broken = tempfile::tempdir().expect("a folder");
    for name in ["page-001.st", crate::MANIFEST] {
        fs::write(broken.path().join(name), "").expect("written");
    }
    export(&plan, &cases, broken.path()).expect("exported");
}

#[test]
fn pages_are_named_by_their_text() {
    let cases = cases(&["widening/integer.toml"]);
    let identities = |plan: &ExportPlan| {
        let exported = ExportFolder::of(plan, &cases);
        exported.arrays.iter().map(|array| array[1]).collect::<Vec<i32>>()
    };
    let plan = plan(DialectName::IRONPLC_ED2);
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
        "conversion/time-and-bits.toml",
        "conversion/real-to-integer-edges.toml",
    ]);
    let with = ExportPlan {
        with: BTreeSet::from([ExtraCases::Open]),
        sample: None,
        cases_per_page: 1000,
        ..plan(DialectName::PLCNEXT)
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

#[test]
fn a_case_that_is_not_accepted_is_named_by_its_message_and_taken_off_its_page_by_its_answer() {
    let cases = cases(&["widening/integer.toml", "widening/user-defined.toml"]);
    let plan = ExportPlan {
        sample: Some(40),
        ..plan(DialectName::IRONPLC_ED3)
    };
    let mut exported = ExportFolder::of(&plan, &cases);
    let manifest = exported.manifest();
    // The last page has types of its own before the program.
    let at = manifest.pages.len() - 1;
    let (page, culprit) = (&manifest.pages[at], 0);
    let id = &page.cases[culprit].id;
    let text = fs::read_to_string(exported.folder.path().join(&page.file)).expect("a page");
    assert!(page.lines.units > 0);
    let stands = text
        .lines()
        .enumerate()
        .filter(|(_, line)| line.contains(&format!(": {id} *)")))
        .map(|(at, _)| at + 1);
    let stands: Vec<usize> = stands.collect();
    // Where it is computed, and where each of its values is compared.
    assert!(stands.len() >= 2, "{text}");
    exported.arrays.pop();
    for line in stands {
        let message = format!("{}({}): error: it is not accepted\n", page.file, line + 1);
        let notes = exported
            .import(&format!("{}{message}", exported.text()))
            .0
            .notes
            .join("\n");
        assert!(
            notes.contains(&format!(
                "write this into answers.txt and export again in the same words:\n  rejected {id}"
            )),
            "{notes}"
        );
        assert_eq!(notes.matches("\n  rejected").count(), 1, "{notes}");
    }
    let before = exported.text();
    exported.answer(&format!("rejected {id}\n"));
    let all: Vec<&Case> = cases.iter().collect();
    let again = export(&plan, &all, exported.folder.path()).expect("exported again");
    assert_eq!((again.cases, again.answered), (exported.cases, 1));
    let manifest = exported.manifest();
    let page = &manifest.pages[at];
    let text = fs::read_to_string(exported.folder.path().join(&page.file)).expect("a page");
    assert!(!text.contains(id.as_str()));
    let last = list(&array(&text, plan.dialect, page.elements, page.steps.len()));
    let (imported, events, whole) = exported.import(&format!("{before}{last}"));
    assert!(whole, "{:?}", imported.notes);
    let odd = odd(&events);
    assert_eq!((odd.len(), &odd[0].id, odd[0].verdict), (1, id, Verdict::Fail));
}
