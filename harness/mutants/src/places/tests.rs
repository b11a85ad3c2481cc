//! Saboteurs on small programs, and a sample of the suite against some of them.

use super::analysis::Analysis;
use super::claim::Rule;
use super::explained::ExplainedSaboteurs;
use super::matrix::required;
use super::measure::{Tally, measure};
use super::saboteur::{BrokenPlace, Saboteur};
use super::site::sites;
use super::table::Judged;
use std::collections::BTreeSet;
use std::path::Path;
use std::sync::LazyLock;
use stickler_engines::{EngineSession, Observation, Outcome, RunRequest};
use stickler_mdtest::assert_fits;
use stickler_suite::{Suite, Wanted};
use stickler_types::{Dialect, DialectName, join};

/// A part of the suite that has programs of every place.
static SAMPLE: LazyLock<Suite> = LazyLock::new(|| {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../conformance-cases");
    const FILES: [&str; 4] = [
        "widening/bool",
        "bit-access/placed-disabled",
        "conversion/placed-reals",
        // The reference does not give the code that this one expects.
        "language/ironplc-as-printed/P4034-1",
    ];
    Suite::load_files(&folder, Wanted::default(), |id, _| FILES.contains(&id))
});

const PROGRAM: &str = include_str!("tests/program.st");

/// Returns what a program does where a rule is broken in a place: the values of its variables, or the lines of its errors.
fn reported(rule: &str, place: BrokenPlace) -> String {
    let engine = saboteur(rule, place).engine();
    let observe = ["plain", "list[0]", "given", "bit"].map(|name| Observation::last(name, ""));
    let request = RunRequest::once(DialectName::IRONPLC_ED3, PROGRAM, &observe);
    let mut session = EngineSession::open(&engine).expect("it opens");
    match session.run(&request).expect("it answers") {
        Outcome::Executed { values, .. } => {
            let values = values.iter().map(|(_, value)| value.to_string());
            join(values, " ")
        }
        Outcome::Rejected { diagnostics } => {
            let lines = diagnostics
                .iter()
                .filter_map(|found| Some(found.line?.to_string()));
            join(lines, " ")
        }
        other => other.to_string(),
    }
}

#[test]
fn a_rule_is_broken_in_its_place_and_nowhere_else() {
    const WRONG: &str = "implicit.signed-to-wider.wrong";
    let right = "INT#-1 INT#-1 INT#-1 BOOL#TRUE";
    assert_eq!(reported(WRONG, BrokenPlace::Target("field")), right);
    let in_element = BrokenPlace::Target("array-element");
    assert_eq!(reported(WRONG, in_element), "INT#-1 INT#255 INT#-1 BOOL#TRUE");
    assert_eq!(reported("implicit.signed-to-wider.refused", in_element), "15");
    let in_argument = BrokenPlace::Target("argument");
    assert_eq!(reported(WRONG, in_argument), "INT#-1 INT#-1 INT#255 BOOL#TRUE");
    let in_if = BrokenPlace::Surrounding("if");
    assert_eq!(reported(WRONG, in_if), "INT#-1 INT#-1 INT#255 BOOL#TRUE");
    let bit = BrokenPlace::Bit(stickler_types::ElementaryType::Byte, 1);
    assert_eq!(
        reported("bit.read-short.wrong", bit),
        "INT#-1 INT#-1 INT#-1 BOOL#FALSE"
    );
}

#[test]
fn an_error_that_is_admitted_is_not_reported() {
    let source = "PROGRAM main\nVAR a : INT; b : SINT; END_VAR\nb := a;\nb := -129;\nEND_PROGRAM\n";
    let left = |rule: &str| {
        let engine = saboteur(rule, BrokenPlace::Target("assignment")).engine();
        let mut session = EngineSession::open(&engine).expect("it opens");
        let outcome = session.check(DialectName::IRONPLC_ED3, source);
        let Outcome::Rejected { diagnostics } = outcome.expect("it answers") else {
            panic!("the other error stays")
        };
        let lines = diagnostics.iter().filter_map(|found| found.line);
        lines.collect::<Vec<_>>()
    };
    assert_eq!(left("implicit.integer-to-narrower.admitted"), [4]);
    assert_eq!(left("literal.integer-as-integer.admitted"), [3]);
    assert_eq!(left("literal.integer-as-integer.refused"), [3, 4]);
}

