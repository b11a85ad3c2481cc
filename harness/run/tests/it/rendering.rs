//! Tests of judging rendered text.

use crate::fixtures::{executed, expecting, rejected};
use stickler_engines::Outcome;
use stickler_run::{Answers, Fact, Grade, Judgement, Rendering, Verdict, judge};
use stickler_suite::{Expectation, ExpectedText};

const TEXT: &str = "PROGRAM main\n    VAR\n        r : BOOL;\n    END_VAR\n    r := w.3;\nEND_PROGRAM\n";

fn judged(run: Outcome, first: Outcome, again: Outcome, rerun: Outcome) -> Judgement {
    let lines = vec!["".into(), "  r := w.3;".into()];
    let expectation = Expectation {
        rendered: Some(ExpectedText { lines, line: 8 }),
        ..Expectation::default()
    };
    let rendering = Rendering {
        first,
        again: Some(again),
        rerun: Some(rerun),
    };
    judge(
        &expecting(expectation),
        &Answers {
            run,
            rendering: Some(rendering),
        },
        Grade::Code,
    )
}

fn text(text: &str) -> Outcome {
    Outcome::Rendered {
        text: text.to_owned(),
    }
}

#[test]
fn the_bodies_are_compared_line_by_line_and_trimmed() {
    let good = judged(executed(&[]), text(TEXT), text(TEXT), executed(&[]));
    assert_eq!(
        (good.verdict, Fact::text(&good.got).as_str()),
        (Verdict::Pass, "r := w.3;")
    );
    let other = TEXT.replace("w.3", "w.%X3");
    let bad = judged(executed(&[]), text(&other), text(&other), executed(&[]));
    assert_eq!(
        (bad.verdict, Fact::text(&bad.got).as_str()),
        (Verdict::Fail, "r := w.%X3;")
    );
    let longer = TEXT.replace("r := w.3;", "r := w.3;\nr := w.3;");
    assert_eq!(
        judged(executed(&[]), text(&longer), text(&longer), executed(&[])).verdict,
        Verdict::Fail
    );
}

#[test]
fn rendering_again_must_change_nothing_not_even_outside_the_bodies() {
    let other = TEXT.replace("    VAR", "  VAR");
    let judgement = judged(executed(&[]), text(TEXT), text(&other), executed(&[]));
    let got = "r := w.3;\nrendered again, line 2 of the text is: VAR";
    assert_eq!(
        (judgement.verdict, Fact::text(&judgement.got).as_str()),
        (Verdict::Fail, got)
    );
    let shorter = TEXT.trim_end();
    assert_eq!(
        judged(executed(&[]), text(TEXT), text(shorter), executed(&[])).verdict,
        Verdict::Fail
    );
}

#[test]
fn a_rendered_text_that_is_rejected_is_told_with_the_line() {
    let again = |diagnostic: &str| {
        let judgement = judged(executed(&[]), text(TEXT), rejected(&[diagnostic]), executed(&[]));
        Fact::text(&judgement.got)
    };
    let reported = again("5 P0002");
    assert!(reported.ends_with(", at `r := w.3;`"), "{reported}");
    assert!(!again("9 P0002").contains('`'), "the text has no such line");
}

#[test]
fn the_rendered_program_must_do_what_the_program_did() {
    let same = |rerun: Outcome| judged(executed(&["x = INT#1"]), text(TEXT), text(TEXT), rerun).verdict;
    assert_eq!(same(executed(&["x = INT#1"])), Verdict::Pass);
    assert_eq!(same(executed(&["x = INT#2"])), Verdict::Fail);
    assert_eq!(same(rejected(&["1 P0002"])), Verdict::Fail);
    assert_eq!(
        same(Outcome::Crashed {
            reason: "gone".to_owned()
        }),
        Verdict::Crash
    );
}

#[test]
fn an_engine_that_refuses_to_render_fails_or_is_unsupported() {
    let refused = |first: Outcome| {
        let expectation = Expectation {
            rendered: Some(ExpectedText {
                lines: vec![],
                line: 8,
            }),
            ..Expectation::default()
        };
        let rendering = Some(Rendering {
            first,
            again: None,
            rerun: None,
        });
        judge(
            &expecting(expectation),
            &Answers {
                run: executed(&[]),
                rendering,
            },
            Grade::Code,
        )
    };
    let judgement = refused(rejected(&["1 P0002"]));
    assert_eq!(
        (judgement.verdict, Fact::text(&judgement.got).as_str()),
        (Verdict::Fail, "rendering was rejected: told")
    );
    assert_eq!(
        Fact::text(&refused(Outcome::ACCEPTED).got),
        "rendering gave no text"
    );
    assert_eq!(
        refused(Outcome::Unsupported {
            reason: String::new()
        })
        .verdict,
        Verdict::Unsupported
    );
}
