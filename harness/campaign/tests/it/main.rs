//! Campaigns as a whole: engines with known defects, and what is found, kept and said.

mod engines;
mod finding;
mod reproducible;
mod survey;
