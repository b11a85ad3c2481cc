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
use std::hash::{BuildHasher, BuildHasherDefault, DefaultHasher, Hash};
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
#[derive(Clone, Copy)]
pub struct Pass<T> {
    /// A description of the changes, for reports of a reduction.
    pub name: &'static str,
    /// Walks the subject, asks [`Sites::here`] at each place that it could change, and changes the chosen ones.
    pub edit: fn(&mut T, &mut Sites),
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
    pub fn all() -> Sites {
        Sites::new(0..usize::MAX)
    }

    /// Creates sites with the same choice, for a second walk over the same subject.
    pub fn again(&self) -> Sites {
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
pub struct ReductionMethod<'p, T> {
    /// The passes, coarse ones first.
    pub passes: &'p [Pass<T>],
    /// Returns the weight of a subject. Only lighter candidates are tried, so that every reduction terminates.
    pub weight: fn(&T) -> (u64, u128),
}

/// Returns a key that is equal for equal subjects; a candidate with the key of an earlier one is not tried again.
fn key<T: Hash>(subject: &T) -> u64 {
    BuildHasherDefault::<DefaultHasher>::default().hash_one(subject)
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

impl<T> Reduction<T> {
    /// Returns the result with its value converted.
    pub fn map<U>(self, convert: impl FnOnce(T) -> U) -> Reduction<U> {
        Reduction {
            value: convert(self.value),
            tries: self.tries,
            refused: self.refused,
            ended: self.ended,
        }
    }
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

/// The judge of the candidates of a reduction.
pub trait CandidateJudge<T> {
    /// Returns whether a candidate keeps the rules that candidates must keep. Only such candidates are judged.
    fn admits(&mut self, candidate: &T) -> bool;

    /// Judges candidates that do not depend on one another: all that were admitted since the last time. Returns one answer for
    /// each, in their order.
    fn judge(&mut self, candidates: &[T]) -> Vec<Interestingness>;

    /// Returns how many candidates are best judged at a time; 1 where several cost as much as one after the other.
    fn pack_size(&self) -> usize {
        1
    }
}

/// A function is asked about one candidate after the other.
impl<T, F: FnMut(&T) -> Interestingness + ?Sized> CandidateJudge<T> for F {
    fn admits(&mut self, _: &T) -> bool {
        true
    }

    fn judge(&mut self, candidates: &[T]) -> Vec<Interestingness> {
        candidates.iter().map(self).collect()
    }
}

/// Makes `start` as small as the passes can, asking the judge about the start and each candidate.
///
/// The same start and the same answers give the same result. Each interesting candidate becomes the base of the next ones,
/// so the result was interesting when it was tried.
///
/// The candidates of a pack are those that would be tried one after the other if none of them were interesting; of those that
/// are, the first is taken. So the result is the same whatever the size of the packs is, and only the number of tries grows.
pub fn minimise<T: Clone + Hash>(
    start: T,
    method: &ReductionMethod<'_, T>,
    judge: &mut dyn CandidateJudge<T>,
    budget: &ReductionBudget<'_>,
) -> Reduction<T> {
    let mut search = PassSearch {
        weight: (method.weight)(&start),
        seen: HashSet::from([key(&start)]),
        best: start,
        method,
        width: judge.pack_size().min(FIRST_PACK_LEN),
        judge,
        budget,
        tries: 1,
        refused: 0,
    };
    let first = match search.judge.admits(&search.best) {
        true => search.judge.judge(std::slice::from_ref(&search.best)),
        false => Vec::new(),
    };
    let ended = match first.first() {
        Some(Interestingness::Interesting) => search.rounds(),
        _ => StopReason::NotInteresting,
    };
    Reduction {
        value: search.best,
        tries: search.tries,
        refused: search.refused,
        ended,
    }
}

/// The maximum number of candidates in the first pack, and in one after an interesting candidate: at the beginning many candidates are
/// interesting, and those behind the first of them were judged for nothing.
const FIRST_PACK_LEN: usize = 4;

struct PassSearch<'a, T> {
    best: T,
    weight: (u64, u128),
    seen: HashSet<u64>,
    method: &'a ReductionMethod<'a, T>,
    judge: &'a mut dyn CandidateJudge<T>,
    /// The number of candidates in the next pack.
    width: usize,
    budget: &'a ReductionBudget<'a>,
    tries: u64,
    refused: u64,
}

/// A position in a round: the sites that a pass is to change next.
#[derive(Clone, Copy)]
struct RoundPosition {
    pass: usize,
    /// The number of sites that the pass has in the best candidate.
    sites: usize,
    chunk: usize,
    at: usize,
}

/// Candidates that are judged together.
struct CandidatePack<T> {
    candidates: Vec<T>,
    /// The position at which each was made.
    positions: Vec<RoundPosition>,
    keys: Vec<u64>,
}

impl<T: Clone + Hash> PassSearch<'_, T> {
    /// Runs all passes repeatedly until a round changes nothing.
    fn rounds(&mut self) -> StopReason {
        loop {
            let before = self.weight;
            if let Err(ended) = self.round() {
                return ended;
            }
            if self.weight == before {
                return StopReason::Smallest;
            }
        }
    }

    /// Runs each pass once, with ever smaller chunks of its sites.
    fn round(&mut self) -> Result<(), StopReason> {
        let mut position = self.begin(0);
        loop {
            let pack = self.pack(&mut position)?;
            if pack.candidates.is_empty() {
                return Ok(());
            }
            if let Some(found) = self.judge(pack) {
                // After a change the next sites have moved to this position.
                position = RoundPosition {
                    sites: self.sites(found.pass),
                    ..found
                };
            }
        }
    }

    /// Returns the first position of a pass.
    fn begin(&self, pass: usize) -> RoundPosition {
        let sites = self.sites(pass);
        RoundPosition {
            pass,
            sites,
            chunk: sites,
            at: 0,
        }
    }

    /// Moves a position behind the end of a chunk size or of a pass to the next one. Returns whether there is a site.
    fn settle(&self, position: &mut RoundPosition) -> bool {
        while position.at >= position.sites || position.chunk == 0 {
            position.chunk = position.chunk.min(position.sites) / 2;
            position.at = 0;
            if position.chunk == 0 {
                if position.pass >= self.method.passes.len() {
                    return false;
                }
                *position = self.begin(position.pass + 1);
            }
        }
        true
    }

    /// Returns the number of sites of a pass; none behind the last pass.
    fn sites(&self, pass: usize) -> usize {
        let mut sites = Sites::new(0..0);
        if let Some(pass) = self.method.passes.get(pass) {
            (pass.edit)(&mut self.best.clone(), &mut sites);
        }
        sites.next
    }

    /// Collects the next candidates, as if none of them were interesting, and moves the position behind them. None are left at
    /// the end of the round.
    ///
    /// # Errors
    /// [`StopReason`] where the budget admits no candidate more and none was collected.
    fn pack(&mut self, position: &mut RoundPosition) -> Result<CandidatePack<T>, StopReason> {
        let mut pack = CandidatePack {
            candidates: Vec::new(),
            positions: Vec::new(),
            keys: Vec::new(),
        };
        while pack.candidates.len() < self.width && self.settle(position) {
            let here = *position;
            let Some((candidate, key)) = self.candidate(here) else {
                position.at += position.chunk;
                continue;
            };
            if let Some(ended) = self.ended(pack.candidates.len()) {
                return if pack.candidates.is_empty() {
                    Err(ended)
                } else {
                    Ok(pack)
                };
            }
            position.at += position.chunk;
            self.seen.insert(key);
            if self.judge.admits(&candidate) {
                pack.candidates.push(candidate);
                pack.positions.push(here);
                pack.keys.push(key);
            } else {
                self.refused += 1;
            }
        }
        Ok(pack)
    }

    /// Returns why no candidate may be tried beside so many; `None` where one may.
    fn ended(&self, collected: usize) -> Option<StopReason> {
        if self.tries + collected as u64 >= self.budget.tries {
            Some(StopReason::OutOfTries)
        } else {
            (self.budget.stop)().then_some(StopReason::Stopped)
        }
    }

    /// Returns the candidate with the sites of a position changed, and its key, if it is lighter and was not seen before.
    fn candidate(&self, position: RoundPosition) -> Option<(T, u64)> {
        let pass = self.method.passes.get(position.pass)?;
        let mut candidate = self.best.clone();
        let mut sites = Sites::new(position.at..position.at + position.chunk);
        (pass.edit)(&mut candidate, &mut sites);
        if !sites.changed || (self.method.weight)(&candidate) >= self.weight {
            return None;
        }
        let key = key(&candidate);
        (!self.seen.contains(&key)).then_some((candidate, key))
    }

    /// Judges the candidates of a pack; the first interesting one becomes the best. Returns its position.
    fn judge(&mut self, pack: CandidatePack<T>) -> Option<RoundPosition> {
        let verdicts = self.judge.judge(&pack.candidates);
        for verdict in &verdicts {
            match verdict {
                Interestingness::Invalid => self.refused += 1,
                Interestingness::Uninteresting | Interestingness::Interesting => self.tries += 1,
            }
        }
        let first = verdicts
            .iter()
            .position(|verdict| *verdict == Interestingness::Interesting);
        let most = self.judge.pack_size().max(1);
        let Some(first) = first else {
            self.width = (self.width * 2).min(most);
            return None;
        };
        self.width = (self.width / 2).max(most.min(FIRST_PACK_LEN));
        // Those behind it were changes of a base that is no more.
        for key in &pack.keys[first + 1..] {
            self.seen.remove(key);
        }
        self.best = pack.candidates.into_iter().nth(first)?;
        self.weight = (self.method.weight)(&self.best);
        pack.positions.get(first).copied()
    }
}

#[cfg(test)]
mod tests;
