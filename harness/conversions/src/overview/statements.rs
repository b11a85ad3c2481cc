//! The statements of documents about conversions: which types convert implicitly, which bits and parts of a type have a name,
//! and what the functions give for boundary values and for the values of the cases of a run.
//!
//! Programs that show conversions, such as the page of a run, read them as one table, in which a word stands once and
//! everything else is a number.

mod functions;

use super::inputs;
use super::recorded::{RecordedAnswers, RecordedColumn};
use super::results::ExpectedResult;
use crate::recording::Recording;
pub use functions::{FunctionCall, FunctionTable, StatedResult};
use serde::{Serialize, Serializer};
use std::collections::HashMap;
use std::sync::Arc;
use stickler_exact::{Signature, call_of_program, signatures};
use stickler_types::{DialectName, ElementaryType, MatrixWord, Value, WordTable};

/// The number of a question to which documents and engines have answers: whether a pair of types converts implicitly, whether a
/// type has a part, or what one call of a function gives. Pairs come first, then parts, then calls.
pub type QuestionNumber = u32;

/// The statements of documents about conversions, and which case of a run asks which question.
#[derive(Default, Serialize)]
pub struct Statements {
    dialects: Vec<&'static str>,
    words: Vec<String>,
    /// The pairs of types.
    pairs: Vec<Accepted>,
    /// The types with the bits and parts that programs take out of them.
    parts: Vec<Accepted>,
    functions: Vec<FunctionStatements>,
    /// The calls of all functions, one function after the other.
    calls: CallStatements,
    /// The bases of calls, which most have in common: by the dialects of the function, the number of a word; `null` where no
    /// document states the result.
    bases: Vec<Vec<Option<u32>>>,
    /// The calls of which a vendor's page states another value than was recorded: the number of the call, the index of the dialect
    /// among all, the word of that value and the word of its basis.
    disputed: Vec<(usize, usize, u32, u32)>,
    /// The number of the question of each case that asks one, by the id of the case.
    #[serde(skip)]
    questions: HashMap<Arc<str>, QuestionNumber>,
    /// The answers of recordings, by recording and dialect.
    #[serde(skip)]
    recorded: Vec<RecordedAnswers>,
}

/// A statement of documents about two words, such as a pair of types: whether a program with them is accepted.
#[derive(Serialize)]
struct Accepted {
    from: u32,
    to: u32,
    /// By dialect, the word of the documents and the basis; `null` where none speaks of it.
    #[serde(serialize_with = "stated_words")]
    stated: Vec<Option<(MatrixWord, u32)>>,
}

fn stated_words<S: Serializer>(
    stated: &[Option<(MatrixWord, u32)>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(
        stated
            .iter()
            .map(|one| one.map(|(word, basis)| (word.as_str(), basis))),
    )
}

/// A function with the types of one of its signatures.
#[derive(Serialize)]
struct FunctionStatements {
    name: u32,
    operands: Vec<u32>,
    result: u32,
    /// The indices of the dialects that have the function with these types.
    dialects: Vec<usize>,
    /// The number of its calls, boundary values first.
    calls: usize,
    /// The number of its boundary values.
    boundaries: usize,
}

/// The calls, each property a list with an element for each call.
#[derive(Default, Serialize)]
struct CallStatements {
    /// The words of the operands.
    operands: Vec<Vec<u32>>,
    /// The index of the bases.
    bases: Vec<usize>,
    /// The words of the stated values: one where all dialects with a basis state the same, otherwise one for each of them.
    values: Vec<Vec<u32>>,
}

/// A statement of a document, of which a case asks whether an engine does so.
#[derive(Clone, PartialEq, Debug)]
pub struct CaseStatement<'c> {
    /// The dialect.
    pub dialect: DialectName,
    /// Whether the program must be accepted.
    pub word: MatrixWord,
    /// The source and section that say so.
    pub basis: &'c str,
    /// The id of the case.
    pub case: &'c Arc<str>,
}

