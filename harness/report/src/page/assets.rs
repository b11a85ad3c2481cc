//! The parts of the page that are the same for every run.

/// The style sheet.
pub(crate) const STYLE: &str = include_str!("page.css");

/// The scripts. Each file declares functions; the last one runs them.
pub(super) const SCRIPTS: [&str; 18] = [
    include_str!("dom.js"),
    include_str!("address.js"),
    include_str!("data.js"),
    include_str!("program.js"),
    include_str!("conversions.js"),
    include_str!("system.js"),
    include_str!("explorer.js"),
    include_str!("curves.js"),
    include_str!("plots.js"),
    include_str!("matrices.js"),
    include_str!("bits.js"),
    include_str!("contradictions.js"),
    include_str!("claims.js"),
    include_str!("causes.js"),
    include_str!("cases.js"),
    include_str!("observations.js"),
    include_str!("site.js"),
    include_str!("main.js"),
];

/// The skeleton of the page, in which three marks stand for what is put in.
const SKELETON: &str = include_str!("page.html");

/// Returns the four parts of the skeleton: before the style, before the data, before the scripts, and the rest.
pub(super) fn skeleton() -> (&'static str, &'static str, &'static str, &'static str) {
    let parts = SKELETON.split_once("{style}").and_then(|(before_style, rest)| {
        let (before_data, rest) = rest.split_once("{data}")?;
        let (before_script, end) = rest.split_once("{script}")?;
        Some((before_style, before_data, before_script, end))
    });
    parts.expect("the skeleton has its three marks, as a test sees")
}
