//! Executes two programs on the reference, each in its dialect, on the same inputs, and finds the first output that differs.

use stickler_reference::Limits;
use stickler_types::boundaries::{BoundaryDetail, boundaries, neighbourhoods};
use stickler_types::{
    ClockSetting, DialectName, ElementaryType, Observation, Outcome, RunRequest, Setting, SplitMix64, Value,
};

/// The maximum number of combinations of inputs.
const MAX_COMBINATIONS: u64 = 1000;

/// The maximum number of combinations at which both programs stop, after each of which they are started again.
const MAX_STOPS: usize = 50;

/// The time from one scan to the next, in nanoseconds.
const CYCLE: i64 = 100_000_000;

/// The first output that differs.
#[derive(Clone)]
pub(super) struct Difference {
    /// The values of the inputs, in their order.
    pub inputs: Vec<Value>,
    /// The scan, from 1, since the start of both programs.
    pub scan: usize,
    /// The index of the output.
    pub output: usize,
    /// The value in each program, or `None` where it stops with a fault.
    pub results: [Option<Value>; 2],
}

/// The inputs of a program, with their types.
type Inputs = [(String, ElementaryType)];

/// Returns the first difference between the outputs of two programs for boundary values of their inputs, each of which stays for
/// `scans` scans, or `None` in its place; `None` where a program cannot be executed, or has no outputs.
pub(super) fn first_difference(
    programs: [(DialectName, &str); 2],
    inputs: &Inputs,
    outputs: &[String],
    scans: usize,
) -> Option<Option<Difference>> {
    let all = combinations(inputs, programs.map(|(dialect, _)| dialect));
    let mut start = 0;
    // Where a dialect lacks a type, there is no combination, and the first start finds that out.
    for stops in 0..MAX_STOPS {
        let Some(rest) = all.get(start..).filter(|rest| stops == 0 || !rest.is_empty()) else {
            break;
        };
        let [left, right] = programs.map(|program| run(program, inputs, rest, outputs, scans));
        let (left, right) = (left?, right?);
        // What becomes of a value that a system does not have, its documents do not say.
        let is_known =
            |value: Option<&Value>, at: usize| value.is_none_or(|value| programs[at].0.rules().holds(value));
        let differs = |&at: &usize| {
            let values @ [left, right] = [left.get(at), right.get(at)];
            left != right && is_known(values[0], 0) && is_known(values[1], 1)
        };
        if let Some(at) = (0..left.len().max(right.len())).find(differs) {
            let scan = at / outputs.len();
            return Some(Some(Difference {
                inputs: rest[scan / scans].clone(),
                scan: scan + 1,
                output: at % outputs.len(),
                results: [left.get(at).cloned(), right.get(at).cloned()],
            }));
        }
        start += left.len().checked_div(outputs.len())? / scans + 1;
    }
    Some(None)
}

/// Returns the values of the outputs after each scan, up to a fault; `None` where the program cannot be executed.
fn run(
    (dialect, source): (DialectName, &str),
    inputs: &Inputs,
    combinations: &[Vec<Value>],
    outputs: &[String],
    scans: usize,
) -> Option<Vec<Value>> {
    let total = u32::try_from(combinations.len() * scans).ok()?;
    let (mut set, mut observe) = (Vec::new(), Vec::new());
    for (before, values) in (1..).step_by(scans).zip(combinations) {
        set.extend(inputs.iter().zip(values).map(|((name, _), value)| Setting {
            before,
            name: name.as_str().into(),
            value: value.clone(),
        }));
    }
    for scan in 1..=total {
        observe.extend(outputs.iter().map(|name| Observation {
            after: Some(scan),
            ..Observation::last(name, "")
        }));
    }
    let request = RunRequest {
        dialect,
        source,
        scans: total,
        observe: &observe,
        clock: &ClockSetting::each(CYCLE, total),
        set: &set,
    };
    match stickler_reference::run(&request, Limits::default()) {
        Ok(Outcome::Executed { values, .. } | Outcome::Faulted { values, .. }) => {
            Some(values.into_iter().map(|(_, value)| value).collect())
        }
        _ => None,
    }
}

/// Returns combinations of boundary values: all where they are few, a sample otherwise; those that are short to write come first. A real
/// number that is the only input also takes the values beside halves and limits.
/// A value that a system does not have is left out, such as a negative TIME where that is a count without a sign.
fn combinations(inputs: &Inputs, dialects: [DialectName; 2]) -> Vec<Vec<Value>> {
    let is_held = |value: &Value| dialects.iter().all(|dialect| dialect.rules().holds(value));
    let of_type = |ty| {
        let values = boundaries(ty).into_iter().map(|written| written.value);
        let is_alone = inputs.len() == 1 && ty.is_real();
        let near = is_alone.then(|| neighbourhoods(ty, BoundaryDetail::Coarse));
        let near = near.into_iter().flatten().map(|raw| Value::plain(ty, raw));
        let near = near.filter(|value| value.real().is_some_and(f64::is_finite));
        values.chain(near).filter(is_held).collect::<Vec<_>>()
    };
    let values: Vec<_> = inputs.iter().map(|(_, ty)| of_type(*ty)).collect();
    let product = values
        .iter()
        .map(Vec::len)
        .fold(1, |product: u64, count| product.saturating_mul(count as u64));
    let numbers: Vec<u64> = match product <= MAX_COMBINATIONS || inputs.len() == 1 {
        true => (0..product).collect(),
        false => SplitMix64::new(0)
            .numbers()
            .take(MAX_COMBINATIONS as usize)
            .collect(),
    };
    // The digits of a number are the indices of the values.
    let combination = |mut number: u64| {
        let digits = values.iter().map(|values| {
            let digit = number % values.len() as u64;
            number /= values.len() as u64;
            values[digit as usize].clone()
        });
        digits.collect::<Vec<Value>>()
    };
    let mut combinations: Vec<_> = numbers.into_iter().map(combination).collect();
    combinations.sort_by_cached_key(|values| values.iter().map(|value| value.literal().len()).sum::<usize>());
    combinations
}
