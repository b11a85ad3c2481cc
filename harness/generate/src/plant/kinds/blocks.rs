//! Calls of function blocks, and arguments of VAR_IN_OUT.

use super::super::plot::{PLANTED, Plot, literal, literal_text};
use super::super::scope::{elementary, places, types};
use super::super::walk::Context;
use super::constants;
use super::misfits::never;
use crate::model::{
    Argument, BinaryOperator, Block, ExpressionKind, Initial, Program, Section, StatementKind, Type, Unit,
    VariableId,
};
use stickler_exact::implicit;
use stickler_types::{ElementaryType, MatrixWord};

/// The function block of an instance.
fn block_of(program: &Program, unit: Unit, instance: VariableId) -> Option<&Block> {
    match unit.variables(program).get(instance.0)?.ty {
        Type::Block(block) => program.blocks.get(block),
        _ => None,
    }
}

/// The variables of a function block that are neither given nor taken in a call.
fn inner(block: &Block) -> Vec<VariableId> {
    let variables = block.variables.iter().enumerate();
    variables
        .filter(|(_, variable)| matches!(variable.section, Section::Local | Section::Constant))
        .map(|(number, _)| VariableId(number))
        .collect()
}

/// Whether a statement calls an instance of a function block with such variables.
fn calls_one_with_inner(program: &Program, unit: Unit, kind: &StatementKind) -> bool {
    match kind {
        StatementKind::Invoke { instance, .. } => {
            block_of(program, unit, *instance).is_some_and(|block| !inner(block).is_empty())
        }
        _ => false,
    }
}

/// A value for what is no input of the function block.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn unknown_input(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let has_inner = |unit, kind: &StatementKind| calls_one_with_inner(original, unit, kind);
    plot.change_statement(has_inner, |plot, unit, kind| {
        let StatementKind::Invoke { instance, inputs, .. } = kind else {
            return None;
        };
        let parameter = plot.choose(inner(block_of(original, unit, *instance)?))?;
        inputs.push(Argument {
            parameter,
            value: literal(ElementaryType::Int),
        });
        Some(())
    })
}

/// An input that is given twice.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn input_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let has_inputs =
        |_, kind: &StatementKind| matches!(kind, StatementKind::Invoke { inputs, .. } if !inputs.is_empty());
    plot.change_statement(has_inputs, |plot, _, kind| {
        let StatementKind::Invoke { inputs, .. } = kind else {
            return None;
        };
        let again = plot.choose(inputs.clone())?;
        inputs.push(again);
        Some(())
    })
}

/// A place that takes what is no output.
///
/// Basis: ironplc-problem-codes: P4004.
pub(super) fn unknown_output(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let has_inner = |unit, kind: &StatementKind| calls_one_with_inner(original, unit, kind);
    plot.change_statement(has_inner, |plot, unit, kind| {
        let StatementKind::Invoke {
            instance, outputs, ..
        } = kind
        else {
            return None;
        };
        let output = plot.choose(inner(block_of(original, unit, *instance)?))?;
        let taker = plot.place(unit, |place, writable| {
            writable && elementary(original, &place.ty).is_some()
        })?;
        outputs.push((output, taker));
        Some(())
    })
}

/// A place that takes an output of a type that does not convert to its own.
///
/// Basis: stickler-design: §7 (`=>` capture: P4035).
pub(super) fn output_taken(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let dialect = original.dialect;
    let takes = |_, kind: &StatementKind| matches!(kind, StatementKind::Invoke { outputs, .. } if !outputs.is_empty());
    plot.change_statement(takes, |plot, unit, kind| {
        let StatementKind::Invoke {
            instance, outputs, ..
        } = kind
        else {
            return None;
        };
        let which = plot.choose((0..outputs.len()).collect())?;
        let (output, taker) = outputs.get_mut(which)?;
        let given = &block_of(original, unit, *instance)?.variables.get(output.0)?.ty;
        let given = elementary(original, given)?;
        *taker = plot.place(unit, |place, writable| {
            writable && elementary(original, &place.ty).is_some_and(|into| never(given, into, dialect))
        })?;
        Some(())
    })
}

