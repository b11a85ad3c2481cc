//! The memory layout of a program: every elementary value has one cell, in the order of declaration.

use super::{Evaluated, EvaluationError, ill_formed};
use crate::model::{ArrayType, DeclaredKind, Program, Type, Variable, VariableSection};

/// The maximum number of cells of a variable.
const MAX_CELLS: usize = 1 << 20;

/// The sizes and offsets of everything that a program declares.
pub(super) struct Layout {
    /// The offsets in each declared type.
    types: Vec<Offsets>,
    /// The offsets in each function.
    pub functions: Vec<Offsets>,
    /// The offsets in each function block.
    pub blocks: Vec<Offsets>,
    /// The offsets in the main program.
    pub main: Offsets,
}

/// The offsets of the variables of a program organization unit, or of the fields of a structure, from its first cell.
#[derive(Default)]
pub(super) struct Offsets {
    /// The offset of each variable or field.
    pub variables: Vec<usize>,
    /// The number of cells of all of them.
    pub size: usize,
}

impl Layout {
    pub fn new(program: &Program) -> Evaluated<Layout> {
        let mut layout = Layout {
            types: Vec::with_capacity(program.types.len()),
            functions: Vec::new(),
            blocks: Vec::with_capacity(program.blocks.len()),
            main: Offsets::default(),
        };
        for declaration in &program.types {
            let laid = layout.declared(&declaration.kind)?;
            layout.types.push(laid);
        }
        for block in &program.blocks {
            let offsets = layout.variables(&block.variables)?;
            layout.blocks.push(offsets);
        }
        for function in &program.functions {
            let offsets = layout.variables(&function.variables)?;
            layout.functions.push(offsets);
        }
        layout.main = layout.variables(&program.main.variables)?;
        Ok(layout)
    }

    fn declared(&self, kind: &DeclaredKind) -> Evaluated<Offsets> {
        let one = |size| Offsets {
            variables: Vec::new(),
            size,
        };
        match kind {
            DeclaredKind::Enumeration(_) => Ok(one(1)),
            DeclaredKind::Alias(ty) => self.size(ty).map(one),
            DeclaredKind::Structure(fields) => laid(fields.iter().map(|(_, ty, _)| self.size(ty))),
        }
    }

    fn variables(&self, variables: &[Variable]) -> Evaluated<Offsets> {
        laid(variables.iter().map(|variable| match variable.section {
            // An in-out has no value of its own, but a cell for the address of its variable.
            VariableSection::InOut => Ok(1),
            _ => self.size(&variable.ty),
        }))
    }

    /// Returns the number of cells of a type.
    pub fn size(&self, ty: &Type) -> Evaluated<usize> {
        match ty {
            Type::Elementary(_) => Ok(1),
            Type::Array(array) => limited(elements(array)?.saturating_mul(self.size(&array.element)?)),
            Type::Declared(index) => self
                .types
                .get(*index)
                .map(|laid| laid.size)
                .ok_or(ill_formed("a type that is not declared before its use")),
            Type::Block(index) => self
                .blocks
                .get(*index)
                .map(|offsets| offsets.size)
                .ok_or(ill_formed("a function block that is not declared before its use")),
        }
    }

    /// Returns the offset of a field from the first cell of its structure.
    pub fn field(&self, structure: usize, field: usize) -> Option<usize> {
        self.types.get(structure)?.variables.get(field).copied()
    }
}

/// Returns the offsets of parts of these sizes, one behind the other.
fn laid(sizes: impl Iterator<Item = Evaluated<usize>>) -> Evaluated<Offsets> {
    let mut offsets = Offsets::default();
    for size in sizes {
        offsets.variables.push(offsets.size);
        offsets.size = limited(offsets.size + size?)?;
    }
    Ok(offsets)
}

/// Returns the number of elements of an array.
pub(super) fn elements(array: &ArrayType) -> Evaluated<usize> {
    array.dimensions.iter().try_fold(1_usize, |product, dimension| {
        limited(product.saturating_mul(extent(*dimension)?))
    })
}

/// Returns the number of subscripts of a dimension.
pub(super) fn extent((low, high): (i64, i64)) -> Evaluated<usize> {
    let extent = i128::from(high) - i128::from(low) + 1;
    if extent < 1 {
        return Err(ill_formed("an array without elements"));
    }
    limited(usize::try_from(extent).unwrap_or(usize::MAX))
}

fn limited(size: usize) -> Evaluated<usize> {
    if size > MAX_CELLS {
        Err(EvaluationError::StepLimit)
    } else {
        Ok(size)
    }
}
