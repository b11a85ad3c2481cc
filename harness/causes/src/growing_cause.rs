//! A cause while groups of failing cases are added to it, and the joining of groups with one cause.

use crate::alone::is_loop_alone;
use crate::claim::keeps_claim;
use crate::essence::Essence;
use crate::failed::FailureGroup;
use crate::failure_sign::{Sign, has_lost_place, is_of_a_value, is_of_reading, is_unread};
use crate::forms::{PLAIN, named_types};
use crate::key::CauseKey;
use crate::line_features::{STANDARD_PARAMETER, lacked_function};
use crate::loop_limits::TO_LAST_VALUE;
use crate::normal_form::{Normal, is_whatever_comes};
use crate::program::read;
use crate::promised::{cite, page_of_code, promise, promise_of_pattern, promise_of_place};
use crate::reduction::{LONG, Smallest};
use crate::title::title;
use crate::words::{tokens, valued_types};
use crate::work::operations;
use std::cmp::Reverse;
use std::collections::{BTreeMap, BTreeSet, HashMap};
use stickler_engines::Identity;
use stickler_run::{Cause, Fact, Grade, Reduced, Reproducer, Symptom, Verdict};
use stickler_suite::{Case, Source, SourceKind, Sources, Suite, ToldSymptom};
use stickler_syntax::tree::Pou;
use stickler_types::Code;

/// A cause while groups are added to it.
pub(crate) struct GrowingCause {
    pub(crate) cause: Cause,
    pub(crate) essence: Essence,
    pub(crate) sign: Sign,
    /// The keys of the neighbours of its program with which the engine deviates in the same way.
    pub(crate) neighbours: Vec<CauseKey>,
    /// The functions of the library that the engine does not have.
    pub(crate) functions: BTreeSet<String>,
    /// The arguments that the ids of all cases have.
    shared: BTreeSet<String>,
    /// Whether the shown claim does not bind the engine.
    pub(crate) differs: bool,
    /// The rank of the shown claim.
    pub(crate) rank: u8,
    /// Whether the claim of the shown case still speaks of the shown program.
    keeps_claim: bool,
    /// The number of cases with the same essence that rest on the shown claim.
    agreeing: u64,
    /// The number of cases of the group whose program is shown.
    own: u64,
}

