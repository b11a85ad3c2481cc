//! Tests the size of the summary in Markdown; golden texts show the rest.

use super::{MAX_BYTES, markdown};
use crate::sample;
use stickler_mdtest::assert_fits;
use stickler_run::{CaseEvent, Verdict};

#[test]
fn a_page_about_endless_failures_stays_below_one_mebibyte_and_counts_the_rest() {
    let huge = |number: usize| CaseEvent {
        got: vec![sample::reported(3, "", &format!("`|<script>\u{1b}[2J{}", "y".repeat(500))); 100],
        title: "x".repeat(10_000),
        ..sample::case(&number.to_string(), Verdict::Fail)
    };
    let text = markdown(&sample::overview(&sample::run_of((0..600).map(huge).collect())));
    assert!(text.len() <= MAX_BYTES + 1000, "{}", text.len());
    let shown = text.matches("\n### ").count();
    assert!((10..100).contains(&shown), "{shown}");
    assert_fits(&text, &format!("…\n... and {} more…", 600 - shown));
    assert!(!text.contains('\u{1b}'));
}
