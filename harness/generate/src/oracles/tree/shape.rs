//! The shape of a syntax tree: everything but its places, as one number that two equal trees share.

use super::visitor::Visitor;
use super::walk::walk;
use stickler_reference::source::Span;
use stickler_reference::syntax::tree::{ExpressionId, Name, SourceUnit};

/// The fingerprint of a tree: the same for trees that differ only in their places, in the case of names and keywords, and in
/// the two forms of one bit access.
///
/// It takes 64 bits; that two different trees share one by chance will not be seen in any campaign.
pub(in crate::oracles) fn shape(unit: &SourceUnit<'_>) -> u64 {
    let mut shape = Shape(0);
    walk(unit, &mut shape);
    shape.0
}

struct Shape(u64);

impl Shape {
    fn mix(&mut self, number: u64) {
        self.0 = (self.0.rotate_left(5) ^ number).wrapping_mul(0x517C_C1B7_2722_0A95);
    }

    fn bytes(&mut self, text: &str, fold: impl Fn(u8) -> u8) {
        self.mix(text.len() as u64);
        for chunk in text.as_bytes().chunks(8) {
            let word = chunk
                .iter()
                .fold(0, |word, byte| word << 8 | u64::from(fold(*byte)));
            self.mix(word);
        }
    }
}

impl Visitor for Shape {
    fn enter(&mut self, _: Span) {}

    fn leave(&mut self) {}

    fn number(&mut self, number: u64) {
        self.mix(number);
    }

    fn name(&mut self, name: &Name<'_>) {
        self.written(name.text, true);
    }

    fn written(&mut self, text: &str, folded: bool) {
        if folded {
            self.bytes(text, |byte| byte.to_ascii_uppercase());
        } else {
            self.bytes(text, |byte| byte);
        }
    }

    fn expression(&mut self, id: ExpressionId) {
        // The arena is filled in the order of the text, which is the same in both.
        self.mix(u64::from(id.0));
    }
}

#[cfg(test)]
mod tests {
    use super::shape;
    use stickler_reference::dialect::Dialect;
    use stickler_reference::syntax::parse;
    use stickler_types::DialectName;

    fn of(statements: &str) -> u64 {
        let text = format!("PROGRAM p {statements} END_PROGRAM");
        shape(&parse(&text, &Dialect::of(DialectName::IronplcEd3)).0)
    }

    #[test]
    fn spelling_and_places_do_not_matter() {
        assert_eq!(of("x := a.%X3 + TRUE;"), of("(* c *)  X:=A.3+true ;"));
    }

    #[test]
    fn everything_else_does() {
        let all = [
            "x := a + b;",
            "x := a - b;",
            "x := b + a;",
            "x := (a + b);",
            "x := a.3;",
            "x := a.4;",
            "x := 'a';",
            "x := 'A';",
            "x := f(a, b);",
            "x := f(a := b);",
            "x := f(a => b);",
            "x := f(NOT a => b);",
            "IF a THEN b; END_IF;",
            "IF a THEN ; ELSE b; END_IF;",
            "FOR x := 1 TO 2 DO EXIT; END_FOR;",
            "FOR x := 1 TO 2 BY 1 DO EXIT; END_FOR;",
            "FOR x := 1 TO 2 DO END_FOR; EXIT;",
            "CASE x OF 1, 2: END_CASE;",
            "CASE x OF 1..2: END_CASE;",
        ];
        for (index, first) in all.iter().enumerate() {
            for second in &all[index + 1..] {
                assert_ne!(of(first), of(second), "{first} and {second}");
            }
        }
    }
}
