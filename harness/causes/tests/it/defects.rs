//! Finds the causes of failing cases on compilers with planted defects, as the files of `tests/it/defects` describe them:
//!
//! | key | what it says |
//! |---|---|
//! | `name` | what is shown, as a sentence |
//! | `compiler` | [`Defects`]; `poses_as` the compiler for whose documents Stickler's own sources speak, `knows_no` codes |
//! | `cases` | `has` the declarations of PROGRAM main and what it `does`, or its whole `program`; what `must` happen; its `basis`; the `place` of its value: source, target and surrounding |
//! | `titles` | the number of cases and the title of each cause that must be found; `…` stands for anything |
//! | `cause` | properties of the first cause, where `…` stands for anything; `program, not` is one that is not shown |
//! | `editions` | whether each case is one of the second edition too |
//! | `questions` | the maximum number of questions of the search |
//! | `most_runs`, `once` | how many programs are run at most; a text of which one program alone is run |

use crate::compiler::{DefectiveCompiler, Defects};
use crate::search::causes;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use stickler_causes::SearchLimits;
use stickler_mdtest::fits;
use stickler_run::{Cause, Fact};
use stickler_suite::{
    Acceptance, Case, Expectation, ExpectedDiagnostic, ExpectedText, ExpectedValue, Placement, Suite, Wanted,
};
use stickler_types::{DialectName, Observation, Setting, Value};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct DefectFile {
    defect: Vec<PlantedDefect>,
}

#[derive(Deserialize, Default)]
#[serde(default, deny_unknown_fields)]
pub struct PlantedDefect {
    name: String,
    compiler: Defects,
    poses_as: Option<String>,
    knows_no: Vec<String>,
    cases: Vec<FailingCase>,
    editions: bool,
    titles: Vec<String>,
    cause: BTreeMap<String, String>,
    questions: Option<u64>,
    most_runs: Option<usize>,
    once: Option<String>,
}

#[derive(Deserialize, Default)]
#[serde(default, deny_unknown_fields)]
struct FailingCase {
    has: String,
    does: String,
    program: Option<String>,
    must: String,
    basis: Option<String>,
    place: Option<[String; 3]>,
    /// A variable that is written before the first scan, and its value.
    sets: Option<(String, String)>,
}

impl FailingCase {
    /// Returns the case. It must end with a value (`into = REAL#5.0`), be rendered (`renders i := 1; | i := 2;`), be rejected (`7 P4035 | 8 P4022`) or be
    /// accepted; of one that is open, nobody decides what must happen.
    fn case(&self, number: usize) -> Case {
        let (has, does) = (&self.has, &self.does);
        let written = || format!("PROGRAM main\nVAR\n    {has}\nEND_VAR\n    {does}\nEND_PROGRAM\n");
        let program = self.program.clone().unwrap_or_else(written);
        let place = self.place.as_ref();
        let arguments = place.map_or(String::new(), |names| format!("({})", names.join(",")));
        let id = format!("t::case-{number}{arguments}");
        let mut expectation = Expectation::default();
        let mut observe = Vec::new();
        if let Some((name, value)) = self.must.split_once(" = ") {
            let value = Value::parse(value).expect("a literal");
            observe.push(Observation::last(name, value.type_name()));
            expectation.values.push(ExpectedValue {
                name: name.into(),
                after: None,
                value,
                line: 1,
            });
        } else if let Some(lines) = self.must.strip_prefix("renders ") {
            let lines = lines.split(" | ").map(Box::from).collect();
            expectation.rendered = Some(ExpectedText { lines, line: 1 });
        } else if self.must.contains(' ') {
            expectation.accepted = Acceptance::Rejected;
            let mistakes = self
                .must
                .split(" | ")
                .filter_map(|mistake| mistake.split_once(' '));
            let mistakes = mistakes.map(|(line, code)| ExpectedDiagnostic {
                line: line.parse().expect("a number"),
                code: code.parse().expect("a code"),
            });
            expectation.diagnostics.extend(mistakes);
        } else if self.must == "open" {
            expectation.accepted = Acceptance::Observed;
        }
        Case {
            title: "A title".into(),
            basis: self.basis.as_deref().unwrap_or("a-source: t").into(),
            file: "conformance-cases/area/file.toml".into(),
            area: "area".into(),
            expectation: Arc::new(expectation),
            observe: observe.into(),
            scans: if self.sets.is_some() { 2 } else { 1 },
            set: self.sets.iter().map(setting).collect(),
            placement: place.map(|[source, target, surrounding]| {
                Arc::new(Placement {
                    source: source.as_str().into(),
                    target: target.as_str().into(),
                    surrounding: surrounding.as_str().into(),
                })
            }),
            ..Case::of_program(&id, DialectName::IRONPLC_ED3, &program)
        }
    }
}

fn setting((name, value): &(String, String)) -> Setting {
    Setting {
        before: 1,
        name: name.as_str().into(),
        value: Value::parse(value).expect("a literal"),
    }
}

impl PlantedDefect {
    /// Returns the compiler.
    pub fn compiler(&self) -> DefectiveCompiler {
        let mut compiler = DefectiveCompiler::new(&self.compiler);
        compiler.identity.name = self.poses_as.clone().unwrap_or(compiler.identity.name);
        let codes = self.knows_no.iter().map(|code| code.parse().expect("a code"));
        compiler.identity.lacks = codes.collect();
        compiler
    }

