//! What a pass asks of a text: its tree and its tokens, and which changes are allowed.

use crate::draft::TextDraft;
use std::cmp::Reverse;
use std::ops::Range;
use stickler_syntax::token::{Token, TokenKind};
use stickler_syntax::tree::{
    CaseLabel, Expression, ExpressionId, Initializer, Name, Pou, SourceUnit, Statement, StatementKind,
    TypeSpecification, VariableBlock, VariableGroup,
};
use stickler_syntax::visitor::{Context, Part, Place, Visitor, bodies, walk};
use stickler_syntax::{Edits, Tokens, parse, tokens};
use stickler_types::Dialect;

/// A text under reduction with its tree, its tokens and lists of their parts.
pub struct TextView<'t> {
    /// The candidate.
    pub draft: &'t TextDraft,
    /// The tree of its text.
    pub unit: &'t SourceUnit<'t>,
    /// Its tokens.
    pub tokens: &'t Tokens,
}

impl TextDraft {
    /// Parses the text, and calls a function with what it consists of.
    pub fn view<R>(&self, ask: impl FnOnce(&TextView<'_>) -> R) -> R {
        let dialect = Dialect::of(self.dialect());
        ask(&TextView {
            draft: self,
            unit: &parse(self.text(), dialect).0,
            tokens: &tokens(self.text(), dialect),
        })
    }
}

impl<'t> TextView<'t> {
    /// Returns the text.
    pub fn text(&self) -> &'t str {
        self.draft.text()
    }

    /// Keeps the changes that leave an allowed text when made alone.
    pub fn only_allowed(&self, mut changes: Vec<Edits>) -> Vec<Edits> {
        changes.retain(|change| self.draft.after(change).is_allowed());
        changes
    }

