//! The campaign on a oracle that knows beforehand what it will say.

use super::{Campaign, CampaignEnd, CampaignEvent, CampaignSummary, Clock, Reorder, Spent, run};
use crate::finding::Finding;
use crate::oracle::{InputVerdict, Mismatch, Oracle, Worker};
use crate::{CampaignPlan, Until, sample};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::Duration;
use stickler_engines::EngineError;
use stickler_workers::{Cancellation, Shard};

/// Every fifth input makes an engine disagree, by three defects of two symptoms.
#[derive(Default)]
struct PlannedMismatches {
    judged: AtomicU64,
    /// The place from which on the engine does not answer.
    gone: Option<u64>,
    /// The place at which Stickler itself panics.
    panics: Option<u64>,
}

impl Oracle for PlannedMismatches {
    fn worker(&self) -> Result<Box<dyn Worker + '_>, EngineError> {
        Ok(Box::new(self))
    }
}

fn verdict(place: u64) -> InputVerdict {
    let symptoms: &[&str] = match place % 5 {
        0 if place.is_multiple_of(3) => &["crash"],
        0 => &["value:INT"],
        _ => &[],
    };
    let mismatch = |symptom: &&str| Mismatch {
        place,
        subject: "engine".to_owned(),
        symptom: (*symptom).to_owned(),
        rule: vec!["FOR".to_owned(), "MOD".to_owned()],
        size: 100,
    };
    InputVerdict {
        place,
        mismatches: symptoms.iter().map(mismatch).collect(),
        passed_over: (place % 5 == 1).then_some("poisoned"),
        ..InputVerdict::default()
    }
}

impl Worker for &PlannedMismatches {
    fn judge(&mut self, places: &[u64], going: &dyn Fn() -> bool) -> Vec<InputVerdict> {
        assert!(places.iter().all(|&place| self.panics != Some(place)));
        self.judged.fetch_add(places.len() as u64, Ordering::Relaxed);
        let going = places.iter().take_while(|_| going());
        going.map(|&place| verdict(place)).collect()
    }

    fn reduce(&mut self, mismatch: &Mismatch, _: &dyn Fn() -> bool) -> Finding {
        let rule = if mismatch.place.is_multiple_of(7) {
            "MOD"
        } else {
            "FOR"
        };
        let mut finding = sample::finding("engine", &mismatch.symptom, &[rule], mismatch.place % 11);
        finding.origin.place = mismatch.place;
        finding
    }

    fn lost(&self) -> Option<String> {
        let gone = self.gone?;
        (self.judged.load(Ordering::Relaxed) >= gone).then(|| "it does not answer".to_owned())
    }
}

fn plan(jobs: usize, shard: Shard, until: Until) -> CampaignPlan {
    CampaignPlan {
        first: 0,
        until,
        shard,
        jobs,
        batch: 8,
    }
}

fn campaign(oracle: &PlannedMismatches, plan: CampaignPlan) -> CampaignSummary {
    run(&plan, oracle, &mut |_| (), &Cancellation::new()).unwrap()
}

#[test]
fn a_seed_finds_the_same_whatever_the_number_of_workers() {
    let of = |jobs| {
        campaign(
            &PlannedMismatches::default(),
            plan(jobs, Shard::WHOLE, Until::Count(3000)),
        )
    };
    let (one, many) = (of(1), of(7));
    assert_eq!(one.findings, many.findings);
    assert_eq!(one.findings.len(), 4);
    assert_eq!(one.times, many.times);
    assert_eq!(one.disagreements, many.disagreements);
    assert_eq!(one.programs, 3000);
    assert_eq!(one.passed_over["poisoned"], 600);
    assert_eq!(one.ended, CampaignEnd::Done);
    let reduced: u64 = one.times.values().sum();
    assert_eq!(
        one.left + reduced,
        600,
        "each disagreement is made small or counted as left"
    );
}

#[test]
fn the_parts_of_a_seed_find_together_what_the_whole_finds() {
    // So few that each is made small.
    let until = Until::Count(100);
    let whole = campaign(&PlannedMismatches::default(), plan(2, Shard::WHOLE, until)).findings;
    let mut together: BTreeMap<String, Finding> = BTreeMap::new();
    for index in 1..=3 {
        let shard = Shard::new(index, 3).unwrap();
        for (id, finding) in campaign(&PlannedMismatches::default(), plan(2, shard, until)).findings {
            if finding.is_best_of(&together) {
                together.insert(id, finding);
            }
        }
    }
    assert_eq!(together, whole);
}

