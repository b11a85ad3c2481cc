//! Finds program organization units that call themselves, which the standard forbids and the machine, with one
//! frame for each function, could not run.
//!
//! Basis: ironplc-problem-codes: P4005; iec-61131-3: 6.6.1 (no recursion).

use super::cycles::{WalkEvent, walk};
use super::lowering::Lowering;
use stickler_types::Code;

impl Lowering<'_> {
    /// Says so once for each cycle of calls, at the call that closes it.
    pub(super) fn report_recursion(&mut self) {
        let model = self.model;
        let mut calls = vec![Vec::new(); model.pous.len()];
        for &(caller, callee, span) in &self.calls {
            calls[caller as usize].push((callee as usize, span));
        }
        let mut cycles = Vec::new();
        walk(
            calls.len(),
            |pou| std::mem::take(&mut calls[pou]),
            |event| {
                if let WalkEvent::Cycle { note, members } = event {
                    cycles.push((note, members));
                }
            },
        );
        for (span, members) in cycles {
            let mut names: Vec<_> = members.iter().map(|&pou| model.pous[pou].pou.name.text).collect();
            names.push(names[0]);
            let message = format!(
                "no function or function block may call itself: {}",
                names.join(" calls ")
            );
            self.report(Code::RecursiveCycle, span, message);
        }
    }
}
