//! The essence of a cause: what of its smallest program matters for the defect, without the place where it happens to stand.
//!
//! Two small programs show one defect where the engine does the same with the same construct. Which construct it is follows
//! from the kind of deviation: the line that is accepted or rejected wrongly, or, of a wrong value, the conversion that the
//! program contains; without a conversion, everything by which the program differs from an assignment.

use crate::names::Names;
use crate::normal::Normal;
use crate::operations::{operations, operations_of};
use crate::reduction::Smallest;
use crate::shape::{in_declarations, number, own_functions, text, types_of};
use crate::statements::{is_block, path};
use crate::title::{assignment, unimplemented};
use crate::tokens::{Token, TokenKind, tokens};
use std::collections::BTreeSet;
use stickler_run::{CaseEvent, Fact, Symptom};
use stickler_types::{Diagnostic, ElementaryType, Family};

/// The features of where a line stands.
const PLACES: [&str; 3] = ["type", "declaration", "statement"];
/// The feature of a mistake that is a literal without a type.
const LITERAL: &str = "untyped literal";
/// The feature of a place where a value of every type is accepted.
const UNCHECKED: &str = "unchecked";

/// What matters of a small program that shows a defect.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Essence {
    /// What the engine does; causes with different classes are different.
    pub(crate) class: String,
    /// The constructs that the defect needs.
    pub(crate) features: BTreeSet<String>,
    /// The properties of values and types that it needs; a cause that needs fewer of them explains one that needs more.
    pub(crate) labels: BTreeSet<String>,
    /// Whether a program with more features of the same class shows the same defect: it contains what already fails alone.
    pub(crate) is_contained: bool,
    /// The class and the constructs of a valid program that is rejected for the same reason, for one that is rejected for the
    /// wrong reason.
    pub(crate) hidden: Option<(String, BTreeSet<String>)>,
}

impl Essence {
    /// Returns the essence of a program that was made small, by its normal form.
    pub(crate) fn of(smallest: &Smallest, normal: &Normal) -> Essence {
        let sign = &normal.deviation.sign;
        let program = Program::new(normal);
        let (class, features, is_contained) = match &sign.symptom {
            Symptom::NotRejected(code) => {
                let features = program.of_mistake(normal.is_unchecked);
                // A place alone is in every program.
                let names_construct = !features.iter().any(|feature| PLACES.contains(&feature.as_str()));
                (format!("accepted {code}"), features, names_construct)
            }
            // What the engine says of a literal depends on the place where it stands.
            Symptom::Rejected(_) if program.has_special_literal() => {
                ("rejected literal".to_owned(), program.of_rejection(), true)
            }
            Symptom::Rejected(reason) => (rejected(reason, &sign.at), program.of_rejection(), true),
            Symptom::NotImplemented(words) => {
                let class = format!("not implemented {words}");
                (class, program.of_missing(normal), true)
            }
            Symptom::OtherCode { code, told } => {
                // The kind of value does not matter for what else is said.
                let mut features = program.of_mistake(false);
                if features.remove(LITERAL) {
                    features.insert(program.place().to_owned());
                }
                (format!("{code} as {told}"), features, false)
            }
            Symptom::Value if normal.is_beginning => {
                let features = ["FUNCTION_BLOCK", "initial value"].map(str::to_owned);
                (sign.symptom.word(), BTreeSet::from(features), false)
            }
            Symptom::Value if normal.is_widened => {
                let features = BTreeSet::from(["operation in the type of its target".to_owned()]);
                (sign.symptom.word(), features, false)
            }
            Symptom::Value | Symptom::Missing => {
                let (features, converts) = program.of_value();
                (sign.symptom.word(), features, !converts)
            }
            Symptom::Crash(words) | Symptom::Unusable(words) if words.split(' ').count() > 3 => {
                (format!("crash {words}"), BTreeSet::new(), false)
            }
            // Whatever it says, it says where by one piece of work.
            Symptom::NoPlace(_) => ("no place".to_owned(), BTreeSet::new(), false),
            Symptom::Text | Symptom::Error(_) => (sign.word(), BTreeSet::new(), false),
            Symptom::OtherLine(_) | Symptom::Incomplete(_) => (sign.word(), program.of_mistake(false), false),
            Symptom::Fault(_) | Symptom::FaultLine(_) | Symptom::NotFaulted(_) => {
                (sign.word(), program.of_fault(), false)
            }
            _ => (sign.word(), BTreeSet::from([sign.shape(&normal.program)]), false),
        };
        let mut features = features;
        if normal.is_unchecked {
            features.insert(UNCHECKED.to_owned());
        }
        let hidden = match &sign.symptom {
            Symptom::OtherCode { told, .. } | Symptom::Surplus(told) => {
                Some((rejected(told, &sign.at), program.of_rejection()))
            }
            _ => None,
        };
        let by_chance = if smallest.flaky.is_some() {
            "by chance: "
        } else {
            ""
        };
        Essence {
            class: format!("{by_chance}{}", class.trim_end()),
            features,
            labels: normal.labels.clone(),
            is_contained,
            hidden: hidden.map(|(class, features)| (format!("{by_chance}{}", class.trim_end()), features)),
        }
    }

