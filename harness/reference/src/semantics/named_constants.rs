//! What the names of declared constants mean in constant expressions.

use super::constants::Constant;
use super::contexts::Context;
use super::declare::{Declared, Declarer};
use super::emitter::SHORT_TEXT;
use super::folding::Known;
use super::model::Definition;
use super::types::{DEFAULT_CAPACITY, TypeId};
use crate::syntax::tree::{
    ExpressionId, Folded, Initializer, InitializerKind, Name, TypeSpecification, TypeSpecificationKind,
    VariableGroup,
};
use stickler_types::{Code, ElementaryType};

/// What a written type comes down to.
enum Written {
    /// An elementary type; a text takes so many code units.
    Elementary(ElementaryType, u32),
    /// Something else.
    Other,
    /// Something that is wrong.
    Unknown,
}

impl<'u> Declarer<'u, '_> {
    /// What an initial value stands for, as far as it is known before types are.
    pub(super) fn exact_initializer(
        &self,
        group: &'u VariableGroup<'u>,
        initializer: &'u Initializer<'u>,
    ) -> Constant {
        let InitializerKind::Expression(id) = initializer.kind else {
            return Constant::NotInteger;
        };
        match self.written(&group.specification) {
            Written::Elementary(ty, _) if ty.is_integer() => self.exact_number(id, ty),
            Written::Elementary(ty, capacity) => {
                match self.evaluating(|evaluator| evaluator.operand(id, ty, Context::Initializer)) {
                    Ok(known) => match known.cut(capacity) {
                        Known::Text(_, units) if units.len() > SHORT_TEXT => Constant::NotInteger,
                        known => Constant::Typed(known),
                    },
                    // Lowering says what is wrong with it, if anything is.
                    Err(_) => Constant::NotInteger,
                }
            }
            Written::Other => Constant::NotInteger,
            Written::Unknown => Constant::Silent,
        }
    }

    /// The number that an initial value stands for. Where a function is called in it types count: the program
    /// computes in them, and what does not fit wraps there, which is no error.
    fn exact_number(&self, id: ExpressionId, ty: ElementaryType) -> Constant {
        let typed = self.evaluating(|evaluator| evaluator.calls(id));
        let found = if typed {
            let known = self.evaluating(|evaluator| evaluator.operand(id, ty, Context::Initializer));
            known.and_then(|known| known.number().ok_or(None))
        } else {
            self.evaluate(id)
        };
        let holds = |number: &i128| {
            ty.integer_range()
                .is_some_and(|(low, high)| (low..=high).contains(number))
        };
        match found {
            Ok(number) if holds(&number) => Constant::Value(number, ty),
            // This may well be an initial value, if not one that is known here.
            Err(Some(reason)) if reason.code == Code::VariableMustBeConst => Constant::NotInteger,
            Err(Some(reason)) if typed && is_left_to_the_machine(reason.code) => Constant::NotInteger,
            // Lowering says what is wrong with it.
            _ => Constant::Silent,
        }
    }

    /// What the name of a constant means in a constant expression.
    pub(super) fn constant_value(&self, group: &'u VariableGroup<'u>, ty: TypeId) -> Constant {
        let Some(initializer) = &group.initializer else {
            let silent = self.says_initial_value(group);
            return if silent {
                Constant::Silent
            } else {
                Constant::Missing
            };
        };
        match self.exact_initializer(group, initializer) {
            _ if ty == TypeId::ERROR => Constant::Silent,
            value => value,
        }
    }

    /// What a written type comes down to, also before types are resolved.
    fn written(&self, specification: &TypeSpecification<'u>) -> Written {
        /// No chain of names is longer than types may nest; one that is goes in a circle.
        const LONGEST_CHAIN: u32 = 200;
        let mut kind = &specification.kind;
        for _ in 0..LONGEST_CHAIN {
            let name = match kind {
                TypeSpecificationKind::Named(name) | TypeSpecificationKind::Subrange { base: name, .. } => {
                    *name
                }
                TypeSpecificationKind::Text { name, length } => return self.written_text(*name, *length),
                TypeSpecificationKind::Error => return Written::Unknown,
                _ => return Written::Other,
            };
            let elementary = ElementaryType::from_name(name.text);
            let named = match self.model.definitions.get(&Folded(name.text)) {
                _ if elementary.is_some_and(|ty| !ty.is_third_edition()) => None,
                Some(&Definition::Type(node)) => Some(self.nodes[node as usize].declared),
                Some(Definition::Pou(_)) => return Written::Other,
                None => None,
            };
            match (named, elementary) {
                (Some(Declared::Type(declared)), _) => kind = &declared.specification.kind,
                (Some(Declared::Block(_)), _) => return Written::Other,
                (None, Some(ty)) if self.model.source.dialect.has(ty) => {
                    return Written::Elementary(ty, DEFAULT_CAPACITY);
                }
                (None, _) => return Written::Unknown,
            }
        }
        Written::Unknown
    }

    fn written_text(&self, name: Name<'u>, length: ExpressionId) -> Written {
        let ty = ElementaryType::from_name(name.text).filter(|ty| ty.is_text());
        let capacity = self
            .evaluate(length)
            .ok()
            .and_then(|length| u32::try_from(length).ok());
        match (ty, capacity) {
            (Some(ty), Some(capacity)) => Written::Elementary(ty, capacity),
            _ => Written::Unknown,
        }
    }
}

/// Whether an operation on constants whose types count, with this to be said of it, is done by the machine as it is
/// done with variables.
const fn is_left_to_the_machine(code: Code) -> bool {
    matches!(
        code,
        Code::ConstantExpressionOverflow | Code::ConstantExpressionDivisionByZero
    )
}
