//! Values whose types do not fit the place where they stand.
//!
//! Basis of all codes here: stickler-design: §7 (*which code where*), and for what is neither an initial value, nor an argument,
//! nor the bare result of a call: *all else P4035*, widening/contexts.toml.

use super::super::plot::{Plot, literal};
use super::super::scope::{elementary, types};
use super::super::walk::{Context, Site};
use crate::model::{Expression, ExpressionKind, Program, StandardFunction, Unit};
use stickler_exact::{implicit, signatures};
use stickler_types::{DialectName, ElementaryType, MatrixWord};

/// A value of a type that does not convert to the target's.
pub(super) fn assigned(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Assigned, SHAPES)
}

/// The same for the result of a function, in its body.
pub(super) fn result(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Result, SHAPES)
}

/// Nothing but a call, assigned.
pub(super) fn call_assigned(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Assigned, &[Shape::Call])
}

/// An initial value, also of an element or a field.
pub(super) fn initial(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(
        plot,
        |context| context == Context::Initial,
        &[Shape::Literal, Shape::Foreign],
    )
}

/// An argument of a function.
pub(super) fn argument(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Argument, ALL_SHAPES)
}

/// An input of a function block.
pub(super) fn input(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Input, ALL_SHAPES)
}

/// The argument of a conversion function whose name says from which type it converts.
pub(super) fn converted(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Converted, ALL_SHAPES)
}

/// The condition of IF.
pub(super) fn condition_of_if(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::If, ALL_SHAPES)
}

/// The condition of ELSIF.
pub(super) fn condition_of_elsif(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::ElsIf, ALL_SHAPES)
}

/// The condition of WHILE.
pub(super) fn condition_of_while(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::While, ALL_SHAPES)
}

/// The condition of REPEAT.
pub(super) fn condition_of_repeat(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    misfit(plot, |context| context == Context::Until, ALL_SHAPES)
}

/// What makes a value of a type.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// A variable, an element, a field or an output.
    Variable,
    /// A literal with its type in front of it.
    Literal,
    /// An operation on a variable.
    Operation,
    /// The bare call of a conversion function.
    Call,
    /// A literal without a type, of another kind than the place takes.
    Foreign,
}

const SHAPES: &[Shape] = &[Shape::Variable, Shape::Literal, Shape::Operation, Shape::Foreign];
pub(super) const ALL_SHAPES: &[Shape] = &[
    Shape::Variable,
    Shape::Literal,
    Shape::Operation,
    Shape::Foreign,
    Shape::Call,
];

/// Puts a value of a type that does not convert to the expected one in a place of one of these contexts, which expect the
/// type that the value there has.
fn misfit(plot: &mut Plot<'_, '_, '_>, context: fn(Context) -> bool, shapes: &[Shape]) -> Option<()> {
    let original = plot.original;
    let dialect = original.dialect;
    let (number, site, expression) = plot
        .site(|site, expression| context(site.context) && elementary(original, &expression.ty).is_some())?;
    let target = elementary(original, &expression.ty)?;
    let shape = plot.choose(shapes.to_vec())?;
    if shape == Shape::Foreign {
        let kind = foreign(plot, |from| never(from, target, dialect))?;
        plot.replace(number, kind);
        return Some(());
    }
    let wrong = types(dialect)
        .filter(|&from| never(from, target, dialect))
        .collect();
    let from = plot.choose(wrong)?;
    let kind = value(plot, site.unit, from, shape)?;
    plot.replace(number, kind);
    // A literal of a text is untyped, so that no conversion function is meant.
    let typed = shape != Shape::Literal || !from.is_text();
    let suggests = matches!(
        site.context,
        Context::Assigned | Context::Result | Context::Argument | Context::Input
    );
    plot.suggested = suggests && typed && converts(from, target, dialect);
    Some(())
}

/// Whether documents say that a value of the one type never stands for one of the other.
pub(super) fn never(from: ElementaryType, into: ElementaryType, dialect: DialectName) -> bool {
    implicit(from, into, dialect) == MatrixWord::No
}

/// Whether the dialect has a conversion function for the pair.
pub(super) fn converts(from: ElementaryType, into: ElementaryType, dialect: DialectName) -> bool {
    !signatures(&format!("{from}_TO_{into}"), dialect).is_empty()
}

/// A value of a type in a unit, of a shape other than [`Shape::Foreign`]; where nothing is declared, a literal.
pub(super) fn value(
    plot: &mut Plot<'_, '_, '_>,
    unit: Unit,
    ty: ElementaryType,
    shape: Shape,
) -> Option<ExpressionKind> {
    match shape {
        _ if unit == Unit::Types => Some(literal(ty).kind),
        Shape::Literal | Shape::Foreign => Some(literal(ty).kind),
        Shape::Variable => plot.variable(unit, ty),
        Shape::Operation => plot.operation(unit, ty),
        Shape::Call => plot.call(unit, ty),
    }
}

/// A literal without a type, of a kind no type of which fits.
///
/// Basis: widening/literal-of-another-kind.toml.
pub(super) fn foreign(
    plot: &mut Plot<'_, '_, '_>,
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
    plot.choose(texts)
        .map(|text: &str| ExpressionKind::Raw(text.to_owned()))
}

/// A subscript that is no integer.
pub(super) fn subscript(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let in_place = |context| matches!(context, Context::Subscript(..));
    no_integer(plot, in_place, converts_to_no_integer)
}

/// A first or last value of FOR that is no integer.
pub(super) fn bound(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    no_integer(plot, |context| context == Context::Bound, converts_to_no_integer)
}

