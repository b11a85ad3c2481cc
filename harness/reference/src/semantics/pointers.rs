//! What follows references and pointers: `^`, `REF=`, ADR, REF, SIZEOF, and the code that reads and writes behind them.
//!
//! Basis: iec-61131-3: Table 12 of the third edition; codesys-pages: _cds_datatype_pointer; codesys-pages: _cds_datatype_reference;
//! codesys-pages: _cds_operator_sizeof; ironplc-problem-codes: P2028 to P2035; rule: memory-of-pointers.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::{Inferred, Magnitude};
use super::locations::{Location, VariablePlace};
use super::lowering::{LoweredValue, Lowering};
use super::model::TopLevelName;
use super::parameters::single_argument;
use super::pointer_types::{addresses_are_numbers, fits_pointer};
use super::types::{PointerType, TypeId, TypeMember};
use crate::instruction::{ArithmeticOperator, ComparisonOperator, Instruction};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, BinaryOperator, ExpressionId, ExpressionKind, PointerForm, VariableKind,
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
    /// LOWER_BOUND: the lowest subscript of a dimension.
    LowerBound,
    /// UPPER_BOUND: the highest subscript of a dimension.
    UpperBound,
}

impl AddressFunction {
    /// Returns the function of a name, and its key in `conformance-cases/features.toml`.
    pub(super) fn of(name: &str) -> Option<(AddressFunction, &'static str)> {
        use AddressFunction::{Adr, IsValidRef, LowerBound, Ref, SizeOf, UpperBound};
        let all = [
            (Adr, "ADR", "adr"),
            (Ref, "REF", "ref"),
            (SizeOf, "SIZEOF", "sizeof"),
            (IsValidRef, "__ISVALIDREF", "__isvalidref"),
            (LowerBound, "LOWER_BOUND", "bound-function"),
            (UpperBound, "UPPER_BOUND", "bound-function"),
        ];
        let found = all.into_iter().find(|(_, own, _)| name.eq_ignore_ascii_case(own));
        found.map(|(function, _, feature)| (function, feature))
    }
}

impl<'m> Lowering<'m> {
    fn addresses_are_numbers(&self) -> bool {
        addresses_are_numbers(self.model.source.dialect)
    }

    /// Returns whether a name that is not declared is the reference to nothing.
    pub(super) fn is_null(&self, name: &str) -> bool {
        name.eq_ignore_ascii_case("NULL") && !self.model.source.dialect.lacks("null")
    }

