//! STruC++: its compiler writes C++, which a C++ compiler builds together with a driver; the driver prints what is observed,
//! exactly.
//!
//! Its command line takes seconds to start, so a Node process of our own asks the same compiler for one program after
//! another. A program that it accepts and whose C++ cannot be built counts as a crash of the compiler.
//!
//! Basis: strucpp: `strucpp --help`, its `compile` function, and the C++ that it writes; measured on version 0.6.

mod driver;

use super::builder::{self, Builder, Language};
use super::locate::{self, failed};
use super::places::{Place, Search};
use super::source::main_program;
use super::witness::{Copies, translate_with};
use crate::process::{CommandLine, Connection, Failure, Folder, ToolLimits};
use crate::{Ability, Diagnostic, Engine, EngineError, Grade, Identity, Outcome, RunRequest, Session};
use driver::{HEADER, driver};
use serde::Deserialize;
use std::path::{Path, PathBuf};
use stickler_types::DialectName;

/// The program that Node runs.
const TRANSLATOR: &str = include_str!("strucpp/translator.mjs");

/// The longest answer of the translator, in bytes: the C++ of a program is many times as long as the program.
const LONGEST: usize = 64 << 20;

const COMPILER: Place = Place {
    key: "strucpp",
    variable: "STICKLER_STRUCPP",
    name: "strucpp",
};

const NODE: Place = Place {
    key: "node",
    variable: "STICKLER_NODE",
    name: "node",
};

/// What is to be found.
pub(super) const PLACES: &[Place] = &[COMPILER, NODE, builder::CXX];

/// The compiler, and what builds its C++.
pub(super) struct Strucpp {
    identity: Identity,
    translator: CommandLine,
    builder: Builder,
    /// Holds the program that Node runs.
    _script: Folder,
}

impl Strucpp {
    /// Finds the compiler, its package around it, Node and a C++ compiler.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str, search: &mut Search<'_>) -> Result<Strucpp, String> {
        let command = search.script(COMPILER)?;
        let node = search.program(NODE)?;
        let package = package(&command)?;
        let builder = Builder::find(search, Language::Cpp, package.join("src/runtime/include"), HEADER)?;
        let folder = Folder::new()?;
        let version = locate::version(&node, &[&command.to_string_lossy(), "--version"], &folder)?;
        let script = folder.write("translator.mjs", TRANSLATOR)?;
        let arguments = [script, package.join("dist/index.js")];
        Ok(Strucpp {
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                // It documents no dialect of ours; its language is the third edition with widening.
                dialects: vec![DialectName::IronplcEd3],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // It has no codes.
                grade: Grade::Line,
            },
            translator: CommandLine::of(
                node.to_string_lossy().into_owned(),
                arguments.map(|path| path.to_string_lossy().into_owned()).to_vec(),
            ),
            builder,
            _script: folder,
        })
    }
}

/// The package that a command belongs to: the nearest folder around it that has what is needed.
fn package(command: &Path) -> Result<PathBuf, String> {
    // On PATH stands a link into the package.
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

impl Engine for Strucpp {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(StrucppSession {
            engine: self,
            folder,
            translator: None,
        }))
    }
}

/// A translator that lives as long as it answers, and a folder in which one program at a time is built and run.
struct StrucppSession<'e> {
    engine: &'e Strucpp,
    folder: Folder,
    /// `None` before the first request and after a failure.
    translator: Option<Connection>,
}

impl Session for StrucppSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn check(&mut self, _: DialectName, source: &str) -> Outcome {
        match self.translate(source) {
            Ok(()) => Outcome::Accepted,
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, _: DialectName, _: &str) -> Outcome {
        Outcome::Unsupported {
            reason: "it gives no normalised source".to_owned(),
        }
    }
}

/// What the translator answers.
#[derive(Deserialize)]
struct Translated {
    #[serde(default)]
    success: bool,
    #[serde(default)]
    errors: Vec<Told>,
    #[serde(default)]
    program: String,
    #[serde(default)]
    header: String,
    /// What the compiler threw, where it did.
    crash: Option<String>,
}

/// A diagnostic of the compiler. Line 0 is no line.
#[derive(Deserialize)]
struct Told {
    message: String,
    line: u32,
    column: u32,
    severity: String,
}

