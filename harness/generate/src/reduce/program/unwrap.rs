//! Variables that are arrays or structures, replaced by one element or one field; fields that nothing reads, dropped.

use super::usage::{instance_of, variable_type};
use super::walk::{Visitor, walk_place, walk_program, walk_statement, walk_variable};
use crate::model::{
    Declared, Initial, Place, Program, Section, Selector, Statement, StatementKind, Type, Unit, Variable,
    VariableId,
};
use crate::reduce::Sites;
use std::collections::{HashMap, HashSet};

/// Makes a variable of the elements' type of an array of which every use has subscripts, and one of the field's type of a
/// structure of which only one field is used.
pub(super) fn unwrap_variables(program: &mut Program, sites: &mut Sites) {
    let mut heads = Heads {
        heads: HashMap::new(),
        unit: Unit::Main,
    };
    walk_program(&mut heads, &mut program.clone());
    let mut unwrapped = Vec::new();
    for (unit, variables) in units(program) {
        for (index, variable) in variables.iter().enumerate() {
            let at = (unit, VariableId(index));
            let local = matches!(variable.section, Section::Local | Section::Constant);
            if let (true, Some(head)) = (local, heads.heads.get(&at))
                && let Some(ty) = inside(program, &variable.ty, *head)
                && sites.here()
            {
                unwrapped.push((at, *head, ty));
            }
        }
    }
    let places = unwrapped.iter().map(|(at, ..)| *at).collect();
    for ((unit, variable), head, ty) in unwrapped {
        let meant = program.unaliased(&ty).clone();
        if let Some(variable) = variable_mut(program, unit, variable) {
            unwrap(variable, head, ty, &meant);
        }
    }
    let unit = Unit::Main;
    walk_program(&mut Shorten { places, unit }, program);
}

/// Gives a variable the type of its part, and the part of its initial value; `meant` is what that type stands for.
fn unwrap(variable: &mut Variable, head: Head, ty: Type, meant: &Type) {
    let part = match (variable.initial.take(), head) {
        (Some(Initial::Array(values)), _) => values.into_iter().next(),
        (Some(Initial::Structure(fields)), Head::Field(field)) => fields
            .into_iter()
            .find(|(which, _)| *which == field)
            .map(|(_, value)| value),
        _ => None,
    };
    // What is no single value any more, as an array in an array, starts as its type does.
    variable.initial = part.filter(|value| value.ty == *meant).map(Initial::Expression);
    if variable.initial.is_none() {
        variable.section = Section::Local;
    }
    variable.ty = ty;
}

fn variable_mut(program: &mut Program, unit: Unit, variable: VariableId) -> Option<&mut Variable> {
    let variables = match unit {
        Unit::Main => &mut program.main.variables,
        Unit::Function(index) => &mut program.functions.get_mut(index)?.variables,
        Unit::Block(index) => &mut program.blocks.get_mut(index)?.variables,
        Unit::Types => return None,
    };
    variables.get_mut(variable.0)
}

/// The units that declare variables, and those.
fn units(program: &Program) -> impl Iterator<Item = (Unit, &[Variable])> {
    let main = [(Unit::Main, program.main.variables.as_slice())];
    let functions = program.functions.iter().enumerate();
    let blocks = program.blocks.iter().enumerate();
    main.into_iter()
        .chain(functions.map(|(index, one)| (Unit::Function(index), one.variables.as_slice())))
        .chain(blocks.map(|(index, one)| (Unit::Block(index), one.variables.as_slice())))
}

/// How all places of a variable begin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Head {
    /// With subscripts.
    Index,
    /// With this field.
    Field(usize),
    /// Some in one way, some in another, or one with nothing.
    Mixed,
}

/// The type of what the first step of every place selects.
pub(super) fn inside(program: &Program, ty: &Type, head: Head) -> Option<Type> {
    match (head, program.unaliased(ty)) {
        (Head::Index, Type::Array(array)) => Some(array.element.clone()),
        (Head::Field(field), ty) => program.fields(ty)?.get(field).map(|(_, ty, _)| ty.clone()),
        _ => None,
    }
}

struct Heads {
    heads: HashMap<(Unit, VariableId), Head>,
    unit: Unit,
}

