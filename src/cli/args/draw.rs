//! Arguments of `draw`.

use super::report::LanguageArg;
use super::setting;
use crate::cli::error::CliError;
use assur_check::Overrides;
use assur_drawing::{Scale, Theme};
use assur_picture::{ArrowKind, KINDS, Kind, Loads, SCALED, Scaled};
use clap::ValueEnum;

/// Frames of a GIF or an APNG, its width in pixels, and its time in hundredths of a second.
const FILM_FRAMES: usize = 48;
const FILM_WIDTH: u16 = 640;
const FILM_TIME: u32 = 600;

/// Arguments of `draw`.
#[derive(Clone, Debug, clap::Args)]
pub struct Draw {
    /// Files to draw, and the pictures wanted: `scheme`, `velocities`, `accelerations`, `forces`, `lever`, `axial`,
    /// `friction`, `curvature`, `train`, `plot "omega(rocker), Mb"`, `work`, `fourier`, `internal`, `planes`, `equilibrium`, `cam`, `gears`, `elements`, `hodograph rod.S`, `polar B`, `animation`
    /// [default: the first that the file has: mostly scheme]
    #[arg(required = true, value_name = "FILES PICTURES")]
    pub names: Vec<String>,
    /// Write one picture to this file (.svg, .png, .pdf, .gif, .apng, .dxf, .tikz, .tex), all to this page (.html), or to files in this folder
    /// (created only when complete) [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    pub out: Option<String>,
    /// Format: of the picture on standard output, or of all files in the folder OUT; html is a page with all pictures
    /// [default: that of the ending of OUT, else svg]
    #[arg(long, value_enum, value_name = "FORMAT")]
    pub format: Option<DrawFormat>,
    /// Draw the pose of this name; may be repeated [default: all of a list, the first and the last of a motion under loads, the first of a sweep]
    #[arg(long, value_name = "NAME")]
    pub pose: Vec<String>,
    /// Draw this number of other poses pale behind the scheme
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub ghosts: usize,
    /// Draw the path of this point over the way of the drive; may be repeated
    #[arg(long, value_name = "LINK.POINT")]
    pub path: Vec<String>,
    /// Show the lengths and offsets that the file gives by name, as dimension lines of the scheme
    #[arg(long)]
    pub dimensions: bool,
    /// Show the numbers of loads and efforts next to them, and arrows of forces in proportion
    #[arg(long)]
    pub numbers: bool,
    /// Draw a DXF in the millimetres of the mechanism: joints, axes, circles, profiles and paths, without symbols
    #[arg(long, conflicts_with_all = ["ghosts", "dimensions", "numbers", "loads", "size", "scale"])]
    pub true_size: bool,
    /// Number of frames of an animation [default: 48 in GIF and APNG, up to 400 in others]
    #[arg(long, value_name = "N", value_parser = frames)]
    pub frames: Option<usize>,
    /// Width of a GIF or an APNG, pixels [default: 640]
    #[arg(long, value_name = "PIXELS", value_parser = clap::value_parser!(u16).range(40..=4000))]
    pub width: Option<u16>,
    /// Time that a GIF or an APNG takes for all its frames [default: 6s]
    #[arg(long, value_name = "TIME", value_parser = time)]
    pub time: Option<Hundredths>,
    /// Arrows that the page of an animation shows first, in one scale over all frames
    #[arg(long, value_enum, value_name = "KIND")]
    pub arrows: Option<ArrowsArg>,
    /// Space for the mechanism or the plan, mm
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<(f64, f64)>,
    /// Scale factors in SI units per mm of `length`, `velocity`, `acceleration`, `force`: 1, 2, 2.5, 4 or 5 times a power of
    /// ten, e.g. length=0.005,velocity=0.02 [default: the smallest that fit]
    #[arg(long, value_name = "KIND=FACTOR", value_delimiter = ',', value_parser = scale)]
    pub scale: Vec<(Scaled, Scale)>,
    /// Draw every picture that the file declares the effects for
    #[arg(long)]
    pub all: bool,
    /// Show all loads, without unknown efforts, or none
    #[arg(long, value_enum, value_name = "WHICH", default_value_t = LoadsArg::All)]
    pub loads: LoadsArg,
    /// Colours: light that turns dark where the reader prefers it, light, dark, or black and white
    #[arg(long, value_enum, value_name = "THEME", default_value_t = ThemeArg::Auto)]
    pub theme: ThemeArg,
    /// Language of the words in pictures, with the letters of its courses
    #[arg(long = "lang", value_enum, value_name = "LANGUAGE", default_value_t = LanguageArg::En)]
    pub language: LanguageArg,
    /// Draw with the rows of this table of variants, or with those that `--row` names
    #[arg(long, value_name = "TABLE.csv")]
    pub variants: Option<String>,
    /// Draw with the row of this name or number, of `--variants` or of the file's own table; may be repeated
    #[arg(long, value_name = "ROW")]
    pub row: Vec<String>,
    /// Replace the value of a `given`, e.g. `--set r=120mm`; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
}

