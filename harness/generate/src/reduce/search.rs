//! The search that makes anything smaller while it stays interesting: greedy, deterministic, and sparing with tries.
//!
//! What can be changed is told by [`Pass`]es, from coarse to fine. A pass numbers the places that it could change; the search
//! asks it to change many of them at once, then half as many, down to one, and keeps each candidate that is still
//! interesting. When a whole round of passes changes nothing, the thing is as small as these passes can make it.
//!
//! A try may cost a second, for it may start a compiler. So a candidate is tried only if it is lighter than what there is,
//! and only once.
//!
//! Basis: Zeller and Hildebrandt, "Simplifying and Isolating Failure-Inducing Input" (chunks by halves); Regehr et al.,
//! "Test-Case Reduction for C Compiler Bugs" (passes to a fixpoint).

use std::collections::HashSet;
use std::ops::Range;

/// What is said of a candidate.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Interestingness {
    /// It shows what is being looked for.
    Interesting,
    /// It was tried, and does not.
    Uninteresting,
    /// It was not worth a try, because it breaks a rule that candidates must keep; it costs nothing and is not counted.
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

/// One way to make a thing smaller.
pub struct Pass<T> {
    /// What it does, for who asks how a reduction went.
    pub name: &'static str,
    /// Walks the thing, asks [`Sites::here`] at each place that it could change, and changes those that are chosen.
    pub edit: fn(&mut T, &mut Sites),
}

/// A pass of this name that makes this edit.
pub(super) const fn pass<T>(name: &'static str, edit: fn(&mut T, &mut Sites)) -> Pass<T> {
    Pass { name, edit }
}

/// The places that a pass could change, numbered as it comes to them.
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

    /// Sites of which every one is chosen: for an edit that leans on another.
    pub(super) fn all() -> Sites {
        Sites::new(0..usize::MAX)
    }

    /// The same choice for a second walk over the same thing.
    pub(super) fn again(&self) -> Sites {
        Sites::new(self.chosen.clone())
    }

    /// To be asked at each place that could be changed: whether this one is to be.
    pub fn here(&mut self) -> bool {
        let chosen = self.chosen.contains(&self.next);
        self.next += 1;
        self.changed |= chosen;
        chosen
    }
}

/// How things of one kind are reduced.
pub struct ReductionMethod<T: 'static> {
    /// The passes, coarse ones first.
    pub passes: &'static [Pass<T>],
    /// How much there is of it. Only what is lighter is tried, so that every reduction ends.
    pub weight: fn(&T) -> (u64, u128),
    /// Equal for equal things; what has the key of something that was tried is not tried again.
    pub key: fn(&T) -> u64,
}

/// What a reduction may take.
#[derive(Clone, Copy)]
pub struct ReductionBudget<'a> {
    /// How many candidates may be tried, those refused not counted.
    pub tries: u64,
    /// Asked before each try: whether to be content with what there is. Ctrl-C and time limits belong here.
    pub stop: &'a dyn Fn() -> bool,
}

impl Default for ReductionBudget<'_> {
    /// Two thousand tries, and never stopped.
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
    /// The smallest that was found to be interesting; the start where nothing smaller was.
    pub value: T,
    /// How many candidates were tried, the start among them.
    pub tries: u64,
    /// How many candidates were refused without a try.
    pub refused: u64,
    /// Why it ended.
    pub ended: StopReason,
}

/// Why a reduction ended.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum StopReason {
    /// No pass makes it any smaller.
    Smallest,
    /// The budget was spent.
    OutOfTries,
    /// [`ReductionBudget::stop`] said so.
    Stopped,
    /// The start itself is not interesting: there was nothing to reduce.
    NotInteresting,
}

/// Makes `start` as small as the passes can, asking `interesting` about each candidate, and about the start first.
///
/// The same start and the same answers give the same result. Each candidate that is found interesting becomes what the next
/// ones are made from, so the result has been interesting when it was tried.
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
    /// All passes, again and again, until a round changes nothing.
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

    /// One pass, with ever smaller chunks of its sites.
    fn chunks(&mut self, pass: &Pass<T>) -> Result<(), StopReason> {
        let mut chunk = self.sites(pass);
        while chunk > 0 {
            let mut at = 0;
            while at < self.sites(pass) {
                // What is kept makes room: the next sites have come to where these were.
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

    /// Whether these sites can be changed; then they are.
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

    /// Lists of numbers: an element is dropped, or made one less.
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