impl GrowingCause {
    /// Returns the cause of a group, by its smallest program. `case` is that of the program.
    pub(crate) fn new(
        group: &FailureGroup,
        (smallest, normal): (&Smallest, &Normal),
        case: Option<&Case>,
        (engine, suite): (&Identity, &Suite),
    ) -> GrowingCause {
        let sources = &suite.sources;
        let essence = Essence::of(smallest, normal);
        let types = |program: &str| valued_types(program).len();
        let is_plain = operations(&smallest.program).is_subset(&operations(&normal.program))
            && types(&smallest.program) <= types(&normal.program);
        // An operand that the engine does not take alone is shown alone, unless the program does nothing else; so is a valid program
        // that is rejected like one with a mistake.
        let hides = smallest.deviation.sign.is_rejected_otherwise() && normal.program != smallest.program;
        let is_shorter = matches!(
            normal.deviation.sign.symptom,
            Symptom::NotImplemented(_) | Symptom::Crash(_)
        ) && normal.program.len() < smallest.program.len();
        let is_other = normal.is_operand && (!is_plain || is_shorter) && !smallest.deviation.sign.accepts();
        let is_derived = hides || is_other;
        // A value of quite another type shows best that none is checked.
        let is_as_small = normal.program.len() <= smallest.program.len();
        let length = |program: &str| tokens(program).len();
        let is_unchecked = smallest.deviation.sign.accepts()
            && normal.is_unchecked()
            && normal.deviation.expected == smallest.deviation.expected
            && length(&normal.program) <= length(&smallest.program);
        // The same mistake shows best where nothing else is done.
        let is_plainer = smallest.deviation.sign.accepts()
            && (normal.deviation.sign == smallest.deviation.sign || normal.is_operand)
            && is_as_small;
        // What a variable begins with shows best where nothing copies it.
        let is_empty = |pou: &Pou<'_>| pou.body.is_empty();
        let is_initial = smallest.deviation.sign.symptom == Symptom::Value
            && read(&normal.program, |program| program.unit.pous().all(is_empty));
        // What is rejected with a plainer type too is shown with that, since the type does not matter.
        let types = named_types(&normal.program);
        let mut former = named_types(&smallest.program).into_iter();
        let is_plainer_type = smallest.deviation.sign.rejects_valid()
            && normal.deviation.sign.symptom == smallest.deviation.sign.symptom
            && length(&normal.program) <= length(&smallest.program)
            && former.any(|ty| !PLAIN.contains(&ty) && !types.contains(ty));
        // A loop, and mistakes beside others, show best in a program with nothing else.
        let is_incomplete = matches!(smallest.deviation.sign.symptom, Symptom::Incomplete(_));
        let is_loop =
            is_as_small && essence.pattern == Some(TO_LAST_VALUE) || is_loop_alone(&smallest.program);
        let tells_others = is_incomplete && normal.way.is_some();
        let has_other_operands = is_plainer_type || normal.has_variables;
        let is_other_form = is_plainer || is_initial || has_other_operands || is_loop || tells_others;
        let mut shown = match is_derived || is_unchecked || is_other_form {
            true => normal.as_smallest(smallest),
            false => smallest.clone(),
        };
        // Of a construct that is not implemented the claim may speak in the plainer program too.
        let is_missing_alone = is_other && matches!(shown.deviation.sign.symptom, Symptom::NotImplemented(_));
        let is_derived = match is_missing_alone {
            true => !keeps_claim(&group.shown, &shown),
            false => {
                let claimed = if is_other_form { &shown } else { smallest };
                is_derived || is_loop_alone(&shown.program) || !keeps_claim(&group.shown, claimed)
            }
        };
        // That each mistake is told is said of every program.
        let is_derived = is_derived && !is_incomplete;
        // No page of a code says how often it is told.
        let is_derived = is_derived || shown.deviation.is_told_twice();
        if is_derived {
            // Where no claim speaks of the program, its plainest form says most.
            if shown.deviation.sign.symptom == Symptom::Value {
                shown = normal.as_smallest(smallest);
            }
            shown.deviation.forget_promise();
        }
        let keeps_claim = !is_derived;
        // What the claim of the case does not speak of, another one may promise; no claim but that of the construct speaks of what
        // cannot be read.
        let promised = case
            .filter(|_| {
                let is_refused = essence.constructs.contains(STANDARD_PARAMETER);
                is_derived || is_refused || is_missing(&shown, &essence) || is_unread(&shown.deviation.got)
            })
            .filter(|_| group.shown.verdict != Verdict::Differs)
            .and_then(|case| promise(&shown, case, (engine, suite)));
        let of_pattern = case
            .filter(|_| group.shown.verdict != Verdict::Differs)
            .and_then(|case| {
                promise_of_pattern(&essence.constructs, (&shown.program, case), (engine, suite))
            });
        // What the makers say of the whole claim is nearer than what they say of its construct.
        let is_told = keeps_claim && rank(&group.shown.basis, &engine.name, sources) == 0;
        let promised = of_pattern.filter(|_| !is_told).or(promised);
        if let Some(basis) = promised.as_deref() {
            cite(&mut shown.deviation.got, basis, sources);
        }
        // What no program may show is told by who says so, and for what a mistake must be rejected by the page about that.
        let told =
            told_symptom(&shown, &engine.name, sources).filter(|_| group.shown.verdict != Verdict::Differs);
        let basis = told.as_deref().or(promised.as_deref());
        let basis = basis.unwrap_or(&group.shown.basis);
        let is_derived = is_derived && promised.is_none() && told.is_none();
        // What is accepted is forbidden by the page about its code, where the makers say no more of it.
        let of_code = page_of_code(&shown, &essence, (engine, sources))
            .filter(|_| group.shown.verdict != Verdict::Differs);
        let basis = match rank(basis, &group.shown.engine, sources) {
            0 => basis,
            _ => of_code.as_deref().unwrap_or(basis),
        };
        // A code is owed to the page that is about it.
        let is_of_page = match &shown.deviation.sign.symptom {
            Symptom::NotRejected(code) => basis.ends_with(code.as_str()),
            _ => true,
        };
        let lacks = if is_of_page { &engine.lacks } else { Code::ALL };
        shown.deviation.forget_codes(lacks);
        let shown = &shown;
        let functions = read(&shown.program, |program| {
            let lacked = lacked_function(program, &shown.deviation.got);
            lacked.map(str::to_ascii_uppercase).into_iter().collect()
        });
        let cause = Cause {
            engine: group.shown.engine.clone(),
            symptom: essence.symptom.clone(),
            construct: essence.construct(),
            title: {
                let by_chance = smallest.flaky.as_ref().map(|_| "in some runs");
                let unchecked = essence
                    .is_unchecked()
                    .then_some("types are not checked in this place");
                let words = [by_chance, essence.pattern.or(unchecked)];
                let words = words.into_iter().flatten().map(str::to_owned);
                let said = title(shown, engine.grade == Grade::Code);
                words.chain([said]).collect::<Vec<_>>().join(": ")
            },
            shown: Reproducer {
                case: group.shown.id.clone(),
                dialect: group.shown.dialect.clone(),
                basis: basis.to_owned(),
                about: group.shown.title.clone(),
                file: group.shown.file.clone(),
                line: group.shown.line,
                program: shown.program.clone(),
                expected: shown.deviation.expected.clone(),
                got: shown.deviation.got.clone(),
                is_derived,
                neighbours: Vec::new(),
                reproduction: None,
                printed: String::new(),
            },
            lacked_in: BTreeMap::new(),
            // No page has room for a long program.
            reduction: match smallest.reduction {
                Reduced::Not if shown.program.len() > LONG => Reduced::Partly,
                reduction => reduction,
            },
            flaky: smallest.flaky.clone(),
            cases: group.cases.clone(),
        };
        GrowingCause {
            differs: group.shown.verdict == Verdict::Differs,
            rank: rank(basis, &group.shown.engine, sources),
            cause,
            essence,
            sign: shown.deviation.sign.clone(),
            neighbours: Vec::new(),
            functions,
            shared: group.shared.clone(),
            keeps_claim,
            agreeing: 0,
            own: group.number(),
        }
    }

