//! Tests of the size of the summary; golden texts show what it holds.

use super::{Detail, SHOWN_FAILURES, Surroundings, write};
use crate::sample;
use stickler_mdtest::assert_fits;
use stickler_run::{CaseEvent, Event, SourceKind, Verdict};

fn shown(events: &[Event]) -> String {
    shown_with(events, Surroundings::default())
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
fn thousands_of_failures_are_counted_and_not_all_shown() {
    let cases = (0..3000)
        .map(|number| sample::case(&number.to_string(), Verdict::Crash))
        .collect();
    let text = shown(&sample::run_of(cases));
    assert_eq!(text.matches("CRASH").count(), SHOWN_FAILURES);
    let rest = 3000 - SHOWN_FAILURES;
    assert_fits(
        &text,
        &format!(
            "…and {} more that are not as expected; all are in…",
            stickler_types::grouped(rest as u64)
        ),
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
    let kinds = {
        use SourceKind::{Document, Measurement, Recording, Rule, Standard};
        [Document, Measurement, Recording, Rule, Standard]
    };
    header.sources = vec![header.sources[0].clone(); 50];
    for (number, source) in header.sources.iter_mut().enumerate() {
        source.key = format!("source-{number}");
        source.kind = kinds[number % kinds.len()];
    }
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
    let table = include_str!("tests/large.txt");
    assert!(text.contains(table) && !text.contains("not shown"), "{text}");
    let many = shown(&large(&["reference"], 11, Verdict::Fail));
    assert_fits(
        &many,
        "…\n  2 more rows are not shown; --verbose and summary.md have all\n…",
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
