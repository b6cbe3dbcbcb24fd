//! Arguments of `draw`.

use super::setting;
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_picture::{KINDS, Kind, Loads};
use clap::ValueEnum;

/// Arguments of `draw`.
#[derive(Clone, Debug, clap::Args)]
pub struct Draw {
    /// Files to draw, and the pictures wanted: `scheme`, `velocities`, `accelerations`, `forces`, `lever`, `friction`,
    /// `train` [default: scheme]
    #[arg(required = true, value_name = "FILES PICTURES")]
    pub names: Vec<String>,
    /// Write one picture to this file (.svg), all to this page (.html), or to files in this folder (created only when
    /// complete) [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    pub out: Option<String>,
    /// Draw the pose of this name; may be repeated [default: the first]
    #[arg(long, value_name = "NAME")]
    pub pose: Vec<String>,
    /// Draw this number of other poses pale behind the scheme
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub ghosts: usize,
    /// Draw the path of this point over the way of the drive; may be repeated
    #[arg(long, value_name = "LINK.POINT")]
    pub path: Vec<String>,
    /// Space for the mechanism or the plan, mm
    #[arg(long, value_name = "WIDTHxHEIGHT", value_parser = size)]
    pub size: Option<(f64, f64)>,
    /// Draw every picture that the file declares the effects for
    #[arg(long)]
    pub all: bool,
    /// Show all loads, without unknown efforts, or none
    #[arg(long, value_enum, value_name = "WHICH", default_value_t = LoadsArg::All)]
    pub loads: LoadsArg,
    /// Colours: light that turns dark where the reader prefers it, light, dark, or black and white
    #[arg(long, value_enum, value_name = "THEME", default_value_t = ThemeArg::Auto)]
    pub theme: ThemeArg,
    /// Replace the value of a `given`, e.g. `--set r=120mm`; may be repeated
    #[arg(long = "set", value_name = "NAME=VALUE", value_parser = setting)]
    pub settings: Vec<(String, String)>,
}

impl Draw {
    /// The pictures wanted, and the names of the files.
    #[must_use]
    pub fn kinds(&self) -> (Vec<Kind>, Vec<String>) {
        let (mut kinds, mut files) = (Vec::new(), Vec::new());
        for name in &self.names {
            match Kind::named(name) {
                Some(kind) if kinds.contains(&kind) => {}
                Some(kind) => kinds.push(kind),
                None => files.push(name.clone()),
            }
        }
        if self.all {
            kinds = KINDS.to_vec();
        }
        if kinds.is_empty() {
            kinds.push(Kind::Scheme);
        }
        (kinds, files)
    }

    /// The values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
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

fn size(text: &str) -> Result<(f64, f64), String> {
    let side = |text: &str| text.trim().parse::<f64>().ok().filter(|x| (60.0..=2000.0).contains(x));
    let sides = text.split_once(['x', '×']).and_then(|(w, h)| Some((side(w)?, side(h)?)));
    sides.ok_or_else(|| "write two numbers from 60 to 2000, e.g. 180x120".to_owned())
}
