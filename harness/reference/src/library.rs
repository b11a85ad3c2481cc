//! The standard function blocks, and the functions of dates and times of day, written in Structured Text in the folder `library`: those that a
//! program uses and does not declare are compiled with it.
//!
//! Basis: iec-61131-3: Tables 35, 36 and 43 to 46.

use std::collections::BTreeSet;
use stickler_syntax::diagnostic::SpannedDiagnostic;
use stickler_syntax::features::standard_block;
use stickler_types::{Code, Dialect, ElementaryType, join};

const TEXTS: [&str; 5] = [
    include_str!("../library/bistable.st"),
    include_str!("../library/edge.st"),
    include_str!("../library/counter.st"),
    include_str!("../library/timer.st"),
    TIME,
];

/// The functions of dates and times of day.
const TIME: &str = include_str!("../library/time.st");

/// The blocks of systems whose inputs are called SET and RESET.
const SET_AND_RESET: &str = include_str!("../library/set_reset.st");

/// The standard functions, function blocks and generic types, and the operators of systems with the form of a call or a type, that are not implemented.
///
/// Basis: iec-61131-3: Tables 22 to 46; codesys-pages: _cds_keywords; strucpp-tests: st-validation/data_types/time_types.st;
/// rusty-lit-tests: tests/lit/single/polymorphism/fnptr; ironplc-repository: compiler/sources/resources/libs.
const NOT_IMPLEMENTED: &str = "BITADR INDEXOF RTC TEST_AND_SET XSIZEOF __COMPARE_AND_SWAP __CURRENTTASK __DELETE __FPOINTER __MOD \
                               __NEW __POOL __POSITION __POUNAME __QUERYINTERFACE __QUERYPOINTER __TRUNC __VARINFO __VECTOR __VOID \
                               __XADD TIME_TO_NS TIME_TO_S TIME_TO_US ANY ANY_BIT ANY_CHARS ANY_DATE ANY_DURATION ANY_ELEMENTARY \
                               ANY_INT ANY_MAGNITUDE ANY_NUM ANY_REAL ANY_SIGNED ANY_STRING ANY_UNSIGNED";

/// Returns whether a name, in any case, is that of a standard function or function block that is not implemented.
pub(crate) fn is_not_implemented(name: &str) -> bool {
    let mut names = NOT_IMPLEMENTED.split(' ');
    names.any(|known| known.eq_ignore_ascii_case(name))
}

/// The types of counters, of which the first one's are written in `library`.
const COUNTED: [ElementaryType; 5] = [
    ElementaryType::Int,
    ElementaryType::Dint,
    ElementaryType::Lint,
    ElementaryType::Udint,
    ElementaryType::Ulint,
];

/// The types of timers, with the global variables in which they find the time that has passed since the start of the program.
pub(crate) const CLOCKS: [(ElementaryType, &str); 2] = [
    (ElementaryType::Time, "stickler_clock"),
    (ElementaryType::Ltime, "stickler_long_clock"),
];

/// Returns a source text with those standard function blocks and functions behind it for whose names diagnostics say that no such type or
/// function is declared; `None` where there are none.
pub(crate) fn with_blocks(
    source: &str,
    diagnostics: &[SpannedDiagnostic],
    dialect: &Dialect,
) -> Option<String> {
    use Code::{
        ArrayElementTypeNotDeclared, FunctionCallUndeclared, NotImplemented, StructFieldTypeNotDeclared,
        UndeclaredUnknownType,
    };
    let undeclared = diagnostics.iter().filter(|one| {
        matches!(
            one.code,
            NotImplemented
                | UndeclaredUnknownType
                | ArrayElementTypeNotDeclared
                | StructFieldTypeNotDeclared
                | FunctionCallUndeclared
        )
    });
    // The name of a library may stand before that of its block.
    let named = undeclared.filter_map(|one| one.span.text(source).rsplit('.').next());
    let named = named.map(str::to_ascii_uppercase);
    let named: BTreeSet<String> = named.collect();
    let has_block = |name: &str| standard_block(name).is_none_or(|feature| !dialect.lacks(feature));
    // The text of TON_LTIME cannot be read where there is no LTIME.
    let has_types = |name: &str| {
        let mut types = name.split('_').filter_map(ElementaryType::from_name);
        types.all(|ty| dialect.may_name(ty))
    };
    let has = |name: &&String| has_block(name) && has_types(name);
    let blocks = named.iter().filter(has).filter_map(|name| block(name, dialect));
    let blocks: Vec<String> = blocks.collect();
    let clocks = CLOCKS.iter().filter(|(_, clock)| {
        let mut blocks = blocks.iter();
        blocks.any(|block| block.contains(clock))
    });
    let clocks = clocks.map(|(ty, clock)| format!("VAR_GLOBAL {clock} : {}; END_VAR", ty.name()));
    let added: Vec<String> = clocks.chain(blocks.iter().cloned()).collect();
    (!added.is_empty()).then(|| format!("{source}\n{}\n", added.join("\n")))
}

