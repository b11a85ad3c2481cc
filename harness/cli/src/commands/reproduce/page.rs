//! The README of a reproduction, and the same on the terminal.

use super::subject::ReproducedProgram;
use std::fmt::Write as _;
use std::io::{self, Write};

/// The name of the file.
pub(super) const README: &str = "README.md";

/// The facts that are printed about a reproduction.
pub(super) struct ReproductionPage<'p> {
    pub(super) subject: &'p ReproducedProgram,
    /// The name of the engine.
    pub(super) engine: &'p str,
    /// The name of the file of the program.
    pub(super) program: &'p str,
    /// The version of the compiler that is here, and what the script printed.
    pub(super) printed: Option<(&'p str, &'p str)>,
}

impl ReproductionPage<'_> {
    /// Returns the text of the README.
    pub(super) fn text(&self) -> String {
        let (heading, title) = self.subject.heading();
        let mut text = format!("# `{heading}` on {}\n\n", self.engine);
        // Writing into a String does not fail.
        if !title.is_empty() {
            let _ = write!(text, "{title}.\n\n");
        }
        let _ = write!(
            text,
            "`sh run.sh` gives `{}` to {}, with the compiler's own tools alone. The variables at the head of `run.sh` say where \
             these are.\n\n",
            self.program, self.engine
        );
        for (what, shown) in self.results() {
            let _ = write!(text, "{what}:\n\n{}\n", indented(&shown));
        }
        let _ = writeln!(text, "Lines are those of `{}`.", self.program);
        text
    }

    /// Writes the expectation and the output.
    pub(super) fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        for (what, shown) in self.results() {
            writeln!(out, "{what}:\n\n{}", indented(&shown))?;
        }
        Ok(())
    }

    /// Returns the expectation and the output, each with what it is.
    fn results(&self) -> Vec<(String, String)> {
        let mut results = Vec::new();
        if let Some((facts, basis)) = self.subject.expected() {
            results.push((format!("Expected, by {basis}"), facts));
        }
        if let Some((version, text)) = self.printed {
            let text = if text.is_empty() { "(nothing)" } else { text };
            results.push((format!("Printed with {} {version}", self.engine), text.to_owned()));
        }
        results
    }
}

/// Returns a text as a block of Markdown, which no text can end.
fn indented(text: &str) -> String {
    let lines = text.lines().map(|line| match line.trim_end() {
        "" => "\n".to_owned(),
        line => format!("    {line}\n"),
    });
    lines.collect()
}
