//! The committed corpora, replayed: every file in `corpus/<target>/` is a test. A folder without files is an error.
//!
//! `cargo test -p stickler-fuzz --test corpus -- parse` replays one target's.

use std::fs;
use std::path::Path;
use stickler_fuzz::FuzzTarget;

fn replay(target: FuzzTarget, path: &Path) -> datatest_stable::Result<()> {
    let data = fs::read(path)?;
    match target.judge(&data) {
        Ok(_) => Ok(()),
        Err(failure) => Err(failure.to_string().into()),
    }
}

macro_rules! corpora {
    ($($name:ident = $target:ident in $root:literal,)*) => {
        $(fn $name(path: &Path) -> datatest_stable::Result<()> {
            replay(FuzzTarget::$target, path)
        })*
        datatest_stable::harness! { $({ test = $name, root = $root, pattern = r"^[^.][^/]*$" },)* }
    };
}

corpora! {
    parse = Parse in "../corpus/parse",
    literal = Literal in "../corpus/literal",
    convert = Convert in "../corpus/convert",
    check = Check in "../corpus/check",
    execute = Execute in "../corpus/execute",
    case_file = CaseFile in "../corpus/case_file",
    protocol = Protocol in "../corpus/protocol",
    differential = Differential in "../corpus/differential",
}
