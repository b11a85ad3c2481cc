//! The test files of `tests/syntax`.
//!
//! | block | says |
//! |---|---|
//! | `st` | what is wrong with a program, by the marks of [`stickler_mdtest`], in the dialects behind the word (`ironplc-ed2` without one) |
//! | `rendered`, `declared`, `used`, `leaves` | what the renderer writes of the program above, which names it declares and uses, and its literals and names, each with its place and depth |
//! | `equal`, `different` | texts, one a line, of which the trees are all equal, or no two |
//! | `kinds`, `tokens` | the kinds of the tokens of a text, and the tokens themselves |
//! | `lexed` | the diagnostics of the lexer: a code and the text at which it points |
//! | `grouping` | an expression with parentheses around each operation, and brackets around what is written in parentheses |
//! | `tree` | parts of the `Debug` text of the tree, and how often: `Positional ×2 & Named` |
//! | `enormous` | how many diagnostics a text has that is written with repetitions, or the only one: `2:6 S0002` |
//! | `features`, `feature-uses`, `separable`, `parts`, `renamed` | the features of a program, and where it uses them; its names, or why it cannot stand beside others |

use crate::diagnostic::SpannedDiagnostic;
use crate::lexer::lex;
use crate::names::{declared, separable, used};
use crate::source::LineIndex;
use crate::token::TokenKind;
use crate::tree::{Declaration, Expression, ExpressionId, ExpressionKind, StatementKind, UnaryOperator};
use crate::visitor::{Context, Part, Visitor, operands, walk};
use crate::{ProgramParts, Renaming, parse, render};
use std::cell::RefCell;
use std::collections::HashSet;
use stickler_mdtest::{Block, Difference, Reported, differences, same};
use stickler_types::{Dialect, DialectName, join};

#[test]
fn the_syntax_is_as_the_files_say() {
    // The program of the last block of that kind, with its dialect.
    let above = RefCell::new((String::new(), DialectName::IRONPLC_ED2));
    stickler_mdtest::check(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/syntax"), |block| {
        let dialect = dialects(block)[0];
        let of = Dialect::of(dialect);
        match block.kind() {
            "st" => {
                above.replace((block.text.clone(), dialect));
                programs(block)
            }
            "rendered" => of_the_program_above(block, &above.borrow(), rendered),
            "declared" => of_the_program_above(block, &above.borrow(), declarations),
            "used" => of_the_program_above(block, &above.borrow(), uses),
            "leaves" => of_the_program_above(block, &above.borrow(), leaves),
            "equal" | "different" => trees(block),
            "kinds" => block.rows(|text, kinds| same(self::kinds(text, of), kinds.to_owned())),
            "tokens" => block.rows(|text, tokens| same(self::tokens(text, of), tokens.to_owned())),
            "lexed" => block.rows(|text, diagnostics| same(lexed(text, of), diagnostics.to_owned())),
            "grouping" => block.rows(|expression, groups| same(grouped(expression), groups.to_owned())),
            "tree" => block.rows(|text, parts| tree(&block.framed(text), of, parts)),
            "features" => block.rows(|text, keys| same(features(&block.framed(text), of), keys.to_owned())),
            "feature-uses" => block.rows(|text, uses| same(feature_uses(text, of), uses.to_owned())),
            "separable" => block.rows(|text, names| same(separate(text, of), names.to_owned())),
            "parts" => block.rows(|text, reason| {
                let parts = ProgramParts::of(text, of).map(|parts| parts.statements);
                same(
                    parts.unwrap_or_else(|reason| format!("{reason:?}")),
                    reason.to_owned(),
                )
            }),
            "enormous" => block.rows(|text, found| enormous(&block.framed(text), found)),
            "renamed" => block.rows(|text, result| same(renamed(text, of), result.to_owned())),
            _ => vec![Difference::new(1, "no test reads such a block")],
        }
    });
}

fn dialects(block: &Block) -> Vec<DialectName> {
    let named: Vec<_> = block
        .options()
        .map(|word| word.parse().expect("a dialect"))
        .collect();
    match named.is_empty() {
        true => vec![DialectName::IRONPLC_ED2],
        false => named,
    }
}

fn programs(block: &Block) -> Vec<Difference> {
    let mut found = Vec::new();
    for one in block.programs() {
        let marks = match one.marks() {
            Ok(marks) => marks.diagnostics,
            Err(wrong) => return vec![wrong],
        };
        for dialect in dialects(block) {
            let (_, diagnostics) = parse(&one.text, Dialect::of(dialect));
            let lines = LineIndex::new(&one.text);
            let reported: Vec<_> = diagnostics
                .iter()
                .map(|said| reported(said, &one.text, &lines))
                .collect();
            found.extend(
                differences(&marks, &reported)
                    .into_iter()
                    .map(|other| one.place(other)),
            );
        }
    }
    found
}

