//! The model that declarations make: types, program organization units, variables and where they
//! lie. It is made once, by `declare`, and only read while bodies are lowered.

use super::constant::Constant;
use super::scope::Scope;
use super::types::{TypeId, TypeTable};
use crate::instruction::RoutineId;
use rustc_hash::{FxHashMap, FxHashSet};
use std::ops::Range;
use stickler_syntax::source::LineIndex;
use stickler_syntax::tree::{
    Access, CaseFolded, Edge, Expression, ExpressionId, Initializer, Name, Pou, PouKind, SourceUnit,
    VariableBlock, VariableGroup, VariableKind,
};
use stickler_syntax::{Meaning, NamespaceId, Namespaces};
use stickler_types::{Dialect, ElementaryType};

/// The source text and the rules that it is read by.
#[derive(Clone, Copy, Debug)]
pub(super) struct SourceText<'u> {
    pub(super) unit: &'u SourceUnit<'u>,
    pub(super) text: &'u str,
    pub(super) lines: &'u LineIndex,
    pub(super) dialect: &'u Dialect,
}

impl<'u> SourceText<'u> {
    /// An expression of the tree.
    pub(super) fn expression(&self, id: ExpressionId) -> &'u Expression<'u> {
        &self.unit.expressions[id.0 as usize]
    }

    /// An expression without the parentheses around it.
    pub(super) fn bare(&self, mut id: ExpressionId) -> ExpressionId {
        while let stickler_syntax::tree::ExpressionKind::Parenthesized(inner) = self.expression(id).kind {
            id = inner;
        }
        id
    }

    /// The source text of an expression.
    pub(super) fn text_of(&self, id: ExpressionId) -> &'u str {
        let span = self.expression(id).span;
        self.text
            .get(span.start as usize..span.end as usize)
            .unwrap_or_default()
    }
}

/// All declarations of a source text.
#[derive(Debug)]
pub(super) struct Model<'u> {
    pub(super) source: SourceText<'u>,
    pub(super) types: TypeTable,
    pub(super) namespaces: Namespaces<'u>,
    /// Types and program organization units by their namespaces and names.
    pub(super) definitions: FxHashMap<(NamespaceId, CaseFolded<'u>), TopLevelName>,
    /// The types of [`TopLevelName::Type`].
    pub(super) declared_types: Vec<TypeId>,
    pub(super) pous: Vec<PouEntry<'u>>,
    /// All variables; those of one POU stand together.
    pub(super) variables: Vec<DeclaredVariable<'u>>,
    /// Global variables by name: indices into `variables`.
    pub(super) globals: Scope<'u, u32>,
    /// The values of enumerations that have a name.
    pub(super) enumerated: Scope<'u, EnumeratedName>,
    /// Routines that give the variables of a type their default value.
    pub(super) initial_values: Vec<InitialRoutine<'u>>,
    /// The starts of initial values that are passed over because their type needs a later edition.
    pub(super) passed_over: FxHashSet<u32>,
    /// The program instances in the order in which they run.
    pub(super) instances: Vec<Instance<'u>>,
    /// The instance that the name of a program means, among [`Self::instances`], by its index into [`Self::pous`].
    pub(super) called_programs: FxHashMap<u32, usize>,
    /// The initial values that VAR_CONFIG sections give.
    pub(super) configured: Vec<ConfiguredValue<'u>>,
    /// The number of routines that have been given out.
    pub(super) routines: RoutineId,
    /// Whether any POU has methods or properties.
    pub(super) has_members: bool,
}

/// The message about a name that several namespaces behind USING declare, behind the name.
pub(super) const SEVERAL_NAMESPACES: &str =
    "is declared in several namespaces behind USING; a qualified name tells which one is meant";

/// The meaning of a name at the top level.
#[derive(Clone, Copy, Debug)]
pub(super) enum TopLevelName {
    /// A type: an index into [`Model::declared_types`].
    Type(u32),
    /// A program organization unit: an index into [`Model::pous`].
    Pou(u32),
}

