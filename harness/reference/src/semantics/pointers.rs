//! What follows references and pointers: `^`, `REF=`, ADR, REF, SIZEOF, and the code that reads and writes behind them.
//!
//! Basis: iec-61131-3: Table 12 of the third edition; codesys-pages: _cds_datatype_pointer; codesys-pages: _cds_datatype_reference;
//! codesys-pages: _cds_operator_sizeof; ironplc-problem-codes: P2028 to P2035; rule: memory-of-pointers.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::{Inferred, Magnitude};
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::model::{Storage, TopLevelName};
use super::parameters::single_argument;
use super::pointer_types::fits_pointer;
use super::types::{PointerType, TypeId, TypeMember};
use crate::addresses::{AddressMap, MemoryObject};
use crate::instruction::{Address, ArithmeticOperator, ComparisonOperator, Instruction, Label};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, BinaryOperator, CaseFolded, ExpressionId, ExpressionKind, PointerForm, VariableKind,
};
use stickler_types::{Code, ElementaryType};

/// Why a function of this file cannot be called.
pub(super) const NOT_IN_DIALECT: &str = "is an operator that the dialect does not have";

/// An operator on variables and types that is written as a function.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum AddressFunction {
    /// ADR: the address of a variable.
    Adr,
    /// REF: a reference to a variable.
    Ref,
    /// SIZEOF: the number of bytes of a variable or a type.
    SizeOf,
    /// __ISVALIDREF: whether a reference is bound.
    IsValidRef,
}

impl AddressFunction {
    /// Returns the function of a name.
    pub(super) fn of(name: &str) -> Option<AddressFunction> {
        use AddressFunction::{Adr, IsValidRef, Ref, SizeOf};
        let mut all = [Adr, Ref, SizeOf, IsValidRef].into_iter();
        all.find(|function| name.eq_ignore_ascii_case(function.feature()))
    }

    /// Returns its key in `conformance-cases/features.toml`, which is its name in small letters.
    pub(super) const fn feature(self) -> &'static str {
        match self {
            AddressFunction::Adr => "adr",
            AddressFunction::Ref => "ref",
            AddressFunction::SizeOf => "sizeof",
            AddressFunction::IsValidRef => "__isvalidref",
        }
    }
}

impl<'m> Lowering<'m> {
    /// Returns whether addresses are numbers, and a pointer of any type leads anywhere.
    fn is_free(&self) -> bool {
        self.model.source.dialect.has_pointers("pointer-arithmetic")
    }

    /// Returns whether a name that is not declared is the reference to nothing.
    pub(super) fn is_null(&self, name: &str) -> bool {
        name.eq_ignore_ascii_case("NULL") && self.model.source.dialect.has_pointers("null")
    }

    /// Returns whether a pointer takes subscripts of its own: `p[i]` is the value `i` sizes behind `p^`.
    pub(super) fn has_elements(&self, pointer: PointerType, subscripts: usize) -> bool {
        subscripts == 1 && pointer.form == PointerForm::PointerTo && self.is_free()
    }

    /// Returns the operand of a call of ADR or REF; `None` for all else.
    fn address_operand(&mut self, id: ExpressionId) -> Option<ExpressionId> {
        let ExpressionKind::Call { callee, arguments } = &self.expression(self.model.source.bare(id)).kind
        else {
            return None;
        };
        match (self.callee(*callee), &arguments[..]) {
            (
                Callee::Address(AddressFunction::Adr | AddressFunction::Ref),
                [Argument::Positional(operand)],
            ) => Some(*operand),
            _ => None,
        }
    }

    /// Returns the pointer type of an expression, if it is one of a known target.
    fn pointer_of(&mut self, id: ExpressionId) -> Option<PointerType> {
        let known = self.known_type(id).filter(|&ty| ty != TypeId::ADDRESS)?;
        self.model.types.pointer(known)
    }

