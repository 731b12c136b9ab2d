//! The plane in rectangles with about equally many samples each.

use curvecrust_geometry::DVec2;

use crate::area::Area;

/// A cut of the plane into cells, by lines parallel to the axes: a k-d tree.
///
/// Every point of the plane lies in exactly one cell; the outer cells have no end.
#[derive(Clone, Debug, PartialEq)]
pub struct Partition {
    nodes: Vec<Node>,
    cells: Vec<Area>,
}

/// A coordinate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// The first one.
    X,
    /// The second one.
    Y,
}

/// A line that cuts a part of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The coordinate that is compared.
    pub axis: Axis,
    /// Points below it lie on one side, the others on the other.
    pub at: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Node {
    Cut {
        cut: Cut,
        /// The node of the other side.
        above: usize,
    },
    Cell(usize),
}

impl Axis {
    fn of(self, point: DVec2) -> f64 {
        match self {
            Self::X => point.x,
            Self::Y => point.y,
        }
    }

    fn of_mut(self, point: &mut DVec2) -> &mut f64 {
        match self {
            Self::X => &mut point.x,
            Self::Y => &mut point.y,
        }
    }
}

impl Partition {
    /// Cells for about equal shares of some points, which stand for all: as many cells as asked
    /// for, or fewer where points do not differ. Points that are not finite are left out.
    ///
    /// ```
    /// use curvecrust_geometry::DVec2;
    /// use curvecrust_tiles::Partition;
    ///
    /// let points: Vec<DVec2> = (0..90).map(|i| DVec2::new(f64::from(i), 0.0)).collect();
    /// let partition = Partition::of(points.clone(), 3);
    /// assert_eq!(partition.cells().len(), 3);
    /// let counts = [0, 1, 2].map(|cell| {
    ///     let inside = |p: &&DVec2| partition.cell_of(**p) == cell;
    ///     points.iter().filter(inside).count()
    /// });
    /// assert_eq!(counts, [30, 30, 30]);
    /// ```
    #[must_use]
    pub fn of(mut points: Vec<DVec2>, cells: usize) -> Self {
        points.retain(|p| p.is_finite());
        let mut cuts = Vec::new();
        cut(&mut points, cells, &mut cuts);
        Self::from_cuts(&cuts)
    }

    /// The partition of some cuts, as [`cuts`](Self::cuts) returns them. Where they end early,
    /// the rest becomes cells.
    #[must_use]
    pub fn from_cuts(cuts: &[Option<Cut>]) -> Self {
        let mut partition = Self {
            nodes: Vec::new(),
            cells: Vec::new(),
        };
        // The parts that are still to be cut, the next one last, and whose node leads there.
        let mut parts = vec![(Area::EVERYTHING, None)];
        let mut cuts = cuts.iter().copied();
        while let Some((area, parent)) = parts.pop() {
            let node = partition.nodes.len();
            if let Some(Node::Cut { above, .. }) = parent.map(|p: usize| &mut partition.nodes[p]) {
                *above = node;
            }
            let Some(cut) = cuts.next().flatten() else {
                partition.nodes.push(Node::Cell(partition.cells.len()));
                partition.cells.push(area);
                continue;
            };
            let (mut below, mut above) = (area, area);
            *cut.axis.of_mut(&mut below.high) = cut.at.next_down();
            *cut.axis.of_mut(&mut above.low) = cut.at;
            partition.nodes.push(Node::Cut { cut, above: node });
            parts.push((above, Some(node)));
            parts.push((below, None));
        }
        partition
    }

    /// The cuts: each before those of its lower side, and these before those of its other side;
    /// `None` for a cell.
    #[must_use]
    pub fn cuts(&self) -> Vec<Option<Cut>> {
        let cut = |node: &Node| match *node {
            Node::Cut { cut, .. } => Some(cut),
            Node::Cell(_) => None,
        };
        self.nodes.iter().map(cut).collect()
    }

    /// The cells by their numbers: each with the doubles that lie in it, so that no two meet.
    #[must_use]
    pub fn cells(&self) -> &[Area] {
        &self.cells
    }

    /// The number of the cell of a point, in a time that grows with the logarithm of their number.
    #[must_use]
    pub fn cell_of(&self, point: DVec2) -> usize {
        let mut at = 0;
        loop {
            match self.nodes[at] {
                Node::Cut { cut, above } if cut.axis.of(point) >= cut.at => at = above,
                Node::Cut { .. } => at += 1,
                Node::Cell(cell) => return cell,
            }
        }
    }
}

/// Cuts points into parts until there are as many as asked for.
fn cut(points: &mut [DVec2], cells: usize, cuts: &mut Vec<Option<Cut>>) {
    let below = cells / 2;
    let found = if below > 0 {
        best_cut(points, below as f64 / cells as f64)
    } else {
        None
    };
    cuts.push(found);
    let Some(Cut { axis, at }) = found else {
        return;
    };
    points.sort_unstable_by(|p, q| axis.of(*p).total_cmp(&axis.of(*q)));
    let middle = points.partition_point(|p| axis.of(*p) < at);
    // Points that do not differ may have made the shares unfair: then the cells are not halved.
    let count = points.len().max(1);
    let below = ((cells * middle + count / 2) / count).clamp(1, cells - 1);
    let (low, high) = points.split_at_mut(middle);
    cut(low, below, cuts);
    cut(high, cells - below, cuts);
}

/// The cut that leaves about a share of the points below it: along the longer side of their area,
/// unless points that do not differ there make the other one fairer.
fn best_cut(points: &mut [DVec2], share: f64) -> Option<Cut> {
    let area = Area::of(points.iter().copied());
    let sides = area.high - area.low;
    let axes = if sides.x < sides.y {
        [Axis::Y, Axis::X]
    } else {
        [Axis::X, Axis::Y]
    };
    let [longer, shorter] = axes;
    let first = cut_along(points, longer, share);
    if let Some((cut, off)) = first
        && off <= points.len() / 8
    {
        return Some(cut);
    }
    let second = cut_along(points, shorter, share);
    let tried = first.into_iter().chain(second);
    tried.min_by_key(|&(_, off)| off).map(|(cut, _)| cut)
}

/// A cut across an axis, and by how many points it misses the share; `None` if all are equal there.
fn cut_along(points: &mut [DVec2], axis: Axis, share: f64) -> Option<(Cut, usize)> {
    #[expect(
        clippy::cast_possible_truncation,
        clippy::cast_sign_loss,
        reason = "at most the number of points"
    )]
    let wanted = ((points.len() as f64 * share) as usize).min(points.len().saturating_sub(1));
    points.sort_unstable_by(|p, q| axis.of(*p).total_cmp(&axis.of(*q)));
    let values = || points.iter().map(|p| axis.of(*p));
    let mut at = values().nth(wanted)?;
    if values().next()? >= at {
        // The next one that differs.
        at = values().find(|&value| value > at)?;
    }
    let below = values().take_while(|&value| value < at).count();
    // -0.0 is 0.0, as in point sets.
    let at = at + 0.0;
    Some((Cut { axis, at }, below.abs_diff(wanted)))
}
