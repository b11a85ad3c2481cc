//! Writes an export: distributes cases over pages, and writes the folder.
//!
//! A folder holds `page-001.st` and so on, `manifest.json`, and `answers.txt`, in which a person notes outcomes that no array of
//! results can show.

use crate::answers::{self, ANSWERS, TEMPLATE};
use crate::manifest::{MANIFEST, Manifest, PageRecord};
use crate::page::{PageText, elements_of};
use crate::page_case::{ExtraCases, PageCase, PageKind};
use crate::plcopen::{Project, ProjectPlan};
use crate::{ExportError, Reason};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use stickler_run::DefinedHeader;
use stickler_suite::Case;
use stickler_types::DialectName;

/// The choice of the contents of an export.
#[derive(Clone, Debug)]
pub struct ExportPlan {
    /// The dialect of the cases.
    pub dialect: DialectName,
    /// The definition of the dialect for reports, where stickler.toml defines it.
    pub defined: Option<DefinedHeader>,
    /// The version of the suite, for the manifest.
    pub suite: String,
    /// The maximum number of cases on a page.
    pub cases_per_page: usize,
    /// The kinds of cases beside those whose programs must be accepted.
    pub with: BTreeSet<ExtraCases>,
    /// The ids of cases that are left out.
    pub without: BTreeSet<String>,
    /// The maximum number of cases, drawn evenly from all that could be exported; `None` takes all.
    pub sample: Option<usize>,
    /// Whether the declarations and the statements of each page are also written as files of their own.
    pub panes: bool,
    /// The project file that holds all pages that run; `None` writes none.
    pub project: Option<ProjectPlan>,
}

/// The result of an export.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Exported {
    /// The number of pages.
    pub pages: usize,
    /// The number of pages that are only compiled.
    pub compiled_only: usize,
    /// The number of cases on the pages.
    pub cases: usize,
    /// The number of cases on the pages that have an answer already, so that their programs are left out.
    pub answered: usize,
    /// The number of cases that were left out, by the reason.
    pub left_out: BTreeMap<Reason, usize>,
}

/// Writes an export of cases into a folder, which is empty, does not exist yet, or holds an earlier export: then
/// all its files but the person's answers are replaced. Leaves out the program of a case that has an answer, so that the others of
/// its page can run; pages without such a case do not change, and arrays that were copied from them stay valid.
///
/// # Errors
/// [`ExportError::Occupied`] before anything is written; [`ExportError::Write`]; [`ExportError::Character`] and
/// [`ExportError::Syntax`] where a page does not fit into the project.
pub fn export(plan: &ExportPlan, cases: &[&Case], folder: &Path) -> Result<Exported, ExportError> {
    prepare(folder)?;
    let answers = answers::read(folder, plan.dialect)?;
    let mut exported = Exported::default();
    let mut left_out: BTreeMap<Reason, usize> = BTreeMap::new();
    let mut leave_out = |reason: Reason| *left_out.entry(reason).or_default() += 1;
    let mut ready = Vec::new();
    for case in cases.iter().filter(|case| case.dialect == plan.dialect) {
        if plan.without.contains(&*case.id) {
            leave_out(Reason::Named);
            continue;
        }
        match PageCase::of(case, &plan.with) {
            Ok(mut ready_case) => {
                ready_case.answered = answers.contains_key(&*case.id);
                exported.answered += usize::from(ready_case.answered);
                ready.push(ready_case);
            }
            Err(reason) => leave_out(reason),
        }
    }
    let before = ready.len();
    let mut ready = drawn(ready, plan.sample);
    for _ in ready.len()..before {
        leave_out(Reason::Sampled);
    }
    ready.sort_by_key(|ready| ready.kind);
    let chunks = chunks(&ready, plan.cases_per_page.max(1));
    let mut manifest = Manifest::new(&plan.suite, plan.dialect.as_str());
    manifest.defined.clone_from(&plan.defined);
    let reported = format!(
        "{}, suite {}, Stickler {}.",
        plan.dialect,
        plan.suite,
        env!("CARGO_PKG_VERSION")
    );
    let mut taken = BTreeSet::new();
    let mut project = plan.project.as_ref().map(|to| (to, Project::new(plan.dialect)));
    for (number, chunk) in chunks.iter().enumerate() {
        let page = PageText::write((number + 1, chunks.len()), chunk, &reported, &mut taken);
        let stem = format!("page-{:03}", page.number);
        write(&folder.join(format!("{stem}.st")), &page.text())?;
        if plan.panes {
            write_panes(&page, folder, &stem)?;
        }
        if let Some((_, project)) = &mut project {
            project.add(&page, &format!("{stem}.st"))?;
        }
        exported.compiled_only += usize::from(page.kind.is_compiled());
        exported.cases += chunk.len();
        manifest.pages.push(PageRecord::of(&page, format!("{stem}.st")));
    }
    if let Some((to, project)) = project {
        project.write(to, &reported)?;
    }
    exported.pages = chunks.len();
    exported.left_out = left_out;
    let text = serde_json::to_string(&manifest).unwrap_or_default();
    // The manifest is written last, so that a folder with a manifest is complete.
    write(&folder.join(MANIFEST), &text)?;
    Ok(exported)
}

