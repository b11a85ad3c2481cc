//! Gathers what cases state about conversions, and numbers the questions.

use super::curve::Curve;
use super::{Accepted, CaseStatement, FunctionStatements, Statements};
use crate::overview::inputs;
use crate::overview::recorded::{QuestionNumber, RecordedColumn};
use crate::overview::results::ExpectedResult;
use crate::recording::Recording;
use indexmap::{IndexMap, IndexSet};
use std::collections::HashMap;
use std::sync::Arc;
use stickler_exact::{Signature, signature_of};
use stickler_types::{ConversionCall, DialectName, ElementaryType, MatrixWord, Question, Value, WordTable};

/// Gathers statements.
#[derive(Default)]
pub struct StatementsBuilder {
    dialects: Vec<DialectName>,
    words: WordTable,
    pairs: AcceptedTable,
    parts: AcceptedTable,
    functions: Vec<StatedFunction>,
    function_numbers: HashMap<(String, Vec<String>, ElementaryType), Option<usize>>,
    call_cases: Vec<(Arc<str>, usize, usize)>,
}

/// A function with the types of one of its signatures, and its calls.
pub struct StatedFunction {
    /// The function and its types.
    pub signature: Signature,
    /// The indices of the dialects that have the function with these types, among those of the table.
    pub dialects: Vec<usize>,
    /// The operands of each call, boundary values first.
    pub calls: Vec<Vec<Value>>,
    /// The number of boundary values among them.
    pub boundaries: usize,
    call_numbers: HashMap<String, usize>,
    /// The results that cases assert, and their bases, by the number of the call and the index of the dialect.
    asserted: HashMap<(usize, usize), (Value, Arc<str>)>,
}

/// Statements about pairs of words, and the cases that ask about them.
#[derive(Default)]
struct AcceptedTable {
    all: IndexMap<(u32, u32), Accepted>,
    cases: Vec<(Arc<str>, usize)>,
}

impl AcceptedTable {
    fn add(
        &mut self,
        (from, to): (u32, u32),
        statement: &CaseStatement<'_>,
        dialects: &[DialectName],
        basis: u32,
    ) {
        let Some(dialect) = dialects.iter().position(|dialect| *dialect == statement.dialect) else {
            return;
        };
        let entry = self.all.entry((from, to));
        let number = entry.index();
        let accepted = entry.or_insert_with(|| {
            let stated = vec![None; dialects.len()];
            Accepted { from, to, stated }
        });
        accepted.stated[dialect].get_or_insert((statement.word, basis));
        self.cases.push((Arc::clone(statement.case), number));
    }
}

impl StatementsBuilder {
    /// Begins a table whose columns are these dialects.
    pub fn new(dialects: Vec<DialectName>) -> StatementsBuilder {
        StatementsBuilder {
            dialects,
            ..StatementsBuilder::default()
        }
    }

    /// Adds the answer that a case expects to a question; and with the first call of a function the boundary values of its types.
    pub fn add(&mut self, question: &Question, statement: &CaseStatement<'_>) {
        let (table, from, to) = match question {
            Question::Implicit((from, to)) => (&mut self.pairs, from, to.name()),
            Question::Part(ty, part) => (&mut self.parts, ty, part.as_str()),
            Question::Comparison(_) => return,
            Question::Call(call) => return self.add_call(call, statement),
        };
        let pair = (self.words.number(from.name()), self.words.number(to));
        let basis = self.words.number(statement.basis);
        table.add(pair, statement, &self.dialects, basis);
    }

    /// Adds every conversion function of the dialects with its boundary values, also where no case calls it.
    pub fn add_all_functions(&mut self) {
        for dialect in self.dialects.clone() {
            let functions = stickler_exact::functions(dialect).into_iter();
            for signature in functions.flat_map(|function| stickler_exact::signatures(&function, dialect)) {
                if let Some(operands) = inputs::boundaries(&signature).into_iter().next() {
                    self.function_number(&ConversionCall {
                        function: signature.function,
                        operands,
                        result: signature.result,
                    });
                }
            }
        }
    }

    /// Returns the number of the function of a call, which is added where it is new; `None` where no dialect has it.
    fn function_number(&mut self, call: &ConversionCall) -> Option<usize> {
        let operands = call.operands.iter().map(|operand| operand.type_name().to_owned());
        let key = (call.function.clone(), operands.collect(), call.result);
        if let Some(number) = self.function_numbers.get(&key) {
            return *number;
        }
        let function = StatedFunction::find(call, &self.dialects);
        let number = function.is_some().then_some(self.functions.len());
        self.functions.extend(function);
        self.function_numbers.insert(key, number);
        number
    }

