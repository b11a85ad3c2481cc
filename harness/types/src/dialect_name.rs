//! The names of the dialects; the reference and exact arithmetic implement their rules.

use crate::definition::{Definition, TakenName};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::str::FromStr;
use std::sync::{PoisonError, RwLock};

/// Declares the dialects of documented systems, and the name of each.
macro_rules! built_in {
    ($($(#[$said:meta])* $dialect:ident = $text:literal,)*) => {
        /// A named set of language rules: those of one documented system, or of a user-defined dialect that overrides some
        /// rules of another.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum DialectName {
            $($(#[$said])* $dialect,)*
            /// A user-defined dialect, from `stickler.toml`; it follows its [base](DialectName::base) wherever its definition
            /// does not state otherwise.
            Defined(DefinedDialect),
        }

        /// A dialect of a documented system, which every user-defined dialect extends. Rules that a definition cannot override
        /// depend on it alone.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum BuiltIn {
            $($(#[$said])* $dialect,)*
        }

        impl DialectName {
            /// The dialects of documented systems, in the order of the declaration, in which reports name them. User-defined
            /// dialects ([`DialectName::defined`]) are not included.
            pub const ALL: [DialectName; [$(BuiltIn::$dialect),*].len()] = [$(DialectName::$dialect),*];

            /// Returns the name of the dialect, such as `ironplc-ed2`.
            pub const fn as_str(self) -> &'static str {
                match self {
                    $(DialectName::$dialect => $text,)*
                    DialectName::Defined(defined) => defined.definition.name.as_str(),
                }
            }

            /// Returns the dialect of a documented system that this one is, or that it finally extends.
            pub const fn base(self) -> BuiltIn {
                match self {
                    $(DialectName::$dialect => BuiltIn::$dialect,)*
                    DialectName::Defined(defined) => defined.definition.base,
                }
            }
        }

        impl BuiltIn {
            /// Returns the name of the dialect.
            pub const fn name(self) -> DialectName {
                match self {
                    $(BuiltIn::$dialect => DialectName::$dialect,)*
                }
            }
        }
    };
}

built_in! {
    /// IronPLC as documented, with the second edition of the standard.
    IronplcEd2 = "ironplc-ed2",
    /// IronPLC as documented, with the third edition of the standard.
    IronplcEd3 = "ironplc-ed3",
    /// IronPLC as documented, with the extensions that follow RuSTy.
    IronplcRusty = "ironplc-rusty",
    /// matiec, as the page on its conversion functions documents it.
    Matiec = "matiec",
    /// PLCnext Engineer, as the page and the table on its implicit conversions document it.
    Plcnext = "plcnext",
    /// STruC++, as its documentation and the tests in its repository document it.
    Strucpp = "strucpp",
    /// RuSTy, as its book and the tests in its repository document it.
    Rusty = "rusty",
    /// CODESYS 3.5.21 with a 64-bit target, as it was recorded.
    Codesys = "codesys",
    /// TwinCAT 3, as its builds were recorded.
    Twincat = "twincat",
    /// Rockwell Logix 5000, as its manual and its help document it.
    Logix = "logix",
    /// Schneider Control Expert with implicit type conversion enabled, as its help documents it.
    ControlExpert = "control-expert",
    /// Omron NJ, as the manuals of its CPU unit and its instructions document it.
    Omron = "omron",
    /// The third edition of the standard, as public pages restate it.
    IecEd3 = "iec-ed3",
}

/// A [defined](DialectName::define) dialect. Dialects that were defined earlier compare as less.
#[derive(Clone, Copy)]
pub struct DefinedDialect {
    /// The number of dialects that were defined before this one.
    index: usize,
    definition: &'static Definition,
}

/// The defined dialects, in their order. They live as long as the process, because a name is copied into every case.
static DEFINED: RwLock<Vec<DefinedDialect>> = RwLock::new(Vec::new());

impl DialectName {
    /// Returns the definition of a user-defined dialect; `None` for a dialect of a documented system.
    pub const fn definition(self) -> Option<&'static Definition> {
        match self {
            DialectName::Defined(defined) => Some(defined.definition),
            _ => None,
        }
    }

    /// Returns whether this is a [variant](Definition::is_variant) of a documented system.
    pub const fn is_variant(self) -> bool {
        match self {
            DialectName::Defined(defined) => defined.definition.is_variant,
            _ => false,
        }
    }

    /// Returns whether this is a dialect of `stickler.toml`, which takes over the cases of its base.
    pub const fn is_custom(self) -> bool {
        matches!(self, DialectName::Defined(_)) && !self.is_variant()
    }

    /// Defines a dialect for the lifetime of the process. Defining the same dialect again changes nothing.
    ///
    /// # Errors
    /// [`TakenName`] if another dialect has the name; names that differ only in case count as the same.
    pub fn define(definition: Definition) -> Result<DialectName, TakenName> {
        let mut defined = DEFINED.write().unwrap_or_else(PoisonError::into_inner);
        if let Some(same) = defined.iter().find(|other| *other.definition == definition) {
            return Ok(DialectName::Defined(*same));
        }
        let others = defined.iter().map(|other| other.definition.name.as_str());
        let built_in = DialectName::ALL.iter().map(|dialect| dialect.as_str());
        if let Some(taken) = built_in
            .chain(others)
            .find(|name| name.eq_ignore_ascii_case(&definition.name))
        {
            return Err(TakenName(taken.to_owned()));
        }
        let dialect = DefinedDialect {
            index: defined.len(),
            definition: Box::leak(Box::new(definition)),
        };
        defined.push(dialect);
        Ok(DialectName::Defined(dialect))
    }

    /// Returns every defined dialect, variants of the suite among them, in the order of the definitions.
    pub fn defined() -> Vec<DialectName> {
        let defined = DEFINED.read().unwrap_or_else(PoisonError::into_inner);
        defined.iter().copied().map(DialectName::Defined).collect()
    }
}

impl BuiltIn {
    /// Returns whether the sources say single things of the system, pairs of types and values, and not what its language is: only
    /// tables that name it speak for it, and no programs are generated in it.
    pub const fn is_known_in_part(self) -> bool {
        matches!(
            self,
            BuiltIn::Codesys
                | BuiltIn::Twincat
                | BuiltIn::Logix
                | BuiltIn::ControlExpert
                | BuiltIn::Omron
                | BuiltIn::IecEd3
        )
    }
}

impl fmt::Debug for DefinedDialect {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.definition.name)
    }
}

