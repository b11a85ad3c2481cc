//! The names of the dialects, and the registry of what their files state.

use crate::{Dialect, DialectKind, dialect_file, joined};
use std::fmt;
use std::str::FromStr;
use std::sync::{LazyLock, PoisonError, RwLock};

/// A named set of language rules: those of a documented system, or of a dialect that overrides some rules of another. Dialects
/// compare in the order in which reports name them: documented systems first, then the others in the order of their definitions.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DialectName(u16);

// The files of the documented systems, as `EMBEDDED`, and a constant for each of their names.
include!(concat!(env!("OUT_DIR"), "/dialects.rs"));

/// Every dialect, by its number. They live as long as the process, because a name is copied into every case.
static REGISTRY: LazyLock<RwLock<Vec<&'static Dialect>>> = LazyLock::new(|| {
    let dialects = dialect_file::documented(&EMBEDDED).into_iter();
    RwLock::new((0..).map(DialectName).zip(dialects).map(registered).collect())
});

fn registered((name, dialect): (DialectName, Dialect)) -> &'static Dialect {
    Box::leak(Box::new(Dialect { name, ..dialect }))
}

/// The error of a name under which no dialect can be defined, because another dialect has it.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("there is a dialect `{0}` already")]
pub struct TakenName(pub String);

impl DialectName {
    /// The dialects of documented systems that Stickler carries, in the order in which reports name them.
    pub const ALL: [DialectName; EMBEDDED.len()] = {
        let mut all = [DialectName(0); EMBEDDED.len()];
        let mut index = 0;
        while index < all.len() {
            all[index] = DialectName(index as u16);
            index += 1;
        }
        all
    };

    /// Returns the rules of the dialect.
    pub fn rules(self) -> &'static Dialect {
        let registry = REGISTRY.read().unwrap_or_else(PoisonError::into_inner);
        registry[usize::from(self.0)]
    }

    /// Returns the name of the dialect, such as `ironplc-ed2`.
    pub fn as_str(self) -> &'static str {
        match EMBEDDED.get(usize::from(self.0)) {
            Some((name, _)) => name,
            None => &self.rules().spelling,
        }
    }

    /// Returns the number of the dialect in the order of the dialects.
    pub const fn index(self) -> usize {
        self.0 as usize
    }

    /// Returns the documented system that this one is, or that it finally extends.
    pub fn base(self) -> DialectName {
        self.rules().base
    }

    /// Returns the rules of a variant or of a custom dialect; `None` for a documented system.
    pub fn definition(self) -> Option<&'static Dialect> {
        Some(self.rules()).filter(|dialect| dialect.kind != DialectKind::Documented)
    }

    /// Returns whether this is a [variant](DialectKind::Variant) of a documented system.
    pub fn is_variant(self) -> bool {
        self.rules().kind == DialectKind::Variant
    }

    /// Returns whether this is a dialect of `stickler.toml`, which takes over the cases of its base.
    pub fn is_custom(self) -> bool {
        self.rules().kind == DialectKind::Custom
    }

    /// Defines a dialect for the lifetime of the process. Defining the same dialect again changes nothing.
    ///
    /// # Errors
    /// [`TakenName`] if another dialect has the name; names that differ only in case count as the same.
    pub fn define(dialect: Dialect) -> Result<DialectName, TakenName> {
        let mut registry = REGISTRY.write().unwrap_or_else(PoisonError::into_inner);
        let has_name = |other: &&Dialect| other.spelling.eq_ignore_ascii_case(&dialect.spelling);
        let taken = registry.iter().position(has_name);
        // No file has so many dialects that 16 bits do not count them.
        let name = DialectName(u16::try_from(taken.unwrap_or(registry.len())).unwrap_or(u16::MAX));
        let base = match dialect.kind {
            DialectKind::Documented => name,
            DialectKind::Variant | DialectKind::Custom => dialect.base,
        };
        let dialect = Dialect {
            name,
            base,
            ..dialect
        };
        match taken.map(|at| registry[at]) {
            Some(other) if *other == dialect => Ok(name),
            Some(other) => Err(TakenName(other.spelling.clone())),
            None => {
                registry.push(registered((name, dialect)));
                Ok(name)
            }
        }
    }

    /// Returns every dialect that was defined besides those of [`DialectName::ALL`], variants among them, in the order of the
    /// definitions.
    pub fn defined() -> Vec<DialectName> {
        let registry = REGISTRY.read().unwrap_or_else(PoisonError::into_inner);
        (0..)
            .map(DialectName)
            .take(registry.len())
            .skip(EMBEDDED.len())
            .collect()
    }
}

