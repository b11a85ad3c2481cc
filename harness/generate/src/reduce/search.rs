//! A greedy, deterministic search that makes a subject smaller while it stays interesting, with few tries.
//!
//! [`Pass`]es, from coarse to fine, make the changes. A pass numbers the places that it could change; the search asks it to
//! change many of them at once, then half as many, down to one, and keeps each candidate that is still interesting. When a
//! whole round of passes changes nothing, the subject is as small as these passes can make it.
//!
//! A try may cost a second, because it may start a compiler. So a candidate is tried only if it is lighter than the best
//! one, and only once.
//!
//! Basis: Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input" (chunks by halves); Regehr et al.,
//! "Test-Case Reduction for C Compiler Bugs" (passes to a fixpoint).

use std::collections::HashSet;
use std::ops::Range;

/// The result of the test of a candidate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Interestingness {
    /// The candidate shows the symptom.
    Interesting,
    /// The candidate was tried, and does not show the symptom.
    Uninteresting,
    /// The candidate breaks a rule that candidates must keep; it was not tried, and does not count as a try.
    Invalid,
}

impl From<bool> for Interestingness {
    fn from(interesting: bool) -> Interestingness {
        if interesting {
            Interestingness::Interesting
        } else {
            Interestingness::Uninteresting
        }
    }
}

/// One way to make a subject smaller.
pub struct Pass<T> {
    /// A description of the changes, for reports of a reduction.
    pub name: &'static str,
    /// Walks the subject, asks [`Sites::here`] at each place that it could change, and changes the chosen ones.
    pub edit: fn(&mut T, &mut Sites),
}

/// Creates a pass.
pub(super) const fn pass<T>(name: &'static str, edit: fn(&mut T, &mut Sites)) -> Pass<T> {
    Pass { name, edit }
}

/// The places that a pass could change, numbered in the order of its walk.
#[derive(Debug)]
pub struct Sites {
    next: usize,
    chosen: Range<usize>,
    changed: bool,
}

impl Sites {
    fn new(chosen: Range<usize>) -> Sites {
        Sites {
            next: 0,
            chosen,
            changed: false,
        }
    }

    /// Creates sites that are all chosen, for an edit that is part of another.
    pub(super) fn all() -> Sites {
        Sites::new(0..usize::MAX)
    }

    /// Creates sites with the same choice, for a second walk over the same subject.
    pub(super) fn again(&self) -> Sites {
        Sites::new(self.chosen.clone())
    }

    /// Returns whether the next place is to be changed; called once at each place that could be changed.
    pub fn here(&mut self) -> bool {
        let chosen = self.chosen.contains(&self.next);
        self.next += 1;
        self.changed |= chosen;
        chosen
    }
}

/// The passes and measures for subjects of one type.
pub struct ReductionMethod<T: 'static> {
    /// The passes, coarse ones first.
    pub passes: &'static [Pass<T>],
    /// Returns the weight of a subject. Only lighter candidates are tried, so that every reduction terminates.
    pub weight: fn(&T) -> (u64, u128),
    /// Returns a key that is equal for equal subjects; a candidate with the key of an earlier one is not tried again.
    pub key: fn(&T) -> u64,
}

/// The limits of a reduction.
#[derive(Clone, Copy)]
pub struct ReductionBudget<'a> {
    /// The maximum number of candidates that are tried, invalid ones not counted.
    pub tries: u64,
    /// Returns whether to stop with the best candidate so far; asked before each try, for Ctrl-C and time limits.
    pub stop: &'a dyn Fn() -> bool,
}

impl Default for ReductionBudget<'_> {
    /// Returns a budget of 2000 tries that is never stopped.
    fn default() -> Self {
        ReductionBudget {
            tries: 2000,
            stop: &|| false,
        }
    }
}

/// The result of a reduction.
#[derive(Clone, PartialEq, Debug)]
pub struct Reduction<T> {
    /// The smallest interesting candidate; the start if there was none.
    pub value: T,
    /// The number of candidates tried, including the start.
    pub tries: u64,
    /// The number of invalid candidates.
    pub refused: u64,
    /// The reason why the reduction ended.
    pub ended: StopReason,
}

