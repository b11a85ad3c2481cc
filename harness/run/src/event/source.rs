//! The sources of claims, as the header of a run names them.

use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use stickler_suite::{Source, Sources, address_of};
use stickler_types::{Contradiction, Relation};

/// A source that cases may cite, or Stickler's own rules.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SourceHeader {
    /// The name with which a basis begins.
    pub key: String,
    /// The title.
    pub title: String,
    /// The person or organization that answers for the text.
    pub publisher: String,
    /// The relation of the publisher to what the source speaks of; left out of a maker.
    #[serde(default, skip_serializing_if = "Relation::is_maker")]
    pub relation: Relation,
    /// The kind, as `sources.toml` spells it: `document`, `standard`, `recording`, `measurement` or `rule`.
    pub kind: String,
    /// The address, in which `{section}` and `{anchor}` stand for a section; [`SourceHeader::address_of`] fills them in.
    pub address: String,
    /// The edition, version, commit or date at which it was read; empty for rules.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub read: String,
    /// The built-in engines for which it speaks; none of a standard and of the rules.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub engines: Vec<String>,
    /// By section, the constructs that the section says are not there yet.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub limitations: BTreeMap<String, String>,
    /// The claims of other sources that it contradicts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contradicts: Vec<Contradiction>,
    /// The first paragraph of each rule; empty of every other source.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub paragraphs: BTreeMap<String, String>,
}

impl SourceHeader {
    /// Returns the headers of the sources of a suite, in their order.
    #[must_use]
    pub fn all(sources: &Sources) -> Vec<SourceHeader> {
        sources.iter().map(SourceHeader::from).collect()
    }

    /// Returns the address at which a section stands: of the web, or a path below the parent of the folder of cases.
    #[must_use]
    pub fn address_of(&self, section: &str) -> String {
        address_of(&self.address, section)
    }
}

impl From<&Source> for SourceHeader {
    fn from(source: &Source) -> SourceHeader {
        SourceHeader {
            key: source.key.clone(),
            title: source.title.clone(),
            publisher: source.publisher.clone(),
            relation: source.relation,
            kind: source.kind.as_str().to_owned(),
            address: source.address.clone(),
            read: source.read.clone(),
            engines: source.engines.clone(),
            limitations: source.limitations.clone(),
            contradicts: source.contradicts.clone(),
            paragraphs: source.paragraphs.clone(),
        }
    }
}