impl Told {
    fn diagnostic(self) -> Diagnostic {
        Diagnostic {
            line: Some(self.line).filter(|&line| line > 0),
            column: Some(self.column).filter(|&column| self.line > 0 && column > 0),
            message: self.message,
            ..Diagnostic::default()
        }
    }
}

impl StrucppSession<'_> {
    fn try_run(&mut self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let Some(main) = main_program(request.source) else {
            self.translate(request.source)?;
            return Ok(Outcome::Accepted);
        };
        let copies = Copies::of(request);
        let driver =
            driver(request, &copies, &main.name).map_err(|reason| Outcome::Unsupported { reason })?;
        translate_with(request, &main, copies.witnesses(), |text| self.translate(text))?;
        self.engine.builder.build(&driver.text, &self.folder)?;
        driver.execute(&self.folder, request)
    }

    /// Translates a program to C++.
    fn translate(&mut self, source: &str) -> Result<(), Outcome> {
        let translated = self.ask(source)?;
        if let Some(reason) = translated.crash {
            return Err(Outcome::Crashed { reason });
        }
        if !translated.success {
            return Err(rejected(translated.errors));
        }
        self.folder
            .write("program.cpp", &translated.program)
            .map_err(failed)?;
        self.folder
            .write("generated.hpp", &translated.header)
            .map_err(failed)?;
        Ok(())
    }

    fn ask(&mut self, source: &str) -> Result<Translated, Outcome> {
        let limits = ToolLimits::default();
        let mut translator = match self.translator.take() {
            Some(translator) => translator,
            None => Connection::open(&self.engine.translator, LONGEST).map_err(failed)?,
        };
        let mut line = serde_json::json!({ "source": source }).to_string().into_bytes();
        line.push(b'\n');
        match translator.exchange(line, limits.time) {
            Ok(reply) => {
                self.translator = Some(translator);
                serde_json::from_slice(&reply)
                    .map_err(|error| failed(format!("its translator answered nonsense: {error}")))
            }
            Err(Failure::Ended) => Err(Outcome::Crashed {
                reason: translator.end(),
            }),
            Err(Failure::TimedOut) => Err(Outcome::TimedOut {
                after_ms: u64::try_from(limits.time.as_millis()).unwrap_or(u64::MAX),
            }),
            Err(Failure::Memory(limit)) => Err(Outcome::Crashed {
                reason: format!("it held more than {} MiB of memory", limit >> 20),
            }),
            Err(Failure::Flood) => Err(Outcome::Crashed {
                reason: format!("it wrote more than {LONGEST} bytes"),
            }),
        }
    }
}

/// The rejection that these errors are; warnings reject nothing.
fn rejected(errors: Vec<Told>) -> Outcome {
    let errors = errors.into_iter().filter(|told| told.severity == "error");
    let mut diagnostics: Vec<Diagnostic> = errors.map(Told::diagnostic).collect();
    if diagnostics.is_empty() {
        return Outcome::Crashed {
            reason: "it fails without saying why".to_owned(),
        };
    }
    diagnostics.sort_by_key(|diagnostic| (diagnostic.line, diagnostic.column));
    diagnostics.dedup();
    Outcome::Rejected { diagnostics }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_reject_and_warnings_do_not() {
        let answer = r#"{"success":false,"program":"","header":"","errors":[
            {"message":"Undeclared variable 'Q'","line":4,"column":2,"severity":"error"},
            {"message":"narrowing","line":3,"column":7,"severity":"warning"},
            {"message":"unexpected character","line":0,"column":0,"severity":"error"}]}"#;
        let translated: Translated = serde_json::from_str(answer).unwrap();
        let Outcome::Rejected { diagnostics } = rejected(translated.errors) else {
            panic!("not rejected")
        };
        let places: Vec<_> = diagnostics.iter().map(|told| (told.line, told.column)).collect();
        assert_eq!(places, [(None, None), (Some(4), Some(2))]);
        assert!(matches!(rejected(Vec::new()), Outcome::Crashed { .. }));
    }

    #[test]
    fn a_command_outside_the_package_is_told() {
        let folder = Folder::new().unwrap();
        let command = folder.write("strucpp", "").unwrap();
        assert!(package(&command).unwrap_err().contains("STICKLER_STRUCPP"));
    }
}
