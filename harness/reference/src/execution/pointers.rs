//! Reads and writes what references and pointers lead to.
//!
//! A value of its own type is read from its cell. Where a pointer is of another type than what it leads to, the bytes count that the value
//! would have in a memory of bytes, the lowest first.
//!
//! Basis: rule: memory-of-pointers.

use super::machine::Machine;
use super::stop::Halt;
use crate::addresses::{Layout, LayoutId, LayoutKind};
use crate::instruction::{Address, FaultKind};
use crate::raw::narrow;
use stickler_types::ElementaryType;

/// The fault of what a memory of cells cannot do.
const NOT_MODELLED: FaultKind =
    FaultKind::Own("not implemented: a variable of another type behind a pointer to what is no plain value");

impl<'p> Machine<'p> {
    fn layout(&self, id: LayoutId) -> Result<&'p Layout, Halt> {
        let layout = self.program.addresses.layouts.get(id as usize);
        layout.ok_or(Halt::Missing("layout of a value"))
    }

    /// Finds the layout and the cell of what lies at an address, and the byte of it that is meant.
    fn find(&mut self, address: u64, wanted: LayoutId) -> Result<(&'p Layout, Address, u32), Halt> {
        self.spend(1)?;
        // What is counted from the address of nothing, such as that of a field, leads to nothing as well; before the first variable lies
        // the second half of these offsets.
        if address.cast_signed().unsigned_abs() < 1 << 31 {
            return Err(FaultKind::NullDereference.into());
        }
        match self.program.addresses.find(address, wanted) {
            Some((object, ..))
                if object
                    .frame
                    .is_some_and(|frame| !frame.iter().any(|&routine| self.is_running(routine))) =>
            {
                Err(FaultKind::InvalidAddress.into())
            }
            Some((_, layout, cell, within)) => Ok((self.layout(layout)?, cell, within)),
            None => Err(FaultKind::InvalidAddress.into()),
        }
    }

    /// Replaces the address of a cell on the stack by its address in bytes.
    pub(super) fn address_of(&mut self) -> Result<(), Halt> {
        let cell = self.pop_address()?;
        let address = self.program.addresses.address_of(cell);
        let address = address.ok_or(Halt::Missing("variable at this address"))?;
        self.operands.push(address);
        Ok(())
    }

    /// Replaces an address in bytes on the stack by that of the cell of a value of a layout.
    pub(super) fn locate(&mut self, id: LayoutId) -> Result<(), Halt> {
        let address = self.pop()?;
        let cell = self.own_cell(address, id)?.ok_or(NOT_MODELLED)?;
        self.operands.push(cell.into());
        Ok(())
    }

    /// Replaces an address in bytes on the stack by the plain value there.
    pub(super) fn peek(&mut self, id: LayoutId) -> Result<(), Halt> {
        let address = self.pop()?;
        let value = match self.own_cell(address, id)? {
            Some(cell) => self.memory.load(cell)?,
            None => {
                let (ty, size) = self.plain_layout(id)?;
                let mut bits = 0;
                for index in 0..size {
                    let byte = self.byte(address.wrapping_add(index.into()), id, None)?;
                    bits |= u64::from(byte) << (8 * index);
                }
                raw_form(ty, size, bits)
            }
        };
        self.operands.push(value);
        Ok(())
    }

    /// Pops a plain value and an address in bytes, and writes the value there.
    pub(super) fn poke(&mut self, id: LayoutId) -> Result<(), Halt> {
        let value = self.pop()?;
        let address = self.pop()?;
        if let Some(cell) = self.own_cell(address, id)? {
            return self.memory.store(cell, value);
        }
        let (ty, size) = self.plain_layout(id)?;
        let bits = stored_form(ty, size, value);
        // Nothing is written where not all of it finds room.
        for new in [false, true] {
            for index in 0..size {
                let byte = new.then_some((bits >> (8 * index)) as u8);
                self.byte(address.wrapping_add(index.into()), id, byte)?;
            }
        }
        Ok(())
    }

    /// Pops an address in bytes and that of a cell, and copies a value to the cells, or from them.
    pub(super) fn transfer(&mut self, id: LayoutId, to_cells: bool) -> Result<(), Halt> {
        let cell = self.pop_address()?;
        let address = self.pop()?;
        self.transfer_value(id, (address, cell), to_cells)
    }

    fn transfer_value(
        &mut self,
        id: LayoutId,
        (address, cell): (u64, Address),
        to_cells: bool,
    ) -> Result<(), Halt> {
        self.spend(1)?;
        let layout = self.layout(id)?;
        match &layout.kind {
            LayoutKind::Plain(_) if to_cells => {
                self.operands.push(address);
                self.peek(id)?;
                let value = self.pop()?;
                self.memory.store(cell, value)
            }
            LayoutKind::Plain(_) => {
                self.operands.extend([address, self.memory.load(cell)?]);
                self.poke(id)
            }
            LayoutKind::Text(ty, capacity) => {
                let step = 1 + u64::from(*ty == ElementaryType::Wstring);
                let mut units = vec![0; *capacity as usize];
                if !to_cells {
                    units = [self.memory.text(cell)?, &[0]].concat();
                }
                for (unit, position) in units.iter_mut().zip(0..) {
                    for (shift, byte) in [0, 8].into_iter().zip(0..step) {
                        let new = (!to_cells).then_some((*unit >> shift) as u8);
                        let at = address.wrapping_add(position * step + byte);
                        *unit |= u16::from(self.byte(at, id, new)?) << shift;
                    }
                }
                let length = units.iter().position(|&unit| unit == 0);
                match to_cells {
                    true => self
                        .memory
                        .store_text(cell, &units[..length.unwrap_or(units.len())]),
                    false => Ok(()),
                }
            }
            LayoutKind::Array(element) => {
                let one = self.layout(*element)?;
                for index in 0..layout.cells / one.cells {
                    let address = address.wrapping_add((index * one.size).into());
                    self.transfer_value(*element, (address, cell + index * one.cells), to_cells)?;
                }
                Ok(())
            }
            LayoutKind::Members(members) => {
                for &([bytes, cells], member) in members {
                    self.transfer_value(
                        member,
                        (address.wrapping_add(bytes.into()), cell + cells),
                        to_cells,
                    )?;
                }
                Ok(())
            }
        }
    }

    /// The raw form of a plain value of some bytes, each of which lies in a cell of its own; `None` where there are no such cells.
    pub fn plain_in_bytes(&self, cell: Address, size: u32, ty: ElementaryType) -> Option<u64> {
        let mut bytes = (0..size).rev();
        let bits = bytes.try_fold(0, |bits, index| Some(bits << 8 | self.plain(cell + index)?))?;
        Some(raw_form(ty, size, bits))
    }

    fn plain_layout(&self, id: LayoutId) -> Result<(ElementaryType, u32), Halt> {
        let layout = self.layout(id)?;
        match layout.kind {
            LayoutKind::Plain(ty) => Ok((ty, layout.size)),
            _ => Err(Halt::Missing("plain layout")),
        }
    }

    /// Returns the cell of the value at an address; `None` where it is not of the type of the pointer.
    fn own_cell(&mut self, address: u64, id: LayoutId) -> Result<Option<Address>, Halt> {
        let (found, cell, within) = self.find(address, id)?;
        let wanted = self.layout(id)?;
        let is_same = match (&found.kind, &wanted.kind) {
            (LayoutKind::Plain(one), LayoutKind::Plain(other))
            | (LayoutKind::Text(one, _), LayoutKind::Text(other, _)) => one == other,
            _ => std::ptr::eq(found, wanted),
        };
        Ok((within == 0 && is_same).then_some(cell))
    }

    /// Reads the byte at an address, having written it first where one is given.
    fn byte(&mut self, address: u64, id: LayoutId, new: Option<u8>) -> Result<u8, Halt> {
        let (layout, cell, within) = self.find(address, id)?;
        let replaced = |old: u64, shift: u32| match new {
            Some(byte) => (old & !(0xFF << shift)) | u64::from(byte) << shift,
            None => old,
        };
        match layout.kind {
            LayoutKind::Plain(ty) => {
                let bits = replaced(stored_form(ty, layout.size, self.memory.load(cell)?), 8 * within);
                if new.is_some() {
                    self.memory.store(cell, raw_form(ty, layout.size, bits))?;
                }
                Ok((bits >> (8 * within)) as u8)
            }
            LayoutKind::Text(ty, capacity) => {
                let (unit, shift) = match ty {
                    ElementaryType::Wstring => (within / 2, within % 2 * 8),
                    _ => (within, 0),
                };
                let bits = replaced(self.memory.unit(cell, unit)?.into(), shift);
                if new.is_some() {
                    self.spend_on_text(capacity.into())?;
                    self.memory.set_unit(cell, capacity, unit, bits as u16)?;
                }
                Ok((bits >> shift) as u8)
            }
            _ => Err(NOT_MODELLED.into()),
        }
    }
}

/// Returns the nanoseconds that one count of a moment of 32 bits stands for; 1 for all else.
fn unit_of(ty: ElementaryType, size: u32) -> i64 {
    match ty {
        ElementaryType::Time | ElementaryType::Tod if size == 4 => 1_000_000,
        ElementaryType::Date | ElementaryType::Dt if size == 4 => 1_000_000_000,
        _ => 1,
    }
}

/// Returns the bits that a memory of bytes has of a value.
fn stored_form(ty: ElementaryType, size: u32, raw: u64) -> u64 {
    let bits = raw.cast_signed().div_euclid(unit_of(ty, size)).cast_unsigned();
    bits & (u64::MAX >> (64 - 8 * size.clamp(1, 8)))
}

/// Returns the value of bits in a memory of bytes.
fn raw_form(ty: ElementaryType, size: u32, bits: u64) -> u64 {
    match ty {
        ElementaryType::Bool => u64::from(bits != 0),
        _ => narrow(bits, ty).wrapping_mul(unit_of(ty, size).cast_unsigned()),
    }
}
