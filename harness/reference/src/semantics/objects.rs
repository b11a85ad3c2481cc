//! Declares what object orientation adds to a model: which POU extends and implements which, the methods and properties of each, and
//! the types of interfaces.
//!
//! The variables of a derived block lie behind those of its base. The first cell of a block that has methods, or takes part in
//! inheritance, holds the number of its type, by which the running program finds the method that is meant.
//!
//! Basis: iec-61131-3: third edition, 6.6.5 to 6.6.8.

use super::declare::Declarer;
use super::model::TopLevelName;
use super::scope::NamedList;
use super::types::{Extent, MAX_ANCESTORS, Structure, TypeId, TypeKind};
use stickler_syntax::source::{Span, saturating_u32};
use stickler_syntax::tree::{CaseFolded, Name, PouKind, TypeSpecification, VariableKind};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Collects the methods and properties of a POU.
    pub(super) fn collect_members(&mut self, owner: usize) {
        let pou = self.model.pous[owner].pou;
        self.model.has_members |= !pou.members.is_empty();
        for part in &pou.members {
            let index = self.add_pou(part, None, Some(saturating_u32(owner)));
            let member = self.model.pous[owner]
                .members
                .entry(CaseFolded(part.name.text))
                .or_default();
            let before = *member;
            let place = match part.kind {
                PouKind::Getter => &mut member.getter,
                PouKind::Setter => &mut member.setter,
                _ => &mut member.method,
            };
            let is_method = part.kind == PouKind::Method;
            let is_other = before.method.is_some() || is_method && before.parts().iter().any(Option::is_some);
            if place.replace(index).is_some() || is_other {
                *member = before;
                let message = format!("`{}` is already declared in `{}`", part.name.text, pou.name.text);
                self.report(Code::SymbolDeclDuplicated, part.name.span, message);
            }
        }
    }

    /// Finds the blocks whose instances hold the number of their type.
    pub(super) fn number_types(&mut self) {
        for index in 0..self.model.pous.len() {
            let pou = self.model.pous[index].pou;
            for base in &pou.extends {
                if let Some(TopLevelName::Pou(base)) = self.model.definition(*base) {
                    self.model.pous[base as usize].has_type_number = true;
                }
            }
            self.model.pous[index].has_type_number |= pou.is_object();
        }
        for entry in &mut self.model.pous {
            entry.has_type_number &= matches!(entry.pou.kind, PouKind::FunctionBlock | PouKind::Class);
        }
    }

    /// Finds what a POU extends and implements. All of it has been resolved before, but for what would be a cycle.
    pub(super) fn resolve_bases(&mut self, index: usize) {
        let pou = self.model.pous[index].pou;
        let mut ancestors = 0_u32;
        for (names, is_base) in [(&pou.extends, true), (&pou.implements, false)] {
            for (number, name) in names.iter().enumerate() {
                let Some(other) = self.ancestor(pou.kind, *name, is_base) else {
                    continue;
                };
                ancestors = ancestors.saturating_add(1 + self.model.pous[other as usize].ancestors);
                let entry = &mut self.model.pous[index];
                if pou.kind == PouKind::Interface || !is_base {
                    entry.interfaces.push(other);
                } else if number == 0 {
                    entry.base = Some(other);
                } else {
                    let message = "a function block or class extends one other only";
                    self.report(Code::InheritanceInvalid, name.span, message);
                }
            }
        }
        if ancestors > MAX_ANCESTORS {
            let message = format!("more than {MAX_ANCESTORS} types are extended and implemented here");
            self.report(Code::LimitExceeded, pou.name.span, message);
            let entry = &mut self.model.pous[index];
            (entry.base, ancestors) = (None, 0);
            entry.interfaces.clear();
        }
        self.model.pous[index].ancestors = ancestors;
    }

    /// Returns the POU that stands behind EXTENDS (`is_base`) or IMPLEMENTS of a POU of some kind.
    fn ancestor(&mut self, of: PouKind, name: Name<'u>, is_base: bool) -> Option<u32> {
        let found = match self.model.definition(name) {
            Some(TopLevelName::Pou(found)) => Some(found),
            Some(TopLevelName::Type(_)) => None,
            None => {
                let message = format!("type `{}` is not declared", name.text);
                self.report(Code::UndeclaredUnknownType, name.span, message);
                return None;
            }
        };
        let kind = found.map(|found| self.model.pous[found as usize].pou.kind);
        let fits = match (of, is_base) {
            (PouKind::FunctionBlock, true) => matches!(kind, Some(PouKind::FunctionBlock | PouKind::Class)),
            (PouKind::Class, true) => kind == Some(PouKind::Class),
            (PouKind::Interface, true) | (PouKind::FunctionBlock | PouKind::Class, false) => {
                kind == Some(PouKind::Interface)
            }
            _ => false,
        };
        let found = found.filter(|_| fits);
        let is_final = found.is_some_and(|found| self.model.pous[found as usize].pou.modifiers.is_final);
        if found.is_none() || is_final {
            let verb = if is_base { "extended" } else { "implemented" };
            let reason = ["is of a kind that", "is FINAL, and"][usize::from(is_final)];
            let message = format!("`{}` {reason} cannot be {verb} here", name.text);
            self.report(Code::InheritanceInvalid, name.span, message);
            return None;
        }
        // Of a cycle, which has been reported, one member is not resolved yet.
        found.filter(|&found| {
            let node = self.model.pous[found as usize].node;
            node.is_some_and(|node| self.nodes[node].id.is_some_and(|id| id != TypeId::ERROR))
        })
    }

    /// Declares the variables of VAR_INST of the methods, which are kept with those of the owner.
    pub(super) fn declare_instance_variables(&mut self, owner: usize) {
        let pou = self.model.pous[owner].pou;
        for (part, index) in pou.members.iter().zip(owner + 1..) {
            let blocks = part.blocks.iter();
            for block in blocks.filter(|block| block.kind == VariableKind::Instance) {
                for group in &block.groups {
                    self.declare_group(index, block, group);
                }
            }
        }
    }

    /// Returns the type of what a POU gives, or of what SET of a property takes.
    pub(super) fn result_specification(&self, index: usize) -> Option<&'u TypeSpecification<'u>> {
        let entry = &self.model.pous[index];
        let pou = entry.pou;
        if let (PouKind::Setter, None, Some(owner)) = (pou.kind, &pou.result, entry.owner) {
            let property = self.model.pous[owner as usize]
                .members
                .get(&CaseFolded(pou.name.text))?;
            return self.model.pous[property.getter? as usize].pou.result.as_ref();
        }
        pou.result.as_ref()
    }

    /// Gives an interface its type.
    pub(super) fn make_interface_type(&mut self, index: usize) {
        let interface = Structure {
            name: self.model.pous[index].pou.name.text.into(),
            pou: saturating_u32(index),
            base: None,
            is_union: false,
            members: NamedList::new(),
        };
        let kind = TypeKind::Interface(Box::new(interface));
        let extent = Extent {
            has_interface: true,
            ..Extent::PLAIN
        };
        self.model.pous[index].ty = self.model.types.add(kind, extent);
        self.note_parents(index);
    }

    /// Notes what the type of a POU extends and implements.
    pub(super) fn note_parents(&mut self, index: usize) {
        let entry = &self.model.pous[index];
        let parents = entry.interfaces.iter().chain(&entry.base);
        let parents: Vec<TypeId> = parents.map(|&other| self.model.pous[other as usize].ty).collect();
        if !parents.is_empty() {
            let ty = self.model.pous[index].ty;
            self.model.types.parents.insert(ty, parents);
        }
    }

    /// Returns whether a POU inherits a variable of this name.
    pub(super) fn is_inherited(&self, pou: usize, name: Name<'u>) -> bool {
        let base = self.model.pous[pou].base;
        let ty = base.map(|base| self.model.pous[base as usize].ty);
        ty.is_some_and(|ty| self.model.types.member(ty, name.text).is_some())
    }

    /// Reports variables or fields of a type whose values consist of instances of an ABSTRACT block.
    pub(super) fn refuse_abstract(&mut self, ty: TypeId, span: Span) {
        if self.is_abstract(ty) {
            let message = "an ABSTRACT function block has no instances";
            self.report(Code::AbstractFunctionBlockInstantiated, span, message);
        }
    }

    fn is_abstract(&self, ty: TypeId) -> bool {
        match self.model.types.kind(ty) {
            TypeKind::Array(shape) => self.is_abstract(shape.element),
            TypeKind::FunctionBlock(block) => self.model.pous[block.pou as usize].pou.modifiers.is_abstract,
            _ => false,
        }
    }
}