/// A program organization unit.
#[derive(Debug)]
pub(super) struct PouEntry<'u> {
    /// The declaration.
    pub(super) pou: &'u Pou<'u>,
    /// The node of a function block in the order of types.
    pub(super) node: Option<usize>,
    /// The variables among [`Model::variables`].
    pub(super) variables: Range<u32>,
    /// The variables by name, the result of a function among them.
    pub(super) scope: Scope<'u, u32>,
    /// The values of enumerations that are declared with its variables.
    pub(super) enumerated: Scope<'u, EnumeratedName>,
    /// The variable that holds a function's result.
    pub(super) result: Option<u32>,
    /// VAR_INPUT and VAR_IN_OUT in order.
    pub(super) parameters: Vec<u32>,
    /// The parameters that a call gives by position: the same, and in some dialects VAR_OUTPUT among them.
    pub(super) positional: Vec<u32>,
    /// The number of those that a call by position must give.
    pub(super) required: usize,
    /// Whether a call may give more arguments by position than these: `args : ...`.
    pub(super) takes_more: bool,
    /// The type of a function block or program, whose members its variables are.
    pub(super) ty: TypeId,
    /// The body.
    pub(super) body: RoutineId,
    /// Gives an instance its initial values; for a function, its inputs their defaults.
    pub(super) initial: RoutineId,
    /// The cells that a function clears at each call.
    pub(super) cleared: Range<u32>,
    /// The POU that a method or a part of a property is a member of.
    pub(super) owner: Option<u32>,
    /// The function block or class behind EXTENDS of a function block or class.
    pub(super) base: Option<u32>,
    /// The interfaces that a function block or class implements, or that an interface extends.
    pub(super) interfaces: Vec<u32>,
    /// The number of types that the POU extends and implements, directly and indirectly.
    pub(super) ancestors: u32,
    /// The methods and properties that the POU declares itself, by name; inherited ones are found by [`Model::member`].
    pub(super) members: Scope<'u, Member>,
    /// Whether the first cell of an instance holds the number of its type, by which its methods are found.
    pub(super) has_type_number: bool,
    /// The shared frame and the routine by which a member is called through a base or an interface; `None` for a member that has one
    /// implementation only, and is called directly.
    pub(super) dispatch: Option<Dispatch>,
    /// Whether a member has another one in a derived block.
    pub(super) is_overridden: bool,
    /// Whether the POU is only the frame of a [`Dispatch`].
    pub(super) is_frame: bool,
}

/// A method or a property: the indices of its parts among [`Model::pous`].
#[derive(Clone, Copy, Default, Debug)]
pub(super) struct Member {
    /// A method.
    pub(super) method: Option<u32>,
    /// GET of a property.
    pub(super) getter: Option<u32>,
    /// SET of a property.
    pub(super) setter: Option<u32>,
}

impl Member {
    /// The parts of the member, each at its place.
    pub(super) fn parts(self) -> [Option<u32>; 3] {
        [self.method, self.getter, self.setter]
    }
}

/// The parts of a call of a method that the running program chooses by the type of the instance.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dispatch {
    /// The member without a body through whose variables arguments and results are passed.
    pub(super) frame: u32,
    /// The routine that passes them to and from the member's own.
    pub(super) routine: RoutineId,
}

impl PouEntry<'_> {
    /// Returns whether a member has statements, be they none: it is not ABSTRACT, and of no interface.
    pub(super) fn has_body(&self, model: &Model<'_>) -> bool {
        let owner = self.owner.map(|owner| model.pous[owner as usize].pou.kind);
        !self.is_frame && !self.pou.modifiers.is_abstract && owner != Some(PouKind::Interface)
    }

    /// Returns whether the POU is a function or a member, whose variables lie in a frame of its own.
    pub(super) fn is_function(&self) -> bool {
        self.pou.kind == PouKind::Function || self.pou.kind.is_member()
    }
}

