//! What an evaluation answers: values, what no document settles, or why there are none.

use std::fmt;
use stickler_types::{Fault, Value};

/// What a program gives.
#[derive(Clone, PartialEq, Debug)]
pub struct Evaluation {
    /// The values of [`crate::model::Program::observed`], in its order, after the last scan.
    pub values: Vec<(String, Value)>,
    /// What happened on the way that no document settles; each question once, by its first place. Where there is any, a
    /// compiler may give other values and contradict no document.
    pub opened: Vec<OpenPoint>,
    /// The statements and expressions evaluated.
    pub steps: u64,
}

impl Evaluation {
    /// Whether the values are those that the reference must give: every open question is one that the design answers for it.
    #[must_use]
    pub fn binds_the_reference(&self) -> bool {
        self.opened
            .iter()
            .all(|opened| opened.question.is_answered_by_the_design())
    }
}

/// Something that happened in an evaluation and that no document settles.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct OpenPoint {
    /// What no document says.
    pub question: OpenQuestion,
    /// In which program organization unit, and of which values.
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

/// A question that the documents leave open.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum OpenQuestion {
    /// What a conversion function gives for this value.
    Conversion,
    /// Whether a type converts implicitly to another, or what arrives.
    ImplicitConversion,
    /// A real divided by zero.
    RealDivisionByZero,
    /// An operation gave no number, or took one.
    NotANumber,
    /// The least integer divided by -1: two's complement gives it back, and some processors stop.
    LeastByMinusOne,
    /// A shift or rotation by the width of the type or more.
    ShiftCount,
    /// A shift or rotation by less than nothing.
    NegativeShiftCount,
    /// Which of two zeros, or which of a number and no number, is the lesser or greater.
    ZerosOfTwoSigns,
    /// MUX with a selector that selects nothing.
    MuxSelector,
    /// LIMIT whose lower limit is above the upper one.
    LimitsCrossed,
    /// A duration or date outside the 64 bits of nanoseconds, or a time of day outside its day.
    MomentRange,
    /// What the variable of a FOR loop holds behind it.
    LoopVariable,
    /// The body of a FOR loop changes its variable or the limit that it runs to.
    LoopChanged,
    /// A text longer than the shortest default length of the systems at hand.
    TextLength,
    /// One variable behind two VAR_IN_OUT of a call.
    AliasedInOut,
    /// An output goes to a place that the call itself moves.
    OutputPlace,
    /// The initial value of a DATE or DT that the program does not give.
    InitialDate,
}

impl OpenQuestion {
    /// Whether stickler-design says what the reference does all the same: what IEC 60559 and two's complement suggest (§8).
    #[must_use]
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

    /// Where a person would look for the answer.
    #[must_use]
    pub const fn sought(self) -> &'static str {
        match self {
            OpenQuestion::Conversion => "the dialect's page on conversion functions",
            OpenQuestion::ImplicitConversion => "the dialect's tables of implicit conversions",
            OpenQuestion::RealDivisionByZero | OpenQuestion::NotANumber => {
                "stickler-design: §8 and real-arithmetic"
            }
            OpenQuestion::LeastByMinusOne => "stickler-design: §8",
            OpenQuestion::ShiftCount | OpenQuestion::NegativeShiftCount => "iec-61131-3: Table 30",
            OpenQuestion::ZerosOfTwoSigns | OpenQuestion::MuxSelector | OpenQuestion::LimitsCrossed => {
                "iec-61131-3: Table 32"
            }
            OpenQuestion::MomentRange => "iec-61131-3: Tables 10 and 35",
            OpenQuestion::LoopVariable | OpenQuestion::LoopChanged => "iec-61131-3: 7.3.3.4.2",
            OpenQuestion::TextLength => "iec-61131-3: Table 10",
            OpenQuestion::AliasedInOut | OpenQuestion::OutputPlace => "iec-61131-3: 6.6.1",
            OpenQuestion::InitialDate => "iec-61131-3: Table 10",
        }
    }

    /// What is asked, as a fragment.
    #[must_use]
    pub const fn as_str(self) -> &'static str {
        match self {
            OpenQuestion::Conversion => "what a conversion gives",
            OpenQuestion::ImplicitConversion => "whether and how a type converts implicitly",
            OpenQuestion::RealDivisionByZero => "a real divided by zero",
            OpenQuestion::NotANumber => "an operation on or to no number",
            OpenQuestion::LeastByMinusOne => "the least integer divided by -1",
            OpenQuestion::ShiftCount => "a shift by the width or more",
            OpenQuestion::NegativeShiftCount => "a shift by less than nothing",
            OpenQuestion::ZerosOfTwoSigns => "the lesser of two zeros or of no number",
            OpenQuestion::MuxSelector => "a selector of MUX that selects nothing",
            OpenQuestion::LimitsCrossed => "LIMIT with crossed limits",
            OpenQuestion::MomentRange => "a moment or duration outside its range",
            OpenQuestion::LoopVariable => "the variable of a FOR loop behind it",
            OpenQuestion::LoopChanged => "a FOR loop that changes its own variable or limit",
            OpenQuestion::TextLength => "a text longer than some default length",
            OpenQuestion::AliasedInOut => "one variable behind two VAR_IN_OUT",
            OpenQuestion::OutputPlace => "an output to a place that the call moves",
            OpenQuestion::InitialDate => "the initial value of a date",
        }
    }
}

impl fmt::Display for OpenQuestion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.as_str())
    }
}

/// Why a program has no values.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum EvaluationError {
    /// It stops with this fault.
    Fault(Fault),
    /// It takes more than [`super::MAX_STEPS`] steps, or more memory than so small a program needs.
    StepLimit,
    /// It holds raw text, which means nothing here.
    Raw,
    /// It is no program: a part of the model contradicts another; the words say which.
    IllFormed(&'static str),
}

impl fmt::Display for EvaluationError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            EvaluationError::Fault(fault) => write!(f, "the program stops: {fault}"),
            EvaluationError::StepLimit => f.write_str("the program takes too many steps or too much memory"),
            EvaluationError::Raw => f.write_str("the program holds raw text"),
            EvaluationError::IllFormed(why) => write!(f, "the model contradicts itself: {why}"),
        }
    }
}

impl std::error::Error for EvaluationError {}
