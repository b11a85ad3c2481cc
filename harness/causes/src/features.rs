//! The features of a small program: the constructs by which the defects of programs are told apart.

use crate::literals::{form_of_number, kind, line_with_number, special_literal, type_of_token, valued_types};
use crate::names::DeclaredNames;
use crate::normal::Normal;
use crate::operations::{LOOPS, operations};
use crate::shape::{in_declarations, own_functions, path};
use crate::sign::is_of_reading;
use crate::statements::is_block;
use crate::title::{unimplemented, unit_of};
use crate::tokens::{ProgramToken, ProgramTokenKind, tokens};
use std::collections::BTreeSet;
use stickler_run::Fact;

/// The features of where a line stands.
pub(crate) const PLACES: [&str; 3] = ["type", "declaration", "statement"];
/// The feature of a mistake that is a literal without a type.
pub(crate) const LITERAL: &str = "untyped literal";
/// The feature of a truth value or a text with its type.
pub(crate) const TYPED_LITERAL: &str = "typed truth value or text";
/// The feature of a place where a value of every type is accepted.
pub(crate) const UNCHECKED: &str = "unchecked";

/// Returns whether an engine says that it could not read a program.
pub(crate) fn is_unread(got: &[Fact]) -> bool {
    let reported = got.iter().find_map(Fact::diagnostic);
    let code = reported.and_then(|reported| reported.code.as_deref());
    code.is_some_and(is_of_reading)
}

/// A small program with the line that matters.
pub(crate) struct MarkedProgram<'p> {
    tokens: Vec<ProgramToken<'p>>,
    /// The names that the program declares.
    own: BTreeSet<String>,
    /// The number of the line at which the expected or the actual diagnostic stands.
    line: Option<u32>,
    /// Whether the engine could not read the program.
    is_unread: bool,
    /// The literals that the engine takes alone.
    innocent: &'p [String],
}

impl<'p> MarkedProgram<'p> {
    pub(crate) fn new(normal: &'p Normal) -> MarkedProgram<'p> {
        let deviation = &normal.deviation;
        // A compiler that has lost the place says line 1, without a column or with the first.
        let line = |facts: &[Fact]| {
            let placed = facts
                .iter()
                .filter_map(Fact::diagnostic)
                .find(|one| one.line.is_some())?;
            let has_column = placed.column.is_some_and(|column| column > 1);
            placed.line.filter(|line| *line > 1 || has_column)
        };
        let tokens = tokens(&normal.program);
        let reported = deviation.got.iter().find_map(Fact::diagnostic);
        MarkedProgram {
            own: own_functions(&tokens),
            tokens,
            line: line(&deviation.got)
                .or_else(|| line(&deviation.expected))
                .or_else(|| line_with_number(&normal.program, reported.map_or("", |one| &one.message))),
            is_unread: is_unread(&deviation.got),
            innocent: &normal.innocent,
        }
    }

    /// Returns the tokens of the line that matters; of the whole program where no line is known.
    fn of_line(&self) -> Vec<ProgramToken<'p>> {
        let on_line = |token: &&ProgramToken<'p>| self.line.is_none_or(|line| token.line == line);
        let found: Vec<ProgramToken<'p>> = self.tokens.iter().filter(on_line).copied().collect();
        // Some compilers name the line behind the mistake, or one of a file of their own.
        match found.iter().any(|token| token.kind != ProgramTokenKind::Sign) {
            true => found,
            false => self.tokens.clone(),
        }
    }

