//! Serves an engine over the wire protocol: each line is answered in order, and only `bye` ends the conversation.

use super::lines::{Line, next_line};
use super::{MAX_LINE, Reply, Request, answer};
use crate::{Engine, EngineSession, Outcome};
use std::io::{self, BufRead, Write};

/// Answers requests until `bye` or the end of the input. Every reply is flushed as it is written; a malformed line is answered
/// by an error (with the request's `id` where it can be read); blank lines are ignored; memory is bounded by [`MAX_LINE`] and
/// what the engine needs for one program. Basis: harness/engines/README.md (the wire protocol).
///
/// # Errors
/// Errors of `input` and `output`, and of an engine of which no session can be opened.
pub fn serve(engine: &dyn Engine, input: impl BufRead, output: impl Write) -> io::Result<()> {
    serve_lines(engine, input, output, MAX_LINE)
}

fn serve_lines(
    engine: &dyn Engine,
    mut input: impl BufRead,
    mut output: impl Write,
    limit: usize,
) -> io::Result<()> {
    let mut buffer = Vec::new();
    let mut session = EngineSession::open(engine).map_err(io::Error::other)?;
    loop {
        let answer = match next_line(&mut input, &mut buffer, limit)? {
            Line::End => return Ok(()),
            Line::TooLong => ServerAnswer::Reply(Reply::error(
                None,
                format!("the line is longer than {limit} bytes"),
            )),
            Line::Whole => answer(&mut session, &buffer)?,
        };
        match answer {
            ServerAnswer::Nothing => {}
            ServerAnswer::Farewell => return Ok(()),
            ServerAnswer::Reply(reply) => send(&mut output, &reply)?,
        }
    }
}

enum ServerAnswer {
    Nothing,
    Farewell,
    Reply(Reply),
}

/// Answers one line.
///
/// # Errors
/// An error where the engine crashed over an earlier line and no session can be opened any more.
fn answer(session: &mut EngineSession<'_>, line: &[u8]) -> io::Result<ServerAnswer> {
    // Some shells put a byte-order mark in front of what they pipe.
    let line = line.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(line).trim_ascii();
    if line.is_empty() {
        return Ok(ServerAnswer::Nothing);
    }
    let (id, outcome) = match serde_json::from_slice::<Request>(line) {
        Ok(Request::Bye) => return Ok(ServerAnswer::Farewell),
        Ok(Request::Hello { protocol }) => {
            let reply = answer::hello(session.engine().identity(), protocol);
            return Ok(ServerAnswer::Reply(reply));
        }
        Ok(Request::Run(request)) => (request.id, answer::run(&request, |run| session.run(run))),
        Ok(Request::Check(request)) => (
            request.id,
            answer::program(&request, |dialect, source| session.check(dialect, source)),
        ),
        Ok(Request::Render(request)) => (
            request.id,
            answer::program(&request, |dialect, source| session.render(dialect, source)),
        ),
        Err(error) => {
            return Ok(ServerAnswer::Reply(Reply::error(
                readable_id(line),
                error.to_string(),
            )));
        }
    };
    let outcome = match outcome {
        Ok(outcome) => outcome.map_err(io::Error::other)?,
        Err(message) => Outcome::Error { message },
    };
    Ok(ServerAnswer::Reply(Reply::from_outcome(id, outcome)))
}

fn send(output: &mut impl Write, reply: &Reply) -> io::Result<()> {
    let mut line = serde_json::to_vec(reply)?;
    line.push(b'\n');
    output.write_all(&line)?;
    output.flush()
}

/// Returns the `id` of a line that is no request but a JSON object all the same.
fn readable_id(line: &[u8]) -> Option<u64> {
    serde_json::from_slice::<serde_json::Value>(line)
        .ok()?
        .get("id")?
        .as_u64()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_is_too_long_is_an_error_and_the_next_is_answered() {
        let hello = "{\"type\":\"hello\",\"protocol\":1}\n";
        let input = format!(
            "{{\"type\":\"check\",\"source\":\"{}\"}}\n{hello}",
            "x".repeat(1000)
        );
        let mut output = Vec::new();
        serve_lines(&crate::Reference::new(), input.as_bytes(), &mut output, 100).unwrap();
        let replies: Vec<Reply> = output
            .split(|&byte| byte == b'\n')
            .filter_map(|line| serde_json::from_slice(line).ok())
            .collect();
        assert_eq!(replies.len(), 2);
        assert_eq!(
            replies[0],
            Reply::error(None, "the line is longer than 100 bytes")
        );
        assert!(matches!(replies[1], Reply::Hello(_)));
    }

    #[test]
    fn an_output_that_is_gone_ends_the_serving_with_an_error() {
        struct Gone;
        impl Write for Gone {
            fn write(&mut self, _: &[u8]) -> io::Result<usize> {
                Err(io::ErrorKind::BrokenPipe.into())
            }
            fn flush(&mut self) -> io::Result<()> {
                Ok(())
            }
        }
        let input = "{\"type\":\"hello\",\"protocol\":1}\n".repeat(2);
        let error = serve(&crate::Reference::new(), input.as_bytes(), Gone).unwrap_err();
        assert_eq!(error.kind(), io::ErrorKind::BrokenPipe);
    }
}
