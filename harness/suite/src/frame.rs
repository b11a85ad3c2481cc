//! The properties that all cases of a file or a probe share, and the making of cases from them.

use std::cell::RefCell;
use std::sync::Arc;

use rustc_hash::FxHashSet;
use stickler_types::{DialectName, Question, sorted};
use toml::Spanned;

use crate::assembly::Assembly;
use crate::citations::{Citations, WrittenBasis};
use crate::dialects::Dialects;
use crate::error::Mistake;
use crate::features::Features;
use crate::model::{Case, MatrixCell};
use crate::place::Lines;
use crate::places::{Placement, Places};
use crate::sources::Sources;
use crate::table::Budget;
use crate::timing::MAX_SCANS;
use crate::toml_text::Scalar;

/// A case file that is being expanded, with its text and the dialects of the suite.
#[derive(Debug)]
pub(crate) struct FileContext<'a> {
    /// The path relative to the suite's parent, as reports show it.
    pub(crate) file: Arc<str>,
    /// The id of the file: its path below the root, without the extension.
    pub(crate) id: String,
    pub(crate) area: Arc<str>,
    pub(crate) text: &'a str,
    pub(crate) lines: Lines,
    pub(crate) dialects: &'a Dialects,
    /// The features of the language, and the dialects that lack them.
    pub(crate) features: &'a Features,
    /// The dialects that the file names otherwise than by `all`.
    pub(crate) named: RefCell<FxHashSet<DialectName>>,
    /// The sources that cases may cite; `None` where they are not known.
    pub(crate) sources: Option<&'a Sources>,
    /// The places that probes may name.
    pub(crate) places: &'a Places,
    /// The limits on the expansion of the file.
    pub(crate) budget: Budget,
}

/// The properties that all cases of a probe share.
#[derive(Clone, Debug)]
pub(crate) struct ProbeFrame {
    pub(crate) summary: Option<Arc<str>>,
    pub(crate) tags: Arc<[Arc<str>]>,
    /// The number of scans; `None` where the marks tell it.
    pub(crate) scans: Option<u32>,
}

/// The properties of a group of cases that differ only in their dialect.
#[derive(Debug, Default)]
pub(crate) struct DialectGroup<'a> {
    pub(crate) id: Arc<str>,
    pub(crate) title: Arc<str>,
    /// The basis that the file writes for the cases, if it writes one.
    pub(crate) basis: Option<WrittenBasis>,
    pub(crate) line: u32,
    pub(crate) source: Arc<str>,
    pub(crate) assembly: Assembly,
    pub(crate) question: Option<Arc<Question>>,
    pub(crate) cell: Option<&'a Arc<MatrixCell>>,
    pub(crate) placement: Option<&'a Arc<Placement>>,
}

/// The cases, mistakes and remarks that reading a case file results in.
#[derive(Debug, Default)]
pub(crate) struct Harvest {
    pub(crate) cases: Vec<Case>,
    pub(crate) mistakes: Vec<Mistake>,
    /// The warnings of lint about the file, beside its mistakes.
    pub(crate) remarks: Vec<Mistake>,
    /// The bases that the cases cite.
    pub(crate) citations: Citations,
}

impl Harvest {
    /// Adds a warning of lint, unless it equals the last one or the limit is reached.
    pub(crate) fn remark(&mut self, remark: Mistake) {
        const MAX_REMARKS: usize = 200;
        if self.remarks.last() != Some(&remark) && self.remarks.len() < MAX_REMARKS {
            self.remarks.push(remark);
        }
    }

    /// Adds a case for each of the dialects, but for those that the file names as `all` only and that lack a feature of the program. A case that asserts something without a basis is a mistake and left out.
    pub(crate) fn add(
        &mut self,
        context: &FileContext<'_>,
        frame: &ProbeFrame,
        group: &DialectGroup<'_>,
        dialects: &[DialectName],
    ) {
        let open = group.assembly.expectation.is_open(&group.assembly.observe);
        let written = group.basis.as_ref();
        for &dialect in &context.having(dialects, &group.source) {
            let basis = match open {
                true => Some(self.citations.none(written)),
                false => {
                    let is_named = context.named.borrow().contains(&dialect);
                    self.citations.cite(written, (dialect, is_named), context.sources)
                }
            };
            let Some(basis) = basis else { continue };
            let case = Case {
                id: Arc::clone(&group.id),
                dialect,
                title: Arc::clone(&group.title),
                basis,
                summary: frame.summary.clone(),
                file: Arc::clone(&context.file),
                area: Arc::clone(&context.area),
                line: group.line,
                source: Arc::clone(&group.source),
                scans: group.assembly.scans,
                tags: Arc::clone(&frame.tags),
                clock: Arc::clone(&group.assembly.clock),
                set: Arc::clone(&group.assembly.set),
                expectation: Arc::clone(&group.assembly.expectation),
                observe: Arc::clone(&group.assembly.observe),
                question: group.question.clone(),
                cell: group.cell.map(Arc::clone),
                placement: group.placement.map(Arc::clone),
            };
            self.cases.push(case);
        }
    }
}

impl FileContext<'_> {
    /// Returns a cell as programs spell it.
    pub(crate) fn spelling(&self, cell: &Spanned<Scalar>) -> Box<str> {
        cell.get_ref()
            .spelling(self.text.get(cell.span()).unwrap_or_default())
    }

    /// Returns the dialects that a list of names stands for, in their own order, each once.
    pub(crate) fn resolve(
        &self,
        names: &[Spanned<String>],
        key: &str,
        mistakes: &mut Vec<Mistake>,
    ) -> Vec<DialectName> {
        let mut dialects = Vec::new();
        for name in names {
            match self.dialects.resolve(name.get_ref()) {
                Ok(resolved) => {
                    if !Dialects::is_all(name.get_ref()) {
                        self.named.borrow_mut().extend(&resolved);
                    }
                    dialects.extend(resolved);
                }
                Err(message) => mistakes.push(self.lines.mistake(name, key, message)),
            }
        }
        sorted(dialects)
    }

    /// Returns those of the dialects that a program can be asked in: the file names them, or they have all features of the program.
    fn having(&self, dialects: &[DialectName], source: &str) -> Vec<DialectName> {
        let asked = dialects
            .iter()
            .copied()
            .filter(|&dialect| self.dialects.asks(dialect));
        let mut having: Vec<DialectName> = asked.collect();
        let named = self.named.borrow();
        if !having.iter().all(|dialect| named.contains(dialect)) {
            let lacking = self.features.lacking(source);
            having.retain(|dialect| named.contains(dialect) || !lacking.contains(dialect));
        }
        having
    }
}

/// Checks the key `scans` and returns its value, if it is there and right.
pub(crate) fn scans(scans: Option<&Spanned<u32>>, lines: &Lines, mistakes: &mut Vec<Mistake>) -> Option<u32> {
    let scans = scans?;
    match *scans.get_ref() {
        number @ 1..=MAX_SCANS => Some(number),
        number => {
            let message = format!("{number} scans; a program runs from 1 to {MAX_SCANS}");
            mistakes.push(lines.mistake(scans, "scans", message));
            None
        }
    }
}
