//! Asks for other forms of a small program that do the same: where the engine does right with one, it says in which way the engine does an
//! operation or tells a mistake.

use super::{Normal, NormalSearch, is_same};
use crate::alone::limit_of_loop_alone;
use crate::declared_first::declared_first;
use crate::failure_sign::is_of_reading;
use crate::forms::with_types;
use crate::patterns::number_pattern;
use crate::program::{ReadProgram, read};
use crate::question::{Deviation, wrong_values};
use crate::smaller_case::as_the_reference;
use crate::ways;
use crate::words::has_word;
use stickler_engines::EngineError;
use stickler_reference::errors;
use stickler_run::Symptom;
use stickler_suite::Acceptance;
use stickler_types::Value;

/// The way of an engine whose diagnostics have no places.
const ALL_PLACELESS: &str = "diagnostics without a place";
/// The way of an engine that loses the places of numbers.
pub(crate) const NUMBERS_PLACELESS: &str = "numbers without a place";

/// The way of an engine that passes by their places what is given to standard functions by name.
pub(crate) const BY_PLACE: &str = "named arguments of a standard function in another order than its inputs";

/// A form of a program that does the same; `None` where it has none.
type Form = fn(&ReadProgram<'_, '_>) -> Option<String>;

/// The ways of an engine that matter more than what comes of them, each with the form of a program that it does right.
const WHATEVER_COMES: [(&str, Form); 3] = [
    ("declaration behind its use", declared_first),
    (
        "number as an argument of a function",
        ways::with_assigned_arguments,
    ),
    (
        "comparison by a function, where the operator is right",
        ways::with_comparison_operators,
    ),
];

/// The ways of an engine that computes wrong values.
const OF_VALUES: [(&str, Form); 4] = [
    (
        "negative real number into an integer without a sign",
        ways::with_positive_number,
    ),
    (
        "operation in a wider type than its operands have",
        ways::in_two_steps,
    ),
    ("comparison in the type of its first operand", ways::turned_round),
    (
        "initial value, which is right where it is assigned",
        ways::with_assigned_initials,
    ),
];

/// The way of an engine that stops where a number is given to another type.
const OF_FAULTS: [(&str, Form); 1] = [("number with a type of its own", ways::with_typed_numbers)];

/// The way of an engine that accepts a calculation, and rejects it with its operands in the other order.
const OF_ACCEPTED: [(&str, Form); 1] = [(
    "operation in the type of its first operand",
    ways::with_swapped_operands,
)];

/// The kinds of literals that an engine reads whatever stands in them, each with the form of a program that has nothing right in them.
const OF_LITERALS: [(&str, Form); 2] = [
    ("whatever stands in a duration is accepted", |program| {
        ways::with_wrong_moment(program, true)
    }),
    (
        "whatever stands in a date or time of day is accepted",
        |program| ways::with_wrong_moment(program, false),
    ),
];

/// A program with a variable that is not declared.
const UNDECLARED: &str = "PROGRAM main\nVAR\n    into : INT;\nEND_VAR\n    into := nobody;\nEND_PROGRAM\n";

/// Programs with two mistakes, each with the words for an engine that tells only the first of them.
const TWO_MISTAKES: [(&str, &str); 2] = [
    (
        "mistakes behind the first one",
        "PROGRAM main\nVAR\n    r : INT;\nEND_VAR\n    r := 'a';\n    r := 'b';\nEND_PROGRAM\n",
    ),
    (
        "mistakes beside one of syntax",
        "PROGRAM main\nVAR\n    r : INT;\nEND_VAR\n    r := 1 + ;\n    r := 'b';\nEND_PROGRAM\n",
    ),
];

/// Returns whether what comes of a program matters nothing beside the way in which an engine does it.
pub(crate) fn is_whatever_comes(way: &str) -> bool {
    way == BY_PLACE || WHATEVER_COMES.iter().any(|(cured, _)| *cured == way)
}

impl NormalSearch<'_, '_> {
    /// Asks for the place of a variable that is not declared: an engine that loses it has no places at all. It is the numbers that have none
    /// where the mistake is one of a number, or has a place with variables for them.
    pub(super) fn places(&mut self) -> Result<(), EngineError> {
        let undeclared = as_the_reference(self.case, UNDECLARED, &[]);
        if self
            .deviation_of(undeclared.as_ref())?
            .flatten()
            .is_some_and(|seen| matches!(seen.sign.symptom, Symptom::NoPlace(_)))
        {
            self.normal.way = Some(ALL_PLACELESS);
            return Ok(());
        }
        let form = read(&self.normal.program, ways::with_variables_for_numbers);
        let Some(form) = form else { return Ok(()) };
        let is_of_number = errors(&form, self.case.dialect).is_empty();
        let case = as_the_reference(self.case, &form, &[]);
        if is_of_number || self.deviation_of(case.as_ref())? == Some(None) {
            self.normal.way = Some(NUMBERS_PLACELESS);
        }
        Ok(())
    }

