//! The search: reduces the smallest program of each group on the engine, and merges groups of one cause.

use crate::essence::Essence;
use crate::failed::{FailedCases, Group};
use crate::question::{Questioner, with_program};
use crate::reduction::{Smallest, reduce};
use crate::shape::types_of;
use crate::sign::Sign;
use crate::title::title;
use std::collections::HashMap;
use std::time::{Duration, Instant};
use stickler_engines::{Ability, Engine, EngineSession, Reproduction};
use stickler_run::{
    AnswerStore, CaseEvent, CaseJudge, Cause, Fact, Plan, Reduced, RunError, Symptom, Verdict, Witness,
    shown_by,
};
use stickler_suite::{Case, SourceKind, Sources, Suite};
use stickler_workers::{Cancellation, WorkerPool};

/// The number of groups that are reduced before the questions that are left are counted. It does not depend on the number
/// of threads, so that the same groups are reduced on every machine.
const WAVE: usize = 32;

/// The limits of a search.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Limits {
    /// The maximum number of questions to each engine, about as many as programs that it has to run.
    pub questions: u64,
    /// The maximum number of questions for one group of cases.
    pub questions_a_group: u64,
    /// The time after which no more questions are asked. What is found then depends on the speed of the machine.
    pub time: Duration,
}

impl Default for Limits {
    /// Returns limits of 20 000 questions to each engine, 200 for a group, and ten minutes.
    fn default() -> Limits {
        Limits {
            questions: 20_000,
            questions_a_group: 200,
            time: Duration::from_secs(600),
        }
    }
}

/// A run that is over, and the limits of the search for its causes.
pub struct Search<'r> {
    /// The plan of the run.
    pub plan: &'r Plan,
    /// The suite of the run.
    pub suite: &'r Suite,
    /// The engines of the run.
    pub engines: &'r [&'r dyn Engine],
    /// The answers of earlier runs, in the order of the engines; engines behind the end of the slice have none.
    pub stores: &'r [Option<&'r dyn AnswerStore>],
    /// The limits of the search.
    pub limits: Limits,
    /// Ends the search, with what is found so far.
    pub cancel: &'r Cancellation,
}

/// How far a search is.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct CauseProgress {
    /// The number of groups that were looked at.
    pub done: u64,
    /// The number of all groups.
    pub of: u64,
}

/// Finds the causes of the failing cases of a run, those that explain most cases first.
///
/// Every group of failing cases belongs to a cause, also where the limits left no question for it; such a cause is
/// [`Reduced::Not`]. `progress` hears of each wave of groups.
///
/// # Errors
/// [`RunError::Engine`] where an engine cannot be opened, [`RunError::Workers`] where the system gives no threads.
pub fn find(
    failed: &FailedCases,
    search: &Search<'_>,
    progress: &mut dyn FnMut(CauseProgress),
) -> Result<Vec<Cause>, RunError> {
    let deadline = Instant::now().checked_add(search.limits.time);
    let stop = || search.cancel.is_requested() || deadline.is_some_and(|end| Instant::now() >= end);
    let cases = cases(failed, search.suite);
    let mut told = CauseProgress {
        done: 0,
        of: failed.groups.len() as u64,
    };
    let mut found = Vec::new();
    for (place, engine) in search.engines.iter().enumerate() {
        let of_engine = |((name, sign, _), group): (&'_ (String, Sign, String), &'_ Group)| {
            (*name == engine.identity().name).then(|| (sign.clone(), group.clone()))
        };
        let mut groups: Vec<(Sign, Group)> = failed.groups.iter().filter_map(of_engine).collect();
        // Sorting keeps the order of the keys among groups of the same size.
        groups.sort_by_key(|(_, group)| std::cmp::Reverse(group.number()));
        let asking = Asking {
            engine: *engine,
            store: search.stores.get(place).copied().flatten(),
            search,
            cases: &cases,
            stop: &stop,
        };
        let mut members = Vec::new();
        let mut left = search.limits.questions;
        for wave in groups.chunks(WAVE) {
            let tries = search.limits.questions_a_group.min(left / wave.len() as u64);
            let shown: Vec<(&Sign, &CaseEvent)> =
                wave.iter().map(|(sign, group)| (sign, &group.shown)).collect();
            let smallest = asking.smallest(&shown, tries)?;
            left = left.saturating_sub(smallest.iter().map(|smallest| smallest.questions).sum());
            let pairs = wave.iter().zip(&smallest);
            members.extend(
                pairs.map(|((_, group), smallest)| Member::new(group, smallest, &search.suite.sources)),
            );
            told.done += wave.len() as u64;
            progress(told);
        }
        let mut causes = merged(members);
        asking.second_witnesses(&mut causes, left)?;
        for member in &mut causes {
            member.cause.shown.reproduction = asking.reproduction(member);
        }
        found.extend(causes);
    }
    found.sort_by_key(|member| (std::cmp::Reverse(member.cause.number()), member.rank));
    Ok(found.into_iter().map(|member| member.cause).collect())
}

