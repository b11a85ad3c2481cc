//! The names that a source text declares, as far as they tell in which place a value stands.

use rustc_hash::FxHashMap;
use stickler_syntax::tree::{
    CaseFolded, Declaration, Pou, PouKind, SourceUnit, TypeSpecification, TypeSpecificationKind,
    VariableBlock, VariableKind,
};
use stickler_types::ElementaryType;

/// The program organization units and the global variables of a source text.
#[derive(Debug, Default)]
pub struct SourceNames<'u> {
    derived: FxHashMap<CaseFolded<'u>, DerivedForm>,
    pous: FxHashMap<CaseFolded<'u>, &'u Pou<'u>>,
    globals: FxHashMap<CaseFolded<'u>, SectionVariable<'u>>,
}

/// A form of user-defined types with the values of an elementary one.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DerivedForm {
    /// Another name of a type: `TYPE LENGTH : INT; END_TYPE`.
    Alias,
    /// A part of the values of a type: `TYPE PERCENT : INT(0..100); END_TYPE`.
    Subrange,
}

/// The variables of a program organization unit.
#[derive(Debug, Default)]
pub struct Variables<'u> {
    by_name: FxHashMap<CaseFolded<'u>, SectionVariable<'u>>,
    /// The name of the function whose result is a variable of that name.
    function: Option<CaseFolded<'u>>,
}

/// A variable, and the section in which it is declared.
#[derive(Clone, Copy, Debug)]
pub struct SectionVariable<'u> {
    /// The kind of section.
    pub kind: VariableKind,
    /// Whether CONSTANT stands behind the section's keyword.
    pub constant: bool,
    /// Whether RETAIN stands behind the section's keyword.
    pub retained: bool,
    /// Whether it is directly represented: `x AT %MW5 : INT;`.
    pub located: bool,
    specification: &'u TypeSpecification<'u>,
}

impl<'u> SourceNames<'u> {
    /// Collects the names of a source text.
    pub fn new(unit: &'u SourceUnit<'u>) -> SourceNames<'u> {
        let mut names = SourceNames::default();
        for declaration in &unit.declarations {
            match declaration {
                Declaration::Pou(pou) => {
                    names.pous.insert(CaseFolded(pou.name.text), pou);
                }
                Declaration::Globals(block) => declare(&mut names.globals, block),
                Declaration::Configuration(configuration) => {
                    let blocks = configuration.globals.iter();
                    blocks.for_each(|block| declare(&mut names.globals, block));
                }
                Declaration::Types(types) => {
                    for declared in types {
                        let form = names.form(&declared.specification);
                        let name = CaseFolded(declared.name.text);
                        names.derived.extend(form.map(|form| (name, form)));
                    }
                }
            }
        }
        names
    }

    /// Returns the form of the type that a specification declares; `None` where it is none of these.
    fn form(&self, specification: &TypeSpecification<'_>) -> Option<DerivedForm> {
        match &specification.kind {
            TypeSpecificationKind::Named(name) if ElementaryType::from_name(name.text).is_some() => {
                Some(DerivedForm::Alias)
            }
            TypeSpecificationKind::Subrange { .. } => Some(DerivedForm::Subrange),
            _ => self.derived(specification),
        }
    }

    /// Returns the form of the type with which something is declared; `None` where it is not user-defined, or declared in other ways.
    pub fn derived(&self, specification: &TypeSpecification<'_>) -> Option<DerivedForm> {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.derived.get(&CaseFolded(name.text)).copied(),
            _ => None,
        }
    }

    /// Returns whether a variable is an array of elements of such a type.
    pub fn has_derived_elements(&self, variable: SectionVariable<'_>) -> bool {
        match &variable.specification.kind {
            TypeSpecificationKind::Array { element, .. } => self.derived(element).is_some(),
            _ => false,
        }
    }

    /// Returns the form of the type of a variable; `None` where it is none of these.
    pub fn form_of(&self, variable: SectionVariable<'_>) -> Option<DerivedForm> {
        self.derived(variable.specification)
    }

    /// Returns the kind of the program organization unit of a name.
    pub fn pou(&self, name: &str) -> Option<PouKind> {
        self.pous.get(&CaseFolded(name)).map(|pou| pou.kind)
    }

    /// Returns a variable of a unit, or else a global one.
    pub fn variable(&self, variables: &Variables<'u>, name: &str) -> Option<SectionVariable<'u>> {
        let name = CaseFolded(name);
        let found = variables.by_name.get(&name).or_else(|| self.globals.get(&name));
        found.copied()
    }

    /// Returns whether a type is that of a function block.
    pub fn is_block(&self, specification: &TypeSpecification<'_>) -> bool {
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.pou(name.text) == Some(PouKind::FunctionBlock),
            _ => false,
        }
    }

    /// Returns whether a variable is an instance of a function block.
    pub fn is_instance(&self, variable: SectionVariable<'_>) -> bool {
        self.is_block(variable.specification)
    }
}

impl<'u> Variables<'u> {
    /// Collects the variables of a unit.
    pub fn new(pou: &'u Pou<'u>) -> Variables<'u> {
        let mut variables = Variables {
            function: (pou.kind == PouKind::Function).then_some(CaseFolded(pou.name.text)),
            ..Variables::default()
        };
        for block in &pou.blocks {
            declare(&mut variables.by_name, block);
        }
        variables
    }

    /// Returns whether a name is that of the function itself, which is its result there.
    pub fn is_result(&self, name: &str) -> bool {
        self.function.is_some_and(|function| function == CaseFolded(name))
    }
}

fn declare<'u>(variables: &mut FxHashMap<CaseFolded<'u>, SectionVariable<'u>>, block: &'u VariableBlock<'u>) {
    let retained = block
        .retention
        .is_some_and(|word| word.eq_ignore_ascii_case("RETAIN"));
    for group in &block.groups {
        let variable = SectionVariable {
            kind: block.kind,
            constant: block.constant,
            retained,
            located: group.location.is_some(),
            specification: &group.specification,
        };
        variables.extend(group.names.iter().map(|name| (CaseFolded(name.text), variable)));
    }
}
