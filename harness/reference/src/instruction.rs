//! The checked program: what the checker lowers a source text to, and what the machine runs.
//!
//! Memory is one array of 64-bit cells. Every variable has a fixed place, because recursion is forbidden
//! (P4005): programs, globals and function frames lie at absolute addresses, the variables of a function block
//! at offsets from its instance (`this`). Arrays and structures lie flat. A text variable's cell holds the
//! index of its entry in the machine's text store. A VAR_IN_OUT cell holds the address of its argument.
//!
//! A cell holds a value's *raw* form as `stickler_types` defines it: signed integers sign-extended, unsigned
//! integers and bit strings zero-extended, BOOL 0 or 1, REAL and LREAL their IEC 60559 bits, durations, dates
//! and times of day as signed nanoseconds, characters their code unit.

use crate::addresses::{AddressMap, LayoutId};
use crate::conversion::{Concatenation, Conversion};
use rustc_hash::FxHashMap;
use stickler_types::ElementaryType;
use stickler_types::dialect::{TextElements, TextPositions};

/// Why a run ended early; one of the words of the wire protocol.
pub use stickler_types::Fault as FaultKind;

/// An index into the memory.
pub type Address = u32;
/// An index into [`MachineProgram::code`].
pub type Label = u32;
/// An index into [`MachineProgram::routines`].
pub type RoutineId = u32;

/// A checked program, ready to run.
#[derive(Debug, Default)]
pub struct MachineProgram {
    /// All code, routine after routine.
    pub code: Vec<Instruction>,
    /// The 1-based source line of each instruction, for faults; as long as `code`.
    pub lines: Vec<u32>,
    /// The labels where the code of the routines begins. A routine ends with [`Instruction::Return`].
    pub routines: Vec<Label>,
    /// Run once before the first scan: initial values of globals and program instances.
    pub startup: RoutineId,
    /// Run once a scan: all program instances in order.
    pub scan: RoutineId,
    /// The number of cells that the program needs.
    pub memory: u32,
    /// The text variables: their cells and capacities. Cells not named here are plain.
    pub texts: Vec<TextCell>,
    /// Text constants, in code units.
    pub text_constants: Vec<Box<[u16]>>,
    /// The routines of methods that the running program chooses, by the number of the type that declares them and their own.
    pub methods: FxHashMap<(u32, u32), RoutineId>,
    /// The type that another one extends, by the numbers of both.
    pub bases: FxHashMap<u32, u32>,
    /// The variables that have addresses in bytes; none where no reference or pointer is made.
    pub addresses: AddressMap,
}

/// A text variable.
#[derive(Clone, Copy, Debug)]
pub struct TextCell {
    /// The cell.
    pub address: Address,
    /// The declared maximum length in code units; a longer text is cut when stored.
    pub capacity: u32,
}

/// A part of the bits of a variable: a bit, a byte, a word, a double word or a long word.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Part {
    /// The number of the part's lowest bit in the variable.
    pub first: u8,
    /// The type of the part: BOOL, BYTE, WORD, DWORD or LWORD.
    pub ty: ElementaryType,
}

/// One step of the stack machine. "Pops a, b" means that b lies on top. Numbers and addresses share one
/// stack; texts have a stack of their own.
#[derive(Clone, Copy, PartialEq, Debug)]
pub enum Instruction {
    /// Pushes a raw value.
    Push(u64),
    /// Pushes a text constant on the text stack.
    PushText(u32),
    /// Drops the top of the stack.
    Drop,
    /// Drops the top of the text stack.
    DropText,
    /// Exchanges the two topmost values of the stack.
    Swap,

    /// Pushes an absolute address.
    Address(Address),
    /// Pushes `this` plus an offset.
    InstanceAddress(u32),
    /// Pops an address and pushes the content of that cell, itself an address (VAR_IN_OUT).
    Dereference,
    /// Adds a constant to the address on top.
    Offset(u32),
    /// Pops an address and a subscript; pushes `address + (subscript - low) * stride`. Faults with
    /// subscript-range where the subscript lies outside `low..=high`.
    Subscript {
        /// The lowest subscript.
        low: i64,
        /// The highest subscript.
        high: i64,
        /// Cells an element takes.
        stride: u32,
        /// Whether the subscript's raw form is unsigned.
        unsigned: bool,
    },

