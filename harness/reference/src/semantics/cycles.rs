//! Cycles in a graph, found without recursion: types that contain themselves, functions that call themselves.

use super::lowering::Lowering;
use stickler_types::Code;

/// The most members of a cycle that are named; a long chain may hold as many long cycles as it has nodes.
const MAX_MEMBERS: usize = 50;

/// Walks a graph depth first, from each node in turn.
///
/// `edges` gives the nodes that a node needs, each with a note of where; `visit` gets each node once all that it needs
/// is done, and each edge that closes a cycle.
pub(super) fn walk<N: Copy>(
    nodes: usize,
    mut edges: impl FnMut(usize) -> Vec<(usize, N)>,
    mut visit: impl FnMut(WalkEvent<N>),
) {
    let mut states = vec![State::New; nodes];
    let mut depths = vec![0; nodes];
    let mut path: Vec<(usize, std::vec::IntoIter<(usize, N)>)> = Vec::new();
    for root in 0..nodes {
        if states[root] != State::New {
            continue;
        }
        states[root] = State::Open;
        path.push((root, edges(root).into_iter()));
        while let Some((node, rest)) = path.last_mut() {
            let node = *node;
            let Some((next, note)) = rest.next() else {
                states[node] = State::Done;
                path.pop();
                visit(WalkEvent::Done(node));
                continue;
            };
            match states[next] {
                State::Done => {}
                State::Open => {
                    let members = path.iter().skip(depths[next]).take(MAX_MEMBERS);
                    visit(WalkEvent::Cycle {
                        note,
                        members: members.map(|&(open, _)| open).collect(),
                    });
                }
                State::New => {
                    states[next] = State::Open;
                    depths[next] = path.len();
                    path.push((next, edges(next).into_iter()));
                }
            }
        }
    }
}

/// An event of a walk.
#[derive(Debug)]
pub(super) enum WalkEvent<N> {
    /// A node, all that it needs having been met before, save what closes a cycle.
    Done(usize),
    /// An edge that closes a cycle.
    Cycle {
        /// The note of the edge.
        note: N,
        /// The nodes of the cycle, from where it begins to where the edge leaves; of a long one the first.
        members: Vec<usize>,
    },
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    Open,
    Done,
}

impl Lowering<'_> {
    /// Reports program organization units that call themselves, which the standard forbids and the machine, with one frame for each
    /// function, could not run: once for each cycle of calls, at the call that closes it.
    ///
    /// Basis: ironplc-problem-codes: P4005; iec-61131-3: 6.6.1 (no recursion).
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

#[cfg(test)]
mod tests {
    use super::{WalkEvent, walk};

    fn events(graph: &[&[usize]]) -> (Vec<usize>, Vec<Vec<usize>>) {
        let (mut order, mut cycles) = (Vec::new(), Vec::new());
        walk(
            graph.len(),
            |node| graph[node].iter().map(|&next| (next, ())).collect(),
            |event| match event {
                WalkEvent::Done(node) => order.push(node),
                WalkEvent::Cycle { members, .. } => cycles.push(members),
            },
        );
        (order, cycles)
    }

    #[test]
    fn what_is_needed_comes_first() {
        assert_eq!(events(&[&[1, 2], &[2], &[]]), (vec![2, 1, 0], vec![]));
    }

    #[test]
    fn each_cycle_is_told_once() {
        assert_eq!(events(&[&[1], &[2], &[1, 0]]).1, [vec![1, 2], vec![0, 1, 2]]);
        assert_eq!(events(&[&[0]]).1, [vec![0]]);
    }

    #[test]
    fn a_long_chain_needs_no_stack() {
        let length = 200_000;
        let mut last = 0;
        walk(
            length,
            |node| {
                if node + 1 < length {
                    vec![(node + 1, ())]
                } else {
                    vec![]
                }
            },
            |event| {
                if let WalkEvent::Done(node) = event {
                    last = node;
                }
            },
        );
        assert_eq!(last, 0);
    }
}
