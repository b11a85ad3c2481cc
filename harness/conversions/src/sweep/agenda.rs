//! Turns the name of a function into the sweeps that it needs: one for each pair of types and each distinct rule.

use crate::functions::{NoSuchFunction, find_function, swept_signatures};
use crate::sweep::domain::{Domain, Sampling};
use crate::sweep::foreign::has_digest;
use crate::sweep::reference::ReferenceFunction;
use stickler_exact::{Operation, Signature, elementary_result, value};
use stickler_types::boundaries::BoundaryDetail;
use stickler_types::{ConversionChoices, DialectName, ElementaryType, Family, MomentUnits, Value};

/// A sweep of one function between fixed types, by one rule.
#[derive(Clone, PartialEq, Debug)]
pub struct Sweep {
    /// The function with its types.
    pub signature: Signature,
    /// The choices that decide the exact result besides the types.
    pub choices: ConversionChoices,
    /// The dialects that make these choices; never empty.
    pub dialects: Vec<DialectName>,
    /// The inputs of the sweep.
    pub domain: Domain,
    /// The reference's own conversion.
    pub reference: ReferenceFunction,
}

/// The units in the last place by which a function of real numbers may be off, if it is not SQRT.
///
/// Basis: rule: reals-within-units.
const UNITS: u32 = 2;

impl Sweep {
    /// Returns what must come of operands; `None` where exact arithmetic has no result, as of NaN.
    pub(crate) fn exact(&self, operands: &[Value]) -> Option<Value> {
        match (self.signature.operation, operands) {
            (Operation::Elementary, [operand]) => match elementary_result(&self.signature, operand)? {
                Value::Plain { ty, raw }
                    if ty.is_real() && !matches!(&*self.signature.function, "ABS" | "SQRT") =>
                {
                    let units = UNITS;
                    Some(Value::Near { ty, raw, units })
                }
                exact => Some(exact),
            },
            _ => Some(value(&self.signature, operands, &self.choices)),
        }
    }
}

/// The reason why a function cannot be swept.
#[derive(Clone, PartialEq, Eq, Debug, thiserror::Error)]
pub enum AgendaError {
    /// None of the dialects has the function.
    #[error(transparent)]
    NoSuchFunction(#[from] NoSuchFunction),
    /// The reference lacks a function that exact arithmetic has; one of the two is wrong.
    #[error("{dialect} of the reference has no `{function}`, but should: this is a defect of Stickler")]
    NotInReference {
        /// The name as it was given.
        function: String,
        /// The dialect.
        dialect: DialectName,
    },
}

/// The method by which a sweep converts its inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum SweepMethod {
    /// Calls of the reference's own conversion. Dialects that have the same rule share a sweep, for nothing else differs.
    Conversion,
    /// Programs that an engine executes. Each dialect has its own sweep, for another engine than the reference may differ in each;
    /// a source of 32 bits is swept only where a program can fold the results into one number, and sampled elsewhere.
    Programs,
}

impl SweepMethod {
    /// The default size of a sample for [`SweepMethod::Programs`], and for a function whose exact result takes its time, small since programs take theirs.
    const SAMPLED_BY_PROGRAMS: u64 = 10_000;

    fn domain(self, signature: &Signature, sampling: Sampling) -> Domain {
        let domain = Domain::of(&signature.operands, sampling);
        let folded = |from| domain.len() <= 1 << 16 || has_digest(from, signature.result);
        // The nearest result of the others takes a millisecond.
        let is_quick = matches!(
            (&*signature.function, signature.result),
            ("ABS" | "NOT" | "LEN", _) | ("SQRT", ElementaryType::Real)
        );
        let is_slow = signature.operation == Operation::Elementary && !is_quick;
        match signature.operands[..] {
            _ if self == SweepMethod::Conversion && !is_slow => domain,
            [from] if domain.is_exhaustive() && folded(from) && !is_slow => domain,
            _ => {
                let inputs = sampling.inputs.unwrap_or(SweepMethod::SAMPLED_BY_PROGRAMS);
                let sampled = Sampling {
                    inputs: Some(inputs),
                    detail: BoundaryDetail::Coarse,
                    ..sampling
                };
                Domain::of(&signature.operands, sampled)
            }
        }
    }
}