    /// Returns the features of a mistake that is accepted: the operators of its line, what it assigns, or the kinds of its operands.
    /// Operators of all kinds are one feature, and so are conversion functions, because a compiler checks the types around them in one
    /// place. Where `is_unchecked`, the compiler checks no types there, and the value is no feature.
    pub(crate) fn of_mistake(&self, is_unchecked: bool) -> BTreeSet<String> {
        let line = self.of_line();
        let as_one = |operation: String| match operation.as_str() {
            "arithmetic" | "power" | "comparison" | "bitwise operator" | "sign" => "operator".to_owned(),
            "call" if self.calls_block(&line) => "call of a block".to_owned(),
            conversion if conversion.contains("_TO_") => "conversion function".to_owned(),
            _ => operation,
        };
        let mut features: BTreeSet<String> = operations(&line, &self.own).into_iter().map(as_one).collect();
        if is_unchecked {
            features.remove("subscript or list");
            features.extend(self.target(&line).map(str::to_owned));
        }
        if features.is_empty() {
            let value = line.iter().rfind(|token| token.kind != ProgramTokenKind::Sign);
            let is_untyped = value
                .is_some_and(|value| matches!(value.kind, ProgramTokenKind::Number | ProgramTokenKind::Text));
            // Where a literal stands is told by the code, if it matters at all.
            features.insert(match is_untyped && !is_unchecked {
                true => LITERAL.to_owned(),
                false => self.place().to_owned(),
            });
        }
        features
    }

    /// Returns the forms of the literals of the line that matters, where these are no plain numbers: what is wrong with one that
    /// should not be read says its form alone.
    pub(crate) fn forms_of_literals(&self) -> BTreeSet<String> {
        let line = self.of_line();
        let mut words: Vec<String> = Vec::new();
        for (at, token) in line.iter().enumerate() {
            let is_part =
                token.kind != ProgramTokenKind::Sign || matches!(token.text, "." | "-" | "+" | "#" | ":");
            let continues = at > 0 && is_part && line[at - 1].end() == token.start;
            match words.last_mut().filter(|_| continues) {
                Some(word) => word.push_str(token.text),
                None => words.push(token.text.to_owned()),
            }
        }
        let forms = words.iter().filter_map(|word| form_of_number(word));
        forms.collect()
    }