    /// Cites who promises the place that all cases have in common, where a valid program is not taken and no claim says why it must be: none
    /// speaks of it, or several do, each of what goes to that place.
    pub(crate) fn cite_place(&mut self, case: &Case, (engine, suite): (&Identity, &Suite)) {
        self.cite_only_claim(engine, suite);
        let basis = &self.cause.shown.basis;
        let has_others = self.cause.cases.iter().any(|some| some.basis != *basis);
        let shown = &mut self.cause.shown;
        if !(shown.is_derived || has_others) || self.differs || !self.sign.rejects_valid() {
            return;
        }
        if let Some(basis) = promise_of_place(&self.shared, (&shown.program, case), (engine, suite)) {
            cite(&mut shown.got, basis, &suite.sources);
            shown.is_derived = false;
            self.rest_on(basis, engine, suite);
        }
    }

    /// Cites the one claim of all cases, where another one was cited because of the program alone.
    fn cite_only_claim(&mut self, engine: &Identity, suite: &Suite) {
        let cases = &self.cause.cases;
        let [first, rest @ ..] = &cases[..] else { return };
        let is_one = rest.iter().all(|some| some.basis == first.basis);
        // What is accepted is told by its code, and what no program may show by who says so.
        let is_of_claim = self.sign.rejects_valid() || self.sign.symptom == Symptom::Value;
        let is_rule = |(source, _): (&Source, &str)| source.kind == SourceKind::Rule;
        let is_binding =
            first.verdict != Verdict::Differs && !suite.sources.of(&first.basis).is_some_and(is_rule);
        if self.keeps_claim
            && is_one
            && is_binding
            && is_of_claim
            && self.essence.pattern.is_none()
            && !self.differs
        {
            let basis = first.basis.clone();
            self.rest_on(&basis, engine, suite);
        }
    }

    fn rest_on(&mut self, basis: &str, engine: &Identity, suite: &Suite) {
        basis.clone_into(&mut self.cause.shown.basis);
        self.rank = rank(basis, &engine.name, &suite.sources);
    }

    /// Returns the order of members with one essence, of which the first is shown: those whose claim binds the engine, then programs
    /// of which the claim of their case still speaks, then claims by their rank, then what does least, then claims by the number of cases that
    /// rest on them, then what more cases
    /// show, by powers of two, then the smaller program.
    pub(crate) fn preference(&self) -> impl Ord + '_ {
        let program = &self.cause.shown.program;
        // A bit is a part of a variable, and so it is of what is done with one.
        let weight = |operation: &String| if operation == "bit access" { 2 } else { 1 };
        (
            self.differs,
            match self.cause.reduction {
                Reduced::Smallest => 0,
                Reduced::Partly => 1,
                Reduced::Not => 2,
            },
            // A wrong value says more than what else comes of the same.
            self.essence.pattern.is_some_and(is_whatever_comes) && self.sign.symptom != Symptom::Value,
            // Behind what cannot be read, many a compiler tells nothing.
            matches!(&self.sign.symptom, Symptom::Incomplete(code) if is_of_reading(code)),
            // A mistake that a compiler finds alone shows best that another one hides it: most find values of a wrong type.
            matches!(&self.sign.symptom, Symptom::Incomplete(code) if !is_of_a_value(code)),
            self.cause.shown.is_derived,
            self.rank,
            operations(program).iter().map(weight).sum::<usize>(),
            Reverse(self.agreeing),
            Reverse(self.own.max(1).ilog2()),
            program.len(),
            program,
        )
    }
}

