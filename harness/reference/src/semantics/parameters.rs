//! Which argument of a call is for which parameter, of standard functions and conversion functions.
//!
//! Basis: ironplc-problem-codes: P4018, P4023, P4024.

use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionId};
use stickler_types::{Code, joined};

/// The parameters of a standard function, or of a conversion function with more than one.
pub(super) struct ParameterList {
    /// The names of the first parameters.
    pub(super) fixed: &'static [&'static str],
    /// The name of any more parameters, before their number, and the first one's number.
    pub(super) more: Option<(&'static str, usize)>,
    /// The least number of arguments.
    pub(super) least: usize,
}

impl ParameterList {
    /// Describes a function with these parameters and no others.
    pub(super) const fn exactly(names: &'static [&'static str]) -> ParameterList {
        ParameterList {
            fixed: names,
            more: None,
            least: names.len(),
        }
    }

    /// Lists the parameters at the end of a message about one that does not exist.
    fn parameters(&self) -> String {
        let more = self.more.map(|(stem, first)| format!("{stem}{first} …"));
        let names: Vec<_> = self
            .fixed
            .iter()
            .map(|&name| name.to_owned())
            .chain(more)
            .collect();
        match &names[..] {
            [] => String::new(),
            [one] => format!("; its only one is {one}"),
            names => format!("; it has {}", joined(names, "and")),
        }
    }

    /// Returns the index of the parameter of a name.
    pub(super) fn position(&self, name: &str) -> Option<usize> {
        let fixed = self
            .fixed
            .iter()
            .position(|known| known.eq_ignore_ascii_case(name));
        fixed.or_else(|| {
            let (stem, first) = self.more?;
            let (head, digits) = name.split_at_checked(stem.len())?;
            let plain = !digits.starts_with('0') || digits == "0";
            let number: usize = digits
                .parse()
                .ok()
                .filter(|_| plain && !digits.starts_with('+'))?;
            (head.eq_ignore_ascii_case(stem) && number >= first).then(|| self.fixed.len() + number - first)
        })
    }

    /// Returns the arguments of a call in the order of the parameters.
    ///
    /// # Errors
    /// The mistake in the arguments as a whole.
    pub(super) fn ordered(
        &self,
        arguments: &[Argument<'_>],
        call: Span,
    ) -> Result<Vec<ExpressionId>, SpannedDiagnostic> {
        const MAX_ARGUMENTS: usize = u16::MAX as usize;
        let mut places: Vec<Option<ExpressionId>> = Vec::with_capacity(arguments.len());
        for (index, argument) in arguments.iter().enumerate() {
            let (name, value) = match argument {
                Argument::Positional(value) if places.len() == index => {
                    places.push(Some(*value));
                    continue;
                }
                Argument::Positional(_) => return Err(mixed(call)),
                Argument::Named { .. } if matches!(arguments[0], Argument::Positional(_)) => {
                    return Err(mixed(call));
                }
                Argument::Named { name, value } => (name, *value),
                Argument::Output { name, .. } => {
                    return Err(SpannedDiagnostic::new(
                        Code::FunctionCallNamedArgUndeclared,
                        name.span,
                        format!("the function has no output `{}`", name.text),
                    ));
                }
            };
            // No call has more parameters than arguments, so a greater number leaves some out.
            let position = self
                .position(name.text)
                .filter(|&position| position < arguments.len() + self.least);
            let Some(position) = position else {
                return Err(SpannedDiagnostic::new(
                    Code::FunctionCallNamedArgUndeclared,
                    name.span,
                    format!(
                        "the function has no parameter `{}` here{}",
                        name.text,
                        self.parameters()
                    ),
                ));
            };
            if places.len() <= position {
                places.resize(position + 1, None);
            }
            if places[position].replace(value).is_some() {
                return Err(SpannedDiagnostic::new(
                    Code::FunctionCallDuplicateNamedArg,
                    name.span,
                    format!("`{}` is given twice", name.text),
                ));
            }
        }
        let count = arguments.len();
        let fits =
            count >= self.least && (self.more.is_some() || count == self.least) && count <= MAX_ARGUMENTS;
        match places.into_iter().collect::<Option<Vec<_>>>() {
            Some(values) if fits => Ok(values),
            _ => {
                let least = self.least;
                let needed = match self.more {
                    Some(_) if count > MAX_ARGUMENTS => format!("at most {MAX_ARGUMENTS} arguments"),
                    Some(_) => format!("at least {least} arguments"),
                    None if least == 1 => "1 argument".to_owned(),
                    None => format!("{least} arguments"),
                };
                let message = format!("the function takes {needed}, not {count}");
                Err(SpannedDiagnostic::new(
                    Code::FunctionCallWrongArgCount,
                    call,
                    message,
                ))
            }
        }
    }
}

/// Returns the one argument of a conversion function, by position or as `IN`.
///
/// # Errors
/// The mistake in the arguments as a whole.
pub(super) fn single_argument(
    arguments: &[Argument<'_>],
    call: Span,
) -> Result<ExpressionId, SpannedDiagnostic> {
    const LIST: ParameterList = ParameterList::exactly(&["IN"]);
    match arguments {
        [Argument::Positional(value)] => Ok(*value),
        _ => LIST.ordered(arguments, call).map(|values| values[0]),
    }
}

/// Refuses arguments by name and by position in one call.
pub(super) fn mixed(call: Span) -> SpannedDiagnostic {
    let message = "arguments are given all by name or all by position";
    SpannedDiagnostic::new(Code::FunctionCallMixedArgTypes, call, message)
}
