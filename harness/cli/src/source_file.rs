//! Reads source files as bytes, whatever their encoding; several of them as one program. Chooses which program of a text runs.

use anyhow::{Context, bail, ensure};
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::{Path, PathBuf};
use stickler_syntax::tree::PouKind;
use stickler_types::{Diagnostic, Dialect, DialectName};
use walkdir::WalkDir;

/// The name to show for stdin.
const STDIN: &str = "<stdin>";

/// Reads the bytes of a file, or of stdin where the path is `-`; also returns the name to show for it.
///
/// # Errors
/// A file or stdin that cannot be read.
pub fn read(path: &Path) -> anyhow::Result<(Vec<u8>, String)> {
    if path.as_os_str() == "-" {
        let mut bytes = Vec::new();
        io::stdin().read_to_end(&mut bytes).context("cannot read stdin")?;
        return Ok((bytes, STDIN.to_owned()));
    }
    let bytes = fs::read(path).with_context(|| format!("cannot read {}", path.display()))?;
    Ok((bytes, path.display().to_string()))
}

/// Returns the line and the column, both from 1, behind the bytes of a text; the column counts characters.
pub fn place(before: &[u8]) -> (usize, usize) {
    let line = before.iter().filter(|byte| **byte == b'\n').count() + 1;
    let of_line = before.rsplit(|byte| *byte == b'\n').next().unwrap_or_default();
    (line, String::from_utf8_lossy(of_line).chars().count() + 1)
}

/// Reads a text file; `None` where there is none.
///
/// # Errors
/// A file that cannot be read.
pub fn text_if_any(path: &Path) -> anyhow::Result<Option<String>> {
    match fs::read_to_string(path) {
        Ok(text) => Ok(Some(text)),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(error).with_context(|| format!("cannot read {}", path.display())),
    }
}

/// A program of one source file or several, whose texts stand one behind the other.
pub struct Program {
    /// The bytes of all files, each of which ends with its line.
    pub bytes: Vec<u8>,
    /// The name to show for each file, and the lines before it.
    files: Vec<(String, u32)>,
}

impl Program {
    /// Reads files, and of folders the files `*.st` in them and in their folders, in the order of their names.
    ///
    /// # Errors
    /// A file or folder that cannot be read; a folder without such files.
    pub fn read(paths: &[PathBuf]) -> anyhow::Result<Program> {
        let mut program = Program {
            bytes: Vec::new(),
            files: Vec::new(),
        };
        for path in paths {
            if !path.is_dir() {
                program.add(path)?;
                continue;
            }
            files_of(path)?.iter().try_for_each(|file| program.add(file))?;
        }
        Ok(program)
    }

    fn add(&mut self, path: &Path) -> anyhow::Result<()> {
        const BYTE_ORDER_MARK: &[u8] = b"\xEF\xBB\xBF";
        let (bytes, name) = read(path)?;
        // One sentence says more than a diagnostic for each stray byte. What is no text shows it at its beginning.
        let sample = &bytes[..bytes.len().min(4096)];
        let is_stray = |byte: &u8| *byte < b' ' && !b"\t\n\r\x0b\x0c\x1a".contains(byte);
        let mut strays = (0..).zip(sample).filter(|(_, byte)| is_stray(byte));
        let first = strays.next().map_or(0, |(at, _)| at);
        if strays.count() > sample.len() / 20 {
            let (line, column) = place(&bytes[..first]);
            bail!(
                "{name}:{line}:{column}: the byte 16#{:02X} begins what is no text; a program is text in UTF-8, so save it as such",
                bytes[first]
            );
        }
        if !self.bytes.is_empty() && !self.bytes.ends_with(b"\n") {
            self.bytes.push(b'\n');
        }
        let lines = self.bytes.iter().filter(|byte| **byte == b'\n').count();
        self.files.push((name, u32::try_from(lines)?));
        let is_first = self.files.len() == 1;
        let text = bytes.strip_prefix(BYTE_ORDER_MARK).filter(|_| !is_first);
        self.bytes.extend_from_slice(text.unwrap_or(&bytes));
        Ok(())
    }

    /// Returns the name of the file in which a line of the program stands, and the lines before the file.
    pub fn file_of(&self, line: u32) -> (&str, u32) {
        let (name, before) = &self.files[self.index_of(line)];
        (name, *before)
    }

