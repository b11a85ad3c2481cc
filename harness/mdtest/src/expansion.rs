//! Texts that are too long to be written out.

/// Writes each `«text ×1000»` out: the text so many times. In it `{n}` is the number of the repetition from 0, and `{rest}` how
/// many are to come; either may have something added: `{n+1}`.
///
/// # Panics
/// Where a repetition has no number, or does not end.
#[must_use]
pub fn expanded(text: &str) -> String {
    let mut parts = text.split('«');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (repeated, after) = part.split_once('»').expect("the end of a repetition");
        let (repeated, times) = repeated.rsplit_once(" ×").expect("a number of repetitions");
        let times: usize = times.parse().expect("a number of repetitions");
        if repeated.contains(['{']) {
            (0..times).for_each(|n| out += &numbered(repeated, n, times - 1 - n));
        } else {
            out += &repeated.repeat(times);
        }
        out += after;
    }
    out
}

/// Replaces the counters of one repetition.
fn numbered(repeated: &str, n: usize, rest: usize) -> String {
    let mut parts = repeated.split('{');
    let mut out = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (counter, after) = part.split_once('}').expect("the end of a counter");
        let (name, more) = counter.split_once('+').unwrap_or((counter, "0"));
        let value = if name == "n" { n } else { rest };
        out += &(value + more.parse::<usize>().expect("a number")).to_string();
        out += after;
    }
    out
}

#[cfg(test)]
mod tests {
    use super::expanded;

    #[test]
    fn repetitions_are_written_out_with_their_numbers() {
        assert_eq!(
            expanded("a«( ×3»b«, v{n} : v{rest+2}; ×2»c"),
            "a(((b, v0 : v3;, v1 : v2;c"
        );
        assert_eq!(expanded("plain"), "plain");
    }
}
