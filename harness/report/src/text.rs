//! Makes texts of unknown origin fit to be shown, since engines may print anything, and words the parts that several reports
//! share.

use crate::overview::Overview;
use std::borrow::Cow;
use stickler_run::{BaselineNote, Footer, Grade, OutdatedEntry, Totals, Verdict, clip_line};
use stickler_types::{counted, join, wrap_within};

/// The maximum number of characters that a report for people shows of a line.
pub(crate) const MAX_SHOWN_CHARACTERS: usize = 1200;

/// The maximum number of characters of a program that a report keeps. `stickler show` prints all of it.
const MAX_PROGRAM_LEN: usize = 32_000;

/// Returns what a report keeps of a program, with a note on how much it leaves out.
pub(crate) fn kept(program: &str) -> Cow<'_, str> {
    // A note that says what is left out is not cut again.
    match program.len() <= MAX_PROGRAM_LEN {
        true => Cow::Borrowed(program),
        false => Cow::Owned(clip_line(program, MAX_PROGRAM_LEN)),
    }
}

/// Escapes the control characters of a text (`\u{1b}`), except line ends and tabs, so that an engine's message cannot move
/// the cursor of a terminal, and keeps of a long one what a report keeps of a program.
pub(crate) fn visible(text: &str) -> String {
    let text = kept(text);
    let mut shown = String::with_capacity(text.len());
    for character in text.chars() {
        match character {
            '\n' | '\t' => shown.push(character),
            '\r' => {}
            _ if character.is_control() => shown.extend(character.escape_unicode()),
            _ => shown.push(character),
        }
    }
    shown
}

/// Clips a text to so many lines of so many characters each, and appends how much is left out.
pub(crate) fn clip(text: &str, lines: usize, characters: usize) -> String {
    let mut kept: Vec<String> = text
        .lines()
        .take(lines)
        .map(|line| clip_line(line, characters))
        .collect();
    let rest = text.lines().count().saturating_sub(lines);
    if rest > 0 {
        kept.push(format!("... {rest} lines more"));
    }
    kept.join("\n")
}

/// Breaks a sentence into lines of at most so many characters, except for longer words; leaves it whole where no number is given.
pub(crate) fn wrapped(sentence: &str, columns: Option<usize>) -> String {
    match columns {
        Some(columns) => wrap_within(sentence, columns),
        None => sentence.to_owned(),
    }
}

/// Formats how long a run took, and beside it how long the search for causes took.
pub(crate) fn took(footer: &Footer) -> String {
    let causes = footer.causes_ms.map_or_else(String::new, |time| {
        format!(", and {} for the causes", duration(time))
    });
    duration(footer.duration_ms) + &causes
}

/// Returns the note that follows the name of an engine whose rejections need not match code and line to pass.
pub(crate) fn judged(strict: Grade) -> &'static str {
    match strict {
        Grade::Code => "",
        Grade::Line => " (rejections judged by line)",
        Grade::Rejected => " (rejections judged without their place)",
    }
}

/// Formats a baseline's note on a case, on one line.
pub(crate) fn noted(note: &BaselineNote) -> String {
    let link = note
        .link
        .as_ref()
        .map_or(String::new(), |link| format!(" ({link})"));
    let expected = Verdict::any_of(&note.verdicts());
    let text = format!("{} expects {expected}: {}{link}", note.at, note.reason);
    visible(&text).replace(['\n', '\t'], " ")
}

/// Formats a baseline entry that is out of date, on one line.
pub(crate) fn outdated(entry: &OutdatedEntry) -> String {
    let text = format!("{}: {} {}", entry.at, entry.case, entry.why);
    visible(&text).replace(['\n', '\t'], " ")
}

/// Formats the number of entries that are out of date, as a sentence without its full stop.
pub(crate) fn outdated_entries(number: usize) -> String {
    let entries = counted(
        number as u64,
        "entry of a baseline is",
        "entries of baselines are",
    );
    format!("{entries} out of date")
}

