//! SVG to PNG by resvg, with a font of our own: a machine without any draws the same bytes.

use anyhow::Context;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};
use std::sync::Arc;

/// Pixels of the picture for a pixel of the drawing.
const SCALE: f32 = 2.0;

/// Draws documents, with the font loaded once.
pub(crate) struct Rasteriser {
    options: Options<'static>,
}

impl Rasteriser {
    pub(crate) fn new() -> Self {
        let mut fonts = Database::new();
        fonts.load_font_data(notosans::REGULAR_TTF.to_vec());
        fonts.load_font_data(notosans::ITALIC_TTF.to_vec());
        fonts.set_sans_serif_family("Noto Sans");
        let options = Options {
            fontdb: Arc::new(fonts),
            font_family: "Noto Sans".to_owned(),
            ..Options::default()
        };
        Self { options }
    }

    pub(crate) fn png(&self, svg: &str) -> anyhow::Result<Vec<u8>> {
        let tree = Tree::from_str(svg, &self.options).context("cannot read our own SVG")?;
        let size = tree.size().to_int_size();
        let size = size.scale_by(SCALE).context("a figure without a size")?;
        let mut picture =
            Pixmap::new(size.width(), size.height()).context("a figure too large to draw")?;
        let scale = Transform::from_scale(SCALE, SCALE);
        resvg::render(&tree, scale, &mut picture.as_mut());
        picture.encode_png().context("cannot write PNG")
    }
}
