//! Adapters for real compilers behind the [`Engine`] trait: each adapter writes a program into a private folder, calls the
//! compiler as a person would on a command line, and reads its output.
//!
//! Where a compiler shows no value of a variable, the adapter adds variables to the program that copy the observed value into
//! something that the compiler does show; no line of the program moves. An adapter corrects nothing that a compiler does wrong.

mod adapter;
mod builder;
mod codes;
mod command;
mod compilers;
mod dependencies;
mod described;
mod driver;
mod fingerprint;
mod ironplc;
pub(crate) mod locate;
mod matiec;
mod probe_variable;
mod recipe;
mod rename;
mod rounds;
mod rusty;
mod settings;
mod source;
mod strucpp;
#[cfg(test)]
mod tests;
mod values;

use crate::{Ability, Engine, EngineError, NoReproduction, Reproduction, RunRequest};
use adapter::{AdapterEngine, reproduce};
use dependencies::DependencySearch;
pub use dependencies::{Dependency, DependencyPaths, FoundBy, FoundDependency};
pub use described::{DescribedEngine, Description};
use ironplc::Ironplc;
use matiec::Matiec;
use rusty::Rusty;
use stickler_types::words;
use strucpp::Strucpp;

words! {
    /// A compiler for which there is an adapter.
    Compiler {
        /// IronPLC: `ironplcc` and `ironplcvm`.
        Ironplc = "ironplc",
        /// matiec: `iec2c` and a C compiler.
        Matiec = "matiec",
        /// RuSTy: `plc` and a C compiler.
        Rusty = "rusty",
        /// STruC++: `strucpp`, Node and a C++ compiler.
        Strucpp = "strucpp",
    }
}

impl Compiler {
    /// Returns the address of the compiler's project, which says how it is installed.
    pub fn project(self) -> &'static str {
        &self.data().project
    }

    /// Returns the programs and folders that the compiler needs.
    pub fn dependencies(self) -> impl Iterator<Item = &'static Dependency> {
        self.data().tools.iter().filter(|tool| tool.can_be_named())
    }

    /// Returns the files and commands by which a person runs a program on this compiler without Stickler. The compiler need not
    /// be on this machine.
    ///
    /// # Errors
    /// [`NoReproduction`], as [`Engine::reproduce`] says.
    pub fn reproduce(
        self,
        request: &RunRequest<'_>,
        ability: Ability,
    ) -> Result<Reproduction, NoReproduction> {
        match self {
            Compiler::Ironplc => reproduce::<Ironplc>(request, ability),
            Compiler::Matiec => reproduce::<Matiec>(request, ability),
            Compiler::Rusty => reproduce::<Rusty>(request, ability),
            Compiler::Strucpp => reproduce::<Strucpp>(request, ability),
        }
    }

    /// Finds the compiler on this machine by environment variables and PATH. Returns it as an engine that is called `called` in
    /// reports.
    ///
    /// # Errors
    /// [`EngineError`] where one of its programs is missing or does not say its version, with the ways to name its path.
    pub fn engine(self, called: &str) -> Result<Box<dyn Engine>, EngineError> {
        self.seek(called, called, &DependencyPaths::default()).engine
    }

    /// Finds the compiler on this machine, also by the paths that a person named. The engine is called `called` in reports;
    /// `table` is its name in `stickler.toml`, for messages.
    pub fn seek(self, called: &str, table: &str, paths: &DependencyPaths) -> CompilerSearch {
        let mut search = DependencySearch::new(table, paths);
        let engine = match self {
            Compiler::Ironplc => AdapterEngine::<Ironplc>::find(called, &mut search),
            Compiler::Matiec => AdapterEngine::<Matiec>::find(called, &mut search),
            Compiler::Rusty => AdapterEngine::<Rusty>::find(called, &mut search),
            Compiler::Strucpp => AdapterEngine::<Strucpp>::find(called, &mut search),
        };
        CompilerSearch {
            located: search.into_located(),
            engine: engine.map_err(|reason| EngineError::NotStarted {
                engine: format!("`{table}`"),
                reason,
            }),
        }
    }
}

/// The result of looking for a compiler.
pub struct CompilerSearch {
    /// The dependencies that were found; all that the compiler needs where there is an engine.
    pub located: Vec<FoundDependency>,
    /// The engine, or the error that says what is missing or does not work.
    pub engine: Result<Box<dyn Engine>, EngineError>,
}
