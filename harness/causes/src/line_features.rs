//! The features of the line of a small program that shows the defect: the constructs by which the defects of programs are told apart.
//!
//! A feature is a word. Most are the words of `work.toml`, and the forms of literals; these are made here:
//!
//! | feature | meaning |
//! |---|---|
//! | `type`, `declaration`, `statement` | where the line stands: among the types, in a section of variables, in a body |
//! | `untyped literal` | the mistake is a literal without a type |
//! | `operator` | an operator that calculates or compares, of any kind, for a mistake that is accepted |
//! | `call of a block` | the line calls an instance of a function block |
//! | `conversion function` | a function that converts by its name, for a mistake that is accepted |
//! | `conversion of texts`, `real_TO_signed` | a conversion by name in either direction, for a program that is rejected wrongly |
//! | `integer of more than 31 bits`, `63`, `64` | a literal that an `i32`, an `i64` or a `u64` does not hold |
//! | `large integer as a label` | a label of CASE that an `i32` or an `i64` does not hold |
//! | `parameter of a standard function`, `partial access` | what the line calls or selects |
//! | `result of a function`, `part of a variable` | what the line assigns; a part is a field, an element or a bit |
//! | `typed literal beyond its type` | a literal such as `SINT#128` |
//! | `array`, `array of structures`, `structure`, `enumeration`, `instance of a function block`, `VAR_IN_OUT` | the variables of something that is not implemented |
//! | `function or function block` | that stands in another unit than a program |
//! | `number`, `duration`, `date or time`, `text` | the kinds of the operands, for an operator that is rejected wrongly |
//! | `initial value by name` | a variable begins with what has a name, such as a constant |
//! | `initial value`, `assigned value` | how a variable gets a wrong value where nothing is computed |
//! | `conversion` | a number becomes one of another type as an initial value or an output argument |
//! | `derived type` | the line gives or takes a whole array, a structure or an enumeration, for a mistake that is accepted |
//! | `AT` | a located variable, for a mistake that is accepted |
//! | `conversion integer and text` | an assignment or an operation converts between values of these kinds |

mod refused;

use crate::failure_sign::is_unread;
use crate::lines::{LinePlace, line_with_number, place_of};
use crate::malformed::forms_of_literals;
use crate::normal_form::Normal;
use crate::program::{Part, ReadProgram};
use crate::question::{Deviation, wrong_values};
use crate::words::{converted, kind, type_of_word, valued_types, words};
use crate::work::{Role, Work, of_numbers, words_of, works};
use std::collections::BTreeSet;
use stickler_run::Fact;
use stickler_syntax::source::Span;
use stickler_syntax::tree::{Argument, ExpressionKind, TypeSpecificationKind, VariableKind};
use stickler_syntax::visitor::Place;
use stickler_types::{Code, Value};

/// The feature of a line that stands among the types.
const IN_TYPES: &str = "type";
/// The feature of a line that stands in a section of variables.
const IN_DECLARATIONS: &str = "declaration";
/// The feature of a line that stands in a body.
pub(crate) const IN_STATEMENTS: &str = "statement";
/// The features of where a line stands.
pub(crate) const LINE_PLACES: [&str; 3] = [IN_TYPES, IN_DECLARATIONS, IN_STATEMENTS];
/// The feature of a mistake that is a literal without a type.
pub(crate) const LITERAL: &str = "untyped literal";

/// The feature of something not implemented that stands in another unit than a PROGRAM.
pub(crate) const IN_OTHER_UNIT: &str = "function or function block";
/// The feature of something not implemented with an instance.
pub(crate) const INSTANCE: &str = "instance of a function block";
/// The feature of a variable that has a location.
const LOCATED: &str = "AT";
/// The feature of a mistake with a whole array, a structure or an enumeration.
pub(crate) const DERIVED: &str = "derived type";

/// The feature of a standard function that refuses the types of its arguments.
pub(crate) const STANDARD_PARAMETER: &str = "parameter of a standard function";