/// Returns a diagnostic as marks describe it; one that points between two characters points at a column.
fn reported(diagnostic: &SpannedDiagnostic, text: &str, lines: &LineIndex) -> Reported {
    let position = lines.position(text, diagnostic.span.start);
    let at = match diagnostic.span.text(text) {
        "" => format!("column {}", position.column),
        at => at.to_owned(),
    };
    Reported {
        line: position.line,
        severity: diagnostic.code.severity().as_str(),
        code: diagnostic.code.as_str().to_owned(),
        at,
        message: diagnostic.message.clone(),
        suggestion: diagnostic.suggestion.clone(),
    }
}

/// Compares the lines of a block with what is made of the program above it.
fn of_the_program_above(
    block: &Block,
    (text, dialect): &(String, DialectName),
    made: fn(&str, &Dialect) -> String,
) -> Vec<Difference> {
    let made = made(text, Dialect::of(*dialect));
    let result = same(made.trim_end(), block.text.trim_end());
    result
        .err()
        .map(|what| Difference::new(1, what))
        .into_iter()
        .collect()
}

/// The rendered text, which renders to itself.
fn rendered(text: &str, dialect: &Dialect) -> String {
    let once = render(&parse(text, dialect).0, text);
    let (again, diagnostics) = parse(&once, dialect);
    assert_eq!((render(&again, &once), diagnostics), (once.clone(), vec![]));
    once
}

fn declarations(text: &str, dialect: &Dialect) -> String {
    let unit = parse(text, dialect).0;
    let described = declared(&unit).into_iter().map(|one| {
        let inside = one
            .inside
            .map_or(String::new(), |pou| format!(" of {}", pou.name.text));
        format!("{} {:?}{inside}\n", one.name.text, one.kind)
    });
    described.collect()
}

fn uses(text: &str, dialect: &Dialect) -> String {
    let unit = parse(text, dialect).0;
    used(&unit)
        .into_iter()
        .map(|one| format!("{} {:?}\n", one.name.text, one.kind))
        .collect()
}

/// Compares the tree of each line with those of the lines before it.
fn trees(block: &Block) -> Vec<Difference> {
    let dialect = Dialect::of(DialectName::IRONPLC_ED3);
    let texts: Vec<_> = block
        .lines()
        .map(|(line, text)| (line, block.framed(text)))
        .collect();
    let trees: Vec<_> = texts
        .iter()
        .map(|(line, text)| (line, parse(text, dialect)))
        .collect();
    let mut found = Vec::new();
    for (index, (line, (tree, diagnostics))) in trees.iter().enumerate() {
        let mut before = trees[..index].iter().map(|(_, (other, _))| other == tree);
        let is_met = match block.kind() {
            "equal" => before.all(|is_equal| is_equal),
            _ => !before.any(|is_equal| is_equal),
        };
        if !is_met || !diagnostics.is_empty() {
            found.push(Difference::new(
                **line,
                format!("not {}, or wrong: {diagnostics:?}", block.kind()),
            ));
        }
    }
    found
}

/// The expressions that are no operators, with their places.
struct Leaves<'s> {
    text: &'s str,
    found: String,
}

impl<'t, 's: 't> Visitor<'t, 's> for Leaves<'s> {
    fn expression(&mut self, part: Part<'t, 's>, at: &Context<'t, 's>) {
        if operands(part.expression).is_empty() {
            let depth = at.around.len() + usize::from(part.around.is_some());
            let text = part.expression.span.text(self.text);
            self.found += &format!("{text} {:?} {depth}\n", part.place);
        }
    }
}

fn leaves(text: &str, dialect: &Dialect) -> String {
    let unit = parse(text, dialect).0;
    let found = String::new();
    let mut leaves = Leaves { text, found };
    walk(&unit, &mut leaves);
    leaves.found
}

fn kinds(text: &str, dialect: &Dialect) -> String {
    let tokens = lex(text, dialect).tokens;
    let kinds = tokens.iter().map(|token| format!("{:?}", token.kind));
    join(kinds.take(tokens.len() - 1), " ")
}

fn tokens(text: &str, dialect: &Dialect) -> String {
    let tokens = lex(text, dialect).tokens;
    let tokens = tokens.iter().filter(|token| token.kind != TokenKind::End);
    join(tokens.map(|token| token.span.text(text)), " ")
}

fn lexed(text: &str, dialect: &Dialect) -> String {
    let list = lex(text, dialect).diagnostics.into_list();
    let described = list
        .iter()
        .map(|one| format!("{} {}", one.code, one.span.text(text)));
    let described = join(described, ", ");
    if described.is_empty() {
        "-".to_owned()
    } else {
        described
    }
}

