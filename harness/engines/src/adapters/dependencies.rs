//! Finds the programs and folders that a compiler needs: by an environment variable, by `stickler.toml`, or on PATH.

use crate::reproduction::ReproductionTool;
use serde::Deserialize;
use std::collections::BTreeMap;
use std::env;
use std::ffi::OsStr;
use std::fmt;
use std::path::{Path, PathBuf};

/// A program or a folder that an adapter needs.
#[derive(Clone, PartialEq, Eq, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Dependency {
    /// The key of the dependency in a table `[engines.NAME]` of `stickler.toml`.
    pub key: String,
    /// The environment variable that holds the path of the dependency.
    pub variable: String,
    /// The name of a program on PATH, or the description of a folder.
    pub name: String,
    /// The usual path of the dependency, as a shell expands it between double quotes.
    pub script: String,
    #[serde(default)]
    kind: DependencyKind,
    /// Whether a script may do without the dependency, whose variable is empty then.
    #[serde(default)]
    optional: bool,
    /// Where a folder may be, from the folder of the compiler.
    #[serde(default)]
    beside: Vec<String>,
}

/// The kind of a dependency.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum DependencyKind {
    /// A program.
    #[default]
    Program,
    /// A file that another program reads and executes.
    File,
    /// A folder.
    Folder,
    /// A part of another dependency, which nobody names.
    Part,
}

impl Dependency {
    /// Returns the name of the variable that holds the path of the dependency in the scripts of
    /// [reproductions](crate::Reproduction), which do not know Stickler.
    pub(super) fn shell_variable(&self) -> &str {
        self.variable.strip_prefix("STICKLER_").unwrap_or(&self.variable)
    }

    /// Returns a command of a script, in which an empty variable of an optional dependency leaves no word.
    pub(super) fn in_script(&self, command: String) -> String {
        let word = format!("\"${}\"", self.shell_variable());
        match self.optional {
            true => command.replace(&word, &format!("${{{}:+{word}}}", self.shell_variable())),
            false => command,
        }
    }

    /// Tells whether a person can name the path of the dependency.
    pub(super) fn can_be_named(&self) -> bool {
        self.kind != DependencyKind::Part
    }

    /// Returns the variable of scripts with the usual path of the dependency.
    pub(super) fn usual(&self) -> ReproductionTool {
        ReproductionTool {
            variable: self.shell_variable().to_owned(),
            default: self.script.clone(),
        }
    }
}

/// The paths of the programs and folders of one compiler, as a person named them.
///
/// Basis: README of this crate: an environment variable counts before `stickler.toml`, and that before PATH.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct DependencyPaths {
    named: BTreeMap<String, Named>,
    /// Whether environment variables are ignored: they belong to the compiler under its own name alone, so that a second
    /// version of it must not use them.
    without_variables: bool,
}

/// A path, and the place where it is written.
#[derive(Clone, PartialEq, Eq, Debug)]
struct Named {
    path: PathBuf,
    written: String,
}

impl DependencyPaths {
    /// Adds the path of the dependency with this key; `written` is the place where a person wrote it, such as
    /// `stickler.toml:4`.
    pub fn named(mut self, key: &str, path: PathBuf, written: String) -> DependencyPaths {
        self.named.insert(key.to_owned(), Named { path, written });
        self
    }

    /// Ignores environment variables.
    pub fn without_variables(mut self) -> DependencyPaths {
        self.without_variables = true;
        self
    }
}

/// A dependency that was found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FoundDependency {
    /// The [key](Dependency::key) of the dependency.
    pub key: &'static str,
    /// The absolute path of the dependency.
    pub path: PathBuf,
    /// The way in which the dependency was found.
    pub by: FoundBy,
}

/// The way in which a dependency was found.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum FoundBy {
    /// By the environment variable of this name.
    Variable(&'static str),
    /// By a configuration; holds the file and the line.
    Configuration(String),
    /// On PATH.
    Path,
    /// The usual place beside another dependency.
    Beside,
}

impl fmt::Display for FoundBy {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FoundBy::Variable(variable) => formatter.write_str(variable),
            FoundBy::Configuration(written) => formatter.write_str(written),
            FoundBy::Path => formatter.write_str("PATH"),
            FoundBy::Beside => formatter.write_str("beside it"),
        }
    }
}

/// A search for the dependencies of one compiler, which keeps what it found.
pub(super) struct DependencySearch<'p> {
    paths: &'p DependencyPaths,
    /// The name of the engine, as in `[engines.NAME]`.
    engine: &'p str,
    located: Vec<FoundDependency>,
}

