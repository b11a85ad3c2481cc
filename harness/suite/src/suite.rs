//! A folder of case files becomes a suite.

use std::path::Path;

use rustc_hash::FxHashMap;
use serde::Deserialize;
use stickler_types::{DefinedDialect, DialectName};
use stickler_workers::{SpawnError, WorkerPool};

use crate::assembly::TypeNames;
use crate::defined::restate;
use crate::error::Mistake;
use crate::frame::{FileContext, Harvest};
use crate::place::Lines;
use crate::{Case, CaseFileError, Dialects, WithdrawnCase};
use crate::{files, ident, single, table, toml_text};

/// All cases of a folder, and what is wrong with its files.
#[derive(Clone, Debug, Default)]
pub struct Suite {
    /// The suite's own version, from `suite.toml`; results name it.
    pub version: String,
    /// The cases, ordered by path and then by their place in the file.
    pub cases: Vec<Case>,
    /// Cases that keep their ids but are not run.
    pub withdrawn: Vec<WithdrawnCase>,
    /// Mistakes in case files, ordered by file and line. What of the suite is sound is loaded all the same.
    pub errors: Vec<CaseFileError>,
    /// The dialects and groups that case files may name, from `dialects.toml`.
    pub dialects: Dialects,
    /// What lint says of the files beside their mistakes.
    pub(crate) remarks: Vec<CaseFileError>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SuiteFile {
    version: String,
}

impl Suite {
    /// Reads every case file below `dir`, the folder that has `suite.toml` and `dialects.toml`.
    ///
    /// It never fails: what is wrong stands in [`Suite::errors`], also where `dir` does not exist.
    pub fn load(dir: &Path) -> Suite {
        Suite::load_with(dir, &[])
    }

    /// The same, with the cases of these dialects that were [defined](DialectName::define): those of the dialect that each
    /// extends, taken over as they are, but for what its definition states. A cell that it overrides expects what it says, and
    /// a call of a conversion function what exact arithmetic gives by its choices. Whether anything else depends on what it
    /// overrides, this crate cannot know.
    pub fn load_with(dir: &Path, defined: &[DialectName]) -> Suite {
        let root = files::Root::new(dir);
        let mut suite = Suite::default();
        suite.read_version(&root);
        suite.read_dialects(&root);
        suite.dialects = std::mem::take(&mut suite.dialects).with_defined(defined);
        let type_names = TypeNames::default();
        let listing = files::list(&root);
        suite.errors.extend(listing.errors);
        suite.remarks.extend(listing.remarks);
        let dialects = &suite.dialects;
        let read = |file: &files::CaseFile| {
            let mut harvest = read_file(file, dialects, &type_names);
            let cases = harvest.cases.iter_mut();
            cases
                .filter(|case| case.dialect.definition().is_some())
                .for_each(|case| restate(case, &type_names));
            harvest
        };
        let files = listing.files.iter();
        let harvests = WorkerPool::new(0).map(files.clone(), || Ok(()), |(), file| Ok(read(file)));
        // Without threads it takes longer.
        let harvests: Vec<Harvest> = harvests.unwrap_or_else(|_: SpawnError| files.map(read).collect());
        suite
            .cases
            .reserve(harvests.iter().map(|harvest| harvest.cases.len()).sum());
        for (file, harvest) in listing.files.iter().zip(harvests) {
            suite.take(&file.shown, harvest);
        }
        suite.drop_duplicates();
        suite.errors.sort();
        suite
    }

    fn read_version(&mut self, root: &files::Root) {
        let shown = root.shown("suite.toml");
        let read = files::read(&root.path().join("suite.toml"));
        let file = read.and_then(|text| toml_text::read::<SuiteFile>(&text, 0, &Lines::new(&text)));
        match file {
            Ok(file) => self.version = file.version,
            Err(mistake) => self.errors.push(mistake.in_file(&shown)),
        }
    }

    fn read_dialects(&mut self, root: &files::Root) {
        let (dialects, errors) = dialects(root);
        self.dialects = dialects;
        self.errors.extend(errors);
    }

    fn take(&mut self, shown: &str, harvest: Harvest) {
        self.cases.extend(harvest.cases);
        self.withdrawn.extend(harvest.withdrawn);
        self.errors
            .extend(harvest.mistakes.into_iter().map(|mistake| mistake.in_file(shown)));
        self.remarks
            .extend(harvest.remarks.into_iter().map(|remark| remark.in_file(shown)));
    }

