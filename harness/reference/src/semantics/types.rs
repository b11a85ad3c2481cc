//! The table of types: elementary ones at fixed places, declared ones behind them.

use super::scope::NamedList;
use crate::instruction::RoutineId;
use rustc_hash::FxHashMap;
use std::sync::LazyLock;
use stickler_syntax::tree::{PointerForm, VariableKind};
use stickler_types::{ElementaryType, join};

/// A type in the [`TypeTable`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct TypeId(u32);

impl TypeId {
    /// The type of what could not be understood: nothing more is said about it.
    pub(super) const ERROR: TypeId = TypeId(ElementaryType::ALL.len() as u32);
    /// The type of NULL, and of the address that ADR and REF give: it goes with every reference and pointer.
    pub(super) const ADDRESS: TypeId = TypeId(TypeId::ERROR.0 + 1);
    /// The type of an output in `library` that a variable of any integer type takes: an INT.
    pub(super) const ANY_INT: TypeId = TypeId(TypeId::ADDRESS.0 + 1);
    /// BOOL.
    pub(super) const BOOL: TypeId = TypeId::of(ElementaryType::Bool);

    /// The place of an elementary type; STRING and WSTRING have their default length there.
    pub(super) const fn of(ty: ElementaryType) -> TypeId {
        TypeId(ty as u32)
    }

    /// The elementary type, where this is one. Aliases, subranges and texts with a length of their own are
    /// not; see [`TypeTable::value_type`].
    pub(super) fn elementary(self) -> Option<ElementaryType> {
        ElementaryType::ALL.get(self.0 as usize).copied()
    }
}

/// The kind of a type.
#[derive(Debug)]
pub(super) enum TypeKind {
    /// A type that is not known.
    Error,
    /// An elementary type that is no text.
    Elementary(ElementaryType),
    /// STRING or WSTRING with a maximum length in code units.
    Text { ty: ElementaryType, capacity: u32 },
    /// Another type under another name.
    Alias,
    /// An integer type with narrower limits.
    Subrange(Subrange),
    /// An enumeration.
    Enumeration(Box<Enumeration>),
    /// An array.
    Array(Box<ArrayShape>),
    /// A structure.
    Structure(Box<Structure>),
    /// A function block or class.
    FunctionBlock(Box<Structure>),
    /// An interface: a value is the address of an instance, or 0.
    Interface(Box<Structure>),
    /// A reference or pointer.
    Pointer(PointerType),
}

/// A reference or pointer.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct PointerType {
    /// The words that make it one.
    pub(super) form: PointerForm,
    /// The type of what it leads to; [`TypeId::ERROR`] until all types are known.
    pub(super) target: TypeId,
}

/// The limits of a subrange.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Subrange {
    /// The integer type whose values it has.
    pub(super) base: ElementaryType,
    /// The lower limit.
    pub(super) low: i128,
    /// The upper limit.
    pub(super) high: i128,
}

/// The values of an enumeration.
#[derive(Debug)]
pub(super) struct Enumeration {
    /// The name, or the name of the variable that it is declared with.
    pub(super) name: Box<str>,
    /// The values and their numbers.
    pub(super) values: NamedList<i64>,
}

/// The element and the limits of an array.
#[derive(Debug)]
pub(super) struct ArrayShape {
    /// The elements' type.
    pub(super) element: TypeId,
    /// The dimensions, the first varying slowest; of an ARRAY[*] each is [`Dimension::VARIABLE`].
    pub(super) dimensions: Box<[Dimension]>,
    /// The number of elements; 0 of an ARRAY[*].
    pub(super) length: u32,
}

/// One dimension of an array.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) struct Dimension {
    /// The lowest subscript.
    pub(super) low: i64,
    /// The highest subscript.
    pub(super) high: i64,
    /// The number of cells from one element to the next.
    pub(super) stride: u32,
}

impl ArrayShape {
    /// Returns whether only a call says what the limits are: those of its argument.
    pub(super) fn is_variable_length(&self) -> bool {
        self.length == 0
    }

