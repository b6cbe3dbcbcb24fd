//! Arguments of `draw`.

use super::setting;
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_picture::{Kind, Loads};
use clap::ValueEnum;

/// Arguments of `draw`.
#[derive(Clone, Debug, clap::Args)]
pub struct Draw {
    /// Files to draw, and the pictures wanted: `scheme`, `plot "omega(rocker), Mb"`, … [default: scheme]
    #[arg(required = true, value_name = "FILES PICTURES")]
    pub names: Vec<String>,
    /// Write to this file (.svg), or to files in this folder (created only when complete) [default: standard output]
    #[arg(short, long, value_name = "OUT")]
    pub out: Option<String>,
    /// Draw the pose of this name; may be repeated [default: the first]
    #[arg(long, value_name = "NAME")]
    pub pose: Vec<String>,
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
    /// The pictures wanted, and the names of the files. What stands behind `plot`, `hodograph` and `polar` is what they show,
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
        if pictures.is_empty() {
            pictures.push(Picture { kind: Kind::Scheme, of: String::new() });
        }
        (pictures, files)
    }

    /// The values from outside.
    #[must_use]
    pub fn overrides(&self) -> Overrides {
        Overrides::set(self.settings.clone())
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
