//! The edges that stay.

/// No partner.
pub(super) const NONE: u32 = u32::MAX;

/// At most two certified edges at each point, at most one at a terminus.
pub(super) struct Certificates<'a> {
    partners: Vec<[u32; 2]>,
    is_terminus: &'a [bool],
}

impl<'a> Certificates<'a> {
    pub(super) fn new(is_terminus: &'a [bool], edges: impl Iterator<Item = [u32; 2]>) -> Self {
        let mut partners = vec![[NONE; 2]; is_terminus.len()];
        for [v, w] in edges {
            add_partners(&mut partners, v, w);
        }
        Self {
            partners,
            is_terminus,
        }
    }

    /// The number of points.
    pub(super) fn len(&self) -> usize {
        self.partners.len()
    }

    /// Those that certified edges join to the point.
    pub(super) fn of(&self, v: u32) -> impl Iterator<Item = u32> + use<> {
        let partners = self.partners[v as usize].into_iter();
        partners.filter(|&w| w != NONE)
    }

    pub(super) fn contain(&self, v: u32, w: u32) -> bool {
        self.partners[v as usize].contains(&w)
    }

    /// Whether the point is a terminus.
    pub(super) fn end_at(&self, v: u32) -> bool {
        self.is_terminus[v as usize]
    }

    /// Whether the point has as many certified edges as it may have edges.
    pub(super) fn saturate(&self, v: u32) -> bool {
        self.of(v).count() + usize::from(self.end_at(v)) == 2
    }

    /// Each edge once.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let points = (0u32..).zip(&self.partners);
        let both_ways = points.flat_map(|(v, partners)| partners.map(|w| [v, w]));
        both_ways.filter(|&[v, w]| w != NONE && v < w)
    }
}

/// Makes two points partners of each other.
pub(super) fn add_partners(partners: &mut [[u32; 2]], v: u32, w: u32) {
    for (from, to) in [(v, w), (w, v)] {
        if let Some(slot) = partners[from as usize].iter_mut().find(|p| **p == NONE) {
            *slot = to;
        }
    }
}
