//! The memory of a program: which cells have been given out, and which of them hold texts.

use super::types::{TypeId, TypeKind, TypeTable};
use crate::instruction::TextCell;
use stickler_syntax::tree::VariableKind;

/// The most cells that one variable, and the whole program, may take.
pub(super) const MAX_CELLS: u64 = 4 << 20;

/// The most code units that all text variables together may hold.
pub(super) const MAX_TEXT: u64 = 32 << 20;

/// The memory that has been given out.
#[derive(Debug, Default)]
pub(super) struct MemoryLayout {
    next: u64,
    text_units: u64,
    /// The text variables in it.
    pub(super) texts: Vec<TextCell>,
}

impl MemoryLayout {
    /// Returns the number of cells that have been given out.
    pub(super) fn cells(&self) -> u32 {
        u32::try_from(self.next).unwrap_or(u32::MAX)
    }

    /// Takes cells for a value; gives their address, or `None` once the limit is reached.
    pub(super) fn allocate(&mut self, types: &TypeTable, ty: TypeId) -> Option<u32> {
        let extent = types.extent(ty);
        let next = self.next + u64::from(extent.size);
        let text_units = self.text_units.saturating_add(extent.text_units);
        if next > MAX_CELLS || text_units > MAX_TEXT {
            return None;
        }
        let address = self.cells();
        (self.next, self.text_units) = (next, text_units);
        collect_texts(types, ty, address, &mut self.texts);
        Some(address)
    }

    /// Takes one plain cell.
    pub(super) fn cell(&mut self) -> Option<u32> {
        let address = self.cells();
        (self.next < MAX_CELLS).then(|| {
            self.next += 1;
            address
        })
    }
}

/// Notes the text variables in a value that lies at an address. Types nest no deeper than their limit.
fn collect_texts(types: &TypeTable, ty: TypeId, address: u32, texts: &mut Vec<TextCell>) {
    if types.extent(ty).text_units == 0 {
        return;
    }
    match types.kind(ty) {
        TypeKind::Text { capacity, .. } => texts.push(TextCell {
            address,
            capacity: *capacity,
        }),
        TypeKind::Array(shape) => {
            let stride = types.extent(shape.element).size;
            for index in 0..shape.length {
                collect_texts(types, shape.element, address + index * stride, texts);
            }
        }
        TypeKind::Structure(structure) | TypeKind::FunctionBlock(structure) => {
            if let Some(base) = structure.base {
                collect_texts(types, base, address, texts);
            }
            for (_, member) in structure.members.iter() {
                if member.kind != VariableKind::InOut {
                    collect_texts(types, member.ty, address + member.offset, texts);
                }
            }
        }
        _ => {}
    }
}
