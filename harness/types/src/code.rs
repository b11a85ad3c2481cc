//! The registry of diagnostic codes.
//!
//! Each code is a Markdown file, such as `harness/types/codes/P4035.md`, whose heading has its number and name.
//! `harness/types/README.md` explains how to add a code.

mod page;

use crate::diagnostic::Severity;
use crate::dialect_name::DialectName;
use page::CodePage;
use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

/// Generates the enumeration of the codes and the list of their entries from one line for each code.
macro_rules! codes {
    ($($code:ident $name:ident,)*) => {
        /// A kind of diagnostic, in the order of the codes.
        ///
        /// Basis: ironplc-problem-codes, whose numbers, names and meanings these are; codes that begin with `S` are Stickler's own.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(
                #[doc = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/codes/", stringify!($code), ".md"))]
                $name,
            )*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];
        }

        /// The entry of each code, in the order of [`Code::ALL`].
        const ENTRIES: &[CodeEntry] = &[$(CodeEntry {
            code: stringify!($code),
            name: stringify!($name),
            page: include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/codes/", stringify!($code), ".md")),
        },)*];
    };
}

// `codes!` with the numbers and names of all pages.
include!(concat!(env!("OUT_DIR"), "/codes.rs"));

/// A code by its page.
struct CodeEntry {
    /// The number, such as `P4035`.
    code: &'static str,
    /// The name, such as `AssignmentTypeMismatch`.
    name: &'static str,
    /// The text of the page.
    page: &'static str,
}

/// The pages of the codes in the order of [`Code::ALL`].
static PAGES: LazyLock<Vec<CodePage>> = LazyLock::new(|| {
    let parse = |entry: &CodeEntry| match page::parse(entry.code, entry.name, entry.page) {
        Ok(page) => page,
        Err(error) => panic!("harness/types/codes/{}.md: {error}", entry.code),
    };
    ENTRIES.iter().map(parse).collect()
});

impl Code {
    fn page(self) -> &'static CodePage {
        &PAGES[self as usize]
    }

    /// Returns the number, such as `P4035`.
    pub const fn as_str(self) -> &'static str {
        ENTRIES[self as usize].code
    }

    /// Returns the weight of a diagnostic with this code: a program with an error is rejected, one with warnings alone is accepted.
    pub const fn severity(self) -> Severity {
        match self {
            Code::SignedToUnsigned
            | Code::UnsignedToSigned
            | Code::LossOfInformation
            | Code::ImplicitDowncast
            | Code::NarrowingConversion => Severity::Warning,
            _ => Severity::Error,
        }
    }

    /// Returns the name, such as `AssignmentTypeMismatch`.
    pub const fn name(self) -> &'static str {
        ENTRIES[self as usize].name
    }

    /// Returns what the code says in one line: a lower-case fragment without a full stop.
    pub fn summary(self) -> &'static str {
        self.page().summary
    }

    /// Returns the meaning of the code in a few sentences on one line.
    pub fn explanation(self) -> &'static str {
        &self.page().explanation
    }

    /// Returns a small complete program for which the code is given.
    pub fn example(self) -> &'static str {
        self.page().example
    }

    /// Returns the dialect in which the reference gives the code for the [example](Code::example); `None` where only other
    /// compilers give the code.
    pub fn example_dialect(self) -> Option<DialectName> {
        self.page().dialect
    }

    /// Returns a description of how to correct such a program.
    pub fn fix(self) -> &'static str {
        &self.page().fix
    }

    /// Returns the corrected [example](Code::example), if it can be corrected.
    pub fn repaired(self) -> Option<&'static str> {
        self.page().repaired
    }

    /// Returns whether the code reports a construct that is not enabled, which suppresses every other diagnostic about that
    /// construct.
    ///
    /// Basis: rule: not-enabled-hides-the-rest.
    pub const fn not_enabled(self) -> bool {
        matches!(
            self,
            Code::PartialAccessSyntaxDisabled
                | Code::UnexpectedToken
                | Code::CStyleComment
                | Code::Std2013Feature
        )
    }
}

impl fmt::Display for Code {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// The error of a text that is not the number of a [`Code`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("unknown diagnostic code `{0}`; a code looks like `P4035`")]
pub struct UnknownCode(pub String);

impl FromStr for Code {
    type Err = UnknownCode;

    /// Parses the number of a code, in upper or lower case.
    fn from_str(text: &str) -> Result<Code, UnknownCode> {
        Code::ALL
            .iter()
            .copied()
            .find(|code| code.as_str().eq_ignore_ascii_case(text))
            .ok_or_else(|| UnknownCode(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_codes_ascend_and_are_read_back_in_any_case() {
        assert!(Code::ALL.is_sorted_by(|one, next| one.as_str() < next.as_str() && one < next));
        for &code in Code::ALL {
            assert_eq!(ENTRIES[code as usize].name, format!("{code:?}"));
            assert_eq!(code.to_string().parse(), Ok(code));
            assert_eq!(code.as_str().to_ascii_lowercase().parse(), Ok(code));
        }
        for text in ["", "P", "P9", "P40355", "4035", "AssignmentTypeMismatch"] {
            assert_eq!(text.parse::<Code>(), Err(UnknownCode(text.to_owned())));
        }
    }

    #[test]
    fn every_code_is_explained_with_an_example_and_a_fix() {
        for &code in Code::ALL {
            let summary = code.summary();
            assert!(
                !summary.is_empty() && !summary.ends_with('.') && !summary.contains('\n'),
                "{code}: {summary}"
            );
            for text in [code.explanation(), code.fix()] {
                assert!(
                    text.ends_with('.') && !text.contains("  ") && !text.contains('\n'),
                    "{code}: {text}"
                );
            }
            assert_ne!(code.repaired(), Some(code.example()), "{code}");
            assert!(
                code.example_dialect().is_none() || code.repaired().is_some(),
                "{code} has no repaired program"
            );
        }
    }

    #[test]
    fn the_programs_stand_flush_and_name_their_parts() {
        for &code in Code::ALL {
            for program in [Some(code.example()), code.repaired()].into_iter().flatten() {
                assert!(
                    !program.starts_with([' ', '\n']) && program.ends_with('\n'),
                    "{code}:\n{program}"
                );
                let is_flush = |line: &str| line == line.trim_end() && line.len() < 100;
                assert!(program.lines().all(is_flush), "{code}:\n{program}");
                let count = |word: &str| {
                    let begins = |line: &&str| line.split(' ').next() == Some(word);
                    program.lines().filter(begins).count()
                };
                for unit in ["PROGRAM", "FUNCTION", "FUNCTION_BLOCK", "TYPE"] {
                    assert_eq!(count(unit), count(&format!("END_{unit}")), "{code}:\n{program}");
                }
                assert!(
                    count("PROGRAM") == 1 || code == Code::NoProgramDeclaration,
                    "{code}:\n{program}"
                );
            }
        }
    }

    #[test]
    fn the_codes_that_suppress_others_are_those_of_the_design() {
        let suppressing = Code::ALL.iter().filter(|code| code.not_enabled());
        assert!(
            suppressing
                .map(|code| code.as_str())
                .eq(["P0003", "P0004", "P0010", "P4033"])
        );
    }
}
