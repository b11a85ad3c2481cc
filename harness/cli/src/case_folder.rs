//! Where the cases are, and what is wrong with them.

use crate::arguments::SelectionArguments;
use crate::exit::Exit;
use crate::output;
use crate::shell;
use anyhow::{Context, bail};
use std::env;
use std::path::{Path, PathBuf};
use stickler_run::{Filter, Plan, Shard};
use stickler_suite::Suite;

/// The name of the folder that is looked for.
const NAME: &str = "conformance-cases";

/// A folder of cases, found or named.
pub struct CaseFolder {
    /// The folder itself.
    pub path: PathBuf,
    /// Where `reports/` stands by default: beside a folder that was found, here where one was named.
    pub root: PathBuf,
}

impl CaseFolder {
    /// The folder that was named, or else `conformance-cases` in the current folder or the nearest above it.
    ///
    /// # Errors
    /// Where it is no folder, or none is found.
    pub fn locate(named: Option<&Path>) -> anyhow::Result<CaseFolder> {
        match named {
            Some(path) if path.is_dir() => Ok(CaseFolder {
                path: path.to_owned(),
                root: PathBuf::new(),
            }),
            Some(path) if path.exists() => bail!("{} is no folder", path.display()),
            Some(path) => bail!("there is no folder {}", path.display()),
            None => CaseFolder::search(&env::current_dir().context("cannot tell the current folder")?),
        }
    }

    fn search(here: &Path) -> anyhow::Result<CaseFolder> {
        let Some(root) = here.ancestors().find(|folder| folder.join(NAME).is_dir()) else {
            bail!("there is no folder {NAME} here or above; name one with --cases DIR")
        };
        // Paths are shown, so a short one is better.
        let root = if root == here {
            PathBuf::new()
        } else {
            root.to_owned()
        };
        Ok(CaseFolder {
            path: root.join(NAME),
            root,
        })
    }

    /// Reads the cases, and says on stderr what is wrong with their files.
    pub fn load(&self) -> Suite {
        let suite = Suite::load(&self.path);
        for error in &suite.errors {
            output::complain(&anyhow::anyhow!("{error}"));
        }
        if !suite.errors.is_empty() {
            let number = suite.errors.len();
            let mistakes = if number == 1 { "mistake" } else { "mistakes" };
            output::note(format!(
                "{number} {mistakes} in case files; the rest of the cases is used"
            ));
        }
        suite
    }
}

/// What broken case files mean for the exit code.
pub fn exit_of(suite: &Suite) -> Exit {
    if suite.errors.is_empty() {
        Exit::AsExpected
    } else {
        Exit::Usage
    }
}

/// Says that the filters left no case, and gives the exit code for it.
pub fn nothing_selected(suite: &Suite) -> Exit {
    let error = match suite.cases.len() {
        0 => anyhow::anyhow!("no case is selected: there are none"),
        number => anyhow::anyhow!("no case is selected: none of {number} fits; `stickler list` lists them"),
    };
    output::complain(&error);
    Exit::NothingTested.worst(exit_of(suite))
}

/// The plan that selects the cases which were asked for.
pub fn plan(selection: &SelectionArguments, shard: Option<Shard>) -> Plan {
    let mut rerun_prefix = format!("{} run", shell::program());
    if let Some(folder) = &selection.cases {
        rerun_prefix.push_str(" --cases ");
        rerun_prefix.push_str(&shell::quote(&folder.to_string_lossy()));
    }
    Plan {
        filters: selection
            .filter
            .iter()
            .map(|text| Filter::new(text.as_str()))
            .collect(),
        dialects: selection.dialect.clone(),
        shard,
        rerun_prefix,
        ..Plan::default()
    }
}
