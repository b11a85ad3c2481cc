//! matiec: `iec2c` translates a program to C, a C compiler builds it together with a driver, and the driver prints what is
//! observed, exactly.
//!
//! A program that `iec2c` accepts and whose C cannot be built counts as a crash of the compiler: it neither rejected the
//! program nor made one that runs.
//!
//! Basis: matiec: `iec2c -h` and the C that it writes; measured.

mod diagnostics;
mod driver;

use super::locate::{self, call, first_error, told};
use super::source::{MainProgram, main_program, words};
use super::witness::{Copies, Witness, with_witnesses};
use crate::process::Folder;
use crate::{Ability, Engine, EngineError, Identity, Outcome, RunRequest, Session};
use driver::Driver;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use stickler_types::{DialectName, Fault};

/// The configuration without which no C is written. It stands behind the program and moves no line of it.
fn configuration(program: &str) -> String {
    format!(
        "\nCONFIGURATION stickler_configuration RESOURCE stickler_resource ON PLC \
         TASK stickler_task(INTERVAL := T#1s, PRIORITY := 0); \
         PROGRAM stickler_instance WITH stickler_task : {program}; END_RESOURCE END_CONFIGURATION\n"
    )
}

/// The header that every built program includes; it is compiled once.
const HEADER: &str =
    "#include \"iec_std_lib.h\"\n#include \"accessor.h\"\n#include <stdio.h>\n#include <string.h>\n";

/// The compiler, its library, and a C compiler.
pub(super) struct Matiec {
    identity: Identity,
    compiler: PathBuf,
    library: PathBuf,
    c_compiler: PathBuf,
    /// Holds [`HEADER`] and what the C compiler made of it.
    prepared: Folder,
}

impl Matiec {
    /// Finds `iec2c` on PATH or by `STICKLER_IEC2C`, its library beside it or by `STICKLER_MATIEC_LIB`, and a C compiler:
    /// `cc` on PATH or what `STICKLER_CC` names.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn find(called: &str) -> Result<Matiec, String> {
        let compiler = locate::program("iec2c", "STICKLER_IEC2C")?;
        let library = locate::folder(
            "the library of iec2c",
            "STICKLER_MATIEC_LIB",
            &libraries(&compiler),
        )?;
        let c_compiler = locate::program("cc", "STICKLER_CC")?;
        let prepared = Folder::new()?;
        let version = locate::version(&compiler, &["-v"], &prepared)?;
        let matiec = Matiec {
            identity: Identity {
                name: called.to_owned(),
                version: version.rsplit(' ').next().unwrap_or_default().to_owned(),
                dialects: vec![DialectName::Matiec],
                abilities: vec![Ability::Check, Ability::Execute, Ability::Scans],
            },
            compiler,
            library,
            c_compiler,
            prepared,
        };
        matiec.prepare()?;
        Ok(matiec)
    }

    /// Compiles the header once, since that takes most of the time of building a small program. A C compiler that makes no
    /// use of it reads the header itself.
    fn prepare(&self) -> Result<(), String> {
        self.prepared.write("stickler.h", HEADER)?;
        let arguments = self.c_arguments(&["stickler.h", "-o", "stickler.h.gch"]);
        let ended = call(&self.c_compiler, &arguments, &self.prepared)
            .map_err(|outcome| format!("the C compiler {}", locate::reason(&outcome)))?;
        match ended.status.success() {
            true => Ok(()),
            false => Err(format!(
                "`{}` does not compile the library of iec2c in `{}`: {}",
                self.c_compiler.display(),
                self.library.display(),
                first_error(&ended)
            )),
        }
    }

    /// The arguments of every call of the C compiler, and these. Without optimisation, so that what C leaves undefined
    /// does what the machine does.
    fn c_arguments(&self, further: &[&str]) -> Vec<OsString> {
        let mut arguments: Vec<OsString> = ["-O0", "-w", "-I"].map(OsString::from).to_vec();
        arguments.push(self.prepared.path().into());
        arguments.push("-I".into());
        arguments.push(self.library.join("C").into());
        arguments.extend(further.iter().map(OsString::from));
        arguments
    }
}

/// Where the library may be: in the source tree, or where it is installed.
fn libraries(compiler: &Path) -> [PathBuf; 3] {
    let beside = |path: &str| compiler.parent().unwrap_or(Path::new("")).join(path);
    [
        beside("lib"),
        beside("../lib/matiec"),
        beside("../share/matiec/lib"),
    ]
}

