//! The dialects and groups of dialects that case files may name: `dialects.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::DialectName;
use toml::Spanned;

use crate::error::{CaseFileError, Mistake};
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
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct EntryFile {
    title: String,
    description: String,
    extends: Option<Spanned<String>>,
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
            .extend(defined.iter().filter(|dialect| dialect.definition().is_some()));
        self
    }

    /// Reads `dialects.toml`; returns its usable part and its mistakes.
    pub(crate) fn read(text: &str) -> (Dialects, Vec<Mistake>) {
        let lines = Lines::new(text);
        match toml_text::read::<DialectsFile>(text, 0, &lines) {
            Ok(file) => Reader {
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

struct Reader {
    lines: Lines,
    mistakes: Vec<Mistake>,
}

impl Reader {
    fn read(mut self, file: DialectsFile) -> (Dialects, Vec<Mistake>) {
        let mut dialects = Dialects::default();
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
            "[groups]\nsome = [\"matiec\",\n\"matieck\"]\n[dialect.codesys]\ntitle=''\ndescription=''\n\
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