    /// Asks for a loop alone from 1 to 1, and from 1 to its last value, which may be what it does not count to.
    pub(super) fn loop_alone(&mut self) -> Result<(), EngineError> {
        let text = self.normal.program.clone();
        let Some(limit) = limit_of_loop_alone(&text).filter(|limit| *limit != "1") else {
            return Ok(());
        };
        for last in ["1", limit] {
            let own = format!("FOR count := {limit} TO {limit} DO");
            let program = text.replace(&own, &format!("FOR count := 1 TO {last} DO"));
            let case = as_the_reference(self.case, &program, &self.observe(&program));
            let seen = self.deviation_of(case.as_ref())?.flatten();
            if let Some(deviation) = seen.filter(|seen| seen.sign.symptom == Symptom::Value) {
                (self.normal.program, self.normal.deviation) = (program, deviation);
                break;
            }
        }
        Ok(())
    }

    /// Asks whether the engine tells two mistakes at all, and one beside a mistake of syntax where the program has one.
    pub(super) fn beside_others(&mut self) -> Result<(), EngineError> {
        let mut expected = self.normal.deviation.expected.iter();
        let has_syntax = expected.any(|fact| {
            fact.diagnostic()
                .is_some_and(|one| one.code.as_deref().is_some_and(is_of_reading))
        });
        for (way, program) in TWO_MISTAKES.into_iter().take(1 + usize::from(has_syntax)) {
            let case = as_the_reference(self.case, program, &[]);
            let seen = self.deviation_of(case.as_ref())?.flatten();
            if let Some(deviation) = seen.filter(|seen| matches!(seen.sign.symptom, Symptom::Incomplete(_))) {
                self.normal.program = program.to_owned();
                self.normal.deviation = deviation;
                self.normal.way = Some(way);
                break;
            }
        }
        Ok(())
    }

    /// Asks about another form of the program; `None` where there is none, or no question is left.
    fn ask_form(&mut self, form: Form) -> Result<Option<Option<Deviation>>, EngineError> {
        let form = read(&self.normal.program, form);
        let case = form.and_then(|form| as_the_reference(self.case, &form, &self.observe(&form)));
        let expected = &self.normal.deviation.expected;
        let is_mistake = expected.iter().any(|fact| fact.diagnostic().is_some());
        let case = case.filter(|case| (case.expectation.accepted == Acceptance::Rejected) == is_mistake);
        self.deviation_of(case.as_ref())
    }

    /// Asks for the forms by which a program is right, whatever comes of it without them.
    pub(super) fn whatever_comes(&mut self) -> Result<(), EngineError> {
        match self.normal.deviation.sign.symptom {
            Symptom::Hang | Symptom::Text | Symptom::NoPlace(_) => Ok(()),
            _ => self.ask_forms(&WHATEVER_COMES),
        }
    }

    /// Asks for the forms by which a program with its symptom may be right.
    pub(super) fn other_forms(&mut self) -> Result<(), EngineError> {
        match self.normal.deviation.sign.symptom {
            Symptom::NotRejected(_) if !self.normal.is_unchecked() => {
                for (way, form) in OF_LITERALS {
                    if self
                        .ask_form(form)?
                        .flatten()
                        .is_some_and(|seen| seen.sign.accepts())
                    {
                        self.normal.way = Some(way);
                    }
                }
                self.ask_forms(&OF_ACCEPTED)
            }
            Symptom::Value | Symptom::Missing => {
                self.ask_forms(&OF_VALUES)?;
                if self.normal.way.is_none() && self.is_as_with_lreals() {
                    self.normal.way = Some("REAL with the precision of an LREAL");
                }
                Ok(())
            }
            Symptom::Fault(_) => self.ask_forms(&OF_FAULTS),
            _ => Ok(()),
        }
    }

