//! The list of language features, from `features.toml`.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::LazyLock;

use rustc_hash::FxHashMap;
use serde::Deserialize;
pub use stickler_syntax::features::FeatureKey;
use stickler_types::{Dialect, DialectName, ElementaryType, words};
use toml::Spanned;

use crate::dialects::Dialects;
use crate::error::{CaseFileError, Mistake, suggestion};
use crate::place::Lines;
use crate::toml_text;
use crate::{Case, Sources, files};

/// The file of the features, below the root of a suite.
const FEATURES: &str = "features.toml";

/// The list of the language's features.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Features {
    /// In the order of the file.
    list: Vec<Feature>,
    /// The dialects that lack a feature, by its key.
    lacked: FxHashMap<String, BTreeSet<DialectName>>,
}

/// A construct of the language that a program may use, a dialect may have, and an engine may lack.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Feature {
    /// The key, such as `array-repetition`.
    pub key: String,
    /// The feature in the words of a sentence.
    pub title: String,
    /// The tables and rows of IEC 61131-3 that are about it, by edition (2, 3, 4).
    pub tables: BTreeMap<u8, String>,
    /// The other features that each program with this one uses.
    pub needs: Vec<String>,
    /// The bases that state that a compiler must take it, most binding first.
    pub promised: Vec<String>,
    /// A minimal program that uses it, and those that it needs.
    pub program: String,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct FeatureTable {
    title: String,
    ed2: Option<String>,
    ed3: Option<String>,
    ed4: Option<String>,
    #[serde(default)]
    needs: Vec<Spanned<String>>,
    #[serde(default)]
    promised: Vec<Spanned<String>>,
    program: String,
}

words! {
    /// The answer of a system to the question whether it has a feature.
    FeatureSupport {
        /// The edition of IEC 61131-3 that a system declares has the feature, or the documents of the system name it.
        Has = "has",
        /// The documents of a system say that it lacks the feature.
        Lacks = "lacks",
        /// A system declares nothing of the feature.
        Open = "open",
    }
}

impl Feature {
    /// Returns what a dialect declares of the feature.
    pub fn support(&self, dialect: DialectName) -> FeatureSupport {
        let rules = dialect.rules();
        // No table of the fourth edition is public: it has what the third has, without what its file names.
        let edition = rules.features.edition.map(|edition| edition.min(3));
        if rules.lacks(&self.key) {
            FeatureSupport::Lacks
        } else if rules.features.has.contains(&self.key)
            || edition.is_some_and(|edition| self.tables.contains_key(&edition))
        {
            FeatureSupport::Has
        } else {
            FeatureSupport::Open
        }
    }

    /// Returns the bases that promise the feature.
    pub fn promises(&self) -> impl Iterator<Item = &str> {
        self.promised.iter().map(String::as_str)
    }
}

impl Case {
    /// Returns the keys of the features that the program of the case uses.
    pub fn features(&self) -> BTreeSet<FeatureKey> {
        stickler_syntax::features::features(&self.source, Dialect::of(self.dialect))
    }
}

