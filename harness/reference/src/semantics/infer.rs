//! Infers types, silently: what is wrong infers to [`Inferred::Error`], and is reported when it is lowered.

use super::constant::Constant;
use super::inferred::Inferred;
use super::lowering::Lowering;
use super::model::{EnumeratedName, TopLevelName};
use super::operators::OperatorSignature;
use super::promotion::prefixed;
use super::types::{TypeId, TypeKind};
use stickler_syntax::tree::{CaseFolded, ExpressionId, ExpressionKind, Name, UnaryOperator};
use stickler_types::dialect::{OperandTypes, ResultSigns};
use stickler_types::{Dialect, ElementaryType};

impl<'m> Lowering<'m> {
    /// Infers the type of an expression by itself. The left spine of a chain of operators is walked without
    /// recursion.
    pub(super) fn infer(&mut self, id: ExpressionId) -> Inferred {
        let mut spine = Vec::new();
        let mut at = id;
        loop {
            let known = self.inferred[at.0 as usize];
            if known != Inferred::Pending {
                break;
            }
            let Some((operator, left, right)) = self.expression(at).binary() else {
                let inferred = self.infer_leaf(at);
                self.inferred[at.0 as usize] = inferred;
                break;
            };
            spine.push((at, operator, left, right));
            at = left;
        }
        for (node, operator, left, right) in spine.into_iter().rev() {
            let right = self.infer(right);
            let left = self.inferred[left.0 as usize];
            self.inferred[node.0 as usize] = match self.rules().signature(operator, left, right) {
                OperatorSignature::Defined(operation) => Inferred::Known(operation.result),
                OperatorSignature::Untyped(inferred) => inferred,
                OperatorSignature::Undefined | OperatorSignature::Silent => Inferred::Error,
            };
        }
        self.inferred[id.0 as usize]
    }

    fn infer_leaf(&mut self, id: ExpressionId) -> Inferred {
        match &self.expression(id).kind {
            ExpressionKind::Literal(literal) => self.infer_literal(literal, false),
            ExpressionKind::Name(name) => self.infer_name(id, *name),
            ExpressionKind::EnumeratedValue(word) => self.infer_enumerated(word.prefix(), word.value()),
            ExpressionKind::Field { .. }
            | ExpressionKind::Index { .. }
            | ExpressionKind::Dereference { .. } => match self.declared_type_of(id) {
                Some(ty) => self.inferred_of(ty),
                None => self.infer_property(id),
            },
            ExpressionKind::Bit { base, .. } => self.infer_part(*base, ElementaryType::Bool),
            ExpressionKind::Part { base, part, .. } => self.infer_part(*base, *part),
            ExpressionKind::Call { callee, arguments } => self.infer_call(*callee, arguments),
            ExpressionKind::Unary { operator, operand } => self.infer_unary(*operator, *operand),
            ExpressionKind::Parenthesized(inner) | ExpressionKind::Assigned { target: inner, .. } => {
                self.infer(*inner)
            }
            ExpressionKind::Aggregate(_) => Inferred::Nothing,
            ExpressionKind::Binary { .. } | ExpressionKind::Error => Inferred::Error,
        }
    }

    /// Returns the type of a value of a declared type.
    pub(super) fn inferred_of(&self, declared: TypeId) -> Inferred {
        let types = &self.model.types;
        match types.value_type(types.named_type(declared)) {
            TypeId::ERROR => Inferred::Error,
            ty => Inferred::Known(ty),
        }
    }

    fn infer_name(&mut self, id: ExpressionId, name: Name<'m>) -> Inferred {
        if let Some((_, variable)) = self.variable(name.text) {
            return match &variable.value {
                Constant::Known(value) => Inferred::from(value.ty()),
                _ => self.inferred_of(variable.ty),
            };
        }
        match self.enumerated_name(name.text) {
            Some(EnumeratedName::One(ty, _)) => Inferred::Known(ty),
            Some(EnumeratedName::Several) => Inferred::Enumerated,
            None if self.is_null(name.text) => Inferred::Known(TypeId::ADDRESS),
            None => match self.own_instance_of(id) {
                Some(own) => self.inferred_of(self.model.pous[own.pou as usize].ty),
                None => match self.called_program(name) {
                    Some(program) => self.inferred_of(program.ty),
                    None => self.infer_property(id),
                },
            },
        }
    }

