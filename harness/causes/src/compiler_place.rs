//! The place in the source of a compiler at which it says that it crashed, or that something is not implemented.

use stickler_run::Fact;

/// The extensions of the source files of compilers.
const SOURCE_FILES: [&str; 12] = [
    "c", "cc", "cpp", "cxx", "h", "hpp", "rs", "go", "java", "cs", "js", "ts",
];

/// Returns the file, without its folders, and the line that a compiler names where it crashes or does not go on, as in
/// `vm/src/stack.rs:62:46`, `codegen/src/call.rs#L873` and `in file parse.cc at line 400`; `None` where it names none.
pub(crate) fn compiler_place(got: &[Fact]) -> Option<String> {
    let reason = got.iter().find_map(|fact| match fact {
        Fact::Crashed { reason } | Fact::NotImplemented { reason, .. } => Some(reason.replace("#L", ":")),
        _ => None,
    })?;
    let trimmed = |word: &str| word.trim_matches(|sign: char| !sign.is_alphanumeric()).to_owned();
    let words: Vec<String> = reason.split_whitespace().map(trimmed).collect();
    let is_number = |word: &&str| !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
    words.iter().enumerate().find_map(|(at, word)| {
        let mut parts = word.split(':');
        let file = parts.next()?.rsplit('/').next()?;
        let (_, extension) = file.rsplit_once('.')?;
        SOURCE_FILES.contains(&extension).then_some(())?;
        let behind = words[at + 1..].iter().take(3).map(String::as_str);
        let mut named = behind.skip_while(|word| *word != "line").skip(1).take(1);
        let line = parts.next().filter(is_number).or_else(|| named.find(is_number))?;
        Some(format!("{file}:{line}"))
    })
}