#[test]
fn each_finding_is_told_and_what_is_told_last_is_what_is_kept() {
    let mut reported: BTreeMap<String, Finding> = BTreeMap::new();
    let mut programs = 0;
    let mut tell = |event: CampaignEvent<'_>| match event {
        CampaignEvent::Found(finding) => {
            reported.insert(finding.id.clone(), finding.clone());
        }
        CampaignEvent::Progress(progress) => programs = progress.programs,
    };
    let plan = plan(3, Shard::WHOLE, Until::Count(500));
    let summary = run(
        &plan,
        &PlannedMismatches::default(),
        &mut tell,
        &Cancellation::new(),
    )
    .unwrap();
    assert_eq!(reported, summary.findings);
    assert_eq!(programs, 500);
}

#[test]
fn a_campaign_that_is_told_to_stop_keeps_what_it_has() {
    let cancel = Cancellation::new();
    let mut tell = |event: CampaignEvent<'_>| {
        if let CampaignEvent::Found(_) = event {
            cancel.request();
        }
    };
    let endless = plan(2, Shard::WHOLE, Until::Count(u64::MAX));
    let summary = run(&endless, &PlannedMismatches::default(), &mut tell, &cancel).unwrap();
    assert_eq!(summary.ended, CampaignEnd::Interrupted);
    assert!(!summary.findings.is_empty());
}

#[test]
fn a_campaign_ends_when_its_time_is_up() {
    let cancel = Cancellation::new();
    let hour = Clock::new(Until::Time(Duration::from_secs(3600)), &cancel);
    assert!(hour.judges() && hour.reduces() && !hour.reserves());
    let none = plan(2, Shard::WHOLE, Until::Time(Duration::ZERO));
    let summary = campaign(&PlannedMismatches::default(), none);
    assert_eq!((summary.ended, summary.programs), (CampaignEnd::Done, 0));
    // A campaign that goes on ends too.
    let short = plan(2, Shard::WHOLE, Until::Time(Duration::from_millis(50)));
    let summary = campaign(&PlannedMismatches::default(), short);
    assert_eq!(summary.ended, CampaignEnd::Done);
}

#[test]
fn when_the_time_is_up_each_symptom_has_a_finding_and_the_rest_is_counted() {
    let none = plan(1, Shard::WHOLE, Until::Time(Duration::ZERO));
    let cancel = Cancellation::new();
    let clock = Clock::new(none.until, &cancel);
    let waiting = |place: u64, symptom: &str, size: usize| Mismatch {
        place,
        subject: "engine".to_owned(),
        symptom: symptom.to_owned(),
        rule: Vec::new(),
        size,
    };
    let mut campaign = Campaign {
        clock: &clock,
        batches: none.batches().enumerate(),
        batches_ahead: 1,
        begun: 0,
        verdicts: Reorder::default(),
        reductions: vec![
            waiting(1, "crash", 9),
            waiting(2, "crash", 5),
            waiting(3, "value:INT", 7),
        ],
        spent: Spent::default(),
        summary: CampaignSummary::default(),
        reduced: BTreeMap::new(),
        tell: &mut |_| (),
    };
    let next: Vec<u64> = std::iter::from_fn(|| campaign.next_reduction())
        .map(|next| next.place)
        .collect();
    assert_eq!(next, [2, 3]);
    assert_eq!(campaign.summary.left, 1);
}

#[test]
fn an_engine_that_is_lost_ends_the_campaign_and_what_was_found_is_kept() {
    let oracle = PlannedMismatches {
        gone: Some(400),
        ..PlannedMismatches::default()
    };
    let summary = campaign(&oracle, plan(2, Shard::WHOLE, Until::Count(u64::MAX)));
    assert_eq!(summary.ended, CampaignEnd::Lost("it does not answer".to_owned()));
    assert!(!summary.findings.is_empty());
}

#[test]
fn a_defect_of_stickler_itself_ends_the_campaign_in_words_and_loses_nothing() {
    let oracle = PlannedMismatches {
        panics: Some(401),
        ..PlannedMismatches::default()
    };
    let summary = campaign(&oracle, plan(1, Shard::WHOLE, Until::Count(u64::MAX)));
    let CampaignEnd::Lost(reason) = &summary.ended else {
        panic!("{:?}", summary.ended)
    };
    assert!(reason.contains("over one of the inputs 400 to 407"), "{reason}");
    assert!(!summary.findings.is_empty());
}
