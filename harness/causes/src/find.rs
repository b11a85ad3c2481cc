//! The search: reduces the smallest program of each group on the engine, and merges groups of one cause.

use crate::assignments::shows_initial_value;
use crate::claim::keeps_claim;
use crate::essence::Essence;
use crate::failed::{FailedCases, FailureGroup};
use crate::literals::valued_types;
use crate::normal::{Normal, normal_form};
use crate::operations::operations_of;
use crate::promised::{cite, promise};
use crate::question::{Questioner, SearchAnswers, shown_case};
use crate::reduction::{Smallest, is_reducible, reduce};
use crate::shape::types_of;
use crate::sign::Sign;
use crate::title::title;
use crate::tokens::tokens;
use crate::twins::value_features;
use std::collections::HashMap;
use std::time::{Duration, Instant};
use stickler_engines::{Ability, Engine, EngineSession, Identity, Reproduction, reproduce_and_run};
use stickler_run::{
    AnswerStore, CaseEvent, CaseJudge, Cause, Fact, Grade, Plan, Reduced, Reproducer, RunError, Symptom,
    Verdict, shown_by,
};
use stickler_suite::{Case, SourceKind, Sources, Suite};
use stickler_types::Observation;
use stickler_workers::{Cancellation, WorkerPool};

/// The number of groups that are reduced before the questions that are left are counted. It does not depend on the number
/// of threads, so that the same groups are reduced on every machine.
const WAVE: usize = 32;

/// The maximum number of characters that are kept of what the commands of a reproduction print.
const MAX_PRINTED: usize = 10_000;

/// The limits of a search.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SearchLimits {
    /// The maximum number of questions to each engine, about as many as programs that it has to run.
    pub questions: u64,
    /// The maximum number of questions for one group of cases.
    pub questions_a_group: u64,
    /// The time after which no more questions are asked. What is found then depends on the speed of the machine.
    pub time: Duration,
}

