//! A compiler with defects that are described as data: it does what the reference does, but for them.

use serde::Deserialize;
use std::sync::Mutex;
use stickler_engines::{
    Ability, Engine, EngineError, Grade, Identity, NoReproduction, Outcome, Packed, Reproduction,
    ReproductionFile, RunRequest, Session,
};
use stickler_types::{Diagnostic, DialectName, Fault, Value};

/// The defects of a compiler, in the order in which they show.
#[derive(Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Defects {
    /// Texts that it takes for others.
    pub replaces: Vec<(String, String)>,
    /// Lines that it rejects.
    pub rejects: Vec<RejectedLine>,
    /// A text that it does not implement, and what it says then.
    pub lacks: Option<(String, String)>,
    /// A text at which it crashes, and what it says then.
    pub crashes: Option<(String, String)>,
    /// Texts in programs of which it makes what cannot be built, each with what a compiler of C says then. Of one with `…` all parts are there.
    pub unusable: Vec<(String, String)>,
    /// Whether it dies over each program with a mistake when that is run.
    pub dies_of_mistakes: bool,
    /// The codes of the mistakes that it does not see.
    pub accepts: Vec<String>,
    /// The code of a mistake beside which it tells no other, and nothing behind the first one where it is empty.
    pub tells_only: Option<String>,
    /// A code with which it reports each mistake once more.
    pub adds: Option<String>,
    /// Texts of lines about whose mistakes it says line 1, column 1; an empty text is in every line.
    pub loses_places: Vec<String>,
    /// A text at which it stops when it runs the program, and what it says then.
    pub stops: Option<(String, String)>,
    /// Values that it computes wrongly.
    pub computes: Vec<WrongValue>,
    /// Texts that it renders as others.
    pub renders: Vec<(String, String)>,
    /// Whether a loop that does not end takes all of its time.
    pub hangs: bool,
    /// The dialect in which alone it has them.
    pub only_in: Option<String>,
}

/// A kind of line that a compiler rejects.
#[derive(Clone, Default, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct RejectedLine {
    /// Texts of which such a line has one.
    pub with: Vec<String>,
    pub code: Option<String>,
    pub message: String,
    pub column: Option<u32>,
    /// Whether it says so once more, without a place.
    pub twice: bool,
}

/// The value of a variable, or of all variables of a type, in programs with one of some texts.
#[derive(Clone, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WrongValue {
    pub of: String,
    pub with: Vec<String>,
    pub is: String,
}

/// A compiler with defects, and the programs that it was asked to run, each behind a line with its dialect.
pub struct DefectiveCompiler {
    pub identity: Identity,
    pub defects: Defects,
    /// The interval at which programs with a text are rejected, whatever else they are; 0 stands for none.
    pub rejects_every: usize,
    pub rejects_where: &'static str,
    /// The number of programs after which it is too busy to answer in time.
    pub busy_after: usize,
    /// The number of programs that it takes together.
    pub pack_size: usize,
    pub asked: Mutex<Vec<String>>,
}

impl DefectiveCompiler {
    /// Creates a compiler that speaks two dialects and is judged by codes.
    pub fn new(defects: &Defects) -> DefectiveCompiler {
        DefectiveCompiler {
            identity: Identity {
                name: "defective".to_owned(),
                version: "1".to_owned(),
                dialects: vec![DialectName::IRONPLC_ED2, DialectName::IRONPLC_ED3],
                abilities: vec![Ability::Execute, Ability::Render],
                grade: Grade::Code,
                lacks: Vec::new(),
            },
            defects: defects.clone(),
            rejects_every: 0,
            rejects_where: "",
            busy_after: usize::MAX,
            pack_size: 1,
            asked: Mutex::default(),
        }
    }

    /// Returns the number of programs with a text that were run.
    pub fn number_asked(&self, text: &str) -> usize {
        let asked = self.asked.lock().expect("no test panics while it asks");
        asked.iter().filter(|source| source.contains(text)).count()
    }
}

impl Engine for DefectiveCompiler {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(self))
    }

    fn pack_size(&self) -> usize {
        self.pack_size
    }

    /// Returns the program and the names of what is observed.
    fn reproduce(&self, request: &RunRequest<'_>, _: Ability) -> Result<Reproduction, NoReproduction> {
        let observed: Vec<&str> = request.observe.iter().map(|one| &*one.name).collect();
        let file = |name: &str, text: &str| ReproductionFile {
            name: name.to_owned(),
            text: text.to_owned(),
        };
        Ok(Reproduction {
            files: vec![
                file("program.st", request.source),
                file("observed.txt", &observed.join(" ")),
            ],
            tools: Vec::new(),
            commands: vec!["echo shown".to_owned()],
        })
    }
}

