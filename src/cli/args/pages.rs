//! The manual of commands with few options.

use clap::ValueEnum;
use clap::builder::NonEmptyStringValueParser;

/// Arguments of `explain`.
#[derive(Clone, Debug, clap::Args)]
pub struct Explain {
    /// Code of a diagnostic, e.g. `mech::assembly::ambiguous`; `mech::` may be left out
    #[arg(required_unless_present = "all", value_name = "CODE")]
    pub code: Option<String>,
    /// List all codes
    #[arg(long, conflicts_with = "code")]
    pub all: bool,
}

/// Arguments of `new`.
#[derive(Clone, Debug, clap::Args)]
pub struct New {
    /// Name of the file; the ending `.mech` may be left out
    #[arg(value_name = "NAME", value_parser = NonEmptyStringValueParser::new())]
    pub name: String,
    /// The mechanism in it
    #[arg(long, value_enum, default_value_t = StartKind::FourBar)]
    pub kind: StartKind,
}

/// The mechanisms to start from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum StartKind {
    /// A four-bar linkage with masses and a load
    FourBar,
    /// A crank-slider with masses and a gas force
    CrankSlider,
    /// A four-bar that moves a ram
    SixBar,
    /// Gears, a drum and a rope
    Train,
    /// A cam, its follower and a spring
    Cam,
}

/// Arguments of `help`.
#[derive(Clone, Debug, clap::Args)]
pub struct Help {
    /// `functions`, `units`, `statements`, or a command
    #[arg(value_name = "TOPIC")]
    pub topic: Option<String>,
}

/// Arguments of `info`.
#[derive(Clone, Debug, clap::Args)]
pub struct Info {
    /// Output format
    #[arg(long, value_enum, default_value_t = InfoFormat::Text)]
    pub format: InfoFormat,
}

/// A form of what a build can do.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum InfoFormat {
    /// Lines to read
    Text,
    /// One object
    Json,
}

/// Arguments of `completions`.
#[derive(Clone, Debug, clap::Args)]
pub struct Completions {
    /// The shell
    #[arg(value_enum, value_name = "SHELL")]
    pub shell: clap_complete::Shell,
}

/// Arguments of `man`.
#[derive(Clone, Debug, clap::Args)]
pub struct Man {
    /// A command; the whole program where it is left out
    #[arg(value_name = "COMMAND")]
    pub command: Option<String>,
}

/// Arguments of `preview`.
#[derive(Clone, Debug, clap::Args)]
pub struct Preview {
    /// The file to show
    #[arg(value_name = "FILE")]
    pub file: String,
    /// Port of the page on this machine [default: one that is free]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub port: Option<u16>,
    /// Print the address and open no browser
    #[arg(long)]
    pub no_open: bool,
}

/// Arguments of `lsp`: none.
#[cfg(feature = "lsp")]
#[derive(Clone, Debug, clap::Args)]
pub struct Lsp {}
