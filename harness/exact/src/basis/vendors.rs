//! The results on the page of a vendor whose system's recordings count for more, so that both can be shown where they differ.

use crate::real;
use crate::signature::{Operation, Signature};
use crate::value::value;
use stickler_types::{ConversionChoices, DialectName, Value};

/// Returns the result that the vendor's page states of a call in a dialect whose cases rest on recordings, with its basis; `None` where the
/// page does not speak of the call, or there is no such page.
///
/// Takes what [`crate::expected`] takes. What the page says decides no case.
pub fn stated_by_vendor(
    signature: &Signature,
    operands: &[Value],
    dialect: DialectName,
) -> Option<(Value, &'static str)> {
    let documented = dialect.definition().is_none().then(|| dialect.rules());
    let page = documented?.documents.page_on_reals.as_ref()?;
    if !is_of_finite_real(signature, operands) {
        return None;
    }
    let choices = ConversionChoices {
        rounding: page.rounding,
        out_of_range: page.out_of_range,
        ..dialect.rules().conversions
    };
    Some((value(signature, operands, &choices), &page.basis))
}

/// Returns whether a call is one of `REAL_TO_x` or `LREAL_TO_x` to an integer or bit string, with a number.
fn is_of_finite_real(signature: &Signature, operands: &[Value]) -> bool {
    let (&[from], &[Value::Plain { raw, .. }]) = (&signature.operands[..], operands) else {
        return false;
    };
    let to = signature.result;
    signature.operation == Operation::Convert
        && from.is_real()
        && !signature.function.starts_with("TO_")
        && (to.is_integer() || (to.is_bit_string() && to.bits() > 1))
        && signature.takes(operands)
        && matches!(real::decode(raw, from), real::Real::Finite(_))
}
