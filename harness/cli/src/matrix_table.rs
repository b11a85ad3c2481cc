//! Writes the matrix of one dialect as a table: the words of the documents, and the answers of engines.

use crate::output::{BAD, BOLD, DIM};
use anstyle::{AnsiColor, Style};
use std::collections::BTreeMap;
use std::io::{self, Write};
use std::sync::Arc;
use stickler_conversions::implicit::MatrixAnswer;
use stickler_conversions::recording::{Recording, pairs};
use stickler_conversions::table::{Alignment, Cell, Table};
use stickler_types::{DialectName, ElementaryType, MatrixWord, TypePair, join, wrap_within};

const YES: Style = AnsiColor::Green.on_default();

/// The maximum width of a table, in characters.
const WIDTH: usize = 80;

/// The word of the documents for each pair, and the source and section from which it comes; from the case files.
pub type Documents = BTreeMap<TypePair, (MatrixWord, Arc<str>)>;

/// The maximum number of recorded contradictions that are described below a table.
const MAX_DESCRIBED: usize = 4;

/// The matrix of one dialect: the words of the documents, and the answers of engines.
pub struct DialectMatrix {
    /// The dialect.
    pub dialect: DialectName,
    /// The types of the rows and columns.
    pub types: Vec<ElementaryType>,
    /// The words of the documents.
    pub documents: Documents,
    /// The answers of each engine that speaks the dialect, in the order of the engines.
    pub engines: Vec<EngineAnswers>,
}

/// The answers of one engine.
pub struct EngineAnswers {
    /// The name of the engine.
    pub engine: String,
    /// The day on which the answers were recorded; then nothing that is here contradicts the documents.
    pub recorded: Option<String>,
    /// The answer for each pair.
    pub answers: BTreeMap<TypePair, MatrixAnswer>,
}

impl EngineAnswers {
    fn answer(&self, pair: TypePair) -> MatrixAnswer {
        self.answers
            .get(&pair)
            .copied()
            .unwrap_or(MatrixAnswer::Unsupported)
    }

    /// Returns whether the engine contradicts the documents for a pair of types.
    fn differs(&self, documents: &Documents, pair: TypePair) -> bool {
        let word = documents.get(&pair).map(|(word, _)| *word);
        self.answer(pair).contradicts(word)
    }

    fn differing(&self, documents: &Documents) -> usize {
        documents
            .keys()
            .filter(|pair| self.differs(documents, **pair))
            .count()
    }
}

impl DialectMatrix {
    /// Returns whether any engine that was asked contradicts the documents for any pair of types.
    pub fn differs(&self) -> bool {
        let mut asked = self.engines.iter().filter(|engine| engine.recorded.is_none());
        asked.any(|engine| engine.differing(&self.documents) > 0)
    }

    /// Adds the answers of recordings for the types of the table.
    pub fn add_recorded(&mut self, recordings: &[&Recording]) {
        for recording in recordings {
            let answer = |pair| Some((pair, recording.implicit(self.dialect, pair)?));
            let answers = pairs(&self.types).into_iter().filter_map(answer).collect();
            let engine = recording.identity().name;
            self.engines.push(EngineAnswers {
                engine,
                recorded: Some(recording.origin.date.clone()),
                answers,
            });
        }
    }

