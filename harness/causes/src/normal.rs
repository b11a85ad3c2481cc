//! The normal form of a small program: the plainest program with which the engine still fails in the same way.
//!
//! Two programs with one normal form show one defect, whatever tables and types they come from. A normal form is found by asking
//! the engine: for an operand alone, for plainer literals, for other types. Only the reference says what must happen with it, so
//! it decides which cases belong together, and what the title names, and no case is failed by it.

use crate::features::is_unread;
use crate::numbers::leaves_range;
use crate::operands::{Alone, alone, only_initial_values, with_fitting_operands};
use crate::question::{Deviation, Questioner, all_variables, as_the_reference, known};
use crate::reduction::Smallest;
use crate::sign::{is_of_a_value, is_of_reading};
use crate::statements::{in_two_steps, turned_round, with_one_statement, with_whole_outputs};
use crate::tokens::{ProgramTokenKind, tokens};
use crate::twins::{
    plainer_literals, plainer_types, value_features, with_first_parts, with_other_operand, with_same_types,
};
use std::collections::BTreeSet;
use stickler_engines::EngineError;
use stickler_run::{Fact, Symptom};
use stickler_suite::{Acceptance, Case};
use stickler_types::Observation;

/// The way of an engine that does an operation in the type of its target, and not in that of its operands.
const OF_TARGET: &str = "operation in the type of its target";
/// The way of an engine that compares in the type of the first operand, and not in one that has the values of both.
const OF_FIRST_OPERAND: &str = "comparison in the type of its first operand";

/// The plainest program with a variable of a function block that begins with a value.
const BEGINNING_BLOCK: &str = "FUNCTION_BLOCK BLOCK\nVAR\n    data : INT := 1;\nEND_VAR\n    data := data;\nEND_FUNCTION_BLOCK\n\n\
    PROGRAM main\nVAR\n    instance : BLOCK;\nEND_VAR\n    instance();\nEND_PROGRAM\n";

/// The normal form of a small program.
#[derive(Clone, PartialEq, Debug)]
pub(crate) struct Normal {
    pub(crate) program: String,
    pub(crate) deviation: Deviation,
    /// Whether the program is an operand of the small one alone.
    pub(crate) is_operand: bool,
    /// Whether quite another type is accepted in the place of the mistake.
    pub(crate) is_unchecked: bool,
    /// Whether variables of function blocks do not begin with their values, so that what the small program does with them does not
    /// matter.
    pub(crate) is_beginning: bool,
    /// The way in which the engine does an operation, where another form of the program shows it.
    pub(crate) way: Option<&'static str>,
    /// The properties of values and types without which the engine does not fail.
    pub(crate) labels: BTreeSet<String>,
    /// The literals of the small program with which the engine does not fail alone.
    pub(crate) innocent: Vec<String>,
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
            is_unchecked: false,
            is_beginning: false,
            way: None,
            labels: BTreeSet::new(),
            innocent: Vec::new(),
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
        observe: known(case, &smallest.program),
        left: tries,
        stop,
        normal: Normal::unasked(smallest),
    };
    let symptom = smallest.deviation.sign.symptom.clone();
    if smallest.flaky.is_some() {
        return Ok(search.normal);
    }
    match symptom {
        // A loop may have no end, and a division stop, because a variable does not begin with its value.
        Symptom::Value | Symptom::Missing | Symptom::Hang | Symptom::Fault(_) => {
            search.initial_values()?;
            search.value()?;
        }
        Symptom::NotRejected(code) => {
            search.operands()?;
            if is_of_a_value(&code) {
                search.unchecked()?;
            }
        }
        Symptom::Rejected(_) => {
            search.operands()?;
            search.plain_types()?;
        }
        Symptom::NotImplemented(_) => search.statements()?,
        Symptom::OtherCode { .. } | Symptom::Surplus(_) | Symptom::OtherLine(_) => {
            search.first_parts()?;
            search.operands()?;
            search.valid_twin()?;
        }
        _ => {}
    }
    let mut normal = search.normal;
    normal.questions = tries - search.left;
    Ok(normal)
}