/// A variable.
#[derive(Clone, Debug)]
pub(super) struct DeclaredVariable<'u> {
    /// The name.
    pub(super) name: Name<'u>,
    /// The declared type.
    pub(super) ty: TypeId,
    /// The section; VAR_IN_OUT for every ARRAY[*], which is passed by its address.
    pub(super) kind: VariableKind,
    /// The section as it is written.
    pub(super) section: VariableKind,
    /// The number of cells behind the address of an ARRAY[*]: the lowest and the highest subscript and the stride of each dimension.
    pub(super) limits: u32,
    /// Whether the variable is a CONSTANT.
    pub(super) constant: bool,
    /// Whether it stands in a section that is PUBLIC or INTERNAL.
    pub(super) is_public: bool,
    /// The edge qualifier of an input, behind which stand what the body sees in its place, and its value in the call before.
    pub(super) edge: Option<Edge>,
    /// The location.
    pub(super) storage: Storage,
    /// The initial value.
    pub(super) initializer: Option<&'u Initializer<'u>>,
    /// Whether the variable shares the initial value with a variable before it, whose errors are not reported twice.
    pub(super) repeated: bool,
    /// The meaning of its name in a constant expression.
    pub(super) value: Constant,
}

impl<'u> DeclaredVariable<'u> {
    /// Returns a variable without an initial value, which has no location yet.
    pub(super) fn new(name: Name<'u>, ty: TypeId, kind: VariableKind) -> DeclaredVariable<'u> {
        DeclaredVariable {
            name,
            ty,
            kind,
            section: kind,
            limits: 0,
            constant: false,
            is_public: false,
            edge: None,
            storage: Storage::Absolute(0),
            initializer: None,
            repeated: false,
            value: Constant::Variable,
        }
    }

    /// Adds what the section and the declaration of a variable say of it.
    pub(super) fn declared(self, block: &VariableBlock<'u>, group: &'u VariableGroup<'u>) -> Self {
        DeclaredVariable {
            constant: block.constant,
            is_public: matches!(block.access, Some(Access::Public | Access::Internal)),
            initializer: group.initializer.as_ref(),
            repeated: group
                .names
                .first()
                .is_none_or(|first| first.span != self.name.span),
            ..self
        }
    }
}

/// The location of a variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Storage {
    /// At an address.
    Absolute(u32),
    /// Behind the address of the instance.
    Instance(u32),
    /// The address in the cell at an address (VAR_IN_OUT of a function); the limits of an ARRAY[*] lie in the cells behind it.
    AbsolutePointer(u32),
    /// The address in a cell of the instance (VAR_IN_OUT of a function block).
    InstancePointer(u32),
}

/// An enumerated value without its type's name in front.
#[derive(Clone, Copy, Debug)]
pub(super) enum EnumeratedName {
    /// The value of one enumeration.
    One(TypeId, i64),
    /// The value of more than one enumeration.
    Several,
}

/// A routine that gives a variable, which is its instance, the default value of its type.
#[derive(Clone, Copy, Debug)]
pub(super) struct InitialRoutine<'u> {
    pub(super) routine: RoutineId,
    pub(super) value: DefaultInitialValue<'u>,
    /// The POU with whose variables the type is declared, if it is; of these only constants are known there.
    pub(super) pou: Option<u32>,
}

/// The default value of the variables of a type.
#[derive(Clone, Copy, Debug)]
pub(super) enum DefaultInitialValue<'u> {
    /// The elements of a structure, each its own.
    Structure(TypeId, &'u [VariableGroup<'u>]),
    /// Every element of an array the default of its type.
    Elements(TypeId),
    /// The value that a declaration writes; the type is the one that it gives a name, with that type's own default.
    Declared(TypeId, &'u Initializer<'u>),
}

/// A program that runs once a scan, or that others call.
#[derive(Clone, Copy, Debug)]
pub(super) struct Instance<'u> {
    /// The name; where there is no CONFIGURATION, the program's own.
    pub(super) name: &'u str,
    /// The program.
    pub(super) pou: u32,
    /// The address of its variables.
    pub(super) base: u32,
    /// Whether it runs without being called.
    pub(super) runs: bool,
}