impl Default for SearchLimits {
    /// Returns limits of 100 000 questions to each engine, 200 for a group, and ten minutes.
    fn default() -> SearchLimits {
        SearchLimits {
            questions: 100_000,
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
    pub limits: SearchLimits,
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
/// [`Reduced::Partly`]. `progress` hears of each wave of groups.
///
/// # Errors
/// [`RunError::Engine`] where an engine cannot be opened, [`RunError::Workers`] where the system gives no threads.
pub fn find(
    failed: &FailedCases<'_>,
    search: &Search<'_>,
    progress: &mut dyn FnMut(CauseProgress),
) -> Result<Vec<Cause>, RunError> {
    let deadline = Instant::now().checked_add(search.limits.time);
    let stop = || search.cancel.is_requested() || deadline.is_some_and(|end| Instant::now() >= end);
    let cases = cases(failed, search.suite);
    let mut reported = CauseProgress {
        done: 0,
        of: failed.groups.len() as u64,
    };
    let mut found = Vec::new();
    for (place, engine) in search.engines.iter().enumerate() {
        let of_engine = |((name, sign, _), group): (&'_ (String, Sign, String), &'_ FailureGroup)| {
            (*name == engine.identity().name).then(|| (sign.clone(), group.clone()))
        };
        let mut groups: Vec<(Sign, FailureGroup)> = failed.groups.iter().filter_map(of_engine).collect();
        // Sorting keeps the order of the keys among groups of the same size.
        groups.sort_by_key(|(_, group)| std::cmp::Reverse(group.number()));
        let asking = Asking {
            engine: *engine,
            store: search.stores.get(place).copied().flatten(),
            answered: SearchAnswers::default(),
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
            left = left.saturating_sub(smallest.iter().map(ReducedGroup::questions).sum());
            let pairs = wave.iter().zip(&smallest);
            let identity = engine.identity();
            members.extend(pairs.map(|((_, group), found)| {
                let case = cases.get(&(group.shown.id.clone(), group.shown.dialect.clone()));
                GrowingCause::new(group, found, case.copied(), (identity, &search.suite.sources))
            }));
            reported.done += wave.len() as u64;
            progress(reported);
        }
        let mut causes = merged(members);
        asking.second_witnesses(&mut causes, left)?;
        asking.reproduce(&mut causes)?;
        found.extend(causes);
    }
    found.sort_by(|one, other| {
        let key = |member: &GrowingCause| (std::cmp::Reverse(member.cause.number()), member.rank);
        (key(one), &one.cause.title).cmp(&(key(other), &other.cause.title))
    });
    Ok(found.into_iter().map(|member| member.cause).collect())
}

/// Returns the cases of the groups, by id and dialect.
fn cases<'s>(failed: &FailedCases<'_>, suite: &'s Suite) -> HashMap<(String, String), &'s Case> {
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

/// The smallest program of a group, and its normal form.
struct ReducedGroup {
    smallest: Smallest,
    normal: Normal,
}

impl ReducedGroup {
    fn unreduced(event: &CaseEvent, sign: &Sign) -> ReducedGroup {
        let mut smallest = Smallest::unreduced(event, sign);
        if is_reducible(&sign.symptom) {
            smallest.reduction = Reduced::Partly;
        }
        let mut normal = Normal::unasked(&smallest);
        // Nobody knows which of them the defect does not need.
        if matches!(sign.symptom, Symptom::Value | Symptom::Missing) {
            normal.labels = value_features(&smallest.program);
        }
        ReducedGroup { smallest, normal }
    }

    /// Removes the codes from the expected diagnostics where the engine is not asked for them.
    fn without_codes(mut self, asked: &Questioner<'_>) -> ReducedGroup {
        for deviation in [&mut self.smallest.deviation, &mut self.normal.deviation] {
            let codes = deviation.expected.iter();
            let codes = codes.filter_map(|fact| fact.diagnostic()?.registered_code());
            if asked.judge.plan.needed_for(asked.judge.engine, codes) != Grade::Code {
                for fact in &mut deviation.expected {
                    if let Fact::Diagnostic(expected) | Fact::Warning(expected) = fact {
                        expected.code = None;
                    }
                }
            }
        }
        self
    }

    /// Returns the number of times that the engine was asked.
    fn questions(&self) -> u64 {
        self.smallest.questions + self.normal.questions
    }
}

/// Asks one engine about the programs of groups.
struct Asking<'r> {
    engine: &'r dyn Engine,
    store: Option<&'r dyn AnswerStore>,
    answered: SearchAnswers,
    search: &'r Search<'r>,
    cases: &'r HashMap<(String, String), &'r Case>,
    stop: &'r (dyn Fn() -> bool + Sync),
}

impl Asking<'_> {
    /// Reduces the programs of these cases, each with at most so many questions.
    fn smallest(&self, shown: &[(&Sign, &CaseEvent)], tries: u64) -> Result<Vec<ReducedGroup>, RunError> {
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
                answered: &self.answered,
            })
        };
        let work = |asked: &mut Questioner<'_>, (sign, event): (&Sign, &CaseEvent)| {
            let case = self.cases.get(&(event.id.clone(), event.dialect.clone()));
            match case {
                Some(case) if tries > 0 && !(self.stop)() => {
                    let sign = asked.sign(case, sign)?;
                    let smallest = reduce(asked, (case, event), &sign, tries, self.stop)?;
                    let left = tries.saturating_sub(smallest.questions).max(tries / 4);
                    let normal = normal_form(asked, case, &smallest, left, self.stop)?;
                    let found = ReducedGroup { smallest, normal };
                    Ok(found.without_codes(asked))
                }
                _ => Ok(ReducedGroup::unreduced(event, sign).without_codes(asked)),
            }
        };
        WorkerPool::new(self.search.plan.jobs).map(shown.iter().copied(), open, work)
    }

    /// Looks for a second witness of the causes that were found in one group only: a case of the group with other types.
    fn second_witnesses(&self, causes: &mut [GrowingCause], left: u64) -> Result<(), RunError> {
        let without = |member: &&mut GrowingCause| {
            member.cause.second.is_none() && member.cause.reduction != Reduced::Not && member.other.is_some()
        };
        let mut without: Vec<&mut GrowingCause> = causes.iter_mut().filter(without).collect();
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
            let second = reproducer(event, &smallest.smallest);
            if member
                .essence
                .explains(&Essence::of(&smallest.smallest, &smallest.normal))
                && member.has_other_types(&second)
            {
                member.cause.second = Some(second);
            }
        }
        Ok(())
    }
}

