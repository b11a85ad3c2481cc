//! Resolves declared types and function blocks, each after those that it contains; what contains itself is
//! diagnosed.
//!
//! Basis: ironplc-problem-codes: P2010 (types), P4005 (function blocks).

use super::cycles::{WalkEvent, walk};
use super::declare::{DeclaredNode, Declarer, TypeNode};
use super::model::{DefaultInitialValue, Model, TopLevelName};
use super::types::{DefaultValue, TypeId, TypeKind};
use rustc_hash::FxHashSet;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    ExpressionKind, Initializer, InitializerKind, Name, TypeDeclaration, TypeSpecification,
    TypeSpecificationKind, VariableKind,
};
use stickler_types::Code;

impl<'u> Declarer<'u, '_> {
    /// Resolves every node of the order.
    pub(super) fn resolve_types(&mut self) {
        let mut order = Vec::with_capacity(self.nodes.len());
        let mut cycles = Vec::new();
        walk(
            self.nodes.len(),
            |node| needs(&self.model, self.nodes[node].declared),
            |event| match event {
                WalkEvent::Done(node) => order.push(node),
                WalkEvent::Cycle { note, members } => cycles.push((note, members)),
            },
        );
        for (span, members) in cycles {
            self.report_cycle(span, &members);
        }
        for node in order {
            let id = match self.nodes[node].declared {
                DeclaredNode::Type(ty) => self.declared_type(ty),
                DeclaredNode::Block(pou) => {
                    self.declare_variables(pou);
                    self.model.pous[pou].ty
                }
            };
            self.nodes[node].id = Some(id);
        }
        self.resolve_pointers();
    }

    fn report_cycle(&mut self, span: Span, members: &[usize]) {
        let is_block = |node: &usize| matches!(self.nodes[*node].declared, DeclaredNode::Block(_));
        let code = if members.iter().any(is_block) {
            Code::RecursiveCycle
        } else {
            Code::RecursiveTypeCycle
        };
        let nodes = members.iter().map(|&node| &self.nodes[node]);
        let mut names: Vec<_> = nodes.map(|node| self.name_of(node)).collect();
        names.push(names[0]);
        let extends = |node: &usize| match self.nodes[*node].declared {
            DeclaredNode::Type(ty) => ty.extends.is_some(),
            DeclaredNode::Block(pou) => !self.model.pous[pou].pou.extends.is_empty(),
        };
        let message = match members.iter().any(extends) {
            true => format!(
                "a type cannot extend or contain itself: {}",
                names.join(" needs ")
            ),
            false => format!("a type cannot contain itself: {}", names.join(" contains ")),
        };
        self.report(code, span, message);
    }

    fn name_of(&self, node: &TypeNode<'u>) -> &'u str {
        match node.declared {
            DeclaredNode::Type(ty) => ty.name.text,
            DeclaredNode::Block(pou) => self.model.pous[pou].pou.name.text,
        }
    }

    fn declared_type(&mut self, ty: &'u TypeDeclaration<'u>) -> TypeId {
        let base = match (&ty.specification.kind, ty.extends) {
            (TypeSpecificationKind::Structure(groups), Some(base)) => {
                self.derived_structure(base, groups, ty.name.text, ty.specification.span)
            }
            _ => self.specification(&ty.specification, ty.name.text),
        };
        if base == TypeId::ERROR {
            // Its initial value would only be looked at in vain.
            return TypeId::ERROR;
        }
        let Some(initializer) = &ty.initializer else {
            return match ty.specification.kind {
                // The names of structures, unions and enumerations are their types' own.
                TypeSpecificationKind::Structure(_)
                | TypeSpecificationKind::Union(_)
                | TypeSpecificationKind::Enumeration { .. } => base,
                _ => {
                    let default = self.model.types.extent(base).default;
                    self.model.types.add_alias(base, ty.name.text, default)
                }
            };
        };
        if let Some(number) = self.enumerated_default(base, initializer) {
            let default = DefaultValue::Constant(number.cast_unsigned());
            return self.model.types.add_alias(base, ty.name.text, default);
        }
        let routine = self.routine();
        self.define_routine(routine, DefaultInitialValue::Declared(base, initializer));
        let default = DefaultValue::Routine(routine);
        self.model.types.add_alias(base, ty.name.text, default)
    }

    /// The number of the value that a declared enumeration begins with, where it is plainly one of its own.
    fn enumerated_default(&self, ty: TypeId, initializer: &Initializer<'u>) -> Option<i64> {
        let TypeKind::Enumeration(enumeration) = self.model.types.kind(ty) else {
            return None;
        };
        let InitializerKind::Expression(id) = initializer.kind else {
            return None;
        };
        match self.model.source.expression(id).kind {
            ExpressionKind::Name(name) => enumeration.values.find(name.text).copied(),
            _ => None,
        }
    }
}

/// The nodes that a node contains, each once, with the place where it says so.
fn needs(model: &Model<'_>, declared: DeclaredNode<'_>) -> Vec<(usize, Span)> {
    let mut needs = Needs {
        model,
        found: Vec::new(),
        seen: FxHashSet::default(),
    };
    match declared {
        DeclaredNode::Type(ty) => {
            ty.extends.iter().for_each(|base| needs.name(*base));
            needs.specification(&ty.specification);
        }
        DeclaredNode::Block(pou) => {
            let pou = model.pous[pou].pou;
            let bases = pou.extends.iter().chain(&pou.implements);
            bases.for_each(|base| needs.name(*base));
            let instance = pou.members.iter().flat_map(|member| &member.blocks);
            let instance = instance.filter(|block| block.kind == VariableKind::Instance);
            let held = pou.blocks.iter().chain(instance);
            let held = held.filter(|block| block.kind.is_held());
            held.flat_map(|block| &block.groups)
                .for_each(|group| needs.specification(&group.specification));
        }
    }
    needs.found
}

struct Needs<'a, 'u> {
    model: &'a Model<'u>,
    found: Vec<(usize, Span)>,
    seen: FxHashSet<usize>,
}

impl Needs<'_, '_> {
    fn specification(&mut self, specification: &TypeSpecification<'_>) {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.name(*name),
            TypeSpecificationKind::Subrange { base, .. } => self.name(*base),
            TypeSpecificationKind::Array { element, .. } => self.specification(element),
            TypeSpecificationKind::Structure(groups) | TypeSpecificationKind::Union(groups) => {
                let specifications = groups.iter().map(|group| &group.specification);
                specifications.for_each(|specification| self.specification(specification));
            }
            // What leads to a value does not contain it.
            TypeSpecificationKind::Pointer { .. }
            | TypeSpecificationKind::VariableLengthArray { .. }
            | TypeSpecificationKind::Text { .. }
            | TypeSpecificationKind::Enumeration { .. }
            | TypeSpecificationKind::Error => {}
        }
    }

    fn name(&mut self, name: Name<'_>) {
        let node = match self.model.definition(name) {
            Some(TopLevelName::Type(node)) => node as usize,
            Some(TopLevelName::Pou(pou)) => match self.model.pous[pou as usize].node {
                Some(node) => node,
                None => return,
            },
            None => return,
        };
        if self.seen.insert(node) {
            self.found.push((node, name.span));
        }
    }
}
