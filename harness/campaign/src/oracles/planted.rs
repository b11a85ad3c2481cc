//! A program with a planted error made small: what is around the error goes, and the same kind of error is planted anew.

use crate::finding::Expected;
use arbitrary::Unstructured;
use stickler_generate::model::Program;
use stickler_generate::oracles::{Failure, SoundProgram, judge_planted};
use stickler_generate::plant::{Planted, plant, plant_kind};
use stickler_generate::reduce::{self, Answer, Budget, Ended, Minimised};
use stickler_generate::writer::{Style, write};

/// What codes stand for which error.
const BASIS: &str = "stickler-design: §7";

/// A sound program, small, in which an error of this kind is not reported as it must be.
pub(super) struct SmallPlant {
    /// How the search went, and the sound program.
    pub(super) reduced: Minimised<Program>,
    /// The kind of error.
    pub(super) kind: &'static str,
    /// How it fails now.
    pub(super) failure: Failure,
    /// The diagnostic that must come; `None` where it is the sound program that is rejected.
    pub(super) expected: Option<Expected>,
}

/// Makes what an input stands for small, if an error of the same kind can be planted so that it fails alike.
pub(super) fn small(input: &[u8], symptom: &str, budget: &Budget<'_>) -> Option<SmallPlant> {
    let SoundProgram { sound, error, .. } = SoundProgram::of(input)?;
    let kind = plant(&sound, &mut Unstructured::new(error))?.kind;
    // Which bytes chose the kind and which the place is the planter's affair: those are taken that lead to the same failure.
    let places = (0..error.len()).filter_map(|skipped| error.get(skipped..));
    let place = { places }.find(|place| failing(&sound, kind, place, symptom).is_some())?;
    let shows = |candidate: &Program| Answer::from(failing(candidate, kind, place, symptom).is_some());
    let reduced = reduce::program(&sound, shows, budget);
    if reduced.ended == Ended::NotInteresting {
        return None;
    }
    let (planted, failure) = failing(&reduced.value, kind, place, symptom)?;
    let of_the_sound = symptom.starts_with("rejected");
    Some(SmallPlant {
        kind,
        failure,
        expected: (!of_the_sound).then(|| expected(&reduced.value, &planted)),
        reduced,
    })
}

/// The error planted in a program, and how the reference fails over it in this way.
fn failing(sound: &Program, kind: &str, place: &[u8], symptom: &str) -> Option<(Planted, Failure)> {
    let planted = plant_kind(sound, kind, &mut Unstructured::new(place))?;
    let failure = judge_planted(sound, &planted, &Style::default()).err()?;
    (failure.symptom == symptom).then_some((planted, failure))
}

fn expected(sound: &Program, planted: &Planted) -> Expected {
    let style = Style::default();
    Expected::Rejected {
        code: planted.code.as_str().to_owned(),
        line: planted.line(&write(sound, &style), &write(&planted.program, &style)),
        basis: Some(BASIS.to_owned()),
    }
}
