//! The normal form of a small program: the plainest program with which the engine still fails in the same way.
//!
//! Two programs with one normal form show one defect, whatever tables and types they come from. The reducer finds it with passes of
//! its own: first an operand alone or fewer statements, then plainer types and numbers. Only the reference says what must happen with
//! it, so it decides which cases belong together, and what the title names, and no case is failed by it.

use crate::alone::{BEGINNING_BLOCK, alone, beginning_block, distance};
use crate::forms;
use crate::program::{ReadProgram, ask, tokens};
use crate::question::{Deviation, Questioner, all_variables, as_the_reference};
use crate::reduction::Smallest;
use crate::sign::{is_of_a_value, is_of_reading, is_unread};
use crate::values::{leaves_range, plainer_numbers, plainness};
use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use stickler_engines::EngineError;
use stickler_reduce::{Interestingness, Pass, ReductionBudget, ReductionMethod, Sites, StopReason, minimise};
use stickler_run::{Fact, Symptom};
use stickler_suite::{Acceptance, Case};
use stickler_syntax::Edits;
use stickler_syntax::features::features;
use stickler_types::{Dialect, DialectName, Observation};

/// The normal form of a small program.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Normal {
    pub(crate) program: String,
    pub(crate) deviation: Deviation,
    /// Whether the program is an operand or a statement of the small one alone.
    pub(crate) is_operand: bool,
    /// The way in which the engine does an operation, where another form of the program shows it.
    pub(crate) way: Option<&'static str>,
    /// Whether the engine was asked for each operand of the program alone, so that none of them fails but the program does.
    pub(crate) is_asked: bool,
    /// The number of times that the engine was asked.
    pub(crate) questions: u64,
}

impl Normal {
    /// Returns the small program itself, where nothing was asked.
    pub(crate) fn unasked(smallest: &Smallest) -> Normal {
        Normal {
            program: smallest.program.clone(),
            deviation: smallest.deviation.clone(),
            is_operand: false,
            way: None,
            is_asked: false,
            questions: 0,
        }
    }

    /// Returns the normal form as the program to show in the place of the small one.
    pub(crate) fn as_smallest(&self, smallest: &Smallest) -> Smallest {
        Smallest {
            program: self.program.clone(),
            deviation: self.deviation.clone(),
            ..smallest.clone()
        }
    }

    /// Returns whether variables of function blocks do not begin with their values, so that what the small program does with them does
    /// not matter.
    pub(crate) fn is_beginning(&self) -> bool {
        self.program == BEGINNING_BLOCK
    }

    /// Returns whether a value of quite another type is accepted in the place of the mistake.
    pub(crate) fn is_unchecked(&self) -> bool {
        let line = self
            .deviation
            .expected
            .iter()
            .find_map(|fact| fact.diagnostic()?.line);
        matches!(&self.deviation.sign.symptom, Symptom::NotRejected(code) if is_of_a_value(code))
            && line.is_some_and(|line| ask(&self.program, |program| forms::is_other_operand(program, line)))
    }

    /// Returns the literals that the engine takes alone.
    pub(crate) fn innocent_literals(&self) -> BTreeSet<String> {
        let operands = ask(&self.program, alone).into_iter().filter(|_| self.is_asked);
        operands.filter_map(|one| one.literal).collect()
    }
}

/// A program on its way to its normal form.
#[derive(Clone)]
struct Draft {
    text: String,
    dialect: DialectName,
}

impl Draft {
    /// Takes one of several programs in the place of this one. Where several are chosen none is taken, so that they are tried one by
    /// one, in their order.
    fn alternative(&mut self, sites: &mut Sites, find: impl FnOnce(&ReadProgram<'_, '_>) -> Vec<String>) {
        let found = ask(&self.text, find);
        let mut chosen = found.into_iter().filter(|_| sites.here());
        if let (Some(one), None) = (chosen.next(), chosen.next()) {
            self.text = one;
        }
    }

    /// Makes some of several changes together.
    fn change(&mut self, sites: &mut Sites, find: fn(&ReadProgram<'_, '_>) -> Vec<Edits>) {
        let found = ask(&self.text, find);
        let mut chosen = Edits::new();
        chosen.extend(found.into_iter().filter(|_| sites.here()));
        self.text = chosen.apply(&self.text);
    }
}

