//! Program organization units, variables, types and initial values.

use super::{CaseFolded, Configuration, ExpressionId, Name, Statement};
use crate::source::Span;
use crate::token::TokenKind;
use stickler_types::words;

/// A declaration at the top level of a source text.
#[derive(PartialEq, Debug)]
pub enum Declaration<'s> {
    /// PROGRAM, FUNCTION, FUNCTION_BLOCK, CLASS or INTERFACE.
    Pou(Pou<'s>),
    /// TYPE … END_TYPE.
    Types(Vec<TypeDeclaration<'s>>),
    /// VAR_GLOBAL … END_VAR outside a configuration.
    Globals(VariableBlock<'s>),
    /// CONFIGURATION … END_CONFIGURATION.
    Configuration(Configuration<'s>),
    /// NAMESPACE and its name; the declarations up to the matching [`Declaration::EndNamespace`] belong to it.
    Namespace(Name<'s>),
    /// The keyword END_NAMESPACE.
    EndNamespace(Name<'s>),
    /// USING and the name of one namespace.
    Using(Name<'s>),
}

impl Declaration<'_> {
    /// Returns the place of a program organization unit, a configuration or a section of global variables; `None` for others.
    pub fn span(&self) -> Option<Span> {
        match self {
            Declaration::Pou(pou) => Some(pou.span),
            Declaration::Globals(section) => Some(section.span),
            Declaration::Configuration(configuration) => Some(configuration.span),
            _ => None,
        }
    }
}

/// The kind of a program organization unit.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum PouKind {
    /// PROGRAM.
    Program,
    /// FUNCTION.
    Function,
    /// FUNCTION_BLOCK.
    FunctionBlock,
    /// CLASS: a function block without statements of its own.
    Class,
    /// INTERFACE: its members have no statements.
    Interface,
    /// METHOD, a member of one of the others.
    Method,
    /// GET of a PROPERTY.
    Getter,
    /// SET of a PROPERTY.
    Setter,
}

impl PouKind {
    /// Returns whether the POU is a member of another one.
    pub const fn is_member(self) -> bool {
        matches!(self, PouKind::Method | PouKind::Getter | PouKind::Setter)
    }

    /// Returns the keyword that closes the POU: END_ and the word that opens it.
    pub const fn closer(self) -> TokenKind {
        match self {
            PouKind::Program => TokenKind::EndProgram,
            PouKind::Function => TokenKind::EndFunction,
            PouKind::FunctionBlock => TokenKind::EndFunctionBlock,
            PouKind::Class => TokenKind::EndClass,
            PouKind::Interface => TokenKind::EndInterface,
            PouKind::Method => TokenKind::EndMethod,
            PouKind::Getter => TokenKind::EndGet,
            PouKind::Setter => TokenKind::EndSet,
        }
    }
}

words! {
    /// An access specifier.
    Access spelled {
        Public = "PUBLIC", Private = "PRIVATE", Protected = "PROTECTED", Internal = "INTERNAL",
    }
}

/// The keywords before the name of a POU.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Modifiers {
    /// The access specifier.
    pub access: Option<Access>,
    /// ABSTRACT.
    pub is_abstract: bool,
    /// FINAL.
    pub is_final: bool,
    /// OVERRIDE.
    pub is_override: bool,
}

impl Modifiers {
    /// Returns the keywords behind the access specifier.
    pub fn words(self) -> impl Iterator<Item = &'static str> {
        let Modifiers {
            access: _,
            is_abstract,
            is_final,
            is_override,
        } = self;
        let all = [
            (is_abstract, "ABSTRACT"),
            (is_final, "FINAL"),
            (is_override, "OVERRIDE"),
        ];
        all.into_iter()
            .filter_map(|(is_there, word)| is_there.then_some(word))
    }
}

/// A program organization unit.
#[derive(Debug)]
pub struct Pou<'s> {
    /// The kind.
    pub kind: PouKind,
    /// The keywords before the name.
    pub modifiers: Modifiers,
    /// The name; the GET and the SET of a property both have the property's, at the same place.
    pub name: Name<'s>,
    /// The namespaces behind USING in the head.
    pub using: Vec<Name<'s>>,
    /// The names behind EXTENDS.
    pub extends: Vec<Name<'s>>,
    /// The names behind IMPLEMENTS.
    pub implements: Vec<Name<'s>>,
    /// The result type of a function or method, and the type of a property: with its GET, or else with its SET. `None` for other kinds,
    /// and where there is no result.
    pub result: Option<TypeSpecification<'s>>,
    /// The variable sections.
    pub blocks: Vec<VariableBlock<'s>>,
    /// The statements.
    pub body: Vec<Statement>,
    /// The methods and properties, GET before SET.
    pub members: Vec<Pou<'s>>,
    /// From the first keyword to the last.
    pub span: Span,
    /// The closing keyword.
    pub end: Span,
}

impl Pou<'_> {
    /// Returns whether the POU has anything of object orientation.
    pub fn is_object(&self) -> bool {
        let is_plain = self.members.is_empty() && self.extends.is_empty() && self.implements.is_empty();
        !is_plain
            || self.modifiers != Modifiers::default()
            || matches!(self.kind, PouKind::Class | PouKind::Interface)
    }
}