/// The functions of one real number, which are one group of the standard (Table 28).
const OF_REAL: [&str; 10] = [
    "SQRT", "LN", "LOG", "EXP", "SIN", "COS", "TAN", "ASIN", "ACOS", "ATAN",
];

/// The feature of a large integer that is a label of CASE.
const LARGE_LABEL: &str = "large integer as a label";

/// The words with which engines say that they do not know a function that they name.
const UNKNOWN: [&str; 8] = [
    "not declared",
    "undeclared",
    "not defined",
    "undefined",
    "unknown",
    "not found",
    "not resolve",
    "no function",
];

/// A set of words.
type Words = BTreeSet<String>;

/// Returns the function of the library that a program calls and an engine says that it does not know; `None` where it says something else.
pub(crate) fn lacked_function<'s>(program: &ReadProgram<'_, 's>, got: &[Fact]) -> Option<&'s str> {
    let said = got.iter().find_map(|fact| match fact {
        Fact::Unusable { reason } => Some(reason),
        _ => Some(&fact.diagnostic()?.message),
    })?;
    let mut codes = got.iter().filter_map(|fact| fact.diagnostic()?.registered_code());
    let is_unknown = codes.any(|code| code == Code::FunctionCallUndeclared)
        || UNKNOWN
            .iter()
            .any(|words| said.to_ascii_lowercase().contains(words));
    // What stands in quotes is no text here.
    let is_said = |name: &&str| {
        let mut words = said.split(|sign: char| !sign.is_alphanumeric() && sign != '_');
        // The names of a linker have the types of the arguments behind two underscores.
        words.any(|word| {
            word.split("__")
                .next()
                .is_some_and(|own| own.eq_ignore_ascii_case(name))
        })
    };
    let callees = program.at(Place::Callee).map(|part| program.text(part.id));
    let mut of_library = callees.filter(|name| is_unknown && !program.declares(name));
    of_library.find(is_said)
}

/// A small program with the line that matters: the one that shows its defect.
pub(crate) struct ProgramAndLine<'t, 's> {
    pub(crate) program: &'t ReadProgram<'t, 's>,
    works: Vec<Work>,
    /// The number of the line at which the expected or the actual diagnostic stands.
    line: Option<u32>,
    /// Whether the engine could not read the program.
    is_unread: bool,
    /// The literals that the engine takes alone.
    innocent: Words,
}

impl<'t, 's> ProgramAndLine<'t, 's> {
    pub(crate) fn new(program: &'t ReadProgram<'t, 's>, normal: &Normal) -> ProgramAndLine<'t, 's> {
        let deviation = &normal.deviation;
        // A compiler that has lost the place says line 1, without a column or with the first.
        let line = |facts: &[Fact]| {
            let mut reported = facts.iter().filter_map(Fact::diagnostic);
            let placed = reported.find(|one| one.line.is_some())?;
            let has_column = placed.column.is_some_and(|column| column > 1);
            placed.line.filter(|line| *line > 1 || has_column)
        };
        let reported = deviation.got.iter().find_map(Fact::diagnostic);
        let by_number = || line_with_number(program, reported.map_or("", |one| &one.message));
        let line = line(&deviation.got)
            .or_else(|| line(&deviation.expected))
            .or_else(by_number);
        // Some compilers name the line behind the mistake, or one of a file of their own.
        let has_words = |number: &u32| {
            let text = program.line_text(*number).unwrap_or_default();
            text.contains(|character: char| {
                character.is_ascii_alphanumeric() || matches!(character, '\'' | '"')
            })
        };
        ProgramAndLine {
            works: works(program.text),
            line: line.filter(has_words),
            is_unread: is_unread(&deviation.got),
            innocent: normal.innocent_literals(),
            program,
        }
    }

    fn is_on_line(&self, span: Span) -> bool {
        self.line.is_none_or(|line| self.program.line(span) == line)
    }