/// Merges the members of one cause: those with the same essence, and those that contain what another needs.
pub(crate) fn merged(mut members: Vec<GrowingCause>) -> Vec<GrowingCause> {
    // What needs least comes first, since it can only be contained in what comes later; what may be hidden comes last.
    members.sort_by_key(|member| {
        let Essence {
            constructs,
            labels,
            hidden,
            ..
        } = &member.essence;
        (
            hidden.is_some(),
            constructs.len(),
            labels.len(),
            Reverse(member.cause.number()),
        )
    });
    let claim = |member: &GrowingCause| {
        let Essence { symptom, .. } = &member.essence;
        (
            symptom.clone(),
            member.essence.construct(),
            member.cause.shown.basis.clone(),
        )
    };
    let mut agreeing: HashMap<_, u64> = HashMap::new();
    for member in &members {
        *agreeing.entry(claim(member)).or_default() += member.cause.number();
    }
    for member in &mut members {
        member.agreeing = agreeing[&claim(member)];
    }
    let mut causes: Vec<GrowingCause> = Vec::new();
    for member in members {
        let explaining = causes
            .iter_mut()
            .filter(|cause| cause.essence.explains(&member.essence));
        let Some(cause) = explaining.max_by_key(|cause| cause.essence.constructs.len()) else {
            causes.push(member);
            continue;
        };
        let mut member = member;
        cause.shared.retain(|argument| member.shared.contains(argument));
        member.shared.clone_from(&cause.shared);
        cause.functions.append(&mut member.functions);
        member.functions.clone_from(&cause.functions);
        let is_same = cause.essence == member.essence;
        // What contradicts a source that binds the engine is shown by such a source, and a program that is not taken by one of which a
        // claim still speaks.
        let is_claimed = cause.sign.rejects_valid()
            && cause.cause.shown.is_derived
            && !member.cause.shown.is_derived
            && member.cause.reduction == Reduced::Smallest;
        if is_same && member.preference() < cause.preference()
            || is_claimed && member.differs <= cause.differs
            || cause.differs && !member.differs
        {
            std::mem::swap(cause, &mut member);
            std::mem::swap(&mut cause.essence, &mut member.essence);
        }
        cause.cause.explain(member.cause);
    }
    causes
}

/// Merges causes of which a neighbour of one shows the other, where no value is wrong, which may be so for several reasons.
pub(crate) fn merged_with_neighbours(causes: Vec<GrowingCause>) -> Vec<GrowingCause> {
    let mut found: Vec<GrowingCause> = Vec::new();
    for mut member in causes {
        let shows = |one: &GrowingCause, other: &GrowingCause| {
            let Essence {
                symptom, constructs, ..
            } = &other.essence;
            let mut keys = one.neighbours.iter();
            one.essence.pattern == other.essence.pattern
                && keys.any(|key| key.symptom == *symptom && key.constructs == *constructs)
        };
        let same = found
            .iter_mut()
            .find(|one| shows(one, &member) || shows(&member, one));
        match same {
            Some(one) => {
                if member.preference() < one.preference() {
                    std::mem::swap(one, &mut member);
                }
                one.cause.explain(member.cause);
            }
            None => found.push(member),
        }
    }
    found
}

/// Returns whether a construct itself is not implemented, whatever the claim of the case is about.
fn is_missing(shown: &Smallest, essence: &Essence) -> bool {
    matches!(shown.deviation.sign.symptom, Symptom::NotImplemented(_))
        && !essence.constructs.contains("bit access")
}

/// Returns the basis on which an engine must not show the symptom of a program, whatever the program does.
fn told_symptom(shown: &Smallest, engine: &str, sources: &Sources) -> Option<String> {
    let symptom = match shown.deviation.sign.symptom {
        Symptom::Crash(_) => ToldSymptom::Crash,
        Symptom::NoPlace(_) => ToldSymptom::NoPlace,
        Symptom::FaultLine(_) => ToldSymptom::FaultLine,
        // What is told twice has a place each time.
        Symptom::Surplus(_) if shown.deviation.is_told_twice() && has_lost_place(&shown.deviation.got) => {
            ToldSymptom::NoPlace
        }
        Symptom::OtherCode { ref code, .. } => return sources.of_code(code, engine),
        _ => return None,
    };
    sources.telling(symptom, engine, &Fact::text(&shown.deviation.got))
}

/// Returns the rank of a claim among those that a cause contradicts: what the makers of the engine say themselves comes first,
/// then the standard.
fn rank(basis: &str, engine: &str, sources: &Sources) -> u8 {
    match sources.of(basis) {
        Some((source, _)) if source.engines.iter().any(|own| own == engine) => 0,
        Some((source, _)) if source.kind == SourceKind::Standard => 1,
        _ => 2,
    }
}
