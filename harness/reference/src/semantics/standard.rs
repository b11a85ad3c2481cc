//! The standard functions that are no conversions: their parameters and results.
//!
//! Basis: iec-61131-3: the tables of the numeric, bit shift, selection and string functions.

use super::common::{TypeRules, settle};
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::{LoweredValue, Lowering};
use super::misfit::misfit;
use super::parameters::ParameterList;
use super::promotion::PromotedOperands;
use super::types::{TypeId, TypeKind};
use crate::instruction::{Instruction, LogicOperator, StandardFunction};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId};
use stickler_types::dialect::ShiftCounts;
use stickler_types::{Code, ElementaryType};

/// Their names.
pub(super) const NAMES: [(&str, StandardFunction); 12] = [
    ("ABS", StandardFunction::Abs),
    ("SEL", StandardFunction::Sel),
    ("MUX", StandardFunction::Mux),
    ("MIN", StandardFunction::Min),
    ("MAX", StandardFunction::Max),
    ("LIMIT", StandardFunction::Limit),
    ("SHL", StandardFunction::Shl),
    ("SHR", StandardFunction::Shr),
    ("ROL", StandardFunction::Rol),
    ("ROR", StandardFunction::Ror),
    ("LEN", StandardFunction::Len),
    ("CONCAT", StandardFunction::Concat),
];

/// Finds the standard function of a name.
pub(super) fn standard_function(name: &str) -> Option<StandardFunction> {
    if !(3..=6).contains(&name.len()) {
        return None;
    }
    NAMES
        .iter()
        .find(|(known, _)| known.eq_ignore_ascii_case(name))
        .map(|&(_, function)| function)
}

fn parameters(function: StandardFunction) -> ParameterList {
    let (fixed, more, least): (&'static [&'static str], _, _) = match function {
        StandardFunction::Abs | StandardFunction::Len => (&["IN"], None, 1),
        StandardFunction::Sel => (&["G", "IN0", "IN1"], None, 3),
        StandardFunction::Mux => (&["K"], Some(("IN", 0)), 2),
        StandardFunction::Min | StandardFunction::Max => (&[], Some(("IN", 1)), 2),
        StandardFunction::Concat => (&[], Some(("IN", 1)), 2),
        StandardFunction::Limit => (&["MN", "IN", "MX"], None, 3),
        StandardFunction::Shl | StandardFunction::Shr | StandardFunction::Rol | StandardFunction::Ror => {
            (&["IN", "N"], None, 2)
        }
    };
    ParameterList { fixed, more, least }
}

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

