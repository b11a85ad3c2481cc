//! `stickler engine`: the reference over the wire protocol.

use crate::exit::Exit;
use anyhow::Context;
use std::io;
use stickler_engines::{Reference, protocol};

/// Answers requests on stdin until `bye` or its end.
///
/// # Errors
/// Where stdin or stdout fails.
pub fn execute() -> anyhow::Result<Exit> {
    // The server flushes each reply, so it gets the stream itself and not the gathering one.
    protocol::serve(&Reference::default(), io::stdin().lock(), io::stdout().lock())
        .context("the conversation broke off")?;
    Ok(Exit::AsExpected)
}
