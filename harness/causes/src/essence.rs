//! The essence of a cause: what of its smallest program matters for the defect, without the place where it happens to stand.
//!
//! Two small programs show one defect where the engine does the same with the same construct. Which construct it is follows
//! from the kind of deviation: the line that is accepted or rejected wrongly, or, of a wrong value, the conversion that the
//! program contains; without a conversion, everything by which the program differs from an assignment.

use crate::alone::is_loop_alone;
use crate::compiler_place::compiler_place;
use crate::failure_sign::{Sign, differing_lines, has_lost_place, is_of_reading, work_of};
use crate::line_features::{
    DERIVED, IN_OTHER_UNIT, IN_STATEMENTS, INSTANCE, LINE_PLACES, LITERAL, ProgramAndLine, lacked_function,
};
use crate::loop_limits::{TO_LAST_VALUE, loop_beyond_limit};
use crate::malformed::{SIZES, is_beyond_type};
use crate::normal_form::{NUMBERS_PLACELESS, Normal, is_whatever_comes};
use crate::patterns::{BITS_OF_LREAL, UNREAD_ESCAPES, has_first_bit, number_pattern};
use crate::plainness::value_features;
use crate::program::{Program, ReadProgram};
use crate::question::{Deviation, wrong_values};
use crate::reduction::Smallest;
use crate::value_lines::shows_initial_value;
use crate::words::{elementary, valued_types};
use std::collections::BTreeSet;
use stickler_run::{Fact, Grade, Symptom, Verdict};
use stickler_types::{Code, Fault};

/// The feature of a place where a value of every type is accepted.
const UNCHECKED: &str = "unchecked";

/// The beginning of the symptom of a mistake that is accepted.
const ACCEPTED: &str = "accepted";

/// The symptom of a mistake that is not reported beside others.
const INCOMPLETE: &str = "incomplete";

/// The symptom of a mistake in a literal that is told without its place.
const LITERAL_WITHOUT_PLACE: &str = "no place number";

/// The symptom of a function of the library that an engine does not have.
pub(crate) const UNKNOWN_FUNCTION: &str = "function that is not there";

/// The feature of a literal that its own type does not hold.
pub(crate) const BEYOND_TYPE: &str = "typed literal beyond its type";

/// The words about variables with fields or elements that a compiler has in a PROGRAM only.
const PARTS_IN_OTHER_UNIT: &str = "variable with fields or elements in a FUNCTION or FUNCTION_BLOCK";
/// The words about instances of function blocks that a compiler has in a PROGRAM only.
const INSTANCE_IN_OTHER_UNIT: &str = "instance of a function block in a FUNCTION or FUNCTION_BLOCK";
/// The words about what a compiler does not take in some units, whatever is done with it.
const MISSING_THERE: [&str; 2] = [PARTS_IN_OTHER_UNIT, INSTANCE_IN_OTHER_UNIT];
/// The features of variables that have fields or elements.
const WITH_PARTS: [&str; 3] = ["array", "array of structures", "structure"];

/// The features of a mistake of which the value is computed.
const COMPUTING: [&str; 2] = ["operator", "conversion function"];

/// The properties that small programs with the same defect have in common.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Essence {
    /// The behaviour of the engine; causes with different symptoms are different.
    pub(crate) symptom: String,
    /// The constructs that the defect needs.
    pub(crate) constructs: BTreeSet<String>,
    /// The properties of values and types that it needs; a cause that needs fewer of them explains one that needs more.
    pub(crate) labels: BTreeSet<String>,
    /// Whether a program with more features of the same symptom shows the same defect: it contains what already fails alone.
    pub(crate) is_contained: bool,
    /// The symptom and the constructs of a valid program that is rejected for the same reason, for one that is rejected for the
    /// wrong reason.
    pub(crate) hidden: Option<(String, BTreeSet<String>)>,
    /// The words by which a title begins, where a wrong value or a lost place tells what decides, whichever program shows it.
    pub(crate) pattern: Option<&'static str>,
}

