//! Turns the answers of a recording into tables of cases, whose basis is the recording.

use super::write::quoted;
use super::{RecordedSection, Recording, all_questions, program_of};
use crate::implicit::MatrixAnswer;
use crate::program::ConversionProgram;
use crate::session::RefusalKind;
use std::collections::BTreeMap;
use std::slice;
use stickler_exact::signature_of;
use stickler_types::{DialectName, ElementaryType, Question, Value, join};

/// A table of cases that was made of a section of a recording.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct RecordedTable {
    /// The section whose answers it holds.
    pub section: RecordedSection,
    /// The number of its rows, each of which is a case.
    pub rows: usize,
    /// The text of the file.
    pub text: String,
}

/// The tables of cases of a recording, and the answers that are none.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct RecordedTables {
    /// The tables, in the order of the sections; none without rows.
    pub tables: Vec<RecordedTable>,
    /// The number of answers that no case asserts, by the reason.
    pub left_out: BTreeMap<&'static str, usize>,
}

/// A row: its name in the ids of cases, the program, and the word or value that must come.
type CaseRow = (String, ConversionProgram, String);

/// The fate of an answer: a word or value that a case expects, or the reason why there is no case.
type PromotedAnswer = Result<String, &'static str>;

impl Recording {
    /// Makes tables of cases of the answers of a dialect. The cases belong to `owner`, the same dialect or one that extends it.
    ///
    /// A warning asserts no more than that the program is accepted, for the code of a warning was not recorded. A call that was refused, a part
    /// that was refused in another form than `.n`, and an engine that crashed or took too long assert nothing.
    pub fn case_tables(&self, dialect: DialectName, owner: &str) -> RecordedTables {
        let mut made = RecordedTables::default();
        let mut rows: BTreeMap<RecordedSection, Vec<CaseRow>> = BTreeMap::new();
        for question in all_questions(dialect) {
            let Some((section, answer)) = self.expected(dialect, &question) else {
                continue;
            };
            match answer {
                Ok(expected) => rows.entry(section).or_default().push((
                    question.to_string(),
                    program_of(&question),
                    expected,
                )),
                Err(reason) => *made.left_out.entry(reason).or_default() += 1,
            }
        }
        let table = |(section, rows): (RecordedSection, Vec<CaseRow>)| RecordedTable {
            section,
            rows: rows.len(),
            text: self.table(section, owner, &rows),
        };
        made.tables = rows.into_iter().map(table).collect();
        made
    }

    /// Returns what a case expects of a question; `None` where it was not asked.
    fn expected(
        &self,
        dialect: DialectName,
        question: &Question,
    ) -> Option<(RecordedSection, PromotedAnswer)> {
        match question {
            Question::Implicit(pair) => {
                let answer = self.implicit(dialect, *pair)?;
                let rules = dialect.rules();
                let expected = match rules.may_name(pair.0) && rules.may_name(pair.1) {
                    true => accepted_or_not(answer),
                    false => Err("a type that the dialect does not have"),
                };
                Some((RecordedSection::Implicit, expected))
            }
            Question::Part(ty, part) => {
                let expected = match (self.part(dialect, *ty, part)?, dialect.rules().may_name(*ty)) {
                    (_, false) => Err("a type that the dialect does not have"),
                    (MatrixAnswer::Rejects, _) if part.starts_with('%') => Err(
                        "a part that is rejected: whether the form or the number is wrong was not recorded",
                    ),
                    (MatrixAnswer::Rejects, _) if !self.has_bits(dialect, *ty) => Err(
                        "a part of a type that has none: whether the type or the number is wrong was not recorded",
                    ),
                    (answer, _) => accepted_or_not(answer),
                };
                Some((RecordedSection::Bits, expected))
            }
            Question::Comparison(pair) => {
                let expected = match self.comparison(dialect, *pair)? {
                    Ok(true) => Ok("BOOL#TRUE".to_owned()),
                    Ok(false) => Ok("BOOL#FALSE".to_owned()),
                    Err(RefusalKind::Rejected) => Ok("no".to_owned()),
                    Err(_) => Err(NO_ANSWER),
                };
                Some((RecordedSection::Comparisons, expected))
            }
            Question::Call(call) => {
                let signature = signature_of(call, dialect)?;
                let answers = self.results(dialect, &signature, slice::from_ref(&call.operands));
                let answer = answers.into_iter().next()?.map_err(|refusal| refusal.kind);
                let expected = match answer {
                    Err(RefusalKind::NotAsked) => return None,
                    Ok(Value::OutOfRange { .. }) => {
                        Err("a result beyond the range of its type, which no literal writes")
                    }
                    Ok(value) => Ok(value.to_string()),
                    Err(RefusalKind::Rejected) => Err("a call that is rejected: why was not recorded"),
                    Err(_) => Err(NO_ANSWER),
                };
                Some((RecordedSection::Functions, expected))
            }
        }
    }

