//! Contradictions between the sources of one compiler, what a source prints without a case, and the relation of a publisher to the makers of the compiler.

use crate::{Versions, words};
use serde::{Deserialize, Serialize};

words! {
    /// The relation of the publisher of a source to what the source speaks of: a compiler, a system or a standard.
    #[derive(Default, Serialize, Deserialize)]
    #[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
    #[serde(rename_all = "kebab-case")]
    Relation {
        /// Who makes it.
        #[default]
        Maker = "maker",
        /// Who ships the compiler in a product.
        Integrator = "integrator",
        /// Who restates a text that is not public.
        Restatement = "restatement",
        /// Anybody else.
        ThirdParty = "third party",
    }
}

impl Relation {
    /// Returns whether the publisher makes what the source speaks of.
    pub fn is_maker(&self) -> bool {
        *self == Relation::Maker
    }

    /// Returns the kind of a source with the relation of its publisher, where that is not the maker: `document (integrator)`.
    pub fn with_kind(self, kind: &str) -> String {
        match self {
            Relation::Maker => kind.to_owned(),
            other => format!("{kind} ({other})"),
        }
    }
}

/// A result that a source prints of a call, where no dialect has a case of it.
#[derive(Clone, PartialEq, Eq, Debug, Serialize)]
pub struct PrintedResult {
    /// The key of the source, which stands for the system.
    pub source: String,
    /// The source and section, and the address at which it stands.
    pub basis: String,
    /// The call, with typed literals: `REAL_TO_INT(REAL#1.5)`.
    pub call: String,
    /// The result: a typed literal, or words without a `#`, such as `operation error 3401H`.
    pub result: String,
}

/// Claims of other sources that a section of a source contradicts, so that they bind no compiler for which that source speaks unless
/// they outweigh it.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Contradiction {
    /// The section that says otherwise.
    pub section: String,
    /// The claims: source and section.
    pub claims: Vec<String>,
    /// Texts of which the id or the program of a case contains one, in capital or small letters; none where all cases of the claims are meant.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub only: Vec<String>,
    /// The statement of the section, as the words behind its name in a sentence: `expects 128`.
    pub says: String,
    /// Whether the claims bind all the same: they are newer or more specific, or the section only tells that what they promise is missing.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub outweighed: bool,
    /// The last version of the compiler of which the claims are known to hold: they bind it and those before it, and none after it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until: Option<String>,
}

impl Contradiction {
    /// Returns whether the claims still hold in this version of the compiler, as it says it: they ended with a later one, or with this one.
    pub fn claims_hold_in(&self, version: &str) -> bool {
        let until = self.until.clone();
        let is_dated = until.is_some();
        is_dated && Versions { since: None, until }.include(version)
    }

    /// Returns whether a claim is contradicted, of a case with this id or of a program that shows it.
    pub fn is_of(&self, basis: &str, (case, program): (&str, &str)) -> bool {
        let is_claimed = self.claims.iter().any(|claim| claim == basis);
        if !is_claimed || self.only.is_empty() {
            return is_claimed;
        }
        let texts = [case, program].map(str::to_ascii_uppercase);
        let is_in = |text: &String| {
            texts
                .iter()
                .any(|within| within.contains(&text.to_ascii_uppercase()))
        };
        self.only.iter().any(is_in)
    }
}
