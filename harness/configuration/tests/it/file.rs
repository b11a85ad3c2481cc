//! Tests of files as people write them, and of the messages about mistakes in them.

use std::fs;
use std::path::Path;
use stickler_configuration::{Configuration, EngineEntry, EngineKind};
use stickler_engines::{Compiler, DependencyPaths};
use stickler_types::definition::Flag;
use stickler_types::{
    BitStringText, BuiltIn, Definition, ElementaryType, MatrixWord, OutOfRange, RealText, Rounding,
    TextReading,
};

/// Returns the configuration of a temporary folder whose file has this text.
fn read(text: &str) -> Result<Configuration, String> {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("stickler.toml"), text).unwrap();
    Configuration::find(folder.path()).map_err(|error| error.to_string())
}

fn mistake(text: &str) -> String {
    read(text).unwrap_err()
}

#[test]
fn a_compiler_gets_its_places_and_each_knows_where_it_is_written() {
    let folder = tempfile::tempdir().unwrap();
    let text = "# Ours.\n[engines.ironplc]\nironplcc = \"bin/ironplcc\"\n\n[engines.old]\nadapter = \"ironplc\"\n\
                ironplcvm = \"/opt/old/ironplcvm\"\n";
    fs::write(folder.path().join("stickler.toml"), text).unwrap();
    let configuration = Configuration::find(folder.path()).unwrap();
    let Some(EngineEntry {
        written,
        kind: EngineKind::Compiler { compiler, places },
    }) = configuration.engine("ironplc")
    else {
        panic!("no compiler")
    };
    assert_eq!(
        (written.as_str(), *compiler),
        ("stickler.toml:2", Compiler::Ironplc)
    );
    let path = folder.path().join("bin/ironplcc");
    let expected = DependencyPaths::default().named("ironplcc", path, "stickler.toml:3".to_owned());
    assert_eq!(*places, expected);
    // Of a second version, environment variables say nothing.
    let Some(EngineKind::Compiler { places, .. }) = configuration.engine("old").map(|entry| &entry.kind)
    else {
        panic!("no compiler")
    };
    let expected = DependencyPaths::default()
        .named(
            "ironplcvm",
            "/opt/old/ironplcvm".into(),
            "stickler.toml:7".to_owned(),
        )
        .without_variables();
    assert_eq!(*places, expected);
    let names: Vec<&str> = configuration.engines().map(|(name, _)| name).collect();
    assert_eq!(names, ["ironplc", "old"]);
    assert_eq!(configuration.folder(), Some(folder.path()));
}

#[test]
fn a_command_line_is_an_engine() {
    let configuration = read("[engines.mine]\ncommand = \"python3 adapter.py\"\n").unwrap();
    let kind = configuration.engine("mine").map(|entry| &entry.kind);
    assert!(matches!(kind, Some(EngineKind::Command { line }) if line == "python3 adapter.py"));
}

#[test]
fn the_file_of_a_folder_above_counts_and_none_is_none() {
    let folder = tempfile::tempdir().unwrap();
    let inside = folder.path().join("a/b");
    fs::create_dir_all(&inside).unwrap();
    fs::write(
        folder.path().join("stickler.toml"),
        "[engines.mine]\ncommand = \"x\"\n",
    )
    .unwrap();
    let configuration = Configuration::find(&inside).unwrap();
    let written = &configuration.engine("mine").unwrap().written;
    assert!(
        written.ends_with("stickler.toml:1") && Path::new(written).is_absolute(),
        "{written}"
    );
    let empty = read("").unwrap();
    assert_eq!(empty.engines().count(), 0);
    assert!(empty.path().is_some());
}

