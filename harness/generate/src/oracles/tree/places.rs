//! The places in a syntax tree: every span lies in the text and in that of what it is a part of, and covers what the tree says.

use super::visitor::Visitor;
use super::walk::walk;
use stickler_reference::source::Span;
use stickler_reference::syntax::tree::{ExpressionId, Name, SourceUnit};

/// The first thing that is wrong with the places of `unit`, the tree of `text`, in words.
///
/// A span lies inside `text`, between characters. In the tree of a text without errors it covers at least one byte, lies inside
/// the span of the node that it is a part of, and a name's covers exactly the name.
///
/// # Errors
/// What is wrong, where something is.
pub(in crate::oracles) fn hold_places(unit: &SourceUnit<'_>, text: &str, sound: bool) -> Result<(), String> {
    let mut places = Places {
        unit,
        text,
        sound,
        around: Vec::new(),
        wrong: None,
    };
    walk(unit, &mut places);
    places.wrong.map_or(Ok(()), Err)
}

/// Whether a span lies inside the text and between characters.
pub(in crate::oracles) fn is_inside(span: Span, text: &str) -> bool {
    text.get(span.start as usize..span.end as usize).is_some()
}

struct Places<'u, 's> {
    unit: &'u SourceUnit<'s>,
    text: &'u str,
    sound: bool,
    /// The nodes that the next one is a part of.
    around: Vec<Span>,
    wrong: Option<String>,
}

impl Places<'_, '_> {
    fn hold(&mut self, span: Span, what: &str) {
        let outer = self.around.last().copied();
        let fits = |outer: Span| outer.start <= span.start && span.end <= outer.end;
        let message = if !is_inside(span, self.text) {
            "does not lie in the text"
        } else if self.sound && span.start == span.end {
            "covers nothing"
        } else if self.sound && !outer.is_none_or(fits) {
            "does not lie in what it is a part of"
        } else {
            return;
        };
        let around = outer.map_or_else(String::new, |outer| {
            format!(" (that is {}..{})", outer.start, outer.end)
        });
        let (start, end) = (span.start, span.end);
        self.wrong
            .get_or_insert_with(|| format!("{what} at {start}..{end} {message}{around}"));
    }
}

impl Visitor for Places<'_, '_> {
    fn enter(&mut self, span: Span) {
        self.hold(span, "a node");
        self.around.push(span);
    }

    fn leave(&mut self) {
        self.around.pop();
    }

    fn number(&mut self, _: u64) {}

    fn name(&mut self, name: &Name<'_>) {
        self.hold(name.span, "a name");
        if name.span.text(self.text) != name.text {
            let (start, end) = (name.span.start, name.span.end);
            self.wrong
                .get_or_insert_with(|| format!("the name `{}` does not stand at {start}..{end}", name.text));
        }
    }

    fn written(&mut self, _: &str, _: bool) {}

    fn expression(&mut self, id: ExpressionId) {
        match self.unit.expressions.get(id.0 as usize) {
            Some(expression) => self.hold(expression.span, "an expression"),
            None => {
                self.wrong
                    .get_or_insert_with(|| format!("there is no expression {}", id.0));
            }
        }
    }
}
