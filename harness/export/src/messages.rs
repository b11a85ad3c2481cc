//! Parses lists of a compiler's messages about pages, and attributes each message to its case.
//!
//! A message is a line that names a page (`stickler_page_12` or `page-012`) and a line of it: `Line 12, Column 4`, `(12,4)`,
//! `page-012.st:12:4`, `12-4..12-9`, or a cell of a table. Where it says `Impl` or `Decl`, lines count within that pane of the editor; otherwise
//! through the whole page. A warning is no rejection.

use crate::manifest::{LinesRecord, Manifest};
use std::collections::{BTreeMap, BTreeSet};

/// The messages about each page, by the page's index in the manifest.
#[derive(Debug, Default)]
pub(crate) struct Messages {
    /// The first message of each line of each page.
    pages: BTreeMap<usize, BTreeMap<usize, String>>,
}

/// The messages that a compiler gave about a page, by case.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) enum MessageList {
    /// No message about the page was given.
    Missing,
    /// The list ends early. Holds the index of the case on whose lines its last message is, where there is one.
    Truncated(Option<usize>),
    /// The first message of each case; `None` where the case was accepted.
    Complete(Vec<Option<String>>),
}

impl Messages {
    /// Adds the messages of a text, and returns their number.
    pub(crate) fn take(&mut self, text: &str, manifest: &Manifest) -> usize {
        let mut taken = 0;
        let lines: Vec<&str> = text.lines().collect();
        for (number, line) in lines.iter().enumerate() {
            let Some((at, behind)) = page_of(line, manifest) else {
                continue;
            };
            let lines_of_page = &manifest.pages[at].lines;
            if is_element(behind) || is_warning(line) {
                continue;
            }
            let Some(found) = line_of(behind).or_else(|| line_of(line)) else {
                continue;
            };
            // Some compilers write the message on a line of its own, above the place.
            let above = number.checked_sub(1).map(|above| lines[above].trim());
            let only_place = line.trim_start().starts_with(['-', '\u{250c}', '>']);
            let message = above
                .filter(|above| only_place && !above.is_empty())
                .unwrap_or(line.trim());
            if is_warning(message) {
                continue;
            }
            let messages = self.pages.entry(at).or_default();
            messages
                .entry(in_page(found, line, lines_of_page))
                .or_insert_with(|| message.to_owned());
            taken += 1;
        }
        taken
    }

    /// Returns the messages about a page that is only compiled, by case.
    pub(crate) fn list(&self, at: usize, lines: &LinesRecord) -> MessageList {
        let Some(mut reported) = self.by_case(at, lines) else {
            return MessageList::Missing;
        };
        let ends = reported.split_off(reported.len().saturating_sub(2));
        if ends.iter().any(Option::is_none) {
            return MessageList::Truncated(reported.iter().rposition(Option::is_some));
        }
        MessageList::Complete(reported)
    }

    /// Returns the first message of each case of a page; `None` where no message is about the page.
    pub(crate) fn by_case(&self, at: usize, lines: &LinesRecord) -> Option<Vec<Option<String>>> {
        let messages = self.pages.get(&at)?;
        let message = |stretches: &Vec<(usize, usize)>| {
            let lines = stretches
                .iter()
                .flat_map(|(first, last)| messages.range(*first..=*last));
            lines.map(|(_, message)| message.clone()).next()
        };
        Some(lines.cases.iter().map(message).collect())
    }
}

/// Returns the index of the page that a line names, and the text after the name.
fn page_of<'l>(line: &'l str, manifest: &Manifest) -> Option<(usize, &'l str)> {
    let lower = line.to_ascii_lowercase();
    for name in ["stickler_page_", "page-"] {
        for (at, _) in lower.match_indices(name) {
            let rest = &line[at + name.len()..];
            let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
            let number = rest[..digits].parse::<usize>().ok();
            let found = manifest.pages.iter().position(|page| Some(page.number) == number);
            if let Some(found) = found {
                return Some((found, &rest[digits..]));
            }
        }
    }
    None
}

/// Returns whether the text after the name of a page makes it the path of an element of its array, as in a row of a watch list:
/// such rows have numbers too, and none of them is a line.
fn is_element(behind: &str) -> bool {
    let path = behind.split(char::is_whitespace).next().unwrap_or_default();
    path.to_ascii_lowercase().contains("results[")
}

