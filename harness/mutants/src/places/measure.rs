//! Runs the cases of the suite against every saboteur, and counts how many notice.

use super::analysis::Analysis;
use super::saboteur::Saboteur;
use super::site::sites;
use rustc_hash::FxHashMap;
use std::collections::{BTreeMap, BTreeSet};
use stickler_engines::{Engine, EngineSession, Outcome, Reference};
use stickler_run::{Plan, Verdict, ask, judge};
use stickler_suite::Case;
use stickler_types::Dialect;
use stickler_workers::WorkerPool;

/// The cases that were run against one saboteur.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Tally {
    /// The number of cases in whose program the saboteur breaks something.
    pub met: usize,
    /// The number of those to which it answers otherwise than the reference.
    pub changed: usize,
    /// The number of those that fail.
    pub noticed: usize,
    /// The number of those that are changed and only record what happens, because no document says what must.
    pub recorded: usize,
    /// The key of the first case that is changed; of the first that the saboteur breaks something in, where none is.
    pub example: Option<String>,
}

/// The number of cases that a thread takes at a time.
const CHUNK: usize = 256;

/// Runs cases against all saboteurs that `wanted` selects. A case is run against those that break something in its program: to
/// all others it is the same as the reference.
///
/// # Errors
/// A message where no thread can be started, or where a case fails without a saboteur.
pub fn measure(
    cases: &[Case],
    jobs: usize,
    wanted: impl Fn(&Saboteur) -> bool + Sync,
) -> anyhow::Result<BTreeMap<Saboteur, Tally>> {
    let measured = WorkerPool::new(jobs).map(
        cases.chunks(CHUNK),
        || Ok(()),
        |(), chunk| {
            let mut tallies = FxHashMap::default();
            for case in chunk {
                try_case(case, &wanted, &mut tallies)?;
            }
            Ok::<_, anyhow::Error>(tallies)
        },
    )?;
    let mut all = BTreeMap::<Saboteur, Tally>::new();
    for tallies in measured {
        for (saboteur, tally) in tallies {
            let sum = all.entry(saboteur).or_default();
            let first_changed = sum.changed == 0 && tally.changed > 0;
            if sum.example.is_none() || first_changed {
                sum.example = tally.example;
            }
            sum.met += tally.met;
            sum.changed += tally.changed;
            sum.noticed += tally.noticed;
            sum.recorded += tally.recorded;
        }
    }
    Ok(all)
}

fn try_case(
    case: &Case,
    wanted: &impl Fn(&Saboteur) -> bool,
    tallies: &mut FxHashMap<Saboteur, Tally>,
) -> anyhow::Result<()> {
    let analysis = Analysis::new(&case.source, Dialect::of(case.dialect));
    let sites = sites(&analysis, case.expectation.rendered.is_some());
    let saboteurs: BTreeSet<Saboteur> = sites.iter().flat_map(Saboteur::of).filter(wanted).collect();
    if saboteurs.is_empty() {
        return Ok(());
    }
    let reference = Reference::new();
    let right = ask(&mut EngineSession::open(&reference)?, case)?;
    let strict = Plan::default().needed(reference.identity(), case);
    let verdict = judge(case, &right, strict).verdict;
    anyhow::ensure!(
        verdict == Verdict::Pass,
        "{} fails without a saboteur; `cargo run` shows why",
        case.key()
    );
    for saboteur in saboteurs {
        let engine = saboteur.engine();
        let answers = ask(&mut EngineSession::open(&engine)?, case)?;
        let broken = answers
            .outcomes()
            .find(|outcome| matches!(outcome, Outcome::Crashed { .. } | Outcome::Error { .. }));
        anyhow::ensure!(
            broken.is_none(),
            "{saboteur} breaks the machine and not a claim, in {}",
            case.key()
        );
        let tally = tallies.entry(saboteur).or_default();
        tally.met += 1;
        let example = tally.example.get_or_insert_with(|| case.key());
        if answers != right {
            if tally.changed == 0 {
                *example = case.key();
            }
            tally.changed += 1;
            tally.recorded += usize::from(case.is_open());
            tally.noticed += usize::from(judge(case, &answers, strict).verdict != Verdict::Pass);
        }
    }
    Ok(())
}
