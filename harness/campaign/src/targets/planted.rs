//! A program with a planted error made small: what is around the error goes, and the same kind of error is planted anew.

use crate::basis::of_code;
use crate::finding::{ExpectedBehavior, Finding};
use std::rc::Rc;
use stickler_generate::model::Program;
use stickler_generate::oracles::{OracleFailure, SoundProgram, judge_planted_text, judge_sound_text};
use stickler_generate::plant::{Planted, plant, plant_kind};
use stickler_generate::writer::{Style, write};
use stickler_generate::{random, reduce};
use stickler_reduce::{
    Interestingness, METHOD, Reduction, ReductionBudget, ReductionMethod, ReferenceRules, StopReason,
    TextDraft, drop_unused, minimise, text_pass,
};

/// The number of other places that are tried for an error, besides the one where it was found.
const OTHER_PLACES: u64 = 32;

/// The number of bytes that choose a place.
const BYTES_OF_A_PLACE: usize = 16;

/// Makes what the input of a finding stands for small, if an error of the same kind can be planted so that it fails alike. Returns the
/// failure of the small program.
pub(super) fn reduce(finding: &mut Finding, budget: &ReductionBudget<'_>) -> Option<OracleFailure> {
    let (input, symptom) = (&finding.input, &finding.symptom);
    let SoundProgram { sound, error, .. } = SoundProgram::of(input)?;
    let kind = plant(&sound, error)?.kind;
    let judge: &Judge<'_> = &|sound, planted, text, line| {
        judge_sound_text(planted.program.dialect, sound)?;
        judge_planted_text(planted, text, line)
    };
    let search = PlantedSearch { kind, symptom, judge };
    // Which bytes chose the kind and which the place is the planter's affair: those are taken that lead to the same failure.
    let places = (0..error.len()).filter_map(|skipped| error.get(skipped..));
    let place = { places }.find(|place| search.failing(&sound, place).is_some())?;
    let (reduced, found) = search.reduce(&sound, place, budget)?;
    // Where it is the sound program that is rejected, no diagnostic must come.
    let found = match symptom.starts_with("rejected") {
        true => found,
        false => {
            let found = search.without_unused(found);
            finding.expected = found.expected();
            found
        }
    };
    // What stands around the error is there because a program needs it.
    finding.rule = vec![kind.to_owned()];
    finding.enter(&reduced);
    Some(found.failure)
}

/// Holds the reference to the text of a sound program, and to that of one with an error on this line.
type Judge<'j> = dyn Fn(&str, &Planted, &str, u32) -> Result<(), OracleFailure> + 'j;

/// The properties that a reduction keeps: the kind of error, and how the reference fails over it.
#[derive(Clone, Copy)]
struct PlantedSearch<'s> {
    kind: &'s str,
    symptom: &'s str,
    judge: &'s Judge<'s>,
}

/// An error planted in a program, and how the reference fails over it.
struct PlantedFailure {
    /// The text of the sound program.
    sound: String,
    planted: Planted,
    /// The line of the error in the text of the failure.
    line: u32,
    failure: OracleFailure,
}

