//! Pictures on paper: one page of the size of the drawing, with subsets of the fonts.

use super::png::tree;
use crate::cli::error::CliError;
use krilla::Document;
use krilla::geom::Size;
use krilla::page::PageSettings;
use krilla_svg::{SurfaceExt, SvgSettings};

/// Points of a pixel of SVG: 72 and 96 to the inch.
const POINTS: f32 = 0.75;

/// A picture as PDF. Without dates and random numbers, so that it is the same each time.
pub fn pdf(svg: &str, name: &str) -> Result<Vec<u8>, CliError> {
    let fail = |why: String| CliError::NotCreated { name: name.to_owned(), why };
    let tree = tree(svg, name)?;
    let size = Size::from_wh(tree.size().width() * POINTS, tree.size().height() * POINTS);
    let size = size.ok_or_else(|| fail("it has no size".to_owned()))?;
    let mut document = Document::new();
    let mut page = document.start_page_with(PageSettings::new(size));
    let mut surface = page.surface();
    let drawn = surface.draw_svg(&tree, size, SvgSettings::default());
    surface.finish();
    page.finish();
    drawn.ok_or_else(|| fail("it cannot be drawn".to_owned()))?;
    document.finish().map_err(|error| fail(format!("{error:?}")))
}
