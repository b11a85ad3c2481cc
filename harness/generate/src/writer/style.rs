//! The spelling of a program.

/// The choices of a spelling. Whatever is chosen, the program means the same, as long as its dialect knows the spelling.
///
/// The default is the canonical spelling: upper-case keywords, no comments, `LF`, `.n`, implicit conversions left implicit,
/// and positional arguments.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Style {
    /// The case of keywords and of the names of types and standard functions.
    pub keywords: Keywords,
    /// Whether comments `(* … *)` stand where blanks stand; they do not nest.
    pub comments: bool,
    /// The characters that end a line.
    pub line_ends: LineEnds,
    /// The form of bit access; only some dialects know the longer form.
    pub bits: Bits,
    /// Whether an implicit conversion is spelled by the function that does the same. Where the dialect has no such function,
    /// it stays implicit.
    pub widening: WideningForm,
    /// The form of arguments in calls of functions of the program. Function blocks are always called with names.
    pub arguments: ArgumentForm,
    /// The notation of literals.
    pub notation: Notation,
    /// The seed that determines where comments stand, the case of each letter of [`Keywords::Mixed`], and the notation of
    /// each literal of [`Notation::Varied`].
    pub seed: u64,
}

/// The case of keywords.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Keywords {
    /// `END_IF`
    #[default]
    Upper,
    /// `end_if`
    Lower,
    /// `eNd_IF`
    Mixed,
}

/// The end of a line.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum LineEnds {
    /// A line feed.
    #[default]
    Lf,
    /// A carriage return and a line feed.
    CrLf,
}

/// The selection of a bit.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Bits {
    /// `word.3`
    #[default]
    Short,
    /// `word.%X3`
    Percent,
}

/// An implicit conversion.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum WideningForm {
    /// `i`, where a DINT is expected.
    #[default]
    Implicit,
    /// `INT_TO_DINT(i)`
    Explicit,
}

/// The arguments of a function's call.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum ArgumentForm {
    /// `f(1, 2)`; a call that leaves out inputs has names all the same.
    #[default]
    Positional,
    /// `f(a := 1, b := 2)`
    Named,
}

/// The notation of literals.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Notation {
    /// `255`, `16#00FF`, `100.0`, `T#90000ms`, `'it$'s'`
    #[default]
    Canonical,
    /// `16#FF`, `2#1111_1111`, `1.0E2`, `T#1m30s`, `'$69t$27s'`; labels of CASE stay as they are.
    Varied,
}
