//! Real compilers behind the [`Engine`] trait: each adapter writes a program into a private folder, calls the compiler as
//! a person would on a command line, and reads what it says.
//!
//! Where a compiler shows no value of a variable, the program that it gets has further variables, which copy what is to
//! be seen into something that it does show; no line of the program moves. What a compiler does wrong is its own: an
//! adapter mends nothing.

mod builder;
mod driver;
mod ironplc;
mod locate;
mod matiec;
mod printed;
mod source;
mod strucpp;
mod witness;

use crate::{Engine, EngineError};
use ironplc::Ironplc;
use matiec::Matiec;
use strucpp::Strucpp;

/// A compiler for which there is an adapter.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Compiler {
    /// IronPLC: `ironplcc` and `ironplcvm`.
    Ironplc,
    /// matiec: `iec2c` and a C compiler.
    Matiec,
    /// STruC++: `strucpp`, Node and a C++ compiler.
    Strucpp,
}

impl Compiler {
    /// Every compiler, by name.
    pub const ALL: [Compiler; 3] = [Compiler::Ironplc, Compiler::Matiec, Compiler::Strucpp];

    /// The name of the engine.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Compiler::Ironplc => "ironplc",
            Compiler::Matiec => "matiec",
            Compiler::Strucpp => "strucpp",
        }
    }

    /// The compiler of this name, if there is one.
    #[must_use]
    pub fn from_name(name: &str) -> Option<Compiler> {
        Compiler::ALL.into_iter().find(|compiler| compiler.name() == name)
    }

    /// Finds the compiler on this machine and makes it an engine that is called `called` in reports.
    ///
    /// # Errors
    /// [`EngineError`] where a program of it is not there or does not say its version, with the environment variable
    /// that tells where it is.
    pub fn engine(self, called: &str) -> Result<Box<dyn Engine>, EngineError> {
        let engine = match self {
            Compiler::Ironplc => Ironplc::find(called).map(boxed),
            Compiler::Matiec => Matiec::find(called).map(boxed),
            Compiler::Strucpp => Strucpp::find(called).map(boxed),
        };
        engine.map_err(|reason| EngineError::NotStarted {
            engine: format!("`{}`", self.name()),
            reason,
        })
    }
}

fn boxed<E: Engine + 'static>(engine: E) -> Box<dyn Engine> {
    Box::new(engine)
}
