//! Real compilers behind the [`Engine`] trait: each adapter writes a program into a private folder, calls the compiler as
//! a person would on a command line, and reads what it says.
//!
//! Where a compiler shows no value of a variable, the program that it gets has further variables, which copy what is to
//! be seen into something that it does show; no line of the program moves. What a compiler does wrong is its own: an
//! adapter mends nothing.

mod apart;
mod builder;
mod described;
mod driver;
mod fingerprint;
mod ironplc;
mod locate;
mod matiec;
mod places;
mod plain;
mod printed;
mod rounds;
mod rusty;
mod source;
mod strucpp;
mod witness;

use crate::{Engine, EngineError};
pub use apart::declared;
pub use described::{DescribedEngine, Description};
use ironplc::Ironplc;
use matiec::Matiec;
use places::Search;
pub use places::{FoundBy, Located, Place, Places};
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

    /// Where its project is, and says how it is installed.
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
    pub const fn places(self) -> &'static [Place] {
        match self {
            Compiler::Ironplc => ironplc::PLACES,
            Compiler::Matiec => matiec::PLACES,
            Compiler::Rusty => rusty::PLACES,
            Compiler::Strucpp => strucpp::PLACES,
        }
    }

    /// Finds the compiler on this machine by environment variables and PATH, and makes it an engine that is called `called`
    /// in reports.
    ///
    /// # Errors
    /// [`EngineError`] where a program of it is not there or does not say its version, with what can tell where it is.
    pub fn engine(self, called: &str) -> Result<Box<dyn Engine>, EngineError> {
        self.seek(called, called, &Places::default()).engine
    }

    /// Finds the compiler on this machine, also by what `places` says, and makes it an engine that is called `called` in
    /// reports; `table` is its name in `stickler.toml`, for messages.
    #[must_use]
    pub fn seek(self, called: &str, table: &str, places: &Places) -> Sought {
        let mut search = Search::new(table, places);
        let engine = match self {
            Compiler::Ironplc => Ironplc::find(called, &mut search).map(boxed),
            Compiler::Matiec => Matiec::find(called, &mut search).map(boxed),
            Compiler::Rusty => Rusty::find(called, &mut search).map(boxed),
            Compiler::Strucpp => Strucpp::find(called, &mut search).map(boxed),
        };
        Sought {
            located: search.into_located(),
            engine: engine.map_err(|reason| EngineError::NotStarted {
                engine: format!("`{table}`"),
                reason,
            }),
        }
    }
}

/// What came of looking for a compiler.
pub struct Sought {
    /// What of it is there; all that it needs where there is an engine.
    pub located: Vec<Located>,
    /// The engine, or what is missing or does not work.
    pub engine: Result<Box<dyn Engine>, EngineError>,
}

fn boxed<E: Engine + 'static>(engine: E) -> Box<dyn Engine> {
    Box::new(engine)
}
