//! Sweeps from the outside: what they go through, what they find, and how they stop.

mod between;
mod broken;
mod catalogue;
mod domains;
mod foreign;
mod stopping;
mod support;