    /// Finds the enumerated value of a name: one that is declared with a variable of the POU, or else of a type.
    pub(super) fn enumerated_name(&self, name: &str) -> Option<EnumeratedName> {
        let entry = self.entry();
        let owner = entry.and_then(|entry| entry.owner);
        let owner = owner.map(|owner| &self.model.pous[owner as usize]);
        let mut scopes = entry.into_iter().chain(owner);
        let local = scopes.find_map(|entry| entry.enumerated.get(&CaseFolded(name)));
        let found = local.or_else(|| self.model.enumerated.get(&CaseFolded(name)));
        found.copied()
    }

    /// Returns the type that a name declares; of the third edition's, the one that the text declares wins.
    pub(super) fn declared_type(&self, name: Name<'_>) -> Option<TypeId> {
        match self.model.definition(name) {
            Some(TopLevelName::Type(index)) => self.model.declared_types.get(index as usize).copied(),
            _ => None,
        }
    }

    fn infer_enumerated(&self, type_name: Name<'m>, value: Name<'m>) -> Inferred {
        let ty = self.declared_type(type_name).unwrap_or(TypeId::ERROR);
        match self.model.types.kind(ty) {
            TypeKind::Enumeration(enumeration) if enumeration.values.find(value.text).is_some() => {
                self.inferred_of(ty)
            }
            _ => Inferred::Error,
        }
    }

    fn infer_part(&mut self, base: ExpressionId, part: ElementaryType) -> Inferred {
        match self.infer(base).elementary() {
            Some(ty) if ty.is_whole() => Inferred::from(part),
            _ => Inferred::Error,
        }
    }

    pub(super) fn infer_unary(&mut self, operator: UnaryOperator, operand: ExpressionId) -> Inferred {
        if operator == UnaryOperator::Negate
            && let ExpressionKind::Literal(literal) = &self.expression(operand).kind
            && literal.prefix().is_none()
        {
            let inferred = self.infer_literal(literal, true);
            if inferred.is_untyped_number() {
                return inferred;
            }
        }
        let inferred = self.infer(operand);
        let dialect = self.model.source.dialect;
        match inferred.elementary() {
            _ if !defined(operator, inferred, dialect) => Inferred::Error,
            Some(ty) => Inferred::from(prefixed(operator, ty, dialect)),
            None => inferred,
        }
    }
}

/// Returns whether a prefix operator is defined for its operand. An untyped operand is looked at again once it has a
/// type.
pub(super) fn defined(operator: UnaryOperator, operand: Inferred, dialect: &Dialect) -> bool {
    match operand {
        Inferred::Known(ty) => (ty.elementary()).is_some_and(|ty| defined_for(operator, ty, dialect)),
        Inferred::Integer(_) => true,
        Inferred::Real => operator != UnaryOperator::Not,
        _ => false,
    }
}

/// Returns whether a prefix operator is defined for a type.
pub(super) fn defined_for(operator: UnaryOperator, ty: ElementaryType, dialect: &Dialect) -> bool {
    match operator {
        UnaryOperator::Not if dialect.operands == OperandTypes::Promoted && ty.is_integer() => true,
        UnaryOperator::Negate if dialect.result_signs == ResultSigns::OfOperator && ty.is_bit_string() => {
            true
        }
        UnaryOperator::Not => ty == ElementaryType::Bool || ty.is_bit_string(),
        UnaryOperator::Negate if ty.is_duration() => dialect.negates_durations,
        UnaryOperator::Negate | UnaryOperator::Plus => ty.is_number() || ty.is_duration(),
    }
}
