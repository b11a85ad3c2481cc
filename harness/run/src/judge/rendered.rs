//! Rendered text against what a case expects of it, and against itself.

use super::bodies::rendered_bodies;
use super::sheet::Sheet;
use crate::Rendering;
use stickler_engines::Outcome;
use stickler_suite::ExpectedText;

/// Compares the bodies in the rendered text with the expected lines, and requires that rendering again
/// changes nothing and that the rendered program does what the program did.
pub(super) fn compare(expected: &ExpectedText, run: &Outcome, rendering: &Rendering, sheet: &mut Sheet) {
    let Outcome::Rendered { text } = &rendering.first else {
        sheet.require(false);
        return write_refusal("rendering", &rendering.first, sheet);
    };
    let bodies = rendered_bodies(text);
    let wanted = expected
        .lines
        .iter()
        .map(|line| line.trim())
        .filter(|line| !line.is_empty());
    sheet.require(wanted.eq(bodies.iter().copied()));
    bodies.iter().for_each(|line| sheet.line(format_args!("{line}")));
    if let Some(again) = &rendering.again {
        compare_again(text, again, sheet);
    }
    if rendering
        .rerun
        .as_ref()
        .is_some_and(|rerun| !means_the_same(run, rerun))
    {
        sheet.require(false);
        sheet.line(format_args!("the rendered program does something else"));
    }
}

fn compare_again(text: &str, again: &Outcome, sheet: &mut Sheet) {
    match again {
        Outcome::Rendered { text: second } if second == text => {}
        Outcome::Rendered { text: second } => {
            sheet.require(false);
            let differs = text
                .lines()
                .zip(second.lines())
                .position(|(first, second)| first != second);
            let at = differs.unwrap_or_else(|| text.lines().count().min(second.lines().count()));
            let line = second.lines().nth(at).unwrap_or_default().trim();
            sheet.line(format_args!(
                "rendered again, line {} of the text is: {line}",
                at + 1
            ));
        }
        refusal => {
            sheet.require(false);
            write_refusal("rendering the rendered text", refusal, sheet);
        }
    }
}

fn write_refusal(what: &str, outcome: &Outcome, sheet: &mut Sheet) {
    match outcome {
        Outcome::Rejected { diagnostics } => {
            let first = diagnostics.first().map_or("", |diagnostic| &diagnostic.message);
            sheet.line(format_args!("{what} was rejected: {first}"));
        }
        _ => sheet.line(format_args!("{what} gave no text")),
    }
}

/// Whether two runs ended alike. Lines may differ, since comments are dropped.
fn means_the_same(run: &Outcome, rerun: &Outcome) -> bool {
    match (run, rerun) {
        (
            Outcome::Faulted { fault, values, .. },
            Outcome::Faulted {
                fault: fault_again,
                values: values_again,
                ..
            },
        ) => fault == fault_again && values == values_again,
        // A rejected program may have been rendered all the same; then the text must be rejected too, at
        // whatever place.
        (Outcome::Rejected { .. }, Outcome::Rejected { .. }) => true,
        _ => run == rerun,
    }
}
