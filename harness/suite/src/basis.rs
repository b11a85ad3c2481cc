//! The sources that an expectation may come from, and their sections.
//!
//! A basis is written `source: section`. The sections are the headings of the documents, letter by letter, so that a claim can
//! be traced from a report to the sentence. The one registry of them is here.

use stickler_types::{Code, ElementaryType};

/// A document that expectations come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// The name that a basis begins with.
    pub id: &'static str,
    /// The document's title, for a person.
    pub title: &'static str,
    /// The sections that may follow the colon.
    pub sections: Sections,
}

/// The way in which the sections of a source are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sections {
    /// By these headings.
    Headings(&'static [&'static str]),
    /// By a cell of the coloured table, `SINT to INT`, or the whole table.
    Table(&'static str, &'static [ElementaryType]),
    /// By a clause, a table or an annex of the standard: `6.3.4`, `Table 3`, `Annex B`.
    Clauses,
    /// By a diagnostic code of the registry.
    Codes,
    /// By a section of Stickler's own design: `§8`.
    Design,
}

/// The types of the coloured table, in its order.
const TABLE_TYPES: &[ElementaryType] = {
    use ElementaryType::*;
    &[
        Bool, Sint, Int, Dint, Lint, Usint, Uint, Udint, Ulint, Real, Lreal, Byte, Word, Dword, Lword, Time,
        Date, Tod, Dt, String,
    ]
};

/// All sources, in the order in which reports list them.
pub const SOURCES: &[Source] = &[
    Source {
        id: "ironplc-type-conversions",
        title: "IronPLC: Type Conversions",
        sections: Sections::Headings(&[
            "Type Conversions",
            "Implicit Type Widening",
            "Integer widening",
            "Integer to real widening",
            "Bit-string widening",
            "Widening chains",
            "Example",
            "Narrowing Conversions",
            "Bit-String Types",
            "Cross-family widening",
            "Integer and Real Types",
            "Explicit Conversion Functions",
        ]),
    },
    Source {
        id: "ironplc-bit-access",
        title: "IronPLC: Bit Access",
        sections: Sections::Headings(&[
            "Bit Access",
            "Support",
            "Syntax",
            "Valid Base Types",
            "Edition 3 Partial-Access Syntax",
            "Byte / Word / Dword / Lword Partial Access",
        ]),
    },
    Source {
        id: "forgeiec-conversion-functions",
        title: "ForgeIEC: Type-conversion functions",
        sections: Sections::Headings(&[
            "The naming pattern",
            "Range and precision",
            "TRUNC vs. ROUND",
            "BCD encoding",
            "IEC reference",
            "matiec conformance",
            "ForgeIEC notes",
        ]),
    },
    Source {
        id: "implicit-conversion-rules",
        title: "PLCnext Engineer: Implicit Data Type Conversion",
        // The page has one heading; its rules are named here.
        sections: Sections::Headings(&[
            "Implicit Data Type Conversion",
            "Range and precision",
            "ANY_NUM",
            "ANY_DURATION",
            "ANY_BIT",
            "ANY_DATE, STRING and user defined",
            "Size",
            "Mantissa",
            "Unsigned integers",
        ]),
    },
    Source {
        id: "implicit-conversion-table",
        title: "PLCnext Engineer: SEM1189, allowed implicit conversions",
        sections: Sections::Table("SEM1189 table", TABLE_TYPES),
    },
    Source {
        id: "iec-61131-3",
        title: "IEC 61131-3",
        sections: Sections::Clauses,
    },
    Source {
        id: "ironplc-problem-codes",
        title: "IronPLC: problem codes",
        sections: Sections::Codes,
    },
    Source {
        id: "stickler-design",
        title: "Stickler: design",
        sections: Sections::Design,
    },
];

/// Returns the source with this id.
pub fn source(id: &str) -> Option<&'static Source> {
    SOURCES.iter().find(|source| source.id == id)
}

/// Returns the source and the section that a basis such as `"ironplc-bit-access: Syntax"` names.
///
/// # Errors
/// A message that says which part is unknown and what there is.
pub fn check(basis: &str) -> Result<(&'static Source, &str), String> {
    let Some((id, section)) = basis.split_once(':') else {
        return Err(format!("`{basis}` is not written `source: section`"));
    };
    let Some(source) = source(id) else {
        let known: Vec<&str> = SOURCES.iter().map(|source| source.id).collect();
        return Err(format!("no source `{id}`; there are {}", known.join(", ")));
    };
    let section = section.trim();
    match source.sections.unknown(section) {
        None => Ok((source, section)),
        Some(expected) => Err(format!("`{id}` has no section `{section}`; {expected}")),
    }
}

