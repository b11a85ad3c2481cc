//! Finds the folder of cases, loads the cases, and reports mistakes in their files.

use crate::carried_cases;
use crate::exit::Exit;
use crate::output;
use crate::{engines, run_plan, shell};
use anyhow::{Context, bail};
use std::collections::BTreeSet;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_conversions::recording::{Recording, RecordingError};
use stickler_run::{DefinedHeader, Filter, Plan, select};
use stickler_suite::{Case, Dialects, FileKind, RECORDINGS, Suite, Wanted};
use stickler_types::{DialectName, Question, counted, join};

/// The name of the folder of cases.
const NAME: &str = "conformance-cases";

/// The file that each folder of cases has.
const SUITE: &str = "suite.toml";

/// A folder of cases, found by a search or named on the command line.
pub struct CaseFolder {
    /// The path of the folder of cases.
    pub path: PathBuf,
    /// The folder that contains `reports/` by default: the parent of a folder of cases that was found in the current folder or
    /// above, otherwise the current folder.
    pub root: PathBuf,
    /// Whether the cases are those that the program carries.
    pub is_carried: bool,
}

impl CaseFolder {
    /// Finds the folder of cases: the one that was named, or else `conformance-cases` in the current folder or the nearest above
    /// it, or else above the program, which serves a tester in the repository of a compiler, or else the cases that the program carries.
    ///
    /// # Errors
    /// A name that is no folder, or no folder found and none that the carried cases can be unpacked into.
    pub fn locate(named: Option<&Path>) -> anyhow::Result<CaseFolder> {
        match named {
            Some(path) if path.is_dir() => Ok(CaseFolder::here(path.to_owned())),
            Some(path) if path.exists() => bail!("{} is no folder", path.display()),
            Some(path) => bail!("there is no folder {}", path.display()),
            None => {
                let here = env::current_dir().context("cannot tell the current folder")?;
                let program = env::current_exe().and_then(|program| program.canonicalize());
                match CaseFolder::search(&here, program.ok().as_deref()) {
                    Some(found) => Ok(found),
                    None => Ok(CaseFolder {
                        is_carried: true,
                        ..CaseFolder::here(carried_cases::unpacked(NAME)?)
                    }),
                }
            }
        }
    }

    /// Returns a folder of cases whose reports belong to the current folder.
    fn here(path: PathBuf) -> CaseFolder {
        CaseFolder {
            path,
            root: PathBuf::new(),
            is_carried: false,
        }
    }

    /// Finds the folder of cases as [`CaseFolder::locate`] does; `None` where none was named and none is found.
    ///
    /// # Errors
    /// A name that is no folder.
    pub fn locate_any(named: Option<&Path>) -> anyhow::Result<Option<CaseFolder>> {
        match (named, CaseFolder::locate(named)) {
            (None, found) => Ok(found.ok()),
            (Some(_), found) => found.map(Some),
        }
    }

    /// Returns the folder of cases in the nearest place; `None` where there is none in any of them.
    fn search(here: &Path, program: Option<&Path>) -> Option<CaseFolder> {
        let above = |start: &Path| {
            // The archive of a release has a folder of the name with pages alone.
            let mut folders = start.ancestors();
            let found = folders.find(|folder| folder.join(NAME).join(SUITE).is_file());
            found.map(Path::to_owned)
        };
        if let Some(root) = above(here) {
            // Paths are shown to the user, so a short one is better.
            let root = if root == here { PathBuf::new() } else { root };
            return Some(CaseFolder {
                root: root.clone(),
                ..CaseFolder::here(root.join(NAME))
            });
        }
        // Reports belong to the current folder, not to the clone in which the program was built.
        let clone = program.and_then(above);
        clone.map(|clone| CaseFolder::here(clone.join(NAME)))
    }

    /// Reads all cases, with those that one edition of a compiler repeats of another, and reports mistakes in their files on stderr. Of the
    /// dialects that stickler.toml defines, only the given ones get cases, so that a run without arguments is the same everywhere.
    pub fn load_with(&self, dialects: impl IntoIterator<Item = DialectName>) -> Suite {
        let suite = Suite::load_with(&self.path, with_repeats(&defined(dialects)));
        report_mistakes(&suite);
        suite
    }

    /// Reads the recordings of compilers, and reports those that are refused on stderr.
    ///
    /// # Errors
    /// A folder or file that cannot be read.
    pub fn usable_recordings(&self) -> anyhow::Result<Vec<Recording>> {
        let report =
            |read: Result<Recording, RecordingError>| read.map_err(|error| output::error(&error.into())).ok();
        Ok(self.recordings()?.into_iter().filter_map(report).collect())
    }

