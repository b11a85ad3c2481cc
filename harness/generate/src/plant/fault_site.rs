//! The state in which a kind of error is planted: a program, a copy to change, and the bytes that choose.

use super::scope::{elementary, places};
use super::walk::{self, ExpressionSite};
use crate::model::{
    BinaryOperator, Expression, ExpressionKind, LiteralForm, Place, Program, Statement, Type, UnaryOperator,
    Unit, Variable, VariableSection,
};
use arbitrary::Unstructured;
use stickler_exact::signatures;
use stickler_types::{ElementaryType, Family, Value};

/// The name of what a kind declares in addition; no program uses it.
pub(super) const PLANTED: &str = "planted";

/// The program in which one error is planted, with the choices of its place.
pub(super) struct FaultSite<'p, 'd> {
    /// The sound program.
    pub original: &'p Program,
    /// The copy that gets the error.
    pub program: Program,
    /// The source of choices.
    pub input: &'p mut Unstructured<'d>,
    /// The text that identifies the line of the error, if a declaration is planted.
    pub mark: Option<String>,
    /// Whether the diagnostic must come with a suggestion.
    pub suggested: bool,
}

impl<'p, 'd> FaultSite<'p, 'd> {
    /// Creates a state in which nothing is planted yet.
    pub fn new(original: &'p Program, input: &'p mut Unstructured<'d>) -> FaultSite<'p, 'd> {
        FaultSite {
            original,
            program: original.clone(),
            input,
            mark: None,
            suggested: false,
        }
    }

    /// Picks an element; `None` if there is none.
    pub fn choose<T>(&mut self, mut from: Vec<T>) -> Option<T> {
        let last = from.len().checked_sub(1)?;
        // When the bytes run out the first is chosen.
        let which = self.input.int_in_range(0..=last).unwrap_or(0);
        Some(from.swap_remove(which))
    }

    /// Picks an expression that satisfies a predicate: returns its number in the walk, its place, and a copy of it.
    pub fn pick_expression(
        &mut self,
        eligible: impl Fn(ExpressionSite, &Expression) -> bool,
    ) -> Option<(usize, ExpressionSite, Expression)> {
        let mut found = Vec::new();
        let mut number = 0;
        walk::expressions(self.original, &mut self.program, &mut |site, expression| {
            if eligible(site, expression) {
                found.push((number, site, expression.clone()));
            }
            number += 1;
        });
        self.choose(found)
    }

    /// Changes the expression with a number.
    pub fn change(&mut self, number: usize, change: impl FnOnce(&mut Expression)) {
        let mut change = Some(change);
        let mut reached = 0;
        walk::expressions(self.original, &mut self.program, &mut |_, expression| {
            if reached == number
                && let Some(change) = change.take()
            {
                change(expression);
            }
            reached += 1;
        });
    }

    /// Replaces the expression with a number, keeping its type field. Always `Some`, as the result of a kind that is planted.
    pub fn replace(&mut self, number: usize, kind: ExpressionKind) -> Option<()> {
        self.change(number, |expression| expression.kind = kind);
        Some(())
    }

    /// Inserts a statement into a list that satisfies a predicate on its unit and on whether a loop encloses it.
    pub fn insert(
        &mut self,
        eligible: impl Fn(Unit, bool) -> bool,
        make: impl FnOnce(&mut Self, Unit) -> Option<Statement>,
    ) -> Option<()> {
        let mut found = Vec::new();
        let mut number = 0;
        walk::lists(&mut self.program, &mut |unit, in_loop, list| {
            if eligible(unit, in_loop) {
                found.push((number, unit, list.len()));
            }
            number += 1;
        });
        let (number, unit, length) = self.choose(found)?;
        let at = self.input.int_in_range(0..=length).unwrap_or(0);
        let kind = make(self, unit)?;
        self.change_list(number, |list| list.insert(at.min(list.len()), kind));
        Some(())
    }

