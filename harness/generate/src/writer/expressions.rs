//! Writing of the expressions and places of the model as source text.

use super::literals::begins_with_minus;
use super::source_writer::SourceWriter;
use crate::model::{
    Argument, BinaryOperator, Expression, ExpressionKind, LiteralForm, Place, PlaceSelector, Type,
    UnaryOperator, Variable, instance_of,
};
use stickler_exact::signatures;

/// Returns the precedence of the outermost operator of an expression; the highest if it has none.
///
/// Basis: iec-61131-3: Table 71.
fn strength(kind: &ExpressionKind) -> u8 {
    match kind {
        ExpressionKind::Binary(operator, ..) => operator_strength(*operator),
        ExpressionKind::Unary(..) => UNARY,
        ExpressionKind::Literal(value, LiteralForm::Untyped) if begins_with_minus(value) => UNARY,
        // The content is unknown, so it stands in parentheses beside any operator.
        ExpressionKind::Raw(_) => 0,
        _ => OPERAND,
    }
}

const UNARY: u8 = 8;
const OPERAND: u8 = 9;

const fn operator_strength(operator: BinaryOperator) -> u8 {
    use BinaryOperator as B;
    match operator {
        B::Or => 1,
        B::Xor => 2,
        B::And => 3,
        B::Equal | B::NotEqual => 4,
        B::Less | B::LessOrEqual | B::Greater | B::GreaterOrEqual => 5,
        B::Add | B::Subtract => 6,
        B::Multiply | B::Divide | B::Modulo => 7,
    }
}

