//! The pages of a column, on their way to the decoders of the crate, which fail where a page needs a
//! dictionary that is missing, or has fewer bytes than numbers.

use parquet::basic::{Encoding, Type};
use parquet::column::page::{Page, PageMetadata, PageReader};
use parquet::errors::{ParquetError, Result};
use parquet::schema::types::ColumnDescriptor;

/// A reader whose pages were looked at.
pub(super) struct Pages {
    pages: Box<dyn PageReader>,
    /// Bytes of a number.
    width: u64,
    is_nullable: bool,
    has_dictionary: bool,
}

impl Pages {
    pub(super) fn new(pages: Box<dyn PageReader>, about: &ColumnDescriptor) -> Self {
        Self {
            pages,
            width: match about.physical_type() {
                Type::INT32 | Type::FLOAT => 4,
                _ => 8,
            },
            is_nullable: about.max_def_level() > 0,
            has_dictionary: false,
        }
    }

    fn check(&mut self, page: &Page) -> Result<()> {
        let problem = |what: &str| Err(ParquetError::General(what.to_owned()));
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
        let bytes = page.buffer();
        let levels = match page {
            Page::DataPageV2 {
                def_levels_byte_len,
                rep_levels_byte_len,
                ..
            } => u64::from(*def_levels_byte_len) + u64::from(*rep_levels_byte_len),
            // Their length is in front of them.
            _ if self.is_nullable => match bytes.first_chunk() {
                Some(length) => 4 + u64::from(u32::from_le_bytes(*length)),
                None => return false,
            },
            _ => 0,
        };
        let numbers = (bytes.len() as u64).saturating_sub(levels);
        let needed = u64::from(page.num_values()) * self.width;
        numbers >= needed && numbers % self.width == 0
    }
}

impl Iterator for Pages {
    type Item = Result<Page>;

    fn next(&mut self) -> Option<Result<Page>> {
        self.get_next_page().transpose()
    }
}

impl PageReader for Pages {
    fn get_next_page(&mut self) -> Result<Option<Page>> {
        let page = self.pages.get_next_page()?;
        if let Some(page) = &page {
            self.check(page)?;
        }
        Ok(page)
    }

    fn peek_next_page(&mut self) -> Result<Option<PageMetadata>> {
        self.pages.peek_next_page()
    }

    fn skip_next_page(&mut self) -> Result<()> {
        self.pages.skip_next_page()
    }
}
