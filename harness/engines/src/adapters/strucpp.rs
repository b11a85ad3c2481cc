//! STruC++: its compiler writes C++, which a C++ compiler builds together with a driver; the driver prints the observed values
//! exactly.
//!
//! The compiler's command line takes seconds to start, so a Node process of the adapter's own asks the same compiler for one
//! program after another. A program that the compiler accepts and whose C++ cannot be built counts as a crash of the compiler.
//!
//! Basis: strucpp: `strucpp --help`, its `compile` function, and the C++ that it writes; measured on version 0.6.

mod driver;
mod pack;
mod reproduction;

use super::builder::{self, Builder, Language};
use super::dependencies::{Dependency, DependencySearch};
use super::fingerprint::Fingerprint;
use super::locate::{self, failed, unsupported};
use super::probe_variable::{ProbeVariables, translate_with};
use super::source::main_program;
use crate::process::{CommandLine, Connection, Failure, Folder, ToolLimits};
use crate::{
    Ability, Diagnostic, Engine, EngineError, Grade, Identity, NoReproduction, Outcome, Packed, Reproduction,
    RunRequest, Session, Severity,
};
use driver::{HEADER, StrucppSubject, driver};
pub(super) use reproduction::reproduce;
use serde::Deserialize;
use std::collections::HashSet;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, OnceLock, PoisonError};
use stickler_types::{Code, DialectName};

/// The dialect of STruC++'s own documentation.
const DIALECT: DialectName = DialectName::STRUCPP;

/// The script that Node runs.
const TRANSLATOR: &str = include_str!("strucpp/translator.mjs");

/// The longest answer of the translator, in bytes: the C++ of a program is many times as long as the program.
const MAX_ANSWER_LEN: usize = 64 << 20;

const COMPILER: Dependency = Dependency {
    key: "strucpp",
    variable: "STICKLER_STRUCPP",
    name: "strucpp",
};

const NODE: Dependency = Dependency {
    key: "node",
    variable: "STICKLER_NODE",
    name: "node",
};

/// The dependencies of the adapter.
pub(super) const DEPENDENCIES: &[Dependency] = &[COMPILER, NODE, builder::CXX];

/// The compiler, and the builder of its C++.
pub(super) struct Strucpp {
    identity: Identity,
    translator: CommandLine,
    builder: Builder,
    node: PathBuf,
    command: PathBuf,
    package: PathBuf,
    /// The folder of the compiler's run-time headers.
    headers: PathBuf,
    /// The names that programs in a pack must not declare; see [`Strucpp::taken`].
    taken: OnceLock<HashSet<String>>,
    /// Translators of sessions that have ended, for later sessions: Node is slow to start.
    idle: Mutex<Vec<Connection>>,
    /// The folder of the script that Node runs.
    _script: Folder,
}

impl Strucpp {
    /// Finds the compiler, its package around it, Node and a C++ compiler.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str, search: &mut DependencySearch<'_>) -> Result<Strucpp, String> {
        let command = search.script(COMPILER)?;
        let node = search.program(NODE)?;
        let package = package(&command)?;
        let headers = package.join("src/runtime/include");
        let builder = Builder::find(search, Language::Cpp, headers.clone(), HEADER)?;
        let folder = Folder::new()?;
        let version = locate::version(&node, &[&command.to_string_lossy(), "--version"], &folder)?;
        let script = folder.write("translator.mjs", TRANSLATOR)?;
        let arguments = [script, package.join("dist/index.js")];
        Ok(Strucpp {
            command,
            node: node.clone(),
            package: package.clone(),
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                dialects: vec![DIALECT],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
                // The compiler has no diagnostic codes.
                grade: Grade::Line,
                lacks: Vec::new(),
            },
            translator: CommandLine::of(
                node.to_string_lossy().into_owned(),
                arguments.map(|path| path.to_string_lossy().into_owned()).to_vec(),
            ),
            builder,
            headers,
            taken: OnceLock::new(),
            idle: Mutex::new(Vec::new()),
            _script: folder,
        })
    }

    /// Returns the names in the run-time headers, in capitals, since the compiler writes the names of a program in capitals. A
    /// program that declares one of them clashes with the header when it is alone, and would hide it within a namespace of its
    /// own.
    fn taken(&self) -> &HashSet<String> {
        self.taken.get_or_init(|| {
            // A file that cannot be read is reported by the compiler.
            let files = std::fs::read_dir(&self.headers).into_iter().flatten().flatten();
            let texts = files.filter_map(|file| std::fs::read_to_string(file.path()).ok());
            texts.fold(HashSet::new(), |mut taken, text| {
                taken.extend(capitals(&text));
                taken
            })
        })
    }
}

