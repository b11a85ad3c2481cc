//! Real compilers behind the [`Engine`] trait: each adapter writes a program into a private folder, calls the compiler as
//! a person would on a command line, and reads what it says.
//!
//! Where a compiler shows no value of a variable, the program that it gets has further variables, which copy what is to
//! be seen into something that it does show; no line of the program moves. What a compiler does wrong is its own: an
//! adapter mends nothing.

mod builder;
mod dependencies;
mod described;
mod driver;
mod fingerprint;
mod ironplc;
mod locate;
mod matiec;
mod plain;
mod printed;
mod probe_variable;
mod rename;
mod rounds;
mod rusty;
mod source;
mod strucpp;

use crate::{Engine, EngineError};
use dependencies::DependencySearch;
pub use dependencies::{Dependency, DependencyPaths, FoundBy, FoundDependency};
pub use described::{DescribedEngine, Description};
use ironplc::Ironplc;
use matiec::Matiec;
pub use rename::declared;
use rusty::Rusty;
pub use source::{Token, Tokens, Word, tokens};
use strucpp::Strucpp;

/// A compiler for which there is an adapter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Compiler {
    /// IronPLC: `ironplcc` and `ironplcvm`.
    Ironplc,
    /// matiec: `iec2c` and a C compiler.
    Matiec,
    /// RuSTy: `plc` and a C compiler.
    Rusty,
    /// STruC++: `strucpp`, Node and a C++ compiler.
    Strucpp,
}

impl Compiler {
    /// Every compiler, by name.
    pub const ALL: [Compiler; 4] = [
        Compiler::Ironplc,
        Compiler::Matiec,
        Compiler::Rusty,
        Compiler::Strucpp,
    ];

    /// The name of the engine.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Compiler::Ironplc => "ironplc",
            Compiler::Matiec => "matiec",
            Compiler::Rusty => "rusty",
            Compiler::Strucpp => "strucpp",
        }
    }

    /// The compiler of this name, if there is one.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Compiler> {
        Compiler::ALL.into_iter().find(|compiler| compiler.name() == name)
    }

    /// Returns the address of its project, which says how it is installed.
    #[must_use]
    pub const fn project(self) -> &'static str {
        match self {
            Compiler::Ironplc => "https://www.ironplc.com",
            Compiler::Matiec => "https://github.com/beremiz/matiec",
            Compiler::Rusty => "https://github.com/PLC-lang/rusty",
            Compiler::Strucpp => "https://github.com/Autonomy-Logic/STruCpp",
        }
    }

    /// The programs and folders that it needs.
    #[must_use]
    pub const fn dependencies(self) -> &'static [Dependency] {
        match self {
            Compiler::Ironplc => ironplc::DEPENDENCIES,
            Compiler::Matiec => matiec::DEPENDENCIES,
            Compiler::Rusty => rusty::DEPENDENCIES,
            Compiler::Strucpp => strucpp::DEPENDENCIES,
        }
    }

    /// Finds the compiler on this machine by environment variables and PATH, and makes it an engine that is called `called`
    /// in reports.
    ///
    /// # Errors
    /// [`EngineError`] where a program of it is not there or does not say its version, with what can tell where it is.
    pub fn engine(self, called: &str) -> Result<Box<dyn Engine>, EngineError> {
        self.seek(called, called, &DependencyPaths::default()).engine
    }

    /// Finds the compiler on this machine, also by the paths that a person named, and makes it an engine that is called `called` in
    /// reports; `table` is its name in `stickler.toml`, for messages.
    #[must_use]
    pub fn seek(self, called: &str, table: &str, paths: &DependencyPaths) -> CompilerSearch {
        let mut search = DependencySearch::new(table, paths);
        let engine = match self {
            Compiler::Ironplc => Ironplc::find(called, &mut search).map(boxed),
            Compiler::Matiec => Matiec::find(called, &mut search).map(boxed),
            Compiler::Rusty => Rusty::find(called, &mut search).map(boxed),
            Compiler::Strucpp => Strucpp::find(called, &mut search).map(boxed),
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
    /// What of it is there; all that it needs where there is an engine.
    pub located: Vec<FoundDependency>,
    /// The engine, or what is missing or does not work.
    pub engine: Result<Box<dyn Engine>, EngineError>,
}

fn boxed<E: Engine + 'static>(engine: E) -> Box<dyn Engine> {
    Box::new(engine)
}
