//! Parses whole numbers on the command line, with messages for other texts.

use std::num::IntErrorKind;

/// Reads a whole number from `least` to `most`, which the type must hold.
///
/// An argument that is read by it needs `allow_negative_numbers`: then it is told what is wrong with `-1`, which would
/// otherwise pass for an option that does not exist.
pub(super) fn whole<N>(
    least: u64,
    most: u64,
) -> impl Fn(&str) -> Result<N, String> + Clone + Send + Sync + 'static
where
    N: TryFrom<u64>,
{
    move |text| {
        let number = match text.parse::<u64>() {
            Ok(number) => Some(number),
            Err(error) if *error.kind() == IntErrorKind::PosOverflow => None,
            Err(_) if most == u64::MAX => return Err(format!("write a whole number, {least} or more")),
            Err(_) => return Err(format!("write a whole number from {least} to {most}")),
        };
        let number = number.filter(|number| (least..=most).contains(number));
        let number = number.and_then(|number| N::try_from(number).ok());
        number.ok_or_else(|| format!("it must be a number from {least} to {most}"))
    }
}

#[cfg(test)]
mod tests {
    use super::whole;

    #[test]
    fn a_number_is_read_and_anything_else_is_told_what_to_write() {
        let jobs = whole::<u16>(1, 1024);
        assert_eq!(jobs("1024"), Ok(1024));
        for (text, reported) in [
            ("0", "it must be a number from 1 to 1024"),
            ("1025", "it must be a number from 1 to 1024"),
            ("99999999999999999999", "it must be a number from 1 to 1024"),
            ("-1", "write a whole number from 1 to 1024"),
            ("1.5", "write a whole number from 1 to 1024"),
            ("", "write a whole number from 1 to 1024"),
        ] {
            assert_eq!(jobs(text), Err(reported.to_owned()), "{text}");
        }
        let seed = whole::<u64>(0, u64::MAX);
        assert_eq!(seed("18446744073709551615"), Ok(u64::MAX));
        assert_eq!(seed("-1"), Err("write a whole number, 0 or more".to_owned()));
    }
}