    /// Returns the constructs, values and types that the defect needs, as a key.
    pub(crate) fn construct(&self) -> String {
        let all: Vec<&str> = self
            .features
            .iter()
            .chain(&self.labels)
            .map(String::as_str)
            .collect();
        all.join(", ")
    }

    /// Returns whether a cause with this essence explains one with the essence `other`.
    pub(crate) fn explains(&self, other: &Essence) -> bool {
        let needs_no_more = |class: &str, features: &BTreeSet<String>| {
            // Where nothing is checked is more than where one mistake is not seen.
            let is_checked = |features: &BTreeSet<String>| !features.contains(UNCHECKED);
            let contains = self.is_contained
                && self.features.is_subset(features)
                && is_checked(&self.features) == is_checked(features);
            self.class == class && (self.features == *features || contains)
        };
        let hidden = other.hidden.as_ref();
        let is_same = needs_no_more(&other.class, &other.features) && self.labels.is_subset(&other.labels);
        is_same || hidden.is_some_and(|(class, features)| needs_no_more(class, features))
    }
}

/// Returns whether the claim of a case still speaks of a program that was made from the case's: whether the program has the
/// operations of that line of the case in which its expectation shows, and is not rejected for another line. A claim about a value
/// says nothing of a program without an operation that the engine cannot read.
pub(crate) fn keeps_claim(case: &CaseEvent, smallest: &Smallest) -> bool {
    let program = case.program.as_deref().unwrap_or_default();
    let all = tokens(program);
    let wanted = case
        .expected
        .iter()
        .zip(case.got.iter().map(Some).chain(std::iter::repeat(None)));
    let mut differing = wanted
        .filter(|(wanted, told)| Some(*wanted) != *told)
        .map(|(wanted, _)| wanted);
    let line = match differing.next() {
        Some(Fact::Value { name, .. }) => assignment(program, name).map(|line| {
            let number = line.as_ptr() as usize - program.as_ptr() as usize;
            let number = program[..number].lines().count() as u32 + 1;
            all.iter().filter(|token| token.line == number).copied().collect()
        }),
        Some(Fact::Diagnostic(Diagnostic { line, .. }) | Fact::Fault { line, .. }) => {
            let on_line = |token: &&Token<'_>| Some(token.line) == *line;
            Some(all.iter().filter(on_line).copied().collect())
        }
        _ => None,
    };
    let line: Option<Vec<Token<'_>>> = line;
    let told = case.got.iter().find_map(|fact| fact.diagnostic()?.line);
    let focus = line
        .as_ref()
        .and_then(|line| line.first())
        .map(|token| token.line);
    let is_elsewhere = told.is_some_and(|told| told > 1) && focus.is_some() && told != focus;
    if is_elsewhere && matches!(smallest.deviation.sign.symptom, Symptom::Rejected(_)) {
        return false;
    }
    let own = own_functions(&all);
    let claimed = line
        .as_ref()
        .map(|line| operations(line, &own))
        .unwrap_or_default();
    let is_value = matches!(case.expected[..], [Fact::Value { .. }, ..]);
    if is_value && claimed.is_empty() && is_unread(&smallest.deviation.got) {
        return false;
    }
    let kept = operations_of(&smallest.program);
    claimed.is_subset(&kept)
        && has_signed_literal(&line.unwrap_or_default()) <= has_signed_literal(&tokens(&smallest.program))
        && (!smallest.deviation.sign.rejects_valid() || keeps_work(program, &smallest.program, &kept))
}

