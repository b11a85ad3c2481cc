//! Compares expected and actual texts line by line; every format shows the same comparison in its own way.

use similar::algorithms::{Capture, Replace, myers};
use similar::{DiffOp, DiffTag, group_diff_ops};
use std::ops::Range;
use std::time::{Duration, Instant};

/// The time after which a comparison falls back to a coarser one. Texts come from foreign engines and may be of any size.
const TIMEOUT: Duration = Duration::from_millis(200);

/// The number of equal lines that are kept around a difference.
const CONTEXT: usize = 3;

/// A line of a comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DiffLine {
    /// The text that the line comes from.
    pub side: Side,
    /// The pieces of the line, without its end; `true` marks a piece that differs from the line it is compared with.
    pub pieces: Vec<(bool, String)>,
}

/// The text that a line of a comparison comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// A line of both texts.
    Both,
    /// Only the expected text contains the line.
    Expected,
    /// Only the engine's text contains the line.
    Got,
    /// Equal lines were left out here; such a line has no pieces.
    Gap,
}

impl Side {
    /// Returns the character that is printed before a line of this side: a plus, which is mostly green, where the line is to be there, and a
    /// minus where it is not.
    pub const fn sign(self) -> char {
        match self {
            Side::Both | Side::Gap => ' ',
            Side::Expected => '+',
            Side::Got => '-',
        }
    }
}

/// Compares two texts line by line; equal texts give no lines.
pub fn lines(expected: &str, got: &str) -> Vec<DiffLine> {
    let (expected, got) = (split_lines(expected), split_lines(got));
    let operations = compare(&expected, &got);
    let mut lines = Vec::new();
    for (number, group) in group_diff_ops(operations, CONTEXT).iter().enumerate() {
        if number > 0 {
            lines.push(DiffLine {
                side: Side::Gap,
                pieces: Vec::new(),
            });
        }
        for operation in group {
            let old = &expected[operation.old_range()];
            let new = &got[operation.new_range()];
            match operation.tag() {
                DiffTag::Equal => lines.extend(old.iter().map(|line| plain(Side::Both, line))),
                DiffTag::Delete => lines.extend(old.iter().map(|line| plain(Side::Expected, line))),
                DiffTag::Insert => lines.extend(new.iter().map(|line| plain(Side::Got, line))),
                DiffTag::Replace => lines.extend(replaced(old, new)),
            }
        }
    }
    lines
}

/// Compares two sequences by Myers' algorithm, in the one instance of it that this crate compiles: the conveniences of the
/// library instantiate all of its algorithms for each type they are used with, which took longer to compile than this crate.
fn compare(expected: &[&str], got: &[&str]) -> Vec<DiffOp> {
    let mut capture = Replace::new(Capture::new());
    let deadline = Instant::now().checked_add(TIMEOUT);
    let (all_expected, all_got) = (0..expected.len(), 0..got.len());
    let compared = myers::diff_deadline(&mut capture, expected, all_expected, got, all_got, deadline);
    match compared {
        Ok(()) => capture.into_inner().into_ops(),
        Err(never) => match never {},
    }
}

/// Splits a text into its lines, without their ends. An end of the last line makes no difference.
fn split_lines(text: &str) -> Vec<&str> {
    match text.strip_suffix('\n').unwrap_or(text) {
        "" if text.is_empty() => Vec::new(),
        text => text.split('\n').collect(),
    }
}

/// Creates a line in one piece, without marks.
fn plain(side: Side, line: &str) -> DiffLine {
    let pieces = std::iter::once((false, line));
    DiffLine::new(side, pieces)
}

/// Returns the lines of a replacement. The words that differ are marked, unless most of them do.
fn replaced(expected: &[&str], got: &[&str]) -> Vec<DiffLine> {
    let (old, new) = (DiffWords::of(expected), DiffWords::of(got));
    let operations = compare(&old.words, &new.words);
    let equal: usize = operations
        .iter()
        .filter(|operation| operation.tag() == DiffTag::Equal)
        .map(|operation| operation.old_range().len())
        .sum();
    let is_alike = 2 * equal >= old.words.len().max(new.words.len());
    let marked = |range: &dyn Fn(&DiffOp) -> Range<usize>, count: usize| {
        let mut differs = vec![is_alike; count];
        for operation in operations
            .iter()
            .filter(|operation| operation.tag() == DiffTag::Equal)
        {
            differs[range(operation)].fill(false);
        }
        differs
    };
    let mut lines = old.lines(Side::Expected, &marked(&DiffOp::old_range, old.words.len()));
    lines.extend(new.lines(Side::Got, &marked(&DiffOp::new_range, new.words.len())));
    lines
}

