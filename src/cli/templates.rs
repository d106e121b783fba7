//! `tankcheck templates`: the templates of the report, to change and give back with --templates.

use std::path::PathBuf;

use crate::cli::{Global, print};
use crate::error::{EXIT_OK, Error};
use files::code::Code;
use files::{text, write_whole};

/// Arguments.
#[derive(clap::Args)]
#[command(subcommand_required = true, arg_required_else_help = true)]
pub(crate) struct Args {
    #[command(subcommand)]
    command: Command,
}

#[derive(clap::Subcommand)]
enum Command {
    /// Write the embedded templates into a folder.
    Export(Export),
}

#[derive(clap::Args)]
#[command(after_help = "\
Examples:
  tankcheck templates export mine/
  tankcheck report out/ --templates mine/

A folder for --templates needs only the files that differ: delete the others, and they follow the program.")]
struct Export {
    /// Folder that is written; it is created if it is missing.
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// Overwrite templates that are there. Other files stay in any case.
    #[arg(long)]
    force: bool,
}

/// Runs the subcommand; returns the exit code.
pub(crate) fn run(args: Args, _: &Global) -> Result<u8, Error> {
    let Command::Export(export) = args.command;
    export.run()?;
    Ok(EXIT_OK)
}

impl Export {
    /// Errors: a template that is there, without --force; a folder or file that cannot be written.
    fn run(&self) -> Result<(), Error> {
        let files: Vec<(PathBuf, &str)> =
            report::template::embedded().map(|(name, text)| (self.folder.join(name), *text)).collect();
        if !self.folder.is_dir() && self.folder.symlink_metadata().is_ok() {
            return Err(self.taken("is a file, expected a folder", "name a folder"));
        }
        let there = files.iter().find(|(path, _)| path.symlink_metadata().is_ok());
        if let Some((path, _)) = there.filter(|_| !self.force) {
            let what = format!("contains `{}`", path.strip_prefix(&self.folder).unwrap_or(path).display());
            return Err(self.taken(&what, "name another folder, or add --force to overwrite its templates"));
        }
        let unwritten = |e: std::io::Error| {
            Error::Files(files::error::Error::Unwritten { path: self.folder.clone(), what: files::error::describe(&e) })
        };
        for (path, text) in &files {
            if let Some(parent) = path.parent() {
                std::fs::create_dir_all(parent).map_err(unwritten)?;
            }
            write_whole(path, text.as_bytes())?;
        }
        print(&format!("{} templates in {}\n", files.len(), self.folder.display()))
    }

    fn taken(&self, what: &str, help: &str) -> Error {
        let folder = self.folder.display().to_string();
        Error::input(Code::FileTaken, format!("{}: {what}\n  help: {help}", text::line(&folder)))
    }
}
