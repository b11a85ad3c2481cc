//! The sign of a failing program: its symptom, what the engine said, and where.

use crate::compiler_place::compiler_place;
use crate::malformed::forms_of_literals;
use crate::patterns::amount;
use crate::program::Program;
use crate::question::wrong_values;
use crate::shape::{KeptTypes, shape, token_at};
use crate::words::words;
use crate::work::{Role, words_of, works};
use stickler_run::{Fact, Grade, Symptom, Verdict};
use stickler_types::{Code, Family, Value, join};

/// The differences of a wrong number that no rounding explains, as [`Sign::at`] tells them.
const TOO_GREAT: &str = "too great";
const TOO_SMALL: &str = "too small";
/// The number of words that are kept of a message.
const MAX_WORDS: usize = 8;

/// The properties by which two failing programs of the same shape are told apart.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Sign {
    pub(crate) symptom: Symptom,
    /// The kind of token at the place of the first diagnostic, for mistakes of reading, whose messages say little else; the
    /// place in the compiler at which something is not implemented, or the operations of the program where it names none; how
    /// the first differing lines differ, for a rendered text; whether a wrong number is far above the right one or far below it;
    /// how many bits a constant has that is accepted.
    pub(crate) at: String,
}

impl Sign {
    /// Returns the sign of a program that did not come out as expected.
    pub(crate) fn of(program: &str, verdict: Verdict, facts: (&[Fact], &[Fact]), strict: Grade) -> Sign {
        let symptom = Symptom::of_facts(verdict, facts, strict);
        let at = match &symptom {
            Symptom::Rejected(reason)
            | Symptom::OtherCode { reported: reason, .. }
            | Symptom::Surplus(reason)
                if is_of_reading(reason) =>
            {
                token_of(program, reason, facts.1)
            }
            Symptom::NotImplemented(_) => compiler_place(facts.1).unwrap_or_else(|| work_of(program)),
            Symptom::Text => difference(facts),
            Symptom::Value => far(facts).unwrap_or_default().to_owned(),
            Symptom::NotRejected(code) if code == Code::ConstantOverflow.as_str() => size(program).to_owned(),
            _ => String::new(),
        };
        Sign { symptom, at }
    }

    /// Returns the sign as a word; equal words mean equal signs.
    pub(crate) fn word(&self) -> String {
        let reported = match &self.symptom {
            Symptom::OtherCode { reported, .. } => reported,
            Symptom::Crash(words) | Symptom::Unusable(words) | Symptom::Error(words) => words,
            _ => "",
        };
        let words = [&self.symptom.word(), reported, &self.at].map(str::to_owned);
        join(words.into_iter().filter(|word| !word.is_empty()), " ")
    }

    /// Returns whether the engine rejects a program with a mistake, but says something else of it.
    pub(crate) const fn is_rejected_otherwise(&self) -> bool {
        matches!(
            self.symptom,
            Symptom::OtherCode { .. } | Symptom::Surplus(_) | Symptom::OtherLine(_)
        )
    }

    /// Returns whether the engine does not take a program that must be accepted.
    pub(crate) const fn rejects_valid(&self) -> bool {
        matches!(self.symptom, Symptom::Rejected(_) | Symptom::NotImplemented(_))
    }

    /// Returns whether the engine accepts what must be rejected.
    pub(crate) const fn accepts(&self) -> bool {
        matches!(self.symptom, Symptom::NotRejected(_))
    }

    /// Returns how much of its types the shape of a program with this sign keeps: what is computed depends on them, what is
    /// accepted or rejected seldom does.
    fn types(&self) -> KeptTypes {
        match self.symptom {
            Symptom::Value
            | Symptom::Missing
            | Symptom::Fault(_)
            | Symptom::FaultLine(_)
            | Symptom::NotFaulted(_) => KeptTypes::Families,
            _ => KeptTypes::Equal,
        }
    }

