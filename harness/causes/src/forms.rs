//! Other forms of a small program: with fewer statements, with other operands, types and literals.

use crate::alone::binary;
use crate::malformed::number_of_literal;
use crate::program::{Part, ReadProgram, read};
use crate::words::{elementary, is_number, tokens, type_of_word};
use std::collections::BTreeSet;
use std::ops::Range;
use stickler_suite::without_blank_lines;
use stickler_syntax::Edits;
use stickler_syntax::source::Span;
use stickler_syntax::token::TokenKind;
use stickler_syntax::tree::{
    BinaryOperator, ExpressionKind, Pou, PouKind, StatementKind, TypeSpecificationKind, VariableKind,
};
use stickler_syntax::visitor::{Place, bodies};
use stickler_types::{ElementaryType, Observation};

/// The numeric types in the order of their plainness.
pub(crate) const PLAIN: [&str; 14] = [
    "INT", "DINT", "UINT", "UDINT", "WORD", "DWORD", "LINT", "ULINT", "LWORD", "SINT", "USINT", "BYTE",
    "REAL", "LREAL",
];

/// The bit strings and the unsigned integers of the same size.
const UNSIGNED: [(&str, &str); 4] = [
    ("BYTE", "USINT"),
    ("WORD", "UINT"),
    ("DWORD", "UDINT"),
    ("LWORD", "ULINT"),
];

/// Returns the place of the statements of a unit, with the last semicolon.
pub(crate) fn body(text: &str, pou: &Pou<'_>) -> Option<Range<usize>> {
    let (first, last) = (pou.body.first()?, pou.body.last()?);
    let end = last.span.end as usize;
    let behind = &text[end..];
    let semicolon = behind.find(';').filter(|at| behind[..*at].trim().is_empty());
    Some(first.span.start as usize..end + semicolon.map_or(0, |at| at + 1))
}

/// Returns the place before END_VAR of the last section of a unit.
pub(crate) fn end_of_variables(text: &str, pou: &Pou<'_>) -> Option<usize> {
    let section = pou.blocks.last()?.span;
    text[..section.end as usize].rfind("END_VAR")
}

/// Returns a program with its bodies left out, so that its variables keep what they begin with; none where a unit of it has no
/// variables. They come without the variables that the bodies used, with them, and in a last form each body assigns one variable to
/// itself, since not every compiler takes a body without a statement.
pub(crate) fn only_initial_values(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let (mut edits, mut without) = (Edits::new(), Edits::new());
    for pou in program.unit.pous() {
        let groups = pou.blocks.iter().flat_map(|block| &block.groups);
        let mut own = groups.filter(|group| elementary(group.specification.span.text(text)).is_some());
        let (Some(body), Some(end)) = (body(text, pou), end_of_variables(text, pou)) else {
            return Vec::new();
        };
        without.remove(body.clone());
        // What a program sees of an instance are its outputs.
        let plain = pou.blocks.iter().filter(|block| {
            pou.kind == PouKind::FunctionBlock && block.kind == VariableKind::Local && !block.constant
        });
        for at in plain.map(|block| block.span.start as usize) {
            without.replace(at..at + "VAR".len(), "VAR_OUTPUT");
            edits.replace(at..at + "VAR".len(), "VAR_OUTPUT");
        }
        match own.find_map(|group| group.names.first()) {
            Some(own) => edits.replace(body, format!("{0} := {0};", own.text)),
            None => {
                edits.replace(end..end, "    done : BOOL;\n");
                edits.replace(body, "done := TRUE;");
            }
        }
    }
    let without = without_blank_lines(&without.apply(text)).0;
    vec![without_unused(&without), without, edits.apply(text)]
}

