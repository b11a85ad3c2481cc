//! How many cells a type takes, and where its parts are: every elementary value has one cell, in the order of declaration.

use super::EvaluationError;
use crate::model::{ArrayType, DeclaredKind, Program, Type, Variable, VariableSection};

/// More cells than this no variable has; a program is small.
const MAX_CELLS: usize = 1 << 20;

/// The sizes and offsets of everything that a program declares.
pub(super) struct Layout {
    /// Of each declared type.
    types: Vec<TypeLayout>,
    /// Of each function's variables.
    pub functions: Vec<Offsets>,
    /// Of each function block's variables.
    pub blocks: Vec<Offsets>,
    /// Of the main program's variables.
    pub main: Offsets,
}

struct TypeLayout {
    size: usize,
    /// Of a structure: where each field begins.
    fields: Vec<usize>,
}

/// Where the variables of a program organization unit are, counted from its first cell.
#[derive(Default)]
pub(super) struct Offsets {
    /// Of each variable.
    pub variables: Vec<usize>,
    /// The cells of all.
    pub size: usize,
}

impl Layout {
    pub fn new(program: &Program) -> Result<Layout, EvaluationError> {
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

    fn declared(&self, kind: &DeclaredKind) -> Result<TypeLayout, EvaluationError> {
        match kind {
            DeclaredKind::Enumeration(_) => Ok(TypeLayout {
                size: 1,
                fields: Vec::new(),
            }),
            DeclaredKind::Alias(ty) => Ok(TypeLayout {
                size: self.size(ty)?,
                fields: Vec::new(),
            }),
            DeclaredKind::Structure(fields) => {
                let mut size = 0;
                let mut offsets = Vec::with_capacity(fields.len());
                for (_, ty, _) in fields {
                    offsets.push(size);
                    size = limited(size + self.size(ty)?)?;
                }
                Ok(TypeLayout {
                    size,
                    fields: offsets,
                })
            }
        }
    }

    fn variables(&self, variables: &[Variable]) -> Result<Offsets, EvaluationError> {
        let mut offsets = Offsets::default();
        for variable in variables {
            offsets.variables.push(offsets.size);
            // An in-out has no value of its own, but a cell that says where its variable is.
            let size = match variable.section {
                VariableSection::InOut => 1,
                _ => self.size(&variable.ty)?,
            };
            offsets.size = limited(offsets.size + size)?;
        }
        Ok(offsets)
    }

    /// The cells of a type.
    pub fn size(&self, ty: &Type) -> Result<usize, EvaluationError> {
        match ty {
            Type::Elementary(_) => Ok(1),
            Type::Array(array) => limited(elements(array)?.saturating_mul(self.size(&array.element)?)),
            Type::Declared(index) => {
                self.types
                    .get(*index)
                    .map(|laid| laid.size)
                    .ok_or(EvaluationError::IllFormed(
                        "a type that is not declared before its use",
                    ))
            }
            Type::Block(index) => {
                self.blocks
                    .get(*index)
                    .map(|offsets| offsets.size)
                    .ok_or(EvaluationError::IllFormed(
                        "a function block that is not declared before its use",
                    ))
            }
        }
    }

    /// Where a field of a structure begins, counted from the structure's first cell.
    pub fn field(&self, structure: usize, field: usize) -> Option<usize> {
        self.types.get(structure)?.fields.get(field).copied()
    }
}

/// How many elements an array has.
pub(super) fn elements(array: &ArrayType) -> Result<usize, EvaluationError> {
    array.dimensions.iter().try_fold(1_usize, |product, dimension| {
        limited(product.saturating_mul(extent(*dimension)?))
    })
}

/// How many subscripts a dimension has.
pub(super) fn extent((low, high): (i64, i64)) -> Result<usize, EvaluationError> {
    let extent = i128::from(high) - i128::from(low) + 1;
    if extent < 1 {
        return Err(EvaluationError::IllFormed("an array without elements"));
    }
    limited(usize::try_from(extent).unwrap_or(usize::MAX))
}

fn limited(size: usize) -> Result<usize, EvaluationError> {
    if size > MAX_CELLS {
        Err(EvaluationError::StepLimit)
    } else {
        Ok(size)
    }
}