struct NormalSearch<'s, 'e> {
    asked: &'s mut Questioner<'e>,
    case: &'s Case,
    observe: Vec<Observation>,
    left: u64,
    stop: &'s dyn Fn() -> bool,
    normal: Normal,
}

impl NormalSearch<'_, '_> {
    /// Takes a program as the normal form if the engine fails with it in the same way, and returns whether it does.
    fn takes(&mut self, program: &str, observe: &[Observation]) -> Result<bool, EngineError> {
        let found = self.fails(program, observe)?;
        // A value that wraps is another defect than one that is within the range of its type.
        let stays = |seen: &Deviation| {
            leaves_range(&self.normal.program, &self.normal.deviation) || !leaves_range(program, seen)
        };
        let same = found.filter(|seen| is_same(&self.normal.deviation, seen) && stays(seen));
        let is_taken = same.is_some();
        if let Some(deviation) = same {
            self.normal.program = program.to_owned();
            self.normal.deviation = deviation;
            self.observe = observe.to_vec();
        }
        Ok(is_taken)
    }

    /// Returns how the engine fails with a program; `None` where it does not, or where no question is left.
    fn fails(&mut self, program: &str, observe: &[Observation]) -> Result<Option<Deviation>, EngineError> {
        if self.left == 0 || (self.stop)() {
            return Ok(None);
        }
        let Some(asked) = as_the_reference(self.case, program, observe) else {
            return Ok(None);
        };
        self.left -= 1;
        self.asked.deviation(&asked)
    }

    /// Asks for each operand alone, and takes the first with which the engine fails. Of a program that it cannot read, an operand with a
    /// literal that the program does not have says nothing: it may not read that either.
    fn operands(&mut self) -> Result<(), EngineError> {
        let whole = self.normal.program.clone();
        let own = is_unread(&self.normal.deviation.got).then(|| literals(&whole));
        for Alone {
            program, ty, literal, ..
        } in alone(&whole)
        {
            if own.as_ref().is_some_and(|own| !literals(&program).is_subset(own)) {
                continue;
            }
            let before = self.left;
            if self.takes(&program, &[Observation::last("into", ty.name())])? {
                self.normal.is_operand = true;
                self.normal.innocent.clear();
                return Ok(());
            }
            self.normal
                .innocent
                .extend(literal.filter(|_| self.left < before));
        }
        Ok(())
    }

    /// Asks for the program without its statements.
    fn initial_values(&mut self) -> Result<(), EngineError> {
        let Some(program) = only_initial_values(&self.normal.program) else {
            return Ok(());
        };
        let observe = all_variables(self.case, &program);
        let is_taken = self.takes(&program, &observe)?;
        self.normal.is_operand |= is_taken;
        if is_taken && self.is_within_a_block() {
            let observe = all_variables(self.case, BEGINNING_BLOCK);
            self.normal.is_beginning = self.takes(BEGINNING_BLOCK, &observe)?;
        }
        Ok(())
    }

    /// Returns whether the first variable with a wrong value is one of a function block.
    fn is_within_a_block(&self) -> bool {
        let Deviation { expected, got, .. } = &self.normal.deviation;
        let differs = |fact: &&Fact| !got.contains(fact);
        let wrong = expected.iter().find(differs);
        wrong.is_some_and(|wrong| matches!(wrong, Fact::Value { name, .. } if name.contains('.')))
            && self.normal.program.contains("FUNCTION_BLOCK")
    }

    /// Asks for programs of which one body is a single statement that does nothing but name a variable.
    fn statements(&mut self) -> Result<(), EngineError> {
        for program in with_one_statement(&self.normal.program) {
            if self.takes(&program, &[])? {
                self.normal.is_operand = true;
                break;
            }
        }
        // The bit that takes an output may not be what is missing.
        if let Some(program) = with_whole_outputs(&self.normal.program) {
            self.normal.is_operand |= self.takes(&program, &[])?;
        }
        Ok(())
    }

    /// Asks for the first parts of the variables of which other parts are accessed.
    fn first_parts(&mut self) -> Result<(), EngineError> {
        if let Some(program) = with_first_parts(&self.normal.program) {
            self.takes(&program, &[])?;
        }
        Ok(())
    }