impl Essence {
    /// Returns the essence of a program that was made small, by its normal form.
    pub(crate) fn of(smallest: &Smallest, normal: &Normal) -> Essence {
        let program = Program::new(&normal.program);
        let read = program.read();
        let line = ProgramAndLine::new(&read, normal);
        let sign = &normal.deviation.sign;
        // What fails whatever the values are.
        let pattern = match sign.symptom {
            _ if normal.way.is_some_and(is_whatever_comes) => normal.way,
            Symptom::Unusable(_) => normal.way,
            Symptom::Value if begins_in_block(&read, normal) => Some("initial value in a FUNCTION_BLOCK"),
            Symptom::Value if is_loop_alone(&normal.program) => Some("FOR loop to its first value"),
            // A loop that never ends counts on.
            Symptom::Hang if loop_beyond_limit(&read).is_some() => Some(TO_LAST_VALUE),
            Symptom::Value => line
                .lost_value_of_type(&normal.deviation)
                .or(normal.way)
                .or_else(|| number_pattern(&read, &normal.deviation)),
            _ => None,
        };
        let is_value = match sign.symptom {
            Symptom::Value | Symptom::Missing => true,
            _ => divides_wrongly(&line, sign),
        };
        let is_beyond = sign.symptom == Symptom::NotRejected(Code::ConstantOverflow.as_str().to_owned())
            && has_literal_beyond_type(&read);
        let is_unchecked = normal.is_unchecked() && !is_beyond && !line.passes_derived();
        let by_chance = if smallest.flaky.is_some() {
            "by chance: "
        } else {
            ""
        };
        let named = |symptom: &str| format!("{by_chance}{}", symptom.trim_end());
        let is_incomplete = matches!(sign.symptom, Symptom::Incomplete(_));
        let tells_way = sign.accepts() || is_incomplete || matches!(sign.symptom, Symptom::Fault(_));
        let (symptom, mut features, is_contained) = match pattern {
            Some(TO_LAST_VALUE) => (Symptom::Value.word(), words([TO_LAST_VALUE]), false),
            // What goes wrong with a value depends on its type.
            Some(way) if is_whatever_comes(way) => (way.to_owned(), BTreeSet::new(), false),
            // What a compiler of C says depends on what the operand is given to.
            Some(way) if matches!(sign.symptom, Symptom::Unusable(_)) => {
                ("unusable".to_owned(), words([way]), false)
            }
            Some(pattern) => (sign.symptom.word(), words([pattern]), false),
            None if let Some(way) = normal.way.filter(|_| tells_way) => {
                let symptom = match sign.accepts() {
                    true => ACCEPTED.to_owned(),
                    false if is_incomplete => INCOMPLETE.to_owned(),
                    false => sign.word(),
                };
                (symptom, words([way]), false)
            }
            None if is_beyond => (sign.symptom.word(), words([BEYOND_TYPE]), false),
            None => needs(&line, sign, smallest, (normal, is_unchecked)),
        };
        features.extend(is_unchecked.then(|| UNCHECKED.to_owned()));
        // Every program has statements.
        let hidden = hidden(&line, sign, normal);
        let hidden = hidden.filter(|(_, features)| features.iter().any(|feature| feature != IN_STATEMENTS));
        // Where such integers become LREALs, one that becomes zero is too large for the way back.
        let is_zero = pattern == Some(SIZES[1]);
        let hidden = hidden.or_else(|| is_zero.then(|| (Symptom::Value.word(), words([BITS_OF_LREAL]))));
        let mut labels = match is_value && pattern.is_none() {
            true => labels(&read),
            false => BTreeSet::new(),
        };
        // Bits of another number are those of the operator, whichever the types are.
        if features.contains("bitwise operator") {
            labels.retain(|label| elementary(label).is_none());
        }
        Essence {
            symptom: named(&symptom),
            pattern: pattern
                .or(normal.way.filter(|_| tells_way))
                .or((symptom == LITERAL_WITHOUT_PLACE).then_some("mistake in a literal"))
                .or((symptom == INCOMPLETE).then_some("mistakes beside others"))
                .or((symptom == UNKNOWN_FUNCTION).then_some(UNKNOWN_FUNCTION))
                .or_else(|| MISSING_THERE.into_iter().find(|missing| symptom == *missing)),
            constructs: features,
            labels,
            is_contained,
            hidden: hidden.map(|(symptom, features)| (named(&symptom), features)),
        }
    }

    /// Returns the constructs, values and types that the defect needs, as a key.
    pub(crate) fn construct(&self) -> String {
        let all = self.constructs.iter().chain(&self.labels);
        all.cloned().collect::<Vec<_>>().join(", ")
    }

    /// Returns whether values of quite other types are accepted in one place.
    pub(crate) fn is_unchecked(&self) -> bool {
        self.constructs.contains(UNCHECKED)
    }

    /// Returns whether a cause with this essence explains one with the essence `other`.
    pub(crate) fn explains(&self, other: &Essence) -> bool {
        // Where nothing is checked is more than where one mistake is not seen.
        let is_checked = |features: &BTreeSet<String>| !features.contains(UNCHECKED);
        let needs_no_more = |symptom: &str, features: &BTreeSet<String>| {
            // What an operator or a conversion gives has a type of its own, which may be what is not checked.
            let computes = |one: &String| !self.constructs.contains(one) && COMPUTING.contains(&one.as_str());
            let contains = self.is_contained
                && self.constructs.is_subset(features)
                && !(symptom.starts_with(ACCEPTED) && features.iter().any(computes))
                && is_checked(&self.constructs) == is_checked(features);
            let unchecked = || {
                let own = || self.constructs.iter().filter(|one| *one != UNCHECKED);
                // A place alone is in every program.
                let placed = |one: &&String| !LINE_PLACES.contains(&one.as_str());
                let is_place = own().next().is_some_and(|first| placed(&first))
                    && own().eq(features.iter().filter(placed));
                let is_computed = own().eq(features) && COMPUTING.iter().any(|one| features.contains(*one));
                self.is_unchecked() && symptom.starts_with(ACCEPTED) && (is_computed || is_place)
            };
            self.symptom == symptom && (self.constructs == *features || contains) || unchecked()
        };
        let is_same =
            needs_no_more(&other.symptom, &other.constructs) && self.labels.is_subset(&other.labels);
        let hidden = other.hidden.as_ref();
        is_same || hidden.is_some_and(|(symptom, features)| needs_no_more(symptom, features))
    }
}

