//! Tests of the summary as a whole.

use super::{Detail, SHOWN_FAILURES, Surroundings, write};
use crate::sample;
use stickler_run::{CaseEvent, Event, SourceHeader, Verdict};

fn shown(events: &[Event]) -> String {
    shown_with(events, Surroundings::default())
}

/// Returns whether a line is the last one before that of the page.
fn ends(text: &str, result: &str) -> bool {
    text.ends_with(&format!("{result}\nPage: reports/latest/index.html\n"))
}

fn shown_with(events: &[Event], around: Surroundings<'_>) -> String {
    let overview = sample::overview(events);
    let mut bytes = Vec::new();
    write(
        &mut bytes,
        &overview,
        Surroundings {
            reports: Some("reports/latest"),
            ..around
        },
    )
    .expect("written");
    anstream::adapter::strip_str(&String::from_utf8(bytes).expect("text")).to_string()
}

#[test]
fn a_failure_shows_all_that_is_needed_to_look_into_it_and_the_end_says_how_it_went() {
    assert_eq!(
        shown(&sample::run()),
        "\
FAIL widening/broken@ironplc-ed2
     SINT widens to INT
     basis    ironplc-type-conversions: Integer widening
     at       conformance-cases/widening/integer.toml:7
     expected - into = INT#-128
     got      + into = INT#128
     rerun    stickler run --filter 'widening/broken@ironplc-ed2'

Claims                      passed  failed  open
  ironplc-type-conversions       2       1     1
    Integer widening             2       1     1

Cases          widening  all
  ironplc-ed2       3/4  3/4
  n/m: n of m cases are as expected

1 observation where no document says what must be.
Engine: reference 0.1.0.
1 case is otherwise than documents say, with a page for each cause:
reports/latest/discrepancies
1 of 4 cases not as expected (1 fail), in 34 ms.
Page: reports/latest/index.html
"
    );
}

#[test]
fn texts_of_several_lines_are_shown_as_a_diff() {
    let case = CaseEvent {
        expected: vec![sample::rendered(&["a := 1;", "b := 2;"])],
        got: vec![sample::rendered(&["a := 1;", "b := 3;"])],
        ..sample::case("x", Verdict::Fail)
    };
    let text = shown(&sample::run_of(vec![case]));
    let diff = "\
     diff     - expected + got
                a := 1;
              - b := 2;
              + b := 3;
";
    assert!(text.contains(diff), "{text}");
}

#[test]
fn a_run_without_failures_says_so_and_names_no_section() {
    let text = shown(&sample::run_of(vec![
        sample::case("a", Verdict::Pass),
        sample::case("b", Verdict::Xfail),
    ]));
    assert!(
        ends(&text, "2 cases in 34 ms: all as expected (1 xfail)."),
        "{text}"
    );
}

#[test]
fn a_difference_is_no_failure_and_is_counted_apart() {
    let text = shown(&sample::run_of(vec![
        sample::case("a", Verdict::Pass),
        sample::case("b", Verdict::Differs),
    ]));
    assert!(text.contains("passed  failed  differs  open\n"), "{text}");
    assert!(
        text.contains("1 case differs from a source that does not bind the engine."),
        "{text}"
    );
    assert!(
        ends(&text, "2 cases in 34 ms: all as expected (1 differs)."),
        "{text}"
    );
}

#[test]
fn a_run_of_which_nothing_was_executed_does_not_end_as_if_all_were_well() {
    let unsupported = |id| sample::case(id, Verdict::Unsupported);
    let text = shown(&sample::run_of(vec![unsupported("a"), unsupported("b")]));
    assert!(
        ends(
            &text,
            "2 cases in 34 ms: nothing was tested, since all are unsupported."
        ),
        "{text}"
    );
    let text = shown(&sample::run_of(vec![
        sample::case("a", Verdict::Pass),
        unsupported("b"),
    ]));
    assert!(ends(&text, "all as expected (1 unsupported)."), "{text}");
}

