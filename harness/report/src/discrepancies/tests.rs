//! Tests of the folders of pages; golden texts show the pages.

use super::Discrepancies;
use super::page::Told;
use crate::sample::{self, names, value};
use std::fs;
use std::path::Path;
use stickler_mdtest::assert_fits;
use stickler_run::{CaseEvent, Cause, Event, Fact, Grade, Reduced, Verdict};

fn failing(id: &str, program: &str, got: Fact) -> CaseEvent {
    CaseEvent {
        program: Some(program.to_owned()),
        got: vec![got],
        ..sample::case(id, Verdict::Fail)
    }
}

fn write(folder: &Path, events: &[Event]) {
    let mut pages = Discrepancies::create(folder, false).expect("a folder");
    events.iter().for_each(|event| pages.take(event));
    pages.finish(&sample::overview(events)).expect("pages");
}

#[test]
fn the_pages_of_a_folder_tell_of_one_run_and_what_others_put_there_stays() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let run = sample::run_of(vec![failing(
        "t::a(1)",
        "PROGRAM m END_PROGRAM\n",
        value("into", "INT#1"),
    )]);
    let unreduced = Cause {
        reduction: Reduced::Partly,
        ..sample::cause("large", 3, Verdict::Fail)
    };
    let causes = [unreduced, sample::cause("differs", 1, Verdict::Differs)];
    write(folder.path(), &sample::with_causes(run.clone(), causes));
    let engine = folder.path().join("discrepancies/reference");
    fs::write(engine.join("notes.txt"), "mine").expect("notes");
    write(folder.path(), &run[..run.len() - 1]);
    assert_eq!(
        names(&engine),
        ["notes.txt"],
        "a run that was cut short has no pages"
    );
    fs::remove_file(engine.join("notes.txt")).expect("removed");
    write(folder.path(), &sample::run_of(Vec::new()));
    assert_eq!(names(folder.path()), Vec::<String>::new());
}

#[test]
fn pages_in_prose_have_no_text_of_a_program() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let mut cause = sample::cause("`into := 1` is accepted", 3, Verdict::Fail);
    cause.shown.program = "PROGRAM main into := 1; END_PROGRAM".to_owned();
    let reason = "cannot read 'into := 1' of the task's body, nor `into :=\n  into := 1\n  ^".to_owned();
    let lines = vec!["into := 1;".to_owned()];
    cause.shown.got = vec![Fact::Unsupported { reason }, Fact::Rendered { lines }];
    cause.shown.expected = cause.shown.got.clone();
    let case = failing("t::a(1)", &cause.shown.program, value("into", "INT#1"));
    let events = sample::with_causes(sample::run_of(vec![case]), [cause]);
    let mut pages = Discrepancies::create(folder.path(), true).expect("a folder");
    events.iter().for_each(|event| pages.take(event));
    pages.finish(&sample::overview(&events)).expect("pages");
    let engine = folder.path().join("discrepancies/reference");
    for name in names(&engine) {
        let page = fs::read_to_string(engine.join(&name)).expect("a page");
        assert!(page.contains("… is accepted"), "{page}");
        assert!(!page.contains("into :="), "{page}");
        let is_index = name == "README.md";
        assert!(
            is_index || page.contains("cannot read … of the task's body, nor …"),
            "{page}"
        );
    }
    assert_eq!(names(&engine).len(), 2);
}

#[test]
fn an_engine_with_endless_kinds_of_failures_has_so_many_pages_and_no_more() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let case = |number: usize| {
        failing(
            &format!("t{number}::a"),
            "PROGRAM m END_PROGRAM\n",
            value("into", "INT#1"),
        )
    };
    let cases = (0..super::MAX_CLUSTERS + 5).map(case).collect();
    write(folder.path(), &sample::run_of(cases));
    let engine = folder.path().join("discrepancies/reference");
    assert_eq!(names(&engine).len(), super::MAX_CLUSTERS + 1);
    let index = fs::read_to_string(engine.join("README.md")).expect("the list");
    assert_fits(&index, "…No page has room for 5 cases of other kinds…");
}

#[test]
fn a_name_of_a_folder_leads_nowhere_else() {
    for (name, folder) in [
        ("codesys-3.5", "codesys-3.5"),
        ("..", "-."),
        ("a/../b c", "a-..-b-c"),
    ] {
        assert_eq!(super::file_name(name), folder);
    }
}

#[test]
fn what_is_told_of_a_compiler_that_dies_is_what_the_commands_of_the_page_print() {
    let told = |printed, fact: Fact| {
        let strict = Grade::Line;
        Told { printed, strict }.text(&[fact])
    };
    let unusable = || Fact::Unusable {
        reason: "the C++ cannot be built: generated.hpp:54:5: error: no type HOST".to_owned(),
    };
    let printed = "accepted\nIn file included from driver.cpp:1:\nprogram.hpp:58:5: error: no type HOST\n";
    assert_eq!(
        told(printed, unusable()),
        "accepted, but the C++ cannot be built: program.hpp:58:5: error: no type HOST"
    );
    assert_eq!(told("", unusable()), unusable().to_string());
    let reason = "Error: not yet at translate (/opt/st/codegen.js:43)".to_owned();
    assert_eq!(
        told(
            "error: \nError: not yet\n    at translate\n",
            Fact::Crashed { reason }
        ),
        "crashed: Error: not yet"
    );
    let reason = "it ended (exit status: 3); its last words: Error: V9014".to_owned();
    assert_eq!(
        told("0\nError: V9014\n", Fact::Crashed { reason }),
        "crashed: it ended (exit status: 3); its last words: Error: V9014"
    );
    let silent = stickler_types::Diagnostic {
        code: Some("P0002".to_owned()),
        line: Some(5),
        ..stickler_types::Diagnostic::default()
    };
    assert_eq!(
        told("an error", Fact::Diagnostic(silent)),
        "line 5: error of any code"
    );
}
