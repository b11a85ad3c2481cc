//! Values whose types do not fit their places.
//!
//! Basis of all codes here: rule: code-of-the-context; widening/contexts.toml.

use super::super::fault_site::{FaultSite, literal};
use super::super::scope::{elementary, types};
use super::super::walk::{ExpressionContext, ExpressionSite};
use crate::model::{Expression, ExpressionKind, Program, StandardFunction, Unit};
use stickler_exact::{implicit, signatures};
use stickler_types::{DialectName, ElementaryType, MatrixWord};

/// The form of a planted value.
#[derive(Clone, Copy, PartialEq, Eq, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub(super) enum MisfitForm {
    /// A variable, an element, a field or an output.
    Variable,
    /// A typed literal.
    Literal,
    /// An operation on a variable.
    Operation,
    /// The bare call of a conversion function.
    Call,
    /// An untyped literal of another kind than the place takes.
    Foreign,
}

/// Every form.
pub(super) const ALL_MISFIT_FORMS: &[MisfitForm] = &[
    MisfitForm::Variable,
    MisfitForm::Literal,
    MisfitForm::Operation,
    MisfitForm::Foreign,
    MisfitForm::Call,
];

/// Replaces an expression in a context by a value of a type that does not convert to the type of the expression.
pub(super) fn misfit(
    fault: &mut FaultSite<'_, '_>,
    context: ExpressionContext,
    shapes: &[MisfitForm],
) -> Option<()> {
    let original = fault.original;
    let dialect = original.dialect;
    let (number, site, expression) = fault.pick_expression(|site, expression| {
        site.context == context && elementary(original, &expression.ty).is_some()
    })?;
    let target = elementary(original, &expression.ty)?;
    let shape = fault.choose(shapes.to_vec())?;
    if shape == MisfitForm::Foreign {
        let kind = foreign(fault, |from| never(from, target, dialect))?;
        return fault.replace(number, kind);
    }
    let wrong = types(dialect).filter(|&from| never(from, target, dialect));
    let from = fault.choose(wrong.collect())?;
    let kind = value(fault, site.unit, from, shape)?;
    fault.replace(number, kind);
    // A text literal is untyped, so that no single conversion function is the right one.
    let typed = shape != MisfitForm::Literal || !from.is_text();
    let suggests = site.context.has_target();
    fault.suggested = suggests && typed && converts(from, target, dialect);
    Some(())
}

/// Returns whether documents state that values of one type never convert implicitly to another.
pub(super) fn never(from: ElementaryType, into: ElementaryType, dialect: DialectName) -> bool {
    implicit(from, into, dialect) == MatrixWord::No
}

/// Returns whether the dialect has a conversion function for a pair of types.
pub(super) fn converts(from: ElementaryType, into: ElementaryType, dialect: DialectName) -> bool {
    !signatures(&format!("{from}_TO_{into}"), dialect).is_empty()
}

/// Creates a value of a type in a unit, in a form other than [`MisfitForm::Foreign`]; a literal where nothing can be
/// declared.
pub(super) fn value(
    fault: &mut FaultSite<'_, '_>,
    unit: Unit,
    ty: ElementaryType,
    shape: MisfitForm,
) -> Option<ExpressionKind> {
    match shape {
        _ if unit == Unit::Types => Some(literal(ty).kind),
        MisfitForm::Literal | MisfitForm::Foreign => Some(literal(ty).kind),
        MisfitForm::Variable => fault.variable(unit, ty),
        MisfitForm::Operation => fault.operation(unit, ty),
        MisfitForm::Call => fault.call(unit, ty),
    }
}

