//! `stickler import`: judges and reports results that were copied out of an editor, like a run of any engine.

use crate::arguments::{ImportArguments, SelectionArguments};
use crate::case_folder::CaseFolder;
use crate::commands::record;
use crate::exit::{self, Exit};
use crate::{baselines, output, run_plan, shell, source_file};
use anyhow::bail;
use std::io::Write;
use std::path::{Path, PathBuf};
use stickler_conversions::overview::Statements;
use stickler_conversions::recording::{Recording, RecordingBuilder};
use stickler_engines::{Ability, Grade, Identity, Outcome, Reference};
use stickler_export::{CopiedText, Export, Imported, MANIFEST};
use stickler_report::terminal::{self, Surroundings};
use stickler_report::{Overview, ReportError, Reports, events};
use stickler_run::{CaseJudge, Plan};
use stickler_suite::{Case, Suite};
use stickler_types::{DialectName, RecordingOrigin, counted};

/// Judges the copied results, writes the reports, and shows a summary.
///
/// # Errors
/// A folder that holds no export, a file that cannot be read, a baseline with a mistake, reports that cannot be written.
pub fn execute(arguments: &ImportArguments, out: &mut dyn Write) -> anyhow::Result<Exit> {
    let engine = engine(arguments)?;
    let export = Export::read(&export_folder(arguments))?;
    let mut recorder = Recorder::begin(arguments, export.dialect())?;
    let texts: Vec<CopiedText> = arguments
        .files
        .iter()
        .map(|file| source(file))
        .collect::<Result<_, _>>()?;
    // Without cases only the comparison with a baseline is not possible.
    let cases = CaseFolder::locate_any(arguments.cases.as_deref())?;
    let root = cases
        .as_ref()
        .map_or_else(PathBuf::new, |folder| folder.root.clone());
    let plan = plan(arguments, &export, &root, &engine)?;
    // A baseline is compared with all cases that the engine could be asked, not only with the exported ones.
    let suite = match (&cases, plan.baselines.is_empty()) {
        (Some(folder), false) => folder.load_with([export.dialect()]),
        (Some(folder), true) => folder.load_sources(),
        (None, false) => bail!("a baseline is about cases; say with --cases DIR where they are"),
        (None, true) => Suite::default(),
    };
    let baseline = plan.matched_baseline(&suite, &engine);
    let report = (!arguments.no_report).then(|| run_plan::report_folder(arguments.report.as_deref(), &root));
    let (imported, overview) = judged(
        &export,
        &texts,
        &CaseJudge {
            plan: &plan,
            suite: &suite,
            engine: &engine,
            lacks: None,
            baseline: baseline.as_ref(),
        },
        report.as_deref(),
        &mut |case, outcome| {
            if let Some(recorder) = &mut recorder {
                recorder.take(case, outcome);
            }
        },
    )?;
    let shown = report.map(|folder| folder.display().to_string());
    let around = Surroundings {
        reports: shown.as_deref(),
        width: output::width(),
        ..Surroundings::default()
    };
    terminal::write(out, &overview, around)?;
    if let Some(recorder) = recorder {
        recorder.finish(out)?;
    }
    // The parts that were not understood follow the summary.
    out.flush()?;
    tell(&imported, &export, &engine);
    Ok(exit(&imported))
}

/// Returns the identity of the compiler by the names on the command line. Its grade is [`Grade::Rejected`], since no adapter maps
/// its messages to a line of the case.
fn engine(arguments: &ImportArguments) -> anyhow::Result<Identity> {
    let name = arguments.engine_name.trim();
    if name.is_empty() || name == Reference::NAME {
        bail!("`{name}` is no name for a compiler that was imported; choose another with --engine-name");
    }
    Ok(Identity {
        name: name.to_owned(),
        version: arguments.engine_version.clone(),
        dialects: DialectName::ALL.to_vec(),
        abilities: vec![Ability::Check, Ability::Execute],
        grade: Grade::Rejected,
        lacks: Vec::new(),
    })
}

fn export_folder(arguments: &ImportArguments) -> PathBuf {
    if let Some(folder) = &arguments.export {
        return folder.clone();
    }
    let beside = arguments.files.first().and_then(|file| file.parent());
    match beside {
        Some(folder) if folder.join(MANIFEST).is_file() => folder.to_owned(),
        _ => PathBuf::from("."),
    }
}

fn source(file: &Path) -> anyhow::Result<CopiedText> {
    let (bytes, _) = source_file::read(file)?;
    if let Some(report) = events::recognize(&bytes) {
        bail!(
            "{} is {report}; import the text that was copied out of the compiler's editor, and run the cases again for a new report",
            file.display()
        );
    }
    Ok(CopiedText {
        name: file.display().to_string(),
        bytes,
    })
}