/// Returns whether there is a folder and something in it.
///
/// # Errors
/// [`ExportError::Read`].
pub(crate) fn is_occupied(folder: &Path) -> Result<bool, ExportError> {
    match fs::read_dir(folder) {
        Ok(mut entries) => Ok(entries.next().is_some()),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(false),
        Err(error) => Err(ExportError::Read(folder.to_owned(), error)),
    }
}

/// Makes the folder, or removes the files of an earlier export from it.
fn prepare(folder: &Path) -> Result<(), ExportError> {
    let writing = |error| ExportError::Write(folder.to_owned(), error);
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == ErrorKind::NotFound => {
            fs::create_dir_all(folder).map_err(writing)?;
            return write(&folder.join(ANSWERS), TEMPLATE);
        }
        Err(error) => return Err(ExportError::Read(folder.to_owned(), error)),
    };
    let names: Vec<String> = entries
        .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
        .collect::<Result<_, std::io::Error>>()
        .map_err(|error| ExportError::Read(folder.to_owned(), error))?;
    // An interrupted export counts as an earlier one, too. Other programs have files with the name of the manifest.
    let has_manifest = names.iter().any(|name| name == MANIFEST);
    let has_page = names.iter().any(|name| is_of_a_page(name));
    let broken = names.iter().all(|name| is_ours(name)) && (has_page || !has_manifest);
    if !broken && !Manifest::is_at(&folder.join(MANIFEST)) {
        let other = format!(" and holds no earlier export (there is no {MANIFEST} of one in it)");
        return Err(ExportError::Occupied(folder.to_owned(), other));
    }
    for name in names.iter().filter(|name| is_ours(name) && *name != ANSWERS) {
        let path = folder.join(name);
        fs::remove_file(&path).map_err(|error| ExportError::Write(path, error))?;
    }
    if names.iter().any(|name| name == ANSWERS) {
        return Ok(());
    }
    write(&folder.join(ANSWERS), TEMPLATE)
}

/// Returns whether an export writes files of the given name.
fn is_ours(name: &str) -> bool {
    name == MANIFEST || name == ANSWERS || is_of_a_page(name)
}

fn is_of_a_page(name: &str) -> bool {
    name.strip_prefix("page-").is_some_and(|rest| {
        let digits = rest.bytes().take_while(u8::is_ascii_digit).count();
        digits >= 3 && ENDINGS.contains(&&rest[digits..])
    })
}

const ENDINGS: [&str; 4] = [".st", "-declarations.txt", "-statements.txt", "-units.st"];

fn write(path: &Path, text: &str) -> Result<(), ExportError> {
    fs::write(path, text).map_err(|error| ExportError::Write(path.to_owned(), error))
}

fn write_panes(page: &PageText<'_, '_>, folder: &Path, stem: &str) -> Result<(), ExportError> {
    let parts = [&page.declarations, &page.statements, &page.units];
    for (text, ending) in parts.into_iter().zip(&ENDINGS[1..]) {
        if !text.is_empty() {
            write(&folder.join(format!("{stem}{ending}")), text)?;
        }
    }
    Ok(())
}

/// Draws `sample` items evenly from first to last; all where it is `None`.
fn drawn<T>(all: Vec<T>, sample: Option<usize>) -> Vec<T> {
    let (length, wanted) = (all.len(), sample.unwrap_or(usize::MAX));
    if wanted >= length {
        return all;
    }
    // An item is drawn where the count of drawn ones steps up.
    let takes = |index: usize| (index + 1) * wanted / length > index * wanted / length;
    let numbered = all.into_iter().enumerate();
    numbered
        .filter(|(index, _)| takes(*index))
        .map(|(_, item)| item)
        .collect()
}

/// The maximum number of elements for the observations of a page: some editors show no more than a thousand elements of an array.
const MAX_PAGE_ELEMENTS: usize = 980;

/// Divides cases into pages: of one kind each, of at most `most` cases, and of at most [`MAX_PAGE_ELEMENTS`] elements.
fn chunks<'r, 'c>(ready: &'r [PageCase<'c>], most: usize) -> Vec<&'r [PageCase<'c>]> {
    let mut chunks = Vec::new();
    let mut begin = 0;
    let mut elements = 0;
    let kind = |at: usize| -> Option<PageKind> { ready.get(at).map(|ready| ready.kind) };
    for at in 0..ready.len() {
        elements += elements_of(&ready[at]);
        let next = ready.get(at + 1).map_or(0, elements_of);
        if at + 1 - begin == most || kind(at + 1) != kind(at) || elements + next > MAX_PAGE_ELEMENTS {
            chunks.push(&ready[begin..=at]);
            (begin, elements) = (at + 1, 0);
        }
    }
    chunks
}
