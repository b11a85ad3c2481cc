//! A block of a test file, and its lines.

use crate::Marks;
use std::fmt::Display;

/// A fenced block of a test file.
pub struct Block {
    /// The nearest heading above the block.
    pub heading: String,
    /// What stands behind the fence.
    pub info: String,
    /// The text between the fences; every line of it ends with a line feed.
    pub text: String,
    /// The line of the file on which the text begins, from 1.
    pub line: usize,
}

/// A program of a block.
pub struct Program {
    /// The text of the program.
    pub text: String,
    /// The line of the block on which it stands alone, from 1.
    row: Option<usize>,
    /// Whether its marks hold for the line of the program on which they stand.
    has_lines: bool,
}

impl Program {
    /// Reads the marks of the program. A program on a line of its own may be wrong on any line of its frame, unless it begins
    /// lines with pilcrows: then each mark is about the line on which it stands.
    ///
    /// # Errors
    /// What is wrong with a mark.
    pub fn marks(&self) -> Result<Marks, Difference> {
        let marks = Marks::of(&self.text).map_err(|wrong| self.place(Difference::new(1, wrong)))?;
        Ok(if self.has_lines {
            marks
        } else {
            marks.on_any_line()
        })
    }

    /// Returns a difference on a line of the program as one on a line of the block.
    pub fn place(&self, difference: Difference) -> Difference {
        let line = self.row.unwrap_or(difference.line);
        Difference { line, ..difference }
    }
}

/// A difference between what a block says and what came.
#[derive(PartialEq, Eq, Debug)]
pub struct Difference {
    /// The line of the block, from 1.
    pub line: usize,
    /// What was expected there, and what came.
    pub what: String,
}

impl Difference {
    /// A difference on a line of a block.
    pub fn new(line: usize, what: impl Into<String>) -> Difference {
        let what = what.into();
        Difference { line, what }
    }
}

/// The words with which a block begins whose lines are programs of their own.
const EACH_LINE: &str = " each line";

impl Block {
    /// Returns the first word behind the fence: what the block is.
    pub fn kind(&self) -> &str {
        self.words().next().unwrap_or_default()
    }

    /// Returns the other words behind the fence, without what is said of each line.
    pub fn options(&self) -> impl Iterator<Item = &str> {
        self.words().skip(1)
    }

    fn words(&self) -> impl Iterator<Item = &str> {
        let info = self.info.split(EACH_LINE).next().unwrap_or_default();
        let info = info.split(" in ").next().unwrap_or_default();
        info.split_whitespace()
    }

    /// Returns the lines that are neither empty nor comments, each with its number from 1.
    pub fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.text.lines().enumerate();
        lines
            .filter(|(_, line)| !line.trim().is_empty() && !line.starts_with("# "))
            .map(|(index, line)| (index + 1, line))
    }

    /// Returns the programs of the block, with their repetitions [written out](expanded): its text, or one for each line, in the frame that the fence may name. A pilcrow begins a
    /// new line in both.
    pub fn programs(&self) -> Vec<Program> {
        let Some((_, frame)) = self.info.split_once(EACH_LINE) else {
            let text = expanded(&self.text);
            return vec![Program {
                text,
                row: None,
                has_lines: true,
            }];
        };
        let frame = frame.trim().strip_prefix("in ").unwrap_or("…");
        let framed = |(number, line): (usize, &str)| Program {
            text: expanded(&frame.replace('…', line.trim()).replace('¶', "\n")),
            row: Some(number),
            has_lines: line.contains('¶'),
        };
        self.lines().map(framed).collect()
    }

    /// Puts the question of a row in the frame that the fence names: `features in PROGRAM p … END_PROGRAM`.
    pub fn framed(&self, question: &str) -> String {
        let frame = self.info.split_once(" in ").map_or("…", |(_, frame)| frame);
        frame.replace('¶', "\n").replace('…', question)
    }

    /// Hands each row `question = answer` to a function, which says what is wrong with it. An arrow may stand for the equals sign,
    /// a pilcrow begins a new line, repetitions are written out, and backticks keep the spaces at the ends of a question.
    pub fn rows(&self, mut row: impl FnMut(&str, &str) -> Result<(), String>) -> Vec<Difference> {
        let mut differences = Vec::new();
        for (number, line) in self.lines() {
            let parts = line.rsplit_once(" → ").or_else(|| line.rsplit_once(" = "));
            let result = match parts {
                Some((question, answer)) => {
                    let question = question.trim();
                    let quoted = question.strip_prefix('`').and_then(|rest| rest.strip_suffix('`'));
                    row(
                        &expanded(&quoted.unwrap_or(question).replace('¶', "\n")),
                        answer.trim(),
                    )
                }
                None => Err("a row has the form `question = answer`".to_owned()),
            };
            differences.extend(
                result
                    .err()
                    .map(|what| Difference::new(number, format!("{line}\n{what}"))),
            );
        }
        differences
    }
}

/// Compares what came with what was expected.
///
/// # Errors
/// Both, where they differ.
pub fn same<T: PartialEq + Display>(got: T, expected: T) -> Result<(), String> {
    if got == expected {
        Ok(())
    } else {
        Err(format!("     got {got}\nexpected {expected}"))
    }
}

/// Writes each `«text ×1000»` out: the text so many times. In it `{n}` is the number of the repetition from 0, and `{rest}` how
/// many are to come; either may have something added: `{n+1}`.
///
/// # Panics
/// Where a repetition has no number, or does not end.
pub fn expanded(text: &str) -> String {
    let mut parts = text.split('«');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (repeated, after) = part.split_once('»').expect("the end of a repetition");
        let (repeated, times) = repeated.rsplit_once(" ×").expect("a number of repetitions");
        let times: usize = times.parse().expect("a number of repetitions");
        if repeated.contains(['{']) {
            (0..times).for_each(|n| out += &numbered(repeated, n, times - 1 - n));
        } else {
            out += &repeated.repeat(times);
        }
        out += after;
    }
    out
}

/// Replaces the counters of one repetition.
fn numbered(repeated: &str, n: usize, rest: usize) -> String {
    let mut parts = repeated.split('{');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (counter, after) = part.split_once('}').expect("the end of a counter");
        let (name, more) = counter.split_once('+').unwrap_or((counter, "0"));
        let value = if name == "n" { n } else { rest };
        out += &(value + more.parse::<usize>().expect("a number")).to_string();
        out += after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::{Block, expanded};

    #[test]
    fn a_mark_is_about_any_line_unless_the_row_has_lines() {
        let block = Block {
            heading: String::new(),
            info: "st each line in a¶…".to_owned(),
            text: "x (*! error P1 *)\ny¶z (*! error P1 *)\n".to_owned(),
            line: 1,
        };
        let line = |program: super::Program| program.marks().expect("marks").diagnostics[0].line;
        let lines: Vec<u32> = block.programs().into_iter().map(line).collect();
        assert_eq!(lines, [0, 3]);
    }

    #[test]
    fn repetitions_are_written_out_with_their_numbers() {
        assert_eq!(
            expanded("a«( ×3»b«, v{n} : v{rest+2}; ×2»c"),
            "a(((b, v0 : v3;, v1 : v2;c"
        );
        assert_eq!(expanded("plain"), "plain");
    }
}
