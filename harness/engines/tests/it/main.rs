//! Integration tests of the engines in one program, since each program of its own would be linked once more.

mod compilers;
#[cfg(unix)]
mod process;
mod reference;
mod server;
mod transcript;
