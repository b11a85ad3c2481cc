//! Variables as expressions name them: with elements, fields and bits; for reading and for writing.
//!
//! Basis: ironplc-bit-access: Valid Base Types; ironplc-problem-codes: P2027, P4007, P4025, P4069; iec-61131-3: 6.4.2.3 (characters). A wrong
//! number of subscripts is P2024, and a subscript of what has no elements P4049.

use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::trace::UseKind;
use super::types::{ArrayShape, Dimension, TypeId, TypeKind};
use crate::instruction::{Instruction, Part};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{ExpressionId, ExpressionKind, Name};
use stickler_types::dialect::{PartialAccess, TextElements};
use stickler_types::{Code, Dialect, ElementaryType};

impl<'m> Lowering<'m> {
    /// Puts the value of a variable, element, field or part on the stack.
    pub(super) fn read(&mut self, id: ExpressionId) -> LoweredValue {
        if let Some(property) = self.property(id) {
            return self.read_property(id, property);
        }
        match self.place(id) {
            Some(place) if self.model.types.is_variable_length(place.ty) => {
                let message = "an `ARRAY[*]` has no value as a whole; only its elements have";
                self.report(Code::OperatorOperandTypeMismatch, self.span(id), message);
                LoweredValue::ERROR
            }
            Some(place) => {
                let before = self.emitter.line();
                if place.location == Location::Bytes {
                    self.set_line(self.span(id));
                }
                let value = self.load(place);
                self.emitter.set_line(before);
                if let (Some(_), Some(of)) = (place.part, self.model.elementary(place.ty)) {
                    self.emitter.record(id, UseKind::BitRead(of));
                }
                value
            }
            None => LoweredValue::ERROR,
        }
    }

    /// The place that an expression names; `None`, and a diagnostic, where it names none. Where the address is
    /// only known as the program runs, it is on the stack.
    pub(super) fn place(&mut self, id: ExpressionId) -> Option<VariablePlace> {
        let place = self.place_itself(id)?;
        self.followed(place)
    }

