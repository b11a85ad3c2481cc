//! Programs without their marks, for readers who know nothing of the suite.

use std::sync::Arc;

use crate::model::{Case, Expectation, ExpectedDiagnostic, ExpectedFault, ExpectedText};
use crate::scan::scan;

impl Case {
    /// Returns the case with a program that has neither header nor marks, and with the lines of the expectation counted in that
    /// program. Lines on which nothing but marks stood are gone, so that the first line is one of the program.
    #[must_use]
    pub fn without_marks(&self) -> Case {
        let program = unmarked(&self.source);
        let expectation = &*self.expectation;
        let line = |line: u32| program.line(line);
        let moved = |reported: &[ExpectedDiagnostic]| {
            let moved = reported.iter().map(|expected| ExpectedDiagnostic {
                line: line(expected.line),
                ..*expected
            });
            moved.collect()
        };
        Case {
            source: program.text.as_str().into(),
            expectation: Arc::new(Expectation {
                diagnostics: moved(&expectation.diagnostics),
                warnings: moved(&expectation.warnings),
                clean_lines: expectation.clean_lines.iter().map(|clean| line(*clean)).collect(),
                fault: expectation.fault.map(|expected| ExpectedFault {
                    line: line(expected.line),
                    ..expected
                }),
                rendered: expectation.rendered.as_ref().map(|expected| ExpectedText {
                    line: line(expected.line),
                    ..expected.clone()
                }),
                ..expectation.clone()
            }),
            ..self.clone()
        }
    }
}

/// A program without marks.
struct Unmarked {
    text: String,
    /// The number of lines that are left up to and including each line of the marked program.
    left: Vec<u32>,
}

impl Unmarked {
    /// Returns the number of a line; for a line that is gone, that of the one behind it.
    fn line(&self, marked: u32) -> u32 {
        let number = |line: usize| self.left.get(line).copied();
        let at = usize::try_from(marked).unwrap_or(usize::MAX).saturating_sub(1);
        let before = at.checked_sub(1).map_or(Some(0), number);
        before.map_or(marked, |before| before + 1)
    }
}

/// Removes the marks of a program, blanks before them, lines that have nothing else, and empty lines before the first.
fn unmarked(source: &str) -> Unmarked {
    let marks: Vec<(usize, usize)> = scan(source)
        .marks
        .iter()
        .map(|mark| (mark.start, mark.text_start() + mark.text.len() + "*)".len()))
        .collect();
    let mut program = Unmarked {
        text: String::with_capacity(source.len()),
        left: Vec::new(),
    };
    let mut lines = 0;
    let mut start = 0;
    for line in source.split_inclusive('\n') {
        let end = start + line.len();
        let marked = marks.iter().any(|&(from, to)| from < end && to > start);
        let bare = if marked {
            without(source, (start, end), &marks)
        } else {
            line.to_owned()
        };
        let gone = bare.trim().is_empty() && (marked || lines == 0);
        if !gone {
            program.text.push_str(&bare);
            lines += 1;
        }
        program.left.push(lines);
        start = end;
    }
    program
}

/// Returns what stands beside marks in the line between two offsets. A blank takes the place of a mark between other things.
fn without(source: &str, (start, end): (usize, usize), marks: &[(usize, usize)]) -> String {
    let mut text = String::new();
    let mut at = start;
    for &(from, to) in marks.iter().filter(|&&(from, to)| from < end && to > start) {
        text.push_str(source[at..from.max(at)].trim_end());
        text.push(' ');
        at = to.min(end);
    }
    text.push_str(source[at..end].trim_start_matches([' ', '\t']));
    let ends = if text.ends_with('\n') { "\n" } else { "" };
    let mut text = text.trim_end().to_owned();
    text.push_str(ends);
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn marks_are_gone_with_their_lines_and_nothing_else_is() {
        let source = "(*!\ntitle = \"t\"\n*)\n\nPROGRAM main (* c *)\n\n  a := '(*! ok *)';   (*! ok *)\n  b(*! ok *):=(*! ok *) c;\n\
                      (*! values\na = INT#1\n*) END_PROGRAM\n(*! values\nb = INT#1\n*)";
        let program = unmarked(source);
        assert_eq!(
            program.text,
            "PROGRAM main (* c *)\n\n  a := '(*! ok *)';\n  b := c;\n END_PROGRAM\n"
        );
        let lines = |marked: [u32; 6]| marked.map(|line| program.line(line));
        assert_eq!(lines([1, 4, 5, 6, 7, 8]), [1, 1, 1, 2, 3, 4]);
        assert_eq!(lines([9, 10, 11, 12, 14, 99]), [5, 5, 5, 6, 6, 99]);
    }

    #[test]
    fn a_program_without_marks_stays_as_it_is() {
        for source in ["", "PROGRAM main\r\n\r\nEND_PROGRAM", "  a \n\n"] {
            assert_eq!(unmarked(source).text, source);
        }
    }
}