/// Returns the number of promised features that engines lack: `1 promised feature is lacking`; `None` where they lack none.
pub(crate) fn lacking(overview: &Overview) -> Option<String> {
    let lacking = overview.lacking();
    let features = counted(lacking, "promised feature is", "promised features are");
    (lacking > 0).then(|| format!("{features} lacking"))
}

/// Formats the number of cases with each verdict that is meant and occurs: `3 pass, 1 fail`.
pub(crate) fn verdicts(totals: &Totals, is_meant: impl Fn(Verdict) -> bool) -> String {
    let occurring = Verdict::ALL.into_iter().filter(|verdict| totals.of(*verdict) > 0);
    let counts = occurring.filter(|verdict| is_meant(*verdict));
    let counts = counts.map(|verdict| format!("{} {verdict}", totals.of(verdict)));
    join(counts, ", ")
}

/// Encodes every byte that is neither unreserved in RFC 3986 nor in `kept`.
pub(crate) fn percent_encoded(text: &str, kept: &str) -> String {
    let mut encoded = String::with_capacity(text.len());
    for byte in text.bytes() {
        if byte.is_ascii_alphanumeric() || b"-._~".contains(&byte) || kept.as_bytes().contains(&byte) {
            encoded.push(char::from(byte));
        } else {
            encoded.push_str(&format!("%{byte:02X}"));
        }
    }
    encoded
}

/// Formats milliseconds for people: `34 ms`, `1.2 s`, `2 min 5 s`.
pub(crate) fn duration(milliseconds: u64) -> String {
    match milliseconds {
        0..1000 => format!("{milliseconds} ms"),
        1000..60_000 => format!("{}.{} s", milliseconds / 1000, milliseconds % 1000 / 100),
        _ => format!("{} min {} s", milliseconds / 60_000, milliseconds % 60_000 / 1000),
    }
}

#[cfg(test)]
mod tests {
    use super::{MAX_PROGRAM_LEN, clip, duration, kept, noted, visible};
    use crate::sample;
    use stickler_mdtest::assert_fits;
    use stickler_run::{BaselineNote, Verdict};

    #[test]
    fn of_a_long_program_the_beginning_is_kept_once() {
        let program = "x := 1;\n".repeat(MAX_PROGRAM_LEN);
        let shortened = kept(&program);
        assert!(shortened.ends_with(" bytes more"), "{}", shortened.len());
        assert!(shortened.len() < MAX_PROGRAM_LEN + 40);
        assert_eq!(kept(&shortened), shortened);
        assert_eq!(visible(&program), shortened);
    }

    #[test]
    fn of_a_baseline_all_that_it_expects_is_told() {
        let note = sample::baseline_note();
        assert_eq!(
            noted(&note),
            "b/reference.toml:7 expects fail: rounds (https://example.org/1)"
        );
        let note = BaselineNote {
            others: vec![Verdict::Crash, Verdict::Pass],
            ..note
        };
        let reported = noted(&note);
        assert_fits(&reported, "… expects fail or crash or pass: rounds…");
    }

    #[test]
    fn an_escape_sequence_is_shown_and_not_obeyed() {
        assert_eq!(visible("\u{1b}[2Ja\tb\r\n\0"), "\\u{1b}[2Ja\tb\n\\u{0}");
    }

    #[test]
    fn what_is_clipped_is_said() {
        assert_eq!(clip("a\nb\nc\nd", 2, 10), "a\nb\n... 2 lines more");
        let long = "abcdef".repeat(10);
        assert_eq!(clip(&long, 2, 4), "abcd ... 56 bytes more");
        assert_eq!(
            clip("abcdef", 2, 4),
            "abcdef",
            "what is cut off is shorter than the word about it"
        );
        assert_eq!(clip("äöü", 1, 3), "äöü");
    }

    #[test]
    fn durations_have_the_unit_that_suits_them() {
        assert_eq!(duration(999), "999 ms");
        assert_eq!(duration(1250), "1.2 s");
        assert_eq!(duration(125_000), "2 min 5 s");
    }
}