    /// Pops an address, a subscript, the lowest and the highest subscript, and the stride; does what `Subscript` does with these.
    SubscriptWithin {
        /// Whether the subscript's raw form is unsigned.
        unsigned: bool,
    },

    /// Pushes the content of an absolute cell.
    Load(Address),
    /// Pops an address, pushes the cell's content.
    LoadIndirect,
    /// Pops a value, stores it in an absolute cell.
    Store(Address),
    /// Pops an address and a value, stores the value there.
    StoreIndirect,
    /// Pops an address, pushes its text on the text stack.
    LoadText,
    /// Pops an address, and a text from the text stack, and stores the text, cut to the cell's capacity.
    StoreText,
    /// Pops a destination and a source address; copies that many cells, texts by content. The two may
    /// overlap. Like `Replicate` and `Clear` it costs steps by the number of cells, lest the step limit fail to
    /// bound a run.
    Copy(u32),
    /// Pops the address of a text and a subscript; pushes both as one, for the two instructions that follow. Faults with subscript-range
    /// where the dialect has no character there.
    Character {
        /// Whether a subscript selects a character from 1 or a code from 0.
        of: TextElements,
        /// Whether the subscript's raw form is unsigned.
        unsigned: bool,
    },
    /// Pops the place of a character, pushes its code.
    LoadCharacter,
    /// Pops the place of a character and a code, and stores the code there. Of codes, a zero ends the text.
    StoreCharacter(TextElements),
    /// Pops an address: copies the `stride` cells there to the `count - 1` places behind them.
    Replicate {
        /// Cells an element takes.
        stride: u32,
        /// The number of elements, the first included.
        count: u32,
    },
    /// Pops an address: sets that many cells to zero and their texts to empty.
    Clear(u32),

    /// Pops the address of a cell, pushes the address in bytes of the variable there, which references and pointers hold.
    AddressOf,
    /// Pops an address in bytes, pushes that of the cell of the value there, which is of this layout. Where it is not, it faults, as the
    /// others of these instructions do with `null-dereference` and `invalid-address`.
    Locate(LayoutId),
    /// Pops an address in bytes, pushes the plain value there, whatever its bytes are part of.
    Peek(LayoutId),
    /// Pops an address in bytes and a plain value; stores it there.
    Poke(LayoutId),
    /// Pops an address in bytes, of a part of a union, and that of a cell; copies the value of this layout from the one to the other.
    Gather(LayoutId),
    /// Pops the same; copies the value in the cells to the address in bytes.
    Scatter(LayoutId),

    /// Pops a value, pushes a part of its bits as a BOOL or a bit string.
    Part(Part),
    /// Pops an address and a value; sets that part of the cell's bits, and brings it back to the raw form of its type.
    StorePart {
        /// The bits that are set.
        part: Part,
        /// The cell's type.
        of: ElementaryType,
    },

