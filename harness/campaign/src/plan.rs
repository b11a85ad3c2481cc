//! The plan of a campaign: how long it goes on, on how many threads, and which places are its own.

use std::time::Duration;
use stickler_workers::Shard;

/// The plan of a campaign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct CampaignPlan {
    /// The first place.
    pub first: u64,
    /// The end of the campaign.
    pub until: Until,
    /// The part of the places that are judged here.
    pub shard: Shard,
    /// The number of workers; 0 stands for one a processor.
    pub jobs: usize,
    /// The number of places that a worker is given at a time.
    pub batch: usize,
}

/// The end of a campaign.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Until {
    /// After so many places of the row, of which a part judges its share. All that is found depends on the seed alone.
    Count(u64),
    /// After so long a time. What is found depends on how quick the machine is.
    Time(Duration),
}

impl CampaignPlan {
    /// Returns the places of this part in order, in batches of [`CampaignPlan::batch`].
    pub(crate) fn batches(self) -> impl Iterator<Item = Vec<u64>> {
        let end = match self.until {
            Until::Count(count) => self.first.saturating_add(count),
            Until::Time(_) => u64::MAX,
        };
        let step = u64::from(self.shard.count());
        let mut next = self.shard.first_place(self.first);
        std::iter::from_fn(move || {
            let mut batch = Vec::with_capacity(self.batch);
            while batch.len() < self.batch.max(1)
                && let Some(place) = next.filter(|place| *place < end)
            {
                batch.push(place);
                next = place.checked_add(step);
            }
            (!batch.is_empty()).then_some(batch)
        })
    }

    /// Returns the number of places of this part, where that is known.
    pub fn share(self) -> Option<u64> {
        let Until::Count(count) = self.until else {
            return None;
        };
        let first = self.shard.first_place(self.first)?;
        let end = self.first.saturating_add(count);
        Some(end.saturating_sub(first).div_ceil(u64::from(self.shard.count())))
    }
}

/// Returns whether the `number`-th disagreement (from 1) of one subject and symptom is reduced.
///
/// The first sixteen are, and eight of each further doubling: a defect that every tenth program meets must not keep a
/// campaign from going on, and yet a rarer one with the same symptom gets its turn.
pub(crate) const fn is_reduced(number: u64) -> bool {
    if number <= 16 {
        return number > 0;
    }
    let step = 1_u64 << (number.ilog2() - 3);
    number.is_multiple_of(step)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(plan: CampaignPlan) -> Vec<u64> {
        plan.batches().flatten().collect()
    }

    fn plan(shard: Shard, count: u64) -> CampaignPlan {
        CampaignPlan {
            first: 3,
            until: Until::Count(count),
            shard,
            jobs: 1,
            batch: 4,
        }
    }

    #[test]
    fn the_parts_together_have_every_place_once() {
        let mut all = Vec::new();
        for index in 1..=3 {
            let plan = plan(Shard::new(index, 3).unwrap(), 20);
            let own = places(plan);
            assert_eq!(Some(own.len() as u64), plan.share());
            all.extend(own);
        }
        all.sort_unstable();
        assert_eq!(all, places(plan(Shard::WHOLE, 20)));
        assert_eq!(all, (3..23).collect::<Vec<u64>>());
    }

    #[test]
    fn a_batch_is_never_empty() {
        assert_eq!(plan(Shard::WHOLE, 0).batches().count(), 0);
        let sizes: Vec<usize> = plan(Shard::WHOLE, 9).batches().map(|batch| batch.len()).collect();
        assert_eq!(sizes, [4, 4, 1]);
    }

    #[test]
    fn every_doubling_has_its_share_of_reductions() {
        let of = |range: std::ops::Range<u64>| range.filter(|&number| is_reduced(number)).count();
        assert_eq!(of(0..17), 16);
        assert_eq!(of(17..33), 8);
        assert_eq!(of(1025..2049), 8);
        assert!(of(0..1_000_000) < 150);
    }
}
