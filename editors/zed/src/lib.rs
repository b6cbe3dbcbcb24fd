//! The language server of `assur` in Zed: the program on PATH.

use zed_extension_api::{self as zed, Command, LanguageServerId, Result, Worktree};

struct Mech;

impl zed::Extension for Mech {
    fn new() -> Self {
        Self
    }

    fn language_server_command(&mut self, _: &LanguageServerId, worktree: &Worktree) -> Result<Command> {
        let command = worktree.which("assur").ok_or("no program `assur` is on PATH; install it with `cargo install --path .`")?;
        Ok(Command { command, args: vec!["lsp".to_owned()], env: worktree.shell_env() })
    }
}

zed::register_extension!(Mech);