fn is_warning(line: &str) -> bool {
    let line = line.to_ascii_lowercase();
    let words: BTreeSet<&str> = line.split(|c: char| !c.is_alphanumeric()).collect();
    let said = [
        "warning",
        "warnung",
        "avertissement",
        "information",
        "hint",
        "note",
    ]
    .iter()
    .any(|word| words.contains(word));
    said && !["error", "fehler", "erreur"]
        .iter()
        .any(|word| words.contains(word))
}

/// Returns the line that a message names.
fn line_of(text: &str) -> Option<usize> {
    let lower = text.to_ascii_lowercase();
    let after = |word: &str| {
        lower
            .match_indices(word)
            .find_map(|(at, _)| digits(text[at + word.len()..].trim_start_matches([' ', ':', '#'])))
    };
    ["line", "zeile", "ligne"]
        .iter()
        .find_map(|word| after(word))
        .or_else(|| after("("))
        .or_else(|| text.find(':').and_then(|at| digits(text[at + 1..].trim_start())))
        .or_else(|| {
            text.split(['\t', ';', ',', '"'])
                .find_map(|cell| cell.trim().parse().ok())
        })
}

fn digits(text: &str) -> Option<usize> {
    let length = text.bytes().take_while(u8::is_ascii_digit).count();
    text[..length].parse().ok()
}

/// Converts the line of a message into one that counts through declarations and statements of the page.
fn in_page(line: usize, message: &str, lines: &LinesRecord) -> usize {
    let message = message.to_ascii_lowercase();
    // The pane is named in parentheses, since messages also contain words such as *implicit* conversion.
    if message.contains("(impl)") {
        line.saturating_add(lines.declarations)
    } else if message.contains("(decl)") {
        line
    } else {
        line.saturating_sub(lines.units)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::manifest::PageRecord;
    use crate::paste::decoded;

    /// Returns a manifest with two cases: the first has the lines 4 and 8, the second 5 and 9; the statements begin at 7 and end
    /// at 10.
    fn manifest() -> Manifest {
        let mut manifest = Manifest::new("1", "matiec");
        manifest.pages.push(PageRecord {
            file: "page-001.st".to_owned(),
            number: 1,
            lines: LinesRecord {
                units: 0,
                declarations: 6,
                cases: vec![
                    vec![(4, 4), (8, 8)],
                    vec![(5, 5), (9, 9)],
                    vec![(7, 7)],
                    vec![(10, 10)],
                ],
            },
            ..PageRecord::default()
        });
        manifest
    }

    fn reported(text: &str) -> MessageList {
        let manifest = manifest();
        let mut messages = Messages::default();
        messages.take(&decoded(text.as_bytes()), &manifest);
        messages.list(0, &manifest.pages[0].lines)
    }

    #[test]
    fn lists_are_read_in_every_form() {
        for section in include_str!("messages.md").split("\n## ").skip(1) {
            let (heading, blocks) = section.split_once('\n').expect("a heading");
            let (_, expected) = heading.split_once(": ").expect("what it tells");
            for text in blocks.split("```text\n").skip(1) {
                let (text, _) = text.split_once("```").expect("an end");
                let told = match reported(text) {
                    MessageList::Missing => "missing".to_owned(),
                    MessageList::Truncated(None) => "truncated".to_owned(),
                    MessageList::Truncated(Some(case)) => format!("truncated after {case}"),
                    MessageList::Complete(cases) => {
                        let case = |message: &Option<String>| match message {
                            None => "accepted".to_owned(),
                            Some(message) if expected.contains("rejected: ") => {
                                format!("rejected: {message}")
                            }
                            Some(_) => "rejected".to_owned(),
                        };
                        cases.iter().map(case).collect::<Vec<_>>().join(", ")
                    }
                };
                assert_eq!(told, expected, "{heading}\n{text}");
            }
        }
    }

    #[test]
    fn a_warning_is_none_in_any_colour() {
        let at = |kind: &str, line: u32| {
            format!(
                "\u{1b}[1;33m{kind}\u{1b}[0m: a\n  \u{1b}[36m\u{250c}\u{2500}\u{1b}[0m page-001.st:{line}:1\n"
            )
        };
        let list = [at("error", 7), at("warning[P1]", 8), at("error", 10)].concat();
        assert_eq!(reported(&list), MessageList::Complete(vec![None, None]));
    }
}
