//! `discrepancies/ENGINE/NN-….md`: the deviations of an engine from documents, one page for each cause, or, where the run did
//! not search for causes, for each cluster of cases. Each page can be pasted into a tracker: the smallest program, the
//! compiler's own commands, the expected result and its basis, the actual result.
//!
//! A cluster holds the cases of one case file and claim with one symptom. Only the smallest program of a cluster is kept, so
//! that memory does not grow with the number of cases.

mod cause_page;
mod page;
mod prose;

pub(crate) use cause_page::{page as cause_page_of, titled};

use crate::ReportError;
use crate::claims::entry;
use crate::observations::probe;
use crate::overview::{Overview, kept};
use crate::pending::PendingFile;
use prose::without_program;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_run::{CaseEvent, Cause, Event, ExplainedCases, Grade, Reproducer, Symptom, Verdict};

/// The name of the pages' folder in a folder of reports.
pub(crate) const NAME: &str = "discrepancies";

/// The name of the folder of the pages about what contradicts no source that binds the engine.
const DIFFERS: &str = "differs";

/// The name of the folder of the pages whose programs were not made as small as possible, so that most show a cause that has a page.
const UNREDUCED: &str = "unreduced";

/// The maximum number of causes or clusters of one engine; cases that belong to no kept one are counted.
const MAX_CLUSTERS: usize = 300;

/// The clusters of a run, gathered until their pages are written.
pub(crate) struct Discrepancies {
    folder: PathBuf,
    /// Whether the pages have no text of a program.
    prose: bool,
    engines: BTreeMap<String, EngineClusters>,
}

/// The deviations of one engine.
#[derive(Default)]
struct EngineClusters {
    /// The worst grade of a rejection by the engine that still passed.
    strict: Grade,
    clusters: BTreeMap<ClusterKey, Cluster>,
    /// The causes of its failing cases, those that explain most cases first; none where they were not searched for.
    causes: Vec<Cause>,
    /// The features that it lacks although a source that binds it promises them.
    lacks: Vec<Cause>,
    /// The number of failing cases.
    failing: u64,
}

/// The common properties of the cases of a cluster.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct ClusterKey {
    basis: String,
    /// The beginning that the ids of the case file's cases share.
    file: String,
    symptom: Symptom,
}

/// A cluster of cases that most probably fail for one reason.
struct Cluster {
    /// The case with the smallest program.
    smallest: CaseEvent,
    /// The number of cases, by probe, dialect and verdict.
    cases: BTreeMap<(String, String, Verdict), u64>,
}

impl Discrepancies {
    /// Removes the pages that an earlier run left in this folder of reports; the new ones have no text of a program where they are `prose`.
    ///
    /// # Errors
    /// [`ReportError::Write`] where they cannot be removed.
    pub(crate) fn create(reports: &Path, prose: bool) -> Result<Discrepancies, ReportError> {
        let folder = reports.join(NAME);
        remove_pages(&folder)?;
        Ok(Discrepancies {
            folder,
            prose,
            engines: BTreeMap::new(),
        })
    }

    /// Adds one event.
    pub(crate) fn take(&mut self, event: &Event) {
        match event {
            // Only a case that did not come out as expected has a program.
            Event::Case(case) if case.program.is_some() && case.actual_verdict().is_discrepancy() => {
                self.take_case(case);
            }
            Event::Header(header) => {
                for engine in &header.engines {
                    entry(&mut self.engines, &engine.name).strict = engine.strict;
                }
            }
            // What nobody promises has no page.
            Event::Cause(cause) if cause.is_lack() => {
                if cause.is_failing_lack() {
                    entry(&mut self.engines, &cause.engine).lacks.push(cause.clone());
                }
            }
            Event::Cause(cause) => {
                let causes = &mut entry(&mut self.engines, &cause.engine).causes;
                if causes.len() < MAX_CLUSTERS {
                    causes.push(cause.clone());
                }
            }
            Event::Case(_) | Event::Footer(_) => {}
        }
    }

    fn take_case(&mut self, case: &CaseEvent) {
        let file = case.id.split("::").next().unwrap_or(&case.id);
        let engine = entry(&mut self.engines, &case.engine);
        engine.failing += 1;
        let key = ClusterKey {
            basis: case.basis.clone(),
            file: file.to_owned(),
            symptom: Symptom::of(case, engine.strict),
        };
        if engine.clusters.len() >= MAX_CLUSTERS && !engine.clusters.contains_key(&key) {
            return;
        }
        let cluster = engine.clusters.entry(key).or_insert_with(|| Cluster {
            smallest: kept(case),
            cases: BTreeMap::new(),
        });
        let counted = (probe(&case.id).to_owned(), case.dialect.clone(), case.verdict);
        *cluster.cases.entry(counted).or_default() += 1;
        if size(case) < size(&cluster.smallest) {
            cluster.smallest = kept(case);
        }
    }

    /// Writes the pages. A run that was cut short gets none.
    ///
    /// # Errors
    /// [`ReportError::Write`] where a page cannot be written.
    pub(crate) fn finish(self, overview: &Overview) -> Result<(), ReportError> {
        if overview.footer.is_none() {
            return Ok(());
        }
        let engines = self.engines.into_iter();
        for (name, engine) in
            engines.filter(|(_, engine)| !engine.clusters.is_empty() || !engine.lacks.is_empty())
        {
            let folder = self.folder.join(file_name(&name));
            engine.write(&folder, &name, overview, self.prose)?;
        }
        Ok(())
    }
}

/// A cause of failing cases, or a cluster in the form of one, with the case that has its smallest program.
type Discrepancy = (Cause, Option<CaseEvent>);