    /// The place that an expression names, of a variable that is declared with REFERENCE TO its own.
    pub(super) fn place_itself(&mut self, id: ExpressionId) -> Option<VariablePlace> {
        let expression = self.expression(id);
        match &expression.kind {
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } if self.property(id).is_some() => {
                self.property_place(id)
            }
            ExpressionKind::Name(name) => self.named_place(id, *name),
            ExpressionKind::Field { base, field } => self.field(*base, *field),
            ExpressionKind::Index { base, subscripts } => self.element(*base, subscripts, expression.span),
            ExpressionKind::Dereference { base } => self.dereference(*base),
            ExpressionKind::Bit { base, index } => {
                self.part(*base, ElementaryType::Bool, *index, expression.span)
            }
            ExpressionKind::Part { base, part, index } => self.part(*base, *part, *index, expression.span),
            ExpressionKind::Call { .. } if self.names_a_place(id) => self.result_place(id),
            ExpressionKind::Error => None,
            _ => {
                self.refuse_value(id, Code::SyntaxError, "a variable is needed here");
                None
            }
        }
    }

    /// The place of what a call gives, of which a copy is kept.
    fn result_place(&mut self, id: ExpressionId) -> Option<VariablePlace> {
        let declared = self.declared_type_of(id);
        let value = self.value(id, None);
        let (ty, span) = (declared.unwrap_or(value.ty), self.span(id));
        let place = VariablePlace {
            constant: true,
            ..VariablePlace::new(Location::Absolute(self.temporary_of(ty, span)), ty)
        };
        self.store(place, span);
        (value.ty != TypeId::ERROR).then_some(place)
    }

    fn named_place(&mut self, id: ExpressionId, name: Name<'m>) -> Option<VariablePlace> {
        if let Some((_, variable)) = self.variable(name.text) {
            return (variable.ty != TypeId::ERROR).then(|| VariablePlace::of(variable));
        }
        if let Some(own) = self.own_instance_of(id) {
            let ty = self.model.pous[own.pou as usize].ty;
            return (ty != TypeId::ERROR).then_some(VariablePlace::new(Location::Instance(0), ty));
        }
        if let Some(program) = self.called_program(name) {
            return Some(program);
        }
        let what = if self.enumerated_name(name.text).is_some() {
            "is an enumerated value, no variable".to_owned()
        } else if self.model.definition(name).is_some() {
            "is no variable".to_owned()
        } else if name.text.eq_ignore_ascii_case("NULL") {
            "is the reference to nothing, which the dialect does not have".to_owned()
        } else {
            format!("is not declared{}", self.similar_variable(name.text))
        };
        let message = format!("`{}` {what}", name.text);
        self.report(Code::VariableUndefined, name.span, message);
        None
    }

    fn field(&mut self, base: ExpressionId, field: Name<'m>) -> Option<VariablePlace> {
        if let Some(variable) = self.own_in_out(base, field) {
            return Some(VariablePlace::of(variable));
        }
        let place = self.place(base)?;
        let Some(member) = self.member_of(base, place.content(), field.text) else {
            let name = self.model.types.name(place.content());
            let message = format!("{name} has no element `{}` that can be reached", field.text);
            self.report(Code::VariableUndefined, field.span, message);
            return None;
        };
        let place = self.entered(place);
        let location = self.member_location(place, member);
        let constant = place.constant || member.constant || self.is_closed(base, field.text);
        (member.ty != TypeId::ERROR).then_some(VariablePlace {
            constant,
            overlaid: place.overlaid,
            ..VariablePlace::new(location, member.ty)
        })
    }

    fn element(
        &mut self,
        base: ExpressionId,
        subscripts: &[ExpressionId],
        span: Span,
    ) -> Option<VariablePlace> {
        let types = &self.model.types;
        let place = self.place(base);
        match place.map(|place| (place, types.kind(place.content()))) {
            Some((place, TypeKind::Array(shape))) => {
                let (needed, given) = (shape.dimensions.len(), subscripts.len());
                if needed != given {
                    let message = format!("the array has {needed} dimensions, not {given}");
                    self.report(Code::ArrayDimensionInvalid, span, message);
                }
                self.subscripts(place, shape, subscripts)
            }
            Some((place, &TypeKind::Text { ty, .. }))
                if self.character_type(ty, subscripts.len()).is_some() =>
            {
                self.character(place, ty, subscripts[0])
            }
            Some((place, TypeKind::Pointer(pointer))) if self.has_elements(*pointer, subscripts.len()) => {
                self.pointer_element(place, pointer.target, subscripts[0])
            }
            _ => {
                for &subscript in subscripts {
                    self.value(subscript, None);
                }
                let name = types.name(place?.content());
                let message = format!("{name} has no elements");
                self.report(Code::OperatorOperandTypeMismatch, span, message);
                None
            }
        }
    }

    /// The element. What is wrong with a subscript is said, and changes nothing of the element's type, nor of whether it can
    /// be written: what is wrong with those is said too.
    ///
    /// Basis: rule: every-mistake-is-told.
    fn subscripts(
        &mut self,
        place: VariablePlace,
        shape: &ArrayShape,
        subscripts: &[ExpressionId],
    ) -> Option<VariablePlace> {
        let mut location = place.location;
        let sizes = (place.location == Location::Bytes).then(|| self.sizes(shape.element));
        for ((&subscript, mut dimension), index) in
            subscripts.iter().zip(shape.dimensions.iter().copied()).zip(0..)
        {
            if let Some((bytes, cells)) = sizes {
                dimension.stride = (dimension.stride / cells).saturating_mul(bytes);
            }
            location = match shape.is_variable_length() {
                true => self.variable_subscript(location, subscript, (place, index)),
                false => self.subscript(location, subscript, dimension),
            };
        }
        for &subscript in subscripts.iter().skip(shape.dimensions.len()) {
            self.value(subscript, None);
        }
        let known = shape.dimensions.len() == subscripts.len() && shape.element != TypeId::ERROR;
        known.then_some(VariablePlace {
            constant: place.constant,
            overlaid: place.overlaid,
            ..VariablePlace::new(location, shape.element)
        })
    }

    /// Goes one dimension further. A constant subscript is taken into the address here and now. What is refused is never run, so
    /// that any address will do.
    fn subscript(&mut self, location: Location, id: ExpressionId, dimension: Dimension) -> Location {
        let Dimension { low, high, stride } = dimension;
        let before = self.emitter.position();
        self.push_address(location);
        let reached = match location {
            Location::Bytes => Location::Bytes,
            _ => Location::Stack,
        };
        let Some(value) = self.integer(id, ElementaryType::Lint, ValueContext::Integer) else {
            return reached;
        };
        let span = self.span(id);
        if let Some(number) = value.constant {
            if number < low.into() || number > high.into() {
                let message = format!("subscript {number} is outside {low}..{high}");
                self.report(Code::ArrayIndexOutOfBounds, span, message);
                return reached;
            }
            // A constant's code is a push or two, and it stands last.
            self.emitter.truncate(before);
            let distance = number - i128::from(low);
            let distance = u32::try_from(distance).unwrap_or(0).saturating_mul(stride);
            return self.shifted(location, distance);
        }
        let unsigned = value.ty.elementary().is_some_and(ElementaryType::is_unsigned);
        let instruction = Instruction::Subscript {
            low,
            high,
            stride,
            unsigned,
        };
        self.emit_at(span, instruction);
        reached
    }

    /// Returns the type of what a subscript selects in a text; `None` where the dialect has no such subscripts.
    pub(super) fn character_type(&self, text: ElementaryType, subscripts: usize) -> Option<ElementaryType> {
        use ElementaryType::{Byte, Char, Wchar, Word, Wstring};
        let ty = match self.model.source.dialect.text_elements {
            TextElements::None => return None,
            TextElements::Characters if text == Wstring => Wchar,
            TextElements::Characters => Char,
            TextElements::Codes if text == Wstring => Word,
            TextElements::Codes => Byte,
        };
        (subscripts == 1).then_some(ty)
    }

    /// The place of a character of a text.
    fn character(
        &mut self,
        place: VariablePlace,
        ty: ElementaryType,
        subscript: ExpressionId,
    ) -> Option<VariablePlace> {
        let span = self.span(subscript);
        let text = self.located(place);
        self.push_address(text.location);
        let position = self.integer(subscript, ElementaryType::Lint, ValueContext::Integer)?;
        if text.overlaid {
            let message = "a character of a text in a UNION is not implemented";
            self.report(Code::NotImplemented, span, message);
            return None;
        }
        let unsigned = position.ty.elementary().is_some_and(ElementaryType::is_unsigned);
        let of = self.model.source.dialect.text_elements;
        self.emit_at(span, Instruction::Character { of, unsigned });
        Some(VariablePlace {
            location: Location::Character,
            ty: TypeId::of(self.character_type(ty, 1)?),
            ..place
        })
    }

    /// Puts an integer of any type on the stack, an untyped one in the type that is wanted.
    ///
    /// Basis: iec-61131-3: 6.4.4.5, 7.3.3 (subscripts, CASE selectors and FOR bounds).
    pub(super) fn integer(
        &mut self,
        id: ExpressionId,
        wanted: ElementaryType,
        context: ValueContext,
    ) -> Option<LoweredValue> {
        let inferred = self.infer(id);
        let wanted = TypeId::of(wanted);
        let fits = match inferred {
            Inferred::Known(ty) => ty.elementary().is_some_and(|ty| self.counting(ty).is_some()),
            Inferred::Integer(_) | Inferred::Error | Inferred::Pending | Inferred::Enumerated => true,
            Inferred::Nothing | Inferred::Real | Inferred::Text { .. } => false,
        };
        let value = self.value(id, Some(wanted));
        if !fits {
            self.report_lowered_misfit(id, inferred, value, wanted, context);
            return None;
        }
        let ty = value.ty.elementary().and_then(|ty| self.counting(ty));
        let ty = ty.map_or(value.ty, TypeId::of);
        (value.ty != TypeId::ERROR).then_some(LoweredValue { ty, ..value })
    }

    /// Returns the integer type of values by which things are counted and selected, in the dialect of the text.
    pub(super) fn counting(&self, ty: ElementaryType) -> Option<ElementaryType> {
        counting(ty, self.model.source.dialect)
    }

    /// A part of a variable's bits, or of such a part. One that the type does not have is a BOOL, BYTE, WORD or DWORD all the same,
    /// of a variable that can be written or not: what is wrong with it as such is said too, as with an element. Of what has no
    /// bits, or not more than the part, there is none that could be anything.
    ///
    /// Basis: ironplc-bit-access: Bit Access ("reads and writes as a BOOL"); rusty-direct-variables: Constant based Direct Access;
    /// rusty-tests: src/validation/tests/bitaccess_validation_test.rs; rule: every-mistake-is-told.
    fn part(
        &mut self,
        base: ExpressionId,
        part: ElementaryType,
        index: u64,
        span: Span,
    ) -> Option<VariablePlace> {
        if !self.names_a_place(base) {
            self.refuse_value(base, Code::BitAccessTypeInvalid, "only a variable has bits");
            return None;
        }
        let place = self.place(base)?;
        let name = self.model.types.name(place.content());
        let ty = self.model.elementary(place.content()).filter(|ty| ty.is_whole());
        let Some(ty) = ty else {
            self.report(Code::BitAccessTypeInvalid, span, format!("{name} has no bits"));
            return None;
        };
        let may_be_whole = part != ElementaryType::Bool
            && self.model.source.dialect.partial_access == PartialAccess::UpToLongWords;
        if part.bits() >= ty.bits() && !may_be_whole {
            let message = format!("{name} has no more bits than one {part}");
            self.report(Code::BitAccessTypeInvalid, span, message);
            return None;
        }
        let parts = ty.bits() / part.bits();
        let first = u32::try_from(index).ok().filter(|&index| index < parts);
        let first = first.and_then(|index| u8::try_from(index * part.bits()).ok());
        if first.is_none() {
            let what = if part == ElementaryType::Bool {
                "bit"
            } else {
                part.name()
            };
            let message = match parts.checked_sub(1) {
                Some(last) => format!("{name} has the {what}s 0 to {last}"),
                None => format!("{name} has fewer bits than one {part}"),
            };
            self.report(Code::BitAccessOutOfRange, span, message);
        }
        if place.location == Location::Character && self.refuses_address(place, span) {
            return None;
        }
        let outer = place.part.map_or(0, |outer| outer.first);
        if place.overlaid {
            // A part of a field of a union is a value of its own, or a bit of one of the bytes.
            let first = outer + first.unwrap_or(0);
            let is_bit = part == ElementaryType::Bool;
            let bit = Part {
                first: first % 8,
                ty: part,
            };
            return Some(VariablePlace {
                location: self.shifted(place.location, u32::from(first / 8)),
                ty: TypeId::of(if is_bit { ElementaryType::Byte } else { part }),
                part: is_bit.then_some(bit),
                overlaid: !is_bit,
                ..place
            });
        }
        // A variable with limits is looked at again once the bit is set.
        let limited = matches!(self.model.types.kind(place.ty), TypeKind::Subrange(_));
        let location = match limited {
            true => self.pinned(place, span),
            false => place.location,
        };
        Some(VariablePlace {
            location,
            // What is refused is never run, so that any part will do.
            part: Some(Part {
                first: outer + first.unwrap_or(0),
                ty: part,
            }),
            ..place
        })
    }

    /// Returns the place of a variable whose address is taken; reports by this code and message what has none: a value, and a part of
    /// a variable's bits.
    pub(super) fn whole_place(
        &mut self,
        id: ExpressionId,
        code: Code,
        message: &str,
    ) -> Option<VariablePlace> {
        let is_value = match self.expression(id).kind {
            ExpressionKind::Name(name) => {
                let is_known = self.enumerated_name(name.text).is_some() || self.is_null(name.text);
                is_known && self.variable(name.text).is_none()
            }
            _ => !self.names_a_place(id),
        };
        if is_value {
            self.refuse_value(id, code, message);
            return None;
        }
        let place = self.place(id)?;
        if place.part.is_some() {
            self.report(code, self.span(id), format!("{message}; a part of one is none"));
            return None;
        }
        let is_character = place.location == Location::Character;
        (!is_character || !self.refuses_address(place, self.span(id))).then_some(place)
    }

    /// Reports a value where a variable is needed; what is wrong inside of it is reported instead.
    fn refuse_value(&mut self, id: ExpressionId, code: Code, message: &str) {
        let value = self.value(id, None);
        if value.ty != TypeId::ERROR || self.infer(id) == Inferred::Nothing {
            self.report(code, self.span(id), message);
        }
    }

    /// Returns whether an expression has the form of a variable.
    pub(super) fn names_a_place(&self, id: ExpressionId) -> bool {
        use ExpressionKind::{Bit, Call, Dereference, Field, Index, Name, Part};
        match self.expression(id).kind {
            Call { .. } => self.model.source.dialect.results_are_variables,
            Name(_) | Field { .. } | Index { .. } | Dereference { .. } | Bit { .. } | Part { .. } => true,
            _ => false,
        }
    }
}

/// Returns the integer type of values by which things are counted and selected: the unsigned one of bit strings, where the dialect takes them.
pub(super) fn counting(ty: ElementaryType, dialect: &Dialect) -> Option<ElementaryType> {
    if !ty.is_bit_string() || !dialect.bit_strings_as_integers {
        return ty.is_integer().then_some(ty);
    }
    let mut all = ElementaryType::ALL.into_iter();
    all.find(|other| other.is_unsigned() && other.bits() == ty.bits())
}