    /// Infers the type of `base^`.
    pub(super) fn infer_dereference(&mut self, base: ExpressionId) -> Inferred {
        let pointer = self.pointer_of(base);
        pointer.map_or(Inferred::Error, |pointer| self.inferred_of(pointer.target))
    }

    /// Returns the type with which the variable of `base^` is declared.
    pub(super) fn target_type(&mut self, base: ExpressionId) -> Option<TypeId> {
        Some(self.pointer_of(base)?.target)
    }

    /// The place of `base^`.
    pub(super) fn dereference(&mut self, base: ExpressionId) -> Option<VariablePlace> {
        let pointer = self.pointer_of(base);
        let value = self.value(base, None);
        if let Some(pointer) = pointer {
            return behind(pointer.target);
        }
        if value.ty != TypeId::ERROR {
            let name = self.model.types.name(value.ty);
            let message = format!("only a reference or pointer leads to a variable, not {name}");
            self.report(Code::DerefRequiresReferenceType, self.span(base), message);
        }
        None
    }

    /// The place that a variable stands for: of one that is declared with REFERENCE TO, what it is bound to.
    pub(super) fn followed(&mut self, place: VariablePlace) -> Option<VariablePlace> {
        let target = self.model.types.named_type(place.ty);
        if target == place.ty || place.part.is_some() {
            return Some(place);
        }
        self.load(place);
        behind(target)
    }

    /// The place of an element behind a pointer, whose place is given.
    ///
    /// Basis: codesys-pages: _cds_datatype_pointer (index access).
    pub(super) fn pointer_element(
        &mut self,
        place: VariablePlace,
        pointer: PointerType,
        subscript: ExpressionId,
    ) -> Option<VariablePlace> {
        self.load(place);
        self.integer(subscript, ElementaryType::Lint, ValueContext::Integer)?;
        let (bytes, _) = self.sizes(pointer.target);
        self.emit(Instruction::Push(bytes.into()));
        let scaled = Instruction::Arithmetic(ArithmeticOperator::Multiply, ElementaryType::Lint);
        let moved = Instruction::Arithmetic(ArithmeticOperator::Add, ElementaryType::Lint);
        self.emit(scaled);
        self.emit(moved);
        behind(pointer.target)
    }

    /// The location of a member of what lies at a place.
    pub(super) fn member_location(&mut self, place: VariablePlace, member: &TypeMember) -> Location {
        let offset = match place.location {
            Location::Bytes => self.member_offset(place.ty, member.offset),
            _ => member.offset,
        };
        self.shifted(place.location, offset)
    }

    /// The place by the address of its cell, which all that is no plain value needs, and VAR_IN_OUT and calls.
    pub(super) fn located(&mut self, place: VariablePlace) -> VariablePlace {
        if place.location != Location::Bytes {
            return place;
        }
        let layout = self.layout(place.ty);
        self.emit(Instruction::Locate(layout));
        let location = Location::Stack;
        VariablePlace { location, ..place }
    }

    /// Puts the address in bytes of a variable on the stack, and gives its type; `None` where it has none, which is reported.
    fn push_address_of(&mut self, id: ExpressionId) -> Option<TypeId> {
        let span = self.span(id);
        if !self.names_a_place(id) {
            let value = self.value(id, None);
            if value.ty != TypeId::ERROR || self.infer(id) == Inferred::Nothing {
                let message = "only a variable has an address";
                self.report(Code::RefOperandNotVariable, span, message);
            }
            return None;
        }
        let is_part = matches!(
            self.expression(id).kind,
            ExpressionKind::Field { .. } | ExpressionKind::Index { .. }
        );
        if is_part && !self.model.source.dialect.has_pointers("reference-to-part") {
            let message = "the dialect has no references to a part of a variable";
            self.report(Code::RefOfArrayElement, span, message);
        }
        if !self.is_free() && self.is_ephemeral(id) {
            let message = "the variable does not outlive the call, so nothing may refer to it";
            self.report(Code::RefOfEphemeralVariable, span, message);
        }
        let place = self.place(id)?;
        if place.part.is_some() {
            let message = "a part of the bits of a variable has no address";
            self.report(Code::RefOperandNotVariable, span, message);
            return None;
        }
        if place.location != Location::Bytes {
            self.push_address(place.location);
            self.emit(Instruction::AddressOf);
            self.addresses.are_taken = true;
        }
        Some(place.ty)
    }

