//! The pages of a column, on their way to the decoders of the crate, which fail where a page needs
//! a dictionary that is missing, or has fewer bytes than values.

use parquet::basic::{Encoding, Type};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::{ParquetError, Result};
use parquet::schema::types::ColumnDescriptor;

/// A reader whose pages were looked at.
pub(super) struct Pages {
    pages: Box<dyn PageReader>,
    /// Bytes of a number; `None` if the column has no numbers.
    width: Option<u64>,
    /// How many values a page may have.
    most: u64,
    is_nullable: bool,
    has_dictionary: bool,
}

impl Pages {
    pub(super) fn new(pages: Box<dyn PageReader>, about: &ColumnDescriptor, most: u64) -> Self {
        Self {
            pages,
            width: match about.physical_type() {
                Type::INT32 | Type::FLOAT => Some(4),
                Type::INT64 | Type::DOUBLE => Some(8),
                _ => None,
            },
            most,
            is_nullable: about.max_def_level() > 0,
            has_dictionary: false,
        }
    }

    fn check(&mut self, page: &Page) -> Result<()> {
        let problem = |what: &str| Err(ParquetError::General(what.to_owned()));
        if u64::from(page.num_values()) > self.most {
            return problem("a page has more values than the table has rows");
        }
        match page.encoding() {
            _ if matches!(page, Page::DictionaryPage { .. }) => {
                self.has_dictionary = true;
                Ok(())
            }
            Encoding::PLAIN_DICTIONARY | Encoding::RLE_DICTIONARY if !self.has_dictionary => {
                problem("a page has no dictionary")
            }
            Encoding::BYTE_STREAM_SPLIT if !self.has_bytes(page) => {
                problem("a page has fewer bytes than numbers")
            }
            _ => Ok(()),
        }
    }

    /// Whether a page has as many bytes behind its levels as its rows need.
    fn has_bytes(&self, page: &Page) -> bool {
        let (Some(width), Some(values)) = (self.width, self.values(page)) else {
            return false;
        };
        let bytes = values.len() as u64;
        bytes >= u64::from(page.num_values()) * width && bytes.is_multiple_of(width)
    }

    /// What a page has behind its levels.
    fn values<'a>(&self, page: &'a Page) -> Option<&'a [u8]> {
        let bytes = page.buffer();
        let levels = match page {
            Page::DictionaryPage { .. } => 0,
            Page::DataPageV2 {
                def_levels_byte_len,
                rep_levels_byte_len,
                ..
            } => *def_levels_byte_len as usize + *rep_levels_byte_len as usize,
            // Their length is in front of them.
            Page::DataPage { .. } if self.is_nullable => {
                4 + u32::from_le_bytes(*bytes.first_chunk()?) as usize
            }
            Page::DataPage { .. } => 0,
        };
        bytes.get(levels..)
    }

    /// A page of texts, with one of length zero behind them for each value: the decoder fails where
    /// there are fewer than the levels say, and stops where there are enough.
    fn padded(&self, mut page: Page) -> Result<Page> {
        let is_plain = match page {
            Page::DictionaryPage { .. } => true,
            _ => page.encoding() == Encoding::PLAIN,
        };
        if self.width.is_some() || !is_plain {
            return Ok(page);
        }
        if !self.values(&page).is_some_and(are_texts) {
            return Err(ParquetError::General("a page is cut off".into()));
        }
        let padding = vec![0; 4 * page.num_values() as usize];
        match &mut page {
            Page::DataPage { buf, .. }
            | Page::DataPageV2 { buf, .. }
            | Page::DictionaryPage { buf, .. } => *buf = [buf, &padding[..]].concat().into(),
        }
        Ok(page)
    }
}

/// Whether bytes are whole texts, each with its length in front.
fn are_texts(mut bytes: &[u8]) -> bool {
    while let Some((length, rest)) = bytes.split_first_chunk() {
        match rest.get(u32::from_le_bytes(*length) as usize..) {
            Some(rest) => bytes = rest,
            None => return false,
        }
    }
    bytes.is_empty()
}

impl Iterator for Pages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Result<Page>> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let Some(page) = self.pages.get_next_page()? else {
            return Ok(None);
        };
        self.check(&page)?;
        self.padded(page).map(Some)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.pages.skip_next_page()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_have_their_length_in_front() {
        assert!(are_texts(b"") && are_texts(b"\x01\0\0\0a\0\0\0\0"));
        assert!(!are_texts(b"\x02\0\0\0a") && !are_texts(b"\0\0\0") && !are_texts(b"\0\0\0\0a"));
    }
}
