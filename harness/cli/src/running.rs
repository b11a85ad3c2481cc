//! Chooses which program of a text runs.

use anyhow::ensure;
use stickler_syntax::tree::PouKind;
use stickler_types::{Dialect, DialectName};

/// Returns a text with a configuration that runs a PROGRAM, in place of those that it has; their global variables stay where they are.
///
/// # Errors
/// No PROGRAM of this name.
pub fn running(text: &str, name: &str, dialect: DialectName) -> anyhow::Result<String> {
    let (unit, _) = stickler_syntax::parse(text, Dialect::of(dialect));
    let mut programs = unit.pous().filter(|pou| pou.kind == PouKind::Program);
    ensure!(
        programs.any(|pou| pou.name.is(name)),
        "there is no PROGRAM `{name}`"
    );
    let mut running = String::with_capacity(text.len());
    let blank = |text: &str| text.replace(|character| character != '\n', " ");
    let mut at = 0;
    for configuration in unit.configurations() {
        running.push_str(&text[at..configuration.span.start as usize]);
        at = configuration.span.start as usize;
        for globals in &configuration.globals {
            running.push_str(&blank(&text[at..globals.span.start as usize]));
            running.push_str(globals.span.text(text));
            at = globals.span.end as usize;
        }
        running.push_str(&blank(&text[at..configuration.span.end as usize]));
        at = configuration.span.end as usize;
    }
    running.push_str(&text[at..]);
    running.push_str(&format!(
        "\nCONFIGURATION stickler RESOURCE here ON this PROGRAM {name} : {name}; END_RESOURCE END_CONFIGURATION\n"
    ));
    Ok(running)
}
