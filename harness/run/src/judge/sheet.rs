//! The sheet on which a judgement is written down.

use crate::Verdict;
use std::fmt::{self, Write};

/// Text of whole lines.
#[derive(Default)]
pub(super) struct Lines {
    text: String,
}

impl Lines {
    /// Adds a line. A line feed inside it, as in a foreign message, becomes a space: one fact, one line.
    pub(super) fn line(&mut self, line: fmt::Arguments<'_>) {
        if self.text.is_empty() {
            self.text.reserve(40);
        } else {
            self.text.push('\n');
        }
        let start = self.text.len();
        // Writing into a String does not fail.
        let _ = self.text.write_fmt(line);
        if self.text[start..].contains(['\n', '\r']) {
            let flat = self.text[start..].replace(['\n', '\r'], " ");
            self.text.replace_range(start.., &flat);
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.text.is_empty()
    }

    pub(super) fn finish(self) -> String {
        self.text
    }
}

/// What was got, and whether it will do.
pub(super) struct Sheet {
    got: Lines,
    met: bool,
    supported: bool,
}

impl Default for Sheet {
    fn default() -> Sheet {
        Sheet {
            got: Lines::default(),
            met: true,
            supported: true,
        }
    }
}

impl Sheet {
    /// Writes down something that was got.
    pub(super) fn line(&mut self, line: fmt::Arguments<'_>) {
        self.got.line(line);
    }

    /// Something that must hold for the case to pass.
    pub(super) fn require(&mut self, holds: bool) {
        self.met &= holds;
    }

    /// The engine could not answer a part of the case.
    pub(super) fn unsupported(&mut self) {
        self.supported = false;
    }

    /// The verdict, and what was got.
    pub(super) fn finish(self) -> (Verdict, String) {
        let verdict = match (self.met, self.supported) {
            (false, _) => Verdict::Fail,
            (true, false) => Verdict::Unsupported,
            (true, true) => Verdict::Pass,
        };
        (verdict, self.got.finish())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_fact_stays_on_one_line() {
        let mut lines = Lines::default();
        lines.line(format_args!("a"));
        lines.line(format_args!("b\r\nc"));
        assert_eq!(lines.finish(), "a\nb  c");
    }

    #[test]
    fn what_is_not_met_fails_whatever_else_was_unsupported() {
        let mut sheet = Sheet::default();
        sheet.unsupported();
        sheet.require(true);
        assert_eq!(sheet.finish().0, Verdict::Unsupported);
        let mut sheet = Sheet::default();
        sheet.unsupported();
        sheet.require(false);
        assert_eq!(sheet.finish().0, Verdict::Fail);
    }
}