/// A case whose program may make one call of a conversion function.
#[derive(Clone, Copy, Debug)]
pub struct CaseProgram<'c> {
    /// The id of the case.
    pub case: &'c Arc<str>,
    /// The dialect.
    pub dialect: DialectName,
    /// The program.
    pub source: &'c str,
    /// The value that the case asserts, if it asserts exactly one.
    pub result: Option<&'c Value>,
    /// The source and section that the case cites.
    pub basis: &'c Arc<str>,
}

impl Statements {
    /// Returns the number of the question that a case asks, by its id; `None` for a case that asks another.
    #[must_use]
    pub fn question(&self, case: &str) -> Option<QuestionNumber> {
        self.questions.get(case).copied()
    }

    /// Returns the answers of recordings to the questions, by recording and dialect.
    #[must_use]
    pub fn recorded(&self) -> &[RecordedAnswers] {
        &self.recorded
    }

    /// Returns whether there is no question.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pairs.is_empty() && self.parts.is_empty() && self.functions.is_empty()
    }
}

/// Gathers statements.
pub struct StatementsBuilder {
    dialects: Vec<DialectName>,
    words: WordTable,
    pairs: AcceptedTable,
    parts: AcceptedTable,
    functions: Vec<StatedFunction>,
    function_numbers: HashMap<(String, ElementaryType, ElementaryType), Option<usize>>,
    call_cases: Vec<(Arc<str>, usize, usize)>,
}

/// A function with the types of one of its signatures, and its calls.
struct StatedFunction {
    signature: Signature,
    dialects: Vec<usize>,
    calls: Vec<Vec<Value>>,
    boundaries: usize,
    call_numbers: HashMap<String, usize>,
    /// The results that cases assert, and their bases, by the number of the call and the index of the dialect.
    asserted: HashMap<(usize, usize), (Value, Arc<str>)>,
}

/// Statements about pairs of words, and the cases that ask about them.
#[derive(Default)]
struct AcceptedTable {
    all: Vec<Accepted>,
    numbers: HashMap<(u32, u32), usize>,
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
        let next = self.all.len();
        let number = *self.numbers.entry((from, to)).or_insert(next);
        if number == next {
            let stated = vec![None; dialects.len()];
            self.all.push(Accepted { from, to, stated });
        }
        let stated = &mut self.all[number].stated[dialect];
        if stated.is_none() {
            *stated = Some((statement.word, basis));
        }
        self.cases.push((Arc::clone(statement.case), number));
    }
}

impl StatementsBuilder {
    /// Begins a table whose columns are these dialects.
    #[must_use]
    pub fn new(dialects: Vec<DialectName>) -> StatementsBuilder {
        StatementsBuilder {
            dialects,
            words: WordTable::default(),
            pairs: AcceptedTable::default(),
            parts: AcceptedTable::default(),
            functions: Vec::new(),
            function_numbers: HashMap::new(),
            call_cases: Vec::new(),
        }
    }

    /// Adds a statement about the implicit conversion of a pair of types.
    pub fn add_implicit(&mut self, from: ElementaryType, to: ElementaryType, statement: &CaseStatement<'_>) {
        let pair = (self.words.number(from.name()), self.words.number(to.name()));
        let basis = self.words.number(statement.basis);
        self.pairs.add(pair, statement, &self.dialects, basis);
    }

    /// Adds a statement about a bit or a part of a type, such as `7` or `%B1`.
    pub fn add_part(&mut self, ty: ElementaryType, part: &str, statement: &CaseStatement<'_>) {
        let pair = (self.words.number(ty.name()), self.words.number(part));
        let basis = self.words.number(statement.basis);
        self.parts.add(pair, statement, &self.dialects, basis);
    }

