//! Parquet, by the crate of that name: the columns of x and y as of any table, or, in GeoParquet,
//! the column of geometries, which are well-known binary or points of x and y.

mod chunks;
mod geo;
mod numbers;
mod pages;
mod rows;
mod schema;

use super::columns::Columns;
use super::gathered::Gathered;
use super::records::Records;
use super::{Flaw, Place, PointList, Problem, ReadOptions, wkb};
use crate::input::Seekable;
use chunks::Chunks;
use geo::{Encoding, Geo};
use numbers::Numbers;
use pages::Pages;
use parquet::basic::{Compression, Type};
use parquet::column::reader::{ColumnReader, get_column_reader};
use parquet::data_type::ByteArray;
use parquet::errors::ParquetError;
use parquet::file::metadata::ParquetMetaData;
use parquet::file::reader::{FileReader, Length, RowGroupReader};
use parquet::file::serialized_reader::{ReadOptionsBuilder, SerializedFileReader};
use parquet::schema::types::SchemaDescriptor;
pub(crate) use rows::Rows;
use std::io;

/// Rows that are read at once.
const ROWS: usize = 8192;

/// A file, and how many bytes it has.
struct Reader {
    file: SerializedFileReader<Chunks>,
    size: u64,
}

/// Where the points of a table are.
#[derive(Clone, Copy)]
enum Layout {
    /// The columns of x and y, and that of heights if there is one and it is wanted.
    Numbers {
        columns: [usize; 2],
        height: Option<usize>,
    },
    /// A column of well-known binary.
    Geometries(usize),
}

pub(super) fn read(source: Seekable, options: &ReadOptions) -> Result<PointList, Flaw> {
    let reader = open(source)?;
    let mut found = Gathered::new(options);
    match layout(&reader, options, &mut found)? {
        Layout::Numbers { columns, height } => points(&reader, columns, height, &mut found)?,
        Layout::Geometries(column) => geometries(&reader, column, &mut found)?,
    }
    Ok(found.finish())
}

/// Opens a table, which must not promise more rows than it can hold.
fn open(source: Seekable) -> Result<Reader, Flaw> {
    let chunks = Chunks::new(source)?;
    let (most, size) = (chunks.most(), chunks.len());
    let mut reading = ReadOptionsBuilder::new();
    if let Some(schema) = schema::of(&chunks)? {
        reading = reading.with_parquet_schema(schema);
    }
    let file = SerializedFileReader::new_with_options(chunks, reading.build()).map_err(flaw)?;
    let rows = file.metadata().row_groups().iter();
    let rows = rows.map(|group| u64::try_from(group.num_rows()).unwrap_or(u64::MAX));
    let rows = rows.fold(0, u64::saturating_add);
    if rows.saturating_mul(16) > most {
        return Err(Problem::Promise { points: rows }.into());
    }
    Ok(Reader { file, size })
}

/// Finds the points of a table; tells `found` what is known about them.
fn layout(reader: &Reader, options: &ReadOptions, found: &mut Gathered) -> Result<Layout, Flaw> {
    let metadata = reader.file.metadata().file_metadata();
    let schema = metadata.schema_descr();
    let geo = match &options.columns {
        Some(_) => None,
        None => geo::of(metadata)?,
    };
    if let Some(geo) = geo {
        let Geo {
            column,
            encoding,
            system,
        } = geo;
        if let Some(system) = system {
            found.system(system);
        }
        return Ok(match encoding {
            Encoding::Wkb => Layout::Geometries(leaf(schema, &[&column])?),
            Encoding::Point => {
                let [x, y, z] = ["x", "y", "z"].map(|axis| leaf(schema, &[&column, axis]));
                Layout::Numbers {
                    columns: [x?, y?],
                    height: z.ok(),
                }
            }
        });
    }
    let header = Header::of(schema);
    let columns = Columns::of_header(&header, options.columns.as_ref());
    let columns = columns.and_then(|columns| {
        columns.ok_or_else(|| super::columns::not_found(&header, options.columns.as_ref()))
    });
    // A table without lines.
    let columns = columns.map_err(|flaw| Flaw::from(flaw.problem))?;
    if let Some(note) = columns.note(&header, options.heights) {
        found.note(note);
    }
    let leaf = |column: usize| header.columns[column].0;
    Ok(Layout::Numbers {
        columns: [columns.x, columns.y].map(leaf),
        height: columns.z.filter(|_| options.heights).map(leaf),
    })
}

fn flaw(error: ParquetError) -> Flaw {
    Problem::Parquet(error.to_string()).into()
}

/// The number of the column with a path.
fn leaf(schema: &SchemaDescriptor, path: &[&str]) -> Result<usize, Flaw> {
    let mut columns = schema.columns().iter();
    let found = columns.position(|column| column.path().parts() == path);
    found.ok_or_else(|| Problem::Parquet("its column of geometries is missing".into()).into())
}

/// The columns that can be named.
struct Header {
    /// The number of each, and its name.
    columns: Vec<(usize, String)>,
}

impl Header {
    fn of(schema: &SchemaDescriptor) -> Self {
        let columns = schema.columns().iter().enumerate();
        let plain = columns
            .filter(|(_, column)| column.path().parts().len() == 1 && column.max_rep_level() == 0);
        let named = plain.map(|(number, column)| (number, column.name().to_owned()));
        Self {
            columns: named.collect(),
        }
    }
}

