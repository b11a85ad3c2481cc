//! The features of the language that a program uses, by their keys in `conformance-cases/features.toml`.
//!
//! What a program uses does not depend on the dialect, of which only the nesting of comments and the names of types and functions
//! are taken: a program with `.%X3` uses partial access also where the dialect lacks it. Variables, assignments, and plain literals of numbers and truth
//! values are in nearly every program and are no features.

mod expressions;

use crate::lexer::lex;
use crate::names::{DeclaredKind, declared};
use crate::namespaces::Namespaces;
use crate::source::Span;
use crate::token::TokenKind;
use crate::tree::{
    CaseFolded, CaseLabel, Declaration, ExpressionKind, Initializer, InitializerKind, Name, PointerForm, Pou,
    PouKind, SourceUnit, Statement, StatementKind, TypeDeclaration, TypeSpecification, TypeSpecificationKind,
    VariableBlock, VariableGroup, VariableKind,
};
use crate::visitor::{Context, Part, Place, Visitor, walk};
use rustc_hash::FxHashMap;
use std::borrow::Cow;
use std::collections::BTreeSet;
use stickler_types::dialect::{PartialAccess, ThirdEditionTypes};
use stickler_types::{DeclaredFeatures, Dialect, ElementaryType};

/// The key of a feature in `conformance-cases/features.toml`; of a standard function its name in small letters, behind which
/// `-function` stands where an operator has that key.
pub type FeatureKey = Cow<'static, str>;

/// A feature where a program uses it.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FeatureUse {
    /// The key of the feature.
    pub key: FeatureKey,
    /// The place in the text.
    pub span: Span,
}

/// Returns the keys of the features that a program uses.
pub fn features(text: &str, dialect: &Dialect) -> BTreeSet<FeatureKey> {
    let uses = feature_uses(text, dialect).into_iter();
    uses.map(|used| used.key).collect()
}

/// Returns the features that a program uses, each where it does, in the order of the text.
pub fn feature_uses(text: &str, dialect: &Dialect) -> Vec<FeatureUse> {
    let dialect = with_all_syntax(dialect);
    let (unit, _) = crate::parse(text, &dialect);
    let mut finder = FeatureFinder::new(text, &unit, &dialect);
    walk(&unit, &mut finder);
    finder.namespaces(&unit);
    finder.configurations(&unit);
    finder.tokens(&dialect);
    let mut found = finder.found;
    found.sort_by_key(|used| used.span.start);
    found
}

/// Returns the rules of a dialect with the syntax that any dialect has, for reading programs of which it does not matter whether the
/// dialect takes them.
pub(crate) fn with_all_syntax(dialect: &Dialect) -> Dialect {
    Dialect {
        bit_access: true,
        partial_access: PartialAccess::UpToLongWords,
        third_edition_types: ThirdEditionTypes::All,
        lengths_in_parentheses: true,
        reals_without_point: true,
        ends_without_semicolon: true,
        library_namespaces: true,
        ampersand_and_power: true,
        features: DeclaredFeatures::NONE,
        ..dialect.clone()
    }
}

/// A walk that notes features.
struct FeatureFinder<'t, 's> {
    text: &'s str,
    /// The dialect, of which the names of types and functions are taken.
    dialect: &'t Dialect,
    /// The kind of each declaration of the program by its name; of several of one name the last.
    declared: FxHashMap<CaseFolded<'s>, DeclaredKind>,
    /// The types with which variables and fields are declared, by name.
    types: FxHashMap<CaseFolded<'s>, &'t TypeSpecification<'s>>,
    /// The number of inputs of each function and function block, VAR_IN_OUT among them.
    inputs: FxHashMap<CaseFolded<'s>, usize>,
    namespaces: Namespaces<'s>,
    found: Vec<FeatureUse>,
}