    /// Returns the shape of a program with this sign. It is empty where the program does not matter.
    pub(crate) fn shape(&self, program: &str) -> String {
        match self.symptom {
            // A compiler that loses the place of a diagnostic loses it in every program; the others are told by `at`.
            Symptom::NoPlace(_) | Symptom::Text | Symptom::OtherType | Symptom::Error(_) => String::new(),
            // What is wrong with a literal is told by its form alone.
            Symptom::NotRejected(ref code) if is_of_reading(code) => {
                let forms = Vec::from_iter(forms_of_literals(program)).join(" ");
                format!("{} {forms}", shape(program, self.types()))
            }
            _ => shape(program, self.types()),
        }
    }

    /// Returns whether a smaller program with the sign `seen` shows the same defect, or one that this sign hides.
    pub(crate) fn is_kept_by(&self, seen: &Sign) -> bool {
        if self == seen {
            return true;
        }
        match (&self.symptom, &seen.symptom) {
            (Symptom::Incomplete(code), Symptom::NotRejected(same)) => code == same,
            // The program is rejected for this reason even where nothing is wrong with it.
            (Symptom::OtherCode { reported, .. } | Symptom::Surplus(reported), Symptom::Rejected(reason)) => {
                reported == reason && self.at == seen.at
            }
            _ => false,
        }
    }
}

/// Returns whether a code of the registry, which adapters give to the messages of engines without codes too, says that a program cannot
/// be read.
pub(crate) fn is_of_reading(code: &str) -> bool {
    code.starts_with("P0")
}

/// Returns whether an engine says that it could not read a program.
pub(crate) fn is_unread(got: &[Fact]) -> bool {
    let reported = got.iter().find_map(Fact::diagnostic);
    let code = reported.and_then(|reported| reported.code.as_deref());
    code.is_some_and(is_of_reading)
}

/// Returns whether a code says that a value does not fit the type of where it is given.
pub(crate) fn is_of_a_value(code: &str) -> bool {
    matches!(
        code.parse(),
        Ok(Code::ConstantOverflow
            | Code::RealLiteralOutOfRange
            | Code::InitializerTypeMismatch
            | Code::FunctionCallArgTypeMismatch
            | Code::FunctionCallReturnTypeMismatch
            | Code::AssignmentTypeMismatch
            | Code::OperatorOperandTypeMismatch)
    )
}

/// Returns the operations of the statements of a program of which something is not implemented: the document speaks of all these
/// together. A condition may stand around anything; where one is missing, the message says so.
pub(crate) fn work_of(text: &str) -> String {
    let program = Program::new(text);
    let bodies: Vec<(u32, u32)> = program
        .unit
        .pous()
        .filter_map(|pou| Some((pou.body.first()?.span.start, pou.body.last()?.span.end)))
        .collect();
    let works = works(text);
    let stated = works.iter().filter(|work| {
        let mut bodies = bodies.iter();
        bodies.any(|(start, end)| (start..end).contains(&&work.span.start))
    });
    let mut operations = words_of(stated, Role::Operation);
    // What is calculated beside something else does not matter.
    if operations.len() > 1 {
        operations.remove("arithmetic");
    }
    operations.remove("condition");
    Vec::from_iter(operations).join(", ")
}

/// Returns the kind of token at the place of the diagnostic with this code; the first words of its message where it has no
/// column.
fn token_of(program: &str, code: &str, got: &[Fact]) -> String {
    let mut diagnostics = got.iter().filter_map(Fact::diagnostic);
    let Some(reported) = diagnostics.find(|reported| reported.code.as_deref() == Some(code)) else {
        return String::new();
    };
    if let (Some(line), Some(column)) = (reported.line, reported.column) {
        let token = token_at(program, line, column);
        return match token.as_str() {
            "=" | "<>" | "<" | ">" | "<=" | ">=" => "comparison".to_owned(),
            _ => token,
        };
    }
    let words = reported.message.split_whitespace();
    let plain = words.filter(|word| word.bytes().all(|byte| byte.is_ascii_lowercase()));
    plain.take(MAX_WORDS).collect::<Vec<_>>().join(" ")
}

