//! Tests the round trip: exports cases, runs their pages on the reference, pastes the arrays in the forms of several editors,
//! and judges them; then with errors on the way.

mod arrays;
mod compiled;
mod folders;
mod project;

use crate::manifest::Manifest;
use crate::{CopiedText, Export, ExportPlan, ExtraCases, Imported, Reason, export};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_engines::{Ability, Engine, Grade, Identity, Observation, Outcome, Reference, RunRequest};
use stickler_run::{CaseEvent, CaseJudge, Event, Fact, Plan, Verdict};
use stickler_suite::{Acceptance, Case, Suite, load_file};
use stickler_types::{DialectName, Value, join};

/// The case files of the tests, which together have every type, POUs and types of their own, constants, and open values.
const FILES: [&str; 14] = [
    "widening/integer.toml",
    "widening/contexts.toml",
    "widening/user-defined.toml",
    "bit-access/read-short.toml",
    "conversion/real-to-integer-edges.toml",
    "conversion/lreal-to-real-powers-of-two.toml",
    "conversion/negative-zero-to-integer.toml",
    "conversion/time-edges.toml",
    "language/literals-third-edition.toml",
    "widening/codesys.toml",
    "widening/logix.toml",
    "widening/control-expert.toml",
    "widening/omron-compared.toml",
    "widening/iec-ed3.toml",
];

fn suite() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases")
}

/// Returns cases of the files: of each file and dialect some that need not be rejected, and some that must.
fn cases(files: &[&str]) -> Vec<Case> {
    let mut cases = Vec::new();
    for file in files {
        let (all, mistakes) = load_file(&suite(), &suite().join(file));
        assert_eq!(mistakes, [], "{file}");
        for dialect in DialectName::ALL {
            let spoken = all.iter().filter(|case| case.dialect == dialect);
            let (rejected, accepted): (Vec<&Case>, Vec<&Case>) =
                spoken.partition(|case| case.expectation.accepted == Acceptance::Rejected);
            for group in [accepted, rejected] {
                cases.extend(
                    group
                        .iter()
                        .step_by(group.len() / 40 + 1)
                        .map(|case| (*case).clone()),
                );
            }
        }
    }
    cases
}

fn plan(dialect: DialectName) -> ExportPlan {
    ExportPlan {
        dialect,
        defined: None,
        suite: "1".to_owned(),
        cases_per_page: 16,
        with: BTreeSet::new(),
        without: BTreeSet::new(),
        sample: Some(192),
        panes: false,
        project: None,
    }
}

/// Imports copied texts as the results of [`engine`].
fn import(export: &Export, texts: &[CopiedText], sink: &mut dyn FnMut(Event)) -> Imported {
    let judge = CaseJudge {
        plan: &Plan::default(),
        suite: &Suite::default(),
        engine: &engine(),
        lacks: None,
        baseline: None,
    };
    export.import(texts, &judge, sink, &mut |_, _| {})
}

fn engine() -> Identity {
    Identity {
        name: "imported".to_owned(),
        version: "1".to_owned(),
        dialects: DialectName::ALL.to_vec(),
        abilities: vec![Ability::Check, Ability::Execute],
        grade: Grade::Rejected,
        lacks: Vec::new(),
    }
}

/// Returns the array of a page after the reference has executed the page.
fn array(page: &str, dialect: DialectName, elements: usize, scans: usize) -> Vec<i32> {
    let names: Vec<String> = (0..elements).map(|index| format!("results[{index}]")).collect();
    let observe: Vec<Observation> = names.iter().map(|name| Observation::last(name, "DINT")).collect();
    let reference = Reference::new();
    let mut session = reference.session().expect("a session");
    let outcome = session.run(&RunRequest {
        scans: u32::try_from(scans).expect("few scans"),
        ..RunRequest::once(dialect, page, &observe)
    });
    let Outcome::Executed { values, .. } = outcome else {
        panic!("{outcome:?}\n{page}");
    };
    let number = |value: &Value| match value {
        Value::Plain { raw, .. } => i32::try_from(raw.cast_signed()).expect("a DINT"),
        other => panic!("{other}"),
    };
    values.iter().map(|(_, value)| number(value)).collect()
}

