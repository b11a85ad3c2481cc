//! Writes a recording as a file: the origin, and a section of answers for each group of dialects in which they are equal.

use super::{FunctionAnswers, Recording};
use std::collections::BTreeMap;
use std::io::{self, Write};
use stickler_types::{DialectName, ElementaryType};
use toml::Value as Toml;

/// The kinds of a section's rows, in the order in which they are written.
const KINDS: [&str; 2] = ["implicit", "functions"];

/// A section: the dialects of its answers, and the text of each row by the kind and key of the row.
type Sections<'r> = BTreeMap<Vec<&'r str>, BTreeMap<(&'static str, String), String>>;

impl Recording {
    /// Writes the file that [`Recording::parse`] reads.
    ///
    /// # Errors
    /// Errors of writing to `out`.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let origin = &self.origin;
        writeln!(out, "# Written by `stickler record`.\n\n[recording]")?;
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
            for kind in KINDS {
                let mut rows = rows.iter().filter(|((of, _), _)| *of == kind).peekable();
                if rows.peek().is_some() {
                    writeln!(out, "\n[answers.{kind}]")?;
                }
                rows.try_for_each(|((_, key), row)| writeln!(out, "{} = {row}", quoted(key)))?;
            }
        }
        Ok(())
    }

    fn sections(&self) -> Sections<'_> {
        // The dialects of each row with the same text.
        let mut equal: BTreeMap<(&str, String, String), Vec<&str>> = BTreeMap::new();
        for dialect in &self.dialects {
            let rows = self.implicit_rows(*dialect).chain(self.function_rows(*dialect));
            for row in rows {
                equal.entry(row).or_default().push(dialect.as_str());
            }
        }
        let mut sections = Sections::new();
        for ((kind, key, row), dialects) in equal {
            sections.entry(dialects).or_default().insert((kind, key), row);
        }
        sections
    }

    fn implicit_rows(&self, dialect: DialectName) -> impl Iterator<Item = (&'static str, String, String)> {
        ElementaryType::ALL.into_iter().filter_map(move |from| {
            let mut columns: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
            for into in ElementaryType::ALL {
                if let Some(answer) = self.implicit(dialect, (from, into)) {
                    columns.entry(answer.as_str()).or_default().push(into.name());
                }
            }
            let columns: Vec<String> = columns
                .iter()
                .map(|(answer, types)| format!("{answer} = {}", quoted(&types.join(" "))))
                .collect();
            let row = format!("{{ {} }}", columns.join(", "));
            (!columns.is_empty()).then(|| ("implicit", from.name().to_owned(), row))
        })
    }

    fn function_rows(&self, dialect: DialectName) -> impl Iterator<Item = (&'static str, String, String)> {
        self.functions
            .iter()
            .filter(move |((of, _), _)| *of == dialect)
            .map(|((_, key), answers)| ("functions", key.clone(), function_row(answers)))
    }
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
