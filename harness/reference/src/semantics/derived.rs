//! User-defined names of elementary types, and subranges of them: where a dialect converts them to no other type.

use super::calls::Callee;
use super::contexts::ValueContext;
use super::inferred::Inferred;
use super::lowering::Lowering;
use super::suggestion::describe;
use super::types::{TypeId, TypeKind, TypeMember};
use stickler_syntax::tree::{ExpressionId, ExpressionKind, VariableKind};

impl<'m> Lowering<'m> {
    /// Returns whether a value would have to convert to the type of `target` although it, or `target`, is of a user-defined type that
    /// converts to nothing. A value of the same elementary type stays what it is.
    ///
    /// Basis: implicit-conversion-rules: ANY_DATE, STRING and user defined.
    pub(super) fn refuses_derived(&mut self, id: ExpressionId, from: Inferred, target: TypeId) -> bool {
        if self.model.source.dialect.derived_types_convert {
            return false;
        }
        let converts = matches!(from, Inferred::Known(from) if from != self.model.types.value_type(target));
        converts && (self.model.types.is_derived(target) || self.is_of_derived_type(id))
    }

    /// Reports a value that is refused so, with the conversion call that would make it fit.
    pub(super) fn report_derived(
        &mut self,
        id: ExpressionId,
        inferred: Inferred,
        target: TypeId,
        context: ValueContext,
    ) {
        let types = &self.model.types;
        let declared = self.declared_type_of(id).filter(|&ty| types.is_derived(ty));
        let from = declared.map_or_else(|| describe(types, inferred), |ty| types.name(ty));
        let message = format!(
            "{from} does not convert implicitly to {}: a user-defined type never does",
            types.name(target)
        );
        self.report_misfit_as(id, inferred, types.value_type(target), context, message);
    }

    /// Returns whether an expression is a variable, or the result of a function, that is declared with a user-defined type.
    pub(super) fn is_of_derived_type(&mut self, id: ExpressionId) -> bool {
        let declared = self.declared_type_of(id);
        declared.is_some_and(|ty| self.model.types.is_derived(ty))
    }

    /// Returns the type with which the variable or the function of an expression is declared; `None` for all that is computed.
    pub(super) fn declared_type_of(&mut self, id: ExpressionId) -> Option<TypeId> {
        let types = &self.model.types;
        match self.expression(self.model.source.bare(id)).kind {
            ExpressionKind::Name(name) => Some(self.variable(name.text)?.1.ty),
            ExpressionKind::Field { base, field } => {
                if let Some(variable) = self.own_in_out(base, field) {
                    return Some(variable.ty);
                }
                let ty = self.known_type(base)?;
                let member = self.member_of(base, ty, field.text)?;
                Some(member.ty)
            }
            ExpressionKind::Index { base, ref subscripts } => match types.kind(self.known_type(base)?) {
                TypeKind::Array(shape) if shape.dimensions.len() == subscripts.len() => Some(shape.element),
                TypeKind::Text { ty, .. } => self.character_type(*ty, subscripts.len()).map(TypeId::of),
                TypeKind::Pointer(pointer) if self.has_elements(*pointer, subscripts.len()) => {
                    Some(pointer.target)
                }
                _ => None,
            },
            ExpressionKind::Dereference { base } => self.target_type(base),
            ExpressionKind::Call { callee, .. } => match self.callee(callee) {
                Callee::Function(pou) | Callee::Method(_, pou) => self.result_type(pou),
                _ => None,
            },
            _ => None,
        }
    }

    /// Returns the element or variable of a name that can be reached in what an expression of a type names: all of the instance whose
    /// code is running.
    pub(super) fn member_of(&self, base: ExpressionId, ty: TypeId, name: &str) -> Option<&'m TypeMember> {
        let types = &self.model.types;
        match self.own_instance_of(base) {
            Some(_) => types.member(ty, name),
            None => types
                .element(ty, name)
                .or_else(|| self.readable_local(base, ty, name)),
        }
    }

    /// Returns the variable of a function block or program that may be read from outside, and not written, in some dialects.
    pub(super) fn readable_local(
        &self,
        base: ExpressionId,
        ty: TypeId,
        name: &str,
    ) -> Option<&'m TypeMember> {
        let types = &self.model.types;
        let member = types
            .member(ty, name)
            .filter(|_| self.model.source.dialect.locals_readable)?;
        // The type of a program is a structure.
        let is_own = types.element(ty, name).is_none()
            || matches!(self.expression(base).kind, ExpressionKind::Name(name) if self.called_program(name).is_some());
        (is_own && member.kind == VariableKind::Local).then_some(member)
    }

    /// Returns whether only the code of a function block or program may write a variable of it: an output, or one that others read.
    ///
    /// Basis: iec-61131-3: 2.5.2.1, Table 32 of the second edition; rusty-tests: src/validation/tests/variable_validation_tests.rs (E037).
    pub(super) fn is_closed(&mut self, base: ExpressionId, name: &str) -> bool {
        let Some(ty) = self.known_type(base) else {
            return false;
        };
        let is_writable = self.model.source.dialect.locals_writable;
        let local = self.readable_local(base, ty, name).filter(|_| !is_writable);
        let member = self.model.types.member(ty, name);
        let closed = local.or(member.filter(|member| member.kind == VariableKind::Output));
        closed.is_some_and(|member| !member.constant) && self.own_instance_of(base).is_none()
    }

    /// Returns the type of an expression that has one by itself.
    pub(super) fn known_type(&mut self, id: ExpressionId) -> Option<TypeId> {
        match self.infer(id) {
            Inferred::Known(ty) => Some(ty),
            _ => None,
        }
    }
}