    fn add_call(&mut self, call: &ConversionCall, statement: &CaseStatement<'_>) {
        let number = self.function_number(call);
        if let Some(number) = number {
            let function = &mut self.functions[number];
            let call = function.call(call.operands.clone());
            let dialect = self
                .dialects
                .iter()
                .position(|dialect| *dialect == statement.dialect);
            if let (Some(dialect), Some(result)) = (dialect, statement.result) {
                let stated = (result.clone(), Arc::clone(statement.basis));
                function.asserted.entry((call, dialect)).or_insert(stated);
            }
            self.call_cases.push((Arc::clone(statement.case), number, call));
        }
    }

    /// Returns the dialects that are the columns of the table.
    pub fn dialects(&self) -> &[DialectName] {
        &self.dialects
    }

    /// Returns the functions, each with its calls.
    pub fn functions(&self) -> &[StatedFunction] {
        &self.functions
    }

    /// Returns what documents state of pairs of types and parts of types: the question, the dialect, the word and its basis.
    pub fn accepted(&self) -> impl Iterator<Item = (Question, DialectName, MatrixWord, &str)> {
        let word = |number: u32| self.words.word(number);
        let ty = move |number| ElementaryType::from_name(word(number));
        let pairs = self.pairs.all.values();
        let pairs = pairs.filter_map(move |of| Some((Question::Implicit((ty(of.from)?, ty(of.to)?)), of)));
        let parts = self.parts.all.values();
        let parts =
            parts.filter_map(move |of| Some((Question::Part(ty(of.from)?, word(of.to).to_owned()), of)));
        pairs.chain(parts).flat_map(move |(question, asked)| {
            let stated = asked.stated.iter().zip(&self.dialects);
            stated.filter_map(move |(stated, dialect)| {
                let (answer, basis) = (*stated)?;
                Some((question.clone(), *dialect, answer, word(basis)))
            })
        })
    }

    /// Returns whether no case has asked a question yet.
    pub fn is_empty(&self) -> bool {
        self.pairs.all.is_empty() && self.parts.all.is_empty() && self.functions.is_empty()
    }

    /// Returns the table, with what documents state of each call, and what the recorded compilers answer.
    pub fn finish(mut self, recordings: &[Recording]) -> Statements {
        let mut recorded = RecordedColumn::all(recordings, &self.dialects);
        let mut all = Statements {
            dialects: self.dialects.iter().map(|dialect| dialect.as_str()).collect(),
            titles: self
                .dialects
                .iter()
                .map(|dialect| &dialect.rules().title[..])
                .collect(),
            pairs: self.pairs.all.into_values().collect(),
            parts: self.parts.all.into_values().collect(),
            ..Statements::default()
        };
        let number = |index: usize| QuestionNumber::try_from(index).unwrap_or(QuestionNumber::MAX);
        let first_part = all.pairs.len();
        let first_call = first_part + all.parts.len();
        let word = |number: u32| self.words.word(number);
        let ty = |number: u32| ElementaryType::from_name(word(number));
        for (question, asked) in all.pairs.iter().chain(&all.parts).enumerate() {
            for column in &mut recorded {
                let stated = asked.stated[column.dialect].map(|(word, _)| word);
                column.add(number(question), stated, |recording, dialect| {
                    let from = ty(asked.from)?;
                    match question < first_part {
                        true => recording.implicit(dialect, (from, ty(asked.to)?)),
                        false => recording.part(dialect, from, word(asked.to)),
                    }
                });
            }
        }
        let mut first_calls = Vec::with_capacity(self.functions.len());
        let mut known_bases = IndexSet::new();
        for function in &self.functions {
            let first = all.calls.operands.len();
            first_calls.push(first);
            // By the dialects of the function, the results of its calls, of which each takes exact arithmetic.
            let expected: Vec<Vec<ExpectedResult>> = function
                .dialects
                .iter()
                .map(|index| function.expected(*index, self.dialects[*index]))
                .collect();
            for column in &mut recorded {
                let mut of_dialects = function.dialects.iter().zip(&expected);
                if let Some((_, expected)) = of_dialects.find(|(index, _)| **index == column.dialect) {
                    let first = number(first_call + first);
                    column.add_calls(first, &function.signature, &function.calls, expected);
                }
            }
            let signature = &function.signature;
            let types = signature.operands.iter().map(|ty| self.words.number(ty.name()));
            let operands = types.collect();
            let dialects: Vec<_> = function
                .dialects
                .iter()
                .map(|index| self.dialects[*index])
                .collect();
            all.functions.push(FunctionStatements {
                name: self.words.number(&signature.function),
                operands,
                result: self.words.number(signature.result.name()),
                dialects: function.dialects.clone(),
                calls: function.calls.len(),
                boundaries: function.boundaries,
                curve: Curve::of(signature, &dialects, &mut self.words),
            });
            for (number, call) in function.calls.iter().enumerate() {
                let texts = call.iter().map(|value| self.words.number(&value.to_string()));
                all.calls.operands.push(texts.collect());
                let expected = expected.iter().map(|of_dialect| &of_dialect[number]);
                let (bases, values) = stated(expected.clone(), &mut self.words);
                for (dialect, expected) in function.dialects.iter().zip(expected) {
                    if let Some(other) = &expected.otherwise {
                        let value = self.words.number(&other.value.to_string());
                        let basis = self.words.number(&other.basis);
                        all.disputed.push((first + number, *dialect, value, basis));
                    }
                }
                all.calls.bases.push(known_bases.insert_full(bases).0);
                all.calls.values.push(values);
            }
        }
        let pairs = self.pairs.cases.into_iter();
        let parts = self
            .parts
            .cases
            .into_iter()
            .map(|(case, part)| (case, first_part + part));
        let calls = self.call_cases.into_iter();
        let calls = calls.map(|(case, function, call)| (case, first_call + first_calls[function] + call));
        let questions = pairs.chain(parts).chain(calls);
        all.questions = questions
            .map(|(case, question)| (case, number(question)))
            .collect();
        all.bases = known_bases.into_iter().collect();
        all.words = self.words.all().cloned().collect();
        all.recorded = recorded.into_iter().map(|column| column.answers).collect();
        all
    }
}

