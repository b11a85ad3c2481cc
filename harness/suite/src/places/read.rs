//! Reads `places.toml`.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::DialectName;
use toml::Spanned;

use super::{PlaceKey, PlaceUnit, Places, ProgramPlace, Role, TESTED};
use crate::condition::{Condition, Testable};
use crate::error::{CaseFileError, Mistake, in_file, suggestion};
use crate::place::Lines;
use crate::toml_text;
use crate::{Dialects, Source, Sources, files, ident};

/// The file of the places, below the root of a suite.
const PLACES: &str = "places.toml";

/// The words in braces that the texts of a place may use.
const WORDS: [&str; 12] = [
    "from",
    "to",
    "value",
    "typed",
    "arriving",
    "below",
    "above",
    "source",
    "target",
    "observe",
    "error",
    "statement",
];

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct PlacesFile {
    #[serde(default)]
    configuration: String,
    #[serde(default)]
    plain: Vec<[Spanned<String>; 3]>,
    #[serde(default)]
    unit: BTreeMap<Spanned<String>, PlaceUnit>,
    #[serde(default)]
    source: BTreeMap<Spanned<String>, PlaceKey>,
    #[serde(default)]
    target: BTreeMap<Spanned<String>, PlaceKey>,
    #[serde(default)]
    surrounding: BTreeMap<Spanned<String>, PlaceKey>,
}

/// Reads the places of the suite at `root`, and leaves out those with mistakes. A suite without the file has none.
pub(crate) fn read(
    root: &files::Root,
    dialects: &Dialects,
    sources: &Sources,
) -> (Places, Vec<CaseFileError>) {
    root.read_own(PLACES, |text| of_text(text, dialects, Some(sources)))
}

impl Places {
    /// Reads the text of the `places.toml` that reports show as `shown`; returns its usable part and its mistakes. Does not ask
    /// whether what promises a place is a source, so that every dialect has the places but those that the text excepts.
    pub fn of_file(shown: &str, text: &str, dialects: &Dialects) -> (Places, Vec<CaseFileError>) {
        let (places, mistakes) = of_text(text, dialects, None);
        (places, in_file(mistakes, shown))
    }
}

fn of_text(text: &str, dialects: &Dialects, sources: Option<&Sources>) -> (Places, Vec<Mistake>) {
    let lines = Lines::new(text);
    let file = match toml_text::read::<PlacesFile>(text, 0, &lines) {
        Ok(file) => file,
        Err(mistake) => return (Places::default(), vec![mistake]),
    };
    let units = toml_text::in_order(file.unit);
    let mut reader = PlacesReader {
        dialects,
        sources,
        lines,
        units: units.iter().map(|(name, _)| name.get_ref().clone()).collect(),
        mistakes: Vec::new(),
    };
    let mut places = Places {
        sources: reader.places(Role::Source, file.source),
        targets: reader.places(Role::Target, file.target),
        surroundings: reader.places(Role::Surrounding, file.surrounding),
        units: units.into_iter().map(|(_, unit)| unit).collect(),
        configuration: file.configuration,
        plain: Vec::new(),
    };
    places.plain = reader.plain(&places, &file.plain);
    (places, reader.mistakes)
}

struct PlacesReader<'a> {
    dialects: &'a Dialects,
    /// The sources that may promise a place; `None` where nobody asks for them.
    sources: Option<&'a Sources>,
    lines: Lines,
    units: Vec<String>,
    mistakes: Vec<Mistake>,
}

