//! Tests of the examples: what a file shows, and what fits an expected text.

use super::{Document, Example, blessed, check_examples, fits};

/// A file in which each example shows its inputs.
const FILE: &str = "tests/shown.md";

fn shown(example: &Example) -> String {
    let inputs = example.inputs().map(|(name, text)| format!("{name} = {text}"));
    inputs.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_inputs_of_an_example_are_cells_and_blocks() {
    check_examples(FILE, shown);
}

#[test]
#[should_panic(expected = "tests/shown.md:21: The last block is what must come\n--- expected\ninput = one")]
fn an_example_that_differs_is_shown_with_its_place() {
    check_examples(FILE, |_| "other".to_owned());
}

#[test]
fn a_piece_that_is_left_out_stands_for_any_text() {
    for (expected, came, is_so) in [
        ("a", "a", true),
        ("a", "ab", false),
        ("a…", "ab", true),
        ("…b", "ab", true),
        ("a…c…e", "abcde", true),
        ("a…e…c", "abcde", false),
        ("ab…b", "ab", false),
        ("…", "", true),
    ] {
        assert_eq!(fits(expected, came), is_so, "{expected} {came}");
    }
}

#[test]
fn blessing_changes_what_must_come_and_nothing_else() {
    let text = "# T\n\n| a | b |\n|---|---|\n| 1 | 2 \\| 3 |\n\n## S\n```\nold\n```\nend\n";
    let document = Document::parse(text).unwrap_or_else(|mistake| panic!("{mistake:?}"));
    let came = ["x|y\nz", "new\nlines"];
    let differing = document.examples.iter().zip(came);
    let new = blessed(text, differing.map(|((_, expected), came)| (expected, came)));
    assert_eq!(
        new,
        "# T\n\n| a | b |\n|---|---|\n| 1 | x\\|y⏎z |\n\n## S\n```\nnew\nlines\n```\nend\n"
    );
}

#[test]
fn a_file_with_a_mistake_has_no_examples() {
    for (text, line) in [
        ("## S\n", 1),
        ("## S\n```\nx\n", 2),
        ("| a | b |\n|---|---|\n| 1 |\n", 3),
        ("```in\nx\n```\n## S\n| for Y | b |\n|---|---|\n| 1 | 2 |\n", 7),
        (
            "```in\nx\n```\n## S\n| instead of | write | b |\n|---|---|---|\n| y | z | 2 |\n",
            7,
        ),
    ] {
        assert_eq!(
            Document::parse(text).map(|_| ()).map_err(|(line, _)| line),
            Err(line),
            "{text}"
        );
    }
}