#[test]
fn a_mistake_is_told_with_its_place_and_what_was_meant() {
    for (text, reported) in [
        (
            "[engine.mine]\n",
            "stickler.toml:1:2: unknown key `engine` of the file; did you mean `engines`?",
        ),
        (
            "engines = 5\n",
            "stickler.toml:1:11: `engines` must be a table, and this is of type integer",
        ),
        (
            "[engines.matiec]\nic2c = \"/x\"\n",
            "stickler.toml:2:1: unknown key `ic2c` of `[engines.matiec]`, which has the adapter `matiec`; did you mean `iec2c`?",
        ),
        (
            "[engines.matiec]\niec2c = 5\n",
            "stickler.toml:2:9: `iec2c` must be a text in quotes, and this is of type integer",
        ),
        (
            "[engines.mine]\nadapter = \"iron\"\n",
            "stickler.toml:2:11: there is no adapter `iron`; there are `ironplc`, `matiec`, `rusty` and `strucpp`",
        ),
        (
            "[engines.mine]\ncommand = \"x\"\ncommands = \"y\"\n",
            "stickler.toml:3:1: unknown key `commands` of `[engines.mine]`; did you mean `command`?",
        ),
        (
            "[engines.mine]\ncomand = \"x\"\n",
            "stickler.toml:2:1: unknown key `comand` of `[engines.mine]`; did you mean `command`?",
        ),
        (
            "[engines.mine]\ncheck = \"st {fiel}\"\n",
            "stickler.toml:2:9: `{fiel}` stands for nothing; there are `{file}`, `{dialect}`, `{folder}`, `{scans}`, `{here}`",
        ),
        (
            "[engines.mine]\ncheck = \"st\"\ndialects.matiec = \"\"\nrun = \"st\"\n",
            "stickler.toml:4:1: `run` needs a `value`: how a value is printed, as in '^(?<name>\\w+) = (?<value>.*)$' (of \
             `[engines.mine]`)",
        ),
        (
            "[engines.reference]\n",
            "stickler.toml:1:10: `reference` is the engine that is always there; give this one another name",
        ),
    ] {
        assert_eq!(mistake(text), reported);
    }
    for (text, part) in [
        ("[engines.\"a b\"]\n", "`a b` cannot be the name of an engine"),
        ("[engines.mine]\n", "does not say what the engine is"),
        ("[engines.mine\n", "stickler.toml:1:"),
        // Those that other tests define may follow.
        (
            "[engines.mine]\ncheck = \"st\"\n[engines.mine.dialects]\nmatic = \"\"\n",
            "stickler.toml:4:1: unknown dialect `matic`; the dialects are `ironplc-ed2`, `ironplc-ed3`, `ironplc-rusty`, \
             `matiec`",
        ),
        ("[engines.mine]\ncommand = 1\n", "stickler.toml:2:11: "),
    ] {
        let reported = mistake(text);
        assert!(reported.contains(part), "{reported}");
    }
}

#[test]
fn a_file_that_cannot_be_read_is_named() {
    let error = Configuration::read(Path::new("no/such/file.toml")).unwrap_err();
    assert_eq!(error.to_string(), "cannot read no/such/file.toml");
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("stickler.toml");
    fs::write(&path, b"\xff\xfe").unwrap();
    assert!(Configuration::read(&path).is_err());
}

#[test]
fn a_compiler_can_be_described() {
    let readme = include_str!("../../engines/README.md");
    let (_, example) = readme.split_once("```toml\n[engines.described]").unwrap();
    let (example, _) = example.split_once("```").unwrap();
    let configuration = read(&format!("[engines.described]{example}")).unwrap();
    let kind = configuration.engine("described").map(|entry| &entry.kind);
    assert!(matches!(kind, Some(EngineKind::Described(_))), "{kind:?}");
}

/// Returns the definition of the only dialect of a file.
fn defined(text: &str) -> &'static Definition {
    let configuration = read(text).unwrap();
    assert_eq!(configuration.dialects().len(), 1);
    configuration.dialects()[0].definition().unwrap()
}

