//! The same seed finds the same: on one thread and on several, on one machine and in parts.

use crate::engines::{Defect, defective, dying};
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use stickler_campaign::{
    CampaignPlan, CampaignSummary, DifferentialOracle, EngineUnderTest, Exclusions, Finding, Inputs,
    PackPolicy, ReproductionCommands, Store, Until, merge, run,
};
use stickler_engines::{Engine, Reference};
use stickler_types::DialectName;
use stickler_workers::{Cancellation, Shard};

/// A campaign of the reference and this engine, which are asked for one program at a time.
pub fn campaign(engine: &dyn Engine, shard: Shard, count: u64, jobs: usize) -> CampaignSummary {
    campaign_with(PackPolicy::Never, engine, shard, count, jobs)
}

fn campaign_with(
    packs: PackPolicy,
    engine: &dyn Engine,
    shard: Shard,
    count: u64,
    jobs: usize,
) -> CampaignSummary {
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
        // A pack has programs of one dialect, so that few dialects make large packs.
        dialects: DialectName::ALL[..7].to_vec(),
        open: false,
        without: Exclusions::default(),
        packs,
        commands: ReproductionCommands {
            program: "stickler".to_owned(),
            folder: PathBuf::from("reports/findings"),
            engines: vec!["cmd:defective".to_owned()],
            dialects: Vec::new(),
            targets: Vec::new(),
            without: Vec::new(),
            max_input: Inputs::MAX_LEN,
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
fn packs_change_nothing_that_is_found() {
    let of = |packs| {
        let engine = defective(Defect::DiesOver("WHILE "));
        campaign_with(packs, &engine, Shard::WHOLE, 64, 1)
    };
    let (alone, packed) = (of(PackPolicy::Never), of(PackPolicy::Always));
    assert!(!alone.findings.is_empty());
    assert_eq!(alone.findings, packed.findings);
    assert_eq!(alone.disagreements, packed.disagreements);
    assert_eq!(alone.programs, packed.programs);
}

#[test]
fn an_engine_that_is_right_is_asked_about_the_programs_of_a_pack_at_once() {
    let requests = Arc::<AtomicU64>::default();
    let right = dying(Defect::None, u64::MAX, Arc::clone(&requests));
    let summary = campaign_with(PackPolicy::Always, &right, Shard::WHOLE, 160, 1);
    assert_eq!((summary.programs, summary.findings.len()), (160, 0));
    let requests = requests.load(Ordering::Relaxed);
    assert!(requests < 80, "{requests}");
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
