//! A reader of what is packed, which gives up when far more comes out than went in.

use crate::points::unpacked;
use std::io::{self, Read};

pub(super) struct Bounded<R> {
    inner: R,
    left: u64,
}

impl<R> Bounded<R> {
    /// Of that many bytes that are packed.
    pub(super) fn new(inner: R, packed: u64) -> Self {
        let left = unpacked::most(packed);
        Self { inner, left }
    }
}

impl<R: Read> Read for Bounded<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let count = self.inner.read(buffer)?;
        self.left = self.left.checked_sub(count as u64).ok_or_else(|| {
            let most = format!("{} times its packed size and 64 MiB", unpacked::RATIO);
            io::Error::other(format!("it unpacks to more than {most}: save it as .npy"))
        })?;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_more_comes_out_than_is_allowed() {
        let most = 64 * 10 + (64 << 20);
        let read = |count: u64| {
            io::copy(
                &mut Bounded::new(io::repeat(0).take(count), 10),
                &mut io::sink(),
            )
        };
        assert_eq!(read(most).unwrap(), most);
        let error = read(most + 1).unwrap_err().to_string();
        assert!(error.contains("64 times its packed size"), "{error}");
    }
}
