//! Writes a recording as a file: the origin, and a section of answers for each group of dialects in which they are equal.

use super::{FunctionAnswers, RecordedSection, Recording, WordKey};
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_types::{DialectName, ElementaryType, join};

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
            let names = join(dialects.into_iter().map(quoted), ", ");
            writeln!(out, "\n[[answers]]\ndialects = [{names}]")?;
            for kind in RecordedSection::ALL.iter().map(|section| section.as_str()) {
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
            let rows = self.word_rows(*dialect).chain(self.function_rows(*dialect));
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

    /// Returns a row for each section and type that has answers in words: the words with what each is the answer to.
    fn word_rows(&self, dialect: DialectName) -> impl Iterator<Item = WrittenRow> {
        let words = self.words.iter().filter(|((of, _), _)| *of == dialect);
        let mut words: Vec<(&WordKey, &str)> = words.map(|((_, key), word)| (key, *word)).collect();
        words.sort_by_key(|((.., column), _)| place(column));
        let mut rows: BTreeMap<(RecordedSection, ElementaryType), BTreeMap<&str, Vec<&str>>> =
            BTreeMap::new();
        for ((section, ty, column), word) in words {
            let row = rows.entry((*section, *ty)).or_default();
            row.entry(word).or_default().push(column);
        }
        rows.into_iter().map(|((section, ty), columns)| {
            let columns = columns.iter().map(|(word, listed)| match word.contains(' ') {
                true => format!("{} = {}", quoted(word), quoted(&listed.join(" "))),
                false => format!("{word} = {}", quoted(&listed.join(" "))),
            });
            let row = format!("{{ {} }}", join(columns, ", "));
            (section.as_str(), ty.name().to_owned(), row)
        })
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

/// Returns the place of a column in its row: types in their order, parts by form and number.
fn place(column: &str) -> (usize, &str, u32) {
    let types = ElementaryType::ALL.into_iter();
    let number = types.take_while(|ty| ty.name() != column).count();
    let (form, index) = column.split_at(column.find(|c: char| c.is_ascii_digit()).unwrap_or(0));
    (number, form, index.parse().unwrap_or(u32::MAX))
}

/// Returns a list with a list for each call: the operands and the result, or the word for why there is none.
fn function_row(answers: &FunctionAnswers) -> String {
    let calls = match answers {
        FunctionAnswers::Refused(kind) => return quoted(kind.word()),
        FunctionAnswers::Calls(calls) => calls,
    };
    let calls = calls.iter().map(|(operands, answer)| {
        let mut texts: Vec<String> = operands.iter().map(|value| quoted(&value.literal())).collect();
        texts.push(match answer {
            Ok(value) => quoted(&value.literal()),
            Err(kind) => quoted(kind.word()),
        });
        format!("[{}]", texts.join(", "))
    });
    format!("[{}]", join(calls, ", "))
}

/// Returns a text as TOML writes it.
pub(super) fn quoted(text: &str) -> String {
    toml::Value::from(text).to_string()
}
