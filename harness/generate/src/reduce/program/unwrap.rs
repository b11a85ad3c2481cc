//! Passes that replace array and structure variables by one element or field, and drop unused fields.

use super::usage::variable_type;
use crate::model::visit::{self, Visitor};
use crate::model::visit_mut::{self, VisitorMut};
use crate::model::{
    DeclaredKind, InitialValue, Place, PlaceSelector, Program, Statement, StatementKind, Type, Unit,
    Variable, VariableId, VariableSection,
};
use std::collections::{HashMap, HashSet};
use stickler_reduce::Sites;

/// Gives the element type to an array variable whose every use has subscripts, and the field type to a structure variable of
/// which only one field is used.
pub(super) fn unwrap_variables(program: &mut Program, sites: &mut Sites) {
    let mut heads = Heads {
        heads: HashMap::new(),
        unit: Unit::Main,
    };
    visit::walk_program(&mut heads, program);
    let mut unwrapped = Vec::new();
    let mut units = Unit::all(program);
    // Main first: a reduction spends most of its time there.
    units.rotate_right(1);
    for unit in units {
        for (index, variable) in unit.variables(program).iter().enumerate() {
            let at = (unit, VariableId(index));
            let local = matches!(
                variable.section,
                VariableSection::Local | VariableSection::Constant
            );
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
        let variables = unit.variables_mut(program);
        if let Some(variable) = variables.and_then(|variables| variables.get_mut(variable.0)) {
            unwrap(variable, head, ty, &meant);
        }
    }
    let unit = Unit::Main;
    visit_mut::walk_program(&mut Shorten { places, unit }, program);
}

/// Gives a variable the type and the initial value of its part; `meant` is the part type with aliases resolved.
fn unwrap(variable: &mut Variable, head: Head, ty: Type, meant: &Type) {
    let part = match (variable.initial.take(), head) {
        (Some(InitialValue::Array(values)), _) => values.into_iter().next(),
        (Some(InitialValue::Structure(fields)), Head::Field(field)) => fields
            .into_iter()
            .find(|(which, _)| *which == field)
            .map(|(_, value)| value),
        _ => None,
    };
    // A part that is not a single value, such as an array in an array, gets the default of its type.
    variable.initial = part
        .filter(|value| value.ty == *meant)
        .map(InitialValue::Expression);
    if variable.initial.is_none() {
        variable.section = VariableSection::Local;
    }
    variable.ty = ty;
}

/// The way in which all places of a variable begin.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Head {
    /// All begin with subscripts.
    Index,
    /// All begin with this field.
    Field(usize),
    /// The places begin in different ways, or one is the whole variable.
    Mixed,
}

/// Returns the type of the part that a head selects.
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

    fn statement(&mut self, statement: &Statement) {
        if let StatementKind::For { variable, .. } = &statement.kind {
            self.heads.insert((self.unit, *variable), Head::Mixed);
        }
        visit::walk_statement(self, statement);
    }

    fn place(&mut self, place: &Place) {
        let head = match place.path.first() {
            Some(PlaceSelector::Index(_)) => Head::Index,
            Some(PlaceSelector::Field(field)) => Head::Field(*field),
            Some(PlaceSelector::Output(_)) | None => Head::Mixed,
        };
        let known = self.heads.entry((self.unit, place.variable)).or_insert(head);
        if *known != head {
            *known = Head::Mixed;
        }
        visit::walk_place(self, place);
    }
}

/// Removes the first selector from the places of some variables.
struct Shorten {
    places: HashSet<(Unit, VariableId)>,
    unit: Unit,
}

impl VisitorMut for Shorten {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn place(&mut self, place: &mut Place) {
        if self.places.contains(&(self.unit, place.variable)) && !place.path.is_empty() {
            place.path.remove(0);
        }
        visit_mut::walk_place(self, place);
    }
}

/// Drops fields of structures that no place names; each structure keeps one.
pub(super) fn drop_fields(program: &mut Program, sites: &mut Sites) {
    let before = program.clone();
    let mut kept: Vec<Vec<bool>> = before
        .types
        .iter()
        .map(|one| vec![false; field_count(&one.kind)])
        .collect();
    let mut fields = FieldVisitor {
        program: &before,
        unit: Unit::Main,
        each: &mut |structure, field| {
            if let Some(kept) = kept.get_mut(structure).and_then(|kept| kept.get_mut(*field)) {
                *kept = true;
            }
        },
    };
    visit_mut::walk_program(&mut fields, program);
    for kept in &mut kept {
        let mut left = kept.len();
        for kept in kept.iter_mut().filter(|kept| !**kept) {
            *kept = left == 1 || !sites.here();
            left -= usize::from(!*kept);
        }
    }
    let mut renumber = FieldVisitor {
        program: &before,
        unit: Unit::Main,
        each: &mut |structure, field| {
            let kept = kept.get(structure).map_or(&[][..], Vec::as_slice);
            *field = kept.iter().take(*field).filter(|kept| **kept).count();
        },
    };
    visit_mut::walk_program(&mut renumber, program);
    for (declaration, kept) in program.types.iter_mut().zip(&kept) {
        if let DeclaredKind::Structure(fields) = &mut declaration.kind {
            let mut kept = kept.iter();
            fields.retain(|_| kept.next().copied().unwrap_or(true));
        }
    }
}

fn field_count(declared: &DeclaredKind) -> usize {
    match declared {
        DeclaredKind::Structure(fields) => fields.len(),
        DeclaredKind::Enumeration(_) | DeclaredKind::Alias(_) => 0,
    }
}

/// Visits each place that names a field by its index, with the index of the structure among the types.
struct FieldVisitor<'p> {
    program: &'p Program,
    unit: Unit,
    each: &'p mut dyn FnMut(usize, &mut usize),
}

impl FieldVisitor<'_> {
    fn structure(&self, ty: &Type) -> Option<usize> {
        match self.program.unaliased(ty) {
            Type::Declared(index) => Some(*index),
            _ => None,
        }
    }
}

impl VisitorMut for FieldVisitor<'_> {
    fn enter(&mut self, unit: Unit) {
        self.unit = unit;
    }

    fn variable(&mut self, variable: &mut Variable) {
        if let Some(InitialValue::Structure(fields)) = &mut variable.initial
            && let Some(structure) = self.structure(&variable.ty)
        {
            for (field, _) in fields {
                (self.each)(structure, field);
            }
        }
        visit_mut::walk_variable(self, variable);
    }

    fn place(&mut self, place: &mut Place) {
        let mut ty = variable_type(self.program, self.unit, place.variable);
        for selector in &mut place.path {
            let Some(outer) = ty else { break };
            // The field's type has to be looked up before the field is renumbered.
            ty = self.program.selected_type(outer, selector);
            if let (PlaceSelector::Field(field), Some(structure)) = (selector, self.structure(outer)) {
                (self.each)(structure, field);
            }
        }
        visit_mut::walk_place(self, place);
    }
}