/// Returns a program with one of its bodies replaced by a single statement, for each body: a call of each instance of a function
/// block that the body uses, the assignment of each field and element that it uses to itself, and each of its own statements where
/// none stands in another.
pub(crate) fn with_one_statement(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let mut found = Vec::new();
    for pou in program.unit.pous() {
        let Some(body) = body(text, pou) else { continue };
        let here = |part: &&Part<'_, '_>| body.contains(&(part.expression.span.start as usize));
        let used = || program.parts.iter().filter(here);
        let names = used()
            .filter_map(Part::name)
            .filter(|name| program.is_instance(name));
        let instances = names.map(|name| format!("{name}();"));
        // A program without a statement, for those who take that.
        let none = (pou.kind == PouKind::Program).then(String::new);
        let is_whole = |part: &&Part<'_, '_>| !program.around(part).is_some_and(Part::is_part_of_variable);
        let paths = used().filter(|part| part.is_part_of_variable()).filter(is_whole);
        let paths = paths.map(|part| format!("{0} := {0};", program.text(part.id)));
        let is_flat = pou.body.iter().all(|statement| bodies(statement).is_empty());
        let own = pou.body.iter().filter(|_| is_flat);
        let mut own: Vec<String> = own.map(|one| format!("{};", one.span.text(text))).collect();
        // A plain assignment may be there only because a program needs a statement.
        own.sort_by_key(|one| !one.contains(['.', '[', '(']));
        for statement in none.into_iter().chain(instances).chain(paths).chain(own) {
            let is_none = statement.is_empty();
            let changed = Edits::replacing(body.clone(), statement).apply(text);
            let changed = match is_none {
                true => without_blank_lines(&changed).0,
                false => without_unused(&changed),
            };
            if changed != text && !found.contains(&changed) {
                found.push(changed);
            }
        }
    }
    found
}

/// Returns a program without one of its statements, for each statement of a body that has several: what is wrong may be so before it.
pub(crate) fn without_one_statement(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let several = program.unit.pous().filter(|pou| pou.body.len() > 1);
    let mut found = Vec::new();
    for pou in several {
        let ends = pou.body.iter().skip(1).map(|next| next.span.start as usize);
        let ends = ends.chain(body(text, pou).map(|body| body.end));
        for (statement, end) in pou.body.iter().zip(ends) {
            let changed = Edits::removing(statement.span.start as usize..end).apply(text);
            found.push(without_unused(&without_blank_lines(&changed).0));
        }
    }
    found
}

/// Returns programs in which a FOR loop counts from the last value of its type to that value alone.
pub(crate) fn with_last_value(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let from = program.at(Place::From).filter_map(|from| {
        let StatementKind::For { control, to, by, .. } = from.statement?.kind else {
            return None;
        };
        let (_, most) = program.type_of(control)?.integer_range()?;
        let span = |id| Some(program.part(id)?.expression.span);
        let mut edits = Edits::replacing(from.expression.span, most.to_string());
        let limit = span(to)?;
        edits.replace(limit, most.to_string());
        if let Some(by) = by.and_then(span) {
            edits.remove(limit.end as usize..by.end as usize);
        }
        Some(edits.apply(program.text))
    });
    from.collect()
}

/// Returns programs in which a statement assigns a variable to itself, in the place of one that uses a bit of it or counts with it: the
/// variable may be at fault, whatever is done with it.
pub(crate) fn with_whole_variable(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let is_elementary = |name: &str| {
        let group = program.group(name);
        group.is_some_and(|group| elementary(group.specification.span.text(program.text)).is_some())
    };
    let used = |part: &Part<'_, '_>| {
        let around = program.around(part).map(|around| &around.expression.kind);
        let is_bit = matches!(around, Some(ExpressionKind::Bit { .. }));
        let statement = part
            .statement
            .filter(|_| is_bit || part.place == Place::Control)?;
        let name = part.name().filter(|name| is_elementary(name))?;
        Some((statement.span, format!("{name} := {name}")))
    };
    let used = program.parts.iter().filter_map(used);
    used.map(|(span, whole)| Edits::replacing(span, whole).apply(program.text))
        .map(|changed| without_unused(&changed))
        .collect()
}