    /// Returns whether the limits are DINT, as LOWER_BOUND gives them, of so few dimensions that each call may pass them all.
    pub(super) fn has_plain_limits(&self) -> bool {
        let is_dint = |limit: i64| i32::try_from(limit).is_ok();
        let mut dimensions = self.dimensions.iter();
        self.dimensions.len() <= 16 && dimensions.all(|limits| is_dint(limits.low) && is_dint(limits.high))
    }
}

impl Dimension {
    /// A dimension of an ARRAY[*].
    pub(super) const VARIABLE: Dimension = Dimension {
        low: 1,
        high: 0,
        stride: 0,
    };

    /// Returns the number of subscripts. Arrays are bounded, so 32 bits suffice.
    pub(super) fn length(self) -> u32 {
        u32::try_from(self.high.wrapping_sub(self.low).wrapping_add(1)).unwrap_or(0)
    }
}

/// The elements of a structure, or the variables of a function block or program.
#[derive(Debug)]
pub(super) struct Structure {
    /// The name.
    pub(super) name: Box<str>,
    /// The index of the function block or interface among the POUs; without meaning for a structure.
    pub(super) pou: u32,
    /// The type that it extends, whose elements lie before its own.
    pub(super) base: Option<TypeId>,
    /// Whether all elements share the memory: a union, of which each cell holds a byte.
    pub(super) is_union: bool,
    /// The elements, those of the base left out.
    pub(super) members: NamedList<TypeMember>,
}

/// An element of a structure, or a variable of a function block.
#[derive(Clone, Copy, Debug)]
pub(super) struct TypeMember {
    /// The declared type.
    pub(super) ty: TypeId,
    /// The offset of its cells from those of the whole.
    pub(super) offset: u32,
    /// The section that it is declared in; a structure's elements count as VAR.
    pub(super) kind: VariableKind,
    /// Whether the member is a CONSTANT.
    pub(super) constant: bool,
    /// Whether the member stands in a section that is PUBLIC or INTERNAL.
    pub(super) is_public: bool,
}

/// The value that a variable has without an initial value of its own.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum DefaultValue {
    /// All cells 0, all texts empty.
    Zero,
    /// An initial value of this raw form.
    Constant(u64),
    /// The value that this routine makes, run on the variable as its instance.
    Routine(RoutineId),
}

/// A row of the table.
#[derive(Debug)]
struct TypeRow {
    kind: TypeKind,
    /// The type itself, or what an alias in the end stands for.
    root: TypeId,
    extent: Extent,
    /// The name of an alias.
    name: Option<Box<str>>,
}

/// The room that a value of a type takes, and its default.
#[derive(Clone, Copy, Debug)]
pub(super) struct Extent {
    /// The number of cells that a value takes.
    pub(super) size: u32,
    /// The most code units that its texts may have in all.
    pub(super) text_units: u64,
    /// The depth of the types nested in it.
    pub(super) depth: u32,
    /// Whether a function block is part of it.
    pub(super) has_block: bool,
    /// Whether an interface is part of it.
    pub(super) has_interface: bool,
    /// The value without an initial value.
    pub(super) default: DefaultValue,
}

impl Extent {
    /// One cell that is 0 at first.
    pub(super) const PLAIN: Extent = Extent {
        size: 1,
        text_units: 0,
        depth: 0,
        has_block: false,
        has_interface: false,
        default: DefaultValue::Zero,
    };
}

/// The most types that a function block, class or interface extends and implements, directly and indirectly; those that are met on
/// several ways count as often.
pub(super) const MAX_ANCESTORS: u32 = 200;

/// The maximum length of the types STRING and WSTRING; a variable of them may have that of its dialect.
const DEFAULT_CAPACITY: u32 = stickler_types::dialect::DEFAULT_TEXT_LENGTH;

/// Every type of a source text; by default the elementary ones.
#[derive(Default, Debug)]
pub(super) struct TypeTable {
    /// The declared types; before them come the [`BUILT_IN`].
    declared: Vec<TypeRow>,
    texts: FxHashMap<(ElementaryType, u32), TypeId>,
    subranges: FxHashMap<Subrange, TypeId>,
    arrays: FxHashMap<(TypeId, Box<[Dimension]>), TypeId>,
    /// The types that function blocks, classes and interfaces directly extend or implement.
    pub(super) parents: FxHashMap<TypeId, Vec<TypeId>>,
}

