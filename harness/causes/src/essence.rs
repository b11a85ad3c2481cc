//! The essence of a cause: what of its smallest program matters for the defect, without the place where it happens to stand.
//!
//! Two small programs show one defect where the engine does the same with the same construct. Which construct it is follows
//! from the kind of deviation: the line that is accepted or rejected wrongly, or, of a wrong value, the conversion that the
//! program contains; without a conversion, everything by which the program differs from an assignment.

use crate::assignments::shows_initial_value;
use crate::features::{LITERAL, MarkedProgram, PLACES, UNCHECKED};
use crate::literals::valued_types;
use crate::normal::Normal;
use crate::numbers;
use crate::reduction::Smallest;
use crate::sign::{Sign, is_of_reading};
use crate::tokens::tokens;
use crate::twins::value_features;
use std::collections::BTreeSet;
use stickler_run::{Fact, Grade, Symptom, Verdict};
use stickler_types::Code;

/// The properties that small programs with the same defect have in common.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Essence {
    /// The class of the engine's behaviour; causes with different classes are different.
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
        let program = MarkedProgram::new(normal);
        let pattern = normal
            .way
            .or_else(|| numbers::number_pattern(&normal.program, &normal.deviation));
        let header = unusable_header(&normal.deviation.got);
        let (class, features, is_contained) = match &sign.symptom {
            Symptom::NotRejected(code) => {
                let mut features = program.of_mistake(normal.is_unchecked);
                let forms = program.forms_of_literals();
                // What is assigned to a constant, or to a part of one, does not matter.
                if code == Code::AssignmentToConstant.as_str() {
                    features.remove(LITERAL);
                    features.insert("constant".to_owned());
                }
                if is_of_reading(code) && !forms.is_empty() {
                    features.remove(LITERAL);
                    features.insert(program.place().to_owned());
                    features.extend(forms);
                }
                // A place alone is in every program.
                let names_construct = !features.iter().any(|feature| PLACES.contains(&feature.as_str()));
                // Where nothing is checked, it does not matter what is not checked.
                let class = match normal.is_unchecked {
                    true => "accepted".to_owned(),
                    false => format!("accepted {code}"),
                };
                (class, features, names_construct)
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
            Symptom::OtherCode { code, reported } => {
                // The kind of value does not matter for what else is said.
                let mut features = program.of_mistake(false);
                // A literal that is too large to be read is that in every place.
                if code == Code::ConstantOverflow.as_str() && is_of_reading(reported) {
                    features = BTreeSet::from(["literal".to_owned()]);
                } else if features.remove(LITERAL) {
                    features.insert(program.place().to_owned());
                }
                (format!("{code} as {reported}"), features, false)
            }
            Symptom::Value if normal.is_beginning => {
                let features = ["FUNCTION_BLOCK", "initial value"].map(str::to_owned);
                (sign.symptom.word(), BTreeSet::from(features), false)
            }
            Symptom::Value if pattern.is_some() => {
                let features = pattern.map(str::to_owned).into_iter().collect();
                (sign.symptom.word(), features, false)
            }
            Symptom::Value | Symptom::Missing => {
                let is_initial = shows_initial_value(smallest);
                let (features, converts) = program.of_value(is_initial);
                // Whatever is computed beside it, a conversion by name is wrong by itself.
                let is_by_name = features.iter().any(|feature| feature.contains("_TO_"));
                (sign.symptom.word(), features, !converts || is_by_name)
            }
            // An operation that takes a value of one kind for one of another gives a wrong value, or a fault where that is zero.
            Symptom::Fault(_) if program.mixes_kinds() => {
                (Symptom::Value.word(), program.of_value(false).0, false)
            }
            Symptom::Hang => (sign.word(), program.loops(), false),
            // A header that the compiler wrote is read before anything else, and what is said of it depends on what follows.
            Symptom::Unusable(_) if header.is_some() => {
                let class = format!("unusable {}", header.unwrap_or_default());
                (class, BTreeSet::new(), false)
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
            Symptom::OtherCode { reported, .. } | Symptom::Surplus(reported) => {
                Some((rejected(reported, &sign.at), program.of_rejection()))
            }
            // What is reported elsewhere may be said of a program without the mistake too.
            Symptom::OtherLine(_) => {
                let facts = (&[Fact::Accepted][..], &normal.deviation.got[..]);
                let valid = Sign::of(&normal.program, Verdict::Fail, facts, Grade::Line);
                match valid.symptom {
                    Symptom::Rejected(reason) => Some((rejected(&reason, &valid.at), program.of_rejection())),
                    _ => None,
                }
            }
            _ => None,
        };
        // Every program has statements.
        let names_construct =
            |features: &BTreeSet<String>| features.iter().any(|feature| feature != PLACES[2]);
        let hidden = hidden.filter(|(_, features)| names_construct(features));
        let by_chance = if smallest.flaky.is_some() {
            "by chance: "
        } else {
            ""
        };
        Essence {
            class: format!("{by_chance}{}", class.trim_end()),
            features,
            labels: match &sign.symptom {
                Symptom::Value if pattern.is_some() => BTreeSet::new(),
                // Nothing was asked of a fault.
                Symptom::Fault(_) if program.mixes_kinds() => value_features(&normal.program),
                _ => labels(normal),
            },
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

/// Returns the name of the header that the engine wrote and a C compiler cannot read; `None` where it cannot read another file.
fn unusable_header(got: &[Fact]) -> Option<&str> {
    got.iter()
        .find_map(|fact| match fact {
            Fact::Unusable { reason } => reason.split_once(':').map(|(file, _)| file),
            _ => None,
        })
        .filter(|file| file.ends_with(".h"))
}

/// Returns the properties of the values and types that a defect needs. Of unsigned numbers with the first bit of their type, which
/// some compilers take for a sign, the size does not matter where they are not converted.
fn labels(normal: &Normal) -> BTreeSet<String> {
    let types = valued_types(&tokens(&normal.program)).len();
    match !normal.labels.is_empty() && types == 1 && numbers::has_first_bit(&normal.program) {
        true => BTreeSet::from(["first bit of an unsigned number".to_owned()]),
        false => normal.labels.clone(),
    }
}

fn rejected(reason: &str, at: &str) -> String {
    format!("rejected {reason} {at}")
}

#[cfg(test)]
mod tests;
