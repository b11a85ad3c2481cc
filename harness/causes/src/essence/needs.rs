//! The work of a compiler that a deviation needs, by its kind: the symptom by which causes are told apart, and the constructs at fault.

use super::{
    ACCEPTED, INCOMPLETE, INSTANCE_IN_OTHER_UNIT, LITERAL_WITHOUT_PLACE, PARTS_IN_OTHER_UNIT,
    UNKNOWN_FUNCTION, divides_wrongly, words,
};
use crate::compiler_place::compiler_place;
use crate::failure_sign::{Sign, has_lost_place, is_of_reading, work_of};
use crate::line_features::{IN_OTHER_UNIT, INSTANCE, LINE_PLACES, LITERAL, ProgramAndLine, lacked_function};
use crate::normal_form::{NUMBERS_PLACELESS, Normal};
use crate::question::Deviation;
use crate::reduction::Smallest;
use crate::value_lines::shows_initial_value;
use crate::words::elementary;
use std::collections::BTreeSet;
use stickler_run::{Fact, Symptom};
use stickler_types::Code;

/// The features of variables that have fields or elements.
const WITH_PARTS: [&str; 3] = ["array", "array of structures", "structure"];

/// Returns the symptom of a deviation, the features that it needs, and whether a program with more of them shows the same defect.
pub(super) fn needs(
    line: &ProgramAndLine<'_, '_>,
    sign: &Sign,
    smallest: &Smallest,
    (normal, is_unchecked): (&Normal, bool),
) -> (String, BTreeSet<String>, bool) {
    let symptom = sign.word();
    let got = &normal.deviation.got[..];
    match &sign.symptom {
        Symptom::NotRejected(code) => {
            let features = of_accepted(line, code, is_unchecked);
            // A place alone is in every program.
            let names_construct = !features
                .iter()
                .any(|feature| LINE_PLACES.contains(&feature.as_str()));
            // Where nothing is checked, it does not matter what is not checked.
            let symptom = match is_unchecked {
                true => ACCEPTED.to_owned(),
                false => format!("{ACCEPTED} {code}"),
            };
            // That what is passed can be written says also that it is a variable.
            if is_one_of(
                code,
                &[Code::FunctionCallInOutArgNotVariable, Code::InOutArgNotWritable],
            ) {
                return (format!("{ACCEPTED} in-out argument"), features, names_construct);
            }
            // What has the name of another element of the library is found in one table.
            let is_doubled = is_one_of(
                code,
                &[
                    Code::TypeDeclNameDuplicated,
                    Code::PouDeclNameDuplicated,
                    Code::FunctionDeclNameDuplicated,
                ],
            );
            if is_doubled {
                return (format!("{ACCEPTED} doubled name"), BTreeSet::new(), false);
            }
            (symptom, features, names_construct)
        }
        // Which function is not there, and what it is for, does not matter. A linker may lack it for the types of its arguments alone.
        Symptom::Unusable(words)
            if words.contains("cannot be linked") && lacked_function(line.program, got).is_some() =>
        {
            ("function that is not linked".to_owned(), BTreeSet::new(), false)
        }
        Symptom::Rejected(_) | Symptom::Unusable(_) if lacked_function(line.program, got).is_some() => {
            (UNKNOWN_FUNCTION.to_owned(), BTreeSet::new(), false)
        }
        // What the engine says of a literal depends on the place where it stands.
        Symptom::Rejected(reason) if line.size_of_integers().is_some() => {
            let (symptom, features) = rejection(line, reason, &sign.at, got);
            (symptom, features, true)
        }
        Symptom::Rejected(_) if line.has_special_literal() => {
            ("rejected literal".to_owned(), line.of_rejection(), true)
        }
        // What a compiler says of itself that it does not do is done there, whatever needs it.
        Symptom::Rejected(reason) if says_unsupported(reason) => {
            (rejected(line, reason, ""), BTreeSet::new(), false)
        }
        // A variable that is not known is so whatever is done with it.
        Symptom::Rejected(reason)
            if says(&normal.deviation.got, Code::VariableUndefined)
                && !line.special_sections().is_empty() =>
        {
            (rejected(line, reason, ""), line.special_sections(), true)
        }
        Symptom::Rejected(reason) => {
            let (symptom, features) = rejection(line, reason, &sign.at, got);
            (symptom, features, true)
        }
        Symptom::NotImplemented(words) => {
            // What is missing at one place of a compiler is put right there, whatever needs it.
            let mut features = line.of_missing(got);
            if let Some(place) = compiler_place(got) {
                // A FUNCTION or a block that has no variables with parts has none whichever part is asked for.
                if features.remove(IN_OTHER_UNIT) {
                    let has_parts = features.iter().any(|one| WITH_PARTS.contains(&&**one));
                    let missing = match features.contains(INSTANCE) {
                        _ if has_parts => Some(PARTS_IN_OTHER_UNIT),
                        true => Some(INSTANCE_IN_OTHER_UNIT),
                        false => None,
                    };
                    if let Some(missing) = missing {
                        return (missing.to_owned(), BTreeSet::new(), false);
                    }
                }
                return (format!("not implemented at {place}"), BTreeSet::new(), false);
            }
            (format!("not implemented {words}"), features, true)
        }
        Symptom::OtherCode { code, reported } => {
            // The kind of value does not matter for what else is said.
            let mut features = line.of_mistake(false);
            // A literal that is too large to be read is that in every place.
            features.remove("operator");
            if code == Code::ConstantOverflow.as_str() && is_of_reading(reported) {
                features = words(["literal"]);
            } else if features.remove(LITERAL) || features.is_empty() {
                features.insert(line.place().to_owned());
            }
            (format!("{code} as {reported}"), features, false)
        }
        Symptom::Value | Symptom::Missing => {
            let is_initial = shows_initial_value(&smallest.program, &smallest.deviation);
            let (features, converts) = line.of_value(is_initial);
            // Whatever is computed beside it, a conversion by name is wrong by itself.
            let is_by_name = features.iter().any(|feature| feature.contains("_TO_"));
            // A condition may stand around anything.
            let names_construct = features.iter().any(|feature| feature != "condition");
            (
                sign.symptom.word(),
                features,
                (!converts || is_by_name) && names_construct,
            )
        }
        Symptom::Fault(_) if divides_wrongly(line, sign) => {
            (Symptom::Value.word(), line.of_value(false).0, false)
        }
        // Whatever stops a program, an engine has its line or has none.
        Symptom::FaultLine(_) if matches!(normal.deviation.got[..], [Fact::Fault { line: None, .. }, ..]) => {
            ("fault without a line".to_owned(), BTreeSet::new(), false)
        }
        // What is not checked when a program runs is not checked, whatever the program does.
        Symptom::NotFaulted(_) => (symptom, BTreeSet::new(), false),
        Symptom::Fault(_) | Symptom::FaultLine(_) => (symptom, line.of_fault(), false),
        Symptom::Hang => (symptom, line.loops(), false),
        Symptom::Crash(words) | Symptom::Unusable(words) => {
            let is_unusable = matches!(sign.symptom, Symptom::Unusable(_));
            // Where in its own source a compiler fails says more than its words.
            if let Some(place) = compiler_place(got) {
                return (format!("crash at {place}"), BTreeSet::new(), false);
            }
            // What a compiler of C says of a header that was written for it depends on what follows.
            let symptom = match unusable_header(got) {
                Some(header) => format!("unusable {header}"),
                // What it says of a global variable depends on what is done with it.
                None if is_unusable && line.uses_external() => {
                    let mut features = line.of_use();
                    features.insert("VAR_EXTERNAL".to_owned());
                    return ("unusable".to_owned(), features, true);
                }
                // What a compiler of C says of declarations, of which no statement does anything, it says whatever they are.
                None if words.contains("error:") && work_of(&normal.program).is_empty() => unusable(words),
                // What it says of one function it says of every other.
                None if is_unusable => {
                    let features = line.of_use();
                    let names_construct = !features.is_empty();
                    return (unusable(words), features, names_construct);
                }
                // What is dumped behind a sign of equality is of the program.
                None if words.split(' ').count() > 3 => {
                    let said = words.split(" = ").next().unwrap_or_default();
                    format!("crash {said}")
                }
                None => return (symptom, BTreeSet::from([sign.shape(&normal.program)]), false),
            };
            (symptom, BTreeSet::new(), false)
        }
        // Whatever an engine without places says, it says where by one piece of work; elsewhere what is said of one construct has a place by
        // one.
        Symptom::NoPlace(_) if normal.way.is_some_and(|way| way != NUMBERS_PLACELESS) => {
            ("no place".to_owned(), BTreeSet::new(), false)
        }
        // What is told once more without a place is what has lost its place elsewhere.
        Symptom::Surplus(reported) if has_lost_place(got) => {
            (format!("no place {reported}"), line.partial_accesses(), false)
        }
        // What is told of a line beside its mistake is told whatever the mistake is.
        Symptom::Surplus(_) if tells_more_of_line(normal) => (symptom, BTreeSet::new(), false),
        // What is wrong with a number has the place of the number.
        Symptom::NoPlace(code) => {
            let of_number = [
                Code::ConstantOverflow,
                Code::BitStringCaseLabelNotAllowed,
                Code::BitAccessOutOfRange,
            ];
            let is_of_number = normal.way.is_some() || is_one_of(code, &of_number);
            let symptom = match is_of_number {
                true => LITERAL_WITHOUT_PLACE.to_owned(),
                false => format!("no place {code}"),
            };
            (symptom, line.partial_accesses(), false)
        }
        Symptom::Text | Symptom::OtherType | Symptom::Error(_) => (symptom, BTreeSet::new(), false),
        // What ends at one mistake says nothing of others, whatever they are.
        Symptom::Incomplete(_) => (INCOMPLETE.to_owned(), BTreeSet::new(), false),
        Symptom::OtherLine(_) => (symptom, line.of_mistake(false), false),
        _ => (symptom, BTreeSet::from([sign.shape(&normal.program)]), false),
    }
}

