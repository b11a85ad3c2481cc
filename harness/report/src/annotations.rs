//! Annotations: lines in the log of a CI job by which its service shows the unexpected results of a run beside the sources.
//!
//! Basis: GitHub, "Workflow commands for GitHub Actions", <https://docs.github.com/actions/reference/workflows-and-actions/workflow-commands>: the form of
//! a line and what is escaped in it. A step shows ten errors; further ones stand in the log only, so they are left to the reports.

use crate::overview::Overview;
use crate::unexpected::Unexpected;
use std::io::{self, Write};

/// The number of errors of a step that GitHub shows.
const MAX_ERRORS: usize = 10;

/// Writes an error for each of the first unexpected results of a run, as workflow commands of GitHub, and the number of further ones.
///
/// # Errors
/// Errors of writing to `out`.
pub fn write_github(overview: &Overview, out: &mut dyn Write) -> io::Result<()> {
    let mut unexpected = Unexpected::all(overview);
    for one in unexpected.by_ref().take(MAX_ERRORS) {
        let mut properties = Vec::new();
        if !one.file.is_empty() {
            properties.push(format!("file={}", property(&one.file)));
            properties.extend(one.line.map(|line| format!("line={line}")));
        }
        properties.push(format!("title={}", property(&one.title)));
        writeln!(out, "::error {}::{}", properties.join(","), message(&one.text))?;
    }
    match unexpected.count() {
        0 => Ok(()),
        more => writeln!(
            out,
            "::notice::... and {more} more that are not as expected; the reports have all"
        ),
    }
}

/// Escapes a message, which may have several lines.
fn message(text: &str) -> String {
    text.replace('%', "%25").replace('\r', "%0D").replace('\n', "%0A")
}

/// Escapes the value of a property.
fn property(text: &str) -> String {
    message(text).replace(':', "%3A").replace(',', "%2C")
}
