//! A pack of programs, round after round: what one program did to all of them takes it out, and the rest goes on.

use crate::{Outcome, Packed};
use std::collections::{BTreeMap, BTreeSet};

/// So often programs are taken out of a pack and the rest goes on, unless an adapter has a reason for fewer; then whoever gave the
/// pack makes smaller ones.
pub(super) const MAX_ROUNDS: usize = 12;

/// What is known of the programs of a pack after they were looked at together. Programs have their numbers in the round, from 0.
#[derive(Debug)]
pub(super) enum Round {
    /// All ran; what came of each, in their order.
    Ran(Vec<Outcome>),
    /// These are taken out of the pack, with what is known of them: an outcome, or that they are to be asked about alone. Of the
    /// others nothing is known yet; where none is taken out, there is nothing more to be learnt from all of them together.
    TakenOut(BTreeMap<usize, Packed>),
}

impl Round {
    /// Nothing is known of any program.
    pub(super) fn nothing() -> Round {
        Round::TakenOut(BTreeMap::new())
    }

    /// These programs are to be asked about alone.
    pub(super) fn alone(numbers: BTreeSet<usize>) -> Round {
        let alone = numbers.into_iter().map(|number| (number, Packed::Alone));
        Round::TakenOut(alone.collect())
    }
}

/// Looks at `members` together, up to `most` times, and writes what becomes of each into `answers`, at the place that `place`
/// tells. What is still together at the end is [`Packed::Unknown`]: whoever gave the pack makes smaller ones.
pub(super) fn play<M>(
    mut members: Vec<M>,
    most: usize,
    answers: &mut [Packed],
    place: impl Fn(&M) -> usize,
    mut look: impl FnMut(&[M]) -> Round,
) {
    for _ in 0..most {
        if members.len() < 2 {
            break;
        }
        match look(&members) {
            Round::Ran(outcomes) => {
                for (member, outcome) in members.drain(..).zip(outcomes) {
                    answers[place(&member)] = Packed::Answered(outcome);
                }
            }
            Round::TakenOut(taken) if taken.is_empty() => break,
            // From the last on, so that the numbers of those before stay theirs.
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

    /// Returns what becomes of programs at the places 1, 3, 5 and 7 of eight, when the rounds tell this.
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

    fn told() -> Packed {
        Packed::Answered(Outcome::Accepted)
    }

    #[test]
    fn what_is_taken_out_keeps_its_answer_and_the_rest_goes_on() {
        let taken = BTreeMap::from([(0, Packed::Alone), (2, told())]);
        let ran = Round::Ran(vec![Outcome::Accepted, Outcome::Accepted]);
        let (answers, seen) = played(9, vec![Round::TakenOut(taken), ran]);
        assert_eq!(seen, [vec![1, 3, 5, 7], vec![3, 7]]);
        assert_eq!(answers[1], Packed::Alone);
        assert_eq!(
            [&answers[3], &answers[5], &answers[7]],
            [&told(), &told(), &told()]
        );
        assert!([0, 2, 4, 6].iter().all(|place| answers[*place] == Packed::Alone));
    }

    #[test]
    fn of_what_stays_together_nothing_is_known() {
        let (answers, seen) = played(9, vec![Round::alone(BTreeSet::from([3])), Round::nothing()]);
        assert_eq!(seen.len(), 2);
        assert_eq!([&answers[1], &answers[3], &answers[5]], [&Packed::Unknown; 3]);
        assert_eq!(answers[7], Packed::Alone);
        // Nor where there were rounds enough.
        let (answers, seen) = played(1, vec![Round::alone(BTreeSet::from([0]))]);
        assert_eq!(seen.len(), 1);
        assert_eq!([&answers[1], &answers[3]], [&Packed::Alone, &Packed::Unknown]);
        // A single program is no pack, so it is looked at by whoever asks about it alone.
        let (answers, seen) = played(9, vec![Round::alone(BTreeSet::from([0, 1, 3]))]);
        assert_eq!(seen.len(), 1);
        assert_eq!(answers[5], Packed::Unknown);
    }
}
