//! Invalid declarations.

use super::super::fault_site::{FaultSite, PLANTED};
use crate::dialect::has_type;
use crate::model::{Unit, VariableSection};
use stickler_types::ElementaryType;

/// Declares one of several types for a variable with a name of its own.
fn declared(fault: &mut FaultSite<'_, '_>, section: VariableSection, texts: &[&str]) -> Option<()> {
    let unit = fault.unit()?;
    let text = fault.choose(texts.to_vec())?;
    fault.declare_text(unit, &format!("{PLANTED}_one {text}"), section)
}

/// Plants a type of the third edition, where the dialect does not have it.
///
/// Basis: language/third-edition-types.st, language/twincat-types.toml.
pub(super) fn third_edition(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    let dialect = fault.original.dialect;
    let absent: Vec<_> = ElementaryType::ALL
        .into_iter()
        .filter(|&ty| !has_type(dialect, ty))
        .collect();
    let texts: Vec<String> = absent
        .iter()
        .map(|ty| format!(": {ty}"))
        .chain(absent.first().map(|ty| format!(": ARRAY[0..1] OF {ty}")))
        .collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    declared(fault, VariableSection::Local, &texts)
}

/// Plants a declaration without its colon.
///
/// Basis: language/syntax-recovery.st.
pub(super) fn no_colon(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Local,
        &["BOOL", "INT := 5", ":= 5", ": INT := "],
    )
}

/// Plants an array whose limits descend.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn limits_descend(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Local,
        &[": ARRAY[3..1] OF INT", ": ARRAY[0..1, 0..-1] OF BOOL"],
    )
}

/// Plants an array that is larger than any memory.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn too_large(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Local,
        &[": ARRAY[1..100000, 1..100000] OF INT"],
    )
}

/// Plants a subrange that descends.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn subrange_descends(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(fault, VariableSection::Local, &[": INT(9..1)", ": DINT(0..-1)"])
}

/// Plants a subrange beyond its base type.
///
/// Basis: ironplc-problem-codes: P2016.
pub(super) fn subrange_outside(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Local,
        &[": SINT(0..128)", ": USINT(-1..1)", ": INT(-40000..0)"],
    )
}

/// Plants a subrange of a type other than an integer.
///
/// Basis: ironplc-problem-codes: P2015.
pub(super) fn subrange_of_no_integer(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(fault, VariableSection::Local, &[": REAL(0..1)", ": BOOL(0..1)"])
}

/// Plants a string longer than the maximum length.
///
/// Basis: ironplc-problem-codes: P2041.
pub(super) fn too_long(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Local,
        &[": STRING[70000]", ": WSTRING[70000]"],
    )
}

/// Plants a constant without a value.
///
/// Basis: ironplc-problem-codes: P4008.
pub(super) fn no_value(fault: &mut FaultSite<'_, '_>) -> Option<()> {
    declared(
        fault,
        VariableSection::Constant,
        &[": INT", ": BOOL", ": STRING", ": ARRAY[0..1] OF INT"],
    )
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
    let number = fault.choose((0..fault.original.functions.len()).collect())?;
    let block = fault.choose(fault.original.blocks.iter().collect())?;
    let text = format!("{PLANTED}_one : {}", block.name);
    fault.declare_text(Unit::Function(number), &text, VariableSection::Local)
}