    /// Reads the recordings of compilers, in the order of their files: each, or the mistake for which it is refused.
    ///
    /// # Errors
    /// A folder or file that cannot be read.
    pub fn recordings(&self) -> anyhow::Result<Vec<Result<Recording, RecordingError>>> {
        let folder = self.path.join(RECORDINGS);
        if !folder.is_dir() {
            return Ok(Vec::new());
        }
        let unreadable = |path: &Path| format!("cannot read {}", path.display());
        let entries = fs::read_dir(&folder).and_then(Iterator::collect::<Result<Vec<_>, _>>);
        let mut paths: Vec<PathBuf> = entries
            .with_context(|| unreadable(&folder))?
            .into_iter()
            .map(|entry| entry.path())
            .filter(|path| path.extension().is_some_and(|extension| extension == "toml"))
            .collect();
        paths.sort();
        let read = |path: PathBuf| {
            let text = fs::read_to_string(&path).with_context(|| unreadable(&path))?;
            Ok(Recording::parse(&path.display().to_string(), &text))
        };
        paths.into_iter().map(read).collect()
    }

    /// Reads what the cases may cite, and no case.
    pub fn load_sources(&self) -> Suite {
        Suite::load_files(&self.path, Wanted::default(), |_, _| false)
    }

    /// Reads the files in which one of these words stands, without reporting mistakes in them. Their cases are those of the dialects `asked`,
    /// of all dialects where there are none.
    pub fn load_mentioning<S: AsRef<str>>(&self, words: &[S], asked: &[DialectName]) -> Suite {
        let wanted = Wanted {
            asked,
            ..Wanted::default()
        };
        Suite::load_files(&self.path, wanted, |id, kind| self.mentions(id, kind, words))
    }

    fn mentions<S: AsRef<str>>(&self, id: &str, kind: FileKind, words: &[S]) -> bool {
        let file = self.path.join(format!("{id}.{}", kind.extension()));
        let has_one = |text: String| words.iter().any(|word| text.contains(word.as_ref()));
        fs::read_to_string(file).is_ok_and(has_one)
    }

    /// Reads the files that may contain a case that the filters select, and reports mistakes in them on stderr. Reads all files
    /// where the filters select no case of these.
    pub fn load_selected(&self, plan: &Plan, dialects: &[DialectName], asked: &[DialectName]) -> Suite {
        let wanted = Wanted {
            defined: &defined(dialects.iter().copied()),
            asked,
            with_repeats: false,
        };
        let named: Vec<(&Filter, Option<&str>)> = plan
            .filters
            .iter()
            .map(|filter| (filter, self.program_named_by(filter)))
            .collect();
        let is_wanted = |id: &str, kind: FileKind| {
            named.iter().any(|(filter, program)| match program {
                Some(program) => kind == FileKind::Program && id == *program,
                None => filter.may_fit_file(id, kind),
            })
        };
        // A baseline is compared with all cases: an entry that matches none is out of date.
        let some = (!named.is_empty() && plan.baselines.is_empty())
            .then(|| Suite::load_files(&self.path, wanted, is_wanted))
            .filter(|suite| !select(plan, &suite.cases).is_empty());
        let suite = some.unwrap_or_else(|| Suite::load_with(&self.path, wanted));
        report_mistakes(&suite);
        suite
    }

    /// Reads all cases of all dialects, those that the plan defines among them, to say why the plan selects none. Mistakes in their files were
    /// reported before.
    pub fn load_whole(&self, plan: &Plan) -> Suite {
        let wanted = Wanted {
            defined: &defined(named_dialects(plan)),
            ..Wanted::default()
        };
        Suite::load_with(&self.path, wanted)
    }

