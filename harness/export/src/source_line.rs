//! The line of a source in the files for people without a harness: what it is, and where it opens.

use serde::Serialize;
use std::borrow::Cow;
use stickler_suite::{SourceKind, Sources};
use stickler_types::{DialectName, Relation};

/// A source.
#[derive(Serialize)]
#[cfg_attr(test, derive(schemars::JsonSchema))]
pub(crate) struct SourceLine<'a> {
    /// The source and its section.
    basis: Cow<'a, str>,
    /// The title.
    title: String,
    /// Who gave it out.
    publisher: &'a str,
    /// `document`, `standard`, `recording`, `measurement` or `rule`.
    kind: &'static str,
    /// The relation of the publisher to what the source speaks of: `maker`, `integrator`, `restatement` or `third party`.
    relation: String,
    /// The edition, version, commit or date at which it was read; of a recording the product and its version.
    read: String,
    /// The address.
    address: String,
}

impl<'a> SourceLine<'a> {
    /// Returns the line of a basis.
    pub(crate) fn new(basis: impl Into<Cow<'a, str>>, sources: &'a Sources) -> SourceLine<'a> {
        let basis = basis.into();
        let found = sources.of(&basis);
        let of_dialect = basis
            .split(':')
            .next()
            .and_then(|name| name.parse::<DialectName>().ok());
        if let (None, Some(dialect)) = (found, of_dialect) {
            return SourceLine {
                title: format!(
                    "The file of {}, whose comments name the pages",
                    dialect.rules().title
                ),
                publisher: "Stickler",
                kind: SourceKind::Document.as_str(),
                relation: Relation::Restatement.to_string(),
                read: String::new(),
                address: format!("conformance-cases/dialects/{}.toml", dialect.base()),
                basis,
            };
        }
        let line = SourceLine {
            title: found.map_or_else(String::new, |(source, section)| {
                source.title.replace("{section}", section)
            }),
            publisher: found.map_or("", |(source, _)| &source.publisher),
            kind: found.map_or("", |(source, _)| source.kind.as_str()),
            relation: found.map_or_else(String::new, |(source, _)| source.relation.to_string()),
            read: found.map_or_else(String::new, |(source, section)| {
                source.read_of(section).into_owned()
            }),
            address: found.map_or_else(String::new, |(source, section)| source.address_of(section)),
            basis: Cow::Borrowed(""),
        };
        SourceLine { basis, ..line }
    }
}