/// An initial value that a VAR_CONFIG gives to a variable of a program instance.
#[derive(Clone, Copy, Debug)]
pub(super) struct ConfiguredValue<'u> {
    /// The index of the program instance.
    pub(super) instance: usize,
    /// The distance of the variable from the address of the instance.
    pub(super) offset: u32,
    /// The type of the variable.
    pub(super) ty: TypeId,
    /// The initial value.
    pub(super) initializer: &'u Initializer<'u>,
}

impl<'u> Model<'u> {
    /// Finds the type or program organization unit that a name means where it stands.
    pub(super) fn meaning(&self, name: Name<'_>) -> Meaning<TopLevelName> {
        let get = |namespace, name: &str| self.definitions.get(&(namespace, CaseFolded(name))).copied();
        self.namespaces.find(name, get)
    }

    /// Returns the type or program organization unit that a name means where it stands.
    pub(super) fn definition(&self, name: Name<'_>) -> Option<TopLevelName> {
        self.meaning(name).one()
    }

    /// Returns whether functions have no body in the text, as `{external}` before them says.
    pub(super) fn has_external_functions(&self) -> bool {
        let is_external = |entry: &PouEntry<'_>| {
            let before = self
                .source
                .text
                .get(..entry.pou.span.start as usize)
                .unwrap_or("");
            before.trim_end().ends_with("{external}")
        };
        self.source.dialect.external_functions && self.pous.iter().any(is_external)
    }

    /// Returns the function of `library` that TIME() or LTIME() calls.
    pub(super) fn clock_function(&self, name: &str) -> Option<TopLevelName> {
        let own = ["TIME", "LTIME"]
            .iter()
            .find(|ty| name.eq_ignore_ascii_case(ty))?;
        let own = format!("STICKLER_{own}");
        self.definitions.get(&(0, CaseFolded(&own))).copied()
    }

    /// A variable.
    pub(super) fn variable(&self, index: u32) -> &DeclaredVariable<'u> {
        &self.variables[index as usize]
    }

    /// Finds the method or property of a name in a POU, or in those above it.
    pub(super) fn member(&self, pou: u32, name: &str) -> Option<Member> {
        let mut waiting = vec![pou];
        let mut found: Option<Member> = None;
        while let Some(next) = waiting.pop() {
            let entry = &self.pous[next as usize];
            if let Some(&member) = entry.members.get(&CaseFolded(name)) {
                // Of a property, GET and SET are inherited one by one.
                let nearest = found.get_or_insert(member);
                nearest.getter = nearest.getter.or(member.getter);
                nearest.setter = nearest.setter.or(member.setter);
                if nearest.method.is_some() || nearest.getter.is_some() && nearest.setter.is_some() {
                    return found;
                }
            }
            if entry.pou.kind == PouKind::Interface || entry.pou.modifiers.is_abstract {
                waiting.extend(&entry.interfaces);
            }
            // What is inherited comes before what is only promised.
            waiting.extend(entry.base);
        }
        found
    }

    /// Returns whether a POU is another one, or extends it.
    pub(super) fn extends(&self, pou: u32, other: u32) -> bool {
        let other = &self.pous[other as usize];
        self.levels(pou).iter().any(|level| std::ptr::eq(*level, other))
    }

    /// Returns a POU and those that it extends, itself the last.
    pub(super) fn levels(&self, pou: u32) -> Vec<&PouEntry<'u>> {
        let mut levels = vec![&self.pous[pou as usize]];
        while let Some(base) = levels[levels.len() - 1].base {
            levels.push(&self.pous[base as usize]);
        }
        levels.reverse();
        levels
    }

    /// The elementary type that values of a declared type have.
    pub(super) fn elementary(&self, ty: TypeId) -> Option<ElementaryType> {
        self.types.value_type(ty).elementary()
    }
}
