//! How values of each type lie in bytes, behind references and pointers and for SIZEOF.
//!
//! Basis: rule: memory-of-pointers; codesys-pages: _cds_operator_sizeof.

use super::lowering::Lowering;
use super::types::{Structure, TypeId, TypeKind};
use crate::addresses::{Layout, LayoutId, LayoutKind};
use rustc_hash::FxHashMap;
use stickler_syntax::tree::VariableKind;
use stickler_types::{ElementaryType, MomentUnits};

/// The bytes between the variables of a function block, which are variables of their own: what runs past the end of one meets none.
const GAP: u32 = 64;

/// The layouts that a program needs.
#[derive(Debug, Default)]
pub(super) struct AddressLayouts {
    pub(super) layouts: Vec<Layout>,
    known: FxHashMap<TypeId, LayoutId>,
    /// Whether the address of any variable is taken.
    pub(super) are_taken: bool,
}

impl Lowering<'_> {
    /// Returns the layout of values of a type.
    pub(super) fn layout(&mut self, ty: TypeId) -> LayoutId {
        let root = self.model.types.root(ty);
        if let Some(&known) = self.addresses.known.get(&root) {
            return known;
        }
        let layout = self.made_layout(root);
        self.addresses.layouts.push(layout);
        let id = u32::try_from(self.addresses.layouts.len() - 1).unwrap_or(u32::MAX);
        self.addresses.known.insert(root, id);
        id
    }

    /// Returns the numbers of bytes and of cells of a value.
    pub(super) fn sizes(&mut self, ty: TypeId) -> (u32, u32) {
        let layout = self.layout(ty) as usize;
        let layout = &self.addresses.layouts[layout];
        (layout.size, layout.cells)
    }

    /// Returns the offset in bytes of the member of a structure or function block that lies at an offset in cells.
    pub(super) fn member_offset(&mut self, ty: TypeId, cells: u32) -> u32 {
        let layout = self.layout(ty) as usize;
        let LayoutKind::Members(members) = &self.addresses.layouts[layout].kind else {
            return 0;
        };
        let found = members.iter().find(|(offsets, _)| offsets[1] == cells);
        found.map_or(0, |(offsets, _)| offsets[0])
    }

    fn made_layout(&mut self, root: TypeId) -> Layout {
        let model = self.model;
        match model.types.kind(root) {
            TypeKind::Elementary(ty) => self.plain(*ty),
            TypeKind::Subrange(subrange) => self.plain(subrange.base),
            TypeKind::Enumeration(_) => self.plain(ElementaryType::Int),
            TypeKind::Pointer(_) | TypeKind::Interface(_) => self.plain(ElementaryType::Lword),
            TypeKind::Text { ty, capacity } => {
                let align = 1 + u32::from(*ty == ElementaryType::Wstring);
                Layout {
                    size: (capacity + 1) * align,
                    align,
                    cells: 1,
                    kind: LayoutKind::Text(*ty, *capacity),
                }
            }
            TypeKind::Array(shape) => {
                let element = self.layout(shape.element);
                let one = &self.addresses.layouts[element as usize];
                Layout {
                    size: one.size.saturating_mul(shape.length),
                    align: one.align,
                    cells: one.cells.saturating_mul(shape.length),
                    kind: LayoutKind::Array(element),
                }
            }
            TypeKind::Structure(structure) => self.members(structure, 0),
            TypeKind::FunctionBlock(structure) => self.members(structure, GAP),
            // Nothing that has an error is run.
            TypeKind::Alias | TypeKind::Error => self.plain(ElementaryType::Bool),
        }
    }

    fn plain(&self, ty: ElementaryType) -> Layout {
        use ElementaryType::{Date, Dt, Time, Tod};
        let counts = self.model.source.dialect.conversions.moment_units == MomentUnits::Counts;
        let size = match ty {
            Time | Date | Tod | Dt if counts => 4,
            _ => (ty.bits() / 8).max(1),
        };
        let kind = LayoutKind::Plain(ty);
        Layout {
            size,
            align: size,
            cells: 1,
            kind,
        }
    }

    /// Lays members out one behind the other, each at a multiple of its alignment, with at least a gap between them. A VAR_IN_OUT, which
    /// holds no value of its own, is left out. Those of what is extended come first.
    fn members(&mut self, structure: &Structure, gap: u32) -> Layout {
        let (mut end, mut align, mut cells) = (0_u32, 1, 0);
        let mut members = Vec::new();
        let types = &self.model.types;
        let mut levels = vec![structure];
        while let Some(base) = levels.last().and_then(|level| types.structure(level.base?)) {
            levels.push(base);
        }
        for (_, member) in levels.iter().rev().flat_map(|level| level.members.iter()) {
            cells = member.offset.saturating_add(1);
            if member.kind == VariableKind::InOut {
                continue;
            }
            let id = self.layout(member.ty);
            let layout = &self.addresses.layouts[id as usize];
            let offset = end.next_multiple_of(layout.align);
            align = align.max(layout.align);
            end = offset.saturating_add(layout.size).saturating_add(gap);
            cells = member.offset.saturating_add(layout.cells);
            members.push(([offset, member.offset], id));
        }
        Layout {
            size: end.next_multiple_of(align).max(1),
            align,
            cells: cells.max(1),
            kind: LayoutKind::Members(members.into()),
        }
    }
}
