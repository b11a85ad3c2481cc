//! Support data: what systems have and what they answer to questions about conversions, each with its source, as one JSON document.
//!
//! [`SupportData::gather`] collects it from cases, documents and recordings, and [`write_data`] writes it with its schema, which
//! describes each key, with its types for TypeScript, and as packages for npm and PyPI.

mod questions;
#[cfg(test)]
mod tests;

use crate::ExportError;
use crate::export::is_occupied;
use crate::source_line::source_line;
use questions::Answers;
pub use questions::{Kind, Questions, answer_word, call_question};
use serde::Serialize;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use stickler_conversions::overview::{StatementsBuilder, rules};
use stickler_conversions::recording::Recording;
use stickler_exact::Signature;
use stickler_suite::{Feature, FeatureSupport, Source, SourceKind, Suite};
use stickler_types::DialectName;

/// The file of the data; a folder that has it is one of support data.
pub const DATA: &str = "stickler-data.json";

/// The word in the files of packages for which the version is written.
const VERSION: &str = "0.0.0";

/// Support data: the features of systems, and their answers to questions about conversions. The published schema describes its keys.
#[derive(Serialize)]
pub struct SupportData<'a> {
    version: &'a str,
    systems: BTreeMap<&'static str, Value>,
    features: BTreeMap<&'a str, Value>,
    conversions: BTreeMap<&'a str, Vec<Value>>,
    functions: Value,
    questions: Questions,
    sources: BTreeMap<String, Value>,
}

impl<'a> SupportData<'a> {
    /// Collects the data of the dialects of a table of statements.
    pub fn gather(suite: &'a Suite, statements: &'a StatementsBuilder, recordings: &[Recording]) -> Self {
        let dialects = statements.dialects();
        let mut data = SupportData {
            version: &suite.version,
            systems: dialects
                .iter()
                .map(|of| (of.as_str(), system(*of, suite)))
                .collect(),
            features: BTreeMap::new(),
            conversions: BTreeMap::new(),
            functions: toml::from_str(include_str!("data/functions.toml")).unwrap_or_default(),
            questions: Questions::gather(&suite.sources, statements, recordings),
            sources: BTreeMap::new(),
        };
        let mut cited: BTreeSet<String> = data.questions.sources().map(str::to_owned).collect();
        for feature in suite.features.iter() {
            let support = support(feature, dialects, suite);
            cited.extend(support.sources().map(str::to_owned));
            let line = json!({
                "title": feature.title, "tables": feature.tables, "needs": feature.needs, "program": feature.program, "support": support,
            });
            data.features.insert(&feature.key, line);
        }
        for function in statements.functions() {
            let having = function
                .dialects
                .iter()
                .filter_map(|index| dialects.get(*index).copied());
            let line = conversion(&function.signature, &having.collect::<Vec<_>>());
            data.conversions
                .entry(&function.signature.function)
                .or_default()
                .push(line);
        }
        let line = |basis: String| (basis.clone(), source_line(&basis, &suite.sources));
        data.sources = cited.into_iter().map(line).collect();
        data
    }

    /// Returns the number of questions.
    pub fn questions(&self) -> usize {
        self.questions.0.len()
    }
}

/// Returns what a system is: its name, version and documents, and the choices of Stickler's model of it.
fn system(dialect: DialectName, suite: &Suite) -> Value {
    let rules = dialect.rules();
    let is_own = |source: &&Source| source.dialects.contains(&dialect.base());
    let mut own: Vec<&Source> = suite.sources.iter().filter(is_own).collect();
    // What a product was seen to do is of one version, and a page often of none.
    own.sort_by_key(|source| !matches!(source.kind, SourceKind::Recording | SourceKind::Measurement));
    let document = |source: &&Source| {
        let mut line = source_line(&format!("{}:", source.key), &suite.sources);
        // Without a section it opens nothing.
        line["address"] = Value::from(source.address.as_str());
        line
    };
    json!({
        "name": rules.title,
        "about": rules.about,
        "variant_of": dialect.is_variant().then(|| dialect.base().as_str()),
        "version": own.first().map(|source| &source.read),
        "edition": rules.features.edition,
        "documents": own.iter().map(document).collect::<Vec<_>>(),
        "choices": rules.all_choices().collect::<BTreeMap<_, _>>(),
    })
}

