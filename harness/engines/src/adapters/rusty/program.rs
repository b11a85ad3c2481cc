//! A program as it is compiled: renamed, so that its names clash neither with those of C nor with those of another program.

use super::driver::RustySubject;
use super::errors::{ErrorPart, LocatedDiagnostic, sorted};
use crate::adapters::rename::{Renamed, declared, has_pack_suffix};
use crate::adapters::source::{MainProgram, main_program};
use crate::{Diagnostic, RunRequest};
use std::collections::HashSet;
use std::path::Path;

/// The functions and operators that the language itself declares, in capitals; they stand in no file of the library.
///
/// Basis: iec-61131-3: tables of the standard functions of selection, comparison and arithmetic; rusty: book, *Libraries*.
const BUILT_IN: &[&str] = &[
    "ADD",
    "SUB",
    "MUL",
    "DIV",
    "GT",
    "GE",
    "EQ",
    "LE",
    "LT",
    "NE",
    "SEL",
    "MUX",
    "MOVE",
    "ADR",
    "REF",
    "SIZEOF",
    "LOWER_BOUND",
    "UPPER_BOUND",
];

/// A program that has a main program.
pub(super) struct PackedProgram<'r> {
    /// The place of the program among the requests.
    pub(super) place: usize,
    pub(super) request: RunRequest<'r>,
    main: MainProgram,
    /// The names that get a suffix, in capitals.
    names: HashSet<String>,
    renamed: Renamed,
}

impl<'r> PackedProgram<'r> {
    /// Returns a program that is compiled alone: only the name of its main program changes, since `main` is where a C program
    /// begins. `None` where it has no main program.
    pub(super) fn alone(request: &RunRequest<'r>) -> Option<PackedProgram<'r>> {
        let main = main_program(request)?;
        let names = HashSet::from([main.name.to_ascii_uppercase()]);
        Some(PackedProgram::with(request, 0, main, names))
    }

    /// Returns a program among others, with all its names made unique; `None` where it cannot stand among others.
    pub(super) fn among_others(
        request: &RunRequest<'r>,
        place: usize,
        taken: &HashSet<String>,
    ) -> Option<PackedProgram<'r>> {
        let names = declared(request, taken, false)?;
        if names.iter().any(|name| BUILT_IN.contains(&name.as_str())) {
            return None;
        }
        let main = main_program(request)?;
        let fits = !has_pack_suffix(request.source);
        fits.then(|| PackedProgram::with(request, place, main, names))
    }

    fn with(
        request: &RunRequest<'r>,
        place: usize,
        main: MainProgram,
        names: HashSet<String>,
    ) -> PackedProgram<'r> {
        let renamed = Renamed::in_pack(request, &names, place);
        PackedProgram {
            place,
            request: *request,
            main,
            names,
            renamed,
        }
    }

    /// Returns the name of the file of the program at a place.
    pub(super) fn file_of(place: usize) -> String {
        format!("program_{place}.st")
    }

    /// Returns the place of the program in a file.
    pub(super) fn place_of(file: &str) -> Option<usize> {
        let name = Path::new(file).file_name()?.to_str()?;
        name.strip_prefix("program_")?.strip_suffix(".st")?.parse().ok()
    }

    /// Returns the renamed text of the program.
    pub(super) fn text(&self) -> &str {
        &self.renamed.text
    }

    /// Returns the program as a driver runs it.
    pub(super) fn subject(&self) -> RustySubject<'r> {
        let rename = |source: &str| {
            let request = RunRequest {
                source,
                ..self.request
            };
            Renamed::in_pack(&request, &self.names, self.place).text
        };
        RustySubject {
            request: self.request,
            program: rename(&self.main.name),
            observed: self
                .request
                .observe
                .iter()
                .map(|asked| rename(&asked.name))
                .collect(),
        }
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
