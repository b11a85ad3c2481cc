//! Variables that an adapter adds to a program, so that a compiler shows what it would not show otherwise.

use super::source::MainProgram;
use crate::{Observation, Outcome, RunRequest};
use std::fmt::Write;
use stickler_types::ElementaryType;

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

/// Has a program translated with its witnesses. Where they are not accepted, the program alone decides whether it is.
///
/// # Errors
/// What `translate` says of the program alone; [`Outcome::Unsupported`] where it accepts that, and its witnesses would show
/// nothing or are not accepted.
pub(super) fn translate_with<T>(
    request: &RunRequest<'_>,
    main: &MainProgram,
    witnesses: &[Witness],
    mut translate: impl FnMut(&str) -> Result<T, Outcome>,
) -> Result<T, Outcome> {
    if witnesses.is_empty() {
        return translate(request.source);
    }
    let reason = if main.returns {
        "a program that may return early shows only its simple variables".to_owned()
    } else if request.scans == 0 {
        "before the first scan only simple variables are shown".to_owned()
    } else {
        match translate(&with_witnesses(request.source, main, witnesses)) {
            Ok(translated) => return Ok(translated),
            Err(outcome) => format!("with copies of its values: {outcome}"),
        }
    };
    translate(request.source)?;
    Err(Outcome::Unsupported { reason })
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

/// Copies of what is observed and is no variable of its own: elements, fields, what a block puts out.
pub(super) struct Copies {
    witnesses: Vec<Witness>,
}

impl Copies {
    /// A copy of each path of a request, in the order in which they are observed.
    pub(super) fn of(request: &RunRequest<'_>) -> Copies {
        let mut copies = Copies {
            witnesses: Vec::new(),
        };
        for asked in request.observe {
            if is_path(&asked.name) && copies.copy(&asked.name).is_none() {
                let ty = ElementaryType::from_name(&asked.type_name);
                copies.witnesses.push(Witness {
                    name: Witness::name(copies.witnesses.len()),
                    type_name: ty.map_or(&*asked.type_name, |ty| ty.name()).to_owned(),
                    expression: asked.name.to_string(),
                });
            }
        }
        copies
    }

    /// The variables to be added to the program.
    pub(super) fn witnesses(&self) -> &[Witness] {
        &self.witnesses
    }

    /// The name of the variable in which a value is to be seen.
    pub(super) fn variable<'v>(&'v self, asked: &'v Observation) -> &'v str {
        self.copy(&asked.name).unwrap_or(&asked.name)
    }

    fn copy(&self, path: &str) -> Option<&str> {
        let found = self.witnesses.iter().find(|witness| witness.expression == path);
        found.map(|witness| witness.name.as_str())
    }
}

/// Whether this is no variable of the main program but a part of one.
fn is_path(name: &str) -> bool {
    name.contains(['.', '['])
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