impl Draw {
    /// The pictures wanted, and the names of the files. What comes after `plot`, `hodograph` and `polar` is what they show,
    /// unless it names a file or another picture.
    #[must_use]
    pub fn pictures(&self) -> (Vec<Picture>, Vec<String>) {
        let (mut pictures, mut files) = (Vec::<Picture>::new(), Vec::new());
        let mut names = self.names.iter().peekable();
        while let Some(name) = names.next() {
            let Some(kind) = Kind::named(name) else {
                files.push(name.clone());
                continue;
            };
            let of =
                names.next_if(|next| kind.names_something() && !is_file(next) && Kind::named(next).is_none());
            let picture = Picture { kind, of: of.cloned().unwrap_or_default() };
            if !pictures.contains(&picture) {
                pictures.push(picture);
            }
        }
        if self.all {
            pictures = KINDS.into_iter().map(Picture::from).collect();
        }
        if pictures.is_empty() {
            pictures.push(Kind::Scheme.into());
        }
        (pictures, files)
    }

    /// How pictures are chosen.
    #[must_use]
    pub fn choice(&self) -> Choice {
        match self.names.iter().any(|name| Kind::named(name).is_some()) {
            _ if self.all => Choice::All,
            true => Choice::Named,
            false => Choice::First,
        }
    }

    /// The first option that changes no picture that is wanted.
    #[must_use]
    pub fn without_effect(&self, pictures: &[Picture]) -> Option<CliError> {
        let of = |option: &str, is_of: &dyn Fn(Kind) -> bool| {
            if pictures.iter().any(|picture| is_of(picture.kind)) {
                return None;
            }
            let kinds =
                KINDS.into_iter().filter(|kind| is_of(*kind)).map(|kind| format!("`{}`", kind.name()));
            let kinds = kinds.collect::<Vec<_>>().join(", ");
            Some(CliError::NoEffect { option: option.to_owned(), help: format!("it is for {kinds}") })
        };
        let scheme_options = [
            (self.ghosts > 0, "--ghosts"),
            (!self.path.is_empty(), "--path"),
            (self.loads != LoadsArg::All, "--loads"),
            (self.dimensions, "--dimensions"),
            (self.numbers, "--numbers"),
            (self.true_size, "--true-size"),
        ];
        let given = scheme_options.into_iter().filter(|(is_given, _)| *is_given);
        let of_scheme = || given.clone().find_map(|(_, option)| of(option, &|kind| kind == Kind::Scheme));
        let of_frames = || self.frames.and_then(|_| of("--frames", &|kind| kind == Kind::Animation));
        let of_arrows = || self.arrows.and_then(|_| of("--arrows", &|kind| kind == Kind::Animation));
        let shows = |kind: Kind, what| {
            kind.has_scale(what) || what == Scaled::Force && kind == Kind::Scheme && self.numbers
        };
        let mut scales = self.scale.iter().map(|(what, _)| *what);
        let mut of_scales =
            || scales.find_map(|what| of(&format!("--scale {}", what.name()), &|kind| shows(kind, what)));
        let of_numbers = || {
            let help = "`--loads none` leaves out all that has a number".to_owned();
            let is_none = self.numbers && self.loads == LoadsArg::None;
            is_none.then(|| CliError::NoEffect { option: "--numbers".to_owned(), help })
        };
        let of_pose =
            || of("--pose", &|kind| kind.needs().place.is_of_position()).filter(|_| !self.pose.is_empty());
        let of_size = || of("--size", &Kind::has_size).filter(|_| self.size.is_some());
        of_scheme()
            .or_else(of_pose)
            .or_else(of_size)
            .or_else(of_frames)
            .or_else(of_arrows)
            .or_else(&mut of_scales)
            .or_else(of_numbers)
    }

