//! The table of the kinds of errors: `kinds.toml`, whose head says what each key means.

use super::super::fault_site::FaultSite;
use super::edit::Edit;
use super::{
    blocks, calls, constants, declarations, literals, misfits, names, omitted_conversions, operands,
    statements,
};
use serde::de::{Deserialize, Deserializer, Error};
use std::sync::LazyLock;
use stickler_types::dialect::{OperandTypes, PartialAccess};
use stickler_types::{Code, Dialect, DialectName};

/// A kind of error.
#[derive(serde::Deserialize)]
pub(in super::super) struct FaultKind {
    /// The kind of the error in a few words.
    pub name: String,
    /// The code of the diagnostic.
    #[serde(deserialize_with = "code")]
    pub code: Code,
    #[serde(rename = "where")]
    dialects: Option<Dialects>,
    plant: Edit,
}

/// The dialects that a kind is for.
#[derive(Clone, Copy, serde::Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Dialects {
    NoBits,
    NoLineComments,
    NoPartialAccess,
    OwnTypes,
    PartialAccess,
}

impl Dialects {
    fn include(self, name: DialectName) -> bool {
        let dialect = Dialect::of(name);
        match self {
            Dialects::NoBits => !dialect.bit_access,
            Dialects::NoLineComments => !dialect.line_comments,
            Dialects::NoPartialAccess => dialect.partial_access == PartialAccess::Disabled,
            Dialects::OwnTypes => dialect.operands != OperandTypes::Promoted && !dialect.literals_by_width,
            Dialects::PartialAccess => name.rules().documents.partial_access,
        }
    }
}

impl FaultKind {
    /// Plants the error; `None` if the program has no place for it, and then the [`FaultSite`] is of no further use.
    pub fn plant(&self, fault: &mut FaultSite<'_, '_>) -> Option<()> {
        let dialect = fault.original.dialect;
        let is_for_it = self.dialects.is_none_or(|dialects| dialects.include(dialect));
        is_for_it.then(|| self.plant.make(fault))?
    }
}

/// Every kind.
pub(in super::super) static KINDS: LazyLock<Vec<FaultKind>> = LazyLock::new(|| {
    #[derive(serde::Deserialize)]
    struct Table {
        kind: Vec<FaultKind>,
    }
    let table: Result<Table, _> = toml::from_str(include_str!("../kinds.toml"));
    table.map(|table| table.kind).unwrap_or_default()
});

fn code<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Code, D::Error> {
    String::deserialize(deserializer)?.parse().map_err(Error::custom)
}

/// A function that plants an error.
pub(super) type Plant = fn(&mut FaultSite<'_, '_>) -> Option<()>;

/// Reads the name of one of the functions.
pub(super) fn function<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Plant, D::Error> {
    let name = String::deserialize(deserializer)?;
    let found = FUNCTIONS.iter().find(|(known, _)| *known == name);
    found
        .map(|(_, function)| *function)
        .ok_or_else(|| Error::custom(format!("no function `{name}`")))
}

macro_rules! functions {
    ($($room:ident::$function:ident,)*) => {
        &[$((concat!(stringify!($room), "::", stringify!($function)), $room::$function),)*]
    };
}

/// The functions that the table names.
const FUNCTIONS: &[(&str, Plant)] = functions! {
    misfits::standard,
    misfits::of_call_alone,
    misfits::selector,
    misfits::subscript,
    misfits::bound,
    omitted_conversions::conversion_left_out_of_operand,
    operands::operand,
    operands::only_operand,
    operands::undefined_operation,
    operands::compared_aggregates,
    literals::integer_for_operand,
    literals::bits_for_target,
    literals::subscript,
    names::variable_read,
    names::initial,
    names::field,
    names::enumerated_value,
    names::other_enumeration,
    names::variable_twice,
    names::function_twice,
    names::block_twice,
    names::two_kinds_of_one_name,
    names::type_twice,
    names::field_twice,
    names::enumerated_value_twice,
    calls::argument_too_many,
    calls::standard_argument,
    calls::conversion_argument,
    calls::recursive_function,
    calls::recursive_block,
    blocks::unknown_input,
    blocks::input_twice,
    blocks::unknown_output,
    blocks::output_taken,
    blocks::too_many_by_position,
    blocks::no_variable,
    blocks::other_type,
    blocks::constant,
    constants::assigned,
    constants::part_assigned,
    statements::descending_labels,
    declarations::third_edition,
    declarations::constant_instance,
    declarations::instance_in_function,
};
