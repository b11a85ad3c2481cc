//! The two output streams: results on stdout, all else on stderr; colours only where the stream is a terminal.

use anstyle::{AnsiColor, Style};
use serde::Serialize;
use serde_json::Value as Json;
use std::env;
use std::fmt::Display;
use std::io::{self, BufWriter, Write};

/// The style of headings.
pub const BOLD: Style = Style::new().bold();
/// The style of what matters less.
pub const DIM: Style = Style::new().dimmed();
/// The style of what is as it should be.
pub const GOOD: Style = AnsiColor::Green.on_default().bold();
/// The style of errors and of what is not as it should be.
pub const BAD: Style = AnsiColor::Red.on_default().bold();

/// Returns the buffered standard output, which strips styles where it is no terminal or `NO_COLOR` is set. After its reader has
/// gone, as in `stickler list | head`, it drops what is written: the command still ends with the exit code of its result, for
/// a pipe must not turn a failed run into a green one.
pub fn stdout() -> impl Write {
    BufWriter::with_capacity(
        1 << 16,
        WhileRead {
            inner: anstream::stdout(),
            read: true,
        },
    )
}

/// A writer that drops what is written after its reader has gone.
struct WhileRead<W> {
    inner: W,
    read: bool,
}

impl<W> WhileRead<W> {
    /// Returns the result of an attempt to write, or `dropped` where nobody reads any more.
    fn attempt<T>(&mut self, dropped: T, write: impl FnOnce(&mut W) -> io::Result<T>) -> io::Result<T> {
        if !self.read {
            return Ok(dropped);
        }
        match write(&mut self.inner) {
            Err(error) if error.kind() == io::ErrorKind::BrokenPipe => {
                self.read = false;
                Ok(dropped)
            }
            other => other,
        }
    }
}

impl<W: Write> Write for WhileRead<W> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.attempt(bytes.len(), |inner| inner.write(bytes))
    }

    fn flush(&mut self) -> io::Result<()> {
        self.attempt((), W::flush)
    }
}

/// Returns the number of columns for tables and sentences on stdout: what the variable `COLUMNS` says, or else the width of the terminal;
/// `None` where stdout is no terminal, so that no line of a log or pipe is broken.
pub fn width() -> Option<usize> {
    let said = env::var("COLUMNS").ok().and_then(|said| said.parse().ok());
    let of_terminal = || terminal_size::terminal_size_of(io::stdout()).map(|(width, _)| usize::from(width.0));
    said.filter(|columns| *columns > 0).or_else(of_terminal)
}

/// Writes a value as JSON in one line.
///
/// # Errors
/// Errors of writing to `out`.
pub fn json_line(out: &mut dyn Write, value: &impl Serialize) -> io::Result<()> {
    serde_json::to_writer(&mut *out, value)?;
    writeln!(out)
}

/// Removes the keys of an object that have no value.
pub fn without_nulls(mut object: Json) -> Json {
    if let Some(keys) = object.as_object_mut() {
        keys.retain(|_, value| !value.is_null());
    }
    object
}

/// Writes an error and its causes to stderr.
pub fn error(error: &anyhow::Error) {
    let causes: Vec<String> = error.chain().map(ToString::to_string).collect();
    // A closed stderr is no reason to fail.
    let _ = writeln!(anstream::stderr(), "{BAD}error:{BAD:#} {}", causes.join(": "));
}

/// Writes a note to stderr.
pub fn note(text: impl Display) {
    // A closed stderr is no reason to fail.
    let _ = writeln!(anstream::stderr(), "{BOLD}note:{BOLD:#} {text}");
}
