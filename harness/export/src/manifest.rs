//! The manifest of an export, which contains all that an import needs: the pages, their cases, and the elements and lines of each
//! case.

use crate::ExportError;
use crate::encoding::encoded;
use crate::page::{FIRST_OBSERVATION, PageText};
use crate::page_case::PageCase;
use crate::record::CaseRecord;
use serde::{Deserialize, Serialize};
use std::fs;
use std::io::ErrorKind;
use std::path::Path;
use stickler_run::DefinedHeader;
use stickler_types::ElementaryType;

/// The file name of the manifest.
pub const MANIFEST: &str = "manifest.json";

/// The version of the manifest's format.
const FORMAT: u32 = 1;

/// The maximum number of elements of an array in a valid manifest; a page has about a thousand, and more only for a single case.
const MAX_ARRAY_ELEMENTS: usize = 1_000_000;

/// The manifest of an export.
#[derive(Clone, PartialEq, Debug, Serialize, Deserialize)]
pub(crate) struct Manifest {
    /// The version of the manifest's format.
    pub(crate) format: u32,
    /// The version of Stickler that wrote the export.
    pub(crate) stickler: String,
    /// The version of the suite.
    pub(crate) suite: String,
    /// The dialect of all cases.
    pub(crate) dialect: String,
    /// The definition of the dialect at the time of the export, where stickler.toml defines it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) defined: Option<DefinedHeader>,
    /// The pages, in the order of their numbers.
    pub(crate) pages: Vec<PageRecord>,
}

/// A page in the manifest.
#[derive(Clone, PartialEq, Debug, Default, Serialize, Deserialize)]
pub(crate) struct PageRecord {
    /// The file of the page.
    pub(crate) file: String,
    /// The number of the page, from 1.
    pub(crate) number: usize,
    /// The identity of the page, which every array of its results contains; 0 where the page is only compiled.
    pub(crate) identity: i32,
    /// The number of elements of the page's array; 0 where the page is only compiled.
    pub(crate) elements: usize,
    /// The cases of the page, in order.
    pub(crate) cases: Vec<CaseRecord>,
    /// The observations of the page, in order.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) steps: Vec<StepRecord>,
    /// The indices of the cases that had an answer, whose programs are left out.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(crate) answered: Vec<usize>,
    /// The lines of the page, by which messages are attributed to cases.
    pub(crate) lines: LinesRecord,
}

/// The line numbers of a page and of its cases.
#[derive(Clone, PartialEq, Eq, Debug, Default, Serialize, Deserialize)]
pub(crate) struct LinesRecord {
    /// The number of lines of POUs and types before the page's program; the other numbers count from there.
    pub(crate) units: usize,
    /// The number of lines before the page's statements.
    pub(crate) declarations: usize,
    /// The ranges of lines of each case; for a page that is only compiled, followed by those of its first and its last statement.
    pub(crate) cases: Vec<Vec<(usize, usize)>>,
}

/// An observation in the manifest.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub(crate) struct StepRecord {
    /// The index of the case on the page.
    pub(crate) case: usize,
    /// The index of the variable among those that the case observes; `None` where the case only has to run.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub(crate) observe: Option<usize>,
    /// The index of the observation's first element.
    pub(crate) place: usize,
}

impl Manifest {
    pub(crate) fn new(suite: &str, dialect: &str) -> Manifest {
        Manifest {
            format: FORMAT,
            stickler: env!("CARGO_PKG_VERSION").to_owned(),
            suite: suite.to_owned(),
            dialect: dialect.to_owned(),
            defined: None,
            pages: Vec::new(),
        }
    }

    /// Returns whether a file is the manifest of an export, of any format version.
    pub(crate) fn is_at(path: &Path) -> bool {
        #[derive(Deserialize)]
        struct Origin {
            #[serde(rename = "stickler")]
            _stickler: String,
        }
        fs::read(path).is_ok_and(|bytes| serde_json::from_slice::<Origin>(&bytes).is_ok())
    }

    /// Reads the manifest of a folder.
    ///
    /// # Errors
    /// [`ExportError::NoExport`] where there is no manifest, [`ExportError::Read`] and [`ExportError::Manifest`] where it cannot be
    /// understood.
    pub(crate) fn read(folder: &Path) -> Result<Manifest, ExportError> {
        let path = folder.join(MANIFEST);
        let text = match fs::read_to_string(&path) {
            Ok(text) => text,
            Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory) => {
                return Err(ExportError::NoExport(folder.to_owned()));
            }
            Err(error) => return Err(ExportError::Read(path, error)),
        };
        let broken = |what: String| ExportError::Manifest(path.clone(), what);
        let manifest: Manifest = serde_json::from_str(&text).map_err(|error| broken(error.to_string()))?;
        if manifest.format != FORMAT {
            return Err(broken(format!(
                "its format is {}, and this version of Stickler reads {FORMAT}",
                manifest.format
            )));
        }
        manifest.check().map_err(broken)?;
        Ok(manifest)
    }

    /// # Errors
    /// A fragment that names a reference to a missing item.
    fn check(&self) -> Result<(), String> {
        for page in &self.pages {
            let ends = if page.is_compiled() { 2 } else { 0 };
            let has_array = (FIRST_OBSERVATION + 1..=MAX_ARRAY_ELEMENTS).contains(&page.elements);
            let is_outside = |step: &StepRecord| {
                step.case >= page.cases.len() || step.place.saturating_add(2) >= page.elements.max(3)
            };
            let mut stretches = page.lines.cases.iter().flatten();
            let wrong = if page.lines.cases.len() != page.cases.len() + ends {
                "its lines are not those of its cases"
            } else if !page.is_compiled() && !has_array {
                "it has no array of results"
            } else if page.steps.iter().any(is_outside) {
                "an observation stands outside it"
            } else if page.answered.iter().any(|case| *case >= page.cases.len()) {
                "it has an answer for none of its cases"
            } else if stretches.any(|(first, last)| first > last) {
                "lines of it end before they begin"
            } else {
                continue;
            };
            return Err(format!("page {}: {wrong}", page.number));
        }
        Ok(())
    }
}

impl StepRecord {
    /// Returns the type that the observed value of a case is [encoded] as, where it is encoded.
    pub(crate) fn encoded(&self, ready: &PageCase<'_>) -> Option<ElementaryType> {
        encoded(&ready.case.observe[self.observe?].type_name)
    }
}

impl PageRecord {
    /// Returns whether the page is only compiled, and has no array.
    pub(crate) fn is_compiled(&self) -> bool {
        self.identity == 0
    }

    pub(crate) fn of(page: &PageText<'_, '_>, file: String) -> PageRecord {
        PageRecord {
            file,
            number: page.number,
            identity: page.identity,
            elements: page.elements,
            cases: page
                .cases
                .iter()
                .map(|ready| CaseRecord::of(ready.case))
                .collect(),
            steps: page.steps.clone(),
            answered: (0..page.cases.len())
                .filter(|case| page.cases[*case].answered)
                .collect(),
            lines: LinesRecord {
                units: page.lines_of_units(),
                declarations: page.declarations.matches('\n').count(),
                cases: page.lines.clone(),
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_manifests_that_point_nowhere() {
        let folder = tempfile::tempdir().expect("a folder");
        check_examples("tests/manifests.md", |example| {
            fs::write(folder.path().join(MANIFEST), example.text("manifest")).expect("written");
            match Manifest::read(folder.path()) {
                Ok(_) => "read".to_owned(),
                Err(error) => {
                    let told = error.to_string();
                    told[told.find(MANIFEST).expect("the file")..].to_owned()
                }
            }
        });
    }
}
