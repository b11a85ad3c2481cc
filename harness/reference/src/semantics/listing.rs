//! Lists what can be observed: the elementary values of the program, by their paths.

use super::observation::CheckedProgram;
use super::types::{ArrayShape, Structure, TypeId, TypeKind, TypeTable};
use crate::library::has_block;
use stickler_syntax::tree::VariableKind;
use stickler_types::join;

impl CheckedProgram {
    /// The paths of all elementary values of the program that runs first (PROGRAM main), in the order of their
    /// declarations, arrays element by element, structures and function blocks field by field; at most `most`.
    ///
    /// Each of them is one that [`CheckedProgram::resolve`] takes.
    pub fn variables(&self, most: usize) -> Vec<String> {
        let directory = &self.directory;
        let mut listing = PathListing {
            types: &directory.types,
            most,
            paths: Vec::new(),
        };
        if let Some((_, ty, _)) = directory.instances.first() {
            listing.value(*ty, String::new());
        }
        listing.paths
    }
}

struct PathListing<'t> {
    types: &'t TypeTable,
    most: usize,
    paths: Vec<String>,
}

impl PathListing<'_> {
    /// Types are declared before they are used, so a value is only as deep as the text is long; the checker bounds
    /// how deep that may be.
    fn value(&mut self, ty: TypeId, path: String) {
        if self.paths.len() >= self.most {
            return;
        }
        match self.types.kind(ty) {
            TypeKind::Elementary(_)
            | TypeKind::Subrange(_)
            | TypeKind::Text { .. }
            | TypeKind::Enumeration(_) => {
                self.paths.push(path);
            }
            TypeKind::Array(shape) => self.elements(shape, &path),
            TypeKind::Structure(structure) | TypeKind::FunctionBlock(structure) => {
                self.members(structure, &path)
            }
            TypeKind::Pointer(_) | TypeKind::Alias | TypeKind::Interface(_) | TypeKind::Error => {}
        }
    }

    fn members(&mut self, structure: &Structure, path: &str) {
        if let Some(base) = structure.base.and_then(|base| self.types.structure(base)) {
            self.members(base, path);
        }
        let is_standard = has_block(&structure.name);
        for (name, member) in structure.members.iter() {
            let is_own = is_standard && member.kind == VariableKind::Local;
            if !is_own && !matches!(member.kind, VariableKind::InOut | VariableKind::Instance) {
                let dot = if path.is_empty() { "" } else { "." };
                self.value(member.ty, format!("{path}{dot}{name}"));
            }
        }
    }

    fn elements(&mut self, shape: &ArrayShape, path: &str) {
        let mut subscripts: Vec<i64> = shape.dimensions.iter().map(|dimension| dimension.low).collect();
        for _ in 0..shape.length {
            if self.paths.len() >= self.most {
                return;
            }
            self.value(shape.element, format!("{path}[{}]", join(&subscripts, ",")));
            for (subscript, dimension) in subscripts.iter_mut().zip(&shape.dimensions).rev() {
                if *subscript < dimension.high {
                    *subscript += 1;
                    break;
                }
                *subscript = dimension.low;
            }
        }
    }
}
