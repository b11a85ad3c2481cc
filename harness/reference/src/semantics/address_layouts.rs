//! The layouts of types in bytes, by which references and pointers reach parts of values, and which SIZEOF measures.
//!
//! Basis: rule: memory-of-pointers; codesys-pages: _cds_operator_sizeof.

use super::lowering::Lowering;
use super::model::Storage;
use super::types::{Structure, TypeId, TypeKind, TypeTable};
use crate::addresses::{AddressMap, Layout, LayoutId, LayoutKind, MemoryObject};
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
    /// The cells that hold values between instructions, and their types.
    pub(super) temporaries: Vec<(u32, TypeId)>,
    /// Whether the address of any variable is taken.
    pub(super) are_taken: bool,
}

impl Lowering<'_> {
    /// Returns the layout of values of a type.
    pub(super) fn layout(&mut self, ty: TypeId) -> LayoutId {
        let units = self.model.source.dialect.conversions.moment_units;
        self.addresses.layout(&self.model.types, units, ty)
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

    /// Makes the map by which the machine finds variables, once all code is there.
    pub(super) fn address_map(&mut self) -> AddressMap {
        let mut objects = Vec::new();
        if self.addresses.are_taken && !self.reporter.has_errors() {
            let model = self.model;
            let of_pous = model.pous.iter().flat_map(|entry| {
                let frame = entry.is_function().then_some([entry.body, entry.initial]);
                entry
                    .variables
                    .clone()
                    .map(move |index| (model.variable(index), None, frame))
            });
            let of_instances = model.instances.iter().flat_map(|instance| {
                let variables = model.pous[instance.pou as usize].variables.clone();
                variables.map(|index| (model.variable(index), Some(instance.base), None))
            });
            let globals = model
                .variables
                .iter()
                .filter(|variable| variable.kind == VariableKind::Global);
            let globals = globals.map(|variable| (variable, None, None));
            for (variable, base, frame) in of_pous.chain(of_instances).chain(globals) {
                let cell = match (variable.storage, base) {
                    _ if variable.kind == VariableKind::External => continue,
                    (Storage::Absolute(cell), None) => cell,
                    (Storage::Instance(offset), Some(base)) => base + offset,
                    _ => continue,
                };
                let layout = self.layout(variable.ty);
                objects.push(MemoryObject { cell, layout, frame });
            }
            for (cell, ty) in std::mem::take(&mut self.addresses.temporaries) {
                let (layout, frame) = (self.layout(ty), None);
                objects.push(MemoryObject { cell, layout, frame });
            }
            objects.sort_by_key(|object| object.cell);
        }
        let layouts = std::mem::take(&mut self.addresses.layouts);
        AddressMap { layouts, objects }
    }
}

impl AddressLayouts {
    /// Returns the layout of values of a type.
    pub(super) fn layout(&mut self, types: &TypeTable, units: MomentUnits, ty: TypeId) -> LayoutId {
        let root = types.root(ty);
        if let Some(&known) = self.known.get(&root) {
            return known;
        }
        let (size, align, kind) = self.made_layout(types, units, root);
        let cells = types.extent(root).size.max(1);
        self.layouts.push(Layout {
            size,
            align,
            cells,
            kind,
        });
        let id = u32::try_from(self.layouts.len() - 1).unwrap_or(u32::MAX);
        self.known.insert(root, id);
        id
    }

    /// Returns the number of bytes of a value, and the number of which its offset is a multiple.
    pub(super) fn size(&mut self, types: &TypeTable, units: MomentUnits, ty: TypeId) -> (u32, u32) {
        let layout = self.layout(types, units, ty) as usize;
        (self.layouts[layout].size, self.layouts[layout].align)
    }

    /// Returns the number of bytes of a type, [`u32::MAX`] for all that are more, its alignment and its parts.
    fn made_layout(&mut self, types: &TypeTable, units: MomentUnits, root: TypeId) -> (u32, u32, LayoutKind) {
        match types.kind(root) {
            TypeKind::Elementary(ty) => plain(*ty, units),
            TypeKind::Subrange(subrange) => plain(subrange.base, units),
            TypeKind::Enumeration(_) => plain(ElementaryType::Int, units),
            TypeKind::Pointer(_) | TypeKind::Interface(_) => plain(ElementaryType::Lword, units),
            TypeKind::Text { ty, capacity } => {
                let unit = 1 + u32::from(*ty == ElementaryType::Wstring);
                ((capacity + 1) * unit, unit, LayoutKind::Text(*ty, *capacity))
            }
            TypeKind::Array(shape) => {
                let element = self.layout(types, units, shape.element);
                let one = &self.layouts[element as usize];
                let size = one.size.saturating_mul(shape.length);
                (size, one.align, LayoutKind::Array(element))
            }
            TypeKind::Structure(union) if union.is_union => {
                let members = union.members.iter();
                let aligns = members.map(|(_, member)| self.size(types, units, member.ty).1);
                let align = aligns.max().unwrap_or(1);
                let byte = self.layout(types, units, TypeId::of(ElementaryType::Byte));
                (types.extent(root).size, align, LayoutKind::Array(byte))
            }
            TypeKind::Structure(structure) => self.members(types, units, structure, 0),
            TypeKind::FunctionBlock(structure) => self.members(types, units, structure, GAP),
            // Nothing that has an error is run.
            TypeKind::Alias | TypeKind::Error => plain(ElementaryType::Bool, units),
        }
    }

    /// Lays members out one behind the other, each at a multiple of its alignment, with at least a gap between them. A VAR_IN_OUT, which
    /// holds no value of its own, is left out. Those of what is extended come first.
    fn members(
        &mut self,
        types: &TypeTable,
        units: MomentUnits,
        structure: &Structure,
        gap: u32,
    ) -> (u32, u32, LayoutKind) {
        let (mut end, mut align) = (0_u32, 1);
        let mut members = Vec::new();
        let mut levels = vec![structure];
        while let Some(base) = levels.last().and_then(|level| types.structure(level.base?)) {
            levels.push(base);
        }
        for (_, member) in levels.iter().rev().flat_map(|level| level.members.iter()) {
            if member.kind == VariableKind::InOut {
                continue;
            }
            let id = self.layout(types, units, member.ty);
            let layout = &self.layouts[id as usize];
            let offset = end.checked_next_multiple_of(layout.align).unwrap_or(u32::MAX);
            align = align.max(layout.align);
            end = offset.saturating_add(layout.size).saturating_add(gap);
            members.push(([offset, member.offset], id));
        }
        let size = end.checked_next_multiple_of(align).unwrap_or(u32::MAX).max(1);
        (size, align, LayoutKind::Members(members.into()))
    }
}

fn plain(ty: ElementaryType, units: MomentUnits) -> (u32, u32, LayoutKind) {
    use ElementaryType::{Date, Dt, Time, Tod};
    let size = match ty {
        Time | Date | Tod | Dt if units == MomentUnits::Counts => 4,
        _ => (ty.bits() / 8).max(1),
    };
    (size, size, LayoutKind::Plain(ty))
}
