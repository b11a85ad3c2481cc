//! Names that nothing has, that two things have, or that stand for something else.

use super::super::plot::{PLANTED, Plot};
use super::super::scope::elementary;
use super::super::walk::Context;
use super::operands::stands_for_any_value;
use crate::model::{Declared, Expression, ExpressionKind, Program, Section, Type, TypeDeclaration, Unit};
use stickler_types::ElementaryType;

/// A variable that is not declared, somewhere in the place of a value.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn variable_read(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    // In the place of an enumerated value the name could be that of a value, too.
    let (number, ..) = plot.site(|site, expression| {
        let in_out = site.context == Context::InOut;
        (in_out || stands_for_any_value(site, expression))
            && original.enumerated_values(&expression.ty).is_none()
    })?;
    plot.replace(number, ExpressionKind::Raw(PLANTED.to_owned()));
    Some(())
}

/// A variable that is not declared, assigned.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn variable_assigned(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    plot.insert_text(|plot, _| {
        let values = ["1", "TRUE", "1.5", "INT#7 + INT#8", "NOT FALSE"];
        let value = plot.choose(values.to_vec())?;
        Some(format!("{PLANTED} := {value};"))
    })
}

/// A field that the structure does not have, or a variable that is no output of the function block.
///
/// Basis: ironplc-problem-codes: P4007.
pub(super) fn field(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, site, _) = plot.site(|site, expression| {
        stands_for_any_value(site, expression)
            && original.enumerated_values(&expression.ty).is_none()
            && site
                .unit
                .variables(original)
                .iter()
                .any(|variable| has_fields(original, &variable.ty))
    })?;
    let variables = site.unit.variables(original).iter();
    let names = variables
        .filter(|variable| has_fields(original, &variable.ty))
        .map(|variable| &variable.name)
        .collect();
    let name = plot.choose(names)?;
    plot.replace(number, ExpressionKind::Raw(format!("{name}.{PLANTED}")));
    Some(())
}

fn has_fields(program: &Program, ty: &Type) -> bool {
    program.fields(ty).is_some() || matches!(ty, Type::Block(_))
}

/// A function that is not declared, somewhere in the place of a value.
///
/// Basis: language/diagnostics-names.st; conversion/bad-name.toml.
pub(super) fn function(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let (number, ..) = plot.site(stands_for_any_value)?;
    let names = ["PLANTED", "INT_TO_DNIT", "TO_DIMT", "BDC_TO_INT", "ITN_TO_REAL"];
    let name = plot.choose(names.to_vec())?;
    let arguments = plot.choose(vec!["INT#1", "BOOL#TRUE", "INT#1, DINT#2", "(INT#3 + INT#4)"])?;
    plot.replace(number, ExpressionKind::Raw(format!("{name}({arguments})")));
    Some(())
}

/// A call of a variable that is no instance of a function block.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn no_instance(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    plot.insert_text(|plot, unit| {
        let types = [ElementaryType::Int, ElementaryType::Bool, ElementaryType::Real];
        let ty = plot.choose(types.to_vec())?;
        let name = plot.variable_text(unit, ty)?;
        let arguments = plot.choose(vec!["", "x := 1"])?;
        Some(format!("{name}({arguments});"))
    })
}

/// A value that the enumeration does not have, with the enumeration's name in front of it.
///
/// Basis: ironplc-problem-codes: P2006.
pub(super) fn enumerated_value(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, _, expression) = plot.site(|_, expression| is_enumerated(original, expression))?;
    let Type::Declared(declared) = expression.ty else {
        return None;
    };
    let name = &original.types.get(declared)?.name;
    plot.replace(number, ExpressionKind::Raw(format!("{name}#{PLANTED}")));
    Some(())
}

fn is_enumerated(program: &Program, expression: &Expression) -> bool {
    matches!(expression.kind, ExpressionKind::Enumerated(_))
        && program.enumerated_values(&expression.ty).is_some()
}

/// A value of another enumeration.
///
/// Basis: widening/user-defined.toml.
pub(super) fn other_enumeration(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let others = |expression: &Expression| {
        let declared = original.types.iter().enumerate();
        declared
            .filter(|(number, declaration)| {
                matches!(declaration.kind, Declared::Enumeration(_))
                    && expression.ty != Type::Declared(*number)
            })
            .map(|(_, declaration)| declaration)
            .collect::<Vec<_>>()
    };
    let (number, _, expression) = plot.site(|site, expression| {
        site.context == Context::Assigned
            && original.enumerated_values(&expression.ty).is_some()
            && !others(expression).is_empty()
    })?;
    let TypeDeclaration {
        name,
        kind: Declared::Enumeration(values),
    } = plot.choose(others(&expression))?
    else {
        return None;
    };
    let value = plot.choose(values.iter().collect())?;
    plot.replace(number, ExpressionKind::Raw(format!("{name}#{value}")));
    Some(())
}

