//! The features of a program that an engine does not take: what of its line is rejected, not implemented or of no use.

use super::{
    IN_DECLARATIONS, IN_OTHER_UNIT, IN_STATEMENTS, LARGE_LABEL, LINE_PLACES, LOCATED, OF_REAL,
    ProgramAndLine, STANDARD_PARAMETER, Words, passes_in_out,
};
use crate::lines::{special_section, unit_of};
use crate::malformed::{SIZES, size_of_integer};
use crate::program::Part;
use crate::suspect::unimplemented;
use crate::words::{LOOPS, converted, has_word, kind, words};
use crate::work::{Role, Work, either_way, words_of};
use std::collections::BTreeSet;
use stickler_run::Fact;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{TypeSpecification, TypeSpecificationKind};
use stickler_syntax::visitor::Place;

impl<'t, 's> ProgramAndLine<'t, 's> {
    /// Returns the features of a program of which something is not implemented: the kinds of the variables on its line, and whether
    /// that stands in a program or in another unit, which has its variables elsewhere; without such variables, the operations.
    pub(crate) fn of_missing(&self, got: &[Fact]) -> Words {
        let line = unimplemented(self.program, got);
        let is_there = |span: Span| self.program.line(span) == line;
        let works = self.works.iter().filter(|work| is_there(work.span));
        let operations = words_of(works, Role::Operation);
        let line_words = words(self.program.line_text(line).unwrap_or_default());
        let kinds = line_words.into_iter().filter_map(|word| self.variable_kind(word));
        let mut features: Words = kinds.map(str::to_owned).collect();
        let passes = passes_in_out(self.program, is_there);
        features.extend(passes.then(|| "VAR_IN_OUT".to_owned()));
        // A variable that is only declared may be what is missing.
        let is_common = |one: &String| matches!(one.as_str(), "arithmetic" | "comparison" | "condition");
        if features.is_empty() && operations.iter().all(is_common) {
            let names = self.program.names.iter().map(|one| one.name.text);
            features.extend(
                names
                    .filter_map(|name| self.variable_kind(name))
                    .map(str::to_owned),
            );
        }
        if features.is_empty() {
            return match operations.is_empty() {
                true => Words::from([IN_STATEMENTS.to_owned()]),
                false => operations,
            };
        }
        match unit_of(self.program, line) {
            Some(_) => features.extend([IN_OTHER_UNIT.to_owned()]),
            None => features.extend(operations.into_iter().filter(|one| one == "bit access")),
        }
        features
    }

    /// Returns whether a type is a structure or an array.
    pub(super) fn is_structured(&self, ty: &TypeSpecification<'_>) -> bool {
        let own = match &ty.kind {
            TypeSpecificationKind::Named(name) => self.program.declared_type(name.text),
            _ => None,
        };
        let kind = own.map_or(&ty.kind, |own| &own.specification.kind);
        matches!(
            kind,
            TypeSpecificationKind::Structure(_) | TypeSpecificationKind::Array { .. }
        )
    }

    /// Returns the kinds of loops of the program.
    pub(crate) fn loops(&self) -> Words {
        let is_there = |word: &&str| has_word(self.program.text, word);
        LOOPS.into_iter().filter(is_there).map(str::to_owned).collect()
    }

    /// Returns the features of a program that stops, or does not stop, with a fault.
    pub(crate) fn of_fault(&self) -> Words {
        let mut features = words_of(&self.works, Role::Operation);
        // A call only leads to the unit whose operations are counted too.
        features.remove("call");
        features
    }

    /// Returns the features of a program that is rejected wrongly: those of the line, and, where the engine could read the
    /// program, the kinds of declarations.
    pub(crate) fn of_rejection(&self) -> Words {
        let operations = self.on_line(Role::Operation).into_iter();
        let mut features: Words = operations.map(|one| either_way(&one)).collect();
        let literals = self.suspect_literals(|span| self.is_on_line(span));
        // An operator whose types are refused is refused anywhere; a sign counts as an operator.
        let operators = match self.is_unread {
            true => Words::new(),
            false => self.operators(&features),
        };
        // An unknown literal is refused in every place; so is an unknown function by an engine that stopped at parsing.
        let is_unknown_anywhere = self.is_unread && self.calls_library();
        if literals.is_empty() && !is_unknown_anywhere {
            features.insert(
                match self.place() {
                    _ if !operators.is_empty() => IN_STATEMENTS,
                    // What begins with a value that is not taken does not matter.
                    _ if self.initial_values().next().is_some() => IN_DECLARATIONS,
                    place => place,
                }
                .to_owned(),
            );
        }
        if !operators.is_empty() {
            features.remove("sign");
            features.extend(operators);
            features.extend(self.operand_kinds());
        }
        features.extend(literals);
        // Where a line cannot be read, and does nothing but give a literal, that matters although it is taken elsewhere.
        if self.is_unread
            && features
                .iter()
                .all(|feature| LINE_PLACES.contains(&feature.as_str()))
        {
            features.extend(self.on_line(Role::Literal));
            features.extend(self.text().contains('\'').then(|| "text".to_owned()));
        }
        if features.contains(IN_DECLARATIONS) && self.initial_values().any(|part| part.name().is_some()) {
            features.insert("initial value by name".to_owned());
        }
        if !self.is_unread {
            features.extend(words_of(&self.works, Role::Declaration));
        }
        features
    }

