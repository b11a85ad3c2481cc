//! The search on lists of numbers.

use super::*;
use std::cell::Cell;

/// A method for lists of numbers: drops elements, or decrements them.
const LISTS: ReductionMethod<'_, Vec<u32>> = ReductionMethod {
    passes: &[
        Pass {
            name: "drop",
            edit: |list, sites| list.retain(|_| !sites.here()),
        },
        Pass {
            name: "decrease",
            edit: |list, sites| {
                for element in list.iter_mut().filter(|element| **element > 0) {
                    if sites.here() {
                        *element -= 1;
                    }
                }
            },
        },
    ],
    weight: |list| {
        (
            list.len() as u64,
            list.iter().map(|element| u128::from(*element)).sum(),
        )
    },
};

fn list() -> Vec<u32> {
    (1..=200).collect()
}

#[test]
fn what_matters_remains_and_all_else_goes() {
    let mut both = |list: &Vec<u32>| {
        Interestingness::from(list.contains(&17) && list.iter().any(|element| *element > 150))
    };
    let found = minimise(list(), &LISTS, &mut both, &ReductionBudget::default());
    assert_eq!(found.value, [17, 151]);
    assert_eq!(found.ended, StopReason::Smallest);
    assert!(found.tries < 200, "{} tries", found.tries);
}

#[test]
fn the_same_question_is_never_asked_twice() {
    let mut asked = HashSet::new();
    let mut ask = |list: &Vec<u32>| {
        assert!(asked.insert(list.clone()), "{list:?} was asked twice");
        Interestingness::from(list.len() >= 3)
    };
    let found = minimise(list(), &LISTS, &mut ask, &ReductionBudget::default());
    assert_eq!(found.value, [0, 0, 0]);
    assert_eq!(found.tries, asked.len() as u64);
}

/// Judges lists in packs of up to nine, and counts the packs.
struct InPacks {
    packs: u64,
}

/// Returns whether a list may be asked about: some lengths are not allowed.
fn is_valid(list: &[u32]) -> bool {
    list.len() % 7 != 5
}

impl CandidateJudge<Vec<u32>> for InPacks {
    fn admits(&mut self, list: &Vec<u32>) -> bool {
        is_valid(list)
    }

    fn judge(&mut self, lists: &[Vec<u32>]) -> Vec<Interestingness> {
        self.packs += 1;
        lists
            .iter()
            .map(|list| Interestingness::from(has_all_tens(list)))
            .collect()
    }

    fn pack_size(&self) -> usize {
        9
    }
}

/// Only drops: with [`LISTS`], nearly every decrement is interesting, and packs would show nothing.
const DROPS: ReductionMethod<Vec<u32>> = ReductionMethod {
    passes: &[Pass {
        name: "drop",
        edit: |list, sites| list.retain(|_| !sites.here()),
    }],
    ..LISTS
};

fn has_all_tens(list: &[u32]) -> bool {
    (1..=20).all(|number| list.contains(&(number * 10)))
}

#[test]
fn packs_change_the_number_of_questions_and_not_the_result() {
    let mut alone = |list: &Vec<u32>| match is_valid(list) {
        false => Interestingness::Invalid,
        true => Interestingness::from(has_all_tens(list)),
    };
    let one = minimise(list(), &DROPS, &mut alone, &ReductionBudget::default());
    let mut judge = InPacks { packs: 0 };
    let packed = minimise(list(), &DROPS, &mut judge, &ReductionBudget::default());
    assert_eq!((&packed.value, packed.ended), (&one.value, StopReason::Smallest));
    assert!(
        judge.packs * 2 < one.tries,
        "{} packs, {} tries",
        judge.packs,
        one.tries
    );
}

#[test]
fn a_start_without_the_symptom_is_given_back_as_it_is() {
    let found = minimise(
        list(),
        &LISTS,
        &mut |_: &Vec<u32>| Interestingness::Uninteresting,
        &ReductionBudget::default(),
    );
    assert_eq!(
        (found.value, found.tries, found.ended),
        (list(), 1, StopReason::NotInteresting)
    );
}

#[test]
fn the_best_so_far_is_given_when_the_budget_ends() {
    let few = ReductionBudget {
        tries: 5,
        ..ReductionBudget::default()
    };
    let mut long = |list: &Vec<u32>| Interestingness::from(list.contains(&17));
    let found = minimise(list(), &LISTS, &mut long, &few);
    assert_eq!((found.tries, found.ended), (5, StopReason::OutOfTries));
    assert!(found.value.contains(&17) && found.value.len() < 200);
}

#[test]
fn the_best_so_far_is_given_when_it_is_stopped() {
    let asked = Cell::new(0);
    let stop = || asked.get() == 3;
    let budget = ReductionBudget {
        stop: &stop,
        ..ReductionBudget::default()
    };
    let mut long = |list: &Vec<u32>| {
        asked.set(asked.get() + 1);
        Interestingness::from(list.contains(&17))
    };
    let found = minimise(list(), &LISTS, &mut long, &budget);
    assert_eq!((found.tries, found.ended), (3, StopReason::Stopped));
    assert!(found.value.contains(&17));
}

#[test]
fn what_is_refused_costs_no_try() {
    let mut even = |list: &Vec<u32>| match list.len() % 2 {
        0 => Interestingness::from(list.contains(&17)),
        _ => Interestingness::Invalid,
    };
    let found = minimise(list(), &LISTS, &mut even, &ReductionBudget::default());
    assert!(found.refused > 0);
    assert_eq!(found.value.len() % 2, 0);
}