/// Returns the cases of the groups, by id and dialect.
fn cases<'s>(failed: &FailedCases, suite: &'s Suite) -> HashMap<(String, String), &'s Case> {
    let mut wanted: HashMap<(String, String), Option<&Case>> = HashMap::new();
    for group in failed.groups.values() {
        for event in [Some(&group.shown), group.second.as_ref()].into_iter().flatten() {
            wanted.insert((event.id.clone(), event.dialect.clone()), None);
        }
    }
    for case in &suite.cases {
        if let Some(found) = wanted.get_mut(&(case.id.to_string(), case.dialect.as_str().to_owned())) {
            *found = Some(case);
        }
    }
    let known = wanted.into_iter();
    known.filter_map(|(key, case)| Some((key, case?))).collect()
}

/// Asks one engine about the programs of groups.
struct Asking<'r> {
    engine: &'r dyn Engine,
    store: Option<&'r dyn AnswerStore>,
    search: &'r Search<'r>,
    cases: &'r HashMap<(String, String), &'r Case>,
    stop: &'r (dyn Fn() -> bool + Sync),
}

impl Asking<'_> {
    /// Reduces the programs of these cases, each with at most so many questions.
    fn smallest(&self, shown: &[(&Sign, &CaseEvent)], tries: u64) -> Result<Vec<Smallest>, RunError> {
        let judge = CaseJudge {
            plan: self.search.plan,
            sources: &self.search.suite.sources,
            engine: self.engine.identity(),
            baseline: None,
        };
        let open = || {
            Ok::<_, RunError>(Questioner {
                session: EngineSession::new(self.engine),
                judge,
                store: self.store,
            })
        };
        let work = |asked: &mut Questioner<'_>, (sign, event): (&Sign, &CaseEvent)| {
            let case = self.cases.get(&(event.id.clone(), event.dialect.clone()));
            match case {
                Some(case) if tries > 0 && !(self.stop)() => {
                    Ok(reduce(asked, (case, event), sign, tries, self.stop)?)
                }
                _ => Ok(Smallest::unreduced(event, sign)),
            }
        };
        WorkerPool::new(self.search.plan.jobs).map(shown.iter().copied(), open, work)
    }

    /// Looks for a second witness of the causes that were found in one group only: a case of the group with other types.
    fn second_witnesses(&self, causes: &mut [Member], left: u64) -> Result<(), RunError> {
        let without = |member: &&mut Member| {
            member.cause.second.is_none() && member.cause.reduction != Reduced::Not && member.other.is_some()
        };
        let mut without: Vec<&mut Member> = causes.iter_mut().filter(without).collect();
        if without.is_empty() {
            return Ok(());
        }
        let tries = self
            .search
            .limits
            .questions_a_group
            .min(left / without.len() as u64);
        let others: Vec<(Sign, CaseEvent)> = without
            .iter()
            .filter_map(|member| Some((member.sign.clone(), member.other.clone()?)))
            .collect();
        let others: Vec<(&Sign, &CaseEvent)> = others.iter().map(|(sign, event)| (sign, event)).collect();
        let smallest = self.smallest(&others, tries)?;
        for ((member, (_, event)), smallest) in without.iter_mut().zip(others).zip(smallest) {
            let second = witness(event, &smallest);
            if member.essence.explains(&Essence::of(&smallest)) && member.has_other_types(&second) {
                member.cause.second = Some(second);
            }
        }
        Ok(())
    }
}

impl Asking<'_> {
    /// Returns the files and commands by which a person sees the deviation of the shown program on the engine.
    fn reproduction(&self, member: &Member) -> Option<Reproduction> {
        let shown = &member.cause.shown;
        let case = self.cases.get(&(shown.case.clone(), shown.dialect.clone()))?;
        let whole = || Some(case.without_marks());
        let mut case = with_program(case, &member.sign, &shown.program).or_else(whole)?;
        // Only what differs has to be seen; where nothing is computed wrongly, nothing is observed.
        let differs = |name: &str| {
            let mut pairs = shown.expected.iter().filter(|fact| !shown.got.contains(fact));
            pairs.any(
                |fact| matches!(fact, Fact::Value { name: wrong, .. } if wrong.eq_ignore_ascii_case(name)),
            )
        };
        let observe = case.observe.iter().filter(|one| differs(&one.key().to_string()));
        case.observe = observe.cloned().collect();
        let ability = match &member.sign.symptom {
            Symptom::Crash(_) | Symptom::Hang => Ability::Execute,
            _ => shown_by(&case),
        };
        self.engine.reproduce(&case.request(), ability).ok()
    }
}

