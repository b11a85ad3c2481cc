//! Converts byte offsets to the lines of a case file.

use toml::Spanned;

use crate::error::Mistake;

/// The lines of a text, for looking up offsets in it.
#[derive(Debug)]
pub(crate) struct Lines {
    /// The byte offset after each line break.
    starts: Vec<usize>,
}

impl Lines {
    pub(crate) fn new(text: &str) -> Lines {
        let starts = text
            .bytes()
            .enumerate()
            .filter(|&(_, byte)| byte == b'\n')
            .map(|(at, _)| at + 1);
        Lines {
            starts: starts.collect(),
        }
    }

    /// Returns the 1-based line on which a value stands.
    pub(crate) fn of<T>(&self, value: &Spanned<T>) -> u32 {
        self.line(value.span().start)
    }

    /// Returns a mistake in the value of a key.
    pub(crate) fn mistake<T>(
        &self,
        value: &Spanned<T>,
        key: impl Into<String>,
        message: impl Into<String>,
    ) -> Mistake {
        Mistake::new(self.of(value), message).key(key)
    }

    /// Returns the 1-based line of a byte offset. O(log n).
    pub(crate) fn line(&self, offset: usize) -> u32 {
        let line = self.starts.partition_point(|&start| start <= offset) + 1;
        u32::try_from(line).unwrap_or(u32::MAX)
    }
}

/// The position in a case file of a text that is taken from it, such as the source of a probe.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct TextPlace {
    /// The line of the file on which the text's first line stands.
    pub(crate) first: u32,
    /// Whether the text has a line of the file for each of its own.
    pub(crate) line_by_line: bool,
}

impl TextPlace {
    /// The position of a text that is a whole file.
    pub(crate) const FILE: TextPlace = TextPlace {
        first: 1,
        line_by_line: true,
    };

    /// Returns the position of a TOML string whose source text, including the quotes, begins at `start` of `file`.
    ///
    /// A backslash that joins a line to the next is not recognized: the numbers of later lines are then too small.
    pub(crate) fn of_toml_string(file: &str, lines: &Lines, start: usize) -> TextPlace {
        let quoted = file.get(start..).unwrap_or_default();
        let first = lines.line(start);
        let Some(inside) = quoted
            .strip_prefix("\"\"\"")
            .or_else(|| quoted.strip_prefix("'''"))
        else {
            return TextPlace {
                first,
                line_by_line: false,
            };
        };
        let trimmed = inside.starts_with('\n') || inside.starts_with("\r\n");
        TextPlace {
            first: first + u32::from(trimmed),
            line_by_line: true,
        }
    }

    /// Returns the line of the file for a 1-based line of the text.
    pub(crate) fn line(self, line: u32) -> u32 {
        if self.line_by_line {
            self.first.saturating_add(line.saturating_sub(1))
        } else {
            self.first
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_counted_from_one() {
        let lines = Lines::new("a\nb\n\nc");
        assert_eq!([0, 1, 2, 4, 5, 99].map(|at| lines.line(at)), [1, 1, 2, 3, 4, 4]);
    }

    #[test]
    fn the_lines_of_a_toml_string_are_lines_of_the_file() {
        let file = "x = 1\ny = \"\"\"\na\nb\"\"\"\nz = \"a\\nb\"\nw = '''a\nb'''";
        let lines = Lines::new(file);
        let place = |pattern| TextPlace::of_toml_string(file, &lines, file.find(pattern).unwrap());
        assert_eq!([1, 2].map(|line| place("\"\"\"").line(line)), [3, 4]);
        assert_eq!([1, 2].map(|line| place("\"a").line(line)), [5, 5]);
        assert_eq!([1, 2].map(|line| place("'''").line(line)), [6, 7]);
    }
}