    /// Returns whether all that is wrong is what it would be if the variables of type REAL were LREALs.
    fn is_as_with_lreals(&self) -> bool {
        let Normal {
            program, deviation, ..
        } = &self.normal;
        let wider = with_types(program, &[("REAL", "LREAL")]);
        let case =
            has_word(program, "REAL").then(|| as_the_reference(self.case, &wider, &self.observe(&wider)));
        let Some(case) = case.flatten() else {
            return false;
        };
        let is_it = |name: &str, got: &Value| {
            let mut values = case.expectation.values.iter();
            let wide = values.find(|one| *one.name == *name).map(|one| &one.value);
            match wide.and_then(Value::real).zip(got.real()) {
                Some((wide, real)) if got.type_name() == "REAL" => f64::from(wide as f32) == real,
                Some((wide, real)) => wide == real,
                None => wide == Some(got),
            }
        };
        let mut wrong = wrong_values(&deviation.expected, &deviation.got).peekable();
        // A literal that is rounded twice is an LREAL in between.
        let says_otherwise = || read(program, |program| number_pattern(program, deviation)).is_some();
        wrong.peek().is_some() && !says_otherwise() && wrong.all(|(name, (_, got))| is_it(name, got))
    }

    /// Asks for forms of the program, in their order: the first that is right says how the engine does the operation.
    fn ask_forms(&mut self, forms: &[(&'static str, Form)]) -> Result<(), EngineError> {
        for (way, form) in forms {
            let accepts = self.normal.deviation.sign.accepts();
            // What is rejected at last is found, wherever it is said to be.
            let is_right = |seen: Option<Deviation>| seen.is_none_or(|seen| accepts && !seen.sign.accepts());
            if self.normal.way.is_none() && self.ask_form(*form)?.is_some_and(is_right) {
                self.normal.way = Some(way);
            }
        }
        Ok(())
    }

    /// Asks for the named arguments of a standard function in the order of its inputs, and where no value is wrong, which they would not give,
    /// also for variables in their place: where the program is right with these, the names do not count.
    pub(super) fn ordered_arguments(&mut self) -> Result<(), EngineError> {
        let as_variables = |program: &ReadProgram<'_, '_>| {
            let ordered = ways::with_ordered_arguments(program)?;
            read(&ordered, ways::with_variables_for_literals)
        };
        let is_value = self.normal.deviation.sign.symptom == Symptom::Value;
        let is_right = self.ask_form(ways::with_ordered_arguments)? == Some(None)
            || !is_value
                && self.ask_form(as_variables)? == Some(None)
                // Where variables alone cure it, it is the literals.
                && self.ask_form(ways::with_variables_for_literals)? != Some(None);
        if is_right {
            self.normal.way = Some(BY_PLACE);
        }
        Ok(())
    }

    /// Asks for single-byte texts in the place of double-byte ones: where the program is right with these, it is the double-byte ones that are
    /// not.
    pub(super) fn single_bytes(&mut self) -> Result<(), EngineError> {
        if self.ask_form(ways::with_single_bytes)? == Some(None) {
            let calls = read(&self.normal.program, |program| {
                program.parts.iter().any(|part| program.call(part.id).is_some())
            });
            self.normal.way = Some(match calls {
                true => "double-byte text as an argument",
                false => "double-byte text as an operand",
            });
        }
        Ok(())
    }

    /// Asks for variables in the place of literals: where these are right, it is the literals that are not.
    pub(super) fn variables_for_literals(&mut self) -> Result<(), EngineError> {
        let form = read(&self.normal.program, ways::with_variables_for_literals);
        let case = form.and_then(|program| as_the_reference(self.case, &program, &[]));
        if let Some(seen) = self.deviation_of(case.as_ref())? {
            let has_text = self.normal.program.contains(['\'', '"']);
            let way = match has_text {
                true => "text literal as an operand",
                false => "truth literal as an operand",
            };
            // What goes wrong otherwise with variables goes wrong in this way with literals alone.
            let is_cured = seen
                .as_ref()
                .is_none_or(|seen| !is_same(&self.normal.deviation, seen));
            // A comparison in the place of a truth value is no literal.
            let is_literal =
                is_cured && (has_text || !matches!(self.ask_form(ways::with_comparisons)?, Some(Some(_))));
            self.normal.way = is_literal.then_some(way).or(self.normal.way);
            // A literal may be at fault beside what it is an operand of.
            if let Some((deviation, case)) = seen
                .filter(|seen| is_same(&self.normal.deviation, seen))
                .zip(case)
            {
                self.normal.program = case.source.to_string();
                self.normal.deviation = deviation;
                self.normal.has_variables = true;
            }
        }
        Ok(())
    }
}