#[test]
fn a_dialect_states_what_it_overrides_and_each_knows_where() {
    let definition = defined(
        r#"
[dialects.all-kinds]
extends = "ironplc-ed3"
about = "MyPLC 2.1"
source = "https://example.org/manual"
[dialects.all-kinds.implicit]
"INT.BOOL" = "yes"
SINT.INT = "no"
SINT.DINT = "open"
[dialects.all-kinds.flags]
nested-comments = false
[dialects.all-kinds.conversions]
rounding = "half-away-from-zero"
out-of-range = "saturate"
text-reading = "leading-number"
real-text = 6
bit-string-text = "shortest"
truncation-out-of-range = "indefinite-32"
moment-text = "components"
bits-as-real = "copy"
bit-string-as-bool = "lowest-bit"
moment-units = "counts"
[dialects.all-kinds.operators]
implicit-warnings = "lost-values"
operands = "promoted"
compared = "of-one-kind"
result-signs = "of-operator"
constant-types = "least"
shift-counts = "low-bits"
"#,
    );
    use ElementaryType::{Bool, Dint, Int, Sint};
    assert_eq!(definition.base, BuiltIn::IronplcEd3);
    assert_eq!(definition.about.as_deref(), Some("MyPLC 2.1"));
    assert_eq!(definition.place, "stickler.toml:2");
    let cells: Vec<_> = definition
        .implicit
        .iter()
        .map(|(pair, stated)| (*pair, stated.value))
        .collect();
    assert_eq!(
        cells,
        [
            ((Sint, Int), MatrixWord::No),
            ((Sint, Dint), MatrixWord::Open),
            ((Int, Bool), MatrixWord::Yes)
        ]
    );
    let basis = "all-kinds: implicit INT.BOOL (stickler.toml:7; https://example.org/manual)";
    assert_eq!(
        definition.implicit(Int, Bool).map(|stated| &*stated.basis),
        Some(basis)
    );
    assert_eq!(definition.flag(Flag::NestedComments), Some(false));
    assert_eq!(definition.flag(Flag::LineComments), None);
    let stated = definition.rounding.as_ref().unwrap();
    assert_eq!(stated.value, Rounding::HalfAwayFromZero);
    assert_eq!(
        stated.basis,
        "all-kinds: rounding (stickler.toml:13; https://example.org/manual)"
    );
    assert_eq!(
        definition.out_of_range.as_ref().unwrap().value,
        OutOfRange::Saturate
    );
    assert_eq!(
        definition.text_reading.as_ref().unwrap().value,
        TextReading::LeadingNumber
    );
    assert_eq!(
        definition.real_text.as_ref().unwrap().value,
        RealText::SignificantDigits(6)
    );
    assert_eq!(
        definition.bit_string_text.as_ref().unwrap().value,
        BitStringText::Shortest
    );
    // Each of them is there, and is written as the file has it.
    let overrides = definition.overrides();
    for line in [
        "truncation-out-of-range = indefinite-32",
        "moment-text = components",
        "bits-as-real = copy",
        "bit-string-as-bool = lowest-bit",
        "moment-units = counts",
        "implicit-warnings = lost-values",
        "operands = promoted",
        "compared = of-one-kind",
        "result-signs = of-operator",
        "constant-types = least",
        "shift-counts = low-bits",
    ] {
        assert!(
            overrides.iter().any(|known| known == line),
            "{line} in {overrides:?}"
        );
    }
}

#[test]
fn a_dialect_takes_over_the_operators_of_the_one_that_it_extends() {
    let configuration = read(
        r#"
[dialects.first-operators]
extends = "codesys"
operators.shift-counts = "all-bits"
operators.operands = "one-of-theirs"
flags.division-stops = false
[dialects.second-operators]
extends = "first-operators"
operators.operands = "promoted"
"#,
    )
    .unwrap();
    let second = configuration.dialects()[1].definition().unwrap();
    let overrides = second.overrides();
    assert_eq!(
        overrides,
        [
            "division-stops = false",
            "operands = promoted",
            "shift-counts = all-bits"
        ]
    );
}

#[test]
fn cross_family_widening_is_another_word_for_its_cells() {
    let definition =
        defined("[dialects.wide]\nextends = \"matiec\"\nflags.allow-cross-family-widening = true\n");
    // BYTE into six integer types, WORD into four, DWORD into two.
    assert_eq!(definition.implicit.len(), 12);
    assert!(
        definition
            .implicit
            .values()
            .all(|stated| stated.value == MatrixWord::Yes)
    );
    let explicit = "[dialects.wide-but]\nextends = \"matiec\"\nflags.allow-cross-family-widening = true\n\
                    implicit.\"BYTE.INT\" = \"no\"\n";
    let cell = defined(explicit)
        .implicit(ElementaryType::Byte, ElementaryType::Int)
        .unwrap();
    assert_eq!(
        (cell.value, &*cell.basis),
        (MatrixWord::No, "wide-but: implicit BYTE.INT (stickler.toml:4)")
    );
}

#[test]
fn a_dialect_extends_another_of_the_file_wherever_that_stands() {
    let configuration = read(
        "[dialects.b-second]\nextends = \"a-first\"\nconversions.rounding = \"truncate\"\n\
         [dialects.a-first]\nextends = \"plcnext\"\n\
         [dialects.a-first.conversions]\nrounding = \"half-to-even\"\nout-of-range = \"saturate\"\n",
    )
    .unwrap();
    let [second, first] = configuration.dialects() else {
        panic!("two dialects")
    };
    assert!(second.as_str() == "b-second" && first.as_str() == "a-first");
    let second = second.definition().unwrap();
    assert_eq!(second.base, BuiltIn::Plcnext);
    assert_eq!(second.rounding.as_ref().unwrap().value, Rounding::Truncate);
    let taken_over = second.out_of_range.as_ref().unwrap();
    assert_eq!(taken_over.basis, "b-second: out-of-range (stickler.toml:8)");
}

