//! Gives everything that lives for the whole run its address: global variables, the frames of functions,
//! program instances. Recursion is forbidden, so each function needs one frame only.

use super::declare::{Declarer, narrow};
use super::model::{Model, Storage};
use super::specification::MAXIMUM_CELLS;
use super::types::{Kind, TypeId, TypeTable};
use crate::instruction::TextCell;
use crate::source::Span;
use crate::syntax::tree::VariableKind;
use stickler_types::Code;

/// How many code units all text variables together may hold.
const MAXIMUM_TEXT: u64 = 32 << 20;

/// The memory that has been given out.
#[derive(Debug, Default)]
pub(super) struct Memory {
    next: u64,
    text_units: u64,
    /// The text variables in it.
    pub(super) texts: Vec<TextCell>,
}

impl Memory {
    /// How many cells have been given out.
    pub(super) fn cells(&self) -> u32 {
        u32::try_from(self.next).unwrap_or(u32::MAX)
    }

    /// Takes cells for a value; gives their address, or `None` once the limit is reached.
    pub(super) fn allocate(&mut self, types: &TypeTable, ty: TypeId) -> Option<u32> {
        let extent = types.extent(ty);
        let next = self.next + u64::from(extent.size);
        let text_units = self.text_units.saturating_add(extent.text_units);
        if next > MAXIMUM_CELLS || text_units > MAXIMUM_TEXT {
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
        (self.next < MAXIMUM_CELLS).then(|| {
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
        Kind::Text { capacity, .. } => texts.push(TextCell {
            address,
            capacity: *capacity,
        }),
        Kind::Array(shape) => {
            let stride = types.extent(shape.element).size;
            for index in 0..shape.length {
                collect_texts(types, shape.element, address + index * stride, texts);
            }
        }
        Kind::Structure(structure) | Kind::FunctionBlock(structure) => {
            for (_, member) in structure.members.iter() {
                if member.kind != VariableKind::InOut {
                    collect_texts(types, member.ty, address + member.offset, texts);
                }
            }
        }
        _ => {}
    }
}

impl Declarer<'_, '_> {
    /// Gives everything its address; where memory does not suffice, that is said once.
    pub(super) fn lay_out(&mut self) -> Memory {
        let mut memory = Memory::default();
        if let Err(span) = self.place_all(&mut memory) {
            let message = format!(
                "the program needs more than {MAXIMUM_CELLS} cells of memory, or texts of more than \
                 {MAXIMUM_TEXT} characters"
            );
            self.report(Code::LimitExceeded, span, message);
        }
        memory
    }

    fn place_all(&mut self, memory: &mut Memory) -> Result<(), Span> {
        for index in 0..self.model.variables.len() {
            if self.model.variables[index].kind == VariableKind::Global {
                self.place_variable(narrow(index), memory)?;
            }
        }
        for index in 0..self.model.variables.len() {
            let variable = &self.model.variables[index];
            if variable.kind == VariableKind::External
                && let Some(&global) = self
                    .model
                    .globals
                    .get(&crate::syntax::tree::Folded(variable.name.text))
            {
                self.model.variables[index].storage = self.model.variable(global).storage;
            }
        }
        for index in 0..self.model.pous.len() {
            if self.model.pous[index].is_function() {
                self.place_frame(index, memory)?;
            }
        }
        for index in 0..self.model.instances.len() {
            let entry = &self.model.pous[self.model.instances[index].pou as usize];
            let base = memory
                .allocate(&self.model.types, entry.ty)
                .ok_or(entry.pou.name.span)?;
            self.model.instances[index].base = base;
        }
        self.fix_single_instances();
        Ok(())
    }

    /// The parameters of a function come first, then what it clears at each call.
    fn place_frame(&mut self, pou: usize, memory: &mut Memory) -> Result<(), Span> {
        for parameter in self.model.pous[pou].parameters.clone() {
            self.place_variable(parameter, memory)?;
        }
        let start = memory.cells();
        for index in self.model.pous[pou].variables.clone() {
            let kind = self.model.variable(index).kind;
            if !matches!(
                kind,
                VariableKind::Input | VariableKind::InOut | VariableKind::External
            ) {
                self.place_variable(index, memory)?;
            }
        }
        self.model.pous[pou].cleared = start..memory.cells();
        Ok(())
    }

    fn place_variable(&mut self, index: u32, memory: &mut Memory) -> Result<(), Span> {
        let Model { types, variables, .. } = &mut self.model;
        let variable = &mut variables[index as usize];
        let (pointer, span) = (variable.kind == VariableKind::InOut, variable.name.span);
        let address = if pointer {
            memory.cell()
        } else {
            memory.allocate(types, variable.ty)
        };
        let address = address.ok_or(span)?;
        variable.storage = if pointer {
            Storage::AbsolutePointer(address)
        } else {
            Storage::Absolute(address)
        };
        Ok(())
    }

    /// The variables of a program that runs in one place only lie at addresses that are known here.
    fn fix_single_instances(&mut self) {
        let mut counts = vec![0_u32; self.model.pous.len()];
        for instance in &self.model.instances {
            counts[instance.pou as usize] += 1;
        }
        for instance in &self.model.instances {
            if counts[instance.pou as usize] > 1 {
                continue;
            }
            for index in self.model.pous[instance.pou as usize].variables.clone() {
                let variable = &mut self.model.variables[index as usize];
                if let Storage::Instance(offset) = variable.storage {
                    variable.storage = Storage::Absolute(instance.base.saturating_add(offset));
                }
            }
        }
    }
}
