//! Draws a case with several scans as a timing diagram: a line for the clock, each variable that is set, and each that is expected.

use std::ops::RangeInclusive;

use stickler_types::{ElementaryType, Value};

use crate::model::Case;

/// The width that a diagram has for its scans.
const WIDTH: usize = 96;

/// The values of a variable in the scans of a diagram; `None` where nothing is known.
struct Line {
    name: String,
    values: Vec<Option<Value>>,
}

impl Case {
    /// Returns whether the case sets or expects something in certain scans, so that there is something to draw.
    pub fn has_timing(&self) -> bool {
        let expects = self.expectation.values.iter().any(|value| value.after.is_some());
        expects || !self.set.is_empty() || !self.clock.is_empty()
    }

    /// Draws these scans, counted from 1: BOOL as a level that is low or high, other values as texts, in blocks as wide as a terminal.
    pub fn timing_diagram(&self, scans: RangeInclusive<u32>) -> String {
        let lines = self.lines(&scans);
        let scans: Vec<String> = scans.map(|scan| scan.to_string()).collect();
        let texts = lines
            .iter()
            .flat_map(|line| line.values.iter().map(|value| width(value.as_ref())));
        let cell = 1 + texts.chain(scans.iter().map(String::len)).max().unwrap_or(1);
        let names = lines.iter().map(|line| line.name.chars().count());
        let name = names.max().unwrap_or_default().max("scan".len());
        let mut text = String::new();
        let in_block = (WIDTH / cell).max(1);
        for start in (0..scans.len()).step_by(in_block) {
            let block = start..(start + in_block).min(scans.len());
            let numbers: String = scans[block.clone()]
                .iter()
                .map(|scan| format!("{scan:<cell$}"))
                .collect();
            let gap = if start > 0 { "\n" } else { "" };
            text.push_str(&format!("{gap}{:<name$}  {}\n", "scan", numbers.trim_end()));
            for line in &lines {
                let drawn: String = line.values[block.clone()]
                    .iter()
                    .map(|value| drawn(value.as_ref(), cell))
                    .collect();
                text.push_str(&format!("{:<name$}  {}\n", line.name, drawn.trim_end()));
            }
        }
        text
    }

    /// Returns the lines of a diagram of these scans. What is set stays until it is set again.
    fn lines(&self, scans: &RangeInclusive<u32>) -> Vec<Line> {
        let mut lines: Vec<Line> = Vec::new();
        let length = usize::try_from(scans.end() + 1 - scans.start()).unwrap_or_default();
        let mut add = |name: &str, scan: u32, value: Value, is_held: bool| {
            let at = lines
                .iter()
                .position(|line| line.name == name)
                .unwrap_or(lines.len());
            if at == lines.len() {
                let (name, values) = (name.to_owned(), vec![None; length]);
                lines.push(Line { name, values });
            }
            let from = usize::try_from(scan.saturating_sub(*scans.start())).unwrap_or(usize::MAX);
            let until = if is_held {
                length
            } else {
                from.saturating_add(1).min(length)
            };
            if scan <= *scans.end() && (is_held || scan >= *scans.start()) {
                lines[at].values[from..until].fill(Some(value));
            }
        };
        for clock in &*self.clock {
            let time = Value::plain(ElementaryType::Time, clock.nanoseconds.cast_unsigned());
            add("clock", clock.before, time, true);
        }
        for set in &*self.set {
            add(&set.name, set.before, set.value.clone(), true);
        }
        for expected in &self.expectation.values {
            if let Some(scan) = expected.after {
                add(
                    &format!("→ {}", expected.name),
                    scan,
                    expected.value.clone(),
                    false,
                );
            }
        }
        lines
    }
}

/// Returns the number of characters that a value needs.
fn width(value: Option<&Value>) -> usize {
    value.map_or(1, |value| match value.truth() {
        Some(_) => 1,
        None => value.without_type().chars().count(),
    })
}

/// Returns a value as it is drawn in a cell.
fn drawn(value: Option<&Value>, cell: usize) -> String {
    match value.map(|value| (value.truth(), value)) {
        Some((Some(true), _)) => "▔".repeat(cell),
        Some((Some(false), _)) => "▁".repeat(cell),
        Some((None, value)) => format!("{:<cell$}", value.without_type()),
        None => format!("{:<cell$}", "·"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Expectation, ExpectedValue};
    use stickler_types::{ClockSetting, DialectName, Setting};

    #[test]
    fn a_diagram_holds_what_is_set_and_shows_what_is_expected_where_it_is() {
        let value = |literal: &str| Value::parse(literal).unwrap();
        let set = |before, name: &str, literal| Setting {
            before,
            name: name.into(),
            value: value(literal),
        };
        let expected = |name: &str, after, literal| {
            let (name, after) = (name.into(), Some(after));
            ExpectedValue {
                name,
                after,
                value: value(literal),
                line: 1,
            }
        };
        let clock = |before, seconds: i64| ClockSetting {
            before,
            nanoseconds: seconds * 1_000_000_000,
        };
        let case = Case {
            scans: 5,
            set: [set(2, "in", "BOOL#TRUE"), set(5, "in", "BOOL#FALSE")].into(),
            clock: [clock(1, 0), clock(4, 7)].into(),
            expectation: Expectation {
                values: vec![
                    expected("Q", 2, "BOOL#FALSE"),
                    expected("Q", 4, "BOOL#TRUE"),
                    expected("n", 3, "INT#-5"),
                ],
                ..Expectation::default()
            }
            .into(),
            ..Case::of_program("a", DialectName::IEC_ED3, "")
        };
        let drawn = [
            "scan   1      2      3      4      5",
            "clock  0ms    0ms    0ms    7000ms 7000ms",
            "in     ·      ▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▔▁▁▁▁▁▁▁",
            "→ Q    ·      ▁▁▁▁▁▁▁·      ▔▔▔▔▔▔▔·",
            "→ n    ·      ·      -5     ·      ·",
        ];
        assert_eq!(case.timing_diagram(1..=5).lines().collect::<Vec<_>>(), drawn);
        let part = case.timing_diagram(4..=4);
        assert_eq!(part.lines().nth(2), Some("in     ▔▔▔▔▔▔▔"), "{part}");
        assert!(case.has_timing());
    }
}
