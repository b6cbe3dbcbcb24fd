//! `assur help`: the manual of a command, or the reference of the language.

use super::args::{Args, Help};
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use crate::report::manual;
use crate::report::text;
use assur_text::diagnostic::did_you_mean;
use clap::CommandFactory;

/// Topics that are not commands.
const TOPICS: [&str; 3] = ["functions", "units", "statements"];

/// Prints a page of the manual.
pub fn run(args: &Help, screen: &Screen) -> Status {
    let topic = args.topic.as_deref();
    let page = match topic {
        Some("functions") => manual::functions(),
        Some("units") => manual::units(),
        Some("statements") => manual::statements(),
        _ => return of_command(topic, screen),
    };
    Status::printed(screen.print(text::render(&page, screen.look())))
}

/// What `--help` prints: of the program, or of a command.
fn of_command(name: Option<&str>, screen: &Screen) -> Status {
    let mut program = Args::command();
    // gives every command its full name
    program.build();
    let names: Vec<String> = program.get_subcommands().map(|c| c.get_name().to_owned()).collect();
    let command = match name {
        None => Some(&mut program),
        Some(name) => program.find_subcommand_mut(name),
    };
    if let Some(command) = command {
        let manual = command.render_long_help();
        let manual = if screen.look().colour { manual.ansi().to_string() } else { manual.to_string() };
        return Status::printed(screen.print(&(manual.trim_end().to_owned() + "\n")));
    }
    let name = name.unwrap_or_default();
    let known = names.iter().map(String::as_str).chain(TOPICS);
    let help = match did_you_mean(name, known).first() {
        Some(near) => format!("did you mean `assur help {near}`?"),
        None => format!("the topics are {} and every command", TOPICS.map(|t| format!("`{t}`")).join(", ")),
    };
    screen.complain(&complaint(CliError::UnknownTopic { name: name.to_owned(), help }, screen));
    Status::Unusable
}