    /// The number of frames of an animation in a format, where there is one that is wanted.
    #[must_use]
    pub fn frames_in(&self, format: Option<DrawFormat>) -> Option<usize> {
        self.frames.or_else(|| format.is_some_and(DrawFormat::is_film).then_some(FILM_FRAMES))
    }

    /// The width of a GIF or an APNG, pixels.
    #[must_use]
    pub fn film_width(&self) -> u16 {
        self.width.unwrap_or(FILM_WIDTH)
    }

    /// The time of a GIF or an APNG.
    #[must_use]
    pub fn time_in_hundredths(&self) -> u32 {
        self.time.map_or(FILM_TIME, |Hundredths(time)| time)
    }

    /// The values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
    }
}

/// How pictures are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    Named,
    /// All that a file has.
    All,
    /// The first that it has: the scheme, where it has a position.
    First,
}

impl From<Kind> for Picture {
    fn from(kind: Kind) -> Self {
        Self { kind, of: String::new() }
    }
}

/// A picture that is wanted.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// Its kind.
    pub kind: Kind,
    /// What it shows: numbers of a plot, a point, a pair; empty where nothing is named.
    pub of: String,
}

/// Whether an argument names a file or a folder.
fn is_file(name: &str) -> bool {
    name == "-" || name.ends_with(".mech") || std::path::Path::new(name).exists()
}

/// A format of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum DrawFormat {
    /// Lines and letters; an animation moves without a script
    Svg,
    /// One page
    Html,
    /// Pixels, in builds with the feature png
    Png,
    /// A page of the size of the drawing, in builds with the feature pdf
    Pdf,
    /// An animation in about 30 colours, in builds with the feature gif
    Gif,
    /// An animation in true colour, in builds with the feature gif
    Apng,
    /// A drawing for CAD: DXF R12
    Dxf,
    /// A picture for a LaTeX document
    Tikz,
    /// A LaTeX document with the picture
    Tex,
}

impl DrawFormat {
    /// That of the ending of a name.
    #[must_use]
    pub fn of_ending(name: &str) -> Option<Self> {
        Self::value_variants().iter().copied().find(|format| name.ends_with(format.ending()))
    }

    /// The feature that it needs and that this build does not have.
    #[must_use]
    pub const fn missing_feature(self) -> Option<&'static str> {
        match self {
            Self::Png if !cfg!(feature = "png") => Some("png"),
            Self::Pdf if !cfg!(feature = "pdf") => Some("pdf"),
            Self::Gif | Self::Apng if !cfg!(feature = "gif") => Some("gif"),
            _ => None,
        }
    }

    /// Whether it has the frames of an animation, one after the other.
    #[must_use]
    pub const fn is_film(self) -> bool {
        matches!(self, Self::Gif | Self::Apng)
    }

    /// Whether it is no text.
    #[must_use]
    pub const fn is_binary(self) -> bool {
        matches!(self, Self::Png | Self::Pdf) || self.is_film()
    }

    /// The ending of its files.
    #[must_use]
    pub const fn ending(self) -> &'static str {
        match self {
            Self::Svg => ".svg",
            Self::Html => ".html",
            Self::Png => ".png",
            Self::Pdf => ".pdf",
            Self::Gif => ".gif",
            Self::Apng => ".apng",
            Self::Dxf => ".dxf",
            Self::Tikz => ".tikz",
            Self::Tex => ".tex",
        }
    }
}

