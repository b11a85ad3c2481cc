//! Compares what is written about small runs with golden texts: each folder of `golden` is a test.
//!
//! The file `run.toml` of a folder describes the run; a comment on the first line says what the reports must show of it. The other files are the golden
//! texts of some of its reports, by the names that they have in a folder of reports, and besides:
//!
//! | file | what it holds |
//! |---|---|
//! | `terminal.txt` | the summary on the terminal; `terminal-result.txt`, `terminal-whole.txt`: in less and in more detail; `terminal-failures.txt`: with each failure |
//! | `rerun.txt` | what the terminal shows of cases that run again when their file changes |
//! | `annotations.txt` | the annotations of a CI job |
//! | `files.txt` | the names of all files in the folder of reports |
//!
//! Reports in JSON are broken into lines. A new golden text begins as an empty file; `cargo xtask bless` fills it and renews the others.

use crate::sample;
use crate::terminal::{self, Detail, Surroundings};
use crate::{Overview, annotations, sarif, schema_tests};
use serde::Deserialize;
use serde::de::DeserializeOwned;
use serde_json::{Map, Value};
use std::fs;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use stickler_conversions::overview::{CaseStatement, Statements, StatementsBuilder};
use stickler_conversions::recording::Recording;
use stickler_run::{CaseEvent, EngineTotals, Event, Totals};
use stickler_types::{DialectName, MatrixWord};

/// The content of a `run.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct RunFile {
    /// What the header of the run has otherwise than that of [`sample::run_of`].
    #[serde(default)]
    header: Value,
    /// The properties in which the cases differ from those of [`sample::case`], besides their `id` and `verdict`. Line 0 stands for none; cases with
    /// observations are open; with `times` there are so many, whose ids end in their numbers.
    #[serde(default)]
    case: Vec<Map<String, Value>>,
    /// What the causes have otherwise than those of [`sample::cause`], besides their `number` of cases and `verdict`.
    #[serde(default)]
    cause: Vec<Value>,
    /// Whether the run was cut short after its cases.
    #[serde(default)]
    cut: bool,
    /// Of a run of a site: whether its folder has a page.
    #[serde(default)]
    page: bool,
}

/// Returns the cases of a table.
fn cases(mut table: Map<String, Value>) -> Vec<CaseEvent> {
    let [id, verdict, times] = ["id", "verdict", "times"].map(|key| table.remove(key));
    let id = id.as_ref().and_then(Value::as_str).expect("an id");
    let base = sample::case(
        id,
        serde_json::from_value(verdict.expect("a verdict")).expect("a verdict"),
    );
    let case: CaseEvent = changed(&base, Value::Object(table));
    let case = CaseEvent {
        open: !case.observations.is_empty(),
        line: case.line.filter(|line| *line > 0),
        expectation: base.expectation,
        ..case
    };
    let numbered = |number| CaseEvent {
        id: format!("{}{number}", case.id),
        ..case.clone()
    };
    match times.and_then(|times| times.as_u64()) {
        Some(times) => (1..=times).map(numbered).collect(),
        None => vec![case],
    }
}

/// Returns a value with the keys of a table in place of its own. Where it holds one table in a list, each table of another list has the keys
/// of that one.
fn merged(base: Value, table: Value) -> Value {
    match (base, table) {
        (base, Value::Null) => base,
        (Value::Object(mut base), Value::Object(table)) => {
            for (key, value) in table {
                let old = base.remove(&key).unwrap_or_default();
                base.insert(key, merged(old, value));
            }
            Value::Object(base)
        }
        (Value::Array(base), Value::Array(tables)) if base.len() == 1 => {
            let of = |table| merged(base[0].clone(), table);
            tables.into_iter().map(of).collect()
        }
        (_, value) => value,
    }
}

/// Returns a part of an event with some keys of a table in place of its own.
fn changed<T: serde::Serialize + DeserializeOwned>(part: &T, table: Value) -> T {
    let json = |part: &T| serde_json::to_value(part).expect("JSON");
    let changed = serde_json::from_value(merged(json(part), table.clone())).expect("keys that there are");
    for key in table.as_object().into_iter().flat_map(Map::keys) {
        assert!(json(&changed).get(key).is_some(), "there is no key `{key}`");
    }
    changed
}

/// Returns the totals of the cases of an engine.
fn totals(name: String, events: &[Event]) -> EngineTotals {
    let mut totals = Totals::default();
    for event in events {
        if let Event::Case(case) = event
            && case.engine == name
        {
            totals.count(case.verdict);
        }
    }
    EngineTotals { name, totals }
}

/// Reads the events of a run, and whether its folder has a page.
pub(crate) fn read(path: &Path) -> (Vec<Event>, bool) {
    let text = fs::read_to_string(path).expect("a run");
    let run: RunFile = toml::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let mut events = sample::run_of(run.case.into_iter().flat_map(cases).collect());
    let header = sample::header(&mut events);
    *header = changed(header, run.header);
    let names: Vec<String> = header.engines.iter().map(|engine| engine.name.clone()).collect();
    let of_engines = names.into_iter().map(|name| totals(name, &events)).collect();
    if let Some(Event::Footer(footer)) = events.last_mut() {
        footer.engines = of_engines;
    }
    let causes = run.cause.into_iter().map(|mut table| {
        let keys = table.as_object_mut().expect("a table");
        let [title, number, verdict] = ["title", "number", "verdict"].map(|key| keys.remove(key));
        let title = title.expect("a title");
        let number = number.and_then(|number| number.as_u64());
        let verdict = serde_json::from_value(verdict.expect("a verdict")).expect("a verdict");
        let cause = sample::cause(
            title.as_str().expect("a title"),
            number.expect("a number"),
            verdict,
        );
        changed(&cause, table)
    });
    let mut events = sample::with_causes(events, causes);
    events.truncate(events.len() - usize::from(run.cut));
    (events, run.page)
}

