//! Prepares a case for a page, or finds the reason why no page can hold it.

use crate::encoding::encoded;
use std::collections::BTreeSet;
use stickler_run::breaks_reading;
use stickler_suite::{Acceptance, Case, ExpectedValue};
use stickler_syntax::{Indivisible, ProgramParts};
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

words! {
    /// The reason for which a case is left out of an export.
    Reason {
        /// The program must be rejected, and such cases were not requested.
        Rejected = "must be rejected by the compiler (--with rejected exports them too)",
        /// No source in Stickler says whether the program is accepted, and such cases were not requested.
        Open = "may be accepted or rejected: no source in Stickler says (--with open exports them too)",
        /// The command line leaves the case out by its id.
        Named = "named by --without",
        /// The case was not drawn for the sample.
        Sampled = "not drawn by --sample",
        /// The case needs several scans, a clock, or variables that are set from outside.
        Scans = "need several scans, a clock, or variables that are set from outside",
        /// The program must stop at a fault, which would also end the array of results.
        Fault = "must stop at a fault, and a page would stop with them",
        /// The case expects its program in normal form.
        Rendered = "ask for the program as text",
        /// The program shares variables with a configuration or with the machine, or is incomplete.
        Shares = "share something with a configuration or the machine, or are not whole",
        /// The source text has no program.
        NoProgram = "have no program",
        /// The source text has several programs.
        SeveralPrograms = "have several programs",
        /// The program may end before its last statement.
        Returns = "may end before their last statement",
        /// The program has a section of variables that several programs cannot share.
        Section = "have variables that are retained, temporary, or passed to a program",
        /// The case expects -0.0, which compares equal to 0.0.
        NegativeZero = "expect -0.0, which no comparison tells from 0.0",
        /// No document demands a value, and the observed value's type cannot be encoded as numbers without a conversion.
        Unseen = "record a text, a character, a date or a time of day, which makes no number",
        /// A mistake in the program keeps a compiler from parsing the cases after it.
        Unreadable = "cannot be read by a compiler, which would not read what stands behind them",
        /// The compiler must warn, which no array of results and no note of an outcome tells.
        Warned = "must be accepted with a warning, which is not imported",
        /// The program must be rejected, and its mistake may be in a POU or type of its own.
        RejectedUnits = "must be rejected, and have POUs or types of their own in which the mistake may be",
    }
}

impl From<Indivisible> for Reason {
    fn from(reason: Indivisible) -> Reason {
        match reason {
            Indivisible::Shares => Reason::Shares,
            Indivisible::NoProgram => Reason::NoProgram,
            Indivisible::SeveralPrograms => Reason::SeveralPrograms,
            Indivisible::Returns => Reason::Returns,
            Indivisible::Section => Reason::Section,
        }
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
    /// The observed values by their numbers in [`Case::observe`], each with the type that it is [encoded] as; empty where only the run itself counts.
    pub(crate) observed: Vec<(usize, Option<ElementaryType>)>,
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
        let observed = if rejected { Vec::new() } else { observed(case)? };
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
            observed,
        })
    }
}

/// # Errors
/// The [`Reason`] where the case needs something that no page supports.
fn refuse(case: &Case) -> Result<(), Reason> {
    let expectation = &*case.expectation;
    let mut observed = case.observe.iter();
    let later = observed.any(|observe| observe.after.is_some_and(|scan| scan != 1));
    let has_time = case.scans != 1 || later || !case.clock.is_empty() || !case.set.is_empty();
    let mut values = expectation.values.iter();
    let mut diagnostics = expectation.diagnostics.iter();
    let reasons = [
        (expectation.rendered.is_some(), Reason::Rendered),
        (expectation.fault.is_some(), Reason::Fault),
        (!expectation.warnings.is_empty(), Reason::Warned),
        (has_time, Reason::Scans),
        (
            values.any(|one| is_negative_zero(&one.value)),
            Reason::NegativeZero,
        ),
        (
            diagnostics.any(|one| breaks_reading(one.code)),
            Reason::Unreadable,
        ),
    ];
    let first = reasons.into_iter().find(|(applies, _)| *applies);
    first.map_or(Ok(()), |(_, reason)| Err(reason))
}

fn observed(case: &Case) -> Result<Vec<(usize, Option<ElementaryType>)>, Reason> {
    let all = case.observe.iter().map(|observe| encoded(&observe.type_name));
    let is_shown =
        |(number, encoded): &(usize, Option<_>)| encoded.is_some() || expected(case, *number).is_some();
    let observed: Vec<_> = all.enumerate().filter(is_shown).collect();
    match observed.is_empty() && !case.observe.is_empty() {
        true => Err(Reason::Unseen),
        false => Ok(observed),
    }
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
    let number = value.real();
    number.is_some_and(|number| number == 0.0 && number.is_sign_negative())
}
