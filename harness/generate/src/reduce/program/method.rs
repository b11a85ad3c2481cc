//! The order of the passes over a program, and the function that runs them.

use super::soundness::breaches;
use super::{declarations, expressions, forget, lift, promote, shapes, statements, unwrap, values, weight};
use crate::model::Program;
use stickler_reduce::{
    CandidateJudge, Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, Sites, minimise,
    minimise_in_packs,
};

const fn pass<T>(name: &'static str, edit: fn(&mut T, &mut Sites)) -> Pass<T> {
    Pass { name, edit }
}

/// The passes for programs: first those that remove many lines, last those that simplify a literal.
const METHOD: ReductionMethod<'_, Program> = ReductionMethod {
    passes: &[
        pass("drop statements of main and what they used", |program, sites| {
            declarations::with_variables(program, sites, statements::drop_of_main);
        }),
        pass("drop what is not used", declarations::drop_unused),
        pass("drop statements and what they used", |program, sites| {
            declarations::with_variables(program, sites, statements::drop_anywhere);
        }),
        pass("drop statements", statements::drop_anywhere),
        pass("replace statements by what they guard", statements::splice),
        pass("drop branches", statements::drop_branches),
        pass("replace calls of blocks by assignments", |program, sites| {
            declarations::with_variables(program, sites, statements::calls_to_assignments);
        }),
        pass("end REPEAT at once", lift::end_repeats),
        pass("put a unit in the place of main", promote::promote),
        pass("make numbers of enumerations", promote::enumerations_to_numbers),
        pass("forget functions", forget::forget_functions),
        pass("forget variables", |program, sites| {
            declarations::with_variables(program, sites, forget::forget_variables);
        }),
        pass("forget variables alone", forget::forget_variables),
        pass("drop what is not used any more", declarations::drop_unused),
        pass("hoist values out of statements", lift::hoist),
        pass("replace variables by what they are assigned", |program, sites| {
            declarations::with_variables(program, sites, lift::propagate);
        }),
        pass("replace expressions by plain literals", expressions::to_plainest),
        pass("replace expressions by their values", values::to_value),
        pass(
            "replace expressions by their first operands",
            expressions::to_first_operand,
        ),
        pass(
            "replace expressions by their second operands",
            expressions::to_second_operand,
        ),
        pass(
            "replace expressions by their third operands",
            expressions::to_third_operand,
        ),
        pass("drop initial values", shapes::drop_initials),
        pass("resolve aliases", shapes::resolve_aliases),
        pass("unwrap variables", unwrap::unwrap_variables),
        pass("drop fields", unwrap::drop_fields),
        pass("halve arrays", shapes::halve_arrays),
        pass("shorten arrays", shapes::shorten_arrays),
        pass("make variables of constants", shapes::constants_to_variables),
        pass("make literals zero", expressions::literals_to_zero),
        pass("make literals one", expressions::literals_to_one),
        pass("halve literals", expressions::halve_literals),
        pass("trim literals", expressions::trim_literals),
        pass("make literals powers of two", expressions::literals_to_powers),
        pass(
            "make literals one more than a power of two",
            expressions::literals_above_powers,
        ),
        pass("lessen literals", expressions::lessen_literals),
        pass("drop prefixes of literals", expressions::drop_prefixes),
    ],
    weight: weight::of,
    key: weight::key,
};

/// Makes a program as small as possible while it stays interesting.
///
/// `interesting` is asked about `start` first, and then about each candidate. It should answer [`Interestingness::Invalid`]
/// if the evaluator refuses the program or meets an open question, and ask an engine only about other candidates. The result
/// is the same for the same answers.
pub fn program(
    start: &Program,
    mut interesting: impl FnMut(&Program) -> Interestingness,
    budget: &ReductionBudget<'_>,
) -> Reduction<Program> {
    // If the start breaks such a rule, the breach may be the symptom.
    let most = breaches(start);
    let mut ask = |candidate: &Program| {
        if breaches(candidate) > most {
            Interestingness::Invalid
        } else {
            interesting(candidate)
        }
    };
    minimise(start.clone(), &METHOD, &mut ask, budget)
}

/// Makes a program as small as possible, like [`program`], with a judge that may be asked about several programs at a time.
pub fn program_in_packs(
    start: &Program,
    judge: &mut dyn CandidateJudge<Program>,
    budget: &ReductionBudget<'_>,
) -> Reduction<Program> {
    let mut sound = SoundCandidates {
        most: breaches(start),
        judge,
    };
    minimise_in_packs(start.clone(), &METHOD, &mut sound, budget)
}

/// A judge of candidates that break no more rules than the start: if the start breaks such a rule, the breach may be the
/// symptom.
struct SoundCandidates<'j> {
    most: usize,
    judge: &'j mut dyn CandidateJudge<Program>,
}

impl CandidateJudge<Program> for SoundCandidates<'_> {
    fn admits(&mut self, candidate: &Program) -> bool {
        breaches(candidate) <= self.most && self.judge.admits(candidate)
    }

    fn judge(&mut self, candidates: &[Program]) -> Vec<Interestingness> {
        self.judge.judge(candidates)
    }

    fn pack_size(&self) -> usize {
        self.judge.pack_size()
    }
}