impl<'t, 's> FeatureFinder<'t, 's> {
    fn new(text: &'s str, unit: &'t SourceUnit<'s>, dialect: &'t Dialect) -> FeatureFinder<'t, 's> {
        let names = declared(unit);
        let of_group = |name: &crate::names::DeclaredName<'t, 's>| {
            let group = name.group?;
            Some((CaseFolded(name.name.text), &group.specification))
        };
        let mut inputs: FxHashMap<CaseFolded<'s>, usize> = FxHashMap::default();
        for name in &names {
            use VariableKind::{InOut, Input};
            let is_input = matches!(name.kind, DeclaredKind::Variable(Input | InOut));
            if let Some(pou) = name.inside.filter(|_| is_input) {
                *inputs.entry(CaseFolded(pou.name.text)).or_default() += 1;
            }
        }
        FeatureFinder {
            text,
            dialect,
            inputs,
            declared: names
                .iter()
                .map(|name| (CaseFolded(name.name.text), name.kind))
                .collect(),
            types: names.iter().filter_map(of_group).collect(),
            namespaces: Namespaces::new(unit, false),
            found: Vec::new(),
        }
    }

    fn note(&mut self, key: impl Into<FeatureKey>, span: Span) {
        let key = key.into();
        self.found.push(FeatureUse { key, span });
    }

    fn note_if(&mut self, is_used: bool, key: &'static str, span: Span) {
        if is_used {
            self.note(key, span);
        }
    }

    /// Notes an elementary type, but INT and BOOL, which nearly every program has.
    fn note_type(&mut self, ty: ElementaryType, span: Span) {
        if !matches!(ty, ElementaryType::Int | ElementaryType::Bool) {
            self.note(ty.name().to_ascii_lowercase(), span);
        }
    }

    /// Returns what the program declares under a name; `None` where it declares nothing of the kind.
    fn declared(&self, name: &str) -> Option<DeclaredKind> {
        self.declared.get(&CaseFolded(name)).copied()
    }

    /// Returns the function block that the program declares and of which a variable is an instance; `None` for other variables.
    fn block_of(&self, variable: &str) -> Option<&'s str> {
        match self.types.get(&CaseFolded(variable))?.kind {
            TypeSpecificationKind::Named(ty) => {
                let is_block = self.declared(ty.text) == Some(DeclaredKind::Pou(PouKind::FunctionBlock));
                is_block.then_some(ty.text)
            }
            _ => None,
        }
    }

    /// Returns whether the program declares a variable of the name as a reference or pointer.
    fn is_pointer(&self, variable: &str) -> bool {
        let declared = self.types.get(&CaseFolded(variable));
        declared.is_some_and(|ty| matches!(ty.kind, TypeSpecificationKind::Pointer { .. }))
    }

    fn namespaces(&mut self, unit: &SourceUnit<'_>) {
        for declaration in &unit.declarations {
            if let Declaration::Namespace(name) | Declaration::Using(name) = declaration {
                self.note("namespace", name.span);
            }
        }
    }

    fn configurations(&mut self, unit: &SourceUnit<'_>) {
        for configuration in unit.configurations() {
            self.note("configuration", configuration.span);
            for resource in &configuration.resources {
                if let Some((name, _)) = &resource.header {
                    self.note("resource", name.span);
                }
                for task in &resource.tasks {
                    self.note("task", task.name.span);
                }
            }
        }
    }

    /// Notes what is seen in the words of a text alone: comments, pragmas, and the forms of some signs and numbers.
    fn tokens(&mut self, dialect: &Dialect) {
        let text = self.text;
        let lexer = lex(text, dialect);
        for span in &lexer.comments {
            let key = match span.text(text).as_bytes() {
                [b'{', ..] => "pragma",
                [b'/', b'/', ..] => "line-comment",
                [b'/', ..] => "slash-comment",
                [b'(', b'*', inner @ ..] if inner.windows(2).any(|pair| pair == b"(*") => "nested-comment",
                _ => continue,
            };
            self.note(key, *span);
        }
        for token in &lexer.tokens {
            let written = token.span.text(text);
            match token.kind {
                TokenKind::Ampersand => self.note("ampersand", token.span),
                TokenKind::Real if !written.contains('.') => {
                    self.note("real-without-point", token.span);
                }
                TokenKind::Partial => self.note(partial_access(written), token.span),
                _ => {}
            }
            if token.kind.is_literal() && is_number_with_underscore(written) {
                self.note("literal-underscore", token.span);
            }
        }
    }
}

