//! `discrepancies/ENGINE/NN-….md`: the deviations of an engine from documents, one page for each cause, or, where the run did
//! not search for causes, for each cluster of cases. Each page can be pasted into a tracker: the smallest program, the
//! compiler's own commands, the expected result and its basis, the actual result.
//!
//! A cluster holds the cases of one case file and claim with one symptom. Only the smallest program of a cluster is kept, so
//! that memory does not grow with the number of cases.

mod cause_page;
mod page;

pub(crate) use cause_page::page as cause_page_of;

use crate::ReportError;
use crate::claims::entry;
use crate::observations::probe;
use crate::overview::{Overview, kept};
use crate::pending::PendingFile;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use stickler_run::{CaseEvent, Cause, EngineHeader, Event, Grade, Symptom};

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
    /// The number of failing cases.
    failing: u64,
    /// The number of cases that belong to no kept cluster.
    left_out: u64,
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
    /// The number of cases, by probe and dialect.
    cases: BTreeMap<(String, String), u64>,
}

impl Discrepancies {
    /// Removes the pages that an earlier run left in this folder of reports.
    ///
    /// # Errors
    /// [`ReportError::Write`] where they cannot be removed.
    pub(crate) fn create(reports: &Path) -> Result<Discrepancies, ReportError> {
        let folder = reports.join(NAME);
        remove_pages(&folder)?;
        Ok(Discrepancies {
            folder,
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
            engine.left_out += 1;
            return;
        }
        let cluster = engine.clusters.entry(key).or_insert_with(|| Cluster {
            smallest: kept(case),
            cases: BTreeMap::new(),
        });
        let counted = (probe(&case.id).to_owned(), case.dialect.clone());
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
        let (Some(header), Some(_)) = (&overview.header, &overview.footer) else {
            return Ok(());
        };
        let engines = self.engines.iter();
        for (name, engine) in engines.filter(|(_, engine)| !engine.clusters.is_empty()) {
            let folder = self.folder.join(file_name(name));
            fs::create_dir_all(&folder).map_err(ReportError::writing(&folder))?;
            if !engine.causes.is_empty() {
                engine.write_causes(&folder, name, overview)?;
                continue;
            }
            let about = header.engines.iter().find(|engine| engine.name == *name);
            // The cluster with the most cases comes first.
            let mut clusters: Vec<(&ClusterKey, &Cluster)> = engine.clusters.iter().collect();
            clusters.sort_by_key(|(_, cluster)| std::cmp::Reverse(cluster.number()));
            let mut index = page::index(name, about, clusters.len(), engine.left_out);
            for (number, (key, cluster)) in clusters.into_iter().enumerate() {
                let file = page_name(number + 1, key);
                index.push_str(&page::entry(&file, key, cluster));
                write(folder.join(file), &page::page(name, about, key, cluster))?;
            }
            write(folder.join("README.md"), &index)?;
        }
        Ok(())
    }
}

impl EngineClusters {
    /// Writes a page for each cause, and the lists of them: causes that contradict no source that binds the engine, and those whose
    /// programs are not as small as possible, have folders of their own.
    fn write_causes(&self, folder: &Path, name: &str, overview: &Overview) -> Result<(), ReportError> {
        let about = engine(overview, name);
        let explained: u64 = self.causes.iter().map(Cause::number).sum();
        let unexplained = self.failing.saturating_sub(explained);
        let (differ, fail): (Vec<&Cause>, Vec<&Cause>) =
            self.causes.iter().partition(|cause| cause.differs());
        let (partly, fail): (Vec<&Cause>, Vec<&Cause>) =
            fail.into_iter().partition(|cause| cause.is_partly_reduced());
        let mut index = cause_page::index(name, about, fail.len(), unexplained);
        index.push_str(&cause_page::list(&fail));
        let separate = [
            (UNREDUCED, partly, cause_page::UNREDUCED),
            (DIFFERS, differ, cause_page::DIFFERS),
        ];
        for (kind, causes, words) in separate.into_iter().filter(|(_, causes, _)| !causes.is_empty()) {
            index.push_str(&words.link(kind, &causes));
            let folder = folder.join(kind);
            fs::create_dir_all(&folder).map_err(ReportError::writing(&folder))?;
            let text = words.head(name, about) + &cause_page::list(&causes);
            write(folder.join("README.md"), &text)?;
            write_pages(&folder, name, overview, &causes)?;
        }
        write_pages(folder, name, overview, &fail)?;
        write(folder.join("README.md"), &index)
    }
}

/// Writes a page for each of these causes.
fn write_pages(folder: &Path, name: &str, overview: &Overview, causes: &[&Cause]) -> Result<(), ReportError> {
    let about = engine(overview, name);
    for (cause, number) in causes.iter().zip(1..) {
        write(
            folder.join(cause_page::file(number, cause)),
            &cause_page::page(name, about, cause, overview),
        )?;
    }
    Ok(())
}

/// Returns the engine with this name, where the header of the run names it.
fn engine<'o>(overview: &'o Overview, name: &str) -> Option<&'o EngineHeader> {
    let mut engines = overview.header.iter().flat_map(|header| &header.engines);
    engines.find(|engine| engine.name == name)
}

impl Cluster {
    fn number(&self) -> u64 {
        self.cases.values().sum()
    }
}

fn size(case: &CaseEvent) -> usize {
    case.program.as_ref().map_or(usize::MAX, String::len)
}

fn write(path: PathBuf, text: &str) -> Result<(), ReportError> {
    PendingFile::create(path)?.fill(text.as_bytes())
}

/// Returns the name of a page's file, such as `03-bit-access-outside-short-line-of-P4025.md`.
fn page_name(number: usize, key: &ClusterKey) -> String {
    let mut name = file_name(&format!("{}-{}", key.file, key.symptom.word()));
    name.truncate(80);
    format!("{number:02}-{name}.md")
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
