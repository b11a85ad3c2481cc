//! Planted errors in declarations.

use super::super::fault_site::{FaultSite, PLANTED};
use super::edit::declaration;
use crate::model::{Unit, VariableSection};
use stickler_types::{Dialect, ElementaryType};

/// Plants a type of the third edition, where the dialect does not have it.
///
/// Basis: language/third-edition-types.st, language/twincat-types.toml.
pub(super) fn third_edition(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let dialect = fault.original.dialect;
    let absent: Vec<_> = ElementaryType::ALL
        .into_iter()
        .filter(|&ty| !Dialect::of(dialect).has(ty))
        .collect();
    let texts: Vec<String> = absent
        .iter()
        .map(|ty| format!(": {ty}"))
        .chain(absent.first().map(|ty| format!(": ARRAY[0..1] OF {ty}")))
        .collect();
    declaration(fault, VariableSection::Local, &texts)
}

/// Plants an instance of a function block that is constant.
///
/// Basis: ironplc-problem-codes: P4009.
pub(super) fn constant_instance(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let block = fault.choose(fault.original.blocks.iter().collect())?;
    let text = format!("{PLANTED}_one : {}", block.name);
    fault.declare_text(Unit::Main, &text, VariableSection::Constant)
}

/// Plants an instance of a function block in a function.
///
/// Basis: ironplc-problem-codes: P4054.
pub(super) fn instance_in_function(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    if fault.original.dialect.rules().blocks_in_functions {
        return None;
    }
    let functions = fault.original.functions.iter().enumerate();
    let functions = functions.filter(|(_, function)| function.owner.is_none());
    let (number, _) = fault.choose(functions.collect())?;
    let block = fault.choose(fault.original.blocks.iter().collect())?;
    let text = format!("{PLANTED}_one : {}", block.name);
    fault.declare_text(Unit::Function(number), &text, VariableSection::Local)
}
