//! The diagnostic codes that a version of `ironplcc` has: those which its executable spells, since it prints them.
//!
//! Basis: ironplc: measured on version 0.239: its executable spells exactly the 110 codes of its `problem-codes.csv`.

use std::collections::BTreeSet;
use std::path::Path;
use stickler_types::Code;

/// Returns the codes of the registry that a compiler does not have; none where its file does not tell, such as a script that
/// calls the compiler.
pub(super) fn lacking(compiler: &Path) -> Vec<Code> {
    std::fs::read(compiler).map_or_else(|_| Vec::new(), |executable| not_spelled(&executable))
}

fn not_spelled(executable: &[u8]) -> Vec<Code> {
    let spelled: BTreeSet<&[u8]> = executable
        .split(|&byte| byte == b'P')
        .filter_map(|after| after.get(..4))
        .filter(|number| number.iter().all(u8::is_ascii_digit))
        .collect();
    let is_spelled = |code: &Code| spelled.contains(&code.as_str().as_bytes()[1..]);
    let lacking: Vec<Code> = Code::ALL
        .iter()
        .copied()
        // The codes of warnings are those of other compilers, and those with an S are Stickler's.
        .filter(|code| code.severity().is_error() && code.as_str().starts_with('P') && !is_spelled(code))
        .collect();
    // A file that spells few codes does not hold the texts of the compiler.
    match lacking.len() < Code::ALL.len() / 2 {
        true => lacking,
        false => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_that_the_executable_does_not_spell_is_lacking() {
        let all_but = |absent: &str| {
            let spelled = Code::ALL.iter().filter(|code| code.as_str() != absent);
            // As a compiler lays out its texts: one behind the other.
            spelled.map(Code::to_string).collect::<String>()
        };
        assert_eq!(
            not_spelled(all_but("P4049").as_bytes()),
            [Code::OperatorOperandTypeMismatch]
        );
        assert_eq!(not_spelled(all_but("none").as_bytes()), []);
    }

    #[test]
    fn what_spells_no_codes_tells_nothing() {
        assert_eq!(not_spelled(b"#!/bin/sh\nexec ironplcc P4035\n"), []);
        assert_eq!(lacking(Path::new("/no/such/file")), []);
    }
}
