//! The variant that exchanges the two sides of an IF.

use super::loops::not;
use super::walk::{each_pou, lists};
use crate::model::{Program, Statement};
use crate::random::Random;
use std::mem;

/// Negates the condition of some IFs without ELSIF, and exchanges their THEN and ELSE branches. Returns the number of
/// changes.
pub(super) fn swap(program: &mut Program, random: &mut Random<'_, '_>) -> usize {
    let mut count = 0;
    each_pou(program, |pou| {
        lists(&mut pou.body, &mut |list| {
            for statement in list {
                let Statement::If(branches, otherwise) = statement else {
                    continue;
                };
                if let [(condition, then)] = &mut branches[..]
                    && !random.chance(1, 4)
                {
                    *condition = not(condition);
                    let positive = mem::replace(then, otherwise.take().unwrap_or_default());
                    *otherwise = Some(positive);
                    count += 1;
                }
            }
        });
    });
    count
}