/// Which loads are shown.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum LoadsArg {
    /// Loads, weights and unknown efforts
    All,
    /// Without unknown efforts
    Given,
    /// None
    None,
}

impl From<LoadsArg> for Loads {
    fn from(which: LoadsArg) -> Self {
        match which {
            LoadsArg::All => Self::All,
            LoadsArg::Given => Self::Given,
            LoadsArg::None => Self::None,
        }
    }
}

/// Which arrows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ArrowsArg {
    /// Of points
    Velocities,
    /// Of points
    Accelerations,
    /// Forces in pairs
    Reactions,
    /// Loads, weights, springs, unknown efforts
    Loads,
}

impl From<ArrowsArg> for ArrowKind {
    fn from(which: ArrowsArg) -> Self {
        match which {
            ArrowsArg::Velocities => Self::Velocities,
            ArrowsArg::Accelerations => Self::Accelerations,
            ArrowsArg::Reactions => Self::Reactions,
            ArrowsArg::Loads => Self::Loads,
        }
    }
}

/// Which colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ThemeArg {
    /// Light, dark where the reader prefers it
    Auto,
    /// Light
    Light,
    /// Dark
    Dark,
    /// Black and white
    Mono,
}

impl From<ThemeArg> for Theme {
    fn from(theme: ThemeArg) -> Self {
        match theme {
            ThemeArg::Auto => Self::Auto,
            ThemeArg::Light => Self::Light,
            ThemeArg::Dark => Self::Dark,
            ThemeArg::Mono => Self::Mono,
        }
    }
}

fn scale(text: &str) -> Result<(Scaled, Scale), String> {
    let example = "write KIND=FACTOR, e.g. length=0.005";
    let (name, factor) = text.split_once('=').ok_or(example)?;
    let name = name.trim();
    let Some(of) = SCALED.into_iter().find(|of| of.name() == name) else {
        let kinds = SCALED.map(Scaled::name).join(", ");
        return Err(format!("`{name}` has no scale: write {kinds}"));
    };
    let number = factor.trim().parse::<f64>().ok().filter(|x| (1e-30..=1e30).contains(x)).ok_or(example)?;
    match Scale::fitting(number, 1.0) {
        Some(scale) if (scale.factor() - number).abs() <= 1e-9 * number => Ok((of, scale)),
        Some(next) => Err(format!(
            "a scale factor is 1, 2, 2.5, 4 or 5 times a power of ten: write {name}={}",
            next.written()
        )),
        None => Err(example.to_owned()),
    }
}

fn frames(text: &str) -> Result<usize, String> {
    let count = text.parse::<usize>().ok().filter(|count| (2..=10_000).contains(count));
    count.ok_or_else(|| "write a number from 2 to 10000".to_owned())
}

/// A time in hundredths of a second.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Hundredths(pub u32);

fn time(text: &str) -> Result<Hundredths, String> {
    let number = |text: &str| text.trim_end().parse::<f64>().ok();
    let seconds = match text.strip_suffix("ms") {
        Some(rest) => number(rest).map(|x| 0.001 * x),
        None => text.strip_suffix('s').and_then(number),
    };
    let hundredths =
        seconds.map(|seconds| (100.0 * seconds).round()).filter(|x| (10.0..=60_000.0).contains(x));
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // bounded
    let time = hundredths.map(|x| Hundredths(x as u32));
    time.ok_or_else(|| "write a time from 0.1s to 600s, e.g. 6s or 500ms".to_owned())
}

fn size(text: &str) -> Result<(f64, f64), String> {
    let side = |text: &str| text.trim().parse::<f64>().ok().filter(|x| (60.0..=2000.0).contains(x));
    let sides = text.split_once(['x', '×']).and_then(|(w, h)| Some((side(w)?, side(h)?)));
    sides.ok_or_else(|| "write two numbers from 60 to 2000, e.g. 180x120".to_owned())
}