/// Arguments by position, one more than the function block has inputs.
///
/// Basis: ironplc-problem-codes: P4003.
pub(super) fn too_many_by_position(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    plot.insert_text(|plot, unit| {
        let original = plot.original;
        let instances = unit
            .variables(original)
            .iter()
            .filter_map(|variable| match variable.ty {
                Type::Block(block) => Some((variable, literals(original.blocks.get(block)?)?)),
                _ => None,
            });
        let (instance, mut arguments) = plot.choose(instances.collect())?;
        arguments.push("TRUE".to_owned());
        Some(format!("{}({});", instance.name, arguments.join(", ")))
    })
}

/// Literals for the inputs of a function block; nothing where an input is not elementary, or a variable is needed.
fn literals(block: &Block) -> Option<Vec<String>> {
    let needed = block
        .variables
        .iter()
        .filter(|variable| matches!(variable.section, Section::Input | Section::InOut));
    needed
        .map(|variable| match (variable.section, &variable.ty) {
            (Section::Input, Type::Elementary(ty)) => Some(literal_text(*ty)),
            _ => None,
        })
        .collect()
}

/// What is no variable, passed to a VAR_IN_OUT.
///
/// Basis: language/diagnostics-calls.st.
pub(super) fn no_variable(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, _, expression) = plot.site(|site, expression| {
        site.context == Context::InOut && elementary(original, &expression.ty).is_some()
    })?;
    let ty = elementary(original, &expression.ty)?;
    let sum = ty.is_integer() && plot.input.ratio(1, 2).unwrap_or(false);
    plot.replace(
        number,
        if sum {
            let one = Box::new(literal(ty));
            ExpressionKind::Binary(BinaryOperator::Add, Box::new(expression), one)
        } else {
            literal(ty).kind
        },
    );
    Some(())
}

/// A variable of another type, passed to a VAR_IN_OUT, also of one that widens elsewhere.
///
/// Basis: language/diagnostics-calls.st; widening/in-out.toml.
pub(super) fn other_type(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, site, expression) = plot.site(|site, expression| {
        site.context == Context::InOut && elementary(original, &expression.ty).is_some()
    })?;
    let own = elementary(original, &expression.ty)?;
    // What would widen as an input is the error that is easiest to overlook.
    let widening = plot.input.ratio(1, 2).unwrap_or(true);
    let yes = |ty| implicit(ty, own, original.dialect) == MatrixWord::Yes;
    let wrong: Vec<_> = types(original.dialect)
        .filter(|&ty| ty != own && (!widening || yes(ty)))
        .collect();
    let others = places(original, site.unit).into_iter().filter(|named| {
        named.writable && elementary(original, &named.place.ty).is_some_and(|ty| wrong.contains(&ty))
    });
    let kind = match plot.choose(others.collect()) {
        Some(other) => ExpressionKind::Read(other.place),
        None => {
            let ty = plot.choose(wrong)?;
            plot.declare(site.unit, PLANTED, Type::Elementary(ty), Section::Local)?;
            ExpressionKind::Raw(PLANTED.to_owned())
        }
    };
    plot.replace(number, kind);
    Some(())
}

/// A constant, passed to a VAR_IN_OUT.
///
/// Basis: language/diagnostics-calls.st.
pub(super) fn constant(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, site, expression) = plot.site(|site, expression| {
        site.context == Context::InOut && elementary(original, &expression.ty).is_some()
    })?;
    // The initial value of the constant is an expression too, so that the others have new numbers behind it.
    plot.replace(number, ExpressionKind::Raw(PLANTED.to_owned()));
    let value = literal(elementary(original, &expression.ty)?);
    constants::declare(plot, site.unit, expression.ty, Initial::Expression(value)).map(|_| ())
}