fn capitals(text: &str) -> impl Iterator<Item = String> + '_ {
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

impl Engine for Strucpp {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = locate::session_folder(&self.identity)?;
        Ok(Box::new(StrucppSession {
            engine: self,
            folder,
            translator: self.idle.lock().unwrap_or_else(PoisonError::into_inner).pop(),
        }))
    }

    fn fingerprint(&self) -> Option<String> {
        let mut fingerprint = Fingerprint::of("strucpp")
            .program(&self.node)
            .folder(&self.package.join("dist"))
            .folder(&self.headers)
            .with(self.builder.fingerprint());
        // The compiler's other parts lie beside it or above, wherever its installer put them; these files list them.
        for file in [
            "package.json",
            "package-lock.json",
            "node_modules/.package-lock.json",
        ] {
            let file = self.package.join(file);
            if file.is_file() {
                fingerprint = fingerprint.file(&file);
            }
        }
        fingerprint.finish()
    }

    /// Returns 48: larger packs take more memory, and save little time for each program.
    fn pack_size(&self) -> usize {
        48
    }

    fn reproduce(&self, request: &RunRequest<'_>, ability: Ability) -> Result<Reproduction, NoReproduction> {
        reproduce(request, ability)
    }

    fn tools(&self) -> Vec<(String, PathBuf)> {
        let tools = [
            (NODE, self.node.as_path()),
            (COMPILER, &self.command),
            (builder::CXX, self.builder.compiler()),
        ];
        let headers = (reproduction::HEADERS.to_owned(), self.headers.clone());
        let tools = tools.map(|(tool, path)| tool.at(path));
        tools.into_iter().chain([headers]).collect()
    }
}

/// A session: a translator that lives as long as it answers, and a folder in which one program at a time is built and run.
struct StrucppSession<'e> {
    engine: &'e Strucpp,
    folder: Folder,
    /// The running translator; `None` before the first request and after a failure.
    translator: Option<Connection>,
}

impl Drop for StrucppSession<'_> {
    fn drop(&mut self) {
        let mut idle = self.engine.idle.lock().unwrap_or_else(PoisonError::into_inner);
        idle.extend(self.translator.take());
    }
}

impl Session for StrucppSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        pack::run(self, requests)
    }

    fn check(&mut self, _: DialectName, source: &str) -> Outcome {
        match self.translate(source) {
            Ok(translated) => Outcome::Accepted {
                warnings: translated.diagnostics(),
            },
            Err(outcome) => outcome,
        }
    }
}

/// The answer of the translator.
#[derive(Deserialize)]
struct Translated {
    #[serde(default)]
    success: bool,
    #[serde(default)]
    diagnostics: Vec<TranslatorDiagnostic>,
    #[serde(default)]
    program: String,
    #[serde(default)]
    header: String,
    /// The exception that the compiler threw, if any.
    crash: Option<String>,
}

/// A diagnostic of the compiler. Line 0 stands for an unknown line.
#[derive(Deserialize)]
struct TranslatorDiagnostic {
    message: String,
    line: u32,
    column: u32,
    severity: String,
}

impl Translated {
    /// Returns the diagnostics, sorted by line and column, each once.
    fn diagnostics(&self) -> Vec<Diagnostic> {
        let reported = self.diagnostics.iter();
        let mut diagnostics: Vec<Diagnostic> = reported.map(TranslatorDiagnostic::diagnostic).collect();
        diagnostics.sort_by_key(|diagnostic| (diagnostic.line, diagnostic.column));
        diagnostics.dedup();
        diagnostics
    }
}

impl TranslatorDiagnostic {
    /// Returns the diagnostic. The compiler has no codes; what it cannot read is Stickler's P0002.
    ///
    /// Basis: strucpp: `src/frontend/parser-error-message-provider.ts`, and the messages of its lexer; measured.
    fn diagnostic(&self) -> Diagnostic {
        let is_unread = ["unexpected character: ", "Unexpected ", "Expected "]
            .iter()
            .any(|beginning| self.message.starts_with(beginning));
        let severity = match self.severity.as_str() {
            "error" => Severity::Error,
            _ => Severity::Warning,
        };
        Diagnostic {
            severity,
            code: is_unread.then(|| Code::SyntaxError.as_str().to_owned()),
            line: Some(self.line).filter(|&line| line > 0),
            column: Some(self.column).filter(|&column| self.line > 0 && column > 0),
            message: self.message.clone(),
            ..Diagnostic::default()
        }
    }
}

/// A program that was accepted, and the values that its driver observes.
struct AcceptedProgram<'r> {
    subject: StrucppSubject<'r>,
    translated: Translated,
}

