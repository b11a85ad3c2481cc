//! Passes that simplify declarations: drop initial values, resolve aliases, shorten arrays.

use super::removal::keep_only;
use super::usage::DeclarationUsage;
use crate::model::visit::{self, Visitor};
use crate::model::visit_mut::{self, VisitorMut};
use crate::model::{ArrayType, DeclaredKind, InitialValue, Program, Type, Variable, VariableSection};
use stickler_reduce::Sites;

/// Drops initial values of variables and fields, and turns constants into variables.
pub(super) fn drop_initials(program: &mut Program, sites: &mut Sites) {
    struct Initials<'s>(&'s mut Sites);
    impl VisitorMut for Initials<'_> {
        fn variable(&mut self, variable: &mut Variable) {
            if (variable.initial.is_some() || variable.section == VariableSection::Constant) && self.0.here()
            {
                variable.initial = None;
                if variable.section == VariableSection::Constant {
                    variable.section = VariableSection::Local;
                }
            }
        }
    }
    visit_mut::walk_program(&mut Initials(sites), program);
    for declaration in &mut program.types {
        if let DeclaredKind::Structure(fields) = &mut declaration.kind {
            for (_, _, initial) in fields.iter_mut().filter(|(.., initial)| initial.is_some()) {
                if sites.here() {
                    *initial = None;
                }
            }
        }
    }
}

/// Turns constants into variables, which keep their value.
pub(super) fn constants_to_variables(program: &mut Program, sites: &mut Sites) {
    struct Constants<'s>(&'s mut Sites);
    impl VisitorMut for Constants<'_> {
        fn variable(&mut self, variable: &mut Variable) {
            if variable.section == VariableSection::Constant && self.0.here() {
                variable.section = VariableSection::Local;
            }
        }
    }
    visit_mut::walk_program(&mut Constants(sites), program);
}

/// Replaces aliases by the types that they stand for.
pub(super) fn resolve_aliases(program: &mut Program, sites: &mut Sites) {
    struct Aliases(Vec<Option<Type>>);
    impl VisitorMut for Aliases {
        fn ty(&mut self, ty: &mut Type) {
            if let Type::Declared(index) = ty
                && let Some(Some(target)) = self.0.get(*index)
            {
                *ty = target.clone();
            }
            visit_mut::walk_type(self, ty);
        }
    }
    let targets = program.types.iter().map(|declaration| match &declaration.kind {
        DeclaredKind::Alias(target) if sites.here() => Some(target.clone()),
        _ => None,
    });
    let mut aliases = Aliases(targets.collect());
    visit_mut::walk_program(&mut aliases, program);
    let mut keep = DeclarationUsage::uniform(program, true);
    for (kept, target) in keep.types.iter_mut().zip(&aliases.0) {
        *kept = target.is_none();
    }
    keep_only(program, &keep);
}

/// Halves arrays in one dimension; equal types stay equal.
pub(super) fn halve_arrays(program: &mut Program, sites: &mut Sites) {
    shrink_arrays(program, sites, |low, high| low + (high - low) / 2);
}

/// Shortens arrays by one element in one dimension.
pub(super) fn shorten_arrays(program: &mut Program, sites: &mut Sites) {
    shrink_arrays(program, sites, |_, high| high - 1);
}

fn shrink_arrays(program: &mut Program, sites: &mut Sites, new_high: fn(i64, i64) -> i64) {
    let mut found = Arrays(Vec::new());
    visit::walk_program(&mut found, program);
    let mut changes = Vec::new();
    for array in found.0 {
        let mut shrunk = array.clone();
        for (low, high) in &mut shrunk.dimensions {
            if *low < *high && sites.here() {
                *high = new_high(*low, *high);
            }
        }
        if shrunk != array {
            changes.push((array, shrunk));
        }
    }
    if !changes.is_empty() {
        visit_mut::walk_program(&mut Shrink(changes), program);
    }
}

/// The different array types of a program, in the order of the walk.
struct Arrays(Vec<ArrayType>);

impl Visitor for Arrays {
    fn ty(&mut self, ty: &Type) {
        if let Type::Array(array) = ty
            && !self.0.contains(array)
        {
            self.0.push((**array).clone());
        }
        visit::walk_type(self, ty);
    }
}

/// Replaces the first type of each pair by the second.
struct Shrink(Vec<(ArrayType, ArrayType)>);

impl VisitorMut for Shrink {
    fn ty(&mut self, ty: &mut Type) {
        visit_mut::walk_type(self, ty);
        if let Type::Array(array) = ty
            && let Some((_, shrunk)) = self.0.iter().find(|(before, _)| before == &**array)
        {
            **array = shrunk.clone();
        }
    }

    fn variable(&mut self, variable: &mut Variable) {
        visit_mut::walk_variable(self, variable);
        if let (Type::Array(array), Some(InitialValue::Array(values))) = (&variable.ty, &mut variable.initial)
        {
            values.truncate(elements(array));
        }
    }
}

/// Returns the number of elements of an array.
fn elements(array: &ArrayType) -> usize {
    let lengths = array
        .dimensions
        .iter()
        .map(|(low, high)| high.abs_diff(*low).saturating_add(1));
    usize::try_from(lengths.fold(1, u64::saturating_mul)).unwrap_or(usize::MAX)
}