    /// Converts the top of the stack; text operands and results are on the text stack.
    Convert(Conversion),
    /// Converts the text on top; pushes the value and above it TRUE, or FALSE where the text spells none.
    TryConvert(Conversion),
    /// Pops a value of the type, and a text by which it is formatted; pushes the text that comes of it.
    Format(ElementaryType),
    /// Pops a date and a time of day; pushes both as one.
    Concatenate(Concatenation),
    /// Pops two values of the type, pushes the result, wrapped to the type's width. Addition and subtraction
    /// also come with durations, and with dates and times, of nanoseconds: 64 bits wrap, and TOD and LTOD are
    /// taken modulo a day. (The difference of two dates is a subtraction of type TIME.)
    Arithmetic(ArithmeticOperator, ElementaryType),
    /// Pops a duration (or for `Divide` first a duration) and a number of the type; pushes the duration. A product with a number that is not finite is
    /// the least duration where that is so, and otherwise 0.
    ScaleDuration(ArithmeticOperator, ElementaryType, bool),
    /// Pops base and exponent; pushes base raised to exponent in the base's type.
    Power {
        /// The type of the base and of the result.
        base: ElementaryType,
        /// The type of the exponent.
        exponent: ElementaryType,
        /// Whether a real zero with a negative exponent faults with division-by-zero.
        stops: bool,
    },
    /// Pops two values of the type, pushes a BOOL.
    Compare(ComparisonOperator, ElementaryType),
    /// Pops two texts, pushes a BOOL.
    CompareText(ComparisonOperator),
    /// Pops two values, pushes AND, OR or XOR of their bits.
    Logic(LogicOperator),
    /// Inverts the top within the type's width.
    Not(ElementaryType),
    /// Negates the top in the type.
    Negate(ElementaryType),
    /// Faults with `subrange` unless the top, a signed or unsigned integer, lies in the range; leaves it.
    CheckRange {
        /// The lower limit.
        low: i64,
        /// The upper limit, as bits of the base type's raw form.
        high: u64,
        /// Whether the base type is unsigned.
        unsigned: bool,
    },
    /// Pops the control value, the limit and the step of a FOR loop (the step on top), integers in the raw
    /// forms of the types that `LoopTypes` names; pushes TRUE where the control value has not passed the limit:
    /// control <= limit for a step of 0 or more, control >= limit for a negative one, as numbers of any size.
    LoopTest(LoopTypes),
    /// Pops the same three; pushes control + step, wrapped to the control's type, and above it TRUE where the
    /// exact sum fits that type and has not passed the limit.
    LoopStep(LoopTypes),
    /// A standard function over plain values; see [`StandardFunction`] for what it pops.
    Standard {
        /// The function.
        function: StandardFunction,
        /// The type of its values.
        of: ElementaryType,
        /// The number of values of the type that it takes.
        count: u16,
        /// The number of integers that it takes besides: a selector, a number of places, a length, a position.
        numbers: u16,
    },

    /// Goes on elsewhere.
    Jump(Label),
    /// Pops a BOOL; goes on elsewhere where it is FALSE.
    JumpIfFalse(Label),
    /// Calls a routine that has no instance; `this` stays as it is for the caller.
    Call(RoutineId),
    /// Pops an address, which becomes `this` of the called routine.
    CallInstance(RoutineId),
    /// Pops the address of an instance, whose first cell holds the number of its type; calls the method that the type has for this
    /// number of [`MachineProgram::methods`]. Faults with null-dereference where there is no instance.
    CallMethod(u32),
    /// Ends the routine.
    Return,
}

/// The integer types of a FOR loop's three numbers, which may differ: bounds are taken by value.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct LoopTypes {
    /// The control variable's.
    pub control: ElementaryType,
    /// The limit's.
    pub limit: ElementaryType,
    /// The step's.
    pub step: ElementaryType,
    /// Whether the sum is compared with the limit as the control variable holds it, wrapped, so that the greatest limit of its type is never passed.
    pub wraps: bool,
}

/// Arithmetic on two values of one type.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum ArithmeticOperator {
    /// `+`.
    Add,
    /// `-`.
    Subtract,
    /// `*`.
    Multiply,
    /// `/`: integers toward zero; zero as an integer divisor faults with division-by-zero.
    Divide,
    /// `/`, of which zero as a real divisor and a quotient of integers that does not fit fault with division-by-zero, too.
    DivideOrStop,
    /// `MOD`: the remainder has the dividend's sign; zero as the divisor faults.
    Modulo,
    /// MOD, of which a divisor of zero gives 0 and no fault.
    ModuloOrZero,
}

/// Comparison of two values of one type. REAL and LREAL follow IEC 60559: NaN is unequal to everything.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum ComparisonOperator {
    /// `=`.
    Equal,
    /// `<>`.
    NotEqual,
    /// `<>`, which does not hold for a number that is not a number.
    LessOrGreater,
    /// `<`.
    Less,
    /// `<=`.
    LessOrEqual,
    /// `>`.
    Greater,
    /// `>=`.
    GreaterOrEqual,
}

/// Bitwise operators.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum LogicOperator {
    /// AND.
    And,
    /// OR.
    Or,
    /// XOR.
    Xor,
}

