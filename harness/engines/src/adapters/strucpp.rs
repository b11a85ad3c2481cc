//! STruC++: its compiler writes C++, which a C++ compiler builds together with a driver; the driver prints what is observed,
//! exactly.
//!
//! Its command line takes seconds to start, so a Node process of our own asks the same compiler for one program after
//! another. A program that it accepts and whose C++ cannot be built counts as a crash of the compiler.
//!
//! Basis: strucpp: `strucpp --help`, its `compile` function, and the C++ that it writes; measured on version 0.6.

mod driver;

use super::locate::{self, call, first_error};
use super::source::{MainProgram, main_program};
use super::witness::{Copies, Witness, with_witnesses};
use crate::process::{CommandLine, Connection, Failure, Folder, ToolLimits};
use crate::{Ability, Diagnostic, Engine, EngineError, Identity, Outcome, RunRequest, Session};
use driver::{Driver, HEADER, SUBSCRIPT};
use serde::Deserialize;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use stickler_types::{DialectName, Fault};

/// The program that Node runs.
const TRANSLATOR: &str = include_str!("strucpp/translator.mjs");

/// The longest answer of the translator, in bytes: the C++ of a program is many times as long as the program.
const LONGEST: usize = 64 << 20;

/// The compiler, and what builds its C++.
pub(super) struct Strucpp {
    identity: Identity,
    translator: CommandLine,
    headers: PathBuf,
    cpp_compiler: PathBuf,
    /// Holds the translator, and [`HEADER`] with what the C++ compiler made of it.
    prepared: Folder,
}

impl Strucpp {
    /// Finds `strucpp` on PATH or by `STICKLER_STRUCPP`, and its package around it; Node (`node`, `STICKLER_NODE`) and a
    /// C++ compiler (`c++`, `STICKLER_CXX`).
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str) -> Result<Strucpp, String> {
        let command = locate::program("strucpp", "STICKLER_STRUCPP")?;
        let node = locate::program("node", "STICKLER_NODE")?;
        let cpp_compiler = locate::program("c++", "STICKLER_CXX")?;
        let package = package(&command)?;
        let prepared = Folder::new()?;
        let version = locate::version(&node, &[&command.to_string_lossy(), "--version"], &prepared)?;
        let script = prepared.write("translator.mjs", TRANSLATOR)?;
        let arguments = [script, package.join("dist/index.js")];
        let strucpp = Strucpp {
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                // It documents no dialect of ours; its language is the third edition with widening.
                dialects: vec![DialectName::IronplcEd3],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
            },
            translator: CommandLine::of(
                node.to_string_lossy().into_owned(),
                arguments.map(|path| path.to_string_lossy().into_owned()).to_vec(),
            ),
            headers: package.join("src/runtime/include"),
            cpp_compiler,
            prepared,
        };
        strucpp.prepare()?;
        Ok(strucpp)
    }

    /// Compiles the headers once, since that takes most of the time of building a small program.
    fn prepare(&self) -> Result<(), String> {
        self.prepared.write("stickler.hpp", HEADER)?;
        let arguments = self.cpp_arguments(&["-x", "c++-header", "stickler.hpp", "-o", "stickler.hpp.gch"]);
        let ended = call(&self.cpp_compiler, &arguments, &self.prepared)
            .map_err(|outcome| format!("the C++ compiler {}", locate::reason(&outcome)))?;
        match ended.status.success() {
            true => Ok(()),
            false => Err(format!(
                "`{}` does not compile the headers in `{}`: {}",
                self.cpp_compiler.display(),
                self.headers.display(),
                first_error(&ended)
            )),
        }
    }

    /// The arguments of every call of the C++ compiler, and these.
    fn cpp_arguments(&self, further: &[&str]) -> Vec<OsString> {
        let mut arguments: Vec<OsString> = ["-std=c++17", "-O0", "-w", "-I"].map(OsString::from).to_vec();
        arguments.push(self.prepared.path().into());
        arguments.push("-I".into());
        arguments.push(self.headers.as_os_str().into());
        arguments.extend(further.iter().map(OsString::from));
        arguments
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
        let folder = Folder::new().map_err(|reason| EngineError::NotStarted {
            engine: self.identity.name.clone(),
            reason,
        })?;
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

fn failed(message: String) -> Outcome {
    Outcome::Error { message }
}

impl StrucppSession<'_> {
    fn try_run(&mut self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let Some(main) = main_program(request.source) else {
            self.translate(request.source)?;
            return Ok(Outcome::Accepted);
        };
        let copies = Copies::of(request);
        let driver =
            Driver::of(request, &copies, &main.name).map_err(|reason| Outcome::Unsupported { reason })?;
        self.translate_with(request.source, &main, copies.witnesses())?;
        self.build(&driver)?;
        self.execute(&driver, request)
    }

    /// Translates a program with its witnesses. Where they are not accepted, the program alone decides whether it is.
    fn translate_with(
        &mut self,
        source: &str,
        main: &MainProgram,
        witnesses: &[Witness],
    ) -> Result<(), Outcome> {
        if witnesses.is_empty() {
            return self.translate(source);
        }
        let reason = match main.returns {
            true => "a program that may return early shows only its simple variables".to_owned(),
            false => match self.translate(&with_witnesses(source, main, witnesses)) {
                Ok(()) => return Ok(()),
                Err(outcome) => format!(
                    "the copies of its values are not accepted: {}",
                    locate::told(&outcome)
                ),
            },
        };
        self.translate(source)?;
        Err(Outcome::Unsupported { reason })
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
            Err(Failure::Flood) => Err(Outcome::Crashed {
                reason: format!("it wrote more than {LONGEST} bytes"),
            }),
        }
    }

    /// Builds what was translated.
    fn build(&self, driver: &Driver<'_>) -> Result<(), Outcome> {
        self.folder.write("driver.cpp", driver.text()).map_err(failed)?;
        let arguments = self
            .engine
            .cpp_arguments(&["driver.cpp", "-I", ".", "-o", "driver"]);
        let ended = call(&self.engine.cpp_compiler, &arguments, &self.folder)?;
        match ended.code()? {
            0 => Ok(()),
            _ => Err(Outcome::Crashed {
                reason: format!(
                    "it accepts the program, and the C++ that it wrote cannot be built: {}",
                    first_error(&ended)
                ),
            }),
        }
    }

    fn execute(&self, driver: &Driver<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let nothing: [&str; 0] = [];
        let ended = locate::execute(&self.folder.path().join("driver"), &nothing, &self.folder)?;
        let faulted = |fault| Outcome::Faulted {
            fault,
            line: None,
            values: Vec::new(),
        };
        if ended.stopped_by_arithmetic() {
            return Ok(faulted(Fault::DivisionByZero));
        }
        match ended.code()? {
            0 => match driver.values(&ended.stdout, request) {
                Ok(values) => Ok(Outcome::Executed { values }),
                Err(message) => Err(failed(message)),
            },
            SUBSCRIPT => Ok(faulted(Fault::SubscriptRange)),
            _ => Err(ended.crashed()),
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
