//! Animations as GIF: colours that the theme chooses, and of each frame what is new in it.

use super::film::{Part, Show};
use crate::cli::error::CliError;
use assur_drawing::{Palette, Role, Theme};
use gif::{DisposalMethod, Encoder, Frame, Repeat};
use resvg::tiny_skia::PremultipliedColorU8;
use std::collections::HashMap;

/// Colours of lines and letters, whose edges are mixed with paper, and of areas.
const INKS: [Role; 5] = [Role::Ink, Role::Grey, Role::Blue, Role::Vermilion, Role::Green];
const AREAS: [Role; 4] = [Role::Paper, Role::Tint, Role::BlueTint, Role::VermilionTint];
/// How many mixtures an ink has, the last without paper.
const MIXTURES: u8 = 5;
/// The index of a pixel that stays as it was.
const SAME: u8 = 0;

/// An animation as GIF, in an endless loop.
pub fn gif(show: &Show<'_>) -> Result<Vec<u8>, CliError> {
    let mut colours = Colours::of(show.theme);
    let mut out = Out { encoder: None, before: Vec::new() };
    for (pixels, delay) in show.frames()?.zip(show.delays()) {
        let pixels = pixels?;
        let size = [pixels.width(), pixels.height()].map(u16::try_from);
        let [Ok(width), Ok(height)] = size else { return Err(show.fail("it is too large")) };
        let now = colours.nearest_of(pixels.pixels());
        out.add(now, (width, height), delay, &colours.table).map_err(|error| show.fail(error))?;
    }
    let encoder = out.encoder.ok_or_else(|| show.fail("it has no frame"))?;
    encoder.into_inner().map_err(|error| show.fail(error))
}

/// What is written, and the frame before.
struct Out {
    encoder: Option<Encoder<Vec<u8>>>,
    before: Vec<u8>,
}

impl Out {
    fn add(
        &mut self,
        now: Vec<u8>,
        size: (u16, u16),
        delay: u16,
        table: &[[u8; 3]],
    ) -> Result<(), gif::EncodingError> {
        let (width, height) = (usize::from(size.0), usize::from(size.1));
        let whole = Part { left: 0, top: 0, width, height };
        let (part, pixels, encoder) = match &mut self.encoder {
            Some(encoder) => {
                let part = Part::changed(&self.before, &now, width);
                (part, part.pixels(&self.before, &now, width, SAME), encoder)
            }
            none => {
                let mut encoder = Encoder::new(Vec::new(), size.0, size.1, table.as_flattened())?;
                encoder.set_repeat(Repeat::Infinite)?;
                (whole, now.clone(), none.insert(encoder))
            }
        };
        let side = |side: usize| u16::try_from(side).unwrap_or(u16::MAX);
        encoder.write_frame(&Frame {
            delay,
            dispose: DisposalMethod::Keep,
            transparent: Some(SAME),
            left: side(part.left),
            top: side(part.top),
            width: side(part.width),
            height: side(part.height),
            buffer: pixels.into(),
            ..Frame::default()
        })?;
        self.before = now;
        Ok(())
    }
}

/// The colours of a picture in their order, behind a place for pixels that stay, and which is the nearest to others.
struct Colours {
    table: Vec<[u8; 3]>,
    known: HashMap<[u8; 3], u8>,
}

impl Colours {
    fn of(theme: Theme) -> Self {
        let palette = Palette::on_screen(theme);
        let paper = palette.rgb(Role::Paper);
        let mut table = vec![paper];
        let mixed = (1..=MIXTURES).flat_map(|part| INKS.map(|ink| mixture(palette.rgb(ink), paper, part)));
        for colour in AREAS.map(|area| palette.rgb(area)).into_iter().chain(mixed) {
            if !table[1..].contains(&colour) {
                table.push(colour);
            }
        }
        Self { table, known: HashMap::new() }
    }

    fn nearest_of(&mut self, pixels: &[PremultipliedColorU8]) -> Vec<u8> {
        // most pixels are as the one before
        let mut before = (PremultipliedColorU8::TRANSPARENT, SAME);
        let of = |pixel: &PremultipliedColorU8| {
            if *pixel != before.0 {
                before = (*pixel, self.nearest([pixel.red(), pixel.green(), pixel.blue()]));
            }
            before.1
        };
        pixels.iter().map(of).collect()
    }

    fn nearest(&mut self, colour: [u8; 3]) -> u8 {
        let table = &self.table;
        *self.known.entry(colour).or_insert_with(|| {
            let from = |i: &u8| {
                let own = table[usize::from(*i)];
                own.iter().zip(colour).map(|(a, b)| u32::from(a.abs_diff(b)).pow(2)).sum::<u32>()
            };
            let all = 1..u8::try_from(table.len()).unwrap_or(u8::MAX);
            all.min_by_key(from).unwrap_or(1)
        })
    }
}

/// Parts of ink, the others of paper.
fn mixture(ink: [u8; 3], paper: [u8; 3], part: u8) -> [u8; 3] {
    let (part, all) = (u16::from(part), u16::from(MIXTURES));
    std::array::from_fn(|i| {
        let sum = u16::from(ink[i]) * part + u16::from(paper[i]) * (all - part);
        u8::try_from((sum + all / 2) / all).unwrap_or(u8::MAX)
    })
}