/// Returns the symptom of a program of which an engine makes what a compiler of C does not take, whatever that proposes.
pub(super) fn unusable(words: &str) -> String {
    format!("unusable {}", words.split(';').next().unwrap_or_default())
}

/// Returns whether an engine reports a mistake, and nothing of another line.
fn tells_more_of_line(normal: &Normal) -> bool {
    let Deviation { expected, got, .. } = &normal.deviation;
    let lines = |facts: &[Fact]| -> BTreeSet<Option<u32>> {
        facts
            .iter()
            .filter_map(|fact| Some(fact.diagnostic()?.line))
            .collect()
    };
    lines(expected) == lines(got)
}

/// Returns the features of a mistake with a code that is accepted.
fn of_accepted(line: &ProgramAndLine<'_, '_>, code: &str, is_unchecked: bool) -> BTreeSet<String> {
    let mut features = line.of_mistake(is_unchecked);
    // What is assigned to a constant, or to a part of one, does not matter.
    if code == Code::AssignmentToConstant.as_str() {
        features.remove(LITERAL);
        features.insert("constant".to_owned());
    }
    // Which function is not declared does not matter.
    if code == Code::FunctionCallUndeclared.as_str() {
        features = words(["call"]);
    }
    // Whether a variable or a part that does not exist is read or assigned does not matter.
    if code == Code::VariableUndefined.as_str() {
        features.retain(|feature| feature != LITERAL && !LINE_PLACES.contains(&feature.as_str()));
        let what = if line.has_part() {
            "part of a variable"
        } else {
            "variable"
        };
        features.insert(what.to_owned());
    }
    // In which base a number is written does not matter for its size.
    if code == Code::ConstantOverflow.as_str() && features.remove("OCTAL-LITERAL") && features.is_empty() {
        features.insert(LITERAL.to_owned());
    }
    let forms = line.forms_of_literals();
    if is_of_reading(code) && !forms.is_empty() {
        // Where it stands does not matter.
        features.retain(|feature| feature != LITERAL && !LINE_PLACES.contains(&feature.as_str()));
        features.extend(forms);
    }
    features
}

