//! Tests what becomes of a compiler's output that is long, is not UTF-8 and holds markup.

use crate::common::{SUITE, output, text};
use std::fs;
use std::path::Path;

/// Prints an error of a hundred kilobytes for every program, with bytes that are no UTF-8 and with markup.
const COMPILER: &str = r#"printf '%s:1: error E1 \377\376 </script><img src=x onerror=alert(1)> <!-- & ' "$1"
head -c 100000 /dev/zero | tr '\0' x
echo
exit 1
"#;

const DESCRIPTION: &str = r#"[engines.hostile]
check = "sh {here}/compiler.sh {file}"
diagnostic = '^(?<file>[^:]+):(?<line>\d+): error (?<code>\w+) (?<message>.*)$'
dialects.ironplc-ed2 = ""
"#;

/// Returns the names and texts of the files of a folder and of the folders in it.
fn files(folder: &Path) -> Vec<(String, String)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder").flatten() {
        match entry.path() {
            path if path.is_dir() => found.extend(files(&path)),
            path => {
                let bytes = fs::read(&path).expect("a file");
                let name = entry.file_name().to_string_lossy().into_owned();
                found.push((name, String::from_utf8(bytes).expect("UTF-8")));
            }
        }
    }
    found
}

#[test]
fn huge_output_with_markup_and_wrong_bytes_is_cut_counted_and_shown_as_text() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("compiler.sh"), COMPILER).expect("a compiler");
    fs::write(folder.path().join("stickler.toml"), DESCRIPTION).expect("its description");
    let arguments = [
        "run",
        "--engine",
        "hostile",
        "--cases",
        SUITE,
        "--no-cache",
        "--annotate",
        "github",
    ];
    let run = output(folder.path(), &arguments);
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    let shown = text(&run.stdout) + &text(&run.stderr);
    assert!(
        shown.contains(" bytes more") && shown.len() < 100_000,
        "{}",
        shown.len()
    );
    let written = files(&folder.path().join("reports/latest"));
    for (name, text) in &written {
        assert!(text.len() < 300_000, "{name} has {} bytes", text.len());
    }
    let of = |name: &str| {
        let found = written.iter().find(|(other, _)| other == name);
        found.map(|(_, text)| text.as_str()).expect("the report")
    };
    for name in [
        "events.jsonl",
        "results.json",
        "junit.xml",
        "index.html",
        "summary.md",
    ] {
        let text = of(name);
        assert!(text.contains(" bytes more"), "{name} does not tell that it cuts");
        assert!(
            text.contains('\u{fffd}'),
            "{name} does not show that bytes are no UTF-8"
        );
    }
    for name in ["index.html", "junit.xml"] {
        assert!(
            !of(name).contains("<img src=x"),
            "{name} holds markup of the compiler"
        );
    }
    let mut marked = of("summary.md").lines().filter(|line| line.contains("<img"));
    assert!(
        marked.all(|line| line.starts_with("+ ") || line.contains("\\<img")),
        "summary.md holds markup that is neither escaped nor in a difference, which is code"
    );
}