impl PlacesReader<'_> {
    fn places(&mut self, role: Role, table: BTreeMap<Spanned<String>, PlaceKey>) -> Vec<ProgramPlace> {
        let mut places = Vec::new();
        for (name, key) in toml_text::in_order(table) {
            let before = self.mistakes.len();
            let place = self.place(role, &name, key);
            if self.mistakes.len() == before {
                places.push(place);
            }
        }
        places
    }

    fn place(&mut self, role: Role, name: &Spanned<String>, key: PlaceKey) -> ProgramPlace {
        let at = name.span().start;
        let path = format!("{}.{}", role.as_str(), name.get_ref());
        if let Err(message) = ident::check(name.get_ref()) {
            self.wrong(at, &path, message);
        }
        self.check(role, at, &path, &key);
        let dialects = self.dialects(&path, &key);
        let only_rejected = self.named(&path, key.only_rejected.as_deref());
        for name in key.only_rejected.iter().flatten() {
            let named = self.dialects.resolve(name.get_ref()).unwrap_or_default();
            if !named.is_empty() && named.iter().all(|dialect| !dialects.contains(dialect)) {
                let message = format!(
                    "`only-rejected` names `{}`, in which the place is not",
                    name.get_ref()
                );
                self.wrong(name.span().start, &path, message);
            }
        }
        let only = self.only(&path, key.only.as_ref());
        let units = self.units(&path, key.units.as_deref());
        ProgramPlace {
            name: name.get_ref().as_str().into(),
            dialects,
            only_rejected,
            only,
            units,
            is_in_its_statement: key.statement.contains("{error}"),
            is_behind_a_parameter: key.declarations.contains("{from}"),
            key,
        }
    }

    /// Returns the combinations that no probe takes.
    fn plain(&mut self, places: &Places, combinations: &[[Spanned<String>; 3]]) -> Vec<[usize; 3]> {
        let mut plain = Vec::new();
        for [source, target, surrounding] in combinations {
            let mut find = |role: Role, name: &Spanned<String>| {
                let found = places.find(role, name.get_ref());
                let found = found.map_err(|message| self.wrong(name.span().start, "plain", message));
                found.unwrap_or_default()
            };
            let sources = find(Role::Source, source);
            let targets = find(Role::Target, target);
            let surroundings = find(Role::Surrounding, surrounding);
            for &source in &sources {
                for &target in &targets {
                    plain.extend(
                        surroundings
                            .iter()
                            .map(|&surrounding| [source, target, surrounding]),
                    );
                }
            }
        }
        plain
    }

    /// Checks that a place has the texts that its role needs, and that the words in braces are known.
    fn check(&mut self, role: Role, at: usize, path: &str, key: &PlaceKey) {
        let needed: &[(&str, &str)] = match role {
            Role::Source => &[("value", &key.value)],
            Role::Target => &[
                ("statement", &key.statement),
                ("observe", &key.observe),
                ("code", &key.code),
            ],
            Role::Surrounding => &[("statement", &key.statement)],
        };
        let promised = key.promised.0.first().map_or("", |basis| basis.get_ref());
        let of_all = [("title", &*key.title), ("promised", promised)];
        let needed = of_all.iter().chain(needed);
        for (name, _) in needed.filter(|(_, text)| text.is_empty()) {
            let message = format!("a {} needs `{name}`", role.as_str());
            self.wrong(at, path, message);
        }
        let texts = [
            &key.declarations,
            &key.parameters,
            &key.variables,
            &key.sections,
            &key.globals,
            &key.before,
            &key.statement,
            &key.after,
            &key.caller,
            &key.arguments,
            &key.value,
            &key.target,
            &key.observe,
        ];
        for word in texts.into_iter().flat_map(|text| words(text)) {
            if !WORDS.contains(&word) {
                let message = format!("no word `{{{word}}}`; {}", suggestion(word, WORDS.into_iter()));
                self.wrong(at, path, message);
            }
        }
    }

    /// Returns the dialects that have the place: those for which one of its sources speaks, without those that lack it.
    fn dialects(&mut self, path: &str, key: &PlaceKey) -> Vec<DialectName> {
        let absent = self.named(path, key.absent.as_deref());
        let all = self.dialects.all().into_iter();
        let Some(sources) = self.sources else {
            return all.filter(|dialect| !absent.contains(dialect)).collect();
        };
        let mut speaking = Vec::new();
        for basis in &key.promised.0 {
            match sources.check(basis.get_ref()) {
                Ok(speaker) => speaking.push(speaker),
                Err(message) => self.wrong(basis.span().start, path, message),
            }
        }
        let has = |dialect: &DialectName| {
            let speaks = |(source, section): &(&Source, &str)| source.speaks_for(section, *dialect);
            !absent.contains(dialect) && speaking.iter().any(speaks)
        };
        all.filter(has).collect()
    }

    /// Returns the dialects of these names and groups.
    fn named(&mut self, path: &str, names: Option<&[Spanned<String>]>) -> Vec<DialectName> {
        let mut found = Vec::new();
        for name in names.unwrap_or_default() {
            match self.dialects.resolve(name.get_ref()) {
                Ok(dialects) => found.extend(dialects),
                Err(message) => self.wrong(name.span().start, path, message),
            }
        }
        found
    }

    fn only(&mut self, path: &str, only: Option<&Spanned<String>>) -> Condition {
        let Some(only) = only else {
            return Condition::default();
        };
        let words: Vec<&str> = only.get_ref().split_whitespace().collect();
        let names = TESTED.map(Into::into);
        let testable = Testable {
            names: &names,
            known: names.len(),
            unnamed: None,
        };
        Condition::parse(&words, testable).unwrap_or_else(|message| {
            self.wrong(only.span().start, path, message);
            Condition::default()
        })
    }

    fn units(&mut self, path: &str, names: Option<&[Spanned<String>]>) -> Vec<usize> {
        let Some(names) = names else {
            return (0..self.units.len()).collect();
        };
        let mut units = Vec::new();
        for name in names {
            match self.units.iter().position(|unit| unit == name.get_ref()) {
                Some(unit) => units.push(unit),
                None => {
                    let known = self.units.iter().map(String::as_str);
                    let message = format!(
                        "no unit `{}`; {}",
                        name.get_ref(),
                        suggestion(name.get_ref(), known)
                    );
                    self.wrong(name.span().start, path, message);
                }
            }
        }
        units
    }

    fn wrong(&mut self, at: usize, key: &str, message: String) {
        self.mistakes
            .push(Mistake::new(self.lines.line(at), message).key(key));
    }
}

/// Returns the words in braces of a text.
fn words(text: &str) -> impl Iterator<Item = &str> {
    text.split('{')
        .skip(1)
        .filter_map(|rest| Some(rest.split_once('}')?.0))
}