/// Creates a pass that takes one of several programs in the place of another.
macro_rules! alternatives {
    ($name:literal, $find:expr) => {
        Pass {
            name: $name,
            edit: |draft, sites| draft.alternative(sites, $find),
        }
    };
}

type NormalPass = Pass<Draft>;
const OPERAND_ALONE: NormalPass = alternatives!("take an operand alone", operands_alone);
const INITIAL_VALUES: NormalPass = alternatives!("leave the bodies out", forms::only_initial_values);
const BEGINNING: NormalPass = alternatives!("begin a variable of a function block", beginning_block);
const OTHER_OPERAND: NormalPass = Pass {
    name: "give quite another type",
    edit: |draft, sites| {
        let dialect = draft.dialect;
        draft.alternative(sites, |program| with_other_operand(program, dialect));
    },
};
const ONE_STATEMENT: NormalPass = alternatives!("keep one statement", forms::with_one_statement);
const WHOLE_OUTPUT: NormalPass = alternatives!("give an output to a variable", forms::with_whole_output);
const FIRST_PARTS: NormalPass = alternatives!("select the first parts", forms::with_first_parts);
const FITTING_OPERAND: NormalPass = alternatives!("give the right type", forms::with_fitting_operand);
const SAME_TYPES: NormalPass = alternatives!("make two types one", forms::with_same_types);
const PLAINER_TYPE: NormalPass = alternatives!("take a plainer type", forms::with_plainer_type);
const PLAINER_NUMBERS: NormalPass = Pass {
    name: "take plainer numbers",
    edit: |draft, sites| draft.change(sites, plainer_numbers),
};

/// Returns the operands of a program, each in a program of its own.
fn operands_alone(program: &ReadProgram<'_, '_>) -> Vec<String> {
    alone(program).into_iter().map(|one| one.program).collect()
}

/// Returns programs with quite another type in the place of a value on the line of the mistake.
fn with_other_operand(program: &ReadProgram<'_, '_>, dialect: DialectName) -> Vec<String> {
    let errors = stickler_reference::errors(program.text, dialect);
    let line = errors.iter().find_map(|error| error.line).unwrap_or_default();
    forms::with_other_operand(program, line)
}

/// Returns the passes that find out what of a program a symptom needs.
fn structure_passes(symptom: &Symptom) -> &'static [NormalPass] {
    match symptom {
        Symptom::Value | Symptom::Missing => &[INITIAL_VALUES, BEGINNING, OPERAND_ALONE],
        // A loop may have no end, and a division stop, because a variable does not begin with its value.
        Symptom::Hang | Symptom::Fault(_) => &[INITIAL_VALUES],
        Symptom::NotRejected(code) if is_of_a_value(code) => &[OPERAND_ALONE, OTHER_OPERAND],
        Symptom::NotRejected(_) | Symptom::Rejected(_) => &[OPERAND_ALONE],
        Symptom::NotImplemented(_) => &[ONE_STATEMENT, WHOLE_OUTPUT],
        Symptom::OtherCode { .. } | Symptom::Surplus(_) | Symptom::OtherLine(_) => {
            &[FIRST_PARTS, OPERAND_ALONE, FITTING_OPERAND, SAME_TYPES]
        }
        _ => &[],
    }
}

/// Returns the weight of what a program does: one without a mistake is lighter, then an operand alone, then one with fewer features of
/// the language, then with fewer words. What takes the place of a value to see whether it is checked weighs nothing.
fn structure(draft: &Draft) -> (u64, u128) {
    let text = draft.text.as_str();
    let has_mistake = !stickler_reference::errors(text, draft.dialect).is_empty();
    let form = 3 * u64::from(has_mistake) + distance(text);
    let features = features(text, Dialect::of(draft.dialect)).into_iter();
    let features = features
        .filter(|key| !matches!(&**key, "string-literal" | "duration-literal"))
        .count();
    let (mut words, mut size) = (0, 0_u128);
    for token in tokens(text) {
        let written = token.span.text(text);
        words += if token.kind.is_literal() { 1 } else { 2 };
        if token.kind.is_literal() && !matches!(written, "'a'" | "T#1s") || written.starts_with('%') {
            size += written.bytes().map(u128::from).sum::<u128>();
        }
    }
    (form * 1_000_000 + features as u64 * 100 + words, size)
}

