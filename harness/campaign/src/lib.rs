//! Fuzz campaigns without libFuzzer: programs from a seed, engines side by side, findings that are kept.
//!
//! [`run()`] follows a [`CampaignPlan`]: it gives out the [`Inputs`] of a seed to the workers of an [`Oracle`], takes their
//! [`InputVerdict`]s in order, has each [`Mismatch`] reduced, and reports each [`Finding`] once. A [`DifferentialOracle`]
//! compares engines with the evaluator, a [`TargetOracle`] judges the reference by the oracles of the fuzz targets.
//!
//! Before a campaign [`survey()`] asks engines for each part of the language alone, so that what fails is left out.
//!
//! A [`Store`] keeps findings in a folder; [`replay()`] judges one again, [`promote()`] makes a case of it, and [`merge()`]
//! puts the folders of several machines together.
//!
//! Architecture Invariant: this crate knows no terminal and no command line.

mod basis;
mod commands;
mod differential;
mod exclusions;
pub mod finding;
mod inputs;
mod merge;
mod oracle;
mod plan;
mod promote;
pub mod record;
mod replay;
mod run;
#[cfg(test)]
mod sample;
mod shrink;
mod store;
mod survey;
mod targets;
mod texts;

pub use commands::ReproductionCommands;
pub use differential::{DifferentialOracle, EngineUnderTest};
pub use exclusions::{Exclusions, UnknownWord};
pub use finding::Finding;
pub use inputs::Inputs;
pub use merge::{Merged, merge};
pub use oracle::{InputVerdict, Mismatch, Oracle, Worker};
pub use plan::{CampaignPlan, Until};
pub use promote::{CaseHead, FOUND, PromoteError, Promoted, check_name, promote};
pub use record::{CampaignRequest, Record};
pub use replay::{Replayed, replay};
pub use run::{CampaignEnd, CampaignError, CampaignEvent, CampaignSummary, run};
pub use store::{Saved, Store, StoreError, load};
pub use survey::{FailingPart, Survey, SurveyPlan, survey};
pub use targets::TargetOracle;
