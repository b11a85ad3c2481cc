//! The names that a text declares, and the places in which it uses names.

use crate::features::with_all_syntax;
use crate::parse;
use crate::token::{Token, TokenKind, tokens};
use crate::tree::{
    Argument, Declaration, ExpressionKind, Initializer, InitializerKind, Name, Pou, PouKind, SourceUnit,
    TypeDeclaration, TypeSpecification, TypeSpecificationKind, VariableBlock, VariableGroup, VariableKind,
};
use crate::visitor::{Context, Part, Place, Visitor, walk};
use std::collections::HashSet;
use stickler_types::{Code, Dialect};

/// What a declared name names.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum DeclaredKind {
    /// A program organization unit.
    Pou(PouKind),
    /// A data type.
    Type,
    /// A value of an enumeration.
    EnumeratedValue,
    /// A field of a structure.
    Field,
    /// A variable of a section.
    Variable(VariableKind),
    /// A configuration, or a resource, a task or a program instance in one.
    Configuration,
}

/// A name where it is declared.
#[derive(Clone, Copy, Debug)]
pub struct DeclaredName<'t, 's> {
    /// The name.
    pub name: Name<'s>,
    /// What it names.
    pub kind: DeclaredKind,
    /// The program organization unit inside of which the name is known; `None` where the whole text knows it.
    pub inside: Option<&'t Pou<'s>>,
    /// The declaration of a variable or a field; `None` for other names.
    pub group: Option<&'t VariableGroup<'s>>,
    /// The section of a variable; `None` for other names.
    pub section: Option<&'t VariableBlock<'s>>,
}

/// What a name stands for where it is used.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum UseKind {
    /// A variable, a value of an enumeration or the result of a function, in an expression.
    Value,
    /// A function or an instance that is called.
    Callee,
    /// A field, or an output of an instance.
    Field,
    /// A parameter of a call.
    Parameter,
    /// A data type or a function block, in a declaration or before the `#` of a value.
    Type,
}

/// A name where it is used.
#[derive(Clone, Copy, Debug)]
pub struct UsedName<'t, 's> {
    /// The name.
    pub name: Name<'s>,
    /// What it stands for.
    pub kind: UseKind,
    /// The program organization unit around; `None` outside of all.
    pub inside: Option<&'t Pou<'s>>,
}

/// Returns the names that a text declares, in the order of the text.
pub fn declared<'t, 's>(unit: &'t SourceUnit<'s>) -> Vec<DeclaredName<'t, 's>> {
    names(unit).declared
}

/// Returns the uses of names in a text, in the order of the text; names of elementary types are among them.
pub fn used<'t, 's>(unit: &'t SourceUnit<'s>) -> Vec<UsedName<'t, 's>> {
    names(unit).used
}

/// Returns the names that a program declares for all of its text, in capitals: units, types and values of enumerations. `None`
/// where the program cannot stand in one text with others: it is not whole, has a pragma or a method, or shares variables with a
/// configuration or, unless `takes_locations`, with the machine.
pub fn separable(text: &str, dialect: &Dialect, takes_locations: bool) -> Option<HashSet<String>> {
    let (unit, diagnostics) = parse(text, &with_all_syntax(dialect));
    let tokens = tokens(text, dialect);
    let is_located = |token: &Token| !takes_locations && token.kind == TokenKind::Direct;
    let is_shared = |declaration: &Declaration<'_>| match declaration {
        Declaration::Pou(pou) => {
            let mut blocks = pou.blocks.iter();
            pou.is_object() || blocks.any(|block| block.kind == VariableKind::External)
        }
        Declaration::Types(_) => false,
        Declaration::Namespace(_) | Declaration::EndNamespace(_) | Declaration::Using(_) => true,
        Declaration::Globals(_) | Declaration::Configuration(_) => true,
    };
    let shares = tokens.list.iter().any(is_located) || unit.declarations.iter().any(is_shared);
    // Forms that a dialect does not have leave the rest of the program as it is.
    let is_harmless = |code| matches!(code, Code::UnexpectedToken | Code::CStyleComment);
    let is_whole = diagnostics.iter().all(|diagnostic| is_harmless(diagnostic.code));
    if shares || tokens.has_pragma(text) || !tokens.is_complete || !is_whole {
        return None;
    }
    let is_known_everywhere = |one: &DeclaredName<'_, '_>| match one.kind {
        DeclaredKind::Pou(kind) => !kind.is_member(),
        DeclaredKind::Type | DeclaredKind::EnumeratedValue => true,
        DeclaredKind::Field | DeclaredKind::Variable(_) | DeclaredKind::Configuration => false,
    };
    let names = declared(&unit).into_iter().filter(is_known_everywhere);
    Some(names.map(|one| one.name.text.to_ascii_uppercase()).collect())
}

fn names<'t, 's>(unit: &'t SourceUnit<'s>) -> Names<'t, 's> {
    let mut names = Names::default();
    walk(unit, &mut names);
    for configuration in unit.configurations() {
        let mut inner = vec![configuration.name];
        for resource in &configuration.resources {
            inner.extend(resource.header.iter().map(|(name, _)| *name));
            inner.extend(resource.tasks.iter().map(|task| task.name));
            for program in &resource.programs {
                inner.push(program.name);
                names.note(program.type_name, UseKind::Type, None);
            }
        }
        for name in inner {
            names.declare(name, DeclaredKind::Configuration, None, None);
        }
    }
    names.declared.sort_by_key(|declared| declared.name.span.start);
    names.used.sort_by_key(|used| used.name.span.start);
    names
}