/// Returns the name of the header that the engine wrote and a C compiler cannot read; `None` where it cannot read another file.
fn unusable_header(got: &[Fact]) -> Option<&str> {
    let file = got.iter().find_map(|fact| match fact {
        Fact::Unusable { reason } => reason.split_once(':').map(|(file, _)| file),
        _ => None,
    });
    file.filter(|file| file.ends_with(".h"))
}

/// Returns whether an engine reports a code that Stickler knows.
fn says(got: &[Fact], code: Code) -> bool {
    let mut codes = got.iter().filter_map(|fact| fact.diagnostic()?.registered_code());
    codes.any(|said| said == code)
}

/// Returns whether a code is one of some.
fn is_one_of(code: &str, codes: &[Code]) -> bool {
    codes.iter().any(|one| one.as_str() == code)
}

/// Returns whether the words of a rejection say what the compiler does not support.
fn says_unsupported(reason: &str) -> bool {
    (reason.contains("unsupported ") || reason.contains("not supported")) && reason.split(' ').count() > 2
}

/// Returns the symptom and the features of a program that is rejected although nothing is wrong with it. An integer that is too large is
/// that in every form and every place.
pub(super) fn rejection(
    line: &ProgramAndLine<'_, '_>,
    reason: &str,
    at: &str,
    got: &[Fact],
) -> (String, BTreeSet<String>) {
    match line.size_of_integers() {
        Some(size) => ("rejected literal".to_owned(), words([size])),
        // Each standard function has parameters of its own, whose types matter to no other.
        None if says(got, Code::FunctionCallArgTypeMismatch) && line.calls_standard() => {
            (rejected(line, reason, ""), line.standard_calls())
        }
        None => (rejected(line, reason, at), line.of_rejection()),
    }
}

/// Returns the symptom of a rejection, whichever elementary types and names of the program its reason has. A name with a digit is none of its
/// words already.
fn rejected(line: &ProgramAndLine<'_, '_>, reason: &str, at: &str) -> String {
    let parts = reason.split([' ', '_']).filter(|part| !line.names(part));
    let parts = parts.map(|part| elementary(part).map_or(part, |_| "type"));
    let parts: Vec<&str> = parts.filter(|part| !part.is_empty()).collect();
    format!("rejected {} {at}", parts.join(" "))
}
