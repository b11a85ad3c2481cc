//! Tests of the crate from outside: suites made by hand, and engines with planted defects.

mod fixtures;
mod normal_forms;
mod planted;
mod sources;
