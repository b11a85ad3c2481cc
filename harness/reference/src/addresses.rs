//! What references and pointers hold: addresses in bytes, and how the variables of a program lie there.
//!
//! The machine's memory is one of cells; only what follows a reference or pointer sees bytes. The upper half of an address is the number
//! of a variable, from 1, so that what is added to an address or taken from it never reaches another variable; the lower half is the
//! offset in bytes. 0 is the address of nothing.
//!
//! Basis: rule: memory-of-pointers.

use crate::instruction::{Address, RoutineId};
use stickler_types::ElementaryType;

/// An index into [`AddressMap::layouts`].
pub type LayoutId = u32;

/// The variables that have addresses, and the layouts of their values; nothing where a program has no references and pointers.
#[derive(Debug, Default)]
pub struct AddressMap {
    /// The layouts of the types of these variables, and of what references and pointers lead to.
    pub layouts: Vec<Layout>,
    /// The variables in the order of their cells.
    pub objects: Vec<MemoryObject>,
}

/// The layout of the values of one type: their size in cells and in bytes, and where their parts are.
#[derive(Debug)]
pub struct Layout {
    /// The number of bytes, with those that fill it up to its alignment.
    pub size: u32,
    /// The number of which its offset in a larger value is a multiple.
    pub align: u32,
    /// The number of cells.
    pub cells: u32,
    /// The parts of the value.
    pub kind: LayoutKind,
}

/// The parts of a value.
#[derive(Debug)]
pub enum LayoutKind {
    /// A value of one cell.
    Plain(ElementaryType),
    /// STRING or WSTRING of this length: the code units and a zero.
    Text(ElementaryType, u32),
    /// Elements one behind the other.
    Array(LayoutId),
    /// Members with their offsets in bytes and in cells.
    Members(Box<[([u32; 2], LayoutId)]>),
}

/// A variable that has an address.
#[derive(Clone, Copy, Debug)]
pub struct MemoryObject {
    /// The first cell of the variable.
    pub cell: Address,
    /// The layout of the variable in bytes.
    pub layout: LayoutId,
    /// The body of the function that it belongs to, and what gives its inputs their defaults; it does not exist outside of these. `None`
    /// for a variable that always exists.
    pub frame: Option<[RoutineId; 2]>,
}

/// The units of offsets, as indices of pairs of them.
const BYTES: usize = 0;
const CELLS: usize = 1;

impl AddressMap {
    /// Returns the address of the value that begins at a cell; `None` where no variable with an address lies.
    pub fn address_of(&self, cell: Address) -> Option<u64> {
        let index = self.objects.partition_point(|object| object.cell <= cell);
        let object = self.objects.get(index.checked_sub(1)?)?;
        let (_, bytes, _) = self.descend(object.layout, cell - object.cell, CELLS, None)?;
        Some((index as u64) << 32 | u64::from(bytes))
    }

    /// Returns the variable of an address, the layout and the cell of the part that lies there, and the offset in bytes from its start:
    /// the part of the wanted layout that begins there, or else the value of one cell that has this byte. `None` where no variable has it.
    pub fn find(&self, address: u64, wanted: LayoutId) -> Option<(MemoryObject, LayoutId, Address, u32)> {
        let index = usize::try_from(address >> 32).ok()?.checked_sub(1)?;
        let object = *self.objects.get(index)?;
        let (layout, cells, within) = self.descend(object.layout, address as u32, BYTES, Some(wanted))?;
        Some((object, layout, object.cell + cells, within))
    }

    /// Returns the offset in bytes of the part of a value that lies at an offset in cells.
    pub fn offset_in_bytes(&self, layout: LayoutId, cells: u32) -> u32 {
        self.descend(layout, cells, CELLS, None)
            .map_or(0, |(_, bytes, _)| bytes)
    }

    /// Goes down to the part at an offset in one unit; gives its layout, its offset in the other unit, and what is left of the offset.
    fn descend(
        &self,
        mut layout: LayoutId,
        mut left: u32,
        unit: usize,
        wanted: Option<LayoutId>,
    ) -> Option<(LayoutId, u32, u32)> {
        let mut passed = 0;
        loop {
            let part = self.layouts.get(layout as usize)?;
            if left >= [part.size, part.cells][unit] {
                return None;
            }
            let is_there = left == 0 && wanted.is_none_or(|wanted| wanted == layout);
            match &part.kind {
                LayoutKind::Array(element) if !is_there => {
                    let one = self.layouts.get(*element as usize)?;
                    let sizes = [one.size, one.cells];
                    passed += left / sizes[unit] * sizes[1 - unit];
                    left %= sizes[unit];
                    layout = *element;
                }
                LayoutKind::Members(members) if !is_there => {
                    let next = members.partition_point(|(offsets, _)| offsets[unit] <= left);
                    let (offsets, member) = members.get(next.checked_sub(1)?)?;
                    passed += offsets[1 - unit];
                    left -= offsets[unit];
                    layout = *member;
                }
                _ => return Some((layout, passed, left)),
            }
        }
    }
}
