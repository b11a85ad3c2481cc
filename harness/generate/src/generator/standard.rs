//! Calls of standard functions other than conversions.

use super::builder::ProgramBuilder;
use super::{TypeContext, literals};
use crate::model::{Expression, ExpressionKind, LiteralForm, StandardFunction as Function, integer};
use stickler_types::{ElementaryType, Family, Value};

impl ProgramBuilder<'_, '_> {
    /// Generates SEL or MUX.
    pub fn selection(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        if self.random.chance(1, 3) {
            let count = 2 + self.random.below(2);
            let mut arguments = vec![self.selector(count as i64 - 1)];
            arguments.extend((0..count).map(|_| self.value(ty, TypeContext::Exact, depth)));
            return Expression::standard(Function::Mux, arguments, ty);
        }
        let condition = self.value(ElementaryType::Bool, TypeContext::Exact, depth);
        let first = self.value(ty, TypeContext::Exact, depth);
        let second = self.value(ty, TypeContext::Exact, depth);
        Expression::standard(Function::Sel, vec![condition, first, second], ty)
    }

    /// Generates an INT from 0 to a limit.
    fn selector(&mut self, most: i64) -> Expression {
        let limited = self.limited(ElementaryType::Int, 0, most);
        limited.unwrap_or_else(|| {
            integer(
                ElementaryType::Int,
                self.random.between(0, most),
                LiteralForm::Typed,
            )
        })
    }

    /// Generates MIN, MAX or LIMIT.
    pub fn extremum(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        let (function, count) =
            [(Function::Min, 2), (Function::Max, 2), (Function::Limit, 3)][self.random.below(3)];
        if function == Function::Limit {
            return self.limit(ty, depth);
        }
        let arguments = (0..count).map(|_| self.value(ty, TypeContext::Exact, depth));
        let arguments = arguments.collect();
        Expression::standard(function, arguments, ty)
    }

    /// Generates LIMIT with a lower limit not above the upper one; no document states the result otherwise.
    fn limit(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        let mut limits = [
            literals::value(ty, &mut self.random),
            literals::value(ty, &mut self.random),
        ];
        if is_above(&limits[0], &limits[1]) {
            limits.swap(0, 1);
        }
        let [low, high] = limits.map(|limit| Expression::literal(ty, limit, LiteralForm::Typed));
        let inner = self.value(ty, TypeContext::Exact, depth);
        Expression::standard(Function::Limit, vec![low, inner, high], ty)
    }

    /// Generates ABS, of a signed integer limited to exclude the least one, whose negation overflows.
    pub fn absolute(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        let operand = self.varying(ty, depth)?;
        let operand = match (ty.family(), ty.integer_range()) {
            (Family::Signed, Some((least, greatest))) => {
                let limit = |number: i128| {
                    Expression::literal(ty, Value::plain(ty, ty.wrap(number)), LiteralForm::Typed)
                };
                let arguments = vec![limit(least + 1), operand, limit(greatest)];
                Expression::standard(Function::Limit, arguments, ty)
            }
            _ => operand,
        };
        let absolute = Expression::standard(Function::Abs, vec![operand], ty);
        // Of the functions of real numbers this one alone has a result that is exact.
        if ty.is_real() && !self.lacks("sqrt") && self.random.chance(1, 2) {
            return Some(Expression::standard(Function::SquareRoot, vec![absolute], ty));
        }
        Some(absolute)
    }

    /// Generates SHL, SHR, ROL or ROR by fewer bits than the type has; with open constructs sometimes by more.
    pub fn shift(&mut self, ty: ElementaryType, depth: usize) -> Expression {
        let functions = [Function::Shl, Function::Shr, Function::Rol, Function::Ror];
        let function = functions[self.random.below(functions.len())];
        let operand = self.value(ty, TypeContext::Exact, depth);
        // With open constructs a shift may be longer than its operand.
        let last = i64::from(ty.bits()) - 1;
        let most = last + if self.open { 2 } else { 0 };
        let count = if self.random.chance(1, 2) {
            let edges = [0, 1, last, most];
            integer(
                ElementaryType::Int,
                edges[self.random.below(edges.len())],
                LiteralForm::Typed,
            )
        } else {
            self.selector(most)
        };
        Expression::standard(function, vec![operand, count], ty)
    }

    /// Generates LEN, or FIND of a text that is not empty.
    pub fn length(&mut self, depth: usize) -> Expression {
        let operand = self.value(ElementaryType::String, TypeContext::Exact, depth.min(1));
        let sought = self.literal(ElementaryType::String, TypeContext::Exact);
        let is_found = matches!(&sought.kind, ExpressionKind::Literal(Value::Text { units, .. }, _) if !units.is_empty());
        let (function, arguments) = match is_found && !self.lacks("find") && self.random.chance(1, 2) {
            true => (Function::Find, vec![operand, sought]),
            false => (Function::Len, vec![operand]),
        };
        Expression::standard(function, arguments, ElementaryType::Int)
    }

    /// Generates CONCAT of a text and a literal, or LEFT or RIGHT of a text; nothing where the dialect has them not for the type.
    pub fn concatenation(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        if ty == ElementaryType::Wstring && !self.profile.dialect.rules().wide_text_functions {
            return None;
        }
        let text = self.value(ty, TypeContext::Exact, depth.min(2));
        let function = [Function::Left, Function::Right][self.random.below(2)];
        let key = if function == Function::Left {
            "left"
        } else {
            "right"
        };
        if self.random.chance(1, 3) && !self.lacks(key) {
            let count = integer(ElementaryType::Int, self.random.between(0, 9), LiteralForm::Typed);
            return Some(Expression::standard(function, vec![text, count], ty));
        }
        let more = self.literal(ty, TypeContext::Exact);
        let arguments = if self.random.chance(1, 2) {
            vec![more, text]
        } else {
            vec![text, more]
        };
        Some(Expression::standard(Function::Concat, arguments, ty))
    }
}

/// Returns whether a number is greater than another of its type.
fn is_above(one: &Value, other: &Value) -> bool {
    let (&Value::Plain { ty, raw }, &Value::Plain { raw: other, .. }) = (one, other) else {
        return false;
    };
    match (ty.real_value(raw), ty.real_value(other)) {
        (Some(one), Some(other)) => one > other,
        _ => ty.integer_value(raw) > ty.integer_value(other),
    }
}