    /// Returns the id of the program that a filter names, as a whole id or key.
    fn program_named_by<'f>(&self, filter: &'f Filter) -> Option<&'f str> {
        let id = filter.as_str().split('@').next()?;
        let is_program = !id.is_empty() && self.path.join(format!("{id}.st")).is_file();
        is_program.then_some(id)
    }

    /// Loads the cases for a plan, including those of the dialects of stickler.toml that the plan or the end of a filter names.
    /// Leaves out the selected inherited cases whose result an override may change, and reports their number on stderr. The cases are for
    /// engines that speak the dialects `asked`, all where it is empty.
    ///
    /// # Errors
    /// A session of the reference that cannot be opened.
    pub fn load_for(&self, plan: &Plan, asked: &[DialectName]) -> anyhow::Result<Loaded> {
        let named = named_dialects(plan);
        let in_filters = plan.filters.iter().map(Filter::dialect);
        let narrowed = !plan.dialects.is_empty()
            || !named.is_empty() && in_filters.into_iter().all(|named| named.is_some());
        let asked = if narrowed { &named[..] } else { asked };
        let suite = self.load_selected(plan, &named, asked);
        self.prepared(plan, suite, named)
    }

    /// Loads the cases of one case file for a plan, as [`CaseFolder::load_for`] does; `id` is the path of the file below the folder, without
    /// its extension.
    ///
    /// # Errors
    /// A session of the reference that cannot be opened.
    pub fn load_file_for(&self, plan: &Plan, id: &str, kind: FileKind) -> anyhow::Result<Loaded> {
        let named = named_dialects(plan);
        let defined = defined(named.iter().copied());
        let is_wanted = |file: &str, of| file == id && of == kind;
        let suite = Suite::load_files(&self.path, with_repeats(&defined), is_wanted);
        report_mistakes(&suite);
        self.prepared(plan, suite, named)
    }

    /// Loads the cases for a plan that ask whether a type converts implicitly, as [`CaseFolder::load_for`] does.
    ///
    /// # Errors
    /// A session of the reference that cannot be opened.
    pub fn load_implicit_for(&self, plan: &Plan) -> anyhow::Result<Loaded> {
        let named = named_dialects(plan);
        let defined = defined(named.iter().copied());
        let is_wanted = |id: &str, kind| self.mentions(id, kind, &["implicit("]);
        let mut suite = Suite::load_files(&self.path, with_repeats(&defined), is_wanted);
        let is_implicit = |case: &Case| matches!(case.question.as_deref(), Some(Question::Implicit(_)));
        suite.cases.retain(is_implicit);
        report_mistakes(&suite);
        self.prepared(plan, suite, named)
    }

    /// Leaves out the selected inherited cases whose result an override may change, and reports their number on stderr.
    fn prepared(&self, plan: &Plan, mut suite: Suite, named: Vec<DialectName>) -> anyhow::Result<Loaded> {
        if self.is_carried {
            suite.version.push_str(" inside the program");
        }
        let left_out = stickler_run::drop_changed_cases(plan, &mut suite.cases)?;
        note_left_out(&left_out);
        Ok(Loaded {
            defined: stickler_run::dialect_headers(&defined(named), &left_out),
            suite,
            left_out,
        })
    }
}

/// Wants all cases with those of these dialects of stickler.toml, and those that one edition of a compiler repeats of another.
fn with_repeats(defined: &[DialectName]) -> Wanted<'_> {
    Wanted {
        defined,
        with_repeats: true,
        ..Wanted::default()
    }
}

/// Returns the dialects that a plan or the end of a filter names.
fn named_dialects(plan: &Plan) -> Vec<DialectName> {
    let in_filters = plan.filters.iter().filter_map(Filter::dialect);
    plan.dialects.iter().copied().chain(in_filters).collect()
}

/// Defines the dialects of the suite, so that the command line may name them. Does nothing where there is no folder of cases.
pub fn define_dialects(named: Option<&Path>) {
    if let Ok(folder) = CaseFolder::locate(named) {
        Dialects::define_those_of(&folder.path);
    }
}

/// Reports the mistakes in the files that were read on stderr.
fn report_mistakes(suite: &Suite) {
    for error in &suite.errors {
        output::error(&anyhow::anyhow!("{error}"));
    }
    if !suite.errors.is_empty() {
        let mistakes = counted(suite.errors.len() as u64, "mistake", "mistakes");
        output::note(format!("{mistakes} in case files; the rest of the cases is used"));
    }
}

/// The cases that were loaded for a plan.
pub struct Loaded {
    /// The suite, with the cases that the plan does not select.
    pub suite: Suite,
    /// The dialects of stickler.toml that have cases, as reports describe them.
    pub defined: Vec<DefinedHeader>,
    /// The inherited cases that were left out, because an override of their dialect may change their result.
    pub left_out: Vec<Case>,
}

/// Returns those of the dialects that stickler.toml defines, each once.
fn defined(dialects: impl IntoIterator<Item = DialectName>) -> Vec<DialectName> {
    let defined = dialects.into_iter().filter(|dialect| dialect.is_custom());
    defined.collect::<BTreeSet<_>>().into_iter().collect()
}

fn note_left_out(left_out: &[Case]) {
    for dialect in DialectName::defined() {
        let number = left_out.iter().filter(|case| case.dialect == dialect).count();
        let base = dialect.base();
        let cases = match number {
            0 => continue,
            1 => format!("1 case of {base} is left out of {dialect}, because what it overrides changes it"),
            _ => format!(
                "{number} cases of {base} are left out of {dialect}, because what it overrides changes them"
            ),
        };
        output::note(format!(
            "{cases} and no source in Stickler says how; `stickler list{} --dialect {dialect} --left-out` lists {}",
            run_plan::places(None),
            if number == 1 { "it" } else { "them" }
        ));
    }
}

