//! Pictures as pixels, with the fonts of the system.

use crate::cli::error::CliError;
use assur_drawing::FAMILIES;
use resvg::tiny_skia::{Pixmap, Transform};
use resvg::usvg::fontdb::Database;
use resvg::usvg::{Options, Tree};
use std::sync::{Arc, OnceLock};

/// Pixels per inch: those of the document, and those of the picture.
const INCH: [f32; 2] = [96.0, 300.0];
/// The piece of a file that says so: 11,811 pixels per metre, with its length and its check sum.
const DENSITY: [u8; 21] =
    [0, 0, 0, 9, b'p', b'H', b'Y', b's', 0, 0, 0x2e, 0x23, 0, 0, 0x2e, 0x23, 1, 0x78, 0xa5, 0x3f, 0x76];
/// Its place: behind the signature and the head.
const HEAD: usize = 33;

/// The fonts of the system, read once.
fn fonts() -> Arc<Database> {
    static FONTS: OnceLock<Arc<Database>> = OnceLock::new();
    let read = || {
        let mut fonts = Database::new();
        fonts.load_system_fonts();
        Arc::new(fonts)
    };
    Arc::clone(FONTS.get_or_init(read))
}

/// How texts are set: in a font of the system.
pub fn options(name: &str) -> Result<Options<'static>, CliError> {
    let mut options = Options { fontdb: fonts(), ..Options::default() };
    let fonts = options.fontdb_mut();
    let installed = |family: &str| fonts.faces().any(|face| face.families.iter().any(|(n, _)| n == family));
    let Some(family) = FAMILIES.into_iter().find(|family| installed(family)) else {
        let families = FAMILIES.join(", ");
        return Err(CliError::NoFont { name: name.to_owned(), families });
    };
    fonts.set_serif_family(family);
    Ok(options)
}

/// An SVG with its texts set.
pub fn tree(svg: &str, name: &str) -> Result<Tree, CliError> {
    Tree::from_str(svg, &options(name)?)
        .map_err(|error| CliError::NotCreated { name: name.to_owned(), why: error.to_string() })
}

/// A picture in pixels.
pub fn png(svg: &str, name: &str) -> Result<Vec<u8>, CliError> {
    drawn(svg, name, None)
}

/// The same of a width in pixels.
pub fn png_of_width(svg: &str, width: u32) -> Result<Vec<u8>, CliError> {
    drawn(svg, "the picture", Some(width))
}

fn drawn(svg: &str, name: &str, width: Option<u32>) -> Result<Vec<u8>, CliError> {
    let fail = |why: String| CliError::NotCreated { name: name.to_owned(), why };
    let tree = tree(svg, name)?;
    let factor = width.map_or(INCH[1] / INCH[0], |width| width as f32 / tree.size().width());
    let size = tree.size().to_int_size().scale_by(factor).ok_or_else(|| fail("it has no size".to_owned()))?;
    let mut pixels =
        Pixmap::new(size.width(), size.height()).ok_or_else(|| fail("it is too large".to_owned()))?;
    resvg::render(&tree, Transform::from_scale(factor, factor), &mut pixels.as_mut());
    let mut bytes = pixels.encode_png().map_err(|error| fail(error.to_string()))?;
    if width.is_none() {
        bytes.splice(HEAD..HEAD, DENSITY);
    }
    Ok(bytes)
}
