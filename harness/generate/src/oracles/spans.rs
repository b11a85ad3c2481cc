//! Spans in a syntax tree: every span lies in the text and in that of its parent, and covers the text of its node.

use stickler_syntax::source::Span;
use stickler_syntax::tree::{
    Argument, CaseLabel, Configuration, Declaration, Expression, ExpressionId, ExpressionKind, Initializer,
    InitializerKind, Name, Pou, SourceUnit, Statement, StatementKind, TypeSpecification,
    TypeSpecificationKind, VariableBlock, VariableGroup,
};

/// Checks the spans of `unit`, the tree of `text`.
///
/// A span lies inside `text`, between characters. In the tree of a text without errors (`sound`) it covers at least one byte
/// and lies inside the span of its parent, and the span of a name covers exactly the name.
///
/// # Errors
/// The first violation, in words.
pub(super) fn check_spans(unit: &SourceUnit<'_>, text: &str, sound: bool) -> Result<(), String> {
    let checker = SpanChecker { unit, text, sound };
    unit.expressions
        .iter()
        .try_for_each(|one| checker.expression(one))?;
    unit.declarations
        .iter()
        .try_for_each(|one| checker.declaration(one))
}

/// Returns whether a span lies inside the text and between characters.
pub(super) fn is_inside(span: Span, text: &str) -> bool {
    text.get(span.start as usize..span.end as usize).is_some()
}

struct SpanChecker<'u, 's> {
    unit: &'u SourceUnit<'s>,
    text: &'u str,
    sound: bool,
}

type SpanCheck = Result<(), String>;

impl SpanChecker<'_, '_> {
    /// Checks a node at `span` as a child of one at `outer`.
    fn node(&self, what: &str, span: Span, outer: Span) -> SpanCheck {
        let message = if !is_inside(span, self.text) {
            "does not lie in the text"
        } else if self.sound && span.start == span.end {
            "covers nothing"
        } else if self.sound && !(outer.start <= span.start && span.end <= outer.end) {
            "does not lie in what it is a part of"
        } else {
            return Ok(());
        };
        Err(format!(
            "{what} at {}..{} {message} ({}..{})",
            span.start, span.end, outer.start, outer.end
        ))
    }

    fn name(&self, name: &Name<'_>, outer: Span) -> SpanCheck {
        self.node("a name", name.span, outer)?;
        if name.span.text(self.text) == name.text {
            return Ok(());
        }
        let (start, end) = (name.span.start, name.span.end);
        Err(format!(
            "the name `{}` does not stand at {start}..{end}",
            name.text
        ))
    }

    /// Checks an expression of the arena that lies inside `outer`.
    fn value(&self, id: ExpressionId, outer: Span) -> SpanCheck {
        match self.unit.expressions.get(id.0 as usize) {
            Some(expression) => self.node("an expression", expression.span, outer),
            None => Err(format!("there is no expression {}", id.0)),
        }
    }

    fn values(&self, ids: impl IntoIterator<Item = ExpressionId>, outer: Span) -> SpanCheck {
        ids.into_iter().try_for_each(|id| self.value(id, outer))
    }

    fn expression(&self, expression: &Expression<'_>) -> SpanCheck {
        let span = expression.span;
        self.node("an expression", span, span)?;
        match &expression.kind {
            ExpressionKind::Literal(literal) => match literal.prefix() {
                Some(prefix) => self.name(&prefix, span),
                None => Ok(()),
            },
            ExpressionKind::Name(name) => self.name(name, span),
            ExpressionKind::EnumeratedValue(word) => {
                self.name(&word.prefix(), span)?;
                self.name(&word.value(), span)
            }
            ExpressionKind::Field { base, field } => {
                self.value(*base, span)?;
                self.name(field, span)
            }
            ExpressionKind::Index { base, subscripts } => {
                self.value(*base, span)?;
                self.values(subscripts.iter().copied(), span)
            }
            ExpressionKind::Call { callee, arguments } => {
                self.value(*callee, span)?;
                arguments.iter().try_for_each(|argument| match argument {
                    Argument::Positional(value) => self.value(*value, span),
                    Argument::Named { name, value } => {
                        self.name(name, span)?;
                        self.value(*value, span)
                    }
                    Argument::Output { name, target, .. } => {
                        self.name(name, span)?;
                        self.value(*target, span)
                    }
                })
            }
            ExpressionKind::Bit { base: inner, .. }
            | ExpressionKind::Part { base: inner, .. }
            | ExpressionKind::Unary { operand: inner, .. }
            | ExpressionKind::Parenthesized(inner) => self.value(*inner, span),
            ExpressionKind::Binary { left, right, .. } => self.values([*left, *right], span),
            ExpressionKind::Error => Ok(()),
        }
    }

    fn body(&self, body: &[Statement], outer: Span) -> SpanCheck {
        body.iter()
            .try_for_each(|statement| self.statement(statement, outer))
    }

