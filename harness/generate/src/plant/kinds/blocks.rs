//! Calls of function blocks, and arguments of VAR_IN_OUT.

use super::super::fault_site::{FaultSite, PLANTED, literal, literal_text};
use super::super::scope::{elementary, places, types};
use super::super::walk::{ExpressionContext, ExpressionSite};
use super::constants;
use super::misfits::never;
use crate::model::{
    Argument, BinaryOperator, Expression, ExpressionKind, InitialValue, Pou, Program, Statement, Type, Unit,
    VariableId, VariableSection,
};
use stickler_exact::implicit;
use stickler_types::{ElementaryType, MatrixWord};

/// Returns the function block of an instance.
fn block_of(program: &Program, unit: Unit, instance: VariableId) -> Option<&Pou> {
    match unit.variables(program).get(instance.0)?.ty {
        Type::Block(block) => program.blocks.get(block),
        _ => None,
    }
}

/// Returns the variables of a function block that a call neither gives nor takes.
fn inner(block: &Pou) -> Vec<VariableId> {
    let variables = block.variables.iter().enumerate();
    variables
        .filter(|(_, variable)| {
            matches!(
                variable.section,
                VariableSection::Local | VariableSection::Constant
            )
        })
        .map(|(number, _)| VariableId(number))
        .collect()
}

/// Returns whether a statement calls an instance of a function block that has such inner variables.
fn calls_one_with_inner(program: &Program, unit: Unit, kind: &Statement) -> bool {
    match kind {
        Statement::Invoke { instance, .. } => {
            block_of(program, unit, *instance).is_some_and(|block| !inner(block).is_empty())
        }
        _ => false,
    }
}

/// Plants a value for a parameter that is no input of the function block.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn unknown_input(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let has_inner = |unit, kind: &Statement| calls_one_with_inner(original, unit, kind);
    fault.change_statement(has_inner, |fault, unit, kind| {
        let Statement::Invoke { instance, inputs, .. } = kind else {
            return None;
        };
        let parameter = fault.choose(inner(block_of(original, unit, *instance)?))?;
        inputs.push(Argument {
            parameter,
            value: literal(ElementaryType::Int),
        });
        Some(())
    })
}

/// Plants an input that is given twice.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn input_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let has_inputs =
        |_, kind: &Statement| matches!(kind, Statement::Invoke { inputs, .. } if !inputs.is_empty());
    fault.change_statement(has_inputs, |fault, _, kind| {
        let Statement::Invoke { inputs, .. } = kind else {
            return None;
        };
        let again = fault.choose(inputs.clone())?;
        inputs.push(again);
        Some(())
    })
}

/// Plants a place that takes a variable that is no output.
///
/// Basis: ironplc-problem-codes: P4004.
pub(super) fn unknown_output(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let has_inner = |unit, kind: &Statement| calls_one_with_inner(original, unit, kind);
    fault.change_statement(has_inner, |fault, unit, kind| {
        let Statement::Invoke {
            instance, outputs, ..
        } = kind
        else {
            return None;
        };
        let output = fault.choose(inner(block_of(original, unit, *instance)?))?;
        let taker = fault.place(unit, |place, writable| {
            writable && elementary(original, &place.ty).is_some()
        })?;
        outputs.push((output, taker));
        Some(())
    })
}

/// Plants a place that takes an output of a type that does not convert to its own.
///
/// Basis: rule: code-of-the-context (`=>` capture: P4035).
pub(super) fn output_taken(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let dialect = original.dialect;
    let takes =
        |_, kind: &Statement| matches!(kind, Statement::Invoke { outputs, .. } if !outputs.is_empty());
    fault.change_statement(takes, |fault, unit, kind| {
        let Statement::Invoke {
            instance, outputs, ..
        } = kind
        else {
            return None;
        };
        let which = fault.choose((0..outputs.len()).collect())?;
        let (output, taker) = outputs.get_mut(which)?;
        let given = &block_of(original, unit, *instance)?.variables.get(output.0)?.ty;
        let given = elementary(original, given)?;
        *taker = fault.place(unit, |place, writable| {
            writable && elementary(original, &place.ty).is_some_and(|into| never(given, into, dialect))
        })?;
        Some(())
    })
}

