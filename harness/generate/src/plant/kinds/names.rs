//! Unknown names, names declared twice, and names of something else.

use super::super::fault_site::{FaultSite, PLANTED};
use super::super::scope::elementary;
use super::super::walk::ExpressionContext;
use super::operands::stands_for_any_value;
use crate::model::{
    DeclaredKind, Expression, ExpressionKind, Pou, Type, TypeDeclaration, Unit, VariableSection,
};
use stickler_types::ElementaryType;

/// Plants an undeclared variable in the place of a value.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn variable_read(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    // In the place of an enumerated value the name could be that of a value, too.
    let (number, ..) = fault.pick_expression(|site, expression| {
        let in_out = site.context == ExpressionContext::InOut;
        (in_out || stands_for_any_value(site, expression))
            && original.enumerated_values(&expression.ty).is_none()
    })?;
    fault.replace(number, ExpressionKind::Raw(PLANTED.to_owned()))
}

/// Plants a field that the structure does not have, or a variable that is no output of the function block.
///
/// Basis: ironplc-problem-codes: P4007.
pub(super) fn field(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let has_fields = |ty: &Type| original.fields(ty).is_some() || matches!(ty, Type::Block(_));
    let names = |unit: Unit| {
        let variables = unit.variables(original).iter();
        let with_fields = variables.filter(|variable| has_fields(&variable.ty));
        with_fields.map(|variable| &variable.name).collect::<Vec<_>>()
    };
    let (number, site, _) = fault.pick_expression(|site, expression| {
        stands_for_any_value(site, expression)
            && original.enumerated_values(&expression.ty).is_none()
            && !names(site.unit).is_empty()
    })?;
    let name = fault.choose(names(site.unit))?;
    fault.replace(number, ExpressionKind::Raw(format!("{name}.{PLANTED}")))
}

/// Plants a value that the enumeration does not have, with the enumeration's name in front of it.
///
/// Basis: ironplc-problem-codes: P2006.
pub(super) fn enumerated_value(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let (number, _, expression) = fault.pick_expression(|_, expression| {
        matches!(expression.kind, ExpressionKind::Enumerated(_))
            && original.enumerated_values(&expression.ty).is_some()
    })?;
    let Type::Declared(declared) = expression.ty else {
        return None;
    };
    let name = &original.types.get(declared)?.name;
    fault.replace(number, ExpressionKind::Raw(format!("{name}#{PLANTED}")))
}

/// Plants a value of another enumeration.
///
/// Basis: widening/user-defined.toml.
pub(super) fn other_enumeration(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let others = |expression: &Expression| {
        let declared = original.types.iter().enumerate();
        declared
            .filter(|(number, declaration)| {
                matches!(declaration.kind, DeclaredKind::Enumeration(_))
                    && expression.ty != Type::Declared(*number)
            })
            .map(|(_, declaration)| declaration)
            .collect::<Vec<_>>()
    };
    let (number, _, expression) = fault.pick_expression(|site, expression| {
        site.context == ExpressionContext::Assigned
            && original.enumerated_values(&expression.ty).is_some()
            && !others(expression).is_empty()
    })?;
    let TypeDeclaration {
        name,
        kind: DeclaredKind::Enumeration(values),
    } = fault.choose(others(&expression))?
    else {
        return None;
    };
    let value = fault.choose(values.iter().collect())?;
    fault.replace(number, ExpressionKind::Raw(format!("{name}#{value}")))
}

/// Plants a variable that is declared twice.
///
/// Basis: language/diagnostics-names.st (the second declaration, whatever its case and type).
pub(super) fn variable_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let unit = fault.unit()?;
    let variables = unit.variables(fault.original).iter().collect();
    let variable = fault.choose(variables)?;
    let name = other_case(&variable.name)?;
    let ty = fault.choose(vec!["INT", "BOOL", "REAL"])?;
    fault.declare_text(unit, &format!("{name} : {ty}"), VariableSection::Local)
}

/// Returns a name in another case of its letters, so that the second declaration differs from the text of the first.
fn other_case(name: &str) -> Option<String> {
    let names = [name.to_ascii_uppercase(), name.to_ascii_lowercase()];
    names.into_iter().find(|other| other != name)
}

/// Plants a function that is declared twice.
///
/// Basis: language/diagnostics-names.st.
pub(super) fn function_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let functions = fault.original.functions.iter();
    let function = fault.choose(functions.filter(|one| one.owner.is_none()).collect())?;
    again(fault, function, &function.name)
}

/// Declares a function or function block once more, under a name in another case of its letters.
fn again(fault: &mut FaultSite<'_, '_>, pou: &Pou, name: &str) -> Option<()> {
    let name = other_case(name)?;
    let (declared, end) = match pou.result {
        Some(_) => (&mut fault.program.functions, " : "),
        None => (&mut fault.program.blocks, ""),
    };
    fault.mark = Some(format!(" {name}{end}"));
    declared.push(Pou { name, ..pou.clone() });
    Some(())
}

/// Plants a function block that is declared twice.
///
/// Basis: ironplc-problem-codes: P4013.
pub(super) fn block_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let blocks = fault.original.blocks.iter().filter(|block| !block.standard);
    let block = fault.choose(blocks.collect())?;
    again(fault, block, &block.name)
}

/// Plants a function with the name of a type.
///
/// Basis: ironplc-problem-codes: P4011.
pub(super) fn two_kinds_of_one_name(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let function = original.functions.iter().rfind(|one| one.owner.is_none())?;
    let declaration = fault.choose(original.types.iter().collect())?;
    again(fault, function, &declaration.name)
}

/// Plants a type that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn type_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let declaration = fault.choose(fault.original.types.iter().collect())?;
    let name = other_case(&declaration.name)?;
    fault.mark = Some(format!("{name} : "));
    fault.program.types.push(TypeDeclaration {
        name,
        kind: DeclaredKind::Alias(Type::Elementary(ElementaryType::Int)),
    });
    Some(())
}

/// Plants a field that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn field_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared_twice(fault, |kind, mark| {
        let DeclaredKind::Structure(fields) = kind else {
            return None;
        };
        let name = other_case(&fields.last()?.0)?;
        *mark = Some(format!("{name} : "));
        fields.push((name, Type::Elementary(ElementaryType::Bool), None));
        Some(())
    })
}

/// Plants an enumerated value that is declared twice.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn enumerated_value_twice(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared_twice(fault, |kind, mark| {
        let DeclaredKind::Enumeration(values) = kind else {
            return None;
        };
        let name = other_case(values.first()?)?;
        *mark = Some(format!("{name})"));
        values.push(name);
        Some(())
    })
}

/// Changes one of the declared types for which the change is possible.
fn declared_twice(
    fault: &mut FaultSite<'_, '_>,
    change: impl Fn(&mut DeclaredKind, &mut Option<String>) -> Option<()>,
) -> Option<()> {
    let numbers = 0..fault.original.types.len();
    let possible = numbers.filter(|&number| {
        let mut tried = fault.original.types[number].kind.clone();
        change(&mut tried, &mut None).is_some()
    });
    let number = fault.choose(possible.collect())?;
    change(&mut fault.program.types.get_mut(number)?.kind, &mut fault.mark)
}

/// Plants an initial value that names what is not declared.
///
/// Basis: ironplc-problem-codes: P4007.
pub(super) fn initial(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let (number, ..) = fault.pick_expression(|site, expression| {
        site.context == ExpressionContext::Initial
            && site.unit != Unit::Types
            && elementary(original, &expression.ty).is_some()
    })?;
    fault.replace(number, ExpressionKind::Raw(PLANTED.to_owned()))
}
