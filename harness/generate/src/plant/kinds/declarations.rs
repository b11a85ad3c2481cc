//! Declarations of what cannot be.

use super::super::plot::{PLANTED, Plot};
use crate::dialect::has_third_edition;
use crate::model::{Section, Unit};

/// Declares one of these, of a name of its own.
fn declared(plot: &mut Plot<'_, '_, '_>, section: Section, texts: &[&str]) -> Option<()> {
    let unit = plot.unit()?;
    let text = plot.choose(texts.to_vec())?;
    plot.declare_text(unit, &format!("{PLANTED}_one {text}"), section)
}

/// A type of the third edition, where the dialect has the second.
///
/// Basis: language/third-edition-types.st.
pub(super) fn third_edition(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    if has_third_edition(plot.original.dialect) {
        return None;
    }
    let types = [
        ": LTIME",
        ": LDATE",
        ": LTOD",
        ": LDT",
        ": CHAR",
        ": WCHAR",
        ": ARRAY[0..1] OF LTIME",
    ];
    declared(plot, Section::Local, &types)
}

/// A declaration without its colon.
///
/// Basis: language/syntax-recovery.st.
pub(super) fn no_colon(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(plot, Section::Local, &["BOOL", "INT := 5", ":= 5", ": INT := "])
}

/// An array whose limits descend.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn limits_descend(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(
        plot,
        Section::Local,
        &[": ARRAY[3..1] OF INT", ": ARRAY[0..1, 0..-1] OF BOOL"],
    )
}

/// An array that is larger than any memory.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn too_large(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(plot, Section::Local, &[": ARRAY[1..100000, 1..100000] OF INT"])
}

/// A subrange that descends.
///
/// Basis: language/diagnostics-types.st.
pub(super) fn subrange_descends(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(plot, Section::Local, &[": INT(9..1)", ": DINT(0..-1)"])
}

/// A subrange beyond its base type.
///
/// Basis: ironplc-problem-codes: P2016.
pub(super) fn subrange_outside(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(
        plot,
        Section::Local,
        &[": SINT(0..128)", ": USINT(-1..1)", ": INT(-40000..0)"],
    )
}

/// A subrange of what is no integer.
///
/// Basis: ironplc-problem-codes: P2015.
pub(super) fn subrange_of_no_integer(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(plot, Section::Local, &[": REAL(0..1)", ": BOOL(0..1)"])
}

/// A string that is longer than strings are.
///
/// Basis: ironplc-problem-codes: P2041.
pub(super) fn too_long(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(plot, Section::Local, &[": STRING[70000]", ": WSTRING[70000]"])
}

/// A constant without a value.
///
/// Basis: ironplc-problem-codes: P4008.
pub(super) fn no_value(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    declared(
        plot,
        Section::Constant,
        &[": INT", ": BOOL", ": STRING", ": ARRAY[0..1] OF INT"],
    )
}

/// An instance of a function block that is constant.
///
/// Basis: ironplc-problem-codes: P4009.
pub(super) fn constant_instance(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let block = plot.choose(plot.original.blocks.iter().collect())?;
    let text = format!("{PLANTED}_one : {}", block.name);
    plot.declare_text(Unit::Main, &text, Section::Constant)
}

/// An instance of a function block in a function.
///
/// Basis: ironplc-problem-codes: P4054.
pub(super) fn instance_in_function(plot: &mut Plot<'_, '_, '_>) -> Option<()> {
    let number = plot.choose((0..plot.original.functions.len()).collect())?;
    let block = plot.choose(plot.original.blocks.iter().collect())?;
    let text = format!("{PLANTED}_one : {}", block.name);
    plot.declare_text(Unit::Function(number), &text, Section::Local)
}
