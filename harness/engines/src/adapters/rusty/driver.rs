//! The C program that runs a compiled one, and the calls by which that one shows what is observed of it.
//!
//! Basis: rusty: book, *External Functions*: a function that is declared `{external}` is one of C; `VAR_INPUT {ref}` takes the
//! address. Integers and bit strings have their width, BOOL a byte, durations and dates are nanoseconds in 64 bits, texts end
//! with a zero.

use crate::RunRequest;
use crate::adapters::driver::{Driven, Driver};
use crate::adapters::printed::{self, Kind};
use crate::adapters::source::{MainProgram, words};
use std::collections::BTreeMap;
use std::fmt::Write;
use stickler_types::{ElementaryType, Value};

/// The headers that the driver includes.
pub(super) const HEADER: &str = "#include <stdint.h>\n#include <stdio.h>\n#include <string.h>\n";

/// What the main program is called in what is compiled.
const PROGRAM: &str = "stickler_program";

/// The function that runs one scan.
const SCAN: &str = "stickler_scan";

const PRINTERS: &str = "\
static unsigned long scan;
static void print_bits(int32_t number, const void *value, size_t size) {
    unsigned long long bits = 0;
    memcpy(&bits, value, size);
    if (after[number] == scan) printf(\"%d %llx\\n\", (int)number, bits);
}
static void print_bytes(int32_t number, const unsigned char *text) {
    if (after[number] != scan) return;
    printf(\"%d '\", (int)number);
    for (; *text; text++) printf(\"%04x\", *text);
    printf(\"\\n\");
}
static void print_units(int32_t number, const uint16_t *text) {
    if (after[number] != scan) return;
    printf(\"%d '\", (int)number);
    for (; *text; text++) printf(\"%04x\", *text);
    printf(\"\\n\");
}
";

/// The driver of a request.
///
/// # Errors
/// A fragment that says what cannot be observed or set.
pub(super) fn driver<'r>(request: &RunRequest<'r>) -> Result<Driver<'r>, String> {
    if !(request.clock.is_empty() && request.set.is_empty()) {
        return Err("its driver takes neither a clock nor values between scans".to_owned());
    }
    let kinds = printed::kinds(request, |_| true)?;
    let after: Vec<String> = request
        .observe
        .iter()
        .map(|asked| format!("{}UL", asked.after.unwrap_or(request.scans)))
        .collect();
    // C has no empty arrays.
    let after = if after.is_empty() {
        "0".to_owned()
    } else {
        after.join(", ")
    };
    let mut text = format!(
        "#include \"stickler.h\"\nstatic const unsigned long after[] = {{{after}}};\n{PRINTERS}int32_t {SCAN}(void);\n"
    );
    for (name, ty) in shown(&kinds) {
        // Writing into a String does not fail.
        let _ = match ty {
            ElementaryType::String => writeln!(
                text,
                "int32_t {name}(int32_t number, unsigned char *value) {{ print_bytes(number, value); return 0; }}"
            ),
            ElementaryType::Wstring => writeln!(
                text,
                "int32_t {name}(int32_t number, uint16_t *value) {{ print_units(number, value); return 0; }}"
            ),
            _ => writeln!(
                text,
                "int32_t {name}(int32_t number, {} value) {{ print_bits(number, &value, sizeof value); return 0; }}",
                of_c(ty)
            ),
        };
    }
    let _ = write!(
        text,
        "int main(void) {{\n    for (scan = 1; scan <= {}UL; scan++) {SCAN}();\n    return 0;\n}}\n",
        request.scans
    );
    Ok(Driver {
        text,
        subjects: vec![Driven {
            request: *request,
            kinds,
        }],
        read: value,
        faults: &[],
    })
}

/// The type of a value as it is shown. The values of an enumeration are numbers.
fn shown_as(kind: &Kind<'_>) -> ElementaryType {
    match kind {
        Kind::Elementary(ty) => *ty,
        Kind::Enumerated(..) => ElementaryType::Dint,
    }
}

/// The functions by which values are shown, each once, and the type that each takes.
fn shown(kinds: &[Kind<'_>]) -> BTreeMap<String, ElementaryType> {
    let function = |kind: &Kind<'_>| (function(kind), shown_as(kind));
    kinds.iter().map(function).collect()
}

fn function(kind: &Kind<'_>) -> String {
    format!("stickler_show_{}", shown_as(kind).name().to_ascii_lowercase())
}

/// The type of C that has the bits of a value.
fn of_c(ty: ElementaryType) -> &'static str {
    match ty {
        ElementaryType::Real => "float",
        ElementaryType::Lreal => "double",
        ElementaryType::Char => "uint8_t",
        ElementaryType::Wchar => "uint16_t",
        _ if ty.is_duration() || ty.is_date_or_time() => "int64_t",
        _ => match ty.bits() {
            0..=8 => "uint8_t",
            9..=16 => "uint16_t",
            17..=32 => "uint32_t",
            _ => "uint64_t",
        },
    }
}

/// The program with the calls that show what is observed. Each line stays the line that it was.
pub(super) fn instrumented(request: &RunRequest<'_>, main: &MainProgram, kinds: &[Kind<'_>]) -> String {
    let source = request.source;
    let mut text = renamed(&source[..main.inside.end], &main.name);
    for (number, (asked, kind)) in request.observe.iter().zip(kinds).enumerate() {
        // Writing into a String does not fail.
        let _ = write!(text, "{}({number}, {}); ", function(kind), asked.name);
    }
    text.push_str(&renamed(&source[main.inside.end..], &main.name));
    for (name, ty) in shown(kinds) {
        let by = if ty.is_text() { " {ref}" } else { "" };
        let _ = write!(
            text,
            "\n{{external}} FUNCTION {name} : DINT VAR_INPUT number : DINT; END_VAR VAR_INPUT{by} value : {ty}; END_VAR \
             END_FUNCTION"
        );
    }
    let _ = write!(text, "\nFUNCTION {SCAN} : DINT {PROGRAM}(); END_FUNCTION\n");
    text
}

/// The text with another name for the main program.
fn renamed(text: &str, name: &str) -> String {
    let mut changed = String::with_capacity(text.len());
    let mut at = 0;
    for word in words(text).filter(|word| word.is(name)) {
        changed.push_str(&text[at..word.at]);
        changed.push_str(PROGRAM);
        at = word.at + word.text.len();
    }
    changed.push_str(&text[at..]);
    changed
}

/// A value as it was printed; `None` where that is nonsense.
fn value(kind: &Kind<'_>, shown: &str) -> Option<Value> {
    let bits = || u64::from_str_radix(shown, 16).ok();
    match kind {
        Kind::Enumerated(..) => kind.enumerated(bits()?),
        Kind::Elementary(ty) if ty.is_text() && shown.starts_with('\'') => {
            Some(Value::text(*ty, printed::units(shown.strip_prefix('\'')?)?))
        }
        Kind::Elementary(ty) if ty.is_duration() || ty.is_date_or_time() => Some(Value::plain(*ty, bits()?)),
        Kind::Elementary(ty) => Some(Value::plain(*ty, printed::raw(*ty, bits()?))),
    }
}