    /// Inserts a statement of raw text into any list.
    pub fn insert_text(&mut self, make: impl FnOnce(&mut Self, Unit) -> Option<String>) -> Option<()> {
        self.insert(|_, _| true, |fault, unit| make(fault, unit).map(Statement::Raw))
    }

    /// Changes a statement that satisfies a predicate.
    pub fn change_statement(
        &mut self,
        eligible: impl Fn(Unit, &Statement) -> bool,
        change: impl FnOnce(&mut Self, Unit, &mut Statement) -> Option<()>,
    ) -> Option<()> {
        let mut found = Vec::new();
        let mut number = 0;
        walk::lists(&mut self.program, &mut |unit, _, list| {
            let statements = list.iter().enumerate();
            found.extend(
                statements
                    .filter(|(_, statement)| eligible(unit, statement))
                    .map(|(at, statement)| (number, at, unit, statement.clone())),
            );
            number += 1;
        });
        let (number, at, unit, mut kind) = self.choose(found)?;
        change(self, unit, &mut kind)?;
        self.change_list(number, |list| {
            if let Some(statement) = list.get_mut(at) {
                *statement = kind;
            }
        });
        Some(())
    }

    /// Changes the list of statements with a number.
    fn change_list(&mut self, number: usize, change: impl FnOnce(&mut Vec<Statement>)) {
        let mut change = Some(change);
        let mut reached = 0;
        walk::lists(&mut self.program, &mut |_, _, list| {
            if reached == number
                && let Some(change) = change.take()
            {
                change(list);
            }
            reached += 1;
        });
    }

    /// Declares a variable after all others of a unit, which keep their numbers.
    pub fn declare(&mut self, unit: Unit, name: &str, ty: Type, section: VariableSection) -> Option<()> {
        unit.pou_mut(&mut self.program)?.variables.push(Variable {
            name: name.to_owned(),
            ty,
            section,
            initial: None,
        });
        Some(())
    }

    /// Declares something that only text can express: the text is part of the name of a variable. The text stands on a line
    /// of its own, which is that of the error; its last declaration is an INT.
    pub fn declare_text(&mut self, unit: Unit, text: &str, section: VariableSection) -> Option<()> {
        self.mark = Some(text.to_owned());
        let last = if text.is_empty() {
            PLANTED.to_owned()
        } else {
            format!("{text}; {PLANTED}")
        };
        let int = ElementaryType::Int;
        self.declare(unit, &last, Type::Elementary(int), section)?;
        if section == VariableSection::Constant {
            let declared = unit.pou_mut(&mut self.program)?.variables.last_mut()?;
            declared.initial = Some(crate::model::InitialValue::Expression(literal(int)));
        }
        Some(())
    }

    /// Picks a unit with variables.
    pub fn unit(&mut self) -> Option<Unit> {
        self.choose(Unit::all(self.original))
    }

    /// Picks a part of a variable that satisfies a predicate.
    pub fn place(&mut self, unit: Unit, eligible: impl Fn(&Place, bool) -> bool) -> Option<Place> {
        let mut found = places(self.original, unit);
        found.retain(|named| eligible(&named.place, named.writable));
        self.choose(found).map(|named| named.place)
    }

    /// Returns the name of a variable of an elementary type that the unit can read and write: an existing one, or a new one.
    pub fn variable_text(&mut self, unit: Unit, ty: ElementaryType) -> Option<String> {
        let original = self.original;
        let found = unit
            .variables(original)
            .iter()
            .filter(|variable| {
                variable.section != VariableSection::Constant
                    && elementary(original, &variable.ty) == Some(ty)
            })
            .map(|variable| variable.name.clone())
            .collect();
        self.choose(found).or_else(|| self.declare_variable(unit, ty))
    }

    /// Declares a local variable of an elementary type and returns its name.
    fn declare_variable(&mut self, unit: Unit, ty: ElementaryType) -> Option<String> {
        let variables = &mut unit.pou_mut(&mut self.program)?.variables;
        let name = format!("{PLANTED}_{}", variables.len());
        self.declare(unit, &name, Type::Elementary(ty), VariableSection::Local)?;
        Some(name)
    }

