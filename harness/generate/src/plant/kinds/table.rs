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
    SingleByteTexts,
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
            Dialects::SingleByteTexts => !dialect.utf8_texts,
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
    ($($room:ident { $($function:ident),* })*) => {
        &[$($((concat!(stringify!($room), "::", stringify!($function)), $room::$function),)*)*]
    };
}

/// The functions that the table names.
const FUNCTIONS: &[(&str, Plant)] = functions! {
    misfits { standard, of_call_alone, selector, subscript, bound }
    omitted_conversions { conversion_left_out_of_operand }
    operands { operand, only_operand, undefined_operation, compared_aggregates }
    literals { integer_for_operand, bits_for_target, subscript }
    names { variable_read, initial, field, enumerated_value, other_enumeration, variable_twice,
        function_twice, block_twice, two_kinds_of_one_name, type_twice, field_twice, enumerated_value_twice }
    calls { argument_too_many, standard_argument, conversion_argument, recursive_function, recursive_block }
    blocks { unknown_input, input_twice, unknown_output, output_taken, too_many_by_position, no_variable,
        other_type, constant }
    constants { assigned, part_assigned }
    statements { descending_labels }
    declarations { third_edition, constant_instance, instance_in_function }
};
