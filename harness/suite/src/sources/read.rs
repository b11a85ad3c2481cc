//! Reads `sources.toml` and `rules.md`.

use std::collections::BTreeMap;

use serde::Deserialize;
use stickler_types::{Contradiction, PrintedResult, Question, Relation, Value, Versions, sorted};
use toml::Spanned;

use super::examples::OmittedEntry;
use super::sections::{SectionForm, first_paragraphs, headings};
use super::{Lines, RECORDING, RULE, Sections, Source, SourceKind, Sources, ToldSymptom, recordings};
use crate::error::{CaseFileError, Mistake, in_file, suggestion};
use crate::toml_text::{self, Strings};
use crate::{Dialects, files};

/// The file of the sources, below the root of a suite.
const SOURCES: &str = "sources.toml";
/// The file of Stickler's own rules, below the root of a suite.
const RULES: &str = "rules.md";

/// The maximum number of characters of a quote: no sentence of a page is copied.
const MAX_QUOTE_LEN: usize = 80;

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SourceEntry {
    title: String,
    publisher: Option<String>,
    relation: Option<Relation>,
    kind: Spanned<String>,
    address: Option<Spanned<String>>,
    read: Option<String>,
    since: Option<Spanned<String>>,
    until: Option<Spanned<String>>,
    engines: Option<Vec<String>>,
    dialects: Option<Vec<Spanned<String>>>,
    sections: Option<Strings>,
    #[serde(default)]
    limitations: BTreeMap<Spanned<String>, String>,
    #[serde(default)]
    examples: BTreeMap<Spanned<String>, u32>,
    #[serde(default)]
    omitted: Vec<OmittedEntry>,
    #[serde(default)]
    quotes: BTreeMap<Spanned<String>, Vec<String>>,
    #[serde(default)]
    contradicts: Vec<Spanned<Contradiction>>,
    #[serde(default)]
    printed: PrintedSections,
    #[serde(default)]
    symptoms: Vec<ToldSymptom>,
}

/// The calls that sections print, each with its result.
type PrintedSections = BTreeMap<Spanned<String>, BTreeMap<Spanned<String>, String>>;

/// The sources of a suite, and what is wrong with their files.
#[derive(Debug)]
pub(crate) struct SourcesRead {
    pub(crate) sources: Sources,
    pub(crate) errors: Vec<CaseFileError>,
    /// The warnings of lint.
    pub(crate) remarks: Vec<CaseFileError>,
}

/// Reads the usable part of the sources of the suite at `root`. A suite without `rules.md` has no rules.
pub(crate) fn read(root: &files::Root, dialects: &Dialects) -> SourcesRead {
    let shown = root.shown(SOURCES);
    let text = files::read(&root.path().join(SOURCES)).map_err(|mistake| {
        mistake.hint(
            "it lists the documents that the cases cite; see \"Sources\" in conformance-cases/README.md",
        )
    });
    let lines = Lines::new(text.as_deref().unwrap_or_default());
    let entries =
        text.and_then(|text| toml_text::read::<BTreeMap<Spanned<String>, SourceEntry>>(&text, 0, &lines));
    let mut reader = SourcesReader {
        root,
        dialects,
        lines,
        mistakes: Vec::new(),
        remarks: Vec::new(),
        dated: Vec::new(),
    };
    let mut sources = Vec::new();
    match entries {
        Ok(entries) => sources.extend(
            entries
                .into_iter()
                .filter_map(|(key, entry)| reader.source(&key, entry)),
        ),
        Err(mistake) => reader.mistakes.push(mistake),
    }
    reader.check_ends(&sources);
    let mut errors = in_file(reader.mistakes, &shown);
    let remarks = in_file(reader.remarks, &shown);
    let (rules, mistakes) = rules(root);
    sources.extend([recordings::read(root), rules]);
    errors.extend(mistakes);
    SourcesRead {
        sources: Sources {
            sources,
            file: shown,
            rules: root.shown(RULES),
        },
        errors,
        remarks,
    }
}

