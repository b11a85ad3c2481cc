//! `*.st` files: what becomes of their headers and marks.

use crate::common::{cases, one_mistake};
use stickler_suite::{Acceptance, Case};
use stickler_types::{Code, DialectName, Fault, Value};

/// A program file with a header and this body, whose first line is line 6.
fn program(dialects: &str, body: &str) -> String {
    format!("(*!\ntitle = \"t\"\nbasis = \"iec-61131-3: 6.3.4\"\ndialects = [{dialects}]\n*)\n{body}")
}

#[track_caller]
fn one_case(body: &str) -> Case {
    let mut cases = cases("area/file.st", &program("'matiec'", body));
    assert_eq!(cases.len(), 1);
    cases.remove(0)
}

#[track_caller]
fn wrong(body: &str, line: u32, said: &str) {
    one_mistake("area/file.st", &program("'matiec'", body), line, said);
}

fn value(literal: &str) -> Value {
    Value::parse(literal).unwrap()
}

#[test]
fn a_header_describes_the_case() {
    let text = "(*!\ntitle = \"One\"\nbasis = \"b: d\"\ndialects = [\"matiec\"]\nscans = 3\n\
                tags = [\"a\", \"b\"]\nsummary = \"S\"\n*)\nPROGRAM main END_PROGRAM (*! ok *)\n";
    let case = &cases("area/deep/file.st", text)[0];
    assert_eq!(&*case.id, "area/deep/file");
    assert_eq!(case.key(), "area/deep/file@matiec");
    assert_eq!((&*case.title, &*case.basis), ("One", "b: d"));
    assert_eq!((case.scans, case.summary.as_deref()), (3, Some("S")));
    assert_eq!(case.tags.iter().map(|tag| &**tag).collect::<Vec<_>>(), ["a", "b"]);
    assert_eq!(
        (&*case.file, &*case.area, case.line),
        ("cases/area/deep/file.st", "area", 1)
    );
    assert_eq!(&*case.source, text);
    assert_eq!(case.expectation.accepted, Acceptance::Required);
    assert_eq!(case.expectation.clean_lines, [9]);
}

#[test]
fn a_case_comes_of_each_dialect_once() {
    let cases = cases(
        "area/file.st",
        &program("'plcnext', 'ironplc', 'ironplc-ed3'", "(*! ok *)"),
    );
    let dialects: Vec<DialectName> = cases.iter().map(|case| case.dialect).collect();
    assert_eq!(
        dialects,
        [
            DialectName::IRONPLC_ED2,
            DialectName::IRONPLC_ED3,
            DialectName::IRONPLC_RUSTY,
            DialectName::PLCNEXT
        ]
    );
}

#[test]
fn error_marks_expect_diagnostics_on_their_lines() {
    let case = one_case("a; (*! error P4035 *)\nb; (*! error P2026 P4035 *)\nc; (*! ok *)");
    assert_eq!(case.expectation.accepted, Acceptance::Rejected);
    let found: Vec<(u32, Code)> = case
        .expectation
        .diagnostics
        .iter()
        .map(|error| (error.line, error.code))
        .collect();
    let code = |text: &str| text.parse::<Code>().unwrap();
    assert_eq!(
        found,
        [(6, code("P4035")), (7, code("P2026")), (7, code("P4035"))]
    );
    assert_eq!(case.expectation.clean_lines, [8]);
    assert!(case.observe.is_empty());
}

