//! Several programs in one text, for engines whose every start costs time.
//!
//! Their types, functions and blocks stand side by side, and their main programs one behind the other in one, every name kept
//! apart by a prefix. A pack that an engine agrees with acquits all its programs; one that it does not is halved until
//! the culprits stand alone, so packing changes no verdict.
//!
//! Basis: harness/engines/README.md (packs).

use super::comparison::JudgedProgram;
use super::evaluated::EvaluatedProgram;
use super::renumber::Shift;
use stickler_generate::model::visit::bodies;
use stickler_generate::model::visit_mut::walk_program;
use stickler_generate::model::{DeclaredKind, MainPou, Program, Statement, StatementKind};
use stickler_generate::writer::{Style, write};
use stickler_types::{DialectName, Value};

/// Several programs as one.
pub(super) struct Pack {
    dialect: DialectName,
    text: String,
    values: Vec<(String, Value)>,
}

impl Pack {
    /// Packs programs of one dialect; `None` where there are none.
    pub(super) fn of(subjects: &[&EvaluatedProgram]) -> Option<Pack> {
        let dialect = subjects.first()?.program.dialect;
        let mut all = Program {
            dialect,
            types: Vec::new(),
            functions: Vec::new(),
            blocks: Vec::new(),
            main: MainPou {
                variables: Vec::new(),
                body: Vec::new(),
            },
        };
        let mut values = Vec::new();
        for (index, subject) in subjects.iter().enumerate() {
            let prefix = format!("p{index}_");
            append(&mut all, subject.program.clone(), &prefix);
            // A path begins with the name of a variable of main.
            values.extend(
                subject
                    .values
                    .iter()
                    .map(|(name, value)| (format!("{prefix}{name}"), value.clone())),
            );
        }
        Some(Pack {
            dialect,
            text: write(&all, &Style::default()).text,
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
    subject.opened.is_empty() && !returns(&subject.program.main.body)
}

/// Adds a program behind those that are there.
fn append(all: &mut Program, mut program: Program, prefix: &str) {
    let mut shift = Shift::behind(all);
    walk_program(&mut shift, &mut program);
    let rename = |name: &mut String| name.insert_str(0, prefix);
    for declaration in &mut program.types {
        rename(&mut declaration.name);
        if let DeclaredKind::Enumeration(names) = &mut declaration.kind {
            names.iter_mut().for_each(rename);
        }
    }
    program
        .functions
        .iter_mut()
        .for_each(|function| rename(&mut function.name));
    program
        .blocks
        .iter_mut()
        .for_each(|block| rename(&mut block.name));
    program
        .main
        .variables
        .iter_mut()
        .for_each(|variable| rename(&mut variable.name));
    all.types.append(&mut program.types);
    all.functions.append(&mut program.functions);
    all.blocks.append(&mut program.blocks);
    all.main.variables.append(&mut program.main.variables);
    all.main.body.append(&mut program.main.body);
}

fn returns(statements: &[Statement]) -> bool {
    statements.iter().any(|statement| {
        matches!(statement.kind, StatementKind::Return | StatementKind::Raw(_))
            || bodies(statement).into_iter().any(|body| returns(body))
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::differential::{Agreement, ask, compare};
    use crate::inputs::Inputs;
    use stickler_engines::{EngineSession, Reference};
    use stickler_generate::generator::DIALECTS;

    fn subjects(dialect: DialectName) -> Vec<EvaluatedProgram> {
        let programs = (0..60).map(|place| Inputs::new(5).program(place, &[dialect], false));
        let subjects = programs.filter_map(|program| EvaluatedProgram::new(program).ok());
        subjects.filter(packs).collect()
    }

    #[test]
    fn a_pack_gives_what_its_programs_give_alone() {
        let reference = Reference::default();
        let mut session = EngineSession::new(&reference);
        for &dialect in DIALECTS.iter() {
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
