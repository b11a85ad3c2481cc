//! Groups cases into packs that an engine is asked about together, and asks again about those that a pack left undecided.
//!
//! An engine that takes long to start is given several programs at a time. A pack holds only programs that are likely to
//! pass together: programs that must be accepted, or programs whose mistakes are all found after parsing. Programs about
//! which the answer to a pack says nothing are asked about again, in packs of half the size, until the culprit stands alone;
//! so packing changes no outcome.
//!
//! Basis: harness/engines/README.md (packs).

use crate::answers::{Answers, ask, ask_pack};
use std::time::{Duration, Instant};
use stickler_engines::{EngineError, EngineSession, Packed};
use stickler_suite::{Acceptance, Case};
use stickler_types::{Code, grouped_by_key};

/// The kind of expectation that all cases of a pack share.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum PackKind {
    /// The programs are likely to be accepted.
    Accepted,
    /// The programs are expected to parse without mistakes, and to be rejected.
    Rejected,
}

/// The length in bytes from which a program is asked about alone: it may overwhelm the compiler, and those beside it would be asked again.
const LONG: usize = 32 << 10;

/// Returns the kind of pack to which a case may belong; `None` where the engine must be asked about it alone.
fn pack_kind(case: &Case) -> Option<PackKind> {
    let expectation = &*case.expectation;
    match expectation.accepted {
        _ if case.source.len() >= LONG => None,
        // More is asked about it than to run it.
        _ if expectation.rendered.is_some() => None,
        Acceptance::Required | Acceptance::Observed => Some(PackKind::Accepted),
        Acceptance::Rejected => {
            let readable = |code: Code| !breaks_reading(code);
            let readable = expectation
                .diagnostics
                .iter()
                .all(|reported| readable(reported.code));
            readable.then_some(PackKind::Rejected)
        }
    }
}

/// Returns whether a program with this mistake may fail to parse, at least in a compiler that does not know the construct
/// that the mistake is about: the compiler may then misread the text that follows.
pub fn breaks_reading(code: Code) -> bool {
    // The registry numbers first what is found while reading.
    code.as_str().starts_with("P0")
        || matches!(
            code,
            Code::PartialAccessSyntaxDisabled | Code::BitAccessOutOfRange | Code::BitAccessTypeInvalid
        )
}

/// Groups these cases into packs, each with the indices of its cases. Every case comes with the index of its engine, whose
/// pack size is in `sizes`. A case that is asked about alone is a pack of one.
pub(crate) fn packs(cases: &[(&Case, usize)], sizes: &[usize]) -> Vec<Vec<usize>> {
    let mut packs = Vec::new();
    let mut packed = Vec::new();
    for (place, &(case, engine)) in cases.iter().enumerate() {
        let kind = if sizes[engine] > 1 { pack_kind(case) } else { None };
        match kind {
            Some(kind) => packed.push(((engine, case.dialect, kind), place)),
            None => packs.push(vec![place]),
        }
    }
    for ((engine, ..), group) in grouped_by_key(packed) {
        let pieces = group.len().div_ceil(sizes[engine]);
        // Packs of like sizes: a small one at the end would cost as much as a large one.
        packs.extend(group.chunks(group.len().div_ceil(pieces)).map(<[usize]>::to_vec));
    }
    packs
}

/// The answers about a case and the time that the engine took; `None` where the case was not reached.
pub(crate) type Settled = Option<(Answers, Duration)>;

/// Asks about all cases of a pack; returns `None` for those that were not reached before `stopping` held.
///
/// # Errors
/// [`EngineError`] where no session can be opened.
pub(crate) fn settle(
    session: &mut EngineSession<'_>,
    cases: &[&Case],
    stopping: &dyn Fn() -> bool,
) -> Result<Vec<Settled>, EngineError> {
    let mut settled: Vec<Settled> = cases.iter().map(|_| None).collect();
    let mut spent = vec![Duration::ZERO; cases.len()];
    let mut open: Vec<Vec<usize>> = vec![(0..cases.len()).collect()];
    while let Some(pack) = open.pop() {
        if stopping() {
            break;
        }
        let begun = Instant::now();
        let asked: Vec<&Case> = pack.iter().map(|&place| cases[place]).collect();
        if let [place] = pack[..] {
            let answers = ask(session, cases[place])?;
            // Whoever stops the run may have ended the engine over it.
            if stopping() {
                break;
            }
            settled[place] = Some((answers, spent[place] + begun.elapsed()));
            continue;
        }
        let packed = ask_pack(session, &asked)?;
        if stopping() {
            break;
        }
        let share = begun.elapsed() / u32::try_from(pack.len()).unwrap_or(u32::MAX);
        let mut unknown = Vec::new();
        let mut alone = Vec::new();
        for (&place, packed) in pack.iter().zip(packed) {
            spent[place] += share;
            match packed {
                Packed::Answered(run) => settled[place] = Some((Answers::of_run(run), spent[place])),
                Packed::Unknown => unknown.push(place),
                Packed::Alone => alone.push(vec![place]),
            }
        }
        halve(unknown, pack.len(), &mut open);
        open.extend(alone.into_iter().rev());
    }
    Ok(settled)
}

/// Splits the cases that a pack of this size left undecided in two, unless they are far fewer already, and queues the
/// halves.
fn halve(unknown: Vec<usize>, size: usize, open: &mut Vec<Vec<usize>>) {
    let pieces = if unknown.len() * 2 > size { 2 } else { 1 };
    let most = unknown.len().div_ceil(pieces).max(1);
    // The last is asked first: the front of the suite.
    open.extend(unknown.chunks(most).rev().map(<[usize]>::to_vec));
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::DialectName;

    #[test]
    fn a_long_program_is_asked_about_alone() {
        let case = |length: usize| Case::of_program("a/b", DialectName::MATIEC, &"x".repeat(length));
        let cases = [case(LONG - 1), case(LONG), case(1)];
        let asked = cases.each_ref().map(|case| (case, 0));
        assert_eq!(packs(&asked, &[8]), [vec![1], vec![0, 2]]);
    }

    #[test]
    fn what_is_left_of_a_pack_makes_smaller_packs() {
        let halves = |count: usize, size| {
            let mut open = Vec::new();
            halve((0..count).collect(), size, &mut open);
            open.iter().map(Vec::len).collect::<Vec<_>>()
        };
        assert_eq!(halves(8, 8), [4, 4]);
        assert_eq!(halves(7, 8), [3, 4]);
        assert_eq!(halves(4, 8), [4]);
        assert_eq!(halves(2, 2), [1, 1]);
        assert_eq!(halves(1, 2), [1]);
        assert_eq!(halves(0, 8), [0; 0]);
    }
}