impl Asking<'_> {
    /// Finds the files and commands by which a person sees each deviation on the engine, and what these print.
    fn reproduce(&self, causes: &mut [GrowingCause]) -> Result<(), RunError> {
        let open = || Ok::<_, RunError>(());
        let work = |(): &mut (), member: &GrowingCause| Ok::<_, RunError>(self.reproduction(member));
        let found = WorkerPool::new(self.search.plan.jobs).map(causes.iter(), open, work)?;
        for (member, found) in causes.iter_mut().zip(found) {
            if let Some((reproduction, printed)) = found {
                member.cause.shown.reproduction = Some(reproduction);
                member.cause.shown.printed = printed;
            }
        }
        Ok(())
    }

    /// Returns the reproduction of the shown program, and what its commands print; nothing where the search was cancelled, or ended before
    /// the program was small, since most such programs show another cause again.
    fn reproduction(&self, member: &GrowingCause) -> Option<(Reproduction, String)> {
        let shown = &member.cause.shown;
        let case = self.cases.get(&(shown.case.clone(), shown.dialect.clone()))?;
        // Only what differs has to be seen; where nothing is computed wrongly, nothing is observed.
        let differing = shown.expected.iter().filter(|fact| !shown.got.contains(fact));
        let wrong: Vec<&str> = differing
            .filter_map(|fact| match fact {
                Fact::Value { name, .. } => Some(name.as_str()),
                _ => None,
            })
            .collect();
        let is_wrong = |one: &Observation| {
            let key = one.key().to_string();
            wrong.iter().any(|name| name.eq_ignore_ascii_case(&key))
        };
        let mut case = shown_case(case, &member.sign, shown);
        let observe = case.observe.iter().filter(|one| is_wrong(one));
        case.observe = observe.cloned().collect();
        let ability = match &member.sign.symptom {
            Symptom::Crash(_) | Symptom::Unusable(_) | Symptom::Hang => Ability::Execute,
            _ => shown_by(&case),
        };
        let request = case.request();
        if self.search.cancel.is_requested() || member.cause.is_partly_reduced() {
            return Some((self.engine.reproduce(&request, ability).ok()?, String::new()));
        }
        let (reproduction, output) = reproduce_and_run(self.engine, &request, ability).ok()?;
        let printed = output.map_or_else(|reason| reason, |output| output.text);
        Some((reproduction, beginning(&printed)))
    }
}

/// A cause while groups are added to it.
struct GrowingCause {
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

impl GrowingCause {
    /// Returns the cause of a group, by its smallest program. `case` is that of the program.
    fn new(
        group: &FailureGroup,
        found: &ReducedGroup,
        case: Option<&Case>,
        (engine, sources): (&Identity, &Sources),
    ) -> GrowingCause {
        let ReducedGroup { smallest, normal } = found;
        let essence = Essence::of(smallest, normal);
        let types = |program: &str| valued_types(&tokens(program)).len();
        let is_plain = operations_of(&smallest.program).is_subset(&operations_of(&normal.program))
            && types(&smallest.program) <= types(&normal.program);
        // An operand that the engine does not take alone is shown alone, unless the program does nothing else; so is a valid program
        // that is rejected like one with a mistake.
        let hides = smallest.deviation.sign.is_rejected_otherwise() && normal.program != smallest.program;
        let is_other = normal.is_operand && !is_plain && !smallest.deviation.sign.accepts();
        let begins = normal.is_beginning && !shows_initial_value(smallest);
        let is_derived = hides || is_other || begins;
        let mut shown = match is_derived {
            true => normal.as_smallest(smallest),
            false => smallest.clone(),
        };
        let is_derived = is_derived || !keeps_claim(&group.shown, smallest);
        if is_derived {
            shown.deviation.forget_promise();
        }
        // What the claim of the case does not speak of, another one may promise.
        let promised = case
            .filter(|_| is_derived || is_missing(&shown, &essence))
            .filter(|_| group.shown.verdict != Verdict::Differs)
            .and_then(|case| promise(&shown, &essence, case, (engine, sources)));
        if let Some(basis) = promised {
            cite(&mut shown.deviation.got, basis, sources);
        }
        let basis = promised.unwrap_or(&group.shown.basis);
        let is_derived = is_derived && promised.is_none();
        let shown = &shown;
        let mut types = types_of(&shown.program);
        types.sort_unstable();
        let cause = Cause {
            engine: group.shown.engine.clone(),
            symptom: essence.class.clone(),
            construct: essence.construct(),
            title: title(shown, engine.grade == Grade::Code),
            shown: Reproducer {
                is_derived,
                basis: basis.to_owned(),
                ..reproducer(&group.shown, shown)
            },
            second: None,
            types: vec![types.join(", ")],
            reduction: smallest.reduction,
            flaky: smallest.flaky.clone(),
            cases: group.cases.clone(),
        };
        GrowingCause {
            differs: group.shown.verdict == Verdict::Differs,
            rank: rank(basis, &group.shown.engine, sources),
            cause,
            essence,
            sign: shown.deviation.sign.clone(),
            other: group.second.clone(),
        }
    }