    fn statement(&self, statement: &Statement, outer: Span) -> SpanCheck {
        let span = statement.span;
        self.node("a statement", span, outer)?;
        match &statement.kind {
            StatementKind::Assignment { target, value } => self.values([*target, *value], span),
            StatementKind::Call(call) => self.value(*call, span),
            StatementKind::If { branches, otherwise } => {
                for (condition, body) in branches {
                    self.value(*condition, span)?;
                    self.body(body, span)?;
                }
                self.body(otherwise.as_deref().unwrap_or_default(), span)
            }
            StatementKind::Case {
                selector,
                branches,
                otherwise,
            } => {
                self.value(*selector, span)?;
                for branch in branches {
                    for label in &branch.labels {
                        match label {
                            CaseLabel::Value(value) => self.value(*value, span)?,
                            CaseLabel::Range(low, high) => self.values([*low, *high], span)?,
                        }
                    }
                    self.body(&branch.body, span)?;
                }
                self.body(otherwise.as_deref().unwrap_or_default(), span)
            }
            StatementKind::For {
                control,
                from,
                to,
                by,
                body,
            } => {
                self.values([*control, *from, *to].into_iter().chain(*by), span)?;
                self.body(body, span)
            }
            StatementKind::While { condition, body } => {
                self.value(*condition, span)?;
                self.body(body, span)
            }
            StatementKind::Repeat { body, until } => {
                self.body(body, span)?;
                self.value(*until, span)
            }
            StatementKind::Exit | StatementKind::Continue | StatementKind::Return | StatementKind::Empty => {
                Ok(())
            }
        }
    }

    fn declaration(&self, declaration: &Declaration<'_>) -> SpanCheck {
        // No node covers the whole text.
        let text = Span {
            start: 0,
            end: u32::MAX,
        };
        match declaration {
            Declaration::Pou(pou) => self.pou(pou, text),
            Declaration::Types(types) => types.iter().try_for_each(|ty| {
                self.name(&ty.name, text)?;
                self.specification(&ty.specification, text)?;
                self.initializer(ty.initializer.as_ref(), text)
            }),
            Declaration::Globals(block) => self.block(block, text),
            Declaration::Configuration(configuration) => self.configuration(configuration, text),
        }
    }

    fn pou(&self, pou: &Pou<'_>, outer: Span) -> SpanCheck {
        self.node("a program organization unit", pou.span, outer)?;
        self.name(&pou.name, pou.span)?;
        if let Some(result) = &pou.result {
            self.specification(result, pou.span)?;
        }
        pou.blocks
            .iter()
            .try_for_each(|block| self.block(block, pou.span))?;
        self.body(&pou.body, pou.span)?;
        self.node("the closing keyword", pou.end, pou.span)
    }

    fn block(&self, block: &VariableBlock<'_>, outer: Span) -> SpanCheck {
        self.node("a variable section", block.span, outer)?;
        self.groups(&block.groups, block.span)
    }

    fn groups(&self, groups: &[VariableGroup<'_>], outer: Span) -> SpanCheck {
        groups.iter().try_for_each(|group| {
            group.names.iter().try_for_each(|name| self.name(name, outer))?;
            self.specification(&group.specification, outer)?;
            self.initializer(group.initializer.as_ref(), outer)
        })
    }

    fn specification(&self, specification: &TypeSpecification<'_>, outer: Span) -> SpanCheck {
        let span = specification.span;
        self.node("a type", span, outer)?;
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.name(name, span),
            TypeSpecificationKind::Text { name, length } => {
                self.name(name, span)?;
                self.value(*length, span)
            }
            TypeSpecificationKind::Subrange {
                base,
                limits: (low, high),
            } => {
                self.name(base, span)?;
                self.values([*low, *high], span)
            }
            TypeSpecificationKind::Array { dimensions, element } => {
                for (low, high) in dimensions {
                    self.values([*low, *high], span)?;
                }
                self.specification(element, span)
            }
            TypeSpecificationKind::Enumeration { base, values } => {
                base.iter().try_for_each(|name| self.name(name, span))?;
                values.iter().try_for_each(|(name, number)| {
                    self.name(name, span)?;
                    self.values(*number, span)
                })
            }
            TypeSpecificationKind::Structure(groups) => self.groups(groups, span),
            TypeSpecificationKind::Error => Ok(()),
        }
    }

    fn initializer(&self, initializer: Option<&Initializer<'_>>, outer: Span) -> SpanCheck {
        let Some(Initializer { kind, span }) = initializer else {
            return Ok(());
        };
        self.node("an initial value", *span, outer)?;
        match kind {
            InitializerKind::Expression(value) => self.value(*value, *span),
            InitializerKind::Array(elements) => elements.iter().try_for_each(|element| {
                self.values(element.repetition, *span)?;
                self.initializer(element.value.as_ref(), *span)
            }),
            InitializerKind::Structure(fields) => fields.iter().try_for_each(|(name, value)| {
                self.name(name, *span)?;
                self.initializer(Some(value), *span)
            }),
        }
    }

    fn configuration(&self, configuration: &Configuration<'_>, outer: Span) -> SpanCheck {
        let span = configuration.span;
        self.node("a configuration", span, outer)?;
        self.name(&configuration.name, span)?;
        configuration
            .globals
            .iter()
            .try_for_each(|block| self.block(block, span))?;
        configuration.resources.iter().try_for_each(|resource| {
            let names = resource.header.iter().flat_map(|(name, kind)| [name, kind]);
            let programs = resource.programs.iter();
            names
                .chain(programs.flat_map(|program| {
                    [&program.name, &program.type_name]
                        .into_iter()
                        .chain(&program.task)
                }))
                .try_for_each(|name| self.name(name, span))?;
            resource.tasks.iter().try_for_each(|task| {
                self.name(&task.name, span)?;
                task.properties.iter().try_for_each(|(name, value)| {
                    self.name(name, span)?;
                    self.value(*value, span)
                })
            })
        })
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
        let (mut unit, diagnostics) = parse(TEXT, &Dialect::of(DialectName::IronplcEd3));
        assert_eq!(diagnostics, []);
        change(&mut unit);
        check_spans(&unit, TEXT, true).err()
    }

    #[test]
    fn every_place_is_held_against_the_text_and_the_node_around_it() {
        assert_eq!(wrong(|_| {}), None);
        let expressions = parse(TEXT, &Dialect::of(DialectName::IronplcEd3))
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
