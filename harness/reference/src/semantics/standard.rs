//! Calls of the standard functions that are no conversions.
//!
//! Basis: iec-61131-3: the tables of the numeric, bit shift, selection and string functions.

use super::calls::Callee;
use super::common::{TypeRules, settle};
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::locations::VariablePlace;
use super::lowering::{LoweredValue, Lowering};
use super::promotion::PromotedOperands;
use super::standard_signatures::{StandardInput, StandardOperation, StandardSignature};
use super::suggestion::misfit;
use super::types::{TypeId, TypeKind};
use crate::conversion::implicit;
use crate::instruction::{ArithmeticOperator, Instruction, LogicOperator, StandardFunction, TextPart};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, BinaryOperator, ExpressionId, ExpressionKind};
use stickler_types::dialect::{ShiftCounts, TextPositions};
use stickler_types::{Code, ElementaryType, GenericType};

/// A function of the machine with the generic type of its values.
type TypedFunction = (StandardFunction, GenericType);

/// Returns the type that arguments are held to: the one that [`TypeRules::common_of_all`] finds. Where that does not go with all, it is
/// rather the one that is wanted of the result, if one of them has it and no more of them would be wrong.
///
/// Basis: harness/engines/README.md (a suggestion makes the program acceptable; what the call gives has to fit, too).
fn held_to(rules: TypeRules<'_>, arguments: &[Inferred], common: TypeId, wanted: Option<TypeId>) -> TypeId {
    let wrong = |ty| arguments.iter().filter(|&&one| !rules.goes_with(one, ty)).count();
    let agreed = wrong(common);
    wanted
        .filter(|&ty| agreed > 0 && arguments.contains(&Inferred::Known(ty)) && wrong(ty) <= agreed)
        .unwrap_or(common)
}

