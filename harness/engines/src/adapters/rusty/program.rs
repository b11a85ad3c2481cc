//! A program as it is compiled: renamed, so that its names clash neither with those of C nor with those of another program.

use super::diagnostics::{ErrorPart, LocatedDiagnostic, sorted};
use crate::adapters::recipe::PROGRAM;
use crate::adapters::rename::{Renamed, declared, has_pack_suffix, pack_suffix};
use crate::adapters::source::{MainProgram, main_program};
use crate::adapters::values::{self, ObservedKind};
use crate::{Diagnostic, RunRequest};
use std::collections::HashSet;
use std::path::Path;

/// The functions and operators that the language itself declares, in capitals; they stand in no file of the library.
///
/// Basis: iec-61131-3: tables of the standard functions of selection, comparison and arithmetic; rusty: book, *Libraries*.
const BUILT_IN: &str =
    "ADD SUB MUL DIV GT GE EQ LE LT NE SEL MUX MOVE ADR REF SIZEOF LOWER_BOUND UPPER_BOUND";

/// A program that has a main program.
pub(super) struct PackedProgram<'r> {
    /// The place of the program among the requests.
    pub(super) place: usize,
    /// The file of the program.
    pub(super) file: String,
    pub(super) request: RunRequest<'r>,
    /// The kind of each observed value.
    pub(super) kinds: Vec<ObservedKind<'r>>,
    main: String,
    /// The names that get a suffix, in capitals.
    names: HashSet<String>,
    suffix: String,
    renamed: Renamed,
}

impl<'r> PackedProgram<'r> {
    /// Returns a program that is compiled alone: only the name of its main program changes, since `main` is where a C program
    /// begins, to one that the program does not have.
    ///
    /// # Errors
    /// A fragment that says what cannot be observed or set.
    pub(super) fn alone(request: &RunRequest<'r>, main: &MainProgram) -> Result<PackedProgram<'r>, String> {
        let names = HashSet::from([main.name.to_ascii_uppercase(), "MAIN".to_owned()]);
        let mut suffix = "_program".to_owned();
        let source = request.source.to_ascii_uppercase();
        while names
            .iter()
            .any(|name| source.contains(&format!("{name}{}", suffix.to_ascii_uppercase())))
        {
            suffix.push_str("_0");
        }
        let program = PackedProgram::with(request, 0, main, (names, suffix))?;
        let file = PROGRAM.to_owned();
        Ok(PackedProgram { file, ..program })
    }

    /// Returns a program among others, with all its names made unique; `None` where it cannot stand among others.
    pub(super) fn among_others(
        request: &RunRequest<'r>,
        place: usize,
        taken: &HashSet<String>,
    ) -> Option<PackedProgram<'r>> {
        let names = declared(request, taken, false)?;
        if has_pack_suffix(request.source) || BUILT_IN.split(' ').any(|name| names.contains(name)) {
            return None;
        }
        let main = main_program(request)?;
        PackedProgram::with(request, place, &main, (names, pack_suffix(place))).ok()
    }

    fn with(
        request: &RunRequest<'r>,
        place: usize,
        main: &MainProgram,
        (names, suffix): (HashSet<String>, String),
    ) -> Result<PackedProgram<'r>, String> {
        if !request.clock.is_empty() {
            return Err("its timers take the clock of the machine, and no other".to_owned());
        }
        Ok(PackedProgram {
            place,
            file: format!("program_{place}.st"),
            request: *request,
            kinds: values::kinds(request, |_| true)?,
            main: main.name.clone(),
            renamed: Renamed::with_suffix(request, &names, &suffix),
            names,
            suffix,
        })
    }

    /// Returns the place of the program in a file.
    pub(super) fn place_of(file: &str) -> Option<usize> {
        let name = Path::new(file).file_name()?.to_str()?;
        match name {
            PROGRAM => Some(0),
            _ => name.strip_prefix("program_")?.strip_suffix(".st")?.parse().ok(),
        }
    }

    /// Returns the renamed text of the program.
    pub(super) fn text(&self) -> &str {
        &self.renamed.text
    }

    /// Returns the name of the main program in the renamed text.
    pub(super) fn main(&self) -> String {
        self.renamed(&self.main)
    }

    /// Returns a name or path of the program as it is in the renamed text.
    pub(super) fn renamed(&self, source: &str) -> String {
        let request = RunRequest {
            source,
            ..self.request
        };
        Renamed::with_suffix(&request, &self.names, &self.suffix).text
    }

    /// Translates a diagnostic of the renamed text back to the program itself.
    pub(super) fn original(&self, diagnostic: Diagnostic) -> Diagnostic {
        self.renamed.original(diagnostic)
    }

    /// Returns those of the located diagnostics that are about this program, as they are about the program itself.
    pub(super) fn own(&self, found: &[LocatedDiagnostic]) -> Vec<Diagnostic> {
        let own = found
            .iter()
            .filter(|(about, _)| *about == ErrorPart::Program(self.place));
        sorted(own.map(|(_, diagnostic)| self.original(diagnostic.clone())))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    #[test]
    fn among_others_every_name_of_a_program_is_kept_apart_unless_the_language_has_it() {
        let taken = HashSet::from(["TON".to_owned()]);
        let among = |source: &str| {
            let request = RunRequest::once(DialectName::RUSTY, source, &[]);
            PackedProgram::among_others(&request, 7, &taken).map(|program| program.text().to_owned())
        };
        assert_eq!(
            among("FUNCTION F : INT F := 1; END_FUNCTION PROGRAM main VAR w : WORD; END_VAR w.%X3 := f() > 0; END_PROGRAM").unwrap(),
            "FUNCTION F_in_pack_7 : INT F_in_pack_7 := 1; END_FUNCTION PROGRAM main_in_pack_7 VAR w : WORD; END_VAR \
             w.%X3 := f_in_pack_7() > 0; END_PROGRAM"
        );
        for alone in [
            "FUNCTION_BLOCK TON END_FUNCTION_BLOCK PROGRAM main END_PROGRAM",
            "FUNCTION sel : INT END_FUNCTION PROGRAM main END_PROGRAM",
            "PROGRAM main VAR x AT %IX0.0 : BOOL; END_VAR END_PROGRAM",
            "PROGRAM main VAR x_in_pack_1 : BOOL; END_VAR END_PROGRAM",
            "FUNCTION f : INT END_FUNCTION",
        ] {
            assert_eq!(among(alone), None, "{alone}");
        }
    }
}
