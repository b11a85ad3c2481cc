//! Finds the causes of failing cases on compilers with planted defects, as the files of `tests/it/defects` describe them:
//!
//! | key | what it says |
//! |---|---|
//! | `name` | what is shown, as a sentence |
//! | `compiler` | [`Defects`]; `poses_as` the compiler for whose documents Stickler's own sources speak, `knows_no` codes |
//! | `cases` | `has` the declarations of PROGRAM main and what it `does`, or its whole `program`; what `must` happen; its `basis` |
//! | `titles` | the number of cases and the title of each cause that must be found; `*` stands for anything |
//! | `cause` | properties of the first cause |
//! | `editions` | whether each case is one of the second edition too |
//! | `questions` | the maximum number of questions of the search |
//! | `most_runs`, `once` | how many programs are run at most; a text of which one program alone is run |

use crate::compiler::{DefectiveCompiler, Defects};
use crate::suites::{self, suite, suite_with_sources, titles};
use serde::Deserialize;
use stickler_causes::SearchLimits;
use stickler_run::{Cause, Fact};
use stickler_suite::{Case, Suite};
use stickler_types::DialectName;

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
    cause: FirstCause,
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
}

/// What is asserted of the cause that explains most cases.
#[derive(Deserialize, Default)]
#[serde(default, deny_unknown_fields)]
struct FirstCause {
    symptom: Option<String>,
    construct: Option<String>,
    basis: Option<String>,
    expected: Option<String>,
    got: Option<String>,
    derived: Option<bool>,
    program_has: Vec<String>,
    program_lacks: Vec<String>,
    /// What the commands of the reproduction printed.
    printed: Option<String>,
    reduction: Option<String>,
}

impl FailingCase {
    fn case(&self, number: usize) -> Case {
        let written = || {
            format!(
                "PROGRAM main\nVAR\n    {}\nEND_VAR\n    {}\nEND_PROGRAM\n",
                self.has, self.does
            )
        };
        let program = self.program.clone().unwrap_or_else(written);
        let case = suites::case(&format!("t::case-{number}"), &program, &self.must);
        match &self.basis {
            Some(basis) => Case {
                basis: basis.as_str().into(),
                ..case
            },
            None => case,
        }
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
        let cases: Vec<Case> = cases.collect();
        match self.poses_as {
            Some(_) => suite_with_sources(cases),
            None => suite(cases),
        }
    }

    /// Returns what is not as the file says.
    fn mistakes(&self) -> Vec<String> {
        let compiler = self.compiler();
        let mut limits = SearchLimits::default();
        limits.questions = self.questions.unwrap_or(limits.questions);
        let found = suites::causes(&self.suite(), &compiler, 1, limits);
        let mut mistakes = Vec::new();
        let titles = titles(&found);
        let is_as_said = titles.len() == self.titles.len()
            && titles
                .iter()
                .zip(&self.titles)
                .all(|(title, said)| matches(said, title));
        if !is_as_said {
            mistakes.push(format!("titles: {titles:#?}"));
        }
        mistakes.extend(
            found
                .first()
                .into_iter()
                .flat_map(|first| self.cause.mistakes(first)),
        );
        mistakes.extend(found.iter().flat_map(reproduction_mistakes));
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

impl FirstCause {
    fn mistakes(&self, found: &Cause) -> Vec<String> {
        let facts = |facts: &[Fact]| facts.iter().map(Fact::to_string).collect::<Vec<_>>().join("; ");
        let shown = &found.shown;
        let derived = self.derived.map(|derived| derived.to_string());
        let properties = [
            ("symptom", &self.symptom, found.symptom.clone()),
            ("construct", &self.construct, found.construct.clone()),
            ("basis", &self.basis, shown.basis.clone()),
            ("expected", &self.expected, facts(&shown.expected)),
            ("got", &self.got, facts(&shown.got)),
            ("derived", &derived, shown.is_derived.to_string()),
            ("printed", &self.printed, shown.printed.trim().to_owned()),
            ("reduction", &self.reduction, format!("{:?}", found.reduction)),
        ];
        let differs = |(_, said, is): &(&str, &Option<String>, String)| {
            said.as_ref().is_some_and(|said| !matches(said, is))
        };
        let properties = properties.into_iter().filter(differs);
        let mut mistakes: Vec<String> = properties.map(|(key, _, is)| format!("{key} = {is:?}")).collect();
        let has = |text: &&String| shown.program.contains(text.as_str());
        let missing = self.program_has.iter().filter(|text| !has(text));
        let there = self.program_lacks.iter().filter(has);
        let wrong = missing.chain(there);
        mistakes.extend(wrong.map(|text| format!("`{text}` in the program\n{}", shown.program)));
        mistakes
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

/// Returns whether a text is as said, where `*` stands for anything.
fn matches(said: &str, text: &str) -> bool {
    match said.split_once('*') {
        None => said == text,
        Some((before, behind)) => text.strip_prefix(before).is_some_and(|rest| {
            (0..=rest.len()).any(|at| rest.get(at..).is_some_and(|rest| matches(behind, rest)))
        }),
    }
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
