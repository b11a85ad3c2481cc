//! The writer: a program of the model as source text, in one of several spellings that mean the same.
//!
//! | file | spells |
//! |---|---|
//! | `style` | nothing; it says what may vary |
//! | `sheet` | keywords, lines, indents and comments |
//! | `literals`, `notation` | literals |
//! | `expressions` | expressions and places |
//! | `statements` | statements |
//! | `declarations` | types, variables, POUs |

mod declarations;
mod expressions;
mod literals;
mod notation;
mod sheet;
mod statements;
mod style;

pub use declarations::{WrittenProgram, write};
pub(crate) use expressions::{function_name, operator_text};
pub use style::{ArgumentForm, Bits, Keywords, LineEnds, Notation, Style, WideningForm};
