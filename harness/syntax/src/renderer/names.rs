//! Spells names as the declarations of a text do, found without checking types: enough is known of the shape of
//! variables to spell fields too.

use crate::tree::{
    CaseFolded, Pou, PouKind, SourceUnit, TypeDeclaration, TypeSpecification, TypeSpecificationKind,
    VariableGroup, own_instance,
};
use crate::visitor::{Context, Visitor, walk};
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

/// The declarations that are searched for a name which a POU or structure does not declare itself.
#[derive(Clone, Copy)]
struct Outer<'u, 's> {
    /// The POU around a method; any other POU itself.
    owner: Option<&'u Pou<'s>>,
    /// The name behind EXTENDS.
    base: Option<&'s str>,
}

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
    /// The POU around a method, and the one or the structure that another extends, by its place.
    outer: FxHashMap<u32, Outer<'u, 's>>,
}

impl<'u, 's: 'u> Visitor<'u, 's> for Names<'u, 's> {
    fn pou(&mut self, pou: &'u Pou<'s>, _: &Context<'u, 's>) {
        if !pou.kind.is_member() {
            self.pous
                .insert(CaseFolded(pou.name.text), (pou.name.text, NameShape::Pou(pou)));
            self.declare_in(pou, pou);
        }
    }

    fn type_declaration(&mut self, declared: &'u TypeDeclaration<'s>, _: &Context<'u, 's>) {
        let name = declared.name.text;
        let shape = NameShape::Typed(&declared.specification);
        self.types.insert(CaseFolded(name), (name, shape));
        if let Some(base) = declared.extends {
            let base = Some(base.unqualified().text);
            let place = declared.specification.span.start;
            self.outer.insert(place, Outer { owner: None, base });
        }
    }

    fn variables(&mut self, group: &'u VariableGroup<'s>, at: &Context<'u, 's>) {
        // A field lies in the structure around it, a variable in its POU; global variables have none.
        let around = match at.is_field() {
            true => at.outer,
            false => at.pou.map(|pou| pou.span),
        };
        for name in &group.names {
            let (key, entry) = (CaseFolded(name.text), NameShape::Typed(&group.specification));
            match around {
                Some(around) => self.members.insert((around.start, key), (name.text, entry)),
                None => self.globals.insert(key, (name.text, entry)),
            };
        }
    }

    fn specification(&mut self, specification: &'u TypeSpecification<'s>, _: &Context<'u, 's>) {
        if let TypeSpecificationKind::Enumeration { values, .. } = &specification.kind {
            self.values
                .extend(values.iter().map(|(name, _)| (CaseFolded(name.text), name.text)));
        }
    }
}

impl<'u, 's> Names<'u, 's> {
    pub(super) fn new(unit: &'u SourceUnit<'s>) -> Names<'u, 's> {
        let mut names = Names::default();
        walk(unit, &mut names);
        names
    }

    /// Declares the methods and properties of a POU; `owner` is the one that it is a member of, or itself.
    fn declare_in(&mut self, pou: &'u Pou<'s>, owner: &'u Pou<'s>) {
        let place = pou.span.start;
        let outer = Outer {
            owner: Some(owner),
            base: pou.extends.first().map(|base| base.unqualified().text),
        };
        self.outer.insert(place, outer);
        for member in &pou.members {
            let name = member.name.text;
            let shape = match (&member.result, member.kind) {
                (Some(ty), PouKind::Getter | PouKind::Setter) => NameShape::Typed(ty),
                _ => NameShape::Pou(member),
            };
            let key = (place, CaseFolded(name));
            self.members.entry(key).or_insert((name, shape));
            self.declare_in(member, pou);
        }
    }

    /// Finds a name in the POU or structure at a place, or else in those around it and those that it extends.
    fn find_in(&self, mut place: u32, name: &'s str) -> Option<NameEntry<'u, 's>> {
        for _ in 0..MAX_ALIASES {
            if let Some(found) = self.members.get(&(place, CaseFolded(name))) {
                return Some(*found);
            }
            let outer = self.outer.get(&place)?;
            let around = outer.owner.map(|owner| owner.span.start);
            place = match around.filter(|around| *around != place) {
                Some(around) => around,
                None => self.place(self.shape_of(outer.base?)?)?,
            };
        }
        None
    }

    /// The declaration of a type or POU.
    fn declared(&self, name: &'s str) -> Option<&NameEntry<'u, 's>> {
        let key = CaseFolded(name);
        self.types.get(&key).or_else(|| self.pous.get(&key))
    }

    fn shape_of(&self, name: &'s str) -> Option<NameShape<'u, 's>> {
        self.declared(name).map(|(_, shape)| *shape)
    }

    /// The place by which the members of something of this shape are found.
    fn place(&self, of: NameShape<'u, 's>) -> Option<u32> {
        match self.resolve(of) {
            NameShape::Unknown => None,
            NameShape::Typed(specification) => Some(specification.span.start),
            NameShape::Pou(pou) => Some(pou.span.start),
        }
    }

    /// A name that stands alone in the POU at `pou`.
    pub(super) fn variable(&self, pou: Option<u32>, name: &'s str) -> NameEntry<'u, 's> {
        let found = pou
            .and_then(|pou| self.find_in(pou, name))
            .or_else(|| self.globals.get(&CaseFolded(name)).copied())
            .or_else(|| self.pous.get(&CaseFolded(name)).copied());
        let value = || self.values.get(&CaseFolded(name)).copied().unwrap_or(name);
        found
            .or_else(|| self.own_instance(pou?, name))
            .unwrap_or_else(|| (value(), NameShape::Unknown))
    }

    /// The POU whose instance THIS or SUPER names in the POU at a place.
    fn own_instance(&self, place: u32, name: &'s str) -> Option<NameEntry<'u, 's>> {
        let owner = self.outer.get(&place)?.owner?;
        let shape = match own_instance(name)? {
            "THIS" => NameShape::Pou(owner),
            _ => self.shape_of(owner.extends.first()?.unqualified().text)?,
        };
        Some((name, shape))
    }

    /// A field of, or a parameter of, something of this shape.
    pub(super) fn member(&self, of: NameShape<'u, 's>, name: &'s str) -> NameEntry<'u, 's> {
        let found = self.place(of).and_then(|place| self.find_in(place, name));
        found.unwrap_or((name, NameShape::Unknown))
    }

    /// An element of an array of this shape.
    pub(super) fn element(&self, of: NameShape<'u, 's>) -> NameShape<'u, 's> {
        match self.resolve(of) {
            NameShape::Typed(TypeSpecification {
                kind:
                    TypeSpecificationKind::Array { element, .. }
                    | TypeSpecificationKind::VariableLengthArray { element, .. },
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
        self.declared(name).map(|(spelling, _)| *spelling)
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
            let Some(named) = self.shape_of(name.text) else {
                break;
            };
            shape = named;
        }
        NameShape::Unknown
    }
}