/// Where the design of places says that a value stands, the tree says so too.
#[test]
fn the_places_of_a_program_that_is_put_together_are_those_of_its_case() {
    let mut seen = BTreeSet::new();
    for case in &SAMPLE.cases {
        let Some(placement) = &case.placement else {
            continue;
        };
        // Behind a parameter another value stands, no source goes to an output, and a subscript is taken for one whatever the array.
        let passed = [
            "result-and-return",
            "block-output",
            "function-output",
            "subscript-of-one-element",
        ];
        if passed.contains(&&*placement.target) || !seen.insert((**placement).clone()) {
            continue;
        }
        let analysis = Analysis::new(&case.source, Dialect::of(case.dialect));
        let found = sites(&analysis, false).iter().any(|site| {
            let standing = site.standing;
            standing.source == Some(&placement.source)
                && standing.target == Some(&placement.target)
                && (standing.surrounding == Some(&placement.surrounding)
                    // A declaration stands in the unit that it belongs to, and the condition of UNTIL a line behind; so does a subscript, before
                    // which an element is set.
                    || placement.target.ends_with("initial-value")
                    || &*placement.target == "until-condition"
                    || (&*placement.target, &*placement.surrounding) == ("subscript", "second-on-a-line"))
        });
        assert!(found, "{}: {placement:?}\n{}", case.key(), case.source);
    }
    assert!(seen.len() > 500, "{}", seen.len());
}

#[test]
fn a_sample_of_the_suite_notices_saboteurs() {
    assert_eq!(SAMPLE.errors, []);
    let wanted = |saboteur: &Saboteur| {
        let rule = saboteur.rule.to_string();
        let place = matches!(saboteur.place, BrokenPlace::Source(_) | BrokenPlace::Target(_));
        place
            && [
                "implicit.bool-to-number.admitted",
                "implicit.from-text.admitted",
                "no-such-form.read-partial-access.admitted",
            ]
            .contains(&&*rule)
    };
    let measured = measure(&SAMPLE.cases, 0, wanted).expect("all cases pass");
    assert!(measured.len() > 25, "{}", measured.len());
    for (saboteur, tally) in measured {
        assert!(tally.noticed > 0, "{saboteur}: {tally:?}");
    }
}

#[test]
fn a_saboteur_that_changes_nothing_is_said_to() {
    let saboteur = Saboteur {
        rule: Rule::all()[0],
        place: BrokenPlace::Target("field"),
    };
    let complaint = |tally| {
        let judged = Judged {
            saboteur,
            tally,
            kind: None,
        };
        judged.complaint()
    };
    let met = Tally {
        met: 2,
        ..Tally::default()
    };
    assert_fits(
        &complaint(met),
        "changes nothing: implicit.signed-to-wider.refused in target.field: 2 cases…",
    );
    assert!(complaint(Tally::default()).starts_with("no case: "));
}

#[test]
fn a_saboteur_breaks_no_claim_where_every_case_that_sees_it_only_records() {
    let is_recorded = |met, changed, recorded| {
        let judged = Judged {
            saboteur: saboteur("implicit.lreal-to-real.wrong", BrokenPlace::Target("field")),
            tally: Tally {
                met,
                changed,
                recorded,
                ..Tally::default()
            },
            kind: None,
        };
        judged.is_recorded()
    };
    assert!(is_recorded(3, 2, 2), "the one that may assert does not see it");
    assert!(!is_recorded(2, 0, 0), "another value could show it");
    assert!(!is_recorded(3, 3, 2), "one that sees it asserts something");
    assert!(!is_recorded(0, 0, 0), "no case has it");
}

/// A list that explains two rules in all targets but one.
const LIST: &str = include_str!("tests/unnoticed.toml");

fn saboteur(rule: &str, place: BrokenPlace) -> Saboteur {
    let rules = Rule::all();
    let rule = rules.iter().find(|known| known.to_string() == rule);
    Saboteur {
        rule: *rule.expect("the rule is known"),
        place,
    }
}

fn dialect(name: &str) -> DialectName {
    name.parse().expect("the dialect is known")
}

