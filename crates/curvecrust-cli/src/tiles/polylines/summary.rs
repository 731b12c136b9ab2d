//! What is stored of the pieces of a tile that are no whole curves.

use crate::tiles::records::{NONE, Record, get_words, put_words};
use curvecrust::DVec2;
use curvecrust::tiles::{Area, ExactSum, Least, PieceSummary};
use std::io::{self, Read, Write};

/// The words of a summary without its sums.
const WORDS: usize = 21;

/// No sum has more parts: doubles do not overlap more often.
const MOST_PARTS: u64 = 64;

/// The words of a summary.
pub(super) fn length(summary: &PieceSummary) -> usize {
    WORDS + 2 + summary.length.parts().len() + summary.twice_area.parts().len()
}

pub(super) fn put(out: &mut impl Write, summary: &PieceSummary) -> io::Result<()> {
    let PieceSummary {
        ends: [first, last],
        points: [p, q],
        links,
        inner: [second, before_last],
        least,
        count,
        length,
        twice_area,
        area,
        leftmost,
        closed: _,
    } = summary;
    let [before, after] = links.map(|link| link.unwrap_or(NONE));
    let [left, below, right, above] = area.words();
    let [px, py, qx, qy, x, y] = [p.x, p.y, q.x, q.y, leftmost.x, leftmost.y].map(f64::to_bits);
    let words: [u64; WORDS] = [
        *first,
        *last,
        px,
        py,
        qx,
        qy,
        before,
        after,
        *second,
        *before_last,
        least.id,
        least.position,
        least.beside[0],
        least.beside[1],
        *count,
        left,
        below,
        right,
        above,
        x,
        y,
    ];
    put_words(out, &words)?;
    for sum in [length, twice_area] {
        put_words(out, &[sum.parts().len() as u64])?;
        for part in sum.parts() {
            put_words(out, &[part.to_bits()])?;
        }
    }
    Ok(())
}

pub(super) fn get(reader: &mut impl Read) -> io::Result<PieceSummary> {
    let words: [u64; WORDS] = get_words(reader)?;
    let [first, last, px, py, qx, qy, rest @ ..] = words;
    let [before, after, second, before_last, rest @ ..] = rest;
    let [id, position, beside0, beside1, count, rest @ ..] = rest;
    let [left, below, right, above, x, y] = rest;
    let at = |x: u64, y: u64| DVec2::new(f64::from_bits(x), f64::from_bits(y));
    let link = |link: u64| Some(link).filter(|&link| link != NONE);
    Ok(PieceSummary {
        ends: [first, last],
        points: [at(px, py), at(qx, qy)],
        links: [link(before), link(after)],
        inner: [second, before_last],
        least: Least {
            id,
            position,
            beside: [beside0, beside1],
        },
        count,
        length: get_sum(reader)?,
        twice_area: get_sum(reader)?,
        area: <Area as Record<4>>::of([left, below, right, above]),
        leftmost: at(x, y),
        // What is closed is whole.
        closed: false,
    })
}

fn get_sum(reader: &mut impl Read) -> io::Result<ExactSum> {
    let [parts] = get_words(reader)?;
    if parts > MOST_PARTS {
        return Err(io::Error::other("it is damaged"));
    }
    let part = |_| get_words(reader).map(|[bits]| f64::from_bits(bits));
    (0..parts).map(part).collect()
}