    /// Of cases with one key only the first stays; the others are mistakes.
    fn drop_duplicates(&mut self) {
        let errors = drop_duplicates(&mut self.cases, &self.withdrawn);
        self.errors.extend(errors);
    }
}

/// Reads the one case file `path`, as a part of the suite at `root`: the cases to run, and the file's mistakes.
///
/// `path` may be given relative to the working folder or absolute, as test harnesses that walk `root` give it.
pub fn load_file(root: &Path, path: &Path) -> (Vec<Case>, Vec<CaseFileError>) {
    let root = files::Root::new(root);
    let (dialects, mut errors) = dialects(&root);
    let file = match root.case_file(path) {
        Ok(file) => file,
        Err(error) => {
            errors.push(error);
            return (Vec::new(), errors);
        }
    };
    let harvest = read_file(&file, &dialects, &TypeNames::default());
    let (cases, mistakes) = alone(harvest, &file.shown);
    errors.extend(mistakes);
    (cases, errors)
}

/// Reads a case file that is no file: `text` under the path `name` below a suite's root, by whose ending it is a program (`.st`)
/// or a table (`.toml`). Gives the cases to run, and the mistakes.
#[must_use]
pub fn read_case_file(name: &str, text: &str, dialects: &Dialects) -> (Vec<Case>, Vec<CaseFileError>) {
    let harvest = match files::kind(name) {
        Some(kind) => read_text(name, name, kind, text, dialects, &TypeNames::default()),
        None => wrong(Mistake::new(1, files::NO_CASE_FILE)),
    };
    alone(harvest, name)
}

/// The cases and mistakes of a file that is read by itself.
fn alone(harvest: Harvest, shown: &str) -> (Vec<Case>, Vec<CaseFileError>) {
    let mistakes = harvest.mistakes.into_iter();
    let mut errors: Vec<_> = mistakes.map(|mistake| mistake.in_file(shown)).collect();
    let mut cases = harvest.cases;
    errors.extend(drop_duplicates(&mut cases, &harvest.withdrawn));
    (cases, errors)
}

fn dialects(root: &files::Root) -> (Dialects, Vec<CaseFileError>) {
    let shown = root.shown("dialects.toml");
    match files::read(&root.path().join("dialects.toml")) {
        Ok(text) => Dialects::of_file(&shown, &text),
        Err(mistake) => (Dialects::default(), vec![mistake.in_file(&shown)]),
    }
}

fn read_file(file: &files::CaseFile, dialects: &Dialects, type_names: &TypeNames) -> Harvest {
    match files::read(&file.path) {
        Ok(text) => read_text(
            &file.below_root,
            &file.shown,
            file.kind,
            &text,
            dialects,
            type_names,
        ),
        Err(mistake) => wrong(mistake),
    }
}

/// What is left of a file that could not be read.
fn wrong(mistake: Mistake) -> Harvest {
    Harvest {
        mistakes: vec![mistake],
        ..Harvest::default()
    }
}

fn read_text(
    below_root: &str,
    shown: &str,
    kind: files::Kind,
    text: &str,
    dialects: &Dialects,
    type_names: &TypeNames,
) -> Harvest {
    let id = match ident::of_file(below_root) {
        Ok(id) => id,
        Err(message) => return wrong(Mistake::new(1, message).hint("rename the file or its folder")),
    };
    let area = id.split('/').next().unwrap_or_default();
    let context = FileContext {
        file: shown.into(),
        area: area.into(),
        id: id.clone(),
        text,
        lines: Lines::new(text),
        dialects,
        type_names,
        budget: table::Budget::default(),
    };
    match kind {
        files::Kind::Program => single::read(&context),
        files::Kind::Table => table::read(&context),
    }
}

/// Takes out the cases whose key stood before, and says so of each place once.
fn drop_duplicates(cases: &mut Vec<Case>, withdrawn: &[WithdrawnCase]) -> Vec<CaseFileError> {
    let duplicates = duplicates(cases, withdrawn);
    let mut errors: Vec<CaseFileError> = duplicates.iter().map(|(_, error)| error.clone()).collect();
    errors.dedup();
    let mut gone = duplicates.iter().map(|&(at, _)| at).peekable();
    if gone.peek().is_some() {
        let mut at = 0;
        cases.retain(|_| {
            let is_gone = gone.next_if_eq(&at).is_some();
            at += 1;
            !is_gone
        });
    }
    errors
}

/// The cases whose key stood before, by index, in order.
fn duplicates(cases: &[Case], withdrawn: &[WithdrawnCase]) -> Vec<(usize, CaseFileError)> {
    let mut seen: FxHashMap<&str, (DialectSet, &Case)> = FxHashMap::default();
    seen.reserve(cases.len() / 2);
    let mut found = Vec::new();
    let all = withdrawn.iter().map(|withdrawn| (&withdrawn.case, None));
    let all = all.chain(cases.iter().enumerate().map(|(at, case)| (case, Some(at))));
    for (case, at) in all {
        let (dialects, first) = seen.entry(&case.id).or_insert((DialectSet::default(), case));
        if dialects.insert(case.dialect) {
            continue;
        }
        let message = format!(
            "the id `{}` stands already at {}:{}",
            case.id, first.file, first.line
        );
        let error = Mistake::new(case.line, message)
            .key("id")
            .hint("an id names one case: change the file's name, the probe's, or give an `id`")
            .in_file(&case.file);
        found.extend(at.map(|at| (at, error)));
    }
    found
}

/// A set of dialects.
#[derive(Clone, Debug, Default)]
struct DialectSet {
    /// A bit each for those of documented systems.
    built_in: u32,
    /// The others; there are few.
    defined: Vec<DefinedDialect>,
}

impl DialectSet {
    /// Adds a dialect; false where it was there.
    fn insert(&mut self, dialect: DialectName) -> bool {
        if let DialectName::Defined(defined) = dialect {
            let is_new = !self.defined.contains(&defined);
            if is_new {
                self.defined.push(defined);
            }
            return is_new;
        }
        let bit = 1 << dialect.base() as u32;
        let is_new = self.built_in & bit == 0;
        self.built_in |= bit;
        is_new
    }
}