/// Finds the normal form of the smallest program of a case, with at most so many questions to the engine. `stop` is asked before
/// each.
///
/// # Errors
/// [`EngineError`] where the engine crashed and cannot be started again.
pub(crate) fn normal_form(
    asked: &mut Questioner<'_>,
    case: &Case,
    smallest: &Smallest,
    tries: u64,
    stop: &dyn Fn() -> bool,
) -> Result<Normal, EngineError> {
    let mut search = NormalSearch {
        asked,
        case,
        left: tries,
        stop,
        normal: Normal::unasked(smallest),
    };
    if smallest.flaky.is_some() {
        return Ok(search.normal);
    }
    let structure_of = |symptom: &Symptom| ReductionMethod {
        passes: structure_passes(symptom),
        weight: structure,
        key,
    };
    let symptom = smallest.deviation.sign.symptom.clone();
    search.minimise(&structure_of(&symptom))?;
    let now = search.normal.deviation.sign.symptom.clone();
    if now == Symptom::Value && symptom != Symptom::Value {
        search.minimise(&structure_of(&now))?;
    }
    search.normal.is_operand = search.normal.program != smallest.program && !search.normal.is_unchecked();
    let plain = |passes| ReductionMethod {
        passes,
        weight: |draft: &Draft| (0, ask(&draft.text, plainness)),
        key,
    };
    match now {
        Symptom::Value | Symptom::Missing if !search.normal.is_beginning() => {
            search.other_forms()?;
            // The types and values of such an operation do not matter.
            if search.normal.way.is_none() {
                search.minimise(&plain(&[PLAINER_TYPE, PLAINER_NUMBERS]))?;
            }
        }
        Symptom::Rejected(_) => search.minimise(&plain(&[PLAINER_TYPE]))?,
        _ => {}
    }
    let mut normal = search.normal;
    normal.is_asked = search.left > 0 && !stop();
    normal.questions = tries - search.left;
    Ok(normal)
}

fn key(draft: &Draft) -> u64 {
    let mut hasher = DefaultHasher::new();
    draft.text.hash(&mut hasher);
    hasher.finish()
}

struct NormalSearch<'s, 'e> {
    asked: &'s mut Questioner<'e>,
    case: &'s Case,
    left: u64,
    stop: &'s dyn Fn() -> bool,
    normal: Normal,
}

impl NormalSearch<'_, '_> {
    /// Makes the normal form lighter while the engine fails with it in the same way.
    fn minimise(&mut self, method: &ReductionMethod<'_, Draft>) -> Result<(), EngineError> {
        let start = Draft {
            text: self.normal.program.clone(),
            dialect: self.case.dialect,
        };
        let (mut error, mut is_start) = (None, true);
        let stop = self.stop;
        let budget = ReductionBudget {
            tries: self.left + 1,
            stop,
        };
        let mut interesting = |draft: &Draft| {
            if std::mem::take(&mut is_start) {
                return Interestingness::Interesting;
            }
            match error {
                Some(_) => Interestingness::Invalid,
                None => self.judge(&draft.text).unwrap_or_else(|failed| {
                    error = Some(failed);
                    Interestingness::Invalid
                }),
            }
        };
        let found = minimise(start, method, &mut interesting, &budget);
        if found.ended == StopReason::OutOfTries {
            self.left = 0;
        }
        error.map_or(Ok(()), Err)
    }

