//! The names that a program declares, with their types and initial values, found without a parser.

use crate::shape::{in_declarations, own_functions, path};
use crate::tokens::{ProgramToken, ProgramTokenKind};
use std::collections::{BTreeMap, BTreeSet};
use stickler_types::ElementaryType;

/// The maximum number of types that a type of one's own is resolved through.
const MAX_ALIASES: usize = 4;

/// The names that a program declares.
pub(crate) struct DeclaredNames {
    /// The elementary type of each variable, field, parameter, element of an array and result of a function.
    types: BTreeMap<String, ElementaryType>,
    /// The literal with which a variable begins.
    pub(crate) initial: BTreeMap<String, String>,
    /// The inputs of each function and function block.
    pub(crate) inputs: BTreeMap<String, Vec<String>>,
    /// The variables of VAR_IN_OUT.
    pub(crate) in_outs: BTreeSet<String>,
    /// The variables of VAR_GLOBAL.
    pub(crate) globals: BTreeSet<String>,
    /// The type of each variable, field and parameter as it is written.
    pub(crate) words: BTreeMap<String, String>,
    pub(crate) own: BTreeSet<String>,
    declared: Vec<bool>,
}

impl DeclaredNames {
    pub(crate) fn new(tokens: &[ProgramToken<'_>]) -> DeclaredNames {
        let mut names = DeclaredNames {
            types: BTreeMap::new(),
            initial: BTreeMap::new(),
            inputs: BTreeMap::new(),
            in_outs: BTreeSet::new(),
            globals: BTreeSet::new(),
            words: BTreeMap::new(),
            own: own_functions(tokens),
            declared: in_declarations(tokens),
        };
        let mut aliases: BTreeMap<String, String> = BTreeMap::new();
        let (mut unit, mut section) = (String::new(), String::new());
        for (at, token) in tokens.iter().enumerate() {
            let upper = token.text.to_ascii_uppercase();
            if ["FUNCTION", "FUNCTION_BLOCK", "PROGRAM"].contains(&upper.as_str()) {
                unit = tokens
                    .get(at + 1)
                    .map(|name| name.text.to_ascii_uppercase())
                    .unwrap_or_default();
                section.clear();
            } else if upper.starts_with("VAR") && names.declared[at] {
                section = upper.clone();
            }
            let is_head = at > 0 && tokens[at - 1].is("FUNCTION");
            let is_named = token.kind == ProgramTokenKind::Word && (names.declared[at] || is_head);
            if !is_named
                || !tokens
                    .get(at + 1)
                    .is_some_and(|next| matches!(next.text, ":" | ","))
            {
                continue;
            }
            let Some(colon) = colon_of(tokens, at) else {
                continue;
            };
            if section == "VAR_INPUT" {
                names.inputs.entry(unit.clone()).or_default().push(upper.clone());
            } else if section == "VAR_IN_OUT" {
                names.in_outs.insert(upper.clone());
            } else if section == "VAR_GLOBAL" {
                names.globals.insert(upper.clone());
            }
            let ends = |token: &&ProgramToken<'_>| !is_head && token.text != ";" && token.text != ":=";
            let ty: Vec<&ProgramToken<'_>> = match is_head {
                true => tokens.get(colon + 1).into_iter().collect(),
                false => tokens[colon + 1..].iter().take_while(ends).collect(),
            };
            let words: Vec<&str> = ty.iter().map(|word| word.text).collect();
            names.words.insert(upper.clone(), words.join(" "));
            let is_array = ty.iter().any(|word| word.is("OF"));
            if let Some(word) = ty.last().filter(|_| ty.len() == 1 || is_array) {
                aliases.insert(upper.clone(), word.text.to_ascii_uppercase());
            }
            let value = colon + 1 + ty.len() + 1;
            if let Some(literal) = literal(tokens, value).filter(|_| !is_head) {
                names.initial.insert(upper, literal);
            }
        }
        for name in aliases.keys() {
            let mut word = name;
            for _ in 0..MAX_ALIASES {
                let Some(next) = aliases.get(word) else { break };
                word = next;
                if let Some(ty) = ElementaryType::from_name(word) {
                    names.types.insert(name.clone(), ty);
                    break;
                }
            }
        }
        names
    }

