//! Lists what can be observed: the elementary values of the program, by their paths.

use super::observation::CheckedProgram;
use super::types::{ArrayShape, Structure, TypeId, TypeKind, TypeTable};
use stickler_syntax::tree::VariableKind;

impl CheckedProgram {
    /// The paths of all elementary values of the program that runs first (PROGRAM main), in the order of their
    /// declarations, arrays element by element, structures and function blocks field by field; at most `most`.
    ///
    /// Each of them is one that [`CheckedProgram::resolve`] takes.
    #[must_use]
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
            TypeKind::Alias | TypeKind::Error => {}
        }
    }

    fn members(&mut self, structure: &Structure, path: &str) {
        for (name, member) in structure.members.iter() {
            if member.kind != VariableKind::InOut {
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
            let inside: Vec<String> = subscripts.iter().map(ToString::to_string).collect();
            self.value(shape.element, format!("{path}[{}]", inside.join(",")));
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

#[cfg(test)]
mod tests {
    use crate::semantics::{CheckedProgram, check};
    use stickler_syntax::source::LineIndex;
    use stickler_types::DialectName;
    use stickler_types::dialect::Dialect;

    fn checked(text: &str) -> CheckedProgram {
        let dialect = Dialect::of(DialectName::IRONPLC_ED2);
        let (unit, diagnostics) = stickler_syntax::parse(text, dialect);
        assert_eq!(diagnostics, []);
        let (program, diagnostics) = check(&unit, text, &LineIndex::new(text), dialect);
        assert_eq!(diagnostics, []);
        program.expect("a program")
    }

    const TEXT: &str = "
        TYPE POINT : STRUCT x : INT; y : INT; END_STRUCT; END_TYPE
        FUNCTION_BLOCK COUNTER VAR_OUTPUT q : INT; END_VAR END_FUNCTION_BLOCK
        PROGRAM main
        VAR a : BOOL; grid : ARRAY[1..2, -1..0] OF INT; line : ARRAY[0..1] OF POINT; c : COUNTER; s : STRING; END_VAR
        END_PROGRAM";

    #[test]
    fn every_elementary_value_is_listed_in_the_order_of_the_declarations() {
        let expected = [
            "a",
            "grid[1,-1]",
            "grid[1,0]",
            "grid[2,-1]",
            "grid[2,0]",
            "line[0].x",
            "line[0].y",
            "line[1].x",
            "line[1].y",
            "c.q",
            "s",
        ];
        assert_eq!(checked(TEXT).variables(100), expected);
    }

    #[test]
    fn what_is_listed_can_be_resolved() {
        let program = checked(TEXT);
        for path in program.variables(100) {
            assert!(program.resolve(&path).is_ok(), "{path}");
        }
    }

    #[test]
    fn a_large_array_does_not_become_a_large_list() {
        let program = checked("PROGRAM main VAR a : ARRAY[1..1000000] OF BYTE; b : INT; END_VAR END_PROGRAM");
        assert_eq!(program.variables(3), ["a[1]", "a[2]", "a[3]"]);
    }
}
