//! Runs many programs in one text: `iec2c` and the C compiler start once for all of them.
//!
//! `iec2c` names the line of every semantic mistake, and the mistakes of one program hide those of no other: such programs are
//! rejected at once, and the others go on without them. Where it stops earlier, or its C cannot be built, the programs that are
//! named in errors are run alone. No program sees what another does when it runs.

use super::driver::{MatiecSubject, driver};
use super::{Matiec, diagnostics, execution};
use crate::adapters::locate::suspects;
use crate::adapters::probe_variable::{ProbeVariables, with_probes};
use crate::adapters::recipe::{Purpose, Workplace};
use crate::adapters::rename::{Renamed, declared, has_pack_suffix, pack_suffix, places_named};
use crate::adapters::rounds::{self, Round};
use crate::adapters::source::{MainProgram, main_program};
use crate::{Diagnostic, Outcome, Packed, RunRequest};
use std::borrow::Cow;
use std::collections::{BTreeMap, BTreeSet, HashSet};

/// A program that may stand among others.
struct PackMember<'r> {
    /// The place of the program among the requests.
    place: usize,
    request: RunRequest<'r>,
    probes: ProbeVariables,
    main: MainProgram,
    /// The names that must be made unique.
    names: HashSet<String>,
}

impl<'r> PackMember<'r> {
    fn of(place: usize, request: &RunRequest<'r>, taken: &HashSet<String>) -> Option<PackMember<'r>> {
        // Locations have no memory in common: see the driver.
        let names = declared(request, taken, true)?;
        let main = main_program(request)?;
        let probes = ProbeVariables::of(request);
        // Such a program may need more than one run.
        let copied_for_nothing = !probes.list().is_empty() && (main.returns || request.scans == 0);
        // The driver accesses variables by the names that they have in the program.
        let seen = request.observe.iter().map(|asked| &asked.name);
        let set = request.set.iter().map(|setting| &setting.name);
        let renamed = seen.chain(set).any(|path| names.contains(&base(path)));
        let fits = !(copied_for_nothing || renamed || has_pack_suffix(request.source));
        fits.then_some(PackMember {
            place,
            request: *request,
            probes,
            main,
            names,
        })
    }

    fn program(&self) -> String {
        format!("{}{}", self.main.name, pack_suffix(self.place))
    }

    /// Returns the text of the program with its probe variables, and with its names made unique.
    fn renamed(&self) -> Renamed {
        let text = match self.probes.list() {
            [] => Cow::Borrowed(self.request.source),
            probes => Cow::Owned(with_probes(self.request.source, &self.main, probes)),
        };
        let request = RunRequest {
            source: &text,
            ..self.request
        };
        Renamed::with_suffix(&request, &self.names, &pack_suffix(self.place))
    }
}

/// Returns the variable that a path begins with, in capitals.
fn base(path: &str) -> String {
    let end = path.find(['.', '[']).unwrap_or(path.len());
    path[..end].to_ascii_uppercase()
}

/// Several programs in one text, each with the number of the line before its first.
struct Joined {
    text: String,
    members: Vec<(u32, Renamed)>,
}

impl Joined {
    fn of(members: &[PackMember<'_>]) -> Joined {
        let mut joined = Joined {
            text: String::new(),
            members: Vec::with_capacity(members.len()),
        };
        let mut lines = 0;
        for member in members {
            let renamed = member.renamed();
            joined.text.push_str(&renamed.text);
            joined.text.push('\n');
            let before = lines;
            lines += u32::try_from(renamed.text.matches('\n').count() + 1).unwrap_or(u32::MAX);
            joined.members.push((before, renamed));
        }
        joined
    }

    /// Returns the number of the member that has this line; `None` for lines behind all of them.
    fn member(&self, line: u32) -> Option<usize> {
        let behind = self.members.partition_point(|(before, _)| *before < line);
        let number = behind.checked_sub(1)?;
        let (before, renamed) = &self.members[number];
        let lines = u32::try_from(renamed.text.matches('\n').count() + 1).unwrap_or(u32::MAX);
        (line - before <= lines).then_some(number)
    }

    /// Returns the outcomes of all members with the warnings about each.
    fn with_warnings(&self, outcomes: Vec<Outcome>, warnings: Vec<Diagnostic>) -> Vec<Outcome> {
        let mut own: BTreeMap<usize, Vec<Diagnostic>> = BTreeMap::new();
        for (number, warning) in warnings.into_iter().filter_map(|warning| self.original(warning)) {
            own.entry(number).or_default().push(warning);
        }
        let outcomes = outcomes.into_iter().enumerate();
        outcomes
            .map(|(number, outcome)| outcome.with_warnings(own.remove(&number).unwrap_or_default()))
            .collect()
    }

    /// Translates a diagnostic back to that of a program alone, with the number of the program; `None` where it is about none.
    fn original(&self, diagnostic: Diagnostic) -> Option<(usize, Diagnostic)> {
        let number = self.member(diagnostic.line?)?;
        let (before, renamed) = &self.members[number];
        let own = |line: Option<u32>| line.map(|line| line.saturating_sub(*before));
        let diagnostic = Diagnostic {
            line: own(diagnostic.line),
            end_line: own(diagnostic.end_line),
            ..diagnostic
        };
        Some((number, renamed.original(diagnostic)))
    }
}

/// Runs a pack of programs, as [`Session::run_pack`](crate::Session::run_pack) does.
pub(super) fn run(adapter: &Matiec, workplace: &Workplace<'_>, requests: &[RunRequest<'_>]) -> Vec<Packed> {
    let taken = &adapter.taken;
    let member = |place, request| PackMember::of(place, request, taken);
    rounds::pack(
        requests,
        member,
        |member| member.place,
        |members| {
            let round = run_round(adapter, workplace, members);
            round.unwrap_or_else(|outcome| Round::alone(suspects(&outcome, members.len())))
        },
    )
}

/// Translates, builds and runs programs in one text.
///
/// # Errors
/// The outcome of a compiler that did not finish.
fn run_round(
    adapter: &Matiec,
    workplace: &Workplace<'_>,
    members: &[PackMember<'_>],
) -> Result<Round, Outcome> {
    let subjects: Vec<MatiecSubject<'_, '_>> = members
        .iter()
        .map(|member| MatiecSubject::of(&member.request, &member.probes, &member.program()))
        .collect();
    let Ok(driver) = driver(&subjects) else {
        let cannot = |number: &usize| driver(&subjects[*number..=*number]).is_err();
        return Ok(Round::alone((0..subjects.len()).filter(cannot).collect()));
    };
    let joined = Joined::of(members);
    let recipe = execution(&*joined.text, &driver.text());
    workplace.begin(&recipe)?;
    let ended = workplace.step(&recipe, Purpose::Translate, &[])?;
    let warnings = match diagnostics::accepted(&ended) {
        Ok(warnings) => warnings,
        Err(Outcome::Rejected { .. }) => return Ok(refused(members, &joined, &ended.stderr)),
        Err(_) => return Ok(Round::nothing()),
    };
    let built = adapter.builder.try_build(&recipe, workplace)?;
    if built.status.success() {
        let outcomes = driver.execute_all(&recipe, workplace);
        return Ok(Round::Ran(joined.with_warnings(outcomes, warnings)));
    }
    let read = |name: &str| std::fs::read_to_string(workplace.folder.path().join(name)).unwrap_or_default();
    let files = [("POUS.c:", read("POUS.c")), ("POUS.h:", read("POUS.h"))];
    let places = named(&built.stderr, files);
    let numbers = members.iter().enumerate();
    let named = numbers.filter(|(_, member)| places.contains(&member.place));
    Ok(Round::alone(named.map(|(number, _)| number).collect()))
}

/// Removes the programs that `iec2c` does not accept.
fn refused(members: &[PackMember<'_>], joined: &Joined, stderr: &str) -> Round {
    let (diagnostics, _) = diagnostics::diagnostics(stderr);
    let complete = diagnostics::are_complete(&diagnostics, stderr);
    let mut mistakes: BTreeMap<usize, Vec<Diagnostic>> = BTreeMap::new();
    for diagnostic in diagnostics {
        let Some((number, original)) = joined.original(diagnostic) else {
            return Round::nothing();
        };
        mistakes.entry(number).or_default().push(original);
    }
    if complete {
        // A program with probe variables has to be run alone, since the mistake may be in these.
        let known = mistakes
            .into_iter()
            .map(|(number, mistakes)| match members[number].probes.list() {
                [] => (number, Packed::Answered(diagnostics::rejected(mistakes))),
                _ => (number, Packed::Alone),
            });
        return Round::TakenOut(known.collect());
    }
    // A mistake at the beginning of a program may come from the end of the one before.
    let begins = |mistakes: &[Diagnostic]| mistakes.iter().any(|mistake| mistake.line == Some(1));
    let before = mistakes.iter().filter(|(_, mistakes)| begins(mistakes));
    let before = before.filter_map(|(number, _)| number.checked_sub(1));
    Round::alone(mistakes.keys().copied().chain(before).collect())
}

/// Returns the programs that a C compiler names in its errors, or in whose part of these files the errors are.
fn named(stderr: &str, files: [(&str, String); 2]) -> BTreeSet<usize> {
    let mut named: BTreeSet<usize> = places_named(stderr).into_iter().collect();
    for line in stderr.lines().filter(|line| line.contains("error")) {
        for (name, text) in &files {
            let number = line.split_once(name).and_then(|(_, rest)| {
                let digits = rest.split(':').next()?;
                digits.parse::<usize>().ok()
            });
            let before: Vec<&str> = text.lines().take(number.unwrap_or(0)).collect();
            let nearest = before
                .iter()
                .rev()
                .find_map(|line| places_named(line).first().copied());
            named.extend(nearest);
        }
    }
    named
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Engine, Observation, Reference};
    use stickler_types::DialectName;

    const PROGRAMS: [&str; 4] = [
        "TYPE COLOR : (RED, GREEN); END_TYPE\nPROGRAM main\nVAR c : COLOR; n : INT; END_VAR\n  c := GREEN;\nEND_PROGRAM",
        "FUNCTION f : INT\nVAR_INPUT x : INT; END_VAR\n  f := x;\nEND_FUNCTION\n\
         PROGRAM main VAR n : INT; b : BOOL; END_VAR\n  n := f(n) + f(b);\n  b := n;\nEND_PROGRAM\n",
        "TYPE COLOR : (GREEN, BLUE); END_TYPE\nPROGRAM main\nVAR c : COLOR; END_VAR\n  c := GREEN;\nEND_PROGRAM",
        "PROGRAM main\nVAR n : SINT; f : INT; END_VAR\n  n := f;\nEND_PROGRAM",
    ];

    fn request<'a>(source: &'a str, observe: &'a [Observation]) -> RunRequest<'a> {
        RunRequest::once(DialectName::MATIEC, source, observe)
    }

    fn members<'r>(programs: &[&'r str], observe: &'r [Observation]) -> Vec<PackMember<'r>> {
        let taken = HashSet::new();
        let numbered = programs.iter().enumerate();
        numbered
            .map(|(place, source)| PackMember::of(place, &request(source, observe), &taken).unwrap())
            .collect()
    }

    /// The reference finds the same mistakes in the joined text as in each program alone.
    #[test]
    fn joined_programs_are_what_they_are_alone() {
        let reference = Reference::new();
        let mut session = reference.session().unwrap();
        let mut check = |source: &str| match session.check(DialectName::MATIEC, source) {
            Outcome::Rejected { diagnostics } => diagnostics,
            Outcome::Accepted { .. } => Vec::new(),
            other => panic!("{other:?}"),
        };
        let joined = Joined::of(&members(&PROGRAMS, &[]));
        let mut found: Vec<Vec<Diagnostic>> = PROGRAMS.iter().map(|_| Vec::new()).collect();
        for diagnostic in check(&joined.text) {
            let (number, diagnostic) = joined.original(diagnostic).unwrap();
            found[number].push(diagnostic);
        }
        let alone: Vec<Vec<Diagnostic>> = PROGRAMS.iter().map(|program| check(program)).collect();
        assert_eq!(alone.iter().map(Vec::len).collect::<Vec<_>>(), [0, 2, 0, 1]);
        for (found, alone) in found.iter().zip(&alone) {
            let places = |diagnostics: &[Diagnostic]| -> Vec<_> {
                let place = |diagnostic: &Diagnostic| {
                    (
                        diagnostic.line,
                        diagnostic.column,
                        diagnostic.end_column,
                        diagnostic.code.clone(),
                    )
                };
                diagnostics.iter().map(place).collect()
            };
            assert_eq!(places(found), places(alone));
        }
    }

    #[test]
    fn lines_are_those_of_their_programs() {
        let joined = Joined::of(&members(&PROGRAMS, &[]));
        let of = |lines: std::ops::Range<u32>| lines.map(|line| joined.member(line)).collect::<Vec<_>>();
        assert_eq!(of(1..6), [Some(0); 5]);
        // The second ends with a line feed, and its last line is empty.
        assert_eq!(of(6..15), [Some(1); 9]);
        assert_eq!(of(15..20), [Some(2); 5]);
        assert_eq!(of(20..24), [Some(3); 4]);
        assert_eq!(joined.member(24), None);
        assert_eq!(joined.member(0), None);
    }

    #[test]
    fn a_program_whose_variable_would_be_renamed_stands_alone() {
        let taken = HashSet::new();
        let observe = ["n", "c.x"].map(|name| Observation::last(name, "INT"));
        let alone = |source: &str| PackMember::of(0, &request(source, &observe), &taken).is_none();
        assert!(!alone("PROGRAM main VAR n : INT; END_VAR END_PROGRAM"));
        assert!(alone("PROGRAM n VAR n : INT; END_VAR END_PROGRAM"));
        assert!(alone(
            "TYPE C : INT; END_TYPE PROGRAM main VAR c : C; END_VAR END_PROGRAM"
        ));
        assert!(alone("PROGRAM main VAR n_IN_PACK_3 : INT; END_VAR END_PROGRAM"));
        assert!(alone("PROGRAM main VAR n : INT; END_VAR RETURN; END_PROGRAM"));
    }

    #[test]
    fn what_a_c_compiler_complains_of_is_found() {
        let c = "void MAIN_IN_PACK_3_body__() {\n  x = y;\n}\nvoid MAIN_IN_PACK_12_body__() {\n  x = z;\n"
            .to_owned();
        let h = "// PROGRAM MAIN_IN_PACK_5\ntypedef struct {\n  what x;\n".to_owned();
        let stderr = "In file included from driver.c:5:\nPOUS.c:5:3: error: 'x' undeclared\n\
                      ./POUS.h:3:1: error: unknown type name\nin function `F_IN_PACK_7': undefined\n";
        let found: Vec<usize> = named(stderr, [("POUS.c:", c), ("POUS.h:", h)])
            .into_iter()
            .collect();
        assert_eq!(found, [5, 7, 12]);
    }
}