/// The elementary types, and behind them [`TypeId::ERROR`], [`TypeId::ADDRESS`] and [`TypeId::ANY_INT`]: the same in every source text.
static BUILT_IN: LazyLock<[TypeRow; ElementaryType::ALL.len() + 3]> = LazyLock::new(|| {
    std::array::from_fn(|index| {
        let (kind, text_units) = match ElementaryType::ALL.get(index) {
            Some(&ty) if ty.is_text() => {
                let capacity = DEFAULT_CAPACITY;
                (TypeKind::Text { ty, capacity }, capacity.into())
            }
            Some(&ty) => (TypeKind::Elementary(ty), 0),
            None if index as u32 == TypeId::ADDRESS.0 => {
                let (form, target) = (PointerForm::RefTo, TypeId::ERROR);
                (TypeKind::Pointer(PointerType { form, target }), 0)
            }
            None if index as u32 == TypeId::ANY_INT.0 => (TypeKind::Alias, 0),
            None => (TypeKind::Error, 0),
        };
        let root = match kind {
            TypeKind::Alias => TypeId::of(ElementaryType::Int),
            _ => TypeId(index as u32),
        };
        TypeRow {
            kind,
            root,
            extent: Extent {
                text_units,
                ..Extent::PLAIN
            },
            name: None,
        }
    })
});

impl TypeTable {
    /// Returns whether a type is another one, or extends or implements it, directly or not.
    pub(super) fn derives(&self, id: TypeId, ancestor: TypeId) -> bool {
        let mut waiting = vec![self.root(id)];
        while let Some(next) = waiting.pop() {
            if next == ancestor {
                return true;
            }
            waiting.extend(self.parents.get(&next).into_iter().flatten());
        }
        false
    }

    /// Returns a type as a structure or function block, if it is one.
    pub(super) fn structure(&self, id: TypeId) -> Option<&Structure> {
        match self.kind(id) {
            TypeKind::Structure(structure) | TypeKind::FunctionBlock(structure) => Some(structure),
            _ => None,
        }
    }

    /// Returns whether a type is a union.
    pub(super) fn is_union(&self, id: TypeId) -> bool {
        self.structure(id).is_some_and(|structure| structure.is_union)
    }

    /// Returns the element or variable of a name, inherited ones among them.
    pub(super) fn member(&self, mut id: TypeId, name: &str) -> Option<&TypeMember> {
        loop {
            let structure = self.structure(id)?;
            let found = structure.members.find(name);
            if found.is_some() {
                return found;
            }
            id = structure.base?;
        }
    }

    /// Returns the member that `x.name` reaches in a variable of a type: any element of a structure, and of a function block its
    /// inputs and outputs, and what is PUBLIC; its other variables are its own.
    ///
    /// Basis: iec-61131-3: 2.5.2 of the second edition (only inputs and outputs are accessible from outside).
    pub(super) fn element(&self, id: TypeId, name: &str) -> Option<&TypeMember> {
        let is_structure = matches!(self.kind(id), TypeKind::Structure(_));
        self.member(id, name).filter(|member| {
            is_structure
                || member.is_public
                || matches!(member.kind, VariableKind::Input | VariableKind::Output)
        })
    }

    /// Adds a type that is equal to no other.
    pub(super) fn add(&mut self, kind: TypeKind, extent: Extent) -> TypeId {
        // A source text of 64 MiB cannot declare 2^32 types.
        let id = TypeId(u32::try_from(BUILT_IN.len() + self.declared.len()).unwrap_or(u32::MAX));
        self.declared.push(TypeRow {
            kind,
            root: id,
            extent,
            name: None,
        });
        id
    }

    /// Gives a reference or pointer type its target.
    pub(super) fn set_target(&mut self, pointer: TypeId, target: TypeId) {
        let row = (pointer.0 as usize).checked_sub(BUILT_IN.len());
        if let Some(TypeRow {
            kind: TypeKind::Pointer(pointer),
            ..
        }) = row.and_then(|row| self.declared.get_mut(row))
        {
            pointer.target = target;
        }
    }

