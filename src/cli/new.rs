//! `assur new`

use super::args::{New, StartKind};
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use assur_text::source::shown_in_line;
use std::fs::File;
use std::io::{ErrorKind, Write};
use std::path::Path;

/// The file of a kind.
const fn text(kind: StartKind) -> &'static str {
    match kind {
        StartKind::FourBar => include_str!("start/four-bar.mech"),
        StartKind::CrankSlider => include_str!("start/crank-slider.mech"),
        StartKind::SixBar => include_str!("start/six-bar.mech"),
        StartKind::Train => include_str!("start/train.mech"),
        StartKind::Cam => include_str!("start/cam.mech"),
    }
}

/// Writes a file to start from, unless there is one of that name.
pub fn run(args: &New, screen: &Screen) -> Status {
    let name = &args.name;
    let path = if name.ends_with(".mech") { name.clone() } else { format!("{name}.mech") };
    match create(&path, text(args.kind)) {
        Ok(()) => {
            let shown = shown_in_line(&path);
            Status::printed(screen.print(format!("wrote {shown}; solve it with: assur solve {shown}\n")))
        }
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

/// The folder of a file that is not there.
fn folder(path: &str) -> String {
    let folder = Path::new(path).parent();
    folder.map(|folder| folder.display().to_string()).unwrap_or_default()
}

fn create(path: &str, text: &str) -> Result<(), CliError> {
    let name = || path.to_owned();
    let created = File::options().write(true).create_new(true).open(path);
    let mut file = created.map_err(|error| match error.kind() {
        ErrorKind::AlreadyExists => CliError::Exists { name: name() },
        ErrorKind::NotFound => CliError::NoFolder { name: folder(path) },
        _ => CliError::NotCreated { name: name(), why: error.to_string() },
    })?;
    file.write_all(text.as_bytes()).map_err(|error| {
        // half a file is of no use; the error is reported in any case
        let _ = std::fs::remove_file(path);
        CliError::NotCreated { name: name(), why: error.to_string() }
    })
}
