//! The ways in which the sections of a source are named.

use crate::error::suggestion;
use std::collections::BTreeMap;

use stickler_types::{Code, ElementaryType, join, words};

/// The names that the sections of a source have.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Sections {
    /// Headings, letter by letter, and other names; each with its line in the file that has it.
    pub(super) headings: Vec<(String, u32)>,
    /// The kinds of names that cannot be listed.
    pub(super) forms: Vec<SectionForm>,
}

words! {
    /// A kind of names of sections, with its word in the key `sections`.
    SectionForm {
        /// A cell of a table of types, `SINT to INT`.
        Cells = "cells",
        /// A clause, a table or an annex of the standard: `6.3.4`, `Table 3`, `Annex B`.
        Clauses = "clauses",
        /// A diagnostic code of the registry, `P4035`.
        Codes = "codes",
        /// The path of a file in a repository, `tests/lit/single/conversion/to_num.st`.
        Paths = "paths",
    }
}

impl SectionForm {
    fn has(self, section: &str) -> bool {
        match self {
            SectionForm::Cells => is_cell(section),
            SectionForm::Clauses => is_clause(section),
            SectionForm::Codes => section.parse::<Code>().is_ok(),
            SectionForm::Paths => is_path(section),
        }
    }

    /// Returns the example that a message gives.
    fn example(self) -> &'static str {
        match self {
            SectionForm::Cells => "a cell like `SINT to INT`",
            SectionForm::Clauses => "a clause, a table or an annex: `6.3.4`, `Table 3`, `Annex B`",
            SectionForm::Codes => "a code: `P4035`",
            SectionForm::Paths => "the path of a file: `tests/example.st`",
        }
    }
}

impl Sections {
    /// Returns what the sections are, as a message says it, if the source has no such section.
    pub(super) fn unknown(&self, section: &str) -> Option<String> {
        let is_known = self.headings.iter().any(|(known, _)| known == section)
            || self.forms.iter().any(|form| form.has(section));
        if is_known {
            return None;
        }
        let forms: Vec<&str> = self.forms.iter().map(|form| form.example()).collect();
        let headings = self.headings.iter().map(|(heading, _)| heading.as_str());
        Some(match (forms.is_empty(), self.headings.is_empty()) {
            (true, _) => suggestion(section, headings),
            (false, true) => format!("write {}", forms.join(", or ")),
            (false, false) => format!(
                "{}, or write {}",
                suggestion(section, headings),
                forms.join(", or ")
            ),
        })
    }
}

/// Returns the part of a heading's address that pages give it: lower-case words with hyphens between them.
pub(super) fn anchor(heading: &str) -> String {
    let words = heading.split(|c: char| !c.is_alphanumeric());
    join(words.filter(|word| !word.is_empty()).map(str::to_lowercase), "-")
}

/// Returns the headings of the second level of a Markdown text, each with its line.
pub(super) fn headings(markdown: &str) -> Vec<(String, u32)> {
    let mut in_code = false;
    let lines = (1..).zip(markdown.lines()).filter(|(_, line)| {
        let is_fence = line.trim_start().starts_with("```");
        in_code ^= is_fence;
        !in_code
    });
    lines
        .filter_map(|(number, line)| Some((line.strip_prefix("## ")?.trim().to_owned(), number)))
        .collect()
}

/// Returns the first paragraph below each heading of the second level of a Markdown text, on one line.
pub(super) fn first_paragraphs(markdown: &str) -> BTreeMap<String, String> {
    let sections = markdown.split("\n## ").skip(1);
    let first = sections.filter_map(|section| {
        let (heading, text) = section.split_once('\n')?;
        let paragraph = text.trim_start().split("\n\n").next()?;
        Some((heading.trim().to_owned(), paragraph.trim().replace('\n', " ")))
    });
    first.collect()
}

fn is_cell(section: &str) -> bool {
    let known = |name: &str| ElementaryType::from_name(name).is_some();
    section
        .split_once(" to ")
        .is_some_and(|(from, to)| known(from) && known(to))
}

fn is_clause(section: &str) -> bool {
    let number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    let annex = |text: &str| text.starts_with(|c: char| c.is_ascii_uppercase());
    number(section)
        || section.strip_prefix("Table ").is_some_and(number)
        || section.strip_prefix("Annex ").is_some_and(annex)
}

fn is_path(section: &str) -> bool {
    let is_name = |part: &str| !part.is_empty() && part != ".." && !part.contains(char::is_whitespace);
    section.contains(['/', '.']) && section.split('/').all(is_name)
}
