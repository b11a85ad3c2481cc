//! The essence of a cause: what of its smallest program matters for the defect, without the place where it happens to stand.
//!
//! Two small programs show one defect where the engine does the same with the same construct. Which construct it is follows
//! from the kind of deviation: the line that is accepted or rejected wrongly, or, of a wrong value, the conversion that the
//! program contains; without a conversion, everything by which the program differs from an assignment.

mod needs;

use crate::alone::is_loop_alone;
use crate::failure_sign::{Sign, differing_lines};
use crate::line_features::{DERIVED, IN_STATEMENTS, LINE_PLACES, ProgramAndLine};
use crate::loop_limits::{TO_LAST_VALUE, loop_beyond_limit};
use crate::malformed::{SIZES, is_beyond_type};
use crate::normal_form::{Normal, is_whatever_comes};
use crate::patterns::{BITS_OF_LREAL, UNREAD_ESCAPES, has_first_bit, number_pattern};
use crate::plainness::value_features;
use crate::program::{Program, ReadProgram};
use crate::question::wrong_values;
use crate::reduction::Smallest;
use crate::value_lines::shows_initial_value;
use crate::words::{elementary, valued_types};
use needs::{needs, rejection, unusable};
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
        // Bits of another number are those of the operator, whichever the types are; so it is where a place does not convert at all.
        let converts_nothing = features.contains("conversion") && features.contains("initial value");
        if features.contains("bitwise operator") || converts_nothing {
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
