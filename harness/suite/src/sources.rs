//! The sources that an expectation may come from, and their sections.
//!
//! A basis is written `source: section`: a key of `sources.toml`, or `rule` for one of Stickler's own rules in `rules.md`, and a
//! section by the name that it has there, so that a claim can be traced from a report to the sentence. The recordings of compilers are
//! a source, too: `recording`, whose sections are their files.

mod examples;
mod lint;
mod read;
mod recordings;
mod saved;
mod sections;

use crate::error::suggestion;
use std::borrow::Cow;
use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use stickler_types::{Contradiction, DialectName, PrintedResult, RecordingOrigin, Relation, Versions, words};

use crate::place::Lines;
use examples::SectionExamples;
pub(crate) use read::read;
pub use saved::{CheckedQuote, QuoteResult};
use sections::{SectionForm, Sections};

/// The key of the source whose sections are Stickler's own rules.
const RULE: &str = "rule";
/// The key of the source whose sections are the files of recordings.
const RECORDING: &str = "recording";

/// The sources that the cases of a folder may cite.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Sources {
    /// Ordered by key; the recordings and the rules stand last.
    sources: Vec<Source>,
    /// The paths of `sources.toml` and `rules.md`, as messages show them.
    file: String,
    rules: String,
}

/// A source that cases may cite, or Stickler's own rules.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[cfg_attr(feature = "schema", schemars(rename = "SourceHeader"))]
pub struct Source {
    /// The name with which a basis begins.
    pub key: String,
    /// The title.
    pub title: String,
    /// The person or organization that answers for the text.
    pub publisher: String,
    /// The relation of the publisher to what the source speaks of; left out of a maker.
    #[serde(default, skip_serializing_if = "Relation::is_maker")]
    pub relation: Relation,
    /// The kind, as `sources.toml` spells it: `document`, `standard`, `recording`, `measurement` or `rule`.
    #[cfg_attr(feature = "schema", schemars(with = "String"))]
    pub kind: SourceKind,
    /// The address, in which `{section}` and `{anchor}` stand for a section; [`Source::address_of`] fills them in.
    pub address: String,
    /// The edition, version, commit or date at which it was read; empty for rules.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub read: String,
    /// The built-in engines for which it speaks; none of a standard and of the rules.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub engines: Vec<String>,
    /// By section, the constructs that the section says are not there yet.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub limitations: BTreeMap<String, String>,
    /// The claims of other sources that it contradicts.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub contradicts: Vec<Contradiction>,
    /// The first paragraph of each rule; empty of every other source.
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub paragraphs: BTreeMap<String, String>,
    /// The versions of these engines for which the claims of the source hold, as far as no [contradiction](Contradiction::until) ends them.
    /// No run writes down this and what follows.
    #[serde(skip)]
    pub versions: Versions,
    /// The dialects for which the source speaks; of a standard, those that are the standard itself. The rules name none.
    #[serde(skip)]
    pub dialects: Vec<DialectName>,
    #[serde(skip)]
    pub(crate) sections: Sections,
    /// The origin that each recording states, or the reason why no case can cite it; empty for every other source.
    #[serde(skip)]
    pub(crate) recorded: BTreeMap<String, Result<RecordedOrigin, String>>,
    /// By section, the programs and fragments that the section prints.
    #[serde(skip)]
    pub(crate) examples: BTreeMap<String, SectionExamples>,
    /// By section, short figures that the page has, letter by letter.
    #[serde(skip)]
    pub quotes: BTreeMap<String, Vec<String>>,
    /// The results of calls that the source prints, and of which no dialect has a case.
    #[serde(skip)]
    pub printed: Vec<PrintedResult>,
    /// The symptoms that the source says must not be, whatever program shows them.
    #[serde(skip)]
    pub symptoms: Vec<ToldSymptom>,
    /// The line of `sources.toml` on which the source begins; 1 for the rules.
    #[serde(skip)]
    pub(crate) line: u32,
}