    /// Returns the suite of the cases.
    pub fn suite(&self) -> Suite {
        let cases = self.cases.iter().zip(1..).map(|(case, number)| case.case(number));
        let dialects = [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3];
        let dialects = &dialects[usize::from(!self.editions)..];
        let cases = cases.flat_map(|case| {
            dialects.iter().map(move |dialect| Case {
                dialect: *dialect,
                ..case.clone()
            })
        });
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
        let mut suite = match self.poses_as {
            Some(_) => Suite::load_files(&folder, Wanted::default(), |_, _| false),
            None => Suite::default(),
        };
        suite.cases = cases.collect();
        suite
    }

    /// Returns what is not as the file says.
    fn mistakes(&self) -> Vec<String> {
        let compiler = self.compiler();
        let mut limits = SearchLimits::default();
        limits.questions = self.questions.unwrap_or(limits.questions);
        let found = causes(&self.suite(), &compiler, 1, limits);
        let mut mistakes = Vec::new();
        let title = |cause: &Cause| format!("{} {}", cause.number(), cause.title);
        let titles: Vec<String> = found.iter().map(title).collect();
        let is_as_said = titles.len() == self.titles.len()
            && titles
                .iter()
                .zip(&self.titles)
                .all(|(title, said)| fits(said, title));
        if !is_as_said {
            mistakes.push(format!("titles: {titles:#?}"));
        }
        for (key, said) in &self.cause {
            let is = found.first().map_or(String::new(), |first| property(first, key));
            if fits(said, &is) == key.ends_with("not") {
                mistakes.push(format!("{key} = {is:?}"));
            }
        }
        mistakes.extend(found.iter().flat_map(reproduction_mistakes));
        let mut together = self.compiler();
        together.pack_size = 48;
        // The end of the time for questions is one of the process, and so of tests beside this one: it may cut off what is printed.
        let unprinted = |mut causes: Vec<Cause>| {
            for cause in &mut causes {
                cause.shown.printed.clear();
            }
            causes
        };
        let again = unprinted(causes(&self.suite(), &together, 1, limits));
        if self.questions.is_none() && again != unprinted(found.clone()) {
            mistakes.push("other causes are found where programs are run together".to_owned());
        }
        let runs = compiler.number_asked("");
        if self.most_runs.is_some_and(|most| runs > most) {
            mistakes.push(format!("{runs} programs were run"));
        }
        if let Some(text) = &self.once
            && compiler.number_asked(text) != 1
        {
            mistakes.push(format!("{text} was run {} times", compiler.number_asked(text)));
        }
        mistakes
    }
}

/// Returns a property of a cause as a text.
fn property(found: &Cause, key: &str) -> String {
    let shown = &found.shown;
    let facts = |facts: &[Fact]| facts.iter().map(Fact::to_string).collect::<Vec<_>>().join("; ");
    match key {
        "symptom" => found.symptom.clone(),
        "construct" => found.construct.clone(),
        "basis" => shown.basis.clone(),
        "expected" => facts(&shown.expected),
        "got" => facts(&shown.got),
        "derived" => shown.is_derived.to_string(),
        "neighbours" => shown.neighbours_told().unwrap_or_default(),
        "printed" => shown.printed.trim().to_owned(),
        "reduction" => format!("{:?}", found.reduction),
        "program" | "program, not" => shown.program.clone(),
        _ => panic!("a cause has no `{key}`"),
    }
}

/// Returns what is wrong with the reproduction of a cause: it must have the program that is shown, and observe what is wrong.
fn reproduction_mistakes(cause: &Cause) -> Vec<String> {
    let shown = &cause.shown;
    let reproduction = shown.reproduction.as_ref().expect("a reproduction");
    let [program, observed] = &reproduction.files[..] else {
        panic!("{} files", reproduction.files.len());
    };
    let mut mistakes = Vec::new();
    if program.text != shown.program {
        mistakes.push(format!("another program is reproduced: {}", program.text));
    }
    for (wanted, reported) in shown.expected.iter().zip(&shown.got) {
        if let Fact::Value { name, .. } = wanted
            && wanted != reported
            && !observed.text.split(' ').any(|one| one == name)
        {
            mistakes.push(format!("{name} is not observed"));
        }
    }
    mistakes
}

/// Returns the defects of a file.
pub fn defects(text: &str) -> Vec<PlantedDefect> {
    toml::from_str::<DefectFile>(text)
        .unwrap_or_else(|error| panic!("{error}"))
        .defect
}

#[test]
fn planted_defects_are_found_and_told_as_their_files_say() {
    let files = [
        ("values.toml", include_str!("defects/values.toml")),
        ("rejections.toml", include_str!("defects/rejections.toml")),
        ("sources.toml", include_str!("defects/sources.toml")),
        ("three.toml", include_str!("defects/three.toml")),
    ];
    let mut failures = Vec::new();
    for (file, text) in files {
        for defect in defects(text) {
            let mistakes = defect.mistakes();
            if !mistakes.is_empty() {
                failures.push(format!("{file}: {}\n  {}", defect.name, mistakes.join("\n  ")));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n\n"));
}
