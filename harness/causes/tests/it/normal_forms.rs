//! Finds which failing cases belong together on engines with one planted defect, by the normal forms of their programs.

use crate::fixtures::{self, identity, suite, titles};
use std::sync::atomic::{AtomicU32, Ordering};
use stickler_causes::SearchLimits;
use stickler_engines::{
    Ability, Engine, EngineError, Identity, NoReproduction, Outcome, Reproduction, ReproductionFile,
    RunRequest, Session,
};
use stickler_run::{Cause, Fact};
use stickler_suite::Case;
use stickler_types::{Code, Diagnostic, DialectName, ElementaryType, Fault, Value};

/// A compiler that runs programs with one defect.
pub struct DefectiveCompiler {
    pub identity: Identity,
    run: fn(&RunRequest<'_>) -> Outcome,
}

impl DefectiveCompiler {
    pub fn new(run: fn(&RunRequest<'_>) -> Outcome) -> DefectiveCompiler {
        let identity = identity();
        DefectiveCompiler { identity, run }
    }
}

impl Engine for DefectiveCompiler {
    fn identity(&self) -> &Identity {
        &self.identity
    }

    fn session(&self) -> Result<Box<dyn Session + '_>, EngineError> {
        Ok(Box::new(Running(self.run)))
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

struct Running(fn(&RunRequest<'_>) -> Outcome);

impl Session for Running {
    fn run(&mut self, request: &RunRequest<'_>) -> Outcome {
        (self.0)(request)
    }

    fn check(&mut self, _: DialectName, _: &str) -> Outcome {
        Outcome::ACCEPTED
    }

    fn render(&mut self, _: DialectName, _: &str) -> Outcome {
        let reason = "not asked".to_owned();
        Outcome::Unsupported { reason }
    }
}

pub fn as_the_reference(request: &RunRequest<'_>) -> Outcome {
    stickler_reference::run(request, stickler_reference::Limits::default())
        .expect("observed variables are there")
}

/// Returns what the reference does with another program in the place of the one that is asked for.
fn as_the_reference_runs(request: &RunRequest<'_>, source: &str) -> Outcome {
    as_the_reference(&RunRequest { source, ..*request })
}

/// Returns a case with a program of these declarations and statements, which must end with a value (`into = REAL#5.0`) or be
/// rejected (`6 P4035`).
fn case(id: &str, declarations: &str, statements: &str, must: &str) -> Case {
    let program = format!("PROGRAM main\nVAR\n{declarations}\nEND_VAR\n{statements}\nEND_PROGRAM\n");
    fixtures::case(id, &program, must)
}

fn causes(compiler: &DefectiveCompiler, cases: Vec<Case>) -> Vec<Cause> {
    causes_within(compiler, cases, SearchLimits::default())
}

fn causes_within(compiler: &DefectiveCompiler, cases: Vec<Case>, limits: SearchLimits) -> Vec<Cause> {
    let found = fixtures::causes(&suite(cases), compiler, 1, limits);
    for Cause { shown, .. } in &found {
        let reproduction = shown.reproduction.as_ref().expect("a reproduction");
        let [program, observed] = &reproduction.files[..] else {
            panic!("{} files", reproduction.files.len());
        };
        assert_eq!(program.text, shown.program, "the program that is shown");
        let pairs = shown.expected.iter().zip(&shown.got);
        for (wanted, _) in pairs.filter(|(wanted, reported)| wanted != reported) {
            if let Fact::Value { name, .. } = wanted {
                assert!(
                    observed.text.split(' ').any(|one| one == name),
                    "{name} is observed"
                );
            }
        }
    }
    found
}

/// Begins LREAL variables without the sign of their initial value.
fn without_signs(request: &RunRequest<'_>) -> Outcome {
    let source = request.source.replace("LREAL := -", "LREAL := ");
    as_the_reference_runs(request, &source)
}

/// Reads neither typed literals with a sign nor lists of initial values.
fn reads_little(request: &RunRequest<'_>) -> Outcome {
    let line = request
        .source
        .lines()
        .position(|line| line.contains("#-") || line.contains(":= ("));
    let Some(line) = line else {
        return as_the_reference(request);
    };
    let unread = Diagnostic {
        line: Some(line as u32 + 1),
        code: Some("P0002".to_owned()),
        ..Diagnostic::default()
    };
    Outcome::Rejected {
        diagnostics: vec![unread],
    }
}

#[test]
fn an_operand_with_a_literal_of_its_own_is_not_what_cannot_be_read() {
    let block = "FUNCTION_BLOCK b\nVAR_INPUT\n    in : INT;\n    on : BOOL;\nEND_VAR\nVAR_OUTPUT\n    out : INT;\nEND_VAR\n    out := in;\nEND_FUNCTION_BLOCK\n";
    let listed = format!(
        "{block}PROGRAM main\nVAR\n    into : INT;\n    taking : b := (on := TRUE);\nEND_VAR\n    taking();\n    into := taking.out;\n\
         END_PROGRAM\n"
    );
    let cases = vec![
        case(
            "t::signed",
            "    into : INT := INT#-2;",
            "    into := into;",
            "into = INT#-2",
        ),
        fixtures::case("t::listed", &listed, "into = INT#0"),
    ];
    let found = causes(&DefectiveCompiler::new(reads_little), cases);
    assert_eq!(found.len(), 2, "{:?}", titles(&found));
}

#[test]
fn an_initial_value_that_fails_alone_is_the_cause_and_not_the_operation_around_it() {
    let declarations = "m : LREAL := -3.0; n : LREAL := 8.0; into : LREAL;";
    let cases = vec![
        case("t::sum", declarations, "into := m + n;", "into = LREAL#5.0"),
        case("t::product", declarations, "into := m * n;", "into = LREAL#-24.0"),
    ];
    let found = causes(&DefectiveCompiler::new(without_signs), cases);
    assert_eq!(
        titles(&found),
        [(
            2,
            "`into := data` (into : LREAL, data : LREAL := -1.0) gives LREAL#1.0, not LREAL#-1.0"
        )]
    );
    assert!(
        found[0].shown.is_derived,
        "the claims are about sums and products"
    );
}

#[cfg(unix)]
#[test]
fn the_commands_are_not_run_for_a_program_that_is_not_small() {
    let printed = |limits| {
        let declarations = "n : LREAL := -3.0; into : LREAL;";
        let cases = vec![case(
            "t::sum",
            declarations,
            "into := n + 8.0;",
            "into = LREAL#5.0",
        )];
        let found = causes_within(&DefectiveCompiler::new(without_signs), cases, limits);
        found[0].shown.printed.trim().to_owned()
    };
    assert_eq!(printed(SearchLimits::default()), "shown");
    let none = SearchLimits {
        questions: 0,
        ..SearchLimits::default()
    };
    assert_eq!(printed(none), "");
}

/// Begins REAL variables without the sign of their initial value.
fn without_signs_of_reals(request: &RunRequest<'_>) -> Outcome {
    let source = request.source.replace(": REAL := -", ": REAL := ");
    as_the_reference_runs(request, &source)
}

#[test]
fn a_conversion_behind_an_initial_value_that_fails_alone_is_not_shown() {
    let declarations = "data : REAL := -3.0; into : LREAL;";
    let widened = case("t::widened", declarations, "into := data;", "into = LREAL#-3.0");
    let found = causes(&DefectiveCompiler::new(without_signs_of_reals), vec![widened]);
    let program = &found[0].shown.program;
    assert!(!program.contains("LREAL"), "{program}");
}

/// Rounds in conversions to integers, and takes the amount of negative numbers for unsigned ones.
fn rounding(request: &RunRequest<'_>) -> Outcome {
    let source = request
        .source
        .replace("UINT(-", "UINT(")
        .replace("UINT#-", "UINT#");
    let rounded = source
        .replace("2.75", "3.0")
        .replace("7.5", "8.0")
        .replace("1.5", "2.0");
    as_the_reference_runs(request, &rounded)
}

#[test]
fn values_with_a_fraction_and_with_a_sign_are_two_causes_whatever_the_types() {
    let of = |id: &str, call: &str, value: &str| {
        let ty = value.split('#').next().expect("a type");
        let into = format!("into : {ty};");
        case(id, &into, &format!("into := {call};"), &format!("into = {value}"))
    };
    let cases = vec![
        of("t::a", "REAL_TO_INT(2.75)", "INT#2"),
        of("t::b", "LREAL_TO_UDINT(7.5)", "UDINT#7"),
        of("t::c", "REAL_TO_WORD(7.5)", "WORD#7"),
        of("t::d", "REAL_TO_UINT(-16.0)", "UINT#65520"),
    ];
    let found = causes(&DefectiveCompiler::new(rounding), cases);
    let numbers: Vec<u64> = found.iter().map(Cause::number).collect();
    assert_eq!(numbers, [3, 1], "{:?}", titles(&found));
}

#[test]
fn a_conversion_by_name_is_the_cause_also_behind_an_operation() {
    let of = |id: &str, operand: &str| {
        let statement = format!("into := REAL_TO_INT({operand});");
        case(id, "into : INT; nought : REAL;", &statement, "into = INT#2")
    };
    let cases = vec![of("t::a", "2.75"), of("t::b", "nought + 2.75")];
    let found = causes(&DefectiveCompiler::new(rounding), cases);
    assert_eq!(titles(&found).len(), 1, "{:?}", titles(&found));
}

/// Begins REAL variables with the bits of an integer literal.
fn without_conversion_of_initial_values(request: &RunRequest<'_>) -> Outcome {
    let source = request.source.replace("REAL := INT#2", "REAL := 3.0E-45");
    as_the_reference_runs(request, &source)
}

#[test]
fn what_a_variable_begins_with_is_shown_without_an_assignment() {
    let cases = vec![case(
        "t::a",
        "into : REAL := INT#2; done : BOOL;",
        "done := TRUE;",
        "into = REAL#2.0",
    )];
    let found = causes(
        &DefectiveCompiler::new(without_conversion_of_initial_values),
        cases,
    );
    let title = &found[0].title;
    assert!(title.starts_with("`into : REAL := INT#2`"), "{title}");
}

/// The number of programs that were run in a search.
static RUN: AtomicU32 = AtomicU32::new(0);

/// Rounds 3.5 in conversions to integers, and counts.
fn counts_and_rounds(request: &RunRequest<'_>) -> Outcome {
    RUN.fetch_add(1, Ordering::Relaxed);
    let source = request.source.replace("3.5", "4.0");
    as_the_reference_runs(request, &source)
}

#[test]
fn an_operand_that_gives_the_same_wrong_value_alone_takes_the_place_of_the_search() {
    let of = |id: &str, before: &str| {
        let statements = format!("{before} list[1] := REAL_TO_INT(given); into := list[1];");
        let declarations = "given : REAL := 3.5; list : ARRAY[0..1] OF INT; into, number : INT;";
        case(id, declarations, &statements, "into = INT#3")
    };
    let cases = vec![
        of("t::a", "number := 1;"),
        of("t::b", "number := number + 1;"),
        of("t::c", "IF number = 0 THEN number := 2; END_IF;"),
        of("t::d", "FOR number := 1 TO 2 DO list[0] := number; END_FOR;"),
    ];
    let found = causes(&DefectiveCompiler::new(counts_and_rounds), cases);
    assert_eq!(titles(&found).len(), 1, "{:?}", titles(&found));
    // Each case once, the operand of all of them with its repetitions, and its normal form.
    let run = RUN.load(Ordering::Relaxed);
    assert!(run < 40, "{run} programs were run");
}

#[test]
fn values_in_lists_that_nobody_checks_are_one_cause_whatever_is_wrong_with_them() {
    let of = |id: &str, value: &str, code: &str| {
        let declarations = format!("a : ARRAY[0..0] OF SINT := [1({value})]; done : BOOL;");
        case(id, &declarations, "done := TRUE;", &format!("3 {code}"))
    };
    let cases = vec![of("t::a", "128", "P2026"), of("t::b", "INT#0", "P4022")];
    let found = causes(&DefectiveCompiler::new(dying), cases);
    assert_eq!(found.len(), 1, "{:?}", titles(&found));
}

/// Compares with a wider operand as if that were of the type of the first one.
fn compares_as_the_first(request: &RunRequest<'_>) -> Outcome {
    let source = request
        .source
        .replace("SINT#0 < wide", "NOT (SINT#0 < wide)")
        .replace("DINT#0 < wide", "NOT (DINT#0 < wide)");
    as_the_reference_runs(request, &source)
}

#[test]
fn a_comparison_that_is_right_when_it_is_turned_round_is_done_in_the_type_of_its_first_operand() {
    let of = |id: &str, declaration: &str, operand: &str, must: &str| {
        let declarations = format!("wide : {declaration}; less : BOOL;");
        case(id, &declarations, &format!("less := {operand} < wide;"), must)
    };
    let cases = vec![
        of("t::a", "INT := -300", "SINT#0", "less = BOOL#FALSE"),
        of("t::b", "LINT := 4294967290", "DINT#0", "less = BOOL#TRUE"),
    ];
    let found = causes(&DefectiveCompiler::new(compares_as_the_first), cases);
    assert_eq!(found.len(), 1, "{:?}", titles(&found));
    assert_eq!(found[0].construct, "comparison in the type of its first operand");
}

/// Accepts a value of every type for every other, and dies when it runs such a program.
pub fn dying(request: &RunRequest<'_>) -> Outcome {
    match as_the_reference(request) {
        Outcome::Rejected { .. } => Outcome::Crashed {
            reason: "the virtual machine ended".to_owned(),
        },
        other => other,
    }
}

#[test]
fn a_program_that_must_be_rejected_and_dies_when_it_runs_was_accepted() {
    let cases = vec![case(
        "t::a",
        "from : DINT; into : INT;",
        "into := from;",
        "5 P4035",
    )];
    let found = causes(&DefectiveCompiler::new(dying), cases);
    assert_eq!(found[0].symptom, "accepted");
    assert_eq!(found[0].shown.got, [Fact::Accepted]);
}

#[test]
fn a_code_that_the_engine_lacks_is_not_asked_for() {
    let cases = || {
        vec![case(
            "t::a",
            "from : DINT; into : INT;",
            "into := from;",
            "5 P4035",
        )]
    };
    let mut compiler = DefectiveCompiler::new(dying);
    let with = causes(&compiler, cases());
    compiler.identity.lacks = vec!["P4035".parse::<Code>().expect("a code")];
    let without = causes(&compiler, cases());
    let ends = |found: &[Cause], end: &str| found[0].title.ends_with(end);
    assert!(ends(&with, "does not fit the target (P4035)") && ends(&without, "does not fit the target"));
    assert_eq!(
        without[0].shown.expected[0].to_string(),
        "line 6: error of any code"
    );
}

/// Rounds where it must truncate, and keeps to the largest LINT where it must wrap.
fn converts_otherwise(request: &RunRequest<'_>) -> Outcome {
    let source = request.source.replace("LINT(r)", "LINT(r + 0.5)");
    let source = source.replace("r : REAL := 1.0E20", "r : REAL := 9.0E18");
    as_the_reference_runs(request, &source)
}

#[test]
fn a_value_that_nobody_asked_about_explains_no_other() {
    let cases = vec![
        case(
            "t::rounded",
            "r : REAL := 1.5; into : LINT;",
            "into := REAL_TO_LINT(r);",
            "into = LINT#1",
        ),
        case(
            "t::wrapped",
            "s : REAL := -3.0; r : REAL := 1.0E20; into : LINT;",
            "into := REAL_TO_LINT(r);",
            "into = LINT#7766279631452241920",
        ),
    ];
    let limits = SearchLimits {
        questions: 0,
        ..SearchLimits::default()
    };
    let found = causes_within(&DefectiveCompiler::new(converts_otherwise), cases, limits);
    assert_eq!(found.len(), 2, "{:?}", titles(&found));
}

/// The number of times that the operand was asked for alone.
static ALONE: AtomicU32 = AtomicU32::new(0);

/// Adds one to the literal 40.
fn counts_the_operand(request: &RunRequest<'_>) -> Outcome {
    if request.source.contains("    into := 40;") {
        ALONE.fetch_add(1, Ordering::Relaxed);
    }
    let source = request.source.replace(":= 40", ":= 41");
    as_the_reference_runs(request, &source)
}

#[test]
fn a_program_that_several_groups_ask_for_is_run_once() {
    let with = |id: &str, operation: &str, value: &str| {
        let declarations = "data : INT := 40; into : INT;";
        case(id, declarations, &format!("into := {operation};"), value)
    };
    let cases = vec![
        with("t::sum", "data + 2", "into = INT#42"),
        with("t::quotient", "data / 5 * data", "into = INT#320"),
        with("t::absolute", "ABS(data)", "into = INT#40"),
    ];
    let found = causes(&DefectiveCompiler::new(counts_the_operand), cases);
    assert_eq!(found.len(), 1, "{:?}", titles(&found));
    assert_eq!(ALONE.load(Ordering::Relaxed), 1);
}

/// Begins the variables of a function block with the default of their type, and takes no end of steps for no answer.
fn without_initial_values_of_blocks(request: &RunRequest<'_>) -> Outcome {
    let source = request
        .source
        .replace("finished : BOOL := TRUE", "finished : BOOL");
    let outcome = as_the_reference_runs(request, &source);
    match outcome {
        Outcome::Faulted {
            fault: Fault::StepLimit,
            ..
        } => Outcome::TimedOut { after_ms: 1000 },
        other => other,
    }
}

#[test]
fn a_loop_without_an_end_is_explained_by_the_initial_value_that_was_lost() {
    let program = "FUNCTION_BLOCK looping\nVAR_OUTPUT\n    count : INT;\nEND_VAR\nVAR\n    finished : BOOL := TRUE;\nEND_VAR\n    REPEAT\n        \
                   count := count + 1;\n    UNTIL finished\n    END_REPEAT;\nEND_FUNCTION_BLOCK\nPROGRAM main\nVAR\n    fb : looping;\n    into : INT;\nEND_VAR\n    \
                   fb();\n    into := fb.count;\nEND_PROGRAM\n";
    let case = fixtures::case("t::loop", program, "into = INT#1");
    let found = causes(
        &DefectiveCompiler::new(without_initial_values_of_blocks),
        vec![case],
    );
    assert_eq!(
        titles(&found),
        [(
            1,
            "`finished : BOOL := TRUE`: fb.finished is BOOL#FALSE, not BOOL#TRUE"
        )]
    );
}

/// Does not look at the types of operands.
fn without_types_of_operands(request: &RunRequest<'_>) -> Outcome {
    match as_the_reference(request) {
        Outcome::Rejected { diagnostics }
            if diagnostics
                .iter()
                .all(|reported| reported.code.as_deref() == Some("P4049")) =>
        {
            Outcome::ACCEPTED
        }
        other => other,
    }
}

#[test]
fn operands_that_no_operator_checks_are_one_cause() {
    let declarations = "t : TIME; w : WORD; b : BOOL;";
    let cases = ["t := t + w;", "b := t < w;", "w := w AND t;"]
        .map(|line| case("t::a", declarations, line, "5 P4049"));
    let found = causes(&DefectiveCompiler::new(without_types_of_operands), cases.to_vec());
    assert_eq!(found.len(), 1, "{:?}", titles(&found));
    assert_eq!(found[0].number(), 3);
}

/// Says what is wrong, and not where.
fn without_places(request: &RunRequest<'_>) -> Outcome {
    match as_the_reference(request) {
        Outcome::Rejected { mut diagnostics } => {
            for reported in &mut diagnostics {
                (reported.line, reported.column) = (Some(1), Some(1));
            }
            Outcome::Rejected { diagnostics }
        }
        other => other,
    }
}

#[test]
fn a_compiler_that_loses_the_places_of_mistakes_has_one_cause_whatever_the_mistakes_are() {
    let declarations = "from : DINT; into : INT;";
    let cases = vec![
        case("t::a", declarations, "into := from;", "5 P4035"),
        case("t::b", declarations, "into := nobody;", "5 P4007"),
    ];
    let found = causes(&DefectiveCompiler::new(without_places), cases);
    assert_eq!(found.len(), 1, "{:?}", titles(&found));
    let title = &found[0].title;
    assert!(
        title.contains("is rejected without the place of the mistake: P4"),
        "{title}"
    );
}

/// Returns a rejection with this code on a line, and once more without a place.
fn told_twice(code: &str, line: u32) -> Outcome {
    let reported = |line| Diagnostic {
        code: Some(code.to_owned()),
        line,
        ..Diagnostic::default()
    };
    let diagnostics = vec![reported(Some(line)), reported(None)];
    Outcome::Rejected { diagnostics }
}

/// Takes the argument of ABS for one too many.
fn without_arguments(request: &RunRequest<'_>) -> Outcome {
    match request.source.lines().position(|line| line.contains("ABS(")) {
        Some(line) => told_twice("P4018", line as u32 + 1),
        None => as_the_reference(request),
    }
}

#[test]
fn a_valid_program_that_is_rejected_like_one_with_a_mistake_is_shown_whole_and_without_its_claim() {
    let declarations = "from : DINT; into : INT;";
    let cases = vec![case("t::a", declarations, "into := ABS(from);", "5 P4035")];
    let found = causes(&DefectiveCompiler::new(without_arguments), cases);
    assert_eq!(found[0].shown.expected, [Fact::Accepted], "{:?}", titles(&found));
    assert!(found[0].shown.is_derived, "the claim is about a mistake");
}

/// Takes every subrange for a mistake, and tells it twice.
fn subranges_twice(request: &RunRequest<'_>) -> Outcome {
    match request.source.lines().position(|line| line.contains("..")) {
        Some(line) => told_twice("P2002", line as u32 + 1),
        None => as_the_reference(request),
    }
}

#[test]
fn a_mistake_that_is_told_twice_does_not_hide_a_valid_program() {
    let program = "TYPE\n    narrow : INT(9..1);\nEND_TYPE\nPROGRAM main\nVAR\n    fine : INT;\nEND_VAR\n    fine := 1;\nEND_PROGRAM\n";
    let cases = vec![fixtures::case("t::a", program, "2 P2002")];
    let found = causes(&DefectiveCompiler::new(subranges_twice), cases);
    assert!(found[0].symptom.starts_with("surplus"), "{:?}", titles(&found));
    let title = &found[0].title;
    assert!(
        title
            .ends_with("`: that the subrange does not ascend (P2002) is reported once more, without a place"),
        "{title}"
    );
}

/// Adds one too few, and assigns nothing of `c` alone.
fn adds_too_little(request: &RunRequest<'_>) -> Outcome {
    let mut outcome = as_the_reference(request);
    if let Outcome::Executed { values, .. } = &mut outcome {
        for (_, value) in values.iter_mut().filter(|(name, _)| name == "x") {
            if request.source.contains('+') {
                *value = Value::plain(ElementaryType::Int, 5);
            } else if request.source.contains("x := c;") {
                *value = Value::plain(ElementaryType::Int, 0);
            }
        }
    }
    outcome
}

#[test]
fn a_wrong_value_stays_what_it_is_while_its_program_becomes_smaller() {
    let sum = case("t::sum", "c : INT := 6; d, x : INT;", "x := c + d;", "x = INT#6");
    let found = causes(&DefectiveCompiler::new(adds_too_little), vec![sum]);
    assert!(found[0].shown.program.contains('+'), "{}", found[0].shown.program);
}