    /// Returns the text of the line that matters; of the whole program where no line is known.
    fn text(&self) -> &'s str {
        let line = self.line.and_then(|line| self.program.line_text(line));
        line.unwrap_or(self.program.text)
    }

    /// Returns the pieces of work on the line that matters.
    fn on_line(&self, role: Role) -> Words {
        words_of(self.works.iter().filter(|work| self.is_on_line(work.span)), role)
    }

    /// Returns the features of a mistake that is accepted: the operators of its line, what it assigns, or the kinds of its operands.
    /// Operators of all kinds are one feature, and so are conversion functions, because a compiler checks the types around them in one
    /// place. Where `is_unchecked`, the compiler checks no types there, and the value is no feature.
    pub(crate) fn of_mistake(&self, is_unchecked: bool) -> Words {
        let as_one = |operation: String| match operation.as_str() {
            "arithmetic" | "power" | "comparison" | "bitwise operator" | "sign" => "operator".to_owned(),
            "call" if self.calls_instance() => "call of a block".to_owned(),
            conversion if conversion.contains("_TO_") => "conversion function".to_owned(),
            _ => operation,
        };
        let mut features: Words = self.on_line(Role::Operation).into_iter().map(as_one).collect();
        if is_unchecked {
            // What kind of variable the line assigns is told by `target`.
            features.remove("subscript or list");
            if let Some(target) = self.target() {
                features.remove("bit access");
                features.insert(target.to_owned());
            }
        }
        if features.is_empty() {
            let value = words(self.text())
                .into_iter()
                .rfind(|word| !matches!(*word, ";" | ")" | "]" | ","));
            let is_untyped = value.is_some_and(|value| {
                value.starts_with(|first: char| first.is_ascii_digit() || matches!(first, '\'' | '"'))
            });
            // Where a literal stands is told by the diagnostic code, if it matters at all.
            features.insert(match is_untyped && !is_unchecked && !self.passes_derived() {
                true => LITERAL.to_owned(),
                false => self.place().to_owned(),
            });
            // If a plain variable were given to another too, that would be the normal form.
            if !is_unchecked && features.contains(IN_STATEMENTS) {
                features.extend(self.target().map(str::to_owned));
                features.extend(self.source().map(str::to_owned));
            }
        }
        // Where one function of the library takes arguments of any type, most do.
        let is_of_library = |part: &Part<'_, '_>| {
            let name = self.program.text(part.id);
            self.is_on_line(part.expression.span) && !self.program.declares(name) && converted(name).is_none()
        };
        if is_unchecked && self.program.at(Place::Callee).any(is_of_library) {
            features = Words::from(["argument of a standard function".to_owned()]);
        }
        // A compiler that does not look at located variables checks nothing of them.
        let is_located = |word: &&str| {
            let group = self.program.group(word);
            group.is_some_and(|group| group.location.is_some())
        };
        let located = words(self.text()).into_iter().find(is_located);
        features.extend(located.map(|_| LOCATED.to_owned()));
        features.extend(self.passes_derived().then(|| DERIVED.to_owned()));
        features
    }

    /// Returns whether the line gives or takes a value of a derived type, which compilers compare apart from elementary ones.
    pub(crate) fn passes_derived(&self) -> bool {
        let names = self.program.parts.iter().filter(|part| {
            !matches!(part.place, Place::Base | Place::Callee) && self.is_on_line(part.expression.span)
        });
        let mut kinds = names.filter_map(|part| self.variable_kind(part.name()?));
        kinds.any(|kind| kind != INSTANCE)
    }

    /// Returns the forms of the literals of the line that matters, where these are no plain numbers: of a
    /// literal that should not be read, its form alone says what is wrong.
    pub(crate) fn forms_of_literals(&self) -> Words {
        forms_of_literals(self.text())
    }

    /// Returns whether a word of a message is a name that the program declares, but for its digits; a small letter alone may be an article.
    pub(crate) fn names(&self, word: &str) -> bool {
        let plain = |name: &str| name.replace(|sign: char| sign.is_ascii_digit(), "");
        let is_word = |name: &str| plain(name).eq_ignore_ascii_case(word);
        let mut names = self.program.names.iter().map(|one| one.name.text);
        let mut units = self.program.unit.pous().map(|unit| unit.name.text);
        let is_article = word.len() < 2 && !word.starts_with(|sign: char| sign.is_ascii_uppercase());
        !is_article && (names.any(is_word) || units.any(is_word))
    }

    /// Returns whether the line names a part of a variable.
    pub(crate) fn has_part(&self) -> bool {
        words(self.text()).contains(&".")
    }

    /// Returns whether the line has an escape in a text.
    pub(crate) fn has_escape(&self) -> bool {
        words(self.text())
            .into_iter()
            .any(|word| word.starts_with(['\'', '"']) && word.contains('$'))
    }

    /// Returns where the line that matters stands.
    pub(crate) fn place(&self) -> &'static str {
        match self.line.map(|line| place_of(self.program, line)) {
            Some(LinePlace::Types) => IN_TYPES,
            Some(LinePlace::Section(_)) => IN_DECLARATIONS,
            Some(LinePlace::Statement) | None => IN_STATEMENTS,
        }
    }

    /// Returns the names that the line calls.
    fn callees(&self) -> impl Iterator<Item = &'s str> {
        let callees = self
            .program
            .at(Place::Callee)
            .filter(|part| self.is_on_line(part.expression.span));
        callees.map(|part| self.program.text(part.id))
    }

    /// Returns whether the line calls an instance of a function block.
    pub(crate) fn calls_instance(&self) -> bool {
        self.callees().any(|name| self.program.is_instance(name))
    }

    /// Returns the kind of variable that the line assigns, unless that is a plain one.
    fn target(&self) -> Option<&'static str> {
        let mut targets = self.program.at(Place::Target);
        let part = targets.find(|part| self.is_on_line(part.expression.span))?;
        match &part.expression.kind {
            ExpressionKind::Name(name) if part.pou?.name.is(name.text) => Some("result of a function"),
            ExpressionKind::Field { .. }
            | ExpressionKind::Index { .. }
            | ExpressionKind::Bit { .. }
            | ExpressionKind::Part { .. } => Some("part of a variable"),
            _ => None,
        }
    }

    /// Returns the kind of variable whose value the line assigns, unless that is a plain one.
    fn source(&self) -> Option<&'static str> {
        let mut values = self.program.at(Place::Value);
        let part = values.find(|part| self.is_on_line(part.expression.span))?;
        match &part.expression.kind {
            ExpressionKind::Field { base, .. } if self.program.is_instance(self.program.text(*base)) => {
                Some("output of a function block")
            }
            ExpressionKind::Field { .. } | ExpressionKind::Index { .. } => {
                Some("value of a part of a variable")
            }
            _ => None,
        }
    }

    /// Returns the kind of a variable, unless that is a plain one.
    fn variable_kind(&self, name: &str) -> Option<&'static str> {
        if self.program.is_instance(name) {
            return Some(INSTANCE);
        }
        let declared = &self.program.group(name)?.specification.kind;
        let own = match declared {
            TypeSpecificationKind::Named(name) => self.program.declared_type(name.text),
            _ => None,
        };
        match own.map_or(declared, |own| &own.specification.kind) {
            TypeSpecificationKind::Array { element, .. } => Some(match self.is_structured(element) {
                true => "array of structures",
                false => "array",
            }),
            TypeSpecificationKind::Structure(_) => Some("structure"),
            TypeSpecificationKind::Enumeration { .. } => Some("enumeration"),
            _ => None,
        }
    }

    /// Returns whether the program converts between values of different kinds.
    pub(crate) fn mixes_kinds(&self) -> bool {
        self.value_kinds().len() > 1
    }

    /// Returns the kinds of the values of the program between which conversions are one piece of work.
    fn value_kinds(&self) -> BTreeSet<&'static str> {
        let types = valued_types(self.program.text).into_iter();
        types.filter_map(kind).collect()
    }

    /// Returns whether the line has a partial access, as a feature.
    pub(crate) fn partial_accesses(&self) -> Words {
        let has_part = words(self.text()).iter().any(|word| word.starts_with('%'));
        has_part
            .then(|| "partial access".to_owned())
            .into_iter()
            .collect()
    }

    /// Returns whether the program uses a variable of VAR_EXTERNAL.
    pub(crate) fn uses_external(&self) -> bool {
        let sections = |part: &Part<'_, '_>| self.program.section(part.name()?, part.pou);
        let mut parts = self.program.parts.iter();
        parts.any(|part| sections(part) == Some(VariableKind::External))
    }

    /// Returns which value is lost, where a variable begins with nothing, although its type begins with a value.
    pub(crate) fn lost_value_of_type(&self, deviation: &Deviation) -> Option<&'static str> {
        let (name, (_, got)) = wrong_values(&deviation.expected, &deviation.got).next()?;
        let is_lost = matches!(got, Value::Plain { raw: 0, .. });
        self.program.initial_value_of_type(name).filter(|_| is_lost)
    }

    /// Returns the features of a program that computes a wrong value, and whether it converts between types. `is_initial` where
    /// the value is one that a variable begins with.
    pub(crate) fn of_value(&self, is_initial: bool) -> (Words, bool) {
        let operations = words_of(&self.works, Role::Operation);
        let mut features: Words = operations.iter().map(|one| of_numbers(one)).collect();
        // A call only leads to the unit whose operations are counted too.
        features.remove("call");
        // What is converted may have a sign before it.
        features.remove("sign");
        let begins = self.program.at(Place::InitialValue).next().is_some();
        let is_initial = is_initial && begins;
        let kinds = self.value_kinds();
        let text = self.program.text;
        // A plain literal has the type of what begins with it.
        let has_typed_literal = || {
            words(text)
                .iter()
                .any(|word| word.contains('#') && type_of_word(word).is_some())
        };
        let converts = valued_types(text).len() > 1 && (!is_initial || has_typed_literal());
        // If an assignment converted wrongly between these types too, it would be the normal form. So what fails is that this place does
        // not convert, whatever the types are.
        let are_numbers = kinds.iter().all(|kind| matches!(*kind, "integer" | "real"));
        if converts && are_numbers && (is_initial || features.contains("output argument")) {
            features.extend(is_initial.then(|| "initial value".to_owned()));
            features.insert("conversion".to_owned());
            return (features, true);
        }
        if converts {
            let kinds: Vec<&str> = kinds.into_iter().collect();
            features.insert(format!("conversion {}", kinds.join(" and ")));
            // Whether a variable or an element of a list is converted is one piece of work.
            features.remove("subscript or list");
            return (features, true);
        }
        let literals = self.suspect_literals(|_| true);
        // A text with an escape is read in one way wherever it stands.
        let is_escaped = literals.iter().any(|literal| literal.starts_with("escape "));
        let declarations = words_of(&self.works, Role::Declaration);
        if operations.is_empty() && !is_escaped {
            features.insert(if begins { "initial value" } else { "assigned value" }.to_owned());
            if declarations.is_empty() {
                features.extend(kinds.into_iter().map(str::to_owned));
            }
        }
        features.extend(literals);
        features.extend(declarations);
        (features, false)
    }
}

/// Returns whether an argument is passed to a variable of VAR_IN_OUT by its name, in a call at one of some places.
pub(crate) fn passes_in_out(program: &ReadProgram<'_, '_>, is_here: impl Fn(Span) -> bool) -> bool {
    let is_in_out = |argument: &Argument<'_>| match argument {
        Argument::Named { name, .. } => program.section(name.text, None) == Some(VariableKind::InOut),
        _ => false,
    };
    program.parts.iter().any(|part| {
        let call = program.call(part.id).filter(|_| is_here(part.expression.span));
        call.is_some_and(|(_, arguments)| arguments.iter().any(is_in_out))
    })
}
