//! The survey before a campaign: its share of the time, and the options of the campaign that follow from it.

use super::DEFAULT_TIME;
use crate::arguments::FuzzArguments;
use crate::{interrupt, output};
use stickler_campaign::{EngineUnderTest, Exclusions, Inputs, Survey, SurveyPlan, survey};
use stickler_types::DialectName;

/// The part of the time of a campaign that its survey may take.
const SHARE: u32 = 4;

/// The options of a campaign that a survey decides, as far as the command line does not.
pub struct Surveyed {
    /// The result of the survey; empty where there was none.
    pub survey: Survey,
    /// The words for what is left out, those of the command line first.
    pub without: Vec<String>,
    /// The number of bytes of the largest inputs.
    pub max_input: usize,
}

impl Default for Surveyed {
    /// Returns the options of a campaign without a survey.
    fn default() -> Surveyed {
        Surveyed {
            survey: Survey::default(),
            without: Vec::new(),
            max_input: Inputs::MAX_LEN,
        }
    }
}

/// Surveys the engines of a campaign, unless the command line says otherwise.
///
/// # Errors
/// An engine that cannot be started; a word that stands for nothing.
pub fn surveyed(
    arguments: &FuzzArguments,
    engines: &[EngineUnderTest<'_>],
    dialects: &[DialectName],
) -> anyhow::Result<Surveyed> {
    let without = Exclusions::new(&arguments.without)?;
    let survey = match arguments.no_survey || engines.iter().all(|engine| engine.is_reference) {
        true => Survey::default(),
        false => asked(arguments, engines, dialects, &without)?,
    };
    let mut words = arguments.without.clone();
    words.extend(survey.words(dialects));
    // With a count, what is found depends on nothing but the seed, so the speed of this machine must not decide.
    let suitable = match arguments.count {
        Some(_) => Inputs::MAX_LEN,
        None => survey.input_len(),
    };
    Ok(Surveyed {
        max_input: arguments.max_input.map_or(suitable, usize::from),
        survey,
        without: words,
    })
}

fn asked(
    arguments: &FuzzArguments,
    engines: &[EngineUnderTest<'_>],
    dialects: &[DialectName],
    without: &Exclusions,
) -> anyhow::Result<Survey> {
    let cancel = interrupt::cancellation()?;
    let time = arguments.time.unwrap_or(DEFAULT_TIME) / SHARE;
    let found = survey(&SurveyPlan {
        engines,
        dialects,
        without,
        jobs: arguments.jobs.map_or(0, usize::from),
        time: arguments.count.is_none().then_some(time),
        going: &|| !cancel.is_requested(),
    })?;
    if found.asked < found.parts {
        output::note(format!(
            "the engines were asked for {} of {} parts of the language alone; a longer --time asks for all",
            found.asked, found.parts
        ));
    }
    Ok(found)
}
