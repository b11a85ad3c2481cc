//! Runs the tables of `tests`: which programs show one cause, and which a reduction may make of others; in [`tables`], what the parts of
//! this crate find in a program.

mod tables;

use crate::essence::Essence;
use crate::guard::Constructs;
use crate::normal_form::Normal;
use crate::promised::OF_PATTERNS;
use crate::question::{Deviation, Takes};
use crate::reduction::Smallest;
use crate::title::title;
use serde::Deserialize;
use std::collections::BTreeMap;
use stickler_run::{Fact, Grade, Verdict};
use stickler_types::{Diagnostic, Value};

/// A small program, and what a compiler made of it. `same_cause.toml` says what each key means.
#[derive(Deserialize, Default)]
#[serde(default, deny_unknown_fields)]
struct Failing {
    units: String,
    has: String,
    does: String,
    program: Option<String>,
    at: Option<u32>,
    column: Option<u32>,
    rejected: Option<String>,
    said: Option<String>,
    accepted: Option<String>,
    otherwise: Option<(String, String)>,
    beside: Option<String>,
    elsewhere: Option<(String, String)>,
    placeless: Option<String>,
    wrong: Option<Vec<String>>,
    fault: Option<String>,
    lacks: Option<String>,
    unusable: Option<String>,
    crashes: Option<(String, String)>,
    hangs: bool,
    asked: bool,
    normally: Option<String>,
}

/// Programs that show one cause, and others.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SameCause {
    first: Failing,
    #[serde(default)]
    same: Vec<Failing>,
    #[serde(default)]
    other: Vec<Failing>,
    construct: Option<String>,
    #[serde(default)]
    title_starts: String,
    #[serde(default)]
    title_ends: String,
}

/// Returns the text of a program: `declarations | statements` is short for one.
fn whole(text: &str) -> String {
    match text.split_once(" | ") {
        Some((has, does)) => format!("PROGRAM p\nVAR\n{has}\nEND_VAR\n{does}\nEND_PROGRAM\n"),
        None => text.to_owned(),
    }
}

fn diagnostic(code: Option<&str>, message: &str, line: Option<u32>, column: Option<u32>) -> Fact {
    Fact::Diagnostic(Diagnostic {
        line,
        column,
        code: code.map(str::to_owned),
        message: message.to_owned(),
        ..Diagnostic::default()
    })
}

fn lacking(reason: &str) -> Fact {
    Fact::NotImplemented {
        reason: reason.to_owned(),
        promised_by: None,
    }
}

impl Failing {
    /// Returns what had to happen, what happened, and the verdict.
    fn facts(&self, program: &str) -> (Vec<Fact>, Vec<Fact>, Verdict) {
        let at = self.at.or(Some(5));
        let mistake = |code: &str| diagnostic(Some(code), "", at, None);
        let last = program.lines().count() as u32 - 1;
        let value = |text: &str| Value::parse(text).expect("a literal");
        let (expected, got) = if let Some(code) = &self.rejected {
            (Fact::Accepted, diagnostic(Some(code), "no", at, self.column))
        } else if let Some(message) = &self.said {
            (Fact::Accepted, diagnostic(None, message, at, None))
        } else if let Some(code) = &self.accepted {
            (mistake(code), Fact::Accepted)
        } else if let Some((code, reported)) = &self.otherwise {
            (mistake(code), diagnostic(Some(reported), "", at, self.column))
        } else if let Some((code, reported)) = &self.elsewhere {
            (
                diagnostic(Some(code), "", Some(last), None),
                diagnostic(Some(reported), "no", at, None),
            )
        } else if let Some(code) = &self.placeless {
            (mistake(code), diagnostic(Some(code), "no", None, None))
        } else if let Some([name, wanted, is]) = self.wrong.as_deref() {
            let fact = |text: &str| Fact::Value {
                name: name.clone(),
                value: value(text),
            };
            (fact(wanted), fact(is))
        } else if let Some(name) = self.wrong.as_ref().and_then(|wrong| wrong.first()) {
            let name = name.clone();
            (
                Fact::Value {
                    name: name.clone(),
                    value: value("BOOL#TRUE"),
                },
                Fact::OtherValue { name },
            )
        } else if let Some(fault) = &self.fault {
            let fault = fault.parse().expect("a fault");
            (Fact::Accepted, Fact::Fault { fault, line: None })
        } else if let Some(reason) = &self.lacks {
            (Fact::Accepted, lacking(reason))
        } else if let Some(reason) = self.unusable.clone() {
            (Fact::Accepted, Fact::Unusable { reason })
        } else if let Some((code, reason)) = &self.crashes {
            let reason = reason.clone();
            (mistake(code), Fact::Crashed { reason })
        } else {
            assert!(self.hangs, "nothing happens");
            (Fact::Accepted, Fact::TimedOut { after_ms: 1000 })
        };
        let verdict = match self.crashes {
            _ if self.hangs => Verdict::Timeout,
            Some(_) => Verdict::Crash,
            None => Verdict::Fail,
        };
        let beside = self.beside.as_deref();
        let beside = beside.map(|code| diagnostic(Some(code), "", Some(last), None));
        ([expected].into_iter().chain(beside).collect(), vec![got], verdict)
    }

