//! Finds the conversions, operators and calls of standard functions of a program whose results differ between two dialects: each is
//! executed alone, in both, on boundary values of the types of its operands.

mod rounding;

use super::Finding;
use super::compare::{Difference, first_difference};
use crate::case_folder::CaseFolder;
use crate::documented;
use std::cmp::Reverse;
use std::collections::{BTreeMap, HashMap};
use stickler_conversions::overview::AssertedResult;
use stickler_reference::conversion::conversion_function_name;
use stickler_reference::semantics::{TracedUse, UseKind, check_traced, is_standard_function};
use stickler_suite::{Acceptance, Case, Suite};
use stickler_syntax::Edits;
use stickler_syntax::diagnostic::quoted;
use stickler_syntax::features::{FeatureUse, feature_uses};
use stickler_syntax::source::{LineIndex, Span};
use stickler_syntax::tree::{Argument, Expression, ExpressionId, ExpressionKind, SourceUnit};
use stickler_types::{Dialect, DialectName, ElementaryType, Question, Value, WrittenValue};

/// The maximum length of an operation, in bytes. What is longer has too many operands for an example.
const MAX_LEN: usize = 400;

/// A program as the dialect from which it moves reads it.
pub(super) struct Typed<'s> {
    text: &'s str,
    dialects: [DialectName; 2],
    unit: SourceUnit<'s>,
    uses: Vec<TracedUse>,
    /// The types of values, and those in which they are used.
    types: HashMap<ExpressionId, (ElementaryType, ElementaryType)>,
    /// The folder of cases, if there is one.
    cases: Option<CaseFolder>,
    /// The features that the program uses.
    features: Vec<FeatureUse>,
    /// The cases about implicit conversions in the other dialect, once they were asked for.
    implicit: Option<Suite>,
    /// The results of conversion functions that cases assert, by the name of the function.
    asserted: HashMap<String, Vec<AssertedResult>>,
    /// The results of [`first_difference`], by the texts of both programs.
    compared: HashMap<[String; 2], Option<Option<Difference>>>,
    /// The text that is suggested in the place of an expression.
    remedies: HashMap<ExpressionId, String>,
}

/// An operator, a call of a standard function, or a value that is assigned.
struct Operation {
    id: ExpressionId,
    /// The conversion function that gives the same.
    function: String,
    /// The operands that are literals and whose type is known.
    literals: Vec<Value>,
    /// The operands that are no literals, each with its index in [`Operation::operands`].
    places: Vec<(ExpressionId, usize)>,
    /// The different ones of them, with their types.
    operands: Vec<(ExpressionId, ElementaryType)>,
}

/// Returns the conversion of a value to the type to which it is assigned.
fn assigned(id: ExpressionId, from: ElementaryType, to: ElementaryType) -> Operation {
    Operation {
        id,
        function: format!("{from}_TO_{to}"),
        literals: Vec::new(),
        places: vec![(id, 0)],
        operands: vec![(id, from)],
    }
}

