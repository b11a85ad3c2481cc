//! An export: which cases stand on which page, and the folder that they are written to.
//!
//! A folder holds `page-001.st` and so on, `manifest.json`, and `answers.txt`, in which a person notes what no array can tell.

use crate::answers::{self, ANSWERS, TEMPLATE};
use crate::manifest::{MANIFEST, Manifest, PageRecord};
use crate::page::{Page, elements_of};
use crate::page_case::{ExtraCases, PageCase, PageKind};
use crate::{ExportError, Reason};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use stickler_run::DefinedHeader;
use stickler_suite::Case;
use stickler_types::DialectName;

/// What an export is to have.
#[derive(Clone, Debug)]
pub struct ExportPlan {
    /// The dialect of its cases.
    pub dialect: DialectName,
    /// What reports say of that dialect, where it is none of a documented system.
    pub defined: Option<DefinedHeader>,
    /// The version of the suite, for the manifest.
    pub suite: String,
    /// How many cases stand on a page at most.
    pub cases_per_page: usize,
    /// What it has beside programs that must be accepted.
    pub with: BTreeSet<ExtraCases>,
    /// Ids of cases that it must not have.
    pub without: BTreeSet<String>,
    /// How many cases it has at most, drawn evenly from all that it could have.
    pub sample: Option<usize>,
    /// Beside each page, its declarations and its statements as files of their own.
    pub panes: bool,
}

/// What was exported.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Exported {
    /// How many pages.
    pub pages: usize,
    /// How many of them are only compiled.
    pub compiled_only: usize,
    /// How many cases are on them.
    pub cases: usize,
    /// How many of them have an answer already, so that their programs are not there.
    pub answered: usize,
    /// How many cases were left out, by the reason.
    pub left_out: BTreeMap<Reason, usize>,
}

/// Writes an export of these cases into a folder, which is empty, not there yet, or that of an earlier export: of that,
/// all but the person's answers is replaced. Of a case that has an answer the program is left out, so that the others of its page can
/// run; pages without such a case stay what they were, and so do the arrays that were copied of them.
///
/// # Errors
/// [`ExportError::NotEmpty`] before anything is written; [`ExportError::Write`].
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
    let told = format!(
        "{}, suite {}, Stickler {}.",
        plan.dialect,
        plan.suite,
        env!("CARGO_PKG_VERSION")
    );
    let mut taken = BTreeSet::new();
    for (number, chunk) in chunks.iter().enumerate() {
        let page = Page::write((number + 1, chunks.len()), chunk, &told, &mut taken);
        let stem = format!("page-{:03}", page.number);
        write(&folder.join(format!("{stem}.st")), &page.text())?;
        if plan.panes {
            write_panes(&page, folder, &stem)?;
        }
        exported.compiled_only += usize::from(page.kind.is_rejected());
        exported.cases += chunk.len();
        manifest.pages.push(PageRecord::of(&page, format!("{stem}.st")));
    }
    exported.pages = chunks.len();
    exported.left_out = left_out;
    let text = serde_json::to_string(&manifest).unwrap_or_default();
    // Last, so that a folder with a manifest is whole.
    write(&folder.join(MANIFEST), &text)?;
    Ok(exported)
}

/// Makes the folder, or takes out of it what an earlier export left.
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
    // Also what a broken export left is an earlier one. Other programs have files that are called as the manifest is.
    let has_manifest = names.iter().any(|name| name == MANIFEST);
    let has_page = names.iter().any(|name| is_of_a_page(name));
    let broken = names.iter().all(|name| is_ours(name)) && (has_page || !has_manifest);
    if !broken && !Manifest::is_at(&folder.join(MANIFEST)) {
        return Err(ExportError::NotEmpty(folder.to_owned()));
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

/// Tells whether an export writes a file of this name.
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

fn write_panes(page: &Page<'_, '_>, folder: &Path, stem: &str) -> Result<(), ExportError> {
    let parts = [&page.declarations, &page.statements, &page.units];
    for (text, ending) in parts.into_iter().zip(&ENDINGS[1..]) {
        if !text.is_empty() {
            write(&folder.join(format!("{stem}{ending}")), text)?;
        }
    }
    Ok(())
}

/// So many of these, evenly from first to last.
fn drawn<T>(all: Vec<T>, sample: Option<usize>) -> Vec<T> {
    let (length, wanted) = (all.len(), sample.unwrap_or(usize::MAX));
    if wanted >= length {
        return all;
    }
    // The item at which the count of drawn ones steps up.
    let takes = |index: usize| (index + 1) * wanted / length > index * wanted / length;
    let numbered = all.into_iter().enumerate();
    numbered
        .filter(|(index, _)| takes(*index))
        .map(|(_, item)| item)
        .collect()
}

/// How many elements of observations a page has at most, so that its whole array is shown: some editors show no more than a
/// thousand of them.
const MAX_PAGE_ELEMENTS: usize = 980;

/// The pages: cases of one kind, no more than are wanted, and no more elements than an editor shows.
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
