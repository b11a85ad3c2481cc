//! Puts data into the crate: the files of the documented dialects, every `conformance-cases/dialects/*.toml` in the order
//! of their key `order`, with a constant for the name of each; the pages of the diagnostic codes, every `codes/*.md`; and the choices of dialects and their options, `choices.toml` and `options.toml`.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs, io};
use toml::Spanned;

fn main() -> io::Result<()> {
    let dialects = read("../../conformance-cases/dialects", "toml")?.into_iter();
    let mut dialects: Vec<_> = dialects.map(|(path, text)| (order(&text), path)).collect();
    dialects.sort();
    write("dialects.rs", &source(&dialects).map_err(io::Error::other)?)?;
    let pages = read("codes", "md")?;
    let codes = pages.iter().map(|(path, page)| code(path, page));
    let codes = codes.collect::<io::Result<String>>()?;
    write("codes.rs", &format!("codes! {{\n{codes}}}\n"))?;
    let enumerations: BTreeMap<String, Enumeration> = tables("options.toml")?;
    write("options.rs", &enumerations.iter().map(words).collect::<String>())?;
    let tables: BTreeMap<String, ChoiceTable> = tables("choices.toml")?;
    for (macro_name, names) in [
        ("language_choices", &["flags", "language", "operators"][..]),
        ("conversion_choices", &["conversions"]),
        ("documents", &["documents"]),
    ] {
        let choices = names.iter().map(|name| choices(name, &tables[*name]));
        let choices: String = choices.collect();
        write(
            &format!("{macro_name}.rs"),
            &format!("{macro_name}! {{\n{choices}}}\n"),
        )?;
    }
    Ok(())
}

/// Reads a file of tables.
fn tables<T: DeserializeOwned>(file: &str) -> io::Result<T> {
    println!("cargo::rerun-if-changed={file}");
    toml::from_str(&fs::read_to_string(file)?).map_err(|error| io::Error::other(format!("{file}: {error}")))
}

/// An enumeration of `options.toml`: its documentation, and that of each option by its word.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Enumeration {
    about: String,
    options: BTreeMap<Spanned<String>, String>,
}

/// Returns an enumeration as the macro `words` takes it, with the options in the order of the file.
fn words((name, Enumeration { about, options }): (&String, &Enumeration)) -> String {
    let option = |(word, about): (&str, &String)| {
        let parts = word.split('-').map(|part| part[..1].to_uppercase() + &part[1..]);
        format!("#[doc = {about:?}] {} = {word:?},\n", parts.collect::<String>())
    };
    let options: String = in_order(options).map(option).collect();
    format!("words! {{ #[doc = {about:?}] {name} {{\n{options}}} }}\n")
}

/// Returns the entries of a table in the order of the file.
fn in_order<T>(table: &BTreeMap<Spanned<String>, T>) -> impl Iterator<Item = (&str, &T)> {
    let mut entries: Vec<_> = table.iter().collect();
    entries.sort_by_key(|(key, _)| key.span().start);
    entries
        .into_iter()
        .map(|(key, entry)| (key.get_ref().as_str(), entry))
}

/// A table of `choices.toml`.
type ChoiceTable = BTreeMap<Spanned<String>, ChoiceEntry>;

/// A choice, as `choices.toml` says at its beginning.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChoiceEntry {
    about: String,
    basis: Option<String>,
    field: Option<String>,
    flag: Option<String>,
    r#type: Option<String>,
    default: Option<String>,
}

/// Returns the choices of a table as the macro `choices` takes them, in the order of the file.
fn choices(table: &str, entries: &ChoiceTable) -> String {
    let choice = |(key, entry): (&str, &ChoiceEntry)| {
        let basis = entry.basis.iter().map(|basis| format!("\n\nBasis: {basis}."));
        let about = entry.about.clone() + &basis.collect::<String>();
        let field = entry.field.clone().unwrap_or_else(|| key.replace('-', "_"));
        let ty = entry.r#type.as_deref().unwrap_or("bool");
        let default = entry.default.as_deref().unwrap_or("false");
        let flag = entry.flag.iter().map(|flag| format!("\"flags.{flag}\", "));
        let keys = flag.collect::<String>() + &format!("\"{table}.{key}\"");
        format!("    #[doc = {about:?}]\n    {field}: {ty} = {default}, [{keys}];\n")
    };
    in_order(entries).map(choice).collect()
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
    match heading.filter(|heading| heading.split(' ').next() == Some(stem(path))) {
        Some(heading) => Ok(format!("    {heading},\n")),
        None => Err(io::Error::other(format!(
            "{}: the first line must be `# CODE NAME`",
            path.display()
        ))),
    }
}

/// Returns the name of a file without its extension.
fn stem(path: &Path) -> &str {
    path.file_stem()
        .and_then(|name| name.to_str())
        .unwrap_or_default()
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
        let name = stem(path);
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
