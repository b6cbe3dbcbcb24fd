//! Frames of an animation in pixels, and what GIF and APNG have in common: the changed rectangle, the time of a frame.

use super::pages::Page;
use super::png::options;
use crate::cli::args::Draw;
use crate::cli::error::CliError;
use assur_drawing::{Palette, Role, Theme};
use assur_picture::Film;
use resvg::tiny_skia::{Color, Pixmap, Transform};
use resvg::usvg::{Options, Tree};

/// How an animation is shown.
pub struct Show<'f> {
    pub film: &'f Film,
    pub theme: Theme,
    /// Width in pixels.
    pub width: u16,
    /// Time of all frames, in hundredths of a second.
    pub time: u32,
    /// The name of what is written.
    pub name: &'f str,
}

impl<'f> Show<'f> {
    /// A page's film as the options say.
    pub fn of(page: &'f Page, args: &Draw, name: &'f str) -> Option<Self> {
        let (width, time) = (args.film_width(), args.time_in_hundredths());
        page.film.as_ref().map(|film| Self { film, theme: args.theme.into(), width, time, name })
    }

    /// An error with its reason.
    pub fn fail(&self, why: impl ToString) -> CliError {
        CliError::NotCreated { name: self.name.to_owned(), why: why.to_string() }
    }

    /// All frames, of one size.
    pub fn frames(&self) -> Result<impl Iterator<Item = Result<Pixmap, CliError>>, CliError> {
        let options = options(self.name)?;
        Ok((0..self.film.count()).map(move |frame| self.drawn(&self.film.frame(frame), &options)))
    }

    fn drawn(&self, svg: &str, options: &Options<'_>) -> Result<Pixmap, CliError> {
        let tree = Tree::from_str(svg, options).map_err(|error| self.fail(error))?;
        let factor = f32::from(self.width) / tree.size().width();
        let height = (tree.size().height() * factor).ceil();
        #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
        // saturates, and is no picture then
        let pixels = Pixmap::new(self.width.into(), height as u32).filter(|_| height <= f32::from(u16::MAX));
        let mut pixels = pixels.ok_or_else(|| self.fail("it is too large"))?;
        let [red, green, blue] = Palette::on_screen(self.theme).rgb(Role::Paper);
        // the last line of pixels is seldom covered in full
        pixels.fill(Color::from_rgba8(red, green, blue, u8::MAX));
        resvg::render(&tree, Transform::from_scale(factor, factor), &mut pixels.as_mut());
        Ok(pixels)
    }

    /// The times of the frames in hundredths of a second, which add up to that of all.
    pub fn delays(&self) -> impl Iterator<Item = u16> {
        let (time, count) = (u64::from(self.time), self.film.count() as u64);
        let until = move |frame: u64| time * frame / count;
        (0..count).map(move |frame| u16::try_from(until(frame + 1) - until(frame)).unwrap_or(u16::MAX))
    }
}

/// A rectangle of pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part {
    pub left: usize,
    pub top: usize,
    pub width: usize,
    pub height: usize,
}

impl Part {
    /// The least that has all pixels which two pictures of a width differ by; one pixel where they are the same.
    pub fn changed<P: PartialEq>(before: &[P], now: &[P], width: usize) -> Self {
        let differs = |(a, b): (&P, &P)| a != b;
        let (mut across, mut down) = ([usize::MAX, 0], [usize::MAX, 0]);
        for (y, (before, now)) in before.chunks(width).zip(now.chunks(width)).enumerate() {
            let Some(first) = before.iter().zip(now).position(differs) else { continue };
            let last = before.iter().zip(now).rposition(differs).unwrap_or(first);
            across = [across[0].min(first), across[1].max(last)];
            down = [down[0].min(y), y];
        }
        if down[0] > down[1] {
            return Self { left: 0, top: 0, width: 1, height: 1 };
        }
        let [width, height] = [across, down].map(|[first, last]| last - first + 1);
        Self { left: across[0], top: down[0], width, height }
    }

    /// Its pixels in a picture of a width; those that are as before are `same`.
    pub fn pixels<P: PartialEq + Copy>(&self, before: &[P], now: &[P], width: usize, same: P) -> Vec<P> {
        let lines = (self.top..self.top + self.height).map(|y| y * width + self.left);
        let lines = lines.map(|at| (&before[at..at + self.width], &now[at..at + self.width]));
        let of_line = |(before, now): (&[P], &[P])| {
            let kept = before.iter().zip(now).map(|(a, b)| if a == b { same } else { *b });
            kept.collect::<Vec<P>>()
        };
        lines.flat_map(of_line).collect()
    }
}
