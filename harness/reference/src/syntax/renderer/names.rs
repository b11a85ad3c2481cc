//! Spells names as the declarations of a text do, found without checking types: enough is known of the shape of
//! variables to spell fields too.

use crate::syntax::tree::{
    Declaration, Folded, Pou, SourceUnit, TypeSpecification, TypeSpecificationKind, VariableBlock,
    VariableGroup,
};
use rustc_hash::FxHashMap;

/// The knowledge of the type of a name or of an expression.
#[derive(Clone, Copy, Default)]
pub(super) enum Shape<'u, 's> {
    /// Nothing.
    #[default]
    Unknown,
    /// A variable of this type.
    Typed(&'u TypeSpecification<'s>),
    /// A POU, or a variable that is an instance of one.
    Pou(&'u Pou<'s>),
}

/// A declaration: its spelling, and what is declared.
type Entry<'u, 's> = (&'s str, Shape<'u, 's>);

/// The most aliases that are followed; a cycle of them is no type.
const ALIASES: usize = 64;

/// The declarations of a text.
#[derive(Default)]
pub(super) struct Names<'u, 's> {
    types: FxHashMap<Folded<'s>, Entry<'u, 's>>,
    pous: FxHashMap<Folded<'s>, Entry<'u, 's>>,
    globals: FxHashMap<Folded<'s>, Entry<'u, 's>>,
    values: FxHashMap<Folded<'s>, &'s str>,
    /// The variables of a POU or the fields of a structure, by the place of the POU or the structure.
    members: FxHashMap<(u32, Folded<'s>), Entry<'u, 's>>,
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
                        names
                            .types
                            .insert(Folded(name), (name, Shape::Typed(&declared.specification)));
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
            .insert(Folded(pou.name.text), (pou.name.text, Shape::Pou(pou)));
        pou.blocks
            .iter()
            .for_each(|block| self.declare_members(pou.span.start, &block.groups));
    }

    fn declare_globals(&mut self, block: &'u VariableBlock<'s>) {
        for group in &block.groups {
            self.declare_parts(&group.specification);
            let shape = Shape::Typed(&group.specification);
            self.globals.extend(
                group
                    .names
                    .iter()
                    .map(|name| (Folded(name.text), (name.text, shape))),
            );
        }
    }

    fn declare_members(&mut self, place: u32, groups: &'u [VariableGroup<'s>]) {
        for group in groups {
            self.declare_parts(&group.specification);
            let shape = Shape::Typed(&group.specification);
            self.members.extend(
                group
                    .names
                    .iter()
                    .map(|name| ((place, Folded(name.text)), (name.text, shape))),
            );
        }
    }

    /// The enumerated values and the fields that a type written out in a declaration declares.
    fn declare_parts(&mut self, specification: &'u TypeSpecification<'s>) {
        match &specification.kind {
            TypeSpecificationKind::Enumeration { values, .. } => {
                self.values
                    .extend(values.iter().map(|(name, _)| (Folded(name.text), name.text)));
            }
            TypeSpecificationKind::Structure(fields) => {
                self.declare_members(specification.span.start, fields)
            }
            TypeSpecificationKind::Array { element, .. } => self.declare_parts(element),
            _ => {}
        }
    }

    /// A name that stands alone in the POU at `pou`.
    pub(super) fn variable(&self, pou: Option<u32>, name: &'s str) -> Entry<'u, 's> {
        let local = pou.and_then(|pou| self.members.get(&(pou, Folded(name))));
        let found = local
            .or_else(|| self.globals.get(&Folded(name)))
            .or_else(|| self.pous.get(&Folded(name)));
        let value = || self.values.get(&Folded(name)).copied().unwrap_or(name);
        found.copied().unwrap_or_else(|| (value(), Shape::Unknown))
    }

    /// A field of, or a parameter of, something of this shape.
    pub(super) fn member(&self, of: Shape<'u, 's>, name: &'s str) -> Entry<'u, 's> {
        let place = match self.resolve(of) {
            Shape::Unknown => None,
            Shape::Typed(specification) => Some(specification.span.start),
            Shape::Pou(pou) => Some(pou.span.start),
        };
        let found = place.and_then(|place| self.members.get(&(place, Folded(name))));
        found.copied().unwrap_or((name, Shape::Unknown))
    }

    /// An element of an array of this shape.
    pub(super) fn element(&self, of: Shape<'u, 's>) -> Shape<'u, 's> {
        match self.resolve(of) {
            Shape::Typed(TypeSpecification {
                kind: TypeSpecificationKind::Array { element, .. },
                ..
            }) => Shape::Typed(element),
            _ => Shape::Unknown,
        }
    }

    /// The result of a call.
    pub(super) fn result(&self, of: Shape<'u, 's>) -> Shape<'u, 's> {
        match of {
            Shape::Pou(Pou {
                result: Some(result), ..
            }) => Shape::Typed(result),
            _ => Shape::Unknown,
        }
    }

    /// The spelling of a type's name, if the text declares it.
    pub(super) fn type_name(&self, name: &'s str) -> Option<&'s str> {
        let found = self
            .types
            .get(&Folded(name))
            .or_else(|| self.pous.get(&Folded(name)));
        found.map(|(spelling, _)| *spelling)
    }

    /// The spelling of an enumerated value.
    pub(super) fn value(&self, name: &'s str) -> &'s str {
        self.values.get(&Folded(name)).copied().unwrap_or(name)
    }

    /// The spelling of a POU's name.
    pub(super) fn pou_name(&self, name: &'s str) -> &'s str {
        self.pous
            .get(&Folded(name))
            .map_or(name, |(spelling, _)| *spelling)
    }

    /// Returns the types that names of types stand for in the end.
    fn resolve(&self, mut shape: Shape<'u, 's>) -> Shape<'u, 's> {
        for _ in 0..ALIASES {
            let Shape::Typed(TypeSpecification {
                kind: TypeSpecificationKind::Named(name),
                ..
            }) = shape
            else {
                return shape;
            };
            let key = Folded(name.text);
            let Some((_, named)) = self.types.get(&key).or_else(|| self.pous.get(&key)) else {
                break;
            };
            shape = *named;
        }
        Shape::Unknown
    }
}
