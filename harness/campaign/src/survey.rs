//! The survey before a campaign: engines are asked for each part of the language alone, so that the programs of the campaign
//! need nothing that is known to fail.
//!
//! A part of the language is a word of [`Exclusions`]. First an engine is given small random programs that together use all
//! parts; a program that it gets right shows that its parts are there. Of each part that is left it is asked the minimal program. An
//! engine that fails with that program is blamed for the part, unless the program contains another one for which it is blamed.

mod probes;

use crate::differential::{Agreement, EngineUnderTest, JudgedProgram, ask_all};
use crate::exclusions::{Exclusions, UnknownWord};
use crate::inputs::Inputs;
use crate::run::CampaignError;
use probes::{ProbeProgram, ProbeSource, SurveyProbe};
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use std::time::{Duration, Instant};
use stickler_engines::{EngineSession, Outcome};
use stickler_types::{DialectName, distinct};
use stickler_workers::WorkerPool;

/// The number of times that an engine is given random programs with the parts that are left.
const COVERING_ROUNDS: usize = 3;

/// The number of programs that a worker is given at a time, where an engine takes one at a time.
const CHUNK_LEN: usize = 8;

/// The plan of a survey.
pub struct SurveyPlan<'s> {
    /// The engines of the campaign; the reference is not asked.
    pub engines: &'s [EngineUnderTest<'s>],
    /// The dialects of the campaign; an engine is asked only for those that it speaks.
    pub dialects: &'s [DialectName],
    /// The parts of the language that are left out anyway.
    pub without: &'s Exclusions,
    /// The number of workers; 0 stands for one a processor.
    pub jobs: usize,
    /// The time that the survey may take; `None` where it has no limit.
    pub time: Option<Duration>,
    /// Returns whether the survey may ask more.
    pub going: &'s (dyn Fn() -> bool + Sync),
}

/// The result of a survey.
#[derive(Clone, PartialEq, Debug, Default)]
pub struct Survey {
    /// The parts of the language with which an engine fails alone, those that most programs have first.
    pub failing: Vec<FailingPart>,
    /// The number of parts that engines were asked for.
    pub asked: u64,
    /// The number of parts that they should have been asked for.
    pub parts: u64,
    /// The time that the slowest engine took for one program, in packs where it takes several at a time.
    pub pace: Duration,
    /// The time that the survey took.
    pub elapsed: Duration,
}

/// A part of the language with which an engine fails alone.
#[derive(Clone, PartialEq, Eq, Debug, Serialize, Deserialize)]
pub struct FailingPart {
    /// The name of the engine.
    pub engine: String,
    /// The dialect of the program.
    pub dialect: String,
    /// The word for the part.
    pub word: String,
    /// The symptom in a word, such as `rejected:P4017` or `value:INT`.
    pub symptom: String,
    /// The program that shows it.
    pub program: String,
}

/// Asks the engines of a campaign for each part of the language alone.
///
/// # Errors
/// [`CampaignError`] where an engine or a thread cannot be started.
pub fn survey(plan: &SurveyPlan<'_>) -> Result<Survey, CampaignError> {
    let begun = Instant::now();
    let going = || (plan.going)() && plan.time.is_none_or(|time| begun.elapsed() < time);
    let plan = &SurveyPlan {
        going: &going,
        ..*plan
    };
    let mut survey = Survey::default();
    for &dialect in plan.dialects {
        let foreign =
            |engine: &&EngineUnderTest<'_>| !engine.is_reference && engine.identity().speaks(dialect);
        let mut engines = plan.engines.iter().filter(foreign).peekable();
        if engines.peek().is_none() {
            continue;
        }
        let source = ProbeSource::new(dialect, plan.without);
        for engine in engines {
            survey.ask(plan, engine, &source)?;
        }
    }
    survey.elapsed = begun.elapsed();
    Ok(survey)
}

impl Survey {
    /// Returns the number of bytes of the largest inputs that suit the speed of the engines: short programs where one takes long,
    /// for these are reduced with fewer questions.
    pub fn input_len(&self) -> usize {
        /// The times for one program from which on inputs are at most so long.
        const LENGTHS: [(Duration, usize); 2] =
            [(Duration::from_millis(40), 256), (Duration::from_millis(5), 512)];
        let slow = LENGTHS.iter().find(|(pace, _)| self.pace >= *pace);
        slow.map_or(Inputs::MAX_LEN, |(_, length)| *length)
    }

