//! Tests of variants: their values against the evaluator, which knows nothing of texts, and their texts against their
//! descriptions.

use super::*;
use crate::evaluate::evaluate;
use crate::evaluate::tests as hand;
use crate::generator::{GeneratorSettings, program};
use crate::model::*;
use crate::random::Random;
use crate::writer::{Style, write};
use arbitrary::Unstructured;
use stickler_types::ElementaryType::{Bool, Byte, Dint, Int};
use stickler_types::Value;

/// Returns pseudorandom bytes of a length that makes a program of some size.
fn bytes(seed: u64) -> Vec<u8> {
    crate::random::bytes(seed, 600)
}

fn made(seed: u64) -> Program {
    program(
        &mut Unstructured::new(&bytes(seed)),
        &GeneratorSettings::default(),
    )
}

/// Returns the values that `other`, which has the variables of `original` and more, gives for everything observed of
/// `original`.
fn values_in(other: &Program, original: &Program) -> Option<Vec<(String, Value)>> {
    let evaluation = evaluate(other, 1).ok()?;
    let observed = original.observed();
    let kept = |path: &str| observed.iter().any(|(name, _)| name == path);
    Some(
        evaluation
            .values
            .into_iter()
            .filter(|(path, _)| kept(path))
            .collect(),
    )
}

/// Creates a program with something for every variant: loops of each kind, a bit, an implicit conversion, a call, both sides
/// of an IF.
pub(crate) fn everything() -> Program {
    let one_more = |id| hand::binary(BinaryOperator::Add, hand::read(id, Int), hand::literal("INT#1"));
    let count = |id| hand::set(id, Int, one_more(id));
    let compared = |operator, id| Expression {
        ty: Type::Elementary(Bool),
        ..hand::binary(operator, hand::read(id, Int), untyped("INT#4"))
    };
    let below = |id| compared(BinaryOperator::Less, id);
    let call = hand::of(
        Int,
        ExpressionKind::Call(
            0,
            vec![
                Argument {
                    parameter: VariableId(0),
                    value: one_more(1),
                },
                Argument {
                    parameter: VariableId(1),
                    value: hand::literal("INT#7"),
                },
            ],
        ),
    );
    let widened = hand::of(Dint, ExpressionKind::Widen(Box::new(call)));
    let body = vec![
        hand::statement(StatementKind::For {
            variable: VariableId(0),
            from: untyped("INT#-1"),
            to: untyped("INT#3"),
            by: Some(untyped("INT#2")),
            body: vec![count(1)],
        }),
        hand::set(0, Int, hand::literal("INT#0")),
        hand::statement(StatementKind::While(below(0), vec![count(0)])),
        hand::statement(StatementKind::Repeat(
            vec![count(1)],
            compared(BinaryOperator::Greater, 1),
        )),
        hand::statement(StatementKind::If(
            vec![(below(1), vec![count(1)])],
            Some(vec![count(0)]),
        )),
        hand::set(2, Dint, widened),
        hand::statement(StatementKind::Assign(
            AssignmentTarget::Bit(hand::place(3, Vec::new(), Byte), 6),
            hand::literal("BOOL#TRUE"),
        )),
    ];
    let variables = vec![
        hand::local("i", Int, ""),
        hand::local("n", Int, "INT#5"),
        hand::local("wide", Dint, ""),
        hand::local("bits", Byte, ""),
    ];
    let mut made = hand::program(variables, body);
    let input = |name| hand::variable(name, Type::Elementary(Int), VariableSection::Input, None);
    made.functions.push(Function {
        name: "product".to_owned(),
        result: Type::Elementary(Int),
        variables: vec![input("a"), input("b")],
        body: vec![hand::statement(StatementKind::Assign(
            AssignmentTarget::Result,
            hand::binary(BinaryOperator::Multiply, hand::read(0, Int), hand::read(1, Int)),
        ))],
    });
    made
}

fn untyped(text: &str) -> Expression {
    let literal = hand::literal(text);
    match literal.kind {
        ExpressionKind::Literal(value, _) => Expression {
            kind: ExpressionKind::Literal(value, LiteralForm::Untyped),
            ..literal
        },
        _ => literal,
    }
}

type VariantChange = fn(&mut Program, &mut Random<'_, '_>) -> usize;

#[test]
fn what_changes_the_model_changes_no_value() {
    let changes: [(&str, VariantChange); 7] = [
        ("hoist", literals::hoist),
        ("type_all", literals::type_all),
        ("swap", operands::swap),
        ("split", operands::split),
        ("unroll", loops::unroll),
        ("insert", dead_code::insert),
        ("branches", branches::swap),
    ];
    for (name, change) in changes {
        let mut changed = 0;
        for seed in 0..200 {
            let original = if seed % 20 == 0 { everything() } else { made(seed) };
            let mut other = original.clone();
            let choices = bytes(seed + 1_000_000);
            changed += change(&mut other, &mut Random::new(&mut Unstructured::new(&choices)));
            let expected = values_in(&original, &original);
            assert!(expected.is_some(), "seed {seed} has values");
            assert_eq!(
                values_in(&other, &original),
                expected,
                "{name} of seed {seed}:\n{}\nof\n{}",
                write(&other, &Style::default()).text,
                write(&original, &Style::default()).text
            );
        }
        assert!(changed > 0, "{name} finds something to change");
    }
}

#[test]
fn every_variant_has_another_text_for_a_program_that_has_everything() {
    for variant in Variant::ALL {
        let varied =
            (0..20).filter_map(|seed| variant.text(&everything(), &mut Unstructured::new(&bytes(seed))));
        let canonical = write(&everything(), &Style::default()).text;
        assert!(
            varied.filter(|text| *text != canonical).count() > 0,
            "{}",
            variant.name()
        );
    }
}

#[test]
fn names_of_variants_are_distinct() {
    let mut names: Vec<&str> = Variant::ALL.iter().map(|variant| variant.name()).collect();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), Variant::ALL.len());
}

#[test]
fn the_case_of_letters_changes_outside_of_texts_only() {
    let mut original = everything();
    let said = hand::local("said", stickler_types::ElementaryType::String, "STRING#'a$'b$$'");
    original.main.variables.push(said);
    let canonical = write(&original, &Style::default()).text;
    let varied = Variant::Capitals
        .text(&original, &mut Unstructured::new(&bytes(5)))
        .unwrap();
    assert_ne!(varied, canonical);
    assert!(varied.eq_ignore_ascii_case(&canonical));
    assert!(
        canonical.contains("'a$'b$$'") && varied.contains("'a$'b$$'"),
        "{varied}"
    );
}