/// Returns the symptom of a deviation, the features that it needs, and whether a program with more of them shows the same defect.
fn needs(
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
                None if words.split(' ').count() > 3 => format!("crash {words}"),
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
fn unusable(words: &str) -> String {
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

/// Returns whether the first wrong value is one that a variable of a function block begins with.
fn begins_in_block(program: &ReadProgram<'_, '_>, normal: &Normal) -> bool {
    let wrong = wrong_values(&normal.deviation.expected, &normal.deviation.got).next();
    let instance = wrong.and_then(|(name, _)| Some(name.split_once('.')?.0));
    instance.is_some_and(|name| program.is_instance(name))
        && shows_initial_value(&normal.program, &normal.deviation)
}

/// Returns whether a program divides by a value of another kind, which is taken for zero as it may be taken for another wrong value.
fn divides_wrongly(line: &ProgramAndLine<'_, '_>, sign: &Sign) -> bool {
    matches!(&sign.symptom, Symptom::Fault(fault) if fault == Fault::DivisionByZero.as_str())
        && line.mixes_kinds()
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

/// Returns the symptom and the features of the valid program that may be hidden behind a mistake.
fn hidden(line: &ProgramAndLine<'_, '_>, sign: &Sign, normal: &Normal) -> Option<(String, BTreeSet<String>)> {
    match &sign.symptom {
        Symptom::OtherCode { reported, .. } | Symptom::Surplus(reported) => {
            Some(rejection(line, reported, &sign.at, &normal.deviation.got))
        }
        // What is done with a global variable may be what cannot be built with any variable.
        Symptom::Unusable(words) if line.uses_external() => Some((unusable(words), line.of_use())),
        // An engine that reads no escapes writes the sign of each twice.
        Symptom::Text => {
            let (wanted, written) = differing_lines(&normal.deviation.expected, &normal.deviation.got)?;
            let is_doubled = written.replace("$$", "$") == wanted;
            is_doubled.then(|| (Symptom::Value.word(), words([UNREAD_ESCAPES])))
        }
        // An engine that reads no escapes takes one that does not exist, and a text that ends behind `$'` for one that does not end.
        Symptom::NotRejected(code) | Symptom::Rejected(code) if of_characters(code) && line.has_escape() => {
            Some((Symptom::Value.word(), words([UNREAD_ESCAPES])))
        }
        // Where no types are checked, derived ones are not.
        Symptom::NotRejected(_) if line.passes_derived() => {
            let mut features = line.of_mistake(true);
            features.remove(DERIVED);
            features.insert(UNCHECKED.to_owned());
            Some((ACCEPTED.to_owned(), features))
        }
        // What is reported elsewhere may be said of a program without the mistake too.
        Symptom::OtherLine(_) => {
            let facts = (&[Fact::Accepted][..], &normal.deviation.got[..]);
            let valid = Sign::of(&normal.program, Verdict::Fail, facts, Grade::Line);
            match valid.symptom {
                Symptom::Rejected(reason) => Some(rejection(line, &reason, &valid.at, &normal.deviation.got)),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Returns whether a code says that the characters of a literal are wrong.
fn of_characters(code: &str) -> bool {
    matches!(
        code.parse(),
        Ok(Code::UnexpectedToken | Code::InvalidStringEscape)
    )
}

/// Returns the name of the header that the engine wrote and a C compiler cannot read; `None` where it cannot read another file.
fn unusable_header(got: &[Fact]) -> Option<&str> {
    let file = got.iter().find_map(|fact| match fact {
        Fact::Unusable { reason } => reason.split_once(':').map(|(file, _)| file),
        _ => None,
    });
    file.filter(|file| file.ends_with(".h"))
}

/// Returns the properties of the values and types that a defect needs. Of unsigned numbers with the first bit of their type, which
/// some compilers take for a sign, the size does not matter where they are not converted.
fn labels(program: &ReadProgram<'_, '_>) -> BTreeSet<String> {
    match valued_types(program.text).len() == 1 && has_first_bit(program) {
        true => words(["first bit of an unsigned number"]),
        false => value_features(program),
    }
}

/// Returns whether a program has a literal whose own type does not hold it, such as `SINT#128`.
fn has_literal_beyond_type(program: &ReadProgram<'_, '_>) -> bool {
    let mut literals = program.literals();
    literals.any(|(_, literal)| is_beyond_type(literal))
}

fn words<const N: usize>(words: [&str; N]) -> BTreeSet<String> {
    BTreeSet::from(words.map(str::to_owned))
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
fn rejection(
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