fn plan(
    arguments: &ImportArguments,
    export: &Export,
    root: &Path,
    engine: &Identity,
) -> anyhow::Result<Plan> {
    let baselines = match arguments.no_baseline {
        true => Vec::new(),
        false => baselines::load(&arguments.baseline, root, &[&engine.name])?,
    };
    // The folder is a new one, since the same would replace the existing pages.
    let again = match export.folder().file_name() {
        Some(name) => format!("{}-again", name.to_string_lossy()),
        None => "again".to_owned(),
    };
    let mut rerun_prefix = format!(
        "{} export {}{}",
        shell::program(),
        shell::quote(&again),
        run_plan::places(arguments.cases.as_deref())
    );
    for kind in export.with() {
        rerun_prefix.push_str(" --with ");
        rerun_prefix.push_str(kind.as_str());
    }
    Ok(Plan {
        baselines,
        rerun_prefix,
        // A page of one case runs the case again; no engine can be named there.
        asked_for: [(engine.name.clone(), Reference::NAME.to_owned())].into(),
        ..run_plan::plan(&SelectionArguments::default(), None)
    })
}

fn judged(
    export: &Export,
    texts: &[CopiedText],
    judge: &CaseJudge<'_>,
    report: Option<&Path>,
    answered: &mut dyn FnMut(&Case, &Outcome),
) -> Result<(Imported, Overview), ReportError> {
    // One program asks many cases at once, so no table of conversions belongs to it.
    let mut reports = Reports::create(report, Statements::default(), false)?;
    let sink = &mut |event| {
        reports.take(&event);
    };
    let imported = export.import(texts, judge, sink, answered);
    Ok((imported, reports.finish()?))
}

fn tell(imported: &Imported, export: &Export, engine: &Identity) {
    imported.notes.iter().for_each(output::note);
    // Basis: harness/docs/compilers-behind-an-editor.md.
    if imported.summary.totals.unexpected() > 0 {
        output::note(format!(
            "what is not as expected differs from {}, as its documents have it; it is no defect of {} by its own",
            export.dialect(),
            engine.name
        ));
    }
}

fn exit(imported: &Imported) -> Exit {
    let summary = &imported.summary;
    let judged = match summary.cases {
        0 => Exit::Usage,
        _ => exit::of_totals(&summary.totals, summary.outdated > 0),
    };
    judged.max(Exit::Usage.when(imported.unjudged > 0))
}

/// Gathers the answers for the file that `--record` names.
struct Recorder {
    path: PathBuf,
    older: Option<Recording>,
    builder: RecordingBuilder,
    title: String,
    /// The number of cases that ask nothing of what a recording holds.
    others: u64,
}

impl Recorder {
    /// Begins a recording; `None` where none is wanted.
    ///
    /// # Errors
    /// A product, version, platform or date that says nothing, or a file that is another recording.
    fn begin(arguments: &ImportArguments, dialect: DialectName) -> anyhow::Result<Option<Recorder>> {
        let Some(path) = arguments.record.clone() else {
            return Ok(None);
        };
        let text = |given: &Option<String>| given.as_deref().unwrap_or_default().trim().to_owned();
        let mut origin = RecordingOrigin {
            product: text(&arguments.product),
            version: text(&arguments.product_version),
            commit: None,
            platform: text(&arguments.platform),
            date: arguments.date.clone().unwrap_or_else(record::today),
        };
        if let Some(mistake) = origin.mistake() {
            bail!("nothing can be recorded: {mistake}");
        }
        let older = record::older(&path, &origin)?;
        // The copied texts are of the same version, and do not tell its commit.
        origin.commit = older.as_ref().and_then(|older| older.origin.commit.clone());
        let name = path
            .file_stem()
            .map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        Ok(Some(Recorder {
            older,
            title: format!("{} {}", origin.product, origin.version),
            builder: RecordingBuilder::new(&name, origin, dialect),
            path,
            others: 0,
        }))
    }

    /// Adds what the compiler did with a case.
    fn take(&mut self, case: &Case, outcome: &Outcome) {
        let observed = case.observe.first().map_or("", |observed| &*observed.name);
        let asked = case.question.as_deref();
        if !asked.is_some_and(|question| self.builder.take(question, observed, outcome)) {
            self.others += 1;
        }
    }

    /// Writes the file, and shows what is in it.
    ///
    /// # Errors
    /// No answer at all, or a file that cannot be written.
    fn finish(self, out: &mut dyn Write) -> anyhow::Result<()> {
        let shown = self.path.display().to_string();
        if self.builder.number() == 0 {
            bail!(
                "{shown} is not written: no result tells what a recording holds; `stickler export --recording` asks for it"
            );
        }
        let answers = counted(self.builder.number() as u64, "answer", "answers");
        let mut recording = self.builder.finish();
        let added = match self.older {
            Some(older) => {
                recording.complete_from(older);
                ", added to those that it had"
            }
            None => "",
        };
        record::write(&recording, &self.path)?;
        writeln!(out, "{shown}: {answers} of {}{added}", self.title)?;
        if self.others > 0 {
            let others = counted(self.others, "case asks", "cases ask");
            writeln!(
                out,
                "  {others} nothing that a recording holds, or showed no value"
            )?;
        }
        Ok(())
    }
}