    fn index_of(&self, line: u32) -> usize {
        self.files.partition_point(|(_, before)| *before < line).max(1) - 1
    }

    /// Returns what to call all of it: the only file, or the number of files.
    pub fn name(&self) -> String {
        match &self.files[..] {
            [(name, _)] => name.clone(),
            files => format!("{} files", files.len()),
        }
    }

    /// Writes a text of as many lines in place of the program into the files that it changes, and returns their number.
    ///
    /// # Errors
    /// A file that cannot be written, such as stdin.
    pub fn write(&self, text: &str) -> anyhow::Result<u64> {
        let mut written = 0_u64;
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let old = String::from_utf8_lossy(&self.bytes);
        let old: Vec<&str> = old.trim_start_matches('\u{feff}').split_inclusive('\n').collect();
        for (index, (name, before)) in self.files.iter().enumerate() {
            let end = self
                .files
                .get(index + 1)
                .map_or(lines.len(), |(_, lines)| *lines as usize);
            let of_file = *before as usize..end;
            let changed = lines
                .get(of_file.clone())
                .filter(|lines| old.get(of_file) != Some(lines));
            if let Some(lines) = changed {
                ensure!(name != STDIN, "stdin cannot be changed; name a file");
                fs::write(name, lines.concat()).with_context(|| format!("cannot write {name}"))?;
                written += 1;
            }
        }
        Ok(written)
    }

    /// Returns the diagnostics of each file, with lines of the file.
    pub fn by_file(&self, diagnostics: Vec<Diagnostic>) -> Vec<(&str, Vec<Diagnostic>)> {
        let mut files: Vec<(&str, Vec<Diagnostic>)> =
            self.files.iter().map(|(name, _)| (&**name, Vec::new())).collect();
        for mut diagnostic in diagnostics {
            let index = self.index_of(diagnostic.line.unwrap_or(1));
            let before = self.files[index].1;
            diagnostic.line = diagnostic.line.map(|line| line - before);
            diagnostic.end_line = diagnostic.end_line.map(|line| line - before);
            files[index].1.push(diagnostic);
        }
        files
    }
}

/// Returns the files `*.st` of a folder and of the folders in it, in the order of their names.
///
/// # Errors
/// A folder that cannot be read, or has no such file.
pub fn files_of(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let mut files = Vec::new();
    // A link to a folder could lead back here, and none is followed.
    for entry in WalkDir::new(folder).sort_by_file_name() {
        let path = entry
            .with_context(|| format!("cannot read {}", folder.display()))?
            .into_path();
        let is_source = path
            .extension()
            .is_some_and(|ending| ending.eq_ignore_ascii_case("st"));
        if is_source && path.is_file() {
            files.push(path);
        }
    }
    ensure!(!files.is_empty(), "no file of {} ends with .st", folder.display());
    Ok(files)
}

/// Returns a text with a configuration that runs a PROGRAM, in place of those that it has; their global variables stay where they are.
///
/// # Errors
/// No PROGRAM of this name.
pub fn running(text: &str, name: &str, dialect: DialectName) -> anyhow::Result<String> {
    let (unit, _) = stickler_syntax::parse(text, Dialect::of(dialect));
    let mut programs = unit.pous().filter(|pou| pou.kind == PouKind::Program);
    ensure!(
        programs.any(|pou| pou.name.is(name)),
        "there is no PROGRAM `{name}`"
    );
    let mut running = String::with_capacity(text.len());
    let blank = |text: &str| text.replace(|character| character != '\n', " ");
    let mut at = 0;
    for configuration in unit.configurations() {
        running.push_str(&text[at..configuration.span.start as usize]);
        at = configuration.span.start as usize;
        for globals in &configuration.globals {
            running.push_str(&blank(&text[at..globals.span.start as usize]));
            running.push_str(globals.span.text(text));
            at = globals.span.end as usize;
        }
        running.push_str(&blank(&text[at..configuration.span.end as usize]));
        at = configuration.span.end as usize;
    }
    running.push_str(&text[at..]);
    running.push_str(&format!(
        "\nCONFIGURATION stickler RESOURCE here ON this PROGRAM {name} : {name}; END_RESOURCE END_CONFIGURATION\n"
    ));
    Ok(running)
}
