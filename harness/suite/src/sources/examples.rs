//! The programs and fragments that the sections of a source print: how many there are, and which of them no case holds.
//!
//! A case says by a tag such as `example-2` that it is the second example of the section that it cites.

use std::collections::{BTreeMap, BTreeSet};

use serde::Deserialize;
use toml::Spanned;

use super::read::SourcesReader;
use super::{Sections, Sources};
use crate::error::{CaseFileError, Mistake};
use crate::{Case, NOT_STATED};

/// The beginning of a tag that says which example a case is.
const TAG: &str = "example-";

/// The examples of one section.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct SectionExamples {
    /// The number of examples that the section prints, counted when it was read.
    count: u32,
    /// The examples, from 1, that no case holds, for a reason that the file gives.
    omitted: BTreeSet<u32>,
    /// The line of `sources.toml` with the number.
    line: u32,
}

/// `[[omitted]]`: examples without a case, by section, and the reason.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OmittedEntry {
    reason: Spanned<String>,
    examples: BTreeMap<Spanned<String>, Vec<u32>>,
}

impl SourcesReader<'_> {
    /// Returns the examples of a source by section. Records a mistake for a section that the source does not have, and for what is omitted
    /// without a reason or is not among the examples.
    pub(super) fn examples(
        &mut self,
        key: &str,
        sections: &Sections,
        counts: BTreeMap<Spanned<String>, u32>,
        omitted: Vec<OmittedEntry>,
    ) -> BTreeMap<String, SectionExamples> {
        let mut examples = BTreeMap::new();
        for (section, count) in counts {
            let at = section.span().start;
            if let Some(expected) = sections.unknown(section.get_ref()) {
                let message = format!("examples of no section `{}`; {expected}", section.get_ref());
                self.wrong(at, key, message);
            }
            let counted = SectionExamples {
                count,
                omitted: BTreeSet::new(),
                line: self.lines.line(at),
            };
            examples.insert(section.into_inner(), counted);
        }
        for entry in omitted {
            if entry.reason.get_ref().trim().is_empty() {
                let message = "`reason` is empty; write why these examples have no case".to_owned();
                self.wrong(entry.reason.span().start, key, message);
            }
            for (section, numbers) in entry.examples {
                let (at, section) = (section.span().start, section.into_inner());
                let counted = examples.get_mut(&section);
                let count = counted.as_ref().map_or(0, |counted| counted.count);
                for number in numbers.iter().filter(|number| !(1..=count).contains(number)) {
                    self.wrong(at, key, beyond(*number, &section, count));
                }
                if let Some(counted) = counted {
                    counted.omitted.extend(numbers);
                }
            }
        }
        examples
    }
}

impl Sources {
    /// Returns a mistake for each case that is an example which its section does not print.
    pub(crate) fn unprinted(&self, cases: &[Case]) -> BTreeSet<CaseFileError> {
        let mistake = |(case, number): (&Case, &str)| {
            let message = self.example(&case.basis, number).err()?;
            Some(Mistake::new(case.line, message).key("tags").in_file(&case.file))
        };
        tagged(cases).filter_map(mistake).collect()
    }

    /// Returns a warning for each example that neither has a case nor is omitted, for each that is omitted and has one, and for each section
    /// without a number that cases cite where others of its source have one.
    pub(super) fn without_case<'c>(&self, cases: &'c [Case], cited: &BTreeSet<&str>) -> Vec<CaseFileError> {
        let number =
            |(case, number): (&'c Case, &str)| Some((&*case.basis, self.example(&case.basis, number).ok()?));
        let held: BTreeSet<(&str, u32)> = tagged(cases).filter_map(number).collect();
        let mut warnings = Vec::new();
        for source in &self.sources {
            let mut warn = |line, message, hint| {
                let mistake = Mistake::new(line, message).key(source.key.clone());
                warnings.push(mistake.hint(hint).in_file(&self.file));
            };
            for (section, examples) in &source.examples {
                let basis = format!("{}: {section}", source.key);
                for number in 1..=examples.count {
                    let is_held = held.contains(&(basis.as_str(), number));
                    let (what, hint) = match (is_held, examples.omitted.contains(&number)) {
                        (false, false) => (
                            "has no case",
                            "write one, or list it with a reason under `omitted`",
                        ),
                        (true, true) => ("is omitted and has a case", "take it out of `omitted`"),
                        _ => continue,
                    };
                    warn(
                        examples.line,
                        format!("example {number} of `{section}` {what}"),
                        hint,
                    );
                }
            }
            let sections = cited
                .iter()
                .filter_map(|basis| basis.strip_prefix(&*source.key)?.strip_prefix(": "));
            for section in sections.filter(|&section| !source.examples.contains_key(section)) {
                if !source.examples.is_empty() {
                    let message = format!("`examples` does not say how many `{section}` prints");
                    warn(source.line, message, "write 0 where it prints none");
                }
            }
        }
        warnings
    }

    /// Returns the number of an example of the section of a basis, as a tag gives it.
    fn example(&self, basis: &str, number: &str) -> Result<u32, String> {
        let parsed = number.parse();
        let number =
            parsed.map_err(|_| format!("`{TAG}{number}` does not end with the number of an example"))?;
        let (section, count) = self.of(basis).map_or((basis, 0), |(source, section)| {
            let examples = source.examples.get(section);
            (section, examples.map_or(0, |examples| examples.count))
        });
        match (1..=count).contains(&number) {
            true => Ok(number),
            false => Err(beyond(number, section, count)),
        }
    }
}

/// Returns the cases that are examples, with the numbers of their tags.
fn tagged(cases: &[Case]) -> impl Iterator<Item = (&Case, &str)> {
    let cites = cases.iter().filter(|case| &*case.basis != NOT_STATED);
    cites.flat_map(|case| {
        case.tags
            .iter()
            .filter_map(move |tag| Some((case, tag.strip_prefix(TAG)?)))
    })
}

/// Returns the message about an example that a section does not print.
fn beyond(number: u32, section: &str, count: u32) -> String {
    match count {
        0 => format!("no example {number}: no `examples` in the file of sources counts those of `{section}`"),
        _ => format!("no example {number}: `{section}` prints {count}, counted from 1"),
    }
}