    /// Finds what is needed of the operands, types and literals of a program that computes a wrong value.
    fn value(&mut self) -> Result<(), EngineError> {
        let has_value = matches!(
            self.normal.deviation.sign.symptom,
            Symptom::Value | Symptom::Missing
        );
        if self.normal.is_beginning || !has_value {
            return Ok(());
        }
        self.plain_literals()?;
        self.operands()?;
        self.other_forms()?;
        // The types and values of such an operation do not matter.
        if self.normal.way.is_some() {
            return Ok(());
        }
        self.plain_types()?;
        self.plain_literals()?;
        let labels = value_features(&self.normal.program);
        self.normal.labels.extend(labels);
        Ok(())
    }

    /// Asks for other forms of the program: where one is right, it says how the engine does the operation.
    fn other_forms(&mut self) -> Result<(), EngineError> {
        let forms = [
            (in_two_steps(&self.normal.program), OF_TARGET),
            (turned_round(&self.normal.program), OF_FIRST_OPERAND),
        ];
        for (program, way) in forms {
            let Some(program) = program else { continue };
            let (before, observe) = (self.left, self.observe.clone());
            let seen = self.fails(&program, &observe)?;
            if seen.is_none() && self.left < before {
                self.normal.way = Some(way);
                break;
            }
        }
        Ok(())
    }

    /// Takes away the sign, the fraction and the size of numbers that the defect does not need.
    fn plain_literals(&mut self) -> Result<(), EngineError> {
        for place in 0..tokens(&self.normal.program).len() {
            let observe = self.observe.clone();
            for program in plainer_literals(&self.normal.program, place) {
                if self.takes(&program, &observe)? {
                    break;
                }
            }
        }
        Ok(())
    }

    /// Replaces types by those that come first among their neighbours, until none can be replaced.
    fn plain_types(&mut self) -> Result<(), EngineError> {
        let mut asked = BTreeSet::new();
        loop {
            let before = self.normal.program.clone();
            for twin in plainer_types(&before) {
                let observe: Vec<Observation> = self
                    .observe
                    .iter()
                    .map(|one| Observation {
                        type_name: twin.changed(&one.type_name).into(),
                        ..one.clone()
                    })
                    .collect();
                // A twin of the program before another type was replaced.
                let program = twin.of(&self.normal.program);
                if program != self.normal.program && asked.insert(program.clone()) {
                    self.takes(&program, &observe)?;
                }
            }
            if self.normal.program == before {
                return Ok(());
            }
        }
    }

    /// Asks whether the place of a mistake is checked at all: whether a value of quite another type is accepted there too. That
    /// program is the normal form then, since it does not matter where the value comes from.
    fn unchecked(&mut self) -> Result<(), EngineError> {
        let line = self
            .normal
            .deviation
            .expected
            .iter()
            .find_map(|fact| fact.diagnostic()?.line);
        for program in with_other_operand(&self.normal.program, line) {
            let must = as_the_reference(self.case, &program, &[]);
            if must.is_some_and(|must| must.expectation.accepted == Acceptance::Rejected) {
                self.normal.is_unchecked = self.takes(&program, &[])?;
                return Ok(());
            }
        }
        Ok(())
    }

    /// Asks for the program with equal types in place of different ones: where that is valid and rejected for the same reason,
    /// the mistake is not what the engine complains of.
    fn valid_twin(&mut self) -> Result<(), EngineError> {
        let twins = with_fitting_operands(&self.normal.program).into_iter();
        for program in twins.chain(with_same_types(&self.normal.program)) {
            if self.takes(&program, &[])? {
                return Ok(());
            }
        }
        Ok(())
    }
}

/// Returns the literals of a program, as they are written.
fn literals(program: &str) -> BTreeSet<&str> {
    use ProgramTokenKind::{Number, Text, Typed};
    let literals = tokens(program).into_iter();
    let literals = literals.filter(|token| matches!(token.kind, Number | Text | Typed));
    literals.map(|token| token.text).collect()
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