    /// Returns every list of statements, outer ones before inner ones; those of the last program organization unit first,
    /// because it is the one that runs.
    pub fn lists(&self) -> Vec<&'t [Statement]> {
        let mut found = Vec::new();
        for pou in self.unit.pous().rev() {
            let mut open = vec![pou.body.as_slice()];
            while let Some(list) = open.pop() {
                found.push(list);
                open.extend(list.iter().flat_map(bodies));
            }
        }
        found
    }

    /// Returns every statement, in the order of [`TextView::lists`].
    pub fn statements(&self) -> Vec<&'t Statement> {
        self.lists().into_iter().flatten().collect()
    }

    /// Returns every expression with its place, outer ones before inner ones, in the order of the text.
    pub fn expressions(&self) -> Vec<(Place, &'t Expression<'t>)> {
        let found = self.parts().expressions.into_iter();
        let mut found: Vec<_> = found.map(|part| (part.place, part.expression)).collect();
        found.sort_by_key(|(_, expression)| (expression.span.start, Reverse(expression.span.end)));
        found
    }

    /// Returns all sections of variables.
    pub fn sections(&self) -> Vec<&'t VariableBlock<'t>> {
        self.parts().sections
    }

    /// Returns the declarations of variables in units, each with its unit.
    pub fn variables(&self) -> impl Iterator<Item = (&'t Pou<'t>, &'t VariableGroup<'t>)> {
        let groups = |pou: &'t Pou<'t>| {
            let groups = pou.blocks.iter().flat_map(|block| &block.groups);
            groups.map(move |group| (pou, group))
        };
        self.unit.pous().flat_map(groups)
    }

    /// Returns the type of every variable, field and declared type, with the initial value beside it.
    pub fn specifications(&self) -> Vec<(&'t TypeSpecification<'t>, Option<&'t Initializer<'t>>)> {
        let groups = self.parts().groups.into_iter();
        let variables = groups.map(|group| (&group.specification, group.initializer.as_ref()));
        let types = self
            .unit
            .types()
            .map(|one| (&one.specification, one.initializer.as_ref()));
        variables.chain(types).collect()
    }

    /// Returns each expression of a POU that is this name, read or written.
    pub fn uses(&self, pou: &Pou<'_>, name: Name<'_>) -> Vec<Part<'t, 't>> {
        let mut found = self.parts().expressions;
        found.retain(|part| part.pou.is_some_and(|own| own.span == pou.span) && part.is(name.text));
        found
    }

    /// Returns the expression that another one is a part of.
    pub fn around(&self, part: &Part<'_, '_>) -> Option<&'t Expression<'t>> {
        self.unit.expression(part.around?)
    }

    fn parts(&self) -> Parts<'t> {
        let mut parts = Parts::default();
        walk(self.unit, &mut parts);
        parts
    }

    /// Returns the range of an expression.
    pub fn range_of_expression(&self, id: ExpressionId) -> Range<usize> {
        self.unit
            .expression(id)
            .map_or(0..0, |expression| expression.span.into())
    }

    /// Returns the range of a CASE label.
    pub fn range_of_label(&self, label: &CaseLabel) -> Range<usize> {
        match label {
            CaseLabel::Value(value) => self.range_of_expression(*value),
            CaseLabel::Range(low, high) => {
                self.range_of_expression(*low).start..self.range_of_expression(*high).end
            }
        }
    }

    /// Returns the tokens that begin inside a range.
    pub fn inside(&self, range: Range<usize>) -> &'t [Token] {
        let list = &self.tokens.list;
        let first = list.partition_point(|token| (token.span.start as usize) < range.start);
        let end = list.partition_point(|token| (token.span.start as usize) < range.end);
        list.get(first..end).unwrap_or_default()
    }

    /// Returns the first token behind a place.
    pub fn next(&self, from: usize) -> Option<&'t Token> {
        self.inside(from..self.text().len()).first()
    }

    /// Returns the last token before a place.
    pub fn previous(&self, to: usize) -> Option<&'t Token> {
        self.inside(0..to).last()
    }

    /// Returns `end`, moved past a semicolon that follows.
    pub fn with_semicolon(&self, end: usize) -> usize {
        let next = self.next(end).filter(|token| token.kind == TokenKind::Semicolon);
        next.map_or(end, |token| token.span.end as usize)
    }

    /// Returns the range of some statements, with the semicolon of the last one.
    pub fn range_of_statements(&self, statements: &[Statement]) -> Option<Range<usize>> {
        let (first, last) = (statements.first()?, statements.last()?);
        Some(first.span.start as usize..self.range_of_statement(last).end)
    }

    /// Returns the range of a statement with its semicolon.
    pub fn range_of_statement(&self, statement: &Statement) -> Range<usize> {
        let range: Range<usize> = statement.span.into();
        match statement.kind {
            // The span of a lone semicolon may be the semicolon.
            StatementKind::Empty if self.text()[range.clone()].ends_with(';') => range,
            _ => range.start..self.with_semicolon(range.end),
        }
    }

    /// Returns the range of a declaration, from its first name to its semicolon.
    pub fn range_of_declaration(&self, group: &VariableGroup<'_>) -> Option<Range<usize>> {
        let from = group.names.first()?.span.start as usize;
        Some(from..self.end_of(&group.specification, group.initializer.as_ref()))
    }

    /// Returns the end of a declaration after its semicolon.
    pub fn end_of(
        &self,
        specification: &TypeSpecification<'_>,
        initializer: Option<&Initializer<'_>>,
    ) -> usize {
        let end = initializer.map_or(specification.span.end, |initializer| initializer.span.end);
        self.with_semicolon(end as usize)
    }

    /// Returns for each element of a list in brackets the edit that removes it with one comma. `open` is at or before the opening
    /// bracket, `ends` are the ends of the elements, and `close` is that of the list.
    pub fn list_items(&self, open: usize, ends: &[usize], close: usize) -> Vec<Edits> {
        let is_bracket = |token: &&Token| matches!(token.kind, TokenKind::LeftParen | TokenKind::LeftBracket);
        let Some(bracket) = self.inside(open..close).iter().find(is_bracket) else {
            return Vec::new();
        };
        let mut changes = Vec::new();
        let mut before = None;
        for &end in ends {
            changes.push(Edits::removing(match before.replace(end) {
                // With the comma before it.
                Some(before) => before..end,
                // The first one with the comma behind it.
                None => {
                    let comma = self.next(end).filter(|token| token.kind == TokenKind::Comma);
                    bracket.span.end as usize..comma.map_or(end, |comma| comma.span.end as usize)
                }
            }));
        }
        changes
    }
}

/// The parts of a tree, in the order of its text.
#[derive(Default)]
struct Parts<'t> {
    sections: Vec<&'t VariableBlock<'t>>,
    groups: Vec<&'t VariableGroup<'t>>,
    expressions: Vec<Part<'t, 't>>,
}

impl<'t> Visitor<'t, 't> for Parts<'t> {
    fn section(&mut self, section: &'t VariableBlock<'t>, _: &Context<'t, 't>) {
        self.sections.push(section);
    }

    fn variables(&mut self, group: &'t VariableGroup<'t>, _: &Context<'t, 't>) {
        self.groups.push(group);
    }

    fn expression(&mut self, part: Part<'t, 't>, _: &Context<'t, 't>) {
        self.expressions.push(part);
    }
}
