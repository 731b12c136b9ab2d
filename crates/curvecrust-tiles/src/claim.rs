//! Choices that one tile cannot judge by itself.

use curvecrust_reconstruct::neighbours::Keep;

/// A sample chose another one, of which its tile does not know the choices.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Claim {
    /// The sample that chose.
    pub from: u64,
    /// The sample that it chose.
    pub to: u64,
}

impl Claim {
    /// Both samples, ascending.
    #[must_use]
    pub fn ends(self) -> [u64; 2] {
        [self.from.min(self.to), self.from.max(self.to)]
    }
}

/// The edges of claims, ascending, each once.
///
/// All claims between two samples have to be among those given. Where there are too many for one
/// machine, they can be split by their smaller end.
///
/// ```
/// use curvecrust_reconstruct::neighbours::Keep;
/// use curvecrust_tiles::{Claim, joined};
///
/// let claims = [(7, 3), (3, 5), (3, 7)].map(|(from, to)| Claim { from, to });
/// assert_eq!(joined(claims.to_vec(), Keep::Mutual), [[3, 7]]);
/// assert_eq!(joined(claims.to_vec(), Keep::Union), [[3, 5], [3, 7]]);
/// ```
#[must_use]
pub fn joined(mut claims: Vec<Claim>, keep: Keep) -> Vec<[u64; 2]> {
    claims.sort_unstable_by_key(|claim| (claim.ends(), claim.from));
    claims.dedup();
    let pairs = claims.chunk_by(|a, b| a.ends() == b.ends());
    let kept = pairs.filter(|pair| keep == Keep::Union || pair.len() == 2);
    kept.map(|pair| pair[0].ends()).collect()
}
