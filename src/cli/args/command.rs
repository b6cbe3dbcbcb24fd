//! The subcommands. The arguments of one are built where it is named: those of all are a tenth of what a small file takes.

use clap::error::ErrorKind;
use clap::{ArgMatches, Args, FromArgMatches, Subcommand};

#[cfg(feature = "lsp")]
use super::Lsp;
use super::{
    Accuracy, Batch, Card, Check, Completions, Course, Draw, Explain, Fmt, Grade, Help, Info, Man, Mcp, New,
    Preview, Profile, Report, Solve, Test,
};

/// Subcommands from their names, words and sentences.
macro_rules! commands {
    ($($(#[$when:meta])? $name:ident $word:literal $about:literal;)+) => {
        /// Subcommands.
        #[derive(Debug)]
        pub enum Command {
            $($(#[$when])? #[doc = $about] $name($name),)+
        }

        impl Command {
            /// The subcommand of this name.
            pub(super) fn named(name: &str) -> Option<clap::Command> {
                match name {
                    $(
                        $(#[$when])?
                        $word => Some(
                            clap::Command::new($word)
                                .about($about)
                                .defer(|command| $name::augment_args(command).about($about).long_about(None)),
                        ),
                    )+
                    _ => None,
                }
            }
        }

        impl Subcommand for Command {
            fn augment_subcommands(program: clap::Command) -> clap::Command {
                program.subcommands([$($(#[$when])? $word),+].into_iter().filter_map(Self::named))
            }

            fn augment_subcommands_for_update(program: clap::Command) -> clap::Command {
                Self::augment_subcommands(program)
            }

            fn has_subcommand(name: &str) -> bool {
                [$($(#[$when])? $word),+].contains(&name)
            }
        }

        impl FromArgMatches for Command {
            fn from_arg_matches(found: &ArgMatches) -> Result<Self, clap::Error> {
                match found.subcommand() {
                    $($(#[$when])? Some(($word, args)) => $name::from_arg_matches(args).map(Self::$name),)+
                    _ => Err(clap::Error::new(ErrorKind::MissingSubcommand)),
                }
            }

            fn update_from_arg_matches(&mut self, found: &ArgMatches) -> Result<(), clap::Error> {
                *self = Self::from_arg_matches(found)?;
                Ok(())
            }
        }
    };
}

commands! {
    Check "check" "Show the structure of a mechanism: mobility, structural groups, effects, plan";
    Solve "solve" "Solve and print the answers";
    Test "test" "Compare the results with the file's `expect` lines";
    Batch "batch" "Solve once per row of a table of variants, in parallel";
    Grade "grade" "Grade answers by an answer key";
    Course "course" "Write an exercise set as questions of a learning platform";
    Accuracy "accuracy" "Show the time that accuracy costs: every accuracy setting, timed on this machine";
    Profile "profile" "Print the profile of a cam, for other programs";
    Draw "draw" "Draw a mechanism: its scheme and what the course draws next to it, as SVG";
    Preview "preview" "Show a file in the browser, in motion, and follow its changes";
    Report "report" "Write the worked solution: formulas with numbers, plans and polygons";
    Explain "explain" "Explain a diagnostic by its code";
    Fmt "fmt" "Put files in the one style: blanks, empty lines, columns";
    New "new" "Write a file to start from";
    #[cfg(feature = "lsp")] Lsp "lsp" "Answer an editor by the language server protocol on standard input and output";
    Mcp "mcp" "Answer an agent by the model context protocol on standard input and output";
    Card "card" "Print the language on one page, for language models and people in a hurry";
    Completions "completions" "Print the script that completes the command line in a shell";
    Man "man" "Print the manual page of the program or of a command, in roff";
    Info "info" "Show the version of the program, its features and the formats that it reads and writes";
    Help "help" "Show the manual of a command, or the functions, units or statements of the language";
}
