//! What the standard function blocks give, by all inputs that they have seen: read off the diagrams and rules of the tables, not off the bodies
//! that a library has. So there is no state here, and each question looks back at the past.
//!
//! Basis: iec-61131-3: Tables 43 to 46 and Figure 15.

use stickler_types::words;

words! {
    /// A kind of block, with its name.
    Block {
        /// A bistable whose dominant input sets it.
        Sr = "SR",
        /// A bistable whose dominant input resets it.
        Rs = "RS",
        /// A semaphore.
        Sema = "SEMA",
        /// A detector of rising edges.
        RTrig = "R_TRIG",
        /// A detector of falling edges.
        FTrig = "F_TRIG",
        /// A counter upward.
        Ctu = "CTU",
        /// A counter downward.
        Ctd = "CTD",
        /// A counter upward and downward.
        Ctud = "CTUD",
        /// A pulse.
        Tp = "TP",
        /// An on-delay.
        Ton = "TON",
        /// An off-delay.
        Tof = "TOF",
    }
}

/// What the sources of some dialects say otherwise.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) enum Rule {
    /// As the tables have it: F_TRIG tells an edge in its first call, and counters stop at the limits of their type.
    #[default]
    Standard,
    /// F_TRIG tells no edge in its first call.
    NoFirstEdge,
    /// Counters count up to PV, and down to 0.
    StopsAtPreset,
}

/// What a block sees in a scan.
#[derive(Clone, Debug)]
pub(super) struct Inputs {
    /// The time since the start.
    pub(super) at: i128,
    /// The inputs, in the order of [`Block::inputs`].
    pub(super) bits: Vec<bool>,
    /// PV or PT.
    pub(super) preset: i128,
}

use Block::{Ctd, Ctu, Ctud, FTrig, RTrig, Rs, Sema, Sr, Tof, Ton, Tp};

impl Block {
    pub(super) fn is_timer(self) -> bool {
        matches!(self, Tp | Ton | Tof)
    }

    /// Returns the variables that programs have for the inputs.
    pub(super) fn inputs(self) -> &'static [&'static str] {
        match self {
            Sr | Rs => &["set", "reset"],
            Sema => &["claim", "release"],
            RTrig | FTrig | Tp | Ton | Tof => &["input"],
            Ctu => &["up", "reset"],
            Ctd => &["down", "load"],
            Ctud => &["up", "down", "reset", "load"],
        }
    }

    /// Returns the variables that programs have for the outputs.
    pub(super) fn outputs(self) -> &'static [&'static str] {
        match self {
            Sr | Rs | Sema | RTrig | FTrig => &["output"],
            Ctu | Ctd => &["output", "count"],
            Ctud => &["full", "empty", "count"],
            Tp | Ton | Tof => &["output", "elapsed"],
        }
    }

    /// Returns the literals of the outputs after what was seen, whose last scan is now, and `-` for what no source says; `range` is that of what a
    /// counter counts.
    pub(super) fn outputs_after(self, seen: &[Inputs], rule: Rule, range: (i128, i128)) -> Vec<String> {
        let preset = seen.last().map_or(0, |now| now.preset);
        let bit = |is_on: bool| String::from(if is_on { "1" } else { "0" });
        let timed = |(is_on, elapsed): (bool, i128)| vec![bit(is_on), format!("{elapsed}s")];
        match self {
            Sr => vec![bit(held(seen, true))],
            Rs => vec![bit(held(seen, false))],
            Sema => vec![bit(is_busy(seen))],
            RTrig => vec![bit(becomes(true, seen, 0, false))],
            FTrig => vec![bit(becomes(false, seen, 0, rule == Rule::Standard))],
            Ctu | Ctd | Ctud => {
                let count = counted(self, seen, rule, range);
                match self {
                    Ctu => vec![bit(count >= preset), count.to_string()],
                    Ctd => vec![bit(count <= 0), count.to_string()],
                    _ => vec![bit(count >= preset), bit(count <= 0), count.to_string()],
                }
            }
            Ton => timed(on_delay(seen)),
            Tof => timed(off_delay(seen)),
            Tp => {
                let mut told = pulses(seen).into_iter().map(timed);
                let first = told.next().unwrap_or_default();
                told.fold(first, |one, other| {
                    let agreed = one.into_iter().zip(other);
                    agreed
                        .map(|(one, other)| if one == other { one } else { "-".to_owned() })
                        .collect()
                })
            }
        }
    }
}

/// Returns the output of a bistable: what the last scan said in which one of the inputs was TRUE, the dominant one where both were.
fn held(seen: &[Inputs], sets_first: bool) -> bool {
    let told = seen.iter().rev().find(|one| one.bits[0] || one.bits[1]);
    told.is_some_and(|one| if sets_first { one.bits[0] } else { !one.bits[1] })
}

