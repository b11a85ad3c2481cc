//! Engines that are the reference with a planted error.

use stickler_engines::{ClosureEngine, RunRequest};

/// Returns the reference with a function replaced: `body` assigns `Wrong` from `x`, and may say `RIGHT` for the right result.
pub fn wrong(function: &str, from: &str, to: &str, body: &str) -> ClosureEngine<'static> {
    let body = body.replace("RIGHT", &format!("{function}(x)"));
    let call = format!(":= {function}(");
    let declared = format!("FUNCTION Wrong : {to}\nVAR_INPUT x : {from}; END_VAR\n{body}\nEND_FUNCTION\n");
    reading(move |source| format!("{declared}{}", source.replace(&call, ":= Wrong(")))
}

/// Returns the reference that reads another program than it is given.
pub fn reading<'f>(other: impl Fn(&str) -> String + Send + Sync + 'f) -> ClosureEngine<'f> {
    ClosureEngine::new("reference", move |reference, request| {
        let source = &other(request.source);
        reference.run(&RunRequest { source, ..*request })
    })
}
