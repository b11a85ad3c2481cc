//! Programs without their marks, for compilers and readers who know nothing of the suite.

use std::sync::Arc;

use crate::model::Case;
use crate::scan::RawMark;

impl Case {
    /// Returns the case with a program without blank lines, and with the lines of the expectation counted in that program.
    pub fn without_blank_lines(&self) -> Case {
        let (program, lines) = without_blank_lines(&self.source);
        let line = |line: u32| match lines.binary_search(&line) {
            Ok(at) | Err(at) => u32::try_from(at + 1).unwrap_or(u32::MAX),
        };
        Case {
            source: program.into(),
            expectation: Arc::new(self.expectation.with_lines(line)),
            ..self.clone()
        }
    }
}

/// Returns a program without its blank lines, and of each line that is left the number that it had.
pub fn without_blank_lines(program: &str) -> (String, Vec<u32>) {
    let (mut filled, mut lines) = (String::with_capacity(program.len()), Vec::new());
    for (line, number) in program.lines().zip(1..) {
        if !line.trim().is_empty() {
            filled.push_str(line.trim_end());
            filled.push('\n');
            lines.push(number);
        }
    }
    (filled, lines)
}

/// Returns a program whose marks are blanks, so that lines and columns stay what they are in the file, and the offset of each mark
/// in that text. Behind the last word of a line and of the program no blanks are left.
pub(crate) fn unmarked(source: &str, marks: &[RawMark<'_>]) -> (String, Vec<usize>) {
    let mut text = String::with_capacity(source.len());
    let mut offsets = Vec::with_capacity(marks.len());
    let mut at = 0;
    for (index, mark) in marks.iter().enumerate() {
        text.push_str(&source[at..mark.start]);
        let ends_line = ends_line(source, &marks[index..]);
        if ends_line {
            text.truncate(text.trim_end_matches(BLANKS).len());
        }
        offsets.push(text.len());
        at = mark.end();
        let blank = |character| if character == '\n' { '\n' } else { ' ' };
        let blanks = source[mark.start..at].chars().map(blank);
        text.extend(blanks.filter(|blank| !ends_line || *blank == '\n'));
        if ends_line {
            at = source.len() - source[at..].trim_start_matches(BLANKS).len();
        }
    }
    let rest = &source[at..];
    if !marks.is_empty() && rest.trim().is_empty() {
        text.truncate(text.trim_end().len());
        text.push('\n');
    } else {
        text.push_str(rest);
    }
    (text, offsets)
}

/// The characters that separate words of a line.
const BLANKS: [char; 2] = [' ', '\t'];

/// Returns whether nothing but marks stands behind the first of these marks on the line on which it ends.
fn ends_line(source: &str, marks: &[RawMark<'_>]) -> bool {
    let mut ends = marks.iter().zip(marks.iter().skip(1).map(Some).chain([None]));
    let last = ends.find(|(mark, next)| {
        let until = next.map_or(source.len(), |next| next.start);
        !source[mark.end()..until].trim_matches(BLANKS).is_empty()
    });
    last.is_none_or(|(mark, _)| {
        let behind = source[mark.end()..].trim_start_matches(BLANKS);
        behind.is_empty() || behind.starts_with(['\n', '\r'])
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::Expectation;
    use crate::scan::scan;

    fn text(source: &str) -> String {
        unmarked(source, &scan(source).marks).0
    }

    #[test]
    fn marks_become_blanks_and_everything_else_stays_where_it_is() {
        let source = "(*!\ntitle = \"t\"\n*)\n\nPROGRAM main (* c *)\n  a := '(*! ok *)';   (*! ok *)  (*! ok *)\n\
                      b(*! ök *):=(*! ok *) c;\n(*! values\na = INT#1\n*) END_PROGRAM\n(*! values\nb = INT#1\n*)\n\n";
        assert_eq!(
            text(source),
            "\n\n\n\nPROGRAM main (* c *)\n  a := '(*! ok *)';\nb         :=          c;\n          \n         \n   END_PROGRAM\n"
        );
    }

    #[test]
    fn a_program_without_marks_stays_as_it_is() {
        for source in ["", "PROGRAM main\r\n\r\nEND_PROGRAM", "  a \n\n"] {
            assert_eq!(text(source), source);
        }
    }

    #[test]
    fn the_offset_of_a_mark_is_that_of_its_blanks() {
        let source = "a (*! ok *)\n{b} (*! ok *) c";
        let (text, offsets) = unmarked(source, &scan(source).marks);
        assert_eq!((text.as_str(), offsets), ("a\n{b}           c", vec![1, 6]));
    }

    #[test]
    fn the_lines_of_an_expectation_follow_those_of_the_program() {
        let mut case = Case::of_program(
            "a",
            stickler_types::DialectName::IEC_ED3,
            "\n \nPROGRAM p  \n\nEND_PROGRAM",
        );
        let clean_lines = vec![3, 5];
        case.expectation = Arc::new(Expectation {
            clean_lines,
            ..Expectation::default()
        });
        let dense = case.without_blank_lines();
        assert_eq!(&*dense.source, "PROGRAM p\nEND_PROGRAM\n");
        assert_eq!(dense.expectation.clean_lines, [1, 2]);
    }
}
