//! Several programs in one text, for engines whose every start costs time.
//!
//! Their types, functions and blocks stand side by side, and their main programs one behind the other in one, every name kept
//! apart by a suffix. A pack that an engine agrees with acquits all its programs; the programs of one that it does not are asked
//! about alone, so packing changes no verdict.
//!
//! Basis: harness/engines/README.md (packs).

use super::comparison::JudgedProgram;
use super::evaluated::EvaluatedProgram;
use std::fmt::Write;
use std::time::Duration;
use stickler_syntax::{ProgramParts, Renaming};
use stickler_types::{Dialect, DialectName, Value};

/// The time for one program from which on an engine is slow: it spends its time starting, for a program of a campaign is done
/// in microseconds.
const SLOW_PROGRAM: Duration = Duration::from_millis(20);

/// Returns whether an engine is slow, by the time of the quickest program that it took alone; nothing is known of one that took none.
pub(super) fn is_slow(quickest: Option<Duration>) -> bool {
    quickest.is_some_and(|quickest| quickest >= SLOW_PROGRAM)
}

/// The number of programs in one pack at most.
pub(super) const MAX_PACK_LEN: usize = 16;

/// Whether an engine is given several programs at a time. It changes how long a campaign takes, not what it finds.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub enum PackPolicy {
    /// Packs programs where no program alone was quick.
    #[default]
    WhereSlow,
    /// Never packs programs.
    Never,
    /// Packs programs from the first one on.
    Always,
}

/// Several programs as one.
pub(super) struct Pack {
    dialect: DialectName,
    text: String,
    values: Vec<(String, Value)>,
}

impl Pack {
    /// Packs programs of one dialect that [can stand among others](packs); `None` where there are none.
    pub(super) fn of(subjects: &[&EvaluatedProgram]) -> Option<Pack> {
        let name = subjects.first()?.program.dialect;
        let dialect = Dialect::of(name);
        let [mut units, mut sections, mut statements] = [const { String::new() }; 3];
        let mut values = Vec::new();
        for (index, subject) in subjects.iter().enumerate() {
            let parts = ProgramParts::of(&subject.text, dialect).ok()?;
            let suffix = format!("_p{index}");
            let mut renaming = Renaming {
                dialect,
                units: (&parts.unit_names, suffix.clone()),
                variables: None,
            };
            // Writing into a String does not fail.
            let _ = writeln!(units, "{}", renaming.of(&parts.units));
            renaming.variables = Some((&parts.variable_names, suffix));
            for section in &parts.variables {
                let constant = if section.constant { " CONSTANT" } else { "" };
                let _ = writeln!(sections, "VAR{constant}\n{}\nEND_VAR", renaming.of(&section.text));
            }
            let _ = writeln!(statements, "{}", renaming.of(&parts.statements));
            let own = subject.values.iter();
            values.extend(own.map(|(name, value)| (renaming.of(name), value.clone())));
        }
        Some(Pack {
            dialect: name,
            text: format!("{units}PROGRAM main\n{sections}{statements}END_PROGRAM\n"),
            values,
        })
    }

    /// Returns the question that an engine is asked about the pack.
    pub(super) fn question(&self) -> JudgedProgram<'_> {
        JudgedProgram {
            dialect: self.dialect,
            text: &self.text,
            values: &self.values,
            binds: true,
        }
    }
}

/// Returns whether a program can stand among others: nothing in it is open, and its main program runs to its end.
pub(super) fn packs(subject: &EvaluatedProgram) -> bool {
    let parts = || ProgramParts::of(&subject.text, Dialect::of(subject.program.dialect));
    subject.opened.is_empty() && parts().is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differential::{Agreement, ask, compare};
    use crate::inputs::Inputs;
    use stickler_engines::{EngineSession, Reference};

    fn subjects(dialect: DialectName) -> Vec<EvaluatedProgram> {
        let programs = (0..60).map(|place| Inputs::new(5).program(place, &[dialect], false));
        let subjects = programs.filter_map(|program| EvaluatedProgram::new(program).ok());
        subjects.filter(packs).collect()
    }

    #[test]
    fn an_engine_is_slow_where_no_program_alone_was_quick() {
        let slow = [None, Some(19), Some(20)].map(|quickest| is_slow(quickest.map(Duration::from_millis)));
        assert_eq!(slow, [false, false, true]);
    }

    #[test]
    fn a_pack_gives_what_its_programs_give_alone() {
        let reference = Reference::default();
        let mut session = EngineSession::new(&reference);
        for &dialect in DialectName::ALL.iter() {
            let subjects = subjects(dialect);
            assert!(subjects.len() > 30, "{} of {dialect}", subjects.len());
            for chunk in subjects.chunks(8) {
                let pack = Pack::of(&chunk.iter().collect::<Vec<_>>()).unwrap();
                let agreement = compare(pack.question(), &ask(&mut session, pack.question()));
                assert_eq!(agreement, Agreement::Agrees, "{}", pack.text);
            }
        }
    }

    #[test]
    fn there_is_no_pack_of_nothing() {
        assert!(Pack::of(&[]).is_none());
    }
}
