//! `stickler matrix`: which types convert implicitly, documents beside an engine.

use crate::arguments::MatrixArguments;
use crate::case_folder::{self, CaseFolder};
use crate::exit::Exit;
use crate::{engines, interrupt};
use anstyle::{AnsiColor, Style};
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_engines::{Outcome, Session};
use stickler_suite::{Case, MatrixCell, Word};
use stickler_types::{DialectName, ElementaryType};

const BOLD: Style = Style::new().bold();
const DIM: Style = Style::new().dimmed();
const YES: Style = AnsiColor::Green.on_default();
const BAD: Style = AnsiColor::Red.on_default().bold();

/// How wide a table may be.
const WIDTH: usize = 80;

/// How wide the first column is: the longest name of a type and a space.
const HEAD: usize = 8;

/// The probe whose cells the matrix is made of.
const PROBE: &str = "assignment";

/// The types that are always shown. Basis: implicit-conversion-table, its rows and columns.
const TYPES: [ElementaryType; 20] = [
    ElementaryType::Bool,
    ElementaryType::Sint,
    ElementaryType::Int,
    ElementaryType::Dint,
    ElementaryType::Lint,
    ElementaryType::Usint,
    ElementaryType::Uint,
    ElementaryType::Udint,
    ElementaryType::Ulint,
    ElementaryType::Real,
    ElementaryType::Lreal,
    ElementaryType::Byte,
    ElementaryType::Word,
    ElementaryType::Dword,
    ElementaryType::Lword,
    ElementaryType::Time,
    ElementaryType::Date,
    ElementaryType::Tod,
    ElementaryType::Dt,
    ElementaryType::String,
];

/// What the documents say of each pair, from the case files.
type Documents = BTreeMap<(ElementaryType, ElementaryType), Word>;

/// Shows one table a dialect.
///
/// # Errors
/// No folder of cases, or an engine that cannot be run.
pub fn execute(arguments: &MatrixArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let suite = CaseFolder::locate(arguments.cases.as_deref())?.load();
    interrupt::at_once()?;
    let engine = engines::by_name(&arguments.engine)?;
    let mut session = engine.session()?;
    let mut exit = case_folder::exit_of(&suite);
    if !suite.cases.iter().any(|case| case.cell.is_some()) {
        return Ok(case_folder::nothing_selected(&suite));
    }
    let asked = if arguments.dialect.is_empty() {
        &DialectName::ALL[..]
    } else {
        &arguments.dialect
    };
    let spoken = engines::spoken(engine.identity(), asked)?;
    for dialect in &spoken {
        let matrix = Matrix::new(*dialect, documents(&suite.cases, *dialect), session.as_mut());
        matrix.write(out)?;
        if matrix.differing() > 0 {
            exit = exit.worst(Exit::Failures);
        }
    }
    legend(&engine.identity().name, out)?;
    Ok(exit)
}

fn documents(cases: &[Case], dialect: DialectName) -> Documents {
    cases
        .iter()
        .filter(|case| case.dialect == dialect)
        .filter_map(|case| case.cell.as_deref())
        .filter(|cell| &*cell.probe == PROBE)
        .filter_map(|cell: &MatrixCell| {
            let pair = (
                ElementaryType::from_name(&cell.row)?,
                ElementaryType::from_name(&cell.column)?,
            );
            Some((pair, cell.word))
        })
        .collect()
}

/// One dialect: what is said and what is done.
struct Matrix {
    dialect: DialectName,
    types: Vec<ElementaryType>,
    documents: Documents,
    answers: BTreeMap<(ElementaryType, ElementaryType), Answer>,
}

/// What an engine makes of a value of one type in a variable of another. Basis: design, section 2, rule 3 (a crash is no
/// rejection).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Answer {
    Accepts,
    Rejects,
    /// It says that it cannot tell, which contradicts no document.
    Unsupported,
    /// It crashed, took too long or answered nonsense.
    Fails,
}

impl Matrix {
    fn new(dialect: DialectName, documents: Documents, session: &mut dyn Session) -> Matrix {
        let named = |ty: &ElementaryType| documents.keys().any(|(row, column)| row == ty || column == ty);
        let types: Vec<ElementaryType> = ElementaryType::ALL
            .into_iter()
            .filter(|ty| TYPES.contains(ty) || named(ty))
            .collect();
        let pairs = types
            .iter()
            .flat_map(|row| types.iter().map(|column| (*row, *column)));
        let answers = pairs.map(|pair| (pair, answer(session, dialect, pair))).collect();
        Matrix {
            dialect,
            types,
            documents,
            answers,
        }
    }

    /// Whether the engine does what the documents do not say.
    fn differs(&self, pair: (ElementaryType, ElementaryType)) -> bool {
        match (self.documents.get(&pair), self.answer(pair)) {
            (_, Answer::Unsupported) | (Some(Word::Open) | None, _) => false,
            (Some(Word::Yes | Word::Same), answer) => answer != Answer::Accepts,
            (Some(Word::No), answer) => answer != Answer::Rejects,
        }
    }

    fn answer(&self, pair: (ElementaryType, ElementaryType)) -> Answer {
        self.answers.get(&pair).copied().unwrap_or(Answer::Unsupported)
    }

    fn differing(&self) -> usize {
        self.documents.keys().filter(|pair| self.differs(**pair)).count()
    }

    fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let (said, differing) = (self.documents.len(), self.differing());
        writeln!(
            out,
            "{BOLD}{}{BOLD:#}  the documents speak of {said} pairs, {differing} differ",
            self.dialect
        )?;
        for columns in self.blocks() {
            write!(out, "{:HEAD$}", "")?;
            columns
                .iter()
                .try_for_each(|column| write!(out, " {BOLD}{:>1$}{BOLD:#}", column.name(), width(*column)))?;
            writeln!(out)?;
            for row in &self.types {
                write!(out, "{BOLD}{:<HEAD$}{BOLD:#}", row.name())?;
                columns
                    .iter()
                    .try_for_each(|column| self.write_cell((*row, *column), out))?;
                writeln!(out)?;
            }
            writeln!(out)?;
        }
        Ok(())
    }

    /// The columns, in pieces that fit the width.
    fn blocks(&self) -> Vec<&[ElementaryType]> {
        let mut blocks = Vec::new();
        let (mut start, mut used) = (0, HEAD);
        for (index, column) in self.types.iter().enumerate() {
            let needed = 1 + width(*column);
            if used + needed > WIDTH {
                blocks.push(&self.types[start..index]);
                (start, used) = (index, HEAD);
            }
            used += needed;
        }
        blocks.push(&self.types[start..]);
        blocks
    }

    fn write_cell(&self, pair: (ElementaryType, ElementaryType), out: &mut dyn Write) -> io::Result<()> {
        let answer = self.answer(pair);
        let said = match self.documents.get(&pair) {
            Some(Word::Yes) => 'y',
            Some(Word::Same) => '=',
            Some(Word::No) => 'n',
            Some(Word::Open) => '?',
            None => ' ',
        };
        let done = match answer {
            Answer::Accepts => '+',
            Answer::Rejects => '-',
            Answer::Unsupported => '?',
            Answer::Fails => 'x',
        };
        let differs = self.differs(pair);
        let mark = if differs { '!' } else { ' ' };
        let style = match (differs, answer) {
            (true, _) | (_, Answer::Fails) => BAD,
            (false, Answer::Accepts) => YES,
            (false, Answer::Rejects | Answer::Unsupported) => DIM,
        };
        // At the right, so that no line ends in blanks.
        let padding = width(pair.1) - 3;
        write!(out, " {:padding$}{style}{mark}{said}{done}{style:#}", "")
    }
}

fn width(column: ElementaryType) -> usize {
    column.name().len().max(3)
}

/// Whether the engine takes a value of one type for a variable of the other.
fn answer(session: &mut dyn Session, dialect: DialectName, pair: (ElementaryType, ElementaryType)) -> Answer {
    let (from, into) = (pair.0.name(), pair.1.name());
    let source = format!(
        "PROGRAM main\nVAR\n    from : {from};\n    into : {into};\nEND_VAR\n    into := from;\nEND_PROGRAM\n"
    );
    match session.check(dialect, &source) {
        Outcome::Accepted => Answer::Accepts,
        Outcome::Rejected { .. } => Answer::Rejects,
        Outcome::Unsupported { .. } => Answer::Unsupported,
        Outcome::Executed { .. } | Outcome::Faulted { .. } | Outcome::Rendered { .. } => Answer::Fails,
        Outcome::Crashed { .. } | Outcome::TimedOut { .. } | Outcome::Error { .. } => Answer::Fails,
    }
}

fn legend(engine: &str, out: &mut dyn Write) -> io::Result<()> {
    writeln!(
        out,
        "A row is the value's type, a column the target's. In a cell, first the documents:"
    )?;
    writeln!(
        out,
        "y yes, n no, = same type, ? open, blank not said; then the engine ({engine}):"
    )?;
    writeln!(
        out,
        "+ accepts, - rejects, ? cannot tell, x fails. ! stands where they differ."
    )
}

#[cfg(test)]
mod tests {
    use super::{Answer, Documents, Matrix};
    use stickler_engines::{Outcome, RunRequest, Session};
    use stickler_suite::Word;
    use stickler_types::{DialectName, ElementaryType};

    /// Answers every check alike.
    struct Always(Outcome);

    impl Session for Always {
        fn run(&mut self, _: &RunRequest<'_>) -> Outcome {
            self.0.clone()
        }

        fn check(&mut self, _: DialectName, _: &str) -> Outcome {
            self.0.clone()
        }

        fn render(&mut self, _: DialectName, _: &str) -> Outcome {
            self.0.clone()
        }
    }

    /// What an outcome is shown as, and whether it differs from a document that says yes, and from one that says no.
    fn judged(outcome: Outcome) -> (Answer, bool, bool) {
        let widening = (ElementaryType::Sint, ElementaryType::Int);
        let narrowing = (ElementaryType::Int, ElementaryType::Sint);
        let documents = Documents::from([(widening, Word::Yes), (narrowing, Word::No)]);
        let matrix = Matrix::new(DialectName::Matiec, documents, &mut Always(outcome));
        (
            matrix.answer(widening),
            matrix.differs(widening),
            matrix.differs(narrowing),
        )
    }

    #[test]
    fn a_crash_is_no_rejection_and_what_is_unsupported_contradicts_nothing() {
        let reason = String::new;
        assert_eq!(judged(Outcome::Accepted), (Answer::Accepts, false, true));
        let diagnostics = Vec::new();
        assert_eq!(
            judged(Outcome::Rejected { diagnostics }),
            (Answer::Rejects, true, false)
        );
        let unsupported = Outcome::Unsupported { reason: reason() };
        assert_eq!(judged(unsupported), (Answer::Unsupported, false, false));
        let crashed = Outcome::Crashed { reason: reason() };
        assert_eq!(judged(crashed), (Answer::Fails, true, true));
        assert_eq!(
            judged(Outcome::TimedOut { after_ms: 1 }),
            (Answer::Fails, true, true)
        );
    }
}
