//! Bytes made fewer and simpler, for targets whose input is no program of the model.
//!
//! A value that is made from bytes takes its first, simplest choice where a byte is 0 and where bytes have run out; so fewer
//! bytes and more zeros make for smaller values.

use stickler_reduce::{Interestingness, Pass, Reduction, ReductionBudget, ReductionMethod, Sites, minimise};

const METHOD: ReductionMethod<'_, Vec<u8>> = ReductionMethod {
    passes: &[
        Pass {
            name: "drop bytes",
            edit: |bytes, sites| bytes.retain(|_| !sites.here()),
        },
        Pass {
            name: "zero bytes",
            edit: |bytes, sites| change(bytes, sites, 1, |_| 0),
        },
        Pass {
            name: "halve bytes",
            edit: |bytes, sites| change(bytes, sites, 2, |byte| byte / 2),
        },
        Pass {
            name: "make bytes one less",
            edit: |bytes, sites| change(bytes, sites, 1, |byte| byte - 1),
        },
    ],
    weight: |bytes| {
        (
            bytes.len() as u64,
            bytes.iter().map(|&byte| u128::from(byte)).sum(),
        )
    },
};

/// Makes bytes as few and as small as they can be while they stay interesting.
pub(crate) fn bytes(
    start: Vec<u8>,
    mut interesting: impl FnMut(&[u8]) -> bool,
    budget: &ReductionBudget<'_>,
) -> Reduction<Vec<u8>> {
    minimise(
        start,
        &METHOD,
        &mut |bytes: &Vec<u8>| Interestingness::from(interesting(bytes)),
        budget,
    )
}

/// Changes bytes that are at least so large.
fn change(bytes: &mut [u8], sites: &mut Sites, least: u8, how: fn(u8) -> u8) {
    for byte in bytes.iter_mut().filter(|byte| **byte >= least) {
        if sites.here() {
            *byte = how(*byte);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_matters_remains_and_all_else_goes() {
        let start: Vec<u8> = (0..=255).collect();
        let found = bytes(
            start,
            |bytes| bytes.contains(&200) && bytes.iter().any(|&byte| byte > 7),
            &ReductionBudget::default(),
        );
        assert_eq!(found.value, [200]);
    }
}