impl Visitor for Heads {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn statement(&mut self, statement: &mut Statement) {
        if let StatementKind::For { variable, .. } = &statement.kind {
            self.heads.insert((self.unit, *variable), Head::Mixed);
        }
        walk_statement(self, statement);
    }

    fn place(&mut self, place: &mut Place) {
        let head = match place.path.first() {
            Some(Selector::Index(_)) => Head::Index,
            Some(Selector::Field(field)) => Head::Field(*field),
            Some(Selector::Output(_)) | None => Head::Mixed,
        };
        let known = self.heads.entry((self.unit, place.variable)).or_insert(head);
        if *known != head {
            *known = Head::Mixed;
        }
        walk_place(self, place);
    }
}

/// Takes the first step off the places of some variables.
struct Shorten {
    places: HashSet<(Unit, VariableId)>,
    unit: Unit,
}

impl Visitor for Shorten {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn place(&mut self, place: &mut Place) {
        if self.places.contains(&(self.unit, place.variable)) && !place.path.is_empty() {
            place.path.remove(0);
        }
        walk_place(self, place);
    }
}

/// Drops fields of structures that no place names; each keeps one.
pub(super) fn drop_fields(program: &mut Program, sites: &mut Sites) {
    let before = program.clone();
    let mut kept: Vec<Vec<bool>> = before
        .types
        .iter()
        .map(|one| vec![false; field_count(&one.kind)])
        .collect();
    let mut fields = Fields {
        program: &before,
        unit: Unit::Main,
        each: &mut |structure, field| {
            if let Some(kept) = kept.get_mut(structure).and_then(|kept| kept.get_mut(*field)) {
                *kept = true;
            }
        },
    };
    walk_program(&mut fields, program);
    for kept in &mut kept {
        let mut left = kept.len();
        for kept in kept.iter_mut().filter(|kept| !**kept) {
            *kept = left == 1 || !sites.here();
            left -= usize::from(!*kept);
        }
    }
    let mut renumber = Fields {
        program: &before,
        unit: Unit::Main,
        each: &mut |structure, field| {
            let kept = kept.get(structure).map_or(&[][..], Vec::as_slice);
            *field = kept.iter().take(*field).filter(|kept| **kept).count();
        },
    };
    walk_program(&mut renumber, program);
    for (declaration, kept) in program.types.iter_mut().zip(&kept) {
        if let Declared::Structure(fields) = &mut declaration.kind {
            let mut kept = kept.iter();
            fields.retain(|_| kept.next().copied().unwrap_or(true));
        }
    }
}

fn field_count(declared: &Declared) -> usize {
    match declared {
        Declared::Structure(fields) => fields.len(),
        Declared::Enumeration(_) | Declared::Alias(_) => 0,
    }
}

/// Comes by each place at which a field is named by its number, with the place of its structure among the types.
struct Fields<'p> {
    program: &'p Program,
    unit: Unit,
    each: &'p mut dyn FnMut(usize, &mut usize),
}

impl Fields<'_> {
    fn structure(&self, ty: &Type) -> Option<usize> {
        match self.program.unaliased(ty) {
            Type::Declared(index) => Some(*index),
            _ => None,
        }
    }
}

impl Visitor for Fields<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn variable(&mut self, variable: &mut Variable) {
        if let Some(Initial::Structure(fields)) = &mut variable.initial
            && let Some(structure) = self.structure(&variable.ty)
        {
            for (field, _) in fields {
                (self.each)(structure, field);
            }
        }
        walk_variable(self, variable);
    }

    fn place(&mut self, place: &mut Place) {
        let mut ty = variable_type(self.program, self.unit, place.variable).cloned();
        for selector in &mut place.path {
            let Some(outer) = ty.take() else { break };
            ty = match selector {
                Selector::Index(_) => inside(self.program, &outer, Head::Index),
                Selector::Field(field) => {
                    // Its type is that of before it is renumbered.
                    let inner = inside(self.program, &outer, Head::Field(*field));
                    if let Some(structure) = self.structure(&outer) {
                        (self.each)(structure, field);
                    }
                    inner
                }
                Selector::Output(output) => instance_of(self.program, self.unit, place.variable)
                    .and_then(|block| variable_type(self.program, Unit::Block(block), *output).cloned()),
            };
        }
        walk_place(self, place);
    }
}