impl<'m> Lowering<'m> {
    /// Infers the type of a call of a standard function by itself.
    pub(super) fn infer_standard(
        &mut self,
        signature: &'static StandardSignature,
        arguments: &[Argument<'_>],
    ) -> Inferred {
        let Ok(values) = signature.parameters.ordered(arguments, Span::default()) else {
            return Inferred::Error;
        };
        match signature.operation {
            StandardOperation::Function(function, _) if function.own_result().is_some() => {
                function.own_result().map_or(Inferred::Error, Inferred::from)
            }
            StandardOperation::Scaled(_, duration) => Inferred::from(duration),
            StandardOperation::Compose(moment) => Inferred::from(moment),
            StandardOperation::Nanoseconds => Inferred::from(ElementaryType::Lint),
            StandardOperation::Function(function, of) => {
                self.infer_common((function, of), &signature.common(&values))
            }
            StandardOperation::Operator(operator) => self.infer_operator(operator, &values),
            StandardOperation::Prefix(operator) => self.infer_unary(operator, values[0]),
            StandardOperation::Move => self.infer(values[0]),
        }
    }

    /// Infers the type that several arguments have in common, if the function takes it.
    fn infer_common(&mut self, function: TypedFunction, values: &[ExpressionId]) -> Inferred {
        let inferred: Vec<_> = values.iter().map(|&value| self.infer(value)).collect();
        let rules = self.rules();
        if let Some(promoted) = self.promoted_call(function, &inferred) {
            return Inferred::from(promoted.result);
        }
        match self.as_real(function.0, rules.common_of_all(&inferred)) {
            Inferred::Known(ty) if !self.takes(function, ty) => Inferred::Error,
            Inferred::Known(ty) if !inferred.iter().all(|&one| rules.goes_with(one, ty)) => Inferred::Error,
            common => common,
        }
    }

    /// Returns what a function of real numbers takes arguments for that have this type in common: integers for the real type to which
    /// they convert implicitly, if there is one.
    fn as_real(&self, function: StandardFunction, common: Inferred) -> Inferred {
        let of = common.elementary().filter(|ty| ty.is_integer());
        match (function, common) {
            (StandardFunction::Real(_), Inferred::Integer(_)) => Inferred::Real,
            (StandardFunction::Real(_), Inferred::Known(_)) => {
                let dialect = self.model.source.dialect;
                let takes = |real: &ElementaryType| {
                    let is_short = *real == ElementaryType::Real && dialect.integers_as_lreal;
                    !is_short && of.is_some_and(|of| implicit(of, *real, dialect).is_some())
                };
                let mut reals = [ElementaryType::Real, ElementaryType::Lreal].into_iter();
                reals.find(takes).map_or(common, Inferred::from)
            }
            _ => common,
        }
    }

    /// Returns the types in which a function computes integers and bit strings, where it does so as operators on promoted operands do.
    fn promoted_call(&self, function: TypedFunction, arguments: &[Inferred]) -> Option<PromotedOperands> {
        let computes = match function.0 {
            StandardFunction::Abs | StandardFunction::Shl | StandardFunction::Shr => true,
            // One of several values of a type is of that type.
            StandardFunction::Min | StandardFunction::Max => {
                arguments.windows(2).any(|pair| pair[0] != pair[1])
            }
            _ => false,
        };
        let promoted = self.rules().promoted_arguments(arguments).filter(|_| computes)?;
        self.takes(function, TypeId::of(promoted.result))
            .then_some(promoted)
    }

    /// Returns whether a standard function is defined for a type.
    fn takes(&self, (function, of): TypedFunction, ty: TypeId) -> bool {
        let Some(elementary) = ty.elementary() else {
            return of == GenericType::Any && matches!(self.model.types.kind(ty), TypeKind::Enumeration(_));
        };
        let shifts_integer = function.moves_bits() && elementary.is_integer();
        let swaps_number = function == StandardFunction::SwapBytes && GenericType::Num.contains(elementary);
        if of == GenericType::String && elementary == ElementaryType::Wstring {
            return self.model.source.dialect.wide_text_functions;
        }
        of.contains(elementary)
            || swaps_number
            || shifts_integer && self.model.source.dialect.functions_promote
    }

    /// Returns whether a standard function is defined for what an argument is.
    fn takes_inferred(&self, function: TypedFunction, inferred: Inferred) -> bool {
        match inferred {
            Inferred::Known(ty) => self.takes(function, ty),
            Inferred::Text { wide, .. } => self.takes(function, TypeId::of(super::literals::text_type(wide))),
            _ => false,
        }
    }

    /// Calls a standard function.
    pub(super) fn call_standard(
        &mut self,
        call: ExpressionId,
        signature: &'static StandardSignature,
        arguments: &[Argument<'m>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let values = match signature.parameters.ordered(arguments, self.span(call)) {
            Ok(values) => values,
            Err(reason) => return self.refuse(reason, arguments),
        };
        match signature.operation {
            StandardOperation::Function(function, of) => {
                self.call_of_machine(call, signature, (function, of), &values, wanted)
            }
            StandardOperation::Operator(operator) => self.call_operator(call, operator, &values, wanted),
            StandardOperation::Prefix(operator) => self.unary(call, operator, values[0], wanted),
            StandardOperation::Scaled(operator, duration) => {
                self.call_scaled(call, operator, duration, &values)
            }
            StandardOperation::Compose(moment) => {
                for &value in &values {
                    self.integer_argument(value);
                }
                self.emit_standard(call, StandardFunction::Compose, moment, (values.len(), 0));
                LoweredValue::of(moment)
            }
            StandardOperation::Move => self.value(values[0], wanted),
            StandardOperation::Nanoseconds => {
                self.value(values[0], None);
                LoweredValue::of(ElementaryType::Lint)
            }
        }
    }

    /// Multiplies a duration of a type by a number, or divides it.
    fn call_scaled(
        &mut self,
        call: ExpressionId,
        operator: BinaryOperator,
        duration: ElementaryType,
        values: &[ExpressionId],
    ) -> LoweredValue {
        let given = self.infer(values[0]);
        if !self.rules().goes_with(given, TypeId::of(duration)) {
            self.coerce(values[0], TypeId::of(duration), ValueContext::Argument);
            self.value(values[1], None);
            return LoweredValue::ERROR;
        }
        let scaled = self.call_operator(call, operator, values, None);
        if self.model.source.dialect.scaled_to_milliseconds && duration == ElementaryType::Time {
            for operator in [ArithmeticOperator::Divide, ArithmeticOperator::Multiply] {
                self.emit(Instruction::Push(1_000_000));
                self.emit(Instruction::Arithmetic(operator, duration));
            }
        }
        scaled
    }

    /// Calls a standard function that the machine knows.
    fn call_of_machine(
        &mut self,
        call: ExpressionId,
        signature: &'static StandardSignature,
        (function, of): TypedFunction,
        values: &[ExpressionId],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let common = signature.common(values);
        let mut ty = None;
        for (position, &value) in values.iter().enumerate() {
            match signature.input(position) {
                StandardInput::Gate => {
                    self.coerce(value, TypeId::of(ElementaryType::Bool), ValueContext::Argument);
                }
                StandardInput::Integer => {
                    self.integer_argument(value);
                    let is_long = self.infer(value).elementary() == Some(ElementaryType::Ulint);
                    if of == GenericType::String && is_long {
                        self.bound(i64::MAX.cast_unsigned());
                    }
                }
                StandardInput::Common if value == common[0] => {
                    if function == StandardFunction::Mux && self.model.source.dialect.mux_outside_takes_last {
                        // A negative selector counts as larger than all.
                        self.bound(common.len() as u64 - 1);
                    }
                    ty = self.common_arguments((function, of), &common, wanted);
                }
                StandardInput::Common => {}
            }
        }
        let Some(ty) = ty else { return LoweredValue::ERROR };
        let of = ty.elementary().unwrap_or(ElementaryType::Lint);
        if matches!(function, StandardFunction::Shl | StandardFunction::Shr) {
            self.mask_shift_count(of);
        }
        let keeps = self.model.source.dialect.keeps_not_finite && of.is_real();
        let computed = match function {
            StandardFunction::Abs if keeps => StandardFunction::FiniteAbs,
            StandardFunction::Limit if keeps => StandardFunction::FiniteLimit,
            StandardFunction::Part(part, _) => {
                StandardFunction::Part(part, self.model.source.dialect.text_positions)
            }
            StandardFunction::Real(function) if self.model.source.dialect.division_stops => {
                StandardFunction::RealOrStop(function)
            }
            _ => function,
        };
        self.emit_standard(call, computed, of, (common.len(), values.len() - common.len()));
        function
            .own_result()
            .map_or(LoweredValue::computed(ty), LoweredValue::of)
    }

    /// Adds the instruction of a standard function over `count` values of a type and `numbers` integers.
    pub(super) fn emit_standard(
        &mut self,
        call: ExpressionId,
        function: StandardFunction,
        of: ElementaryType,
        (count, numbers): (usize, usize),
    ) {
        let [count, numbers] = [count, numbers].map(|count| u16::try_from(count).unwrap_or(u16::MAX));
        let instruction = Instruction::Standard {
            function,
            of,
            count,
            numbers,
        };
        self.emit_at(self.span(call), instruction);
    }

    /// Replaces the text on the stack, the result of a standard function that is assigned, where the variable does not hold it whole, if the dialect
    /// does so; returns the place at which to store it.
    pub(super) fn fit_result(
        &mut self,
        value: &ExpressionKind<'m>,
        target: ExpressionId,
        mut place: VariablePlace,
    ) -> VariablePlace {
        if self.model.source.dialect.text_positions == TextPositions::Whole
            && let ExpressionKind::Call { callee, arguments } = value
            && let TypeKind::Text { ty, capacity } = *self.model.types.kind(place.content())
            && let Callee::Standard(signature) = self.callee(*callee)
            && let StandardOperation::Function(function, _) = signature.operation
        {
            let span = self.span(target);
            let values = signature.parameters.ordered(arguments, span).unwrap_or_default();
            let text = |id: ExpressionId| self.span(id).text(self.model.source.text);
            let takes_itself = matches!(function, StandardFunction::Part(TextPart::Replace, _))
                && values
                    .get(1)
                    .is_some_and(|&by| text(by).eq_ignore_ascii_case(text(target)));
            let is_kept = function == StandardFunction::Concat;
            if is_kept {
                place.location = self.pinned(place, span);
                self.load(place);
            }
            let longest = if takes_itself { 0 } else { capacity.into() };
            self.emit(Instruction::Push(longest));
            self.emit_standard(
                target,
                StandardFunction::Fitting,
                ty,
                (1 + usize::from(is_kept), 1),
            );
        }
        place
    }

    /// Replaces a ULINT, which is on the stack, by the greatest one that is allowed where it is greater.
    fn bound(&mut self, greatest: u64) {
        self.emit(Instruction::Push(greatest));
        self.emit(Instruction::Standard {
            function: StandardFunction::Min,
            of: ElementaryType::Ulint,
            count: 2,
            numbers: 0,
        });
    }

    /// Keeps of the count of a shift, which is on the stack, the bits that a dialect looks at.
    fn mask_shift_count(&mut self, of: ElementaryType) {
        if self.model.source.dialect.shift_counts == ShiftCounts::LowBits {
            let mask = if of.bits() > 32 { 63 } else { 31 };
            self.emit(Instruction::Push(mask));
            self.emit(Instruction::Logic(LogicOperator::And));
        }
    }

    /// Puts arguments of one type on the stack, and gives that type; `None` where something is wrong.
    fn common_arguments(
        &mut self,
        function: TypedFunction,
        values: &[ExpressionId],
        wanted: Option<TypeId>,
    ) -> Option<TypeId> {
        let rules = self.rules();
        let inferred: Vec<_> = values.iter().map(|&value| self.infer(value)).collect();
        if inferred.contains(&Inferred::Error) {
            for &value in values {
                self.value(value, None);
            }
            return None;
        }
        let common = self.as_real(function.0, rules.common_of_all(&inferred));
        let ty = match common {
            Inferred::Known(ty) => Some(held_to(rules, &inferred, ty, wanted)),
            Inferred::Text { wide, .. } => Some(TypeId::of(super::literals::text_type(wide))),
            Inferred::Enumerated => wanted,
            Inferred::Integer(_) | Inferred::Real => self.settle_for(function.0, common, wanted),
            Inferred::Nothing | Inferred::Error | Inferred::Pending => None,
        };
        if let Some(promoted) = self.promoted_call(function, &inferred) {
            return self.promoted_values(values, &inferred, promoted);
        }
        let target = ty.unwrap_or(TypeId::ERROR);
        if target != TypeId::ERROR && !self.takes(function, target) {
            for (&value, &inferred) in values.iter().zip(&inferred) {
                if self.takes_inferred(function, inferred) {
                    self.value(value, None);
                } else {
                    self.refuse_argument(function, value, wanted);
                }
            }
            return None;
        }
        let mut sound = target != TypeId::ERROR;
        for &value in values {
            sound &= self.coerce(value, target, ValueContext::CommonArgument).ty != TypeId::ERROR;
        }
        if common == Inferred::Error {
            self.report_nothing_in_common(values[0]);
        }
        sound.then_some(target)
    }

    /// Reports arguments, the first of which is given, that have no type in common.
    pub(super) fn report_nothing_in_common(&mut self, first: ExpressionId) {
        let message = "the arguments have no type in common".to_owned();
        self.report(Code::FunctionCallArgTypeMismatch, self.span(first), message);
    }

    /// Puts arguments on the stack in the type in which a function computes them, and gives that type.
    fn promoted_values(
        &mut self,
        values: &[ExpressionId],
        inferred: &[Inferred],
        promoted: PromotedOperands,
    ) -> Option<TypeId> {
        let computed = TypeId::of(promoted.computed);
        let mut sound = true;
        for (&id, inferred) in values.iter().zip(inferred) {
            if let Some(from) = inferred.elementary() {
                self.warn_of_lost_value(id, TypeId::of(from), TypeId::of(promoted.result));
            }
            let value = self.value(id, Some(computed));
            sound &= self.operand(id, value, computed).ty != TypeId::ERROR;
        }
        sound.then_some(computed)
    }

    /// Returns the type of untyped arguments; what shifts bits takes DWORD or LWORD rather than an integer.
    fn settle_for(
        &self,
        function: StandardFunction,
        untyped: Inferred,
        wanted: Option<TypeId>,
    ) -> Option<TypeId> {
        let settled = settle(untyped, wanted)?;
        let shifts = function.moves_bits();
        Some(TypeId::of(match settled {
            ElementaryType::Dint if shifts && wanted.is_none() => ElementaryType::Dword,
            ElementaryType::Lint | ElementaryType::Ulint if shifts && wanted.is_none() => {
                ElementaryType::Lword
            }
            ty => ty,
        }))
    }

    /// Reports an argument of a type for which the function is not defined, with the conversion to the type that is wanted of the
    /// result. Where none is wanted nothing is suggested, for what the call would then give might not fit where it stands.
    ///
    /// Basis: harness/engines/README.md (a suggestion makes the program acceptable).
    fn refuse_argument(&mut self, function: TypedFunction, id: ExpressionId, wanted: Option<TypeId>) {
        let value = self.value(id, None);
        let inferred = self.infer(id);
        if value.ty == TypeId::ERROR && inferred != Inferred::Nothing {
            return;
        }
        let usual = match function.1 {
            GenericType::String => ElementaryType::String,
            GenericType::Num | GenericType::Real => ElementaryType::Lreal,
            _ => ElementaryType::Lword,
        };
        let usual = TypeId::of(usual);
        let wanted = match function.0 {
            function if function.own_result().is_some() => Some(usual),
            _ => wanted.filter(|&ty| self.takes(function, ty)),
        };
        let Some(target) = wanted else {
            let message = misfit(&self.model.types, inferred, usual, ValueContext::CommonArgument);
            return self.report(Code::FunctionCallArgTypeMismatch, self.span(id), message);
        };
        self.report_misfit(id, inferred, target, ValueContext::CommonArgument);
    }

    /// Lowers the count of a shift, or the selector of MUX.
    fn integer_argument(&mut self, id: ExpressionId) {
        self.integer(id, ElementaryType::Lint, ValueContext::Argument);
    }
}
