//! The key `basis` of a case file: one basis, or several of which each dialect has its own.
//!
//! Where dialects have different documents, a probe cites one for each: a case has the first whose source speaks for its dialect.
//! In a file they are a list; within the suite, and in a cell of a column `basis`, one text with [`OR`] between them.

use serde::{Deserialize, Deserializer};
use stickler_types::DialectName;

use crate::sources::Sources;
use crate::toml_text::TextOr;

/// The text between several bases of a case, of which each dialect has the first whose source speaks for it.
pub const OR: &str = " | ";

/// The value of a key `basis`: one basis, or a list of them.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Bases(String);

impl Bases {
    /// Returns the bases as one text, with [`OR`] between them.
    pub fn text(&self) -> &str {
        &self.0
    }
}

impl<'de> Deserialize<'de> for Bases {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Ok(Bases(match TextOr::<String>::deserialize(deserializer)? {
            TextOr::Text(text) => text,
            TextOr::List(list) => list.join(OR),
        }))
    }
}

impl Sources {
    /// Returns the basis that a case of a dialect has of several: the first whose source speaks for it; `None` where none does.
    pub fn choose<'b>(&self, bases: &'b str, dialect: DialectName) -> Option<&'b str> {
        let speaks = |basis: &&str| {
            self.of(basis)
                .is_some_and(|(source, section)| source.speaks_for(section, dialect))
        };
        bases.split(OR).find(speaks)
    }
}
