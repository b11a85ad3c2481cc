//! The description of a source in the files for people without a harness: what it is, and where it opens.

use serde_json::{Value, json};
use stickler_suite::Sources;
use stickler_types::{DialectName, Relation};

/// Returns the description of the source of a basis; the schemas of the files say what its keys mean.
pub(crate) fn source_line(basis: &str, sources: &Sources) -> Value {
    let known = sources.of(basis);
    let of_dialect = basis
        .split(':')
        .next()
        .and_then(|name| name.parse::<DialectName>().ok());
    match (known, of_dialect) {
        (Some((source, section)), _) => json!({
            "basis": basis,
            "title": source.title.replace("{section}", section),
            "publisher": source.publisher,
            "kind": source.kind.as_str(),
            "relation": source.relation.to_string(),
            "read": source.read_of(section),
            "address": source.address_of(section),
        }),
        (None, Some(dialect)) => json!({
            "basis": basis,
            "title": format!("The file of {}, whose comments name the pages", dialect.rules().title),
            "publisher": "Stickler",
            "kind": "document",
            "relation": Relation::Restatement.to_string(),
            "read": "",
            "address": format!("conformance-cases/dialects/{}.toml", dialect.base()),
        }),
        (None, None) => json!({
            "basis": basis, "title": "", "publisher": "", "kind": "", "relation": "", "read": "", "address": "",
        }),
    }
}
