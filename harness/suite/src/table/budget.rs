//! Limits on the expansion of one file: a table of a few lines can stand for more cases than a machine can hold.

/// The remaining budget of a file that is being expanded.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Budget {
    /// The number of cells or rows that may still be visited.
    pub(crate) visits: u64,
    /// The number of bytes of programs that may still be written.
    pub(crate) bytes: u64,
}

impl Default for Budget {
    fn default() -> Self {
        Budget {
            visits: 20_000_000,
            bytes: 512 << 20,
        }
    }
}

impl Budget {
    /// Counts the visit of one cell or row by one probe.
    ///
    /// # Errors
    /// A message, if the limit is exceeded.
    pub(crate) fn visit(&mut self) -> Result<(), String> {
        take(&mut self.visits, 1).ok_or_else(|| "the table expands into too many cells".to_owned())
    }

    /// Counts a program of `bytes` bytes and the case around it.
    ///
    /// # Errors
    /// A message, if the limit is exceeded.
    pub(crate) fn program(&mut self, bytes: usize) -> Result<(), String> {
        let cost = u64::try_from(bytes).unwrap_or(u64::MAX).saturating_add(400);
        take(&mut self.bytes, cost)
            .ok_or_else(|| "the table expands into more than 512 MiB of programs".to_owned())
    }
}

fn take(left: &mut u64, cost: u64) -> Option<()> {
    *left = left.checked_sub(cost)?;
    Some(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_budget_comes_to_an_end() {
        let mut budget = Budget {
            visits: 1,
            bytes: 1000,
        };
        assert_eq!(budget.visit(), Ok(()));
        assert!(budget.visit().is_err());
        assert_eq!(budget.program(600), Ok(()));
        assert!(budget.program(0).is_err());
    }
}
