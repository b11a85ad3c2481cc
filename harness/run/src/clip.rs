//! Clips what an engine said, which may have any length, and states how much is left out.

use crate::fact::Fact;

/// The maximum number of characters of a text of an engine, such as a message, that an event keeps. What follows is counted.
const MAX_TEXT_LEN: usize = 1000;

/// The number of bytes that a text may have beyond what is kept without being cut: more than the note on what is left out has, so that a
/// text that was cut once is not cut again.
const MAX_NOTE_LEN: usize = 40;

/// The maximum number of bytes of all texts of an engine about one case that an event keeps, but for the end of the last one.
const MAX_TEXTS_LEN: usize = 32_000;

/// Clips the facts of an answer to what an event keeps, so that no engine makes the reports of a run larger than they can be read.
pub(crate) fn clip_answer(facts: Vec<Fact>) -> Vec<Fact> {
    clip(facts, usize::MAX, MAX_TEXTS_LEN)
}

/// Clips facts to so many lines; a last fact states how many lines are left out.
pub fn clip_facts(facts: &[Fact], lines: usize) -> Vec<Fact> {
    clip(facts.to_vec(), lines, usize::MAX)
}

/// Clips facts to so many lines, and all texts together to about so many bytes.
fn clip(facts: Vec<Fact>, lines: usize, bytes: usize) -> Vec<Fact> {
    let mut lines_left = lines;
    let mut bytes_left = bytes;
    let mut kept = Vec::with_capacity(facts.len().min(lines));
    let mut left_out = 0;
    for mut fact in facts {
        if let Fact::LeftOut { lines } = fact {
            left_out += lines;
            continue;
        }
        if let Fact::Rendered { lines: texts } = &mut fact {
            let whole = texts.len();
            texts.truncate(lines_left);
            let mut used = 0;
            let fitting = texts.iter().take_while(|text| {
                used += text.len().min(MAX_TEXT_LEN);
                used <= bytes_left
            });
            let fitting = fitting.count();
            texts.truncate(fitting);
            left_out += whole - fitting;
            if fitting == 0 {
                continue;
            }
        } else if lines_left == 0 || bytes_left == 0 {
            left_out += 1;
            continue;
        }
        for text in fact.texts_mut() {
            clip_text(text, MAX_TEXT_LEN);
            bytes_left = bytes_left.saturating_sub(text.len());
        }
        lines_left = lines_left.saturating_sub(fact.lines());
        kept.push(fact);
    }
    if left_out > 0 {
        kept.push(Fact::LeftOut { lines: left_out });
    }
    kept
}

/// Clips a line to so many characters, and appends how much is left out.
pub fn clip_line(line: &str, characters: usize) -> String {
    let mut line = line.to_owned();
    clip_text(&mut line, characters);
    line
}

fn clip_text(text: &mut String, characters: usize) {
    let Some((end, _)) = text.char_indices().nth(characters) else {
        return;
    };
    let rest = text.len() - end;
    if rest > MAX_NOTE_LEN {
        text.truncate(end);
        text.push_str(&format!(" ... {rest} bytes more"));
        text.shrink_to_fit();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickler_types::Diagnostic;

    fn error(code: &str, message: &str) -> Fact {
        Fact::Diagnostic(Diagnostic {
            code: Some(code.to_owned()),
            message: message.to_owned(),
            ..Diagnostic::default()
        })
    }

    #[test]
    fn what_is_cut_is_counted_and_what_fits_stays_as_it_is() {
        let long = "x".repeat(1 << 20);
        let clipped = clip_answer(vec![error("E1", "short"), error(&long, &long)]);
        assert_eq!(clipped[0], error("E1", "short"));
        let cut = format!(
            "{} ... {} bytes more",
            &long[..MAX_TEXT_LEN],
            long.len() - MAX_TEXT_LEN
        );
        assert_eq!(clipped[1], error(&cut, &cut));
        assert_eq!(clip_answer(clipped.clone()), clipped, "a text is cut once");
    }

    #[test]
    fn many_long_texts_are_cut_together() {
        let long = "ä".repeat(1 << 16);
        let clipped = clip_answer(vec![error("E1", &long); 60]);
        let text = Fact::text(&clipped);
        assert!(text.len() < 2 * MAX_TEXTS_LEN, "{}", text.len());
        let kept = clipped.len() - 1;
        assert_eq!(clipped.last(), Some(&Fact::LeftOut { lines: 60 - kept }));
    }

    #[test]
    fn what_was_left_out_before_is_counted_with_what_is_left_out_now() {
        let clipped = clip_answer(vec![
            error("E1", "x"),
            error("E2", "y"),
            Fact::LeftOut { lines: 5 },
        ]);
        assert_eq!(clipped[2], Fact::LeftOut { lines: 5 });
        assert_eq!(
            clip_facts(&clipped, 1),
            [error("E1", "x"), Fact::LeftOut { lines: 6 }]
        );
    }

    #[test]
    fn of_a_rendered_text_the_lines_that_fit_are_kept() {
        let lines = vec!["a := b;".to_owned(); 100_000];
        let clipped = clip_answer(vec![Fact::Rendered { lines }]);
        let [Fact::Rendered { lines }, Fact::LeftOut { lines: left_out }] = &clipped[..] else {
            panic!("{clipped:?}");
        };
        assert_eq!(lines.len() + left_out, 100_000);
        assert_eq!(lines.len(), MAX_TEXTS_LEN / "a := b;".len());
    }
}