/// Returns where the first number that a program has wrong is, if it is further from the right one than an error of rounding: one conversion
/// may round wrongly and also leave the range of its type, and another may lose the sign.
fn far((expected, got): (&[Fact], &[Fact])) -> Option<&'static str> {
    let (_, (wanted, got)) = wrong_values(expected, got).next()?;
    let (wanted, got) = (number(wanted)?, number(got)?);
    // Rounding to an integer changes a number by no more than 1.
    let whole = if wanted.fract() == 0.0 && got.fract() == 0.0 {
        1.0
    } else {
        0.0
    };
    let is_near = (wanted - got).abs() <= wanted.abs().mul_add(1e-6, whole) || wanted == got;
    match got > wanted {
        _ if is_near => None,
        true => Some(TOO_GREAT),
        false => Some(TOO_SMALL),
    }
}

/// Returns how many bits the largest integer of a program has, since compilers compute constants with 32 or 64.
fn size(program: &str) -> &'static str {
    let program = Program::new(program);
    let program = program.read();
    let most = program
        .literals()
        .filter_map(|(_, literal)| amount(literal))
        .fold(0.0, f64::max);
    match most {
        most if most >= 2_f64.powi(64) => "more than 64 bits",
        most if most > 2_f64.powi(31) => "more than 31 bits",
        _ => "",
    }
}

/// Returns the number that a value is: of a duration or a date its count; `None` for a text and for no number.
fn number(value: &Value) -> Option<f64> {
    if let Some(real) = value.real() {
        return (!real.is_nan()).then_some(real);
    }
    match value {
        Value::Plain { ty, raw } if ty.family() == Family::Signed || ty.is_duration() => {
            Some(raw.cast_signed() as f64)
        }
        Value::Plain { raw, .. } => Some(*raw as f64),
        _ => None,
    }
}

/// Returns the first words in which a rendered text is not the expected one; of one that is rejected itself, why and at what.
fn difference((expected, got): (&[Fact], &[Fact])) -> String {
    if let Some((wanted, reported)) = differing_lines(expected, got) {
        return differing_words(wanted, reported);
    }
    let rejected = got.iter().find_map(|fact| match fact {
        Fact::NotRendered {
            again: true,
            rejection,
        } => Some(rejection.as_deref().unwrap_or_default()),
        _ => None,
    });
    match rejected {
        Some(rejection) => format!("again {}", shape(rejection, KeptTypes::Equal)),
        None => "lines are missing".to_owned(),
    }
}

/// Returns the forms of the first words in which two lines differ, beside parentheses; of none where they differ in these alone.
fn differing_words(wanted: &str, reported: &str) -> String {
    let words = |line| words(line).into_iter().filter(|word| !matches!(*word, "(" | ")"));
    let (wanted, reported) = (words(wanted), words(reported));
    let same = wanted
        .clone()
        .zip(reported.clone())
        .take_while(|(one, other)| one == other);
    let same = same.count();
    let form = |word: Option<&str>| word.map_or(String::new(), |word| shape(word, KeptTypes::Equal));
    [wanted, reported]
        .map(|mut words| form(words.nth(same)))
        .join(" / ")
}

/// Returns the first lines in which a rendered text is not the expected one, of those that differ in more than parentheses if there are any.
pub(crate) fn differing_lines<'f>(expected: &'f [Fact], got: &'f [Fact]) -> Option<(&'f str, &'f str)> {
    let lines = |facts: &'f [Fact]| {
        let lines = facts.iter().find_map(|fact| match fact {
            Fact::Rendered { lines } => Some(&lines[..]),
            _ => None,
        });
        lines.unwrap_or_default()
    };
    let pairs = lines(expected).iter().zip(lines(got));
    let differing = pairs.filter(|(wanted, reported)| wanted != reported);
    let plain = |line: &str| line.replace(['(', ')', ' '], "");
    let first = differing
        .clone()
        .find(|(wanted, reported)| plain(wanted) != plain(reported));
    let (wanted, reported) = first.or_else(|| differing.clone().next())?;
    Some((wanted, reported))
}

/// Returns whether a diagnostic has no line.
pub(crate) fn has_lost_place(got: &[Fact]) -> bool {
    let mut reported = got.iter().filter_map(Fact::diagnostic);
    reported.any(|one| one.line.is_none())
}