/// The origin of a recording, and the dialects in which its product was asked.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct RecordedOrigin {
    origin: RecordingOrigin,
    dialects: Vec<DialectName>,
}

/// A symptom of which a source of a compiler's makers says that it must not be.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ToldSymptom {
    /// The compiler, or what runs its programs, dies and says a word that is the name of a section.
    Crash,
    /// A diagnostic has no place.
    NoPlace,
    /// A fault at run time has no line.
    FaultLine,
}

words! {
    /// The kind of a source, with its name in `sources.toml` and in reports.
    #[derive(Default, Serialize, Deserialize)]
    #[serde(rename_all = "lowercase")]
    SourceKind {
        /// A text that the publisher of a compiler or of a programming system gives out about it.
        #[default]
        Document = "document",
        /// A standard, which speaks for all compilers.
        Standard = "standard",
        /// The values or messages that a product of a named version was recorded to give.
        Recording = "recording",
        /// The answers of an open compiler of a named version, which anybody can build and ask again.
        Measurement = "measurement",
        /// A decision of Stickler itself, where no public text says anything.
        Rule = "rule",
    }
}

impl SourceKind {
    /// Returns whether a source of this kind speaks for every dialect.
    const fn speaks_for_all(self) -> bool {
        matches!(self, SourceKind::Standard | SourceKind::Rule)
    }
}

impl Sources {
    /// Returns every source, ordered by key, with the recordings and the rules last.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter()
    }

    /// Returns the source with this key.
    pub fn get(&self, key: &str) -> Option<&Source> {
        self.sources.iter().find(|source| source.key == key)
    }

    /// Returns the section about a diagnostic code in a source of an engine's makers; `None` where they have none of codes.
    pub fn of_code(&self, code: &str, engine: &str) -> Option<String> {
        let mut sources = self.sources.iter();
        let found = sources.find(|source| {
            let is_own = source.engines.iter().any(|own| own == engine);
            is_own
                && source.sections.forms.contains(&SectionForm::Codes)
                && source.sections.unknown(code).is_none()
        });
        found.map(|source| format!("{}: {code}", source.key))
    }

    /// Returns the basis on which an engine must not show a symptom: for a crash the section whose name stands in what it said, for a place
    /// that is missing the first section. `None` where no source of its makers tells that.
    pub fn telling(&self, symptom: ToldSymptom, engine: &str, said: &str) -> Option<String> {
        let own = |source: &&Source| {
            source.symptoms.contains(&symptom) && source.engines.iter().any(|own| own == engine)
        };
        self.sources.iter().filter(own).find_map(|source| {
            let mut names = source.sections.headings.iter().map(|(name, _)| name);
            let section = match symptom {
                ToldSymptom::Crash => names.find(|name| said.contains(name.as_str()))?,
                ToldSymptom::NoPlace | ToldSymptom::FaultLine => names.next()?,
            };
            Some(format!("{}: {section}", source.key))
        })
    }

    /// Returns the source that a basis such as `ironplc-bit-access: Syntax` begins with, and the rest of the basis. Does not ask
    /// whether the source has the section.
    pub fn of<'s, 'b>(&'s self, basis: &'b str) -> Option<(&'s Source, &'b str)> {
        let (key, section) = basis.split_once(':')?;
        Some((self.get(key)?, section.trim()))
    }

    /// Returns whether documents that speak for some dialects are about this one, so that they bind who follows it: they speak for
    /// it or for the system of which it is a variant. About a dialect of `stickler.toml` only its definition is, since it inherits what the
    /// extended one does and not whom that is bound to; about the dialect of a standard only the standard is.
    pub fn are_about(&self, dialects: &[DialectName], dialect: DialectName) -> bool {
        let system = if dialect.is_custom() {
            dialect
        } else {
            dialect.base()
        };
        let is_standard =
            |source: &Source| source.kind == SourceKind::Standard && source.dialects.contains(&system);
        (dialects.contains(&dialect) || dialects.contains(&system)) && !self.iter().any(is_standard)
    }

    /// Returns the source and the section that a basis such as `ironplc-bit-access: Syntax` names.
    ///
    /// # Errors
    /// A message that says which part is unknown, and what there is.
    pub fn check<'s, 'b>(&'s self, basis: &'b str) -> Result<(&'s Source, &'b str), String> {
        let Some((key, section)) = basis.split_once(':') else {
            return Err(format!("`{basis}` is not written `source: section`"));
        };
        let Some(source) = self.get(key) else {
            if self.sources.iter().all(Source::is_built_in) {
                return Err(format!(
                    "no source `{key}`; {} has none that can be read",
                    self.file
                ));
            }
            let known = self.sources.iter().map(|source| source.key.as_str());
            return Err(format!("no source `{key}`; {}", suggestion(key, known)));
        };
        let section = section.trim();
        if let Some(Err(message)) = source.recorded.get(section) {
            return Err(format!("no case can cite the recording `{section}`: {message}"));
        }
        match source.sections.unknown(section) {
            None => Ok((source, section)),
            Some(expected) if source.key == RECORDING => Err(format!("no recording `{section}`; {expected}")),
            Some(expected) if source.kind == SourceKind::Rule => {
                Err(format!("no rule `{section}`; {expected}"))
            }
            Some(expected) => Err(format!("`{key}` has no section `{section}`; {expected}")),
        }
    }
}