#[test]
fn a_star_stands_for_any_text_but_for_the_exceptions() {
    use stickler_types::ElementaryType::{Date, Lreal, Real, Time, Tod};
    let list = ExplainedSaboteurs::from_text(LIST, &[]).expect("it is readable");
    let (refused, wrong) = ("implicit.lreal-to-real.refused", "implicit.from-time.wrong");
    for (rule, place, is_explained) in [
        (refused, BrokenPlace::Target("field"), true),
        ("implicit.lreal-to-real.wrong", BrokenPlace::Target("field"), true),
        (refused, BrokenPlace::Cell(Lreal, Real, "field"), true),
        (refused, BrokenPlace::Source("field"), false),
        (
            "implicit.real-to-lreal.refused",
            BrokenPlace::Target("field"),
            false,
        ),
        (refused, BrokenPlace::Target("assignment"), false),
        (refused, BrokenPlace::Cell(Lreal, Real, "assignment"), false),
        (wrong, BrokenPlace::Cell(Time, Date, "assignment"), true),
        (wrong, BrokenPlace::Cell(Time, Tod, "assignment"), false),
        (wrong, BrokenPlace::Target("assignment"), false),
    ] {
        let kind = list.kind(&saboteur(rule, place));
        assert_eq!(kind.is_some(), is_explained, "{rule} in {place}");
    }
}

#[test]
fn an_entry_that_explains_too_much_or_nothing_is_stale() {
    use stickler_types::ElementaryType::{Date, Lreal, Real, Time};
    let list = ExplainedSaboteurs::from_text(LIST, &[]).expect("it is readable");
    let refused = |place| saboteur("implicit.lreal-to-real.refused", place);
    let in_field = refused(BrokenPlace::Target("field"));
    let assigned = refused(BrokenPlace::Target("assignment"));
    let to_date = saboteur(
        "implicit.from-time.wrong",
        BrokenPlace::Cell(Time, Date, "assignment"),
    );
    assert_eq!(list.stale(&[&in_field, &to_date], &[&assigned]), [""; 0]);
    // Of a pair of types, a place may be noticed that is not noticed as a whole.
    let pair = refused(BrokenPlace::Cell(Lreal, Real, "path"));
    assert_eq!(list.stale(&[&in_field, &to_date], &[&assigned, &pair]), [""; 0]);
    let noticed = refused(BrokenPlace::Target("path"));
    assert_eq!(
        list.stale(&[&in_field, &to_date], &[&assigned, &noticed]),
        [
            "implicit.lreal-to-real.refused in target.path by `implicit.lreal-to-real.*` in `target.*`, although it is noticed"
        ]
    );
    assert_eq!(
        list.stale(&[&in_field], &[]),
        [
            "nothing in target.assignment by its exception: no rule of the entry is noticed there",
            "implicit.from-time.wrong in target.assignment, which is noticed or does not exist",
        ]
    );
}

#[test]
fn a_reason_of_a_dialect_explains_and_is_stale_by_its_cases_alone() {
    let of_a_dialect = LIST.replacen("kind =", "dialects = [\"codesys\"]\nkind =", 1);
    let place = BrokenPlace::Target("field");
    let refused = saboteur("implicit.lreal-to-real.refused", place);
    let read = |dialects: &[DialectName]| ExplainedSaboteurs::from_text(&of_a_dialect, dialects);
    for (dialects, explained) in [
        (&[][..], false),
        (&[dialect("codesys")], true),
        (&[dialect("iec-ed3")], false),
        (&[dialect("codesys"), dialect("iec-ed3")], false),
    ] {
        let list = read(dialects).expect("it is readable");
        assert_eq!(list.kind(&refused).is_some(), explained, "{dialects:?}");
        assert_eq!(!list.stale(&[], &[]).is_empty(), explained, "{dialects:?}");
    }
    let unknown = LIST.replacen("kind =", "dialects = [\"codsys\"]\nkind =", 1);
    assert!(ExplainedSaboteurs::from_text(&unknown, &[]).is_err());
}

#[test]
fn the_list_names_rules_and_places_that_there_are() {
    let known: Vec<String> = Rule::all().iter().map(Rule::to_string).collect();
    let names: BTreeSet<&String> = known.iter().collect();
    assert_eq!(names.len(), known.len(), "each rule has a name of its own");
    for dialects in [&[][..], &[dialect("iec-ed3")], &[dialect("codesys")]] {
        let explained = ExplainedSaboteurs::read(dialects).expect("the list is readable");
        assert_eq!(explained.unknown_rules(&known), [""; 0]);
    }
    let all = required(&SAMPLE, &DialectName::ALL);
    assert!(
        all.iter()
            .any(|saboteur| saboteur.place == BrokenPlace::Source("in-out"))
    );
    // REAL becomes LREAL in every dialect but matiec, where nothing stands for another type.
    let admitted = |saboteur: &&Saboteur| saboteur.rule.to_string() == "implicit.real-to-lreal.admitted";
    assert!(all.iter().any(|saboteur| admitted(&saboteur)));
}
