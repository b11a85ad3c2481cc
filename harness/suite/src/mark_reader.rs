//! Reads marks: from the text of a comment to a [`Mark`].
//!
//! Basis: conformance-cases/README.md (marks).

use stickler_types::{Code, DialectName};

use crate::condition::{Condition, Testable};
use crate::dialects::Dialects;
use crate::error::Mistake;
use crate::mark::{Known, Mark, MarkClaim, MarkWord, ValueLine};
use crate::scan::RawMark;
use crate::template::Template;
use crate::timing::scan_number;

/// The words with which marks begin.
pub(crate) const MARKS: [&str; 11] = [
    "error", "warning", "ok", "fault", "values", "rendered", "observe", "set", "clock", "scan", "scans",
];

/// Reader of the marks of one kind of file.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MarkReader<'a> {
    pub(crate) dialects: &'a Dialects,
    /// The placeholders that conditions may test; none in a program that is not a template.
    pub(crate) testable: Testable<'a>,
    /// Whether braces stand for placeholders.
    pub(crate) is_template: bool,
}

impl MarkReader<'_> {
    /// Reads a text that may hold placeholders.
    pub(crate) fn template(&self, text: &str) -> Result<Template, String> {
        match self.is_template {
            true => Template::parse(text, self.testable.names).map_err(|mistake| mistake.message),
            false => Ok(Template::plain(text)),
        }
    }

    /// Reads a mark. Mistakes have the lines of the template.
    pub(crate) fn read(&self, raw: &RawMark<'_>) -> Result<Mark, Mistake> {
        if let Some(at) = raw.text.find("(*") {
            let line = raw.line + newlines(&raw.text[..at]);
            let message = "a mark cannot contain `(*`, because in some dialects comments nest; write `($2A`";
            return Err(Mistake::new(line, message));
        }
        let leading = raw.text.len() - raw.text.trim_start().len();
        let line = raw.line + newlines(&raw.text[..leading]);
        let text = raw.text.trim();
        let (head, block) = text.split_once('\n').unwrap_or((text, ""));
        let here = |message: String| Mistake::new(line, message);
        let mut words = head.split_whitespace();
        let word = words.next().unwrap_or_default();
        let rest = head[word.len()..].trim();
        let mut clauses = Clauses::default();
        let claim = match word {
            "error" => MarkClaim::Error(self.codes(word, "P4035", rest, &mut clauses).map_err(here)?),
            "warning" => MarkClaim::Warning(self.codes(word, "C0195", rest, &mut clauses).map_err(here)?),
            "ok" => self
                .clauses(rest, &mut clauses)
                .map(|()| MarkClaim::Ok)
                .map_err(here)?,
            "fault" => self.fault(rest, &mut clauses).map_err(here)?,
            "observe" => self.observe(rest, &mut clauses).map_err(here)?,
            "set" => self.set(rest, &mut clauses).map_err(here)?,
            "clock" => self.clock(rest, &mut clauses).map_err(here)?,
            "values" => {
                self.clauses(rest, &mut clauses).map_err(here)?;
                MarkClaim::Values {
                    after: clauses.after.take(),
                    values: self.values(block, line + 1)?,
                }
            }
            "rendered" => {
                self.clauses(rest, &mut clauses).map_err(here)?;
                MarkClaim::Rendered(self.template(block).map_err(here)?)
            }
            "scan" => self.one_scan(rest, &mut clauses).map_err(here)?,
            "scans" => {
                self.clauses(rest, &mut clauses).map_err(here)?;
                let (text, is_table) = (self.template(block).map_err(here)?, true);
                MarkClaim::Scans { text, is_table }
            }
            _ => return Err(here(unknown_mark(word))),
        };
        let is_block = matches!(
            claim,
            MarkClaim::Values { .. } | MarkClaim::Rendered(_) | MarkClaim::Scans { is_table: true, .. }
        );
        if !is_block && !block.trim().is_empty() {
            return Err(here(format!("`{word}` stands on one line")));
        }
        if clauses.after.is_some() {
            return Err(here(format!("`after` has no meaning in `{word}`")));
        }
        Ok(Mark {
            line: raw.line,
            offset: raw.start,
            condition: clauses.condition,
            dialects: clauses.dialects,
            claim,
        })
    }

    /// Reads the codes behind `error` or `warning`; `example` is a code for the message where there are none.
    fn codes(
        &self,
        word: &str,
        example: &str,
        rest: &str,
        clauses: &mut Clauses,
    ) -> Result<Vec<Known<Code>>, String> {
        let (codes, rest) = split_clauses(rest);
        let codes: Vec<Known<Code>> = codes
            .split_whitespace()
            .map(|code| self.known(code))
            .collect::<Result<_, _>>()?;
        if codes.is_empty() {
            return Err(format!("`{word}` needs a code: `{word} {example}`"));
        }
        self.clauses(rest, clauses)?;
        Ok(codes)
    }

    fn fault(&self, rest: &str, clauses: &mut Clauses) -> Result<MarkClaim, String> {
        let (fault, rest) = split_clauses(rest);
        let fault = self.known(fault)?;
        self.clauses(rest, clauses)?;
        Ok(MarkClaim::Fault(fault))
    }

    fn observe(&self, rest: &str, clauses: &mut Clauses) -> Result<MarkClaim, String> {
        if let Some(rest) = rest
            .strip_prefix("acceptance")
            .filter(|rest| !rest.trim_start().starts_with(':'))
        {
            self.clauses(rest, clauses)?;
            return Ok(MarkClaim::ObserveAcceptance);
        }
        let Some((name, rest)) = rest.split_once(':') else {
            return Err("write `observe name : TYPE` or `observe acceptance`".to_owned());
        };
        let (ty, rest) = split_clauses(rest.trim());
        if name.trim().is_empty() || ty.is_empty() || ty.contains(char::is_whitespace) {
            return Err("write `observe name : TYPE`, with the type's name alone".to_owned());
        }
        self.clauses(rest, clauses)?;
        let after = clauses.after.take();
        Ok(MarkClaim::Observe {
            name: self.template(name.trim())?,
            ty: self.template(ty)?,
            after,
        })
    }

    fn set(&self, rest: &str, clauses: &mut Clauses) -> Result<MarkClaim, String> {
        let usage = || "write `set name = LITERAL before N`".to_owned();
        let (assignment, rest) = rest.rsplit_once(" before ").ok_or_else(usage)?;
        let (name, value) = assignment.split_once('=').ok_or_else(usage)?;
        let before = self.scan(rest, clauses)?;
        Ok(MarkClaim::Set {
            name: self.template(name.trim())?,
            value: self.known(value.trim())?,
            before,
        })
    }

    fn clock(&self, rest: &str, clauses: &mut Clauses) -> Result<MarkClaim, String> {
        let usage = || "write `clock LITERAL before N`".to_owned();
        let (value, rest) = rest.rsplit_once(" before ").ok_or_else(usage)?;
        let before = self.scan(rest, clauses)?;
        Ok(MarkClaim::Clock {
            value: self.known(value.trim())?,
            before,
        })
    }

    fn one_scan(&self, rest: &str, clauses: &mut Clauses) -> Result<MarkClaim, String> {
        let (text, rest) = split_clauses(rest);
        self.clauses(rest, clauses)?;
        let (text, is_table) = (self.template(text)?, false);
        Ok(MarkClaim::Scans { text, is_table })
    }

    /// Reads the number of a scan, and the clauses that follow it.
    fn scan(&self, rest: &str, clauses: &mut Clauses) -> Result<u32, String> {
        let (number, rest) = split_clauses(rest.trim());
        self.clauses(rest, clauses)?;
        scan_number(number)
    }

    fn values(&self, block: &str, first_line: u32) -> Result<Vec<ValueLine>, Mistake> {
        let mut values = Vec::new();
        for (line, text) in (first_line..).zip(block.lines()) {
            let text = text.trim();
            if text.is_empty() {
                continue;
            }
            let value = self
                .value_line(text, line)
                .map_err(|message| Mistake::new(line, message))?;
            values.push(value);
        }
        if values.is_empty() {
            let message = "`values` needs lines `path = literal` below it";
            return Err(Mistake::new(first_line - 1, message));
        }
        Ok(values)
    }

    fn value_line(&self, text: &str, line: u32) -> Result<ValueLine, String> {
        let (name, value) = text.split_once('=').ok_or("write `path = literal`")?;
        let name = name.trim();
        if name.is_empty() {
            return Err("write `path = literal`".to_owned());
        }
        Ok(ValueLine {
            name: self.template(name)?,
            value: self.known(value.trim())?,
            line,
        })
    }

    fn known<T: MarkWord>(&self, text: &str) -> Result<Known<T>, String> {
        let template = self.template(text)?;
        match template.fixed() {
            Some(fixed) => T::read(fixed).map(Known::Now),
            None => Ok(Known::Later(template)),
        }
    }

    /// Reads `after 3`, `if …` and `in …`, in any order.
    fn clauses(&self, text: &str, clauses: &mut Clauses) -> Result<(), String> {
        let words: Vec<&str> = text.split_whitespace().collect();
        let mut rest = &words[..];
        while let [keyword, behind @ ..] = rest {
            let length = behind
                .iter()
                .position(|word| is_clause(word))
                .unwrap_or(behind.len());
            let (own, next) = behind.split_at(length);
            match *keyword {
                "if" => clauses.condition.and(Condition::parse(own, self.testable)?),
                "in" => clauses.dialects = Some(self.dialects(own)?),
                "after" => clauses.after = Some(scan_number(&own.join(" "))?),
                word => return Err(format!("`{word}` is not understood here")),
            }
            rest = next;
        }
        Ok(())
    }

    fn dialects(&self, names: &[&str]) -> Result<Vec<DialectName>, String> {
        if names.is_empty() {
            return Err("`in` needs a dialect or a group behind it".to_owned());
        }
        self.dialects.resolve(&names.join(" "))
    }
}

/// The clauses `after`, `if` and `in`, which may follow the words of a mark.
#[derive(Debug, Default)]
struct Clauses {
    condition: Condition,
    dialects: Option<Vec<DialectName>>,
    after: Option<u32>,
}

fn is_clause(word: &str) -> bool {
    matches!(word, "if" | "in" | "after")
}

/// Splits the words of a mark from the clauses that follow them.
fn split_clauses(text: &str) -> (&str, &str) {
    let mut at = 0;
    let mut words = text.split_whitespace().peekable();
    while let Some(word) = words.next() {
        // `word` is a part of `text` at or behind `at`.
        let start = at + text[at..].find(word).unwrap_or(0);
        // A variable may have the name of a clause.
        if is_clause(word) && words.peek() != Some(&"=") {
            return (text[..start].trim_end(), &text[start..]);
        }
        at = start + word.len();
    }
    (text, "")
}

fn newlines(text: &str) -> u32 {
    u32::try_from(text.matches('\n').count()).unwrap_or(u32::MAX)
}

fn unknown_mark(word: &str) -> String {
    let known = MARKS.join(", ");
    match word {
        "" => format!("the mark is empty; there are {known}"),
        _ => format!("no mark `{word}`; there are {known}"),
    }
}
