//! Where an id is among others.

/// About so many ids share an entry of the table.
const SHARED: usize = 4;

/// Ids in ascending order, each once.
///
/// A table by the leading digits of ids leads to a few of them, so an id is found in a time that
/// does not grow with their number if they are spread evenly, as the numbers of points in a tile
/// are, and in one that grows with its logarithm whatever they are.
///
/// ```
/// use curvecrust_tiles::Ids;
///
/// let ids = Ids::new(vec![70, 40, 10, 40]);
/// assert_eq!(ids.as_slice(), [10, 40, 70]);
/// assert_eq!((ids.position(70), ids.position(50)), (Some(2), None));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Ids {
    ids: Vec<u64>,
    /// What is shifted out of the difference of an id and the first one.
    shift: u32,
    /// Where the ids of each entry start; behind the last entry their number.
    starts: Vec<usize>,
}

impl Ids {
    /// Sorts ids.
    #[must_use]
    pub fn new(mut ids: Vec<u64>) -> Self {
        ids.sort_unstable();
        ids.dedup();
        let (Some(&first), Some(&last)) = (ids.first(), ids.last()) else {
            return Self::default();
        };
        let entries = (ids.len() / SHARED).max(1) as u64;
        let mut shift = 0;
        while (last - first) >> shift >= 2 * entries {
            shift += 1;
        }
        let mut starts = vec![0];
        for (at, id) in ids.iter().enumerate() {
            let entry = entry(*id, first, shift);
            while starts.len() <= entry {
                starts.push(at);
            }
        }
        starts.push(ids.len());
        Self { ids, shift, starts }
    }

    /// The ids, ascending.
    #[must_use]
    pub fn as_slice(&self) -> &[u64] {
        &self.ids
    }

    /// The position of an id; `None` if it is none of them.
    #[must_use]
    pub fn position(&self, id: u64) -> Option<usize> {
        let first = self.ids.first().filter(|&&first| first <= id)?;
        let entry = entry(id, *first, self.shift);
        let (&start, &end) = (self.starts.get(entry)?, self.starts.get(entry + 1)?);
        let found = self.ids[start..end].binary_search(&id).ok()?;
        Some(start + found)
    }
}

/// The entry of an id that is not below the first one; ids that are too far above have a large one.
fn entry(id: u64, first: u64, shift: u32) -> usize {
    usize::try_from((id - first) >> shift).unwrap_or(usize::MAX - 1)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn positions_are_those_of_a_search(
            ids in prop::collection::vec(prop_oneof![0..50u64, any::<u64>()], 0..40),
            others in prop::collection::vec(prop_oneof![0..50u64, any::<u64>()], 0..40),
        ) {
            let found = Ids::new(ids.clone());
            for id in ids.into_iter().chain(others).chain([0, u64::MAX]) {
                prop_assert_eq!(found.position(id), found.as_slice().binary_search(&id).ok());
            }
        }
    }
}