/// Returns programs in which an output of a call, or a value, is given to a variable of its own in the place of a bit.
pub(crate) fn with_variable_for_bit(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let is_bit = |part: &&Part<'_, '_>| matches!(part.expression.kind, ExpressionKind::Bit { .. });
    let change = |part: &Part<'_, '_>| {
        let end = end_of_variables(text, part.pou?)?;
        let mut edits = Edits::replacing(part.expression.span, "received");
        edits.replace(end..end, "    received : BOOL;\n");
        Some(without_unused(&edits.apply(text)))
    };
    let given = program.at(Place::OutputArgument).chain(program.at(Place::Target));
    given.filter(is_bit).filter_map(change).collect()
}

/// Returns programs with the numbers that calculations with literals give in the place of these.
pub(crate) fn with_folded_literals(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let number = |id| number_of_literal(program.text(id));
    let fold = |part: &Part<'_, '_>| {
        let (operator, left, right) = binary(program, part.id)?;
        let (left, right) = (number(left)?, number(right)?);
        let folded = match operator {
            BinaryOperator::Add => left.checked_add(right)?,
            BinaryOperator::Subtract => left.checked_sub(right)?,
            BinaryOperator::Multiply => left.checked_mul(right)?,
            _ => return None,
        };
        Some(Edits::replacing(part.expression.span, folded.to_string()).apply(program.text))
    };
    program.parts.iter().filter_map(fold).collect()
}

/// Returns programs in which a variable has the type of the function that is called, and is given in its place: what a function gives may
/// matter no more than its type.
pub(crate) fn with_variable_for_call(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let change = |part: &Part<'_, '_>| {
        let (name, _) = program.call(part.id)?;
        let result = program.unit_of(name)?.result.as_ref()?.span.text(text);
        let end = end_of_variables(text, part.pou?)?;
        let mut edits = Edits::replacing(part.expression.span, "given");
        edits.replace(end..end, format!("    given : {result};\n"));
        Some(without_unused(&edits.apply(text)))
    };
    program.at(Place::Value).filter_map(change).collect()
}

/// Returns programs that measure a text in the end, each with what it observes: the length of the text where that is wrong, or else
/// whether its first wrong character is the one that it has and must not have. So no escape of the right text is needed.
pub(crate) fn with_measured_text(
    program: &ReadProgram<'_, '_>,
    name: &str,
    (wanted, got): (&[u16], &[u16]),
) -> Vec<(String, Observation)> {
    let with = |variable: &str, ty: &str, value: &str| with_last_variable(program, (variable, ty), value);
    if wanted.len() != got.len() {
        return with("length", "INT", &format!("LEN({name})"))
            .into_iter()
            .collect();
    }
    let at = wanted.iter().zip(got).position(|(wanted, got)| wanted != got);
    let plain = at.and_then(|at| Some((at + 1, char::from_u32(got[at].into())?)));
    let plain = plain.filter(|(_, sign)| (' '..='~').contains(sign) && !matches!(sign, '$' | '\'' | '"'));
    let has = |(place, sign): (usize, char)| {
        with("is_other", "BOOL", &format!("MID({name}, 1, {place}) = '{sign}'"))
    };
    plain.and_then(has).into_iter().collect()
}

/// Returns a program whose PROGRAM gives a value to a variable of its own in the end, with what it observes; `None` where it has no
/// variables.
pub(crate) fn with_last_variable(
    program: &ReadProgram<'_, '_>,
    (variable, ty): (&str, &str),
    value: &str,
) -> Option<(String, Observation)> {
    let pou = program.unit.pous().find(|pou| pou.kind == PouKind::Program)?;
    let (end, behind) = (end_of_variables(program.text, pou)?, pou.end.start as usize);
    let mut edits = Edits::new();
    edits.replace(end..end, format!("    {variable} : {ty};\n"));
    edits.replace(behind..behind, format!("    {variable} := {value};\n"));
    Some((edits.apply(program.text), Observation::last(variable, ty)))
}