/// Plants arguments by position, one more than the function block has inputs.
///
/// Basis: ironplc-problem-codes: P4003.
pub(super) fn too_many_by_position(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, unit| {
        let original = fault.original;
        let instances = unit
            .variables(original)
            .iter()
            .filter_map(|variable| match variable.ty {
                Type::Block(block) => Some((variable, literals(original.blocks.get(block)?)?)),
                _ => None,
            });
        let (instance, mut arguments) = fault.choose(instances.collect())?;
        arguments.push("TRUE".to_owned());
        Some(format!("{}({});", instance.name, arguments.join(", ")))
    })
}

/// Returns literals for the inputs of a function block; `None` if an input is not elementary, or an in-out needs a variable.
fn literals(block: &Pou) -> Option<Vec<String>> {
    let needed = block
        .variables
        .iter()
        .filter(|variable| matches!(variable.section, VariableSection::Input | VariableSection::InOut));
    needed
        .map(|variable| match (variable.section, &variable.ty) {
            (VariableSection::Input, Type::Elementary(ty)) => Some(literal_text(*ty)),
            _ => None,
        })
        .collect()
}

/// Picks an argument of a VAR_IN_OUT that has an elementary type: returns its number, its place, a copy of it, and its type.
fn in_out(fault: &mut FaultSite<'_, '_>) -> Option<(usize, ExpressionSite, Expression, ElementaryType)> {
    let original = fault.original;
    let (number, site, expression) = fault.pick_expression(|site, expression| {
        site.context == ExpressionContext::InOut && elementary(original, &expression.ty).is_some()
    })?;
    let ty = elementary(original, &expression.ty)?;
    Some((number, site, expression, ty))
}

/// Plants an expression other than a variable as argument of a VAR_IN_OUT.
///
/// Basis: language/diagnostics-calls.st.
pub(super) fn no_variable(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let (number, _, expression, ty) = in_out(fault)?;
    let sum = ty.is_integer() && fault.input.ratio(1, 2).unwrap_or(false);
    let kind = match sum {
        true => ExpressionKind::Binary(BinaryOperator::Add, Box::new(expression), Box::new(literal(ty))),
        false => literal(ty).kind,
    };
    fault.replace(number, kind)
}

/// Plants a variable of another type, also one that widens elsewhere, as argument of a VAR_IN_OUT.
///
/// Basis: language/diagnostics-calls.st; widening/in-out.toml.
pub(super) fn other_type(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let (number, site, _, own) = in_out(fault)?;
    // A type that would widen as an input is the error that is easiest to overlook.
    let widening = fault.input.ratio(1, 2).unwrap_or(true);
    let yes = |ty| implicit(ty, own, original.dialect) == MatrixWord::Yes;
    let wrong: Vec<_> = types(original.dialect)
        .filter(|&ty| ty != own && (!widening || yes(ty)))
        .collect();
    let others = places(original, site.unit).into_iter().filter(|named| {
        named.writable && elementary(original, &named.place.ty).is_some_and(|ty| wrong.contains(&ty))
    });
    let kind = match fault.choose(others.collect()) {
        Some(other) => ExpressionKind::Read(other.place),
        None => {
            let ty = fault.choose(wrong)?;
            fault.declare(site.unit, PLANTED, Type::Elementary(ty), VariableSection::Local)?;
            ExpressionKind::Raw(PLANTED.to_owned())
        }
    };
    fault.replace(number, kind)
}

/// Plants a constant as argument of a VAR_IN_OUT.
///
/// Basis: language/diagnostics-calls.st.
pub(super) fn constant(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let (number, site, expression, ty) = in_out(fault)?;
    // The initial value of the constant is an expression too, so that the others have new numbers behind it.
    fault.replace(number, ExpressionKind::Raw(PLANTED.to_owned()));
    let value = literal(ty);
    constants::declare(fault, site.unit, expression.ty, InitialValue::Expression(value)).map(|_| ())
}