    /// Returns whether a variable, of which an expression may name a part, is in VAR_TEMP or in a function.
    fn is_ephemeral(&self, mut id: ExpressionId) -> bool {
        while let ExpressionKind::Field { base, .. } | ExpressionKind::Index { base, .. } =
            self.expression(id).kind
        {
            id = base;
        }
        let ExpressionKind::Name(name) = self.expression(id).kind else {
            return false;
        };
        // The variables of its block outlive the call of a method.
        let function = self.entry().filter(|entry| entry.is_function());
        self.variable(name.text).is_some_and(|(index, variable)| {
            let in_function = function.is_some_and(|entry| entry.variables.contains(&index));
            match variable.kind {
                VariableKind::Temporary => true,
                VariableKind::Local | VariableKind::Input | VariableKind::Output => in_function,
                VariableKind::InOut
                | VariableKind::External
                | VariableKind::Global
                | VariableKind::Instance => false,
            }
        })
    }

    /// Puts the address of a variable on the stack to which a variable of the type `target`, which is declared with REFERENCE TO, is bound.
    pub(super) fn bind_reference(&mut self, id: ExpressionId, target: TypeId) -> LoweredValue {
        if self.model.source.text_of(id) == "0" {
            self.emit(Instruction::Push(0));
            return LoweredValue::computed(target);
        }
        let Some(ty) = self.push_address_of(id) else {
            return LoweredValue::ERROR;
        };
        let types = &self.model.types;
        let wanted = types.named_type(target);
        let texts = self.is_text(wanted) && types.value_type(ty) == types.value_type(wanted);
        if !texts && wanted != TypeId::ERROR && !types.is_same(ty, wanted) {
            let message = format!(
                "{} is bound to a variable, not {}",
                types.name(target),
                types.name(ty)
            );
            self.report(Code::ReferenceTypeMismatch, self.span(id), message);
            return LoweredValue::ERROR;
        }
        LoweredValue::computed(target)
    }

    /// Lowers `target REF= value`.
    pub(super) fn binding(&mut self, target: ExpressionId, value: ExpressionId) {
        let Some(place) = self.place_itself(target) else {
            self.value(value, None);
            return;
        };
        let span = self.span(target);
        if self.model.types.named_type(place.ty) == place.ty {
            let message = "`REF=` binds a variable that is declared with REFERENCE TO";
            self.report(Code::SyntaxError, span, message);
            return;
        }
        self.begin_store(place);
        self.bind_reference(value, place.ty);
        self.finish_store(place, span);
    }