/// Returns programs with a variable of the right type in the place of an operand that is given to something: programs without
/// their mistake, where the type of an operand is the mistake.
pub(crate) fn with_fitting_operand(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let change = |part: &Part<'_, '_>| {
        let pou = part.pou.filter(|pou| pou.kind == PouKind::Program)?;
        part.statement?;
        let written = program.target_specification(part)?.span.text(text);
        let is_alone = tokens(program.text(part.id)).len() == 1;
        let end = end_of_variables(text, pou).filter(|_| is_alone)?;
        let mut edits = Edits::replacing(part.expression.span, "fitting");
        edits.replace(end..end, format!("    fitting : {written};\n"));
        Some(without_unused(&edits.apply(text)))
    };
    let given = program.at(Place::Value).chain(program.at(Place::NamedArgument));
    given.filter_map(change).collect()
}

/// Returns a program without the variables of its PROGRAM that have a line of their own and are not used.
fn without_unused(text: &str) -> String {
    let lines = read(text, |program| {
        let is_used = |name: &str| program.parts.iter().any(|part| part.is(name));
        let is_local = |pou: &Pou<'_>| pou.kind == PouKind::Program;
        let local = program
            .names
            .iter()
            .filter(|one| one.inside.is_some_and(is_local));
        let unused = local.filter(|one| !is_used(one.name.text));
        Vec::from_iter(unused.map(|one| program.line(one.name.span)))
    });
    let kept = text.split_inclusive('\n').zip(1..);
    let is_kept =
        |(line, number): &(&str, u32)| !lines.contains(number) || line.matches([';', ':', ',']).count() != 2;
    kept.filter(is_kept).map(|(line, _)| line).collect()
}

/// Returns programs with quite another type in the place of a value that a line gives to something: a text where a number stands, a
/// duration where a text stands; or with another type of the variable that takes an output. What the line assigns comes first, and the
/// operands of operators last.
pub(crate) fn with_other_operand(program: &ReadProgram<'_, '_>, line: u32) -> Vec<String> {
    let places = [
        &[Place::Value][..],
        &[Place::NamedArgument],
        &[Place::InitialValue, Place::Argument, Place::Subscript],
        &[Place::OutputArgument],
        &[Place::Right, Place::Left, Place::Operand],
    ];
    let here = program
        .parts
        .iter()
        .filter(|part| program.line(part.expression.span) == line);
    let rank = |place: Place| places.iter().position(|places| places.contains(&place));
    // A subscript of what has no elements is no second mistake.
    let is_of_array = |part: &Part<'_, '_>| {
        let mut bases = program.parts.iter().filter(|base| base.place == Place::Base);
        let base = bases.find(|base| base.around == part.around);
        let kind = base.and_then(|base| Some(&program.specification(base.id)?.kind));
        matches!(kind, Some(TypeSpecificationKind::Array { .. }))
    };
    let mut given: Vec<_> = here
        .filter(|part| part.place != Place::Subscript || is_of_array(part))
        .filter_map(|part| match part.place {
            Place::OutputArgument => {
                let taker = program.group(part.name()?)?;
                Some((rank(part.place)?, taker.specification.span, ["STRING", "TIME"]))
            }
            place => Some((rank(place)?, part.expression.span, ["'a'", "T#1s"])),
        })
        .collect();
    given.sort_by_key(|(rank, ..)| *rank);
    let others = |(_, span, others): (_, Span, [&str; 2])| {
        others.map(|other| Edits::replacing(span, other).apply(program.text))
    };
    given.into_iter().flat_map(others).collect()
}

/// Returns whether a value is one of those that [`with_other_operand`] gives.
pub(crate) fn is_other_operand(program: &ReadProgram<'_, '_>, line: u32) -> bool {
    let text = program.text;
    with_other_operand(program, line)
        .iter()
        .any(|other| other == text)
}

/// Returns a program in which each partial access selects the first bit or byte, which are there in every type.
pub(crate) fn with_first_parts(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let mut edits = Edits::new();
    for token in tokens(text)
        .iter()
        .filter(|token| token.kind == TokenKind::Partial)
    {
        let is_bit = token.span.text(text).to_ascii_uppercase().starts_with("%X");
        edits.replace(token.span, if is_bit { "%X0" } else { "%B0" });
    }
    vec![edits.apply(text)]
}

