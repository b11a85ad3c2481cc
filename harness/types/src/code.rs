//! The registry of diagnostic codes.
//!
//! Each code stands in one place, a file under `code/`, with all that is said about it; the macros below make the enumeration and
//! its table of that. The files are in the order of the codes, and so are the variants.

mod program;

#[macro_use]
mod arguments;
#[macro_use]
mod compiler;
#[macro_use]
mod extensions;
#[macro_use]
mod invocations;
#[macro_use]
mod literals;
#[macro_use]
mod names;
#[macro_use]
mod objects;
#[macro_use]
mod reading;
#[macro_use]
mod references;
#[macro_use]
mod statements;
#[macro_use]
mod targets;
#[macro_use]
mod type_contents;
#[macro_use]
mod type_declarations;

use crate::dialect_name::DialectName;
use program::{program, program_length};
use std::fmt;
use std::str::FromStr;

/// What the registry says about one code.
struct Entry {
    code: &'static str,
    name: &'static str,
    summary: &'static str,
    explanation: &'static str,
    dialect: Option<DialectName>,
    example: &'static str,
    fix: &'static str,
    repaired: Option<&'static str>,
}

/// Where the reference gives the code for the example: in that dialect, or only other compilers do (`elsewhere`).
macro_rules! dialect {
    (elsewhere) => {
        None
    };
    ($dialect:ident) => {
        Some(DialectName::$dialect)
    };
}

/// The text of a program without the indent that it has in the registry.
macro_rules! program {
    ($text:literal) => {{
        const TEXT: [u8; program_length($text)] = program($text);
        match str::from_utf8(&TEXT) {
            Ok(text) => text,
            Err(_) => panic!("taking off spaces cannot break a character"),
        }
    }};
}

/// The program put right, if the registry has it.
macro_rules! repaired {
    () => {
        None
    };
    ($text:literal) => {
        Some(program!($text))
    };
}

/// Makes the enumeration and its table of the entries.
macro_rules! registry {
    ($($code:ident $name:ident {
        summary: $summary:literal,
        explanation: $explanation:literal,
        example: $dialect:ident $example:literal,
        fix: $fix:literal,
        $(repaired: $repaired:literal,)?
    })*) => {
        /// A kind of diagnostic, in the order of the codes.
        ///
        /// Basis: ironplc-problem-codes, whose numbers, names and meanings these are; codes that begin with `S` are Stickler's own.
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
        pub enum Code {
            $(#[doc = concat!("`", stringify!($code), "`: ", $summary, ".")] $name,)*
        }

        impl Code {
            /// Every code, in order.
            pub const ALL: &'static [Code] = &[$(Code::$name,)*];
        }

        /// What is said about the codes, in their order.
        const ENTRIES: &[Entry] = &[$(Entry {
            code: stringify!($code),
            name: stringify!($name),
            summary: $summary,
            explanation: $explanation,
            dialect: dialect!($dialect),
            example: program!($example),
            fix: $fix,
            repaired: repaired!($($repaired)?),
        },)*];
    };
}

/// Strings the files of the registry together: each takes its turn, and adds its entries behind those before it.
macro_rules! gather {
    ([$first:ident $($rest:ident)*] $($entries:tt)*) => { $first! { [$($rest)*] $($entries)* } };
    ([] $($entries:tt)*) => { registry! { $($entries)* } };
}

gather! {
    [
        reading_codes type_declaration_codes type_content_codes reference_codes literal_codes invocation_codes
        name_codes argument_codes target_codes extension_codes statement_codes object_codes compiler_codes
    ]
}

impl Code {
    const fn entry(self) -> &'static Entry {
        &ENTRIES[self as usize]
    }

    /// The code itself, such as `P4035`.
    pub const fn as_str(self) -> &'static str {
        self.entry().code
    }

    /// The name, such as `AssignmentTypeMismatch`.
    pub const fn name(self) -> &'static str {
        self.entry().name
    }

    /// What the code says, in one line: a lower-case fragment without a full stop.
    pub const fn summary(self) -> &'static str {
        self.entry().summary
    }

    /// What the code means, in a few sentences.
    pub const fn explanation(self) -> &'static str {
        self.entry().explanation
    }

    /// A small complete program for which the code is given.
    pub const fn example(self) -> &'static str {
        self.entry().example
    }

    /// The dialect in which the reference gives the code for the [example](Code::example); nothing where only other compilers
    /// give the code.
    pub const fn example_dialect(self) -> Option<DialectName> {
        self.entry().dialect
    }

    /// How such a program is put right, in words.
    pub const fn fix(self) -> &'static str {
        self.entry().fix
    }

    /// The [example](Code::example) put right, where it can be.
    pub const fn repaired(self) -> Option<&'static str> {
        self.entry().repaired
    }

    /// Whether the code says that a construct is not enabled, which suppresses all else about that construct.
    ///
    /// Basis: stickler-design: §4.
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

/// A text that is no [`Code`].
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
#[error("unknown diagnostic code `{0}`; a code looks like `P4035`")]
pub struct UnknownCode(pub String);

impl FromStr for Code {
    type Err = UnknownCode;

    /// Reads what [`Code::as_str`] gives, in any case.
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
                let lines = || program.lines();
                assert!(
                    lines().all(|line| line == line.trim_end() && line.len() < 100),
                    "{code}:\n{program}"
                );
                let units = |word: &str| {
                    lines()
                        .filter(|line| line.split(' ').next() == Some(word))
                        .count()
                };
                assert_eq!(units("PROGRAM"), units("END_PROGRAM"), "{code}:\n{program}");
                assert!(
                    units("PROGRAM") == 1 || code == Code::NoProgramDeclaration,
                    "{code}:\n{program}"
                );
                assert_eq!(units("FUNCTION"), units("END_FUNCTION"), "{code}:\n{program}");
                assert_eq!(
                    units("FUNCTION_BLOCK"),
                    units("END_FUNCTION_BLOCK"),
                    "{code}:\n{program}"
                );
                assert_eq!(units("TYPE"), units("END_TYPE"), "{code}:\n{program}");
            }
        }
    }

    #[test]
    fn the_codes_that_suppress_others_are_those_of_the_design() {
        let suppressing = Code::ALL
            .iter()
            .filter(|code| code.not_enabled())
            .map(|code| code.as_str());
        assert!(suppressing.eq(["P0003", "P0004", "P0010", "P4033"]));
    }
}
