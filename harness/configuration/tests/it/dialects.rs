//! Tests of the dialects that a file defines, and of the messages about mistakes in them.

use stickler_types::{
    BitStringText, Dialect, DialectName, ElementaryType, MatrixWord, OutOfRange, RealText, Rounding,
    TextReading,
};

use super::{mistake, read};

/// Returns the definition of the only dialect of a file.
fn defined(text: &str) -> &'static Dialect {
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
    assert_eq!(definition.base, DialectName::IRONPLC_ED3);
    assert_eq!(definition.about.as_deref(), Some("MyPLC 2.1"));
    assert_eq!(definition.place, "stickler.toml:2");
    let cells: Vec<_> = definition
        .cells
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
        definition
            .implicit(Int, Bool)
            .map(|stated| stated.basis.as_deref().unwrap()),
        Some(basis)
    );
    assert_eq!(
        (
            definition.nested_comments,
            definition.basis("flags.line-comments")
        ),
        (false, None)
    );
    assert_eq!(
        definition.basis("conversions.rounding"),
        Some("all-kinds: rounding (stickler.toml:13; https://example.org/manual)")
    );
    let choices = &definition.conversions;
    assert_eq!(choices.rounding, Rounding::HalfAwayFromZero);
    assert_eq!(choices.out_of_range, OutOfRange::Saturate);
    assert_eq!(choices.text_reading, TextReading::LeadingNumber);
    assert_eq!(choices.real_text, RealText::SignificantDigits(6));
    assert_eq!(choices.bit_string_text, BitStringText::Shortest);
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
    assert_eq!(definition.cells.len(), 12);
    assert!(
        definition
            .cells
            .values()
            .all(|stated| stated.value == MatrixWord::Yes)
    );
    let explicit = "[dialects.wide-but]\nextends = \"matiec\"\nflags.allow-cross-family-widening = true\n\
                    implicit.\"BYTE.INT\" = \"no\"\n";
    let cell = defined(explicit)
        .implicit(ElementaryType::Byte, ElementaryType::Int)
        .unwrap();
    assert_eq!(
        (cell.value, cell.basis.as_deref().unwrap()),
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
    assert_eq!(second.base, DialectName::PLCNEXT);
    assert_eq!(second.conversions.rounding, Rounding::Truncate);
    assert_eq!(
        second.basis("conversions.out-of-range"),
        Some("b-second: out-of-range (stickler.toml:8)")
    );
}

#[test]
fn what_is_taken_over_says_nothing_of_types_that_are_taken_away() {
    let configuration = read(
        "[dialects.has-ltime]\nextends = \"ironplc-ed3\"\nimplicit = { \"LTIME.TIME\" = \"yes\", \"TIME.LTIME\" = \"no\", \"INT.SINT\" = \"yes\" }\n\
         [dialects.has-no-ltime]\nextends = \"has-ltime\"\nflags.third-edition-types = false\n",
    )
    .unwrap();
    let definition = configuration.dialects()[1].definition().unwrap();
    let cells: Vec<_> = definition.cells.keys().copied().collect();
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
    assert_eq!(last.base(), DialectName::PLCNEXT);
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
    assert_eq!(defined(text).cells.len(), 1);
}
