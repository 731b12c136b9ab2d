//! Iterators over many threads: those of rayon, by their names. WebAssembly has no threads, and
//! there the same names are those of one.
//!
//! Rayon would do the same there, but it and what it needs of threads are a tenth of a module.

#[cfg(not(target_family = "wasm"))]
pub use rayon::prelude::*;
#[cfg(target_family = "wasm")]
pub use serial::*;

#[cfg(target_family = "wasm")]
mod serial {
    use std::slice::{Chunks, ChunksMut, Iter};

    pub trait IntoParallelIterator: IntoIterator + Sized {
        fn into_par_iter(self) -> Self::IntoIter {
            self.into_iter()
        }
    }

    impl<I: IntoIterator> IntoParallelIterator for I {}

    pub trait ParallelSlice<T> {
        fn par_iter(&self) -> Iter<'_, T>;
        fn par_chunks(&self, size: usize) -> Chunks<'_, T>;
        fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T>;
    }

    impl<T> ParallelSlice<T> for [T] {
        fn par_iter(&self) -> Iter<'_, T> {
            self.iter()
        }

        fn par_chunks(&self, size: usize) -> Chunks<'_, T> {
            self.chunks(size)
        }

        fn par_chunks_mut(&mut self, size: usize) -> ChunksMut<'_, T> {
            self.chunks_mut(size)
        }
    }

    pub trait ParallelIterator: Iterator + Sized {
        fn with_min_len(self, _: usize) -> Self {
            self
        }

        fn flat_map_iter<J: IntoIterator>(
            self,
            of: impl FnMut(Self::Item) -> J,
        ) -> impl Iterator<Item = J::Item> {
            self.flat_map(of)
        }

        fn find_first(mut self, wanted: impl FnMut(&Self::Item) -> bool) -> Option<Self::Item> {
            self.find(wanted)
        }
    }

    impl<I: Iterator> ParallelIterator for I {}
}