/// Creates an untyped literal of a kind that does not fit any type of the place.
///
/// Basis: widening/literal-of-another-kind.toml.
pub(super) fn foreign(
    fault: &mut FaultSite<'_, '_>,
    never: impl Fn(ElementaryType) -> bool,
) -> Option<ExpressionKind> {
    use ElementaryType as E;
    let kinds: [(&str, &[ElementaryType]); 4] = [
        ("2.5", &[E::Real, E::Lreal]),
        ("TRUE", &[E::Bool]),
        ("T#5s", &[E::Time, E::Ltime]),
        ("'ab'", &[E::String]),
    ];
    let texts = kinds
        .into_iter()
        .filter(|(_, types)| types.iter().all(|&ty| never(ty)))
        .map(|(text, _)| text)
        .collect();
    fault
        .choose(texts)
        .map(|text: &str| ExpressionKind::Raw(text.to_owned()))
}

/// Plants a subscript that is no integer.
pub(super) fn subscript(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let in_place = |context| matches!(context, ExpressionContext::Subscript(..));
    no_integer(fault, in_place, converts_to_no_integer)
}

/// Plants a first or last value of FOR that is no integer.
pub(super) fn bound(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let in_place = |context| context == ExpressionContext::Bound;
    no_integer(fault, in_place, converts_to_no_integer)
}

/// Plants a selector of CASE that is neither an integer nor an enumeration, whatever converts to an integer elsewhere.
///
/// Basis: ironplc-problem-codes: P4053; widening/any-integer.toml (nothing widens in the place of a selector).
pub(super) fn selector(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let in_place = |context| context == ExpressionContext::Selector;
    // A type that converts to an integer elsewhere is the error that is easiest to overlook.
    let tempting = fault.input.ratio(1, 2).unwrap_or(true);
    let wrong = |ty: ElementaryType, dialect: DialectName| {
        let selects = ty.is_integer() || ty.is_bit_string() && dialect.rules().bit_strings_as_integers;
        !selects && (!tempting || ty.is_bit_string() || ty.is_duration())
    };
    no_integer(fault, in_place, wrong)
}

/// Replaces an expression in one of some contexts by a value of a type that is no integer.
fn no_integer(
    fault: &mut FaultSite<'_, '_>,
    context: fn(ExpressionContext) -> bool,
    wrong: impl Fn(ElementaryType, DialectName) -> bool,
) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, site, _) = fault.pick_expression(|site, _| context(site.context))?;
    let from = fault.choose(types(dialect).filter(|&ty| wrong(ty, dialect)).collect())?;
    let shape = fault.choose(vec![MisfitForm::Variable, MisfitForm::Operation])?;
    let kind = value(fault, site.unit, from, shape)?;
    fault.replace(number, kind)
}

/// Returns whether a type converts implicitly to no integer type. If it converts, as bit strings and durations do in some
/// dialects, it is doubtful whether a subscript of that type is wrong.
fn converts_to_no_integer(ty: ElementaryType, dialect: DialectName) -> bool {
    let integers = types(dialect).filter(|into| into.is_integer());
    !ty.is_integer() && { integers }.all(|into| never(ty, into, dialect))
}

/// Plants an argument of a standard function that its parameter does not take.
///
/// Basis: iec-61131-3: Tables 28 to 34 (the generic types of the parameters).
pub(super) fn standard(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let dialect = fault.original.dialect;
    let (number, site, _) =
        fault.pick_expression(|site, _| takes(site.context, ElementaryType::Date, dialect) == Some(false))?;
    let wrong = types(dialect).filter(|&ty| takes(site.context, ty, dialect) == Some(false));
    let from = fault.choose(wrong.collect())?;
    let kind = fault.variable(site.unit, from)?;
    fault.replace(number, kind)
}

