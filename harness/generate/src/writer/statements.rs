//! Writing of the statements of the model as source text.

use super::source_writer::SourceWriter;
use crate::model::{
    Argument, AssignmentTarget, CaseBranch, CaseLabel, Expression, ForLoop, Place, Statement, Type, Unit,
    VariableId,
};

impl SourceWriter<'_> {
    /// Writes statements, each on a line of its own, one step deeper; an empty statement for an empty list, because the
    /// standard demands a statement.
    pub fn statements(&mut self, statements: &[Statement]) {
        self.deeper();
        for statement in statements {
            self.new_line();
            self.statement(statement);
        }
        if statements.is_empty() {
            self.new_line();
            self.put(";");
        }
        self.shallower();
    }

    fn statement(&mut self, statement: &Statement) {
        match statement {
            Statement::Assign(target, value) => {
                self.target(target);
                self.between_blanks(":=");
                self.expression(value);
            }
            Statement::If(branches, otherwise) => self.branches(branches, otherwise.as_deref()),
            Statement::Case(selector, branches, otherwise) => {
                self.case(selector, branches, otherwise.as_deref());
            }
            Statement::For(parts) => {
                self.for_head(parts);
                self.statements(&parts.body);
                self.closing("END_FOR");
            }
            Statement::While(condition, body) => {
                self.head("WHILE", condition, "DO");
                self.statements(body);
                self.closing("END_WHILE");
            }
            Statement::Repeat(body, condition) => {
                self.word("REPEAT");
                self.statements(body);
                self.closing("UNTIL");
                self.blank();
                self.expression(condition);
                self.closing("END_REPEAT");
            }
            Statement::Invoke {
                instance,
                inputs,
                outputs,
            } => self.invocation(*instance, inputs, outputs),
            Statement::Exit => self.word("EXIT"),
            Statement::Return => self.word("RETURN"),
            Statement::Raw(text) => return self.raw(text),
        }
        self.put(";");
    }

    /// Writes an expression between two keywords.
    fn head(&mut self, first: &str, expression: &Expression, last: &str) {
        self.word(first);
        self.blank();
        self.expression(expression);
        self.blank();
        self.word(last);
    }

    fn closing(&mut self, keyword: &str) {
        self.new_line();
        self.word(keyword);
    }

    fn target(&mut self, target: &AssignmentTarget) {
        match target {
            AssignmentTarget::Place(place) => self.place(place),
            AssignmentTarget::Bit(place, bit) => self.bit(place, *bit),
            AssignmentTarget::Result => self.put(&self.pou.name),
        }
    }

    fn branches(&mut self, branches: &[(Expression, Vec<Statement>)], otherwise: Option<&[Statement]>) {
        for (number, (condition, body)) in branches.iter().enumerate() {
            let keyword = if number == 0 { "IF" } else { "ELSIF" };
            if number > 0 {
                self.new_line();
            }
            self.head(keyword, condition, "THEN");
            self.statements(body);
        }
        self.otherwise(otherwise);
        self.closing("END_IF");
    }

    fn otherwise(&mut self, otherwise: Option<&[Statement]>) {
        if let Some(body) = otherwise {
            self.closing("ELSE");
            self.statements(body);
        }
    }

    fn case(&mut self, selector: &Expression, branches: &[CaseBranch], otherwise: Option<&[Statement]>) {
        self.head("CASE", selector, "OF");
        self.deeper();
        for branch in branches {
            self.new_line();
            self.list(&branch.labels, |writer, label| writer.label(label));
            self.put(":");
            self.statements(&branch.body);
        }
        self.shallower();
        self.otherwise(otherwise);
        self.closing("END_CASE");
    }

    /// Writes a label, whose numbers the second edition writes in decimal digits only.
    fn label(&mut self, label: &CaseLabel) {
        let varied = std::mem::take(&mut self.style.varied_notation);
        match label {
            CaseLabel::One(value) => self.expression(value),
            CaseLabel::Range(low, high) => {
                self.expression(low);
                self.put("..");
                self.expression(high);
            }
        }
        self.style.varied_notation = varied;
    }

    fn for_head(&mut self, parts: &ForLoop) {
        let ForLoop {
            variable,
            from,
            to,
            by,
            ..
        } = parts;
        self.word("FOR");
        self.blank();
        if let Some(variable) = self.variable(*variable) {
            self.put(&variable.name);
        }
        self.between_blanks(":=");
        self.expression(from);
        self.between_blanks("TO");
        self.expression(to);
        if let Some(by) = by {
            self.between_blanks("BY");
            self.expression(by);
        }
        self.blank();
        self.word("DO");
    }

    fn invocation(&mut self, instance: VariableId, inputs: &[Argument], outputs: &[(VariableId, Place)]) {
        let Some(variable) = self.variable(instance) else {
            return;
        };
        let parameters = match variable.ty {
            Type::Block(block) => Unit::Block(block).variables(self.program),
            _ => &[],
        };
        self.put(&variable.name);
        self.put("(");
        self.list(inputs, |writer, input| {
            writer.parameter(parameters, input);
            writer.expression(&input.value);
        });
        for (number, (output, place)) in outputs.iter().enumerate() {
            if number > 0 || !inputs.is_empty() {
                self.comma();
            }
            if let Some(output) = parameters.get(output.0) {
                self.put(&output.name);
            }
            self.between_blanks("=>");
            self.place(place);
        }
        self.put(")");
    }
}
