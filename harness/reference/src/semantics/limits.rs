//! ARRAY[*]: parameters that take arrays of any limits, and the functions that ask for these.
//!
//! The limits of the argument lie behind its address, in cells of the parameter: of each dimension the lowest and the highest subscript
//! and the number of cells from one element to the next.
//!
//! Basis: iec-61131-3: 6.5.3 and Table 15 of the third edition; codesys-pages: _cds_datatype_array.

use super::contexts::ValueContext;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::parameters::ParameterList;
use super::types::{ArrayShape, TypeId, TypeKind};
use crate::instruction::{ArithmeticOperator, Instruction, StandardFunction};
use stickler_syntax::tree::{Argument, ExpressionId};
use stickler_types::{Code, ElementaryType};

/// The type of the cells in which limits lie.
pub(super) const LIMIT: TypeId = TypeId::of(ElementaryType::Lint);

impl<'m> Lowering<'m> {
    /// Returns the shape of the array at a place, if one lies there.
    fn array_shape(&self, place: VariablePlace) -> Option<&'m ArrayShape> {
        match self.model.types.kind(place.content()) {
            TypeKind::Array(shape) => Some(shape),
            _ => None,
        }
    }

    /// Puts one of the numbers on the stack that an ARRAY[*] has of the array at a place, counted over all dimensions.
    pub(super) fn push_limit(&mut self, place: VariablePlace, index: u32) {
        let Some(shape) = self.array_shape(place) else {
            return;
        };
        if shape.is_variable_length() {
            let cell = match place.location {
                Location::Pointer { cell, .. } => Location::Absolute(cell + 1 + index),
                Location::InstancePointer { cell, .. } => Location::Instance(cell + 1 + index),
                other => other,
            };
            self.load(VariablePlace::new(cell, LIMIT));
        } else if let Some(dimension) = shape.dimensions.get(index as usize / 3) {
            let numbers = [dimension.low, dimension.high, dimension.stride.into()];
            self.emit(Instruction::Push(numbers[index as usize % 3].cast_unsigned()));
        }
    }

    /// Goes a dimension further in the ARRAY[*] at a place.
    pub(super) fn variable_subscript(
        &mut self,
        location: Location,
        subscript: ExpressionId,
        (array, dimension): (VariablePlace, u32),
    ) -> Location {
        self.push_address(location);
        if let Some(value) = self.integer(subscript, ElementaryType::Lint, ValueContext::Integer) {
            for index in 0..3 {
                self.push_limit(array, 3 * dimension + index);
            }
            let unsigned = value.ty.elementary().is_some_and(ElementaryType::is_unsigned);
            self.emit_at(self.span(subscript), Instruction::SubscriptWithin { unsigned });
        }
        Location::Stack
    }

    /// Calls LOWER_BOUND (0) or UPPER_BOUND (1): puts that limit of a dimension of an array on the stack.
    pub(super) fn call_bound(
        &mut self,
        call: ExpressionId,
        limit: u32,
        arguments: &[Argument<'m>],
    ) -> LoweredValue {
        const LIST: ParameterList = ParameterList::exactly(&["ARR", "DIM"]);
        let span = self.span(call);
        let values = match LIST.ordered(arguments, span) {
            Ok(values) => values,
            Err(reason) => return self.refuse(reason, arguments),
        };
        let start = self.emitter.position();
        let (code, what) = (Code::FunctionCallArgTypeMismatch, "`ARR` is an array");
        let place = self.whole_place(values[0], code, what);
        // Only the limits are asked for.
        self.emitter.truncate(start);
        let dimension = self.integer(values[1], ElementaryType::Dint, ValueContext::Argument);
        let (Some(place), Some(dimension)) = (place, dimension) else {
            return LoweredValue::ERROR;
        };
        let Some(shape) = self.array_shape(place) else {
            self.report(code, self.span(values[0]), what);
            return LoweredValue::ERROR;
        };
        if !shape.has_plain_limits() {
            let message = "limits that no DINT holds, and more than 16 dimensions, are not implemented here";
            self.report(Code::NotImplemented, self.span(values[0]), message);
            return LoweredValue::ERROR;
        }
        let dimensions = shape.dimensions.len();
        if let Some(number) = dimension.constant
            && !(1..=dimensions as i128).contains(&number)
        {
            let message = format!("the array has the dimensions 1 to {dimensions}, and no {number}");
            self.report(Code::ArrayDimensionInvalid, self.span(values[1]), message);
        }
        self.emit(Instruction::Push(1));
        let subtract = ArithmeticOperator::Subtract;
        self.emit(Instruction::Arithmetic(subtract, ElementaryType::Lint));
        for index in (0..).take(dimensions) {
            self.push_limit(place, 3 * index + limit);
        }
        self.emit_standard(call, StandardFunction::Mux, ElementaryType::Dint, (dimensions, 1));
        LoweredValue::of(ElementaryType::Dint)
    }
}
