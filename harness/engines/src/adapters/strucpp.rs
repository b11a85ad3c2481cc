//! STruC++: its compiler writes C++, which a C++ compiler builds together with a driver; the driver prints the observed values
//! exactly.
//!
//! The compiler's command line takes seconds to start, so a Node process of the adapter's own asks the same compiler for one
//! program after another. A program that the compiler accepts and whose C++ cannot be built counts as a crash of the compiler.
//!
//! Basis: strucpp: `strucpp --help`, its `compile` function, and the C++ that it writes; measured on version 0.6.

mod driver;
mod pack;
mod translator;

use super::Compiler;
use super::adapter::Adapter;
use super::builder::{Builder, CPP};
use super::compilers::path;
use super::driver::DriverText;
use super::fingerprint::Fingerprint;
use super::locate::unsupported;
use super::probe_variable::{ProbeVariables, translate_with, with_shown_probes};
use super::recipe::{PROGRAM, Purpose, Recipe, Tools, Workplace};
use super::rename::TakenNames;
use super::source::{MainProgram, main_program};
use crate::{Diagnostic, NoReproduction, Outcome, Packed, RunRequest};
use driver::{StrucppSubject, driver};
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use stickler_types::DialectName;
use translator::{Translated, Translator};

/// Returns the recipe that translates a program to C++.
fn translation(text: impl Into<String>) -> Recipe {
    Recipe::of(PROGRAM, text).step(Compiler::Strucpp, Purpose::Translate, "translate", &[])
}

/// Returns the recipe that translates a program to C++, builds it with a driver, and runs it.
fn execution(text: impl Into<String>, driver: &DriverText) -> Recipe {
    translation(text).driver(Compiler::Strucpp, driver, &[])
}

/// The adapter: the compiler in a process of Node, and the builder of its C++.
pub(super) struct Strucpp {
    translator: Translator,
    builder: Builder,
    node: PathBuf,
    package: PathBuf,
    /// The folder of the compiler's run-time headers.
    headers: PathBuf,
    /// The names in the run-time headers.
    taken: TakenNames,
}

/// Returns the names in the run-time headers, in capitals, since the compiler writes the names of a program in capitals. A
/// program that declares one of them clashes with the header when it is alone, and would hide it within a namespace of its
/// own.
fn header_names(headers: &Path) -> HashSet<String> {
    // A file that cannot be read is reported by the compiler.
    let files = std::fs::read_dir(headers).into_iter().flatten().flatten();
    let texts = files.filter_map(|file| std::fs::read_to_string(file.path()).ok());
    texts
        .flat_map(|text| capitals(&text).collect::<Vec<_>>())
        .collect()
}

pub(super) fn capitals(text: &str) -> impl Iterator<Item = String> + '_ {
    let words = text.split(|character: char| !(character.is_ascii_alphanumeric() || character == '_'));
    let capitals = words.filter(|word| !word.bytes().any(|byte| byte.is_ascii_lowercase()));
    // For a type `X` the compiler also declares `IEC_X`.
    capitals.map(|word| word.strip_prefix("IEC_").unwrap_or(word).to_owned())
}

/// Returns the package that a command belongs to: the nearest folder around it that has the needed files.
fn package(command: &Path) -> Result<PathBuf, String> {
    // The command on PATH is a link into the package.
    let command = command.canonicalize().map_err(|error| error.to_string())?;
    let has_all = |folder: &&Path| {
        folder.join("dist/index.js").is_file() && folder.join("src/runtime/include").is_dir()
    };
    let found = command.ancestors().skip(1).find(has_all);
    found.map(Path::to_owned).ok_or_else(|| {
        format!(
            "`{}` lies in no package of STruC++, with `dist/index.js` and `src/runtime/include`; say by \
             STICKLER_STRUCPP where `dist/node/cli.js` is",
            command.display()
        )
    })
}

impl Adapter for Strucpp {
    const COMPILER: Compiler = Compiler::Strucpp;
    // Larger packs take more memory, and save little time for each program.
    const PACK_SIZE: usize = 48;

