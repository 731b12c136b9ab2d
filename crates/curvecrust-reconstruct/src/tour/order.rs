//! A tour as an array, and where each vertex is in it.

/// A part of a tour: the places that it leads from and to, and whether it follows the tour or goes
/// against it.
#[derive(Clone, Copy, Default)]
pub(super) struct Segment {
    pub(super) from: u32,
    pub(super) to: u32,
    pub(super) is_on: bool,
}

impl Segment {
    /// The same from its other end.
    fn reversed(self) -> Self {
        Self {
            from: self.to,
            to: self.from,
            is_on: !self.is_on,
        }
    }
}

/// A state of a tour: the changes since the last one that was kept.
#[derive(Clone, Copy, Default)]
pub(super) struct Mark(usize);

/// A closed tour through the vertices `0..n`, and a log of what was changed.
pub(super) struct Order {
    at: Vec<u32>,
    place: Vec<u32>,
    /// What was at which place, since the last state that is kept.
    log: Vec<(u32, u32)>,
    /// Where vertices are on their way.
    moved: Vec<u32>,
}

impl Order {
    /// Each vertex once.
    pub(super) fn new(at: Vec<u32>) -> Self {
        let mut place = vec![0; at.len()];
        for (i, &v) in (0u32..).zip(&at) {
            place[v as usize] = i;
        }
        Self {
            at,
            place,
            log: Vec::new(),
            moved: Vec::new(),
        }
    }

    pub(super) fn len(&self) -> usize {
        self.at.len()
    }

    /// The vertices in their order.
    pub(super) fn vertices(&self) -> &[u32] {
        &self.at
    }

    pub(super) fn into_inner(self) -> Vec<u32> {
        self.at
    }

    /// The edges in the direction of the tour.
    pub(super) fn edges(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        let next = self.at.iter().cycle().skip(1);
        self.at.iter().zip(next).map(|(&v, &w)| [v, w])
    }

    pub(super) fn place(&self, v: u32) -> u32 {
        self.place[v as usize]
    }

    /// The vertex so many steps after another.
    pub(super) fn after(&self, v: u32, steps: usize) -> u32 {
        self.at[(self.place(v) as usize + steps) % self.at.len()]
    }

    pub(super) fn next(&self, v: u32) -> u32 {
        let place = self.place(v) as usize + 1;
        self.at[if place == self.at.len() { 0 } else { place }]
    }

    pub(super) fn previous(&self, v: u32) -> u32 {
        let place = self.place(v) as usize;
        self.at[(if place == 0 { self.at.len() } else { place }) - 1]
    }

    /// Of the two neighbours of a vertex the one that is not the other.
    pub(super) fn beyond(&self, v: u32, from: u32) -> u32 {
        let next = self.next(v);
        if next == from { self.previous(v) } else { next }
    }

    pub(super) fn are_joined(&self, v: u32, w: u32) -> bool {
        self.next(v) == w || self.previous(v) == w
    }

    /// Keeps the present state.
    pub(super) fn keep(&mut self) {
        self.log.clear();
    }

    /// A state to go back to, until one is kept.
    pub(super) fn mark(&self) -> Mark {
        Mark(self.log.len())
    }

    /// Goes back to a state.
    pub(super) fn undo(&mut self, to: Mark) {
        for (place, v) in self.log.drain(to.0.min(self.log.len())..).rev() {
            self.at[place as usize] = v;
            self.place[v as usize] = place;
        }
    }

    /// How many vertices [`join`](Self::join) moves at most.
    pub(super) fn moved(&self, segments: &[Segment]) -> usize {
        let longest = segments.iter().map(|&s| self.length(s)).max();
        self.at.len() - longest.unwrap_or_default()
    }

    /// The vertices in their order in the last state that was kept.
    pub(super) fn kept(&self) -> Vec<u32> {
        let mut at = self.at.clone();
        for &(place, v) in self.log.iter().rev() {
            at[place as usize] = v;
        }
        at
    }

    /// Replaces the edges t1 t2 and t3 t4 by t2 t3 and t4 t1, where a way around the tour meets t1,
    /// t2, t4, t3 in this order. The new state is kept.
    pub(super) fn exchange(&mut self, [t1, t2, t3, t4]: [u32; 4]) {
        let ends = if self.next(t1) == t2 {
            [t2, t4, t3, t1]
        } else {
            [t4, t2, t1, t3]
        };
        let [from, to, rest, last] = ends.map(|v| self.place(v));
        let turned = Segment {
            from: to,
            to: from,
            is_on: false,
        };
        let rest = Segment {
            from: rest,
            to: last,
            is_on: true,
        };
        self.join(&mut [turned, rest]);
        self.keep();
    }

    /// How many vertices are from one place on to another.
    fn between(&self, from: u32, to: u32) -> usize {
        let [from, to] = [from, to].map(|place| place as usize);
        (if from <= to { 0 } else { self.at.len() }) + to - from + 1
    }

    fn length(&self, segment: Segment) -> usize {
        if segment.is_on {
            self.between(segment.from, segment.to)
        } else {
            self.between(segment.to, segment.from)
        }
    }

    /// Joins segments, which make up the tour, in this order.
    ///
    /// The longest stays where it is, and so do others that would come to their own place: on the
    /// other places the vertices are written anew.
    pub(super) fn join(&mut self, segments: &mut [Segment]) {
        let longest = (0..segments.len()).max_by_key(|&i| self.length(segments[i]));
        let Some(longest) = longest else { return };
        if !segments[longest].is_on {
            segments.reverse();
            segments.iter_mut().for_each(|s| *s = s.reversed());
            segments.rotate_left(segments.len() - 1 - longest);
        } else {
            segments.rotate_left(longest);
        }
        let stays =
            |segment: Segment, start: usize| segment.is_on && segment.from as usize == start;
        let mut start = self.wrapped(segments[0].to as usize + 1);
        let first = start;
        for &segment in &segments[1..] {
            let length = self.length(segment);
            if !stays(segment, start) {
                self.lift(segment, length);
            }
            start = self.wrapped(start + length);
        }
        let moved = std::mem::take(&mut self.moved);
        let mut vertices = moved.iter();
        start = first;
        for &segment in &segments[1..] {
            let length = self.length(segment);
            if !stays(segment, start) {
                for (i, &v) in vertices.by_ref().take(length).enumerate() {
                    self.put(v, self.wrapped(start + i));
                }
            }
            start = self.wrapped(start + length);
        }
        self.moved = moved;
        self.moved.clear();
    }

    fn wrapped(&self, place: usize) -> usize {
        if place < self.at.len() {
            place
        } else {
            place - self.at.len()
        }
    }

    /// Copies the vertices of a segment.
    fn lift(&mut self, segment: Segment, length: usize) {
        let first = if segment.is_on {
            segment.from
        } else {
            segment.to
        } as usize;
        let end = first + length;
        let inside = end.min(self.at.len());
        let before = self.moved.len();
        self.moved.extend_from_slice(&self.at[first..inside]);
        self.moved.extend_from_slice(&self.at[..end - inside]);
        if !segment.is_on {
            self.moved[before..].reverse();
        }
    }

    fn put(&mut self, v: u32, place: usize) {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "below the number of vertices"
        )]
        let short = place as u32;
        self.log.push((short, self.at[place]));
        self.at[place] = v;
        self.place[v as usize] = short;
    }
}