impl Engine for Matiec {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        let folder = Folder::new().map_err(|reason| EngineError::NotStarted {
            engine: self.identity.name.clone(),
            reason,
        })?;
        Ok(Box::new(MatiecSession { engine: self, folder }))
    }
}

/// A folder in which one program at a time is translated, built and run.
struct MatiecSession<'e> {
    engine: &'e Matiec,
    folder: Folder,
}

impl Session for MatiecSession<'_> {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        self.try_run(request).unwrap_or_else(|outcome| outcome)
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match speaks(dialect).and_then(|()| self.translate(source)) {
            Ok(()) => Outcome::Accepted,
            Err(outcome) => outcome,
        }
    }

    fn render(&mut self, _: DialectName, _: &str) -> Outcome {
        Outcome::Unsupported {
            reason: "iec2c gives no normalised source".to_owned(),
        }
    }
}

fn speaks(dialect: DialectName) -> Result<(), Outcome> {
    match dialect {
        DialectName::Matiec => Ok(()),
        _ => Err(Outcome::Unsupported {
            reason: format!("it does not speak {dialect}"),
        }),
    }
}

fn failed(message: String) -> Outcome {
    Outcome::Error { message }
}

impl MatiecSession<'_> {
    fn try_run(&self, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        speaks(request.dialect)?;
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
    fn translate_with(&self, source: &str, main: &MainProgram, witnesses: &[Witness]) -> Result<(), Outcome> {
        let plain = || {
            let mut text = source.to_owned();
            if !words(source).any(|word| word.is("CONFIGURATION")) {
                text.push_str(&configuration(&main.name));
            }
            text
        };
        if witnesses.is_empty() {
            return self.translate(&plain());
        }
        let reason = match main.returns {
            true => "a program that may return early shows only its simple variables".to_owned(),
            false => {
                let text = with_witnesses(source, main, witnesses);
                match self.translate(&(text + &plain()[source.len()..])) {
                    Ok(()) => return Ok(()),
                    Err(outcome) => format!("the copies of its values are not accepted: {}", told(&outcome)),
                }
            }
        };
        self.translate(&plain())?;
        Err(Outcome::Unsupported { reason })
    }

    /// Translates a program to C.
    fn translate(&self, source: &str) -> Result<(), Outcome> {
        self.folder.write("program.st", source).map_err(failed)?;
        for left in ["POUS.c", "POUS.h"] {
            // What an earlier program left behind must not be taken for this one.
            let _ = std::fs::remove_file(self.folder.path().join(left));
        }
        let library = self.engine.library.as_os_str();
        let arguments = [
            "-i".as_ref(),
            "-I".as_ref(),
            library,
            "-T".as_ref(),
            ".".as_ref(),
            "program.st".as_ref(),
        ];
        let ended = call(&self.engine.compiler, &arguments, &self.folder)?;
        diagnostics::outcome(&ended)
    }

    /// Builds what was translated.
    fn build(&self, driver: &Driver<'_>) -> Result<(), Outcome> {
        self.folder.write("driver.c", driver.text()).map_err(failed)?;
        let arguments = self
            .engine
            .c_arguments(&["driver.c", "-I", ".", "-o", "driver", "-lm"]);
        let ended = call(&self.engine.c_compiler, &arguments, &self.folder)?;
        match ended.code()? {
            0 => Ok(()),
            _ => Err(Outcome::Crashed {
                reason: format!(
                    "it accepts the program, and the C that it wrote cannot be built: {}",
                    first_error(&ended)
                ),
            }),
        }
    }

    fn execute(&self, driver: &Driver<'_>, request: &RunRequest<'_>) -> Result<Outcome, Outcome> {
        let nothing: [&str; 0] = [];
        let ended = locate::execute(&self.folder.path().join("driver"), &nothing, &self.folder)?;
        if ended.stopped_by_arithmetic() {
            return Ok(Outcome::Faulted {
                fault: Fault::DivisionByZero,
                line: None,
                values: Vec::new(),
            });
        }
        match ended.code()? {
            0 => match driver.values(&ended.stdout, request) {
                Ok(values) => Ok(Outcome::Executed { values }),
                Err(message) => Err(failed(message)),
            },
            _ => Err(ended.crashed()),
        }
    }
}
