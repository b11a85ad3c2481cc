//! The names that a source text declares, as far as they tell in which place a value stands.

use rustc_hash::FxHashMap;
use stickler_syntax::names::{DeclaredKind, DeclaredName, declared};
use stickler_syntax::tree::{
    CaseFolded, Declaration, Pou, PouKind, SourceUnit, TypeSpecification, TypeSpecificationKind,
};
use stickler_types::ElementaryType;

/// The names of a source text, and the places of its user-defined types.
#[derive(Debug)]
pub struct SourceNames<'u> {
    declared: Vec<DeclaredName<'u, 'u>>,
    derived: FxHashMap<CaseFolded<'u>, &'static str>,
}

impl<'u> SourceNames<'u> {
    /// Collects the names of a source text.
    pub fn new(unit: &'u SourceUnit<'u>) -> SourceNames<'u> {
        let mut names = SourceNames {
            declared: declared(unit),
            derived: FxHashMap::default(),
        };
        for declaration in &unit.declarations {
            let Declaration::Types(types) = declaration else {
                continue;
            };
            for declared in types {
                let place = names.place_of_type(&declared.specification);
                let name = CaseFolded(declared.name.text);
                names.derived.extend(place.map(|place| (name, place)));
            }
        }
        names
    }

    /// Returns the place of the variables of a type that is declared so: `alias` of another name of an elementary type, `subrange` of a part
    /// of its values; `None` of other types.
    fn place_of_type(&self, specification: &TypeSpecification<'_>) -> Option<&'static str> {
        match &specification.kind {
            TypeSpecificationKind::Named(name) if ElementaryType::from_name(name.text).is_some() => {
                Some("alias")
            }
            TypeSpecificationKind::Subrange { .. } => Some("subrange"),
            _ => self.derived(specification),
        }
    }

    /// Returns the place of the variables of a user-defined type with the values of an elementary one; `None` for other types.
    pub fn derived(&self, specification: &TypeSpecification<'_>) -> Option<&'static str> {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.derived.get(&CaseFolded(name.text)).copied(),
            _ => None,
        }
    }

    /// Returns the kind of the program organization unit of a name.
    pub fn pou(&self, name: &str) -> Option<PouKind> {
        self.declared.iter().rev().find_map(|one| match one.kind {
            DeclaredKind::Pou(kind) if !kind.is_member() && one.name.is(name) => Some(kind),
            _ => None,
        })
    }

    /// Returns a variable of a unit, or else a global one.
    pub fn variable(&self, pou: Option<&Pou<'_>>, name: &str) -> Option<&DeclaredName<'u, 'u>> {
        let named = self.declared.iter().rev();
        let named_in = |span| {
            let is_it = |one: &&DeclaredName<'_, '_>| {
                one.section.is_some() && one.inside.map(|pou| pou.span) == span && one.name.is(name)
            };
            named.clone().find(is_it)
        };
        named_in(pou.map(|pou| pou.span)).or_else(|| named_in(None))
    }

    /// Returns whether a type is that of a function block.
    pub fn is_block(&self, specification: &TypeSpecification<'_>) -> bool {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.pou(name.text) == Some(PouKind::FunctionBlock),
            _ => false,
        }
    }
}