/// Returns whether a name is that of a standard function block, of whose variables only inputs and outputs are known to programs.
pub fn has_block(name: &str) -> bool {
    block(&name.to_ascii_uppercase(), &Dialect::DEFAULT).is_some()
}

/// Returns the text of a standard function block by its name in capital letters, such as `CTU` and `CTU_DINT`, as a dialect has it; `None` for
/// other names.
fn block(name: &str, dialect: &Dialect) -> Option<String> {
    let other_inputs = dialect.set_and_reset_inputs.then_some(SET_AND_RESET);
    if let Some(text) = other_inputs.and_then(|text| cut(text, name)) {
        return Some(text.to_owned());
    }
    if let Some((ty, clock)) = CLOCKS
        .iter()
        .find(|(ty, _)| dialect.system_time && ty.name() == name)
    {
        let text = written("STICKLER_TIME")?.replace("TIME", ty.name());
        return Some(text.replace(CLOCKS[0].1, clock));
    }
    let own = |text: &str| match name {
        "F_TRIG" if !dialect.first_call_falls => text.replace("M : BOOL;", "M : BOOL := TRUE;"),
        _ if dialect.counters_stop_at_preset => {
            let text = text.replace("CV < INT#32767", "CV < PV");
            text.replace("CV > INT#-32768", "CV > INT#0")
        }
        _ => text.to_owned(),
    };
    let typed = name.rsplit_once('_').and_then(|(block, ty)| {
        let ty = ElementaryType::from_name(ty)?;
        Some((block, ty))
    });
    match typed {
        Some((block, ty)) if COUNTED.contains(&ty) && block.starts_with("CT") => {
            let (least, greatest) = ty.integer_range()?;
            let text = own(written(block)?).replace("INT#-32768", "{least}");
            let text = text.replace("INT#32767", "{greatest}").replace("INT", ty.name());
            let text = text.replace("{least}", &format!("{}#{least}", ty.name()));
            let text = text.replace("{greatest}", &format!("{}#{greatest}", ty.name()));
            Some(text.replacen(block, name, 1))
        }
        Some((block, ty)) if block.starts_with('T') => {
            let (_, clock) = CLOCKS.iter().find(|(timed, _)| *timed == ty)?;
            let text = written(block)?.replace("TIME", ty.name());
            Some(text.replace(CLOCKS[0].1, clock).replacen(block, name, 1))
        }
        _ => written(name).map(own).or_else(|| long_function(name)),
    }
}

/// Returns the text of a function of the long types by its name, such as `ADD_LTOD_LTIME`.
fn long_function(name: &str) -> Option<String> {
    let short = |word: &str| match word {
        "LTIME" | "LDATE" | "LTOD" | "LDT" => word[1..].to_owned(),
        word => word.to_owned(),
    };
    let text = written(&join(name.split('_').map(short), "_"))?.to_owned();
    let types = ["TIME", "DATE", "TOD", "DT"].into_iter();
    Some(types.fold(text, |text, ty| text.replace(ty, &format!("L{ty}"))))
}

/// Returns the names of the functions that are written in `library`.
pub(crate) fn functions() -> impl Iterator<Item = &'static str> {
    let heads = TIME.lines().filter_map(|line| line.strip_prefix("FUNCTION "));
    heads.filter_map(|head| head.split(' ').next())
}

/// Returns the text of a function block or function that is written in `library`.
fn written(name: &str) -> Option<&'static str> {
    TEXTS.iter().find_map(|text| cut(text, name))
}

/// Returns the function block or function of a name out of a text.
fn cut<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    let heads = ["FUNCTION_BLOCK", "FUNCTION"].into_iter();
    heads
        .flat_map(|unit| ["\n", " :"].map(|behind| (unit, format!("{unit} {name}{behind}"))))
        .find_map(|(unit, head)| {
            let (behind, end) = (&text[text.find(&head)?..], format!("END_{unit}"));
            behind.find(&end).map(|at| &behind[..at + end.len()])
        })
}