    /// Reports a reference that leads to another type than the one that is expected, or NULL where no reference and no interface is; gives
    /// whether it was.
    pub(super) fn refuses_reference(&mut self, id: ExpressionId, inferred: Inferred, to: TypeId) -> bool {
        let (types, dialect) = (&self.model.types, self.model.source.dialect);
        let Inferred::Known(from) = inferred else {
            return false;
        };
        let is_interface = types.is_interface(to);
        if self.is_free() && !is_interface {
            return false;
        }
        let operand = self.address_operand(id);
        let (code, message) = match (types.pointer(from), types.pointer(to), operand) {
            (Some(_), Some(pointer), Some(operand)) => {
                let ty = self.declared_type_of(operand).unwrap_or(TypeId::ERROR);
                let ty = types.named_type(ty);
                if types.is_same(ty, pointer.target) || [ty, pointer.target].contains(&TypeId::ERROR) {
                    return false;
                }
                let message = format!("a reference to {} is no {}", types.name(ty), types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (Some(_), Some(_), None) if !fits_pointer(from, to, types, dialect) => {
                let message = format!("{} is no {}", types.name(from), types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (Some(_), None, Some(_)) if from == TypeId::ADDRESS && is_interface => {
                let message = format!("the address of a variable is no {}", types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (Some(_), None, None) if from == TypeId::ADDRESS && to != TypeId::ERROR && !is_interface => {
                let message = "only a reference or pointer can be NULL".to_owned();
                (Code::NullRequiresReferenceType, message)
            }
            _ => return false,
        };
        self.value(id, None);
        self.report(code, self.span(id), message);
        true
    }

    /// Returns the code of an operator that is not defined for its operands.
    pub(super) fn undefined_code(
        &self,
        operator: BinaryOperator,
        (left, right): (Inferred, Inferred),
    ) -> Code {
        use BinaryOperator::{Equal, Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
        let is_pointer =
            |value| matches!(value, Inferred::Known(ty) if self.model.types.pointer(ty).is_some());
        match operator {
            _ if !is_pointer(left) && !is_pointer(right) => Code::OperatorOperandTypeMismatch,
            Equal | NotEqual => Code::ReferenceTypeMismatch,
            Less | LessOrEqual | Greater | GreaterOrEqual => Code::OrderingOnReference,
            _ => Code::ArithmeticOnReference,
        }
    }

    /// Infers the type of a call of such an operator.
    pub(super) fn infer_address(
        &mut self,
        function: AddressFunction,
        arguments: &[Argument<'m>],
    ) -> Inferred {
        match function {
            AddressFunction::Adr | AddressFunction::Ref => Inferred::Known(TypeId::ADDRESS),
            AddressFunction::IsValidRef => Inferred::from(ElementaryType::Bool),
            AddressFunction::SizeOf => {
                let operand = single_argument(arguments, Span::default()).ok();
                let size = operand.and_then(|operand| self.size_of(operand));
                size.map_or(Inferred::Error, |size| Inferred::Integer(Magnitude::of(size)))
            }
        }
    }

    /// Calls such an operator, and leaves its result on the stack.
    pub(super) fn call_address(
        &mut self,
        call: ExpressionId,
        function: AddressFunction,
        arguments: &[Argument<'m>],
        wanted: Option<TypeId>,
    ) -> LoweredValue {
        let operand = match single_argument(arguments, self.span(call)) {
            Ok(operand) => operand,
            Err(reason) => return self.refuse(reason, arguments),
        };
        match function {
            AddressFunction::Adr | AddressFunction::Ref => match self.push_address_of(operand) {
                Some(_) => LoweredValue::computed(TypeId::ADDRESS),
                None => LoweredValue::ERROR,
            },
            AddressFunction::IsValidRef => self.is_valid(operand),
            AddressFunction::SizeOf => {
                let Some(size) = self.size_of(operand) else {
                    return self.refuse_size(operand);
                };
                let wanted = wanted.and_then(TypeId::elementary);
                let wanted = wanted.filter(|ty| ty.integer_range().is_some());
                let ty = wanted.unwrap_or_else(|| Magnitude::of(size).ty());
                let start = self.emitter.position();
                self.folded(call, start, ty, Some(size))
            }
        }
    }

    fn is_valid(&mut self, operand: ExpressionId) -> LoweredValue {
        let place = match self.names_a_place(operand) {
            true => self.place_itself(operand),
            false => None,
        };
        match place {
            Some(place) if self.model.types.named_type(place.ty) != place.ty => {
                self.load(place);
                self.emit(Instruction::Push(0));
                let differs = Instruction::Compare(ComparisonOperator::NotEqual, ElementaryType::Ulint);
                self.emit(differs);
            }
            _ => {
                let message = "`__ISVALIDREF` takes a variable that is declared with REFERENCE TO";
                self.report(Code::FunctionCallArgTypeMismatch, self.span(operand), message);
            }
        }
        LoweredValue::of(ElementaryType::Bool)
    }

    /// Returns the type of a variable or the type that an operand of SIZEOF names.
    fn sized_type(&mut self, operand: ExpressionId) -> Option<TypeId> {
        if let ExpressionKind::Name(name) = self.expression(operand).kind
            && self.variable(name.text).is_none()
        {
            let elementary = ElementaryType::from_name(name.text);
            let dialect = self.model.source.dialect;
            return match self.model.definitions.get(&CaseFolded(name.text)) {
                Some(&TopLevelName::Pou(pou)) => Some(self.model.pous[pou as usize].ty),
                Some(TopLevelName::Type(_)) => self.declared_type(name.text),
                None => elementary.filter(|&ty| dialect.has(ty)).map(TypeId::of),
            };
        }
        let ty = self.declared_type_of(operand)?;
        Some(self.model.types.named_type(ty))
    }

    /// Returns the number of bytes of what SIZEOF is applied to; `None` where it has no size that is known.
    fn size_of(&mut self, operand: ExpressionId) -> Option<i128> {
        let ty = self.sized_type(operand).filter(|&ty| ty != TypeId::ERROR)?;
        let has_size = !self.model.types.extent(ty).has_block;
        has_size.then(|| self.sizes(ty).0.into())
    }

    fn refuse_size(&mut self, operand: ExpressionId) -> LoweredValue {
        let (code, message) = match self.sized_type(operand) {
            Some(TypeId::ERROR) => return LoweredValue::ERROR,
            Some(_) => (
                Code::NotImplemented,
                "sizes of function blocks are not implemented",
            ),
            None if self.value(operand, None).ty == TypeId::ERROR => return LoweredValue::ERROR,
            None => (
                Code::FunctionCallArgTypeMismatch,
                "`SIZEOF` takes a variable or a type",
            ),
        };
        self.report(code, self.span(operand), message);
        LoweredValue::ERROR
    }

    /// Makes the map by which the machine finds variables, once all code is there.
    pub(super) fn address_map(&mut self) -> AddressMap {
        let mut objects = Vec::new();
        if self.addresses.are_taken && !self.reporter.has_errors() {
            let model = self.model;
            let labels = self.emitter.sorted_labels();
            for (entry, pou) in model.pous.iter().zip(0..) {
                let body = self.emitter.label(entry.body);
                let next = labels.partition_point(|&label| label <= body);
                let end = labels.get(next).copied().unwrap_or(u32::MAX);
                let frame = entry.is_function().then_some((body, end));
                let bases = model.instances.iter().filter(|instance| instance.pou == pou);
                let bases: Vec<_> = bases.map(|instance| instance.base).collect();
                for variable in entry.variables.clone().map(|index| model.variable(index)) {
                    match variable.storage {
                        _ if variable.kind == VariableKind::External => {}
                        Storage::Absolute(cell) => self.add_object(&mut objects, cell, variable.ty, frame),
                        Storage::Instance(offset) => bases
                            .iter()
                            .for_each(|base| self.add_object(&mut objects, base + offset, variable.ty, None)),
                        Storage::AbsolutePointer(_) | Storage::InstancePointer(_) => {}
                    }
                }
            }
            for variable in &model.variables {
                if let (VariableKind::Global, Storage::Absolute(cell)) = (variable.kind, variable.storage) {
                    self.add_object(&mut objects, cell, variable.ty, None);
                }
            }
            objects.sort_by_key(|object| object.cell);
        }
        let layouts = std::mem::take(&mut self.addresses.layouts);
        AddressMap { layouts, objects }
    }

    fn add_object(
        &mut self,
        objects: &mut Vec<MemoryObject>,
        cell: Address,
        ty: TypeId,
        frame: Option<(Label, Label)>,
    ) {
        let layout = self.layout(ty);
        objects.push(MemoryObject { cell, layout, frame });
    }
}

/// The place behind an address in bytes that is on the stack; `None` where its type is not known.
fn behind(ty: TypeId) -> Option<VariablePlace> {
    (ty != TypeId::ERROR).then_some(VariablePlace::new(Location::Bytes, ty))
}