/// Returns whether a program that an engine does not take still does what the whole one did with its values: conversions by name
/// and accesses of bits, or else the conversion between two types.
fn keeps_work(whole: &str, program: &str, kept: &BTreeSet<String>) -> bool {
    let is_work = |operation: &&String| operation.contains("_TO_") || *operation == "bit access";
    let operations = operations_of(whole);
    let work: Vec<&String> = operations.iter().filter(is_work).collect();
    let types = |program: &str| {
        let types = types_of(program).into_iter();
        types.filter(|ty| *ty != "BOOL").count()
    };
    match work.is_empty() {
        true => types(whole) < 2 || types(program) > 1,
        false => work.into_iter().all(|operation| kept.contains(operation)),
    }
}

/// Returns whether a minus stands before a literal with a type.
fn has_signed_literal(tokens: &[Token<'_>]) -> bool {
    let mut pairs = tokens.windows(2);
    pairs.any(|pair| pair[0].text == "-" && pair[1].kind == TokenKind::Typed)
}

/// Returns whether an engine says that it could not read a program.
fn is_unread(got: &[Fact]) -> bool {
    let told = got.iter().find_map(Fact::diagnostic);
    told.and_then(|told| told.code.as_deref())
        .is_some_and(|code| code.starts_with("P0"))
}

fn rejected(reason: &str, at: &str) -> String {
    format!("rejected {reason} {at}")
}

/// A small program with the line that matters.
struct Program<'p> {
    tokens: Vec<Token<'p>>,
    /// The names that the program declares.
    own: BTreeSet<String>,
    /// The number of the line at which the expected or the actual diagnostic stands.
    line: Option<u32>,
    /// Whether the engine could not read the program.
    is_unread: bool,
    /// The literals that the engine takes alone.
    innocent: &'p [String],
}

impl<'p> Program<'p> {
    fn new(normal: &'p Normal) -> Program<'p> {
        let deviation = &normal.deviation;
        let is_placed = |line: &u32| *line > 1;
        let line = |facts: &[Fact]| {
            facts
                .iter()
                .find_map(|fact| fact.diagnostic()?.line)
                .filter(is_placed)
        };
        let tokens = tokens(&normal.program);
        Program {
            own: own_functions(&tokens),
            tokens,
            line: line(&deviation.got).or_else(|| line(&deviation.expected)),
            is_unread: is_unread(&deviation.got),
            innocent: &normal.innocent,
        }
    }

    /// Returns the tokens of the line that matters; of the whole program where no line is known.
    fn of_line(&self) -> Vec<Token<'p>> {
        let on_line = |token: &&Token<'p>| self.line.is_none_or(|line| token.line == line);
        let found: Vec<Token<'p>> = self.tokens.iter().filter(on_line).copied().collect();
        // Some compilers name the line behind the mistake, or one of a file of their own.
        match found.iter().any(|token| token.kind != TokenKind::Sign) {
            true => found,
            false => self.tokens.clone(),
        }
    }

    /// Returns the features of a mistake that is accepted: the operators of its line, what it assigns, or the kinds of its operands.
    /// Whatever the operator is, checking the types around it is one piece of work; and where nothing is checked, the value does not
    /// matter.
    fn of_mistake(&self, is_unchecked: bool) -> BTreeSet<String> {
        let line = self.of_line();
        let as_one = |operation: String| match operation.as_str() {
            "arithmetic" | "power" | "comparison" | "bitwise operator" => "operator".to_owned(),
            "call" if self.calls_block(&line) => "call of a block".to_owned(),
            _ => operation,
        };
        let mut features: BTreeSet<String> = operations(&line, &self.own).into_iter().map(as_one).collect();
        if is_unchecked {
            features.remove("subscript or list");
            features.extend(self.target(&line).map(str::to_owned));
        }
        if features.is_empty() {
            let value = line.iter().rfind(|token| token.kind != TokenKind::Sign);
            let is_untyped =
                value.is_some_and(|value| matches!(value.kind, TokenKind::Number | TokenKind::Text));
            // Where a literal stands is told by the code, if it matters at all.
            features.insert(match is_untyped && !is_unchecked {
                true => LITERAL.to_owned(),
                false => self.place().to_owned(),
            });
        }
        features
    }