impl Source {
    /// Returns whether a section of the source speaks for a dialect, or for the dialect that it extends, so that a case of the dialect may
    /// cite it: a recording only for those in which its product was asked.
    pub fn speaks_for(&self, section: &str, dialect: DialectName) -> bool {
        let dialects = self.dialects_of(section);
        let names = |dialect| dialects.contains(&dialect);
        self.kind.speaks_for_all() || names(dialect) || names(dialect.base())
    }

    /// Returns the dialects for which a section speaks: of a recording, those in which its product was asked, and of every other source its
    /// [`dialects`](Source::dialects).
    pub fn dialects_of(&self, section: &str) -> &[DialectName] {
        match self.recorded.get(section) {
            Some(Ok(recorded)) => &recorded.dialects,
            Some(Err(_)) => &[],
            None => &self.dialects,
        }
    }

    /// Returns whether a section of the source speaks for a built-in engine: a recording for the compiler that was recorded.
    pub fn speaks_of(&self, section: &str, engine: &str) -> bool {
        match self.recorded.get(section) {
            Some(Ok(recorded)) => recorded.origin.is_of(section, engine),
            _ => self.engines.iter().any(|name| name == engine),
        }
    }

    /// Returns the edition, version, commit or date at which a section was read: of a recording, the product, its version and the date.
    pub fn read_of(&self, section: &str) -> Cow<'_, str> {
        match self.recorded.get(section) {
            Some(Ok(RecordedOrigin { origin, .. })) => {
                format!("{} {}, {}", origin.product, origin.version, origin.date).into()
            }
            _ => self.read.as_str().into(),
        }
    }

    /// Returns whether the source stands in no `sources.toml`: the recordings and the rules.
    pub fn is_built_in(&self) -> bool {
        matches!(self.key.as_str(), RECORDING | RULE)
    }

    /// Returns the address at which a section stands: an address of the web, or a path below the parent of the folder of cases. In
    /// the address of the source `{section}` stands for its name, `{anchor}` for its words in lower case with hyphens between them.
    pub fn address_of(&self, section: &str) -> String {
        let address = self.address.replace("{section}", section);
        address.replace("{anchor}", &sections::anchor(section))
    }

    /// Returns the first section that the file of sources names; `None` where it names none.
    pub fn first_section(&self) -> Option<&str> {
        self.sections.headings.first().map(|(name, _)| name.as_str())
    }
}