    /// Returns the initial values on the line.
    fn initial_values(&self) -> impl Iterator<Item = &Part<'t, 's>> {
        let initial = self.program.at(Place::InitialValue);
        initial.filter(|part| self.is_on_line(part.expression.span))
    }

    /// Returns the operators among the features of the line; the sign of a number is one that calculates.
    fn operators(&self, features: &Words) -> Words {
        let operators = ["arithmetic", "comparison", "bitwise operator", "power"];
        let is_operator = |one: &&String| operators.contains(&one.as_str());
        let mut found: Words = features.iter().filter(is_operator).cloned().collect();
        let has_sign = words(self.text()).iter().any(|word| matches!(*word, "+" | "-"));
        found.extend(has_sign.then(|| "arithmetic".to_owned()));
        found
    }

    /// Returns the kinds of the operands on the line; numbers are of one kind.
    fn operand_kinds(&self) -> Words {
        let kinds = words(self.text()).into_iter().filter_map(|word| {
            let is_number = word.starts_with(|first: char| first.is_ascii_digit());
            match self.program.type_of_word(word).and_then(kind) {
                _ if is_number => Some("number"),
                Some("integer" | "real") => Some("number"),
                other => other,
            }
        });
        kinds.map(str::to_owned).collect()
    }

    /// Returns whether the line calls a standard function other than a conversion.
    pub(crate) fn calls_standard(&self) -> bool {
        let is_standard = |name: &str| !self.program.declares(name) && converted(name).is_none();
        self.callees().any(is_standard)
    }

    /// Returns the standard functions, and the operators among them, that the line calls.
    pub(crate) fn standard_calls(&self) -> Words {
        let mut called = self.on_line(Role::Operation);
        called.retain(|one| !matches!(one.as_str(), "call" | "sign" | "condition" | "subscript or list"));
        // What one function of a real number takes, all take.
        let is_of_real = |one: &String| OF_REAL.contains(&one.as_str());
        if called.iter().any(is_of_real) {
            called.retain(|one| !is_of_real(one));
            called.insert("function of a real number".to_owned());
        }
        called.insert(STANDARD_PARAMETER.to_owned());
        called
    }

    /// Returns the sections in which the variables of the line are declared, but plain ones and those of inputs.
    pub(crate) fn special_sections(&self) -> BTreeSet<String> {
        let names = self
            .program
            .parts
            .iter()
            .filter(|part| self.is_on_line(part.expression.span));
        let declared = |part: &Part<'_, '_>| Some(self.program.named(part.name()?, part.pou)?.name.span);
        let lines = names.filter_map(|part| Some(self.program.line(declared(part)?)));
        lines
            .filter_map(|line| Some(special_section(self.program, line)?.to_owned()))
            .collect()
    }

    /// Returns whether the line calls a function that the program does not declare.
    pub(super) fn calls_library(&self) -> bool {
        self.callees().any(|name| !self.program.declares(name))
    }

    /// Returns the forms of those literals that are not known to be taken by the engine: of the line that matters, or of all.
    pub(super) fn suspect_literals(&self, is_here: impl Fn(Span) -> bool) -> Words {
        let is_suspect = |work: &&Work| {
            let written = work.span.text(self.program.text);
            is_here(work.span) && !self.innocent.contains(written)
        };
        words_of(self.works.iter().filter(is_suspect), Role::Literal)
    }

    /// Returns the size of the largest integer of the line that matters, where it is one that compilers do not read. The reduction would have
    /// left a smaller number if the size did not matter.
    pub(crate) fn size_of_integers(&self) -> Option<&'static str> {
        let literals = self.program.literals();
        let here = literals.filter(|(part, _)| self.is_on_line(part.expression.span));
        let sizes = here.filter_map(|(part, literal)| {
            let size = size_of_integer(literal)?;
            // The labels of CASE are read by a piece of work of their own, whatever the type of the selector.
            let is_label = part.place == Place::Label && size != SIZES[2];
            Some(if is_label { LARGE_LABEL } else { size })
        });
        sizes.max_by_key(|size| SIZES.iter().position(|one| one == size))
    }

    /// Returns whether the engine could read the program, and the line that matters has a literal of a form that it may not know,
    /// and no function.
    pub(crate) fn has_special_literal(&self) -> bool {
        let literals = self.suspect_literals(|span| self.is_on_line(span));
        !self.is_unread && !self.calls_library() && !literals.is_empty()
    }

    /// Returns the features of a program of which the compiler makes what cannot be built or dies: its operations, and of a program without
    /// them the forms of its literals and the kinds of its declarations.
    pub(crate) fn of_use(&self) -> Words {
        // What a compiler of C says of one comparison, it says of all that are called as functions, and so of what compares its arguments.
        let named = |one: &String| match &**one {
            "LIMIT" => "MAX".to_owned(),
            "EQ" | "NE" | "LT" | "LE" | "GT" | "GE" => "comparison called as a function".to_owned(),
            other => either_way(other),
        };
        let mut features: Words = self.of_fault().iter().map(named).collect();
        features.remove("condition");
        let declared = words_of(&self.works, Role::Declaration);
        // Whatever is done with a variable that has a location may go wrong because of that.
        if features.is_empty() || declared.contains(LOCATED) {
            features.extend(self.suspect_literals(|_| features.is_empty()));
            features.extend(declared);
        }
        features
    }
}