/// Returns Stickler's own rules as a source, whose sections are the rules.
fn rules(root: &files::Root) -> (Source, Vec<CaseFileError>) {
    let ((headings, paragraphs), errors) = root.read_own(RULES, |text| {
        let headings = headings(text);
        let mistakes = unfit_rules(&headings);
        ((headings, first_paragraphs(text)), mistakes)
    });
    let source = Source {
        key: RULE.to_owned(),
        title: "Rules".to_owned(),
        publisher: "Stickler".to_owned(),
        relation: Relation::Maker,
        kind: SourceKind::Rule,
        address: format!("{}#{{section}}", root.shown(RULES)),
        sections: Sections {
            headings,
            forms: Vec::new(),
        },
        paragraphs,
        line: 1,
        ..Source::default()
    };
    (source, errors)
}

/// Returns what is wrong with the names of rules: one that stands twice, and one that is no name.
fn unfit_rules(headings: &[(String, u32)]) -> Vec<Mistake> {
    let is_name = |name: &str| {
        let is_fit = |letter: char| letter.is_ascii_lowercase() || letter.is_ascii_digit() || letter == '-';
        name.chars().all(is_fit)
    };
    let mut mistakes = Vec::new();
    for (at, (name, line)) in headings.iter().enumerate() {
        if let Some((_, first)) = headings[..at].iter().find(|(known, _)| known == name) {
            let message =
                format!("the rule `{name}` stands in line {first} too; give one of them another name");
            mistakes.push(Mistake::new(*line, message));
        }
        if !is_name(name) {
            let message =
                format!("`{name}` is no name of a rule: write small letters, digits and hyphens, `one-rule`");
            mistakes.push(Mistake::new(*line, message));
        }
    }
    mistakes
}

/// Returns what a key of a source says.
fn meaning(key: &str) -> &'static str {
    match key {
        "title" => "what the source is called",
        "publisher" => "who answers for it",
        _ => "the edition, version, commit or date at which it was read",
    }
}

pub(super) struct SourcesReader<'a> {
    root: &'a files::Root,
    dialects: &'a Dialects,
    pub(super) lines: Lines,
    mistakes: Vec<Mistake>,
    remarks: Vec<Mistake>,
    /// The contradictions that end claims with a version.
    dated: Vec<Spanned<Contradiction>>,
}

