//! The scope of a program organization unit: its readable and writable places, and the types of expressions as written.

use crate::model::{
    Expression, ExpressionKind, LiteralForm, PathStep, Place, PlaceSelector, Program, StandardFunction, Type,
    Unit, VariableId, VariableSection, controlled, integer,
};
use stickler_types::{Dialect, DialectName, ElementaryType};

/// Returns the elementary type that a type is or stands for.
pub(super) fn elementary(program: &Program, ty: &Type) -> Option<ElementaryType> {
    match program.unaliased(ty) {
        Type::Elementary(ty) => Some(*ty),
        _ => None,
    }
}

/// Returns the elementary type that the text of an expression determines; `None` if the context determines it, or if the
/// type is not elementary.
///
/// An implicit conversion does not appear in the text, so its operand counts.
pub(super) fn written(expression: &Expression) -> Option<ElementaryType> {
    let own = match expression.ty {
        Type::Elementary(ty) => Some(ty),
        // Aliases are not resolved: documents say little about them in mixed operations.
        _ => None,
    };
    match &expression.kind {
        ExpressionKind::Literal(_, LiteralForm::Untyped) => None,
        ExpressionKind::Literal(_, LiteralForm::Typed)
        | ExpressionKind::Read(_)
        | ExpressionKind::Bit(..)
        | ExpressionKind::Convert(..)
        | ExpressionKind::Call(..) => own,
        ExpressionKind::Widen(operand) | ExpressionKind::Unary(_, operand) => written(operand),
        ExpressionKind::Binary(operator, left, right) => {
            // One operand converts to the type of the other, which is the type of the whole.
            let rigid = operator.is_comparison() || written(left).or_else(|| written(right)).is_some();
            own.filter(|_| rigid)
        }
        ExpressionKind::Standard(function, arguments) => {
            let values = match function {
                StandardFunction::Len | StandardFunction::Find => return own,
                StandardFunction::Sel | StandardFunction::Mux => arguments.get(1..),
                StandardFunction::Shl
                | StandardFunction::Shr
                | StandardFunction::Rol
                | StandardFunction::Ror
                | StandardFunction::Left
                | StandardFunction::Right => arguments.get(..1),
                StandardFunction::Abs
                | StandardFunction::SquareRoot
                | StandardFunction::Min
                | StandardFunction::Max
                | StandardFunction::Limit
                | StandardFunction::Concat => Some(&arguments[..]),
            };
            let rigid = values
                .unwrap_or_default()
                .iter()
                .any(|value| written(value).is_some());
            own.filter(|_| rigid)
        }
        ExpressionKind::Enumerated(_) | ExpressionKind::Reference(_) | ExpressionKind::Raw(_) => None,
    }
}

/// Returns every elementary type of a dialect.
///
/// Basis: ironplc-problem-codes: P0010 (the types of the third edition need it).
pub(super) fn types(dialect: DialectName) -> impl Iterator<Item = ElementaryType> {
    ElementaryType::ALL
        .into_iter()
        .filter(move |&ty| Dialect::of(dialect).has(ty))
}

/// A part of a variable that a unit can name.
#[derive(Clone, Debug)]
pub(super) struct NamedPlace {
    /// The place of the part.
    pub place: Place,
    /// Whether the unit may write the part without changing anything else.
    pub writable: bool,
}

/// Returns every part of the variables of a unit; of arrays the element with the lowest subscripts.
pub(super) fn places(program: &Program, unit: Unit) -> Vec<NamedPlace> {
    let mut found = Vec::new();
    let controlled = controlled(unit.pou(program).map_or(&[], |pou| &pou.body));
    for (number, variable) in unit.variables(program).iter().enumerate() {
        let id = VariableId(number);
        let place = Place::whole(id, variable.ty.clone());
        let writable = match variable.section {
            VariableSection::Local | VariableSection::Output | VariableSection::InOut => {
                !controlled.contains(&id)
            }
            VariableSection::Constant | VariableSection::Input => false,
        };
        parts(program, place, writable, &mut found);
    }
    found
}

fn parts(program: &Program, place: Place, writable: bool, found: &mut Vec<NamedPlace>) {
    for (step, _, ty) in program.parts(&place.ty) {
        let writable = writable && !matches!(step, PathStep::Output(_));
        let selector = match step {
            PathStep::Index(limits) => {
                // Any integer type would do; this one holds every subscript.
                let lowest =
                    |&(low, _): &(i64, i64)| integer(ElementaryType::Lint, low, LiteralForm::Untyped);
                PlaceSelector::Index(limits.iter().map(lowest).collect())
            }
            PathStep::Field(field) => PlaceSelector::Field(field),
            PathStep::Output(output) => PlaceSelector::Output(output),
            PathStep::Followed => PlaceSelector::Followed,
        };
        let part = Place {
            variable: place.variable,
            path: [&place.path[..], &[selector]].concat(),
            ty: ty.clone(),
        };
        parts(program, part, writable, found);
    }
    found.push(NamedPlace { place, writable });
}
