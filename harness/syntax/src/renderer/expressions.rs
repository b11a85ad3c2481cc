//! Expressions. Chains of infix operators are walked along their left spine; everything else is no deeper than
//! the parser's limits.

use super::names::NameShape;
use super::writer::Writer;
use crate::tree::{
    Argument, BinaryOperator, ExpressionId, ExpressionKind, Literal, LiteralKind, UnaryOperator,
};
use stickler_types::ElementaryType;

impl<'u, 's> Writer<'u, 's> {
    /// An expression; gives what is known of the variable that it names.
    pub(super) fn expression(&mut self, id: ExpressionId) -> NameShape<'u, 's> {
        match self.node(id) {
            ExpressionKind::Literal(literal) => self.literal(literal),
            ExpressionKind::Name(name) => {
                let (spelling, shape) = self.names.variable(self.pou, name.text);
                self.put(spelling);
                return shape;
            }
            ExpressionKind::EnumeratedValue(enumerated) => {
                let (type_name, value) = (enumerated.prefix(), enumerated.value());
                let spelling = self.names.type_name(type_name.text).unwrap_or(type_name.text);
                self.put(spelling);
                self.put("#");
                self.put(self.names.value(value.text));
            }
            ExpressionKind::Field { base, field } => {
                let of = self.expression(*base);
                let (spelling, shape) = self.names.member(of, field.text);
                self.put(".");
                self.put(spelling);
                return shape;
            }
            ExpressionKind::Index { base, subscripts } => {
                let of = self.expression(*base);
                self.between_brackets(|writer| writer.expressions(subscripts));
                return self.names.element(of);
            }
            ExpressionKind::Dereference { base } => {
                let of = self.expression(*base);
                self.put("^");
                return of;
            }
            ExpressionKind::Assigned { target, value } => {
                self.expression(*target);
                self.put(" := ");
                self.expression(*value);
            }
            ExpressionKind::Bit { base, index } => {
                self.expression(*base);
                self.put(".");
                self.put(&index.to_string());
            }
            ExpressionKind::Part { base, part, index } => {
                self.expression(*base);
                self.put(match part {
                    ElementaryType::Byte => ".%B",
                    ElementaryType::Word => ".%W",
                    ElementaryType::Dword => ".%D",
                    _ => ".%L",
                });
                self.put(&index.to_string());
            }
            ExpressionKind::Call { callee, arguments } => {
                let of = self.expression(*callee);
                self.put("(");
                self.list(arguments, |writer, argument| writer.argument(of, argument));
                self.put(")");
                return self.names.result(of);
            }
            ExpressionKind::Unary { operator, operand } => {
                self.put(operator.as_str());
                self.put(if *operator == UnaryOperator::Not { " " } else { "" });
                self.expression(*operand);
            }
            ExpressionKind::Binary {
                operator,
                left,
                right,
            } => self.chain(*operator, *left, *right),
            ExpressionKind::Parenthesized(inner) => {
                self.put("(");
                self.expression(*inner);
                self.put(")");
            }
            ExpressionKind::Aggregate(initializer) => self.initializer(initializer, NameShape::Unknown),
            ExpressionKind::Error => {}
        }
        NameShape::Unknown
    }

    /// Expressions with commas between them.
    fn expressions(&mut self, ids: &[ExpressionId]) {
        self.list(ids, |writer, id| {
            writer.expression(*id);
        });
    }

    /// A chain of infix operators: its left spine is found first, then written from its deepest operand on.
    fn chain(&mut self, operator: BinaryOperator, mut left: ExpressionId, right: ExpressionId) {
        let start = self.spine.len();
        self.spine.push((operator, right));
        while let ExpressionKind::Binary {
            operator,
            left: next,
            right,
        } = self.node(left)
        {
            self.spine.push((*operator, *right));
            left = *next;
        }
        self.expression(left);
        while self.spine.len() > start
            && let Some((operator, right)) = self.spine.pop()
        {
            self.operator(operator);
            self.expression(right);
        }
    }

    /// An operator between spaces, which words need even between brackets.
    fn operator(&mut self, operator: BinaryOperator) {
        let symbol = operator.as_str();
        if self.dense && !symbol.starts_with(|first: char| first.is_ascii_alphabetic()) {
            return self.put(symbol);
        }
        self.put(" ");
        self.put(symbol);
        self.put(" ");
    }

    fn argument(&mut self, callee: NameShape<'u, 's>, argument: &'u Argument<'s>) {
        match argument {
            Argument::Positional(value) => {
                self.expression(*value);
            }
            Argument::Named { name, value } => {
                self.put(self.names.member(callee, name.text).0);
                self.put(if self.dense { ":=" } else { " := " });
                self.expression(*value);
            }
            Argument::Output {
                name,
                negated,
                target,
            } => {
                self.put(if *negated { "NOT " } else { "" });
                self.put(self.names.member(callee, name.text).0);
                self.put(if self.dense { "=>" } else { " => " });
                self.expression(*target);
            }
        }
    }

    /// A literal as it stands, but its prefix and the words TRUE and FALSE in capitals.
    fn literal(&mut self, literal: &Literal) {
        if let Some(prefix) = literal.prefix() {
            self.capitals(prefix.text);
            self.put("#");
        }
        if literal.kind == LiteralKind::Boolean {
            self.capitals(literal.text());
        } else {
            self.put(literal.text());
        }
    }
}