impl SourcesReader<'_> {
    /// Returns the source of an entry; `None` where a mistake leaves nothing to cite.
    fn source(&mut self, key: &Spanned<String>, entry: SourceEntry) -> Option<Source> {
        let name = key.get_ref().as_str();
        let at = key.span().start;
        if [RULE, RECORDING].contains(&name) || name.contains([':', ' ']) {
            let message =
                "a source's key has neither a colon nor a space, and is neither `rule` nor `recording`";
            self.wrong(at, name, message.to_owned());
            return None;
        }
        let texts = [
            ("title", Some(entry.title)),
            ("publisher", entry.publisher),
            ("read", entry.read),
        ];
        let [title, publisher, read] = texts.map(|(key, text)| {
            let is = if text.is_some() { "is empty" } else { "is missing" };
            let text = text.unwrap_or_default();
            if text.trim().is_empty() {
                self.wrong(at, name, format!("`{key}` {is}; write {}", meaning(key)));
            }
            text
        });
        if entry.relation.is_none() {
            let message = "`relation` is missing; write how the publisher stands to what the source speaks of: \
                           `maker`, `integrator`, `restatement` or `third-party`";
            // Cases can rest on it all the same: as on the word of a maker.
            self.remarks
                .push(Mistake::new(self.lines.line(at), message).key(name));
        }
        let kind = self.kind(name, &entry.kind)?;
        let (address, file) = self.address(name, at, kind, entry.address.as_ref())?;
        if !kind.speaks_for_all() && (entry.engines.is_none() || entry.dialects.is_none()) {
            let message = format!(
                "a {} needs `engines` and `dialects`: those for which it speaks",
                kind.as_str()
            );
            self.wrong(at, name, message);
        }
        let mut dialects = Vec::new();
        for name in entry.dialects.iter().flatten() {
            match self.dialects.resolve(name.get_ref()) {
                Ok(resolved) => dialects.extend(resolved),
                Err(message) => self.wrong(name.span().start, key.get_ref(), message),
            }
        }
        let dialects = sorted(dialects);
        let sections = self.sections(name, at, file.as_deref(), entry.sections);
        let mut limitations = BTreeMap::new();
        for (section, text) in entry.limitations {
            self.check_section(
                name,
                &sections,
                section.span().start,
                ("limitations of", section.get_ref()),
            );
            limitations.insert(section.into_inner(), text);
        }
        let examples = self.examples(name, &sections, entry.examples, entry.omitted);
        let mut quotes = BTreeMap::new();
        for (section, texts) in entry.quotes {
            let is_figure = |text: &String| !text.trim().is_empty() && text.chars().count() <= MAX_QUOTE_LEN;
            let at = section.span().start;
            let is_known = self.check_section(name, &sections, at, ("quotes of", section.get_ref()));
            if is_known && !texts.iter().all(is_figure) {
                let message =
                    format!("a quote is a figure of 1 to {MAX_QUOTE_LEN} characters, and no copied sentence");
                self.wrong(at, name, message);
            }
            quotes.insert(section.into_inner(), texts);
        }
        for contradiction in &entry.contradicts {
            let (at, section) = (contradiction.span().start, &contradiction.get_ref().section);
            self.check_section(name, &sections, at, ("a contradiction of", section));
            if contradiction.get_ref().until.is_some() {
                self.dated.push(contradiction.clone());
            }
        }
        let ends = [&entry.since, &entry.until];
        let written = ends.into_iter().flatten().map(|end| end.span().start).next_back();
        let [since, until] = [entry.since, entry.until].map(|end| end.map(Spanned::into_inner));
        let versions = Versions { since, until };
        if let Some((written, message)) = written.zip(versions.mistake()) {
            self.wrong(written, name, message);
        }
        let contradicts = entry.contradicts.into_iter().map(Spanned::into_inner);
        let mut source = Source {
            key: name.to_owned(),
            title,
            publisher,
            relation: entry.relation.unwrap_or_default(),
            kind,
            address,
            read,
            engines: entry.engines.unwrap_or_default(),
            versions,
            dialects,
            sections,
            limitations,
            examples,
            quotes,
            contradicts: contradicts.collect(),
            symptoms: entry.symptoms,
            line: self.lines.line(at),
            ..Source::default()
        };
        source.printed = self.printed(&source, entry.printed);
        Some(source)
    }

    /// Returns whether a source has a section, and says otherwise of what it has none.
    fn check_section(
        &mut self,
        key: &str,
        sections: &Sections,
        at: usize,
        (what, name): (&str, &str),
    ) -> bool {
        let unknown = sections.unknown(name);
        if let Some(expected) = &unknown {
            self.wrong(at, key, format!("{what} no section `{name}`; {expected}"));
        }
        unknown.is_none()
    }

    /// Returns what the sections print: the result of each call, a typed literal or words without a `#`.
    fn printed(&mut self, source: &Source, all: PrintedSections) -> Vec<PrintedResult> {
        let mut printed = Vec::new();
        for (section, calls) in all {
            let (at, section) = (section.span().start, section.get_ref());
            self.check_section(&source.key, &source.sections, at, ("calls printed by", section));
            for (call, result) in calls {
                let (at, call) = (call.span().start, call.into_inner());
                let is_call = format!("{call} : INT").parse::<Question>().is_ok();
                if !is_call || (result.contains('#') && Value::parse(&result).is_err()) {
                    let message = format!(
                        "`{call}` is not printed with typed literals: `REAL_TO_INT(REAL#2.5)` = `INT#2`, or a result in words without a `#`"
                    );
                    self.wrong(at, &source.key, message);
                }
                let basis = format!("{}: {section} ({})", source.key, source.address_of(section));
                let source = source.key.clone();
                printed.push(PrintedResult {
                    source,
                    basis,
                    call,
                    result,
                });
            }
        }
        printed
    }

    fn kind(&mut self, key: &str, kind: &Spanned<String>) -> Option<SourceKind> {
        let kinds = SourceKind::ALL
            .into_iter()
            .filter(|kind| *kind != SourceKind::Rule);
        let found = kinds.clone().find(|known| known.as_str() == kind.get_ref());
        if found.is_none() {
            let message = match kind.get_ref().as_str() == SourceKind::Rule.as_str() {
                true => format!("rules are not listed here: each is a heading of {RULES}"),
                false => {
                    let known = kinds.map(SourceKind::as_str);
                    format!(
                        "no kind `{}`; {}",
                        kind.get_ref(),
                        suggestion(kind.get_ref(), known)
                    )
                }
            };
            self.wrong(kind.span().start, key, message);
        }
        found
    }

    /// Returns the address, and the text of the file that it names, if it is a path below the root.
    fn address(
        &mut self,
        key: &str,
        at: usize,
        kind: SourceKind,
        address: Option<&Spanned<String>>,
    ) -> Option<(String, Option<String>)> {
        let Some(address) = address else {
            let message = format!("a {} needs an `address` that opens", kind.as_str());
            self.wrong(at, key, message);
            return None;
        };
        let start = address.span().start;
        let address = address.get_ref();
        let rest = address.replace("{section}", "").replace("{anchor}", "");
        if rest.contains(['{', '}', ' ']) {
            let message = "an address has no spaces, and in braces only `{section}` and `{anchor}`";
            self.wrong(start, key, message.to_owned());
        }
        if address.starts_with("https://") || address.starts_with("http://") {
            return Some((address.clone(), None));
        }
        let path = address.split('#').next().unwrap_or_default();
        // The cases can be run without the text, so this is no error.
        let text = files::read(&self.root.path().join(path)).unwrap_or_else(|mistake| {
            let message = format!(
                "`{path}` is neither an address of the web nor a file beside {SOURCES}: {}",
                mistake.message
            );
            let line = self.lines.line(start);
            self.remarks.push(Mistake::new(line, message).key(key));
            String::new()
        });
        Some((self.root.shown(address), Some(text)))
    }

    /// Returns the names of the sections: those listed, or the headings of the file.
    fn sections(&mut self, key: &str, at: usize, file: Option<&str>, listed: Option<Strings>) -> Sections {
        let mut sections = Sections::default();
        let listed = listed.map(|listed| listed.0);
        if listed.as_ref().is_none_or(Vec::is_empty) {
            match file {
                Some(text) => sections.headings = headings(text),
                None => self.wrong(at, key, "the source has no `sections`".to_owned()),
            }
        }
        for section in listed.into_iter().flatten() {
            let line = self.lines.line(section.span().start);
            let section = section.into_inner();
            match SectionForm::from_word(&section) {
                Some(form) => sections.forms.push(form),
                None => sections.headings.push((section, line)),
            }
        }
        sections
    }

    /// Checks that no contradiction ends a claim before it begins.
    fn check_ends(&mut self, sources: &[Source]) {
        for contradiction in std::mem::take(&mut self.dated) {
            let (at, contradiction) = (contradiction.span().start, contradiction.into_inner());
            for claim in &contradiction.claims {
                let cited = sources
                    .iter()
                    .find(|source| claim.split(':').next() == Some(&source.key));
                let versions = cited.map_or_else(Versions::default, |source| source.versions.clone());
                let ended = Versions {
                    until: contradiction.until.clone(),
                    ..versions
                };
                if let Some(message) = ended.mistake() {
                    self.wrong(at, claim, message);
                }
            }
        }
    }

    pub(super) fn wrong(&mut self, at: usize, key: &str, message: String) {
        self.mistakes
            .push(Mistake::new(self.lines.line(at), message).key(key));
    }
}
