//! Tests of the pages of a small run.

use super::Discrepancies;
use crate::overview::Overview;
use crate::sample::{self, error, names, told, value};
use std::fs;
use std::path::Path;
use stickler_run::{CaseEvent, Event, Fact, Grade, Verdict};

fn failing(id: &str, program: &str, got: Fact) -> CaseEvent {
    CaseEvent {
        program: Some(program.to_owned()),
        got: vec![got],
        ..sample::case(id, Verdict::Fail)
    }
}

fn write(folder: &Path, events: &[Event]) {
    let mut pages = Discrepancies::create(folder).expect("a folder");
    let mut overview = Overview::default();
    for event in events {
        pages.take(event);
        overview.take(event);
    }
    pages.finish(&overview).expect("pages");
}

#[test]
fn cases_of_one_file_and_symptom_share_a_page_with_their_smallest_program() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let cases = vec![
        failing(
            "t::a(1)",
            "PROGRAM long (* ``` *) END_PROGRAM\n",
            value("into", "INT#1"),
        ),
        failing("t::a(2)", "PROGRAM m END_PROGRAM\n", value("into", "INT#2")),
        failing("t::b(1)", "PROGRAM middle END_PROGRAM\n", value("into", "INT#3")),
        failing("t::a(3)", "PROGRAM m END_PROGRAM\n", told(3, "P4035", "wrong")),
        sample::case("t::a(4)", Verdict::Pass),
    ];
    write(folder.path(), &sample::run_of(cases));
    let engine = folder.path().join("discrepancies/reference");
    let expected = [
        "01-widening-t-value.md",
        "02-widening-t-rejected-P4035.md",
        "README.md",
    ];
    assert_eq!(names(&engine), expected);
    let page = fs::read_to_string(engine.join(expected[0])).expect("a page");
    assert_eq!(
        page,
        "\
# reference 0.1.0: it computes another value

SINT widens to INT.

Save this as `program.st`:

```iecst
PROGRAM m END_PROGRAM
```

and run

```sh
ironplcc check program.st
```

Expected, by *ironplc-type-conversions: Integer widening*:

```
into = INT#-128
```

Got:

```
into = INT#2
```

Lines are those of `program.st`. 3 cases show this:

- 2 of `` widening/t::a `` in ironplc-ed2
- 1 of `` widening/t::b `` in ironplc-ed2

Found by Stickler, in its dialect `ironplc-ed2`: `` stickler run --filter 'widening/t::a(2)@ironplc-ed2' ``
"
    );
    let index = fs::read_to_string(engine.join("README.md")).expect("the list");
    assert!(
        index.contains("\n| 3 | [widening/t: it computes another value](01-widening-t-value.md) |"),
        "{index}"
    );
}

#[test]
fn the_pages_of_a_folder_tell_of_one_run_and_what_others_put_there_stays() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let run = sample::run_of(vec![failing(
        "t::a(1)",
        "PROGRAM m END_PROGRAM\n",
        value("into", "INT#1"),
    )]);
    write(folder.path(), &run);
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
    assert!(
        index.contains("No page has room for 5 cases of other kinds"),
        "{index}"
    );
}

#[test]
fn a_rejection_is_held_to_as_much_as_was_compared_and_the_page_says_to_what() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let case = CaseEvent {
        expected: vec![error(1, "P4035"), error(2, "P4049")],
        ..failing("t::a", "PROGRAM m\nEND_PROGRAM\n", told(1, "", "no sum"))
    };
    let mut run = sample::run_of(vec![case]);
    if let Event::Header(header) = &mut run[0] {
        header.engines[0].strict = Grade::Line;
    }
    write(folder.path(), &run);
    let page = folder
        .path()
        .join("discrepancies/reference/01-widening-t-incomplete-P4049.md");
    let page = fs::read_to_string(page).expect("a page");
    for part in [
        "# reference 0.1.0: it does not tell every mistake (P4049 is not told)\n",
        "Codes are Stickler's own and were not compared, only lines. One case shows this.",
    ] {
        assert!(page.contains(part), "{part}\n{page}");
    }
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
