//! The names of the dialects; what a dialect means is the reference's affair.

use std::fmt;
use std::str::FromStr;

/// A named set of language rules, taken from one documented system.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum DialectName {
    /// IronPLC as documented, with the second edition of the standard.
    IronplcEd2,
    /// IronPLC as documented, with the third edition of the standard.
    IronplcEd3,
    /// IronPLC as documented, with the extensions that follow RuSTy.
    IronplcRusty,
    /// matiec, as the page on its conversion functions documents it.
    Matiec,
    /// PLCnext Engineer, as the page and the table on its implicit conversions document it.
    Plcnext,
}

impl DialectName {
    /// Every dialect, in the order of the declaration, which is the order in which reports name them.
    pub const ALL: [DialectName; 5] = [
        DialectName::IronplcEd2,
        DialectName::IronplcEd3,
        DialectName::IronplcRusty,
        DialectName::Matiec,
        DialectName::Plcnext,
    ];

    /// The name as it is written everywhere, such as `ironplc-ed2`.
    pub const fn as_str(self) -> &'static str {
        match self {
            DialectName::IronplcEd2 => "ironplc-ed2",
            DialectName::IronplcEd3 => "ironplc-ed3",
            DialectName::IronplcRusty => "ironplc-rusty",
            DialectName::Matiec => "matiec",
            DialectName::Plcnext => "plcnext",
        }
    }
}

impl fmt::Display for DialectName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// A text that names no [`DialectName`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error(
    "unknown dialect `{0}`; the dialects are `ironplc-ed2`, `ironplc-ed3`, `ironplc-rusty`, `matiec` and `plcnext`"
)]
pub struct UnknownDialect(pub String);

impl FromStr for DialectName {
    type Err = UnknownDialect;

    /// Reads exactly what [`DialectName::as_str`] gives.
    fn from_str(text: &str) -> Result<DialectName, UnknownDialect> {
        DialectName::ALL
            .into_iter()
            .find(|dialect| dialect.as_str() == text)
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
        }
    }

    #[test]
    fn the_error_for_an_unknown_name_lists_every_dialect() {
        let message = "codesys".parse::<DialectName>().unwrap_err().to_string();
        assert!(message.contains("`codesys`"), "{message}");
        for dialect in DialectName::ALL {
            assert!(
                message.contains(&format!("`{dialect}`")),
                "{message} does not name {dialect}"
            );
        }
    }
}
