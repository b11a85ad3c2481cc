//! The writer: the source text of a program of the model, in one of several spellings with the same meaning.
//!
//! | file | spells |
//! |---|---|
//! | `source_writer` | keywords, lines, indents and comments |
//! | `literals` | literals |
//! | `expressions` | expressions and places |
//! | `statements` | statements |
//! | `declarations` | types, variables, POUs |

mod declarations;
mod expressions;
mod literals;
mod source_writer;
mod statements;

pub use declarations::{WrittenProgram, write};

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
    /// Whether a line ends with a carriage return and a line feed, and not with a line feed alone.
    pub carriage_returns: bool,
    /// Whether a bit is selected by `word.%X3` and not by `word.3`; only some dialects know the longer form.
    pub percent_bits: bool,
    /// Whether an implicit conversion is spelled by the function that does the same: `INT_TO_DINT(i)`. Where the dialect has
    /// no such function, it stays implicit.
    pub explicit_conversions: bool,
    /// Whether calls of functions of the program have named arguments, `f(a := 1, b := 2)`. Calls of function blocks and calls
    /// that leave out inputs have names all the same.
    pub named_arguments: bool,
    /// Whether literals have other notations than the canonical one: `16#FF`, `2#1111_1111`, `1.0E2`, `T#1m30s`,
    /// `'$69t$27s'`. Labels of CASE stay as they are.
    pub varied_notation: bool,
    /// The seed that determines where comments stand, the case of each letter of [`Keywords::Mixed`], and the notation of
    /// each varied literal.
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