#[test]
fn values_are_expected_after_their_scan() {
    let text = "(*!\ntitle = \"t\"\nbasis = \"b: c\"\ndialects = [\"matiec\"]\nscans = 3\n*)\n\
                (*! values\nsmall = INT#-31072\n\n a[1].x = STRING#'= $27'\n*)\n(*! values after 2\nsmall = INT#1\n*)";
    let case = &cases("area/file.st", text)[0];
    let found: Vec<_> = case
        .expectation
        .values
        .iter()
        .map(|v| (&*v.name, v.after, v.value.clone(), v.line))
        .collect();
    assert_eq!(
        found,
        [
            ("small", None, value("INT#-31072"), 8),
            ("a[1].x", None, value("STRING#'= $27'"), 10),
            ("small", Some(2), value("INT#1"), 13),
        ]
    );
    let observed: Vec<_> = case
        .observe
        .iter()
        .map(|o| (&*o.name, &*o.type_name, o.after))
        .collect();
    assert_eq!(
        observed,
        [
            ("small", "INT", None),
            ("a[1].x", "STRING", None),
            ("small", "INT", Some(2))
        ]
    );
}

#[test]
fn faults_renderings_and_observations_are_read() {
    let case = one_case(
        "x := 1 / zero; (*! fault division-by-zero *)\n(*! observe c : COLOR *)\n(*! rendered\n  x := 1;\n\n y; \n*)",
    );
    let expectation = &case.expectation;
    assert_eq!(
        expectation.fault.map(|fault| (fault.fault, fault.line)),
        Some((Fault::DivisionByZero, 6))
    );
    let rendered = expectation.rendered.as_ref().unwrap();
    assert_eq!(
        rendered.lines.iter().map(|line| &**line).collect::<Vec<_>>(),
        ["x := 1;", "", "y;"]
    );
    assert_eq!(
        (&*case.observe[0].name, &*case.observe[0].type_name),
        ("c", "COLOR")
    );
}

#[test]
fn open_acceptance_asserts_nothing() {
    let case = one_case("x; (*! observe acceptance *)\n(*! observe r : BOOL *)");
    assert_eq!(case.expectation.accepted, Acceptance::Observed);
    assert_eq!(&*case.observe[0].name, "r");
}

#[test]
fn settings_come_from_marks_and_from_the_header() {
    let text = "(*!\ntitle = \"t\"\nbasis = \"b: c\"\ndialects = [\"matiec\"]\nscans = 3\n\
                [[set]]\nbefore = 3\nname = \"in\"\nvalue = \"BOOL#TRUE\"\n\
                [[clock]]\nbefore = 2\nvalue = \"TIME#150ms\"\n*)\n\
                (*! set s = STRING#' before ' before 2 *)\n(*! clock LTIME#1s before 1 *) (*! ok *)";
    let case = &cases("area/file.st", text)[0];
    let set: Vec<_> = case
        .set
        .iter()
        .map(|set| (set.before, &*set.name, set.value.clone()))
        .collect();
    assert_eq!(
        set,
        [
            (2, "s", value("STRING#' before '")),
            (3, "in", value("BOOL#TRUE"))
        ]
    );
    let clock: Vec<_> = case
        .clock
        .iter()
        .map(|clock| (clock.before, clock.nanoseconds))
        .collect();
    assert_eq!(clock, [(1, 1_000_000_000), (2, 150_000_000)]);
}

#[test]
fn a_mark_can_be_limited_to_dialects() {
    let body = "r := b.%X3; (*! error P4033 in ironplc-ed2 *)\n(*! values in ironplc-ed3 ironplc-rusty\nr = BOOL#TRUE\n*)";
    let cases = cases("area/file.st", &program("'ironplc'", body));
    let accepted: Vec<_> = cases.iter().map(|case| case.expectation.accepted).collect();
    assert_eq!(
        accepted,
        [Acceptance::Rejected, Acceptance::Required, Acceptance::Required]
    );
    assert_eq!(
        cases
            .iter()
            .map(|case| case.expectation.values.len())
            .collect::<Vec<_>>(),
        [0, 1, 1]
    );
}

#[test]
fn braces_are_braces_in_a_program() {
    let case = one_case("{pragma}} (*! values\n{x} = INT#1\n*)");
    assert_eq!(&*case.expectation.values[0].name, "{x}");
}