impl SourceWriter<'_> {
    /// Writes an expression .
    pub fn expression(&mut self, expression: &Expression) {
        match &expression.kind {
            ExpressionKind::Literal(value, form) => self.literal(value, *form),
            ExpressionKind::Enumerated(which) => self.enumerated(&expression.ty, *which),
            ExpressionKind::Read(place) => self.place(place),
            ExpressionKind::Reference(place) => {
                self.word(self.program.reference_words().map_or("", |(_, word)| word));
                self.put("(");
                self.place(place);
                self.put(")");
            }
            ExpressionKind::Bit(place, bit) => self.bit(place, *bit),
            ExpressionKind::Unary(operator, operand) => self.unary(*operator, operand),
            ExpressionKind::Binary(operator, left, right) => self.binary(*operator, left, right),
            ExpressionKind::Widen(operand) => self.widened(&expression.ty, operand),
            ExpressionKind::Convert(signature, operand) => {
                self.call(&signature.function, [&**operand]);
            }
            ExpressionKind::Call(function, arguments) => self.function(*function, arguments),
            ExpressionKind::Standard(function, arguments) => {
                self.call(function.as_str(), arguments);
            }
            ExpressionKind::Raw(text) => self.raw(text),
        }
    }

    /// Writes a call of a function that the language defines.
    fn call<'e>(&mut self, name: &str, arguments: impl IntoIterator<Item = &'e Expression>) {
        self.word(name);
        self.put("(");
        self.list(arguments, |writer, argument| writer.expression(argument));
        self.put(")");
    }

    /// Writes the items of a list, with commas between them.
    pub fn list<T>(&mut self, items: impl IntoIterator<Item = T>, mut write: impl FnMut(&mut Self, T)) {
        for (number, item) in items.into_iter().enumerate() {
            if number > 0 {
                self.comma();
            }
            write(self, item);
        }
    }

    pub fn comma(&mut self) {
        self.put(",");
        self.blank();
    }

    /// Writes a call of a function of the program.
    fn function(&mut self, function: usize, arguments: &[Argument]) {
        let Some(called) = self.program.functions.get(function) else {
            return;
        };
        // Only a call with names can omit inputs.
        let named = self.style.named_arguments || arguments.len() < called.inputs().count();
        // A method uses no variable of its block, so that any instance will do.
        if let Some(block) = called.owner
            && let Some(instance) = instance_of(&self.pou.variables, block)
        {
            self.put(&instance.name);
            self.put(".");
        }
        self.put(&called.name);
        self.put("(");
        self.list(arguments, |writer, argument| {
            if named {
                writer.parameter(&called.variables, argument);
            }
            writer.expression(&argument.value);
        });
        self.put(")");
    }

    /// Writes `name := `.
    pub fn parameter(&mut self, parameters: &[Variable], argument: &Argument) {
        if let Some(parameter) = parameters.get(argument.parameter.0) {
            self.put(&parameter.name);
            self.between_blanks(":=");
        }
    }

    fn unary(&mut self, operator: UnaryOperator, operand: &Expression) {
        match operator {
            UnaryOperator::Negate => self.put("-"),
            UnaryOperator::Not => {
                self.word("NOT");
                self.blank();
            }
        }
        // Two adjacent signs are not valid in the standard.
        self.operand(operand, OPERAND);
    }

    fn binary(&mut self, operator: BinaryOperator, left: &Expression, right: &Expression) {
        let own = operator_strength(operator);
        // Comparisons of comparisons read badly, and some compilers have no rule for them.
        let left_needs = if (4..=5).contains(&own) { 6 } else { own };
        self.operand(left, left_needs);
        self.between_blanks(operator.as_str());
        self.operand(right, (own + 1).max(left_needs));
    }

    /// Writes an operand, in parentheses unless its precedence is at least `needed`.
    fn operand(&mut self, operand: &Expression, needed: u8) {
        // An implicit conversion is spelled as its operand; an untyped minus at the left end of a product is also safer inside.
        let mut seen = operand;
        while let (ExpressionKind::Widen(inner), true) = (&seen.kind, self.stays_implicit(seen)) {
            seen = inner;
        }
        let bare_minus = matches!(&seen.kind, ExpressionKind::Literal(..)) && strength(&seen.kind) == UNARY;
        if strength(&seen.kind) >= needed && !bare_minus {
            self.expression(operand);
        } else {
            self.put("(");
            self.expression(operand);
            self.put(")");
        }
    }

    fn widened(&mut self, into: &Type, operand: &Expression) {
        match self.spelled_conversion(into, operand) {
            Some(function) => self.call(&function, [operand]),
            None => self.expression(operand),
        }
    }

    fn stays_implicit(&self, widened: &Expression) -> bool {
        match &widened.kind {
            ExpressionKind::Widen(operand) => self.spelled_conversion(&widened.ty, operand).is_none(),
            _ => true,
        }
    }

    /// Returns the function that spells an implicit conversion, where the style wants it and the dialect has it.
    fn spelled_conversion(&self, into: &Type, operand: &Expression) -> Option<String> {
        let (&Type::Elementary(from), &Type::Elementary(into)) = (&operand.ty, into) else {
            return None;
        };
        if !self.style.explicit_conversions {
            return None;
        }
        let name = format!("{from}_TO_{into}");
        (!signatures(&name, self.program.dialect).is_empty()).then_some(name)
    }

    fn enumerated(&mut self, ty: &Type, which: usize) {
        if let Some(name) = self
            .program
            .enumerated_values(ty)
            .and_then(|names| names.get(which))
        {
            self.put(name);
        }
    }

    /// Writes a bit of a place.
    pub fn bit(&mut self, place: &Place, bit: u32) {
        self.place(place);
        self.put(if self.style.percent_bits { ".%X" } else { "." });
        self.put(&bit.to_string());
    }

    /// Writes a variable with its selectors.
    pub fn place(&mut self, place: &Place) {
        let Some(variable) = self.variable(place.variable) else {
            return;
        };
        self.put(&variable.name);
        let mut within = &variable.ty;
        for selector in &place.path {
            let Some(selected) = self.selected(within, selector) else {
                return;
            };
            within = selected;
        }
    }

    /// Writes one selector and returns the type of the selected part.
    fn selected<'t>(&mut self, within: &'t Type, selector: &PlaceSelector) -> Option<&'t Type>
    where
        Self: 't,
    {
        let program = self.program;
        match selector {
            PlaceSelector::Index(subscripts) => {
                self.put("[");
                self.list(subscripts, |writer, subscript| writer.expression(subscript));
                self.put("]");
            }
            PlaceSelector::Followed => self.put("^"),
            PlaceSelector::Field(field) => {
                let (name, ..) = program.fields(within)?.get(*field)?;
                self.put(".");
                self.put(name);
            }
            PlaceSelector::Output(output) => {
                let Type::Block(block) = within else {
                    return None;
                };
                let variable = program.blocks.get(*block)?.variables.get(output.0)?;
                self.put(".");
                self.put(&variable.name);
            }
        }
        program.selected_type(within, selector)
    }
}
