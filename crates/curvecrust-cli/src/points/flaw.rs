//! What can be wrong with a file of points: where, and what stood there.

use crate::format::{self, Format};
use curvecrust::geometry::PointSet;
use std::fmt;
use std::io;
use thiserror::Error;

/// Why a file holds no points that can be used.
#[derive(Debug, Error)]
#[error("{file}{}: {}", flaw.place, flaw.problem)]
pub(crate) struct PointsError {
    file: String,
    flaw: Flaw,
}

impl PointsError {
    pub(crate) fn new(file: String, flaw: Flaw) -> Self {
        Self { file, flaw }
    }
}

/// A problem and where it is.
#[derive(Debug)]
pub(crate) struct Flaw {
    pub(crate) place: Place,
    pub(crate) problem: Problem,
}

/// A place in a file; all are counted from 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    /// The file as a whole.
    File,
    /// A line.
    Line(u64),
    /// A line, and in it the first of the characters.
    Column(u64, usize),
    /// A line of a table, and one of its columns.
    Field(u64, usize),
    /// A row of an array, and one of its columns.
    Row(u64, usize),
    /// A group of rows of a table, and one of its rows.
    GroupRow(u64, u64),
    /// A feature of a collection.
    Feature(usize),
    /// A thing of some kind, such as a shape.
    Item(&'static str, u64),
    /// A feature, if there is a collection, and one of its positions.
    Position(Option<usize>, usize),
}

