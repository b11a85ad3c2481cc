//! Spans in a syntax tree: every span lies in the text and in that of its parent, and covers the text of its node.

use stickler_syntax::names::{declared, used};
use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, ExpressionKind, Initializer, InitializerKind, Name, Pou, SourceUnit, Statement,
    TypeSpecification, TypeSpecificationKind, VariableBlock, VariableGroup,
};
use stickler_syntax::visitor::{Context, Part, Visitor, operands, walk};

/// Checks the spans of `unit`, the tree of `text`.
///
/// A span lies inside `text`, between characters. In the tree of a text without errors (`sound`) it covers at least one byte
/// and lies inside the span of its parent, and the span of a name covers exactly the name.
///
/// # Errors
/// The first violation, in words.
pub(super) fn check_spans(unit: &SourceUnit<'_>, text: &str, sound: bool) -> Result<(), String> {
    let mut checker = SpanChecker {
        text,
        sound,
        violation: None,
    };
    walk(unit, &mut checker);
    // Expressions that an error has left out of the tree are only in the arena.
    for expression in &unit.expressions {
        checker.node("an expression", expression.span, Some(expression.span));
        for (part, _) in operands(expression) {
            match unit.expression(part) {
                Some(part) => checker.node("an expression", part.span, Some(expression.span)),
                None => checker.report(format!("there is no expression {}", part.0)),
            }
        }
    }
    let names = declared(unit).into_iter().map(|declared| declared.name);
    for name in names.chain(used(unit).into_iter().map(|used| used.name)) {
        checker.name(&name, None);
    }
    checker.violation.map_or(Ok(()), Err)
}

/// Returns whether a span lies inside the text and between characters.
pub(super) fn is_inside(span: Span, text: &str) -> bool {
    text.get(span.start as usize..span.end as usize).is_some()
}

struct SpanChecker<'s> {
    text: &'s str,
    sound: bool,
    /// The first violation.
    violation: Option<String>,
}

impl SpanChecker<'_> {
    fn report(&mut self, violation: String) {
        self.violation.get_or_insert(violation);
    }

    /// Checks a name as a part of a node at `outer`.
    fn name(&mut self, name: &Name<'_>, outer: Option<Span>) {
        self.node("a name", name.span, outer);
        let Span { start, end } = name.span;
        if name.span.text(self.text) != name.text {
            self.report(format!(
                "the name `{}` does not stand at {start}..{end}",
                name.text
            ));
        }
    }

    /// Checks a node at `span` as a child of one at `outer`.
    fn node(&mut self, what: &str, span: Span, outer: Option<Span>) {
        let outer = outer.unwrap_or(Span::new(0, u32::MAX));
        let message = if !is_inside(span, self.text) {
            "does not lie in the text"
        } else if self.sound && span.start == span.end {
            "covers nothing"
        } else if self.sound && !(outer.start <= span.start && span.end <= outer.end) {
            "does not lie in what it is a part of"
        } else {
            return;
        };
        let (Span { start, end }, from, to) = (span, outer.start, outer.end);
        self.report(format!("{what} at {start}..{end} {message} ({from}..{to})"));
    }
}

impl<'t, 's: 't> Visitor<'t, 's> for SpanChecker<'_> {
    fn pou(&mut self, pou: &'t Pou<'s>, at: &Context<'t, 's>) {
        self.node("a program organization unit", pou.span, at.outer);
        self.name(&pou.name, Some(pou.span));
        self.node("the closing keyword", pou.end, Some(pou.span));
    }

    fn section(&mut self, section: &'t VariableBlock<'s>, at: &Context<'t, 's>) {
        self.node("a variable section", section.span, at.outer);
    }

    fn variables(&mut self, group: &'t VariableGroup<'s>, at: &Context<'t, 's>) {
        group.names.iter().for_each(|name| self.name(name, at.outer));
    }

