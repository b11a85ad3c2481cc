//! Declarations of types and of variables with their initial values.

use super::TypeContext;
use super::builder::ProgramBuilder;
use super::constructs::Construct;
use super::scope::PouScope;
use crate::model::{
    ArrayType, DeclaredKind, Expression, InitialValue, LiteralForm, Type, TypeDeclaration, Variable,
    VariableId, VariableSection, subscripts,
};
use stickler_types::{ElementaryType, Family};

/// The maximum number of elements of an array of elementary values.
const MAX_ELEMENTS: usize = 8;

/// The maximum number of elements of an array of structures or enumerations.
const MAX_STRUCTURES: usize = 3;

impl ProgramBuilder<'_, '_> {
    /// Declares the types of the program (TYPE … END_TYPE).
    pub fn declare_types(&mut self) {
        if self.has(Construct::Enumerations) {
            for _ in 0..=self.random.below(2) {
                let number = self.program.types.len();
                let names = (0..2 + self.random.below(4)).map(|value| format!("e{number}v{value}"));
                let names = names.collect();
                self.declare_type("Enum", DeclaredKind::Enumeration(names));
            }
        }
        if self.has(Construct::Structures) {
            for _ in 0..=self.random.below(2) {
                let fields = (0..1 + self.random.below(4))
                    .map(|field| self.field(field))
                    .collect();
                self.declare_type("Rec", DeclaredKind::Structure(fields));
            }
        }
        if self.has(Construct::Aliases) && !self.lacks("array") {
            self.declare_alias();
        }
    }

    fn declare_type(&mut self, stem: &str, kind: DeclaredKind) {
        let name = format!("{stem}{}", self.program.types.len());
        self.program.types.push(TypeDeclaration { name, kind });
    }

    fn field(&mut self, number: usize) -> (String, Type, Option<Expression>) {
        let ty = match self.random.weighted(&[6, 1, 1]) {
            1 if self.has(Construct::Arrays) => self.array(),
            2 => self.declared_type(),
            _ => Type::Elementary(self.any_type()),
        };
        // A field has a single initial value, so an array that needs several cannot be a field.
        let ty = match ty {
            Type::Array(array) if is_of_dates(&array) => array.element,
            ty => ty,
        };
        let initial = match ty {
            Type::Elementary(ty) if needs_initial(ty) || self.wants_initial() => {
                Some(self.literal(ty, TypeContext::Initial))
            }
            _ => None,
        };
        (format!("m{number}"), ty, initial)
    }

    /// Declares a name for an array type, so that whole arrays can be assigned. Names for elementary types are declared only
    /// where open constructs are allowed: no document states whether they convert as their types do.
    fn declare_alias(&mut self) {
        let ty = if self.open && !self.lacks("type-alias") && self.random.chance(1, 2) {
            Type::Elementary(self.any_type())
        } else {
            self.array()
        };
        self.declare_type("Alias", DeclaredKind::Alias(ty));
    }

    /// Generates an array type of one to three dimensions.
    fn array(&mut self) -> Type {
        let element = match self.random.weighted(&[6, 1]) {
            1 => self.declared_type(),
            _ => Type::Elementary(self.any_type()),
        };
        let dimensions = 1 + self.random.weighted(&[6, 2, 1]);
        let is_simple = matches!(element, Type::Elementary(_));
        let mut left = if is_simple { MAX_ELEMENTS } else { MAX_STRUCTURES };
        let limits = (0..dimensions).map(|_| {
            let low = [0, 1, -1, 5, -3][self.random.below(5)];
            let length = 1 + self.random.below(left.min(6));
            left /= length;
            (low, low + length as i64 - 1)
        });
        let dimensions = limits.collect();
        Type::Array(Box::new(ArrayType { dimensions, element }))
    }

    /// Picks a declared enumeration or structure; an elementary type if there is none. Only small structures are picked, so
    /// that no variable has hundreds of parts.
    fn declared_type(&mut self) -> Type {
        let is_small = |kind: &DeclaredKind| match kind {
            DeclaredKind::Enumeration(_) => true,
            DeclaredKind::Structure(fields) => {
                fields.iter().all(|(_, ty, _)| matches!(ty, Type::Elementary(_)))
            }
            DeclaredKind::Alias(_) => false,
        };
        let types = self.program.types.iter().enumerate();
        let small: Vec<usize> = types
            .filter(|(_, declared)| is_small(&declared.kind))
            .map(|(place, _)| place)
            .collect();
        match self.random.pick(&small) {
            Some(&declared) => Type::Declared(declared),
            None => Type::Elementary(self.any_type()),
        }
    }

    /// Declares the variables of main: some of every kind of type in the program, and an instance of every function block.
    pub fn main_variables(&mut self) {
        // One of each type at least, so that every value can be read from and written to a variable.
        for ty in self.palette.clone() {
            self.declare_local(Type::Elementary(ty));
        }
        let locals = 1 + self.random.below(5);
        self.locals(locals);
        for block in 0..self.program.blocks.len() {
            for _ in 0..=self.random.below(2) {
                self.declare_instance(block);
            }
        }
    }

    /// Declares so many local variables of any types.
    pub fn locals(&mut self, count: usize) {
        for _ in 0..count {
            let ty = self.variable_type();
            self.declare_local(ty);
        }
    }