/// A selector of CASE that is neither an integer nor an enumeration, whatever converts to an integer elsewhere.
///
/// Basis: ironplc-problem-codes: P4053; widening/any-integer.toml (nothing widens in the place of a selector).
pub(super) fn selector(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let in_place = |context| context == Context::Selector;
    // What converts to an integer elsewhere is the error that is easiest to overlook.
    let tempting = plot.input.ratio(1, 2).unwrap_or(true);
    let wrong =
        |ty: ElementaryType, _| !ty.is_integer() && (!tempting || ty.is_bit_string() || ty.is_duration());
    no_integer(plot, in_place, wrong)
}

/// Puts a value of one of these types, which are no integers, in a place of one of these contexts.
fn no_integer(
    plot: &mut Plot<'_, '_, '_>,
    context: fn(Context) -> bool,
    wrong: impl Fn(ElementaryType, DialectName) -> bool,
) -> Option<()> {
    let dialect = plot.original.dialect;
    let (number, site, _) = plot.site(|site, _| context(site.context))?;
    let from = plot.choose(types(dialect).filter(|&ty| wrong(ty, dialect)).collect())?;
    let shape = plot.choose(vec![Shape::Variable, Shape::Operation])?;
    let kind = value(plot, site.unit, from, shape)?;
    plot.replace(number, kind);
    Some(())
}

/// Whether no integer type takes a value of a type without a call. Where one does, as with bit strings and durations in some
/// dialects, a person may doubt that a subscript is wrong.
fn converts_to_no_integer(ty: ElementaryType, dialect: DialectName) -> bool {
    let integers = types(dialect).filter(|into| into.is_integer());
    !ty.is_integer() && { integers }.all(|into| never(ty, into, dialect))
}

/// An argument of a standard function that its parameter does not take.
///
/// Basis: iec-61131-3: Tables 28 to 34 (the generic types of the parameters).
pub(super) fn standard(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let dialect = plot.original.dialect;
    let (number, site, _) = plot.site(|site, _| takes(site.context, ElementaryType::Date) == Some(false))?;
    let wrong = types(dialect).filter(|&ty| takes(site.context, ty) == Some(false));
    let from = plot.choose(wrong.collect())?;
    let kind = plot.variable(site.unit, from)?;
    plot.replace(number, kind);
    Some(())
}

/// The same where the call is all that is assigned or passed: then the type that is wanted of it is known, and with that the
/// conversion to suggest.
pub(super) fn of_call_alone(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let original = plot.original;
    let dialect = original.dialect;
    let alone = |site: Site, call: &Expression| {
        let wanted = matches!(
            site.context,
            Context::Assigned | Context::Result | Context::Argument | Context::Input
        );
        match &call.kind {
            ExpressionKind::Standard(function, arguments) if wanted => {
                of_one_type(original, *function, arguments)
            }
            _ => Vec::new(),
        }
    };
    let (number, site, call) = plot.site(|site, expression| !alone(site, expression).is_empty())?;
    let (context, target) = plot.choose(alone(site, &call))?;
    let Context::Standard(_, place) = context else {
        return None;
    };
    let wrong = types(dialect).filter(|&ty| takes(context, ty) == Some(false));
    let from = plot.choose(wrong.collect())?;
    let kind = plot.variable(site.unit, from)?;
    plot.change(number, |call| {
        if let ExpressionKind::Standard(_, arguments) = &mut call.kind
            && let Some(argument) = arguments.get_mut(place)
        {
            argument.kind = kind;
        }
    });
    plot.suggested = converts(from, target, dialect);
    Some(())
}

/// The arguments for which a call of a standard function takes only one type, with that type. A number that counts may be of any
/// integer type, so that no conversion is the one that was meant.
fn of_one_type(
    program: &Program,
    function: StandardFunction,
    arguments: &[Expression],
) -> Vec<(Context, ElementaryType)> {
    let contexts = (0..arguments.len()).map(|number| Context::Standard(function, number));
    let types = arguments.iter().map(|argument| elementary(program, &argument.ty));
    let found = contexts
        .zip(types)
        .filter_map(|(context, ty)| Some((context, ty?)));
    found
        .filter(|&(context, ty)| takes(context, ElementaryType::Date) == Some(false) && !counts(context, ty))
        .collect()
}

/// Whether it is the selector of MUX, or by how much is shifted.
fn counts(context: Context, ty: ElementaryType) -> bool {
    matches!(context, Context::Standard(function, _) if function != StandardFunction::Abs && ty.is_integer())
}

/// Whether a parameter of a standard function takes a type; nothing where the type has to be that of another argument, or
/// where a dialect might convert it.
fn takes(context: Context, ty: ElementaryType) -> Option<bool> {
    use StandardFunction as S;
    let Context::Standard(function, number) = context else {
        return None;
    };
    match (function, number) {
        (S::Abs, 0) if ty.is_duration() => None,
        (S::Abs, 0) => Some(ty.is_integer() || ty.is_real()),
        (S::Sel, 0) => Some(ty == ElementaryType::Bool),
        (S::Mux, 0) | (S::Shl | S::Shr | S::Rol | S::Ror, 1) if ty.is_bit_string() || ty.is_duration() => {
            None
        }
        (S::Mux, 0) | (S::Shl | S::Shr | S::Rol | S::Ror, 1) => Some(ty.is_integer()),
        (S::Shl | S::Shr | S::Rol | S::Ror, 0) if ty == ElementaryType::Bool => None,
        (S::Shl | S::Shr | S::Rol | S::Ror, 0) => Some(ty.is_bit_string()),
        (S::Len, 0) | (S::Concat, _) if ty.is_text() || ty.is_character() => None,
        (S::Len, 0) | (S::Concat, _) => Some(false),
        _ => None,
    }
}
