//! Reads a folder of case files into a suite.

use std::cell::RefCell;
use std::collections::BTreeSet;
use std::panic::resume_unwind;
use std::path::Path;
use std::thread;

use rustc_hash::FxHashMap;
use serde::Deserialize;
use stickler_types::{DialectName, Fnv1a};
use stickler_workers::{SpawnError, WorkerPool};

use crate::defined::restate;
use crate::error::{Mistake, in_file};
use crate::files::FileKind;
use crate::frame::{FileContext, Harvest};
use crate::place::Lines;
use crate::places::Places;
use crate::{Case, CaseFileError, Dialects, Features, SourceStatement, Sources, Withdrawn};
use crate::{dialects, features, files, ident, places, single, sources, statements, table, toml_text};

/// The cases of a folder, and the mistakes in its files.
#[derive(Clone, Debug, Default)]
pub struct Suite {
    /// The suite's own version, from `suite.toml`; results name it.
    pub version: String,
    /// The cases, ordered by path and then by their place in the file.
    pub cases: Vec<Case>,
    /// The mistakes in case files, ordered by file and line. The sound part of the suite is loaded all the same.
    pub errors: Vec<CaseFileError>,
    /// The dialects and groups that case files may name, from `dialects.toml`.
    pub dialects: Dialects,
    /// The sources that cases may cite, from `sources.toml` and `rules.md`.
    pub sources: Sources,
    /// The places in which programs can be put together, from `places.toml`.
    pub places: Places,
    /// The features of the language, from `features.toml`.
    pub features: Features,
    /// The answers of sources to questions that no case can ask, from `statements.toml`.
    pub statements: Vec<SourceStatement>,
    /// The cases that were withdrawn, from `withdrawn.toml`.
    pub withdrawn: Vec<Withdrawn>,
    /// The warnings of lint about the files, beside their mistakes.
    pub(crate) remarks: Vec<CaseFileError>,
}

/// The dialects whose cases are wanted of a suite. By default every dialect has cases, and repeats are left out.
#[derive(Clone, Copy, Debug, Default)]
pub struct Wanted<'w> {
    /// The dialects that were [defined](DialectName::define) and take over the cases of the dialect that each extends, unchanged except
    /// where its definition states a result. An overridden cell of a matrix expects the word of the definition, and a call of a conversion
    /// function expects the result of exact arithmetic with the choices of the definition. Whether another case depends on an override
    /// cannot be told here.
    pub defined: &'w [DialectName],
    /// The dialects that get cases; all where there is none.
    pub asked: &'w [DialectName],
    /// Whether a dialect that is asked beside another one, such as another edition of one compiler, gets the cases of tables in which
    /// they do not differ. Otherwise it gets a sample of them, unless the other one is not asked.
    pub with_repeats: bool,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SuiteFile {
    version: String,
}

impl Suite {
    /// Reads every case file below `dir`, the folder that has `suite.toml`, `dialects.toml` and `sources.toml`.
    ///
    /// Loading never fails: mistakes are listed in [`Suite::errors`], also if `dir` does not exist.
    pub fn load(dir: &Path) -> Suite {
        Suite::load_with(dir, Wanted::default())
    }

    /// Reads every case file, and returns the cases that are wanted.
    pub fn load_with(dir: &Path, wanted: Wanted<'_>) -> Suite {
        Suite::load_files(dir, wanted, |_, _| true)
    }

    /// Reads the case files that `is_wanted` selects by the id of a file (its path below `dir` without the extension) and
    /// its kind. Does not report the mistakes of the other files.
    pub fn load_files(dir: &Path, wanted: Wanted<'_>, is_wanted: impl Fn(&str, FileKind) -> bool) -> Suite {
        let root = files::Root::new(dir);
        let (mut suite, mut listing) = thread::scope(|scope| {
            // Nothing else is needed to list the files, and the other processor is idle.
            let listing = thread::Builder::new().spawn_scoped(scope, || files::list(&root));
            let suite = Suite::without_cases(&root, wanted);
            let listing = match listing {
                Ok(listing) => listing.join().unwrap_or_else(|panic| resume_unwind(panic)),
                // Without threads it takes longer.
                Err(_) => files::list(&root),
            };
            (suite, listing)
        });
        listing
            .files
            .retain(|file| is_wanted(ident::stem(&file.below_root), file.kind));
        suite.errors.extend(listing.errors);
        suite.remarks.extend(listing.remarks);
        let read = |file: &files::CaseFile| {
            let mut harvest = read_file(file, suite.names());
            let cases = harvest.cases.iter_mut();
            cases.filter(|case| case.dialect.is_custom()).for_each(restate);
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
        suite.errors.sort();
        suite
    }

    /// Reads the files of the suite's own.
    fn without_cases(root: &files::Root, wanted: Wanted<'_>) -> Suite {
        let mut suite = Suite::default();
        suite.read_version(root);
        suite.read_withdrawn(root);
        let (dialects, of_dialects) = dialects::read(root);
        suite.dialects = dialects.wanting(wanted);
        let read = sources::read(root, &suite.dialects);
        suite.sources = read.sources;
        suite.remarks.extend(read.remarks);
        let (places, of_places) = places::read(root, &suite.dialects, &suite.sources);
        let (features, of_features) = features::read(root, &suite.sources, &suite.dialects);
        let (statements, of_statements) = statements::read(root, &suite.sources);
        (suite.places, suite.features, suite.statements) = (places, features, statements);
        let errors = [of_dialects, read.errors, of_places, of_features, of_statements];
        suite.errors.extend(errors.into_iter().flatten());
        suite
    }

    fn names(&self) -> SuiteNames<'_> {
        SuiteNames {
            dialects: &self.dialects,
            features: &self.features,
            sources: Some(&self.sources),
            places: &self.places,
        }
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

    fn take(&mut self, shown: &str, harvest: Harvest) {
        self.cases.extend(harvest.cases);
        self.errors.extend(in_file(harvest.mistakes, shown));
        self.remarks.extend(in_file(harvest.remarks, shown));
    }
}

/// Reads the one case file `path` as a part of the suite at `root`; returns the cases to run and the file's mistakes.
///
/// `path` may be given relative to the working folder or absolute, as test harnesses that walk `root` give it.
pub fn load_file(root: &Path, path: &Path) -> (Vec<Case>, Vec<CaseFileError>) {
    let root = files::Root::new(root);
    let mut suite = Suite::without_cases(&root, Wanted::default());
    match root.case_file(path) {
        Ok(file) => {
            let harvest = read_file(&file, suite.names());
            suite.take(&file.shown, harvest);
        }
        Err(error) => suite.errors.push(error),
    }
    (suite.cases, suite.errors)
}

/// Reads a case file from memory: `text` under the path `name` below a suite's root, whose extension makes it a program
/// (`.st`) or a table (`.toml`), which may be put together of `places`. Returns the cases to run and the mistakes, but does not
/// ask whether a basis names a source.
pub fn read_case_file(
    name: &str,
    text: &str,
    dialects: &Dialects,
    places: &Places,
) -> (Vec<Case>, Vec<CaseFileError>) {
    let names = SuiteNames {
        dialects,
        features: &Features::default(),
        sources: None,
        places,
    };
    let harvest = match files::kind(name) {
        Some(kind) => read_text(name, name, kind, text, names),
        None => wrong(Mistake::new(1, files::NO_CASE_FILE)),
    };
    (harvest.cases, in_file(harvest.mistakes, name))
}

/// The names that the files of a suite may use.
#[derive(Clone, Copy)]
struct SuiteNames<'a> {
    dialects: &'a Dialects,
    features: &'a Features,
    sources: Option<&'a Sources>,
    places: &'a Places,
}