    fn specification(&mut self, specification: &'t TypeSpecification<'s>, at: &Context<'t, 's>) {
        self.node("a type", specification.span, at.outer);
        let outer = Some(specification.span);
        match &specification.kind {
            TypeSpecificationKind::Named(name)
            | TypeSpecificationKind::Text { name, .. }
            | TypeSpecificationKind::Subrange { base: name, .. } => self.name(name, outer),
            TypeSpecificationKind::Enumeration { base, values } => {
                base.iter().for_each(|name| self.name(name, outer));
                values.iter().for_each(|(name, _)| self.name(name, outer));
            }
            TypeSpecificationKind::Array { .. }
            | TypeSpecificationKind::VariableLengthArray { .. }
            | TypeSpecificationKind::Pointer { .. }
            | TypeSpecificationKind::Structure(_)
            | TypeSpecificationKind::Union(_)
            | TypeSpecificationKind::Error => {}
        }
    }

    fn initializer(&mut self, initializer: &'t Initializer<'s>, at: &Context<'t, 's>) {
        self.node("an initial value", initializer.span, at.outer);
        if let InitializerKind::Structure(fields) = &initializer.kind {
            fields
                .iter()
                .for_each(|(name, _)| self.name(name, Some(initializer.span)));
        }
    }

    fn statement(&mut self, statement: &'t Statement, at: &Context<'t, 's>) {
        self.node("a statement", statement.span, at.outer);
    }

    fn expression(&mut self, part: Part<'t, 's>, at: &Context<'t, 's>) {
        let Part {
            expression, around, ..
        } = part;
        let outer = around.and_then(|around| at.unit.expression(around));
        let outer = outer.map(|around| around.span);
        self.node("an expression", expression.span, outer.or(at.outer));
        let span = Some(expression.span);
        match &expression.kind {
            ExpressionKind::Name(name) | ExpressionKind::Field { field: name, .. } => self.name(name, span),
            ExpressionKind::Literal(literal) => {
                literal.prefix().iter().for_each(|name| self.name(name, span))
            }
            ExpressionKind::EnumeratedValue(word) => {
                self.name(&word.prefix(), span);
                self.name(&word.value(), span);
            }
            ExpressionKind::Call { arguments, .. } => {
                for argument in arguments {
                    if let Argument::Named { name, .. } | Argument::Output { name, .. } = argument {
                        self.name(name, span);
                    }
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::check_spans;
    use stickler_syntax::parse;
    use stickler_syntax::tree::SourceUnit;
    use stickler_types::Dialect;
    use stickler_types::DialectName;

    const TEXT: &str =
        "PROGRAM p VAR x : INT := 5; END_VAR IF x > 1 THEN x := f(a := 2); END_IF; END_PROGRAM";

    /// Returns the violation in the tree of [`TEXT`] after a change.
    fn wrong(change: impl FnOnce(&mut SourceUnit<'_>)) -> Option<String> {
        let (mut unit, diagnostics) = parse(TEXT, Dialect::of(DialectName::IRONPLC_ED3));
        assert_eq!(diagnostics, []);
        change(&mut unit);
        check_spans(&unit, TEXT, true).err()
    }

    #[test]
    fn every_place_is_held_against_the_text_and_the_node_around_it() {
        assert_eq!(wrong(|_| {}), None);
        let expressions = parse(TEXT, Dialect::of(DialectName::IRONPLC_ED3))
            .0
            .expressions
            .len();
        for index in 0..expressions {
            let far = wrong(|unit| unit.expressions[index].span.end = 1000);
            assert!(
                far.is_some_and(|message| message.contains("in the text")),
                "{index}"
            );
            let empty = wrong(|unit| unit.expressions[index].span.end = unit.expressions[index].span.start);
            assert!(
                empty.is_some_and(|message| message.contains("covers nothing")),
                "{index}"
            );
            let elsewhere = wrong(|unit| {
                let span = &mut unit.expressions[index].span;
                (span.start, span.end) = (0, 1);
            });
            assert!(elsewhere.is_some(), "{index}");
        }
    }
}
