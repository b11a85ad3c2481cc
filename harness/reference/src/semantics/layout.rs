//! Gives everything that lives for the whole run its address: global variables, the frames of functions,
//! program instances. Recursion is forbidden, so each function needs one frame only.

use super::declare::Declarer;
use super::memory::{MAX_CELLS, MAX_TEXT, MemoryLayout};
use super::model::{Model, Storage};
use stickler_syntax::source::{Span, saturating_u32};
use stickler_syntax::tree::VariableKind;
use stickler_types::Code;

impl Declarer<'_, '_> {
    /// Gives everything its address; where memory does not suffice, that is said once.
    pub(super) fn lay_out(&mut self) -> MemoryLayout {
        let mut memory = MemoryLayout::default();
        if let Err(span) = self.place_all(&mut memory) {
            let message = format!(
                "the program needs more than {MAX_CELLS} cells of memory, or texts of more than \
                 {MAX_TEXT} characters"
            );
            self.report(Code::LimitExceeded, span, message);
        }
        memory
    }

    fn place_all(&mut self, memory: &mut MemoryLayout) -> Result<(), Span> {
        // The address 0 is that of no instance.
        if self.model.has_members {
            memory.cell();
        }
        for index in 0..self.model.variables.len() {
            if matches!(
                self.model.variables[index].kind,
                VariableKind::Global | VariableKind::Static
            ) {
                self.place_variable(saturating_u32(index), memory)?;
            }
        }
        for index in 0..self.model.variables.len() {
            let variable = &self.model.variables[index];
            if variable.kind == VariableKind::External
                && let Some(&global) = self
                    .model
                    .globals
                    .get(&stickler_syntax::tree::CaseFolded(variable.name.text))
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
    fn place_frame(&mut self, pou: usize, memory: &mut MemoryLayout) -> Result<(), Span> {
        for parameter in self.model.pous[pou].parameters.clone() {
            self.place_variable(parameter, memory)?;
        }
        let start = memory.cells();
        for index in self.model.pous[pou].variables.clone() {
            let kind = self.model.variable(index).kind;
            if kind.is_held() && !matches!(kind, VariableKind::Input | VariableKind::Static) {
                self.place_variable(index, memory)?;
            }
        }
        self.model.pous[pou].cleared = start..memory.cells();
        Ok(())
    }

    fn place_variable(&mut self, index: u32, memory: &mut MemoryLayout) -> Result<(), Span> {
        let Model { types, variables, .. } = &mut self.model;
        let variable = &mut variables[index as usize];
        let storage = match variable.kind {
            VariableKind::InOut => {
                let address = memory.cell();
                for _ in 0..variable.limits {
                    memory.cell().ok_or(variable.name.span)?;
                }
                address.map(Storage::AbsolutePointer)
            }
            _ => memory.allocate(types, variable.ty).map(Storage::Absolute),
        };
        variable.storage = storage.ok_or(variable.name.span)?;
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
