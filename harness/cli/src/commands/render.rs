//! `stickler render`: prints one file in normal form.

use crate::arguments::SourceArguments;
use crate::exit::Exit;
use crate::{snippet, source_file};
use std::io::Write;
use stickler_syntax::decoding::decode;

/// Prints the normalized source; for a file that cannot be parsed, writes the diagnostics to stderr.
///
/// # Errors
/// A file that cannot be read.
pub fn execute(arguments: &SourceArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let (bytes, path) = source_file::read(&arguments.file)?;
    let (text, broken) = decode(&bytes);
    // Bytes that are no text were replaced; printing the replacement as the source would hide that.
    let rendered = match broken.is_empty() {
        true => stickler_reference::render(&text, arguments.dialect),
        false => Err(stickler_reference::check_bytes(&bytes, arguments.dialect).1),
    };
    match rendered {
        Ok(rendered) => {
            out.write_all(rendered.as_bytes())?;
            Ok(Exit::AsExpected)
        }
        Err(diagnostics) => {
            snippet::write(&diagnostics, &text, |_| (&path, 0), &mut anstream::stderr())?;
            Ok(Exit::Failures)
        }
    }
}
