//! Results of an evaluation: values, open questions, and errors.

use std::fmt;
use stickler_types::{Fault, Value, words};

/// The values that a program has by the documents.
#[derive(Clone, PartialEq, Debug)]
pub struct Evaluation {
    /// The values of [`crate::model::Program::observed`], in its order, after the last scan.
    pub values: Vec<(String, Value)>,
    /// The open questions that the evaluation met, each once, at its first place. If there is any, a compiler may give other
    /// values without contradicting a document.
    pub opened: Vec<OpenPoint>,
    /// The number of statements and expressions evaluated.
    pub steps: u64,
}

impl Evaluation {
    /// Returns whether the reference must give these values: IEC 60559 and two's complement answer every open question for it.
    pub fn binds_the_reference(&self) -> bool {
        self.opened
            .iter()
            .all(|opened| opened.question.is_answered_by_the_design())
    }
}

/// A point of an evaluation that no document settles.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OpenPoint {
    /// The question that no document answers.
    pub question: OpenQuestion,
    /// The program organization unit, and the values in question.
    pub at: String,
}

impl fmt::Display for OpenPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{} ({}; sought in {})",
            self.question,
            self.at,
            self.question.sought()
        )
    }
}

words! {
    /// A question that the documents leave open.
    OpenQuestion {
        /// The result of a conversion function for a value.
        Conversion = "what a conversion gives",
        /// Whether a type converts implicitly to another, and with which result.
        ImplicitConversion = "whether and how a type converts implicitly",
        /// A real divided by zero.
        RealDivisionByZero = "a real divided by zero",
        /// An operation that gives or takes NaN.
        NotANumber = "an operation that takes or gives NaN",
        /// The least integer divided by -1: two's complement gives it back, some processors stop.
        LeastByMinusOne = "the least integer divided by -1",
        /// A shift or rotation by the width of the type or more.
        ShiftCount = "a shift by the width or more",
        /// A shift or rotation by a negative count.
        NegativeShiftCount = "a shift by a negative count",
        /// The lesser or greater of two zeros, or of a number and NaN.
        ZerosOfTwoSigns = "the lesser of two zeros, or of a number and NaN",
        /// MUX with a selector outside its inputs.
        MuxSelector = "a selector of MUX outside its inputs",
        /// LIMIT with a lower limit above the upper one.
        LimitsCrossed = "LIMIT with crossed limits",
        /// A duration or date outside the 64 bits of nanoseconds, or a time of day outside its day.
        MomentRange = "a moment or duration outside its range",
        /// The value of the variable of a FOR loop after the loop.
        LoopVariable = "the variable of a FOR loop after the loop",
        /// A FOR loop whose body changes its variable or its limit.
        LoopChanged = "a FOR loop that changes its own variable or limit",
        /// A text longer than the shortest default length of the known systems.
        TextLength = "a text longer than some default length",
        /// One variable passed to two VAR_IN_OUT of a call.
        AliasedInOut = "one variable passed to two VAR_IN_OUT",
        /// An output assigned to a place that the call itself moves.
        OutputPlace = "an output to a place that the call moves",
        /// A timer whose PT is not positive or changes, and a pulse that may begin where one ends.
        Timer = "a timer with another PT than before, or an edge where a pulse ends",
        /// The initial value of a DATE or DT without an initializer.
        InitialDate = "the initial value of a date",
    }
}

impl OpenQuestion {
    /// Returns whether rules of the suite state the behaviour of the reference: the one that IEC 60559 and two's complement
    /// suggest.
    pub const fn is_answered_by_the_design(self) -> bool {
        matches!(
            self,
            OpenQuestion::Conversion
                | OpenQuestion::ImplicitConversion
                | OpenQuestion::RealDivisionByZero
                | OpenQuestion::NotANumber
                | OpenQuestion::LeastByMinusOne
        )
    }

    /// Returns the document in which a person would look for the answer.
    pub const fn sought(self) -> &'static str {
        match self {
            OpenQuestion::Conversion => "the dialect's page on conversion functions",
            OpenQuestion::ImplicitConversion => "the dialect's tables of implicit conversions",
            OpenQuestion::RealDivisionByZero | OpenQuestion::NotANumber => "IEC 60559 and real-arithmetic",
            OpenQuestion::LeastByMinusOne => "rule: integer-overflow-wraps",
            OpenQuestion::ShiftCount | OpenQuestion::NegativeShiftCount => "iec-61131-3: Table 30",
            OpenQuestion::ZerosOfTwoSigns | OpenQuestion::MuxSelector | OpenQuestion::LimitsCrossed => {
                "iec-61131-3: Table 32"
            }
            OpenQuestion::MomentRange => "iec-61131-3: Tables 10 and 35",
            OpenQuestion::LoopVariable | OpenQuestion::LoopChanged => "iec-61131-3: 7.3.3.4.2",
            OpenQuestion::AliasedInOut | OpenQuestion::OutputPlace => "iec-61131-3: 6.6.1",
            OpenQuestion::Timer => "iec-61131-3: Figure 15",
            OpenQuestion::TextLength | OpenQuestion::InitialDate => "iec-61131-3: Table 10",
        }
    }
}

/// The reason why a program has no values.
#[derive(Clone, Copy, PartialEq, Eq, Debug, thiserror::Error)]
pub enum EvaluationError {
    /// The program stops with this fault.
    #[error("the program stops: {0}")]
    Fault(Fault),
    /// The program takes more than [`super::MAX_STEPS`] steps, or more memory than so small a program needs.
    #[error("the program takes too many steps or too much memory")]
    StepLimit,
    /// The program contains raw text, which has no meaning in the model.
    #[error("the program holds raw text")]
    Raw,
    /// The program is ill-formed: a part of the model contradicts another; the text names the contradiction.
    #[error("the model contradicts itself: {0}")]
    IllFormed(&'static str),
}

/// What the evaluator computes, or why there is no value.
pub(super) type Evaluated<T> = Result<T, EvaluationError>;

/// Returns the error for a model whose parts contradict each other.
pub(super) const fn ill_formed(contradiction: &'static str) -> EvaluationError {
    EvaluationError::IllFormed(contradiction)
}
