//! `tankcheck completions`: shell completions and the manual page.

use clap_complete::Shell;
use files::code::Code;

use crate::cli::{Global, command, print};
use crate::error::{EXIT_OK, Error};

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck completions bash > ~/.local/share/bash-completion/completions/tankcheck
  tankcheck completions zsh > \"${fpath[1]}/_tankcheck\"
  tankcheck completions fish > ~/.config/fish/completions/tankcheck.fish
  tankcheck completions --man > tankcheck.1")]
pub(crate) struct Args {
    /// Shell to complete for.
    #[arg(value_enum, required_unless_present = "man")]
    shell: Option<Shell>,
    /// Print the manual page instead (roff), or that of a subcommand.
    #[arg(long, conflicts_with = "shell", value_name = "SUBCOMMAND", num_args = 0..=1, default_missing_value = "")]
    man: Option<String>,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let mut command = command();
    let mut page = Vec::new();
    match (args.shell, args.man.as_deref()) {
        (Some(shell), _) => clap_complete::generate(shell, &mut command, "tankcheck", &mut page),
        (None, name) => {
            command.build();
            let name = name.unwrap_or_default();
            let chosen = match name {
                "" => command,
                name => command.find_subcommand(name).cloned().ok_or_else(|| {
                    let known: Vec<&str> = command.get_subcommands().map(clap::Command::get_name).collect();
                    Error::input(
                        Code::UnknownId,
                        format!("unknown subcommand; found `{name}`, expected one of {}", known.join(", ")),
                    )
                })?,
            };
            clap_mangen::Man::new(chosen).render(&mut page).map_err(|e| Error::report(format!("manual page: {e}")))?;
        }
    }
    print(&String::from_utf8_lossy(&page))?;
    Ok(EXIT_OK)
}
