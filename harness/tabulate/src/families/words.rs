//! Words that many families need: sources, groups of dialects, columns.

use crate::column::Column;

/// The ForgeIEC page's table of names.
pub const NAMING: &str = "forgeiec-conversion-functions: The naming pattern";
/// The ForgeIEC page on what is lost.
pub const RANGE: &str = "forgeiec-conversion-functions: Range and precision";
/// The ForgeIEC page on truncation.
pub const TRUNC: &str = "forgeiec-conversion-functions: TRUNC vs. ROUND";
/// The ForgeIEC page on BCD.
pub const BCD: &str = "forgeiec-conversion-functions: BCD encoding";
/// The ForgeIEC page on what matiec does.
pub const CONFORMANCE: &str = "forgeiec-conversion-functions: matiec conformance";
/// IronPLC's page on conversion functions.
pub const IRONPLC_EXPLICIT: &str = "ironplc-type-conversions: Explicit Conversion Functions";
/// IronPLC's page on narrowing.
pub const IRONPLC_NARROWING: &str = "ironplc-type-conversions: Narrowing Conversions";
/// Stickler's own design.
pub const DESIGN: &str = "stickler-design: §8";

/// Every dialect.
pub const ALL: &[&str] = &["all"];
/// The dialects whose documents say most.
pub const DOCUMENTED: &[&str] = &["ironplc", "matiec"];
/// Where the ForgeIEC page speaks.
pub const MATIEC: &[&str] = &["matiec"];
/// Where it does not.
pub const ELSEWHERE: &[&str] = &["ironplc", "plcnext"];
/// Where no document says what a conversion function gives.
pub const PLCNEXT: &[&str] = &["plcnext"];

/// The columns of a table of `<SRC>_TO_<DST>` with asserted values.
pub const PAIR: &[Column] = &[
    Column::From,
    Column::To,
    Column::Input,
    Column::Typed,
    Column::Expected,
];
/// The columns of a table of `<SRC>_TO_<DST>` that only records.
pub const OPEN_PAIR: &[Column] = &[Column::From, Column::To, Column::Input];
/// The columns of a table of other names with asserted values.
pub const NAMED: &[Column] = &[
    Column::Function,
    Column::From,
    Column::To,
    Column::Input,
    Column::Typed,
    Column::Expected,
];
/// The columns of a table of other names that only records.
pub const OPEN_NAMED: &[Column] = &[Column::Function, Column::From, Column::To, Column::Input];
/// The columns of a table of `<SRC>_TO_<DST>` with asserted values that are only tried with variables.
pub const VALUES: &[Column] = &[Column::From, Column::To, Column::Input, Column::Expected];
/// The same for other names.
pub const NAMED_VALUES: &[Column] = &[
    Column::Function,
    Column::From,
    Column::To,
    Column::Input,
    Column::Expected,
];