impl fmt::Debug for DialectName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.as_str())
    }
}

impl fmt::Display for DialectName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// The error of a text that names no [`DialectName`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("unknown dialect `{0}`; the dialects are {known}", known = known())]
pub struct UnknownDialect(pub String);

/// Returns a list of the dialects' names for a message, including custom ones, but only the first few of them.
fn known() -> String {
    const MAX_NAMES: usize = DialectName::ALL.len() + 5;
    let defined = DialectName::defined()
        .into_iter()
        .filter(|dialect| !dialect.is_variant());
    let all = DialectName::ALL.into_iter().chain(defined);
    let mut names: Vec<String> = all.map(|dialect| format!("`{dialect}`")).collect();
    let more = names.len().saturating_sub(MAX_NAMES);
    if more > 0 {
        names.truncate(MAX_NAMES);
        names.push(format!("{more} more"));
    }
    joined(&names, "and")
}

impl FromStr for DialectName {
    type Err = UnknownDialect;

    /// Parses exactly the names that [`DialectName::as_str`] returns.
    fn from_str(text: &str) -> Result<DialectName, UnknownDialect> {
        let named = |dialect: &DialectName| dialect.as_str() == text;
        DialectName::ALL
            .into_iter()
            .find(named)
            .or_else(|| DialectName::defined().into_iter().find(named))
            .ok_or_else(|| UnknownDialect(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_dialect_is_read_back_from_its_name() {
        for dialect in DialectName::ALL {
            assert_eq!(dialect.to_string().parse(), Ok(dialect));
            assert_eq!(dialect.base(), dialect);
            assert_eq!(dialect.definition(), None);
        }
    }

    #[test]
    fn the_error_for_an_unknown_name_lists_every_dialect() {
        let message = "codesis".parse::<DialectName>().unwrap_err().to_string();
        assert!(message.contains("`codesis`"), "{message}");
        for dialect in DialectName::ALL {
            assert!(
                message.contains(&format!("`{dialect}`")),
                "{message} does not name {dialect}"
            );
        }
    }

    #[test]
    fn a_dialect_that_was_defined_is_read_back_and_goes_by_its_base() {
        let define = |name| DialectName::define(Dialect::custom(name, DialectName::MATIEC, "here"));
        let (first, second) = (define("first-of-two").unwrap(), define("second-of-two").unwrap());
        assert_eq!("first-of-two".parse(), Ok(first));
        assert_eq!(second.to_string(), "second-of-two");
        assert_eq!(first.base(), DialectName::MATIEC);
        assert!(DialectName::PLCNEXT < first && first < second);
        assert!(DialectName::defined().contains(&first) && !DialectName::ALL.contains(&first));
        let message = "third-of-two".parse::<DialectName>().unwrap_err().to_string();
        assert!(message.contains("`first-of-two`"), "{message}");
        assert_eq!(define("first-of-two"), Ok(first));
        for taken in ["First-Of-Two", "matiec", "MATIEC"] {
            assert!(define(taken).is_err(), "{taken}");
        }
        let otherwise = Dialect::custom("first-of-two", DialectName::PLCNEXT, "there");
        assert!(DialectName::define(otherwise).is_err());
    }
}
