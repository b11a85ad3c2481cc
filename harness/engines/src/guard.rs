//! A panic of an engine that lives in this process is a crash of that engine, not of the run.

use crate::Outcome;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};

/// Asks an engine, and turns its panic into [`Outcome::Crashed`]. Afterwards the session it came from must be
/// thrown away: that is what makes the unwind safe.
#[must_use]
pub fn guard(ask: impl FnOnce() -> Outcome) -> Outcome {
    guarded(ask).unwrap_or_else(|crashed| crashed)
}

/// Asks an engine anything, and tells its panic apart from all that it answers.
///
/// # Errors
/// [`Outcome::Crashed`] where it panicked; then, as after [`guard`], the session must be thrown away.
pub fn guarded<T>(ask: impl FnOnce() -> T) -> Result<T, Outcome> {
    catch_unwind(AssertUnwindSafe(ask)).map_err(|payload| Outcome::Crashed {
        reason: panic_text(payload.as_ref()),
    })
}

fn panic_text(payload: &(dyn Any + Send)) -> String {
    let text = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("with no message");
    format!("panicked: {text}")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_becomes_a_crash_with_its_message() {
        let number = 7;
        let outcome = guard(|| panic!("broken {number}"));
        assert_eq!(
            outcome,
            Outcome::Crashed {
                reason: "panicked: broken 7".to_owned()
            }
        );
    }

    #[test]
    fn an_answer_passes_through() {
        assert_eq!(guard(|| Outcome::Accepted), Outcome::Accepted);
    }
}