impl StrucppSession<'_> {
    fn try_run(&mut self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let accepted = self.accepted(request)?;
        let warnings = accepted.translated.diagnostics();
        Ok(self.build_and_run(&accepted)?.with_warnings(warnings))
    }

    /// Translates a program that is to be run.
    ///
    /// # Errors
    /// The outcome of a program that is not accepted, or that is and has no main program.
    fn accepted<'r>(&mut self, request: &RunRequest<'r>) -> Result<AcceptedProgram<'r>, Outcome> {
        let Some(main) = main_program(request) else {
            let warnings = self.translate(request.source)?.diagnostics();
            return Err(Outcome::Accepted { warnings });
        };
        driver::kinds(request).map_err(unsupported)?;
        let probes = ProbeVariables::of(request);
        let translated = translate_with(request, &main, probes.list(), |text| self.translate(text))?;
        let subject = StrucppSubject {
            request: *request,
            probes,
            program: main.name,
        };
        Ok(AcceptedProgram { subject, translated })
    }

    /// Builds and runs a program that was accepted.
    fn build_and_run(&self, accepted: &AcceptedProgram<'_>) -> Result<Outcome, Outcome> {
        let write = |name: &str, text: &str| self.folder.write(name, text).map(drop).map_err(failed);
        write("program.cpp", &accepted.translated.program)?;
        write("generated.hpp", &accepted.translated.header)?;
        let driver = driver(&[&accepted.subject]).map_err(unsupported)?;
        self.engine.builder.build(&driver.text, &self.folder)?;
        driver.execute(&self.folder)
    }

    /// Translates a program to C++.
    fn translate(&mut self, source: &str) -> Result<Translated, Outcome> {
        let translated = self.ask(source)?;
        if let Some(reason) = translated.crash {
            return Err(Outcome::Crashed { reason });
        }
        if !translated.success {
            return Err(rejected(translated.diagnostics()));
        }
        Ok(translated)
    }

    fn ask(&mut self, source: &str) -> Result<Translated, Outcome> {
        let limits = ToolLimits::default();
        let mut translator = match self.translator.take() {
            Some(translator) => translator,
            None => Connection::open(&self.engine.translator, MAX_ANSWER_LEN).map_err(failed)?,
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
                reason: format!("it wrote more than {MAX_ANSWER_LEN} bytes"),
            }),
        }
    }
}

/// Returns the rejection for these diagnostics; warnings reject nothing.
fn rejected(diagnostics: Vec<Diagnostic>) -> Outcome {
    match diagnostics.iter().any(Diagnostic::is_error) {
        true => Outcome::rejected(diagnostics),
        false => Outcome::Crashed {
            reason: "it fails without saying why".to_owned(),
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_reject_and_warnings_do_not() {
        let answer = r#"{"success":false,"program":"","header":"","diagnostics":[
            {"message":"Undeclared variable 'Q'","line":4,"column":2,"severity":"error"},
            {"message":"narrowing","line":3,"column":7,"severity":"warning"},
            {"message":"unexpected character: ->#<- at offset: 7, skipped 1 characters.","line":0,"column":0,"severity":"error"}]}"#;
        let translated: Translated = serde_json::from_str(answer).unwrap();
        let Outcome::Rejected { diagnostics } = rejected(translated.diagnostics()) else {
            panic!("not rejected")
        };
        let places: Vec<_> = diagnostics
            .iter()
            .map(|diagnostic| (diagnostic.line, diagnostic.column, diagnostic.code.as_deref()))
            .collect();
        assert_eq!(places, [(None, None, Some("P0002")), (Some(4), Some(2), None)]);
        assert!(matches!(rejected(Vec::new()), Outcome::Crashed { .. }));
        let accepted = r#"{"success":true,"diagnostics":[{"message":"narrowing","line":3,"column":7,"severity":"warning"}]}"#;
        let accepted: Translated = serde_json::from_str(accepted).unwrap();
        let warnings = accepted.diagnostics();
        assert_eq!(warnings.len(), 1);
        assert_eq!(
            (warnings[0].severity, warnings[0].line),
            (Severity::Warning, Some(3))
        );
    }

    #[test]
    fn names_in_capitals_are_taken() {
        let found: Vec<String> = capitals("using IEC_TIME = IECVar<TIME_t>; // an ADD_X").collect();
        let named: Vec<&str> = found
            .iter()
            .map(String::as_str)
            .filter(|name| !name.is_empty())
            .collect();
        assert_eq!(named, ["TIME", "ADD_X"]);
    }

    #[test]
    fn a_command_outside_the_package_is_told() {
        let folder = Folder::new().unwrap();
        let command = folder.write("strucpp", "").unwrap();
        assert!(package(&command).unwrap_err().contains("STICKLER_STRUCPP"));
    }
}