impl Session for &DefectiveCompiler {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        let number = {
            let mut asked = self.asked.lock().expect("no test panics while it asks");
            asked.push(format!("{}\n{}", request.dialect, request.source));
            asked.len() - 1
        };
        match self.rejects_every {
            _ if number >= self.busy_after => Outcome::TimedOut { after_ms: 1000 },
            every
                if every > 0
                    && number.is_multiple_of(every)
                    && request.source.contains(self.rejects_where) =>
            {
                Outcome::rejected(vec![Diagnostic {
                    line: Some(1),
                    column: Some(1),
                    message: "the dice said no".to_owned(),
                    ..Diagnostic::default()
                }])
            }
            _ if self
                .defects
                .only_in
                .as_ref()
                .is_some_and(|only| only != request.dialect.as_str()) =>
            {
                Defects::default().run(request)
            }
            _ => self.defects.run(request),
        }
    }

    fn run_pack(&mut self, requests: &[RunRequest<'_>]) -> Vec<Packed> {
        let answered = requests.iter().map(|request| Packed::Answered(self.run(request)));
        answered.collect()
    }

    fn check(&mut self, dialect: DialectName, source: &str) -> Outcome {
        match self.defects.run(&RunRequest::once(dialect, source, &[])) {
            rejected @ Outcome::Rejected { .. } => rejected,
            _ => Outcome::ACCEPTED,
        }
    }

    fn render(&mut self, dialect: DialectName, source: &str) -> Outcome {
        if let Some(rejection) = self
            .defects
            .rejects
            .iter()
            .find_map(|line| line.rejection(source))
        {
            return rejection;
        }
        let text = match stickler_reference::render(source, dialect) {
            Ok(text) => text,
            Err(diagnostics) => return Outcome::rejected(diagnostics),
        };
        let mut replaced = self.defects.renders.iter();
        let text = replaced.find_map(|(from, into)| text.contains(from).then(|| text.replace(from, into)));
        Outcome::Rendered {
            text: text.unwrap_or_else(|| source.to_owned()),
        }
    }
}

impl RejectedLine {
    /// Returns what is said of a program that has such a line.
    fn rejection(&self, source: &str) -> Option<Outcome> {
        let is_such = |text: &str| self.with.iter().any(|with| text.contains(with));
        let (_, number) = source.lines().zip(1..).find(|(text, _)| is_such(text))?;
        let first = Diagnostic {
            line: Some(number),
            column: self.column,
            code: self.code.clone(),
            message: self.message.clone(),
            ..Diagnostic::default()
        };
        let again = Diagnostic {
            line: None,
            ..first.clone()
        };
        Some(Outcome::rejected(if self.twice {
            vec![first, again]
        } else {
            vec![first]
        }))
    }
}

impl Defects {
    fn run(&self, request: &RunRequest<'_>) -> Outcome {
        let reason = |defect: &Option<(String, String)>| {
            let found = defect.as_ref().filter(|(text, _)| request.source.contains(text));
            found.map(|(_, reason)| reason.clone())
        };
        if let Some(reason) = reason(&self.crashes) {
            return Outcome::Crashed { reason };
        }
        if let Some(reason) = reason(&self.lacks) {
            return Outcome::NotImplemented { reason };
        }
        let mut unusable = self.unusable.iter();
        let has_all = |text: &str| text.split('…').all(|part| request.source.contains(part));
        if let Some((_, reason)) = unusable.find(|(text, _)| has_all(text)) {
            let reason = reason.clone();
            return Outcome::Unusable { reason };
        }
        if let Some(outcome) = self
            .rejects
            .iter()
            .find_map(|line| line.rejection(request.source))
        {
            return outcome;
        }
        let replaced = self.replaces.iter();
        let source = replaced.fold(request.source.to_owned(), |source, (from, into)| {
            source.replace(from, into)
        });
        let request = RunRequest {
            source: &source,
            ..*request
        };
        let outcome = stickler_reference::run(&request, stickler_reference::Limits::default());
        self.changed(&source, outcome.expect("observed variables are there"))
    }

    /// Returns what this compiler makes of what the reference did.
    fn changed(&self, source: &str, outcome: Outcome) -> Outcome {
        match outcome {
            Outcome::Rejected { .. } if self.dies_of_mistakes => {
                Outcome::crashed("the virtual machine ended")
            }
            Outcome::Rejected { mut diagnostics } => {
                let is_seen = |reported: &Diagnostic| {
                    let code = reported.code.as_deref().unwrap_or_default();
                    !self.accepts.iter().any(|accepted| accepted == code)
                };
                diagnostics.retain(is_seen);
                let is_lost = |reported: &&mut Diagnostic| {
                    let line = reported.line.map_or(1, |line| line.max(1)) as usize;
                    let line = source.lines().nth(line - 1).unwrap_or_default();
                    self.loses_places.iter().any(|text| line.contains(text))
                };
                for reported in diagnostics.iter_mut().filter(is_lost) {
                    (reported.line, reported.column) = (Some(1), Some(1));
                }
                if let Some(only) = &self.tells_only {
                    let is_it = |one: &Diagnostic| only.is_empty() || one.code.as_ref() == Some(only);
                    let at = diagnostics.iter().position(is_it);
                    diagnostics = at.map_or(diagnostics.clone(), |at| vec![diagnostics.swap_remove(at)]);
                }
                if let Some(code) = &self.adds {
                    let mut added = diagnostics.clone();
                    for reported in &mut added {
                        reported.code = Some(code.clone());
                    }
                    diagnostics.extend(added);
                }
                match diagnostics.is_empty() {
                    true => Outcome::ACCEPTED,
                    false => Outcome::Rejected { diagnostics },
                }
            }
            Outcome::Faulted {
                fault: Fault::StepLimit,
                ..
            } if self.hangs => Outcome::TimedOut { after_ms: 1000 },
            Outcome::Executed { values, .. }
                if let Some((_, words)) = self.stops.as_ref().filter(|(text, _)| source.contains(text)) =>
            {
                let fault = Fault::reported(words);
                Outcome::Faulted {
                    fault,
                    line: None,
                    values,
                    warnings: Vec::new(),
                }
            }
            Outcome::Executed { mut values, .. } => {
                for (name, value) in &mut values {
                    let is_wrong = |wrong: &&WrongValue| {
                        (*name == wrong.of || value.type_name() == wrong.of)
                            && wrong.with.iter().any(|with| source.contains(with.as_str()))
                    };
                    if let Some(wrong) = self.computes.iter().find(is_wrong) {
                        *value = Value::parse(&wrong.is).expect("a literal");
                    }
                }
                Outcome::executed(values)
            }
            other => other,
        }
    }
}