    /// Adds the call that a case makes, if its program makes one call of a conversion function, and the result that it asserts; and with
    /// the first call of a function the boundary values of its types.
    pub fn add_program(&mut self, case: &CaseProgram<'_>) {
        let Some(call) = call_of_program(case.source) else {
            return;
        };
        let Some(from) = ElementaryType::from_name(call.operand.type_name()) else {
            return;
        };
        let function = call.function.to_ascii_uppercase();
        let key = (function, from, call.result);
        let number = match self.function_numbers.get(&key) {
            Some(number) => *number,
            None => {
                let function = StatedFunction::find(&key, &self.dialects);
                let number = function.is_some().then_some(self.functions.len());
                self.functions.extend(function);
                self.function_numbers.insert(key, number);
                number
            }
        };
        if let Some(number) = number {
            let function = &mut self.functions[number];
            let call = function.call(vec![call.operand]);
            let dialect = self.dialects.iter().position(|dialect| *dialect == case.dialect);
            if let (Some(dialect), Some(result)) = (dialect, case.result) {
                let stated = (result.clone(), Arc::clone(case.basis));
                function.asserted.entry((call, dialect)).or_insert(stated);
            }
            self.call_cases.push((Arc::clone(case.case), number, call));
        }
    }

    /// Returns whether no case has asked a question yet.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.pairs.all.is_empty() && self.parts.all.is_empty() && self.functions.is_empty()
    }

    /// Returns the table, with what documents state of each call, and what the recorded compilers answer.
    #[must_use]
    pub fn finish(mut self, recordings: &[Recording]) -> Statements {
        let mut recorded = RecordedColumn::all(recordings, &self.dialects);
        let mut all = Statements {
            dialects: self.dialects.iter().map(|dialect| dialect.as_str()).collect(),
            pairs: self.pairs.all,
            parts: self.parts.all,
            ..Statements::default()
        };
        let number = |index: usize| QuestionNumber::try_from(index).unwrap_or(QuestionNumber::MAX);
        let first_part = all.pairs.len();
        let first_call = first_part + all.parts.len();
        for (question, pair) in all.pairs.iter().enumerate() {
            let ty = |word: u32| ElementaryType::from_name(self.words.all().get(word as usize)?);
            if let (Some(from), Some(to)) = (ty(pair.from), ty(pair.to)) {
                for column in &mut recorded {
                    let word = pair.stated[column.dialect()].map(|(word, _)| word);
                    column.add_pair(number(question), (from, to), word);
                }
            }
        }
        for (question, part) in (first_part..).zip(&all.parts) {
            let word = |word: u32| self.words.all().get(word as usize);
            let ty = word(part.from).and_then(|name| ElementaryType::from_name(name));
            if let (Some(ty), Some(named)) = (ty, word(part.to)) {
                for column in &mut recorded {
                    let word = part.stated[column.dialect()].map(|(word, _)| word);
                    column.add_part(number(question), ty, named, word);
                }
            }
        }
        let mut first_calls = Vec::with_capacity(self.functions.len());
        let mut known_bases = HashMap::new();
        for function in &self.functions {
            let first = all.calls.operands.len();
            first_calls.push(first);
            for column in &mut recorded {
                if function.dialects.contains(&column.dialect()) {
                    let dialect = (column.dialect(), self.dialects[column.dialect()]);
                    let calls = 0..function.calls.len();
                    let expected = calls.map(|call| function.expected(call, dialect)).collect();
                    let first = number(first_call + first);
                    column.add_calls(first, &function.signature, &function.calls, expected);
                }
            }
            let signature = &function.signature;
            let types = signature.operands.iter().map(|ty| self.words.number(ty.name()));
            let operands = types.collect();
            all.functions.push(FunctionStatements {
                name: self.words.number(&signature.function),
                operands,
                result: self.words.number(signature.result.name()),
                dialects: function.dialects.clone(),
                calls: function.calls.len(),
                boundaries: function.boundaries,
            });
            for (number, call) in function.calls.iter().enumerate() {
                let texts = call.iter().map(|value| self.words.number(&value.to_string()));
                all.calls.operands.push(texts.collect());
                let (bases, values) = function.stated(number, &self.dialects, &mut self.words);
                for dialect in &function.dialects {
                    let expected = function.expected(number, (*dialect, self.dialects[*dialect]));
                    if let Some(other) = expected.otherwise {
                        let value = self.words.number(&other.value.to_string());
                        let basis = self.words.number(&other.basis);
                        all.disputed.push((first + number, *dialect, value, basis));
                    }
                }
                let next = all.bases.len();
                let number = *known_bases.entry(bases.clone()).or_insert(next);
                if number == next {
                    all.bases.push(bases);
                }
                all.calls.bases.push(number);
                all.calls.values.push(values);
            }
        }
        let pairs = self.pairs.cases.into_iter();
        all.questions = pairs.map(|(case, pair)| (case, number(pair))).collect();
        let parts = self.parts.cases.into_iter();
        all.questions
            .extend(parts.map(|(case, part)| (case, number(first_part + part))));
        let calls = self.call_cases.into_iter();
        all.questions.extend(
            calls.map(|(case, function, call)| (case, number(first_call + first_calls[function] + call))),
        );
        all.words = self.words.all().to_vec();
        all.recorded = recorded.into_iter().map(RecordedColumn::into_answers).collect();
        all
    }
}