/// The reason why a reduction ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StopReason {
    /// No pass makes the subject smaller.
    Smallest,
    /// The tries of the budget are spent.
    OutOfTries,
    /// [`ReductionBudget::stop`] returned `true`.
    Stopped,
    /// The start itself is not interesting, so there was nothing to reduce.
    NotInteresting,
}

/// Makes `start` as small as the passes can, asking `interesting` about the start and each candidate.
///
/// The same start and the same answers give the same result. Each interesting candidate becomes the base of the next ones,
/// so the result was interesting when it was tried.
pub fn minimise<T: Clone>(
    start: T,
    method: &ReductionMethod<T>,
    interesting: &mut dyn FnMut(&T) -> Interestingness,
    budget: &ReductionBudget<'_>,
) -> Reduction<T> {
    let mut search = PassSearch {
        weight: (method.weight)(&start),
        seen: HashSet::from([(method.key)(&start)]),
        best: start,
        method,
        interesting,
        budget,
        tries: 1,
        refused: 0,
    };
    let ended = match (search.interesting)(&search.best) {
        Interestingness::Interesting => search.rounds(),
        Interestingness::Uninteresting | Interestingness::Invalid => StopReason::NotInteresting,
    };
    Reduction {
        value: search.best,
        tries: search.tries,
        refused: search.refused,
        ended,
    }
}

struct PassSearch<'a, T: 'static> {
    best: T,
    weight: (u64, u128),
    seen: HashSet<u64>,
    method: &'a ReductionMethod<T>,
    interesting: &'a mut dyn FnMut(&T) -> Interestingness,
    budget: &'a ReductionBudget<'a>,
    tries: u64,
    refused: u64,
}

impl<T: Clone> PassSearch<'_, T> {
    /// Runs all passes repeatedly until a round changes nothing.
    fn rounds(&mut self) -> StopReason {
        loop {
            let before = self.weight;
            for pass in self.method.passes {
                if let Err(ended) = self.chunks(pass) {
                    return ended;
                }
            }
            if self.weight == before {
                return StopReason::Smallest;
            }
        }
    }

    /// Runs one pass, with ever smaller chunks of its sites.
    fn chunks(&mut self, pass: &Pass<T>) -> Result<(), StopReason> {
        let mut chunk = self.sites(pass);
        while chunk > 0 {
            let mut at = 0;
            while at < self.sites(pass) {
                // After a change the next sites have moved to this position.
                if !self.attempt(pass, at..at + chunk)? {
                    at += chunk;
                }
            }
            chunk = chunk.min(self.sites(pass)) / 2;
        }
        Ok(())
    }

    fn sites(&self, pass: &Pass<T>) -> usize {
        let mut sites = Sites::new(0..0);
        (pass.edit)(&mut self.best.clone(), &mut sites);
        sites.next
    }

    /// Tries to change the chosen sites; returns whether the candidate was interesting and replaced the best one.
    fn attempt(&mut self, pass: &Pass<T>, chosen: Range<usize>) -> Result<bool, StopReason> {
        let mut candidate = self.best.clone();
        let mut sites = Sites::new(chosen);
        (pass.edit)(&mut candidate, &mut sites);
        let weight = (self.method.weight)(&candidate);
        if !sites.changed || weight >= self.weight || !self.seen.insert((self.method.key)(&candidate)) {
            return Ok(false);
        }
        if self.tries >= self.budget.tries {
            return Err(StopReason::OutOfTries);
        }
        if (self.budget.stop)() {
            return Err(StopReason::Stopped);
        }
        match (self.interesting)(&candidate) {
            Interestingness::Invalid => self.refused += 1,
            Interestingness::Uninteresting => self.tries += 1,
            Interestingness::Interesting => {
                self.tries += 1;
                self.best = candidate;
                self.weight = weight;
                return Ok(true);
            }
        }
        Ok(false)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::cell::Cell;
    use std::hash::{DefaultHasher, Hash, Hasher};

    /// A method for lists of numbers: drops elements, or decrements them.
    const LISTS: ReductionMethod<Vec<u32>> = ReductionMethod {
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
        key: |list| {
            let mut hasher = DefaultHasher::new();
            list.hash(&mut hasher);
            hasher.finish()
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

    #[test]
    fn a_start_without_the_symptom_is_given_back_as_it_is() {
        let found = minimise(
            list(),
            &LISTS,
            &mut |_| Interestingness::Uninteresting,
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
}
