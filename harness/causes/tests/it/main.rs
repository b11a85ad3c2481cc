//! Tests of the crate from outside: suites made by hand, and a compiler with planted defects.

mod compiler;
mod defects;
mod planted;
mod search;
