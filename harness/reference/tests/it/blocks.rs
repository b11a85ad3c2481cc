//! Holds the standard timers and counters against models made from the diagrams and rules of the standard, for all short sequences of
//! their inputs.
//!
//! Basis: iec-61131-3: Tables 45 and 46, Figure 15.

use stickler_reference::{Limits, run};
use stickler_types::{ClockSetting, DialectName, Observation, Outcome, RunRequest, Setting, Value};

/// The number of scans of a sequence.
const SCANS: usize = 4;
/// The preset time, and the times that may pass between two scans: none, less than it, it, and more.
const PRESET: i64 = 100;
const PASSED: [i64; 4] = [0, 60, PRESET, 150];

/// An input of a timer: when it is seen, in milliseconds, and whether it is TRUE.
#[derive(Clone, Copy, Debug)]
struct Seen {
    at: i64,
    is_on: bool,
}

/// Returns the output and the elapsed time of a timer, by what was seen of its input so far.
type TimerModel = fn(&[Seen]) -> (bool, i64);

/// Returns the time at which the input of a timer began to be what it is now.
fn since(seen: &[Seen]) -> i64 {
    let last = seen[seen.len() - 1];
    let same = seen.iter().rev().take_while(|one| one.is_on == last.is_on);
    same.last().map_or(last.at, |one| one.at)
}

/// Returns the output and the elapsed time of an on-delay.
fn on_delay(seen: &[Seen]) -> (bool, i64) {
    let now = seen[seen.len() - 1];
    let passed = now.at - since(seen);
    match now.is_on {
        true => (passed >= PRESET, passed.min(PRESET)),
        false => (false, 0),
    }
}

/// Returns the output and the elapsed time of an off-delay.
fn off_delay(seen: &[Seen]) -> (bool, i64) {
    let now = seen[seen.len() - 1];
    let passed = now.at - since(seen);
    match now.is_on {
        true => (true, 0),
        false if seen.iter().any(|one| one.is_on) => (passed < PRESET, passed.min(PRESET)),
        false => (false, 0),
    }
}

/// Returns the output and the elapsed time of a pulse, which begins with a rising edge where none is under way.
fn pulse(seen: &[Seen]) -> (bool, i64) {
    let mut begun = None;
    let mut was_on = false;
    for one in seen {
        let is_under_way = begun.is_some_and(|begun| one.at - begun < PRESET);
        if one.is_on && !was_on && !is_under_way {
            begun = Some(one.at);
        }
        was_on = one.is_on;
    }
    let now = seen[seen.len() - 1];
    match begun.map(|begun| now.at - begun) {
        Some(passed) if passed < PRESET => (true, passed),
        Some(_) if now.is_on => (false, PRESET),
        _ => (false, 0),
    }
}

/// Runs a program for some scans, and returns the values of two variables after each.
fn after_each_scan(
    source: &str,
    names: [&str; 2],
    set: &[Setting],
    clock: &[ClockSetting],
) -> Vec<[Value; 2]> {
    let after = |scan: usize| {
        names.map(|name| Observation {
            after: Some(scan as u32),
            ..Observation::last(name, "")
        })
    };
    let observe: Vec<Observation> = (1..=SCANS).flat_map(after).collect();
    let request = RunRequest {
        scans: SCANS as u32,
        set,
        clock,
        ..RunRequest::once(DialectName::IEC_ED3, source, &observe)
    };
    let outcome = run(&request, Limits::default()).expect("what is observed is there");
    let Outcome::Executed { values, .. } = outcome else {
        panic!("{outcome:?}");
    };
    let values: Vec<Value> = values.into_iter().map(|(_, value)| value).collect();
    let pairs = values.chunks(2).map(|pair| [pair[0].clone(), pair[1].clone()]);
    pairs.collect()
}

fn parsed(literal: &str) -> Value {
    Value::parse(literal).expect("a literal")
}

