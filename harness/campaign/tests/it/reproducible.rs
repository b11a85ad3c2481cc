//! The same seed finds the same: on one thread and on several, on one machine and in parts.

use crate::engines::{Defect, defective};
use std::collections::BTreeMap;
use std::path::PathBuf;
use stickler_campaign::{
    CampaignPlan, CampaignSummary, DifferentialOracle, EngineUnderTest, Exclusions, Finding, Inputs,
    ReproductionCommands, Store, Until, merge, run,
};
use stickler_engines::{Engine, Reference};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, Shard};

/// A campaign of the reference and this engine.
pub fn campaign(engine: &dyn Engine, shard: Shard, count: u64, jobs: usize) -> CampaignSummary {
    let reference = Reference::default();
    let under_test = |engine, asked_for| EngineUnderTest {
        engine,
        asked_for,
        is_reference: asked_for == "reference",
    };
    let oracle = DifferentialOracle {
        engines: vec![
            under_test(&reference, "reference"),
            under_test(engine, "cmd:defective"),
        ],
        inputs: Inputs::new(11),
        dialects: DialectName::ALL[..7].to_vec(),
        open: false,
        without: Exclusions::default(),
        commands: ReproductionCommands {
            program: "stickler".to_owned(),
            folder: PathBuf::from("reports/findings"),
            engines: vec!["cmd:defective".to_owned()],
            max_input: Inputs::MAX_LEN,
            ..ReproductionCommands::default()
        },
    };
    let plan = CampaignPlan {
        first: 0,
        until: Until::Count(count),
        shard,
        jobs,
        batch: 16,
    };
    run(&plan, &oracle, &mut |_| (), &Cancellation::new()).expect("the engines start")
}

/// A campaign that is no part, on two threads.
pub fn whole(engine: &dyn Engine, count: u64) -> CampaignSummary {
    campaign(engine, Shard::WHOLE, count, 2)
}

const DEFECT: Defect = Defect::Mistakes(" > ", " >= ");

#[test]
fn the_number_of_jobs_changes_nothing_that_is_found() {
    let of = |jobs| campaign(&defective(DEFECT), Shard::WHOLE, 100, jobs).findings;
    let one = of(1);
    assert!(!one.is_empty());
    assert_eq!(one, of(4));
}

#[test]
fn the_parts_put_together_have_what_the_whole_has() {
    let whole: BTreeMap<String, Finding> = whole(&defective(DEFECT), 100).findings;
    let root = tempfile::tempdir().unwrap();
    let mut folders = Vec::new();
    for index in 1..=3 {
        let shard = Shard::new(index, 3).unwrap();
        let store = Store::open(&root.path().join(index.to_string())).unwrap();
        for finding in campaign(&defective(DEFECT), shard, 100, 2).findings.values() {
            store.save(finding).unwrap();
        }
        folders.push(store.folder().to_owned());
    }
    assert_eq!(merge(&folders).findings, whole);
}