impl StatedFunction {
    /// Returns a function with its boundary values, if one of the dialects has it with these types.
    fn find(call: &ConversionCall, dialects: &[DialectName]) -> Option<StatedFunction> {
        let mut found: Option<StatedFunction> = None;
        for (index, dialect) in dialects.iter().enumerate() {
            match (&mut found, signature_of(call, *dialect)) {
                (_, None) => {}
                (Some(function), Some(_)) => function.dialects.push(index),
                (None, Some(signature)) => {
                    let boundaries = inputs::boundaries(&signature);
                    let mut function = StatedFunction {
                        signature,
                        dialects: vec![index],
                        calls: Vec::new(),
                        boundaries: boundaries.len(),
                        call_numbers: HashMap::new(),
                        asserted: HashMap::new(),
                    };
                    boundaries.into_iter().for_each(|call| {
                        function.call(call);
                    });
                    found = Some(function);
                }
            }
        }
        found
    }

    /// Returns the number of a call, which is added where it is new.
    fn call(&mut self, operands: Vec<Value>) -> usize {
        let text: String = operands.iter().map(ToString::to_string).collect();
        let next = self.calls.len();
        let number = *self.call_numbers.entry(text).or_insert(next);
        if number == next {
            self.calls.push(operands);
        }
        number
    }

    /// Returns the expected results of the calls in a dialect; `index` is that of the dialect among all.
    pub fn expected(&self, index: usize, dialect: DialectName) -> Vec<ExpectedResult> {
        let of_call = |(number, call): (usize, &Vec<Value>)| {
            let asserted = self.asserted.get(&(number, index));
            let asserted = asserted.map(|(value, basis)| (value, basis));
            ExpectedResult::of(&self.signature, call, dialect, asserted)
        };
        self.calls.iter().enumerate().map(of_call).collect()
    }
}

/// Returns the words of the bases of a call by dialect, and of the stated values: one where all are equal.
fn stated<'e>(
    expected: impl Iterator<Item = &'e ExpectedResult>,
    words: &mut WordTable,
) -> (Vec<Option<u32>>, Vec<u32>) {
    let mut values = Vec::new();
    let mut bases = Vec::new();
    for stated in expected {
        bases.push(stated.basis.as_ref().map(|basis| words.number(basis)));
        if stated.basis.is_some() {
            values.push(words.number(&stated.value.to_string()));
        }
    }
    if let [first, rest @ ..] = &values[..]
        && rest.iter().all(|value| value == first)
    {
        values.truncate(1);
    }
    (bases, values)
}