#[test]
fn timers_do_what_their_diagrams_show() {
    let models: [(&str, TimerModel); 3] = [("TON", on_delay), ("TOF", off_delay), ("TP", pulse)];
    let steps = 2 * PASSED.len();
    for number in 0..steps.pow(SCANS as u32) {
        let step = |scan: usize| number / steps.pow(scan as u32) % steps;
        let mut at = 0;
        let mut seen = Vec::new();
        for scan in 0..SCANS {
            at += PASSED[step(scan) / 2];
            let is_on = step(scan) % 2 == 1;
            seen.push(Seen { at, is_on });
        }
        let literal = |on: bool| parsed(if on { "BOOL#TRUE" } else { "BOOL#FALSE" });
        let of_scan = |(scan, one): (usize, &Seen)| Setting {
            before: scan as u32 + 1,
            name: "input".into(),
            value: literal(one.is_on),
        };
        let set: Vec<Setting> = seen.iter().enumerate().map(of_scan).collect();
        let time = |(scan, one): (usize, &Seen)| ClockSetting {
            before: scan as u32 + 1,
            nanoseconds: one.at * 1_000_000,
        };
        let clock: Vec<ClockSetting> = seen.iter().enumerate().map(time).collect();
        for (block, model) in models {
            let source = format!(
                "PROGRAM main VAR timer : {block}; input : BOOL; END_VAR timer(IN := input, PT := T#{PRESET}ms); END_PROGRAM"
            );
            let found = after_each_scan(&source, ["timer.Q", "timer.ET"], &set, &clock);
            let expected = (1..=SCANS).map(|scans| {
                let (output, elapsed) = model(&seen[..scans]);
                [literal(output), parsed(&format!("TIME#{elapsed}ms"))]
            });
            let expected: Vec<[Value; 2]> = expected.collect();
            assert_eq!(found, expected, "{block}: {seen:?}");
        }
    }
}

/// Returns the number that a counter of INT holds after some scans, each with its inputs CU, CD, R and LD: an edge of one of the first two
/// alone counts, where neither of the others sets the number.
fn counted(seen: &[[bool; 4]], preset: i64) -> i64 {
    let mut count = 0;
    let mut last = [false; 2];
    for [up, down, reset, load] in seen.iter().copied() {
        let edges = [up && !last[0], down && !last[1]];
        count = match (reset, load, edges) {
            (true, ..) => 0,
            (_, true, _) => preset,
            (.., [true, false]) => (count + 1).min(i64::from(i16::MAX)),
            (.., [false, true]) => (count - 1).max(i64::from(i16::MIN)),
            _ => count,
        };
        last = [up, down];
    }
    count
}

#[test]
fn counters_count_edges_up_to_the_limits_of_their_type() {
    let bool_of = |is_on: bool| parsed(if is_on { "BOOL#TRUE" } else { "BOOL#FALSE" });
    for number in 0..16_usize.pow(SCANS as u32) {
        let bits = |scan: usize| [0, 1, 2, 3].map(|bit| number >> (4 * scan + bit) & 1 == 1);
        let seen: Vec<[bool; 4]> = (0..SCANS).map(bits).collect();
        for (block, call, masks) in [
            ("CTUD", "CU := up, CD := down, R := reset, LD := load", [true; 4]),
            ("CTU", "CU := up, R := reset", [true, false, true, false]),
            ("CTD", "CD := down, LD := load", [false, true, false, true]),
        ] {
            // What a block has no input for is asked once.
            if seen
                .iter()
                .any(|inputs| (0..4).any(|at| inputs[at] && !masks[at]))
            {
                continue;
            }
            let preset = if number % 2 == 0 { 1 } else { i64::from(i16::MAX) };
            let source = format!(
                "PROGRAM main VAR c : {block}; up, down, reset, load : BOOL; END_VAR
                 c({call}, PV := {preset}); END_PROGRAM"
            );
            let names = ["up", "down", "reset", "load"];
            let scans = seen.iter().enumerate();
            let set = scans.flat_map(|(scan, inputs)| {
                names.iter().zip(inputs).map(move |(name, input)| Setting {
                    before: scan as u32 + 1,
                    name: (*name).into(),
                    value: bool_of(*input),
                })
            });
            let set: Vec<Setting> = set.collect();
            let output = match block {
                "CTUD" => "c.QU",
                _ => "c.Q",
            };
            let found = after_each_scan(&source, [output, "c.CV"], &set, &[]);
            let expected = (1..=SCANS).map(|scans| {
                let count = counted(&seen[..scans], preset);
                let is_reached = if block == "CTD" {
                    count <= 0
                } else {
                    count >= preset
                };
                [bool_of(is_reached), parsed(&format!("INT#{count}"))]
            });
            assert_eq!(found, expected.collect::<Vec<_>>(), "{block}: {seen:?}");
        }
    }
}
