//! A compliance statement as Markdown, as a page for browsers, and as JSON.

use super::{ComplianceStatement, Section};
use std::fmt::Write;
use stickler_report::{html_page, html_text, markdown_text};

/// The form of a statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ComplianceForm {
    /// Markdown.
    Markdown,
    /// A page for browsers.
    Html,
    /// JSON.
    Json,
}

impl ComplianceStatement {
    /// Returns the statement in a form.
    ///
    /// # Errors
    /// Returns the error of serde_json.
    pub fn text(&self, form: ComplianceForm) -> serde_json::Result<String> {
        if form == ComplianceForm::Json {
            return Ok(serde_json::to_string_pretty(self)? + "\n");
        }
        let is_page = form == ComplianceForm::Html;
        let mut text = match is_page {
            true => format!("<p>{}</p>\n", html_text(&self.claim)),
            false => format!("# {}\n\n{}\n", markdown_text(&self.title), self.claim),
        };
        for section in &self.sections {
            let written = if is_page {
                section.html()
            } else {
                section.markdown()
            };
            text.push_str(&written);
        }
        Ok(if is_page {
            html_page(&self.title, &text)
        } else {
            text
        })
    }
}

impl Section {
    // Writing into a String does not fail.
    fn markdown(&self) -> String {
        let mut text = format!("\n## {}\n\n", markdown_text(self.title.trim_end_matches(": ")));
        if !self.text.is_empty() {
            let _ = write!(text, "{}\n\n", self.text);
        }
        let _ = writeln!(
            text,
            "| {} |\n|{}",
            self.head.join(" | "),
            "---|".repeat(self.head.len())
        );
        for row in &self.rows {
            let cells: Vec<String> = row.iter().map(|cell| markdown_text(cell)).collect();
            let _ = writeln!(text, "| {} |", cells.join(" | "));
        }
        text
    }

    fn html(&self) -> String {
        let cells = |cells: &mut dyn Iterator<Item = &str>, tag: &str| {
            let cells = cells.map(|cell| format!("<{tag}>{}</{tag}>", html_text(cell)));
            format!("<tr>{}</tr>\n", cells.collect::<String>())
        };
        let rows = self
            .rows
            .iter()
            .map(|row| cells(&mut row.iter().map(String::as_str), "td"));
        format!(
            "<h2>{}</h2>\n<p>{}</p>\n<table>\n{}{}</table>\n",
            html_text(self.title.trim_end_matches(": ")),
            self.text,
            cells(&mut self.head.iter().copied(), "th"),
            rows.collect::<String>()
        )
    }
}