    fn smallest(&self) -> Smallest {
        let text = || {
            format!(
                "{}{}",
                self.units,
                whole(&format!("{} | {}", self.has, self.does))
            )
        };
        let program = self.program.clone().unwrap_or_else(text);
        let (expected, got, verdict) = self.facts(&program);
        let of_codes = self.otherwise.is_some();
        let grade = if of_codes { Grade::Code } else { Grade::Line };
        let deviation = Deviation::new(&program, verdict, (expected, got), grade);
        Smallest::known(program, deviation)
    }

    fn essence(&self) -> Essence {
        let smallest = self.smallest();
        let mut normal = Normal::unasked(&smallest);
        normal.is_asked = self.asked;
        if let Some(normally) = &self.normally {
            normal.program = smallest.program.replace(&self.does, normally);
        }
        Essence::of(&smallest, &normal)
    }
}

#[test]
fn programs_show_one_cause_or_several_and_have_the_titles_that_the_table_says() {
    let tables: BTreeMap<String, Vec<SameCause>> =
        toml::from_str(include_str!("tests/same_cause.toml")).expect("a table");
    let mut failures = Vec::new();
    for (name, one) in tables
        .iter()
        .flat_map(|(name, all)| all.iter().map(move |one| (name, one)))
    {
        let first = one.first.essence();
        let others = one
            .same
            .iter()
            .map(|other| (other, true))
            .chain(one.other.iter().map(|other| (other, false)));
        for (number, (other, is_same)) in others.enumerate() {
            let other = other.essence();
            if first.explains(&other) != is_same {
                failures.push(format!(
                    "{name}, program {number}: {is_same} is said\n  {first:?}\n  {other:?}"
                ));
            }
        }
        if one
            .construct
            .as_ref()
            .is_some_and(|construct| *construct != first.construct())
        {
            failures.push(format!("{name}: {}", first.construct()));
        }
        let title = title(&one.first.smallest(), false);
        if !title.starts_with(&one.title_starts) || !title.ends_with(&one.title_ends) {
            failures.push(format!("{name}: {title}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn a_title_keeps_the_code_of_an_adapter_where_codes_are_compared() {
    let failing = Failing {
        has: "x : INT := INT#-5;".to_owned(),
        does: "x := x;".to_owned(),
        rejected: Some("P0002".to_owned()),
        at: Some(3),
        ..Failing::default()
    };
    let smallest = failing.smallest();
    assert!(title(&smallest, true).ends_with("is rejected: P0002 no"));
    assert!(title(&smallest, false).ends_with("is rejected: no"));
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct MayBecome {
    program: Option<String>,
    /// Whether the engine takes all that not every compiler does.
    #[serde(default)]
    takes_all: bool,
    may: Vec<(String, String)>,
    may_not: Vec<(String, String)>,
}

#[test]
fn a_reduction_makes_only_those_programs_of_others_that_the_table_says() {
    let tables: BTreeMap<String, Vec<MayBecome>> =
        toml::from_str(include_str!("tests/may_become.toml")).expect("a table");
    let mut failures = Vec::new();
    for (name, one) in tables
        .iter()
        .flat_map(|(name, all)| all.iter().map(move |one| (name, one)))
    {
        let of = |inside: &str| match &one.program {
            Some(program) => Constructs::of(&program.replace('…', inside)),
            None => Constructs::of(inside),
        };
        let takes = match one.takes_all {
            true => Takes {
                empty_bodies: true,
                no_variables: true,
                empty_statements: true,
                no_program: true,
            },
            false => Takes::default(),
        };
        for (pair, may) in one
            .may
            .iter()
            .map(|pair| (pair, true))
            .chain(one.may_not.iter().map(|pair| (pair, false)))
        {
            if of(&pair.0).may_become(&of(&pair.1), takes) != may {
                failures.push(format!("{name}: {may} is said of {pair:?}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn each_pattern_that_is_promised_is_one_that_a_value_tells_and_a_feature_promises() {
    let named = [
        include_str!("loop_limits.rs"),
        include_str!("malformed.rs"),
        include_str!("patterns.rs"),
        include_str!("essence.rs"),
        include_str!("normal_form/other_forms.rs"),
        include_str!("value_lines.rs"),
    ]
    .concat();
    for (key, patterns) in OF_PATTERNS {
        let is_named = |pattern: &&str| named.contains(&format!("{pattern:?}"));
        assert!(patterns.iter().all(is_named), "{patterns:?}");
        let features = stickler_suite::Features::built_in();
        assert!(
            features
                .get(key)
                .is_some_and(|feature| !feature.promised.is_empty()),
            "{key}"
        );
    }
}