/// A literal whose prefix is no enumeration.
///
/// Basis: ironplc-problem-codes: P2004.
pub(super) fn enumeration(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let (number, ..) = plot.site(stands_for_any_value)?;
    plot.replace(number, ExpressionKind::Raw(format!("{PLANTED}#Red")));
    Some(())
}

/// A type that is not declared.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn type_name(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let unit = plot.unit()?;
    let types = ["NO_SUCH_TYPE", "ARRAY[1..2] OF NO_SUCH_TYPE"];
    let ty = plot.choose(types.to_vec())?;
    plot.declare_text(unit, &format!("{PLANTED}_type : {ty}"), Section::Local)
}

/// A variable that is declared twice.
///
/// Basis: language/diagnostics-names.st (the second declaration, whatever its case and type).
pub(super) fn variable_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let unit = plot.unit()?;
    let variables = unit.variables(plot.original).iter().collect();
    let variable = plot.choose(variables)?;
    let name = other_case(&variable.name)?;
    let ty = plot.choose(vec!["INT", "BOOL", "REAL"])?;
    plot.declare_text(unit, &format!("{name} : {ty}"), Section::Local)
}

/// The same name in another case, so that the second declaration is not the first one's text.
fn other_case(name: &str) -> Option<String> {
    let names = [name.to_ascii_uppercase(), name.to_ascii_lowercase()];
    names.into_iter().find(|other| other != name)
}

/// A function that is declared twice.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn function_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let mut function = plot.choose(plot.original.functions.iter().collect())?.clone();
    function.name = other_case(&function.name)?;
    plot.mark = Some(format!(" {} : ", function.name));
    plot.program.functions.push(function);
    Some(())
}

/// A function block that is declared twice.
///
/// Basis: ironplc-problem-codes: P4013.
pub(super) fn block_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let mut block = plot.choose(plot.original.blocks.iter().collect())?.clone();
    block.name = other_case(&block.name)?;
    plot.mark = Some(format!(" {}", block.name));
    plot.program.blocks.push(block);
    Some(())
}

/// A function with the name of a type, or a function block with that of a function.
///
/// Basis: ironplc-problem-codes: P4011.
pub(super) fn two_kinds_of_one_name(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    if let Some(block) = original.blocks.last()
        && let Some(function) = plot.choose(original.functions.iter().collect())
    {
        let mut block = block.clone();
        block.name = other_case(&function.name)?;
        plot.mark = Some(format!(" {}", block.name));
        plot.program.blocks.push(block);
        return Some(());
    }
    let mut function = original.functions.last()?.clone();
    let declaration = plot.choose(original.types.iter().collect())?;
    function.name = other_case(&declaration.name)?;
    plot.mark = Some(format!(" {} : ", function.name));
    plot.program.functions.push(function);
    Some(())
}

/// A type that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn type_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let declaration = plot.choose(plot.original.types.iter().collect())?;
    let name = other_case(&declaration.name)?;
    plot.mark = Some(format!("{name} : "));
    plot.program.types.push(TypeDeclaration {
        name,
        kind: Declared::Alias(Type::Elementary(ElementaryType::Int)),
    });
    Some(())
}

/// A field that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn field_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared_twice(plot, |kind, mark| {
        let Declared::Structure(fields) = kind else {
            return None;
        };
        let name = other_case(&fields.last()?.0)?;
        *mark = Some(format!("{name} : "));
        fields.push((name, Type::Elementary(ElementaryType::Bool), None));
        Some(())
    })
}

/// An enumerated value that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn enumerated_value_twice(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared_twice(plot, |kind, mark| {
        let Declared::Enumeration(values) = kind else {
            return None;
        };
        let name = other_case(values.first()?)?;
        *mark = Some(format!("{name})"));
        values.push(name);
        Some(())
    })
}

/// Changes one of the declared types that can be changed.
fn declared_twice(
    plot: &mut Plot<'_, '_, '_>,
    change: impl Fn(&mut Declared, &mut Option<String>) -> Option<()>,
) -> Option<()> {
    let numbers = 0..plot.original.types.len();
    let possible = numbers.filter(|&number| {
        let mut tried = plot.original.types[number].kind.clone();
        change(&mut tried, &mut None).is_some()
    });
    let number = plot.choose(possible.collect())?;
    change(&mut plot.program.types.get_mut(number)?.kind, &mut plot.mark)
}

/// An initial value that names what is not declared.
///
/// Basis: ironplc-problem-codes: P4007.
pub(super) fn initial(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let (number, ..) = plot.site(|site, expression| {
        site.context == Context::Initial
            && site.unit != Unit::Types
            && elementary(original, &expression.ty).is_some()
    })?;
    plot.replace(number, ExpressionKind::Raw(PLANTED.to_owned()));
    Some(())
}
