//! The writer: the source text of a program of the model, in one of several spellings with the same meaning.
//!
//! | file | spells |
//! |---|---|
//! | `style` | nothing; it holds the choices of a spelling |
//! | `source_writer` | keywords, lines, indents and comments |
//! | `literals`, `notation` | literals |
//! | `expressions` | expressions and places |
//! | `statements` | statements |
//! | `declarations` | types, variables, POUs |

mod declarations;
mod expressions;
mod literals;
mod notation;
mod source_writer;
mod statements;
mod style;

pub use declarations::{WrittenProgram, write};
pub use style::{Keywords, Style};
