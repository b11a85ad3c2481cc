//! The parts of this crate one by one: each makes texts of texts, which stand in files in `tests/examples`.

use crate::contradictions::{AnswerOrigin, ContradictionsBuilder};
use crate::functions::{dialect_list, find_function};
use crate::implicit::{self, MatrixAnswer};
use crate::literals::{has_literal, literal, power_of_two};
use crate::overview::{
    CaseStatement, ComparedResult, ExpectedResult, StatementsBuilder, accepted, boundary_calls, calls,
    choices, read_operand,
};
use crate::recording::{Recording, all_questions, extreme, program_of};
use crate::session::{Refusal, RefusalKind};
use crate::table::{Alignment, Cell, Table};
use anstyle::Style;
use std::sync::Arc;
use stickler_engines::Outcome;
use stickler_exact::{Signature, signatures};
use stickler_mdtest::{Example, check_examples};
use stickler_types::{DialectName, ElementaryType, MatrixWord, Question, Value, join};

fn dialects(text: &str) -> Vec<DialectName> {
    match text {
        "all" => DialectName::ALL.to_vec(),
        names => names
            .split_whitespace()
            .map(|name| name.parse().unwrap())
            .collect(),
    }
}

fn signature(example: &Example) -> Signature {
    signatures(example.text("function"), dialects(example.text("dialects"))[0]).remove(0)
}

fn ty(name: &str) -> ElementaryType {
    ElementaryType::from_name(name).unwrap_or_else(|| panic!("`{name}` is no type"))
}

fn values(example: &Example, name: &str) -> Vec<Vec<Value>> {
    let values = example.text(name).split_whitespace();
    values
        .map(|literal| vec![Value::parse_observed(literal).unwrap()])
        .collect()
}

#[test]
fn golden_functions() {
    check_examples("tests/examples/functions.md", |example| match example.wanted() {
        "in one line" => dialect_list(&dialects(example.text("dialects"))),
        "choices" => {
            let dialects = dialects(example.text("dialects"));
            let mut bytes = Vec::new();
            choices::write(&signature(example), &dialects, &mut bytes).unwrap();
            anstream::adapter::strip_str(&String::from_utf8(bytes).unwrap()).to_string()
        }
        "boundary values" => join(
            boundary_calls(&signature(example)).iter().map(|call| &call[0]),
            " ",
        ),
        _ => find_function(
            example.text("function"),
            &dialects(example.text("dialects")),
            signatures,
        )
        .map_or_else(
            |error| error.to_string(),
            |found| {
                format!(
                    "{}; not in {}",
                    join(found.having.iter(), " "),
                    join(found.lacking.iter(), " ")
                )
            },
        ),
    });
}

#[test]
fn powers_of_two_are_exact() {
    for exponent in [-149, -1, 0, 1, 52, 128] {
        let value = Value::parse(&power_of_two(exponent)).unwrap();
        let Value::Plain { raw, .. } = value else {
            panic!("{value}")
        };
        assert_eq!(f64::from_bits(raw), 2_f64.powi(exponent));
    }
}

#[test]
fn golden_values() {
    check_examples("tests/examples/values.md", |example| match example.wanted() {
        "literal" => {
            let value = Value::parse(example.text("value")).unwrap();
            if has_literal(&value) {
                literal(&value)
            } else {
                "none".to_owned()
            }
        }
        "read" => {
            let read = read_operand(example.text("text"), ty(example.text("type")), true);
            let told = |message: String| {
                assert!(message.len() < 100, "a long text is told in part: {message}");
                message
            };
            read.map_or_else(told, |value| value.to_string())
        }
        "extreme" => extreme(ty(example.text("type"))).to_string(),
        "parts" => {
            let asked = all_questions(DialectName::CODESYS).into_iter();
            join(
                asked.filter_map(|question| match question {
                    Question::Part(of, part) if of == ty(example.text("type")) => Some(part),
                    _ => None,
                }),
                " ",
            )
        }
        _ => {
            let texts: Vec<String> = example
                .text("texts")
                .split_whitespace()
                .map(str::to_owned)
                .collect();
            let all = signatures(example.text("function"), dialects(example.text("dialects"))[0]);
            let shown = |(signature, calls): &(Signature, Vec<Vec<Value>>)| {
                let operands = calls.iter().map(|call| join(call.iter(), " "));
                format!("{}: {}", signature.operands[0], join(operands, "; "))
            };
            calls(&texts, all).map_or_else(
                |error| error.to_string(),
                |rows| join(rows.iter().map(shown), " "),
            )
        }
    });
}

/// Returns the outcome of a word.
fn outcome(word: &str) -> Outcome {
    let reason = String::new();
    match word {
        "accepted" => Outcome::ACCEPTED,
        "rejected" => Outcome::Rejected {
            diagnostics: Vec::new(),
        },
        "unsupported" => Outcome::Unsupported { reason },
        "not implemented" => Outcome::NotImplemented { reason },
        "crashed" => Outcome::Crashed { reason },
        _ => Outcome::TimedOut { after_ms: 1 },
    }
}

