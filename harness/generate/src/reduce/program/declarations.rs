//! Passes that drop declarations.

use super::removal::keep_only;
use super::usage::DeclarationUsage;
use crate::model::{Program, VariableSection};
use stickler_reduce::Sites;

/// Drops types, functions, function blocks, variables and parameters that are not used. A function keeps one input, because
/// the second edition of the standard has no call without arguments.
pub(super) fn drop_unused(program: &mut Program, sites: &mut Sites) {
    let mut usage = DeclarationUsage::of(program);
    for (function, used) in program.functions.iter().zip(&mut usage.of_functions) {
        let inputs = function
            .variables
            .iter()
            .zip(used.iter_mut())
            .filter(|(variable, _)| variable.section == VariableSection::Input);
        let mut inputs: Vec<_> = inputs.map(|(_, used)| used).collect();
        if let (false, Some(first)) = (inputs.iter().any(|used| **used), inputs.first_mut()) {
            **first = true;
        }
    }
    let DeclarationUsage {
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

/// Applies an edit, and drops the variables that become unused by it.
///
/// A variable that is no longer written has the default value of its type, which may be open, as for dates: so statements
/// and the variable that they write can only go together.
pub(super) fn with_variables(program: &mut Program, sites: &mut Sites, edit: fn(&mut Program, &mut Sites)) {
    let before = DeclarationUsage::of(program);
    edit(program, sites);
    let now = DeclarationUsage::of(program);
    let keep = |before: &[bool], now: &[bool]| -> Vec<bool> {
        let both = before.iter().zip(now);
        both.map(|(before, now)| *now || !*before).collect()
    };
    let mut kept = DeclarationUsage::uniform(program, true);
    kept.main = keep(&before.main, &now.main);
    for (block, kept) in kept.of_blocks.iter_mut().enumerate() {
        if let (Some(before), Some(now)) = (before.of_blocks.get(block), now.of_blocks.get(block)) {
            *kept = keep(before, now);
        }
    }
    keep_only(program, &kept);
}