impl<'s> Typed<'s> {
    /// Reads a program, whatever is wrong with it.
    pub fn new(text: &'s str, dialects: [DialectName; 2], cases: Option<CaseFolder>) -> Typed<'s> {
        let dialect = Dialect::of(dialects[0]);
        let (mut unit, _) = stickler_syntax::parse(text, dialect);
        stickler_syntax::resolve_qualifiers(&mut unit, text, dialect, |name| {
            is_standard_function(name, dialect)
        });
        let (_, _, uses) = check_traced(&unit, text, &LineIndex::new(text), dialect);
        let mut types = HashMap::new();
        for TracedUse { expression, kind, .. } in &uses {
            let met = match *kind {
                UseKind::Expected { from, to, .. } => from.map(|from| (from, to)),
                UseKind::Operand { from, to } => Some((from, to)),
                UseKind::Converted { from, .. } => Some((from, from)),
                _ => None,
            };
            if let Some(met) = met {
                types.entry(*expression).or_insert(met);
            }
        }
        Typed {
            text,
            dialects,
            unit,
            uses,
            types,
            cases,
            features: feature_uses(text, dialect),
            implicit: None,
            asserted: HashMap::new(),
            compared: HashMap::new(),
            remedies: HashMap::new(),
        }
    }

    /// Returns what means something else in the other dialect, each place once.
    pub fn findings(&mut self) -> Vec<Finding> {
        let mut found = BTreeMap::new();
        let mut uses = self.uses.clone();
        // What is written instead of an operand is part of what is written instead of its operation.
        uses.sort_by_key(|used| self.text_of(used.expression).len());
        for TracedUse { expression, kind, .. } in uses {
            let (from, to) = match kind {
                UseKind::Expected {
                    from: Some(from),
                    to,
                    fits: true,
                }
                | UseKind::Captured { from, to, fits: true } => (from, to),
                UseKind::Operand { from, .. } => (from, from),
                _ => continue,
            };
            let operation = self.operation(self.bare(expression));
            let operation = operation.filter(|operation| !self.is_rounded(operation));
            let mut finding = operation.and_then(|operation| {
                // What a conversion gives does not depend on where it goes.
                let to = if self.is_conversion(&operation) { from } else { to };
                self.finding(&operation, to)
            });
            if finding.is_none() && from != to && !self.is_literal(expression) {
                finding = self.finding(&assigned(expression, from, to), to);
            }
            if let Some(finding) = finding {
                let Span { start, end } = self.expression(self.bare(expression)).span;
                // What holds another place comes before it.
                found.entry((start, Reverse(end))).or_insert(finding);
            }
        }
        found.into_values().collect()
    }

    /// Returns the source by which the other dialect rejects a place of the program: its features, by those that the place uses, or the claim that a
    /// type does not convert to another. `None` where no source states it.
    pub fn rejected_by(&mut self, place: Span) -> Option<String> {
        let to = self.dialects[1];
        let is_here = |used: &FeatureUse| used.span.start < place.end && place.start < used.span.end;
        let mut lacked = self.features.iter().filter(|used| to.rules().lacks(&used.key));
        let words = place.text(self.text).split('_');
        let mut types = words.filter_map(ElementaryType::from_name);
        if lacked.any(is_here) || types.any(|ty| !to.rules().may_name(ty)) {
            return Some(format!("{}: features", to.base()));
        }
        let mut types = self.types.iter();
        let (_, pair) = types.find(|(id, _)| self.expression(**id).span == place)?;
        let (folder, pair) = (self.cases.as_ref()?, *pair);
        let load = || folder.load_mentioning(&["implicit("], &[to]);
        let suite = self.implicit.get_or_insert_with(load);
        let states = |case: &&Case| {
            let asks = matches!(case.question.as_deref(), Some(Question::Implicit(asked)) if *asked == pair);
            asks && case.dialect == to && case.expectation.accepted == Acceptance::Rejected
        };
        let mut bases = suite.cases.iter().filter(states).map(|case| &*case.basis);
        bases.find(|basis| !basis.starts_with("rule:")).map(str::to_owned)
    }

    /// Returns what to write at a place that the other dialect rejects so that it gives the same there: an operator that computes in as
    /// wide a type as before, or a conversion function.
    pub fn mended_at(&mut self, place: Span) -> Option<String> {
        let mut types = self.types.iter().map(|(id, pair)| (*id, *pair));
        let (id, (from, to)) = types.find(|(id, _)| self.expression(*id).span == place)?;
        let operation = self.operation(self.bare(id));
        if let Some(widened) = operation.and_then(|operation| self.widened(&operation, to)) {
            return Some(self.in_parentheses(id, widened));
        }
        let function = conversion_function_name(from, to, Dialect::of(self.dialects[1]))?;
        let assigned = assigned(id, from, to);
        match self.compare(&assigned, to, format!("{function}(operand0)"))? {
            None => Some(format!("{function}({})", self.remedied(id))),
            Some(_) => self.rounded(&assigned, to, None),
        }
    }

    /// Returns what takes the place of the inside of an expression, in parentheses where that is.
    fn in_parentheses(&self, id: ExpressionId, inside: String) -> String {
        match self.bare(id) == id {
            true => inside,
            false => format!("({inside})"),
        }
    }

    fn expression(&self, id: ExpressionId) -> &Expression<'s> {
        &self.unit.expressions[id.0 as usize]
    }

