//! `stickler run --watch`: after the run, runs the cases of each case file that changes, until Ctrl-C.

use crate::case_folder::{CaseFolder, Loaded};
use crate::exit::Exit;
use crate::output;
use anyhow::{Context, bail};
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::BTreeSet;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::time::Duration;
use stickler_engines::Engine;
use stickler_report::{Overview, terminal};
use stickler_run::{AnswerStore, Plan, select};
use stickler_suite::{FileKind, RECORDINGS};
use stickler_workers::Cancellation;

/// The time without a change after which the files that changed are read: editors write a file in several steps.
const SETTLED: Duration = Duration::from_millis(100);

/// The time between two looks at whether Ctrl-C was pressed.
const POLL: Duration = Duration::from_millis(100);

/// The files that cases of all other files may depend on.
const SHARED: [&str; 6] = [
    "suite.toml",
    "dialects.toml",
    "sources.toml",
    "features.toml",
    "places.toml",
    "rules.md",
];

/// The run whose cases are run again.
pub struct CaseWatch<'w> {
    /// The folder of the cases.
    pub folder: &'w CaseFolder,
    /// The plan of the run; its baselines are not used, since most of their entries are about other files.
    pub plan: Plan,
    /// The engines of the run.
    pub engines: &'w [&'w dyn Engine],
    /// The answers that are known of each engine.
    pub stores: &'w [Option<&'w dyn AnswerStore>],
    /// The maximum number of failures that are shown whole.
    pub failures: Option<usize>,
    /// The cancellation that Ctrl-C requests.
    pub cancel: &'w Cancellation,
}

impl CaseWatch<'_> {
    /// Watches the folder of cases until Ctrl-C, and returns the exit code for that.
    ///
    /// # Errors
    /// A folder that cannot be watched, an engine that cannot be run any more, or an error of writing to `out`.
    pub fn watch(&self, out: &mut dyn Write) -> anyhow::Result<Exit> {
        let root = self.folder.path.canonicalize();
        let root = root.with_context(|| format!("cannot watch {}", self.folder.path.display()))?;
        let (send, changes) = mpsc::channel();
        let mut watcher: RecommendedWatcher = notify::recommended_watcher(send)?;
        watcher
            .watch(&root, RecursiveMode::Recursive)
            .with_context(|| format!("cannot watch {}", self.folder.path.display()))?;
        let shown = self.folder.path.display();
        writeln!(out, "\nWatching {shown} for changed case files; Ctrl-C ends.")?;
        out.flush()?;
        while let Some(changed) = self.next_changes(&root, &changes)? {
            self.step(&changed, out)?;
            out.flush()?;
        }
        Ok(Exit::Interrupted)
    }

    /// Waits for changes, and returns the changed files, relative to the folder of cases; `None` after Ctrl-C. Where the system lost
    /// changes, says so on stderr.
    ///
    /// # Errors
    /// The folder is watched no more.
    fn next_changes(
        &self,
        root: &Path,
        changes: &Receiver<notify::Result<notify::Event>>,
    ) -> anyhow::Result<Option<BTreeSet<PathBuf>>> {
        let mut changed = BTreeSet::new();
        while !self.cancel.is_requested() {
            match changes.recv_timeout(if changed.is_empty() { POLL } else { SETTLED }) {
                Ok(Ok(event)) if event.need_rescan() => {
                    output::note("some changes were missed; start again to run all cases")
                }
                // Reading a file is no change.
                Ok(Ok(event)) if !event.kind.is_access() => {
                    let below = event.paths.iter().filter_map(|path| path.strip_prefix(root).ok());
                    changed.extend(below.map(Path::to_owned));
                }
                Ok(Ok(_)) => {}
                Ok(Err(error)) => output::note(format_args!("a change was missed: {error}")),
                Err(RecvTimeoutError::Timeout) if changed.is_empty() => {}
                Err(RecvTimeoutError::Timeout) => return Ok(Some(changed)),
                Err(RecvTimeoutError::Disconnected) => {
                    bail!("{} is watched no more", self.folder.path.display())
                }
            }
        }
        Ok(None)
    }

    /// Runs the cases of changed files, given relative to the folder of cases, and shows their verdicts. Mistakes in a file are reported
    /// on stderr, and the sound cases of the file are run all the same. Files that are no case files are passed over.
    ///
    /// # Errors
    /// An engine that cannot be run any more, or an error of writing to `out`.
    pub fn step(&self, changed: &BTreeSet<PathBuf>, out: &mut dyn Write) -> anyhow::Result<()> {
        for below in changed {
            let name = below.to_string_lossy().replace('\\', "/");
            let path = self.folder.path.join(below);
            let shown = path.display();
            match case_file(&name) {
                _ if SHARED.contains(&&*name) => writeln!(
                    out,
                    "\n{shown} changed; all cases may depend on it: start again to run them"
                )?,
                None => {}
                Some(_) if !path.is_file() => writeln!(out, "\n{shown} is gone")?,
                Some((id, kind)) => {
                    writeln!(out, "\n{shown} changed")?;
                    // What is on stderr belongs below this line.
                    out.flush()?;
                    self.rerun(id, kind, out)?;
                }
            }
            if self.cancel.is_requested() {
                break;
            }
        }
        Ok(())
    }

    /// Runs the cases of one file.
    fn rerun(&self, id: &str, kind: FileKind, out: &mut dyn Write) -> anyhow::Result<()> {
        let Loaded { suite, .. } = self.folder.load_file_for(&self.plan, id, kind)?;
        if select(&self.plan, &suite.cases).is_empty() {
            let why = match suite.cases.len() {
                0 => "it has no case",
                _ => "none of its cases is selected",
            };
            writeln!(out, "{why}")?;
            return Ok(());
        }
        let mut overview = Overview::default();
        let take = &mut |event| overview.take(&event);
        stickler_run::run_with(&self.plan, &suite, self.engines, self.stores, take, self.cancel)?;
        terminal::write_rerun(out, &overview, self.failures)?;
        Ok(())
    }
}

/// Returns the id and kind of a case file by its path below the folder of cases; `None` for recordings, hidden files, and all others.
fn case_file(name: &str) -> Option<(&str, FileKind)> {
    let is_hidden = name.split('/').any(|part| part.starts_with('.'));
    let is_recording = name.split('/').next() == Some(RECORDINGS);
    let (id, extension) = name.rsplit_once('.')?;
    let kinds = [FileKind::Program, FileKind::Table];
    let kind = kinds.into_iter().find(|kind| kind.extension() == extension)?;
    (!is_hidden && !is_recording).then_some((id, kind))
}

#[cfg(test)]
mod tests;