fn read_file(file: &files::CaseFile, names: SuiteNames<'_>) -> Harvest {
    match files::read(&file.path) {
        Ok(text) => read_text(&file.below_root, &file.shown, file.kind, &text, names),
        Err(mistake) => wrong(mistake),
    }
}

/// Returns the result for a file that could not be read: no case, and one mistake.
fn wrong(mistake: Mistake) -> Harvest {
    Harvest {
        mistakes: vec![mistake],
        ..Harvest::default()
    }
}

fn read_text(below_root: &str, shown: &str, kind: FileKind, text: &str, names: SuiteNames<'_>) -> Harvest {
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
        dialects: names.dialects,
        features: names.features,
        named: RefCell::default(),
        sources: names.sources,
        places: names.places,
        budget: table::Budget::default(),
    };
    let mut harvest = match kind {
        FileKind::Program => single::read(&context),
        FileKind::Table => table::read(&context),
    };
    harvest.mistakes.extend(harvest.citations.mistakes());
    harvest.remarks.extend(harvest.citations.idle());
    drop_duplicates(&mut harvest);
    if kind == FileKind::Table {
        drop_repeats(&mut harvest, names.dialects);
    }
    harvest
}

/// Drops each case whose id and dialect the file has already, and records one mistake per line. Ids of different files
/// differ.
fn drop_duplicates(harvest: &mut Harvest) {
    let mut seen: FxHashMap<&str, (BTreeSet<DialectName>, u32)> = FxHashMap::default();
    seen.reserve(harvest.cases.len() / 2);
    let mut mistakes = Vec::new();
    let mut is_first = Vec::with_capacity(harvest.cases.len());
    for case in &harvest.cases {
        let (dialects, first_line) = seen.entry(&case.id).or_insert((BTreeSet::new(), case.line));
        let is_new = dialects.insert(case.dialect);
        is_first.push(is_new);
        if is_new {
            continue;
        }
        let message = format!(
            "the id `{}` stands already at {}:{first_line}",
            case.id, case.file
        );
        let hint = "an id names one case: change the probe's name, or give the rows an `id` column";
        mistakes.push(Mistake::new(case.line, message).key("id").hint(hint));
    }
    if !mistakes.is_empty() {
        mistakes.dedup();
        harvest.mistakes.extend(mistakes);
        let mut is_first = is_first.into_iter();
        harvest.cases.retain(|_| is_first.next().unwrap_or(true));
    }
}

/// Drops most of the cases that another edition of the same compiler is asked, too, with the same expectation: those that are not in a sample
/// by a hash of the id.
fn drop_repeats(harvest: &mut Harvest, dialects: &Dialects) {
    const SAMPLE: u32 = 16;
    let others: Vec<(DialectName, DialectName)> = dialects.asked_beside().collect();
    let is_other = |dialect| others.iter().any(|&(_, other)| other == dialect);
    let cases = harvest.cases.iter().filter(|case| is_other(case.dialect));
    let there: FxHashMap<(&str, DialectName), &Case> =
        cases.map(|case| ((&*case.id, case.dialect), case)).collect();
    let is_repeated = |case: &Case| {
        let beside = others.iter().filter(|&&(dialect, _)| dialect == case.dialect);
        let mut twins = beside.filter_map(|&(_, other)| there.get(&(&*case.id, other)));
        twins.any(|twin| twin.asks_the_same_as(case)) && !Fnv1a::of(&*case.id).folded().is_multiple_of(SAMPLE)
    };
    let repeated: Vec<bool> = harvest.cases.iter().map(is_repeated).collect();
    let mut repeated = repeated.into_iter();
    harvest.cases.retain(|_| !repeated.next().unwrap_or(false));
}
