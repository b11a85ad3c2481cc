//! Calls of functions with arguments too many, too few, twice, or by unknown names; and recursive calls.

use super::super::fault_site::{FaultSite, PLANTED, literal, literal_text};
use super::super::scope::{elementary, types, written};
use super::super::walk::ExpressionSite;
use super::misfits::converts;
use super::operands::stands_for_any_value;
use crate::model::{
    Argument, AssignmentTarget, Expression, ExpressionKind, Pou, Program, StandardFunction, Statement, Type,
    Unit, Variable, VariableId, VariableSection,
};
use stickler_types::{Dialect, ElementaryType};

/// Plants one argument more than the function has inputs; the style must write positional arguments.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn argument_too_many(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    // A call that omits inputs has named arguments.
    let functions = &fault.original.functions;
    let gives_all = |function: usize, arguments: &[Argument]| {
        let called = functions.get(function);
        called.is_some_and(|called| called.inputs().count() == arguments.len())
    };
    let (number, ..) = fault.pick_expression(|_, expression| {
        matches!(&expression.kind, ExpressionKind::Call(function, arguments) if gives_all(*function, arguments))
    })?;
    fault.change(number, |call| {
        if let ExpressionKind::Call(_, arguments) = &mut call.kind {
            arguments.push(Argument {
                parameter: VariableId(arguments.len()),
                value: literal(ElementaryType::Int),
            });
        }
    });
    Some(())
}

/// Plants a call of a standard function with one argument more or less than it has parameters.
///
/// Basis: ironplc-problem-codes: P4018; iec-61131-3: Tables 28 to 34.
pub(super) fn standard_argument(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let (number, ..) =
        fault.pick_expression(|_, expression| matches!(expression.kind, ExpressionKind::Standard(..)))?;
    let fewer = fault.input.ratio(1, 2).unwrap_or(true);
    fault.change(number, |call| {
        if let ExpressionKind::Standard(function, arguments) = &mut call.kind {
            if takes_any_number(*function) {
                arguments.truncate(1);
            } else if fewer {
                arguments.pop();
            } else {
                let last = arguments.last().cloned();
                arguments.extend(last);
            }
        }
    });
    Some(())
}

/// Returns whether a function takes any number of arguments from two, so that only one argument is too few.
const fn takes_any_number(function: StandardFunction) -> bool {
    matches!(
        function,
        StandardFunction::Min | StandardFunction::Max | StandardFunction::Mux | StandardFunction::Concat
    )
}

/// Plants a conversion function with one argument too many, or with none; its result is of the type that the place expects.
///
/// Basis: conversion/bad-count.toml.
pub(super) fn conversion_argument(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let dialect = original.dialect;
    let sources = |expression: &Expression| {
        let into = written(expression);
        types(dialect)
            .filter(|&from| into.is_some_and(|into| from != into && converts(from, into, dialect)))
            .collect::<Vec<_>>()
    };
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        stands_for_any_value(site, expression) && written(expression).is_some()
    })?;
    let from = fault.choose(sources(&expression))?;
    let into = written(&expression)?;
    let argument = literal_text(from);
    // Where texts are written by a format, that is a second input.
    let takes = 1 + usize::from(into.is_text() && Dialect::of(dialect).format_strings);
    let arguments = fault.choose(vec![String::new(), vec![argument; takes + 1].join(", ")])?;
    fault.replace(
        number,
        ExpressionKind::Raw(format!("{from}_TO_{into}({arguments})")),
    )
}

/// Returns the inputs of a function with their elementary types.
fn inputs(function: &Pou) -> Vec<(&Variable, ElementaryType)> {
    let inputs = function.inputs();
    inputs
        .filter_map(|(_, variable)| match variable.ty {
            Type::Elementary(ty) => Some((variable, ty)),
            _ => None,
        })
        .collect()
}

/// Returns the functions whose inputs are all elementary, and whose arguments can be written as literals.
fn callable(program: &Program, unit: Unit) -> Vec<&Pou> {
    // A function calls only those before it; a call of itself or of a later one could be recursive.
    let before = match unit {
        Unit::Function(number) => number,
        Unit::Types => 0,
        Unit::Block(_) | Unit::Main => program.functions.len(),
    };
    let functions = program.functions.iter().take(before);
    functions
        .filter(|function| function.owner.is_none())
        .filter(|function| {
            let others = function.variables.iter();
            let needed = others.filter(|variable| {
                matches!(variable.section, VariableSection::Input | VariableSection::InOut)
            });
            !inputs(function).is_empty() && inputs(function).len() == needed.count()
        })
        .collect()
}

