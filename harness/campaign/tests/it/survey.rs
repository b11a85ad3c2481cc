//! The survey of engines that are known to fail with some parts of the language.

use crate::engines::{Defect, defective};
use stickler_campaign::{EngineUnderTest, Exclusions, Survey, SurveyPlan, survey};
use stickler_types::DialectName;

/// Surveys the reference, which rejects programs with one of these texts.
fn surveyed(texts: &'static [&'static str], without: &[&str], going: &(dyn Fn() -> bool + Sync)) -> Survey {
    let engine = &defective(Defect::Rejects(texts));
    let words: Vec<String> = without.iter().map(|&word| word.to_owned()).collect();
    let engines = [EngineUnderTest {
        engine,
        asked_for: "lacking",
        is_reference: false,
    }];
    let plan = SurveyPlan {
        engines: &engines,
        dialects: &[DialectName::IRONPLC_ED3],
        without: &Exclusions::new(&words).unwrap(),
        jobs: 1,
        time: None,
        going,
    };
    survey(&plan).unwrap()
}

#[test]
fn an_engine_is_blamed_for_what_it_lacks_and_for_nothing_that_only_occurs_beside_it() {
    let lacking = &["ARRAY", " MOD "];
    let survey = surveyed(lacking, &[], &|| true);
    let dialects = [DialectName::IRONPLC_ED3];
    let mut words = survey.words(&dialects);
    words.sort();
    assert_eq!(words, ["array", "mod"]);
    assert!(survey.failing.iter().all(|part| part.symptom == "rejected"));
    assert!(
        survey
            .failing
            .iter()
            .all(|part| part.program.lines().count() < 10)
    );
    assert!(survey.asked > 50, "{}", survey.asked);
    let surveyed_again = surveyed(lacking, &["MOD"], &|| true);
    assert_eq!(surveyed_again.words(&dialects), ["array"]);
}

#[test]
fn a_word_has_its_dialect_where_it_fails_in_some_only() {
    let survey = surveyed(&[" MOD "], &[], &|| true);
    let dialects = [DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3];
    assert_eq!(survey.words(&dialects), ["mod@ironplc-ed3"]);
    assert!(survey.exclusions(&["CHAR".to_owned()], &dialects).is_ok());
}

#[test]
fn a_survey_without_time_learns_nothing() {
    let survey = surveyed(&[" MOD "], &[], &|| false);
    assert_eq!((survey.asked, survey.failing.len()), (0, 0));
    assert!(survey.parts > 50);
}