    /// Returns where the line that matters stands.
    pub(crate) fn place(&self) -> &'static str {
        place_of(&self.tokens, self.line)
    }

    /// Returns whether a line calls an instance of a function block.
    fn calls_block(&self, line: &[ProgramToken<'_>]) -> bool {
        let names = DeclaredNames::new(&self.tokens);
        let mut pairs = line.windows(2);
        pairs.any(|pair| {
            let ty = names.words.get(&pair[0].text.to_ascii_uppercase());
            pair[1].text == "(" && ty.is_some_and(|ty| is_block(&self.tokens, ty))
        })
    }

    /// Returns the kind of variable that a line assigns, unless that is a plain one.
    fn target(&self, line: &[ProgramToken<'_>]) -> Option<&'static str> {
        let sign = line.iter().position(|token| token.text == ":=")?;
        let end = path(line, 0)?;
        let mut heads = self.tokens.windows(2);
        let is_result = heads.any(|pair| pair[0].is("FUNCTION") && pair[1].is(line[0].text));
        match end {
            1 if sign == 1 && is_result => Some("result of a function"),
            end if end > 1 && end == sign => Some("field or element"),
            _ => None,
        }
    }

    /// Returns the features of a program of which something is not implemented: the kinds of the variables on its line, and whether
    /// that stands in a program or in another unit, which has its variables elsewhere; without such variables, the operations.
    pub(crate) fn of_missing(&self, normal: &Normal) -> BTreeSet<String> {
        let program = normal.program.as_str();
        let text = unimplemented(program, &normal.deviation.got);
        let line = tokens(text);
        let all = &self.tokens;
        let names = DeclaredNames::new(all);
        let kinds = line.iter().filter_map(|token| {
            let ty = names.words.get(&token.text.to_ascii_uppercase())?;
            let declared = all
                .windows(3)
                .find(|three| three[0].is(ty) && three[1].text == ":");
            let ty = declared
                .map_or(ty.as_str(), |three| three[2].text)
                .to_ascii_uppercase();
            Some(match ty.split(' ').next()? {
                "ARRAY" => "array",
                "STRUCT" => "structure",
                _ if is_block(all, &ty) => "instance of a function block",
                _ => return None,
            })
        });
        let mut features: BTreeSet<String> = kinds.map(str::to_owned).collect();
        if passes_in_out(&line, &names) {
            features.insert("VAR_IN_OUT".to_owned());
        }
        if features.is_empty() {
            features = operations(&line, &self.own);
            if features.is_empty() {
                features.insert("statement".to_owned());
            }
            return features;
        }
        let is_program = unit_of(program, text).is_none();
        features.extend((!is_program).then(|| "function or function block".to_owned()));
        if is_program {
            features.extend(
                operations(&line, &self.own)
                    .into_iter()
                    .filter(|one| one == "bit access"),
            );
        }
        features
    }

    /// Returns whether a program converts between values of different kinds.
    pub(crate) fn mixes_kinds(&self) -> bool {
        self.kinds().len() > 1
    }

    /// Returns the kinds of the values of a program between which conversions are one piece of work.
    fn kinds(&self) -> BTreeSet<&'static str> {
        valued_types(&self.tokens).into_iter().filter_map(kind).collect()
    }

    /// Returns the kinds of loops of a program.
    pub(crate) fn loops(&self) -> BTreeSet<String> {
        let begins = |word: &&str| self.tokens.iter().any(|token| token.is(word));
        LOOPS.into_iter().filter(begins).map(str::to_owned).collect()
    }

    /// Returns the features of a program that stops, or does not stop, with a fault.
    pub(crate) fn of_fault(&self) -> BTreeSet<String> {
        let mut features = operations(&self.tokens, &self.own);
        features.remove("call");
        features
    }

    /// Returns the features of a program that is rejected wrongly: those of the line, and, where the engine could read the
    /// program, the kinds of declarations.
    pub(crate) fn of_rejection(&self) -> BTreeSet<String> {
        let line = self.of_line();
        let operations = operations(&line, &self.own).into_iter();
        let mut features: BTreeSet<String> = operations.map(|one| either_way(&one)).collect();
        // One of the two is the other with the comparison turned round.
        if features.remove("MIN") {
            features.insert("MAX".to_owned());
        }
        let mut literals: Vec<String> = self.special_literals(&line);
        literals.extend(self.signed_literal(&line));
        // An operator whose types are refused is refused anywhere, and so is one of the sign of a number.
        let operators = match self.is_unread {
            true => BTreeSet::new(),
            false => operators(&line),
        };
        // A literal that the engine does not know is not known anywhere, and a function is not known to a parser anywhere.
        let is_unknown_anywhere = self.is_unread && self.calls_library(&line);
        if literals.is_empty() && !is_unknown_anywhere {
            let place = if operators.is_empty() {
                self.place()
            } else {
                PLACES[2]
            };
            features.insert(place.to_owned());
        }
        if !operators.is_empty() {
            features.remove("sign");
            features.extend(operators);
            features.extend(self.operand_kinds(&line));
        }
        features.extend(literals.into_iter().map(|form| match form.as_str() {
            // A compiler that takes typed numbers lacks these by one piece of work.
            "BOOL#" | "STRING#" | "WSTRING#" | "CHAR#" | "WCHAR#" => TYPED_LITERAL.to_owned(),
            _ => form,
        }));
        let by_name = line
            .windows(2)
            .any(|pair| pair[0].text == ":=" && pair[1].kind == ProgramTokenKind::Word);
        if by_name && features.contains("declaration") {
            features.insert("initial value by name".to_owned());
        }
        if !self.is_unread {
            features.extend(declarations(&self.tokens));
        }
        features
    }

    /// Returns the kinds of the operands on a line; numbers are of one kind.
    fn operand_kinds(&self, line: &[ProgramToken<'_>]) -> BTreeSet<String> {
        let names = DeclaredNames::new(&self.tokens);
        let kinds = line.iter().filter_map(|token| match token.kind {
            ProgramTokenKind::Number => Some("number"),
            _ => match kind(type_of_token(token).or_else(|| names.type_of(token))?)? {
                "integer" | "real" => Some("number"),
                other => Some(other),
            },
        });
        kinds.map(str::to_owned).collect()
    }

    /// Returns whether a function is called that the program does not declare.
    fn calls_library(&self, tokens: &[ProgramToken<'_>]) -> bool {
        let mut pairs = tokens.windows(2);
        pairs.any(|pair| {
            pair[0].kind == ProgramTokenKind::Word
                && pair[1].text == "("
                && !self.own.contains(&pair[0].text.to_ascii_uppercase())
        })
    }

    /// Returns the form of a typed number with its sign behind the `#`, where one is not known to be taken by the engine.
    fn signed_literal(&self, tokens: &[ProgramToken<'_>]) -> Option<String> {
        let is_signed = |token: &ProgramToken<'_>| {
            token.kind == ProgramTokenKind::Typed
                && token.text.contains("#-")
                && special_literal(token).is_none()
        };
        let is_innocent =
            |token: &ProgramToken<'_>| self.innocent.iter().any(|literal| literal.as_str() == token.text);
        let mut signed = tokens.iter().filter(|token| is_signed(token));
        signed
            .any(|token| !is_innocent(token))
            .then(|| "typed literal with a sign".to_owned())
    }

    /// Returns the forms of those literals that are not known to be taken by the engine.
    fn special_literals(&self, tokens: &[ProgramToken<'_>]) -> Vec<String> {
        let is_innocent =
            |token: &&ProgramToken<'_>| self.innocent.iter().any(|literal| literal.as_str() == token.text);
        let suspects = tokens.iter().filter(|token| !is_innocent(token));
        suspects.filter_map(special_literal).collect()
    }

    /// Returns whether the engine could read the program, and the line that matters has a literal of a form that it may not know,
    /// and no function.
    pub(crate) fn has_special_literal(&self) -> bool {
        let line = self.of_line();
        !self.is_unread && !self.calls_library(&line) && !self.special_literals(&line).is_empty()
    }

    fn has_initial_value(&self) -> bool {
        let declared = in_declarations(&self.tokens);
        let mut pairs = self.tokens.iter().zip(declared);
        pairs.any(|(token, declared)| declared && token.text == ":=")
    }

    fn has_typed_literal(&self) -> bool {
        self.tokens
            .iter()
            .any(|token| token.kind == ProgramTokenKind::Typed)
    }

    /// Returns the features of a program that computes a wrong value, and whether it converts between types. `is_initial` where
    /// the value is one that a variable begins with.
    pub(crate) fn of_value(&self, is_initial: bool) -> (BTreeSet<String>, bool) {
        let features = operations(&self.tokens, &self.own).into_iter();
        let mut features: BTreeSet<String> = features.map(|one| of_numbers(&one)).collect();
        features.remove("call");
        // What is converted may have a sign before it.
        features.remove("sign");
        let types = valued_types(&self.tokens);
        let kinds = self.kinds();
        let is_initial = is_initial && self.has_initial_value();
        // A plain literal has the type of what begins with it.
        let converts = types.len() > 1 && (!is_initial || self.has_typed_literal());
        // An assignment converts between these types, or it would be the normal form; the place converts nothing.
        let are_numbers = kinds.iter().all(|kind| matches!(*kind, "integer" | "real"));
        let converts_nothing = are_numbers && (is_initial || features.contains("output argument"));
        if converts && converts_nothing {
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
        let literals = self.special_literals(&self.tokens);
        // A text with an escape is read in one way wherever it stands.
        let is_escaped = literals.iter().any(|form| form.ends_with("-with-escape"));
        features.extend(literals);
        features.extend(declarations(&self.tokens));
        if operations(&self.tokens, &self.own).is_empty() && !is_escaped {
            let place = if self.has_initial_value() {
                "initial value"
            } else {
                "assigned value"
            };
            features.insert(place.to_owned());
            if declarations(&self.tokens).is_empty() {
                features.extend(kinds.into_iter().map(str::to_owned));
            }
        }
        (features, false)
    }
}

/// Returns the name of a conversion between a real number and an integer without the family of the integer: how it rounds is one piece of
/// work, and numbers that one family does not have are properties of the value.
fn of_numbers(operation: &str) -> String {
    let side = |side: &str| match side {
        "signed" | "unsigned" | "bitstring" => "integer".to_owned(),
        other => other.to_owned(),
    };
    match operation.split_once("_TO_") {
        Some((from, into)) if from == "real" || into == "real" => format!("{}_TO_{}", side(from), side(into)),
        _ => operation.to_owned(),
    }
}

/// Returns the name of a conversion and its opposite, where an operation is one: a compiler that lacks one of them lacks the pair of
/// types, and one that lacks some of those from and to texts lacks them all.
fn either_way(operation: &str) -> String {
    match operation.split_once("_TO_") {
        Some((from, into)) if from == "text" || into == "text" => "conversion of texts".to_owned(),
        Some((from, into)) => format!("{}_TO_{}", from.min(into), from.max(into)),
        None => operation.to_owned(),
    }
}

/// Returns whether a line passes an argument to a variable of VAR_IN_OUT by its name.
pub(crate) fn passes_in_out(line: &[ProgramToken<'_>], names: &DeclaredNames) -> bool {
    line.windows(3).any(|three| {
        matches!(three[0].text, "(" | ",")
            && three[2].text == ":="
            && names.in_outs.contains(&three[1].text.to_ascii_uppercase())
    })
}

/// Returns the operators of a line; the sign of a number is one that calculates.
fn operators(line: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let all = operations(line, &BTreeSet::new()).into_iter();
    let is_operator = |one: &String| {
        matches!(
            one.as_str(),
            "arithmetic" | "comparison" | "bitwise operator" | "power"
        )
    };
    let mut found: BTreeSet<String> = all.filter(is_operator).collect();
    if line.iter().any(|token| matches!(token.text, "+" | "-")) {
        found.insert("arithmetic".to_owned());
    }
    found
}

/// Returns where a line stands.
fn place_of(tokens: &[ProgramToken<'_>], line: Option<u32>) -> &'static str {
    // A section may begin on the line itself.
    let first = tokens.iter().find(|token| Some(token.line) == line);
    let before = tokens
        .iter()
        .take_while(|token| line.is_none_or(|line| token.line < line));
    let mut place = "statement";
    for token in before
        .chain(first)
        .filter(|token| token.kind == ProgramTokenKind::Word)
    {
        let upper = token.text.to_ascii_uppercase();
        place = match upper.as_str() {
            "TYPE" => "type",
            "END_TYPE" | "END_VAR" => "statement",
            _ if upper == "VAR" || upper.starts_with("VAR_") => "declaration",
            _ => place,
        };
    }
    place
}

/// Returns the kinds of declarations in a program, without those that every program has.
fn declarations(tokens: &[ProgramToken<'_>]) -> BTreeSet<String> {
    let words: BTreeSet<String> = tokens
        .iter()
        .map(|token| token.text.to_ascii_uppercase())
        .collect();
    let special = [
        "STRUCT",
        "ARRAY",
        "FUNCTION",
        "FUNCTION_BLOCK",
        "VAR_IN_OUT",
        "VAR_OUTPUT",
        "VAR_EXTERNAL",
        "VAR_GLOBAL",
        "VAR_TEMP",
        "CONSTANT",
        "RETAIN",
        "CONFIGURATION",
    ];
    let found = special.iter().filter(|word| words.contains(**word));
    let mut found: BTreeSet<String> = found.map(|word| (*word).to_owned()).collect();
    if tokens.iter().any(|token| token.is_located) {
        found.insert("AT".to_owned());
    }
    let is_composed = found.contains("STRUCT") || found.contains("ARRAY");
    if words.contains("TYPE") && !is_composed {
        found.insert("type of one's own".to_owned());
    }
    found
}
