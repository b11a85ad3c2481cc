//! The functions of a table of statements as texts, for reports that show one function at a time.

use super::Statements;
use crate::overview::recorded::QuestionNumber;
use std::collections::HashMap;

/// A conversion function with the types of one of its signatures, and what documents state of its calls.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FunctionTable<'s> {
    /// The name in capitals, such as `REAL_TO_INT`.
    pub name: &'s str,
    /// The names of the operands' types.
    pub operands: Vec<&'s str>,
    /// The name of the result's type.
    pub result: &'s str,
    /// The dialects that have the function with these types.
    pub dialects: Vec<&'static str>,
    /// The calls, boundary values first.
    pub calls: Vec<FunctionCall<'s>>,
}

/// A call of a function.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FunctionCall<'s> {
    /// The number of the question what the call gives.
    pub question: QuestionNumber,
    /// The operands as typed literals.
    pub operands: Vec<&'s str>,
    /// Whether the operands are boundary values of their types; otherwise a case has them.
    pub is_boundary: bool,
    /// The result that a source states, for each of the function's dialects in their order; `None` where all sources are silent.
    pub stated: Vec<Option<StatedResult<'s>>>,
}

/// The result of a call by a source.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct StatedResult<'s> {
    /// The value as a typed literal.
    pub value: &'s str,
    /// The source and section that state it.
    pub basis: &'s str,
    /// Another value, with its basis, that a page of the same vendor states of what was recorded.
    pub otherwise: Option<(&'s str, &'s str)>,
}

impl Statements {
    /// Returns the functions, each with its calls.
    #[must_use]
    pub fn functions(&self) -> Vec<FunctionTable<'_>> {
        let word = |number: u32| self.words[number as usize].as_str();
        let disputed = self.disputed.iter();
        let disputed =
            disputed.map(|&(call, dialect, value, basis)| ((call, dialect), (word(value), word(basis))));
        let disputed: HashMap<(usize, usize), (&str, &str)> = disputed.collect();
        let first_question = self.pairs.len() + self.parts.len();
        let mut first = 0;
        let mut tables = Vec::with_capacity(self.functions.len());
        for function in &self.functions {
            let call = |at: usize| FunctionCall {
                question: QuestionNumber::try_from(first_question + first + at)
                    .unwrap_or(QuestionNumber::MAX),
                operands: self.calls.operands[first + at]
                    .iter()
                    .map(|operand| word(*operand))
                    .collect(),
                is_boundary: at < function.boundaries,
                stated: self.stated(first + at, &function.dialects, &disputed),
            };
            tables.push(FunctionTable {
                name: word(function.name),
                operands: function.operands.iter().map(|operand| word(*operand)).collect(),
                result: word(function.result),
                dialects: function
                    .dialects
                    .iter()
                    .map(|dialect| self.dialects[*dialect])
                    .collect(),
                calls: (0..function.calls).map(call).collect(),
            });
            first += function.calls;
        }
        tables
    }

    /// Returns what sources state of a call, in the order of these dialects.
    fn stated<'s>(
        &'s self,
        call: usize,
        dialects: &[usize],
        disputed: &HashMap<(usize, usize), (&'s str, &'s str)>,
    ) -> Vec<Option<StatedResult<'s>>> {
        let word = |number: u32| self.words[number as usize].as_str();
        let values = &self.calls.values[call];
        let bases = self.bases[self.calls.bases[call]].iter().zip(dialects);
        // One value where all dialects with a basis state the same, otherwise one for each of them.
        let mut following = values.iter();
        let of_dialect = |(basis, dialect): (&Option<u32>, &usize)| {
            let basis = (*basis)?;
            let value = match &values[..] {
                [only] => only,
                _ => following.next()?,
            };
            Some(StatedResult {
                value: word(*value),
                basis: word(basis),
                otherwise: disputed.get(&(call, *dialect)).copied(),
            })
        };
        bases.map(of_dialect).collect()
    }
}