impl Records for Header {
    const IS_TEXT: bool = false;

    fn advance(&mut self) -> io::Result<bool> {
        Ok(false)
    }

    fn len(&self) -> usize {
        self.columns.len()
    }

    fn field(&self, index: usize) -> &[u8] {
        self.columns[index].1.as_bytes()
    }

    fn line(&self) -> u64 {
        1
    }

    fn place(&self, _: usize) -> Place {
        Place::File
    }

    fn has_decimal_commas(&self) -> bool {
        false
    }

    fn ragged(&self, expected: usize) -> Flaw {
        let found = self.len();
        Problem::Ragged { found, expected }.into()
    }
}

/// The reader of one column of a group of rows, after it is settled that the column is there, and
/// packed in a way that says how much comes out.
fn column(
    metadata: &ParquetMetaData,
    group: &dyn RowGroupReader,
    column: usize,
    size: u64,
) -> Result<ColumnReader, Flaw> {
    let about = metadata.file_metadata().schema_descr().column(column);
    let chunk = group.metadata().column(column);
    let codec = chunk.compression();
    if !matches!(
        codec,
        Compression::UNCOMPRESSED
            | Compression::SNAPPY
            | Compression::ZSTD(_)
            | Compression::LZ4_RAW
    ) {
        let name = super::quoted(about.name().as_bytes());
        // Without its level.
        let codec = codec.to_string();
        let codec = codec.split('(').next().unwrap_or_default().to_owned();
        return Err(Problem::Codec { name, codec }.into());
    }
    let start = chunk
        .dictionary_page_offset()
        .unwrap_or(chunk.data_page_offset());
    let range = [start, chunk.data_page_offset(), chunk.compressed_size()].map(u64::try_from);
    let is_inside = match range {
        [Ok(start), Ok(_), Ok(length)] => start.saturating_add(length) <= size,
        _ => false,
    };
    if !is_inside {
        return Err(Problem::Parquet("it is cut off".into()).into());
    }
    let most = group.metadata().num_rows().try_into().unwrap_or(0);
    let pages = group.get_column_page_reader(column).map_err(flaw)?;
    Ok(get_column_reader(
        about.clone(),
        Box::new(Pages::new(pages, &about, most)),
    ))
}

/// Takes two columns of numbers, and one of heights if there is one.
fn points(
    reader: &Reader,
    columns: [usize; 2],
    height: Option<usize>,
    found: &mut Gathered,
) -> Result<(), Flaw> {
    let metadata = reader.file.metadata();
    let schema = metadata.file_metadata().schema_descr();
    let [mut xs, mut ys, mut zs] = [Vec::new(), Vec::new(), Vec::new()];
    let mut row = 0;
    for index in 0..metadata.num_row_groups() {
        let group = reader.file.get_row_group(index).map_err(flaw)?;
        let axis = |number| {
            let numbers = column(metadata, &*group, number, reader.size)?;
            Numbers::new(numbers, &schema.column(number))
        };
        let [mut x_axis, mut y_axis] = [axis(columns[0])?, axis(columns[1])?];
        let mut z_axis = height.map(axis).transpose()?;
        loop {
            let count = x_axis.read(ROWS, row, &mut xs)?;
            let heights = match &mut z_axis {
                Some(z_axis) => z_axis.read(ROWS, row, &mut zs)?,
                None => count,
            };
            if y_axis.read(ROWS, row, &mut ys)? != count || heights != count {
                return Err(Problem::Parquet("its columns differ in length".into()).into());
            }
            if count == 0 {
                break;
            }
            for (index, (x, y)) in xs.iter().zip(&ys).enumerate() {
                row += 1;
                found.go_to(Place::Item("row", row));
                found.point(([*x, *y], zs.get(index).copied()))?;
            }
        }
    }
    Ok(())
}

/// Takes a column of well-known binary.
fn geometries(reader: &Reader, number: usize, found: &mut Gathered) -> Result<(), Flaw> {
    let metadata = reader.file.metadata();
    let about = metadata.file_metadata().schema_descr().column(number);
    if about.physical_type() != Type::BYTE_ARRAY || about.max_rep_level() > 0 {
        return Err(Problem::Parquet("its column of geometries holds others".into()).into());
    }
    let mut row = 0;
    for index in 0..metadata.num_row_groups() {
        let group = reader.file.get_row_group(index).map_err(flaw)?;
        let column = column(metadata, &*group, number, reader.size)?;
        let ColumnReader::ByteArrayColumnReader(mut column) = column else {
            continue;
        };
        loop {
            let (mut levels, mut values) = (Vec::new(), Vec::<ByteArray>::new());
            let is_nullable = about.max_def_level() > 0;
            let nulls = is_nullable.then_some(&mut levels);
            let read = column.read_records(ROWS, nulls, None, &mut values);
            let (rows, _, _) = read.map_err(|error| {
                Problem::Parquet(error.to_string()).at(Place::Item("row", row + 1))
            })?;
            if rows == 0 {
                break;
            }
            let mut values = values.iter();
            for index in 0..rows {
                row += 1;
                found.go_to(Place::Item("row", row));
                // A row without a geometry is no place.
                if levels
                    .get(index)
                    .is_some_and(|&level| level < about.max_def_level())
                {
                    continue;
                }
                if let Some(value) = values.next() {
                    wkb::collect(found, value.data())?;
                }
            }
        }
    }
    Ok(())
}