    /// Returns whether a pointer takes subscripts of its own: `p[i]` is the value `i` sizes behind `p^`.
    pub(super) fn has_elements(&self, pointer: PointerType, subscripts: usize) -> bool {
        subscripts == 1 && pointer.form == PointerForm::PointerTo && self.addresses_are_numbers()
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

    /// Returns the type with which the variable of `base^` is declared; `None` where the base is no reference or pointer, or NULL.
    pub(super) fn target_type(&mut self, base: ExpressionId) -> Option<TypeId> {
        match self.infer(base) {
            Inferred::Known(ty) if ty != TypeId::ADDRESS => Some(self.model.types.pointer(ty)?.target),
            _ => None,
        }
    }

    /// The place of `base^`.
    pub(super) fn dereference(&mut self, base: ExpressionId) -> Option<VariablePlace> {
        let target = self.target_type(base);
        let value = self.value(base, None);
        if let Some(target) = target {
            return behind(target);
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

    /// The place of an element behind a pointer to the type `target`, whose place is given.
    ///
    /// Basis: codesys-pages: _cds_datatype_pointer (index access).
    pub(super) fn pointer_element(
        &mut self,
        place: VariablePlace,
        target: TypeId,
        subscript: ExpressionId,
    ) -> Option<VariablePlace> {
        self.load(place);
        self.integer(subscript, ElementaryType::Lint, ValueContext::Integer)?;
        let (bytes, _) = self.sizes(target);
        self.emit(Instruction::Push(bytes.into()));
        for operator in [ArithmeticOperator::Multiply, ArithmeticOperator::Add] {
            self.emit(Instruction::Arithmetic(operator, ElementaryType::Lint));
        }
        behind(target)
    }

    /// The place of a value whose members are looked for: of a union, by its address in bytes.
    pub(super) fn entered(&mut self, place: VariablePlace) -> VariablePlace {
        if !self.model.types.is_union(place.ty) {
            return place;
        }
        self.push_address_in_bytes(place.location);
        VariablePlace {
            location: Location::Bytes,
            overlaid: true,
            ..place
        }
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
        if place.location != Location::Bytes || place.overlaid {
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
        let place = self.whole_place(id, Code::RefOperandNotVariable, "only a variable has an address")?;
        use ExpressionKind::{Field, Index};
        let is_part = matches!(self.expression(id).kind, Field { .. } | Index { .. });
        if is_part && self.model.source.dialect.lacks("reference-to-part") {
            let message = "the dialect has no references to a part of a variable";
            self.report(Code::RefOfArrayElement, span, message);
        }
        if !self.addresses_are_numbers() && self.is_ephemeral(id) {
            let message = "the variable does not outlive the call, so nothing may refer to it";
            self.report(Code::RefOfEphemeralVariable, span, message);
        }
        self.push_address_in_bytes(place.location);
        Some(place.ty)
    }

    /// Puts the address in bytes of a location on the stack, where it is not there already.
    fn push_address_in_bytes(&mut self, location: Location) {
        if location != Location::Bytes {
            self.push_address(location);
            self.emit(Instruction::AddressOf);
            self.addresses.are_taken = true;
        }
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
            use VariableKind::{Input, Local, Output, Temporary};
            let in_function = function.is_some_and(|entry| entry.variables.contains(&index));
            variable.kind == Temporary || in_function && matches!(variable.kind, Local | Input | Output)
        })
    }

    /// Puts the address of a variable on the stack to which a variable of the type `target`, which is declared with REFERENCE TO, is bound.
    pub(super) fn bind_reference(&mut self, id: ExpressionId, target: TypeId) -> LoweredValue {
        if self.model.source.text_of(id) == "0" {
            self.emit(Instruction::Push(0));
            return LoweredValue::computed(target);
        }
        let named = self
            .address_operand(id)
            .filter(|_| self.model.source.dialect.references_are_pointers);
        let Some(ty) = self.push_address_of(named.unwrap_or(self.model.source.bare(id))) else {
            return LoweredValue::ERROR;
        };
        let types = &self.model.types;
        let wanted = types.pointer(target).map_or(target, |pointer| pointer.target);
        let fits = types.is_same_variable(ty, wanted) || types.derives(ty, wanted);
        if wanted != TypeId::ERROR && !fits {
            let (target, ty) = (types.name(target), types.name(ty));
            let message = format!("{target} is bound to a variable, not {ty}");
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
        let is_pointer = self.model.types.pointer(place.ty).is_some();
        let is_bound = is_pointer && self.model.source.dialect.references_are_pointers;
        if self.model.types.named_type(place.ty) == place.ty && !is_bound {
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
        if types.pointer(from).is_none() || addresses_are_numbers(dialect) && !is_interface {
            return false;
        }
        let (code, message) = match (types.pointer(to), self.address_operand(id)) {
            (Some(pointer), Some(operand)) => {
                let ty = self.declared_type_of(operand).unwrap_or(TypeId::ERROR);
                let (ty, target) = (types.named_type(ty), pointer.target);
                if types.is_same(ty, target) || [ty, target].contains(&TypeId::ERROR) {
                    return false;
                }
                let message = format!("a reference to {} is no {}", types.name(ty), types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (Some(_), None) if !fits_pointer(from, to, types, dialect) => {
                let message = format!("{} is no {}", types.name(from), types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (None, Some(_)) if from == TypeId::ADDRESS && is_interface => {
                let message = format!("the address of a variable is no {}", types.name(to));
                (Code::ReferenceTypeMismatch, message)
            }
            (None, None) if from == TypeId::ADDRESS && to != TypeId::ERROR && !is_interface => {
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
        let types = &self.model.types;
        let is_pointer = |value| matches!(value, Inferred::Known(ty) if types.pointer(ty).is_some());
        match operator {
            _ if !is_pointer(left) && !is_pointer(right) => Code::OperatorOperandTypeMismatch,
            Equal | NotEqual => Code::ReferenceTypeMismatch,
            Less | LessOrEqual | Greater | GreaterOrEqual => Code::OrderingOnReference,
            _ if self.model.source.dialect.pointers_count_variables => Code::NotImplemented,
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
            AddressFunction::LowerBound | AddressFunction::UpperBound => Inferred::from(ElementaryType::Dint),
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
        if let AddressFunction::LowerBound | AddressFunction::UpperBound = function {
            let limit = u32::from(function == AddressFunction::UpperBound);
            return self.call_bound(call, limit, arguments);
        }
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
            _ => {
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
        let is_place = self.names_a_place(operand);
        match is_place.then(|| self.place_itself(operand)).flatten() {
            Some(place) if self.model.types.named_type(place.ty) != place.ty => {
                self.load(place);
                self.emit(Instruction::Push(0));
                let not_equal = ComparisonOperator::NotEqual;
                self.emit(Instruction::Compare(not_equal, ElementaryType::Ulint));
            }
            _ => {
                let message = "`__ISVALIDREF` takes a variable that is declared with REFERENCE TO";
                self.report(Code::FunctionCallArgTypeMismatch, self.span(operand), message);
            }
        }
        LoweredValue::of(ElementaryType::Bool)
    }

    /// Returns the type of a variable, of what a call gives, or the type that an operand of SIZEOF names.
    fn sized_type(&mut self, operand: ExpressionId) -> Option<TypeId> {
        if let ExpressionKind::Name(name) = self.expression(operand).kind
            && self.variable(name.text).is_none()
        {
            let elementary = ElementaryType::from_name(name.text);
            let dialect = self.model.source.dialect;
            return match self.model.definition(name) {
                Some(TopLevelName::Pou(pou)) => Some(self.model.pous[pou as usize].ty),
                Some(TopLevelName::Type(_)) => self.declared_type(name),
                None => elementary.filter(|&ty| dialect.may_name(ty)).map(TypeId::of),
            };
        }
        let declared = self.declared_type_of(operand);
        let is_address = declared.is_none() && self.infer(operand) == Inferred::Known(TypeId::ADDRESS);
        let address = is_address && self.model.source.dialect.results_are_variables;
        let ty = declared.or(address.then_some(TypeId::ADDRESS))?;
        Some(self.model.types.named_type(ty))
    }

    /// Returns the number of bytes of what SIZEOF is applied to; `None` where it has no size that is known.
    fn size_of(&mut self, operand: ExpressionId) -> Option<i128> {
        let ty = self.sized_type(operand).filter(|&ty| ty != TypeId::ERROR)?;
        let types = &self.model.types;
        let has_size = !types.extent(ty).has_block && !types.is_variable_length(ty);
        let size = has_size.then(|| self.sizes(ty).0);
        size.filter(|&size| size < u32::MAX).map(i128::from)
    }

    fn refuse_size(&mut self, operand: ExpressionId) -> LoweredValue {
        let (code, message) = match self.sized_type(operand) {
            Some(TypeId::ERROR) => return LoweredValue::ERROR,
            Some(_) => (
                Code::NotImplemented,
                "sizes of function blocks, of ARRAY[*], and of 4 GiB and more, are not implemented",
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
}

/// The place behind an address in bytes that is on the stack; `None` where its type is not known.
fn behind(ty: TypeId) -> Option<VariablePlace> {
    (ty != TypeId::ERROR).then_some(VariablePlace::new(Location::Bytes, ty))
}
