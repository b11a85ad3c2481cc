//! Asks the parts of this crate what `tables.toml` says that they find in small programs.

use super::{Failing, diagnostic, lacking, whole};
use crate::alone::alone;
use crate::claim::{keeps_claim, keeps_work};
use crate::failure_sign::Sign;
use crate::forms;
use crate::key::CauseKey;
use crate::lines::{described, line_with_number};
use crate::patterns;
use crate::plainness;
use crate::program::{Program, ReadProgram};
use crate::promised;
use crate::question::{self, Deviation};
use crate::reduction::moved;
use crate::shape::{KeptTypes, shape, token_at};
use crate::suspect::{self, unimplemented};
use crate::title::condition;
use crate::ways;
use crate::words::ANY;
use crate::work::{WORKS, operations};
use std::collections::{BTreeMap, BTreeSet};
use stickler_run::{CaseEvent, Fact, Grade, Verdict};
use stickler_suite::Features;
use stickler_types::{Diagnostic, Dialect, DialectName, Fault, NamedValue, Outcome, Value};

/// Returns a text in one line.
fn in_line(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Returns what stands between the last END_VAR and the end of a program.
fn body(text: &str) -> String {
    let (_, body) = text.rsplit_once("END_VAR").unwrap_or(("", text));
    in_line(body.trim_end().trim_end_matches("END_PROGRAM"))
}

/// Returns an operand alone without what all of these programs have.
fn operand(text: &str) -> String {
    in_line(
        &text
            .replace("PROGRAM main\nVAR", "")
            .replace("END_VAR", "")
            .replace("END_PROGRAM", ""),
    )
}

fn joined(texts: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    texts
        .into_iter()
        .map(|text| text.as_ref().to_owned())
        .collect::<Vec<_>>()
        .join(" ; ")
}

fn yes(is_it: bool) -> String {
    if is_it { "yes" } else { "no" }.to_owned()
}

fn key(program: &str, values: &[NamedValue], outcome: &Outcome) -> Option<CauseKey> {
    CauseKey::of_program(program, DialectName::IRONPLC_ED3, values, outcome)
}

/// Returns whether a claim of a kind says something of a program of which a compiler says something.
fn claims(program: &str, claim: &str, said: &str) -> bool {
    let mut failing = Failing {
        program: Some(program.to_owned()),
        ..Failing::default()
    };
    match said.starts_with('P') {
        true => failing.rejected = Some(said.to_owned()),
        false => failing.unusable = Some(said.to_owned()),
    }
    let smallest = failing.smallest();
    let value = || Fact::Value {
        name: "x".to_owned(),
        value: Value::parse("INT#-5").expect("a literal"),
    };
    let case = CaseEvent {
        expected: vec![match claim {
            "value" => value(),
            "mistake" => Fact::Diagnostic(Diagnostic::default()),
            _ => Fact::Accepted,
        }],
        got: smallest.deviation.got.clone(),
        program: Some(program.to_owned()),
        ..CaseEvent::default()
    };
    keeps_claim(&case, &smallest)
}

/// Returns the answer to a question about a program, by the inputs of a row.
fn answer(question: &str, inputs: &[String]) -> String {
    let text = whole(&inputs[0]);
    let parsed = Program::new(&text);
    let program = parsed.read();
    let other = || whole(&inputs[1]);
    let line = |number: Option<u32>| {
        number
            .and_then(|number| parsed.line_text(number))
            .unwrap_or_default()
            .to_owned()
    };
    let line_of = |wanted: &str| {
        let place = text.lines().position(|line| line == wanted);
        place.expect("a line of the program") as u32 + 1
    };
    let lacking = |reason: &str| vec![lacking(reason)];
    let sign =
        |text: &str, got: Vec<Fact>| Sign::of(text, Verdict::Fail, (&[Fact::Accepted], &got), Grade::Code);
    let deviation = || {
        let fact = |text: &String| Fact::Value {
            name: "x".to_owned(),
            value: Value::parse_observed(text).expect("a literal"),
        };
        let facts = (vec![fact(&inputs[1])], vec![fact(&inputs[2])]);
        Deviation::new("", Verdict::Fail, facts, Grade::Line)
    };
    let others = |texts: Vec<String>| texts.into_iter().filter(|one| *one != text);
    let bodies = |texts: Vec<String>| joined(others(texts).map(|one| body(&one)));
    let lines = |texts: Vec<String>| joined(others(texts).map(|one| in_line(&one)));
    let alone = |program: &ReadProgram<'_, '_>| {
        alone(program)
            .into_iter()
            .map(|one| operand(&one.program))
            .collect::<Vec<_>>()
    };
    match question {
        "computation" => line(program.computation(&inputs[1])),
        "declaration" => line(Some(program.declaration(&inputs[1]))),
        "culprit" => line(Some(suspect::culprit(&program))),
        "line_with_number" => line(line_with_number(&program, &inputs[1])),
        "unimplemented" => line(Some(unimplemented(&program, &lacking(&inputs[1])))),
        "described" => described(&program, line_of(&inputs[1])),
        "condition" => line(condition(&program, line_of(&inputs[1]))),
        "promised" => {
            let got = [diagnostic(Some("P4035"), "no", Some(3), None)];
            let dialect = Dialect::of(DialectName::IRONPLC_ED3);
            let found = promised::specific(&program, (3, &got), dialect, Features::built_in());
            found.map_or(String::new(), |feature| feature.key.clone())
        }
        "keeps_work" => yes(keeps_work(&text, &other(), &operations(&other()))),
        "shape" => yes(shape(&text, KeptTypes::Equal) == shape(&other(), KeptTypes::Equal)),
        "shape_of_families" => yes(shape(&text, KeptTypes::Families) == shape(&other(), KeptTypes::Families)),
        "token_at" => token_at(&text, 5, inputs[1].parse().expect("a column")),
        "unread_alike" => {
            let unread = || vec![diagnostic(Some("P0002"), "", Some(5), inputs[2].parse().ok())];
            yes(sign(&text, unread()) == sign(&other(), unread()))
        }
        "mistyped_alike" => {
            let mistyped = || vec![diagnostic(Some("P4035"), "", Some(5), Some(6))];
            yes(sign(&text, mistyped()) == sign(&other(), mistyped()))
        }
        "keeps_claim" => yes(claims(&text, &inputs[1], &inputs[2])),
        "hides" => {
            let of = |expected: Fact, code: &str| {
                let got = [diagnostic(Some(code), "", Some(1), Some(6))];
                Sign::of("x := y;", Verdict::Fail, (&[expected], &got), Grade::Code)
            };
            let hides = of(diagnostic(Some("P4022"), "", Some(1), Some(1)), &inputs[0]);
            let hidden = of(Fact::Accepted, &inputs[1]);
            yes(hides.is_kept_by(&hidden) && !hidden.is_kept_by(&hides))
        }
        "same_key" => {
            let keys = [text.clone(), other()].map(|text| {
                let diagnostics = vec![Diagnostic {
                    code: Some("P4017".to_owned()),
                    line: Some(5),
                    ..Diagnostic::default()
                }];
                let key = key(&text, &[], &Outcome::Rejected { diagnostics }).expect("a rejection");
                assert!(key.title.contains("is rejected"), "{}", key.title);
                (key.symptom, key.constructs)
            });
            yes(keys[0] == keys[1])
        }
        "symptom_of_key" => {
            let value = |text: &str| vec![("a".to_owned(), Value::parse(text).expect("a literal"))];
            let found = key(&text, &value("INT#5"), &Outcome::executed(value(&inputs[1])));
            found.map_or(String::new(), |key| key.symptom)
        }
        "missing_alike" => yes(sign(&text, lacking("no")) == sign(&other(), lacking("no"))),
        "alone" => joined(alone(&program)),
        "alone_has" => yes(alone(&program).contains(&inputs[1])),
        "only_initial_values" => lines(forms::only_initial_values(&program)),
        "with_one_statement" => bodies(forms::with_one_statement(&program)),
        "with_other_operand" => bodies(forms::with_other_operand(&program, 5)),
        "with_other_initial_value" => lines(forms::with_other_operand(&program, 5)),
        "in_two_steps" => {
            let found = ways::in_two_steps(&program).map(|one| {
                one.split_once("END_VAR\n")
                    .map_or(String::new(), |(_, rest)| in_line(rest))
            });
            found.unwrap_or_default().replace(" END_PROGRAM", "")
        }
        "with_swapped_operands" => bodies(Vec::from_iter(ways::with_swapped_operands(&program))),
        "with_measured_text" => {
            let units = |at: usize| Vec::from_iter(inputs[at].encode_utf16());
            let found = forms::with_measured_text(&program, "s", (&units(1), &units(2)));
            bodies(found.into_iter().map(|(program, _)| program).collect())
        }
        "brings_in" => yes(question::brings_in(
            &BTreeSet::from([inputs[2].clone()]),
            (&text, &whole(&inputs[1])),
            &ANY,
        )),
        "turned_round" => bodies(Vec::from_iter(ways::turned_round(&program))),
        "with_variables_for_literals" => lines(Vec::from_iter(ways::with_variables_for_literals(&program))),
        "with_variable_for_bit" => lines(forms::with_variable_for_bit(&program)),
        "with_fitting_operand" => lines(forms::with_fitting_operand(&program)),
        "with_first_parts" => bodies(forms::with_first_parts(&program)),
        "with_plainer_type" => lines(forms::with_plainer_type(&program)),
        "first_plainer_type" => lines(forms::with_plainer_type(&program).into_iter().take(1).collect()),
        "with_same_types" => lines(forms::with_same_types(&program)),
        "plainer_numbers" => bodies(
            plainness::plainer_numbers(&program)
                .iter()
                .map(|one| one.apply(&text))
                .collect(),
        ),
        "value_features" => joined(plainness::value_features(&program)),
        "has_first_bit" => yes(patterns::has_first_bit(&program)),
        "leaves_range" => yes(patterns::leaves_range(&program, &deviation())),
        "number_pattern" => patterns::number_pattern(&program, &deviation())
            .unwrap_or_default()
            .to_owned(),
        _ => panic!("nobody asks `{question}`"),
    }
}

#[test]
fn the_parts_of_a_program_are_found_as_the_tables_say() {
    let tables: BTreeMap<String, Vec<Vec<String>>> =
        toml::from_str(include_str!("tables.toml")).expect("tables");
    let mut failures = Vec::new();
    for (question, row) in tables
        .iter()
        .flat_map(|(question, rows)| rows.iter().map(move |row| (question, row)))
    {
        let (expected, inputs) = row.split_last().expect("an answer");
        // The function and the block that some programs of the tables use.
        let mut inputs = inputs.to_vec();
        if matches!(
            question.as_str(),
            "computation" | "unimplemented" | "with_one_statement" | "described"
        ) {
            inputs[0] = format!("{}{}", include_str!("units.st"), whole(&inputs[0]));
        }
        let found = answer(question, &inputs);
        if found != *expected {
            failures.push(format!(
                "{question}: {}\n  is {found:?}\n  not {expected:?}",
                row[0]
            ));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn each_piece_of_work_has_features_of_the_list() {
    let features = Features::built_in();
    let unknown = WORKS.keys().filter(|key| features.get(key).is_none());
    assert_eq!(Vec::from_iter(unknown), [""; 0]);
}

#[test]
fn the_lines_of_facts_are_those_of_the_program_without_blank_lines() {
    let fault = |line| Fact::Fault {
        fault: Fault::Subrange,
        line: Some(line),
    };
    let facts = [fault(5), fault(1), Fact::Accepted];
    assert_eq!(moved(&facts, &[4, 5, 6, 7]), [fault(2), fault(1), Fact::Accepted]);
}
