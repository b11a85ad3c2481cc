//! The locations of variables, and the code that reads and writes them there.

use super::lowering::{LoweredValue, Lowering};
use super::model::{DeclaredVariable, Storage};
use super::types::{Subrange, TypeId, TypeKind};
use crate::instruction::{Instruction, Part};
use stickler_syntax::source::Span;
use stickler_types::{Code, ElementaryType};

/// The location of a value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Location {
    /// At an address.
    Absolute(u32),
    /// Behind the address of the instance.
    Instance(u32),
    /// Behind the address that a cell holds.
    Pointer { cell: u32, offset: u32 },
    /// Behind the address that a cell of the instance holds.
    InstancePointer { cell: u32, offset: u32 },
    /// At the address on top of the stack, which can be used once.
    Stack,
    /// At the address in bytes on top of the stack, which can be used once: behind a reference or pointer.
    Bytes,
    /// At the character of a text whose place is on top of the stack, which can be used once.
    Character,
}

/// A variable, an element of one, or a part of its bits.
#[derive(Clone, Copy, Debug)]
pub(super) struct VariablePlace {
    pub(super) location: Location,
    /// The declared type; of a part, the type that it is part of.
    pub(super) ty: TypeId,
    /// The part of the bits that is selected.
    pub(super) part: Option<Part>,
    /// Whether the location belongs to a CONSTANT.
    pub(super) constant: bool,
    /// Whether the value is part of a union, so that its bytes, whose address is on the stack, lie in cells of their own.
    pub(super) overlaid: bool,
}

impl VariablePlace {
    /// Returns all of what lies at a location, and can be written.
    pub(super) const fn new(location: Location, ty: TypeId) -> VariablePlace {
        VariablePlace {
            location,
            ty,
            part: None,
            constant: false,
            overlaid: false,
        }
    }

    /// Returns the place of a whole variable.
    pub(super) fn of(variable: &DeclaredVariable<'_>) -> VariablePlace {
        VariablePlace {
            constant: variable.constant,
            ..VariablePlace::new(Location::of(variable.storage), variable.ty)
        }
    }

    /// The type of what stands there.
    pub(super) fn content(&self) -> TypeId {
        self.part.map_or(self.ty, |part| TypeId::of(part.ty))
    }
}

impl Location {
    /// Returns the location of a variable; of a VAR_IN_OUT, that of its argument.
    pub(super) fn of(storage: Storage) -> Location {
        match storage {
            Storage::Absolute(address) => Location::Absolute(address),
            Storage::Instance(offset) => Location::Instance(offset),
            Storage::AbsolutePointer(cell) => Location::Pointer { cell, offset: 0 },
            Storage::InstancePointer(cell) => Location::InstancePointer { cell, offset: 0 },
        }
    }
}

/// The kind of cells that a value takes.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum CellKind {
    Plain,
    Text,
    Many(u32),
}

