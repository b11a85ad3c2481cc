//! The dialects and groups of dialects that case files may name: `dialects.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::DialectName;
use stickler_types::definition::{Definition, Flag, Stated};
use toml::Spanned;

use crate::error::{CaseFileError, Mistake};
use crate::near::suggestion;
use crate::place::Lines;
use crate::toml_text;

/// The dialects and groups of dialects that case files may name.
#[derive(Clone, Debug)]
pub struct Dialects {
    groups: BTreeMap<String, Vec<DialectName>>,
    entries: BTreeMap<DialectName, DialectEntry>,
    /// The user-defined dialects that take over the cases of the dialects that they extend.
    defined: Vec<DialectName>,
}

/// The entry of one dialect in `dialects.toml`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct DialectEntry {
    /// A name for a person.
    pub title: String,
    /// A description of the system or the rules that the dialect stands for.
    pub description: String,
    /// The dialect whose cases it takes over.
    pub extends: Option<DialectName>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DialectsFile {
    #[serde(default)]
    groups: BTreeMap<String, Vec<Spanned<String>>>,
    #[serde(default)]
    dialect: BTreeMap<Spanned<String>, EntryFile>,
    #[serde(default)]
    variant: BTreeMap<Spanned<String>, VariantFile>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EntryFile {
    title: String,
    description: String,
    extends: Option<Spanned<String>>,
}

/// A variant of a documented system: its documents say what compiler options do.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct VariantFile {
    extends: Spanned<String>,
    description: String,
    flags: BTreeMap<Spanned<String>, bool>,
}

impl Default for Dialects {
    /// Returns the dialects under their own names, without groups.
    fn default() -> Self {
        Dialects {
            groups: BTreeMap::new(),
            entries: BTreeMap::new(),
            defined: Vec::new(),
        }
    }
}

impl Dialects {
    /// Adds user-defined dialects, which take over the cases of the dialects that they extend.
    pub(crate) fn with_defined(mut self, defined: &[DialectName]) -> Dialects {
        self.defined
            .extend(defined.iter().filter(|dialect| dialect.is_custom()));
        self
    }

    /// Reads `dialects.toml`; returns its usable part and its mistakes.
    pub(crate) fn read(text: &str) -> (Dialects, Vec<Mistake>) {
        let lines = Lines::new(text);
        match toml_text::read::<DialectsFile>(text, 0, &lines) {
            Ok(file) => DialectsReader {
                lines,
                mistakes: Vec::new(),
            }
            .read(file),
            Err(mistake) => (Dialects::default(), vec![mistake]),
        }
    }

    /// Reads the text of the `dialects.toml` that reports show as `shown`; returns its usable part and its mistakes.
    #[must_use]
    pub fn of_file(shown: &str, text: &str) -> (Dialects, Vec<CaseFileError>) {
        let (dialects, mistakes) = Dialects::read(text);
        let errors = mistakes.into_iter().map(|mistake| mistake.in_file(shown));
        (dialects, errors.collect())
    }

    /// Returns every dialect that case files may name, user-defined ones among them.
    pub(crate) fn all(&self) -> Vec<DialectName> {
        DialectName::ALL
            .into_iter()
            .chain(self.defined.iter().copied())
            .collect()
    }

    /// Returns the dialects that the file has an entry for, with their entries.
    pub fn entries(&self) -> impl Iterator<Item = (DialectName, &DialectEntry)> {
        self.entries.iter().map(|(&name, entry)| (name, entry))
    }

    /// Returns the groups, each with its dialects.
    pub fn groups(&self) -> impl Iterator<Item = (&str, &[DialectName])> {
        self.groups
            .iter()
            .map(|(name, members)| (name.as_str(), members.as_slice()))
    }