    fn new(tools: &mut Tools) -> Result<Strucpp, String> {
        let package = package(&path(tools, "STRUCPP"))?;
        let headers = package.join("src/runtime/include");
        tools.push(("STRUCPP_INCLUDE".to_owned(), headers.clone()));
        let (node, folder) = (path(tools, "NODE"), headers.clone());
        Ok(Strucpp {
            translator: Translator::new(&node, &package.join("dist/index.js"))?,
            builder: Builder::new(path(tools, "CXX"), &CPP, headers.clone(), driver::HEADER)?,
            node,
            package,
            headers,
            taken: LazyLock::new(Box::new(move || header_names(&folder))),
        })
    }

    fn fingerprint(&self, fingerprint: Fingerprint) -> Fingerprint {
        // The compiler's other parts lie beside it or above, wherever its installer put them; these files list them.
        let lists = [
            "package.json",
            "package-lock.json",
            "node_modules/.package-lock.json",
        ];
        let lists = lists.map(|list| self.package.join(list)).into_iter();
        let fingerprint = fingerprint
            .program(&self.node)
            .folder(&self.package.join("dist"))
            .folder(&self.package.join("libs"))
            .folder(&self.headers)
            .with(self.builder.fingerprint());
        lists
            .filter(|list| list.is_file())
            .fold(fingerprint, |fingerprint, list| fingerprint.file(&list))
    }

    fn translation(_: DialectName, source: &str) -> Result<Recipe, Outcome> {
        Ok(translation(source))
    }

    fn execution(request: &RunRequest<'_>, main: &MainProgram) -> Result<Recipe, NoReproduction> {
        let probes = ProbeVariables::of(request);
        let text = with_shown_probes(request, main, probes.list())?;
        let subject = StrucppSubject::of(request, probes, &main.name)?;
        Ok(execution(text, &driver(&[&subject]).text()))
    }

    fn run(&self, workplace: &Workplace<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let AcceptedProgram { subject, translated } = self.accepted(request)?;
        let driver = driver(&[&subject]);
        // What the compiler wrote into files for a person.
        let recipe = execution(request.source, &driver.text())
            .file("program.cpp", &*translated.program)
            .file("program.hpp", &*translated.header);
        workplace.begin(&recipe)?;
        self.builder.build(&recipe, workplace)?;
        let outcome = driver.execute(&recipe, workplace)?;
        Ok(outcome.with_warnings(translated.diagnostics()))
    }

    fn run_pack(&self, workplace: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        pack::run(self, workplace, requests)
    }

    fn check(&self, _: &Workplace<'_>, _: DialectName, source: &str) -> Result<Vec<Diagnostic>, Outcome> {
        Ok(self.translator.translate(source)?.diagnostics())
    }
}

/// A program that was accepted, and the values that its driver observes.
struct AcceptedProgram<'r> {
    subject: StrucppSubject<'r>,
    translated: Translated,
}

impl Strucpp {
    /// Translates a program that is to be run.
    ///
    /// # Errors
    /// The outcome of a program that is not accepted, or that is and has no main program.
    fn accepted<'r>(&self, request: &RunRequest<'r>) -> Result<AcceptedProgram<'r>, Outcome> {
        let Some(main) = main_program(request) else {
            let warnings = self.translator.translate(request.source)?.diagnostics();
            return Err(Outcome::Accepted { warnings });
        };
        let probes = ProbeVariables::of(request);
        let subject = StrucppSubject::of(request, probes, &main.name).map_err(unsupported)?;
        let translate = |text: &str| self.translator.translate(text);
        let translated = translate_with(request, &main, subject.probes.list(), translate)?;
        Ok(AcceptedProgram { subject, translated })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::Folder;

    #[test]
    fn a_command_outside_the_package_is_told() {
        let folder = Folder::new().unwrap();
        let command = folder.write("strucpp", "").unwrap();
        assert!(package(&command).unwrap_err().contains("STICKLER_STRUCPP"));
    }
}