words! {
    /// The section that a variable is declared in: VAR_INST is one of a method, and of VAR_STAT there is one variable for all instances
    /// and calls.
    VariableKind spelled {
        Local = "VAR", Temporary = "VAR_TEMP", Instance = "VAR_INST", Static = "VAR_STAT",
        Input = "VAR_INPUT", Output = "VAR_OUTPUT", InOut = "VAR_IN_OUT",
        External = "VAR_EXTERNAL", Global = "VAR_GLOBAL", Configured = "VAR_CONFIG",
    }
}

impl VariableKind {
    /// Returns whether the variables of the section hold values of their own, and do not stand for others.
    pub const fn is_held(self) -> bool {
        !matches!(self, VariableKind::InOut | VariableKind::External)
    }
}

/// One variable section, VAR … END_VAR.
#[derive(Debug)]
pub struct VariableBlock<'s> {
    /// The kind of section.
    pub kind: VariableKind,
    /// The access specifier.
    pub access: Option<Access>,
    /// Whether CONSTANT stands behind the section's keyword.
    pub constant: bool,
    /// RETAIN or NON_RETAIN as written; it has no effect on a run, and is kept for the renderer.
    pub retention: Option<CaseFolded<'s>>,
    /// The declarations.
    pub groups: Vec<VariableGroup<'s>>,
    /// From VAR… to END_VAR.
    pub span: Span,
}

/// `a, b : TYPE := initializer;`: also the fields of a structure.
#[derive(PartialEq, Debug)]
pub struct VariableGroup<'s> {
    /// The names declared.
    pub names: Vec<Name<'s>>,
    /// The location of a directly represented variable: `%MW5` of `x AT %MW5 : INT;`.
    pub location: Option<Name<'s>>,
    /// Their common type.
    pub specification: TypeSpecification<'s>,
    /// The edge of the input that the block sees in its place.
    pub edge: Option<Edge>,
    /// Their common initial value.
    pub initializer: Option<Initializer<'s>>,
}

words! {
    /// The edge qualifier of an input.
    Edge {
        /// R_EDGE: TRUE in the call in which the input becomes TRUE.
        Rising = "R_EDGE",
        /// F_EDGE: TRUE in the call in which the input becomes FALSE.
        Falling = "F_EDGE",
    }
}

impl VariableGroup<'_> {
    /// Returns whether the variable has a location that a VAR_CONFIG completes: `%I*`.
    pub fn is_partly_located(&self) -> bool {
        self.location.is_some_and(|location| location.text.ends_with('*'))
    }
}

/// `name : specification := initializer;` in TYPE … END_TYPE.
#[derive(PartialEq, Debug)]
pub struct TypeDeclaration<'s> {
    /// The new type's name.
    pub name: Name<'s>,
    /// The structure that this one extends.
    pub extends: Option<Name<'s>>,
    /// The type that it stands for.
    pub specification: TypeSpecification<'s>,
    /// The default initial value.
    pub initializer: Option<Initializer<'s>>,
}

