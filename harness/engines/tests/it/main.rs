//! The engines from the outside, in one program: each of its own would be linked once more.

mod compilers;
#[cfg(unix)]
mod process;
mod reference;
mod server;
mod transcript;