    /// Writes the table, in pieces that fit the terminal.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        self.write_heading(out)?;
        let heads = self.types.iter().map(|ty| Cell::plain(ty.name()));
        // The first column has room for the longest name of a type and a space.
        let first = Cell::left(format_args!("{:8}", ""));
        let mut table = Table::of_values(vec![[first].into_iter().chain(heads).collect()], 1, 1);
        for row in &self.types {
            let name = vec![(row.name().to_owned(), BOLD)];
            let cells = self.types.iter().map(|column| self.cell((*row, *column)));
            table.row(
                [Cell::new(name, Alignment::Left)]
                    .into_iter()
                    .chain(cells)
                    .collect(),
            );
        }
        table.write(out, Some(WIDTH))?;
        writeln!(out)?;
        self.write_disputed(out)
    }

    /// Writes a sentence for each pair of which a document and a recording of the same system say different things, up to
    /// [`MAX_DESCRIBED`].
    fn write_disputed(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut disputed = Vec::new();
        for engine in &self.engines {
            let Some(date) = &engine.recorded else { continue };
            for ((from, to), (word, basis)) in &self.documents {
                let pair = (*from, *to);
                if engine.differs(&self.documents, pair) {
                    let does = match engine.answer(pair) {
                        MatrixAnswer::Accepts => "accepts",
                        MatrixAnswer::Warns => "warns of",
                        MatrixAnswer::Rejects => "rejects",
                        MatrixAnswer::Unsupported => "does not support",
                        MatrixAnswer::Fails => "fails at",
                    };
                    disputed.push(format!(
                        "{from} to {to}: {} by {basis}, but {} {does} it (recorded {date})",
                        word.as_str(),
                        engine.engine,
                    ));
                }
            }
        }
        for sentence in disputed.iter().take(MAX_DESCRIBED) {
            writeln!(out, "{}", wrap_within(sentence, WIDTH))?;
        }
        match disputed.len().saturating_sub(MAX_DESCRIBED) {
            0 if disputed.is_empty() => Ok(()),
            0 => writeln!(out),
            more => writeln!(out, "... and {more} more\n"),
        }
    }

    fn write_heading(&self, out: &mut dyn Write) -> io::Result<()> {
        write!(
            out,
            "{BOLD}{}{BOLD:#}  the documents speak of {} pairs",
            self.dialect,
            self.documents.len()
        )?;
        match &self.engines[..] {
            [engine] => writeln!(out, ", {} differ", engine.differing(&self.documents)),
            engines => {
                let count = |column: &EngineAnswers| {
                    let differing = column.differing(&self.documents);
                    format!("{differing} differ on {}", column.engine)
                };
                writeln!(out, ": {}", join(engines.iter().map(count), ", "))
            }
        }
    }

    /// Returns a cell: a mark where an engine differs, the word of the documents, and a sign for each engine.
    fn cell(&self, pair: TypePair) -> Cell {
        let said = match self.documents.get(&pair).map(|(word, _)| word) {
            Some(MatrixWord::Yes) => 'y',
            Some(MatrixWord::Same) => '=',
            Some(MatrixWord::Warn) => 'w',
            Some(MatrixWord::No) => 'n',
            Some(MatrixWord::Open) => '?',
            None => ' ',
        };
        let differs = |engine: &EngineAnswers| engine.differs(&self.documents, pair);
        let mark = if self.engines.iter().any(differs) {
            '!'
        } else {
            ' '
        };
        let mut pieces = vec![(mark.to_string(), BAD), (said.to_string(), Style::new())];
        for engine in &self.engines {
            let answer = engine.answer(pair);
            let style = match (differs(engine), answer) {
                (true, _) | (_, MatrixAnswer::Fails) => BAD,
                (false, MatrixAnswer::Accepts | MatrixAnswer::Warns) => YES,
                (false, MatrixAnswer::Rejects | MatrixAnswer::Unsupported) => DIM,
            };
            pieces.push((sign(answer).to_string(), style));
        }
        Cell::new(pieces, Alignment::Right)
    }
}

fn sign(answer: MatrixAnswer) -> char {
    match answer {
        MatrixAnswer::Accepts => '+',
        MatrixAnswer::Warns => 'w',
        MatrixAnswer::Rejects => '-',
        MatrixAnswer::Unsupported => '?',
        MatrixAnswer::Fails => 'x',
    }
}

#[cfg(test)]
mod tests {
    use super::{Documents, EngineAnswers};
    use stickler_conversions::implicit::MatrixAnswer;
    use stickler_types::{ElementaryType, MatrixWord};

    const WIDENING: (ElementaryType, ElementaryType) = (ElementaryType::Sint, ElementaryType::Int);
    const SIGN: (ElementaryType, ElementaryType) = (ElementaryType::Sint, ElementaryType::Uint);
    const NARROWING: (ElementaryType, ElementaryType) = (ElementaryType::Int, ElementaryType::Sint);

    fn documents() -> Documents {
        let words = [
            (WIDENING, MatrixWord::Yes),
            (SIGN, MatrixWord::Warn),
            (NARROWING, MatrixWord::No),
        ];
        words
            .map(|(pair, word)| (pair, (word, "here: there".into())))
            .into()
    }

    fn always(engine: &str, answer: MatrixAnswer) -> EngineAnswers {
        EngineAnswers {
            engine: engine.to_owned(),
            recorded: None,
            answers: [WIDENING, SIGN, NARROWING].map(|pair| (pair, answer)).into(),
        }
    }

    #[test]
    fn what_is_unsupported_contradicts_nothing_and_a_crash_both_answers() {
        for (answer, widening, sign, narrowing) in [
            (MatrixAnswer::Accepts, false, true, true),
            (MatrixAnswer::Warns, false, false, true),
            (MatrixAnswer::Rejects, true, true, false),
            (MatrixAnswer::Unsupported, false, false, false),
            (MatrixAnswer::Fails, true, true, true),
        ] {
            let column = always("e", answer);
            let differs = |pair| column.differs(&documents(), pair);
            assert_eq!(
                (differs(WIDENING), differs(SIGN), differs(NARROWING)),
                (widening, sign, narrowing),
                "{answer:?}"
            );
        }
    }
}