    pub(crate) fn type_of(&self, token: &ProgramToken<'_>) -> Option<ElementaryType> {
        let is_name = token.kind == ProgramTokenKind::Word;
        self.types
            .get(&token.text.to_ascii_uppercase())
            .copied()
            .filter(|_| is_name)
    }

    /// Returns the type of an operand that is a literal with its type or a variable.
    pub(crate) fn type_of_operand(&self, token: &ProgramToken<'_>) -> Option<ElementaryType> {
        prefix_type(token).or_else(|| self.type_of(token))
    }

    /// Returns the written type of what the token at this place is given to by name.
    pub(crate) fn words(&self, tokens: &[ProgramToken<'_>], at: usize) -> Option<String> {
        let sign = at.checked_sub(1).filter(|before| tokens[*before].text == ":=")?;
        let target = tokens.get(sign.checked_sub(1)?)?;
        self.words.get(&target.text.to_ascii_uppercase()).cloned()
    }

    pub(crate) fn is_declared_at(&self, at: usize) -> bool {
        self.declared.get(at).copied().unwrap_or_default()
    }

    /// Returns the type of what the operand at this place is given to, where nothing else is done with it.
    pub(crate) fn target(&self, tokens: &[ProgramToken<'_>], at: usize) -> Option<ElementaryType> {
        let mut end = at + 1;
        if tokens.get(at)?.text == "-" {
            end += 1;
        }
        if !tokens
            .get(end)
            .is_none_or(|next| matches!(next.text, ";" | "," | ")" | "]"))
        {
            return None;
        }
        let before = at.checked_sub(1)?;
        match tokens[before].text {
            ":=" => self.assigned(tokens, before),
            // The first element of a list.
            "[" if before > 0 && tokens[before - 1].text == ":=" => self.assigned(tokens, before - 1),
            // What is repeated in a list.
            "(" if before > 0 && tokens[before - 1].kind == ProgramTokenKind::Number => {
                let list = tokens[..before].iter().rposition(|token| token.text == "[")?;
                let sign = list.checked_sub(1).filter(|sign| tokens[*sign].text == ":=")?;
                self.assigned(tokens, sign)
            }
            "(" | "," => {
                let open = tokens[..at].iter().rposition(|token| token.text == "(")?;
                let callee = tokens.get(open.checked_sub(1)?)?;
                let upper = callee.text.to_ascii_uppercase();
                let number = tokens[open..at].iter().filter(|token| token.text == ",").count();
                match self.own.contains(&upper) {
                    true => self.types.get(self.inputs.get(&upper)?.get(number)?).copied(),
                    false => Some(converted(callee)?.0).filter(|_| number == 0),
                }
            }
            _ => None,
        }
    }

    /// Returns the type of the variable, field or element that begins at a token, where nothing follows that is done with it.
    pub(crate) fn whole(&self, tokens: &[ProgramToken<'_>], at: usize) -> Option<ElementaryType> {
        let end = path(tokens, at)?;
        if !tokens
            .get(end)
            .is_some_and(|next| matches!(next.text, ";" | "," | ")"))
        {
            return None;
        }
        // The name before the subscripts of an element has the type of the element.
        let is_name = |place: &usize| tokens[*place].kind == ProgramTokenKind::Word;
        let behind_bracket = tokens[end - 1].text == "]";
        let last = match behind_bracket {
            true => (at..end).rfind(|place| is_name(place) && tokens[place + 1].text == "[")?,
            false => end - 1,
        };
        self.type_of(&tokens[last])
    }

    /// Returns a literal of a type: one that a variable of the type begins with, or a number with all of its bits.
    pub(crate) fn some_value(&self, ty: ElementaryType) -> Option<String> {
        let mut of_type = self
            .initial
            .iter()
            .filter(|(name, _)| self.types.get(*name) == Some(&ty));
        let is_number = ty.is_integer() || ty.is_bit_string() || ty.is_real();
        let plain = match ty.integer_range() {
            Some((0, most)) => most.to_string(),
            Some(_) => "-1".to_owned(),
            None if ty.is_bit_string() => "1".to_owned(),
            None => "1.5".to_owned(),
        };
        let known = of_type.next().map(|(_, literal)| literal.clone());
        known.or_else(|| is_number.then(|| format!("{}#{plain}", ty.name())))
    }

    /// Returns the types between which a value is converted when it is given to a variable of another type, for the arrow or the
    /// assignment sign before it: the value of an output, of a variable, or the result of a conversion function.
    pub(crate) fn met(
        &self,
        tokens: &[ProgramToken<'_>],
        at: usize,
    ) -> Option<(ElementaryType, ElementaryType)> {
        let next = tokens.get(at + 1)?;
        if tokens[at].text == ":=" {
            let result = converted(next).map(|(_, result)| result);
            let source = result.or_else(|| self.whole(tokens, at + 1))?;
            let target = self.assigned(tokens, at)?;
            return (source != target).then_some((source, target));
        }
        let output = tokens.get(at.checked_sub(1)?)?;
        let is_arrow = tokens[at].text == "=>";
        Some((self.type_of(output)?, self.type_of(tokens.get(at + 1)?)?)).filter(|_| is_arrow)
    }

    /// Returns the type of what stands before an assignment sign.
    pub(crate) fn assigned(&self, tokens: &[ProgramToken<'_>], sign: usize) -> Option<ElementaryType> {
        let mut at = sign.checked_sub(1)?;
        if self.is_declared_at(sign) {
            let start = tokens[..sign]
                .iter()
                .rposition(|token| matches!(token.text, ";" | "(" | ":"));
            // Of an initial value the type stands before the sign; of a field within brackets its name does.
            if let Some(colon) = start.filter(|start| tokens[*start].text == ":") {
                at = colon.checked_sub(1)?;
            }
        } else if tokens[at].text == "]" {
            at = tokens[..at]
                .iter()
                .rposition(|token| token.text == "[")?
                .checked_sub(1)?;
        }
        self.type_of(&tokens[at])
    }
}

/// Returns the place of the colon behind a name and those that are declared with it.
fn colon_of(tokens: &[ProgramToken<'_>], at: usize) -> Option<usize> {
    let mut at = at + 1;
    loop {
        match tokens.get(at)?.text {
            ":" => return Some(at),
            "," => at += 2,
            _ => return None,
        }
    }
}

/// Returns the types between which a function converts by its name.
pub(crate) fn converted(token: &ProgramToken<'_>) -> Option<(ElementaryType, ElementaryType)> {
    let upper = token.text.to_ascii_uppercase();
    let (from, into) = upper
        .split_once("_TO_")
        .filter(|_| token.kind == ProgramTokenKind::Word)?;
    Some((ElementaryType::from_name(from)?, ElementaryType::from_name(into)?))
}

/// Returns the literal that begins at a token, with its sign.
pub(crate) fn literal(tokens: &[ProgramToken<'_>], at: usize) -> Option<String> {
    let token = tokens.get(at)?;
    let is_literal = |token: &ProgramToken<'_>| {
        matches!(
            token.kind,
            ProgramTokenKind::Number | ProgramTokenKind::Text | ProgramTokenKind::Typed
        ) || token.is("TRUE")
            || token.is("FALSE")
    };
    if is_literal(token) {
        let ends_signed = |before: &ProgramToken<'_>| before.text == "-" && is_sign(tokens, at - 1);
        let signed = at
            .checked_sub(1)
            .is_some_and(|before| ends_signed(&tokens[before]));
        return (!signed).then(|| token.text.to_owned());
    }
    let next = tokens
        .get(at + 1)
        .filter(|next| next.kind == ProgramTokenKind::Number);
    let next = next.filter(|_| token.text == "-" && is_sign(tokens, at))?;
    Some(format!("-{}", next.text))
}

/// Returns whether the minus at this place is the sign of what follows and no subtraction.
fn is_sign(tokens: &[ProgramToken<'_>], at: usize) -> bool {
    let before = at.checked_sub(1).and_then(|before| tokens.get(before));
    before.is_some_and(|before| before.kind == ProgramTokenKind::Sign && !matches!(before.text, ")" | "]"))
}

/// Returns the type that a literal names.
pub(crate) fn prefix_type(token: &ProgramToken<'_>) -> Option<ElementaryType> {
    let (prefix, _) = token
        .text
        .split_once('#')
        .filter(|_| token.kind == ProgramTokenKind::Typed)?;
    ElementaryType::from_literal_prefix(&prefix.to_ascii_uppercase())
}
