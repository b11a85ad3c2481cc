//! Expressions of a given type: the choice of their form, and leaves.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::literals;
use crate::model::{Expression, LiteralForm, Type};
use stickler_types::{ElementaryType, Family, Value};

/// The forms of an expression that the generator chooses from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum ExpressionForm {
    Leaf,
    Arithmetic,
    Division,
    Negation,
    Logic,
    Not,
    Comparison,
    Bit,
    Widened,
    Conversion,
    Selection,
    Extremum,
    Absolute,
    Shift,
    Length,
    Concatenation,
    Call,
}

impl ProgramBuilder<'_, '_> {
    /// Generates an expression of an elementary type, at most `depth` levels deep.
    pub fn value(&mut self, ty: ElementaryType, context: TypeContext, depth: usize) -> Expression {
        if depth == 0 || self.nodes_left == 0 || self.random.is_exhausted() {
            return self.leaf(ty, context);
        }
        self.nodes_left -= 1;
        let forms = self.forms(ty, context);
        let kind = forms[self.random.weighted(&forms.map(|(_, weight)| weight))].0;
        let made = self.of_kind(kind, ty, context, depth - 1);
        made.unwrap_or_else(|| self.leaf(ty, context))
    }

    /// Returns the forms of a value of a type with their weights; 0 for those that the program may not use.
    fn forms(&self, ty: ElementaryType, context: TypeContext) -> [(ExpressionForm, u16); 17] {
        use Construct as F;
        use ExpressionForm as E;
        let family = ty.family();
        let is_number = matches!(family, Family::Signed | Family::Unsigned | Family::Real);
        let is_boolean = family == Family::Boolean;
        let is_stored = context == TypeContext::Assigned;
        let wraps = is_stored || !self.profile.computes_wider(ty);
        let is_logical = matches!(family, Family::Boolean | Family::BitString)
            && (is_stored || self.profile.keeps_bit_strings(ty));
        let is_of_two = context == TypeContext::Operand && !self.profile.mixes_operands();
        let widens = context != TypeContext::Exact && !is_of_two && !self.profile.sources(ty).is_empty();
        let adds = is_number || (ty == ElementaryType::Time || ty == ElementaryType::Ltime);
        let negates = is_number && wraps && self.profile.negates(ty);
        let bits = is_boolean && self.has(F::Bits) && self.profile.has_bits(self.open);
        let selects = self.has(F::Selection);
        let shifts = family == Family::BitString && wraps && self.has(F::Shifts);
        let weight = |offered: bool, weight: u16| if offered { weight } else { 0 };
        [
            (E::Leaf, 4),
            (E::Arithmetic, weight(adds && wraps && self.has(F::Arithmetic), 6)),
            (E::Division, weight(is_number && self.has(F::Division), 3)),
            (E::Negation, weight(negates && self.has(F::Arithmetic), 1)),
            (E::Logic, weight(is_logical && self.has(F::Logic), 6)),
            (E::Not, weight(is_logical && wraps && self.has(F::Logic), 2)),
            (E::Comparison, weight(is_boolean && self.has(F::Comparisons), 5)),
            (E::Bit, weight(bits, 5)),
            (E::Widened, weight(widens && self.has(F::Widening), 5)),
            (E::Conversion, weight(self.has(F::Conversions), 5)),
            (E::Selection, weight(selects, 2)),
            (E::Extremum, weight(is_number && selects, 2)),
            (E::Absolute, weight(is_number && selects, 1)),
            (E::Shift, weight(shifts, 4)),
            (E::Length, weight(ty == ElementaryType::Int && selects, 2)),
            (E::Concatenation, weight(family == Family::Text && selects, 5)),
            (E::Call, weight(!self.program.functions.is_empty(), 4)),
        ]
    }

    fn of_kind(
        &mut self,
        kind: ExpressionForm,
        ty: ElementaryType,
        context: TypeContext,
        depth: usize,
    ) -> Option<Expression> {
        match kind {
            ExpressionForm::Leaf => None,
            ExpressionForm::Arithmetic => self.arithmetic(ty, depth),
            ExpressionForm::Division => self.division(ty, depth),
            ExpressionForm::Negation => self.negation(ty, depth),
            ExpressionForm::Logic => Some(self.logic(ty, depth)),
            ExpressionForm::Not => Some(self.complement(ty, depth)),
            ExpressionForm::Comparison => Some(self.comparison(depth)),
            ExpressionForm::Bit => self.bit(),
            ExpressionForm::Widened => self.widened(ty, context, depth),
            ExpressionForm::Conversion => self.conversion(ty, context, depth),
            ExpressionForm::Selection => Some(self.selection(ty, depth)),
            ExpressionForm::Extremum => Some(self.extremum(ty, depth)),
            ExpressionForm::Absolute => self.absolute(ty, depth),
            ExpressionForm::Shift => Some(self.shift(ty, depth)),
            ExpressionForm::Length => Some(self.length(depth)),
            ExpressionForm::Concatenation => self.concatenation(ty, depth),
            ExpressionForm::Call => self.call(&Type::Elementary(ty), depth),
        }
    }

