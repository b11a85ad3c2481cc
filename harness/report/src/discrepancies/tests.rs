//! Tests of the pages of a small run.

use super::Discrepancies;
use crate::sample::{self, error, names, reported, value};
use std::fs;
use std::path::Path;
use stickler_engines::{Reproduction, ReproductionFile};
use stickler_run::{
    CaseEvent, Event, ExplainedCases, Fact, Grade, Reduced, RepeatedOutcome, Repeats, Reproducer, Verdict,
};

fn failing(id: &str, program: &str, got: Fact) -> CaseEvent {
    CaseEvent {
        program: Some(program.to_owned()),
        got: vec![got],
        ..sample::case(id, Verdict::Fail)
    }
}

fn write(folder: &Path, events: &[Event]) {
    let mut pages = Discrepancies::create(folder).expect("a folder");
    events.iter().for_each(|event| pages.take(event));
    pages.finish(&sample::overview(events)).expect("pages");
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
        failing(
            "t::a(3)",
            "PROGRAM m END_PROGRAM\n",
            reported(3, "P4035", "wrong"),
        ),
        sample::case("t::a(4)", Verdict::Pass),
    ];
    write(folder.path(), &sample::run_of(cases));
    let engine = folder.path().join("discrepancies/reference");
    let expected = [
        "01-widening-t-it-computes-another-value.md",
        "02-widening-t-it-rejects-what-must-be-accepted-P4035.md",
        "README.md",
    ];
    assert_eq!(names(&engine), expected);
    let page = fs::read_to_string(engine.join(expected[0])).expect("a page");
    assert_eq!(
        page,
        "\
# reference 0.1.0: widening/t: it computes another value

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

3 cases show this:

| cases | probe | dialect |
|--:|---|---|
| 2 | `` widening/t::a `` | ironplc-ed2 |
| 1 | `` widening/t::b `` | ironplc-ed2 |

Found by Stickler, in its dialect `ironplc-ed2`; a case that shows it: `` stickler run --filter 'widening/t::a(2)@ironplc-ed2' ``
"
    );
    let index = fs::read_to_string(engine.join("README.md")).expect("the list");
    assert!(
        index.contains(
            "\n| 3 | [widening/t: it computes another value](01-widening-t-it-computes-another-value.md) |"
        ),
        "{index}"
    );
}

#[test]
fn of_many_values_only_those_that_differ_are_shown() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let values = |last: &str| vec![value("a", "INT#1"), value("b", "INT#2"), value("c", last)];
    let case = CaseEvent {
        expected: values("INT#3"),
        got: values("INT#4"),
        ..failing("t::a(1)", "PROGRAM m END_PROGRAM\n", value("c", "INT#4"))
    };
    write(folder.path(), &sample::run_of(vec![case]));
    let page = folder
        .path()
        .join("discrepancies/reference/01-widening-t-it-computes-another-value.md");
    let page = fs::read_to_string(page).expect("a page");
    let end = "```\nc = INT#3\n```\n\nGot:\n\n```\nc = INT#4\n```\n\n2 other values are as expected.\n";
    assert!(page.contains(end), "{page}");
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
        ..failing("t::a", "PROGRAM m\nEND_PROGRAM\n", reported(1, "", "no sum"))
    };
    let mut run = sample::run_of(vec![case]);
    sample::header(&mut run).engines[0].strict = Grade::Line;
    write(folder.path(), &run);
    let page = folder
        .path()
        .join("discrepancies/reference/01-widening-t-it-does-not-report-every-mistake-P4049-is-missing.md");
    let page = fs::read_to_string(page).expect("a page");
    for part in [
        "# reference 0.1.0: widening/t: it does not report every mistake (P4049 is missing)\n",
        "Codes are Stickler's own and were not compared, only lines.\n\n1 case shows this:",
    ] {
        assert!(page.contains(part), "{part}\n{page}");
    }
}

#[test]
fn a_cause_has_a_page_that_stands_for_itself() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let failing = |id| failing(id, "PROGRAM m END_PROGRAM\n", value("into", "INT#1"));
    let run = sample::run_of(vec![failing("t::a(1)"), failing("t::a(2)"), failing("u::a(1)")]);
    let mut cause = sample::cause("`into := from` gives 128", 2, Verdict::Fail);
    let outcome = |got, runs| RepeatedOutcome { got: vec![got], runs };
    cause.flaky = Some(Repeats {
        seen: 7,
        of: 20,
        outcomes: vec![outcome(value("into", "INT#128"), 7), outcome(Fact::Accepted, 13)],
    });
    cause.types = vec!["SINT, INT".to_owned(), "INT, DINT".to_owned()];
    cause.second = Some(Reproducer {
        program: "PROGRAM n END_PROGRAM\n".to_owned(),
        expected: vec![value("into", "DINT#5")],
        got: vec![value("into", "DINT#6")],
        ..Reproducer::default()
    });
    cause.cases.push(ExplainedCases {
        basis: "iec-61131-3: 6.3".to_owned(),
        probe: "widening/u::a".to_owned(),
        dialect: "matiec".to_owned(),
        verdict: Verdict::Fail,
        cases: 1,
    });
    let run = sample::with_causes(sample::with_sources(run), [cause]);
    write(folder.path(), &run);
    let engine = folder.path().join("discrepancies/reference");
    assert_eq!(names(&engine), ["01-into-from-gives-128.md", "README.md"]);
    let page = fs::read_to_string(engine.join("01-into-from-gives-128.md")).expect("a page");
    assert_eq!(
        page,
        "\
# reference 0.1.0: `` into := from `` gives 128

Save this as `program.st`:

```iecst
PROGRAM m END_PROGRAM
```

and run

```sh
ironplcc check program.st
```

Expected, by [ironplc-type-conversions: Integer widening](<https://example.org/Integer widening#integer-widening>) (IronPLC: Type Conversions, document, read 0.239):

```
into = INT#-128
```

Got:

```
into = INT#128
```

**By chance:** this came in 7 of 20 runs of the same program.

- 7 of 20: `` into = INT#128 ``
- 13 of 20: `` accepted ``

Another program shows the same:

```iecst
PROGRAM n END_PROGRAM
```

Expected: `` into = DINT#5 ``. Got: `` into = DINT#6 ``.

Seen with the types SINT, INT · INT, DINT.

3 cases show this. It hides whether the compiler meets other claims, whose cases fail for it too:

- iec-61131-3: 6.3: 1

| cases | probe | dialect |
|--:|---|---|
| 2 | `` widening/t::a `` | ironplc-ed2 |
| 1 | `` widening/u::a `` | matiec |

Found by Stickler, in its dialect `ironplc-ed2`; a case that shows it: `` stickler run --filter 'widening/t::a(1)@ironplc-ed2' ``
"
    );
    let index = fs::read_to_string(engine.join("README.md")).expect("the list");
    assert!(index.contains("1 page, one for each cause"), "{index}");
}

