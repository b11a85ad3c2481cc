//! Expected beside got, line by line: one comparison that every format shows in its own way.

use similar::{ChangeTag, TextDiff, TextDiffConfig};
use std::borrow::Cow;
use std::fmt::Write;
use std::time::Duration;

/// How long a comparison may take before it falls back to a coarser one. Texts come from foreign engines and may be
/// of any size.
const PATIENCE: Duration = Duration::from_millis(200);

/// How many equal lines stand around a difference.
const CONTEXT: usize = 3;

/// One line of a comparison.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct DiffLine {
    /// On which side it stands.
    pub side: Side,
    /// Its pieces; `true` marks a piece that differs from the line it is compared with. Without the end of line.
    pub pieces: Vec<(bool, String)>,
}

/// Where a line of a comparison comes from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Side {
    /// Both texts have it.
    Both,
    /// Only the expected text has it.
    Expected,
    /// Only the engine's text has it.
    Got,
    /// Equal lines were left out here; it has no pieces.
    Gap,
}

impl Side {
    /// The character that stands before such a line.
    pub const fn sign(self) -> char {
        match self {
            Side::Both | Side::Gap => ' ',
            Side::Expected => '-',
            Side::Got => '+',
        }
    }
}

/// Compares two texts line by line; equal texts give no lines.
pub fn lines(expected: &str, got: &str) -> Vec<DiffLine> {
    let (expected, got) = (ended(expected), ended(got));
    let diff: TextDiff<'_, '_, str> = TextDiffConfig::default()
        .timeout(PATIENCE)
        .diff_lines(&*expected, &*got);
    let mut lines = Vec::new();
    for (number, group) in diff.grouped_ops(CONTEXT).iter().enumerate() {
        if number > 0 {
            lines.push(DiffLine {
                side: Side::Gap,
                pieces: Vec::new(),
            });
        }
        for operation in group {
            lines.extend(diff.iter_inline_changes(operation).map(|change| DiffLine {
                side: side(change.tag()),
                pieces: pieces(change.values()),
            }));
        }
    }
    lines
}

/// The comparison as plain text, a sign before each line: `-` expected, `+` got.
pub fn text(expected: &str, got: &str) -> String {
    let mut text = String::new();
    for line in lines(expected, got) {
        if line.side == Side::Gap {
            text.push_str("  ...\n");
            continue;
        }
        // Writing to a String cannot fail.
        let _ = write!(text, "{} ", line.side.sign());
        line.pieces.iter().for_each(|(_, piece)| text.push_str(piece));
        text.push('\n');
    }
    text
}

/// A text whose last line ends, too: the end of a line is part of what is compared.
fn ended(text: &str) -> Cow<'_, str> {
    if text.is_empty() || text.ends_with('\n') {
        Cow::from(text)
    } else {
        Cow::from(format!("{text}\n"))
    }
}

fn side(tag: ChangeTag) -> Side {
    match tag {
        ChangeTag::Equal => Side::Both,
        ChangeTag::Delete => Side::Expected,
        ChangeTag::Insert => Side::Got,
    }
}

fn pieces(values: &[(bool, &str)]) -> Vec<(bool, String)> {
    values
        .iter()
        .map(|(differs, piece)| (*differs, piece.trim_end_matches(['\n', '\r']).to_owned()))
        .filter(|(_, piece)| !piece.is_empty())
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{Side, lines, text};

    #[test]
    fn a_changed_value_stands_beside_the_value_expected() {
        assert_eq!(text("r = INT#-5", "r = INT#251"), "- r = INT#-5\n+ r = INT#251\n");
    }

    #[test]
    fn equal_texts_have_no_difference() {
        assert!(lines("a\nb\n", "a\nb\n").is_empty());
    }

    #[test]
    fn a_last_line_is_the_same_where_the_other_text_goes_on() {
        assert_eq!(text("a\nb", "a\nb\nc"), "  a\n  b\n+ c\n");
        assert_eq!(text("a\nb\nc", "b"), "- a\n  b\n- c\n");
        assert_eq!(text("", "b"), "+ b\n");
        assert!(lines("a\nb\n", "a\nb").is_empty());
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
        assert!(text(&expected, &got).contains("- line 35\n+ LINE 35\n"));
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
