//! Animations as APNG: true colour, and of each frame what is new in it.

use super::film::{Part, Show};
use crate::cli::error::CliError;
use png::{BitDepth, BlendOp, ColorType, Compression, DisposeOp, Encoder, EncodingError, Filter, Writer};
use resvg::tiny_skia::{Pixmap, PremultipliedColorU8};

/// A pixel that stays as it was: nothing of the new frame is over it.
const SAME: PremultipliedColorU8 = PremultipliedColorU8::TRANSPARENT;
/// Parts of a second in which times are written.
const PARTS: u16 = 100;

/// An animation as APNG, in an endless loop.
pub fn apng(show: &Show<'_>) -> Result<Vec<u8>, CliError> {
    let mut frames = show.frames()?.zip(show.delays());
    let (first, delay) = frames.next().ok_or_else(|| show.fail("it has no frame"))?;
    let mut before = first?;
    let mut out = Vec::new();
    let mut writer = begin(&mut out, &before, show.film.count(), delay).map_err(|error| show.fail(error))?;
    for (now, delay) in frames {
        let now = now?;
        add(&mut writer, &before, &now, delay).map_err(|error| show.fail(error))?;
        before = now;
    }
    writer.finish().map_err(|error| show.fail(error))?;
    Ok(out)
}

fn begin<'o>(
    out: &'o mut Vec<u8>,
    first: &Pixmap,
    count: usize,
    delay: u16,
) -> Result<Writer<&'o mut Vec<u8>>, EncodingError> {
    let mut encoder = Encoder::new(out, first.width(), first.height());
    encoder.set_color(ColorType::Rgba);
    encoder.set_depth(BitDepth::Eight);
    encoder.set_compression(Compression::High);
    encoder.set_filter(Filter::NoFilter);
    encoder.set_animated(u32::try_from(count).unwrap_or(u32::MAX), 0)?;
    encoder.set_dispose_op(DisposeOp::None)?;
    encoder.set_blend_op(BlendOp::Over)?;
    encoder.set_frame_delay(delay, PARTS)?;
    let mut writer = encoder.write_header()?;
    writer.write_image_data(first.data())?;
    Ok(writer)
}

fn add(
    writer: &mut Writer<&mut Vec<u8>>,
    before: &Pixmap,
    now: &Pixmap,
    delay: u16,
) -> Result<(), EncodingError> {
    writer.set_frame_delay(delay, PARTS)?;
    let (before, now, width) = (before.pixels(), now.pixels(), now.width() as usize);
    let part = Part::changed(before, now, width);
    let side = |side: usize| u32::try_from(side).unwrap_or(u32::MAX);
    // the place first: a rectangle at its old place may be outside
    writer.reset_frame_position()?;
    writer.set_frame_dimension(side(part.width), side(part.height))?;
    writer.set_frame_position(side(part.left), side(part.top))?;
    let pixels = part.pixels(before, now, width, SAME);
    let bytes = pixels.iter().flat_map(|p| [p.red(), p.green(), p.blue(), p.alpha()]);
    writer.write_image_data(&bytes.collect::<Vec<u8>>())
}
