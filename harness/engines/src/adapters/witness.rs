//! Variables that an adapter adds to a program, so that a compiler shows what it would not show otherwise.

use super::source::MainProgram;
use std::fmt::Write;

/// A variable that takes the value of an expression at the end of the main program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(super) struct Witness {
    /// Its name, which no program has: see [`Witness::name`].
    pub(super) name: String,
    /// Its type, as it is declared.
    pub(super) type_name: String,
    /// What it takes.
    pub(super) expression: String,
}

impl Witness {
    /// The name of the witness of this number.
    pub(super) fn name(number: usize) -> String {
        format!("stickler_witness_{number}")
    }
}

/// The program with its witnesses. Each line stays the line that it was: the declarations stand behind the program's
/// name, the assignments before its `END_PROGRAM`.
pub(super) fn with_witnesses(source: &str, main: &MainProgram, witnesses: &[Witness]) -> String {
    let mut text = source[..main.inside.start].to_owned();
    text.push_str(" VAR");
    for witness in witnesses {
        // Writing into a String does not fail.
        let _ = write!(text, " {} : {};", witness.name, witness.type_name);
    }
    text.push_str(" END_VAR");
    text.push_str(&source[main.inside.clone()]);
    for witness in witnesses {
        let _ = write!(text, "{} := {}; ", witness.name, witness.expression);
    }
    text.push_str(&source[main.inside.end..]);
    text
}

#[cfg(test)]
mod tests {
    use super::super::source::main_program;
    use super::*;

    #[test]
    fn witnesses_move_no_line() {
        let source = "PROGRAM main\nVAR\n  a : ARRAY[1..2] OF INT;\nEND_VAR\n  a[1] := 7;\nEND_PROGRAM\n";
        let witness = |number: usize, expression: &str| Witness {
            name: Witness::name(number),
            type_name: "INT".to_owned(),
            expression: expression.to_owned(),
        };
        let text = with_witnesses(
            source,
            &main_program(source).unwrap(),
            &[witness(0, "a[1]"), witness(1, "a[2]")],
        );
        assert_eq!(
            text,
            "PROGRAM main VAR stickler_witness_0 : INT; stickler_witness_1 : INT; END_VAR\n\
             VAR\n  a : ARRAY[1..2] OF INT;\nEND_VAR\n  a[1] := 7;\n\
             stickler_witness_0 := a[1]; stickler_witness_1 := a[2]; END_PROGRAM\n"
        );
        assert_eq!(text.lines().count(), source.lines().count());
    }
}
