//! The dialects and groups of dialects that case files may name: `dialects/*.toml` and `dialects.toml`.

use std::collections::BTreeMap;
use std::path::Path;

use serde::Deserialize;
use stickler_types::dialect_file::read_documented;
use stickler_types::{Dialect, DialectName, join, sorted};
use toml::Spanned;

use crate::error::{CaseFileError, Mistake, in_file};
use crate::place::Lines;
use crate::{Wanted, files, toml_text};

/// The folder of the files of dialects, below the root of a suite.
const FOLDER: &str = "dialects";

/// The file of the groups, below the root of a suite.
const GROUPS: &str = "dialects.toml";

/// The word for every documented system: a case file that names it asks those that have the features of its programs.
const EVERY: &str = "all";

/// The dialects and groups of dialects that case files may name.
#[derive(Clone, Debug, Default)]
pub struct Dialects {
    groups: BTreeMap<String, Vec<DialectName>>,
    /// The documented systems that the folder has besides those that Stickler carries.
    added: Vec<DialectName>,
    /// The user-defined dialects that take over the cases of the dialects that they extend.
    defined: Vec<DialectName>,
    /// The dialects that get cases; all where there is none.
    asked: Vec<DialectName>,
    /// Whether a dialect that is asked beside another one gets the cases in which they do not differ.
    with_repeats: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DialectsFile {
    #[serde(default)]
    groups: BTreeMap<String, Vec<Spanned<String>>>,
}

impl Dialects {
    /// Adds the user-defined dialects that are wanted, which take over the cases of the dialects that they extend, and restricts those that
    /// get cases.
    pub(crate) fn wanting(mut self, wanted: Wanted<'_>) -> Dialects {
        let defined = wanted.defined.iter().filter(|dialect| dialect.is_custom());
        self.defined.extend(defined);
        self.asked = wanted.asked.to_vec();
        self.with_repeats = wanted.with_repeats;
        self
    }

    /// Returns whether a dialect gets cases.
    pub(crate) fn asks(&self, dialect: DialectName) -> bool {
        self.asked.is_empty() || self.asked.contains(&dialect)
    }

    /// Returns the dialects that are asked beside another one that is asked, each with the other; none where repeats are wanted.
    pub(crate) fn asked_beside(&self) -> impl Iterator<Item = (DialectName, DialectName)> {
        let beside = |dialect: DialectName| {
            let other = dialect.rules().asked_beside.as_ref()?.parse().ok()?;
            Some((dialect, other)).filter(|&(_, other)| !self.with_repeats && self.asks(other))
        };
        self.documented().filter_map(beside)
    }

    /// Defines the dialects of a suite's folder, so that a command line may name them; what is wrong with its files is reported
    /// where its cases are loaded.
    pub fn define_those_of(folder: &Path) {
        let _ = read(&files::Root::new(folder));
    }

    /// Reads the text of the `dialects.toml` that reports show as `shown`; returns its usable part and its mistakes.
    pub fn of_file(shown: &str, text: &str) -> (Dialects, Vec<CaseFileError>) {
        let (dialects, mistakes) = Dialects::default().with_groups(text);
        (dialects, in_file(mistakes, shown))
    }

    /// Adds the groups of the text of a `dialects.toml`; returns its mistakes, too.
    fn with_groups(mut self, text: &str) -> (Dialects, Vec<Mistake>) {
        let lines = Lines::new(text);
        let file = match toml_text::read::<DialectsFile>(text, 0, &lines) {
            Ok(file) => file,
            Err(mistake) => return (self, vec![mistake]),
        };
        let mut mistakes = Vec::new();
        for (group, members) in file.groups {
            let read = |member: &Spanned<String>| match member.get_ref().parse() {
                Ok(dialect) => Some(dialect),
                Err(unknown) => {
                    let unknown: stickler_types::UnknownDialect = unknown;
                    let line = lines.line(member.span().start);
                    mistakes.push(Mistake::new(line, unknown.to_string()).key(format!("groups.{group}")));
                    None
                }
            };
            let members = members.iter().filter_map(read).collect();
            self.groups.insert(group, members);
        }
        (self, mistakes)
    }

    /// Defines the dialect of the text of a file `dialects/NAME.toml` for the lifetime of the process, unless Stickler carries it.
    fn define(&mut self, name: &str, text: &str, place: &str) -> Result<(), Mistake> {
        if DialectName::ALL.iter().any(|carried| carried.as_str() == name) {
            return Ok(());
        }
        let extended = |other: &str| Some(other.parse::<DialectName>().ok()?.rules().clone());
        // A dialect that is not defined yet stands for itself in its own definition.
        let own = DialectName::IEC_ED3;
        let lines = Lines::new(text);
        let file = read_documented((name, own), text, place, &extended)
            .map_err(|mistake| Mistake::new(lines.line(mistake.span.start), mistake.message))?;
        let define =
            |definition| DialectName::define(definition).map_err(|taken| Mistake::new(1, taken.to_string()));
        let base = define(file.dialect)?;
        for variant in file.variants {
            define(Dialect { base, ..variant })?;
        }
        self.added.push(base);
        Ok(())
    }

    /// Returns every documented system.
    fn documented(&self) -> impl Iterator<Item = DialectName> {
        DialectName::ALL.into_iter().chain(self.added.iter().copied())
    }

    /// Returns every dialect that case files may name, user-defined ones among them.
    pub(crate) fn all(&self) -> Vec<DialectName> {
        self.documented().chain(self.defined.iter().copied()).collect()
    }

