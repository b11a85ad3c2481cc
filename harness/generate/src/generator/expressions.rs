//! Expressions of a wanted type: which kind, and the leaves.

use super::features::Feature;
use super::literals;
use super::maker::Maker;
use super::operations::binary;
use crate::model::{Expression, ExpressionKind, LiteralForm, Type};
use stickler_types::{ElementaryType, Family};

/// What the place of an expression asks of it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Wanted {
    /// Its text has the type by itself: it is an operand of something that takes several types.
    Exact,
    /// The other operand of an operator, whose text has the type by itself.
    Operand,
    /// What an assignment assigns.
    Assigned,
    /// What is passed to a parameter.
    Argument,
    /// An initial value.
    Initial,
}

/// The kinds of expressions that are more than a leaf.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Kind {
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

/// Kinds with their weights.
#[derive(Default)]
struct Menu {
    kinds: [Option<Kind>; 16],
    weights: [u16; 16],
    length: usize,
}

impl Menu {
    fn offer(&mut self, kind: Kind, weight: u16, offered: bool) {
        if offered && self.length < self.kinds.len() {
            self.kinds[self.length] = Some(kind);
            self.weights[self.length] = weight;
            self.length += 1;
        }
    }
}

impl Maker<'_, '_> {
    /// An expression of an elementary type, at most `depth` levels deep.
    pub fn value(&mut self, ty: ElementaryType, wanted: Wanted, depth: usize) -> Expression {
        if depth == 0 || self.nodes_left == 0 || self.random.is_exhausted() {
            return self.leaf(ty, wanted);
        }
        self.nodes_left -= 1;
        let menu = self.menu(ty, wanted);
        let chosen = self.random.weighted(&menu.weights[..menu.length]);
        let kind = menu.kinds[chosen].unwrap_or(Kind::Leaf);
        let made = self.of_kind(kind, ty, wanted, depth - 1);
        made.unwrap_or_else(|| self.leaf(ty, wanted))
    }

    /// What the program may use to make a value of this type.
    fn menu(&self, ty: ElementaryType, wanted: Wanted) -> Menu {
        use Feature as F;
        let family = ty.family();
        let is_number = matches!(family, Family::Signed | Family::Unsigned | Family::Real);
        let is_logical = matches!(family, Family::Boolean | Family::BitString);
        let is_boolean = family == Family::Boolean;
        let widens = wanted != Wanted::Exact && !self.language.sources(ty).is_empty();
        let mut menu = Menu::default();
        menu.offer(Kind::Leaf, 4, true);
        let adds = is_number || (ty == ElementaryType::Time || ty == ElementaryType::Ltime);
        menu.offer(Kind::Arithmetic, 6, adds && self.has(F::Arithmetic));
        menu.offer(Kind::Division, 3, is_number && self.has(F::Division));
        let negates = matches!(family, Family::Signed | Family::Real);
        menu.offer(Kind::Negation, 1, negates && self.has(F::Arithmetic));
        menu.offer(Kind::Logic, 6, is_logical && self.has(F::Logic));
        menu.offer(Kind::Not, 2, is_logical && self.has(F::Logic));
        menu.offer(Kind::Comparison, 5, is_boolean && self.has(F::Comparisons));
        let bits = is_boolean && self.has(F::Bits) && self.language.has_bits(self.open);
        menu.offer(Kind::Bit, 5, bits);
        menu.offer(Kind::Widened, 5, widens && self.has(F::Widening));
        menu.offer(Kind::Conversion, 5, self.has(F::Conversions));
        menu.offer(Kind::Selection, 2, self.has(F::Selection));
        menu.offer(Kind::Extremum, 2, is_number && self.has(F::Selection));
        menu.offer(Kind::Absolute, 1, is_number && self.has(F::Selection));
        menu.offer(Kind::Shift, 4, family == Family::BitString && self.has(F::Shifts));
        menu.offer(
            Kind::Length,
            2,
            ty == ElementaryType::Int && self.has(F::Selection),
        );
        menu.offer(
            Kind::Concatenation,
            5,
            family == Family::Text && self.has(F::Selection),
        );
        menu.offer(Kind::Call, 4, !self.program.functions.is_empty());
        menu
    }

    fn of_kind(
        &mut self,
        kind: Kind,
        ty: ElementaryType,
        wanted: Wanted,
        depth: usize,
    ) -> Option<Expression> {
        match kind {
            Kind::Leaf => None,
            Kind::Arithmetic => self.arithmetic(ty, depth),
            Kind::Division => self.division(ty, depth),
            Kind::Negation => self.negation(ty, depth),
            Kind::Logic => Some(self.logic(ty, depth)),
            Kind::Not => Some(self.complement(ty, depth)),
            Kind::Comparison => Some(self.comparison(depth)),
            Kind::Bit => self.bit(),
            Kind::Widened => self.widened(ty, wanted, depth),
            Kind::Conversion => self.conversion(ty, wanted, depth),
            Kind::Selection => Some(self.selection(ty, depth)),
            Kind::Extremum => Some(self.extremum(ty, depth)),
            Kind::Absolute => self.absolute(ty, depth),
            Kind::Shift => Some(self.shift(ty, depth)),
            Kind::Length => Some(self.length(depth)),
            Kind::Concatenation => Some(self.concatenation(ty, depth)),
            Kind::Call => self.call(&Type::Elementary(ty), depth),
        }
    }

