//! What the fuzz targets share: how a failure ends libFuzzer's process, and how inputs are replayed without libFuzzer.
//!
//! Architecture Invariant: nothing is judged here; every oracle is an ordinary function of `stickler-generate`.
#![forbid(unsafe_code)]

mod replay;

pub use replay::{Summary, replay, replay_all};
pub use stickler_generate::oracles::Target;

/// Judges an input for libFuzzer, which takes a panic for a finding and keeps the input.
///
/// # Panics
/// Where the input breaks what the target holds it to.
#[inline(always)]
pub fn hold(target: Target, data: &[u8]) {
    if let Err(failure) = target.judge(data) {
        panic!("{failure}");
    }
}

/// The whole of a fuzz target: libFuzzer's entry under `cargo fuzz`, otherwise a `main` that replays the files and folders
/// named on its command line.
#[macro_export]
macro_rules! target {
    ($target:ident) => {
        #[cfg(fuzzing)]
        ::libfuzzer_sys::fuzz_target!(|data: &[u8]| $crate::hold($crate::Target::$target, data));

        #[cfg(not(fuzzing))]
        fn main() -> std::process::ExitCode {
            $crate::replay($crate::Target::$target)
        }
    };
}