impl EngineClusters {
    /// Writes a page for each cause or cluster, and the lists of them: what contradicts no source that binds the engine, and causes whose
    /// programs are not as small as possible, have folders of their own.
    fn write(self, folder: &Path, name: &str, overview: &Overview, prose: bool) -> Result<(), ReportError> {
        let about = overview.engine(name);
        let words = match self.causes.is_empty() {
            true => cause_page::OF_CLUSTERS,
            false => cause_page::OF_CAUSES,
        };
        let failing = self.failing;
        let mut found = self.discrepancies(name);
        if prose {
            found.iter_mut().for_each(|(cause, _)| without_program(cause));
        }
        let causes = found.iter().filter(|(cause, _)| !cause.is_lack());
        let explained: u64 = causes.map(|(cause, _)| cause.number()).sum();
        let all = found.iter();
        let (partly, small): (Vec<_>, Vec<_>) = all.partition(|(cause, _)| cause.is_partly_reduced());
        let small = small.into_iter();
        let (differ, fail): (Vec<_>, Vec<_>) = small.partition(|(cause, _)| cause.differs());
        let unexplained = failing.saturating_sub(explained);
        let mut index = cause_page::index(name, about, (fail.len(), words), unexplained);
        index.push_str(&cause_page::list(&fail));
        let separate = [
            (UNREDUCED, partly, cause_page::UNREDUCED),
            (DIFFERS, differ, cause_page::DIFFERS),
        ];
        for (kind, found, words) in separate.into_iter().filter(|(_, found, _)| !found.is_empty()) {
            index.push_str(&words.link(kind, &found));
            let list = words.head(name, about) + &cause_page::list(&found);
            write_pages(&folder.join(kind), name, overview, &found, &list)?;
        }
        write_pages(folder, name, overview, &fail, &index)
    }

    /// Returns the features that the engine lacks, and the causes, or the clusters where causes were not searched for; those with most
    /// cases come first.
    fn discrepancies(self, name: &str) -> Vec<Discrepancy> {
        let clusters = self.clusters.into_iter().filter(|_| self.causes.is_empty());
        let mut clusters: Vec<Discrepancy> = clusters
            .map(|(key, cluster)| (cluster.cause(name, &key), Some(cluster.smallest)))
            .collect();
        clusters.sort_by_key(|(cause, _)| std::cmp::Reverse(cause.number()));
        let causes = self.lacks.into_iter().chain(self.causes);
        causes.map(|cause| (cause, None)).chain(clusters).collect()
    }
}

/// Writes a page for each of these causes, and the list of them.
fn write_pages(
    folder: &Path,
    name: &str,
    overview: &Overview,
    found: &[&Discrepancy],
    list: &str,
) -> Result<(), ReportError> {
    fs::create_dir_all(folder).map_err(ReportError::writing(folder))?;
    let about = overview.engine(name);
    for ((cause, case), number) in found.iter().copied().zip(1..) {
        let page = cause_page::page(name, about, (cause, case.as_ref()), overview);
        write(folder.join(cause_page::file(number, cause)), &page)?;
    }
    write(folder.join("README.md"), list)
}

impl Cluster {
    /// Returns the cluster in the form of a cause.
    fn cause(&self, engine: &str, key: &ClusterKey) -> Cause {
        let case = &self.smallest;
        let cases = self.cases.iter();
        Cause {
            engine: engine.to_owned(),
            title: format!("{}: {}", key.file, key.symptom),
            shown: Reproducer {
                case: case.id.clone(),
                dialect: case.dialect.clone(),
                basis: case.basis.clone(),
                program: case.program.clone().unwrap_or_default(),
                expected: case.expected.clone(),
                got: case.got.clone(),
                ..Reproducer::default()
            },
            cases: cases
                .map(|((probe, dialect, verdict), cases)| ExplainedCases {
                    probe: probe.clone(),
                    dialect: dialect.clone(),
                    basis: case.basis.clone(),
                    verdict: *verdict,
                    cases: *cases,
                })
                .collect(),
            ..Cause::default()
        }
    }
}

fn size(case: &CaseEvent) -> usize {
    case.program.as_ref().map_or(usize::MAX, String::len)
}

fn write(path: PathBuf, text: &str) -> Result<(), ReportError> {
    PendingFile::create(path)?.fill(text.as_bytes())
}

/// Returns a name that every file system accepts: a character other than a letter, digit, hyphen or dot becomes a hyphen,
/// and so does a dot at the beginning, which would hide the file or lead elsewhere.
pub(crate) fn file_name(name: &str) -> String {
    let safe = |(at, character): (usize, char)| match character {
        'a'..='z' | 'A'..='Z' | '0'..='9' | '-' | '_' => character,
        '.' if at > 0 => character,
        _ => '-',
    };
    name.char_indices().map(safe).collect()
}

/// Removes the pages of all engines, and the folders that are empty then. Other files in the folders stay.
fn remove_pages(folder: &Path) -> Result<(), ReportError> {
    for engine in entries(folder) {
        let folders = [engine.join(DIFFERS), engine.join(UNREDUCED), engine];
        for page in folders.iter().flat_map(|folder| entries(folder)) {
            let name = page
                .file_name()
                .unwrap_or_default()
                .to_string_lossy()
                .into_owned();
            let numbered = name.starts_with(|character: char| character.is_ascii_digit());
            if name == "README.md" || (numbered && name.ends_with(".md")) {
                fs::remove_file(&page).map_err(ReportError::writing(&page))?;
            }
        }
        // A folder in which something is left is no error.
        for folder in folders {
            let _ = fs::remove_dir(folder);
        }
    }
    let _ = fs::remove_dir(folder);
    Ok(())
}

/// Returns the paths in a folder; none where there is no such folder.
fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.path()).collect()
}

#[cfg(test)]
mod tests;