/// Returns [`Exit::Usage`] where case files have mistakes, otherwise [`Exit::AsExpected`].
pub fn exit_of(suite: &Suite) -> Exit {
    Exit::Usage.when(!suite.errors.is_empty())
}

/// Reports on stderr why a plan selects no case of a [whole suite](CaseFolder::load_whole), and returns the exit code for that.
pub fn nothing_selected(plan: &Plan, suite: &Suite) -> Exit {
    output::error(&anyhow::anyhow!(
        "no case is selected: {}",
        why_nothing(plan, suite)
    ));
    Exit::NothingTested.max(exit_of(suite))
}

/// Returns what of a plan selects no case, and which cases there are otherwise.
fn why_nothing(plan: &Plan, suite: &Suite) -> String {
    let filters = options("--filter", plan.filters.iter().map(Filter::as_str));
    let all = Plan {
        filters: plan.filters.clone(),
        ..Plan::default()
    };
    let fitting = select(&all, &suite.cases);
    let in_dialects = Plan {
        dialects: plan.dialects.clone(),
        ..all
    };
    let spoken = select(&in_dialects, &suite.cases);
    let number = counted(spoken.len() as u64, "case", "cases");
    if suite.cases.is_empty() {
        "there are none".to_owned()
    } else if fitting.is_empty() {
        let is_beside = |dialect: &DialectName| {
            dialect.is_custom() && suite.cases.iter().all(|case| case.dialect != *dialect)
        };
        let unless_named = match DialectName::defined().iter().any(is_beside) {
            true => "; a dialect of stickler.toml has cases where --dialect names it",
            false => "",
        };
        let all = counted(suite.cases.len() as u64, "case", "cases");
        format!("{filters} fits none of {all}; `stickler list` lists them{unless_named}")
    } else if spoken.is_empty() {
        let dialects = options("--dialect", plan.dialects.iter().map(|dialect| dialect.as_str()));
        let of: BTreeSet<DialectName> = fitting.iter().map(|case| case.dialect).collect();
        let of = engines::listed(&Vec::from_iter(of));
        let what = if filters.is_empty() {
            "the suite has"
        } else {
            &format!("{filters} fits")
        };
        format!("{dialects} has none of what {what}, which is of {of}")
    } else if let Some(shard) = plan.shard {
        format!("part {shard} has none of {number}")
    } else if plan.excluded.is_empty() {
        format!("none of {number} is what is asked for")
    } else {
        let excluded = options("--exclude", plan.excluded.iter().map(Filter::as_str));
        format!("{excluded} leaves out all of {number}")
    }
}

/// Returns an option with its arguments, as it is typed.
pub fn options<'a>(name: &str, arguments: impl Iterator<Item = &'a str>) -> String {
    let typed = arguments.map(|argument| format!("{name} {}", shell::quote(argument)));
    join(typed, " ")
}

#[cfg(test)]
mod tests {
    use super::{CaseFolder, NAME, SUITE};
    use std::fs;
    use std::path::PathBuf;

    #[test]
    fn cases_are_sought_here_and_above_and_then_above_the_program() {
        let folder = tempfile::tempdir().expect("a folder");
        let [clone, compiler] = ["stickler", "compiler"].map(|name| folder.path().join(name));
        let (program, inside) = (clone.join("target/release/stickler"), compiler.join("tests"));
        for made in [&clone.join(NAME), &inside] {
            fs::create_dir_all(made).expect("a folder");
        }
        let suite_in = |folder: &PathBuf| fs::write(folder.join(NAME).join(SUITE), "").expect("a file");
        suite_in(&clone);
        assert!(CaseFolder::search(&inside, None).is_none());
        let found = CaseFolder::search(&inside, Some(&program)).expect("above the program");
        assert_eq!((found.path, found.root), (clone.join(NAME), PathBuf::new()));
        fs::create_dir(compiler.join(NAME)).expect("a folder");
        suite_in(&compiler);
        let found = CaseFolder::search(&inside, Some(&program)).expect("above this folder");
        assert_eq!((found.path, found.root), (compiler.join(NAME), compiler.clone()));
        let found = CaseFolder::search(&compiler, Some(&program)).expect("here");
        assert_eq!((found.path, found.root), (PathBuf::from(NAME), PathBuf::new()));
    }
}