/// The words of several lines and the white space between them, in their order.
struct DiffWords<'t> {
    words: Vec<&'t str>,
    /// The end of each line, as an index into `words`.
    ends: Vec<usize>,
}

impl<'t> DiffWords<'t> {
    /// Splits lines into words.
    fn of(lines: &[&'t str]) -> DiffWords<'t> {
        let (mut words, mut ends) = (Vec::new(), Vec::new());
        for line in lines {
            let mut rest = *line;
            while let Some(first) = rest.chars().next() {
                let end = rest.find(|character: char| character.is_whitespace() != first.is_whitespace());
                let (word, behind) = rest.split_at(end.unwrap_or(rest.len()));
                words.push(word);
                rest = behind;
            }
            ends.push(words.len());
        }
        DiffWords { words, ends }
    }

    /// Joins the words into lines again, each word marked as `differs` states. Neighbouring words with the same mark become
    /// one piece.
    fn lines(&self, side: Side, differs: &[bool]) -> Vec<DiffLine> {
        let starts = std::iter::once(0).chain(self.ends.iter().copied());
        let ranges = starts.zip(&self.ends).map(|(start, &end)| start..end);
        ranges
            .map(|range| {
                let words = range.map(|index| (differs[index], self.words[index]));
                DiffLine::new(side, words)
            })
            .collect()
    }
}

impl DiffLine {
    /// Creates a line of these pieces, without the end of line. Empty pieces are left out.
    fn new<'t>(side: Side, words: impl Iterator<Item = (bool, &'t str)>) -> DiffLine {
        let mut pieces: Vec<(bool, String)> = Vec::new();
        for (differs, word) in words {
            match pieces.last_mut() {
                Some((marked, piece)) if *marked == differs => piece.push_str(word),
                _ => pieces.push((differs, word.to_owned())),
            }
        }
        if let Some((_, piece)) = pieces.last_mut() {
            piece.truncate(piece.trim_end_matches('\r').len());
        }
        pieces.retain(|(_, piece)| !piece.is_empty());
        DiffLine { side, pieces }
    }
}

/// Formats the comparison as plain text, with a sign before each line: `-` expected, `+` got.
pub fn text(expected: &str, got: &str) -> String {
    let mut text = String::new();
    for line in lines(expected, got) {
        if line.side == Side::Gap {
            text.push_str("  ...\n");
            continue;
        }
        text.push_str(&format!("{} ", line.side.sign()));
        line.pieces.iter().for_each(|(_, piece)| text.push_str(piece));
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::{Side, lines, text};
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_differences() {
        check_examples("tests/differences.md", |example| {
            match text(example.text("expected"), example.text("got")) {
                same if same.is_empty() => "none".to_owned(),
                differences => differences,
            }
        });
    }

    #[test]
    fn far_apart_differences_leave_out_what_is_equal_between_them() {
        let expected: String = (0..40).map(|n| format!("line {n}\n")).collect();
        let got = expected
            .replace("line 2\n", "LINE 2\n")
            .replace("line 35\n", "LINE 35\n");
        let gaps = lines(&expected, &got)
            .iter()
            .filter(|line| line.side == Side::Gap)
            .count();
        assert_eq!(gaps, 1);
        assert!(text(&expected, &got).contains("+ line 35\n- LINE 35\n"));
    }

    #[test]
    fn the_piece_that_differs_is_marked() {
        let marked: Vec<String> = lines("x is 12 now", "x is 13 now")
            .into_iter()
            .flat_map(|line| line.pieces)
            .filter(|(differs, _)| *differs)
            .map(|(_, piece)| piece)
            .collect();
        assert_eq!(marked, ["12", "13"]);
    }
}