impl StatedFunction {
    /// Returns a function with its boundary values, if one of the dialects has it with these types.
    fn find(
        (name, from, result): &(String, ElementaryType, ElementaryType),
        dialects: &[DialectName],
    ) -> Option<StatedFunction> {
        let mut found: Option<StatedFunction> = None;
        for (index, dialect) in dialects.iter().enumerate() {
            let mut all = signatures(name, *dialect).into_iter();
            let signature = all.find(|one| one.operands == [*from] && one.result == *result);
            match (&mut found, signature) {
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

    /// Returns the expected result of a call in a dialect, which is given with its index.
    fn expected(&self, number: usize, (index, dialect): (usize, DialectName)) -> ExpectedResult {
        let asserted = self.asserted.get(&(number, index));
        let asserted = asserted.map(|(value, basis)| (value, basis));
        ExpectedResult::of(&self.signature, &self.calls[number], dialect, asserted)
    }

    /// Returns the basis of a call by dialect, and the stated values: one where all are equal.
    fn stated(
        &self,
        number: usize,
        dialects: &[DialectName],
        words: &mut WordTable,
    ) -> (Vec<Option<u32>>, Vec<u32>) {
        let mut values = Vec::new();
        let mut bases = Vec::with_capacity(self.dialects.len());
        for dialect in &self.dialects {
            let stated = self.expected(number, (*dialect, dialects[*dialect]));
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
}

#[cfg(test)]
mod tests {
    use super::{CaseProgram, CaseStatement, Statements, StatementsBuilder};
    use serde_json::{Value, json};
    use std::sync::Arc;
    use stickler_types::{DialectName, ElementaryType, MatrixWord};

    const PROGRAM: &str = "PROGRAM main\nVAR\n    data : REAL := 2.25;\n    into : INT;\nEND_VAR\n    into := REAL_TO_INT(data);\nEND_PROGRAM\n";

    fn statements() -> Statements {
        let dialects = vec![
            DialectName::IronplcEd3,
            DialectName::Matiec,
            DialectName::Plcnext,
            DialectName::Codesys,
        ];
        let mut builder = StatementsBuilder::new(dialects);
        let case = Arc::from("w::assignment(INT,DINT,1)");
        let statement = CaseStatement {
            dialect: DialectName::Matiec,
            word: MatrixWord::No,
            basis: "measured: here",
            case: &case,
        };
        builder.add_implicit(ElementaryType::Int, ElementaryType::Dint, &statement);
        let part = CaseStatement {
            case: &Arc::from("b::p(BYTE,8)"),
            ..statement
        };
        builder.add_part(ElementaryType::Byte, "8", &part);
        let recorded = stickler_types::Value::parse("INT#77").unwrap();
        let program = CaseProgram {
            case: &Arc::from("c::p(REAL,INT,2.25)"),
            dialect: DialectName::Codesys,
            source: PROGRAM,
            result: Some(&recorded),
            basis: &Arc::from("codesys-recording: here"),
        };
        builder.add_program(&program);
        builder.add_program(&CaseProgram {
            case: &Arc::from("c::none"),
            source: "PROGRAM main END_PROGRAM",
            ..program
        });
        builder.finish(&[])
    }

    #[test]
    fn a_call_has_what_documents_state_and_is_open_where_they_are_silent() {
        let statements = statements();
        let data = serde_json::to_value(&statements).unwrap();
        let word = |number: &Value| data["words"][usize::try_from(number.as_u64().unwrap()).unwrap()].clone();
        let question = statements.question("c::p(REAL,INT,2.25)").unwrap() as usize;
        let before = ["pairs", "parts"].map(|key| data[key].as_array().unwrap().len());
        let call = question - before[0] - before[1];
        assert_eq!(word(&data["calls"]["operands"][call][0]), json!("REAL#2.25"));
        let values = ["INT#2", "INT#2", "INT#77"].map(|value| json!(value));
        for (index, value) in values.iter().enumerate() {
            assert_eq!(word(&data["calls"]["values"][call][index]), *value);
        }
        let bases = usize::try_from(data["calls"]["bases"][call].as_u64().unwrap()).unwrap();
        let bases = &data["bases"][bases];
        assert_eq!(
            word(&bases[0]),
            json!("ironplc-conversion-functions: Real to Integer")
        );
        assert_eq!(
            word(&bases[1]),
            json!("forgeiec-conversion-functions: Range and precision")
        );
        assert!(bases[2].is_null(), "no document of PLCnext says how it rounds");
        assert_eq!(word(&bases[3]), json!("codesys-recording: here"));
    }

    #[test]
    fn a_function_is_told_as_texts_with_the_same_questions() {
        let statements = statements();
        let functions = statements.functions();
        let [function] = &functions[..] else {
            panic!("{functions:?}");
        };
        assert_eq!((function.name, function.result), ("REAL_TO_INT", "INT"));
        assert_eq!(function.dialects, ["ironplc-ed3", "matiec", "plcnext", "codesys"]);
        let question = statements.question("c::p(REAL,INT,2.25)").unwrap();
        let call = function
            .calls
            .iter()
            .find(|call| call.question == question)
            .unwrap();
        assert_eq!(
            (&call.operands[..], call.is_boundary),
            (&["REAL#2.25"][..], false)
        );
        let values = call
            .stated
            .iter()
            .map(|stated| stated.as_ref().map(|one| one.value));
        let values: Vec<Option<&str>> = values.collect();
        assert_eq!(values, [Some("INT#2"), Some("INT#2"), None, Some("INT#77")]);
    }

    #[test]
    fn the_boundary_values_of_a_function_are_there_without_a_case() {
        let data = serde_json::to_value(statements()).unwrap();
        let words = data["words"].as_array().unwrap();
        for value in ["REAL#NaN", "REAL#2.5", "REAL#32768.0"] {
            assert!(words.contains(&json!(value)), "{value}");
        }
        assert_eq!(data["functions"].as_array().unwrap().len(), 1);
    }

    #[test]
    fn a_pair_of_types_is_a_question_of_its_own() {
        let statements = statements();
        assert_eq!(statements.question("w::assignment(INT,DINT,1)"), Some(0));
        assert_eq!(statements.question("b::p(BYTE,8)"), Some(1));
        assert_eq!(statements.question("c::none"), None);
        let data = serde_json::to_value(&statements).unwrap();
        assert_eq!(data["pairs"][0]["stated"][1][0], json!("no"));
        assert!(data["pairs"][0]["stated"][0].is_null());
        assert_eq!(data["parts"][0]["stated"][1][0], json!("no"));
    }
}