#[test]
fn several_engines_stand_side_by_side() {
    let on = |engine: &str, case: CaseEvent| CaseEvent {
        engine: engine.to_owned(),
        ..case
    };
    let mut rounds = on("matiec", sample::open_case("open"));
    rounds.observations[0].value = "INT#2".to_owned();
    let cases = vec![
        on("reference", sample::case("a", Verdict::Pass)),
        on("matiec", sample::case("a", Verdict::Fail)),
        on("reference", sample::open_case("open")),
        rounds,
    ];
    let text = shown(&sample::run_on(&["reference", "matiec"], cases));
    let table = "
Claims                      reference  matiec
  ironplc-type-conversions          1     0/1
    Integer widening                1     0/1
  n/m: n of m cases came out as the source says
";
    assert!(text.contains(table), "{text}");
    assert!(
        text.contains("\n1 observation differs between the engines: see summary.md.\n"),
        "{text}"
    );
}

#[test]
fn a_claim_shows_the_kind_of_its_source() {
    let text = shown(&sample::with_sources(sample::run()));
    let table = "
Claims                      kind      passed  failed  open
  ironplc-type-conversions  document       2       1     1
    Integer widening                       2       1     1
";
    assert!(text.contains(table), "{text}");
}

#[test]
fn what_a_baseline_says_stands_with_the_case_and_what_is_out_of_date_with_the_end() {
    let mut events = sample::run_with_baseline();
    let text = shown(&events);
    let note =
        "     baseline b/reference.toml:7 expects fail: rounds (https://example.org/1)\n     rerun    ";
    assert!(text.contains(note), "{text}");
    let outdated = "OUTDATED b/reference.toml:12: widening/gone* fits no case\n1 of 2 cases";
    assert!(text.contains(outdated), "{text}");
    // What is expected is not shown, and yet not all is well.
    events.remove(1);
    let text = shown(&events);
    assert!(
        ends(
            &text,
            "all as expected (1 xfail), but 1 entry of a baseline is out of date."
        ),
        "{text}"
    );
}

#[test]
fn a_run_that_was_not_judged_by_code_and_line_says_so() {
    let text = shown(&sample::run_by_line());
    let engine = "Engine: reference 0.1.0 (rejections judged by line).\n";
    assert!(text.contains(engine), "{text}");
}

#[test]
fn what_was_judged_by_line_is_compared_by_line() {
    let text = shown(&sample::run_by_line());
    for line in sample::BY_LINE {
        assert!(text.contains(line), "{line} in {text}");
    }
}

#[test]
fn thousands_of_failures_are_counted_and_not_all_shown() {
    let cases = (0..3000)
        .map(|number| sample::case(&number.to_string(), Verdict::Crash))
        .collect();
    let text = shown(&sample::run_of(cases));
    assert_eq!(text.matches("CRASH").count(), SHOWN_FAILURES);
    let rest = 3000 - SHOWN_FAILURES;
    assert!(
        text.contains(&format!(
            "and {} more that are not as expected; all are in",
            stickler_types::grouped(rest as u64)
        )),
        "{text}"
    );
}

#[test]
fn where_causes_are_known_single_failures_are_shown_only_when_asked_for() {
    let cause = sample::cause("it widens nothing", 1, Verdict::Fail);
    let events = sample::with_causes(sample::run(), [cause]);
    let text = shown(&events);
    assert!(
        text.starts_with("Cases  Cause\n    1  it widens nothing\n"),
        "{text}"
    );
    assert!(!text.contains("FAIL"), "{text}");
    let overview = sample::overview(&events);
    let mut bytes = Vec::new();
    let around = Surroundings {
        failures: Some(1),
        ..Surroundings::default()
    };
    write(&mut bytes, &overview, around).expect("written");
    assert!(String::from_utf8_lossy(&bytes).contains("FAIL"));
}

#[test]
fn a_run_that_was_cut_short_says_so_last() {
    let events = sample::run();
    let end = "\nCut short after 2 cases.\nLog: reports/latest/events.jsonl, as far as the run came\n";
    assert!(shown(&events[..3]).ends_with(end));
}

#[test]
fn a_run_of_a_broken_suite_does_not_end_as_if_all_were_well() {
    let mut events = sample::run_of(vec![sample::case("a", Verdict::Pass)]);
    sample::header(&mut events).broken_files = vec!["a.st:1: wrong".to_owned()];
    let text = shown(&events);
    assert!(
        text.contains("\n1 mistake in case files: some cases were not run.\n1 case in"),
        "{text}"
    );
}