/// Returns the feature of a form of partial access: `%X3`, `%3`, `%B1` …
fn partial_access(written: &str) -> &'static str {
    match written.as_bytes().get(1).map(u8::to_ascii_uppercase) {
        Some(b'B') => "partial-access-byte",
        Some(b'W') => "partial-access-word",
        Some(b'D') => "partial-access-double-word",
        Some(b'L') => "partial-access-long-word",
        _ => "partial-access-bit",
    }
}

/// Returns the key of the feature of a standard function block, such as `TON` and `CTU_DINT`; `None` for other names.
pub fn standard_block(name: &str) -> Option<&'static str> {
    let name = name.to_ascii_uppercase();
    let (family, of_type) = name.rsplit_once('_').unwrap_or((&name, ""));
    match (family, of_type) {
        ("SR" | "RS", "") => Some("bistable-blocks"),
        ("SEMA", "") => Some("semaphore-block"),
        ("R" | "F", "TRIG") => Some("edge-blocks"),
        ("CTU" | "CTD" | "CTUD", "") => Some("counter-blocks"),
        ("CTU" | "CTD" | "CTUD", _) => Some("typed-counter-blocks"),
        ("TP" | "TON" | "TOF", "") => Some("timer-blocks"),
        ("TP" | "TON" | "TOF", "LTIME") => Some("long-timer-blocks"),
        _ => None,
    }
}

/// Returns whether a number is written with an underscore between its digits.
fn is_number_with_underscore(written: &str) -> bool {
    let value = written.split_once('#').map_or(written, |(_, value)| value);
    let unsigned = value.trim_start_matches(['-', '+']);
    let is_number = unsigned.starts_with(|first: char| first.is_ascii_digit());
    is_number && value.contains('_')
}

