//! Reads `basis.toml`. A mistake in it is a panic, which the first call shows.

use super::Rules;
use super::conditions::Condition;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::sync::LazyLock;
use stickler_types::ElementaryType;

/// The rows of each document, in their order.
pub(super) static ROWS: LazyLock<BTreeMap<Rules, Vec<Row>>> = LazyLock::new(|| {
    let file = toml::from_str(include_str!("../basis.toml"));
    let file: BasisFile = file.unwrap_or_else(|error| panic!("basis.toml: {error}"));
    let mut rows: BTreeMap<Rules, Vec<Row>> = BTreeMap::new();
    for (document, tables) in &file.documents {
        let document = Rules::from_word(document).unwrap_or_else(|| no(document, "document"));
        for (functions, table) in tables {
            let read = table.iter().map(|row| file.row(functions, row));
            rows.entry(document).or_default().extend(read);
        }
    }
    rows
});

/// The content of the file.
#[derive(Deserialize)]
struct BasisFile {
    /// The types of which a word is short.
    types: BTreeMap<String, String>,
    /// The tables of each document, by the functions.
    #[serde(flatten)]
    documents: BTreeMap<String, BTreeMap<String, Vec<[String; 4]>>>,
}

/// A row: the source of the results of some calls.
#[derive(Debug)]
pub(super) struct Row {
    functions: String,
    /// The types, a bit for each.
    from: u32,
    to: u32,
    pub(super) conditions: Vec<Condition>,
    /// The source, as the suite writes a basis: `source: section`.
    pub(super) basis: &'static str,
}

impl Row {
    /// Returns whether the row is one of these functions and types.
    pub(super) fn is_of(&self, functions: &str, from: ElementaryType, to: ElementaryType) -> bool {
        let has = |types: u32, ty: ElementaryType| types >> ty as u32 & 1 == 1;
        has(self.from, from) && has(self.to, to) && self.functions.split(' ').any(|own| own == functions)
    }
}

impl BasisFile {
    fn row(&self, functions: &str, [from, to, conditions, basis]: &[String; 4]) -> Row {
        let condition = |word| Condition::from_word(word).unwrap_or_else(|| no(word, "condition"));
        let conditions = conditions.split(", ").filter(|word| !word.is_empty());
        Row {
            functions: functions.to_owned(),
            from: self.types(from),
            to: self.types(to),
            conditions: conditions.map(condition).collect(),
            // The file is read once.
            basis: basis.clone().leak(),
        }
    }

    fn types(&self, words: &str) -> u32 {
        let of = |word: &str| match (self.types.get(word), ElementaryType::from_name(word)) {
            (Some(words), _) => self.types(words),
            (None, Some(ty)) => 1 << ty as u32,
            (None, None) => no(word, "type"),
        };
        words.split(' ').fold(0, |types, word| types | of(word))
    }
}

fn no<T>(word: &str, what: &str) -> T {
    panic!("`{word}` in basis.toml is no {what}")
}