impl<'p> DependencySearch<'p> {
    /// Begins a search for the compiler behind the engine of this name.
    pub(super) fn new(engine: &'p str, paths: &'p DependencyPaths) -> DependencySearch<'p> {
        DependencySearch {
            paths,
            engine,
            located: Vec::new(),
        }
    }

    /// Returns the dependencies that were found, in the order of the search.
    pub(super) fn into_located(self) -> Vec<FoundDependency> {
        self.located
    }

    /// Finds a dependency of the `compiler` at this path; `None` for a part of another one.
    ///
    /// # Errors
    /// A fragment that says what is missing and how to name it, or that it cannot be started.
    pub(super) fn find(
        &mut self,
        dependency: &'static Dependency,
        compiler: &Path,
    ) -> Result<Option<PathBuf>, String> {
        let (path, by) = match (dependency.kind, self.named_path(dependency)) {
            (DependencyKind::Part, _) => return Ok(None),
            (_, Some((path, by))) => (existing(&path, &by, dependency)?, by),
            (DependencyKind::Folder, None) => (self.beside(dependency, compiler)?, FoundBy::Beside),
            (_, None) => (self.on_path(dependency)?, FoundBy::Path),
        };
        self.located.push(FoundDependency {
            key: &dependency.key,
            path: path.clone(),
            by,
        });
        match dependency.kind {
            DependencyKind::Program => executable(path).map(Some),
            _ => Ok(Some(path)),
        }
    }

    fn on_path(&self, dependency: &Dependency) -> Result<PathBuf, String> {
        let (name, hint) = (&dependency.name, self.how_to_name(dependency));
        let found = on_path(name, env::var_os("PATH").as_deref());
        found.ok_or_else(|| format!("there is no `{name}` on PATH; install it, or {hint}"))
    }

    /// Returns the first of the folders in which the dependency may be.
    fn beside(&self, dependency: &Dependency, compiler: &Path) -> Result<PathBuf, String> {
        let from = compiler.parent().unwrap_or(Path::new(""));
        let mut candidates = dependency.beside.iter().map(|path| from.join(path));
        let found = candidates.find(|folder| folder.is_dir());
        found.ok_or_else(|| {
            let hint = self.how_to_name(dependency);
            format!("{} was not found; {hint}", dependency.name)
        })
    }

    /// Returns the path that a person named, and the way in which it was named.
    fn named_path(&self, dependency: &'static Dependency) -> Option<(PathBuf, FoundBy)> {
        let variable = match self.paths.without_variables {
            true => None,
            // Some pipelines set a variable to an empty text to say that there is none.
            false => env::var_os(&dependency.variable).filter(|path| !path.is_empty()),
        };
        let named = self.paths.named.get(&dependency.key);
        variable
            .map(|path| (PathBuf::from(path), FoundBy::Variable(&dependency.variable)))
            .or_else(|| {
                named.map(|named| (named.path.clone(), FoundBy::Configuration(named.written.clone())))
            })
    }

    fn how_to_name(&self, dependency: &Dependency) -> String {
        let (engine, key) = (self.engine, &dependency.key);
        let table = format!("by `{key} = \"…\"` under `[engines.{engine}]` in stickler.toml");
        match self.paths.without_variables {
            true => format!("say where it is {table}"),
            false => format!("say where it is by {}, or {table}", dependency.variable),
        }
    }
}

fn existing(path: &Path, by: &FoundBy, dependency: &Dependency) -> Result<PathBuf, String> {
    let is = match dependency.kind {
        DependencyKind::Folder => Path::is_dir,
        _ => Path::is_file,
    };
    // The programs run in folders of their own, where a relative path would lead elsewhere.
    let what = match path.canonicalize() {
        Ok(path) if is(&path) => return Ok(path),
        Ok(path) if path.is_dir() => "is a folder; name the file",
        Ok(_) => "is a file; name the folder",
        Err(_) => "is not there",
    };
    Err(format!(
        "{by} names `{}` for {}, which {what}",
        path.display(),
        dependency.name
    ))
}

/// Returns the path of a file that the system would start as a program.
///
/// # Errors
/// A fragment that says that it would not.
pub(super) fn executable(path: PathBuf) -> Result<PathBuf, String> {
    let shown = path.display();
    match may_be_executed(&path) {
        false => Err(format!("`{shown}` is not executable; allow it by `chmod +x`")),
        true => Ok(path),
    }
}

/// Tells whether the system would start the file as a program.
#[cfg(unix)]
fn may_be_executed(path: &Path) -> bool {
    use std::os::unix::fs::PermissionsExt;
    path.metadata()
        .is_ok_and(|metadata| metadata.permissions().mode() & 0o111 != 0)
}

