//! Prepares a case for a page, or finds the reason why no page can hold it.

use crate::Reason;
use crate::encoding::ValueEncoding;
use std::collections::BTreeSet;
use stickler_run::breaks_reading;
use stickler_suite::{Acceptance, Case, ExpectedValue};
use stickler_syntax::ProgramParts;
use stickler_types::{Dialect, ElementaryType, Value, words};

words! {
    /// A kind of cases that an export may have beside those whose programs must be accepted.
    ExtraCases {
        /// Cases of which no source in Stickler says whether their programs are accepted.
        Open = "open",
        /// Cases whose programs must be rejected.
        Rejected = "rejected",
    }
}

/// The kind of cases that a page holds. Cases of different kinds would not be accepted, or rejected, together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub(crate) enum PageKind {
    /// Cases that must be accepted, and need one program only.
    Accepted,
    /// Cases that must be accepted, and need POUs or types of their own.
    AcceptedWithUnits,
    /// Cases that may be accepted, and need one program only.
    Open,
    /// Cases that may be accepted, and need POUs or types of their own.
    OpenWithUnits,
    /// Cases of which only their acceptance is asked, and which need one program only.
    Asked,
    /// Cases that must be rejected, and need one program only.
    Rejected,
}

impl PageKind {
    /// Returns whether the page is only compiled and never run.
    pub(crate) const fn is_compiled(self) -> bool {
        matches!(self, PageKind::Asked | PageKind::Rejected)
    }
}

/// A case that a page can hold.
pub(crate) struct PageCase<'c> {
    pub(crate) case: &'c Case,
    pub(crate) parts: ProgramParts,
    pub(crate) kind: PageKind,
    /// Whether a person noted the outcome of the case, which then keeps its place on the page without its program.
    pub(crate) answered: bool,
    /// The encoding of each observed value, by its number in [`Case::observe`]; empty where only the run itself counts.
    pub(crate) encodings: Vec<(usize, ValueEncoding)>,
}

impl<'c> PageCase<'c> {
    /// Prepares a case for a page.
    ///
    /// # Errors
    /// The [`Reason`] why no page can hold the case.
    pub(crate) fn of(case: &'c Case, with: &BTreeSet<ExtraCases>) -> Result<PageCase<'c>, Reason> {
        let rejected = match case.expectation.accepted {
            Acceptance::Rejected if !with.contains(&ExtraCases::Rejected) => return Err(Reason::Rejected),
            Acceptance::Observed if !with.contains(&ExtraCases::Open) => return Err(Reason::Open),
            Acceptance::Rejected => true,
            Acceptance::Observed | Acceptance::Required => false,
        };
        refuse(case)?;
        let encodings = if rejected { Vec::new() } else { encodings(case)? };
        let parts = ProgramParts::of(&case.source, Dialect::of(case.dialect))?;
        let alone = parts.units.is_empty();
        // Where such a program is rejected, no other of its page would run.
        let asks_acceptance = alone && case.observe.is_empty();
        let kind = match case.expectation.accepted {
            Acceptance::Required if alone => PageKind::Accepted,
            Acceptance::Required => PageKind::AcceptedWithUnits,
            Acceptance::Observed if asks_acceptance => PageKind::Asked,
            Acceptance::Observed if alone => PageKind::Open,
            Acceptance::Observed => PageKind::OpenWithUnits,
            Acceptance::Rejected if alone => PageKind::Rejected,
            Acceptance::Rejected => return Err(Reason::RejectedUnits),
        };
        Ok(PageCase {
            case,
            parts,
            kind,
            answered: false,
            encodings,
        })
    }
}

/// # Errors
/// The [`Reason`] where the case needs something that no page supports.
fn refuse(case: &Case) -> Result<(), Reason> {
    let expectation = &*case.expectation;
    if expectation.rendered.is_some() {
        return Err(Reason::Rendered);
    }
    if expectation.fault.is_some() {
        return Err(Reason::Fault);
    }
    if !expectation.warnings.is_empty() {
        return Err(Reason::Warned);
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
        .any(|reported| breaks_reading(reported.code))
    {
        return Err(Reason::Unreadable);
    }
    Ok(())
}

fn encodings(case: &Case) -> Result<Vec<(usize, ValueEncoding)>, Reason> {
    let mut encodings = Vec::with_capacity(case.observe.len());
    for (number, observe) in case.observe.iter().enumerate() {
        let encoding = ValueEncoding::of(&observe.type_name);
        if encoding != ValueEncoding::Compared || expected(case, number).is_some() {
            encodings.push((number, encoding));
        }
    }
    if encodings.is_empty() && !case.observe.is_empty() {
        return Err(Reason::Unseen);
    }
    Ok(encodings)
}

/// Returns the value that an observed variable must have; `None` where the case expects none.
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