/// The standard functions that are no conversions. `of` is the common type of the values; for a text type
/// values and results are on the text stack.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum StandardFunction {
    /// ABS: pops one value; wraps for the least integer.
    Abs,
    /// SEL: pops a BOOL and two values (the BOOL lies deepest).
    Sel,
    /// MUX: pops a selector as an i64 (deepest) and `count` values; a selector outside the range faults with
    /// subscript-range.
    Mux,
    /// MIN: pops `count` values.
    Min,
    /// MAX: pops `count` values.
    Max,
    /// LIMIT: pops minimum, value, maximum; `MIN(MAX(value, minimum), maximum)`.
    Limit,
    /// ABS of reals that gives an infinity and a NaN for itself.
    FiniteAbs,
    /// LIMIT of reals that gives the value where one of the three is an infinity or a NaN.
    FiniteLimit,
    /// SHL: pops a value and a count as an i64; zeros come in; a count below 0 or past the width gives 0.
    Shl,
    /// SHR.
    Shr,
    /// ROL: the count is taken modulo the width.
    Rol,
    /// ROR.
    Ror,
    /// LEN: pops a text; pushes its length in code units as INT.
    Len,
    /// CONCAT: pops `count` texts, pushes them joined.
    Concat,
    /// LEFT and its kin: pops one or two texts and the numbers of the function, and does what the dialect does where these lie outside the text.
    Part(TextPart, TextPositions),
    /// Replaces a text that is longer than the variable to which it is assigned: pops the greatest length and one or two texts; pushes the
    /// first text where it is no longer, otherwise the second one, or an empty text.
    Fitting,
    /// FIND: pops two texts; pushes the position of the second in the first as INT, 0 where it is not there or empty.
    Find,
    /// SQRT and the other functions of one real number, and ATAN2: pops their operands. Where the function is not defined, the result is not
    /// a number, or infinite.
    Real(RealFunction),
    /// A function of real numbers as [`Instruction::Real`], but LN and LOG of 0, which would be infinite, fault with division-by-zero.
    RealOrStop(RealFunction),
    /// CONCAT_DATE and its kin: pops the numbers of a date, a time of day or both as i64, from the year or the hour on; faults with subrange where
    /// the type does not have them.
    Compose,
    /// TO_BIG_ENDIAN, FROM_BIG_ENDIAN: pops a value, pushes that of its bytes in the opposite order.
    SwapBytes,
    /// IS_VALID: pops a real number; pushes whether it is a number and not infinite.
    IsValid,
    /// IS_VALID_BCD: pops a bit string; pushes whether each four bits of it are a decimal digit.
    IsValidBcd,
    /// GT and its kin: pops `count` values, pushes a BOOL: whether each of them compares so with the one behind it.
    InOrder(ComparisonOperator),
}

/// The standard functions of parts of texts.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum TextPart {
    /// LEFT: of a text and a number of characters.
    Left,
    /// RIGHT.
    Right,
    /// MID: of a text, a number of characters, and the position of the first one, from 1.
    Mid,
    /// INSERT: of two texts and the number of characters of the first one that stay before the second.
    Insert,
    /// DELETE: of what MID is.
    Delete,
    /// REPLACE: of two texts, and the number and the position of the characters of the first one that the second replaces.
    Replace,
}

/// The standard functions of real numbers.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum RealFunction {
    /// SQRT.
    SquareRoot,
    /// LN.
    NaturalLogarithm,
    /// LOG: to the base 10.
    Logarithm,
    /// EXP.
    Exponential,
    /// SIN, of an angle in radians.
    Sine,
    /// COS.
    Cosine,
    /// TAN.
    Tangent,
    /// ASIN.
    ArcSine,
    /// ACOS.
    ArcCosine,
    /// ATAN.
    ArcTangent,
    /// ATAN2: the angle of the point with the ordinate of the first operand and the abscissa of the second.
    ArcTangent2,
}

impl StandardFunction {
    /// Returns the type of the result where it does not depend on the inputs.
    pub(crate) const fn own_result(self) -> Option<ElementaryType> {
        match self {
            StandardFunction::Len | StandardFunction::Find => Some(ElementaryType::Int),
            StandardFunction::IsValid | StandardFunction::IsValidBcd => Some(ElementaryType::Bool),
            _ => None,
        }
    }

    /// Returns whether the function shifts or rotates bits.
    pub(crate) const fn moves_bits(self) -> bool {
        use StandardFunction::{Rol, Ror, Shl, Shr};
        matches!(self, Shl | Shr | Rol | Ror)
    }
}