/// Returns `true`: on systems other than Unix the name of a file says whether it can be started.
#[cfg(not(unix))]
fn may_be_executed(_: &Path) -> bool {
    true
}

/// Returns the program of this name in the folders of PATH, as a shell finds it.
pub(super) fn on_path(name: &str, path: Option<&OsStr>) -> Option<PathBuf> {
    let file = format!("{name}{}", env::consts::EXE_SUFFIX);
    env::split_paths(path?)
        .map(|folder| folder.join(&file))
        .find(|candidate| candidate.is_file() && may_be_executed(candidate))
        .and_then(|found| std::path::absolute(found).ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::process::Folder;

    fn dependency(name: &str, kind: DependencyKind) -> &'static Dependency {
        Box::leak(Box::new(Dependency {
            key: "compiler".to_owned(),
            variable: "STICKLER_NO_SUCH_COMPILER".to_owned(),
            name: name.to_owned(),
            script: name.to_owned(),
            kind,
            optional: false,
            beside: vec!["no-such-folder".to_owned(), "there".to_owned()],
        }))
    }

    /// Returns the paths that name the dependency on line 4 of a file.
    fn named(path: &Path) -> DependencyPaths {
        DependencyPaths::default().named("compiler", path.to_owned(), "stickler.toml:4".to_owned())
    }

    #[test]
    fn what_is_missing_or_does_not_fit_is_told_with_where_it_is_written() {
        use DependencyKind::{File, Folder as Inside, Program};
        let folder = Folder::new().unwrap();
        let file = folder.write("compiler", "").unwrap();
        let table = "by `compiler = \"…\"` under `[engines.mine]` in stickler.toml";
        let variable = format!("by STICKLER_NO_SUCH_COMPILER, or {table}");
        let without_variables = format!("say where it is {table}");
        let nowhere = "stickler.toml:4 names `/no/such/file` for no-such-compiler, which is not there";
        let unnamed = DependencyPaths::default;
        for (paths, kind, part) in [
            (unnamed(), Program, "there is no `no-such-compiler` on PATH"),
            (unnamed(), Program, &*variable),
            (unnamed().without_variables(), Program, &*without_variables),
            (unnamed(), Inside, "no-such-compiler was not found"),
            (named(Path::new("/no/such/file")), Program, nowhere),
            (named(folder.path()), File, ", which is a folder; name the file"),
            (named(&file), Inside, ", which is a file; name the folder"),
            #[cfg(unix)]
            (named(&file), Program, "is not executable; allow it by `chmod +x`"),
        ] {
            let sought = dependency("no-such-compiler", kind);
            let error = DependencySearch::new("mine", &paths)
                .find(sought, &file)
                .unwrap_err();
            assert!(error.contains(part), "{error}");
        }
    }

    #[test]
    fn what_is_named_counts_before_path_and_is_kept_with_where_it_is_written() {
        let folder = Folder::new().unwrap();
        let there = folder.write("compiler", "").unwrap().canonicalize().unwrap();
        let paths = named(&there);
        let mut search = DependencySearch::new("mine", &paths);
        // `sh` is on PATH wherever there is a shell.
        let found = search.find(dependency("sh", DependencyKind::File), Path::new(""));
        assert_eq!(found, Ok(Some(there.clone())));
        let located = FoundDependency {
            key: "compiler",
            path: there,
            by: FoundBy::Configuration("stickler.toml:4".to_owned()),
        };
        assert_eq!(search.into_located(), [located]);
    }

    #[test]
    fn a_program_is_found_on_path_where_it_may_be_executed() {
        let folder = Folder::new().unwrap();
        let file = format!("compiler{}", env::consts::EXE_SUFFIX);
        let there = folder.write(&file, "").unwrap();
        let path = env::join_paths([Path::new("/no/such/folder"), folder.path()]).unwrap();
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            assert_eq!(on_path("compiler", Some(&path)), None);
            std::fs::set_permissions(&there, std::fs::Permissions::from_mode(0o700)).unwrap();
        }
        assert_eq!(on_path("compiler", Some(&path)), Some(there));
        assert_eq!(on_path("compiler", None), None);
    }

    #[test]
    fn a_folder_is_the_first_candidate_that_there_is() {
        let folder = Folder::new().unwrap();
        let there = folder.path().join("there");
        std::fs::create_dir(&there).unwrap();
        let paths = DependencyPaths::default();
        let sought = dependency("no-such-compiler", DependencyKind::Folder);
        let found = DependencySearch::new("mine", &paths).find(sought, &folder.path().join("compiler"));
        assert_eq!(found, Ok(Some(there)));
    }
}
