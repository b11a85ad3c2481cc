//! Initial values of arrays that have more values than the array has elements, which the standard leaves open.

use crate::program::ReadProgram;
use stickler_syntax::tree::{
    ExpressionId, Initializer, InitializerKind, TypeSpecification, TypeSpecificationKind, VariableGroup,
};

/// Returns whether an array of one dimension, whose limits are numbers, begins with more values than it has elements: a variable, a field or an
/// element of one, one of a type, or one of a function block.
pub(crate) fn has_more_values(program: &ReadProgram<'_, '_>) -> bool {
    let groups = program.names.iter().filter_map(|one| one.group);
    let mut begun = groups.filter_map(|group| Some((&group.specification, group.initializer.as_ref()?)));
    begun.any(|(ty, initializer)| exceeds(program, ty, initializer))
}

/// Returns whether an initial value of this type, or a part of it, has more values than the array that it is given to has elements.
fn exceeds(program: &ReadProgram<'_, '_>, ty: &TypeSpecification<'_>, initializer: &Initializer<'_>) -> bool {
    let (ty, block) = match &ty.kind {
        TypeSpecificationKind::Named(name) => (
            program.declared_type(name.text).map(|one| &one.specification),
            program.unit.pous().find(|pou| pou.name.is(name.text)),
        ),
        _ => (Some(ty), None),
    };
    match (ty.map(|ty| &ty.kind), &initializer.kind) {
        (structure, InitializerKind::Structure(values)) => {
            let fields = match structure {
                Some(TypeSpecificationKind::Structure(fields)) => &fields[..],
                _ => &[],
            };
            let variables = block.into_iter().flat_map(|block| &block.blocks);
            let fields = fields.iter().chain(variables.flat_map(|section| &section.groups));
            let fields: Vec<&VariableGroup<'_>> = fields.collect();
            values.iter().any(|(field, value)| {
                let has_name =
                    |group: &&&VariableGroup<'_>| group.names.iter().any(|name| name.is(field.text));
                let group = fields.iter().find(has_name);
                group.is_some_and(|group| exceeds(program, &group.specification, value))
            })
        }
        (Some(TypeSpecificationKind::Array { dimensions, element }), InitializerKind::Array(elements)) => {
            let mut values = elements.iter().flat_map(|one| &one.values);
            let size = match &dimensions[..] {
                [limits] => size(program, *limits),
                _ => None,
            };
            let number = elements.iter().map(|one| {
                let times = one
                    .repetition
                    .map_or(Some(1), |times| number(program, times))
                    .unwrap_or(1);
                times.saturating_mul(one.values.len().max(1) as i64)
            });
            let number = number.fold(0, i64::saturating_add);
            size.is_some_and(|size| number > size) || values.any(|value| exceeds(program, element, value))
        }
        _ => false,
    }
}

/// Returns the number of elements between two limits that are numbers.
fn size(program: &ReadProgram<'_, '_>, (low, high): (ExpressionId, ExpressionId)) -> Option<i64> {
    let (low, high) = (number(program, low)?, number(program, high)?);
    Some(high.saturating_sub(low).saturating_add(1))
}

fn number(program: &ReadProgram<'_, '_>, id: ExpressionId) -> Option<i64> {
    program.text(id).replace('_', "").parse().ok()
}
