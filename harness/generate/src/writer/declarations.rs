//! Writing of types, variables, POUs, and the whole text.

use super::Style;
use super::source_writer::SourceWriter;
use crate::model::{DeclaredKind, InitialValue, Pou, Program, Type, TypeDeclaration, Unit, Variable};

/// The text of a program.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct WrittenProgram {
    /// The source text; it ends with a line end.
    pub text: String,
    /// The line, counted from 1, on which each raw expression or statement begins, in the order of the text.
    pub raw_lines: Vec<u32>,
}

/// Writes a program. Accepts any program, also one that is not well-typed; a reference to something that the program does
/// not have is omitted.
pub fn write(program: &Program, style: &Style) -> WrittenProgram {
    let mut writer = SourceWriter::new(program, *style);
    writer.types(&program.types);
    for unit in Unit::all(program) {
        if let Some(pou) = unit.pou(program).filter(|pou| pou.owner.is_none()) {
            writer.pou(unit, pou);
            writer.new_line();
        }
    }
    WrittenProgram {
        text: writer.text,
        raw_lines: writer.raw_lines,
    }
}

impl<'p> SourceWriter<'p> {
    fn pou(&mut self, unit: Unit, pou: &'p Pou) {
        let keyword = match unit {
            Unit::Function(_) if pou.owner.is_some() => "METHOD",
            Unit::Function(_) => "FUNCTION",
            Unit::Block(_) => "FUNCTION_BLOCK",
            Unit::Main | Unit::Types => "PROGRAM",
        };
        self.pou = pou;
        self.word(keyword);
        self.blank();
        if pou.owner.is_some() {
            self.word("PUBLIC");
            self.blank();
        }
        self.put(&pou.name);
        if let Some(result) = &pou.result {
            self.between_blanks(":");
            self.type_name(result);
        }
        for section in pou.variables.chunk_by(|one, next| one.section == next.section) {
            self.section(section);
        }
        if let Unit::Block(block) = unit {
            self.methods(block);
            self.pou = pou;
        }
        self.statements(&pou.body);
        self.new_line();
        self.word(&format!("END_{keyword}"));
    }

    /// Writes the methods of a function block.
    fn methods(&mut self, block: usize) {
        let functions = self.program.functions.iter().enumerate();
        for (number, method) in functions.filter(|(_, function)| function.owner == Some(block)) {
            self.deeper();
            self.new_line();
            self.pou(Unit::Function(number), method);
            self.shallower();
        }
    }

    fn section(&mut self, declared: &[Variable]) {
        let Some(first) = declared.first() else { return };
        self.new_line();
        self.word(first.section.as_str());
        self.deeper();
        for variable in declared {
            self.new_line();
            self.put(&variable.name);
            self.between_blanks(":");
            self.type_name(&variable.ty);
            if let Some(initial) = &variable.initial {
                self.between_blanks(":=");
                self.initial(initial, &variable.ty);
            }
            self.put(";");
        }
        self.shallower();
        self.new_line();
        self.word("END_VAR");
    }

    fn initial(&mut self, initial: &InitialValue, ty: &Type) {
        match initial {
            InitialValue::Expression(value) => self.expression(value),
            InitialValue::Array(values) => {
                self.put("[");
                self.list(values, |writer, value| writer.expression(value));
                self.put("]");
            }
            InitialValue::Structure(values) => {
                let fields = self.program.fields(ty).unwrap_or_default();
                self.put("(");
                self.list(values, |writer, (field, value)| {
                    if let Some((name, ..)) = fields.get(*field) {
                        writer.put(name);
                    }
                    writer.between_blanks(":=");
                    writer.expression(value);
                });
                self.put(")");
            }
        }
    }

    /// Writes a type where it is used: its name, or an array type.
    fn type_name(&mut self, ty: &Type) {
        let program = self.program;
        match ty {
            Type::Elementary(ty) => self.word(ty.name()),
            Type::Array(array) => {
                self.word("ARRAY");
                self.put("[");
                self.list(&array.dimensions, |writer, (low, high)| {
                    writer.put(&format!("{low}..{high}"))
                });
                self.put("]");
                self.between_blanks("OF");
                self.type_name(&array.element);
            }
            Type::Reference(to) => {
                if let Some((word, _)) = program.reference_words() {
                    self.word(word);
                    self.blank();
                    self.type_name(to);
                }
            }
            Type::Declared(declared) => self.put(program.types.get(*declared).map_or("", |ty| &ty.name)),
            Type::Block(block) => self.put(program.blocks.get(*block).map_or("", |block| &block.name)),
        }
    }

    fn types(&mut self, types: &'p [TypeDeclaration]) {
        if types.is_empty() {
            return;
        }
        self.word("TYPE");
        self.deeper();
        for declaration in types {
            self.new_line();
            self.put(&declaration.name);
            self.between_blanks(":");
            self.declared(&declaration.kind);
            self.put(";");
        }
        self.shallower();
        self.new_line();
        self.word("END_TYPE");
        self.new_line();
    }

    fn declared(&mut self, declared: &'p DeclaredKind) {
        match declared {
            DeclaredKind::Enumeration(names) => {
                self.put("(");
                self.list(names, |writer, name| writer.put(name));
                self.put(")");
            }
            DeclaredKind::Alias(ty) => self.type_name(ty),
            DeclaredKind::Structure(fields) => {
                self.word("STRUCT");
                self.deeper();
                for (name, ty, initial) in fields {
                    self.new_line();
                    self.put(name);
                    self.between_blanks(":");
                    self.type_name(ty);
                    if let Some(initial) = initial {
                        self.between_blanks(":=");
                        self.expression(initial);
                    }
                    self.put(";");
                }
                self.shallower();
                self.new_line();
                self.word("END_STRUCT");
            }
        }
    }
}