    /// Picks a type for a variable: an array, a declared type or an elementary type.
    pub fn variable_type(&mut self) -> Type {
        match self.random.weighted(&[7, 2, 2]) {
            1 if self.has(Construct::Arrays) => self.array(),
            2 if !self.program.types.is_empty() => {
                Type::Declared(self.random.below(self.program.types.len()))
            }
            _ => Type::Elementary(self.any_type()),
        }
    }

    /// Picks an elementary type or an enumeration, for parameters.
    pub fn small_type(&mut self) -> Type {
        let is_enumeration =
            |place: &usize| matches!(self.program.types[*place].kind, DeclaredKind::Enumeration(_));
        let enumerations: Vec<usize> = (0..self.program.types.len()).filter(is_enumeration).collect();
        match self.random.weighted(&[5, 1]) {
            1 if !enumerations.is_empty() => {
                Type::Declared(enumerations[self.random.below(enumerations.len())])
            }
            _ => Type::Elementary(self.any_type()),
        }
    }

    /// Declares a local variable or a constant.
    pub fn declare_local(&mut self, ty: Type) -> VariableId {
        let initial = self.initial(&ty);
        let may_be_constant =
            self.has(Construct::Constants) && matches!(ty, Type::Elementary(_)) && initial.is_some();
        if may_be_constant && self.random.chance(1, 4) {
            return self.declare_variable("c", ty, VariableSection::Constant, initial);
        }
        self.declare_variable("v", ty, VariableSection::Local, initial)
    }

    /// Declares a variable in a section.
    pub fn declare_variable(
        &mut self,
        stem: &str,
        ty: Type,
        section: VariableSection,
        initial: Option<InitialValue>,
    ) -> VariableId {
        let name = format!("{stem}{}", self.pou.variables.len());
        let variable = Variable {
            name,
            ty,
            section,
            initial,
        };
        self.pou.declare(variable, &self.program)
    }

    pub fn declare_instance(&mut self, block: usize) {
        self.declare_variable("inst", Type::Block(block), VariableSection::Local, None);
    }

    fn wants_initial(&mut self) -> bool {
        self.has(Construct::Initials) && self.random.chance(3, 4)
    }

    /// Generates an initial value; `None` if the variable keeps the default of its type.
    pub fn initial(&mut self, ty: &Type) -> Option<InitialValue> {
        let ty = self.program.unaliased(ty).clone();
        let needed = match &ty {
            Type::Elementary(ty) => needs_initial(*ty),
            Type::Array(array) => is_of_dates(array),
            _ => false,
        };
        if !needed && !self.wants_initial() {
            return None;
        }
        match ty {
            Type::Elementary(ty) => Some(InitialValue::Expression(self.initial_value(ty))),
            Type::Array(array) => match array.element {
                Type::Elementary(ty) => {
                    let values = (0..subscripts(&array.dimensions).len())
                        .map(|_| self.literal(ty, TypeContext::Initial));
                    Some(InitialValue::Array(values.collect()))
                }
                _ => None,
            },
            ty => match self.program.enumerated_values(&ty).map(<[String]>::len) {
                Some(count) => {
                    let value = self.random.below(count);
                    Some(InitialValue::Expression(Expression::enumerated(&ty, value)))
                }
                None => self.initial_structure(&ty),
            },
        }
    }

    /// Generates values of some of the elementary fields of a structure.
    fn initial_structure(&mut self, ty: &Type) -> Option<InitialValue> {
        let fields = self.program.fields(ty)?.iter().enumerate();
        let elementary_fields: Vec<(usize, ElementaryType)> = fields
            .filter_map(|(field, (_, ty, _))| match ty {
                Type::Elementary(ty) => Some((field, *ty)),
                _ => None,
            })
            .collect();
        let mut values = Vec::new();
        for (field, ty) in elementary_fields {
            if values.is_empty() || self.random.chance(2, 3) {
                values.push((field, self.literal(ty, TypeContext::Initial)));
            }
        }
        (!values.is_empty()).then_some(InitialValue::Structure(values))
    }

    /// Generates a literal of the type, or of a type that widens to it.
    fn initial_value(&mut self, ty: ElementaryType) -> Expression {
        let sources = self.profile.sources(ty);
        if self.has(Construct::Widening) && !sources.is_empty() && self.random.chance(1, 4) {
            let from = self.random.pick(sources).copied().unwrap_or(ty);
            let value = self.drawn(from);
            let literal = Expression::literal(from, value, LiteralForm::Typed);
            return Expression::widened(Type::Elementary(ty), literal);
        }
        self.literal(ty, TypeContext::Initial)
    }

    /// Starts a POU that may get `statements` statements.
    pub fn begin(&mut self, statements: usize) {
        self.pou = PouScope::new();
        self.statements_left = statements;
    }
}

/// Returns whether a variable of a type needs an initial value: no document states on which day dates begin.
fn needs_initial(ty: ElementaryType) -> bool {
    matches!(ty.family(), Family::Date | Family::DateAndTime)
}

fn is_of_dates(array: &ArrayType) -> bool {
    matches!(array.element, Type::Elementary(ty) if needs_initial(ty))
}
