//! `tankcheck desk`: the page of the crate [`desk`], its questions answered by the same readers, codes and reports as on the command line.

mod office;

use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Arc;

use crate::cli::Global;
use crate::cli::progress;
use crate::cli::terminal::{print, say};
use crate::error::{EXIT_OK, Error};
use files::code::Code;
use files::text::line;

/// Arguments.
#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck desk                       the tanks, records and results of this folder
  tankcheck desk tank.json
  tankcheck desk project/ --no-browser --port 8000

The page is served on this machine alone, at an address with a random token; nothing is fetched from elsewhere. What it computes are the
commands of this program: each is shown as it would be typed. Ctrl-C closes the desk.")]
pub(crate) struct Args {
    /// Folder, or a tank file in it [default: this folder].
    #[arg(value_name = "FOLDER or TANK")]
    path: Option<PathBuf>,
    /// Print the address without opening a browser.
    #[arg(long)]
    no_browser: bool,
    /// Port; 0 takes any that is free [default: 8650, else any that is free].
    #[arg(long, value_name = "N")]
    port: Option<u16>,
}

/// Port that is tried first.
const USUAL: u16 = 8650;

/// Runs the subcommand; returns the exit code.
///
/// * `commands`: all commands, of which the desk runs some
pub(crate) fn run(args: Args, commands: clap::Command, global: &Global) -> Result<u8, Error> {
    let path = args.path.unwrap_or_else(|| ".".into());
    let (folder, tank) = opened(&path)?;
    let program = std::env::current_exe().map_err(|e| Error::output(e.to_string()))?;
    // What a browser keeps belongs to the port: with the same one it is found again.
    let ports = args.port.map_or_else(|| vec![USUAL, 0], |port| vec![port]);
    let opening = desk::Opening { folder, tank, ports, program, version: env!("CARGO_PKG_VERSION") };
    progress::stop_gracefully("closing the desk");
    let show = |address: &str| {
        // Whoever started the desk reads the address; where nobody can, it closes by itself.
        if print(&format!("desk: {address}\n")).is_err() {
            return;
        }
        if !args.no_browser && !browsed(address) && !global.quiet {
            say!("note: no browser was opened; open the address in one");
        }
    };
    let served = desk::serve(
        opening,
        Arc::new(office::Answers { commands: commands.no_binary_name(true) }),
        show,
        progress::stopped,
    );
    served.map_err(|error| match error.kind() {
        std::io::ErrorKind::AddrInUse | std::io::ErrorKind::PermissionDenied => Error::value(format!(
            "--port: found {}, which another program uses or this user may not\n  help: leave --port out, and any free one is taken",
            args.port.unwrap_or_default()
        )),
        _ => Error::output(error.to_string()),
    })?;
    Ok(EXIT_OK)
}

/// The folder, and the name of the file in it that is shown first.
///
/// Errors: a path that leads to neither.
fn opened(path: &Path) -> Result<(PathBuf, Option<String>), Error> {
    if path.is_dir() {
        return Ok((path.to_owned(), None));
    }
    let name = path.file_name().and_then(|name| name.to_str());
    match (path.is_file(), name) {
        (true, Some(name)) => {
            let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
            Ok((folder.to_owned(), Some(name.to_owned())))
        }
        _ => Err(Error::input(
            Code::FileUnreadable,
            format!(
                "{}: found nothing there, expected a folder or a tank file\n  help: `tankcheck init --out tank.json` writes a tank to \
                 start from",
                line(&path.to_string_lossy())
            ),
        )),
    }
}

/// Opens the address as the system does.
fn browsed(address: &str) -> bool {
    let (program, arguments): (&str, &[&str]) = match std::env::consts::OS {
        "macos" => ("open", &[]),
        "windows" => ("rundll32", &["url.dll,FileProtocolHandler"]),
        _ => ("xdg-open", &[]),
    };
    let mut command = Command::new(program);
    command.args(arguments).arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
