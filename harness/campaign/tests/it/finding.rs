//! Findings of a campaign over an engine with a known defect.

use crate::engines::{Defect, defective, dying};
use crate::reproducible::{campaign, whole};
use std::fs;
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use stickler_campaign::finding::{Confirmation, ExpectedBehavior};
use stickler_campaign::{CampaignEnd, CaseHead, EngineUnderTest, Finding, Store, load, promote, replay};
use stickler_engines::{ClosureEngine, Engine, Reference};
use stickler_mdtest::assert_fits;
use stickler_workers::Shard;

/// Returns the findings of a campaign without those that probably repeat a simpler one.
fn found(defect: Defect, count: u64) -> Vec<Finding> {
    let summary = whole(&defective(defect), count);
    assert_eq!(summary.ended, CampaignEnd::Done);
    let all: Vec<Finding> = summary.findings.values().cloned().collect();
    let different = all
        .iter()
        .filter(|finding| !all.iter().any(|simpler| finding.is_like(simpler)));
    different.cloned().collect()
}

/// Returns the finding of an engine that takes MOD for a division.
fn found_mod() -> Finding {
    let mut findings = found(Defect::Mistakes(" MOD ", " / "), 250).into_iter();
    let itself = findings.find(|finding| finding.rule == ["mod"]);
    itself.expect("the defect itself")
}

#[test]
fn a_program_that_is_computed_wrongly_is_found_and_made_small() {
    let finding = &found_mod();
    assert_eq!(finding.engine.as_ref().unwrap().name, "defective");
    assert_eq!(finding.kind(), "value");
    assert_eq!(finding.standing, Confirmation::Confirmed);
    assert!(finding.origin.size <= 15, "{} lines", finding.origin.size);
    let outcomes: Vec<&str> = finding
        .outcomes
        .iter()
        .map(|answer| answer.engine.name.as_str())
        .collect();
    assert_eq!(outcomes, ["reference", "defective"]);
    let ExpectedBehavior::Values { opened, .. } = &finding.expected else {
        panic!("values")
    };
    assert_eq!(opened, &Vec::<String>::new());
}

#[test]
fn a_program_over_which_an_engine_dies_is_found_and_made_small() {
    let findings = found(Defect::DiesOver("FOR "), 100);
    let [finding] = &findings[..] else {
        panic!("{findings:#?}")
    };
    assert_eq!(
        (finding.symptom.as_str(), &finding.rule[..]),
        ("crash", &["for".to_owned()][..])
    );
    assert!(finding.origin.size <= 15, "{} lines", finding.origin.size);
}

#[test]
fn an_engine_that_dies_now_and_then_is_started_again_and_what_is_not_seen_again_is_flaky() {
    let summary = whole(&defective(Defect::DiesEvery(50)), 120);
    assert_eq!(summary.ended, CampaignEnd::Done);
    assert_eq!(summary.programs, 120);
    // Which of the later deaths meets a program for the first time depends on the workers; that of the fiftieth does not.
    assert!(summary.deaths >= 1, "{}", summary.deaths);
    assert!(
        summary
            .findings
            .values()
            .all(|finding| finding.standing == Confirmation::Flaky)
    );
    assert!(!summary.findings.is_empty());
}

#[test]
fn an_engine_that_does_not_live_any_more_ends_the_campaign_in_words() {
    let summary = whole(&dying(Defect::None, 60, Arc::default()), 1000);
    let CampaignEnd::Lost(reason) = &summary.ended else {
        panic!("{:?}", summary.ended)
    };
    assert!(reason.contains("engine defective is lost"), "{reason}");
    assert!(summary.programs < 200);
}

#[test]
fn a_program_is_not_blamed_for_the_deaths_of_an_engine_that_is_gone() {
    let summary = whole(&defective(Defect::DiesForEverOver(" MOD ")), 1000);
    let CampaignEnd::Lost(reason) = &summary.ended else {
        panic!("{:?}", summary.ended)
    };
    assert!(reason.ends_with("it died: it was made to"), "{reason}");
    let finding = summary.findings.values().find(|finding| {
        let program = finding.program.as_deref().unwrap_or_default();
        program.contains(" MOD ")
    });
    let finding = finding.expect("the program over which it died first, as it was");
    assert_eq!(finding.standing, Confirmation::Flaky);
    assert_eq!(finding.program, finding.original);
    assert!(!finding.origin.smallest);
    assert_fits(
        &finding.message,
        "crash, and it could not be run again; engine defective is lost…",
    );
    assert!(
        summary
            .findings
            .values()
            .all(|finding| finding.standing == Confirmation::Flaky)
    );
}

#[test]
fn an_engine_that_is_lost_while_a_finding_is_made_small_ends_the_campaign() {
    let defect = Defect::Mistakes(" MOD ", " / ");
    let finds = |programs: &u64| {
        !campaign(&defective(defect), Shard::WHOLE, *programs, 1)
            .findings
            .is_empty()
    };
    // The last of these programs has the defect: what the engine is asked last is asked to make that one small.
    let programs = (1..200).find(finds).expect("a program with the defect");
    let of = |engine: &ClosureEngine<'_>| campaign(engine, Shard::WHOLE, programs, 1);
    let requests = Arc::<AtomicU64>::default();
    let lasting = dying(defect, u64::MAX, Arc::clone(&requests));
    assert_eq!(of(&lasting).ended, CampaignEnd::Done);
    let summary = of(&dying(
        defect,
        requests.load(Ordering::Relaxed) - 2,
        Arc::default(),
    ));
    assert!(
        matches!(summary.ended, CampaignEnd::Lost(_)),
        "{:?}",
        summary.ended
    );
    assert_eq!(summary.programs, programs);
    let cut_short = |finding: &Finding| finding.message.contains(", and it could not be run again; ");
    assert_eq!(
        summary
            .findings
            .values()
            .filter(|finding| cut_short(finding))
            .count(),
        1
    );
}

#[test]
fn the_reference_agrees_with_the_documents() {
    let summary = campaign(&Reference::default(), Shard::WHOLE, 300, 2);
    assert_eq!(summary.findings.into_values().collect::<Vec<_>>(), []);
}

#[test]
fn a_finding_is_saved_judged_again_and_promoted() {
    let engine = defective(Defect::Mistakes(" MOD ", " / "));
    let finding = &found_mod();
    let folder = tempfile::tempdir().unwrap();
    let store = Store::open(folder.path()).unwrap();
    store.save(finding).unwrap();
    let finding = load(&store.place(&finding.id)).unwrap();
    let reference = Reference::default();
    let shows = |engine: &dyn Engine| {
        let engine = EngineUnderTest {
            engine,
            asked_for: "",
            is_reference: false,
        };
        replay(&finding, &[engine]).unwrap().shows()
    };
    assert!(shows(&engine));
    assert!(!shows(&reference));
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    let found = folder.path().join("found");
    fs::create_dir(&found).unwrap();
    fs::write(found.join("README.md"), "Found.").unwrap();
    for file in ["suite.toml", "dialects.toml", "sources.toml", "rules.md"] {
        fs::copy(cases.join(file), folder.path().join(file)).unwrap();
    }
    let words = CaseHead {
        name: Some("mod"),
        ..CaseHead::default()
    };
    let promoted = promote(&finding, folder.path(), &words).unwrap();
    let (read, errors) = stickler_suite::load_file(folder.path(), &promoted.path);
    assert_eq!(errors, []);
    assert_eq!(read.len(), 1);
}
