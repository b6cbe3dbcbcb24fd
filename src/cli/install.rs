//! What an installation adds to a system: `assur completions`, `assur man`.

use super::args::{Args, Completions, Man};
use super::error::CliError;
use super::reply::{Status, complaint};
use super::screen::Screen;
use assur_text::diagnostic::did_you_mean;
use clap::CommandFactory;
use std::io;

/// Prints the completions of a shell.
pub fn completions(args: &Completions, screen: &Screen) -> Status {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Args::command(), "assur", &mut script);
    Status::printed(screen.print(script))
}

/// Prints a manual page.
pub fn manual(args: &Man, screen: &Screen) -> Status {
    let mut program = Args::command();
    // gives every command its full name
    program.build();
    let Some(name) = &args.command else { return page(program, "assur", screen) };
    if let Some(command) = program.find_subcommand(name) {
        return page(command.clone(), &format!("assur-{name}"), screen);
    }
    let near = did_you_mean(name, program.get_subcommands().map(clap::Command::get_name));
    let help = match near.first() {
        Some(near) => format!("did you mean `assur man {near}`?"),
        None => "`assur help` lists the commands".to_owned(),
    };
    screen.complain(&complaint(CliError::UnknownTopic { name: name.clone(), help }, screen));
    Status::Unusable
}

fn page(command: clap::Command, title: &str, screen: &Screen) -> Status {
    let mut roff = Vec::new();
    match clap_mangen::Man::new(command).title(title).render(&mut roff) {
        Ok(()) => Status::printed(screen.print(roff)),
        Err(io::Error { .. }) => Status::Unusable,
    }
}