    /// Returns the dialects that a name stands for: those of a group, or the dialect itself and those that extend it.
    ///
    /// # Errors
    /// A message that lists the names there are.
    pub fn resolve(&self, name: &str) -> Result<Vec<DialectName>, String> {
        let mut found = match (self.groups.get(name), name.parse::<DialectName>()) {
            (Some(group), _) => group.clone(),
            (None, Ok(dialect)) => vec![dialect],
            (None, Err(_)) => return Err(self.unknown(name)),
        };
        // Extensions of extensions come in as long as there are new ones.
        let mut next = 0;
        while let Some(&base) = found.get(next) {
            let extending = self
                .entries
                .iter()
                .filter(|(_, entry)| entry.extends == Some(base));
            let defined = self.defined.iter().filter(|name| name.base().name() == base);
            let new: Vec<_> = extending
                .map(|(&name, _)| name)
                .chain(defined.copied())
                .filter(|name| !found.contains(name))
                .collect();
            found.extend(new);
            next += 1;
        }
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }

    fn unknown(&self, name: &str) -> String {
        let dialects = DialectName::ALL.iter().map(|dialect| dialect.as_str());
        let known: Vec<&str> = dialects.chain(self.groups.keys().map(String::as_str)).collect();
        format!("no dialect or group `{name}`; there are {}", known.join(", "))
    }
}

struct DialectsReader {
    lines: Lines,
    mistakes: Vec<Mistake>,
}

impl DialectsReader {
    fn read(mut self, file: DialectsFile) -> (Dialects, Vec<Mistake>) {
        let mut dialects = Dialects::default();
        // Groups may name them.
        for (name, variant) in file.variant {
            self.define(&name, variant);
        }
        for (group, members) in file.groups {
            let key = format!("groups.{group}");
            let members = members
                .iter()
                .filter_map(|member| self.dialect(member, &key))
                .collect();
            dialects.groups.insert(group, members);
        }
        for (name, entry) in file.dialect {
            let key = format!("dialect.{}", name.get_ref());
            let Some(dialect) = self.dialect(&name, &key) else {
                continue;
            };
            let entry = self.entry(entry, &key);
            dialects.entries.insert(dialect, entry);
        }
        (dialects, self.mistakes)
    }

    /// Defines a variant for the lifetime of the process, so that its name is one of a dialect.
    fn define(&mut self, name: &Spanned<String>, variant: VariantFile) {
        let key = format!("variant.{}", name.get_ref());
        let Some(base) = self.dialect(&variant.extends, &key) else {
            return;
        };
        let place = format!("dialects.toml:{}", self.lines.line(name.span().start));
        let mut definition = Definition {
            is_variant: true,
            about: Some(variant.description),
            ..Definition::new(name.get_ref(), base.base(), &place)
        };
        for (word, value) in variant.flags {
            match Flag::from_word(word.get_ref()) {
                Some(flag) => {
                    let basis = format!("{}: {} ({place})", name.get_ref(), flag.as_str());
                    definition.flags.insert(flag, Stated { value, basis });
                }
                None => {
                    let known = Flag::ALL.iter().map(|flag| flag.as_str());
                    let message = format!(
                        "no flag `{}`; {}",
                        word.get_ref(),
                        suggestion(word.get_ref(), known)
                    );
                    self.mistake(&word, &key, message);
                }
            }
        }
        if let Err(taken) = DialectName::define(definition) {
            self.mistake(name, &key, taken.to_string());
        }
    }

    fn entry(&mut self, entry: EntryFile, key: &str) -> DialectEntry {
        DialectEntry {
            title: entry.title,
            description: entry.description,
            extends: entry.extends.and_then(|base| self.dialect(&base, key)),
        }
    }

    fn dialect(&mut self, name: &Spanned<String>, key: &str) -> Option<DialectName> {
        let dialect = name.get_ref().parse();
        dialect
            .map_err(|error: stickler_types::UnknownDialect| self.mistake(name, key, error.to_string()))
            .ok()
    }

