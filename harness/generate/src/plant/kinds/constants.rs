//! Assignments to constants and to their parts.

use super::super::fault_site::{FaultSite, PLANTED, literal, literal_text};
use super::super::scope::{elementary, places, types};
use super::bits::bits;
use crate::model::{
    ArrayType, AssignmentTarget, DeclaredKind, InitialValue, Place, PlaceSelector, Program, Statement, Type,
    Unit, Variable, VariableId, VariableSection,
};
use stickler_types::ElementaryType;

/// Declares a constant with the planted name, after all variables of a unit.
pub(super) fn declare(
    fault: &mut FaultSite<'_, '_>,
    unit: Unit,
    ty: Type,
    initial: InitialValue,
) -> Option<VariableId> {
    Some(unit.pou_mut(&mut fault.program)?.declare(Variable {
        name: PLANTED.to_owned(),
        ty,
        section: VariableSection::Constant,
        initial: Some(initial),
    }))
}

/// Plants an assignment to a constant.
///
/// Basis: language/diagnostics-calls.st.
pub(super) fn assigned(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    fault.insert_text(|fault, unit| {
        let ty = fault.choose(types(fault.original.dialect).filter(|ty| !ty.is_text()).collect())?;
        let value = InitialValue::Expression(literal(ty));
        declare(fault, unit, Type::Elementary(ty), value)?;
        Some(format!("{PLANTED} := {};", literal_text(ty)))
    })
}

/// Plants an assignment to a part of a constant: a field or an element, a part of such a part, or a bit of one or of the
/// whole.
///
/// Basis: language/diagnostics-beside-a-subscript.st; bit-access/constant-parts-are-not-written.st.
pub(super) fn part_assigned(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    fault.insert(
        |_, _| true,
        |fault, unit| {
            let sorts = [structures(original), arrays(original), with_bits(original)];
            let sorts = sorts.into_iter().filter(|constants| !constants.is_empty());
            let constants = fault.choose(sorts.collect())?;
            let (ty, initial) = fault.choose(constants)?;
            let constant = declare(fault, unit, ty, initial)?;
            let targets = places(&fault.program, unit)
                .into_iter()
                .filter(|named| named.place.variable == constant)
                .flat_map(|named| targets(original, &named.place));
            let (target, ty) = fault.choose(targets.collect())?;
            fault.mark = Some(beginning(&target));
            Some(Statement::Assign(target, literal(ty)))
        },
    )
}

/// Returns constants of the structures that have an elementary field, with a value for that field.
fn structures(program: &Program) -> Vec<(Type, InitialValue)> {
    let declared = program.types.iter().enumerate();
    let constants = declared.filter_map(|(number, declaration)| {
        let DeclaredKind::Structure(fields) = &declaration.kind else {
            return None;
        };
        let mut fields = fields.iter().enumerate();
        let value = fields.find_map(|(field, (_, ty, _))| Some((field, literal(elementary(program, ty)?))));
        Some((Type::Declared(number), InitialValue::Structure(vec![value?])))
    });
    constants.collect()
}

/// Returns constants that are arrays, of each elementary type but texts.
fn arrays(program: &Program) -> Vec<(Type, InitialValue)> {
    let constant = |ty| {
        let array = ArrayType {
            dimensions: vec![(1, 2)],
            element: Type::Elementary(ty),
        };
        let values = vec![literal(ty), literal(ty)];
        (Type::Array(Box::new(array)), InitialValue::Array(values))
    };
    let elements = types(program.dialect).filter(|ty| !ty.is_text());
    elements.map(constant).collect()
}

/// Returns constants that have bits, where the dialect has access to them.
fn with_bits(program: &Program) -> Vec<(Type, InitialValue)> {
    let has_bits = program.dialect.rules().documents.bits;
    let constants = types(program.dialect)
        .map(|ty| (Type::Elementary(ty), InitialValue::Expression(literal(ty))))
        .filter(|(ty, _)| has_bits && bits(program, ty).is_some());
    constants.collect()
}

/// Returns the assignable parts of a place of a constant, with the types of their values.
fn targets(program: &Program, place: &Place) -> Vec<(AssignmentTarget, ElementaryType)> {
    let mut found = Vec::new();
    let ty = elementary(program, &place.ty).filter(|ty| !ty.is_text());
    if let Some(ty) = ty
        && !place.path.is_empty()
    {
        found.push((AssignmentTarget::Place(place.clone()), ty));
    }
    if let Some(width) = bits(program, &place.ty)
        && program.dialect.rules().documents.bits
    {
        let bit = |number| (AssignmentTarget::Bit(place.clone(), number), ElementaryType::Bool);
        found.extend([0, width - 1].map(bit));
    }
    found
}

/// Returns the first characters of the text of a part of the planted constant, which its declaration does not contain.
fn beginning(target: &AssignmentTarget) -> String {
    let first = match target {
        AssignmentTarget::Place(place) | AssignmentTarget::Bit(place, _) => place.path.first(),
        AssignmentTarget::Result => None,
    };
    match first {
        Some(PlaceSelector::Index(_)) => format!("{PLANTED}["),
        _ => format!("{PLANTED}."),
    }
}