    /// Generates a variable, a part of one, or a literal.
    pub fn leaf(&mut self, ty: ElementaryType, context: TypeContext) -> Expression {
        if self.random.chance(1, 4) {
            return self.literal(ty, context);
        }
        let read = self.read(&Type::Elementary(ty), false);
        let made = match ty {
            ElementaryType::Bool => read.or_else(|| self.small_condition()),
            _ => read,
        };
        made.unwrap_or_else(|| self.literal(ty, context))
    }

    /// Generates a bit, or a comparison of a variable with a literal: for programs without a variable of type BOOL.
    fn small_condition(&mut self) -> Option<Expression> {
        if self.has(Construct::Bits) && self.profile.has_bits(self.open) && self.random.chance(1, 2) {
            return self.bit();
        }
        let pou = &self.pou;
        let seen = |ty: &ElementaryType| *ty != ElementaryType::Bool && pou.varies(*ty);
        let ty = *self.random.pick_where(&self.palette, seen)?;
        let operator = self.comparison_operator(ty);
        let left = self.read(&Type::Elementary(ty), true)?;
        let right = self.compared(&left, ty, 0);
        Some(Expression::binary(operator, left, right, ElementaryType::Bool))
    }

    /// Generates a literal, with the prefix of its type unless the context allows to omit it.
    pub fn literal(&mut self, ty: ElementaryType, context: TypeContext) -> Expression {
        let value = self.drawn(ty);
        let form = self.form(ty, context);
        if form == LiteralForm::Typed
            && self.lacks_typed(ty)
            && let Some(read) = self.read(&Type::Elementary(ty), false)
        {
            return read;
        }
        Expression::literal(ty, value, form)
    }

    /// Draws a value of a type; 0 in place of one that the dialect does not have.
    pub fn drawn(&mut self, ty: ElementaryType) -> Value {
        let value = literals::value(ty, &mut self.random);
        match self.profile.holds(&value) {
            true => value,
            false => Value::plain(ty, 0),
        }
    }

    /// Returns whether the program shall do without literals with this type.
    pub fn lacks_typed(&self, ty: ElementaryType) -> bool {
        !self.lacking.is_empty() && (self.lacks("typed-literal") || self.lacks(&format!("{ty}#")))
    }

    /// Chooses whether a literal has the prefix of its type in a context.
    pub fn form(&mut self, ty: ElementaryType, context: TypeContext) -> LiteralForm {
        // A prefix before a text is rare, and so are compilers that know it.
        let prefixed = if ty.is_text() { 1 } else { 4 };
        let bare = self.has(Construct::Untyped) && !self.random.chance(prefixed, 16);
        let takes_untyped =
            self.profile.takes_untyped(ty, context) && !self.profile.types_operands(ty, context);
        if (bare || self.lacks_typed(ty)) && takes_untyped {
            LiteralForm::Untyped
        } else {
            LiteralForm::Typed
        }
    }

    /// Generates a value of a narrower type, converted implicitly.
    pub fn widened(&mut self, ty: ElementaryType, context: TypeContext, depth: usize) -> Option<Expression> {
        let from = self.source(ty, context)?;
        let operand = self.value(from, TypeContext::Exact, depth);
        Some(Expression::widened(Type::Elementary(ty), operand))
    }

    /// Picks a type that converts implicitly to `ty`, preferably one that variables have.
    fn source(&mut self, ty: ElementaryType, context: TypeContext) -> Option<ElementaryType> {
        let sources = self.profile.sources(ty);
        let start = self.random.below(sources.len());
        // Beside an operator UDINT and TIME, which convert both ways, might also be read as a duration and its factor.
        let suits =
            |from: &ElementaryType| context != TypeContext::Operand || ty.is_duration() == from.is_duration();
        let from_here = || {
            sources[start..]
                .iter()
                .chain(&sources[..start])
                .copied()
                .filter(suits)
        };
        let seen = from_here().find(|&from| self.pou.varies(from));
        let found = seen.or_else(|| from_here().next());
        found.filter(|from| self.lacking.is_empty() || !self.lacks(&format!("{from} to {ty}")))
    }

    /// Generates a value that no compiler can compute: that of a variable, or a conversion of one; `None` if there is none.
    ///
    /// Arithmetic starts with such a value, because overflow in constant arithmetic is an error (P4040).
    pub fn varying(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        let adds = ty.is_number();
        let goes_on = depth > 0 && self.nodes_left > 0 && self.random.chance(1, 3);
        if adds && goes_on && self.has(Construct::Arithmetic) && !self.profile.computes_wider(ty) {
            self.nodes_left -= 1;
            let made = self.arithmetic(ty, depth - 1);
            if made.is_some() {
                return made;
            }
        }
        if let Some(read) = self.read(&Type::Elementary(ty), true) {
            return Some(read);
        }
        if !self.has(Construct::Conversions) {
            return None;
        }
        self.converted_variable(ty)
    }

    /// Generates a condition.
    pub fn condition(&mut self) -> Expression {
        let depth = self.deepest.min(3);
        if self.random.chance(1, 4) {
            self.value(ElementaryType::Bool, TypeContext::Exact, depth)
        } else {
            self.comparison(depth)
        }
    }
}