/// Returns the output of a semaphore: whether it was claimed before this scan and not released since, nor is now without a claim.
fn is_busy(seen: &[Inputs]) -> bool {
    let Some((now, before)) = seen.split_last() else {
        return false;
    };
    held(before, true) && (now.bits[0] || !now.bits[1])
}

/// Returns whether an input is as said now and was not in the scan before; in the first scan, whether it was not `before` it.
fn becomes(is_on: bool, seen: &[Inputs], input: usize, before: bool) -> bool {
    let [past @ .., now] = seen else { return false };
    let was = past.last().map_or(before, |last| last.bits[input]);
    now.bits[input] == is_on && was != is_on
}

/// Returns the number that a counter holds: that which the last reset or load gave it, and an edge of one of the counted inputs alone adds or
/// takes one, within its limits.
fn counted(block: Block, seen: &[Inputs], rule: Rule, (least, greatest): (i128, i128)) -> i128 {
    let place = |name: &str| block.inputs().iter().position(|known| *known == name);
    let is_on = |one: &Inputs, name: &str| place(name).is_some_and(|at| one.bits[at]);
    let edge =
        |scan: usize, name: &str| place(name).is_some_and(|at| becomes(true, &seen[..=scan], at, false));
    let last = seen
        .iter()
        .rposition(|one| is_on(one, "reset") || is_on(one, "load"));
    let start = match last.map(|scan| &seen[scan]) {
        Some(loaded) if !is_on(loaded, "reset") => loaded.preset,
        _ => 0,
    };
    (last.map_or(0, |scan| scan + 1)..seen.len()).fold(start, |count, scan| {
        let (floor, ceiling) = match rule {
            Rule::StopsAtPreset => (0, seen[scan].preset),
            Rule::Standard | Rule::NoFirstEdge => (least, greatest),
        };
        match (edge(scan, "up"), edge(scan, "down")) {
            (true, false) if count < ceiling => count + 1,
            (false, true) if count > floor => count - 1,
            _ => count,
        }
    })
}

/// Returns the time for which the input has been what it is.
fn unchanged(seen: &[Inputs]) -> i128 {
    let Some(now) = seen.last() else { return 0 };
    let same = seen.iter().rev().take_while(|one| one.bits == now.bits);
    same.last().map_or(0, |since| now.at - since.at)
}

/// Returns output and elapsed time of an on-delay: TRUE when the input has been TRUE for PT.
fn on_delay(seen: &[Inputs]) -> (bool, i128) {
    match seen.last() {
        Some(now) if now.bits[0] => (unchanged(seen) >= now.preset, unchanged(seen).min(now.preset)),
        _ => (false, 0),
    }
}

/// Returns output and elapsed time of an off-delay: FALSE when the input has been FALSE for PT, and before it was TRUE.
fn off_delay(seen: &[Inputs]) -> (bool, i128) {
    match seen.last() {
        Some(now) if now.bits[0] => (true, 0),
        Some(now) if seen.iter().any(|one| one.bits[0]) => {
            (unchanged(seen) < now.preset, unchanged(seen).min(now.preset))
        }
        _ => (false, 0),
    }
}

/// Returns what output and elapsed time of a pulse may be, which begins with a rising edge where none is under way, and lasts PT. Where an edge is
/// seen in the scan in which a pulse is seen to have ended, no source says which came first: a pulse begins, or none does.
fn pulses(seen: &[Inputs]) -> Vec<(bool, i128)> {
    let mut begun: Vec<Option<i128>> = vec![None];
    for (scan, one) in seen.iter().enumerate() {
        let is_under_way = |begun: Option<i128>, at: i128| begun.is_some_and(|begun| at - begun < one.preset);
        if becomes(true, &seen[..=scan], 0, false) {
            let before = scan.checked_sub(1).map_or(one.at, |last| seen[last].at);
            let stay = begun.iter().copied().filter(|begun| is_under_way(*begun, before));
            let mut next: Vec<Option<i128>> = stay.collect();
            if !begun.iter().all(|begun| is_under_way(*begun, one.at)) {
                next.push(Some(one.at));
            }
            begun = next;
        }
    }
    let Some(now) = seen.last() else { return Vec::new() };
    let told = begun
        .into_iter()
        .map(|begun| match begun.map(|begun| now.at - begun) {
            Some(passed) if passed < now.preset => (true, passed),
            Some(_) if now.bits[0] => (false, now.preset),
            _ => (false, 0),
        });
    told.collect()
}
