//! Integration tests of the engines in one program, since each program of its own would be linked once more.

mod compilers;
#[cfg(unix)]
mod process;
mod reference;
#[cfg(unix)]
mod reproduction;
mod server;
mod transcript;