impl Lowering<'_> {
    fn cells(&self, ty: TypeId) -> CellKind {
        match self.model.types.kind(ty) {
            TypeKind::Text { .. } => CellKind::Text,
            TypeKind::Array(_) | TypeKind::Structure(_) | TypeKind::FunctionBlock(_) => {
                CellKind::Many(self.model.types.extent(ty).size)
            }
            _ => CellKind::Plain,
        }
    }

    /// Returns whether values of a type are addresses of where they lie.
    pub(super) fn is_aggregate(&self, ty: TypeId) -> bool {
        matches!(self.cells(ty), CellKind::Many(_))
    }

    /// Returns whether a place is read and written byte by byte.
    fn is_peeked(&self, place: VariablePlace) -> bool {
        place.location == Location::Bytes && place.part.is_none() && self.cells(place.ty) == CellKind::Plain
    }

    /// The location some cells, or bytes, further on.
    pub(super) fn shifted(&mut self, mut location: Location, by: u32) -> Location {
        use Location::{Absolute, Bytes, Character, Instance, InstancePointer, Pointer, Stack};
        match &mut location {
            Absolute(offset) | Instance(offset) | Pointer { offset, .. } | InstancePointer { offset, .. } => {
                *offset = offset.saturating_add(by)
            }
            Stack | Bytes | Character => self.offset(by),
        }
        location
    }

    fn offset(&mut self, by: u32) {
        if by > 0 {
            self.emit(Instruction::Offset(by));
        }
    }

    /// Puts the address of a location on the stack.
    pub(super) fn push_address(&mut self, location: Location) {
        match location {
            Location::Absolute(address) => self.emit(Instruction::Address(address)),
            Location::Instance(offset) => self.emit(Instruction::InstanceAddress(offset)),
            Location::Pointer { cell, offset } => {
                self.emit(Instruction::Load(cell));
                self.offset(offset);
            }
            Location::InstancePointer { cell, offset } => {
                self.emit(Instruction::InstanceAddress(cell));
                self.emit(Instruction::Dereference);
                self.offset(offset);
            }
            Location::Stack | Location::Bytes | Location::Character => {}
        }
    }

    /// Returns the location of a place as one that can be used more than once.
    pub(super) fn pinned(&mut self, place: VariablePlace, span: Span) -> Location {
        let location = self.located(place).location;
        if self.refuses_address(place, span) || location != Location::Stack {
            return location;
        }
        let cell = self.temporary(span);
        self.emit(Instruction::Store(cell));
        Location::Pointer { cell, offset: 0 }
    }

    /// Puts what lies somewhere on the stack; of an aggregate, its address.
    pub(super) fn load(&mut self, place: VariablePlace) -> LoweredValue {
        if self.is_peeked(place) {
            let layout = self.layout(place.ty);
            self.emit(Instruction::Peek(layout));
            return LoweredValue::computed(self.model.types.value_type(place.ty));
        }
        let place = match place.overlaid {
            true => self.gathered(place),
            false => self.located(place),
        };
        match (self.cells(place.ty), place.location) {
            (CellKind::Many(_), location) => self.push_address(location),
            (CellKind::Text, location) => {
                self.push_address(location);
                self.emit(Instruction::LoadText);
            }
            (CellKind::Plain, Location::Absolute(address)) => self.emit(Instruction::Load(address)),
            (CellKind::Plain, Location::Character) => self.emit(Instruction::LoadCharacter),
            (CellKind::Plain, location) => {
                self.push_address(location);
                self.emit(Instruction::LoadIndirect);
            }
        }
        if let Some(part) = place.part {
            self.emit(Instruction::Part(part));
        }
        LoweredValue::computed(self.model.types.value_type(place.content()))
    }

    /// Puts on the stack what must lie below the value that is to be stored.
    pub(super) fn begin_store(&mut self, place: VariablePlace) {
        if !self.is_peeked(place) {
            self.located(place);
        }
        if self.has_address_below(place) {
            self.push_address(place.location);
        }
    }

    /// Returns whether the address of a place lies below the value that is to be stored there; else the place is in the instruction, or
    /// its address comes last.
    fn has_address_below(&self, place: VariablePlace) -> bool {
        let is_in_instruction = matches!(place.location, Location::Absolute(_));
        place.part.is_some()
            || match self.cells(place.ty) {
                CellKind::Text => false,
                CellKind::Plain => !is_in_instruction,
                CellKind::Many(_) => true,
            }
    }

    /// Stores the value on the stack, [`Self::begin_store`] having come before it.
    pub(super) fn finish_store(&mut self, place: VariablePlace, span: Span) {
        if self.is_peeked(place) {
            let layout = self.layout(place.ty);
            return self.emit_at(span, Instruction::Poke(layout));
        }
        if place.overlaid {
            return self.scatter(place, span);
        }
        if let (Some(part), Some(of)) = (place.part, self.model.elementary(place.ty)) {
            return self.store_part(place, part, of, span);
        }
        match (self.cells(place.ty), place.location) {
            (CellKind::Many(size), _) => self.copy(place.ty, size),
            (CellKind::Text, location) => {
                self.push_address(location);
                self.emit(Instruction::StoreText);
            }
            (CellKind::Plain, Location::Absolute(address)) => self.emit(Instruction::Store(address)),
            (CellKind::Plain, Location::Character) => {
                let of = self.model.source.dialect.text_elements;
                self.emit_at(span, Instruction::StoreCharacter(of));
            }
            (CellKind::Plain, _) => self.emit(Instruction::StoreIndirect),
        }
    }

    /// Copies the value of a field of a union, which is no plain one, to cells as others have.
    fn gathered(&mut self, place: VariablePlace) -> VariablePlace {
        let cell = self.temporary_of(place.ty, Span::default());
        let layout = self.layout(place.ty);
        self.emit(Instruction::Address(cell));
        self.emit(Instruction::Gather(layout));
        VariablePlace::new(Location::Absolute(cell), place.ty)
    }

    /// Stores a value that is no plain one in a field of a union.
    fn scatter(&mut self, place: VariablePlace, span: Span) {
        if self.cells(place.ty) == CellKind::Text {
            let cell = self.temporary_of(place.ty, span);
            self.emit(Instruction::Address(cell));
            self.emit(Instruction::StoreText);
            self.emit(Instruction::Address(cell));
        }
        let layout = self.layout(place.ty);
        self.emit_at(span, Instruction::Scatter(layout));
    }

    /// Reports a field of a union and a character of a text where the address of a cell is needed, which they have not; gives whether it is
    /// one.
    pub(super) fn refuses_address(&mut self, place: VariablePlace, span: Span) -> bool {
        let message = match place.location {
            _ if place.overlaid => {
                "a field of a UNION as VAR_IN_OUT or as the control variable of FOR is not implemented"
            }
            Location::Character => {
                "a character of a text as VAR_IN_OUT or as the control variable of FOR, its address and its bits are not implemented"
            }
            _ => return false,
        };
        self.report(Code::NotImplemented, span, message);
        true
    }

    /// Copies an aggregate. A function block keeps the number of its own type.
    fn copy(&mut self, ty: TypeId, size: u32) {
        let numbered = match self.model.types.kind(ty) {
            TypeKind::FunctionBlock(block) => self.model.pous[block.pou as usize].has_type_number,
            _ => false,
        };
        if numbered {
            for _ in 0..2 {
                self.offset(1);
                self.emit(Instruction::Swap);
            }
        }
        self.emit(Instruction::Copy(size - u32::from(numbered)));
    }

    /// Stores the value on the stack, nothing having been said of the place before; the limits of a subrange
    /// are checked.
    pub(super) fn store(&mut self, place: VariablePlace, span: Span) {
        self.begin_store(place);
        if self.has_address_below(place) {
            self.emit(Instruction::Swap);
        }
        if let (TypeKind::Subrange(limits), None) = (self.model.types.kind(place.ty), place.part) {
            self.emit_at(span, check_range(*limits));
        }
        self.finish_store(place, span);
    }

    /// Sets a part of a variable's bits; a variable with limits must still keep to them.
    fn store_part(&mut self, place: VariablePlace, part: Part, of: ElementaryType, span: Span) {
        self.emit(Instruction::StorePart { part, of });
        if let TypeKind::Subrange(limits) = *self.model.types.kind(place.ty)
            && !matches!(place.location, Location::Stack | Location::Bytes)
        {
            self.load(VariablePlace { part: None, ..place });
            self.emit_at(span, check_range(limits));
            self.emit(Instruction::Drop);
        }
    }

    /// Sets cells to zero and texts to nothing.
    pub(super) fn clear(&mut self, location: Location, cells: u32) {
        if cells > 0 {
            self.push_address(location);
            self.emit(Instruction::Clear(cells));
        }
    }
}

/// The instruction that checks the limits of a subrange.
pub(super) fn check_range(limits: Subrange) -> Instruction {
    let Subrange { base, low, high } = limits;
    Instruction::CheckRange {
        low: base.wrap(low).cast_signed(),
        high: base.wrap(high),
        unsigned: base.is_unsigned(),
    }
}
