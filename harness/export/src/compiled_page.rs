//! Writes a page that is only compiled: the programs of many cases that must or may be rejected, one after the other.
//!
//! A compiler answers with a list of messages, each of which belongs to the case on whose lines it is. A case without a message
//! was accepted, if the list is complete: so the first statement of the page and its last are wrong on purpose, and a list that
//! lacks either shows nothing about any case.

use crate::page::{PageText, shown};
use crate::page_case::PageKind;
use stickler_types::counted;

/// The statement at the beginning and the end of a page. Its types are wrong, as in most cases: compilers check types last, and
/// some that stop before that check would report an undeclared name.
const WRONG: &str = "    stickler_wrong := T#1s;\n";

impl PageText<'_, '_> {
    /// Writes the declarations and the statements.
    pub(crate) fn write_compiled(&mut self, pages: usize, export: &str) {
        (self.steps, self.elements) = (Vec::new(), 0);
        let suffixes = vec![String::new(); self.cases.len()];
        let number = self.number;
        let must = match self.kind {
            PageKind::Asked => "that may be rejected",
            _ => "that must be rejected",
        };
        let mut text = format!(
            "(* Stickler: page {number} of {pages}, {} {must}. {export}\n   \
             Only compile it, copy all messages into a file, and give that to `stickler import`.\n   \
             The first statement and the last are wrong on purpose: without their messages the list is not whole. *)\n\
             PROGRAM stickler_page_{number}\nVAR\n    stickler_wrong : BOOL;\nEND_VAR\n",
            counted(self.cases.len() as u64, "case", "cases"),
        );
        self.write_variables(&mut text, &suffixes);
        let before = text.matches('\n').count();
        self.declarations = text;
        let mut text = WRONG.to_owned();
        for (case, ready) in self.cases.iter().enumerate().filter(|(_, ready)| !ready.answered) {
            let first = before + text.matches('\n').count() + 1;
            text.push_str(&format!("    (* {}: {} *)\n", case + 1, shown(&ready.case.id)));
            let statements = self.renaming(case, &suffixes).of(&ready.parts.statements);
            if !statements.is_empty() {
                text.push_str(&format!("    {statements}\n"));
            }
            self.lines[case].push((first, before + text.matches('\n').count()));
        }
        text.push_str(WRONG);
        let last = before + text.matches('\n').count();
        self.lines.push(vec![(before + 1, before + 1)]);
        self.lines.push(vec![(last, last)]);
        self.statements = text;
    }
}