/// Looks for parts in what the tree of a text prints of itself, whatever is wrong with the text.
fn tree(text: &str, dialect: &Dialect, parts: &str) -> Result<(), String> {
    let printed = format!("{:?}", parse(text, dialect).0);
    parts.split(" & ").try_for_each(|part| {
        let (part, count) = part.split_once(" ×").unwrap_or((part, ""));
        let found = printed.matches(part).count();
        let is_met = if count.is_empty() {
            found > 0
        } else {
            found.to_string() == count
        };
        if is_met {
            Ok(())
        } else {
            Err(format!("`{part}` is found {found} times in {printed}"))
        }
    })
}

fn enormous(text: &str, found: &str) -> Result<(), String> {
    let (_, diagnostics) = parse(text, Dialect::of(DialectName::IRONPLC_ED2));
    if diagnostics.is_empty() {
        // Neither the renderer nor the walk recurses along a chain.
        let dialect = Dialect::of(DialectName::IRONPLC_ED2);
        assert!(!rendered(text, dialect).is_empty() && !leaves(text, dialect).is_empty());
    }
    let lines = LineIndex::new(text);
    match &diagnostics[..] {
        [only] if found.contains(':') => {
            let at = lines.position(text, only.span.start);
            same(
                format!("{}:{} {}", at.line, at.column, only.code),
                found.to_owned(),
            )
        }
        several => same(several.len().to_string(), found.to_owned()),
    }
}

fn features(text: &str, dialect: &Dialect) -> String {
    let found = crate::features::features(text, dialect);
    let found: Vec<_> = found.into_iter().map(String::from).collect();
    if found.is_empty() {
        "-".to_owned()
    } else {
        found.join(" ")
    }
}

fn feature_uses(text: &str, dialect: &Dialect) -> String {
    let uses = crate::features::feature_uses(text, dialect);
    let described = uses
        .iter()
        .map(|one| format!("{} {}", one.key, one.span.text(text)));
    join(described, "; ")
}

fn separate(text: &str, dialect: &Dialect) -> String {
    let Some(names) = separable(text, dialect, false) else {
        return "-".to_owned();
    };
    let mut names: Vec<_> = names.into_iter().collect();
    names.sort();
    names.join(" ")
}

/// Renames the units F, COLOR, RED and REC, and the variables X, Y, R, S1 and WORD.
fn renamed(text: &str, dialect: &Dialect) -> String {
    let set = |names: &[&str]| names.iter().map(ToString::to_string).collect::<HashSet<_>>();
    let (units, variables) = (
        set(&["F", "COLOR", "RED", "REC"]),
        set(&["X", "Y", "R", "S1", "WORD"]),
    );
    let renaming = Renaming {
        dialect,
        units: (&units, "_u1".to_owned()),
        variables: Some((&variables, "_7".to_owned())),
    };
    renaming.of(text)
}

fn grouped(expression: &str) -> String {
    let text = format!("PROGRAM p x := {expression}; END_PROGRAM");
    let (unit, diagnostics) = parse(&text, Dialect::of(DialectName::IRONPLC_ED2));
    assert_eq!(diagnostics, [], "{text}");
    match &unit.declarations[0] {
        Declaration::Pou(pou) => match pou.body[0].kind {
            StatementKind::Assignment { value, .. } => group(&unit.expressions, value),
            _ => panic!("{unit:?}"),
        },
        _ => panic!("{unit:?}"),
    }
}

fn group(all: &[Expression], id: ExpressionId) -> String {
    match &all[id.0 as usize].kind {
        ExpressionKind::Name(name) => name.text.to_owned(),
        ExpressionKind::Literal(literal) => {
            let prefix = literal
                .prefix()
                .map_or(String::new(), |prefix| format!("{}#", prefix.text));
            format!("{prefix}{:?}:{}", literal.kind, literal.text()).replace("Integer:2", "2")
        }
        ExpressionKind::EnumeratedValue(word) => format!("{}#{}", word.prefix().text, word.value().text),
        ExpressionKind::Parenthesized(inner) => format!("[{}]", group(all, *inner)),
        ExpressionKind::Unary { operator, operand } => {
            let blank = if *operator == UnaryOperator::Not { " " } else { "" };
            format!("({operator}{blank}{})", group(all, *operand))
        }
        ExpressionKind::Binary {
            operator,
            left,
            right,
        } => {
            format!(
                "({} {} {})",
                group(all, *left),
                operator.as_str(),
                group(all, *right)
            )
        }
        other => format!("{other:?}"),
    }
}