/// What is wrong there.
#[derive(Debug, Error)]
pub(crate) enum Problem {
    #[error("{0}")]
    Io(io::Error),
    #[error("there are no points")]
    NoPoints,
    #[error("the text is UTF-16: save it as UTF-8")]
    Utf16,
    #[error("this is {what}: {advice}")]
    Foreign {
        what: &'static str,
        advice: &'static str,
    },
    #[error("this is binary data of a kind that is not known")]
    Binary,
    #[error("this is {}, not {}: leave out --from", .format.name(), .asked.name())]
    Asked { asked: Format, format: Format },
    #[error("this is XML of `{0}`: of XML, svg, gpx and kml hold points")]
    OtherXml(String),
    #[error(
        "this is {name}, which this program was built without: build it with the feature `{name}`",
        name = .0.name()
    )]
    LeftOut(Format),
    #[error("points cannot be read from {}: use {}", .0.name(), format::listed(super::FORMATS))]
    Unreadable(Format),
    #[error("`{0}` is not a number")]
    NotANumber(String),
    #[error("`{0}` is not a finite number")]
    NotFinite(String),
    #[error(
        "`{0}` is out of range: scale the points so that every coordinate is zero or between {low:e} \
         and {high:e} in magnitude",
        low = PointSet::MIN_MAGNITUDE,
        high = PointSet::MAX_MAGNITUDE
    )]
    Magnitude(String),
    #[error("a point is x and y, but here is only `{0}`")]
    Short(String),
    #[error("a point is x and y, but `{0}` follows")]
    Long(String),
    #[error("{found} columns without names: head those of the coordinates x and y")]
    Unnamed { found: usize },
    #[error("no columns are named x and y: there are {found}; pass --x and --y with two of them")]
    NoColumns { found: String },
    #[error("no column is named {missing}: there are {found}")]
    NoColumn { missing: String, found: String },
    #[error("{0} could both be meant: pass --x and --y with the names of two columns")]
    TwoColumns(String),
    #[error("--x and --y name columns of tables, but this is {}", .0.name())]
    NoTable(Format),
    #[error("`termini` names the point {index}, which is not there")]
    NoTerminus { index: usize },
    #[error("there is no height to keep")]
    NoHeight,
    #[error("{0}")]
    Json(String),
    #[error("the object has neither `points` nor `samples`, nor is it GeoJSON")]
    NoArray,
    #[error("the object has both `points` and `samples`: which?")]
    TwoArrays,
    #[error("it holds a {0}, which is no point: pass --vertices to take its vertices")]
    Geometry(String),
    #[error("the coordinates of a {0} have to be positions [x, y]")]
    Coordinates(String),
    #[error("this is no NumPy array")]
    NotNpy,
    #[error("the numbers are `{0}`: save them as float64 or float32")]
    Type(String),
    #[error("the shape is ({0}): points have the shape (n, 2)")]
    Shape(String),
    #[error("the array has {rows} rows: at most {} points are read at once", u32::MAX - 1)]
    ManyRows { rows: usize },
    #[error("the shape is ({0}): the coordinates of one axis have the shape (n,)")]
    ColumnShape(String),
    #[error("the arrays {first} and {second} have {first_rows} and {second_rows} rows")]
    Rows {
        first: String,
        second: String,
        first_rows: usize,
        second_rows: usize,
    },
    #[error("no array is named {missing}: there are {found}")]
    NoArrayNamed { missing: String, found: String },
    #[error("which holds points? There are {0}: pass --x and --y with the names of two")]
    Arrays(String),
    #[error("array `{name}`{}: {}", .flaw.place, .flaw.problem)]
    InArray { name: String, flaw: Box<Flaw> },
    #[error("{0}")]
    Archive(String),
    #[error("the header of the array is more than {0} bytes long")]
    LongHeader(usize),
    #[error("`fortran_order` is `{0}`: it has to be True or False")]
    Order(String),
    #[error("the array is stored by columns: save it by rows, as numpy.ascontiguousarray has it")]
    ByColumns,
    #[error("the array is cut off before the end of its {rows} rows")]
    Truncated { rows: usize },
    #[error("the file goes on after the {rows} rows of its array")]
    Trailing { rows: usize },
    #[error("this is no GPX document")]
    NotGpx,
    #[error("this is no KML document")]
    NotKml,
    #[error("this is no PLY file: {0}")]
    Ply(String),
    #[error("it is cut off: of {promised} {what} there are {found}")]
    CutOff {
        what: &'static str,
        promised: u64,
        found: u64,
    },
    #[error("this is no well-known binary: {0}")]
    Wkb(String),
    #[error("this is no LAS file: {0}")]
    Las(String),
    #[error("the LAZ data cannot be decompressed: {0}")]
    Laz(String),
    /// What another process of the program says of it.
    #[error("{0}")]
    Said(String),
    #[error("it promises {points} points, more than 64 times its size and 64 MiB can unpack to")]
    Promise { points: u64 },
    #[error("the table cannot be read: {0}")]
    Parquet(String),
    #[error("the column `{name}` is compressed by {codec}: use Snappy, Zstandard or LZ4_RAW")]
    Codec { name: String, codec: String },
    #[error("the column `{name}` is of the type {found}: coordinates are numbers")]
    ColumnType { name: String, found: String },
    #[error("the column `{name}` has no number")]
    NoNumber { name: String },
    #[error("with --tiles every row has to be one point, and this one is not")]
    OnePoint,
    #[error("this is no FlatGeobuf: {0}")]
    Flatgeobuf(String),
    #[error("this is no Shapefile: {0}")]
    Shapefile(String),
    #[error("this is no well-known text")]
    NotWkt,
    #[error("this is no well-known text: {0}")]
    Wkt(String),
    #[error("this is no SVG document")]
    NotSvg,
    #[error("{0}")]
    Xml(String),
    #[error("the elements are more than {0} levels deep: simplify the document")]
    Deep(usize),
    #[error("{0}")]
    Markup(String),
    #[error("there are no circles and no paths")]
    NoShapes,
    #[error("`{0}` elements are not followed: put the shapes themselves in the drawing")]
    Element(String),
    #[error("{name} is `{found}`, which cannot be read")]
    Attribute { name: String, found: String },
    #[error("{name} {message}")]
    Value { name: String, message: String },
    #[error("the line has {found} columns, the first has {expected}")]
    Ragged { found: usize, expected: usize },
}

impl From<Problem> for Flaw {
    fn from(problem: Problem) -> Self {
        problem.at(Place::File)
    }
}

impl From<io::Error> for Flaw {
    fn from(error: io::Error) -> Self {
        Problem::Io(error).into()
    }
}

impl Problem {
    pub(crate) fn at(self, place: Place) -> Flaw {
        Flaw {
            place,
            problem: self,
        }
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => Ok(()),
            Self::Line(line) => write!(f, ", line {line}"),
            Self::Column(line, column) => write!(f, ", line {line}, column {column}"),
            Self::Field(line, field) => write!(f, ", line {line}, field {field}"),
            Self::Row(row, column) => write!(f, ", row {row}, column {column}"),
            Self::Item(kind, number) => write!(f, ", {kind} {number}"),
            Self::GroupRow(group, row) => write!(f, ", row group {group}, row {row}"),
            Self::Feature(feature) => write!(f, ", feature {feature}"),
            Self::Position(None, position) => write!(f, ", position {position}"),
            Self::Position(Some(feature), position) => {
                write!(f, ", feature {feature}, position {position}")
            }
        }
    }
}