/// Returns a run of many sources and dialects, in which the cases of the last sources have the given verdict on each engine.
fn large(engines: &[&str], last_sources: usize, last: Verdict) -> Vec<Event> {
    let mut cases = Vec::new();
    for engine in engines {
        for number in 0..50 {
            let areas = [
                "bit-access",
                "conversion",
                "found",
                "language",
                "rendering",
                "widening",
            ];
            let verdict = if number >= 50 - last_sources {
                last
            } else {
                Verdict::Pass
            };
            let case = if number == 3 {
                sample::open_case("o")
            } else {
                sample::case("a", verdict)
            };
            cases.push(CaseEvent {
                id: format!("widening/{number}"),
                engine: (*engine).to_owned(),
                dialect: format!("a-dialect-of-a-long-name-{}", number % 20),
                basis: format!(
                    "source-{number}: A section of many words that is longer than forty characters"
                ),
                area: areas[number % areas.len()].to_owned(),
                ..case
            });
        }
    }
    let mut events = sample::with_sources(sample::run_on(engines, cases));
    let header = sample::header(&mut events);
    let kinds = ["document", "measurement", "recording", "rule", "standard"];
    let of = |number: usize| SourceHeader {
        key: format!("source-{number}"),
        kind: kinds[number % kinds.len()].to_owned(),
        ..header.sources[0].clone()
    };
    header.sources = (0..50).map(of).collect();
    events
}

#[test]
fn a_large_run_in_which_all_is_well_fits_a_screen_whatever_its_width() {
    for engines in [&["reference"][..], &["reference", "matiec"]] {
        for width in [60, 80, 100, 200] {
            let around = Surroundings {
                width: Some(width),
                from_cache: 7,
                ..Surroundings::default()
            };
            let text = shown_with(&large(engines, 1, Verdict::Differs), around);
            assert!(text.lines().count() <= 24, "{text}");
            let widest = text.lines().map(|line| line.chars().count()).max();
            assert!(widest <= Some(width), "{width}: {text}");
        }
    }
}

#[test]
fn many_sources_are_summed_up_by_kind_and_those_that_are_not_met_are_named() {
    let text = shown(&large(&["reference"], 1, Verdict::Fail));
    let table = "
Claims                                          sources  passed  failed  open
  document                                           10      10       0     0
  measurement                                        10      10       0     0
  recording                                          10      10       0     0
  rule                                               10       9       0     1
  standard                                           10       9       1     0
    source-49                                                 0       1     0
      A section of many words that is longer …                0       1     0

Cases         reference
  bit-access          9
  conversion        8/9
";
    assert!(text.contains(table) && !text.contains("not shown"), "{text}");
    let many = shown(&large(&["reference"], 11, Verdict::Fail));
    assert!(
        many.contains("\n  2 more rows are not shown; --verbose and summary.md have all\n"),
        "{many}"
    );
    let whole = Surroundings {
        detail: Detail::Whole,
        ..Surroundings::default()
    };
    let text = shown_with(&large(&["reference"], 1, Verdict::Fail), whole);
    for row in [
        "\n  source-0 ",
        "\n  source-48 ",
        "\n  a-dialect-of-a-long-name-19 ",
    ] {
        assert!(text.contains(row), "{row} in {text}");
    }
}

#[test]
fn where_only_the_result_is_asked_for_two_lines_are_shown() {
    let around = Surroundings {
        detail: Detail::Result,
        ..Surroundings::default()
    };
    let text = shown_with(&sample::run(), around);
    let expected = "1 of 4 cases not as expected (1 fail), in 34 ms.\nPage: reports/latest/index.html\n";
    assert_eq!(text, expected);
}

#[test]
fn tables_and_causes_are_no_wider_than_the_terminal() {
    let cause = sample::cause(&"a long title ".repeat(30), 1, Verdict::Fail);
    let events = sample::with_causes(large(&["reference", "matiec"], 1, Verdict::Fail), [cause]);
    for (width, detail) in [60, 100, 200]
        .into_iter()
        .flat_map(|width| [Detail::Summary, Detail::Whole].map(|detail| (width, detail)))
    {
        let around = Surroundings {
            width: Some(width),
            detail,
            failures: Some(0),
            ..Surroundings::default()
        };
        let text = shown_with(&events, around);
        let widest = text.lines().map(|line| line.chars().count()).max();
        assert!(widest <= Some(width), "{width}: {text}");
    }
}
