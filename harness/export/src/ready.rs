//! A case made ready for a page, or the reason why it is on none.

use crate::Reason;
use crate::look::Look;
use crate::parts::Parts;
use std::collections::BTreeSet;
use stickler_run::breaks_reading;
use stickler_suite::{Acceptance, Case, ExpectedValue};
use stickler_types::{ElementaryType, Value};

/// What else than programs that must be accepted an export has.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum With {
    /// Programs of which no document says whether they are accepted.
    Open,
    /// Programs that must be rejected.
    Rejected,
}

impl With {
    /// Both, in their order.
    pub const ALL: [With; 2] = [With::Open, With::Rejected];

    /// The word for it, as on the command line.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            With::Open => "open",
            With::Rejected => "rejected",
        }
    }
}

/// Which cases stand on one page: nothing else would be accepted, or rejected, together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) enum Company {
    /// They must be accepted, and need nothing but one program.
    Accepted,
    /// They must be accepted, and need POUs or types of their own.
    AcceptedWithUnits,
    /// They may be accepted, and need nothing but one program.
    Open,
    /// They may be accepted, and need POUs or types of their own.
    OpenWithUnits,
    /// They must be rejected, and need nothing but one program.
    Rejected,
}

impl Company {
    /// Whether the page is to be compiled, and never to be run.
    pub(crate) const fn is_rejected(self) -> bool {
        matches!(self, Company::Rejected)
    }
}

/// A case that a page can hold.
pub(crate) struct Ready<'c> {
    pub(crate) case: &'c Case,
    pub(crate) parts: Parts,
    pub(crate) company: Company,
    /// A person noted what the compiler does with it: it keeps its place on the page, and its program is not there.
    pub(crate) answered: bool,
    /// What is looked at, by the numbers of [`Case::observe`]; empty where there is nothing to see but that it runs.
    pub(crate) looks: Vec<(usize, Look)>,
}

impl<'c> Ready<'c> {
    /// Makes a case ready.
    ///
    /// # Errors
    /// Why it can be on no page.
    pub(crate) fn of(case: &'c Case, with: &BTreeSet<With>) -> Result<Ready<'c>, Reason> {
        let rejected = match case.expectation.accepted {
            Acceptance::Rejected if !with.contains(&With::Rejected) => return Err(Reason::Rejected),
            Acceptance::Observed if !with.contains(&With::Open) => return Err(Reason::Open),
            Acceptance::Rejected => true,
            Acceptance::Observed | Acceptance::Required => false,
        };
        refuse(case)?;
        let looks = if rejected { Vec::new() } else { looks(case)? };
        let parts = Parts::of(&case.source)?;
        let alone = parts.units.is_empty();
        let company = match case.expectation.accepted {
            Acceptance::Required if alone => Company::Accepted,
            Acceptance::Required => Company::AcceptedWithUnits,
            Acceptance::Observed if alone => Company::Open,
            Acceptance::Observed => Company::OpenWithUnits,
            Acceptance::Rejected if alone => Company::Rejected,
            Acceptance::Rejected => return Err(Reason::RejectedUnits),
        };
        Ok(Ready {
            case,
            parts,
            company,
            answered: false,
            looks,
        })
    }
}

/// # Errors
/// Where the case asks for what no page can give.
fn refuse(case: &Case) -> Result<(), Reason> {
    let expectation = &*case.expectation;
    if expectation.rendered.is_some() {
        return Err(Reason::Rendered);
    }
    if expectation.fault.is_some() {
        return Err(Reason::Fault);
    }
    let later = case
        .observe
        .iter()
        .any(|observe| observe.after.is_some_and(|scan| scan != 1));
    if case.scans != 1 || later || !case.clock.is_empty() || !case.set.is_empty() {
        return Err(Reason::Scans);
    }
    if expectation
        .values
        .iter()
        .any(|expected| is_negative_zero(&expected.value))
    {
        return Err(Reason::NegativeZero);
    }
    if expectation
        .diagnostics
        .iter()
        .any(|told| breaks_reading(told.code))
    {
        return Err(Reason::Unreadable);
    }
    Ok(())
}

fn looks(case: &Case) -> Result<Vec<(usize, Look)>, Reason> {
    let mut looks = Vec::with_capacity(case.observe.len());
    for (number, observe) in case.observe.iter().enumerate() {
        let look = Look::of(&observe.type_name);
        if look != Look::Compared || expected(case, number).is_some() {
            looks.push((number, look));
        }
    }
    if looks.is_empty() && !case.observe.is_empty() {
        return Err(Reason::Unseen);
    }
    Ok(looks)
}

/// The value that an observed variable must have, where it must have one.
pub(crate) fn expected(case: &Case, observe: usize) -> Option<&ExpectedValue> {
    let observe = &case.observe[observe];
    let values = case.expectation.values.iter();
    values
        .into_iter()
        .find(|value| value.name == observe.name && value.after == observe.after)
}

fn is_negative_zero(value: &Value) -> bool {
    match value {
        Value::Plain {
            ty: ElementaryType::Real,
            raw,
        } => *raw == u64::from((-0.0_f32).to_bits()),
        Value::Plain {
            ty: ElementaryType::Lreal,
            raw,
        } => *raw == (-0.0_f64).to_bits(),
        _ => false,
    }
}
