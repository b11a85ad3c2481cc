//! The initial values of the variables of function blocks: whether a program fails only because an engine does not give them.

use crate::forms::body;
use crate::program::{ReadProgram, read};
use crate::question::Questioner;
use crate::reduction::{Smallest, repeated};
use crate::smaller_case::{all_variables, as_the_reference, with_program};
use stickler_engines::EngineError;
use stickler_run::Symptom;
use stickler_suite::Case;
use stickler_syntax::Edits;
use stickler_syntax::tree::{InitializerKind, Pou, PouKind};

/// The plainest programs with an output of a function block that begins with a value: without a statement, and for those who
/// demand one.
const BEGINNING_BLOCKS: [&str; 2] = [
    "FUNCTION_BLOCK BLOCK\nVAR_OUTPUT\n    data : INT := 1;\nEND_VAR\nEND_FUNCTION_BLOCK\n\n\
    PROGRAM main\nVAR\n    instance : BLOCK;\nEND_VAR\nEND_PROGRAM\n",
    "FUNCTION_BLOCK BLOCK\nVAR_OUTPUT\n    data : INT := 1;\nEND_VAR\n    data := data;\nEND_FUNCTION_BLOCK\n\n\
    PROGRAM main\nVAR\n    instance : BLOCK;\nEND_VAR\n    instance();\nEND_PROGRAM\n",
];

/// Returns whether a program is one of the plainest with a variable of a function block that begins with a value.
pub(crate) fn is_beginning_block(program: &str) -> bool {
    BEGINNING_BLOCKS.contains(&program)
}

/// Returns the plainest programs of which a function block has an initial value, for a program of which one has.
fn beginning_blocks(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let mut blocks = program
        .unit
        .pous()
        .filter(|pou| pou.kind == PouKind::FunctionBlock);
    let begins = |pou: &Pou<'_>| {
        let mut groups = pou.blocks.iter().flat_map(|block| &block.groups);
        groups.any(|group| group.initializer.is_some())
    };
    match blocks.any(begins) {
        true => BEGINNING_BLOCKS.map(str::to_owned).to_vec(),
        false => Vec::new(),
    }
}

/// Returns a program whose function blocks give their variables the initial values by statements; `None` where a value cannot be given
/// so, or none is there.
fn begun_by_statements(program: &ReadProgram<'_, '_>) -> Option<String> {
    let mut edits = Edits::new();
    for pou in program
        .unit
        .pous()
        .filter(|pou| pou.kind == PouKind::FunctionBlock)
    {
        let mut given = String::new();
        for group in pou.blocks.iter().flat_map(|block| &block.groups) {
            match group.initializer.as_ref().map(|initial| &initial.kind) {
                Some(InitializerKind::Expression(value)) => {
                    for name in &group.names {
                        given += &format!("{} := {};\n", name.text, program.text(*value));
                    }
                }
                Some(_) => return None,
                None => {}
            }
        }
        if !given.is_empty() {
            let start = body(program.text, pou)?.start;
            edits.replace(start..start, given);
        }
    }
    let begun = edits.apply(program.text);
    (begun != program.text).then_some(begun)
}

/// Returns one of the plainest programs with an initial value in a function block, where the engine loses that value, and does what it must
/// with the program of a case once statements give its blocks their initial values. Two questions take the place of a reduction.
///
/// # Errors
/// [`EngineError`] where the engine crashed and cannot be started again.
pub(crate) fn beginning_alone(
    asked: &mut Questioner<'_>,
    case: &Case,
    unreduced: &Smallest,
    stop: &dyn Fn() -> bool,
) -> Result<Option<Smallest>, EngineError> {
    let sign = &unreduced.deviation.sign;
    if !matches!(
        sign.symptom,
        Symptom::Value | Symptom::Missing | Symptom::Fault(_)
    ) {
        return Ok(None);
    }
    let (blocks, begun) = read(&unreduced.program, |program| {
        (beginning_blocks(program), begun_by_statements(program))
    });
    let Some(begun) = begun.and_then(|begun| with_program(case, sign, &begun)) else {
        return Ok(None);
    };
    for program in blocks {
        let Some(block) = as_the_reference(case, &program, &all_variables(case, &program)) else {
            continue;
        };
        let questions = 1 + u64::from(!asked.has_answered(&block));
        let seen = asked.deviation(&block)?;
        let Some(deviation) = seen.filter(|seen| seen.sign.symptom == Symptom::Value) else {
            continue;
        };
        if stop() || asked.deviation(&begun)?.is_some() {
            return Ok(None);
        }
        let found = Smallest {
            questions,
            ..Smallest::known(program, deviation)
        };
        let sign = found.deviation.sign.clone();
        return repeated(asked, &block, &sign, found, stop).map(Some);
    }
    Ok(None)
}