/// Returns the elementary types that a program names anywhere, also in the names of functions.
pub(crate) fn named_types(text: &str) -> BTreeSet<&'static str> {
    let words = tokens(text)
        .into_iter()
        .map(|token| token.span.text(text).to_ascii_uppercase());
    let mut found = BTreeSet::new();
    for word in words.filter(|word| word.starts_with(|first: char| first.is_ascii_alphabetic())) {
        let name = word.split('#').next().unwrap_or_default();
        found.extend(name.split('_').filter_map(elementary).map(ElementaryType::name));
    }
    found
}

/// Returns a text with types replaced in declarations, prefixes and names of functions.
pub(crate) fn with_types(text: &str, changes: &[(&str, &str)]) -> String {
    let changed = |word: &str| {
        let change = changes.iter().find(|(from, _)| word.eq_ignore_ascii_case(from));
        change.map_or(word, |(_, into)| *into).to_owned()
    };
    let mut edits = Edits::new();
    for token in tokens(text) {
        let word = token.span.text(text);
        if !word.starts_with(|first: char| first.is_ascii_alphabetic()) {
            continue;
        }
        let (name, value) = word.split_at(word.find('#').unwrap_or(word.len()));
        let name: Vec<String> = name.split('_').map(changed).collect();
        edits.replace(token.span, format!("{}{value}", name.join("_")));
    }
    edits.apply(text)
}

/// Returns programs with a plainer numeric type in the place of one, with unsigned integers in the place of bit strings, and with zeros in the
/// place of texts, durations and dates; none where two types would become one.
pub(crate) fn with_plainer_type(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let text = program.text;
    let there = named_types(text);
    let is_free = |name: &str| !there.contains(name);
    let bit_strings: Vec<_> = UNSIGNED
        .into_iter()
        .filter(|(bits, _)| there.contains(bits))
        .collect();
    let mut found = Vec::new();
    // A conversion between two of them has to keep both sizes.
    if bit_strings.len() > 1 && bit_strings.iter().all(|(_, number)| is_free(number)) {
        found.push(with_types(text, &bit_strings));
    }
    for name in &there {
        let is_other = |ty: &ElementaryType| ty.is_text() || ty.is_duration() || ty.is_date_or_time();
        if is_free(PLAIN[0]) && elementary(name).as_ref().is_some_and(is_other) {
            found.push(with_zeros(&with_types(text, &[(name, PLAIN[0])])));
        }
        let ty = elementary(name).filter(|ty| is_number(*ty));
        let plainer = PLAIN.iter().take_while(|plain| *plain != name);
        let is_neighbour =
            |plain: &&&str| elementary(plain).map(ElementaryType::is_real) == ty.map(ElementaryType::is_real);
        let plainer = plainer.filter(is_neighbour).filter(|plain| is_free(plain));
        found.extend(plainer.map(|plain| with_types(text, &[(name, plain)])));
    }
    found
}

/// Returns a text with a zero in the place of each text, duration and date.
fn with_zeros(text: &str) -> String {
    let mut edits = Edits::new();
    for token in tokens(text).iter().filter(|token| token.kind.is_literal()) {
        let literal = token.span.text(text);
        let ty = type_of_word(literal).filter(|_| literal.contains('#'));
        if literal.starts_with(['\'', '"']) || ty.is_some_and(|ty| !is_number(ty)) {
            edits.replace(token.span, "0");
        }
    }
    edits.apply(text)
}

/// Returns programs with one of the types in the place of another, for each pair of types.
pub(crate) fn with_same_types(program: &ReadProgram<'_, '_>) -> Vec<String> {
    let types = named_types(program.text);
    let pairs = types
        .iter()
        .flat_map(|from| types.iter().map(move |into| (*from, *into)));
    let pairs = pairs.filter(|(from, into)| from != into);
    pairs.map(|pair| with_types(program.text, &[pair])).collect()
}
