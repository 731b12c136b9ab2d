//! Files of records of 8 byte words, which are there completely or not at all.

use anyhow::Context;
use curvecrust::DVec2;
use curvecrust::tiles::{Area, Claim, Lack, OpenSample, Sample};
use std::fs::{self, File};
use std::io::{self, BufWriter, Read, Write};
use std::path::{Path, PathBuf};

/// Bytes that are written to the system or read from it at once.
pub(super) const BUFFER: usize = 1 << 18;

/// No sample has this id, and nothing else this number.
pub(super) const NONE: u64 = u64::MAX;

/// What is stored in a fixed number of words.
pub(super) trait Record<const WORDS: usize>: Sized {
    fn words(&self) -> [u64; WORDS];
    fn of(words: [u64; WORDS]) -> Self;
}

impl Record<3> for Sample {
    fn words(&self) -> [u64; 3] {
        [self.id, self.point.x.to_bits(), self.point.y.to_bits()]
    }

    fn of([id, x, y]: [u64; 3]) -> Self {
        let point = DVec2::new(f64::from_bits(x), f64::from_bits(y));
        Self { id, point }
    }
}

impl Record<4> for Area {
    fn words(&self) -> [u64; 4] {
        let [low, high] = [self.low, self.high];
        [low.x, low.y, high.x, high.y].map(f64::to_bits)
    }

    fn of(words: [u64; 4]) -> Self {
        let [left, below, right, above] = words.map(f64::from_bits);
        Self {
            low: DVec2::new(left, below),
            high: DVec2::new(right, above),
        }
    }
}

impl Record<2> for Claim {
    fn words(&self) -> [u64; 2] {
        [self.from, self.to]
    }

    fn of([from, to]: [u64; 2]) -> Self {
        Self { from, to }
    }
}

impl Record<10> for OpenSample {
    fn words(&self) -> [u64; 10] {
        let lacks = match self.lacks {
            Lack::Nearest => 0,
            Lack::Half => 1,
        };
        let other = |other: Option<Sample>| other.map_or([NONE; 3], |other| other.words());
        let [id, x, y] = self.sample.words();
        let [id0, x0, y0] = other(self.nearest);
        let [id1, x1, y1] = other(self.half);
        [lacks, id, x, y, id0, x0, y0, id1, x1, y1]
    }

    fn of([lacks, id, x, y, id0, x0, y0, id1, x1, y1]: [u64; 10]) -> Self {
        let other = |words: [u64; 3]| Some(Sample::of(words)).filter(|other| other.id != NONE);
        Self {
            sample: Sample::of([id, x, y]),
            lacks: if lacks == 0 {
                Lack::Nearest
            } else {
                Lack::Half
            },
            nearest: other([id0, x0, y0]),
            half: other([id1, x1, y1]),
        }
    }
}

/// Writes records one after the other.
pub(super) fn put<const WORDS: usize, R: Record<WORDS>>(
    out: &mut impl Write,
    records: impl IntoIterator<Item = R>,
) -> io::Result<()> {
    records
        .into_iter()
        .flat_map(|record| record.words())
        .try_for_each(|word| out.write_all(&word.to_le_bytes()))
}

/// Writes numbers one after the other.
pub(super) fn put_words(out: &mut impl Write, words: &[u64]) -> io::Result<()> {
    let mut words = words.iter();
    words.try_for_each(|word| out.write_all(&word.to_le_bytes()))
}

/// Reads `count` records, and gives them to `take` one by one.
pub(super) fn each<const WORDS: usize, R: Record<WORDS>>(
    reader: &mut impl Read,
    count: u64,
    mut take: impl FnMut(R),
) -> io::Result<()> {
    let at_once = BUFFER / (8 * WORDS);
    let mut buffer = vec![0; at_once * 8 * WORDS];
    let mut left = count;
    while left > 0 {
        let now = usize::try_from(left).map_or(at_once, |left| left.min(at_once));
        let bytes = &mut buffer[..now * 8 * WORDS];
        reader.read_exact(bytes)?;
        let (words, _) = bytes.as_chunks::<8>();
        let (records, _) = words.as_chunks::<WORDS>();
        for record in records {
            take(R::of(record.map(u64::from_le_bytes)));
        }
        left -= now as u64;
    }
    Ok(())
}

/// Reads `count` records.
pub(super) fn get<const WORDS: usize, R: Record<WORDS>>(
    reader: &mut impl Read,
    count: u64,
) -> io::Result<Vec<R>> {
    let mut records = Vec::with_capacity(usize::try_from(count).unwrap_or(0));
    each(reader, count, |record| records.push(record))?;
    Ok(records)
}

/// Reads `WORDS` numbers.
pub(super) fn get_words<const WORDS: usize>(reader: &mut impl Read) -> io::Result<[u64; WORDS]> {
    let mut words = [0; WORDS];
    for word in &mut words {
        let mut bytes = [0; 8];
        reader.read_exact(&mut bytes)?;
        *word = u64::from_le_bytes(bytes);
    }
    Ok(words)
}

/// Writes a file under a temporary name and renames it: whoever finds it finds all of it. The
/// temporary file of a run that was killed is overwritten.
pub(super) fn write(
    path: &Path,
    content: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
) -> anyhow::Result<()> {
    let temporary = temporary(path);
    let written = File::create(&temporary)
        .and_then(|file| {
            let mut out = BufWriter::with_capacity(BUFFER, file);
            content(&mut out)?;
            out.into_inner()?;
            Ok(())
        })
        .and_then(|()| fs::rename(&temporary, path));
    if written.is_err() {
        // That it cannot be removed either is not the message.
        let _ = fs::remove_file(&temporary);
    }
    written.with_context(|| format!("cannot write {}", path.display()))
}

/// The name under which a file is written.
pub(super) fn temporary(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    name.push(".part");
    name.into()
}