/// The names of a text.
#[derive(Default)]
struct Names<'t, 's> {
    declared: Vec<DeclaredName<'t, 's>>,
    used: Vec<UsedName<'t, 's>>,
}

impl<'t, 's> Names<'t, 's> {
    fn declare(
        &mut self,
        name: Name<'s>,
        kind: DeclaredKind,
        inside: Option<&'t Pou<'s>>,
        of_variable: Option<(&'t VariableGroup<'s>, Option<&'t VariableBlock<'s>>)>,
    ) {
        self.declared.push(DeclaredName {
            name,
            kind,
            inside,
            group: of_variable.map(|(group, _)| group),
            section: of_variable.and_then(|(_, section)| section),
        });
    }

    fn note(&mut self, name: Name<'s>, kind: UseKind, inside: Option<&'t Pou<'s>>) {
        self.used.push(UsedName { name, kind, inside });
    }
}

impl<'t, 's: 't> Visitor<'t, 's> for Names<'t, 's> {
    fn pou(&mut self, pou: &'t Pou<'s>, _: &Context<'t, 's>) {
        // The SET of a property has the name of its GET.
        if pou.kind != PouKind::Setter || pou.result.is_some() {
            self.declare(pou.name, DeclaredKind::Pou(pou.kind), None, None);
        }
        for base in pou.extends.iter().chain(&pou.implements) {
            self.note(base.unqualified(), UseKind::Type, None);
        }
    }

    fn type_declaration(&mut self, declaration: &'t TypeDeclaration<'s>, _: &Context<'t, 's>) {
        self.declare(declaration.name, DeclaredKind::Type, None, None);
        if let Some(base) = declaration.extends {
            self.note(base, UseKind::Type, None);
        }
    }

    fn variables(&mut self, group: &'t VariableGroup<'s>, at: &Context<'t, 's>) {
        let section = at.section.filter(|_| !at.is_field());
        let (kind, inside) = match section {
            Some(section) => (DeclaredKind::Variable(section.kind), at.pou),
            None => (DeclaredKind::Field, None),
        };
        // Of VAR_CONFIG the names are paths to variables that are declared elsewhere.
        let is_declared = kind != DeclaredKind::Variable(VariableKind::Configured);
        for name in group.names.iter().filter(|_| is_declared) {
            self.declare(*name, kind, inside, Some((group, section)));
        }
    }

    fn specification(&mut self, specification: &'t TypeSpecification<'s>, at: &Context<'t, 's>) {
        match &specification.kind {
            TypeSpecificationKind::Named(name)
            | TypeSpecificationKind::Text { name, .. }
            | TypeSpecificationKind::Subrange { base: name, .. } => {
                self.note(name.unqualified(), UseKind::Type, at.pou);
            }
            TypeSpecificationKind::Enumeration { base, values } => {
                if let Some(base) = base {
                    self.note(*base, UseKind::Type, at.pou);
                }
                for (name, _) in values {
                    self.declare(*name, DeclaredKind::EnumeratedValue, at.pou, None);
                }
            }
            TypeSpecificationKind::Array { .. }
            | TypeSpecificationKind::VariableLengthArray { .. }
            | TypeSpecificationKind::Pointer { .. }
            | TypeSpecificationKind::Structure(_)
            | TypeSpecificationKind::Union(_)
            | TypeSpecificationKind::Error => {}
        }
    }

    fn initializer(&mut self, initializer: &'t Initializer<'s>, at: &Context<'t, 's>) {
        if let InitializerKind::Structure(fields) = &initializer.kind {
            for (name, _) in fields {
                self.note(*name, UseKind::Field, at.pou);
            }
        }
    }

    fn expression(&mut self, part: Part<'t, 's>, at: &Context<'t, 's>) {
        match &part.expression.kind {
            ExpressionKind::Name(name) if name.text.ends_with('^') => {}
            ExpressionKind::Name(name) => {
                let kind = match part.place {
                    Place::Callee => UseKind::Callee,
                    _ => UseKind::Value,
                };
                self.note(*name, kind, at.pou);
            }
            ExpressionKind::EnumeratedValue(value) => {
                self.note(value.prefix(), UseKind::Type, at.pou);
                self.note(value.value(), UseKind::Value, at.pou);
            }
            ExpressionKind::Literal(literal) => {
                if let Some(prefix) = literal.prefix() {
                    self.note(prefix, UseKind::Type, at.pou);
                }
            }
            ExpressionKind::Field { field, .. } => self.note(*field, UseKind::Field, at.pou),
            ExpressionKind::Call { arguments, .. } => {
                for argument in arguments {
                    if let Argument::Named { name, .. } | Argument::Output { name, .. } = argument {
                        self.note(*name, UseKind::Parameter, at.pou);
                    }
                }
            }
            ExpressionKind::Index { .. }
            | ExpressionKind::Dereference { .. }
            | ExpressionKind::Bit { .. }
            | ExpressionKind::Part { .. }
            | ExpressionKind::Unary { .. }
            | ExpressionKind::Binary { .. }
            | ExpressionKind::Assigned { .. }
            | ExpressionKind::Parenthesized(_)
            | ExpressionKind::Aggregate(_)
            | ExpressionKind::Error => {}
        }
    }
}