    /// Returns a type as a function block, class or interface, if it is one.
    pub(super) fn object(&self, id: TypeId) -> Option<&Structure> {
        match self.kind(id) {
            TypeKind::FunctionBlock(object) | TypeKind::Interface(object) => Some(object),
            _ => None,
        }
    }

    /// Returns whether a type is an interface.
    pub(super) fn is_interface(&self, id: TypeId) -> bool {
        matches!(self.kind(id), TypeKind::Interface(_))
    }

    /// Returns a type as an array, if it is one.
    pub(super) fn array(&self, id: TypeId) -> Option<&ArrayShape> {
        match self.kind(id) {
            TypeKind::Array(shape) => Some(shape),
            _ => None,
        }
    }

    /// Returns a type as a reference or pointer, if it is one.
    pub(super) fn pointer(&self, id: TypeId) -> Option<PointerType> {
        match self.kind(id) {
            TypeKind::Pointer(pointer) => Some(*pointer),
            _ => None,
        }
    }

    /// Returns the type that a variable has where its name stands: of one that is declared with REFERENCE TO, what it is bound to.
    pub(super) fn named_type(&self, id: TypeId) -> TypeId {
        match self.pointer(id) {
            Some(PointerType {
                form: PointerForm::ReferenceTo,
                target,
            }) => target,
            _ => id,
        }
    }

    /// Returns whether two types are the same: one and its alias, and references, pointers and arrays of the same.
    pub(super) fn is_same(&self, mut one: TypeId, mut other: TypeId) -> bool {
        // A type may be a pointer to itself.
        for _ in 0..50 {
            (one, other) = match (self.kind(one), self.kind(other)) {
                _ if self.root(one) == self.root(other) => return true,
                (TypeKind::Pointer(one), TypeKind::Pointer(other)) if one.form == other.form => {
                    (one.target, other.target)
                }
                (TypeKind::Array(one), TypeKind::Array(other)) if one.dimensions == other.dimensions => {
                    (one.element, other.element)
                }
                _ => return false,
            };
        }
        true
    }

    /// Returns whether a variable of one type may be meant by the address of one of another. Each text variable keeps to its own
    /// length, so that only the kind of text matters.
    pub(super) fn is_same_variable(&self, one: TypeId, other: TypeId) -> bool {
        let is_text = matches!(self.kind(one), TypeKind::Text { .. });
        is_text && self.value_type(one) == self.value_type(other) || self.is_same(one, other)
    }

    /// Returns whether a type is that of an ARRAY[*].
    pub(super) fn is_variable_length(&self, id: TypeId) -> bool {
        matches!(self.kind(id), TypeKind::Array(shape) if shape.is_variable_length())
    }

    /// Returns whether an array may be passed where an ARRAY[*] is expected.
    ///
    /// Basis: iec-61131-3: 6.5.3 of the third edition.
    pub(super) fn fits_variable_length(&self, argument: TypeId, parameter: TypeId) -> bool {
        match (self.kind(argument), self.kind(parameter)) {
            (TypeKind::Array(one), TypeKind::Array(other)) => {
                other.is_variable_length()
                    && one.has_plain_limits()
                    && one.dimensions.len() == other.dimensions.len()
                    && self.is_same(one.element, other.element)
            }
            _ => false,
        }
    }

    /// Adds another name for a type, which may have a default value of its own.
    pub(super) fn add_alias(&mut self, base: TypeId, name: &str, default: DefaultValue) -> TypeId {
        let extent = Extent {
            default,
            ..*self.extent(base)
        };
        let root = self.root(base);
        let id = self.add(TypeKind::Alias, extent);
        if let Some(entry) = self.declared.last_mut() {
            entry.root = root;
            entry.name = Some(name.into());
        }
        id
    }

    /// The text type of this length.
    pub(super) fn text(&mut self, ty: ElementaryType, capacity: u32) -> TypeId {
        match self.texts.get(&(ty, capacity)) {
            Some(&id) => id,
            None if capacity == DEFAULT_CAPACITY => TypeId::of(ty),
            None => {
                let extent = Extent {
                    text_units: capacity.into(),
                    ..Extent::PLAIN
                };
                let id = self.add(TypeKind::Text { ty, capacity }, extent);
                self.texts.insert((ty, capacity), id);
                id
            }
        }
    }

