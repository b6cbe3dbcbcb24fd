//! Arguments of `course`.

use super::report::{LanguageArg, part};
use super::{setting, threads, tolerance};
use crate::exercise::grade::{Credit, Points};
use crate::handout::course::{Picture, Steps};
use assur_check::Overrides;
use clap::ValueEnum;

/// Arguments of `course`.
#[derive(Clone, Debug, clap::Args)]
pub struct Course {
    /// The learning platform
    #[arg(value_enum, value_name = "PLATFORM")]
    pub platform: Platform,
    /// Files, folders, globs, or `-` for standard input: one question per row of variants
    #[arg(required = true, value_name = "FILES")]
    pub files: Vec<String>,
    /// Write the questions to this file [default: standard output]; of PrairieLearn to this folder (created only when complete)
    #[arg(short, long, value_name = "OUTPUT")]
    pub out: Option<String>,
    /// In Moodle: write a numerical question with units for every answer, in place of one question with gaps
    #[arg(long)]
    pub one_per_answer: bool,
    /// With --one-per-answer: the part of the mark that a missing or wrong unit costs, from 0 to 1 [default: 1]
    #[arg(long, value_name = "PART", value_parser = unit_penalty, requires = "one_per_answer")]
    pub unit_penalty: Option<f64>,
    /// Category of the questions; each problem has its own below it [default: the folder's name]
    #[arg(long, value_name = "NAME")]
    pub category: Option<String>,
    /// Show these parts of the worked solution after an answer, e.g. 3,6 as in `report`; `all` with pictures, or `none`
    #[arg(long, value_name = "PARTS", default_value = "all", value_parser = steps)]
    pub steps: Steps,
    /// Pictures: svg, png (900 pixels wide) or none
    #[arg(long, value_enum, value_name = "FORMAT", default_value_t = PictureArg::Svg)]
    pub picture: PictureArg,
    /// Maximum difference, relative to the value
    #[arg(long, value_name = "TOLERANCE", default_value = "3%", value_parser = tolerance)]
    pub within: f64,
    /// Give quantities points, as in 'Mb=2,F_A=1'; `*` is for all others, 0 leaves one out; may be repeated
    #[arg(long, value_name = "NAME=POINTS,…", value_parser = Points::read)]
    pub points: Vec<Points>,
    /// Give a part of the points for a slip, as in sign=0.5,unit=0.25; may be repeated
    #[arg(long, value_name = "SLIP=PART,…", value_parser = Credit::read)]
    pub credit: Vec<Credit>,
    /// Ask at the position of this name [default: all that the sheet asks at]
    #[arg(long, value_name = "NAME")]
    pub pose: Option<String>,
    /// Ask at the positions of these names alone, e.g. `--positions 1,4,8`
    #[arg(long, value_name = "NAMES", value_delimiter = ',', conflicts_with = "pose")]
    pub positions: Vec<String>,
    /// Take the rows of this table of variants in place of the file's own
    #[arg(long, value_name = "TABLE.csv")]
    pub variants: Option<String>,
    /// Take the row of this name or number; may be repeated [default: all rows]
    #[arg(long, value_name = "ROW")]
    pub row: Vec<String>,
    /// Replace the value of a `given`, e.g. `--set r=120mm`; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
    /// Language of the sentences, with the letters of its courses
    #[arg(long = "lang", value_enum, value_name = "LANGUAGE", default_value_t = LanguageArg::En)]
    pub language: LanguageArg,
    /// Number of threads [default: all processors]
    #[arg(long, value_name = "N", value_parser = threads)]
    pub threads: Option<usize>,
}

/// A learning platform.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Platform {
    /// Moodle XML
    Moodle,
    /// Folders of questions with all rows
    #[value(name = "prairielearn")]
    PrairieLearn,
}

/// Pictures of questions.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum PictureArg {
    /// Sharp at every size
    Svg,
    /// Pixels
    Png,
    /// No pictures
    None,
}

impl From<PictureArg> for Picture {
    fn from(picture: PictureArg) -> Self {
        match picture {
            PictureArg::Svg => Self::Svg,
            PictureArg::Png => Self::Png,
            PictureArg::None => Self::None,
        }
    }
}

impl Course {
    /// Values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
    }
}

fn steps(text: &str) -> Result<Steps, String> {
    match text.trim() {
        "all" => Ok(Steps::All),
        "none" => Ok(Steps::None),
        list => list.split(',').map(part).collect::<Result<_, _>>().map(Steps::Parts),
    }
}

/// The part of a mark that a unit costs.
fn unit_penalty(text: &str) -> Result<f64, String> {
    let part = text.parse().ok().filter(|part| (0.0..=1.0).contains(part));
    part.ok_or_else(|| "write a part from 0 to 1, as in 0.5".to_owned())
}