#[test]
fn causes_that_contradict_nothing_that_binds_the_engine_or_are_not_small_have_folders_of_their_own() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let case = failing("t::a(1)", "PROGRAM m END_PROGRAM\n", value("into", "INT#1"));
    let mut unreduced = sample::cause("large", 3, Verdict::Fail);
    unreduced.reduction = Reduced::Partly;
    let causes = [
        sample::cause("fails", 1, Verdict::Fail),
        sample::cause("differs", 1, Verdict::Differs),
        unreduced,
    ];
    let run = sample::with_causes(sample::run_of(vec![case.clone(), case]), causes);
    write(folder.path(), &run);
    let engine = folder.path().join("discrepancies/reference");
    assert_eq!(
        names(&engine),
        ["01-fails.md", "README.md", "differs", "unreduced"]
    );
    assert_eq!(names(&engine.join("unreduced")), ["01-large.md", "README.md"]);
    assert_eq!(names(&engine.join("differs")), ["01-differs.md", "README.md"]);
    let index = fs::read_to_string(engine.join("README.md")).expect("the list");
    assert!(
        index.contains("\n1 more page is in [`differs`](differs/README.md), for 1 case: differences"),
        "{index}"
    );
    assert!(
        index.contains("1 page, one for each cause")
            && index.contains(
                "\n1 more page is in [`unreduced`](unreduced/README.md), for 3 cases: the search ended"
            ),
        "{index}"
    );
    write(folder.path(), &sample::run_of(Vec::new()));
    assert_eq!(names(folder.path()), Vec::<String>::new());
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
fn of_a_crash_a_rule_demands_an_answer_and_what_the_commands_print_is_shown() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let reason = "signal 6".to_owned();
    let crashing = CaseEvent {
        basis: "rule: not-stated".to_owned(),
        ..failing("t::a(1)", "PROGRAM m END_PROGRAM\n", Fact::Crashed { reason })
    };
    let run = sample::run_of(vec![crashing.clone()]);
    let mut cause = sample::cause("it crashes", 1, Verdict::Crash);
    let lines: Vec<String> = (1..=43).map(|line| format!("line {line}")).collect();
    cause.shown = Reproducer {
        basis: crashing.basis,
        expected: vec![Fact::Accepted],
        got: crashing.got,
        reproduction: Some(Reproduction {
            files: vec![ReproductionFile {
                name: "program.st".to_owned(),
                text: "PROGRAM m END_PROGRAM\n".to_owned(),
            }],
            tools: Vec::new(),
            commands: vec!["stc program.st".to_owned(), "./out".to_owned()],
        }),
        printed: lines.join("\n"),
        ..cause.shown
    };
    write(folder.path(), &sample::with_causes(run, [cause]));
    let page = folder.path().join("discrepancies/reference/01-it-crashes.md");
    let page = fs::read_to_string(page).expect("a page");
    for part in [
        "and run\n\n```sh\nstc program.st &&\n./out\n```\n\nThat prints:\n\n```\nline 1\n",
        "\nline 40\n… 3 more lines\n```\n",
        "Expected:\n\n```\nan answer, no crash\n```\n\nGot:\n\n```\ncrashed: signal 6\n```\n",
    ] {
        assert!(page.contains(part), "{part}\n{page}");
    }
    assert!(!page.contains("Expected, by"), "{page}");
}

#[test]
fn of_what_is_not_implemented_the_page_that_lists_it_is_named() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let page = |reason: &str| {
        let lacking = Fact::NotImplemented {
            reason: reason.to_owned(),
            promised_by: None,
        };
        let case = failing("t::a(1)", "PROGRAM m END_PROGRAM\n", lacking);
        let run = sample::with_sources(sample::run_of(vec![case.clone()]));
        let mut cause = sample::cause("lacks", 1, Verdict::Fail);
        cause.shown.got = case.got;
        write(folder.path(), &sample::with_causes(run, [cause]));
        fs::read_to_string(folder.path().join("discrepancies/reference/01-lacks.md")).expect("a page")
    };
    let text = page("P9999: not yet");
    let said = "[ironplc-type-conversions: P9999](<https://example.org/P9999#p9999>) lists what may give this answer: arrays. Where";
    assert!(text.contains(said), "{text}");
    assert!(!page("P9997: not yet").contains("lists what"));
}
