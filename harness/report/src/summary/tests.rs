//! Tests the summary in Markdown.

use super::{MAX_BYTES, markdown};
use crate::sample;
use stickler_run::{CaseEvent, Cause, Event, Reduced, Verdict};

fn page(events: &[Event]) -> String {
    markdown(&sample::overview(events))
}

#[test]
fn the_page_leads_with_the_claims() {
    let text = page(&sample::run());
    let at = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part:?} in {text}"));
    assert!(at("# Stickler: 1 of 4 cases not as expected") < at("## Claims"));
    assert!(
        at("| **✗** | ironplc-type-conversions |  | Integer widening | 2 | **1** | 0 | 1 | 0 |")
            < at("## Cases")
    );
    assert!(at("| reference | ironplc-ed2 | **3/4** | **3/4** |") < at("## Not as expected"));
    assert!(
        at("### fail: widening/broken@ironplc-ed2 on reference")
            < at("- into = INT#-128\n+ into = INT#128\n")
    );
}

#[test]
fn a_source_has_its_kind_and_leads_to_its_address() {
    let text = page(&sample::with_sources(sample::run()));
    let address = "<https://example.org/Integer widening#integer-widening>";
    assert!(
        text.contains(&format!(
            "| ironplc-type-conversions | document | [Integer widening]({address}) |"
        )),
        "{text}"
    );
    assert!(
        text.contains(&format!(
            "- basis: [ironplc-type-conversions: Integer widening]({address})\n"
        )),
        "{text}"
    );
}

#[test]
fn what_was_judged_by_line_is_compared_by_line() {
    let text = page(&sample::run_by_line());
    assert!(
        text.contains(&format!("{}\n", sample::BY_LINE.join("\n"))),
        "{text}"
    );
}

#[test]
fn several_engines_stand_side_by_side() {
    let on = |engine: &str, case: CaseEvent| CaseEvent {
        engine: engine.to_owned(),
        ..case
    };
    let mut rounds = on("matiec", sample::open_case("open(2.5)"));
    rounds.observations[0].value = "INT#2".to_owned();
    let cases = vec![
        on("matiec", sample::case("a", Verdict::Fail)),
        on("reference", sample::case("a", Verdict::Pass)),
        on("matiec", sample::case("b", Verdict::Unsupported)),
        on("reference", sample::case("b", Verdict::Pass)),
        rounds,
        on("reference", sample::open_case("open(2.5)")),
    ];
    let text = page(&sample::run_on(&["reference", "matiec"], cases));
    for part in [
        "\n| | source | kind | section | reference | matiec |\n|---|---|---|---|--:|--:|\n",
        "\n| **✗** | ironplc-type-conversions |  | Integer widening | 2/2, 1 open | **0/1**, 1 open, 1 unsupported |\n",
        "\n- `` widening/open(2.5) ``, `` r ``: `` INT#3 `` by reference, `` INT#2 `` by matiec\n",
    ] {
        assert!(text.contains(part), "{part}\n{text}");
    }
    let at = |part: &str| text.find(part).unwrap_or_else(|| panic!("no {part:?} in {text}"));
    assert!(at("## Cases") < at("## Where no document decides"));
    assert!(at("## Where no document decides") < at("## Not as expected"));
}

#[test]
fn the_causes_that_are_not_expected_stand_before_the_cases() {
    let mut run = sample::run();
    let causes = [
        ("large", Verdict::Fail, Reduced::Partly),
        ("`a` gives 1", Verdict::Fail, Reduced::Smallest),
        ("known", Verdict::Xfail, Reduced::Partly),
    ];
    let footer = run.len() - 1;
    for (title, verdict, reduction) in causes {
        let cause = Cause {
            reduction,
            ..sample::cause(title, 7, verdict)
        };
        run.insert(footer, Event::Cause(cause));
    }
    let text = page(&run);
    assert!(
        text.contains("\nThe search ended before 1 program, of 7 cases, could be made as small"),
        "{text}"
    );
    let row = "| 7 | \\`a\\` gives 1 | reference | ironplc-type-conversions: Integer widening |\n";
    assert!(text.contains(row), "{text}");
    assert!(!text.contains("known") && !text.contains("large"), "{text}");
    assert!(text.find(row) < text.find("### fail:"), "{text}");
}

#[test]
fn what_a_baseline_says_is_on_the_page() {
    let mut events = sample::run_with_baseline();
    let text = page(&events);
    assert!(
        text.contains("- baseline: b/reference.toml:7 expects fail: rounds (https://example.org/1)\n"),
        "{text}"
    );
    let outdated = "- **out of date** b/reference.toml:12: widening/gone\\* fits no case\n";
    assert!(text.contains(outdated), "{text}");
    events.remove(1);
    assert!(
        page(&events)
            .starts_with("# Stickler: 1 case, all as expected, but 1 entry of a baseline is out of date\n")
    );
}

#[test]
fn a_page_about_endless_failures_stays_below_one_mebibyte_and_counts_the_rest() {
    let huge = |number: usize| CaseEvent {
        got: vec![sample::reported(3, "", &format!("`|<script>\u{1b}[2J{}", "y".repeat(500))); 100],
        title: "x".repeat(10_000),
        ..sample::case(&number.to_string(), Verdict::Fail)
    };
    let text = page(&sample::run_of((0..600).map(huge).collect()));
    assert!(text.len() <= MAX_BYTES + 1000, "{}", text.len());
    let shown = text.matches("\n### ").count();
    assert!((10..100).contains(&shown), "{shown}");
    assert!(
        text.contains(&format!("\n... and {} more", 600 - shown)),
        "the rest is counted"
    );
    assert!(!text.contains('\u{1b}'));
}

#[test]
fn what_an_engine_says_cannot_leave_its_code_block() {
    let case = CaseEvent {
        got: vec![sample::rendered(&["```", "# no heading"])],
        ..sample::case("x", Verdict::Fail)
    };
    let text = page(&sample::run_of(vec![case]));
    assert!(text.contains("````diff\n"), "{text}");
    assert!(text.contains("\n+ # no heading\n````\n"), "{text}");
}

#[test]
fn names_cannot_break_the_tables() {
    let case = CaseEvent {
        basis: "doc: a | b\n<i>".to_owned(),
        ..sample::case("x", Verdict::Pass)
    };
    let text = page(&sample::run_of(vec![case]));
    assert!(text.contains(r"| doc |  | a \| b \<i\> |"), "{text}");
}
