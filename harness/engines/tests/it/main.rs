//! Integration tests of the engines in one program, since each program of its own would be linked once more.

mod compilers;
mod fixture;
#[cfg(unix)]
mod process;
mod reference;
#[cfg(unix)]
mod reproduction;
mod server;
#[cfg(unix)]
mod stand_ins;
mod transcript;
