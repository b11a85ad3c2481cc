//! The passes of the reducer that lead to the normal form of a program, and the weights by which one form is plainer than another.

use crate::alone::{alone, distance, loops_alone};
use crate::forms;
use crate::plainness::{plainer_numbers, plainness};
use crate::program::{ReadProgram, read};
use crate::words::{has_word, tokens};
use crate::work::operations;
use stickler_reduce::{
    METHOD, Pass, ReductionMethod, Sites, TextDraft, TextView, drop_units, drop_unused, text_pass,
    unit_to_program,
};
use stickler_reference::errors;
use stickler_run::Symptom;
use stickler_syntax::Edits;
use stickler_syntax::features::features;
use stickler_types::Dialect;

/// Takes one of several programs in the place of another. Where several are chosen none is taken, so that they are tried one by
/// one, in their order.
fn take_one(
    draft: &mut TextDraft,
    sites: &mut Sites,
    find: impl FnOnce(&ReadProgram<'_, '_>) -> Vec<String>,
) {
    let found = read(draft.text(), find);
    let mut chosen = found.into_iter().filter(|_| sites.here());
    if let (Some(one), None) = (chosen.next(), chosen.next()) {
        draft.replace_text(one);
    }
}

/// Creates a pass that takes one of several programs in the place of another.
macro_rules! alternatives {
    ($name:literal, $find:expr) => {
        Pass {
            name: $name,
            edit: |draft, sites| take_one(draft, sites, $find),
        }
    };
}

type NormalPass = Pass<TextDraft>;
const OPERAND_ALONE: NormalPass = alternatives!("take an operand alone", operands_alone);
const INITIAL_VALUES: NormalPass = alternatives!("leave the bodies out", forms::only_initial_values);
const ONE_LESS: NormalPass = alternatives!("leave a statement out", forms::without_one_statement);
const LOOP_ALONE: NormalPass = Pass {
    name: "take a loop alone",
    edit: |draft, sites| {
        let dialect = draft.dialect();
        take_one(draft, sites, |program| {
            let loops = loops_alone(program, dialect).into_iter();
            loops.map(|one| one.program).collect()
        });
    },
};
/// The pass for what is wrong in a PROGRAM too.
const UNIT_TO_PROGRAM: NormalPass =
    text_pass!("make a function block or a function the program", unit_to_program);
const LAST_VALUE: NormalPass = alternatives!("count to the last value alone", forms::with_last_value);
const ONE_STATEMENT: NormalPass = alternatives!("keep one statement", forms::with_one_statement);
const VARIABLE_FOR_BIT: NormalPass =
    alternatives!("give a value to a variable", forms::with_variable_for_bit);
const FOLDED_LITERALS: NormalPass = alternatives!("fold literals", forms::with_folded_literals);
const VARIABLE_FOR_CALL: NormalPass =
    alternatives!("give a variable for a call", forms::with_variable_for_call);
const WHOLE_VARIABLE: NormalPass = alternatives!("assign a whole variable", forms::with_whole_variable);
const FIRST_PARTS: NormalPass = alternatives!("select the first parts", forms::with_first_parts);
const FITTING_OPERAND: NormalPass = alternatives!("give the right type", forms::with_fitting_operand);
const SAME_TYPES: NormalPass = alternatives!("make two types one", forms::with_same_types);
const PLAINER_TYPE: NormalPass = alternatives!("take a plainer type", forms::with_plainer_type);
const PLAINER_NUMBERS: NormalPass = Pass {
    name: "take plainer numbers",
    edit: |draft, sites| {
        draft.change("take plainer numbers", sites, |view| {
            read(view.text(), plainer_numbers)
        })
    },
};
/// The passes for what nothing uses any more, since another operand or statement took the place of what used it.
const UNUSED: [NormalPass; 2] = [
    text_pass!("drop what the PROGRAM does not use", drop_other_units),
    text_pass!("drop what is not used", drop_unused),
];

/// Lists changes that drop units other than the PROGRAM, without which there is another mistake.
fn drop_other_units(view: &TextView<'_>) -> Vec<Edits> {
    let mut changes = drop_units(view);
    changes.retain(|change| has_word(&change.apply(view.text()), "PROGRAM"));
    changes
}

/// Returns the operands of a program, each in a program of its own.
fn operands_alone(program: &ReadProgram<'_, '_>) -> Vec<String> {
    alone(program).into_iter().map(|one| one.program).collect()
}

/// Returns the passes that find out what of a program a symptom needs.
fn structure_passes(symptom: &Symptom) -> &'static [NormalPass] {
    match symptom {
        Symptom::Value | Symptom::Missing => &[
            LOOP_ALONE,
            INITIAL_VALUES,
            OPERAND_ALONE,
            UNIT_TO_PROGRAM,
            ONE_LESS,
            LAST_VALUE,
        ],
        // A loop may have no end, and a division stop, because a variable does not begin with its value.
        Symptom::Hang | Symptom::Fault(_) => &[INITIAL_VALUES],
        Symptom::NotRejected(_) => &[OPERAND_ALONE, WHOLE_VARIABLE, VARIABLE_FOR_CALL, FOLDED_LITERALS],
        Symptom::Rejected(_) => &[OPERAND_ALONE, WHOLE_VARIABLE, VARIABLE_FOR_BIT, SAME_TYPES],
        Symptom::NotImplemented(_) | Symptom::Crash(_) => &[ONE_STATEMENT, VARIABLE_FOR_BIT, SAME_TYPES],
        Symptom::OtherCode { .. } | Symptom::Surplus(_) | Symptom::OtherLine(_) => {
            &[FIRST_PARTS, OPERAND_ALONE, FITTING_OPERAND, SAME_TYPES]
        }
        _ => &[],
    }
}

/// Returns the weight of what a program does: one without a mistake is lighter, then an operand alone, then one with fewer operations,
/// then with fewer features of the language, then with fewer words.
fn structure(draft: &TextDraft) -> (u64, u128) {
    let text = draft.text();
    let has_mistake = !errors(text, draft.dialect()).is_empty();
    let form = 3 * u64::from(has_mistake) + distance(text);
    let features = features(text, Dialect::of(draft.dialect())).into_iter();
    let features = features.count();
    let (mut words, mut size) = (0, 0_u128);
    for token in tokens(text) {
        let written = token.span.text(text);
        words += if token.kind.is_literal() { 1 } else { 2 };
        if token.kind.is_literal() || written.starts_with('%') {
            size += written.bytes().map(u128::from).sum::<u128>();
        }
    }
    let operations = operations(text).len();
    (
        form * 1_000_000 + (operations * 10_000 + features * 100 + words) as u64,
        size,
    )
}

/// Returns the method that finds out what of a program a symptom needs.
pub(crate) fn structure_method(symptom: &Symptom) -> ReductionMethod<'static, TextDraft> {
    ReductionMethod {
        passes: structure_passes(symptom),
        weight: structure,
    }
}

/// Returns the method that drops what a program does not use.
pub(crate) fn unused_method() -> ReductionMethod<'static, TextDraft> {
    ReductionMethod {
        passes: &UNUSED,
        ..METHOD
    }
}

/// Returns the method that makes the types of a program plainer, and its numbers where `with_numbers`.
pub(crate) fn plain_method(with_numbers: bool) -> ReductionMethod<'static, TextDraft> {
    ReductionMethod {
        passes: if with_numbers {
            &[PLAINER_TYPE, PLAINER_NUMBERS]
        } else {
            &[PLAINER_TYPE]
        },
        weight: |draft: &TextDraft| (0, read(draft.text(), plainness)),
    }
}
