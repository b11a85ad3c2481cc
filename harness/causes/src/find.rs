//! The search: reduces the smallest program of each group on the engine, and merges groups of one cause.

use crate::failed::{FailedCases, FailureGroup, LackedFeatures};
use crate::failure_sign::Sign;
use crate::growing_cause::{GrowingCause, merged, merged_with_neighbours};
use crate::normal_form::normal_form;
use crate::question::{Questioner, SearchAnswers};
use crate::reduced_group::{OpenGroups, ReducedGroup};
use crate::reduction::reduce;
use std::collections::{HashMap, HashSet};
use std::time::{Duration, Instant};
use stickler_engines::{Engine, EngineSession, end_questions_at};
use stickler_run::{AnswerStore, CaseEvent, CaseJudge, Cause, Plan, Reduced, RunError, Verdict};
use stickler_suite::{Case, Suite};
use stickler_workers::{Cancellation, WorkerPool};

/// The number of groups that are reduced before the questions that are left are counted. It does not depend on the number
/// of threads, so that the same groups are reduced on every machine.
const WAVE: usize = 32;

/// The numbers of questions for each group before any group gets more: one for what an operand shows alone, and then enough for a
/// program that is nearly as small as it can be and for its plainest form.
const QUESTIONS_FIRST: [u64; 2] = [1, 32];

/// The time for one question of a search: what takes longer is no smaller program.
const QUESTION_TIME: Duration = Duration::from_secs(4);

/// The time for the questions about one group in each round: others wait for it.
const GROUP_TIME: Duration = Duration::from_secs(20);

/// The maximum number of programs that an engine is asked about together: of many, some are asked about for nothing.
const MAX_PACK_LEN: usize = 12;

/// The share of the time of a search that is left for what belongs to a page: the neighbours of a program, and the commands that show it. It
/// is one part of so many, the first half of it for the neighbours.
const REPRODUCTION_SHARE: u32 = 5;

/// The limits of a search.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct SearchLimits {
    /// The maximum number of questions to each engine, about as many as programs that it has to run.
    pub questions: u64,
    /// The maximum number of questions for one group of cases.
    pub questions_a_group: u64,
    /// The time after which no more questions are asked, and at which the last ones are cut off; its last fifth is for the
    /// neighbours and the commands of what was found. What is found then depends on the speed of the machine.
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

/// The progress of a search.
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
/// [`Reduced::Partly`]. `progress` hears of each group that is finished.
///
/// # Errors
/// [`RunError::Engine`] where an engine cannot be opened, [`RunError::Workers`] where the system gives no threads.
pub fn find(
    failed: &FailedCases<'_>,
    search: &Search<'_>,
    progress: &mut dyn FnMut(CauseProgress),
) -> Result<Vec<Cause>, RunError> {
    let found = find_before_end(failed, search, progress);
    end_questions_at(None);
    found
}

fn find_before_end(
    failed: &FailedCases<'_>,
    search: &Search<'_>,
    progress: &mut dyn FnMut(CauseProgress),
) -> Result<Vec<Cause>, RunError> {
    let begun = Instant::now();
    let deadline = begun.checked_add(search.limits.time - search.limits.time / REPRODUCTION_SHARE);
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
        end_questions_at(deadline.map(|end| (end, QUESTION_TIME)));
        let asking = Asking {
            engine: *engine,
            store: search.stores.get(place).copied().flatten(),
            answered: SearchAnswers::default(),
            lacked: &failed.lacked,
            search,
            cases: &cases,
            stop: &stop,
        };
        let shown: Vec<(&Sign, &CaseEvent)> =
            groups.iter().map(|(sign, group)| (sign, &group.shown)).collect();
        let smallest = asking.in_rounds(&shown, &mut |done| {
            reported.done += done;
            progress(reported);
        })?;
        let identity = engine.identity();
        let pairs = groups.iter().zip(&smallest);
        let members = pairs.map(|((_, group), found)| {
            let case = cases.get(&(group.shown.id.clone(), group.shown.dialect.clone()));
            let found = (&found.smallest, &found.normal);
            GrowingCause::new(group, found, case.copied(), (identity, search.suite))
        });
        let mut causes = merged(members.collect());
        for member in &mut causes {
            let shown = &member.cause.shown;
            if let Some(case) = cases.get(&(shown.case.clone(), shown.dialect.clone())) {
                member.cite_place(case, (identity, search.suite));
            }
        }
        let end = begun.checked_add(search.limits.time);
        let half = begun.checked_add(search.limits.time - search.limits.time / (2 * REPRODUCTION_SHARE));
        let stop = || search.cancel.is_requested() || half.is_some_and(|end| Instant::now() >= end);
        end_questions_at(half.map(|end| (end, QUESTION_TIME)));
        asking.neighbours(&mut causes, &stop)?;
        let mut causes = merged_with_neighbours(causes);
        end_questions_at(end.map(|end| (end, Duration::MAX)));
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
    let shown = failed.groups.values().map(|group| &group.shown);
    let wanted: HashSet<(&str, &str)> = shown.map(|event| (&*event.id, &*event.dialect)).collect();
    let is_wanted = |case: &&Case| wanted.contains(&(&*case.id, case.dialect.as_str()));
    let key = |case: &Case| (case.id.to_string(), case.dialect.as_str().to_owned());
    let cases = suite.cases.iter().filter(is_wanted);
    cases.map(|case| (key(case), case)).collect()
}

