//! The parts of the site's pages: the frame of a page, escaped text, the bar of a share, the chart of a history.

use crate::claims::Standing;
use crate::page::STYLE;
use crate::text::visible;

/// The styles that only the site has, beside those of a run's page.
const SITE_STYLE: &str = include_str!("site.css");

/// Returns a whole page with this title and body; the body is HTML.
pub fn page(title: &str, body: &str) -> String {
    page_with("", title, body)
}

/// Returns a whole page with further elements in its head; they and the body are HTML.
pub(super) fn page_with(head: &str, title: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <meta name=\"color-scheme\" content=\"light dark\">\n\
         <title>{title}</title>\n{head}<style>\n{STYLE}{SITE_STYLE}</style>\n</head>\n<body>\n\
         <header><h1>{title}</h1></header>\n<main>\n{body}</main>\n</body>\n</html>\n"
    )
}

/// Escapes a text for an element or a quoted attribute.
pub fn escaped(text: &str) -> String {
    visible(text)
        .replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Returns the cell of a table with the share of passed cases, as numbers and as a bar.
pub(super) fn share(standing: Standing) -> String {
    match standing.per_mille() {
        None => "<td class=\"number dim\">–</td>".to_owned(),
        Some(passed) => format!(
            "<td class=\"number\">{} of {}<span class=\"bar\"><span style=\"width: {}.{}%\"></span></span></td>",
            standing.passed,
            standing.decided(),
            passed / 10,
            passed % 10
        ),
    }
}

/// The width of the chart, in pixels of its own scale.
const WIDTH: u64 = 600;
/// The height of the chart; a unit of it is a share of one percent.
const HEIGHT: u64 = 100;

/// Returns the line chart of the shares of passed cases, oldest first; nothing where there are not two of them.
pub(super) fn chart(shares: &[u64]) -> String {
    if shares.len() < 2 {
        return String::new();
    }
    let steps = shares.len() as u64 - 1;
    let mut points = String::new();
    for (at, passed) in shares.iter().enumerate() {
        let x = at as u64 * WIDTH / steps;
        let y = 1000 - passed;
        points.push_str(&format!("{x},{}.{} ", y / 10, y % 10));
    }
    format!(
        "<svg class=\"history\" viewBox=\"-4 -4 {} {}\" role=\"img\" aria-label=\"Share of passed cases, from the oldest run \
         to the newest; the lower edge is 0 %, the upper one 100 %\"><polyline points=\"{}\"/></svg>\n",
        WIDTH + 8,
        HEIGHT + 8,
        points.trim_end()
    )
}

#[cfg(test)]
mod tests {
    use super::{chart, escaped};

    #[test]
    fn markup_of_an_engine_stays_text() {
        assert_eq!(escaped("</script>\"&\u{1b}"), "&lt;/script&gt;&quot;&amp;\\u{1b}");
    }

    #[test]
    fn a_chart_has_its_oldest_run_at_the_left_and_full_marks_at_the_top() {
        assert!(chart(&[0, 755, 1000]).contains("points=\"0,100.0 300,24.5 600,0.0\""));
        assert_eq!(chart(&[500]), "");
    }
}
