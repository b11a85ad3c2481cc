//! All sequences of six scans of a timer, 64 instances side by side: one for each sequence of its input.

use super::PASSED;
use super::model::{Block, Inputs, Rule};
use std::fmt::Write;

/// The number of scans of a sequence.
const SCANS: usize = 6;

/// Returns the table of scans of 64 instances, of which number `n` has TRUE as its input in scan `k` of a sequence where bit `k - 1` of `n` is set.
/// The sequences follow one another; between them the inputs are FALSE for longer than `preset`. `passed` is what passes before the first scans
/// behind the first; before the others pass all times in turn.
///
/// The bits of `output`, `three` and `five` tell of each instance whether its output is TRUE, and whether its elapsed time is 3 or 5 seconds; no
/// other time than these and 0 is there. `known` has the bits of those instances of which the model says what comes; the others are 0. What the first scans of a sequence give is told once.
pub(super) fn side_by_side(block: Block, passed: &[i128], preset: i128) -> String {
    let mut text = String::from("clock scan known | output three five\n");
    let free = SCANS - 1 - passed.len();
    let mut at = 0;
    for number in 0..PASSED.len().pow(free as u32) {
        let digit = |place: usize| number / PASSED.len().pow((free - 1 - place) as u32) % PASSED.len();
        let behind = (0..free).map(|place| PASSED[digit(place)]);
        let steps: Vec<i128> = [1]
            .into_iter()
            .chain(passed.iter().copied())
            .chain(behind)
            .collect();
        // A sequence begins when all timers are at rest.
        let rest = [at + 1, at + 1 + 2 * preset];
        let _ = writeln!(text, "{}s 0 - | - - -\n{}s 0 - | - - -", rest[0], rest[1]);
        at = rest[1];
        let mut times = Vec::new();
        for (scan, step) in steps.iter().enumerate() {
            at += step;
            times.push(at);
            let is_told = (scan.saturating_sub(passed.len())..free).all(|place| digit(place) == 0);
            let _ = match is_told {
                true => writeln!(
                    text,
                    "{at}s {} {}",
                    scan + 1,
                    outputs(block, &times, rest, number > 0, preset)
                ),
                false => writeln!(text, "{at}s {} - | - - -", scan + 1),
            };
        }
    }
    text
}

/// Returns the bits of all instances after scans at these times, behind a `rest` and, where `is_later`, other sequences.
fn outputs(block: Block, times: &[i128], rest: [i128; 2], is_later: bool, preset: i128) -> String {
    let mut bits = [0_u64; 4];
    for instance in 0..64_u64 {
        let seen = |at: i128, is_on: bool| Inputs {
            at,
            bits: vec![is_on],
            preset,
        };
        let mut past = Vec::new();
        if is_later && instance != 0 {
            past.push(seen(rest[0] - 1, true));
        }
        past.extend(rest.map(|at| seen(at, false)));
        let scans = times.iter().enumerate();
        past.extend(scans.map(|(scan, at)| seen(*at, instance >> scan & 1 == 1)));
        let told = block.outputs_after(&past, Rule::Standard, (0, 0));
        for (bits, is_set) in bits
            .iter_mut()
            .zip([told[0] == "1", told[1] == "3s", told[1] == "5s", true])
        {
            let is_known = !told.iter().any(|output| output == "-");
            *bits |= u64::from(is_set && is_known) << instance;
        }
    }
    let [output, three, five, known] = bits.map(|bits| format!("16#{bits:016X}"));
    format!("{known} | {output} {three} {five}")
}
