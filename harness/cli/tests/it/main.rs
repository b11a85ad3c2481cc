//! Tests of the command line, in one program, since each further test program would be linked separately.

#[cfg(unix)]
mod bless;
#[cfg(unix)]
mod caching;
mod carried;
#[cfg(unix)]
mod ci;
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
#[cfg(unix)]
mod hostile_output;
mod links;
mod pages;
mod recordings;
#[cfg(unix)]
mod reduce;
mod reproduce;
mod run;
#[cfg(unix)]
mod sweep;
