//! Writes the text of a rewritten baseline: entries that stay keep their text and comments unchanged.

use super::Baseline;
use super::fold::Folded;
use crate::Verdict;
use std::path::Path;
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, RawString, Table, Value, value};

/// The comment at the head of a new file.
const HEAD: &str = include_str!("head.toml");

/// The decision about an old entry.
pub(super) enum Fate {
    Kept,
    Undated,
    Narrowed(Vec<Folded>, String),
    Widened(Vec<Folded>, String),
    Removed(String),
}

/// An entry that is added to a baseline.
pub(super) struct Added {
    pub(super) folded: Vec<Folded>,
    pub(super) verdict: Verdict,
    pub(super) reason: String,
}

/// Returns the new text, from the old one (empty where there was none) and the decision about each of its entries.
pub(super) fn rewritten(
    text: &str,
    baseline: &Baseline,
    engine: &str,
    fates: &[Fate],
    added: &[Added],
) -> String {
    let mut document: DocumentMut = match text.trim() {
        "" => head(baseline, engine),
        _ => text.parse().unwrap_or_default(),
    };
    let mut old: Vec<Table> = document
        .remove("expected")
        .map(Item::into_array_of_tables)
        .and_then(Result::ok)
        .into_iter()
        .flatten()
        .collect();
    let opening = opening(&mut document, old.first_mut());
    let kept = old
        .into_iter()
        .zip(fates)
        .filter_map(|(table, fate)| kept(table, fate));
    let mut tables: Vec<Table> = kept.chain(added.iter().map(new)).collect();
    match tables.first_mut() {
        Some(first) => {
            let prefix = format!("{opening}{}", prefix(first));
            first.decor_mut().set_prefix(prefix);
            document.insert("expected", Item::ArrayOfTables(in_order(tables)));
        }
        None => document.set_trailing(opening),
    }
    document.to_string()
}

/// Creates a document that names the engine, unless the name of the file does.
fn head(baseline: &Baseline, engine: &str) -> DocumentMut {
    let stem = Path::new(&baseline.file).file_stem();
    let mut document: DocumentMut = HEAD.parse().unwrap_or_default();
    if stem.is_none_or(|stem| stem != engine) {
        document = format!("{HEAD}engine = {}\n", Value::from(engine))
            .parse()
            .unwrap_or_default();
    }
    document
}

/// Removes and returns the comments that open the file, which are about more than the entry that happens to be the first:
/// all text before the last blank line above that entry.
fn opening(document: &mut DocumentMut, first: Option<&mut Table>) -> String {
    let Some(first) = first else {
        let opening = document.trailing().as_str().unwrap_or_default().to_owned();
        document.set_trailing("");
        return opening;
    };
    let mut opening = prefix(first);
    let own = opening.split_off(opening.rfind("\n\n").map_or(0, |at| at + 1));
    first.decor_mut().set_prefix(own);
    opening
}

/// Returns the comments and blank lines above a table.
fn prefix(table: &Table) -> String {
    let prefix = table.decor().prefix().and_then(RawString::as_str);
    prefix.unwrap_or_default().to_owned()
}

/// Numbers the tables so that they are printed in this order.
fn in_order(tables: Vec<Table>) -> ArrayOfTables {
    let mut ordered = ArrayOfTables::new();
    for mut table in tables {
        table.set_position(isize::try_from(ordered.len() + 1).ok());
        ordered.push(table);
    }
    ordered
}

/// Returns what an entry becomes; `None` where it is gone.
fn kept(mut table: Table, fate: &Fate) -> Option<Table> {
    match fate {
        Fate::Kept => {}
        Fate::Removed(_) => return None,
        Fate::Undated => drop(table.remove("until")),
        Fate::Narrowed(parts, _) | Fate::Widened(parts, _) => {
            if let Some(Item::Value(case)) = table.get_mut("case") {
                let decor = case.decor().clone();
                *case = cases(parts);
                *case.decor_mut() = decor;
            }
        }
    }
    Some(table)
}

fn new(added: &Added) -> Table {
    let mut table = Table::new();
    table.decor_mut().set_prefix("\n");
    table.insert("case", value(cases(&added.folded)));
    table.insert("verdict", value(added.verdict.as_str()));
    table.insert("reason", value(added.reason.as_str()));
    table
}

/// Returns the ids and patterns of an entry: one alone, or a list with a line for each.
fn cases(parts: &[Folded]) -> Value {
    if let [part] = parts {
        return Value::from(part.case.as_str());
    }
    let mut list: Array = parts.iter().map(|part| part.case.as_str()).collect();
    list.iter_mut()
        .for_each(|part| part.decor_mut().set_prefix("\n    "));
    list.set_trailing("\n");
    list.set_trailing_comma(true);
    Value::Array(list)
}
