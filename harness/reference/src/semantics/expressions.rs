//! Lowers expressions: puts a value on the stack, in its own type or converted to the one that is expected.

use super::common::settle;
use super::constant::{Constant, ConstantValue};
use super::contexts::{Fit, ValueContext, elementary_value, fit};
use super::infer::{defined, defined_for};
use super::inferred::Inferred;
use super::literals::Signed;
use super::locations::check_range;
use super::lowering::{LoweredValue, Lowering};
use super::model::EnumeratedName;
use super::promotion::{prefixed, promoted};
use super::trace::UseKind;
use super::types::{Subrange, TypeId, TypeKind};
use crate::conversion::{Conversion, ConversionRule, of_operand};
use crate::instruction::Instruction;
use stickler_syntax::tree::{ExpressionId, ExpressionKind, Name, UnaryOperator};
use stickler_types::dialect::OperandTypes;
use stickler_types::{Code, Dialect, ElementaryType};

impl<'m> Lowering<'m> {
    /// Puts a value on the stack where a declared type is expected: checks that it may stand there, converts
    /// it, and checks the limits of a subrange.
    pub(super) fn coerce(&mut self, id: ExpressionId, target: TypeId, context: ValueContext) -> LoweredValue {
        let is_own = self.model.source.dialect.references_are_pointers && self.own_instance_of(id).is_some();
        let is_bound = is_own && self.model.types.pointer(target).is_some();
        if self.model.types.named_type(target) != target || is_bound {
            return self.bind_reference(id, target);
        }
        if let ExpressionKind::Aggregate(list) = &self.expression(id).kind {
            return self.aggregate(list, target);
        }
        let to = self.model.types.value_type(target);
        let inferred = self.infer(id);
        if self.refuses_reference(id, inferred, to) {
            return LoweredValue::ERROR;
        }
        if self.reports_unknown_value(id, to, context) {
            return LoweredValue::ERROR;
        }
        let flexible = self.flexible_result(id, to).map_or(inferred, Inferred::from);
        let fits = match self.refuses_derived(id, flexible, target) {
            true => Fit::No,
            false => fit(
                flexible,
                to,
                context,
                &self.model.types,
                self.model.source.dialect,
            ),
        };
        // What does not fit is lowered all the same, for what is wrong inside. A call in which something is wrong knows what
        // is wanted of it, for its suggestions.
        let bare = self.expression(self.model.source.bare(id));
        let broken_call = fits == Fit::Silent && matches!(bare.kind, ExpressionKind::Call { .. });
        let wanted = fits == Fit::Yes || broken_call && to != TypeId::ERROR;
        let value = self.value(id, wanted.then_some(to));
        if fits == Fit::No && self.refuses_derived(id, flexible, target) {
            self.report_derived(id, inferred, target, context);
            self.record_expected(id, flexible, to, false);
            return LoweredValue::ERROR;
        }
        if fits == Fit::No {
            self.report_lowered_misfit(id, inferred, value, to, context);
            self.record_expected(id, flexible, to, false);
            return LoweredValue::ERROR;
        }
        let from = match inferred {
            Inferred::Known(ty) => ty,
            _ => value.ty,
        };
        let by_number = self.constant_type(id, inferred, value, to);
        if by_number.is_some_and(|from| self.refuses_constant(id, from, to)) {
            return LoweredValue::ERROR;
        }
        self.warn_of_lost_value(id, by_number.map_or(from, TypeId::of), to);
        self.warn_of_literal(id, value, to);
        let value = self.adapt(value, to);
        self.record_expected(id, flexible, to, fits == Fit::Yes);
        self.check_limits(id, value, target)
    }

    /// Records that a value stands where an elementary type is expected.
    fn record_expected(&mut self, id: ExpressionId, value: Inferred, expected: TypeId, fits: bool) {
        if let Some(to) = expected.elementary() {
            let from = value.elementary();
            self.emitter.record(id, UseKind::Expected { from, to, fits });
        }
    }

    /// Says that a value which has been lowered does not fit. A type that is known is wrong here whatever is wrong inside; a
    /// literal that could not be read in its default type is not said to be of the wrong type as well.
    ///
    /// Basis: rule: every-mistake-is-told.
    pub(super) fn report_lowered_misfit(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        value: LoweredValue,
        expected: TypeId,
        context: ValueContext,
    ) {
        let known = matches!(inferred, Inferred::Known(_) | Inferred::Nothing);
        if known || value.ty != TypeId::ERROR {
            self.report_misfit(id, inferred, expected, context);
        }
    }

