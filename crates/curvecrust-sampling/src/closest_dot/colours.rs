//! The dots of each colour so far, and which edges may be added to them.
//!
//! After each edge it holds that every dot has one choice in each of its colours: the other end of
//! one of its edges, with all other dots of the colour farther by the margin. And each edge is the
//! choice of one of its ends or of both. So the solver joins these dots in this way.

use std::collections::BTreeMap;

use curvecrust_geometry::DVec2;
use rstar::RTree;
use rstar::primitives::GeomWithData;

/// What rounding could take from a margin.
const SAFE: f64 = 1.0 + 1e-9;

/// A dot by its index, and where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Dot {
    pub(super) index: usize,
    pub(super) at: DVec2,
}

/// All colours, by their numbers.
#[derive(Debug)]
pub(super) struct Colours {
    /// By what factor the second closest dot is to be farther than the closest.
    factor: f64,
    colours: Vec<OneColour>,
}

/// The dots of a colour.
#[derive(Debug, Default)]
struct OneColour {
    tree: RTree<GeomWithData<[f64; 2], usize>>,
    choices: BTreeMap<usize, Choice>,
    /// No choice was ever farther than this.
    longest: f64,
}

/// The dot that a dot is joined with, and how far that is.
#[derive(Clone, Copy, Debug)]
struct Choice {
    dot: usize,
    distance: f64,
}

/// What a new edge is to one of its ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Role {
    /// The end gets the colour, and the edge is its choice.
    First,
    /// The end had the colour; the edge becomes its choice.
    Shorter,
    /// The end had the colour and keeps its choice.
    Longer,
}

impl Colours {
    pub(super) fn new(margin: f64) -> Self {
        Self {
            factor: (1.0 + margin) * SAFE,
            colours: Vec::new(),
        }
    }

    /// How many there are.
    pub(super) fn len(&self) -> usize {
        self.colours.len()
    }

    /// One more, in which any edge fits.
    pub(super) fn add(&mut self) -> usize {
        self.colours.push(OneColour::default());
        self.colours.len() - 1
    }

    /// Whether the solver would join two dots if they had a colour, and all others as before.
    pub(super) fn fits(&self, colour: usize, ends: [Dot; 2]) -> bool {
        self.roles(colour, ends).is_some()
    }

    /// Gives two dots a colour in which their edge fits.
    pub(super) fn join(&mut self, colour: usize, ends: [Dot; 2]) {
        let Some(roles) = self.roles(colour, ends) else {
            return;
        };
        let distance = ends[0].at.distance(ends[1].at);
        let colour = &mut self.colours[colour];
        for (role, [end, other]) in roles.into_iter().zip([ends, [ends[1], ends[0]]]) {
            if role == Role::First {
                let place = GeomWithData::new(end.at.to_array(), end.index);
                colour.tree.insert(place);
                colour.longest = colour.longest.max(distance);
            }
            if role != Role::Longer {
                let dot = other.index;
                colour.choices.insert(end.index, Choice { dot, distance });
            }
        }
    }

    /// What an edge would be to both of its ends; `None` if it does not fit.
    fn roles(&self, colour: usize, [a, b]: [Dot; 2]) -> Option<[Role; 2]> {
        let colour = self.colours.get(colour)?;
        let distance = a.at.distance(b.at);
        // What takes no search comes first.
        let held = [
            colour.held(a, distance, self.factor),
            colour.held(b, distance, self.factor),
        ];
        let roles = match held {
            [Held::Refused, _] | [_, Held::Refused] => return None,
            [Held::As(a), Held::As(b)] => [a, b],
            [Held::As(role), Held::Not] => [role, Role::First],
            [Held::Not, Held::As(role)] => [Role::First, role],
            [Held::Not, Held::Not] => [Role::First; 2],
        };
        let is_free = |end: Dot, other: Dot| colour.is_free(end, other, distance, self.factor);
        let fits = roles != [Role::Longer; 2]
            && (roles[0] != Role::First || is_free(a, b))
            && (roles[1] != Role::First || is_free(b, a));
        fits.then_some(roles)
    }
}

/// What a new edge is to a dot that may have the colour.
enum Held {
    /// The dot does not have the colour.
    Not,
    As(Role),
    /// The solver could not tell which of two edges is meant, or would lose one.
    Refused,
}

impl OneColour {
    /// What an edge of some length is to a dot with one edge of this colour or none.
    fn held(&self, end: Dot, distance: f64, factor: f64) -> Held {
        let Some(choice) = self.choices.get(&end.index) else {
            return Held::Not;
        };
        if distance * factor <= choice.distance {
            // The edge so far has to be the choice of its other end.
            let back = self.choices.get(&choice.dot);
            match back.is_some_and(|back| back.dot == end.index) {
                true => Held::As(Role::Shorter),
                false => Held::Refused,
            }
        } else if distance >= choice.distance * factor {
            Held::As(Role::Longer)
        } else {
            Held::Refused
        }
    }

    /// Whether a dot that gets the colour, with a choice at some distance, is far enough from all
    /// but that: for its own choice, and for those of the others.
    fn is_free(&self, end: Dot, other: Dot, distance: f64, factor: f64) -> bool {
        let reach = distance.max(self.longest) * factor;
        let near = self
            .tree
            .locate_within_distance(end.at.to_array(), reach * reach);
        near.filter(|place| place.data != other.index).all(|place| {
            let choice = self.choices.get(&place.data);
            let longer = choice.map_or(distance, |choice| choice.distance.max(distance));
            DVec2::from_array(*place.geom()).distance(end.at) >= longer * factor
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn dots(at: &[f64]) -> Vec<Dot> {
        let dot = |(index, &x): (usize, &f64)| Dot {
            index,
            at: DVec2::new(x, 0.0),
        };
        at.iter().enumerate().map(dot).collect()
    }

    /// Joins consecutive dots on a line in one colour, and says which edges fit.
    fn fit(at: &[f64]) -> Vec<bool> {
        let mut colours = Colours::new(0.1);
        let colour = colours.add();
        let dots = dots(at);
        let pairs = dots.windows(2).map(|pair| [pair[0], pair[1]]);
        pairs
            .map(|ends| {
                let fits = colours.fits(colour, ends);
                colours.join(colour, ends);
                fits
            })
            .collect()
    }

    #[test]
    fn steps_get_shorter_and_then_longer() {
        assert_eq!(fit(&[0.0, 4.0, 7.0, 9.0, 12.0]), [true; 4]);
    }

    #[test]
    fn steps_that_differ_by_less_than_the_margin_do_not_fit() {
        assert_eq!(fit(&[0.0, 4.0, 7.8]), [true, false]);
        assert_eq!(fit(&[0.0, 4.0, 8.2]), [true, false]);
    }

    /// The edge in the middle would be nobody's choice.
    #[test]
    fn no_step_is_longer_than_both_beside_it() {
        assert_eq!(fit(&[0.0, 2.0, 5.0, 7.0]), [true, true, false]);
    }
}
