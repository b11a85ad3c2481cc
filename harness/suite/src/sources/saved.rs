//! Holds the figures that sources quote against saved copies of their pages.
//!
//! The copy of a page has the key of its source as its name. A source with one page for each section, whose address contains the section,
//! has a folder of copies: `KEY/SECTION`. An extension may follow. Text is compared by its words and signs, so that neither markup nor spaces matter.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Serialize;

use super::{Source, Sources};
use crate::files;

/// The extensions that the copy of a page may have.
const EXTENSIONS: [&str; 6] = [".html", ".htm", ".md", ".txt", ".csv", ""];

/// A quoted figure, and what the saved copy of its page says of it.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct CheckedQuote<'s> {
    /// The key of the source.
    pub source: &'s str,
    /// The section that has the figure.
    pub section: &'s str,
    /// The figure.
    pub quote: &'s str,
    /// The path below the folder of copies at which the copy is, without its extension.
    pub page: String,
    /// The address of the section.
    pub address: String,
    /// What the copy says.
    pub result: QuoteResult,
}

/// What the saved copy of a page says of a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum QuoteResult {
    /// The page has the figure.
    Found,
    /// The page does not have it.
    NotInPage,
    /// No copy of the page is there that can be read.
    NoPage,
}

impl Sources {
    /// Looks for each quote of the sources in the copies of their pages below `folder`, in the order of the sources and sections.
    pub fn check_quotes(&self, folder: &Path) -> Vec<CheckedQuote<'_>> {
        let mut pages: BTreeMap<String, Option<Vec<String>>> = BTreeMap::new();
        let mut checked = Vec::new();
        for source in &self.sources {
            for (section, quote) in source.quotes() {
                let page = source.page_of(section);
                let words = pages.entry(page.clone());
                let words = words.or_insert_with_key(|page| words_of_page(folder, page));
                let result = match words {
                    Some(words) if has(words, &words_of(quote)) => QuoteResult::Found,
                    Some(_) => QuoteResult::NotInPage,
                    None => QuoteResult::NoPage,
                };
                let (source, address) = (source.key.as_str(), source.address_of(section));
                checked.push(CheckedQuote {
                    source,
                    section,
                    quote,
                    page,
                    address,
                    result,
                });
            }
        }
        checked
    }
}

impl Source {
    fn quotes(&self) -> impl Iterator<Item = (&str, &str)> {
        let sections = self.quotes.iter();
        sections.flat_map(|(section, texts)| texts.iter().map(|text| (section.as_str(), text.as_str())))
    }

    /// Returns the path of the saved copy of a section's page, below the folder of copies and without its extension.
    fn page_of(&self, section: &str) -> String {
        match self.address.split('#').next() {
            Some(page) if page.contains("{section}") => format!("{}/{section}", self.key),
            _ => self.key.clone(),
        }
    }
}

/// Returns the words of the saved copy of a page; `None` where there is none that can be read.
fn words_of_page(folder: &Path, page: &str) -> Option<Vec<String>> {
    let path = |extension: &&str| folder.join(format!("{page}{extension}"));
    let mut texts = EXTENSIONS.iter().map(path).flat_map(|path| files::read(&path));
    let text = texts.next()?;
    let text = text.trim_start_matches('\u{feff}');
    Some(match text.trim_start().starts_with('<') {
        true => words_of(&without_markup(text)),
        false => words_of(text),
    })
}

/// Returns whether some words stand in a text one after the other.
fn has(text: &[String], words: &[String]) -> bool {
    text.windows(words.len().max(1)).any(|window| window == words)
}

/// The signs that Markdown puts around code and between the cells of a table.
const MARKUP: [char; 2] = ['`', '|'];

/// Returns the words and numbers of a text, and each of its other signs alone.
fn words_of(text: &str) -> Vec<String> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut words: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in text.chars() {
        match words.last_mut() {
            Some(word) if is_word(before) && is_word(c) => word.push(c),
            _ if c.is_whitespace() || MARKUP.contains(&c) => {}
            _ => words.push(c.to_string()),
        }
        before = c;
    }
    words
}

/// Returns the text of an HTML page: tags within a line vanish, and all others are spaces.
fn without_markup(html: &str) -> String {
    const INLINE: &str = " a b code em font i kbd span strong sub sup tt var wbr ";
    let mut text = String::new();
    let mut rest = html;
    while let Some((before, behind)) = rest.split_once('<') {
        push_decoded(&mut text, before);
        let mut names = behind
            .trim_start_matches('/')
            .split(|c: char| !c.is_ascii_alphanumeric());
        let name = names.next().unwrap_or_default().to_ascii_lowercase();
        let end = match &*name {
            _ if behind.starts_with("!--") => "-->",
            "script" | "style" if !behind.starts_with('/') => &format!("</{name}"),
            _ => ">",
        };
        if !INLINE.contains(&format!(" {name} ")) {
            text.push(' ');
        }
        let at = behind.to_ascii_lowercase().find(end);
        rest = at.map_or("", |at| &behind[at + end.len()..]);
        if end.starts_with("</") {
            rest = rest.split_once('>').map_or("", |(_, behind)| behind);
        }
    }
    push_decoded(&mut text, rest);
    text
}

/// Adds a text with its character references decoded; one that is not known stays as it is.
fn push_decoded(text: &mut String, mut rest: &str) {
    while let Some((before, behind)) = rest.split_once('&') {
        text.push_str(before);
        let named = behind.split_once(';');
        let known = named.and_then(|(name, behind)| Some((decoded(name)?, behind)));
        let (c, behind) = known.unwrap_or(('&', behind));
        text.push(c);
        rest = behind;
    }
    text.push_str(rest);
}

fn decoded(name: &str) -> Option<char> {
    const NAMES: &str = "amp& lt< gt> quot\" apos' nbsp\u{a0} rarr→ minus− le≤ ge≥ times× hellip…";
    if let Some(number) = name.strip_prefix('#') {
        let number = match number.strip_prefix(['x', 'X']) {
            Some(digits) => u32::from_str_radix(digits, 16),
            None => number.parse(),
        };
        return char::from_u32(number.ok()?);
    }
    let mut letters = NAMES.split(' ').filter_map(|known| known.strip_prefix(name));
    letters.find_map(|letter| letter.chars().next().filter(|c| !c.is_ascii_lowercase()))
}
