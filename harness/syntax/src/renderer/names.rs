//! Spells names as the declarations of a text do, found without checking types: enough is known of the shape of
//! variables to spell fields too.

use crate::tree::{
    CaseFolded, Declaration, Pou, SourceUnit, TypeSpecification, TypeSpecificationKind, VariableBlock,
    VariableGroup,
};
use rustc_hash::FxHashMap;

/// The knowledge of the type of a name or of an expression.
#[derive(Clone, Copy, Default)]
pub(super) enum NameShape<'u, 's> {
    /// A name that is not declared.
    #[default]
    Unknown,
    /// A variable; holds its type.
    Typed(&'u TypeSpecification<'s>),
    /// A POU, or a variable that is an instance of one.
    Pou(&'u Pou<'s>),
}

/// A declaration: its spelling, and what is declared.
type NameEntry<'u, 's> = (&'s str, NameShape<'u, 's>);

/// The most aliases that are followed; a cycle of them is no type.
const MAX_ALIASES: usize = 64;

/// The declarations of a text.
#[derive(Default)]
pub(super) struct Names<'u, 's> {
    types: FxHashMap<CaseFolded<'s>, NameEntry<'u, 's>>,
    pous: FxHashMap<CaseFolded<'s>, NameEntry<'u, 's>>,
    globals: FxHashMap<CaseFolded<'s>, NameEntry<'u, 's>>,
    values: FxHashMap<CaseFolded<'s>, &'s str>,
    /// The variables of a POU or the fields of a structure, by the place of the POU or the structure.
    members: FxHashMap<(u32, CaseFolded<'s>), NameEntry<'u, 's>>,
}

impl<'u, 's> Names<'u, 's> {
    pub(super) fn new(unit: &'u SourceUnit<'s>) -> Names<'u, 's> {
        let mut names = Names::default();
        for declaration in &unit.declarations {
            match declaration {
                Declaration::Pou(pou) => names.declare_pou(pou),
                Declaration::Types(types) => {
                    for declared in types {
                        let name = declared.name.text;
                        names.types.insert(
                            CaseFolded(name),
                            (name, NameShape::Typed(&declared.specification)),
                        );
                        names.declare_parts(&declared.specification);
                    }
                }
                Declaration::Globals(block) => names.declare_globals(block),
                Declaration::Configuration(configuration) => {
                    configuration
                        .globals
                        .iter()
                        .for_each(|block| names.declare_globals(block));
                }
            }
        }
        names
    }

    fn declare_pou(&mut self, pou: &'u Pou<'s>) {
        self.pous
            .insert(CaseFolded(pou.name.text), (pou.name.text, NameShape::Pou(pou)));
        pou.blocks
            .iter()
            .for_each(|block| self.declare_members(pou.span.start, &block.groups));
    }

    fn declare_globals(&mut self, block: &'u VariableBlock<'s>) {
        for group in &block.groups {
            self.declare_parts(&group.specification);
            let shape = NameShape::Typed(&group.specification);
            self.globals.extend(
                group
                    .names
                    .iter()
                    .map(|name| (CaseFolded(name.text), (name.text, shape))),
            );
        }
    }

    fn declare_members(&mut self, place: u32, groups: &'u [VariableGroup<'s>]) {
        for group in groups {
            self.declare_parts(&group.specification);
            let shape = NameShape::Typed(&group.specification);
            self.members.extend(
                group
                    .names
                    .iter()
                    .map(|name| ((place, CaseFolded(name.text)), (name.text, shape))),
            );
        }
    }

    /// The enumerated values and the fields that a type written out in a declaration declares.
    fn declare_parts(&mut self, specification: &'u TypeSpecification<'s>) {
        match &specification.kind {
            TypeSpecificationKind::Enumeration { values, .. } => {
                self.values
                    .extend(values.iter().map(|(name, _)| (CaseFolded(name.text), name.text)));
            }
            TypeSpecificationKind::Structure(fields) => {
                self.declare_members(specification.span.start, fields)
            }
            TypeSpecificationKind::Array { element, .. } => self.declare_parts(element),
            TypeSpecificationKind::Pointer { target, .. } => self.declare_parts(target),
            _ => {}
        }
    }

    /// A name that stands alone in the POU at `pou`.
    pub(super) fn variable(&self, pou: Option<u32>, name: &'s str) -> NameEntry<'u, 's> {
        let local = pou.and_then(|pou| self.members.get(&(pou, CaseFolded(name))));
        let found = local
            .or_else(|| self.globals.get(&CaseFolded(name)))
            .or_else(|| self.pous.get(&CaseFolded(name)));
        let value = || self.values.get(&CaseFolded(name)).copied().unwrap_or(name);
        found.copied().unwrap_or_else(|| (value(), NameShape::Unknown))
    }

    /// A field of, or a parameter of, something of this shape.
    pub(super) fn member(&self, of: NameShape<'u, 's>, name: &'s str) -> NameEntry<'u, 's> {
        let place = match self.resolve(of) {
            NameShape::Unknown => None,
            NameShape::Typed(specification) => Some(specification.span.start),
            NameShape::Pou(pou) => Some(pou.span.start),
        };
        let found = place.and_then(|place| self.members.get(&(place, CaseFolded(name))));
        found.copied().unwrap_or((name, NameShape::Unknown))
    }

    /// An element of an array of this shape.
    pub(super) fn element(&self, of: NameShape<'u, 's>) -> NameShape<'u, 's> {
        match self.resolve(of) {
            NameShape::Typed(TypeSpecification {
                kind: TypeSpecificationKind::Array { element, .. },
                ..
            }) => NameShape::Typed(element),
            _ => NameShape::Unknown,
        }
    }

    /// The result of a call.
    pub(super) fn result(&self, of: NameShape<'u, 's>) -> NameShape<'u, 's> {
        match of {
            NameShape::Pou(Pou {
                result: Some(result), ..
            }) => NameShape::Typed(result),
            _ => NameShape::Unknown,
        }
    }

    /// The spelling of a type's name, if the text declares it.
    pub(super) fn type_name(&self, name: &'s str) -> Option<&'s str> {
        let found = self
            .types
            .get(&CaseFolded(name))
            .or_else(|| self.pous.get(&CaseFolded(name)));
        found.map(|(spelling, _)| *spelling)
    }

    /// The spelling of an enumerated value.
    pub(super) fn value(&self, name: &'s str) -> &'s str {
        self.values.get(&CaseFolded(name)).copied().unwrap_or(name)
    }

    /// The spelling of a POU's name.
    pub(super) fn pou_name(&self, name: &'s str) -> &'s str {
        self.pous
            .get(&CaseFolded(name))
            .map_or(name, |(spelling, _)| *spelling)
    }

    /// Returns the types that names of types stand for in the end; of references and pointers what these lead to.
    fn resolve(&self, mut shape: NameShape<'u, 's>) -> NameShape<'u, 's> {
        for _ in 0..MAX_ALIASES {
            let NameShape::Typed(specification) = shape else {
                return shape;
            };
            let name = match &specification.kind {
                TypeSpecificationKind::Named(name) => name,
                TypeSpecificationKind::Pointer { target, .. } => {
                    shape = NameShape::Typed(target);
                    continue;
                }
                _ => return shape,
            };
            let key = CaseFolded(name.text);
            let Some((_, named)) = self.types.get(&key).or_else(|| self.pous.get(&key)) else {
                break;
            };
            shape = *named;
        }
        NameShape::Unknown
    }
}