#[test]
fn a_program_may_have_carriage_returns_a_byte_order_mark_and_no_last_line_break() {
    let text = program("'matiec'", "x; (*! error P0002 *)\n(*! ok *)").replace('\n', "\r\n");
    let case = &cases("area/file.st", &format!("\u{FEFF}{text}"))[0];
    assert_eq!(case.expectation.diagnostics[0].line, 6);
    assert_eq!(case.expectation.clean_lines, [7]);
    let values = program("'matiec'", "(*! values\nx = INT#1\n*)").replace('\n', "\r\n");
    assert_eq!(
        cases("area/file.st", &values)[0].expectation.values[0].value,
        value("INT#1")
    );
}

#[test]
fn a_header_that_is_missing_or_wrong_is_said() {
    for (text, line, said) in [
        ("PROGRAM main END_PROGRAM", 1, "the file has no header"),
        ("", 1, "the file has no header"),
        ("\n(*! title = ", 2, "the header is not closed"),
        ("x;\n(*! error P4035 *)", 2, "the first mark is not the header"),
        (
            "(*!\ntitle = \"t\"\nbasis = 3\n*)",
            3,
            "`basis`: invalid type: integer `3`, expected a string",
        ),
        ("(*!\ntitle = \"t\"\n*)", 1, "missing field `dialects`"),
        (
            "(*!\ntitle = \"t\"\nbasis = \"b: c\"\ndialects = []\n*)",
            1,
            "at least one dialect",
        ),
        (
            "(*!\ntitle = \"t\"\nbasis = \"b: c\"\ndialects = [\"st\"]\n*)",
            4,
            "no dialect or group `st`",
        ),
        (
            "(*!\ntitle = \"t\"\nbasis = \"b: c\"\nscan = 1\n*)",
            4,
            "unknown field `scan`, expected one of",
        ),
        ("(*!\ntitle = \"t\n*)", 2, "invalid basic string"),
        (
            "(*!\ntitle = \"t\"\nbasis = \"b: c\"\nscans = 0\ndialects = [\"matiec\"]\n*)",
            4,
            "`scans`: 0 scans",
        ),
    ] {
        one_mistake("area/file.st", text, line, said);
    }
}

#[test]
fn a_wrong_setting_in_the_header_is_said() {
    let header = "(*!\ntitle = \"t\"\nbasis = \"b: c\"\ndialects = [\"matiec\"]\n";
    for (rest, line, said) in [
        (
            "[[set]]\nbefore = 0\nname = \"a\"\nvalue = \"INT#1\"\n*)",
            6,
            "`set`: scans count from 1",
        ),
        (
            "[[set]]\nbefore = 1\nname = \"a\"\nvalue = \"INT#x\"\n*)",
            8,
            "`set`: `INT#x` is no typed literal",
        ),
        (
            "[[clock]]\nbefore = 1\nvalue = \"150\"\n*)",
            7,
            "`clock`: `150` is no typed literal",
        ),
        (
            "[[clock]]\nbefore = 1\nvalue = \"INT#1\"\n*)",
            1,
            "the clock is set to a TIME or LTIME, not to `INT#1`",
        ),
        (
            "[[clock]]\nbefore = 2\nvalue = \"TIME#1s\"\n*)",
            1,
            "scan 2 never comes, for `scans` is 1",
        ),
    ] {
        one_mistake("area/file.st", &format!("{header}{rest}"), line, said);
    }
}

