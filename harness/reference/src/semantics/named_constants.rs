//! The meanings of the names of declared constants in constant expressions.

use super::constant::{Constant, ConstantValue};
use super::declare::{DeclaredNode, Declarer};
use super::emitter::MAX_SHORT_TEXT;
use super::lowering::Lowering;
use super::memory::MemoryLayout;
use super::model::TopLevelName;
use super::types::{TypeId, TypeKind};
use stickler_syntax::source::saturating_u32;
use stickler_syntax::tree::{
    ExpressionId, InitializerKind, Name, TypeSpecification, TypeSpecificationKind, VariableGroup,
};
use stickler_types::ElementaryType;

/// The type of a constant, as far as it matters to its value.
#[derive(Clone, Copy)]
pub(super) enum ConstantType {
    /// An elementary type; a text takes so many code units.
    Elementary(ElementaryType, u32),
    /// A type whose constants have no elementary value.
    Other,
    /// A wrong type, which is reported elsewhere.
    Unknown,
}

impl<'u> Declarer<'u, '_> {
    /// Returns what a constant of a resolved type means.
    pub(super) fn local_constant(&mut self, group: &'u VariableGroup<'u>, ty: TypeId) -> Constant {
        let ty = match *self.model.types.kind(ty) {
            TypeKind::Elementary(ty) => ConstantType::Elementary(ty, 0),
            TypeKind::Text { ty, capacity } => ConstantType::Elementary(ty, capacity),
            TypeKind::Subrange(limits) => ConstantType::Elementary(limits.base, 0),
            TypeKind::Error => ConstantType::Unknown,
            _ => ConstantType::Other,
        };
        self.constant_of_type(group, ty)
    }

    pub(super) fn constant_of_type(&mut self, group: &'u VariableGroup<'u>, ty: ConstantType) -> Constant {
        let Some(initializer) = &group.initializer else {
            let silent = self.says_initial_value(group);
            return if silent {
                Constant::Silent
            } else {
                Constant::Missing
            };
        };
        let (ty, capacity, id) = match (ty, &initializer.kind) {
            (ConstantType::Unknown, _) => return Constant::Silent,
            (ConstantType::Elementary(ty, capacity), &InitializerKind::Expression(id)) => (ty, capacity, id),
            _ => return Constant::Computed,
        };
        // What is wrong with it is reported as it is lowered once more, where it is stored.
        let muted = self.reporter.mute(true);
        let constant = self.lowering(|lowering| lowering.constant_initializer(id, ty));
        self.reporter.mute(muted);
        match constant {
            Constant::Known(value) => match value.cut(capacity) {
                ConstantValue::Text(_, units) if units.len() > MAX_SHORT_TEXT => Constant::Computed,
                value => Constant::Known(value),
            },
            // Whatever its value is, it is no integer.
            _ if !ty.is_integer() => Constant::Computed,
            constant => constant,
        }
    }

    /// Returns the number that an expression stands for; where it stands for none, reports why.
    pub(super) fn constant(&mut self, id: ExpressionId) -> Option<i128> {
        self.lowering(|lowering| lowering.constant_number(id))
    }

    /// Lowers with what is declared so far. No code is left of it.
    fn lowering<T>(&mut self, lower: impl FnOnce(&mut Lowering<'_>) -> T) -> T {
        let mut lowering = Lowering::new(&self.model, MemoryLayout::default(), self.reporter);
        lowering.pou = self.current.map(saturating_u32);
        lowering.guesses = self.guesses;
        lowering.inferred = std::mem::take(&mut self.inferred);
        let answer = lower(&mut lowering);
        (self.inferred, self.guesses) = (lowering.inferred, lowering.guesses);
        answer
    }

    /// Returns what a written type comes down to, also before types are resolved.
    pub(super) fn written(&mut self, specification: &'u TypeSpecification<'u>) -> ConstantType {
        /// No chain of names is longer than types may nest; one that is goes in a circle.
        const MAX_CHAIN: u32 = 200;
        let mut kind = &specification.kind;
        for _ in 0..MAX_CHAIN {
            let name = match kind {
                TypeSpecificationKind::Named(name) | TypeSpecificationKind::Subrange { base: name, .. } => {
                    name.unqualified()
                }
                TypeSpecificationKind::Text { name, length } => return self.written_text(*name, *length),
                TypeSpecificationKind::Error => return ConstantType::Unknown,
                _ => return ConstantType::Other,
            };
            let dialect = self.model.source.dialect;
            let elementary = dialect.elementary(name.text);
            let named = match self.model.definition(name) {
                _ if elementary.is_some_and(|ty| !ty.is_third_edition() && dialect.may_name(ty)) => None,
                Some(TopLevelName::Type(node)) => Some(self.nodes[node as usize].declared),
                Some(TopLevelName::Pou(_)) => return ConstantType::Other,
                None => None,
            };
            match (named, elementary) {
                (Some(DeclaredNode::Type(declared)), _) => kind = &declared.specification.kind,
                (Some(DeclaredNode::Block(_)), _) => return ConstantType::Other,
                (None, Some(ty)) if dialect.may_name(ty) => {
                    return ConstantType::Elementary(ty, dialect.text_length);
                }
                (None, _) => return ConstantType::Unknown,
            }
        }
        ConstantType::Unknown
    }

    fn written_text(&mut self, name: Name<'u>, length: ExpressionId) -> ConstantType {
        let ty = ElementaryType::from_name(name.text).filter(|ty| ty.is_text());
        let muted = self.reporter.mute(true);
        let length = self.constant(length);
        self.reporter.mute(muted);
        match (ty, length.and_then(|length| u32::try_from(length).ok())) {
            (Some(ty), Some(capacity)) => ConstantType::Elementary(ty, capacity),
            _ => ConstantType::Unknown,
        }
    }
}
