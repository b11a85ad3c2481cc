//! A block of a test file, and its lines.

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

/// Something that is not as a block says.
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
    #[must_use]
    pub fn kind(&self) -> &str {
        self.words().next().unwrap_or_default()
    }

    /// Returns the other words behind the fence, without what is said of each line.
    pub fn options(&self) -> impl Iterator<Item = &str> {
        self.words().skip(1)
    }

    fn words(&self) -> impl Iterator<Item = &str> {
        let info = self
            .info
            .split_once(EACH_LINE)
            .map_or(&*self.info, |(before, _)| before);
        info.split_whitespace()
    }

    /// Returns the lines that are neither empty nor comments, each with its number from 1.
    pub fn lines(&self) -> impl Iterator<Item = (usize, &str)> {
        let lines = self.text.lines().enumerate();
        lines
            .filter(|(_, line)| !line.trim().is_empty() && !line.starts_with("# "))
            .map(|(index, line)| (index + 1, line))
    }

    /// Returns the programs of the block, each with the number of the line before it.
    #[must_use]
    pub fn programs(&self) -> Vec<(usize, String)> {
        let Some((_, frame)) = self.info.split_once(EACH_LINE) else {
            return vec![(0, self.text.clone())];
        };
        let frame = frame.trim().strip_prefix("in ").unwrap_or("…");
        let framed = |(number, line): (usize, &str)| (number - 1, frame.replace('…', line.trim()));
        self.lines().map(framed).collect()
    }

    /// Hands each row `question = answer` to a function, which says what is wrong with it.
    pub fn rows(&self, mut row: impl FnMut(&str, &str) -> Result<(), String>) -> Vec<Difference> {
        let mut differences = Vec::new();
        for (number, line) in self.lines() {
            let result = match line
                .rsplit_once(" = ")
                .or_else(|| Some((line.strip_suffix(" =")?, "")))
            {
                Some((question, answer)) => row(question.trim(), answer.trim()),
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