impl PlantedSearch<'_> {
    /// Makes the sound program small, first with the error in the place that these bytes choose, then in any.
    ///
    /// Bytes choose among what there is: where less is there they choose something else, mostly what the reference does not
    /// fail over. So at last they only hold fast what could go but for them. A program that is small already is quickly
    /// judged with many errors.
    fn reduce(
        self,
        sound: &Program,
        place: &[u8],
        budget: &ReductionBudget<'_>,
    ) -> Option<(Reduction<Program>, PlantedFailure)> {
        let mut shows = |candidate: &Program| Interestingness::from(self.failing(candidate, place).is_some());
        let first = reduce::program(sound, &mut shows, budget);
        let mut places = places(place);
        let mut last = self.failing(&first.value, place)?;
        let left = ReductionBudget {
            tries: budget.tries.saturating_sub(first.tries),
            ..*budget
        };
        let mut shows = |candidate: &Program| match self.failing_anywhere(candidate, &mut places) {
            Some(found) => {
                last = found;
                Interestingness::Interesting
            }
            None => Interestingness::Uninteresting,
        };
        let second = reduce::program(&first.value, &mut shows, &left);
        let reduced = Reduction {
            tries: first.tries.saturating_add(second.tries),
            refused: first.refused.saturating_add(second.refused),
            ..second
        };
        (reduced.ended != StopReason::NotInteresting).then_some((reduced, last))
    }

    /// The first place where the reference fails over the error; it comes to the front of all.
    fn failing_anywhere(self, sound: &Program, places: &mut [Vec<u8>]) -> Option<PlantedFailure> {
        for number in 0..places.len() {
            if let Some(found) = places.get(number).and_then(|place| self.failing(sound, place)) {
                places.swap(0, number);
                return Some(found);
            }
        }
        None
    }

    /// The error planted in a program, and how the reference fails over it in this way.
    fn failing(self, sound: &Program, place: &[u8]) -> Option<PlantedFailure> {
        let planted = plant_kind(sound, self.kind, place)?;
        let style = Style::default();
        let (without, with) = (write(sound, &style), write(&planted.program, &style));
        let line = planted.line(&without, &with);
        let failure = (self.judge)(&without.text, &planted, &with.text, line).err()?;
        (failure.symptom == self.symptom).then_some(PlantedFailure {
            sound: without.text,
            planted,
            line,
            failure,
        })
    }

    /// Drops the declarations that only the sound program uses. A comment marks the line of the error meanwhile.
    fn without_unused(self, mut found: PlantedFailure) -> PlantedFailure {
        const MARK: &str = "(* the planted error *)";
        let dialect = found.planted.program.dialect;
        let mut text = String::new();
        for (number, line) in (1..).zip(found.failure.program.iter().flat_map(|text| text.lines())) {
            let mark = if number == found.line { MARK } else { "" };
            text += &format!("{line}{mark}\n");
        }
        let errors = |text: &str| stickler_reference::errors(text, dialect).len();
        let most = errors(&text);
        let mut shows = |draft: &TextDraft| {
            let above = draft.text().split(MARK).next().unwrap_or_default();
            let line = above.lines().count() as u32;
            let text = draft.text().replace(MARK, "");
            // What is used somewhere would be an error of its own there.
            if errors(&text) > most {
                return Interestingness::Invalid;
            }
            match (self.judge)(&found.sound, &found.planted, &text, line) {
                Err(failure) if failure.symptom == self.symptom => {
                    found.line = line;
                    found.failure = failure;
                    Interestingness::Interesting
                }
                _ => Interestingness::Uninteresting,
            }
        };
        let draft = TextDraft::new(&text, dialect, Rc::new(ReferenceRules::new(&text, dialect)));
        let method = ReductionMethod {
            passes: &[text_pass!("drop what is not used", drop_unused)],
            ..METHOD
        };
        minimise(draft, &method, &mut shows, &ReductionBudget::default());
        found
    }
}

impl PlantedFailure {
    fn expected(&self) -> ExpectedBehavior {
        ExpectedBehavior::Rejected {
            code: self.planted.code.as_str().to_owned(),
            line: self.line,
            basis: Some(of_code(self.planted.code, self.planted.program.dialect)),
        }
    }
}

/// The bytes that chose a place, none, which choose the first, and others.
fn places(found: &[u8]) -> Vec<Vec<u8>> {
    let others = (0..OTHER_PLACES).map(|seed| random::bytes(seed, BYTES_OF_A_PLACE));
    [found.to_vec(), Vec::new()].into_iter().chain(others).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_generate::generator::{GeneratorSettings, program};

    /// A program of which the bytes are drawn from this seed.
    fn generated(seed: u64) -> Program {
        let bytes = random::bytes(seed, 1500);
        program(&bytes, &GeneratorSettings::default())
    }

    /// The smallest text in which a reference that overlooks some errors of a kind overlooks one: those of which the text passes a
    /// test. The reference itself says of it what it must.
    fn reduced(kind: &str, overlooked: &dyn Fn(&str) -> bool) -> String {
        let judge = |sound: &str, planted: &Planted, text: &str, line: u32| {
            judge_sound_text(planted.program.dialect, sound)?;
            judge_planted_text(planted, text, line)?;
            if overlooked(text) {
                return Err(OracleFailure::new("overlooked", "nothing is said").of_program(text));
            }
            Ok(())
        };
        let search = PlantedSearch {
            kind,
            symptom: "overlooked",
            judge: &judge,
        };
        let seeds = (0..500).map(|seed| (generated(seed), random::bytes(seed, 48)));
        let (sound, place) = { seeds }
            .find(|(sound, place)| search.failing(sound, place).is_some())
            .expect("one of the programs has a place for the error");
        let (_, found) = search
            .reduce(&sound, &place, &ReductionBudget::default())
            .expect("it fails");
        search
            .without_unused(found)
            .failure
            .program
            .expect("it has a text")
    }

    #[test]
    fn errors_that_need_much_around_them_are_left_with_fifteen_lines() {
        for kind in include_str!("surrounded.txt").lines() {
            let text = reduced(kind, &|_| true);
            assert!(text.lines().count() <= 15, "{kind}:\n{text}");
        }
    }

    #[test]
    fn an_error_that_shows_in_few_places_is_planted_in_another_as_the_program_shrinks() {
        let unsigned = |text: &str| text.contains("planted : U");
        let text = reduced("a VAR_IN_OUT of another type", &unsigned);
        assert!(text.lines().count() <= 13, "{text}");
    }

    #[test]
    fn what_only_the_sound_program_needs_goes_at_last() {
        let text = reduced("a VAR_IN_OUT that is constant", &|_| true);
        assert_eq!(text.matches(" : ").count(), 3, "{text}");
    }
}
