//! `assur explain`

use super::args::Explain;
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use assur_text::diagnostic::{CODES, did_you_mean, explain};

/// Prints the page of a code, which may be given by a part of it, or lists all codes.
pub fn run(args: &Explain, screen: &Screen) -> Status {
    let Some(code) = &args.code else {
        let list: String = CODES.iter().map(|c| format!("{}\n", c.code)).collect();
        return Status::printed(screen.print(&list));
    };
    if let Some(page) = explain(code) {
        return Status::printed(screen.print(format!("{}\n", page.trim_end())));
    }
    let named = CODES.iter().filter(|known| known.code.contains(code.as_str())).collect::<Vec<_>>();
    match named.as_slice() {
        [] => {}
        [only] => {
            return Status::printed(screen.print(format!("{}\n", only.page.trim_end())));
        }
        several => {
            let list: String = several.iter().map(|c| format!("{}\n", c.code)).collect();
            return Status::printed(screen.print(&list));
        }
    }
    let near = did_you_mean(code, CODES.iter().map(|c| c.code.strip_prefix("mech::").unwrap_or(c.code)));
    let help = match near.first() {
        Some(near) => format!("did you mean `mech::{near}`?"),
        None => "`assur explain --all` lists all codes".to_owned(),
    };
    screen.complain(&complaint(CliError::UnknownCode { code: code.clone(), help }, screen));
    Status::Unusable
}