    /// Takes a program as the normal form if the engine fails with it in the same way.
    fn judge(&mut self, text: &str) -> Result<Interestingness, EngineError> {
        let former = &self.normal;
        // Of a program that cannot be read, an operand with a literal that the program does not have says nothing: that may not be read
        // either.
        if is_unread(&former.deviation.got) && !literals(text).is_subset(&literals(&former.program)) {
            return Ok(Interestingness::Invalid);
        }
        let Some(case) = as_the_reference(self.case, text, &self.observe(text)) else {
            return Ok(Interestingness::Invalid);
        };
        // A value of another type that is right there says nothing.
        let accepts = matches!(former.deviation.sign.symptom, Symptom::NotRejected(_));
        if accepts && case.expectation.accepted != Acceptance::Rejected {
            return Ok(Interestingness::Invalid);
        }
        self.left = self.left.saturating_sub(1);
        let seen = self.asked.deviation(&case)?;
        let former = &self.normal;
        // A value that wraps is another defect than one that is within the range of its type.
        let leaves = |text: &str, seen: &Deviation| ask(text, |program| leaves_range(program, seen));
        let stays = |seen: &Deviation| leaves(&former.program, &former.deviation) || !leaves(text, seen);
        let same = seen.filter(|seen| is_same(&former.deviation, seen) && stays(seen));
        let is_same = same.is_some();
        if let Some(deviation) = same {
            self.normal.program = text.to_owned();
            self.normal.deviation = deviation;
        }
        Ok(Interestingness::from(is_same))
    }

    /// Returns the observations that show what is wrong with a program: those of the case and of an operand alone, or of all variables
    /// where these keep what they begin with.
    fn observe(&self, text: &str) -> Vec<Observation> {
        let has_values = matches!(
            self.normal.deviation.sign.symptom,
            Symptom::Value | Symptom::Missing | Symptom::Hang | Symptom::Fault(_)
        );
        if !has_values {
            return Vec::new();
        }
        let all = all_variables(self.case, text);
        let initial = ask(text, forms::only_initial_values);
        let keeps = text == BEGINNING_BLOCK || initial.iter().any(|initial| initial == text);
        let is_observed = |one: &&Observation| {
            let mut observed = self.case.observe.iter();
            one.name.eq_ignore_ascii_case("into")
                || observed.any(|known| known.name.eq_ignore_ascii_case(&one.name))
        };
        let observed: Vec<Observation> = all.iter().filter(is_observed).cloned().collect();
        if keeps || observed.is_empty() {
            all
        } else {
            observed
        }
    }

    /// Asks for other forms of the program: where one is right, it says how the engine does the operation.
    fn other_forms(&mut self) -> Result<(), EngineError> {
        let (in_two_steps, turned_round) = ask(&self.normal.program, |program| {
            (forms::in_two_steps(program), forms::turned_round(program))
        });
        let forms = [
            (in_two_steps, "operation in the type of its target"),
            (turned_round, "comparison in the type of its first operand"),
        ];
        for (form, way) in forms {
            let case = form.and_then(|form| as_the_reference(self.case, &form, &self.observe(&form)));
            if let Some(case) = case.filter(|_| self.left > 0 && !(self.stop)()) {
                self.left -= 1;
                if self.asked.deviation(&case)?.is_none() {
                    self.normal.way = Some(way);
                    break;
                }
            }
        }
        Ok(())
    }
}

/// Returns the literals of a program, as they are written.
fn literals(text: &str) -> BTreeSet<&str> {
    let literals = tokens(text).into_iter().filter(|token| token.kind.is_literal());
    literals.map(|token| token.span.text(text)).collect()
}

/// Returns whether an engine fails in the same way with another program, which may have the place or the types of another.
fn is_same(former: &Deviation, seen: &Deviation) -> bool {
    match (&former.sign.symptom, &seen.sign.symptom) {
        // Without the mistake the same is said of the same construct.
        (Symptom::OtherLine(_), Symptom::Rejected(reason)) => {
            let reported = former.got.iter().find_map(Fact::diagnostic);
            reported.is_some_and(|reported| reported.code.as_ref() == Some(reason))
        }
        (Symptom::Rejected(reason), Symptom::Rejected(other)) => {
            reason == other || !is_of_reading(reason) && !is_of_reading(other)
        }
        (Symptom::OtherCode { reported, .. } | Symptom::Surplus(reported), Symptom::Rejected(reason)) => {
            reported == reason
        }
        // The code that was expected is not missed alone.
        (Symptom::OtherCode { code, .. }, Symptom::NotRejected(same)) => code == same,
        (Symptom::NotRejected(_), Symptom::NotRejected(_))
        | (Symptom::NotImplemented(_), Symptom::NotImplemented(_))
        | (Symptom::Value | Symptom::Missing | Symptom::Hang | Symptom::Fault(_), Symptom::Value) => true,
        _ => false,
    }
}
