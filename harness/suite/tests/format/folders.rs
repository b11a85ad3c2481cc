//! Small suites in temporary folders.

use std::path::Path;

use stickler_mdtest::Example;
use stickler_suite::Suite;

/// The `dialects.toml` of every test suite, with two groups of the real suite.
const DIALECTS: &str = "[groups]\nironplc = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\"]\n\
    all = [\"ironplc-ed2\", \"ironplc-ed3\", \"ironplc-rusty\", \"matiec\", \"plcnext\"]\n";

/// The sources that files cite, each of which speaks for all dialects, with their sections.
const SOURCES: [(&str, &str); 5] = [
    ("b", "['c', 'd', 'cells']"),
    ("iec-61131-3", "'clauses'"),
    ("forgeiec-conversion-functions", "['Range and precision']"),
    ("ironplc-type-conversions", "['Integer widening']"),
    ("implicit-conversion-table", "'cells'"),
];

/// Writes `text` to `path` below `root`.
pub fn write(root: &Path, path: &str, text: impl AsRef<[u8]>) {
    let path = root.join(path);
    std::fs::create_dir_all(path.parent().unwrap()).unwrap();
    std::fs::write(path, text).unwrap();
}

/// Returns a folder `cases` with these files, and with `suite.toml`, `dialects.toml`, READMEs, and a `sources.toml` that has those of
/// [`SOURCES`] that the files cite.
pub fn folder(files: &[(&str, &str)]) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let root = folder.path().join("cases");
    let is_cited = |(key, _): &(&str, &str)| files.iter().any(|(_, text)| text.contains(&format!("{key}: ")));
    let source = |(key, sections)| {
        format!(
            "[{key}]\ntitle = 't'\npublisher = 'p'\nrelation = 'maker'\nkind = 'standard'\naddress = 'https://example.org'\nread = '1'\n\
             sections = {sections}\n"
        )
    };
    let sources: String = SOURCES.into_iter().filter(is_cited).map(source).collect();
    write(&root, "suite.toml", "version = \"1.2.3\"\n");
    write(&root, "dialects.toml", DIALECTS);
    write(&root, "sources.toml", sources);
    write(&root, "README.md", "");
    for (path, text) in files {
        write(&root, path, text);
        if let Some((area, _)) = path.split_once('/') {
            write(&root, &format!("{area}/README.md"), "");
        }
    }
    folder
}

/// Returns the files of an example: its inputs that are named by a path.
pub fn files(example: &Example) -> Vec<(&str, &str)> {
    let is_file = |name: &str| {
        [".st", ".toml", ".md", ".txt", ".swp"]
            .iter()
            .any(|end| name.ends_with(end))
    };
    example.inputs().filter(|(name, _)| is_file(name)).collect()
}

/// Returns the suite of these files.
pub fn load(files: &[(&str, &str)]) -> Suite {
    Suite::load(&folder(files).path().join("cases"))
}
