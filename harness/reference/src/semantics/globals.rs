//! Declares global variables, and gives VAR_EXTERNAL the ones that they stand for.
//!
//! A VAR_EXTERNAL without its VAR_GLOBAL is P4007, and one of another type P4035.

use super::constant::Constant;
use super::declare::Declarer;
use super::model::DeclaredVariable;
use super::types::TypeId;
use stickler_syntax::source::saturating_u32;
use stickler_syntax::tree::{CaseFolded, Name, PouKind, VariableBlock, VariableGroup, VariableKind};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Declares the global variables in the order of the text, their types aside, so that types can name constants.
    pub(super) fn declare_globals(&mut self) {
        for block in self.global_blocks.clone() {
            for group in &block.groups {
                let value = if block.constant {
                    let ty = self.written(&group.specification);
                    self.constant_of_type(group, ty)
                } else {
                    Constant::Variable
                };
                for name in &group.names {
                    self.declare_global(*name, block, group, value.clone());
                }
            }
        }
    }

    /// Gives the global variables their types.
    pub(super) fn resolve_globals(&mut self) {
        let mut index = 0;
        for block in std::mem::take(&mut self.global_blocks) {
            for group in &block.groups {
                let hint = group.names.first().map_or("", |name| name.text);
                let ty = self.group_type(group, hint);
                self.check_group(PouKind::Program, block, group, ty);
                for _ in &group.names {
                    let variable = &mut self.model.variables[index];
                    variable.ty = ty;
                    if ty == TypeId::ERROR && block.constant {
                        variable.value = Constant::Silent;
                    }
                    index += 1;
                }
            }
        }
    }

    fn declare_global(
        &mut self,
        name: Name<'u>,
        block: &VariableBlock<'u>,
        group: &'u VariableGroup<'u>,
        value: Constant,
    ) {
        let index = saturating_u32(self.model.variables.len());
        let known = *self.model.globals.entry(CaseFolded(name.text)).or_insert(index);
        if known != index {
            let message = format!("global variable `{}` is already declared", name.text);
            self.report(Code::SymbolDeclDuplicated, name.span, message);
        }
        let variable =
            DeclaredVariable::new(name, TypeId::ERROR, VariableKind::Global).declared(block, group);
        self.model.variables.push(DeclaredVariable { value, ..variable });
    }

    /// Gives VAR_IN_OUT and VAR_EXTERNAL their types, and the latter the variables that they stand for.
    pub(super) fn resolve_deferred(&mut self) {
        for deferred in std::mem::take(&mut self.deferred) {
            self.current = Some(deferred.pou);
            let is_parameter = self.model.variables[deferred.variables.start].limits > 0;
            let ty = match is_parameter {
                true => self.parameter_type(deferred.specification, deferred.hint),
                false => self.specification(deferred.specification, deferred.hint),
            };
            for index in deferred.variables {
                self.model.variables[index].ty = ty;
                if self.model.variables[index].kind == VariableKind::External {
                    self.resolve_external(index);
                }
            }
        }
        self.current = None;
    }

    fn resolve_external(&mut self, index: usize) {
        let (name, ty) = (self.model.variables[index].name, self.model.variables[index].ty);
        let Some(&global) = self.model.globals.get(&CaseFolded(name.text)) else {
            let message = format!("there is no global variable `{}`", name.text);
            self.report(Code::VariableUndefined, name.span, message);
            self.model.variables[index].ty = TypeId::ERROR;
            return;
        };
        let DeclaredVariable {
            ty: other,
            constant,
            ref value,
            ..
        } = *self.model.variable(global);
        let value = value.clone();
        let known = ty != TypeId::ERROR && other != TypeId::ERROR;
        if known && self.model.types.root(ty) != self.model.types.root(other) {
            let (here, there) = (self.model.types.name(ty), self.model.types.name(other));
            let message = format!("global variable `{}` is of type {there}, not {here}", name.text);
            self.report(Code::AssignmentTypeMismatch, name.span, message);
        }
        let variable = &mut self.model.variables[index];
        variable.constant |= constant;
        variable.value = value;
        variable.ty = other;
    }
}
