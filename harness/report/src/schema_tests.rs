//! Tests the published schemas of `events.jsonl.gz` and `results.json`, what is written against them, and what is refused.
//!
//! To write the schemas again after a change: `cargo xtask bless`.

use crate::events::{self, LogLine};
use crate::golden_tests::{self, difference};
use crate::results::{self, ResultsDocument};
use crate::sample;
use flate2::read::GzDecoder;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::Value;
use std::collections::BTreeSet;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};
use stickler_conversions::overview::Statements;
use stickler_mdtest::schema as schema_check;
use stickler_run::Event;

/// Returns the schema of what is written of a type.
fn schema_of<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::default().for_serialize();
    settings.into_generator().into_root_schema_for::<T>()
}

/// Returns the path of a published schema.
fn published(report: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("schemas");
    folder.join(format!("{report}.schema.json"))
}

fn read(path: PathBuf) -> Value {
    serde_json::from_slice(&fs::read(path).expect("a file")).expect("JSON")
}

/// Returns a file about a run with each kind of element that the reports have.
fn of_log(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("golden-log")
        .join(file)
}

fn full_run() -> Vec<Event> {
    golden_tests::read(&of_log("run.toml")).0
}

#[test]
fn the_golden_schemas_are_those_of_the_code() {
    for (report, schema) in [
        ("events", schema_of::<LogLine<'static>>()),
        ("results", schema_of::<ResultsDocument<'static>>()),
    ] {
        let text = format!("{:#}\n", schema.as_value());
        assert_eq!(difference(&published(report), &text), None);
    }
}

#[test]
fn what_a_run_writes_fits_the_schemas_and_has_every_key_of_the_document() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    sample::report(folder.path(), &full_run());
    assert_fits(folder.path());
}

/// Asserts that the log and the results in a folder of reports fit their schemas, and that the results have every key of theirs.
pub(crate) fn assert_fits(reports: &Path) {
    let schemas = ["events", "results"].map(|report| read(published(report)));
    let mut log = String::new();
    let packed = fs::File::open(reports.join(events::NAME)).expect("a log");
    GzDecoder::new(packed).read_to_string(&mut log).expect("text");
    for line in log.lines() {
        let line: Value = serde_json::from_str(line).expect("JSON");
        assert_eq!(schema_check::misfit(&schemas[0], &line), None, "{line}");
    }
    let document = read(reports.join(results::NAME));
    assert_eq!(schema_check::misfit(&schemas[1], &document), None);
    let keys = |object: &Value| {
        object
            .as_object()
            .map(|object| BTreeSet::from_iter(object.keys().cloned()))
    };
    assert_eq!(keys(&document), keys(&schemas[1]["properties"]));
}

/// The edits of `golden-log/edits.toml`, by what is wrong then.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Edits {
    misfit: Vec<Edit>,
    contradiction: Vec<Edit>,
    sound: Vec<Edit>,
}

/// An edit of a line, and what a site says of the log then.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Edit {
    line: usize,
    at: String,
    value: Option<Value>,
    #[serde(default)]
    says: Vec<String>,
}

impl Edit {
    fn apply(&self, line: &mut Value) {
        let (parent, key) = self.at.rsplit_once('/').expect("a place");
        match (line.pointer_mut(parent).expect("a parent"), &self.value) {
            (Value::Object(keys), Some(value)) => drop(keys.insert(key.to_owned(), value.clone())),
            (Value::Object(keys), None) => drop(keys.remove(key)),
            (Value::Array(list), Some(value)) => match key.parse::<usize>() {
                Ok(place) => list[place] = value.clone(),
                Err(_) => list.push(value.clone()),
            },
            (other, _) => panic!("{}: {other} has no parts", self.at),
        }
    }

    /// Returns what a site says of the edited log, and the schema of the edited line.
    fn judged(&self) -> (String, Option<String>) {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let log = String::from_utf8(events::log_of(&full_run())).expect("text");
        let lines = log.lines().map(serde_json::from_str);
        let mut lines: Vec<Value> = lines.collect::<Result<_, _>>().expect("JSON");
        self.apply(&mut lines[self.line - 1]);
        let text: String = lines.iter().map(|line| format!("{line}\n")).collect();
        let path = folder.path().join("handed-in.jsonl");
        fs::write(&path, text).expect("written");
        let site = folder.path().join("site");
        let refused = match crate::site::write(&[path], false, &site, &Statements::default()) {
            Ok(_) => String::new(),
            Err(error) => crate::parts::describe_error(&error),
        };
        for part in &self.says {
            assert!(refused.contains(part), "{}: {part}\n{refused}", self.at);
        }
        let misfit = schema_check::misfit(&read(published("events")), &lines[self.line - 1]);
        (refused, misfit)
    }
}

#[test]
fn a_log_is_refused_where_it_does_not_fit_the_schema_or_contradicts_itself() {
    let text = fs::read_to_string(of_log("edits.toml")).expect("the edits");
    let edits: Edits = toml::from_str(&text).expect("edits");
    for edit in edits.misfit {
        let (refused, misfit) = edit.judged();
        let line = format!("line {} of", edit.line);
        assert!(refused.contains(&line), "{}: {refused}", edit.at);
        assert!(misfit.is_some(), "{}: the schema does not refuse it", edit.at);
    }
    for edit in edits.contradiction {
        edit.judged();
    }
    for edit in edits.sound {
        assert_eq!(edit.judged(), (String::new(), None), "{}", edit.at);
    }
}