/// Replaces a value of the result type of a function by a call of it with these arguments, in which `{names}` stands for all arguments
/// by name, `{first}` for the first of them, `{others}` for the others, and `{value}` and `{fewer}` for the first and for all but the
/// last by position.
pub(super) fn call(fault: &mut FaultSite<'_, '_>, arguments: &str) -> Option<()> {
    let original = fault.original;
    let least = if arguments.contains("{others}") { 2 } else { 1 };
    let may_end_early = arguments == "{fewer}" && Dialect::of(original.dialect).outputs_by_position;
    let fitting = |site: ExpressionSite, expression: &Expression| {
        // An implicitly converted value has another type than its place.
        let own = !matches!(expression.kind, ExpressionKind::Widen(_));
        let functions = callable(original, site.unit).into_iter();
        // Where outputs are given by position, a last input with an initial value may be left out.
        let needs_last = |inputs: &[(&Variable, ElementaryType)]| {
            let last = inputs.last();
            !may_end_early || last.is_some_and(|(last, _)| last.initial.is_none())
        };
        let suits = |function: &&Pou| {
            let inputs = inputs(function);
            own && function.result.as_ref() == Some(&expression.ty)
                && inputs.len() >= least
                && needs_last(&inputs)
        };
        functions.filter(suits).collect::<Vec<_>>()
    };
    let (number, site, expression) = fault.pick_expression(|site, expression| {
        stands_for_any_value(site, expression) && !fitting(site, expression).is_empty()
    })?;
    let function = fault.choose(fitting(site, &expression))?;
    let inputs = inputs(function).into_iter();
    let (names, values): (Vec<String>, Vec<String>) = inputs
        .map(|(variable, ty)| {
            (
                format!("{} := {}", variable.name, literal_text(ty)),
                literal_text(ty),
            )
        })
        .unzip();
    let ((first, others), (_, fewer)) = (names.split_first()?, values.split_last()?);
    let arguments = arguments
        .replace("{names}", &names.join(", "))
        .replace("{first}", first)
        .replace("{others}", &others.join(", "))
        .replace("{value}", values.first()?)
        .replace("{fewer}", &fewer.join(", "));
    let text = format!("{}({arguments})", function.name);
    fault.replace(number, ExpressionKind::Raw(text))
}

/// Plants a function that calls itself.
///
/// Basis: language/diagnostics-recursion.st (the call is the line).
pub(super) fn recursive_function(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let callable = callable(original, Unit::Main);
    let numbers = (0..original.functions.len()).filter(|&number| {
        let function = &original.functions[number];
        let result = function.result.as_ref();
        result.is_some_and(|ty| elementary(original, ty).is_some()) && callable.contains(&function)
    });
    let number = fault.choose(numbers.collect())?;
    let function = fault.program.functions.get_mut(number)?;
    let arguments = function
        .inputs()
        .filter_map(|(parameter, variable)| match variable.ty {
            Type::Elementary(ty) => Some(Argument {
                parameter,
                value: literal(ty),
            }),
            _ => None,
        });
    let value = Expression::new(
        function.result.clone()?,
        ExpressionKind::Call(number, arguments.collect()),
    );
    let at = fault.input.int_in_range(0..=function.body.len()).unwrap_or(0);
    let kind = Statement::Assign(AssignmentTarget::Result, value);
    function.body.insert(at, kind);
    Some(())
}

/// Plants a function block that holds an instance of itself.
///
/// Basis: ironplc-problem-codes: P4005.
pub(super) fn recursive_block(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let blocks = fault.original.blocks.iter().enumerate();
    let own = blocks.filter(|(_, block)| !block.standard);
    let (number, block) = fault.choose(own.collect())?;
    fault.declare_text(
        Unit::Block(number),
        &format!("{PLANTED}_own : {}", block.name),
        VariableSection::Local,
    )
}