/// Plants an argument that its parameter does not take in a call of a standard function that is the whole value assigned or
/// passed: the place determines the type of the call, and so the conversion to suggest.
pub(super) fn of_call_alone(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let original = fault.original;
    let dialect = original.dialect;
    let alone = |site: ExpressionSite, call: &Expression| {
        let wanted = site.context.has_target();
        match &call.kind {
            ExpressionKind::Standard(function, arguments) if wanted => {
                of_one_type(original, *function, arguments)
            }
            _ => Vec::new(),
        }
    };
    let (number, site, call) =
        fault.pick_expression(|site, expression| !alone(site, expression).is_empty())?;
    let (context, target) = fault.choose(alone(site, &call))?;
    let ExpressionContext::Standard(_, place) = context else {
        return None;
    };
    let wrong = types(dialect).filter(|&ty| takes(context, ty, dialect) == Some(false));
    let from = fault.choose(wrong.collect())?;
    let kind = fault.variable(site.unit, from)?;
    fault.change(number, |call| {
        if let ExpressionKind::Standard(_, arguments) = &mut call.kind
            && let Some(argument) = arguments.get_mut(place)
        {
            argument.kind = kind;
        }
    });
    fault.suggested = converts(from, target, dialect);
    Some(())
}

/// Returns the arguments for which a call of a standard function takes only one type, with that type. A counting argument
/// may be of any integer type, so that no single conversion is the right one.
fn of_one_type(
    program: &Program,
    function: StandardFunction,
    arguments: &[Expression],
) -> Vec<(ExpressionContext, ElementaryType)> {
    let contexts = (0..arguments.len()).map(|number| ExpressionContext::Standard(function, number));
    let types = arguments.iter().map(|argument| elementary(program, &argument.ty));
    let found = contexts
        .zip(types)
        .filter_map(|(context, ty)| Some((context, ty?)));
    found
        .filter(|&(context, ty)| {
            takes(context, ElementaryType::Date, program.dialect) == Some(false) && !counts(context, ty)
        })
        .collect()
}

/// Returns whether an argument counts: the selector of MUX, or the count of a shift.
fn counts(context: ExpressionContext, ty: ElementaryType) -> bool {
    matches!(context, ExpressionContext::Standard(function, _) if function != StandardFunction::Abs && ty.is_integer())
}

/// Returns whether a parameter of a standard function takes a type; `None` where the type must be that of another argument,
/// or where a dialect might convert it.
fn takes(context: ExpressionContext, ty: ElementaryType, dialect: DialectName) -> Option<bool> {
    use StandardFunction as S;
    let ExpressionContext::Standard(function, number) = context else {
        return None;
    };
    match (function, number) {
        (S::Abs, 0) if ty.is_duration() => None,
        (S::Abs, 0) => Some(ty.is_integer() || ty.is_real()),
        (S::Sel, 0) if ty == ElementaryType::Bool => Some(true),
        (S::Sel, 0) => never(ty, ElementaryType::Bool, dialect).then_some(false),
        (S::Mux, 0) | (S::Shl | S::Shr | S::Rol | S::Ror, 1) if ty.is_bit_string() || ty.is_duration() => {
            None
        }
        (S::Mux, 0) | (S::Shl | S::Shr | S::Rol | S::Ror, 1) => Some(ty.is_integer()),
        (S::Shl | S::Shr | S::Rol | S::Ror, 0) if ty == ElementaryType::Bool => None,
        // Where functions promote integers, they shift their bits too.
        (S::Shl | S::Shr | S::Rol | S::Ror, 0) if ty.is_integer() && dialect.rules().functions_promote => {
            None
        }
        (S::Shl | S::Shr | S::Rol | S::Ror, 0) => Some(ty.is_bit_string()),
        (S::Len, 0) | (S::Concat, _) if ty.is_text() || ty.is_character() => None,
        (S::Len, 0) | (S::Concat, _) => Some(false),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where numbers stand for one another, a WORD is a selector like any other.
    #[test]
    fn a_selector_of_sel_is_wrong_where_it_does_not_convert_to_bool() {
        let selector = ExpressionContext::Standard(StandardFunction::Sel, 0);
        let word = |dialect| takes(selector, ElementaryType::Word, dialect);
        assert_eq!(word(DialectName::PLCNEXT), Some(false));
        assert_eq!(word(DialectName::RUSTY), None);
        assert_eq!(word(DialectName::STRUCPP), None);
        assert_eq!(
            takes(selector, ElementaryType::Bool, DialectName::RUSTY),
            Some(true)
        );
    }
}