    /// Converts the value on the stack to a type that it may convert to.
    pub(super) fn adapt(&mut self, value: LoweredValue, to: TypeId) -> LoweredValue {
        if value.ty == to || self.model.types.is_same(value.ty, to) {
            return LoweredValue { ty: to, ..value };
        }
        let is_interface = || matches!(self.model.types.kind(to), TypeKind::Interface(_));
        if value.ty != TypeId::ERROR && (self.model.types.pointer(to).is_some() || is_interface()) {
            // An address is a number, and integers are kept with their sign in all 64 bits; that of an instance is a value of the interface.
            return LoweredValue::computed(to);
        }
        let dialect = self.model.source.dialect;
        let from = elementary_value(value.ty, &self.model.types, dialect);
        let converts = |(from, to)| of_operand(from, to, dialect).or_else(|| narrowed(from, to, dialect));
        let Some(conversion) = from.zip(to.elementary()).and_then(converts) else {
            return LoweredValue::ERROR;
        };
        self.emitter.convert(conversion);
        let exact = conversion.from.is_integer() && conversion.to.is_integer();
        LoweredValue {
            ty: to,
            constant: value.constant.filter(|_| exact),
        }
    }

    /// Converts the operand of a prefix operator, which is on the stack, to the type in which a dialect that promotes operands computes:
    /// for NOT of an integer the bits of its width.
    fn promoted_operand(
        &mut self,
        operator: UnaryOperator,
        value: LoweredValue,
        ty: ElementaryType,
    ) -> (LoweredValue, ElementaryType) {
        if self.model.source.dialect.operands != OperandTypes::Promoted || !ty.is_whole() {
            return (value, ty);
        }
        let computed = match operator {
            UnaryOperator::Plus => return (value, ty),
            UnaryOperator::Negate => promoted(prefixed(operator, ty, self.model.source.dialect)),
            UnaryOperator::Not => bits_of(ty),
        };
        (self.adapt(value, TypeId::of(computed)), computed)
    }

    /// Lets no value outside a subrange through to a variable that has one.
    pub(super) fn check_limits(
        &mut self,
        id: ExpressionId,
        value: LoweredValue,
        target: TypeId,
    ) -> LoweredValue {
        let TypeKind::Subrange(limits) = *self.model.types.kind(target) else {
            return value;
        };
        let Subrange { low, high, .. } = limits;
        match value.constant {
            _ if value.ty == TypeId::ERROR => {}
            Some(number) if (low..=high).contains(&number) => {}
            Some(number) => {
                let message = format!("{number} does not lie in {low}..{high}");
                self.report(Code::ConstantOverflow, self.span(id), message);
                return LoweredValue::ERROR;
            }
            None => self.emit_at(self.span(id), check_range(limits)),
        }
        value
    }

    /// Puts a value on the stack: in its own type, or where it is untyped in the type that is wanted.
    pub(super) fn value(&mut self, id: ExpressionId, wanted: Option<TypeId>) -> LoweredValue {
        let expression = self.expression(id);
        match &expression.kind {
            ExpressionKind::Literal(literal) => {
                self.literal(Signed::new(literal, false, expression.span), wanted)
            }
            ExpressionKind::Name(name) => self.name(id, *name, wanted),
            ExpressionKind::EnumeratedValue(word) => self.enumerated(word.prefix(), word.value()),
            ExpressionKind::Field { .. }
            | ExpressionKind::Index { .. }
            | ExpressionKind::Dereference { .. }
            | ExpressionKind::Bit { .. }
            | ExpressionKind::Part { .. } => self.read(id),
            ExpressionKind::Call { callee, arguments } => self.call(id, *callee, arguments, wanted),
            ExpressionKind::Unary { operator, operand } => self.unary(id, *operator, *operand, wanted),
            ExpressionKind::Binary { .. } => self.chain(id, wanted),
            ExpressionKind::Assigned { target, value } => {
                self.assignment(*target, *value);
                // What is wrong with the target has been said.
                let muted = self.reporter.mute(true);
                let value = self.read(*target);
                self.reporter.mute(muted);
                value
            }
            ExpressionKind::Parenthesized(inner) => self.value(*inner, wanted),
            ExpressionKind::Aggregate(list) => self.aggregate(list, TypeId::ERROR),
            ExpressionKind::Error => LoweredValue::ERROR,
        }
    }

