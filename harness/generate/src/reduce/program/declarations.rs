//! Declarations dropped.

use super::removal::keep_only;
use super::usage::Usage;
use crate::model::{Program, Section};
use crate::reduce::Sites;

/// Drops types, functions, function blocks, variables and parameters that nothing refers to. A function keeps one input, for
/// the second edition of the standard knows no call without arguments.
pub(super) fn drop_unused(program: &mut Program, sites: &mut Sites) {
    let mut usage = Usage::of(program);
    for (function, used) in program.functions.iter().zip(&mut usage.of_functions) {
        let inputs = function
            .variables
            .iter()
            .zip(used.iter_mut())
            .filter(|(variable, _)| variable.section == Section::Input);
        let mut inputs: Vec<_> = inputs.map(|(_, used)| used).collect();
        if let (false, Some(first)) = (inputs.iter().any(|used| **used), inputs.first_mut()) {
            **first = true;
        }
    }
    let Usage {
        functions,
        blocks,
        types,
        main,
        of_functions,
        of_blocks,
    } = &mut usage;
    let lists = [functions, blocks, types, main].into_iter();
    for used in lists.chain(of_functions).chain(of_blocks).flatten() {
        *used = *used || !sites.here();
    }
    keep_only(program, &usage);
}