/// Returns the sweeps of a function, in the order of its signatures and, for each, of the dialects. The name may be in any ASCII
/// case; dialects that lack the function are left out.
///
/// # Errors
/// [`AgendaError`] where none of the dialects has the function, or where the reference lacks it.
pub fn agenda(
    function: &str,
    dialects: &[DialectName],
    sampling: Sampling,
    method: SweepMethod,
) -> Result<Vec<Sweep>, AgendaError> {
    let mut sweeps: Vec<Sweep> = Vec::new();
    for dialect in find_function(function, dialects, swept_signatures)?.having {
        let choices = dialect.rules().conversions;
        for signature in swept_signatures(function, dialect) {
            let Some(reference) = ReferenceFunction::find(&signature, dialect) else {
                return Err(AgendaError::NotInReference {
                    function: function.to_owned(),
                    dialect,
                });
            };
            let same = sweeps.iter_mut().find(|sweep| {
                method == SweepMethod::Conversion
                    && sweep.signature == signature
                    && sweep.reference == reference
                    && relevant(&signature, sweep.choices) == relevant(&signature, choices)
            });
            match same {
                Some(sweep) => sweep.dialects.push(dialect),
                None => sweeps.push(Sweep {
                    domain: method.domain(&signature, sampling),
                    dialects: vec![dialect],
                    signature,
                    choices,
                    reference,
                }),
            }
        }
    }
    let order = in_order(function, dialects);
    sweeps.sort_by_key(|sweep| order.iter().position(|signature| *signature == sweep.signature));
    Ok(sweeps)
}

/// Returns the signatures that a function has in any of the dialects, grouped by type.
fn in_order(function: &str, dialects: &[DialectName]) -> Vec<Signature> {
    let mut all: Vec<Signature> = dialects
        .iter()
        .flat_map(|dialect| swept_signatures(function, *dialect))
        .collect();
    all.sort_by(|one, other| (&one.operands, one.result).cmp(&(&other.operands, other.result)));
    all
}

/// Returns the choices, with those that cannot matter for a signature reset to a fixed value.
fn relevant(signature: &Signature, choices: ConversionChoices) -> ConversionChoices {
    let has = |is: fn(ElementaryType) -> bool| signature.operands.iter().any(|ty| is(*ty));
    let (real, text) = (has(|ty| ty.is_real()), has(|ty| ty.is_text()));
    let mut kept = DialectName::ALL[0].rules().conversions;
    if real && signature.result.is_whole() {
        kept.rounding = choices.rounding;
        match signature.operation {
            Operation::Truncate => kept.truncation_out_of_range = choices.truncation_out_of_range,
            _ => kept.out_of_range = choices.out_of_range,
        }
    }
    if text && signature.operation == Operation::Convert {
        kept.text_reading = choices.text_reading;
    }
    if signature.result.is_text() && real {
        kept.real_text = choices.real_text;
    }
    if signature.result.is_text() && has(|ty| ty.is_bit_string()) {
        kept.bit_string_text = choices.bit_string_text;
    }
    let to = signature.result;
    if let [from] = signature.operands[..] {
        let is_calendar = |ty: ElementaryType| matches!(ty.family(), Family::Date | Family::DateAndTime);
        let is_number = |ty: ElementaryType| ty.integer_range().is_some() || ty.is_real();
        if (is_calendar(from) && is_number(to)) || (is_number(from) && is_calendar(to)) {
            kept.moment_units = choices.moment_units;
        }
        if to.is_text() && from.is_moment() {
            kept.moment_text = choices.moment_text;
        }
        if choices.moment_units == MomentUnits::Counts && (from.is_moment() || to.is_moment()) {
            kept.moment_units = choices.moment_units;
            if from.is_real() {
                (kept.rounding, kept.out_of_range) = (choices.rounding, choices.out_of_range);
            }
        }
        let bits_and_real = (from.is_bit_string() && to.is_real()) || (from.is_real() && to.is_bit_string());
        if bits_and_real && from.bits() == to.bits() {
            kept.bits_as_real = choices.bits_as_real;
        }
        if (from.is_signed() && to.is_bit_string()) || (from.is_bit_string() && to.is_signed()) {
            kept.bits_as_integer = choices.bits_as_integer;
        }
        let is_count = from.integer_range().is_some() || from.is_duration();
        if choices.moment_units == MomentUnits::ShortTime && to == ElementaryType::Time && is_count {
            kept.moment_units = choices.moment_units;
        }
        if from.is_bit_string() && to == ElementaryType::Bool {
            kept.bit_string_as_bool = choices.bit_string_as_bool;
        }
    }
    if signature.operation != Operation::Convert {
        // A function that names its own way of rounding does not ask how a conversion rounds.
        kept.rounding = DialectName::ALL[0].rules().conversions.rounding;
    }
    kept
}