    fn text_of(&self, id: ExpressionId) -> &'s str {
        self.expression(id).span.text(self.text)
    }

    fn is_conversion(&self, Operation { function, .. }: &Operation) -> bool {
        let has = |dialect: &DialectName| !stickler_exact::signatures(function, *dialect).is_empty();
        self.dialects.iter().any(has)
    }

    /// Returns the text of an expression, or what is suggested to be written instead.
    fn remedied(&self, id: ExpressionId) -> String {
        match self.remedies.get(&self.bare(id)) {
            Some(remedy) => self.in_parentheses(id, remedy.clone()),
            None => self.text_of(id).to_owned(),
        }
    }

    fn bare(&self, id: ExpressionId) -> ExpressionId {
        match self.expression(id).kind {
            ExpressionKind::Parenthesized(inner) => self.bare(inner),
            _ => id,
        }
    }

    fn is_literal(&self, id: ExpressionId) -> bool {
        match self.expression(self.bare(id)).kind {
            ExpressionKind::Literal(_) | ExpressionKind::EnumeratedValue(_) => true,
            ExpressionKind::Unary { operand, .. } => self.is_literal(operand),
            _ => false,
        }
    }

    /// Returns the operation of an expression; `None` where it is none or very long, or the types of its operands are not known.
    fn operation(&self, id: ExpressionId) -> Option<Operation> {
        if self.text_of(id).len() > MAX_LEN {
            return None;
        }
        let (operands, function) = match &self.expression(id).kind {
            ExpressionKind::Binary { left, right, .. } => (vec![*left, *right], ""),
            ExpressionKind::Unary { operand, .. } => (vec![*operand], ""),
            ExpressionKind::Call { callee, arguments } => {
                let name = self.text_of(*callee);
                let dialect = Dialect::of(self.dialects[0]);
                let is_standard = is_standard_function(dialect.standard_name(name), dialect);
                let is_declared = self.unit.pous().any(|pou| pou.name.is(name));
                let given = arguments.iter().map(|argument| match *argument {
                    Argument::Positional(value) | Argument::Named { value, .. } => Some(value),
                    Argument::Output { .. } => None,
                });
                let given: Option<Vec<_>> = given.collect();
                (given.filter(|_| is_standard && !is_declared)?, name)
            }
            _ => return None,
        };
        let mut operation = Operation {
            id,
            function: function.to_owned(),
            literals: Vec::new(),
            places: Vec::new(),
            operands: Vec::new(),
        };
        for operand in operands {
            if self.is_literal(operand) {
                let ty = self.types.get(&operand).map(|(from, _)| *from);
                let value = ty.and_then(|ty| WrittenValue::parse(ty, self.text_of(operand)).ok());
                operation.literals.extend(value.map(|written| written.value));
                continue;
            }
            let text = self.text_of(operand);
            let is_same = |(known, _): &_| !text.contains('(') && self.text_of(*known) == text;
            let known = operation.operands.iter().position(is_same);
            operation
                .places
                .push((operand, known.unwrap_or(operation.operands.len())));
            if known.is_none() {
                operation.operands.push((operand, self.type_of(operand)?));
            }
        }
        Some(operation)
    }

    /// Returns the type of an operand: that in which it was read, or else that of the variable.
    fn type_of(&self, id: ExpressionId) -> Option<ElementaryType> {
        if let Some((from, _)) = self.types.get(&id) {
            return Some(*from);
        }
        let Span { start, .. } = self.expression(id).span;
        let pou = self
            .unit
            .pous()
            .find(|pou| pou.span.start <= start && start < pou.span.end)?;
        let mut groups = pou.blocks.iter().flat_map(|block| &block.groups);
        let group = groups.find(|group| group.names.iter().any(|name| name.is(self.text_of(id))))?;
        Dialect::of(self.dialects[0]).elementary(group.specification.span.text(self.text))
    }

    /// Returns an operation as it is written, or with variables for its operands, or with these converted to the type in which they are
    /// used; `None` where the other dialect has no such conversion, or none is needed.
    fn written(&self, operation: &Operation, variables: bool, widened: bool) -> Option<String> {
        let mut edits = Edits::new();
        let Span { start: before, .. } = self.expression(operation.id).span;
        let mut is_wider = false;
        for (operand, number) in &operation.places {
            let Span { start, end } = self.expression(*operand).span;
            let inner = self
                .operation(self.bare(*operand))
                .filter(|_| widened && !variables);
            let inner = inner.and_then(|inner| self.written(&inner, false, true));
            let mut text = match inner {
                Some(inside) => self.in_parentheses(*operand, inside),
                None if variables => format!("operand{number}"),
                None => self.remedied(*operand),
            };
            if let Some((from, to)) = self.types.get(operand).filter(|(from, to)| widened && from != to) {
                let function = conversion_function_name(*from, *to, Dialect::of(self.dialects[1]))?;
                text = format!("{function}({text})");
                is_wider = true;
            }
            edits.replace((start - before) as usize..(end - before) as usize, text);
        }
        (is_wider || !widened).then(|| edits.apply(self.text_of(operation.id)))
    }

    /// Returns an operation with its operands converted to the type in which it is computed, if it gives the same in the other dialect then.
    fn widened(&mut self, operation: &Operation, to: ElementaryType) -> Option<String> {
        let widened = self.written(operation, true, true)?;
        let is_same = matches!(self.compare(operation, to, widened), Some(None));
        self.written(operation, false, true).filter(|_| is_same)
    }

    /// Executes the assignment of an operation in the one dialect, and of the expression `other` in the other, as [`first_difference`] does.
    fn compare(
        &mut self,
        operation: &Operation,
        to: ElementaryType,
        other: String,
    ) -> Option<Option<Difference>> {
        let operands = (0..).zip(&operation.operands);
        let inputs: Vec<_> = operands
            .map(|(number, (_, ty))| (format!("operand{number}"), *ty))
            .collect();
        let variables: String = inputs
            .iter()
            .map(|(name, ty)| format!("{name} : {ty}; "))
            .collect();
        let texts = [self.written(operation, true, false)?, other].map(|expression| {
            format!("PROGRAM main VAR result : {to}; {variables}END_VAR result := {expression}; END_PROGRAM")
        });
        let programs = [(self.dialects[0], &*texts[0]), (self.dialects[1], &*texts[1])];
        let compare = || first_difference(programs, &inputs, &["result".to_owned()], 1);
        self.compared.entry(texts.clone()).or_insert_with(compare).clone()
    }

    fn finding(&mut self, operation: &Operation, to: ElementaryType) -> Option<Finding> {
        let same = self.written(operation, true, false)?;
        let Difference { inputs, results, .. } = self.compare(operation, to, same)??;
        let result = results[0].clone();
        let given = if inputs.is_empty() {
            &operation.literals
        } else {
            &inputs
        };
        let dialects = self.dialects;
        let is_conversion = self.is_conversion(operation);
        let basis = |at: usize| self.basis(&operation.function, given, results[at].as_ref()?, dialects[at]);
        let basis = is_conversion.then(|| [0, 1].map(basis));
        if basis == Some([None, None]) {
            // What no source states of either system is no difference between them.
            return None;
        }
        let what = match operation.places[..] {
            [(id, _)] if id == operation.id => format!("{} as {to}", self.text_of(id)),
            _ => self.text_of(operation.id).to_owned(),
        };
        let operands = operation
            .operands
            .iter()
            .map(|(id, _)| self.text_of(*id).to_owned());
        let example = (operands.zip(inputs).collect(), results);
        let span = self.expression(operation.id).span;
        let mut finding = Finding::differs(self.text, span, &quoted(&what), example, self.dialects, basis);
        let suggestion = self.widened(operation, to);
        let suggestion = suggestion.or_else(|| self.rounded(operation, to, result));
        match &suggestion {
            Some(suggestion) => _ = self.remedies.insert(operation.id, suggestion.clone()),
            None => finding.diagnostic.message += "; nothing is known that gives the same there",
        }
        finding.diagnostic.suggestion = suggestion;
        Some(finding)
    }

    /// Returns the source that states the result of a conversion function, if one does.
    fn basis(
        &mut self,
        function: &str,
        operands: &[Value],
        value: &Value,
        dialect: DialectName,
    ) -> Option<String> {
        let function = Dialect::of(dialect).standard_name(function).to_ascii_uppercase();
        let mut signatures = stickler_exact::signatures(&function, dialect).into_iter();
        let signature =
            signatures.find(|one| Some(one.result) == value.elementary() && one.takes(operands))?;
        let stated = stickler_exact::expected(&signature, operands, dialect);
        let mut basis = stated.basis.filter(|_| stated.value == *value).map(str::to_owned);
        if let (None, Some(folder)) = (&basis, &self.cases) {
            let load = || {
                documented::asserted_results(&folder.load_mentioning(&[&function], &self.dialects), &function)
            };
            let known = self.asserted.entry(function.clone()).or_insert_with(load);
            let is_result = |one: &&AssertedResult| {
                one.dialect == dialect && one.operands == operands && one.value == *value
            };
            basis = known.iter().find(is_result).map(|one| one.basis.to_string());
        }
        basis.filter(|basis| !basis.starts_with("rule:"))
    }
}