/// Returns which dialects have a feature.
fn support(feature: &Feature, dialects: &[DialectName], suite: &Suite) -> Answers {
    let mut support = Answers::default();
    for dialect in dialects {
        let answer = feature.support(*dialect);
        let basis = declared_by(feature, *dialect, suite);
        let kind = match answer {
            FeatureSupport::Open => Kind::Open,
            _ => Kind::of(basis.as_deref(), &suite.sources),
        };
        support.add(*dialect, answer.as_str(), (kind, basis.as_deref()));
    }
    support
}

/// Returns the basis by which a dialect has a feature or lacks it: a document of the system, the table of its edition, or else its file.
pub(crate) fn declared_by(feature: &Feature, dialect: DialectName, suite: &Suite) -> Option<String> {
    let own = |kind: SourceKind| {
        let is_own = |basis: &&str| {
            let found = suite.sources.of(basis);
            found.is_some_and(|(source, section)| source.kind == kind && source.speaks_for(section, dialect))
        };
        feature.promises().find(is_own)
    };
    let is_named = dialect.rules().features.has.contains(&feature.key);
    let found = match feature.support(dialect) {
        FeatureSupport::Open => return None,
        FeatureSupport::Lacks => None,
        FeatureSupport::Has if is_named => own(SourceKind::Document),
        FeatureSupport::Has => own(SourceKind::Document).or_else(|| own(SourceKind::Standard)),
    };
    Some(found.map_or_else(|| format!("{}: features", dialect.base()), str::to_owned))
}

/// Returns a conversion function with the types of a signature: the systems that have it, and the rules in which they differ.
fn conversion(signature: &Signature, dialects: &[DialectName]) -> Value {
    let names = |dialects: &[DialectName]| dialects.iter().map(|of| of.as_str()).collect::<Vec<_>>();
    let mut lines = Vec::new();
    for (about, rule, mut systems) in rules(signature, dialects) {
        let all = systems.clone();
        systems.retain(|of| !of.is_variant() || !all.contains(&of.base()));
        lines.push(json!({ "about": about, "rule": rule, "systems": names(&systems) }));
    }
    json!({
        "operands": signature.operands.iter().map(|ty| ty.name()).collect::<Vec<_>>(),
        "result": signature.result.name(),
        "systems": names(dialects),
        "rules": lines,
    })
}

/// Writes data into a folder, which is empty, does not exist yet, or has earlier data, which is replaced.
///
/// # Errors
/// [`ExportError::Occupied`] before anything is written; [`ExportError::Write`].
pub fn write_data(data: &SupportData<'_>, folder: &Path) -> Result<(), ExportError> {
    if is_occupied(folder)? && !folder.join(DATA).is_file() {
        let other = format!(" and holds no earlier data (there is no {DATA} in it)");
        return Err(ExportError::Occupied(folder.to_owned(), other));
    }
    let json =
        serde_json::to_string(data).map_err(|error| ExportError::Write(folder.join(DATA), error.into()))?;
    let types = include_str!("data/types.d.ts");
    let readme = include_str!("data/package/README.md");
    for (name, text) in [
        (DATA, &*json),
        ("stickler-data.schema.json", include_str!("data/schema.json")),
        ("stickler-data.d.ts", types),
        ("npm/package.json", include_str!("data/package/package.json")),
        ("npm/index.json", &json),
        ("npm/index.d.ts", types),
        ("npm/README.md", readme),
        ("pypi/pyproject.toml", include_str!("data/package/pyproject.toml")),
        ("pypi/README.md", readme),
        (
            "pypi/stickler_data/__init__.py",
            include_str!("data/package/init.py"),
        ),
        ("pypi/stickler_data/data.json", &json),
        ("pypi/stickler_data/py.typed", ""),
    ] {
        let path = folder.join(name);
        let versioned = [name.ends_with("package.json"), name.ends_with(".toml")].contains(&true);
        let text = if versioned {
            text.replace(VERSION, data.version)
        } else {
            text.to_owned()
        };
        let created = path.parent().map_or(Ok(()), fs::create_dir_all);
        created
            .and_then(|()| fs::write(&path, text))
            .map_err(|error| ExportError::Write(path, error))?;
    }
    Ok(())
}