impl Lowering<'_> {
    /// Infers the type of a call of a standard function by itself.
    pub(super) fn infer_standard(
        &mut self,
        function: StandardFunction,
        arguments: &[Argument<'_>],
    ) -> Inferred {
        let Ok(values) = parameters(function).ordered(arguments, Span::default()) else {
            return Inferred::Error;
        };
        match function {
            StandardFunction::Len => Inferred::from(ElementaryType::Int),
            _ if function.moves_bits() => self.infer_common(function, &values[..1]),
            StandardFunction::Sel | StandardFunction::Mux => self.infer_common(function, &values[1..]),
            _ => self.infer_common(function, &values),
        }
    }

    /// Infers the type that several arguments have in common, if the function takes it.
    fn infer_common(&mut self, function: StandardFunction, values: &[ExpressionId]) -> Inferred {
        let inferred: Vec<_> = values.iter().map(|&value| self.infer(value)).collect();
        let rules = self.rules();
        if let Some(promoted) = self.promoted_call(function, &inferred) {
            return Inferred::from(promoted.result);
        }
        match rules.common_of_all(&inferred) {
            Inferred::Known(ty) if !self.takes(function, ty) => Inferred::Error,
            Inferred::Known(ty) if !inferred.iter().all(|&one| rules.goes_with(one, ty)) => Inferred::Error,
            common => common,
        }
    }

    /// Returns the types in which a function computes integers and bit strings, where it does so as operators on promoted operands do.
    fn promoted_call(&self, function: StandardFunction, arguments: &[Inferred]) -> Option<PromotedOperands> {
        let computes = match function {
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
    fn takes(&self, function: StandardFunction, ty: TypeId) -> bool {
        let Some(elementary) = ty.elementary() else {
            let enumerated = matches!(self.model.types.kind(ty), TypeKind::Enumeration(_));
            return enumerated && matches!(function, StandardFunction::Sel | StandardFunction::Mux);
        };
        match function {
            StandardFunction::Abs => elementary.is_integer() || elementary.is_real(),
            _ if function.moves_bits() => {
                elementary.is_bit_string()
                    || elementary == ElementaryType::Bool
                    || elementary.is_integer() && self.model.source.dialect.functions_promote
            }
            StandardFunction::Len | StandardFunction::Concat => elementary.is_text(),
            _ => true,
        }
    }

    /// Returns whether a standard function is defined for what an argument is.
    fn takes_inferred(&self, function: StandardFunction, inferred: Inferred) -> bool {
        match inferred {
            Inferred::Known(ty) => self.takes(function, ty),
            Inferred::Text { wide, .. } => self.takes(function, TypeId::of(super::literals::text_type(wide))),
            _ => false,
        }
    }

    /// Calls a standard function.
    pub(super) fn call_standard(
        &mut self,
        call: Span,
        function: StandardFunction,
        arguments: &[Argument<'_>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let values = match parameters(function).ordered(arguments, call) {
            Ok(values) => values,
            Err(reason) => return self.refuse(reason, arguments),
        };
        let (common, selector): (&[_], _) = match function {
            StandardFunction::Sel | StandardFunction::Mux => (&values[1..], Some(values[0])),
            _ if function.moves_bits() => (&values[..1], None),
            _ => (&values, None),
        };
        match (function, selector) {
            (StandardFunction::Sel, Some(selector)) => {
                self.coerce(selector, TypeId::BOOL, ValueContext::Argument);
            }
            (_, Some(selector)) => {
                self.integer_argument(selector);
                self.bound_selector(common.len());
            }
            _ => {}
        }
        let ty = self.common_arguments(function, common, wanted);
        if common.len() < values.len() && selector.is_none() {
            self.integer_argument(values[1]);
        }
        let Some(ty) = ty else { return LoweredValue::ERROR };
        let of = ty.elementary().unwrap_or(ElementaryType::Lint);
        if matches!(function, StandardFunction::Shl | StandardFunction::Shr) {
            self.mask_shift_count(of);
        }
        let count = u16::try_from(common.len()).unwrap_or(u16::MAX);
        self.emit_at(call, Instruction::Standard { function, of, count });
        match function {
            StandardFunction::Len => LoweredValue::of(ElementaryType::Int),
            _ => LoweredValue::computed(ty),
        }
    }

    /// Replaces the selector of MUX, which is on the stack, by that of the last input where it is negative or too large, if the dialect does so.
    fn bound_selector(&mut self, inputs: usize) {
        if self.model.source.dialect.mux_outside_takes_last {
            self.emit(Instruction::Push(inputs as u64 - 1));
            // A negative selector counts as larger than all.
            self.emit(Instruction::Standard {
                function: StandardFunction::Min,
                of: ElementaryType::Ulint,
                count: 2,
            });
        }
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
        function: StandardFunction,
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
        let common = rules.common_of_all(&inferred);
        let ty = match common {
            Inferred::Known(ty) => Some(held_to(rules, &inferred, ty, wanted)),
            Inferred::Text { wide, .. } => Some(TypeId::of(super::literals::text_type(wide))),
            Inferred::Enumerated => wanted,
            Inferred::Integer(_) | Inferred::Real => self.settle_for(function, common, wanted),
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
            let message = "the arguments have no type in common".to_owned();
            self.report(Code::FunctionCallArgTypeMismatch, self.span(values[0]), message);
        }
        sound.then_some(target)
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
    fn refuse_argument(&mut self, function: StandardFunction, id: ExpressionId, wanted: Option<TypeId>) {
        let value = self.value(id, None);
        let inferred = self.infer(id);
        if value.ty == TypeId::ERROR && inferred != Inferred::Nothing {
            return;
        }
        let usual = match function {
            StandardFunction::Len | StandardFunction::Concat => ElementaryType::String,
            StandardFunction::Abs => ElementaryType::Lreal,
            _ => ElementaryType::Lword,
        };
        let usual = TypeId::of(usual);
        let wanted = match function {
            StandardFunction::Len => Some(usual),
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