/// The name of the type of an input that stands for any number of arguments.
pub const ANY_ARGUMENTS: &str = "...";

/// A type as written in a declaration.
#[derive(Debug)]
pub struct TypeSpecification<'s> {
    /// The form.
    pub kind: TypeSpecificationKind<'s>,
    /// The place in the text.
    pub span: Span,
}

/// The forms of a type in a declaration.
#[derive(PartialEq, Debug)]
pub enum TypeSpecificationKind<'s> {
    /// An elementary or declared type's name, STRING and WSTRING without a length among them.
    Named(Name<'s>),
    /// `STRING[n]` or `WSTRING[n]`.
    Text {
        /// The keyword.
        name: Name<'s>,
        /// The maximum length.
        length: ExpressionId,
    },
    /// `INT(low..high)`.
    Subrange {
        /// The base type.
        base: Name<'s>,
        /// The lower and the upper limit.
        limits: (ExpressionId, ExpressionId),
    },
    /// `ARRAY[low..high, …] OF element`.
    Array {
        /// The limits of each dimension.
        dimensions: Vec<(ExpressionId, ExpressionId)>,
        /// The elements' type.
        element: Box<TypeSpecification<'s>>,
    },
    /// `ARRAY[*, …] OF element`: a parameter that takes arrays of any limits.
    VariableLengthArray {
        /// The number of dimensions.
        dimensions: u32,
        /// The elements' type.
        element: Box<TypeSpecification<'s>>,
    },
    /// `REF_TO target`, `POINTER TO target` or `REFERENCE TO target`.
    Pointer {
        /// The words in front of the type.
        form: PointerForm,
        /// The type of what it leads to.
        target: Box<TypeSpecification<'s>>,
    },
    /// `(RED, GREEN := 5, BLUE)`, with a base type in front or behind where one is written.
    Enumeration {
        /// `INT` of `INT (RED, GREEN)` or `(RED, GREEN) INT`.
        base: Option<Name<'s>>,
        /// The values' names and what they are given.
        values: Vec<(Name<'s>, Option<ExpressionId>)>,
    },
    /// `STRUCT … END_STRUCT`.
    Structure(Vec<VariableGroup<'s>>),
    /// `UNION … END_UNION`.
    Union(Vec<VariableGroup<'s>>),
    /// A type that could not be read, or that names something that is not implemented; a diagnostic has been
    /// given, and nothing more is said about what is declared with it.
    Error,
}

words! {
    /// The words that make a type one of references or pointers.
    PointerForm {
        /// `REF_TO`: the standard's references, followed by `^`.
        RefTo = "REF_TO",
        /// `POINTER TO`: an address, followed by `^`.
        PointerTo = "POINTER TO",
        /// `REFERENCE TO`: another name of the variable to which `REF=` binds it.
        ReferenceTo = "REFERENCE TO",
    }
}

impl PointerForm {
    /// Returns the key of the feature in `conformance-cases/features.toml`.
    pub const fn feature(self) -> &'static str {
        match self {
            PointerForm::RefTo => "reference",
            PointerForm::PointerTo => "pointer",
            PointerForm::ReferenceTo => "reference-to",
        }
    }
}

/// An initial value.
#[derive(Debug)]
pub struct Initializer<'s> {
    /// The form.
    pub kind: InitializerKind<'s>,
    /// The place in the text.
    pub span: Span,
}

/// The forms of an initial value.
#[derive(PartialEq, Debug)]
pub enum InitializerKind<'s> {
    /// An expression.
    Expression(ExpressionId),
    /// `[1, 2, 3(0)]`.
    Array(Vec<ArrayElement<'s>>),
    /// `(x := 1, y := 2)`.
    Structure(Vec<(Name<'s>, Initializer<'s>)>),
}

/// One entry of an array's initial value.
#[derive(PartialEq, Debug)]
pub struct ArrayElement<'s> {
    /// `3` of `3(0)`.
    pub repetition: Option<ExpressionId>,
    /// The value, or the values that are repeated together: `2(1, 2)`; none for `3()`, which leaves the default.
    pub values: Vec<Initializer<'s>>,
}
