//! Commands that can be pasted into a shell.

use std::borrow::Cow;
use std::env;

/// The argument as a POSIX shell takes it for one word.
pub fn quote(argument: &str) -> Cow<'_, str> {
    let safe = |byte: u8| byte.is_ascii_alphanumeric() || b"-_./:@=,+%".contains(&byte);
    if !argument.is_empty() && argument.bytes().all(safe) {
        return argument.into();
    }
    format!("'{}'", argument.replace('\'', r"'\''")).into()
}

/// Returns how the reader calls `stickler`: one who came by `cargo run` has no `stickler` to call.
pub fn program() -> &'static str {
    // Cargo tells the programs that it runs where their manifest is.
    let by_cargo = env::var_os("CARGO_MANIFEST_DIR").is_some_and(|folder| !folder.is_empty());
    match (by_cargo, cfg!(debug_assertions)) {
        (false, _) => "stickler",
        (true, false) => "cargo run --release --",
        (true, true) => "cargo run --",
    }
}

/// The command line of this process, to be pasted again.
pub fn command_line() -> String {
    let arguments: Vec<String> = env::args_os()
        .skip(1)
        .map(|a| a.to_string_lossy().into_owned())
        .collect();
    let mut line = String::from("stickler");
    for argument in &arguments {
        line.push(' ');
        line.push_str(&quote(argument));
    }
    line
}

#[cfg(test)]
mod tests {
    use super::quote;

    #[test]
    fn a_shell_takes_a_quoted_argument_for_one_word() {
        assert_eq!(
            quote("widening/integer@ironplc-ed2"),
            "widening/integer@ironplc-ed2"
        );
        assert_eq!(quote("a(INT,-1)"), "'a(INT,-1)'");
        assert_eq!(quote("it's"), r"'it'\''s'");
        assert_eq!(quote(""), "''");
        assert_eq!(quote("*"), "'*'");
    }
}