    fn name(&mut self, id: ExpressionId, name: Name<'m>, wanted: Option<TypeId>) -> LoweredValue {
        if let Some((_, variable)) = self.variable(name.text) {
            return self.known(&variable.value).unwrap_or_else(|| self.read(id));
        }
        match self.enumerated_name(name.text) {
            Some(EnumeratedName::One(ty, number)) => self.enumerated_value(ty, number),
            Some(EnumeratedName::Several) => {
                let types = &self.model.types;
                let number = wanted.and_then(|ty| match types.kind(ty) {
                    TypeKind::Enumeration(enumeration) => Some((ty, *enumeration.values.find(name.text)?)),
                    _ => None,
                });
                if let Some((ty, number)) = number {
                    return self.enumerated_value(ty, number);
                }
                let text = name.text;
                let message = format!("more than one enumeration has a value `{text}`; write TYPE#{text}");
                self.report(Code::EnumValueAmbiguous, name.span, message);
                LoweredValue::ERROR
            }
            None if self.is_null(name.text) => {
                self.emit(Instruction::Push(0));
                LoweredValue::computed(TypeId::ADDRESS)
            }
            None => self.read(id),
        }
    }

    /// Puts the value of a named constant on the stack, where it is known.
    fn known(&mut self, constant: &Constant) -> Option<LoweredValue> {
        let Constant::Known(value) = constant else {
            return None;
        };
        match value {
            ConstantValue::Plain(_, raw) => self.emit(Instruction::Push(*raw)),
            ConstantValue::Text(_, units) => self.emitter.push_text(units.to_vec()),
        }
        Some(LoweredValue {
            ty: TypeId::of(value.ty()),
            constant: value.number(),
        })
    }

    fn enumerated_value(&mut self, ty: TypeId, number: i64) -> LoweredValue {
        self.emit(Instruction::Push(number.cast_unsigned()));
        LoweredValue {
            ty: self.model.types.value_type(ty),
            constant: Some(number.into()),
        }
    }

    fn enumerated(&mut self, type_name: Name<'m>, value: Name<'m>) -> LoweredValue {
        let types = &self.model.types;
        let Some(ty) = self.declared_type(type_name) else {
            let (code, message) = match ElementaryType::from_name(type_name.text) {
                Some(ty) => (
                    Code::Std2013Feature,
                    format!("{} is a type of the third edition", ty.name()),
                ),
                None => (
                    Code::EnumNotDeclared,
                    format!("enumeration `{}` is not declared", type_name.text),
                ),
            };
            self.report(code, type_name.span, message);
            return LoweredValue::ERROR;
        };
        match types.kind(ty) {
            TypeKind::Enumeration(enumeration) => match enumeration.values.find(value.text) {
                Some(&number) => self.enumerated_value(ty, number),
                None => {
                    let message = format!("`{}` has no value `{}`", types.name(ty), value.text);
                    self.report(Code::EnumValueNotDefined, value.span, message);
                    LoweredValue::ERROR
                }
            },
            TypeKind::Error => LoweredValue::ERROR,
            _ => {
                let message = format!("`{}` is no enumeration", type_name.text);
                self.report(Code::EnumNotDeclared, type_name.span, message);
                LoweredValue::ERROR
            }
        }
    }

    /// Reports a lone unknown name where an enumeration is expected as a value that the enumeration does not have, and as the initial value
    /// of a structure as that of something which is no enumeration.
    ///
    /// Basis: ironplc-problem-codes: P2006, P2004.
    fn reports_unknown_value(&mut self, id: ExpressionId, target: TypeId, context: ValueContext) -> bool {
        let ExpressionKind::Name(name) = self.expression(id).kind else {
            return false;
        };
        let (code, message) = match self.model.types.kind(target) {
            TypeKind::Enumeration(enumeration) => (
                Code::EnumValueNotDefined,
                format!("`{}` has no value `{}`", enumeration.name, name.text),
            ),
            TypeKind::Structure(_) if context == ValueContext::Initializer => (
                Code::EnumNotDeclared,
                format!(
                    "`{}` is no value of a structure, nor of an enumeration",
                    name.text
                ),
            ),
            _ => return false,
        };
        let known = self.variable(name.text).is_some() || self.enumerated_name(name.text).is_some();
        if !known {
            self.report(code, name.span, message);
        }
        !known
    }

