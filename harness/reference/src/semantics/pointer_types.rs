//! Reference and pointer types: their targets, which may be declared later, and what goes with them.
//!
//! Basis: iec-61131-3: Table 12 of the third edition; codesys-pages: _cds_datatype_pointer; codesys-pages: _cds_datatype_reference;
//! ironplc-problem-codes: P2028 to P2036.

use super::declare::Declarer;
use super::types::{Extent, PointerType, TypeId, TypeKind, TypeTable};
use crate::conversion::implicit;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{PointerForm, TypeSpecification};
use stickler_types::{Code, Dialect, ElementaryType};

/// A reference or pointer type whose target is not resolved.
pub(super) struct PendingPointer<'u> {
    ty: TypeId,
    target: &'u TypeSpecification<'u>,
    hint: &'u str,
    pou: Option<usize>,
}

impl<'u> Declarer<'u, '_> {
    /// Adds the type of `REF_TO target`, `POINTER TO target` or `REFERENCE TO target`.
    pub(super) fn pointer_type(
        &mut self,
        form: PointerForm,
        target: &'u TypeSpecification<'u>,
        hint: &'u str,
    ) -> TypeId {
        let form = match form {
            PointerForm::RefTo if self.model.source.dialect.references_are_pointers => PointerForm::PointerTo,
            form => form,
        };
        let kind = TypeKind::Pointer(PointerType {
            form,
            target: TypeId::ERROR,
        });
        let ty = self.model.types.add(kind, Extent::PLAIN);
        let pou = self.current;
        let pending = PendingPointer {
            ty,
            target,
            hint,
            pou,
        };
        match &mut self.pointers {
            Some(pointers) => pointers.push(pending),
            None => self.resolve_pointer(&pending),
        }
        ty
    }

    /// Resolves the targets of all types so far.
    pub(super) fn resolve_pointers(&mut self) {
        for pending in self.pointers.take().unwrap_or_default() {
            self.current = pending.pou;
            self.resolve_pointer(&pending);
        }
        self.current = None;
    }

    fn resolve_pointer(&mut self, pending: &PendingPointer<'u>) {
        let target = self.specification(pending.target, pending.hint);
        self.model.types.set_target(pending.ty, target);
        self.check_nested(target, pending.target.span);
    }

    /// Reports a reference as the element of an array or the target of a pointer, where the dialect has none such.
    pub(super) fn check_nested(&mut self, inner: TypeId, span: Span) {
        let of_reference = self.model.types.pointer(inner);
        if of_reference.is_some_and(|inner| inner.form != PointerForm::PointerTo)
            && self.model.source.dialect.lacks("reference-nested")
        {
            let message = "the dialect has no references to references, nor arrays of them";
            self.report(Code::NestedRefToNotSupported, span, message);
        }
    }
}

/// Returns whether addresses are numbers, so that a pointer of any type leads anywhere.
pub(super) fn addresses_are_numbers(dialect: &Dialect) -> bool {
    !dialect.lacks("pointer-arithmetic")
}

/// Returns whether a value of one type may stand where another is expected, at least one of which is a reference or pointer.
pub(super) fn fits_pointer(from: TypeId, to: TypeId, types: &TypeTable, dialect: &Dialect) -> bool {
    let is_free = addresses_are_numbers(dialect);
    match (types.pointer(from), types.pointer(to)) {
        (Some(_), Some(_)) => {
            from == TypeId::ADDRESS || to == TypeId::ADDRESS || is_free || types.is_same(from, to)
        }
        (Some(_), None) => {
            let converts = |to| implicit(ElementaryType::Lword, to, dialect).is_some();
            is_free && to.elementary().is_some_and(converts)
        }
        (None, _) => is_free && from.elementary().is_some_and(ElementaryType::is_whole),
    }
}