    /// Returns whether a bit of the type was accepted in the dialect, so that a bit that was not has a number beyond the type.
    fn has_bits(&self, dialect: DialectName, ty: ElementaryType) -> bool {
        matches!(
            self.part(dialect, ty, "0"),
            Some(MatrixAnswer::Accepts | MatrixAnswer::Warns)
        )
    }

    fn table(&self, section: RecordedSection, owner: &str, rows: &[CaseRow]) -> String {
        let product = format!("{} {}", self.origin.product, self.origin.version);
        let product = product.replace('{', "{{").replace('}', "}}");
        let (probe, code, observe) = match section {
            RecordedSection::Implicit => ("converts", Some("P4035"), None),
            RecordedSection::Bits => ("selects", Some("P4025"), None),
            RecordedSection::Comparisons => ("compares", Some("P4049"), Some("BOOL")),
            RecordedSection::Functions => ("gives", None, Some("{target}")),
        };
        let mut text = format!(
            "# Made of recordings/{0}.toml by `stickler promote`.\n\
             title    = {1}\nbasis    = {2}\ndialects = [{3}]\n\n",
            self.name,
            quoted(&format!("{product}, recorded: {{done}}")),
            quoted(&format!("recording: {}", self.name)),
            quoted(owner)
        );
        let targets = observe.is_some_and(|ty| ty.starts_with('{'));
        let target = if targets { "\"target\", " } else { "" };
        text += &format!("columns = [\"id\", \"declared\", \"done\", {target}\"recorded\"]\nrows = [\n");
        for (id, program, recorded) in rows {
            let (declared, done) = (one_line(&program.declarations), one_line(&program.statements));
            let target = match targets {
                true => format!("{}, ", quoted(program.ty.name())),
                false => String::new(),
            };
            let cells = [id, &declared, &done].map(|cell| quoted(cell)).join(", ");
            text += &format!("    [{cells}, {target}{}],\n", quoted(recorded));
        }
        text += &format!("]\nasks = \"{{id}}\"\n\n[[probe]]\nname    = {}\n", quoted(probe));
        if let Some((ty, (_, program, _))) = observe.zip(rows.first()) {
            let name = program.observed.first().map_or("", String::as_str);
            text += &format!("observe = \"{name} : {ty}\"\n");
        }
        let mark = code.map(|code| format!(" (*! error {code} if recorded = no *)"));
        text += &format!(
            "expect  = \"{{recorded}}\"\nsource  = \"\"\"\nPROGRAM main\nVAR\n    {{declared}}\nEND_VAR\n    {{done}}{}\nEND_PROGRAM\n\"\"\"\n",
            mark.unwrap_or_default()
        );
        text
    }
}

/// The reason for which a crash, a time-out and the like assert nothing.
const NO_ANSWER: &str = "no answer: a crash, a time-out, or a program that the engine does not support";

fn accepted_or_not(answer: MatrixAnswer) -> PromotedAnswer {
    match answer {
        MatrixAnswer::Accepts | MatrixAnswer::Warns => Ok("accepted".to_owned()),
        MatrixAnswer::Rejects => Ok("no".to_owned()),
        MatrixAnswer::Unsupported | MatrixAnswer::Fails => Err(NO_ANSWER),
    }
}

/// Returns declarations or statements on one line.
fn one_line(text: &str) -> String {
    join(text.lines().map(str::trim), " ")
}