    pub(super) fn unary(
        &mut self,
        id: ExpressionId,
        operator: UnaryOperator,
        operand: ExpressionId,
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let span = self.span(id);
        if operator == UnaryOperator::Negate
            && let ExpressionKind::Literal(literal) = &self.expression(operand).kind
            && literal.prefix().is_none()
            && self.infer_literal(literal, true).is_untyped_number()
        {
            return self.literal(Signed::new(literal, true, span), wanted);
        }
        let inferred = self.infer(operand);
        let dialect = self.model.source.dialect;
        let settled = settle(inferred, wanted).map(TypeId::of);
        let start = self.emitter.position();
        let value = self.value(operand, settled);
        if value.ty == TypeId::ERROR {
            return value;
        }
        let is_defined = |ty: &_| defined(operator, inferred, dialect) && defined_for(operator, *ty, dialect);
        let Some(ty) = value.ty.elementary().filter(is_defined) else {
            let name = self.model.types.name(value.ty);
            let message = format!("`{operator}` is not defined for {name}");
            self.report(Code::OperatorOperandTypeMismatch, span, message);
            return LoweredValue::ERROR;
        };
        let result = prefixed(operator, ty, dialect);
        self.warn_of_lost_value(operand, TypeId::of(ty), TypeId::of(result));
        let (value, ty) = self.promoted_operand(operator, value, ty);
        match operator {
            UnaryOperator::Plus => return value,
            UnaryOperator::Not => self.emit(Instruction::Not(ty)),
            UnaryOperator::Negate => {
                if let (Some(number), true) = (value.constant, ty.is_integer()) {
                    return self.folded(id, start, ty, number.checked_neg());
                }
                self.negate(start, ty);
            }
        }
        LoweredValue::computed(value.ty)
    }

    /// Negates what has been pushed since a position: right here where that is a real number, or an integer whose
    /// negative fits.
    fn negate(&mut self, start: u32, ty: ElementaryType) {
        let negative = self.emitter.pushed_since(start).and_then(|raw| match ty {
            _ if ty.is_real() => Some(opposite(ty, raw)),
            _ if ty.is_integer() => fitting(ty, ty.integer_value(raw).checked_neg()),
            _ => None,
        });
        match negative {
            Some(raw) => self.emitter.replace(1, Instruction::Push(raw)),
            None => self.emit(Instruction::Negate(ty)),
        }
    }

    /// Replaces the code of a constant expression by its result, where that fits the type.
    pub(super) fn folded(
        &mut self,
        id: ExpressionId,
        start: u32,
        ty: ElementaryType,
        number: Option<i128>,
    ) -> LoweredValue {
        match fitting(ty, number) {
            Some(raw) => {
                self.emitter.truncate(start);
                self.emit(Instruction::Push(raw));
                LoweredValue {
                    ty: TypeId::of(ty),
                    constant: number,
                }
            }
            None => {
                let (low, high) = ty.integer_range().unwrap_or((0, 0));
                let message = format!("the result does not fit {} ({low}..{high})", ty.name());
                self.report(Code::ConstantExpressionOverflow, self.span(id), message);
                LoweredValue::ERROR
            }
        }
    }
}

/// Returns the raw form of a real number with the opposite sign.
pub(super) const fn opposite(ty: ElementaryType, raw: u64) -> u64 {
    raw ^ 1 << (ty.bits() - 1)
}

/// Returns the raw form of a number that a type holds.
pub(super) fn fitting(ty: ElementaryType, number: Option<i128>) -> Option<u64> {
    let (low, high) = ty.integer_range()?;
    let number = number.filter(|number| (low..=high).contains(number))?;
    Some(ty.wrap(number))
}

/// Returns the conversion of a value that was computed with promoted operands to the narrower type that it has for the checker.
fn narrowed(from: ElementaryType, to: ElementaryType, dialect: &Dialect) -> Option<Conversion> {
    let is_promoted = dialect.operands == OperandTypes::Promoted && from.is_whole() && to.is_whole();
    let rule = ConversionRule::between(from, to, &dialect.conversions).filter(|_| is_promoted)?;
    Some(Conversion { from, to, rule })
}

/// Returns the bit string with the width of an integer or bit string.
const fn bits_of(ty: ElementaryType) -> ElementaryType {
    match ty.bits() {
        ..=8 => ElementaryType::Byte,
        9..=16 => ElementaryType::Word,
        17..=32 => ElementaryType::Dword,
        _ => ElementaryType::Lword,
    }
}
