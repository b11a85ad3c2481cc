//! Numbers as messages and reports have them.

/// Writes a number with commas between its thousands: `62,118`.
#[must_use]
pub fn grouped(number: u64) -> String {
    let digits = number.to_string();
    let mut text = String::with_capacity(digits.len() * 4 / 3);
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Writes a number, grouped, and the word for one or for several: `1 case`, `62,118 cases`.
#[must_use]
pub fn counted(number: u64, one: &str, several: &str) -> String {
    format!("{} {}", grouped(number), if number == 1 { one } else { several })
}

#[cfg(test)]
mod tests {
    use super::{counted, grouped};

    #[test]
    fn thousands_are_kept_apart() {
        assert_eq!(
            [0, 999, 1_000, 65_536, 4_294_967_296].map(grouped),
            ["0", "999", "1,000", "65,536", "4,294,967,296"]
        );
    }

    #[test]
    fn one_has_a_word_of_its_own() {
        assert_eq!(
            [0, 1, 2].map(|number| counted(number, "case", "cases")),
            ["0 cases", "1 case", "2 cases"]
        );
    }
}
