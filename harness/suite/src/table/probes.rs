//! The probes of a table, whose programs are written out, or composed for each combination of places that a cell or row takes.
//!
//! Basis: conformance-cases/README.md (tables, places).

use rustc_hash::FxHashSet;
use stickler_types::DialectName;

use crate::condition::Testable;
use crate::error::Mistake;
use crate::frame::{FileContext, Harvest};
use crate::places::Places;
use crate::table::arranged::{self, Arranged};
use crate::table::keys::{KeyReader, ProbeKey, TableFile};
use crate::table::probe::Probe;

/// A probe of a table with its programs: the one that is written out, or one for each combination of places.
#[derive(Debug)]
pub(crate) struct ProbePrograms<'a> {
    /// The probe with the program that is written out, or with that of the first combination of places.
    pub(crate) probe: Probe<'a>,
    /// The probes of the single combinations of places; `None` if the program is written out.
    arranged: Option<Arranged<'a>>,
}

impl<'a> ProbePrograms<'a> {
    /// Returns the programs that a cell or a row takes, each with its dialects: indices for [`ProbePrograms::at`]. `number` tells
    /// the cell from others, and `texts` are those of its placeholders.
    pub(crate) fn chosen(
        &self,
        places: &Places,
        number: usize,
        dialects: Vec<DialectName>,
        texts: &[&str],
    ) -> Vec<(usize, Vec<DialectName>)> {
        match &self.arranged {
            None => vec![(0, dialects)],
            Some(arranged) => {
                let chosen = arranged.chosen(places, number, &dialects, texts);
                chosen.into_iter().collect()
            }
        }
    }

    /// Returns the probe with a program of those that [`ProbePrograms::chosen`] returns, or nothing if this has a mistake.
    pub(crate) fn at(
        &mut self,
        index: usize,
        context: &FileContext<'_>,
        harvest: &mut Harvest,
    ) -> Option<&mut Probe<'a>> {
        match &mut self.arranged {
            None => Some(&mut self.probe),
            Some(arranged) => arranged.probe(&self.probe, index, context, harvest),
        }
    }

    /// Adds a warning if the probe has no case, and one for each mark that applied in no case.
    pub(crate) fn remarks(&self, cases: usize, remarks: &mut Vec<Mistake>) {
        let probe = &self.probe;
        if cases == 0 {
            let message = format!("the probe `{}` has no case", probe.name);
            remarks.push(Mistake::new(probe.line, message).key("probe"));
        } else if self.arranged.as_ref().is_none_or(Arranged::is_idle) {
            probe.note_idle_marks(remarks);
        }
    }

    /// Returns whether any part of the probe uses a placeholder.
    pub(crate) fn mentions(&self, slot: usize) -> bool {
        let arranged = self.arranged.as_ref();
        self.probe.mentions(slot) || arranged.is_some_and(|arranged| arranged.mentions(slot))
    }
}

/// Reads the probes of a file; leaves out those with mistakes.
pub(crate) fn read<'a>(
    file: &'a TableFile,
    context: &FileContext<'_>,
    testable: Testable<'a>,
    harvest: &mut Harvest,
) -> Vec<ProbePrograms<'a>> {
    if file.probe.is_empty() {
        let mistake = Mistake::new(1, "the table has no [[probe]]");
        harvest.mistakes.push(mistake.key("probe"));
    }
    let mut probes: Vec<ProbePrograms<'a>> = Vec::new();
    let mut names = FxHashSet::default();
    for key in &file.probe {
        let mut reader = KeyReader::new(context, testable);
        let read = one(&mut reader, file, key.get_ref());
        if let Some(read) = read.filter(|_| reader.mistakes.is_empty()) {
            if !names.insert(read.probe.name.clone()) {
                let message = format!("there are two probes `{}`", read.probe.name);
                let mistake = Mistake::new(read.probe.line, message).key("probe.name");
                reader.mistakes.push(mistake);
            } else {
                probes.push(read);
            }
        }
        harvest.mistakes.append(&mut reader.mistakes);
        harvest.remarks.append(&mut reader.remarks);
    }
    probes
}

fn one<'a>(
    reader: &mut KeyReader<'a, '_>,
    file: &'a TableFile,
    key: &'a ProbeKey,
) -> Option<ProbePrograms<'a>> {
    match (&key.source, &key.places) {
        (Some(source), None) => {
            let probe = reader.written_out(file, key, source)?;
            Some(ProbePrograms {
                probe,
                arranged: None,
            })
        }
        (None, Some(places)) => {
            let (probe, arranged) = arranged::read(reader, file, key, places)?;
            let arranged = Some(arranged);
            Some(ProbePrograms { probe, arranged })
        }
        _ => {
            let message = "a probe has either `source` or `places`";
            reader.wrong(&key.name, "probe", message);
            None
        }
    }
}