impl Features {
    /// Returns the features of the suite that ships with Stickler, without asking whether their bases have sources.
    pub fn built_in() -> &'static Features {
        static BUILT_IN: LazyLock<Features> = LazyLock::new(|| {
            let text = include_str!("../../../conformance-cases/features.toml");
            let tables = toml_text::read(text, 0, &Lines::new(text)).unwrap_or_default();
            features(tables, &Sources::default(), &Lines::new(text)).0
        });
        &BUILT_IN
    }

    /// Returns the features, in the order of the file.
    pub fn iter(&self) -> impl Iterator<Item = &Feature> {
        self.list.iter()
    }

    /// Returns the feature of a key; `None` where the list has none of it.
    pub fn get(&self, key: &str) -> Option<&Feature> {
        self.list.iter().find(|feature| feature.key == key)
    }

    /// Returns the dialects that lack a feature of a program.
    pub(crate) fn lacking(&self, source: &str) -> BTreeSet<DialectName> {
        let mut lacking = BTreeSet::new();
        for used in stickler_syntax::features::feature_uses(source, &Dialect::DEFAULT) {
            if let Some(dialects) = self.lacked.get(&*used.key) {
                lacking.extend(dialects);
            }
        }
        lacking
    }

    /// Notes which of the dialects lack which features; returns a mistake for each word of a dialect that is no feature, and for each name that
    /// it gives to nothing. A folder of cases may have fewer features than the dialects that Stickler carries name, so these are not asked.
    fn ask(&mut self, dialects: &[DialectName]) -> Vec<Mistake> {
        let mut mistakes = Vec::new();
        let features = || self.list.iter().map(|feature| feature.key.as_str());
        for &dialect in dialects {
            let rules = dialect.rules();
            let mut say = |message: String, word: &str| {
                mistakes.push(Mistake::new(1, message).hint(suggestion(word, features())));
            };
            let declared = rules.features.has.iter().chain(&rules.features.lacks);
            if !DialectName::ALL.contains(&dialect) {
                for word in declared.filter(|word| self.get(word).is_none()) {
                    let message = format!("`[features]` of {dialect} names `{word}`, which is no feature");
                    say(message, word);
                }
                for word in rules
                    .names
                    .values()
                    .filter(|word| !self.is_standard(word, dialect))
                {
                    let message = format!(
                        "`[names]` of {dialect} gives another name to `{word}`, which is no type, function or function block of the standard"
                    );
                    say(message, word);
                }
            }
            for feature in self.list.iter().filter(|feature| rules.lacks(&feature.key)) {
                let lacking = self.lacked.entry(feature.key.clone());
                lacking.or_default().insert(dialect);
            }
        }
        mistakes
    }

    /// Returns whether a name, in capital letters, is that of an elementary type, of a conversion function of a dialect, or of a feature: a
    /// standard function or function block.
    pub fn is_standard(&self, name: &str, dialect: DialectName) -> bool {
        let key = name.to_ascii_lowercase();
        ElementaryType::from_name(name).is_some()
            || self.get(&key).is_some()
            || self.get(&format!("{key}-function")).is_some()
            || !stickler_exact::signatures(name, dialect).is_empty()
    }

    /// Returns a feature of a program that a dialect does not declare to have: neither its edition of IEC 61131-3 has a table of it, nor
    /// does its file name it. `None` in a suite without a list of features.
    pub fn undeclared(&self, program: &str, dialect: DialectName) -> Option<FeatureKey> {
        if self.list.is_empty() {
            return None;
        }
        let rules = Dialect::of(dialect);
        let declares = |key: &str| match self.get(key) {
            Some(feature) => feature.support(dialect) == FeatureSupport::Has,
            None => !rules.lacks(key) && rules.features.has.iter().any(|has| has == key),
        };
        stickler_syntax::features::features(program, rules)
            .into_iter()
            .find(|key| !declares(key))
    }
}

/// Reads the features of a suite and what is wrong with their file, or with what the dialects say of them. A suite without the file
/// has none.
pub(crate) fn read(
    root: &files::Root,
    sources: &Sources,
    dialects: &Dialects,
) -> (Features, Vec<CaseFileError>) {
    root.read_toml(FEATURES, |tables, lines| {
        let (mut features, mut mistakes) = features(tables, sources, lines);
        mistakes.extend(features.ask(&dialects.all()));
        (features, mistakes)
    })
}

fn features(
    tables: BTreeMap<Spanned<String>, FeatureTable>,
    sources: &Sources,
    lines: &Lines,
) -> (Features, Vec<Mistake>) {
    let keys: BTreeSet<String> = tables.keys().map(|key| key.get_ref().clone()).collect();
    let mut mistakes = Vec::new();
    let tables = toml_text::in_order(tables);
    for (key, table) in &tables {
        let at = |word: &Spanned<String>| lines.line(word.span().start);
        for need in table.needs.iter().filter(|need| !keys.contains(need.get_ref())) {
            let message = format!(
                "`{}` needs `{}`, which is no feature",
                key.get_ref(),
                need.get_ref()
            );
            let known = keys.iter().map(String::as_str);
            let hint = suggestion(need.get_ref(), known);
            mistakes.push(Mistake::new(at(need), message).key("needs").hint(hint));
        }
        for basis in table
            .promised
            .iter()
            .filter(|basis| sources.of(basis.get_ref()).is_none())
        {
            let message = format!("`{}` names no source", basis.get_ref());
            mistakes.push(
                Mistake::new(at(basis), message)
                    .key("promised")
                    .hint("see sources.toml"),
            );
        }
    }
    let feature = |(key, table): (Spanned<String>, FeatureTable)| Feature {
        key: key.into_inner(),
        title: table.title,
        tables: [(2, table.ed2), (3, table.ed3), (4, table.ed4)]
            .into_iter()
            .filter_map(|(edition, rows)| Some((edition, rows?)))
            .collect(),
        needs: table.needs.into_iter().map(Spanned::into_inner).collect(),
        promised: table.promised.into_iter().map(Spanned::into_inner).collect(),
        program: table.program,
    };
    let features = Features {
        list: tables.into_iter().map(feature).collect(),
        lacked: FxHashMap::default(),
    };
    (features, mistakes)
}