/// An export in a folder of its own, with the arrays of its pages.
struct ExportFolder {
    folder: tempfile::TempDir,
    arrays: Vec<Vec<i32>>,
    cases: usize,
}

impl ExportFolder {
    fn of(plan: &ExportPlan, cases: &[Case]) -> ExportFolder {
        let folder = tempfile::tempdir().expect("a folder");
        let cases: Vec<&Case> = cases.iter().collect();
        let reported = export(plan, &cases, folder.path()).expect("exported");
        let manifest = Manifest::read(folder.path()).expect("a manifest");
        let arrays = manifest
            .pages
            .iter()
            .filter(|page| page.identity != 0)
            .map(|page| {
                let text = fs::read_to_string(folder.path().join(&page.file)).expect("a page");
                array(&text, plan.dialect, page.elements, page.steps.len())
            });
        ExportFolder {
            arrays: arrays.collect(),
            cases: reported.cases,
            folder,
        }
    }

    fn import(&self, text: &str) -> (Imported, Vec<CaseEvent>, bool) {
        let source = CopiedText {
            name: "copied.txt".to_owned(),
            bytes: text.as_bytes().to_vec(),
        };
        let (mut events, mut whole) = (Vec::new(), false);
        let export = Export::read(self.folder.path()).expect("an export");
        let imported = import(&export, &[source], &mut |event| match event {
            Event::Header(_) | Event::Cause(_) => {}
            Event::Case(case) => events.push(case),
            Event::Footer(_) => whole = true,
        });
        (imported, events, whole)
    }

    fn manifest(&self) -> Manifest {
        Manifest::read(self.folder.path()).expect("a manifest")
    }

    /// Writes the file of answers.
    fn answer(&self, text: &str) {
        fs::write(self.folder.path().join(crate::ANSWERS), text).expect("written");
    }

    fn text(&self) -> String {
        self.arrays.iter().map(|array| list(array)).collect()
    }

    /// Imports a text, asserts that no case gets a verdict, and returns the notes.
    fn notes_without_verdicts(&self, text: &str) -> String {
        let (imported, events, whole) = self.import(text);
        assert!(
            !whole && events.is_empty() && imported.summary.cancelled,
            "{text}"
        );
        assert_eq!(imported.unjudged, self.cases as u64);
        imported.notes.join("\n")
    }
}

/// Returns the cases that did not pass.
fn odd(events: &[CaseEvent]) -> Vec<&CaseEvent> {
    events
        .iter()
        .filter(|case| case.verdict != Verdict::Pass)
        .collect()
}

fn list(array: &[i32]) -> String {
    let values = array.iter().enumerate();
    let lines = values.map(|(index, value)| format!("results[{index}] := {value};\n"));
    lines.collect()
}

fn watch_list(array: &[i32]) -> String {
    let mut text = "Expression\tType\tValue\tPrepared value\tAddress\tComment\r\n".to_owned();
    for (index, value) in array.iter().enumerate() {
        text.push_str(&format!(
            "Device.Application.stickler_page.results[{index}]\tDINT\t{value}\t\t\t\r\n"
        ));
    }
    text
}

/// Returns an array as a table of a German spreadsheet, with hexadecimal values where they have no sign.
fn table(array: &[i32]) -> String {
    let grouped = |value: i32| {
        let digits = value.unsigned_abs().to_string();
        let mut text = String::new();
        for (at, digit) in digits.chars().enumerate() {
            if at > 0 && (digits.len() - at).is_multiple_of(3) {
                text.push('.');
            }
            text.push(digit);
        }
        format!("{}{text}", if value < 0 { "-" } else { "" })
    };
    let cell = |value: i32| {
        if value % 2 == 0 {
            format!("16#{value:08X}")
        } else {
            grouped(value)
        }
    };
    let rows = array
        .iter()
        .enumerate()
        .map(|(index, value)| format!("[{index}];{}\n", cell(*value)));
    rows.collect()
}

fn numbers(array: &[i32]) -> String {
    format!("[{}]\n", join(array, ", "))
}
