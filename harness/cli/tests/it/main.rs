//! The command line from the outside. One program holds all of these tests: each program of its own would be linked once
//! more.

#[cfg(unix)]
mod bless;
#[cfg(unix)]
mod caching;
mod common;
mod compare;
mod dialects;
#[cfg(unix)]
mod disks;
#[cfg(unix)]
mod engines;
mod export;
#[cfg(unix)]
mod fuzz;
mod links;
mod pages;
#[cfg(unix)]
mod reduce;
mod run;
#[cfg(unix)]
mod sweep;