impl PartialEq for DefinedDialect {
    fn eq(&self, other: &DefinedDialect) -> bool {
        self.index == other.index
    }
}

impl Eq for DefinedDialect {}

impl PartialOrd for DefinedDialect {
    fn partial_cmp(&self, other: &DefinedDialect) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for DefinedDialect {
    fn cmp(&self, other: &DefinedDialect) -> Ordering {
        self.index.cmp(&other.index)
    }
}

impl Hash for DefinedDialect {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.index.hash(state);
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

/// Returns a list of the dialects' names for a message, including user-defined ones, but only the first few of them.
fn known() -> String {
    const MAX_NAMES: usize = DialectName::ALL.len() + 5;
    let all = DialectName::ALL.into_iter().chain(DialectName::defined());
    let mut names: Vec<String> = all.map(|dialect| format!("`{dialect}`")).collect();
    let last = match names.len().checked_sub(MAX_NAMES) {
        Some(more) if more > 0 => {
            names.truncate(MAX_NAMES);
            format!("{more} more")
        }
        _ => names.pop().unwrap_or_default(),
    };
    format!("{} and {last}", names.join(", "))
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
            assert_eq!(dialect.base().name(), dialect);
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
        let define = |name| DialectName::define(Definition::new(name, BuiltIn::Matiec, "here"));
        let (first, second) = (define("first-of-two").unwrap(), define("second-of-two").unwrap());
        assert_eq!("first-of-two".parse(), Ok(first));
        assert_eq!(second.to_string(), "second-of-two");
        assert_eq!(first.base(), BuiltIn::Matiec);
        assert!(DialectName::Plcnext < first && first < second);
        assert!(DialectName::defined().contains(&first) && !DialectName::ALL.contains(&first));
        let message = "third-of-two".parse::<DialectName>().unwrap_err().to_string();
        assert!(message.contains("`first-of-two`"), "{message}");
        assert_eq!(define("first-of-two"), Ok(first));
        for taken in ["First-Of-Two", "matiec", "MATIEC"] {
            assert!(define(taken).is_err(), "{taken}");
        }
        let otherwise = Definition::new("first-of-two", BuiltIn::Plcnext, "there");
        assert!(DialectName::define(otherwise).is_err());
    }
}