    /// Returns the order of members with one essence, of which the first is shown: programs of which the claim of their case
    /// still speaks, then claims by their rank, then the smaller program.
    fn preference(&self) -> (u8, bool, u8, usize, &str) {
        let program = &self.cause.shown.program;
        (
            match self.cause.reduction {
                Reduced::Smallest => 0,
                Reduced::Partly => 1,
                Reduced::Not => 2,
            },
            self.cause.shown.is_derived,
            self.rank,
            program.len(),
            program,
        )
    }

    /// Returns whether a program has other types than the shown one, so that it is worth a place as a second witness.
    fn has_other_types(&self, reproducer: &Reproducer) -> bool {
        types_of(&reproducer.program) != types_of(&self.cause.shown.program)
    }
}

/// Merges the members of one cause: those with the same essence, and those that contain what another needs.
fn merged(mut members: Vec<GrowingCause>) -> Vec<GrowingCause> {
    // What needs least comes first, since it can only be contained in what comes later; what may be hidden comes last.
    members.sort_by_key(|member| {
        let Essence {
            features,
            labels,
            hidden,
            ..
        } = &member.essence;
        (
            hidden.is_some(),
            features.len(),
            labels.len(),
            std::cmp::Reverse(member.cause.number()),
        )
    });
    let mut causes: Vec<GrowingCause> = Vec::new();
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
        // What contradicts a source that binds the engine is shown by such a source, and a program that is not taken by one of which a
        // claim still speaks.
        let is_claimed = cause.sign.rejects_valid()
            && cause.cause.shown.is_derived
            && !member.cause.shown.is_derived
            && member.cause.reduction == Reduced::Smallest;
        if is_same && member.preference() < cause.preference()
            || is_claimed && member.differs <= cause.differs
            || cause.differs && !member.differs
        {
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

/// Returns whether a construct itself is not implemented, whatever the claim of the case is about.
fn is_missing(shown: &Smallest, essence: &Essence) -> bool {
    matches!(shown.deviation.sign.symptom, Symptom::NotImplemented(_))
        && !essence.features.contains("bit access")
}

fn reproducer(event: &CaseEvent, smallest: &Smallest) -> Reproducer {
    Reproducer {
        case: event.id.clone(),
        dialect: event.dialect.clone(),
        basis: event.basis.clone(),
        about: event.title.clone(),
        file: event.file.clone(),
        line: event.line,
        program: smallest.program.clone(),
        expected: smallest.deviation.expected.clone(),
        got: smallest.deviation.got.clone(),
        is_derived: false,
        reproduction: None,
        printed: String::new(),
    }
}

/// Returns the beginning of a text.
fn beginning(text: &str) -> String {
    text.chars().take(MAX_PRINTED).collect()
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