#[test]
fn golden_answers() {
    check_examples("tests/examples/answers.md", |example| match example.wanted() {
        "answer" => implicit::answer(&outcome(example.text("outcome")))
            .as_str()
            .to_owned(),
        "compared" => {
            let answer = MatrixAnswer::from_word(example.text("answer")).unwrap();
            format!(
                "{:?}",
                accepted(answer, MatrixWord::from_word(example.text("word")))
            )
        }
        "contradicts" => {
            let got = example.text("got");
            let got = Value::parse(got).map_err(|_| Refusal {
                kind: RefusalKind::stored(got).unwrap(),
                detail: String::new(),
                line: None,
            });
            let expected = ExpectedResult {
                value: Value::parse("INT#5").unwrap(),
                basis: example
                    .get("basis")
                    .filter(|basis| !basis.is_empty())
                    .map(Arc::from),
                otherwise: None,
            };
            ComparedResult { got, expected }.contradicts().to_string()
        }
        _ => {
            let dialect = dialects(example.text("dialects"))[0];
            let (recorded, source) = (
                Value::parse(example.text("recorded")).unwrap(),
                example.text("source").into(),
            );
            let call = &values(example, "operand")[0];
            let expected = ExpectedResult::of(&signature(example), call, dialect, Some((&recorded, &source)));
            let other = expected
                .otherwise
                .map(|other| format!(", but {} by {}", other.value, other.basis));
            format!(
                "{} by {}{}",
                expected.value,
                expected.basis.as_deref().unwrap_or("nobody"),
                other.unwrap_or_default()
            )
        }
    });
}

/// Returns the recording of a block.
fn recording(example: &Example, name: &str) -> Result<Recording, String> {
    Recording::parse("recordings/mine.toml", example.text(name)).map_err(|error| error.to_string())
}

#[test]
fn golden_recordings() {
    check_examples("tests/examples/recordings.md", |example| {
        let mut read = match recording(example, "recording.toml") {
            Ok(read) => read,
            Err(mistake) => return mistake,
        };
        match example.wanted() {
            "completed" => {
                read.complete_from(recording(example, "older.toml").unwrap());
                let mut text = Vec::new();
                read.write(&mut text).unwrap();
                String::from_utf8(text).unwrap()
            }
            "answer" => {
                let pair = (ty(example.text("from")), ty(example.text("to")));
                read.implicit(DialectName::MATIEC, pair)
                    .map_or("none", MatrixAnswer::as_str)
                    .to_owned()
            }
            "results" => {
                let signature = &signatures(example.text("function"), DialectName::MATIEC)[0];
                let results = read.results(DialectName::MATIEC, signature, &values(example, "operands"));
                let shown = |result: Result<Value, Refusal>| {
                    result.map_or_else(
                        |refusal| refusal.kind.word().to_owned(),
                        |value| value.to_string(),
                    )
                };
                join(results.into_iter().map(shown), " ")
            }
            _ => {
                let made = read.case_tables(DialectName::CODESYS, "my-plc");
                let tables = made
                    .tables
                    .iter()
                    .map(|table| format!("{}: {} rows\n{}", table.section.as_str(), table.rows, table.text));
                let left_out = made
                    .left_out
                    .iter()
                    .map(|(reason, number)| format!("{number} left out: {reason}\n"));
                tables.chain(left_out).collect()
            }
        }
    });
}

#[test]
fn questions_have_names_and_programs_of_their_own() {
    let questions = all_questions(DialectName::CODESYS);
    for text in [Question::to_string, |question: &Question| {
        program_of(question).source()
    }] {
        let texts: std::collections::BTreeSet<String> = questions.iter().map(text).collect();
        assert_eq!(texts.len(), questions.len());
    }
    for question in questions {
        assert_eq!(question.to_string().parse(), Ok(question));
    }
}

#[test]
fn no_function_is_listed_twice() {
    let names = crate::all_functions();
    let once: std::collections::BTreeSet<&String> = names.iter().collect();
    assert_eq!(once.len(), names.len());
    assert!(names.len() > 500, "{}", names.len());
}

/// Returns the cell of a text: numbers on the right, parts apart in styles of their own.
fn cell(text: &str) -> Cell {
    let mut styles = [Style::new(), Style::new().bold()].into_iter().cycle();
    let pieces = text
        .split('~')
        .zip(&mut styles)
        .map(|(piece, style)| (piece.to_owned(), style));
    let is_number = text.starts_with(|first: char| first.is_ascii_digit() || first == '-' || first == '>');
    let align = if is_number {
        Alignment::Right
    } else {
        Alignment::Left
    };
    let pieces = pieces.map(|(piece, style)| (piece.trim_start_matches('>').to_owned(), style));
    Cell::new(pieces.collect(), align)
}