impl<'t, 's: 't> Visitor<'t, 's> for FeatureFinder<'t, 's> {
    fn pou(&mut self, pou: &'t Pou<'s>, _: &Context<'t, 's>) {
        let span = pou.name.span;
        self.note_if(!pou.using.is_empty(), "namespace", span);
        match pou.kind {
            PouKind::Program => {}
            PouKind::Function if pou.result.is_none() => self.note("function-without-result", span),
            PouKind::Function => self.note("function", span),
            PouKind::FunctionBlock => self.note("function-block", span),
            PouKind::Class => self.note("class", span),
            PouKind::Interface => self.note("interface", span),
            PouKind::Method => self.note("method", span),
            PouKind::Getter | PouKind::Setter => self.note("property", span),
        }
        self.note_if(pou.modifiers.access.is_some(), "access-specifier", span);
        for word in pou.modifiers.words() {
            self.note(word.to_ascii_lowercase(), span);
        }
        self.note_if(!pou.extends.is_empty(), "extends", span);
        self.note_if(!pou.implements.is_empty(), "implements", span);
    }

    fn type_declaration(&mut self, declaration: &'t TypeDeclaration<'s>, _: &Context<'t, 's>) {
        use TypeSpecificationKind::{
            Array, Enumeration, Error, Named, Pointer, Structure, Subrange, Text, Union, VariableLengthArray,
        };
        let span = declaration.name.span;
        self.note_if(declaration.extends.is_some(), "structure-extends", span);
        match &declaration.specification.kind {
            Named(_) | Text { .. } => self.note("type-alias", span),
            Array { .. } => self.note("array-type", span),
            Structure(_) | Union(_) => self.end_of_block(declaration.specification.span),
            Subrange { .. } | Enumeration { .. } | VariableLengthArray { .. } | Pointer { .. } | Error => {}
        }
        if let Some(initializer) = &declaration.initializer {
            self.note("type-initial-value", initializer.span);
        }
    }

    fn section(&mut self, section: &'t VariableBlock<'s>, _: &Context<'t, 's>) {
        if section.kind != VariableKind::Local {
            let key = section.kind.as_str().to_ascii_lowercase().replace('_', "-");
            self.note(key, section.span);
        }
        self.note_if(section.access.is_some(), "access-specifier", section.span);
        self.note_if(section.constant, "constant", section.span);
        if let Some(retention) = section.retention {
            let is_retain = retention == CaseFolded("RETAIN");
            self.note(if is_retain { "retain" } else { "non-retain" }, section.span);
        }
    }

    fn variables(&mut self, group: &'t VariableGroup<'s>, at: &Context<'t, 's>) {
        if let Some(location) = &group.location {
            let key = match group.is_partly_located() {
                true => "partly-located-variable",
                false => "located-variable",
            };
            self.note(key, location.span);
        }
        self.note_if(group.edge.is_some(), "edge-input", group.specification.span);
        let is_field = at.is_field();
        let initializer = group.initializer.as_ref();
        let is_plain = initializer.is_some_and(|one| matches!(one.kind, InitializerKind::Expression(_)));
        if let Some(initializer) = initializer.filter(|_| is_field || is_plain) {
            let keys = ["initial-value", "field-initial-value"];
            self.note(keys[usize::from(is_field)], initializer.span);
        }
        if let TypeSpecificationKind::Named(ty) = &group.specification.kind {
            match self.declared(ty.unqualified().text) {
                Some(DeclaredKind::Pou(PouKind::FunctionBlock)) => {
                    self.note("function-block-instance", ty.span);
                    let is_held = at
                        .section
                        .is_some_and(|section| section.kind != VariableKind::InOut);
                    let in_function = at.pou.is_some_and(|pou| pou.kind == PouKind::Function);
                    self.note_if(is_held && in_function, "function-block-in-function", ty.span);
                }
                Some(DeclaredKind::Pou(PouKind::Interface)) => self.note("interface-variable", ty.span),
                _ => {}
            }
        }
    }

    fn specification(&mut self, specification: &'t TypeSpecification<'s>, at: &Context<'t, 's>) {
        let span = specification.span;
        match &specification.kind {
            TypeSpecificationKind::Named(name) => self.named_type(name),
            TypeSpecificationKind::Text { name, .. } => {
                self.named_type(name);
                self.note("string-length", span);
            }
            TypeSpecificationKind::Subrange { base, .. } => {
                self.named_type(base);
                self.note("subrange", span);
            }
            TypeSpecificationKind::Array { dimensions, .. } => {
                self.note("array", span);
                self.note_if(dimensions.len() > 1, "array-dimensions", span);
                let written = |id| at.unit.expression(id).map(|limit| limit.span.text(self.text));
                let mut limits = dimensions.iter();
                let has_one = limits.any(|(low, high)| written(*low) == written(*high));
                self.note_if(has_one, "array-one-element", span);
            }
            TypeSpecificationKind::VariableLengthArray { .. } => {
                self.note("variable-length-array", span);
                use VariableKind::{Input, Output};
                let is_input = at
                    .section
                    .is_some_and(|section| matches!(section.kind, Input | Output));
                self.note_if(is_input, "variable-length-input", span);
            }
            TypeSpecificationKind::Enumeration { base, values } => {
                self.note("enumeration", span);
                if let Some(base) = base {
                    self.named_type(base);
                    self.note("enumeration-base-type", span);
                }
                let has_number = values.iter().any(|(_, number)| number.is_some());
                self.note_if(has_number, "enumeration-number", span);
            }
            TypeSpecificationKind::Structure(_) => self.note("structure", span),
            TypeSpecificationKind::Union(_) => self.note("union", span),
            TypeSpecificationKind::Pointer { form, target } => {
                self.note(form.feature(), span);
                let is_nested = matches!(&target.kind, TypeSpecificationKind::Pointer { form, .. } if *form != PointerForm::PointerTo);
                self.note_if(is_nested, "reference-nested", span);
            }
            TypeSpecificationKind::Error => {}
        }
    }

    fn initializer(&mut self, initializer: &'t Initializer<'s>, _: &Context<'t, 's>) {
        match &initializer.kind {
            InitializerKind::Expression(_) => {}
            InitializerKind::Array(elements) => {
                self.note("array-initial-value", initializer.span);
                let repeats = elements.iter().any(|element| element.repetition.is_some());
                self.note_if(repeats, "array-repetition", initializer.span);
            }
            InitializerKind::Structure(_) => self.note("structure-initial-value", initializer.span),
        }
    }

    fn statement(&mut self, statement: &'t Statement, _: &Context<'t, 's>) {
        let span = statement.span;
        if statement.kind.is_block() {
            self.end_of_block(span);
        }
        match &statement.kind {
            StatementKind::Assignment { .. } | StatementKind::Call(_) => {}
            StatementKind::Binding { .. } => self.note("reference-binding", span),
            StatementKind::If { branches, otherwise } => {
                self.note("if", span);
                self.note_if(branches.len() > 1, "elsif", span);
                self.note_if(otherwise.is_some(), "else", span);
            }
            StatementKind::Case {
                branches, otherwise, ..
            } => {
                self.note("case", span);
                let mut labels = branches.iter().flat_map(|branch| &branch.labels);
                let has_range = labels.any(|label| matches!(label, CaseLabel::Range(..)));
                self.note_if(has_range, "case-range", span);
                let has_list = branches.iter().any(|branch| branch.labels.len() > 1);
                self.note_if(has_list, "case-list", span);
                self.note_if(otherwise.is_some(), "case-else", span);
            }
            StatementKind::For { by, .. } => {
                self.note("for", span);
                self.note_if(by.is_some(), "for-by", span);
            }
            StatementKind::While { .. } => self.note("while", span),
            StatementKind::Repeat { .. } => self.note("repeat", span),
            StatementKind::Exit => self.note("exit", span),
            StatementKind::Continue => self.note("continue", span),
            StatementKind::Return => self.note("return", span),
            StatementKind::Jump(_) | StatementKind::Label(_) => self.note("jump", span),
            StatementKind::Empty => self.note("empty-statement", span),
        }
    }

    fn expression(&mut self, part: Part<'t, 's>, at: &Context<'t, 's>) {
        let is_callee = part.place == Place::Callee;
        let around = part.around.and_then(|id| at.unit.expression(id));
        match &part.expression.kind {
            ExpressionKind::Name(_) | ExpressionKind::Field { .. } if is_callee => {}
            _ => self.expression_features(part.expression, around, at),
        }
    }
}

impl<'s> FeatureFinder<'_, 's> {
    /// Notes what has an END_… of its own and no `;` behind it.
    fn end_of_block(&mut self, span: Span) {
        let (own, behind) = self.text.split_at(span.end as usize);
        // A block that is cut short has no end.
        let mut words = own.rsplit(|letter: char| !letter.is_alphanumeric() && letter != '_');
        let last = words.next();
        let has_end = last.is_some_and(|word| word.to_ascii_uppercase().starts_with("END_"));
        let is_closed = behind.trim_start().starts_with([';', ':', '(', '/', '{']);
        self.note_if(has_end && !is_closed, "end-without-semicolon", span);
    }

    fn named_type(&mut self, name: &Name<'s>) {
        if let Some((qualifier, _)) = name.text.split_once('.') {
            self.note_if(!self.namespaces.has(qualifier), "qualified-name", name.span);
        }
        if let Some(ty) = self.dialect.elementary(name.text) {
            self.note_type(ty, name.span);
        } else if let Some(key) = standard_block(name.text)
            && self.declared(name.text).is_none()
        {
            self.note(key, name.span);
        }
    }
}
