//! Sequences of scans that are too many for a line each: 64 instances side by side, one for each sequence of the inputs of some scans.

use super::PASSED;
use super::model::{Block, Inputs, Rule};

/// The number of scans of a sequence of a timer.
const SCANS: usize = 6;
/// The number of scans of a sequence of a counter.
const COUNTED: usize = 5;

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
        text.push_str(&format!("{}s 0 - | - - -\n{}s 0 - | - - -\n", rest[0], rest[1]));
        at = rest[1];
        let mut times = Vec::new();
        for (scan, step) in steps.iter().enumerate() {
            at += step;
            times.push(at);
            let is_told = (scan.saturating_sub(passed.len())..free).all(|place| digit(place) == 0);
            let outputs = match is_told {
                true => outputs(block, &times, rest, number > 0, preset),
                false => "- | - - -".to_owned(),
            };
            text.push_str(&format!("{at}s {} {outputs}\n", scan + 1));
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

/// Returns the table of scans of 64 counters upward and downward, each of which is reset before every sequence. The first scan of a sequence has all inputs in
/// turn, which the counters share, and the second all of the counted ones; in scan `k` of the last three bits `2 * k - 6` and `2 * k - 5` of
/// the number of a counter are its CU and CD. A reset or a load in a later scan would only begin a shorter sequence.
///
/// The bits of `full` and `empty` are the outputs of the counters, those of `odd` and `half` tell whether the number and a half of it are odd.
pub(super) fn counting_side_by_side(
    block: Block,
    rule: Rule,
    presets: &[i128],
    range: (i128, i128),
) -> String {
    let mut text = String::from("phase up down reset load preset | full empty odd half\n");
    let mut presets = presets.iter().cycle();
    for number in 0..64 {
        let bit = |at: usize| number >> at & 1 == 1;
        let rest = vec![false, false, true, false];
        let first = vec![bit(0), bit(1), bit(2), bit(3)];
        let second = vec![bit(4), bit(5), false, false];
        let mut shared = vec![rest, first, second];
        shared.resize(COUNTED + 1, vec![false; 4]);
        let mut pasts: Vec<Vec<Inputs>> = vec![Vec::new(); 64];
        for (scan, inputs) in shared.iter().enumerate() {
            let preset = presets.next().copied().unwrap_or_default();
            let mut bits = [0_u64; 4];
            for (instance, past) in pasts.iter_mut().enumerate() {
                let own = |input| scan > 2 && instance >> (2 * scan - 6 + input) & 1 == 1;
                let mut now = inputs.clone();
                now[0] |= own(0);
                now[1] |= own(1);
                past.push(Inputs {
                    at: 0,
                    bits: now,
                    preset,
                });
                let told = block.outputs_after(past, rule, range);
                let count: i128 = told[2].parse().unwrap_or_default();
                let seen = [told[0] == "1", told[1] == "1", count % 2 != 0, count / 2 % 2 != 0];
                for (bits, is_set) in bits.iter_mut().zip(seen) {
                    *bits |= u64::from(is_set) << instance;
                }
            }
            let inputs: Vec<String> = inputs.iter().map(|bit| u8::from(*bit).to_string()).collect();
            let bits = bits.map(|bits| format!("16#{bits:016X}")).join(" ");
            text.push_str(&format!("{scan} {} {preset} | {bits}\n", inputs.join(" ")));
        }
    }
    text
}