#[test]
fn golden_tables() {
    check_examples("tests/examples/terminal-tables.md", |example| {
        let line = |text: &str| text.split(" / ").map(cell).collect::<Vec<Cell>>();
        let mut lines = example.text("table").lines();
        let heads = example
            .get("heads")
            .map(|heads| heads.lines().map(line).collect());
        let mut table = match heads {
            Some(heads) => Table::of_values(heads, 1, 2),
            None => Table::new(line(lines.next().unwrap())),
        };
        lines.for_each(|text| table.row(line(text)));
        let mut bytes = Vec::new();
        table
            .write(&mut bytes, example.text("columns").parse().ok())
            .unwrap();
        let text = anstream::adapter::strip_str(&String::from_utf8(bytes).unwrap()).to_string();
        // In an example `…` stands for any text.
        text.replace('…', "~")
    });
}

/// Shows what is stated of the questions of cases, whose lines are `id@dialect word question = result (basis)`, or the boundary values.
#[test]
fn golden_statements() {
    check_examples("tests/examples/statements.md", |example| {
        let mut builder = StatementsBuilder::new(dialects(example.text("dialects")));
        for line in example.text("cases").lines() {
            let parts = || {
                let (case, rest) = line.split_once('@')?;
                let (dialect, rest) = rest.split_once(' ')?;
                let (word, rest) = rest.split_once(' ')?;
                let (asked, basis) = rest.strip_suffix(')')?.split_once(" (")?;
                Some((case, dialect, word, asked, basis))
            };
            let (case, dialect, word, asked, basis) = parts().unwrap_or_else(|| panic!("{line}"));
            let (question, result) = match asked.split_once(" = ") {
                Some((question, result)) => (question, Some(Value::parse(result).unwrap())),
                None => (asked, None),
            };
            let statement = CaseStatement {
                case: &case.into(),
                dialect: dialect.parse().unwrap(),
                word: MatrixWord::from_word(word).unwrap(),
                result: result.as_ref(),
                basis: &basis.into(),
            };
            builder.add(&question.parse().unwrap(), &statement);
        }
        let statements = builder.finish(&[]);
        assert_eq!(Vec::from_iter(statements.function_names()), ["REAL_TO_INT"]);
        assert_eq!(statements.function_of(u32::MAX), None);
        let data = serde_json::to_value(&statements).unwrap();
        let list = |value: &serde_json::Value| value.as_array().unwrap().clone();
        let word = |number: &serde_json::Value| match number.as_u64() {
            Some(number) => data["words"][usize::try_from(number).unwrap()].as_str().unwrap(),
            None => "nobody",
        };
        let words = |numbers: &serde_json::Value| join(list(numbers).iter().map(word), " ");
        let first_call = list(&data["pairs"]).len() + list(&data["parts"]).len();
        if example.wanted() == "boundaries" {
            let number = usize::try_from(data["functions"][0]["boundaries"].as_u64().unwrap()).unwrap();
            return join(list(&data["calls"]["operands"])[..number].iter().map(words), " ");
        }
        let stated = [list(&data["pairs"]), list(&data["parts"])].concat();
        let shown = |line: &str| {
            let case = line.split('@').next().unwrap_or_default();
            let Some(question) = statements.question(case) else {
                return format!("{case}: no question");
            };
            if let Some(pair) = stated.get(question as usize) {
                let of_dialect = |one: &serde_json::Value| match one.as_array().map(|list| &list[..]) {
                    Some([stated, basis]) => format!("{} by {}", stated.as_str().unwrap(), word(basis)),
                    _ => "nothing".to_owned(),
                };
                let all: Vec<String> = list(&pair["stated"]).iter().map(of_dialect).collect();
                assert_eq!(statements.function_of(question), None);
                return format!(
                    "{case}: {}: {}",
                    words(&serde_json::json!([pair["from"], pair["to"]])),
                    all.join(", ")
                );
            }
            let calls = &data["calls"];
            let call = question as usize - first_call;
            let bases = &data["bases"][usize::try_from(calls["bases"][call].as_u64().unwrap()).unwrap()];
            let bases: Vec<&str> = list(bases).iter().map(word).collect();
            format!(
                "{case}: {}({}): {} by {}",
                statements.function_of(question).unwrap(),
                words(&calls["operands"][call]),
                words(&calls["values"][call]),
                bases.join(", ")
            )
        };
        join(example.text("cases").lines().map(shown), "\n")
    });
}

/// Shows the topics of answers, whose lines are `question = answer (system, kind, source)`.
#[test]
fn golden_contradictions() {
    check_examples("tests/examples/contradictions.md", |example| {
        let mut builder = ContradictionsBuilder::default();
        for line in example.text("answers").lines() {
            let (question, rest) = line.split_once(" = ").unwrap();
            let (answer, by) = rest.strip_suffix(')').unwrap().split_once(" (").unwrap();
            let by: Vec<&str> = by.split(", ").collect();
            let [system, kind, source] = [0, 1, 2].map(|at| by[at].to_owned());
            let (read, address, dialect) = ("1".to_owned(), "https://example.org".to_owned(), None);
            let origin = AnswerOrigin {
                system,
                kind,
                source,
                read,
                address,
                dialect,
            };
            let given = (&Arc::new(origin), answer.to_owned());
            builder.add_question(&question.parse().unwrap(), None, given);
        }
        let mut text = Vec::new();
        builder.finish(usize::MAX, |_| true).write(&mut text).unwrap();
        String::from_utf8(text).unwrap()
    });
}
