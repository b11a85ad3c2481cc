//! Sweeps from the outside: what they go through, what they find, and how they stop.

mod broken;
mod catalogue;
mod domains;
mod stopping;
mod support;
