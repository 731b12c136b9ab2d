//! Points as the readers of geometries gather them. Heights and the last vertices of closed lines
//! are left out, and the notes say so.

use super::heights::Heights;
use super::system::{DEGREES, System};
use super::value::in_double_range;
use super::{Flaw, Place, PointList, Problem, ReadOptions};
use curvecrust::DVec2;

/// Reference systems that a note names; what has more is no map.
const MOST_SYSTEMS: usize = 8;

/// The coordinates of a point: x and y, and z if it has one.
pub(super) type Vertex = ([f64; 2], Option<f64>);

/// Points, and what is known about them, on the way through a file.
pub(super) struct Gathered {
    points: Vec<DVec2>,
    /// Whether vertices of lines and polygons are points.
    vertices: bool,
    /// Where the reader is; positions are counted here.
    place: Place,
    heights: Heights,
    has_measures: bool,
    /// Lines whose last vertex, which repeats the first, was left out.
    closed_lines: usize,
    /// The different reference systems that were named.
    systems: Vec<System>,
    notes: Vec<String>,
}

impl Gathered {
    pub(super) fn new(options: &ReadOptions) -> Self {
        Self {
            points: Vec::new(),
            vertices: options.vertices,
            place: Place::File,
            heights: Heights::new(options),
            has_measures: false,
            closed_lines: 0,
            systems: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// The number of points.
    pub(super) fn count(&self) -> usize {
        self.points.len()
    }

    /// Goes to a place: what follows is there.
    pub(super) fn go_to(&mut self, place: Place) {
        self.place = place;
    }

    /// A problem at the place where the reader is.
    pub(super) fn flaw(&self, problem: Problem) -> Flaw {
        problem.at(self.place)
    }

    /// Takes a point.
    pub(super) fn point(&mut self, ([x, y], height): Vertex) -> Result<(), Flaw> {
        if let Place::Position(_, number) = &mut self.place {
            *number += 1;
        }
        let value = |value| in_double_range(value).map_err(|problem| problem.at(self.place));
        self.points.push(DVec2::new(value(x)?, value(y)?));
        self.heights
            .take(height)
            .map_err(|problem| problem.at(self.place))
    }

    /// Takes the vertices of a line, of a closed one the first once. Whether they are wanted is
    /// settled before, by [`Self::wants_vertices`].
    pub(super) fn line(
        &mut self,
        vertices: impl IntoIterator<Item = Result<Vertex, Flaw>>,
    ) -> Result<(), Flaw> {
        let start = self.points.len();
        for vertex in vertices {
            self.point(vertex?)?;
        }
        if let [first, .., last] = &self.points[start..]
            && first == last
        {
            self.points.pop();
            self.heights.pop();
            self.closed_lines += 1;
        }
        Ok(())
    }

    /// An error unless vertices of what has this name are points.
    pub(super) fn wants_vertices(&self, of: &str) -> Result<(), Flaw> {
        if self.vertices {
            Ok(())
        } else {
            let place = match self.place {
                // A geometry is wrong, and none of its positions.
                Place::Position(None, _) => Place::File,
                Place::Position(Some(feature), _) => Place::Feature(feature),
                place => place,
            };
            Err(Problem::Geometry(of.to_owned()).at(place))
        }
    }

    /// The height that a word stands for, which need not be a number if none is wanted.
    pub(super) fn height_of(&self, word: Option<&[u8]>) -> Result<Option<f64>, Flaw> {
        let height = self.heights.of_word(word, false);
        height.map_err(|problem| problem.at(self.place))
    }

    /// Notes whether what was taken has a measure, the fourth coordinate of maps.
    pub(super) fn measure(&mut self, has_measure: bool) {
        self.has_measures |= has_measure;
    }

    /// Notes the reference system of what was taken.
    pub(super) fn system(&mut self, system: System) {
        if self.systems.len() <= MOST_SYSTEMS && !self.systems.contains(&system) {
            self.systems.push(system);
        }
    }

    /// Notes something else about how the points were read.
    pub(super) fn note(&mut self, note: impl Into<String>) {
        self.notes.push(note.into());
    }

    pub(super) fn finish(self) -> PointList {
        let mut notes = self.notes;
        notes.extend(system_note(&self.systems));
        let (heights, left_out) = self.heights.finish();
        notes.extend(left_out);
        if self.has_measures {
            notes.push("measures are left out".to_owned());
        }
        notes.extend(match self.closed_lines {
            0 => None,
            1 => Some("the last vertex of a closed line repeats the first and is left out".into()),
            count => Some(format!(
                "the last vertices of {count} closed lines repeat the first ones and are left out"
            )),
        });
        let system = match <[System; 1]>::try_from(self.systems) {
            Ok([system]) => Some(system),
            // There may be none, or several.
            Err(_) => None,
        };
        PointList {
            points: self.points,
            heights,
            system,
            notes,
        }
    }
}

/// What the user should know about the reference systems of a file.
fn system_note(systems: &[System]) -> Option<String> {
    let (first, others) = systems.split_first()?;
    if others.is_empty() {
        let note = format!("the reference system is {}", first.name());
        return Some(match first.is_geographic() {
            true => format!("{note}: {DEGREES}"),
            false => note,
        });
    }
    let shown = systems.iter().take(MOST_SYSTEMS).map(System::name);
    let more = if systems.len() > MOST_SYSTEMS {
        " and more"
    } else {
        ""
    };
    let names = shown.collect::<Vec<_>>().join(", ");
    Some(format!(
        "points of several reference systems are taken as they are: {names}{more}"
    ))
}
