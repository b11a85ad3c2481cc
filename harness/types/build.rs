//! Puts two folders of data into the crate: the files of the documented dialects, every `conformance-cases/dialects/*.toml` in the order
//! of their key `order`, with a constant for the name of each; and the pages of the diagnostic codes, every `codes/*.md`.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

fn main() -> io::Result<()> {
    let dialects = read("../../conformance-cases/dialects", "toml")?.into_iter();
    let mut dialects: Vec<_> = dialects.map(|(path, text)| (order(&text), path)).collect();
    dialects.sort();
    write("dialects.rs", &source(&dialects).map_err(io::Error::other)?)?;
    let pages = read("codes", "md")?;
    let codes = pages.iter().map(|(path, page)| code(path, page));
    let codes = codes.collect::<io::Result<String>>()?;
    write("codes.rs", &format!("codes! {{\n{codes}}}\n"))
}

/// Returns the paths and texts of the files with an extension in a folder of the crate, by path.
fn read(folder: &str, extension: &str) -> io::Result<Vec<(PathBuf, String)>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    println!("cargo::rerun-if-changed={}", folder.display());
    let mut files = Vec::new();
    for entry in fs::read_dir(&folder)? {
        let path = entry?.path();
        if path.extension().is_some_and(|own| own == extension) {
            println!("cargo::rerun-if-changed={}", path.display());
            files.push((path.clone(), fs::read_to_string(&path)?));
        }
    }
    files.sort();
    Ok(files)
}

fn write(file: &str, text: &str) -> io::Result<()> {
    fs::write(
        Path::new(&env::var_os("OUT_DIR").unwrap_or_default()).join(file),
        text,
    )
}

/// Returns the line of a diagnostic code: its number and its name, which its page has in the heading.
fn code(path: &Path, page: &str) -> io::Result<String> {
    let heading = page.lines().next().and_then(|line| line.strip_prefix("# "));
    let heading = heading.filter(|heading| {
        path.file_stem()
            .is_some_and(|code| heading.split(' ').next() == code.to_str())
    });
    let wrong = || {
        io::Error::other(format!(
            "{}: the first line must be `# CODE NAME`",
            path.display()
        ))
    };
    heading
        .map(|heading| format!("    {heading},\n"))
        .ok_or_else(wrong)
}

/// Returns the number behind `order =`; files without one come last.
fn order(text: &str) -> u32 {
    let mut lines = text
        .lines()
        .filter_map(|line| line.strip_prefix("order")?.trim_start().strip_prefix('='));
    let number = lines.next().and_then(|number| number.trim().parse().ok());
    number.unwrap_or(u32::MAX)
}

/// Returns the table of the files, and the constants.
fn source(files: &[(u32, PathBuf)]) -> Result<String, std::fmt::Error> {
    let (mut table, mut constants) = (String::new(), String::new());
    for (index, (_, path)) in files.iter().enumerate() {
        let name = path
            .file_stem()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        writeln!(
            table,
            "    ({name:?}, include_str!({:?})),",
            path.display().to_string()
        )?;
        let constant = name.to_uppercase().replace('-', "_");
        writeln!(constants, "    /// The dialect `{name}`.")?;
        writeln!(
            constants,
            "    pub const {constant}: DialectName = DialectName({index});"
        )?;
    }
    let length = files.len();
    Ok(format!(
        "/// The name and the file of each documented system.\nconst EMBEDDED: [(&str, &str); {length}] = [\n{table}];\n\n\
         impl DialectName {{\n{constants}}}\n"
    ))
}