impl Sections {
    /// Returns an error message with the valid spellings, if the source has no such section.
    fn unknown(self, section: &str) -> Option<String> {
        let (known, expected) = match self {
            Sections::Headings(headings) => (headings.contains(&section), headings.join(" · ")),
            Sections::Table(whole, types) => (
                section == whole || is_cell(section, types),
                format!("write `{whole}`, or a cell like `SINT to INT`"),
            ),
            Sections::Clauses => (
                is_clause(section),
                "write a clause, a table or an annex: `6.3.4`, `Table 3`, `Annex B`".to_owned(),
            ),
            Sections::Codes => (
                section.parse::<Code>().is_ok(),
                "write a code: `P4035`".to_owned(),
            ),
            Sections::Design => (is_design_section(section), "write `§1` to `§9`".to_owned()),
        };
        (!known).then_some(expected)
    }
}

fn is_cell(section: &str, types: &[ElementaryType]) -> bool {
    let known = |name: &str| types.iter().any(|ty| ty.name() == name);
    section
        .split_once(" to ")
        .is_some_and(|(from, to)| known(from) && known(to))
}

fn is_clause(section: &str) -> bool {
    let number = |text: &str| text.starts_with(|c: char| c.is_ascii_digit());
    let annex = |text: &str| text.starts_with(|c: char| c.is_ascii_uppercase());
    number(section)
        || section.strip_prefix("Table ").is_some_and(number)
        || section.strip_prefix("Annex ").is_some_and(annex)
}

fn is_design_section(section: &str) -> bool {
    let number = section.strip_prefix('§').and_then(|rest| rest.split('.').next());
    number.is_some_and(|number| number.parse().is_ok_and(|number: u8| (1..=9).contains(&number)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_known_basis_gives_its_source_and_section() {
        for (basis, id, section) in [
            (
                "ironplc-type-conversions: Integer widening",
                "ironplc-type-conversions",
                "Integer widening",
            ),
            (
                "implicit-conversion-table: SEM1189 table",
                "implicit-conversion-table",
                "SEM1189 table",
            ),
            (
                "implicit-conversion-table: UDINT to TIME",
                "implicit-conversion-table",
                "UDINT to TIME",
            ),
            ("iec-61131-3: 6.3.4", "iec-61131-3", "6.3.4"),
            ("iec-61131-3: Table 3", "iec-61131-3", "Table 3"),
            ("iec-61131-3: Annex B.2", "iec-61131-3", "Annex B.2"),
            ("ironplc-problem-codes: P4035", "ironplc-problem-codes", "P4035"),
            ("stickler-design: §8", "stickler-design", "§8"),
            ("stickler-design: §3.1", "stickler-design", "§3.1"),
        ] {
            assert_eq!(
                check(basis).map(|(source, section)| (source.id, section)),
                Ok((id, section))
            );
        }
    }

    #[test]
    fn a_typo_in_a_basis_is_found() {
        for (basis, said) in [
            ("ironplc-type-conversions", "is not written `source: section`"),
            (
                "ironplc: Integer widening",
                "no source `ironplc`; there are ironplc-type-conversions",
            ),
            (
                "ironplc-type-conversions: Integer Widening",
                "Integer widening · ",
            ),
            (
                "implicit-conversion-table: LTIME to TIME",
                "a cell like `SINT to INT`",
            ),
            ("iec-61131-3: somewhere", "write a clause"),
            ("iec-61131-3: Table x", "write a clause"),
            ("ironplc-problem-codes: P9876", "write a code"),
            ("stickler-design: §10", "write `§1` to `§9`"),
            ("stickler-design: 8", "write `§1` to `§9`"),
        ] {
            let message = check(basis).unwrap_err();
            assert!(message.contains(said), "{basis}: {message}");
        }
    }

    #[test]
    fn no_source_is_listed_twice() {
        for (at, source) in SOURCES.iter().enumerate() {
            assert!(
                SOURCES[..at].iter().all(|other| other.id != source.id),
                "{}",
                source.id
            );
        }
    }
}