    /// Returns the groups, each with its dialects.
    pub fn groups(&self) -> impl Iterator<Item = (&str, &[DialectName])> {
        self.groups
            .iter()
            .map(|(name, members)| (name.as_str(), members.as_slice()))
    }

    /// Returns the dialects that names with blanks between them stand for: those of a group, or a dialect itself and those that extend it.
    /// `all` stands for every documented system, and `all but codesys twincat` for the others.
    ///
    /// # Errors
    /// A message that lists the names there are.
    pub fn resolve(&self, names: &str) -> Result<Vec<DialectName>, String> {
        let (named, but) = names.split_once(" but ").unwrap_or((names, ""));
        let mut found = self.of_names(named)?;
        let others = self.of_names(but)?;
        found.retain(|dialect| !others.contains(dialect));
        Ok(sorted(found))
    }

    /// Returns whether names begin with the word for every documented system.
    pub fn is_all(names: &str) -> bool {
        names.split_whitespace().next() == Some(EVERY)
    }

    fn of_names(&self, names: &str) -> Result<Vec<DialectName>, String> {
        let mut found = Vec::new();
        for name in names.split_whitespace().map(|name| name.trim_end_matches(',')) {
            match (self.groups.get(name), name.parse::<DialectName>()) {
                (Some(group), _) => found.extend(group),
                (None, Ok(dialect)) => found.push(dialect),
                (None, Err(_)) if name == EVERY => found.extend(self.documented()),
                (None, Err(_)) => return Err(self.unknown(name)),
            }
        }
        let extending = self.defined.iter().filter(|name| found.contains(&name.base()));
        let extending: Vec<DialectName> = extending.copied().collect();
        found.extend(extending);
        Ok(found)
    }

    fn unknown(&self, name: &str) -> String {
        let dialects = DialectName::ALL.iter().map(|dialect| dialect.as_str());
        let groups = self.groups.keys().map(String::as_str);
        let every = (!self.groups.contains_key(EVERY)).then_some(EVERY);
        let known = join(dialects.chain(every).chain(groups), ", ");
        format!("no dialect or group `{name}`; there are {known}")
    }
}

/// Reads the dialects and groups of a suite: `dialects/*.toml` and `dialects.toml`; returns what is wrong with the files, too.
pub(crate) fn read(root: &files::Root) -> (Dialects, Vec<CaseFileError>) {
    let mut dialects = Dialects::default();
    let mut errors = Vec::new();
    for name in files::names(&root.path().join(FOLDER), "toml") {
        let below = format!("{FOLDER}/{name}.toml");
        let shown = root.shown(&below);
        let read = files::read(&root.path().join(&below));
        if let Err(mistake) = read.and_then(|text| dialects.define(&name, &text, &shown)) {
            errors.push(mistake.in_file(&shown));
        }
    }
    let shown = root.shown(GROUPS);
    match files::read(&root.path().join(GROUPS)) {
        Ok(text) => {
            let (with, mistakes) = dialects.with_groups(&text);
            errors.extend(in_file(mistakes, &shown));
            (with, errors)
        }
        Err(mistake) => {
            errors.push(mistake.in_file(&shown));
            (dialects, errors)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Rounding;

    const ED2: DialectName = DialectName::IRONPLC_ED2;
    const MATIEC: DialectName = DialectName::MATIEC;

    fn read(text: &str) -> Dialects {
        let (dialects, mistakes) = Dialects::default().with_groups(text);
        assert_eq!(mistakes, []);
        dialects
    }

    #[test]
    fn a_variant_is_named_and_takes_over_no_cases() {
        let dialects = read("[groups]\nwith = [\"matiec\", \"ironplc-ed2+partial-access\"]");
        let variant: DialectName = "ironplc-ed2+partial-access".parse().expect("its file has it");
        assert!(variant.is_variant() && !variant.is_custom());
        let stated: Vec<_> = variant.rules().statements().collect();
        assert_eq!(stated, [("flags.allow-partial-access-syntax", "true".to_owned())]);
        assert_eq!(dialects.resolve("with"), Ok(vec![MATIEC, variant]));
        assert_eq!(dialects.resolve("ironplc-ed2"), Ok(vec![ED2]));
    }

    #[test]
    fn a_file_adds_a_dialect_and_its_variants_without_rust() {
        let mut dialects = Dialects::default();
        let text = "title = 'Trial'\nextends = 'matiec'\n[flags]\nbit-access = true\n[conversions]\nrounding = 'half-to-even'\n\
                    [variants.'trial+comments'.flags]\nline-comments = true\n";
        dialects
            .define("trial", text, "dialects/trial.toml")
            .expect("it can be read");
        let trial: DialectName = "trial".parse().expect("it is defined");
        assert_eq!(
            (trial.base(), trial.is_custom(), trial.definition()),
            (trial, false, None)
        );
        let rules = Dialect::of(trial);
        assert!(rules.bit_access && !rules.line_comments && !rules.rounding_functions);
        assert_eq!(rules.conversions.rounding, Rounding::HalfToEven);
        let variant: DialectName = "trial+comments".parse().expect("it is defined");
        assert!(variant.is_variant() && variant.base() == trial && Dialect::of(variant).line_comments);
        assert_eq!(dialects.resolve("trial"), Ok(vec![trial]));
        assert!(dialects.all().contains(&trial));
    }
}