    /// Returns the words for what failed, for [`Exclusions`]: with the dialect where the part did not fail in all of these.
    pub fn words(&self, dialects: &[DialectName]) -> Vec<String> {
        let word = |part: &FailingPart| {
            let fails_in = |dialect: &DialectName| {
                let mut failing = self.failing.iter();
                failing.any(|other| other.word == part.word && other.dialect == dialect.as_str())
            };
            match dialects.iter().all(fails_in) {
                true => part.word.clone(),
                false => format!("{}@{}", part.word, part.dialect),
            }
        };
        distinct(self.failing.iter().map(word))
    }

    /// Returns the exclusions of a campaign: these words and those for what failed.
    ///
    /// # Errors
    /// [`UnknownWord`] where one of the words stands for nothing.
    pub fn exclusions(&self, words: &[String], dialects: &[DialectName]) -> Result<Exclusions, UnknownWord> {
        let mut all = words.to_vec();
        all.extend(self.words(dialects));
        Exclusions::new(&all)
    }

    /// Asks one engine in one dialect.
    fn ask(
        &mut self,
        plan: &SurveyPlan<'_>,
        engine: &EngineUnderTest<'_>,
        source: &ProbeSource,
    ) -> Result<(), CampaignError> {
        let mut suspects = source.words();
        let parts = suspects.len();
        self.parts += parts as u64;
        let mut covering = source.covering();
        for _ in 0..COVERING_ROUNDS {
            let programs = covering.next(&suspects);
            let symptoms = self.symptoms(plan, engine, &programs)?;
            for (program, symptom) in programs.iter().zip(symptoms) {
                if symptom == Some(None) {
                    suspects.retain(|word| !program.words.contains(word));
                }
            }
        }
        self.asked += (parts - suspects.len()) as u64;
        self.blame(plan, engine, source, &suspects)
    }

    /// Asks one engine for each part that no program has shown to be there.
    fn blame(
        &mut self,
        plan: &SurveyPlan<'_>,
        engine: &EngineUnderTest<'_>,
        source: &ProbeSource,
        suspects: &BTreeSet<String>,
    ) -> Result<(), CampaignError> {
        let probes = source.probes(suspects);
        let programs: Vec<&ProbeProgram> = probes.iter().map(|probe| &probe.program).collect();
        let symptoms = self.symptoms(plan, engine, &programs)?;
        self.asked += symptoms.iter().flatten().count() as u64;
        let mut blamed: BTreeSet<String> = BTreeSet::new();
        for (SurveyProbe { word, program }, symptom) in probes.into_iter().zip(symptoms) {
            if let Some(Some(symptom)) = symptom
                && program.words.is_disjoint(&blamed)
            {
                blamed.insert(word.clone());
                self.failing.push(FailingPart {
                    engine: engine.identity().name.clone(),
                    dialect: source.dialect.as_str().to_owned(),
                    word,
                    symptom,
                    program: program.text,
                });
            }
        }
        Ok(())
    }

    /// Returns the symptom that an engine shows on each program, `Some(None)` where it does what it must, and `None` where it was
    /// not asked.
    fn symptoms(
        &mut self,
        plan: &SurveyPlan<'_>,
        engine: &EngineUnderTest<'_>,
        programs: &[&ProbeProgram],
    ) -> Result<Vec<Option<Option<String>>>, CampaignError> {
        let begun = Instant::now();
        let pool = WorkerPool::new(plan.jobs);
        let chunk = engine.engine.pack_size().max(CHUNK_LEN);
        let open = || Ok::<_, CampaignError>(EngineSession::open(engine.engine)?);
        let work = |session: &mut EngineSession<'_>, chunk: &[&ProbeProgram]| {
            Ok(symptoms_of(session, chunk, plan.going))
        };
        let all: Vec<_> = pool.map(programs.chunks(chunk), open, work)?.concat();
        let reached = u32::try_from(all.iter().flatten().count()).unwrap_or(u32::MAX);
        if reached > 0 {
            let threads = pool.threads().min(programs.len().div_ceil(chunk));
            let spent = begun.elapsed() * u32::try_from(threads).unwrap_or(u32::MAX);
            self.pace = self.pace.max(spent / reached);
        }
        Ok(all)
    }
}

fn symptoms_of(
    session: &mut EngineSession<'_>,
    programs: &[&ProbeProgram],
    going: &dyn Fn() -> bool,
) -> Vec<Option<Option<String>>> {
    let questions: Vec<JudgedProgram<'_>> = programs.iter().map(|program| program.question()).collect();
    let symptom = |(_, agreement): (Outcome, Agreement)| match agreement {
        Agreement::Agrees => None,
        Agreement::Unsupported => Some("unsupported".to_owned()),
        Agreement::Disagrees { symptom, .. } => Some(symptom),
    };
    let outcomes = ask_all(session, &questions, going).into_iter();
    outcomes.map(|outcome| outcome.map(symptom)).collect()
}