#[test]
fn what_is_taken_over_says_nothing_of_types_that_are_taken_away() {
    let configuration = read(
        "[dialects.has-ltime]\nextends = \"ironplc-ed3\"\nimplicit = { \"LTIME.TIME\" = \"yes\", \"TIME.LTIME\" = \"no\", \"INT.SINT\" = \"yes\" }\n\
         [dialects.has-no-ltime]\nextends = \"has-ltime\"\nflags.third-edition-types = false\n",
    )
    .unwrap();
    let definition = configuration.dialects()[1].definition().unwrap();
    let cells: Vec<_> = definition.implicit.keys().copied().collect();
    assert_eq!(cells, [(ElementaryType::Int, ElementaryType::Sint)]);
}

#[test]
fn a_file_may_have_many_dialects_and_be_read_twice() {
    let many: String = (0..300)
        .map(|number| format!("[dialects.many-{number}]\nextends = \"matiec\"\n"))
        .collect();
    assert_eq!(read(&many).unwrap().dialects().len(), 300);
    assert_eq!(read(&many).unwrap().dialects(), read(&many).unwrap().dialects());
    let chain: String = (1..300)
        .map(|number| format!("[dialects.chain-{number}]\nextends = \"chain-{}\"\n", number - 1))
        .collect();
    let chain = format!("{chain}[dialects.chain-0]\nextends = \"plcnext\"\n");
    let last = read(&chain).unwrap().dialects()[298];
    assert_eq!(last.base(), BuiltIn::Plcnext);
    assert_eq!(read("[dialects]\n").unwrap().dialects(), []);
}

#[test]
fn an_engine_may_speak_a_dialect_of_the_file() {
    let text = "[engines.mine]\ncheck = \"stc {file}\"\n[engines.mine.dialects]\nspoken = \"--spoken\"\n\
                [dialects.spoken]\nextends = \"matiec\"\n";
    assert!(read(text).is_ok());
    let message = mistake(&text.replace("\nspoken =", "\nnot-spoken ="));
    assert!(message.contains("unknown dialect `not-spoken`"), "{message}");
}