/// Asks one engine about the programs of groups.
pub(crate) struct Asking<'r> {
    pub(crate) engine: &'r dyn Engine,
    store: Option<&'r dyn AnswerStore>,
    answered: SearchAnswers,
    lacked: &'r LackedFeatures,
    pub(crate) search: &'r Search<'r>,
    pub(crate) cases: &'r HashMap<(String, String), &'r Case>,
    stop: &'r (dyn Fn() -> bool + Sync),
}

impl Asking<'_> {
    /// Reduces the programs of groups: all with few questions, and then those that need more. So a limit of time leaves none unasked.
    /// `progress` hears of each group that is finished.
    fn in_rounds(
        &self,
        shown: &[(&Sign, &CaseEvent)],
        progress: &mut dyn FnMut(u64),
    ) -> Result<Vec<ReducedGroup>, RunError> {
        let SearchLimits {
            questions: mut left,
            questions_a_group: most,
            ..
        } = self.search.limits;
        let unreduced = shown.iter().map(|(sign, event)| ReducedGroup {
            is_open: true,
            ..ReducedGroup::unreduced(event, sign)
        });
        let mut found: Vec<ReducedGroup> = unreduced.collect();
        for tries in QUESTIONS_FIRST
            .map(|first| first.min(most))
            .into_iter()
            .chain([most])
        {
            let is_long = |at: &usize| found[*at].is_long();
            let open = (0..shown.len()).filter(|at| found[*at].is_open);
            // A compiler may take seconds for each question about a long program, so that they are asked about once, in the end.
            let open = open.filter(|at| tries == most || !is_long(at)).collect();
            let mut open = OpenGroups::new(open, &found);
            while let Some(wave) = open.next(WAVE, tries == most, &found) {
                let tries = tries.min(left / wave.len() as u64);
                let smallest = self.smallest(wave.iter().map(|at| shown[*at]), tries)?;
                for (at, mut smaller) in wave.iter().copied().zip(smallest) {
                    left = left.saturating_sub(smaller.questions());
                    // What was not asked to its end may show another cause.
                    if smaller.is_open && (self.stop)() {
                        smaller.smallest.end_partly();
                    }
                    smaller.is_open &= tries < most && !(self.stop)();
                    progress(u64::from(!smaller.is_open));
                    // A program that does in one scan what another does in several is longer.
                    match found[at].questions() == 0 || smaller.distance() <= found[at].distance() {
                        true => found[at] = smaller,
                        false if (self.stop)() => found[at].smallest.end_partly(),
                        false => found[at].is_open = false,
                    }
                }
                open.note(wave.iter().map(|at| (*at, &found[*at])));
            }
        }
        let open = found.iter_mut().filter(|group| group.is_open);
        open.for_each(|group| group.smallest.end_partly());
        Ok(found)
    }

    /// Opens a session with the engine, for questions.
    pub(crate) fn questioner(&self) -> Questioner<'_> {
        let judge = CaseJudge {
            plan: self.search.plan,
            suite: self.search.suite,
            engine: self.engine.identity(),
            lacks: None,
            baseline: None,
        };
        Questioner {
            session: EngineSession::new(self.engine),
            judge,
            store: self.store,
            answered: &self.answered,
            lacked: self.lacked,
            pack_size: match self.search.plan.unpacked {
                true => 1,
                false => self.engine.pack_size().min(MAX_PACK_LEN),
            },
            only_checks: false,
        }
    }

    /// Reduces the programs of these cases, each with at most so many questions.
    fn smallest<'c>(
        &self,
        shown: impl ExactSizeIterator<Item = (&'c Sign, &'c CaseEvent)>,
        tries: u64,
    ) -> Result<Vec<ReducedGroup>, RunError> {
        let open = || Ok::<_, RunError>(self.questioner());
        let work = |asked: &mut Questioner<'_>, (sign, event): (&Sign, &CaseEvent)| {
            let case = self.cases.get(&(event.id.clone(), event.dialect.clone()));
            match case {
                Some(&case) if tries > 0 && !(self.stop)() => {
                    let begun = Instant::now();
                    let stop = || (self.stop)() || begun.elapsed() > GROUP_TIME;
                    asked.only_checks = false;
                    let one_scan = asked.in_one_scan((case, event), sign)?;
                    let (case, event, died) = match &one_scan {
                        Some((case, event, sign)) => (case, event, sign),
                        None => (case, event, sign),
                    };
                    let sign = asked.sign(case, died)?;
                    asked.only_checks = sign.accepts();
                    let mut smallest = reduce(asked, (case, event), &sign, tries, &stop)?;
                    let rendered = asked.of_rendered_text((case, event), &smallest)?;
                    let case = match &rendered {
                        Some((case, event, sign)) => {
                            smallest = reduce(asked, (case, event), sign, tries, &stop)?;
                            case
                        }
                        None => case,
                    };
                    let left = tries.saturating_sub(smallest.questions).max(tries / 4);
                    let normal = normal_form(asked, case, &smallest, left, &stop)?;
                    // Without its plainest form a program may show another cause than it seems to.
                    if stop() {
                        smallest.end_partly();
                    }
                    let found = ReducedGroup {
                        is_open: smallest.reduction == Reduced::Partly || normal.questions >= left,
                        smallest,
                        normal,
                        differs: event.verdict == Verdict::Differs,
                    };
                    Ok(found.without_codes(&event.basis, asked))
                }
                _ => Ok(ReducedGroup::unreduced(event, sign).without_codes(&event.basis, asked)),
            }
        };
        WorkerPool::new(self.search.plan.jobs).map(shown, open, work)
    }
}