    /// The subrange with these limits.
    pub(super) fn subrange(&mut self, subrange: Subrange) -> TypeId {
        if let Some(&id) = self.subranges.get(&subrange) {
            return id;
        }
        let default = if (subrange.low..=subrange.high).contains(&0) {
            DefaultValue::Zero
        } else {
            DefaultValue::Constant(subrange.base.wrap(subrange.low))
        };
        let extent = Extent {
            default,
            ..Extent::PLAIN
        };
        let id = self.add(TypeKind::Subrange(subrange), extent);
        self.subranges.insert(subrange, id);
        id
    }

    /// The array type with these elements and dimensions, where it is there already.
    pub(super) fn known_array(&self, element: TypeId, dimensions: &[Dimension]) -> Option<TypeId> {
        self.arrays.get(&(element, dimensions.into())).copied()
    }

    /// Adds an array type.
    pub(super) fn add_array(&mut self, shape: ArrayShape, extent: Extent) -> TypeId {
        let key = (shape.element, shape.dimensions.clone());
        let id = self.add(TypeKind::Array(Box::new(shape)), extent);
        self.arrays.insert(key, id);
        id
    }

    fn entry(&self, id: TypeId) -> &TypeRow {
        let index = id.0 as usize;
        BUILT_IN
            .get(index)
            .or_else(|| self.declared.get(index - BUILT_IN.len()))
            .unwrap_or(&BUILT_IN[TypeId::ERROR.0 as usize])
    }

    /// Returns what a type in the end is: never an alias.
    pub(super) fn kind(&self, id: TypeId) -> &TypeKind {
        &self.entry(self.entry(id).root).kind
    }

    /// The type that an alias stands for, or the type itself.
    pub(super) fn root(&self, id: TypeId) -> TypeId {
        self.entry(id).root
    }

    /// Returns whether a type is an alias or a subrange: a user-defined type that takes its values from another.
    pub(super) fn is_derived(&self, id: TypeId) -> bool {
        matches!(self.entry(id).kind, TypeKind::Alias | TypeKind::Subrange(_))
    }

    /// The type that a value has: aliases, subranges and lengths of texts make no difference to it.
    pub(super) fn value_type(&self, id: TypeId) -> TypeId {
        if id.elementary().is_some() {
            return id;
        }
        let root = self.root(id);
        match self.kind(root) {
            TypeKind::Subrange(subrange) => TypeId::of(subrange.base),
            TypeKind::Text { ty, .. } => TypeId::of(*ty),
            _ => root,
        }
    }

    /// Returns the room that a value of the type takes, and its default.
    pub(super) fn extent(&self, id: TypeId) -> &Extent {
        &self.entry(id).extent
    }

    /// Names a type in a message.
    pub(super) fn name(&self, id: TypeId) -> String {
        let entry = self.entry(id);
        if let Some(name) = &entry.name {
            return name.to_string();
        }
        match &entry.kind {
            TypeKind::Error | TypeKind::Alias => "?".to_owned(),
            TypeKind::Elementary(ty) => ty.name().to_owned(),
            TypeKind::Text { ty, capacity } if *capacity == DEFAULT_CAPACITY => ty.name().to_owned(),
            TypeKind::Text { ty, capacity } => format!("{}[{capacity}]", ty.name()),
            TypeKind::Subrange(Subrange { base, low, high }) => format!("{}({low}..{high})", base.name()),
            TypeKind::Enumeration(enumeration) => enumeration.name.to_string(),
            TypeKind::Structure(structure)
            | TypeKind::FunctionBlock(structure)
            | TypeKind::Interface(structure) => structure.name.to_string(),
            TypeKind::Pointer(_) if id == TypeId::ADDRESS => "an address".to_owned(),
            TypeKind::Pointer(pointer) => {
                format!("{} {}", pointer.form.as_str(), self.name(pointer.target))
            }
            TypeKind::Array(shape) => {
                let limits = shape
                    .dimensions
                    .iter()
                    .map(|limit| match shape.is_variable_length() {
                        true => "*".to_owned(),
                        false => format!("{}..{}", limit.low, limit.high),
                    });
                format!("ARRAY[{}] OF {}", join(limits, ", "), self.name(shape.element))
            }
        }
    }
}