    fn mistake(&mut self, at: &Spanned<String>, key: &str, message: String) {
        self.mistakes
            .push(Mistake::new(self.lines.line(at.span().start), message).key(key));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use DialectName::{IronplcEd2, IronplcEd3, IronplcRusty, Matiec};

    fn read(text: &str) -> Dialects {
        let (dialects, mistakes) = Dialects::read(text);
        assert_eq!(mistakes, []);
        dialects
    }

    #[test]
    fn a_group_stands_for_its_members() {
        let dialects = read("[groups]\nboth = [\"matiec\", \"ironplc-ed2\"]");
        assert_eq!(dialects.resolve("both"), Ok(vec![IronplcEd2, Matiec]));
        assert_eq!(dialects.resolve("matiec"), Ok(vec![Matiec]));
        let unknown = dialects.resolve("neither").unwrap_err();
        assert!(unknown.contains("`neither`") && unknown.contains("both") && unknown.contains("plcnext"));
    }

    #[test]
    fn a_variant_is_named_and_takes_over_no_cases() {
        let dialects = read(
            "[groups]\nwith = [\"matiec\", \"test+bits\"]\n[variant.\"test+bits\"]\nextends = 'ironplc-ed2'\n\
             description = 'bits'\nflags = { allow-partial-access-syntax = true }",
        );
        let variant: DialectName = "test+bits".parse().expect("it is defined");
        assert!(variant.is_variant() && !variant.is_custom());
        let definition = variant.definition().expect("it is defined");
        assert_eq!(definition.flag(Flag::PartialAccessSyntax), Some(true));
        assert_eq!(dialects.resolve("with"), Ok(vec![Matiec, variant]));
        assert_eq!(dialects.resolve("ironplc-ed2"), Ok(vec![IronplcEd2]));
    }

    #[test]
    fn a_flag_of_a_variant_that_there_is_not_is_named_with_the_nearest() {
        let (_, mistakes) = Dialects::read(
            "[variant.test-flag]\nextends = 'matiec'\ndescription = ''\nflags = { bit-acces = true }",
        );
        let [mistake] = &mistakes[..] else {
            panic!("{mistakes:?}")
        };
        assert!(
            format!("{mistake:?}").contains("did you mean `bit-access`?"),
            "{mistake:?}"
        );
    }

    #[test]
    fn an_extending_dialect_takes_over_the_cases() {
        let dialects = read(
            "[dialect.ironplc-ed3]\ntitle=''\ndescription=''\nextends='ironplc-ed2'\n\
             [dialect.ironplc-rusty]\ntitle=''\ndescription=''\nextends='ironplc-ed3'",
        );
        assert_eq!(
            dialects.resolve("ironplc-ed2"),
            Ok(vec![IronplcEd2, IronplcEd3, IronplcRusty])
        );
        assert_eq!(dialects.resolve("ironplc-rusty"), Ok(vec![IronplcRusty]));
    }

    #[test]
    fn dialects_that_extend_each_other_come_to_an_end() {
        let dialects = read(
            "[dialect.ironplc-ed3]\ntitle=''\ndescription=''\nextends='ironplc-ed2'\n\
             [dialect.ironplc-ed2]\ntitle=''\ndescription=''\nextends='ironplc-ed3'",
        );
        assert_eq!(dialects.resolve("ironplc-ed2"), Ok(vec![IronplcEd2, IronplcEd3]));
    }

    #[test]
    fn mistakes_have_their_line_and_the_rest_is_used() {
        let (dialects, mistakes) = Dialects::read(
            "[groups]\nsome = [\"matiec\",\n\"matieck\"]\n[dialect.codesis]\ntitle=''\ndescription=''\n\
             [dialect.matiec]\ntitle=''\ndescription=''\nextends='nowhere'",
        );
        assert_eq!(
            mistakes.iter().map(|mistake| mistake.line).collect::<Vec<_>>(),
            [3, 4, 10]
        );
        assert_eq!(dialects.resolve("some"), Ok(vec![Matiec]));
        let (dialects, mistakes) = Dialects::read("groups = 3");
        assert_eq!(mistakes[0].line, 1);
        assert!(dialects.resolve("matiec").is_ok());
    }
}
