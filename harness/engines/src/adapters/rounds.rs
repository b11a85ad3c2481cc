//! Runs a pack of programs in rounds: a program that affected all of them is removed, and the rest goes on.

use crate::{Outcome, Packed, RunRequest};
use std::collections::{BTreeMap, BTreeSet};

/// The number of rounds in which programs are removed from a pack, unless an adapter has a reason for fewer; then the caller
/// makes smaller packs.
pub(super) const MAX_ROUNDS: usize = 12;

/// The result of running the programs of a pack together. Programs have their numbers in the round, from 0.
#[derive(Debug)]
pub(super) enum Round {
    /// All programs ran; holds their outcomes, in their order.
    Ran(Vec<Outcome>),
    /// Holds the programs that are removed from the pack, each with its result: an outcome, or that it has to be run alone.
    /// Nothing is known of the other programs yet; where none is removed, running them together shows nothing more.
    TakenOut(BTreeMap<usize, Packed>),
}

impl Round {
    /// Returns a round that shows nothing about any program.
    pub(super) fn nothing() -> Round {
        Round::TakenOut(BTreeMap::new())
    }

    /// Returns a round after which these programs have to be run alone.
    pub(super) fn alone(numbers: BTreeSet<usize>) -> Round {
        let alone = numbers.into_iter().map(|number| (number, Packed::Alone));
        Round::TakenOut(alone.collect())
    }
}

/// Runs those of `requests` together of which `member` makes one of a pack, as [`play`] does with [`MAX_ROUNDS`] rounds, and returns
/// the results of all.
pub(super) fn pack<'r, 'q, M>(
    requests: &'q [RunRequest<'r>],
    member: impl Fn(usize, &'q RunRequest<'r>) -> Option<M>,
    place: impl Fn(&M) -> usize,
    run_round: impl FnMut(&[M]) -> Round,
) -> Vec<Packed> {
    let mut answers = vec![Packed::Alone; requests.len()];
    let numbered = requests.iter().enumerate();
    let members = numbered
        .filter_map(|(number, request)| member(number, request))
        .collect();
    play(members, MAX_ROUNDS, &mut answers, place, run_round);
    answers
}

/// Runs `members` together, up to `most` times, and writes the result of each into `answers`, at the place that `place`
/// returns. Programs that are still together at the end are [`Packed::Unknown`]: the caller makes smaller packs.
pub(super) fn play<M>(
    mut members: Vec<M>,
    most: usize,
    answers: &mut [Packed],
    place: impl Fn(&M) -> usize,
    mut run_round: impl FnMut(&[M]) -> Round,
) {
    for _ in 0..most {
        if members.len() < 2 {
            break;
        }
        match run_round(&members) {
            Round::Ran(outcomes) => {
                for (member, outcome) in members.drain(..).zip(outcomes) {
                    answers[place(&member)] = Packed::Answered(outcome);
                }
            }
            Round::TakenOut(taken) if taken.is_empty() => break,
            // Programs are removed from the last on, so that the numbers of those before stay valid.
            Round::TakenOut(taken) => {
                for (number, known) in taken.into_iter().rev() {
                    answers[place(&members.remove(number))] = known;
                }
            }
        }
    }
    for member in members {
        answers[place(&member)] = Packed::Unknown;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the results of programs at the places 1, 3, 5 and 7 of eight, when the rounds have these results.
    fn played(most: usize, rounds: Vec<Round>) -> (Vec<Packed>, Vec<Vec<usize>>) {
        let mut answers = vec![Packed::Alone; 8];
        let mut rounds = rounds.into_iter();
        let mut seen = Vec::new();
        play(
            vec![1, 3, 5, 7],
            most,
            &mut answers,
            |place| *place,
            |members| {
                seen.push(members.to_vec());
                rounds.next().expect("no more rounds than these")
            },
        );
        (answers, seen)
    }

    fn answered() -> Packed {
        Packed::Answered(Outcome::ACCEPTED)
    }

    #[test]
    fn what_is_taken_out_keeps_its_answer_and_the_rest_goes_on() {
        let taken = BTreeMap::from([(0, Packed::Alone), (2, answered())]);
        let ran = Round::Ran(vec![Outcome::ACCEPTED, Outcome::ACCEPTED]);
        let (answers, seen) = played(9, vec![Round::TakenOut(taken), ran]);
        assert_eq!(seen, [vec![1, 3, 5, 7], vec![3, 7]]);
        assert_eq!(answers[1], Packed::Alone);
        assert_eq!(
            [&answers[3], &answers[5], &answers[7]],
            [&answered(), &answered(), &answered()]
        );
        assert!([0, 2, 4, 6].iter().all(|place| answers[*place] == Packed::Alone));
    }

    #[test]
    fn of_what_stays_together_nothing_is_known() {
        let (answers, seen) = played(9, vec![Round::alone(BTreeSet::from([3])), Round::nothing()]);
        assert_eq!(seen.len(), 2);
        assert_eq!([&answers[1], &answers[3], &answers[5]], [&Packed::Unknown; 3]);
        assert_eq!(answers[7], Packed::Alone);
        // Nor is there another round after the last one that is allowed.
        let (answers, seen) = played(1, vec![Round::alone(BTreeSet::from([0]))]);
        assert_eq!(seen.len(), 1);
        assert_eq!([&answers[1], &answers[3]], [&Packed::Alone, &Packed::Unknown]);
        // A single program is no pack, so the caller runs it alone.
        let (answers, seen) = played(9, vec![Round::alone(BTreeSet::from([0, 1, 3]))]);
        assert_eq!(seen.len(), 1);
        assert_eq!(answers[5], Packed::Unknown);
    }
}
