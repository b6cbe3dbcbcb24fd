//! Whether pictures and options fit the format.

use crate::cli::args::{Draw, DrawFormat, Picture, ThemeArg};
use crate::cli::error::CliError;
use assur_picture::Kind;

/// The most frames of a second: many programs show frames of less than 2/100 s slowly.
const RATE: u32 = 50;

/// Why GIF and APNG cannot show what is asked for.
pub fn no_film(format: DrawFormat, place: &str, args: &Draw, pictures: &[Picture]) -> Option<CliError> {
    if !format.is_film() {
        return None;
    }
    if let Some(picture) = pictures.iter().find(|picture| picture.kind != Kind::Animation) {
        let ending = format.ending();
        let out = match &args.out {
            Some(out) => format!("-o {out}"),
            None => format!("--format {}", ending.trim_start_matches('.')),
        };
        let file = args.pictures().1.first().map_or_else(|| "FILE".to_owned(), Clone::clone);
        let (name, picture) = (place.to_owned(), picture.kind.name());
        return Some(CliError::NotAnimation { name, ending, picture, file, out });
    }
    let (frames, time) = (args.frames_in(Some(format)).unwrap_or_default(), args.time_in_hundredths());
    let most = time * RATE / 100;
    (frames > most as usize).then_some(CliError::TooFast { frames, time: f64::from(time) / 100.0, most })
}

/// The first option that changes nothing in a format.
pub fn without_effect(format: Option<DrawFormat>, args: &Draw) -> Option<CliError> {
    let is_dxf = format == Some(DrawFormat::Dxf);
    let is_film = format.is_some_and(DrawFormat::is_film);
    let of_films = "it is for GIF and APNG: `-o NAME.gif`, or `--format gif`";
    let options = [
        (args.true_size && !is_dxf, "--true-size", "it is for DXF: `-o NAME.dxf`, or `--format dxf`"),
        (args.theme != ThemeArg::Auto && is_dxf, "--theme", "the colours of DXF are those of its layers"),
        (args.width.is_some() && !is_film, "--width", of_films),
        (args.time.is_some() && !is_film, "--time", of_films),
        (args.arrows.is_some() && is_film, "--arrows", "the page of an animation has arrows: `-o NAME.html`"),
    ];
    let (_, option, help) = options.into_iter().find(|(is_idle, ..)| *is_idle)?;
    Some(CliError::NoEffect { option: option.to_owned(), help: help.to_owned() })
}
