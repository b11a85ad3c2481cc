//! Calls of function blocks, and arguments of VAR_IN_OUT.

use super::super::fault_site::{FaultSite, PLANTED, literal, literal_text};
use super::super::scope::{elementary, places, types};
use super::super::walk::{ExpressionContext, ExpressionSite};
use super::constants;
use super::misfits::never;
use crate::model::{
    Argument, BinaryOperator, Expression, ExpressionKind, InitialValue, Place, Pou, Program, Statement, Type,
    Unit, VariableId, VariableSection,
};
use stickler_exact::implicit;
use stickler_types::{Dialect, ElementaryType, MatrixWord};

/// The outputs that a call takes, and their places.
type Outputs = Vec<(VariableId, Place)>;

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
            // Those of the standard have others in each system.
            !block.standard
                && matches!(
                    variable.section,
                    VariableSection::Local | VariableSection::Constant
                )
        })
        .map(|(number, _)| VariableId(number))
        .collect()
}

fn has_inner(block: &Pou, _: usize, _: usize) -> bool {
    !inner(block).is_empty()
}

/// Changes a call of a function block, of which `fits` takes the block and the numbers of inputs and outputs.
fn change_call(
    fault: &mut FaultSite<'_, '_>,
    fits: impl Fn(&Pou, usize, usize) -> bool,
    change: impl FnOnce(&mut FaultSite<'_, '_>, Unit, &Pou, &mut Vec<Argument>, &mut Outputs) -> Option<()>,
) -> Option<()> {
    let original = fault.original;
    let fits = |unit, statement: &Statement| match statement {
        Statement::Invoke {
            instance,
            inputs,
            outputs,
        } => {
            block_of(original, unit, *instance).is_some_and(|block| fits(block, inputs.len(), outputs.len()))
        }
        _ => false,
    };
    fault.change_statement(fits, |fault, unit, statement| match statement {
        Statement::Invoke {
            instance,
            inputs,
            outputs,
        } => change(fault, unit, block_of(original, unit, *instance)?, inputs, outputs),
        _ => None,
    })
}

/// Plants a value for a parameter that is no input of the function block.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn unknown_input(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    change_call(fault, has_inner, |fault, _, block, inputs, _| {
        let parameter = fault.choose(inner(block))?;
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
    let has_inputs = |_: &Pou, inputs, _| inputs > 0;
    change_call(fault, has_inputs, |fault, _, _, inputs, _| {
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
    change_call(fault, has_inner, |fault, unit, block, _, outputs| {
        let output = fault.choose(inner(block))?;
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
    let has_outputs = |_: &Pou, _, outputs| outputs > 0;
    change_call(fault, has_outputs, |fault, unit, block, _, outputs| {
        let which = fault.choose((0..outputs.len()).collect())?;
        let (output, taker) = outputs.get_mut(which)?;
        let given = elementary(original, &block.variables.get(output.0)?.ty)?;
        *taker = fault.place(unit, |place, writable| {
            writable && elementary(original, &place.ty).is_some_and(|into| never(given, into, dialect))
        })?;
        Some(())
    })
}

/// Plants arguments by position, one more than the function block has inputs, where they are not for outputs.
///
/// Basis: ironplc-problem-codes: P4003.
pub(super) fn too_many_by_position(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, unit| {
        let original = fault.original;
        let instances = unit
            .variables(original)
            .iter()
            .filter(|_| !Dialect::of(original.dialect).outputs_by_position)
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