    /// A variable, or part of one, or a literal.
    pub fn leaf(&mut self, ty: ElementaryType, wanted: Wanted) -> Expression {
        if self.random.chance(1, 4) {
            return self.literal(ty, wanted);
        }
        let read = self.read(&Type::Elementary(ty), false);
        let made = match ty {
            ElementaryType::Bool => read.or_else(|| self.small_condition()),
            _ => read,
        };
        made.unwrap_or_else(|| self.literal(ty, wanted))
    }

    /// A bit, or a variable compared with a literal: for programs that have no variable of type BOOL.
    fn small_condition(&mut self) -> Option<Expression> {
        if self.has(Feature::Bits) && self.language.has_bits(self.open) && self.random.chance(1, 2) {
            return self.bit();
        }
        let pou = &self.pou;
        let seen = |ty: &ElementaryType| *ty != ElementaryType::Bool && pou.varies(*ty);
        let ty = *self.random.pick_where(&self.palette, seen)?;
        let operator = self.comparison_operator(ty);
        let left = self.read(&Type::Elementary(ty), true)?;
        let right = self.compared(&left, ty, 0);
        Some(binary(operator, left, right, ElementaryType::Bool))
    }

    /// A literal, with the prefix of its type unless the context allows to leave it away.
    pub fn literal(&mut self, ty: ElementaryType, wanted: Wanted) -> Expression {
        let value = literals::value(ty, &mut self.random);
        let form = self.form(ty, wanted);
        elementary(ty, ExpressionKind::Literal(value, form))
    }

    /// How a literal is written in a context.
    pub fn form(&mut self, ty: ElementaryType, wanted: Wanted) -> LiteralForm {
        // A prefix before a text is rare, and so are compilers that know it.
        let prefixed = if ty.is_text() { 1 } else { 4 };
        let bare = self.has(Feature::Untyped) && !self.random.chance(prefixed, 16);
        if bare && self.language.takes_untyped(ty, wanted) {
            LiteralForm::Untyped
        } else {
            LiteralForm::Typed
        }
    }

    /// A value that a narrower type has, without a call.
    pub fn widened(&mut self, ty: ElementaryType, wanted: Wanted, depth: usize) -> Option<Expression> {
        let from = self.source(ty, wanted)?;
        let operand = self.value(from, Wanted::Exact, depth);
        Some(elementary(ty, ExpressionKind::Widen(Box::new(operand))))
    }

    /// A type that becomes `ty` without a call: rather one that variables have.
    fn source(&mut self, ty: ElementaryType, wanted: Wanted) -> Option<ElementaryType> {
        let sources = self.language.sources(ty);
        let start = self.random.below(sources.len());
        // Beside an operator UDINT and TIME, which convert both ways, might as well be a duration and its factor.
        let suits =
            |from: &ElementaryType| wanted != Wanted::Operand || ty.is_duration() == from.is_duration();
        let from_here = || {
            sources[start..]
                .iter()
                .chain(&sources[..start])
                .copied()
                .filter(suits)
        };
        let seen = from_here().find(|&from| self.pou.varies(from));
        seen.or_else(|| from_here().next())
    }

    /// A value that no compiler can compute: one of a variable, or a conversion of one. Nothing where there is no such.
    ///
    /// Arithmetic begins with one, for arithmetic on constants that overflows is an error (P4040).
    pub fn varying(&mut self, ty: ElementaryType, depth: usize) -> Option<Expression> {
        let adds = ty.is_integer() || ty.is_real();
        let goes_on = depth > 0 && self.nodes_left > 0 && self.random.chance(1, 3);
        if adds && goes_on && self.has(Feature::Arithmetic) {
            self.nodes_left -= 1;
            let made = self.arithmetic(ty, depth - 1);
            if made.is_some() {
                return made;
            }
        }
        if let Some(read) = self.read(&Type::Elementary(ty), true) {
            return Some(read);
        }
        if !self.has(Feature::Conversions) {
            return None;
        }
        self.converted_variable(ty)
    }

    /// A condition.
    pub fn condition(&mut self) -> Expression {
        let depth = self.deepest.min(3);
        if self.random.chance(1, 4) {
            self.value(ElementaryType::Bool, Wanted::Exact, depth)
        } else {
            self.comparison(depth)
        }
    }
}

/// An expression of an elementary type.
pub(super) fn elementary(ty: ElementaryType, kind: ExpressionKind) -> Expression {
    Expression {
        ty: Type::Elementary(ty),
        kind,
    }
}