    /// Returns where the line that matters stands.
    fn place(&self) -> &'static str {
        place_of(&self.tokens, self.line)
    }

    /// Returns whether a line calls an instance of a function block.
    fn calls_block(&self, line: &[Token<'_>]) -> bool {
        let names = Names::new(&self.tokens);
        let mut pairs = line.windows(2);
        pairs.any(|pair| {
            let ty = names.words.get(&pair[0].text.to_ascii_uppercase());
            pair[1].text == "(" && ty.is_some_and(|ty| is_block(&self.tokens, ty))
        })
    }

    /// Returns the kind of variable that a line assigns, unless that is a plain one.
    fn target(&self, line: &[Token<'_>]) -> Option<&'static str> {
        let sign = line.iter().position(|token| token.text == ":=")?;
        let end = path(line, 0)?;
        let mut heads = self.tokens.windows(2);
        let is_result = heads.any(|pair| pair[0].is("FUNCTION") && pair[1].is(line[0].text));
        match end {
            1 if sign == 1 && is_result => Some("result of a function"),
            end if end > 1 && end == sign => Some("field or element"),
            _ => None,
        }
    }

    /// Returns the features of a program of which something is not implemented: the kinds of the variables on its line, and whether
    /// that stands in a program or in another unit, which has its variables elsewhere; without such variables, the operations.
    fn of_missing(&self, normal: &Normal) -> BTreeSet<String> {
        let program = normal.program.as_str();
        let text = unimplemented(program, &normal.deviation.got);
        let line = tokens(text);
        let all = &self.tokens;
        let names = Names::new(all);
        let kinds = line.iter().filter_map(|token| {
            let ty = names.words.get(&token.text.to_ascii_uppercase())?;
            let declared = all
                .windows(3)
                .find(|three| three[0].is(ty) && three[1].text == ":");
            let ty = declared
                .map_or(ty.as_str(), |three| three[2].text)
                .to_ascii_uppercase();
            Some(match ty.split(' ').next()? {
                "ARRAY" => "array",
                "STRUCT" => "structure",
                _ if is_block(all, &ty) => "instance of a function block",
                _ => return None,
            })
        });
        let mut features: BTreeSet<String> = kinds.map(str::to_owned).collect();
        if features.is_empty() {
            features = operations(&line, &self.own);
            if features.is_empty() {
                features.insert("statement".to_owned());
            }
            return features;
        }
        let place = text.as_ptr() as usize - program.as_ptr() as usize;
        let is_program = program[..place].rfind("PROGRAM ").is_some_and(|head| {
            let others = ["END_FUNCTION", "END_PROGRAM"];
            others.iter().all(|end| !program[head + 1..place].contains(end))
        });
        features.extend((!is_program).then(|| "function or function block".to_owned()));
        if is_program {
            features.extend(
                operations(&line, &self.own)
                    .into_iter()
                    .filter(|one| one == "bit access"),
            );
        }
        features
    }

    /// Returns the features of a program that stops, or does not stop, with a fault.
    fn of_fault(&self) -> BTreeSet<String> {
        let mut features = operations(&self.tokens, &self.own);
        features.remove("call");
        features
    }

    /// Returns the features of a program that is rejected wrongly: those of the line, and, where the engine could read the
    /// program, the kinds of declarations.
    fn of_rejection(&self) -> BTreeSet<String> {
        let line = self.of_line();
        let mut features = operations(&line, &self.own);
        let mut literals: Vec<String> = self.special_literals(&line);
        literals.extend(self.signed_literal(&line));
        // A literal that the engine does not know is not known anywhere, and a function is not known to a parser anywhere.
        if literals.is_empty() && !(self.is_unread && self.calls_library(&line)) {
            features.insert(self.place().to_owned());
        }
        features.extend(literals);
        let by_name = line
            .windows(2)
            .any(|pair| pair[0].text == ":=" && pair[1].kind == TokenKind::Word);
        if by_name && features.contains("declaration") {
            features.insert("initial value by name".to_owned());
        }
        if !self.is_unread {
            features.extend(declarations(&self.tokens));
        }
        features
    }

    /// Returns whether a function is called that the program does not declare.
    fn calls_library(&self, tokens: &[Token<'_>]) -> bool {
        let mut pairs = tokens.windows(2);
        pairs.any(|pair| {
            pair[0].kind == TokenKind::Word
                && pair[1].text == "("
                && !self.own.contains(&pair[0].text.to_ascii_uppercase())
        })
    }

    /// Returns the form of a typed number with its sign behind the `#`, where one is not known to be taken by the engine.
    fn signed_literal(&self, tokens: &[Token<'_>]) -> Option<String> {
        let is_signed = |token: &Token<'_>| {
            token.kind == TokenKind::Typed && token.text.contains("#-") && special_literal(token).is_none()
        };
        let is_innocent =
            |token: &Token<'_>| self.innocent.iter().any(|literal| literal.as_str() == token.text);
        let mut signed = tokens.iter().filter(|token| is_signed(token));
        signed
            .any(|token| !is_innocent(token))
            .then(|| "typed literal with a sign".to_owned())
    }

    /// Returns the forms of those literals that are not known to be taken by the engine.
    fn special_literals(&self, tokens: &[Token<'_>]) -> Vec<String> {
        let is_innocent =
            |token: &&Token<'_>| self.innocent.iter().any(|literal| literal.as_str() == token.text);
        let suspects = tokens.iter().filter(|token| !is_innocent(token));
        suspects.filter_map(special_literal).collect()
    }

    /// Returns whether the engine could read the program, and the line that matters has a literal of a form that it may not know.
    fn has_special_literal(&self) -> bool {
        !self.is_unread && !self.special_literals(&self.of_line()).is_empty()
    }

    fn has_initial_value(&self) -> bool {
        let declared = in_declarations(&self.tokens);
        let mut pairs = self.tokens.iter().zip(declared);
        pairs.any(|(token, declared)| declared && token.text == ":=")
    }

    /// Returns the features of a program that computes a wrong value, and whether it converts between types.
    fn of_value(&self) -> (BTreeSet<String>, bool) {
        let mut features = operations(&self.tokens, &self.own);
        features.remove("call");
        let types: BTreeSet<ElementaryType> = self.tokens.iter().filter_map(type_of_token).collect();
        let kinds: BTreeSet<&str> = types.iter().filter_map(|ty| kind(*ty)).collect();
        let numbers = types.iter().filter(|ty| kind(**ty).is_some()).count();
        if numbers > 1 {
            let kinds: Vec<&str> = kinds.into_iter().collect();
            features.insert(format!("conversion {}", kinds.join(" and ")));
            return (features, true);
        }
        features.extend(self.special_literals(&self.tokens));
        features.extend(declarations(&self.tokens));
        if operations(&self.tokens, &self.own).is_empty() {
            let place = if self.has_initial_value() {
                "initial value"
            } else {
                "assigned value"
            };
            features.insert(place.to_owned());
            if declarations(&self.tokens).is_empty() {
                features.extend(kinds.into_iter().map(str::to_owned));
            }
        }
        (features, false)
    }
}

/// Returns the type that a token names, as a word or as the prefix of a literal.
fn type_of_token(token: &Token<'_>) -> Option<ElementaryType> {
    let upper = token.text.to_ascii_uppercase();
    match token.kind {
        TokenKind::Word => ElementaryType::from_name(&upper),
        TokenKind::Typed => ElementaryType::from_literal_prefix(upper.split_once('#')?.0),
        _ => None,
    }
}

/// Returns the kind of values between which conversions are one piece of work in a compiler; `None` for BOOL, which is the
/// type of comparisons too.
const fn kind(ty: ElementaryType) -> Option<&'static str> {
    Some(match ty.family() {
        Family::Boolean => return None,
        Family::Signed | Family::Unsigned | Family::BitString => "integer",
        Family::Real => "real",
        Family::Duration => "duration",
        Family::Date | Family::TimeOfDay | Family::DateAndTime => "date or time",
        Family::Text | Family::Character => "text",
    })
}

/// Returns where a line stands.
fn place_of(tokens: &[Token<'_>], line: Option<u32>) -> &'static str {
    let before = tokens
        .iter()
        .take_while(|token| line.is_none_or(|line| token.line < line));
    let mut place = "statement";
    for token in before.filter(|token| token.kind == TokenKind::Word) {
        let upper = token.text.to_ascii_uppercase();
        place = match upper.as_str() {
            "TYPE" => "type",
            "END_TYPE" | "END_VAR" => "statement",
            _ if upper == "VAR" || upper.starts_with("VAR_") => "declaration",
            _ => place,
        };
    }
    place
}

/// Returns the form of a literal that a compiler may not know; plain numbers and truth values are none.
fn special_literal(token: &Token<'_>) -> Option<String> {
    let upper = token.text.to_ascii_uppercase();
    match token.kind {
        TokenKind::Number => Some(number(&upper)).filter(|form| !matches!(form.as_str(), "integer" | "real")),
        TokenKind::Text => Some(text(token.text)).filter(|form| form != "'text'"),
        TokenKind::Typed => {
            let (prefix, value) = upper.split_once('#')?;
            let is_number = type_of_token(token)
                .is_some_and(|ty| kind(ty).is_some_and(|kind| matches!(kind, "integer" | "real")));
            let form = number(value.trim_start_matches('-'));
            match is_number {
                true => Some(form).filter(|form| form == "real-beyond-REAL"),
                // Dates and times of day are read by one piece of work.
                false => match type_of_token(token) {
                    Some(ty) if kind(ty) == Some("date or time") => Some("date or time#".to_owned()),
                    Some(ty) => Some(format!("{}#", ty.name())),
                    None => Some(format!("{prefix}#")),
                },
            }
        }
        _ => None,
    }
}

/// Returns the kinds of declarations in a program, without those that every program has.
fn declarations(tokens: &[Token<'_>]) -> BTreeSet<String> {
    let words: BTreeSet<String> = tokens
        .iter()
        .map(|token| token.text.to_ascii_uppercase())
        .collect();
    let special = [
        "STRUCT",
        "ARRAY",
        "FUNCTION",
        "FUNCTION_BLOCK",
        "VAR_IN_OUT",
        "VAR_OUTPUT",
        "VAR_EXTERNAL",
        "VAR_GLOBAL",
        "VAR_TEMP",
        "CONSTANT",
        "RETAIN",
        "CONFIGURATION",
    ];
    let found = special.iter().filter(|word| words.contains(**word));
    let mut found: BTreeSet<String> = found.map(|word| (*word).to_owned()).collect();
    let is_composed = found.contains("STRUCT") || found.contains("ARRAY");
    if words.contains("TYPE") && !is_composed {
        found.insert("type of one's own".to_owned());
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::question::Deviation;
    use crate::sign::Sign;
    use crate::title::title;
    use stickler_run::{Grade, Reduced, Verdict};

    /// Returns what an engine made of a program that it rejects on this line with this code.
    fn rejected(program: &str, line: u32, code: &str) -> Smallest {
        let told = Diagnostic {
            line: Some(line),
            code: Some(code.to_owned()),
            message: "no".to_owned(),
            ..Diagnostic::default()
        };
        let (expected, got) = (vec![Fact::Accepted], vec![Fact::Diagnostic(told)]);
        Smallest {
            program: program.to_owned(),
            deviation: Deviation {
                sign: Sign::of(program, Verdict::Fail, (&expected, &got), Grade::Line),
                expected,
                got,
            },
            reduction: Reduced::Smallest,
            flaky: None,
            questions: 0,
        }
    }

    #[test]
    fn a_typed_literal_with_a_sign_is_one_cause_wherever_it_stands() {
        let initial = rejected(
            "PROGRAM p\nVAR\nx : INT := INT#-5;\nEND_VAR\nx := x;\nEND_PROGRAM\n",
            3,
            "P0002",
        );
        let assigned = rejected(
            "PROGRAM p\nVAR\nx : DINT;\nEND_VAR\nx := DINT#-7;\nEND_PROGRAM\n",
            5,
            "P0002",
        );
        let essence = |smallest: &Smallest| Essence::of(smallest, &Normal::unasked(smallest));
        assert!(essence(&initial).explains(&essence(&assigned)));
        assert_eq!(essence(&initial).construct(), "typed literal with a sign");
        assert!(title(&initial, true).ends_with("is rejected: P0002 no"));
        assert!(
            title(&initial, false).ends_with("is rejected: no"),
            "the code is its adapter's"
        );
        // The engine takes the literal alone.
        let innocent = Normal {
            innocent: vec!["INT#-5".to_owned()],
            ..Normal::unasked(&initial)
        };
        assert_eq!(Essence::of(&initial, &innocent).construct(), "declaration");
    }

    #[test]
    fn a_literal_that_is_not_known_is_one_cause_whatever_is_said_of_its_place() {
        let said = |program: &str, line: u32, message: &str| {
            let mut smallest = rejected(program, line, "P0");
            let told = Diagnostic {
                line: Some(line),
                message: message.to_owned(),
                ..Diagnostic::default()
            };
            let (expected, got) = (vec![Fact::Accepted], vec![Fact::Diagnostic(told)]);
            let sign = Sign::of(program, Verdict::Fail, (&expected, &got), Grade::Line);
            smallest.deviation = Deviation { sign, expected, got };
            Essence::of(&smallest, &Normal::unasked(&smallest))
        };
        let initial = "PROGRAM p\nVAR\nx : LREAL := 1.0E308;\nEND_VAR\nx := x;\nEND_PROGRAM\n";
        let assigned = "PROGRAM p\nVAR\nx : LREAL;\nEND_VAR\nx := 1.0E308;\nEND_PROGRAM\n";
        let of_initial = said(initial, 3, "initial value has another type");
        assert!(said(assigned, 5, "types do not fit").explains(&of_initial));
        assert!(!said(&assigned.replace("E308", ""), 5, "types do not fit").explains(&of_initial));
    }

    #[test]
    fn a_function_that_a_parser_does_not_know_is_one_cause_whatever_it_is_given() {
        let given = |declared: &str, operand: &str| {
            let program = format!(
                "PROGRAM p\nVAR\n{declared} x : DT;\nEND_VAR\nx := DATE_TO_DT({operand});\nEND_PROGRAM\n"
            );
            let smallest = rejected(&program, 5, "P0002");
            Essence::of(&smallest, &Normal::unasked(&smallest))
        };
        let variable = given("d : DATE;", "d");
        assert!(variable.explains(&given("", "DATE#2024-03-01")));
        assert_eq!(variable.construct(), "date_TO_dateandtime");
    }

    #[test]
    fn a_claim_about_a_value_says_nothing_of_a_program_that_cannot_be_read() {
        let program = "PROGRAM p\nVAR\nx : INT := INT#-5;\nEND_VAR\nx := x;\nEND_PROGRAM\n";
        let keeps = |expected: Fact, code: &str| {
            let smallest = rejected(program, 5, code);
            let case = CaseEvent {
                id: "a".to_owned(),
                dialect: "matiec".to_owned(),
                engine: "e".to_owned(),
                verdict: Verdict::Fail,
                open: false,
                grade: None,
                basis: "document: a".to_owned(),
                file: "a.toml".to_owned(),
                line: None,
                area: "a".to_owned(),
                title: "t".to_owned(),
                expectation: 0,
                expected: vec![expected],
                got: smallest.deviation.got.clone(),
                duration_us: 0,
                observations: Vec::new(),
                program: Some(program.to_owned()),
                baseline: None,
            };
            keeps_claim(&case, &smallest)
        };
        let value = || Fact::Value {
            name: "x".to_owned(),
            value: stickler_types::Value::plain(ElementaryType::Int, 65531),
        };
        assert!(!keeps(value(), "P0002"));
        assert!(keeps(value(), "P4035"));
        assert!(keeps(Fact::Accepted, "P0002"));
    }
}
