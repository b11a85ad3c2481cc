//! Calls of functions and function blocks that the text declares: passes the arguments, calls, and brings back
//! what comes of it.
//!
//! All arguments are evaluated before any is stored in the callee's frame, and the result is taken out of the
//! frame before any output is looked at, so that `F(F(1))` and `F(q => a[F(2)])` do what they say.

use super::arguments::{BoundArguments, Capture};
use super::contexts::{Fit, ValueContext, fit};
use super::inferred::Inferred;
use super::limits::LIMIT;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::methods::Entrance;
use super::model::{DeclaredVariable, Storage};
use super::trace::UseKind;
use super::types::{TypeId, TypeKind};
use crate::conversion::{Conversion, ConversionRule};
use crate::instruction::Instruction;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId, ExpressionKind, VariableKind};
use stickler_types::{Code, ElementaryType};

/// The type that a cell with an address counts as.
const ADDRESS: TypeId = TypeId::of(ElementaryType::Ulint);

impl<'m> Lowering<'m> {
    /// Calls a function; its result is left on the stack where it is `used`.
    pub(super) fn call_function(
        &mut self,
        span: Span,
        pou: u32,
        arguments: &[Argument<'m>],
        used: bool,
    ) -> LoweredValue {
        self.note_call(pou, span);
        self.call_entered(span, pou, Entrance::Function, arguments, used)
    }

    /// Calls a function or a method, its instance having been found.
    pub(super) fn call_entered(
        &mut self,
        span: Span,
        pou: u32,
        entrance: Entrance,
        arguments: &[Argument<'m>],
        used: bool,
    ) -> LoweredValue {
        let entry = &self.model.pous[pou as usize];
        let result = entry.result.map(|result| self.model.variable(result));
        let value = match result {
            Some(result) => LoweredValue::computed(self.model.types.value_type(result.ty)),
            None => LoweredValue::ERROR,
        };
        let Some(bound) = self.bind(pou, arguments, span) else {
            return value;
        };
        let places = self.pass(&bound, None);
        if bound.omitted {
            self.emit(Instruction::Call(entry.initial));
        }
        self.finish_passing(places, span);
        self.emit_entrance(span, pou, entrance);
        if let (Some(result), true) = (result, used) {
            self.take_result(result, span);
        }
        self.capture(&bound.captures, None, span);
        value
    }

    /// Puts the result of a function on the stack. An aggregate is copied, for the next call overwrites it.
    fn take_result(&mut self, result: &'m DeclaredVariable<'m>, span: Span) {
        let place = VariablePlace::of(result);
        if self.is_aggregate(result.ty) {
            let address = self.temporary_of(result.ty, span);
            let copy = VariablePlace {
                location: Location::Absolute(address),
                ..place
            };
            self.begin_store(copy);
            self.load(place);
            self.finish_store(copy, span);
            self.load(copy);
        } else {
            self.load(place);
        }
    }

    /// Calls an instance of a function block.
    pub(super) fn call_block(
        &mut self,
        span: Span,
        instance: ExpressionId,
        pou: u32,
        arguments: &[Argument<'m>],
    ) {
        self.note_call(pou, span);
        let Some(place) = self.place(instance) else {
            return self.lower_arguments(arguments);
        };
        let location = self.pinned(place, span);
        let Some(bound) = self.bind(pou, arguments, span) else {
            return;
        };
        let places = self.pass(&bound, Some(location));
        self.finish_passing(places, span);
        self.push_address(location);
        self.emit(Instruction::CallInstance(self.model.pous[pou as usize].body));
        self.capture(&bound.captures, Some(location), span);
    }

    /// Returns where a variable of the callee lies for the caller; of a VAR_IN_OUT, the cell for the address.
    pub(super) fn outside(
        &mut self,
        variable: &DeclaredVariable<'_>,
        instance: Option<Location>,
    ) -> VariablePlace {
        let (location, ty) = match (variable.storage, instance) {
            (Storage::Instance(offset), Some(base)) => (self.shifted(base, offset), variable.ty),
            (Storage::InstancePointer(cell), Some(base)) => (self.shifted(base, cell), ADDRESS),
            (Storage::AbsolutePointer(cell), _) => (Location::Absolute(cell), ADDRESS),
            (storage, _) => (Location::of(storage), variable.ty),
        };
        VariablePlace::new(location, ty)
    }

    /// Evaluates the arguments and leaves them on the stack; gives the places where they belong.
    fn pass(&mut self, bound: &BoundArguments, instance: Option<Location>) -> Vec<VariablePlace> {
        let mut places = Vec::with_capacity(bound.inputs.len());
        for &(parameter, argument) in &bound.inputs {
            let variable = &self.model.variables[parameter as usize];
            let place = self.outside(variable, instance);
            self.begin_store(place);
            places.push(place);
            if variable.kind != VariableKind::InOut {
                self.coerce(argument, variable.ty, ValueContext::Argument);
            } else if let Some(passed) = self.pass_by_reference(argument, variable) {
                for index in 0..variable.limits {
                    let cell = self.shifted(place.location, 1 + index);
                    let limit = VariablePlace::new(cell, LIMIT);
                    self.begin_store(limit);
                    self.push_limit(passed, index);
                    places.push(limit);
                }
            }
        }
        places
    }

    fn finish_passing(&mut self, places: Vec<VariablePlace>, span: Span) {
        for place in places.into_iter().rev() {
            self.finish_store(place, span);
        }
    }

    /// Puts the address of an argument on the stack; gives the place of a variable that fits.
    ///
    /// Basis: iec-61131-3: 6.6.1 (VAR_IN_OUT needs the same type); ironplc-problem-codes: P4058, P4059, P4060.
    fn pass_by_reference(
        &mut self,
        argument: ExpressionId,
        parameter: &DeclaredVariable<'_>,
    ) -> Option<VariablePlace> {
        let ty = parameter.ty;
        let span = self.span(argument);
        if parameter.constant && parameter.limits == 0 && !self.names_a_place(argument) {
            let address = Location::Absolute(self.temporary_of(ty, span));
            let copy = VariablePlace::new(address, ty);
            self.begin_store(copy);
            self.coerce(argument, ty, ValueContext::Argument);
            self.finish_store(copy, span);
            self.push_address(address);
            return Some(copy);
        }
        let (code, what) = (
            Code::FunctionCallInOutArgNotVariable,
            "VAR_IN_OUT needs a variable",
        );
        let place = self.whole_place(argument, code, what)?;
        let types = &self.model.types;
        let same = types.is_same_variable(place.ty, ty)
            || matches!(types.kind(ty), TypeKind::FunctionBlock(_))
                && types.derives(place.ty, types.root(ty))
            || types.fits_variable_length(place.ty, ty);
        if !same && ty != TypeId::ERROR {
            let (needed, given) = (types.name(ty), types.name(place.ty));
            let message = format!("VAR_IN_OUT needs a variable of type {needed}, not {given}");
            self.report(Code::FunctionCallInOutArgTypeMismatch, span, message);
        } else if place.constant && !parameter.constant {
            let message = "VAR_IN_OUT needs a variable that can be written";
            self.report(Code::InOutArgNotWritable, span, message);
        }
        self.refuses_address(place, span);
        let place = self.located(place);
        self.push_address(place.location);
        same.then_some(place)
    }

    /// Copies outputs to their targets: first all are read, then all are written, the last one first.
    fn capture(&mut self, captures: &[Capture], instance: Option<Location>, span: Span) {
        let mut taken = Vec::with_capacity(captures.len());
        for capture in captures {
            let variable = &self.model.variables[capture.output as usize];
            let output = self.outside(variable, instance);
            let sound = self.read_output(capture, output);
            taken.push((capture.target, output, sound));
        }
        for (target, output, sound) in taken.into_iter().rev() {
            let Some(place) = self.place(target) else { continue };
            if place.constant {
                self.refuse_constant(target);
            } else if sound && self.is_aggregate(output.ty) {
                let place = self.located(place);
                self.push_address(place.location);
                self.push_address(output.location);
                self.finish_store(place, span);
            } else if sound {
                self.store(place, span);
                self.record_written(target, place);
            }
        }
    }

    /// Puts an output on the stack, as its target takes it; an aggregate is left where it is. Gives whether it
    /// fits its target.
    fn read_output(&mut self, capture: &Capture, output: VariablePlace) -> bool {
        let span = self.span(capture.target);
        let target = self.infer(capture.target);
        let types = &self.model.types;
        let from = types.value_type(output.ty);
        if from == TypeId::ERROR {
            return false;
        }
        if capture.negated && from != TypeId::BOOL {
            let message = format!("`NOT` is not defined for {}", types.name(from));
            self.report(Code::OperatorOperandTypeMismatch, span, message);
            return false;
        }
        let Inferred::Known(to) = target else { return false };
        if let (TypeId::ANY_INT, Some(ty)) = (output.ty, to.elementary().filter(|ty| ty.is_integer())) {
            self.load(output);
            let (from, rule) = (ElementaryType::Int, ConversionRule::Wrap);
            self.emitter.convert(Conversion { from, to: ty, rule });
            return true;
        }
        let dialect = self.model.source.dialect;
        let fits = fit(Inferred::Known(from), to, ValueContext::Capture, types, dialect) == Fit::Yes;
        let is_derived = types.is_derived(output.ty);
        let refused = from != to
            && !dialect.derived_types_convert
            && (is_derived || self.is_of_derived_type(capture.target));
        if !fits || refused {
            let types = &self.model.types;
            let (given, needed) = (types.name(from), types.name(to));
            let message = format!("{given} does not convert implicitly to {needed}");
            self.report(ValueContext::Capture.code(), span, message);
            self.record_captured(capture.target, from, to, false);
            return false;
        }
        if self.is_aggregate(output.ty) {
            return true;
        }
        let value = self.load(output);
        if capture.negated {
            self.emit(Instruction::Not(ElementaryType::Bool));
        }
        self.adapt(value, to);
        self.record_captured(capture.target, from, to, true);
        true
    }

    /// Records that an output goes to a variable, where both are of elementary types.
    fn record_captured(&mut self, target: ExpressionId, from: TypeId, to: TypeId, fits: bool) {
        if let (Some(from), Some(to)) = (from.elementary(), to.elementary()) {
            self.emitter.record(target, UseKind::Captured { from, to, fits });
        }
    }

    /// Says that a constant cannot be written.
    pub(super) fn refuse_constant(&mut self, target: ExpressionId) {
        use ExpressionKind::{Bit, Field, Index};
        let text = self.model.source.text_of(target);
        let mut part = target;
        while let Field { base, .. } | Index { base, .. } | Bit { base, .. } = self.expression(part).kind {
            if let Field { field, .. } = self.expression(part).kind
                && self.is_closed(base, field.text)
            {
                let message = format!("`{text}` is no input: only the code of its block may write it");
                return self.report(Code::MemberNotAccessible, self.span(target), message);
            }
            part = base;
        }
        let message = format!("`{text}` is a CONSTANT");
        self.report(Code::AssignmentToConstant, self.span(target), message);
    }
}