#[test]
fn a_mistake_in_a_dialect_is_told_with_its_place_and_the_word_that_was_meant() {
    let table = |rest: &str| format!("[dialects.wrong]\nextends = \"ironplc-ed2\"\n{rest}\n");
    for (text, said) in [
        (
            table("exends = 5"),
            "3:1: unknown key `exends` of `[dialects.wrong]`; did you mean `extends`?",
        ),
        (
            "[dialects.wrong]\n".to_owned(),
            "1:11: `[dialects.wrong]` does not say which dialect it extends",
        ),
        (
            "[dialects.wrong]\nextends = \"matiek\"\n".to_owned(),
            "2:11: there is no dialect `matiek` to extend; did you mean `matiec`?",
        ),
        (
            "[dialects.wrong]\nextends = \"wrong\"\n".to_owned(),
            "2:11: `wrong` cannot extend itself",
        ),
        (
            "[dialects.wrong]\nextends = \"other\"\n[dialects.other]\nextends = \"wrong\"\n".to_owned(),
            "4:11: `other` extends itself by way of others",
        ),
        (
            "[dialects.wrong]\nextends = 5\n".to_owned(),
            "2:11: `extends` must be a text in quotes",
        ),
        (
            "[dialects.Matiec]\nextends = \"matiec\"\n".to_owned(),
            "1:11: there is a dialect `matiec` already",
        ),
        (
            "[dialects.\"a b\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `a b` cannot be the name of a dialect",
        ),
        (
            "[dialects.\"a@b\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `a@b` cannot be",
        ),
        (
            "[dialects.\"a*\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `a*` cannot be",
        ),
        (
            "[dialects.\"a,b\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `a,b` cannot be",
        ),
        (
            "[dialects.\"größer\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `größer` cannot be",
        ),
        (
            "[dialects.\"\\u0007\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `\\u{7}` cannot be",
        ),
        (
            "[dialects.\"\"]\nextends = \"matiec\"\n".to_owned(),
            "1:11: `` cannot be",
        ),
        (
            format!("[dialects.{}]\nextends = \"matiec\"\n", "a".repeat(65)),
            "1:11: `aaa",
        ),
        ("dialects = 5\n".to_owned(), "1:12: `dialects` must be a table"),
        (
            "[dialects]\nwrong = \"matiec\"\n".to_owned(),
            "2:9: `dialects.wrong` must be a table",
        ),
        (
            "[dialect.mine]\n".to_owned(),
            "1:2: unknown key `dialect` of the file; did you mean `dialects`?",
        ),
        (table("about = \"a\\nb\""), "3:9: `about` must be one line"),
        (
            table("implicit.\"INTT.BOOL\" = \"no\""),
            "3:10: there is no type `INTT`; did you mean `INT`?",
        ),
        (
            table("implicit.INT.BOL = \"no\""),
            "3:14: there is no type `BOL`; did you mean `BOOL`?",
        ),
        (
            table("implicit.\"INT\" = \"no\""),
            "3:10: `INT` names no pair of types",
        ),
        (
            table("implicit.INT.BOOL = \"no\"\nimplicit.\"INT.BOOL\" = \"yes\""),
            "4:10: `INT.BOOL` has a word already",
        ),
        (
            table("implicit.\"INT.INT\" = \"no\""),
            "3:10: `INT.INT` needs no word",
        ),
        (
            table("implicit.\"INT.BOOL\" = \"error\""),
            "3:23: `INT.BOOL` is not `error`; there is `yes`, `warn`, `no` and `open`",
        ),
        (
            table("implicit.\"INT.BOOL\" = \"yess\""),
            "3:23: `INT.BOOL` is not `yess`; did you mean `yes`?",
        ),
        (
            table("implicit.\"INT.BOOL\" = true"),
            "3:23: `INT.BOOL` must be a text in quotes",
        ),
        (
            table("implicit.\"DATE.TIME\" = \"yes\""),
            "3:24: `DATE.TIME` cannot be `yes`; there is no conversion",
        ),
        (
            table("implicit.\"TIME.LTIME\" = \"yes\""),
            "3:10: `wrong` has no type LTIME, for ironplc-ed2 has none",
        ),
        (
            table("flags.bit-acess = true"),
            "3:7: unknown key `bit-acess` of `[dialects.wrong.flags]`; did you mean `bit-access`?",
        ),
        (
            table("flags.bit-access = \"no\""),
            "3:20: `bit-access` must be true or false, and this is of type string",
        ),
        (
            table("conversions.roundin = \"truncate\""),
            "3:13: unknown key `roundin` of `[dialects.wrong.conversions]`; did you mean `rounding`?",
        ),
        (
            table("conversions.rounding = \"truncat\""),
            "3:24: `rounding` is not `truncat`; did you mean `truncate`?",
        ),
        (
            table("operators.operand = \"promoted\""),
            "3:11: unknown key `operand` of `[dialects.wrong.operators]`; did you mean `operands`?",
        ),
        (
            table("operators.operands = \"promote\""),
            "3:22: `operands` is not `promote`; did you mean `promoted`?",
        ),
        (
            table("operators.shift-counts = 5"),
            "3:26: `shift-counts` must be a text in quotes, and this is of type integer",
        ),
        (
            table("conversions.moment-units = \"count\""),
            "3:28: `moment-units` is not `count`; did you mean `counts`?",
        ),
        (
            table("flags.division-stop = true"),
            "3:7: unknown key `division-stop` of `[dialects.wrong.flags]`; did you mean `division-stops`?",
        ),
        (
            table("conversions.real-text = 0"),
            "3:25: `real-text` is \"shortest\", \"by-width\", or a number of significant digits from 1 to 40",
        ),
        (
            table("conversions.real-text = \"long\""),
            "3:25: `real-text` is \"shortest\"",
        ),
    ] {
        let message = mistake(&text);
        assert!(
            message.contains(&format!("stickler.toml:{said}")),
            "{text}{message}"
        );
    }
}

#[test]
fn a_dialect_may_be_given_the_types_of_the_third_edition() {
    let text = "[dialects.longer]\nextends = \"ironplc-ed2\"\nflags.third-edition-types = true\n\
                implicit.\"TIME.LTIME\" = \"yes\"\n";
    assert_eq!(defined(text).implicit.len(), 1);
}
