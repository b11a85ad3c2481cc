//! What the expansions of both kinds of table have in common.

use std::sync::Arc;

use stickler_types::DialectName;

use crate::assemble::Assembler;
use crate::assembly::Assembly;
use crate::citations::WrittenBasis;
use crate::error::Mistake;
use crate::frame::{DialectGroup, FileContext, Harvest};
use crate::table::keys::TableFile;
use crate::table::probe::Probe;
use crate::template::{BasisTemplate, Template};

/// The number of mistakes in one file after which the rest is dropped, because they have one cause.
const MAX_MISTAKES: usize = 50;

/// A table file, as the expansions of both kinds of table use it.
pub(crate) struct TableExpansion<'a> {
    pub(crate) context: &'a FileContext<'a>,
    pub(crate) file: &'a TableFile,
    /// The names of the placeholders.
    pub(crate) names: &'a [Box<str>],
    /// The dialects of the file; `None` if it does not name any.
    pub(crate) dialects: Option<Vec<DialectName>>,
    pub(crate) title: Template,
    pub(crate) basis: Option<BasisTemplate>,
}

/// Makes the cases of a table, and keeps what is wrong.
pub(super) struct CaseMaker<'a, 'h> {
    pub(super) table: &'a TableExpansion<'a>,
    pub(super) harvest: &'h mut Harvest,
    pub(super) scratch: String,
    budget: Budget,
}

impl<'a, 'h> CaseMaker<'a, 'h> {
    pub(super) fn new(table: &'a TableExpansion<'a>, harvest: &'h mut Harvest) -> CaseMaker<'a, 'h> {
        CaseMaker {
            table,
            harvest,
            scratch: String::new(),
            budget: table.context.budget,
        }
    }

    pub(super) fn wrong(&mut self, mistake: Mistake) {
        self.harvest.mistakes.push(mistake);
    }

    /// Counts the visit of a cell or a row by a probe.
    ///
    /// # Errors
    /// A mistake, if there were too many visits or mistakes.
    pub(super) fn visit(&mut self, line: u32) -> Result<(), Mistake> {
        if self.harvest.mistakes.len() > MAX_MISTAKES {
            return Err(Mistake::new(line, "further mistakes in this table are left out"));
        }
        self.budget.visit().map_err(|message| Mistake::new(line, message))
    }

    /// Returns the title of a case: that of its probe, or `own`, or that of the file.
    pub(super) fn title(&mut self, probe: &Probe<'_>, own: Option<&Template>, texts: &[&str]) -> Arc<str> {
        let title = probe.title.as_ref().or(own).unwrap_or(&self.table.title);
        title.fill(&mut self.scratch, texts)
    }

    /// Returns the basis of a case, found as its title is.
    pub(super) fn basis(
        &mut self,
        probe: &Probe<'_>,
        own: Option<&BasisTemplate>,
        texts: &[&str],
    ) -> Option<WrittenBasis> {
        let written = probe.basis.as_ref().or(own).or(self.table.basis.as_ref())?;
        Some(written.basis(&mut self.scratch, texts))
    }

    /// Returns the claims of the marks that apply and of the `targets` that are observed; `hint` says to which of the cases a mistake
    /// belongs.
    pub(super) fn assembly(
        &mut self,
        probe: &Probe<'_>,
        active: &[usize],
        (texts, line): (&[&str], u32),
        targets: impl FnOnce(&mut Assembler) -> Result<(), Mistake>,
        hint: impl FnOnce() -> String,
    ) -> Result<Assembly, Mistake> {
        let program = &probe.program;
        if let Some(slot) = program.breaks_a_mark(texts) {
            let message = format!(
                "`{{{}}}` has `(*` or `*)` in it and stands in a mark",
                self.table.names[slot]
            );
            return Err(Mistake::new(line, message).hint("write `($2A` and `*$29`"));
        }
        let mut assembler = Assembler::default();
        let applied = program.apply(active, texts, &mut assembler);
        targets(&mut assembler)?;
        let assembly = applied
            .and_then(|()| assembler.finish(probe.frame.scans, || program.fill(&mut String::new(), texts)));
        assembly.map_err(|mistake| {
            let place = program.place.line(mistake.line.max(1));
            Mistake::new(place, mistake.message)
                .key("probe.source")
                .hint(hint())
        })
    }

    /// Adds a case in each of these dialects, with the program, the question and the placement of the probe.
    ///
    /// # Errors
    /// A mistake, if the programs are too long together, or the text of the question is none.
    pub(super) fn add(
        &mut self,
        probe: &Probe<'_>,
        texts: &[&str],
        group: DialectGroup<'_>,
        dialects: &[DialectName],
    ) -> Result<(), Mistake> {
        let line = group.line;
        let source = probe.program.fill(&mut self.scratch, texts);
        let fits = self.budget.program(source.len());
        fits.map_err(|message| Mistake::new(line, message))?;
        let group = DialectGroup {
            source,
            question: probe.question(&mut self.scratch, texts, line)?,
            placement: probe.placement.as_ref(),
            ..group
        };
        self.harvest
            .add(self.table.context, &probe.frame, &group, dialects);
        Ok(())
    }
}

/// The remaining budget of a file that is being expanded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// The number of cells or rows that may still be visited.
    pub(crate) visits: u64,
    /// The number of bytes of programs that may still be written.
    pub(crate) bytes: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Budget {
            visits: 20_000_000,
            bytes: 512 << 20,
        }
    }
}

impl Budget {
    /// Counts the visit of one cell or row by one probe.
    ///
    /// # Errors
    /// A message, if the limit is exceeded.
    pub(crate) fn visit(&mut self) -> Result<(), String> {
        take(&mut self.visits, 1).ok_or_else(|| "the table expands into too many cells".to_owned())
    }

    /// Counts a program of `bytes` bytes and the case around it.
    ///
    /// # Errors
    /// A message, if the limit is exceeded.
    pub(crate) fn program(&mut self, bytes: usize) -> Result<(), String> {
        let cost = u64::try_from(bytes).unwrap_or(u64::MAX).saturating_add(400);
        take(&mut self.bytes, cost)
            .ok_or_else(|| "the table expands into more than 512 MiB of programs".to_owned())
    }
}

fn take(left: &mut u64, cost: u64) -> Option<()> {
    *left = left.checked_sub(cost)?;
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_comes_to_an_end() {
        let mut budget = Budget {
            visits: 1,
            bytes: 1000,
        };
        assert_eq!(budget.visit(), Ok(()));
        assert!(budget.visit().is_err());
        assert_eq!(budget.program(600), Ok(()));
        assert!(budget.program(0).is_err());
    }
}