    /// Creates a value of an elementary type: a variable, an element, a field or an output.
    pub fn variable(&mut self, unit: Unit, ty: ElementaryType) -> Option<ExpressionKind> {
        self.variable_where(unit, ty, |_| true)
    }

    /// Creates a value of an elementary type: a part of a variable of which a predicate holds, or a new variable.
    fn variable_where(
        &mut self,
        unit: Unit,
        ty: ElementaryType,
        eligible: impl Fn(&Variable) -> bool,
    ) -> Option<ExpressionKind> {
        let variables = unit.variables(self.original);
        let suits = |place: &Place| {
            place.ty == Type::Elementary(ty) && variables.get(place.variable.0).is_some_and(&eligible)
        };
        let found = self
            .place(unit, |place, _| suits(place))
            .map(ExpressionKind::Read);
        found.or_else(|| self.declare_variable(unit, ty).map(ExpressionKind::Raw))
    }

    /// Creates a value of an elementary type that is no bare variable: an operation on one, where the type has operations. A constant is
    /// no operand, because its sum may not fit the type, which would be a second error.
    ///
    /// Basis: rule: constants-are-checked.
    pub fn operation(&mut self, unit: Unit, ty: ElementaryType) -> Option<ExpressionKind> {
        let kind = self.variable_where(unit, ty, |variable| variable.section != VariableSection::Constant)?;
        let operand = || Box::new(Expression::elementary(ty, kind.clone()));
        Some(match ty.family() {
            Family::Signed | Family::Unsigned | Family::Real | Family::Duration => {
                ExpressionKind::Binary(BinaryOperator::Add, operand(), operand())
            }
            Family::Boolean => ExpressionKind::Binary(BinaryOperator::And, operand(), operand()),
            Family::BitString => ExpressionKind::Unary(UnaryOperator::Not, operand()),
            _ => kind,
        })
    }

    /// Creates a bare call of a function that gives an elementary type: a conversion from another type.
    pub fn call(&mut self, unit: Unit, ty: ElementaryType) -> Option<ExpressionKind> {
        let dialect = self.original.dialect;
        let sources: Vec<_> = super::scope::types(dialect)
            .filter(|&from| from != ty && !signatures(&format!("{from}_TO_{ty}"), dialect).is_empty())
            .collect();
        let from = self.choose(sources)?;
        let argument = self.variable(unit, from)?;
        let signature = signatures(&format!("{from}_TO_{ty}"), dialect).swap_remove(0);
        Some(ExpressionKind::Convert(
            signature,
            Box::new(Expression::elementary(from, argument)),
        ))
    }
}

/// Returns the text of [`literal`].
pub(super) fn literal_text(ty: ElementaryType) -> String {
    match literal(ty).kind {
        ExpressionKind::Literal(value, LiteralForm::Typed) => value.to_string(),
        _ if ty == ElementaryType::Wstring => "\"ab\"".to_owned(),
        _ => "'ab'".to_owned(),
    }
}

/// Creates a small literal of an elementary type, with the prefix of its type. A text has no prefix, because its quotes
/// determine its type, and two characters, so that it is no single character.
pub(super) fn literal(ty: ElementaryType) -> Expression {
    const SECOND: u64 = 1_000_000_000;
    let raw = match ty.family() {
        Family::Text => {
            let form = LiteralForm::Untyped;
            let value = Value::text(ty, vec![u16::from(b'a'), u16::from(b'b')]);
            return Expression::literal(ty, value, form);
        }
        Family::Real => ty.real_bits(1.5),
        Family::Character => u64::from(b'a'),
        Family::Duration | Family::TimeOfDay => SECOND,
        Family::Date | Family::DateAndTime => 0,
        Family::Boolean | Family::Signed | Family::Unsigned | Family::BitString => 1,
    };
    Expression::literal(ty, Value::plain(ty, raw), LiteralForm::Typed)
}
