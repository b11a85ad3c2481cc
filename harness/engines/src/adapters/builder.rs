//! Builds the output of a compiler under test together with a driver, by a C or C++ compiler.

use super::fingerprint::Fingerprint;
use super::locate::{call, first_error, is_of_linker};
use super::recipe::{Purpose, Recipe, Workplace};
use crate::Outcome;
use crate::process::{Ended, Folder};
use std::ffi::OsString;
use std::path::{Path, PathBuf};

/// The language that a compiler under test writes, for a C or a C++ compiler. Programs are built without optimisation, so that what
/// C leaves undefined does what the machine does; the commands of recipes have the same options, without which compiled headers are not
/// used.
pub(super) struct Language {
    name: &'static str,
    options: &'static [&'static str],
    header: &'static str,
    header_kind: &'static str,
    /// The name of the file of a driver.
    pub(super) driver: &'static str,
}

pub(super) const C: Language = Language {
    name: "C",
    options: &["-O0", "-w"],
    header: "stickler.h",
    header_kind: "c-header",
    driver: "driver.c",
};

pub(super) const CPP: Language = Language {
    name: "C++",
    options: &["-std=c++17", "-O0", "-w"],
    header: "stickler.hpp",
    header_kind: "c++-header",
    driver: "driver.cpp",
};

/// The programs that a C or C++ compiler calls.
const PROGRAMS: [&str; 4] = ["cc1", "cc1plus", "as", "ld"];

/// The libraries of the programs that it builds.
const LIBRARIES: [&str; 4] = ["libc.so.6", "libm.so.6", "libstdc++.so.6", "libgcc_s.so.1"];

/// The environment variables that decide what the compiler includes and links, and what a program runs with.
///
/// Basis: gcc: *Environment Variables Affecting GCC*; linux: ld.so(8).
const VARIABLES: [&str; 8] = [
    "CPATH",
    "C_INCLUDE_PATH",
    "CPLUS_INCLUDE_PATH",
    "LIBRARY_PATH",
    "COMPILER_PATH",
    "GCC_EXEC_PREFIX",
    "LD_LIBRARY_PATH",
    "LD_PRELOAD",
];

/// A C or C++ compiler, and the headers that every built program includes; they are compiled once, since that takes most of the
/// time of building a small program. A compiler that does not use the compiled headers reads them itself.
pub(super) struct Builder {
    language: &'static Language,
    compiler: PathBuf,
    headers: PathBuf,
    /// The folder with the header that includes the others, and its compiled form.
    prepared: Folder,
}

impl Builder {
    /// Compiles `text` with a compiler, which includes headers of the folder `headers`.
    ///
    /// # Errors
    /// A fragment that says what is missing or does not work.
    pub(super) fn new(
        compiler: PathBuf,
        language: &'static Language,
        headers: PathBuf,
        text: &str,
    ) -> Result<Builder, String> {
        let builder = Builder {
            language,
            compiler,
            headers,
            prepared: Folder::new()?,
        };
        let Language { name, header, .. } = builder.language;
        builder.prepared.write(header, text)?;
        let compiled = format!("{header}.gch");
        let arguments = builder.arguments(&["-x", builder.language.header_kind, header, "-o", &compiled]);
        let ended = call(&builder.compiler, &arguments, &builder.prepared)
            .map_err(|outcome| format!("the {name} compiler: {outcome}"))?;
        if ended.status.success() {
            return Ok(builder);
        }
        Err(format!(
            "`{}` does not compile the headers in `{}`: {}",
            builder.compiler.display(),
            builder.headers.display(),
            first_error(&ended)
        ))
    }

    /// Returns a digest of everything that decides what the compiler builds; `None` where that cannot be known.
    pub(super) fn fingerprint(&self) -> Option<String> {
        let kind = self.language.header_kind.trim_end_matches("-header");
        // The output has every header that is included, without the paths of the headers.
        let arguments = self.arguments(&["-E", "-P", "-x", kind, self.language.header]);
        let headers = call(&self.compiler, &arguments, &self.prepared).ok()?;
        let version = call(&self.compiler, &["--version"], &self.prepared).ok()?;
        if !headers.status.success() {
            return None;
        }
        let mut fingerprint = Fingerprint::of(self.language.name)
            .program(&self.compiler)
            .text(&version.stdout)
            .text(&headers.stdout)
            .variables(&VARIABLES);
        let programs = PROGRAMS.map(|name| format!("-print-prog-name={name}"));
        let libraries = LIBRARIES.map(|name| format!("-print-file-name={name}"));
        for question in programs.iter().chain(&libraries) {
            let answer = call(&self.compiler, &[question], &self.prepared).ok()?;
            let path = PathBuf::from(answer.stdout.trim());
            // A program or library that the compiler does not have is named without a path.
            if path.is_absolute() && path.is_file() {
                fingerprint = fingerprint.file(&path);
            }
        }
        fingerprint.finish()
    }

    /// Executes the step of a recipe that builds its driver.
    ///
    /// # Errors
    /// [`Outcome::Unusable`] where the program cannot be built: the compiler under test neither rejected its program nor made
    /// one that runs. Otherwise an outcome as [`Workplace::step`] returns.
    pub(super) fn build(&self, recipe: &Recipe, workplace: &Workplace<'_>) -> Result<(), Outcome> {
        let ended = self.try_build(recipe, workplace)?;
        match ended.code()? {
            0 => Ok(()),
            _ => {
                let error = without_folder(&first_error(&ended), &self.headers);
                let what = match is_of_linker(&error) {
                    true => "what it wrote cannot be linked".to_owned(),
                    false => format!("the {} that it wrote cannot be built", self.language.name),
                };
                let reason = format!("{what}: {error}");
                Err(Outcome::Unusable { reason })
            }
        }
    }

    /// Executes the step of a recipe that builds its driver, as [`Builder::build`] does. Returns the output and the end of the
    /// compiler.
    ///
    /// # Errors
    /// An outcome as [`Workplace::step`] returns.
    pub(super) fn try_build(&self, recipe: &Recipe, workplace: &Workplace<'_>) -> Result<Ended, Outcome> {
        let header = self.prepared.path().join(self.language.header);
        let compiled = ["-include".as_ref(), header.as_os_str()];
        workplace.step(recipe, Purpose::Build, &compiled)
    }

    /// Returns the arguments of every call, followed by `further`.
    fn arguments(&self, further: &[&str]) -> Vec<OsString> {
        let mut arguments: Vec<OsString> = self.language.options.iter().map(OsString::from).collect();
        for folder in [self.prepared.path(), &self.headers] {
            arguments.push("-I".into());
            arguments.push(folder.into());
        }
        arguments.extend(further.iter().map(OsString::from));
        arguments
    }
}

/// Removes a folder from the paths in a text. Where a compiler lies differs from machine to machine.
pub(super) fn without_folder(text: &str, folder: &Path) -> String {
    text.replace(&folder.join("").display().to_string(), "")
}

#[cfg(test)]
mod tests {
    use super::{C, CPP};
    use crate::adapters::Compiler;

    #[test]
    fn drivers_are_built_with_the_options_of_their_compiled_headers() {
        for (compiler, language) in [
            (Compiler::Matiec, C),
            (Compiler::Rusty, C),
            (Compiler::Strucpp, CPP),
        ] {
            let build = compiler.data().command("build", &[]);
            let options = language.options.join(" ");
            assert!(build.contains(&format!("}} {options} ")), "{build}");
        }
    }
}
