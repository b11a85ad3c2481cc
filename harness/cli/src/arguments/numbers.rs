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
    use std::fmt::Display;
    use stickler_mdtest::check_examples;

    #[test]
    fn golden_numbers() {
        fn said(read: Result<impl Display, String>) -> String {
            read.map_or_else(|message| message, |number| number.to_string())
        }
        check_examples("tests/numbers.md", |example| match example.wanted() {
            "jobs" => said(whole::<u16>(1, 1024)(example.text("text"))),
            _ => said(whole::<u64>(0, u64::MAX)(example.text("text"))),
        });
    }
}
