//! Runs a program in one scan that a case runs in several: its body stands once for each scan, behind assignments of what the case writes
//! before it. What a page shows needs no counting of scans then.

use crate::failure_sign::Sign;
use crate::forms::body;
use crate::program::read;
use crate::question::{Questioner, wrong_values};
use crate::smaller_case::as_the_reference;
use crate::words::has_word;
use std::collections::BTreeMap;
use std::fmt::Write;
use stickler_engines::EngineError;
use stickler_run::{CaseEvent, Symptom};
use stickler_suite::Case;
use stickler_syntax::Edits;
use stickler_syntax::tree::PouKind;
use stickler_types::{Observation, Value};

/// The maximum number of bytes of a program that does in one scan what another does in several, where a value is wrong.
const MAX_LENGTH: usize = 40_000;

impl Questioner<'_> {
    /// Returns a case of several scans as one of a single scan, with what the engine does with it; `None` where it needs a clock, or the engine does
    /// not deviate in the same way.
    ///
    /// # Errors
    /// [`EngineError`] where no session can be opened.
    pub(crate) fn in_one_scan(
        &mut self,
        (case, event): (&Case, &CaseEvent),
        sign: &Sign,
    ) -> Result<Option<(Case, CaseEvent, Sign)>, EngineError> {
        // The first scan after which a value is wrong is the last that matters.
        let wrong = wrong_values(&event.expected, &event.got).map(|(name, _)| name);
        let wrong = wrong.map(|name| name.split_once('@').unwrap_or((name, "")));
        let wrong = wrong.min_by_key(|(_, scan)| scan.parse().unwrap_or(u32::MAX));
        let scans = match sign.symptom {
            Symptom::Value | Symptom::Missing | Symptom::Crash(_) | Symptom::Unusable(_) => wrong
                .and_then(|(_, scan)| scan.parse().ok())
                .unwrap_or(case.scans),
            _ => 1,
        };
        if case.scans < 2 || scans > 1 && !case.clock.is_empty() {
            return Ok(None);
        }
        let is_wrong = |one: &&Observation| Some(&*one.name) == wrong.map(|(name, _)| name);
        let observed = case.observe.iter().find(is_wrong);
        let observed = observed.map(|one| Observation::last(&one.name, &one.type_name));
        for is_inlined in [true, false] {
            let program =
                unrolled(case, scans, is_inlined).filter(|text| wrong.is_none() || text.len() <= MAX_LENGTH);
            let one_scan = program.and_then(|program| as_the_reference(case, &program, observed.as_slice()));
            let is_valid = |one: &Case| one.expectation.accepted == case.expectation.accepted;
            let Some(one_scan) = one_scan.filter(is_valid) else {
                continue;
            };
            let seen = self.deviation(&one_scan)?;
            if let Some(seen) = seen.filter(|seen| seen.sign.symptom == sign.symptom) {
                let event = CaseEvent {
                    program: Some(one_scan.source.to_string()),
                    expected: seen.expected,
                    got: seen.got,
                    ..event.clone()
                };
                return Ok(Some((one_scan, event, seen.sign)));
            }
        }
        Ok(None)
    }
}

/// Returns the program of a case with the body of its PROGRAM once for each of the first scans, with what the case writes as literals in the
/// place of the variables, or else as assignments; `None` where it has no body, or one that may end before its last statement.
fn unrolled(case: &Case, scans: u32, is_inlined: bool) -> Option<String> {
    read(&case.source, |program| {
        let main = program.unit.pous().find(|pou| pou.kind == PouKind::Program)?;
        let place = body(program.text, main)?;
        let mut set = BTreeMap::new();
        let mut all = String::new();
        for scan in 1..=scans {
            let mut edits = Edits::new();
            let now = case.set.iter().filter(|setting| setting.before == scan);
            let now = now.map(|setting| (&*setting.name, plain(&setting.value)));
            if is_inlined {
                set.extend(now);
                let here = program.parts.iter();
                let here = here.filter(|part| place.contains(&(part.expression.span.start as usize)));
                let read = here.filter_map(|part| {
                    Some(Edits::replacing(
                        part.expression.span,
                        set.get(part.name()?)?.as_str(),
                    ))
                });
                edits.extend(read);
            } else {
                now.for_each(|(name, value)| all += &format!("    {name} := {value};\n"));
            }
            let statements = edits.apply(program.text);
            let end = statements.len() - (program.text.len() - place.end);
            let _ = writeln!(all, "    {}", &statements[place.start..end]);
        }
        let has_end = has_word(&program.text[place.clone()], "RETURN");
        (!has_end).then(|| Edits::replacing(place, all.trim()).apply(program.text))
    })
}

/// Returns a value as a literal, without its type where that is plain.
fn plain(value: &Value) -> String {
    let literal = value.to_string();
    match literal.split_once('#') {
        Some(("BOOL" | "SINT" | "INT" | "DINT" | "LINT" | "USINT" | "UINT" | "UDINT" | "ULINT", plain)) => {
            plain.to_owned()
        }
        _ => literal,
    }
}
