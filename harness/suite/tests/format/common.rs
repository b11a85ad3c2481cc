//! Helpers that write a small suite to a temporary folder.

use std::path::Path;

use stickler_suite::{Case, Suite};

/// The `dialects.toml` of every test suite, with two groups of the real suite.
pub const DIALECTS: &str = "[groups]\nironplc = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\"]\n\
    all = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\", \"matiec\", \"plcnext\"]\n";

/// The `sources.toml` of a test suite, with those sources that its files cite: each speaks for all dialects.
pub fn sources(files: &[(&str, &str)]) -> String {
    let sources = [
        ("b", "['c', 'd', 'cells']"),
        ("iec-61131-3", "'clauses'"),
        ("forgeiec-conversion-functions", "['Range and precision']"),
        ("ironplc-type-conversions", "['Integer widening']"),
        ("implicit-conversion-table", "'cells'"),
    ];
    let source = |(key, sections)| {
        format!(
            "[{key}]\ntitle = 't'\npublisher = 'p'\nkind = 'standard'\naddress = 'https://example.org'\nread = '1'\n\
             sections = {sections}\n"
        )
    };
    let is_cited = |(key, _): &(&str, &str)| {
        let basis = format!("{key}: ");
        files.iter().any(|(_, text)| text.contains(&basis))
    };
    let cited = sources.into_iter().filter(is_cited);
    cited.map(source).collect()
}

/// Writes `text` to `path` below `root`.
pub fn write(root: &Path, path: &str, text: impl AsRef<[u8]>) {
    let path = root.join(path);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// A folder `cases` with these files, and with `suite.toml`, `dialects.toml`, `sources.toml` and READMEs.
pub fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("cases");
    write(&root, "suite.toml", "version = \"1.2.3\"\n");
    write(&root, "dialects.toml", DIALECTS);
    write(&root, "sources.toml", sources(files));
    write(&root, "README.md", "");
    for (path, text) in files {
        write(&root, path, text);
        if let Some((area, _)) = path.split_once('/') {
            write(&root, &format!("{area}/README.md"), "");
        }
    }
    folder
}

/// The suite of these files.
pub fn load(files: &[(&str, &str)]) -> Suite {
    Suite::load(&folder(files).path().join("cases"))
}

/// The cases of one file without mistakes.
#[track_caller]
pub fn cases(path: &str, text: &str) -> Vec<Case> {
    let suite = load(&[(path, text)]);
    assert!(suite.errors.is_empty(), "{}", suite.errors[0]);
    suite.cases
}

/// The mistakes of one file, as a person sees them, without the path.
pub fn mistakes(path: &str, text: &str) -> Vec<String> {
    let suite = load(&[(path, text)]);
    let prefix = format!("cases/{path}:");
    suite
        .errors
        .iter()
        .map(|error| error.to_string().trim_start_matches(&prefix).to_owned())
        .collect()
}

/// Asserts that a file has exactly one mistake, and that it begins and goes on like this.
#[track_caller]
pub fn one_mistake(path: &str, text: &str, line: u32, said: &str) {
    let mistakes = mistakes(path, text);
    assert!(mistakes.len() == 1, "{mistakes:#?}\n{text}");
    assert!(
        mistakes[0].starts_with(&format!("{line}: ")),
        "line {line}: {}",
        mistakes[0]
    );
    assert!(mistakes[0].contains(said), "{said}: {}", mistakes[0]);
}