/// A cause while groups are added to it.
struct Member {
    cause: Cause,
    essence: Essence,
    sign: Sign,
    /// A case of the group with other types than the shown one.
    other: Option<CaseEvent>,
    /// Whether the shown claim does not bind the engine.
    differs: bool,
    /// The rank of the shown claim.
    rank: u8,
}

impl Member {
    /// Returns the cause of a group, by its smallest program.
    fn new(group: &Group, smallest: &Smallest, sources: &Sources) -> Member {
        let essence = Essence::of(smallest);
        let mut types = types_of(&smallest.program);
        types.sort_unstable();
        let cause = Cause {
            engine: group.shown.engine.clone(),
            symptom: essence.class.clone(),
            construct: essence.features.iter().cloned().collect::<Vec<_>>().join(", "),
            title: title(smallest),
            shown: witness(&group.shown, smallest),
            second: None,
            types: vec![types.join(", ")],
            reduction: smallest.reduction,
            flaky: smallest.flaky,
            cases: group.cases.clone(),
        };
        Member {
            differs: group.shown.verdict == Verdict::Differs,
            rank: rank(&group.shown.basis, &group.shown.engine, sources),
            cause,
            essence,
            sign: smallest.deviation.sign.clone(),
            other: group.second.clone(),
        }
    }

    /// Returns the order of members with one essence, of which the first is shown: claims by their rank, then the smaller
    /// program.
    fn preference(&self) -> (bool, u8, usize, &str) {
        let program = &self.cause.shown.program;
        (
            self.cause.reduction == Reduced::Not,
            self.rank,
            program.len(),
            program,
        )
    }

    /// Returns whether a program has other types than the shown one, so that it is worth a place as a second witness.
    fn has_other_types(&self, witness: &Witness) -> bool {
        types_of(&witness.program) != types_of(&self.cause.shown.program)
    }
}

/// Merges the members of one cause: those with the same essence, and those that contain what another needs.
fn merged(mut members: Vec<Member>) -> Vec<Member> {
    // What needs least comes first, since it can only be contained in what comes later; what may be hidden comes last.
    members.sort_by_key(|member| {
        let Essence { features, hidden, .. } = &member.essence;
        (
            hidden.is_some(),
            features.len(),
            std::cmp::Reverse(member.cause.number()),
        )
    });
    let mut causes: Vec<Member> = Vec::new();
    for member in members {
        let explaining = causes
            .iter_mut()
            .filter(|cause| cause.essence.explains(&member.essence));
        let Some(cause) = explaining.max_by_key(|cause| cause.essence.features.len()) else {
            causes.push(member);
            continue;
        };
        let mut member = member;
        let is_same = cause.essence == member.essence;
        // What contradicts a source that binds the engine is shown by such a source.
        if is_same && member.preference() < cause.preference() || cause.differs && !member.differs {
            std::mem::swap(cause, &mut member);
            std::mem::swap(&mut cause.essence, &mut member.essence);
        }
        cause.cause.explain(member.cause);
        let second = cause.cause.second.take();
        cause.cause.second = second.filter(|second| cause.has_other_types(second));
        cause.other = cause.other.take().or(member.other);
    }
    causes
}

fn witness(event: &CaseEvent, smallest: &Smallest) -> Witness {
    Witness {
        case: event.id.clone(),
        dialect: event.dialect.clone(),
        basis: event.basis.clone(),
        about: event.title.clone(),
        program: smallest.program.clone(),
        expected: smallest.deviation.expected.clone(),
        got: smallest.deviation.got.clone(),
        reproduction: None,
    }
}

/// Returns the rank of a claim among those that a cause contradicts: what the makers of the engine say themselves comes first,
/// then the standard.
fn rank(basis: &str, engine: &str, sources: &Sources) -> u8 {
    match sources.of(basis) {
        Some((source, _)) if source.engines.iter().any(|own| own == engine) => 0,
        Some((source, _)) if source.kind == SourceKind::Standard => 1,
        _ => 2,
    }
}
