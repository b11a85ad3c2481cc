//! Lookups that every reader of a program needs: resolved aliases, fields of structures, observed values.

use super::{
    DeclaredKind, Expression, PlaceSelector, Pou, Program, Type, Unit, Variable, VariableId, VariableSection,
};
use stickler_types::{ElementaryType, join};

impl Program {
    /// Returns the type that an alias stands for; any other type itself.
    pub fn unaliased<'t>(&'t self, ty: &'t Type) -> &'t Type {
        match self.definition(ty) {
            Some(DeclaredKind::Alias(of)) => of,
            _ => ty,
        }
    }

    fn definition(&self, ty: &Type) -> Option<&DeclaredKind> {
        let Type::Declared(declared) = ty else { return None };
        Some(&self.types.get(*declared)?.kind)
    }

    /// Returns the fields of a structure, each with its name, type and initial value; `None` for any other type.
    pub fn fields(&self, ty: &Type) -> Option<&[(String, Type, Option<Expression>)]> {
        match self.definition(ty)? {
            DeclaredKind::Structure(fields) => Some(fields),
            _ => None,
        }
    }

    /// Returns the names of the values of an enumeration; `None` for any other type.
    pub fn enumerated_values(&self, ty: &Type) -> Option<&[String]> {
        match self.definition(ty)? {
            DeclaredKind::Enumeration(names) => Some(names),
            _ => None,
        }
    }

    /// Returns the type of the part of `ty` that a selector selects; `None` if the type has no such part.
    pub fn selected_type<'t>(&'t self, ty: &'t Type, selector: &PlaceSelector) -> Option<&'t Type> {
        match (selector, self.unaliased(ty)) {
            (PlaceSelector::Index(_), Type::Array(array)) => Some(&array.element),
            (PlaceSelector::Field(field), ty) => self.fields(ty)?.get(*field).map(|(_, ty, _)| ty),
            (PlaceSelector::Followed, Type::Reference(ty)) => Some(ty),
            (PlaceSelector::Output(output), Type::Block(block)) => {
                let output = Unit::Block(*block).variables(self).get(output.0)?;
                Some(&output.ty)
            }
            _ => None,
        }
    }

    /// Returns the parts that a type directly consists of, each with its name and its type: the elements of an array at once and without
    /// a name, the fields of a structure, what a reference leads to, or the outputs of a function block, which alone every compiler lets its environment
    /// read.
    pub fn parts<'t>(&'t self, ty: &'t Type) -> Vec<(PathStep, &'t str, &'t Type)> {
        match self.unaliased(ty) {
            Type::Elementary(_) => Vec::new(),
            Type::Reference(ty) => vec![(PathStep::Followed, "", ty)],
            Type::Array(array) => vec![(PathStep::Index(array.dimensions.clone()), "", &array.element)],
            ty @ Type::Declared(_) => {
                let fields = self.fields(ty).unwrap_or_default().iter().enumerate();
                fields
                    .map(|(field, (name, ty, _))| (PathStep::Field(field), &**name, ty))
                    .collect()
            }
            Type::Block(block) => {
                let variables = Unit::Block(*block).variables(self).iter().enumerate();
                let outputs = variables.filter(|(_, variable)| variable.section == VariableSection::Output);
                outputs
                    .map(|(number, output)| (PathStep::Output(VariableId(number)), &*output.name, &output.ty))
                    .collect()
            }
        }
    }

    /// Returns the path and the type of each elementary value in the variables of main, checksums included, in the order of
    /// the declarations. In arrays the last subscript varies fastest; there are no blanks in `a[1,2]`.
    ///
    /// An instance of a function block contributes its outputs, which every compiler lets its environment read. Enumerations
    /// are omitted because they have no elementary type; they enter the checksum.
    pub fn observed(&self) -> Vec<(String, ElementaryType)> {
        let parts = self.observed_parts().into_iter();
        parts.map(|part| (part.path, part.ty)).collect()
    }

    /// Returns the parts of the variables of main that [`Program::observed`] names.
    pub(crate) fn observed_parts(&self) -> Vec<ObservedPart> {
        let mut found = Vec::new();
        for (number, variable) in self.main.variables.iter().enumerate() {
            self.observe((&variable.name, &[number]), &variable.ty, &mut found);
        }
        found
    }

    fn observe(&self, (path, numbers): (&str, &[usize]), ty: &Type, found: &mut Vec<ObservedPart>) {
        if let Type::Elementary(ty) = self.unaliased(ty) {
            return found.push(ObservedPart {
                path: path.to_owned(),
                ty: *ty,
                numbers: numbers.to_vec(),
            });
        }
        for (step, name, ty) in self.parts(ty) {
            let inside = match step {
                PathStep::Index(limits) => {
                    let texts = subscripts(&limits).into_iter();
                    let texts = texts.map(|subscripts| format!("[{}]", join(&subscripts, ",")));
                    texts.zip(0..).collect()
                }
                PathStep::Field(number) | PathStep::Output(VariableId(number)) => {
                    vec![(format!(".{name}"), number)]
                }
                // What it leads to is observed itself.
                PathStep::Followed => Vec::new(),
            };
            for (name, number) in inside {
                let numbers = [numbers, &[number]].concat();
                self.observe((&format!("{path}{name}"), &numbers), ty, found);
            }
        }
    }
}

/// A step from a variable to a part of it, before its subscripts are chosen.
#[derive(Clone, PartialEq, Debug)]
pub enum PathStep {
    /// To the elements of an array, by the limits of its dimensions.
    Index(Vec<(i64, i64)>),
    /// To a field of a structure.
    Field(usize),
    /// To an output of a function block instance.
    Output(VariableId),
    /// To what a reference leads to.
    Followed,
}

/// An elementary value in a variable of main.
pub(crate) struct ObservedPart {
    /// The variable with its fields, subscripts and outputs, as [`Program::observed`] writes them.
    pub path: String,
    /// The type of the value.
    pub ty: ElementaryType,
    /// The number of the variable, then that of the field, element or output, and so on.
    pub numbers: Vec<usize>,
}

impl Pou {
    /// Declares a variable after all others.
    pub fn declare(&mut self, variable: Variable) -> VariableId {
        self.variables.push(variable);
        VariableId(self.variables.len() - 1)
    }

    /// Returns the inputs of a function with their indices, in the order of a positional call.
    pub fn inputs(&self) -> impl Iterator<Item = (VariableId, &Variable)> {
        let variables = self.variables.iter().enumerate();
        variables
            .filter(|(_, variable)| variable.section == VariableSection::Input)
            .map(|(place, variable)| (VariableId(place), variable))
    }
}

/// Returns a variable that is an instance of a function block; `None` where none of these is.
pub fn instance_of(variables: &[Variable], block: usize) -> Option<&Variable> {
    let mut variables = variables.iter();
    variables.find(|variable| variable.ty == Type::Block(block))
}

/// Returns the subscripts of every element of an array with these dimensions, the last subscript varying fastest.
pub fn subscripts(dimensions: &[(i64, i64)]) -> Vec<Vec<i64>> {
    let mut all = vec![Vec::new()];
    for &(low, high) in dimensions {
        all = all
            .into_iter()
            .flat_map(|before| {
                (low..=high).map(move |next| {
                    let mut subscripts = before.clone();
                    subscripts.push(next);
                    subscripts
                })
            })
            .collect();
    }
    all
}
