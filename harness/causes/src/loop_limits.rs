//! FOR loops that count beyond the limits of the type of their variable, which a variable that wraps never leaves.

use crate::malformed::number_of_literal;
use crate::program::ReadProgram;
use crate::words::{LOOPS, words};
use stickler_syntax::tree::StatementKind;
use stickler_syntax::visitor::Place;
use stickler_types::ElementaryType;

/// The pattern of such a loop.
pub(crate) const TO_LAST_VALUE: &str = "FOR loop to the last value of its type, which goes on behind that";

/// Returns the line of the only loop of a program, where that is a FOR with numbers for its limits, behind whose last value no step stays
/// within the type of its variable; `None` where there is no such loop, or another one too.
pub(crate) fn loop_beyond_limit(program: &ReadProgram<'_, '_>) -> Option<u32> {
    let is_loop = |word: &&&str| LOOPS.iter().any(|one| one.eq_ignore_ascii_case(word));
    if words(program.text).iter().filter(is_loop).count() != 1 {
        return None;
    }
    let number = |id| number_of_literal(program.literal(id)?);
    let mut limits = program.at(Place::From);
    limits.find_map(|from| {
        let statement = from.statement?;
        let StatementKind::For { control, to, by, .. } = statement.kind else {
            return None;
        };
        let (least, most) = program.type_of(control).and_then(ElementaryType::integer_range)?;
        let (from, to, step) = (number(from.id)?, number(to)?, by.map_or(Some(1), number)?);
        let steps = to
            .checked_sub(from)?
            .checked_div(step)
            .filter(|steps| *steps >= 0)?;
        let behind = from.checked_add(steps.checked_add(1)?.checked_mul(step)?)?;
        (!(least..=most).contains(&behind)).then(|| program.line(statement.span))
    })
}