#[test]
fn a_wrong_mark_is_said_with_its_line() {
    for (body, line, said) in [
        (
            "(*! eror P4035 *)",
            6,
            "no mark `eror`; there are error, warning, ok",
        ),
        ("\n(*!*)", 7, "the mark is empty"),
        ("(*! error *)", 6, "`error` needs a code"),
        ("(*! error P9876 *)", 6, "P9876"),
        ("(*! error P4035\nP4035 *)", 6, "`error` stands on one line"),
        ("(*! ok maybe *)", 6, "`maybe` is not understood here"),
        ("(*! fault overflow *)", 6, "unknown fault `overflow`"),
        ("(*! observe x *)", 6, "write `observe name : TYPE`"),
        ("(*! observe x : ARRAY OF INT *)", 6, "with the type's name alone"),
        ("(*! values *)", 6, "needs lines `path = literal`"),
        ("(*! values\nx = 5 *)", 7, "`5` is no typed literal"),
        ("(*! values\nx : INT#5 *)", 7, "write `path = literal`"),
        ("(*! values x = INT#5 *)", 6, "`x` is not understood here"),
        ("(*! values after 0\nx = INT#5 *)", 6, "`0` is no scan"),
        (
            "(*! values after 2\nx = INT#5 *)",
            6,
            "scan 2 never comes, for `scans` is 1",
        ),
        ("(*! values\nx = STRING#'(*' *)", 7, "a mark cannot contain `(*`"),
        ("(*! set x = INT#1 *)", 6, "write `set name = LITERAL before N`"),
        ("(*! set x = INT#1 before now *)", 6, "`now` is no scan"),
        ("(*! clock before 1 *)", 6, "write `clock LITERAL before N`"),
        ("(*! ok after 1 *)", 6, "`after` has no meaning in `ok`"),
        ("(*! ok if no *)", 6, "`no` is no condition"),
        ("(*! ok in nowhere *)", 6, "no dialect or group `nowhere`"),
        ("(*! warning *)", 6, "`warning` needs a code: `warning C0195`"),
        (
            "(*! warning P4035 *)",
            6,
            "P4035 is the code of errors; write `error P4035`",
        ),
        (
            "(*! error C0195 *)",
            6,
            "C0195 is the code of warnings; write `warning C0195`",
        ),
        ("(*! ok in *)", 6, "`in` needs a dialect"),
        ("x; (*! ok", 6, "the mark is not closed"),
    ] {
        wrong(body, line, said);
    }
}

#[test]
fn marks_that_contradict_each_other_are_said() {
    for (body, said) in [
        (
            "(*! values\nx = INT#1\n*)\na; (*! error P4035 *)",
            "but values are asserted (in matiec)",
        ),
        (
            "(*! error P4035 *) (*! fault step-limit *)",
            "but a fault is asserted",
        ),
        (
            "(*! error P4035 *) (*! rendered\nx *)",
            "what the renderer gives back is asserted",
        ),
        ("(*! error P4035 *) (*! observe acceptance *)", "apply at once"),
        (
            "(*! error P4035 *) (*! ok *)",
            "`ok` and `error` apply to the same line",
        ),
        (
            "(*! observe acceptance *) (*! ok *)",
            "asserts nothing, but `ok` does",
        ),
        (
            "(*! observe acceptance *) (*! values\nx = INT#1\n*)",
            "asserts nothing, but values are asserted",
        ),
        (
            "(*! values\nx = INT#1\nx = INT#1\n*)",
            "the value of `x` is asserted twice",
        ),
        (
            "(*! values\nx = INT#1\n*) (*! observe x : DINT *)",
            "`x` is observed as DINT and as INT",
        ),
        (
            "(*! fault step-limit *)\n(*! fault step-limit *)",
            "execution stops only once",
        ),
        (
            "(*! rendered\nx *)(*! rendered\nx *)",
            "a program is rendered once",
        ),
    ] {
        let text = program("'matiec'", body);
        let found = crate::common::mistakes("area/file.st", &text);
        assert!(found.len() == 1 && found[0].contains(said), "{said}: {found:?}");
    }
}

#[test]
fn all_wrong_marks_of_a_file_are_said_at_once() {
    let text = program(
        "'matiec'",
        "(*! eror *)\n(*! error P9876 *)\n(*! values\nx = 5\n*)",
    );
    assert_eq!(crate::common::mistakes("area/file.st", &text).len(), 3);
}