/// The statements of documents about the conversions of a run, in a `statements.toml`.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementsFile {
    dialects: Vec<String>,
    statement: Vec<StatementTable>,
}

/// The statement of a document about the question of a case.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct StatementTable {
    question: String,
    case: String,
    dialect: String,
    word: String,
    result: Option<String>,
    basis: String,
}

/// Reads what documents state about the conversions of a run, and what compilers answered that a folder `recordings` beside it has.
pub(crate) fn statements(folder: &Path) -> Statements {
    let text = |file: &Path| fs::read_to_string(folder.join(file)).expect("a file");
    let read: StatementsFile = toml::from_str(&text(Path::new("statements.toml"))).expect("statements");
    let dialect = |name: &String| name.parse::<DialectName>().expect("a dialect");
    let mut builder = StatementsBuilder::new(read.dialects.iter().map(dialect).collect());
    for table in read.statement {
        let literal = |text: String| stickler_types::Value::parse(&text).expect("a literal");
        let result = table.result.map(literal);
        let statement = CaseStatement {
            case: &Arc::from(table.case),
            dialect: dialect(&table.dialect),
            word: MatrixWord::from_word(&table.word).expect("a word"),
            result: result.as_ref(),
            basis: &Arc::from(table.basis),
        };
        builder.add(&table.question.parse().expect("a question"), &statement);
    }
    let recordings = files(&folder.join("recordings")).into_iter().map(|file| {
        let name = file.display().to_string();
        Recording::parse(&name, &text(&Path::new("recordings").join(file))).expect("a recording")
    });
    builder.finish(&recordings.collect::<Vec<_>>())
}

/// Returns what is shown of a run on the terminal, without its styles.
fn shown(write: impl FnOnce(&mut Vec<u8>)) -> String {
    let mut bytes = Vec::new();
    write(&mut bytes);
    anstream::adapter::strip_str(&String::from_utf8(bytes).expect("text")).to_string()
}

/// Returns what is written of a run into a golden text of this name.
fn written(name: &str, overview: &Overview, reports: &Path) -> String {
    let around = |detail, failures| Surroundings {
        reports: Some("reports/latest"),
        failures,
        detail,
        ..Surroundings::default()
    };
    let terminal = |around| shown(|out| terminal::write(out, overview, around).expect("written"));
    match name {
        "terminal.txt" => terminal(around(Detail::Summary, None)),
        "terminal-result.txt" => terminal(around(Detail::Result, None)),
        "terminal-whole.txt" => terminal(around(Detail::Whole, None)),
        "terminal-failures.txt" => terminal(around(Detail::Summary, Some(usize::MAX))),
        "rerun.txt" => shown(|out| terminal::write_rerun(out, overview, None).expect("written")),
        "annotations.txt" => shown(|out| annotations::write_github(overview, out).expect("written")),
        "files.txt" => list(reports),
        report => {
            let text = fs::read_to_string(reports.join(report)).expect(report);
            match serde_json::from_str::<Value>(&text) {
                Ok(json) => format!("{json:#}\n"),
                Err(_) => text,
            }
        }
    }
}

/// Returns the paths of the files in a folder, one a line.
pub(crate) fn list(folder: &Path) -> String {
    let files = files(folder);
    files.iter().map(|file| format!("{}\n", file.display())).collect()
}

/// Returns the paths of the files in a folder and in its folders, relative to it and sorted.
pub(crate) fn files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        let (path, name) = (entry.path(), PathBuf::from(entry.file_name()));
        match path.is_dir() {
            true => found.extend(files(&path).into_iter().map(|file| name.join(file))),
            false => found.push(name),
        }
    }
    found.sort();
    found
}

/// Compares a text with a golden one, or writes it where the environment says so; returns how they differ.
pub(crate) fn difference(path: &Path, text: &str) -> Option<String> {
    let golden = fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    if golden != text && std::env::var_os("STICKLER_BLESS").is_some() {
        fs::write(path, text).expect("written");
        return None;
    }
    let differs = || {
        let lines = crate::diff::text(&golden, text);
        format!(
            "{} is not what comes; see `cargo xtask bless`:\n{lines}",
            path.display()
        )
    };
    (golden != text).then(differs)
}

/// Asserts that the reports for programs can be read: those in JSON fit their schemas, and the JUnit file is one.
fn assert_valid(reports: &Path) {
    schema_tests::assert_fits(reports);
    let read = |report: &str| fs::read_to_string(reports.join(report)).expect(report);
    sarif::tests::assert_valid(&serde_json::from_str(&read("results.sarif")).expect("JSON"));
    quick_junit::Report::deserialize_from_str(&read("junit.xml")).expect("a report");
}

#[test]
fn reports_of_small_runs_are_their_golden_texts() {
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("golden");
    let mut differences = Vec::new();
    for run in files(&golden).iter().filter(|file| file.ends_with("run.toml")) {
        let folder = golden.join(run.parent().expect("the folder of the run"));
        let (events, _) = read(&folder.join("run.toml"));
        let reports = tempfile::tempdir().expect("a temporary folder");
        sample::report(reports.path(), &events);
        if files(reports.path()).len() > 1 {
            assert_valid(reports.path());
        }
        let overview = sample::overview(&events);
        for file in files(&folder).iter().filter(|file| !file.ends_with("run.toml")) {
            let text = written(&file.to_string_lossy(), &overview, reports.path());
            differences.extend(difference(&folder.join(file), &text));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n"));
}
