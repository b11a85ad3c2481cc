//! Writes a recording as a file: the origin, and a section of answers for each group of dialects in which they are equal.

use super::{FunctionAnswers, RecordedSection, Recording};
use crate::implicit::MatrixAnswer;
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_types::{DialectName, ElementaryType};
use toml::Value as Toml;

/// A section: the dialects of its answers, and the text of each row by the kind and key of the row.
type WrittenSections<'r> = BTreeMap<Vec<&'r str>, BTreeMap<(&'static str, String), String>>;

/// A row: its kind, its key, and its text.
type WrittenRow = (&'static str, String, String);

impl Recording {
    /// Writes the file that [`Recording::parse`] reads.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let origin = &self.origin;
        writeln!(out, "# Written by Stickler.\n\n[recording]")?;
        for (name, text) in [
            ("product", Some(&origin.product)),
            ("version", Some(&origin.version)),
            ("commit", origin.commit.as_ref()),
            ("platform", Some(&origin.platform)),
            ("date", Some(&origin.date)),
        ] {
            if let Some(text) = text {
                writeln!(out, "{name} = {}", quoted(text))?;
            }
        }
        for (dialects, rows) in self.sections() {
            let names: Vec<String> = dialects.into_iter().map(quoted).collect();
            writeln!(out, "\n[[answers]]\ndialects = [{}]", names.join(", "))?;
            for kind in RecordedSection::ALL.map(RecordedSection::as_str) {
                let mut rows = rows.iter().filter(|((of, _), _)| *of == kind).peekable();
                if rows.peek().is_some() {
                    writeln!(out, "\n[answers.{kind}]")?;
                }
                rows.try_for_each(|((_, key), row)| writeln!(out, "{} = {row}", quoted(key)))?;
            }
        }
        Ok(())
    }

    fn sections(&self) -> WrittenSections<'_> {
        // The dialects of each row with the same text.
        let mut equal: BTreeMap<(&str, String, String), Vec<&str>> = BTreeMap::new();
        for dialect in &self.dialects {
            let rows = self
                .implicit_rows(*dialect)
                .chain(self.part_rows(*dialect))
                .chain(self.comparison_rows(*dialect))
                .chain(self.function_rows(*dialect));
            for row in rows {
                equal.entry(row).or_default().push(dialect.as_str());
            }
        }
        let mut sections = WrittenSections::new();
        for ((kind, key, row), dialects) in equal {
            sections.entry(dialects).or_default().insert((kind, key), row);
        }
        sections
    }

    fn implicit_rows(&self, dialect: DialectName) -> impl Iterator<Item = WrittenRow> {
        let answers = move |from| {
            let answer = move |into: ElementaryType| {
                let answer = self.implicit(dialect, (from, into))?;
                Some((answer.as_str(), into.name().to_owned()))
            };
            ElementaryType::ALL.into_iter().filter_map(answer).collect()
        };
        word_rows(RecordedSection::Implicit, answers)
    }

    fn part_rows(&self, dialect: DialectName) -> impl Iterator<Item = WrittenRow> {
        let mut all: Vec<(ElementaryType, &str, MatrixAnswer)> = self
            .parts
            .iter()
            .filter(|((of, ..), _)| *of == dialect)
            .map(|((_, ty, part), answer)| (*ty, part.as_str(), *answer))
            .collect();
        all.sort_by_key(|(_, part, _)| {
            let (form, index) = part.split_at(part.find(|c: char| c.is_ascii_digit()).unwrap_or(0));
            (form.to_owned(), index.parse::<u32>().unwrap_or(u32::MAX))
        });
        let answers = move |of| {
            let rows = all.iter().filter(|(ty, ..)| *ty == of);
            rows.map(|(_, part, answer)| (answer.as_str(), (*part).to_owned()))
                .collect()
        };
        word_rows(RecordedSection::Bits, answers)
    }

    fn comparison_rows(&self, dialect: DialectName) -> impl Iterator<Item = WrittenRow> {
        let all = self.all_comparisons(dialect);
        let answers = move |of| {
            let rows = all.iter().filter(|((left, _), _)| *left == of);
            rows.map(|((_, right), word)| (*word, right.name().to_owned()))
                .collect()
        };
        word_rows(RecordedSection::Comparisons, answers)
    }

    fn function_rows(&self, dialect: DialectName) -> impl Iterator<Item = WrittenRow> {
        self.functions
            .iter()
            .filter(move |((of, _), _)| *of == dialect)
            .map(|((_, key), answers)| {
                let section = RecordedSection::Functions.as_str();
                (section, key.clone(), function_row(answers))
            })
    }
}

/// Returns the rows of a kind: for each type that has answers, the words with what each is the answer to.
fn word_rows(
    section: RecordedSection,
    answers: impl Fn(ElementaryType) -> Vec<(&'static str, String)>,
) -> impl Iterator<Item = WrittenRow> {
    ElementaryType::ALL.into_iter().filter_map(move |ty| {
        let mut columns: BTreeMap<&str, Vec<String>> = BTreeMap::new();
        for (word, listed) in answers(ty) {
            columns.entry(word).or_default().push(listed);
        }
        let columns: Vec<String> = columns
            .iter()
            .map(|(word, listed)| match word.contains(' ') {
                true => format!("{} = {}", quoted(word), quoted(&listed.join(" "))),
                false => format!("{word} = {}", quoted(&listed.join(" "))),
            })
            .collect();
        let row = format!("{{ {} }}", columns.join(", "));
        (!columns.is_empty()).then(|| (section.as_str(), ty.name().to_owned(), row))
    })
}

/// Returns a list with a list for each call: the operands and the result, or the word for why there is none.
fn function_row(answers: &FunctionAnswers) -> String {
    let calls = match answers {
        FunctionAnswers::Refused(kind) => return quoted(kind.word()),
        FunctionAnswers::Calls(calls) => calls,
    };
    let calls: Vec<String> = calls
        .iter()
        .map(|(operands, answer)| {
            let mut texts: Vec<String> = operands.iter().map(|value| quoted(&value.literal())).collect();
            texts.push(match answer {
                Ok(value) => quoted(&value.literal()),
                Err(kind) => quoted(kind.word()),
            });
            format!("[{}]", texts.join(", "))
        })
        .collect();
    format!("[{}]", calls.join(", "))
}

fn quoted(text: &str) -> String {
    Toml::String(text.to_owned()).to_string()
}
