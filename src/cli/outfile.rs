//! `--out FILE` of commands whose result is one text.

use std::path::{Path, PathBuf};

use crate::cli::print;
use crate::error::Error;
use files::code::Code;
use files::write_whole;

/// The option.
#[derive(clap::Args, Clone, Debug, Default)]
pub(crate) struct OutFile {
    /// Write into this file, which must not exist, instead of standard output.
    #[arg(long, short, value_name = "FILE")]
    out: Option<PathBuf>,
    /// Overwrite the file of --out.
    #[arg(long, requires = "out")]
    force: bool,
}

impl OutFile {
    /// The file; none for standard output.
    pub(crate) fn path(&self) -> Option<&Path> {
        self.out.as_deref().filter(|path| *path != Path::new("-"))
    }

    /// Writes the text into the file, whole or not at all, or prints it (`-` too).
    ///
    /// Errors: a file that exists, without --force; one that cannot be written.
    pub(crate) fn put(&self, text: &str) -> Result<(), Error> {
        let Some(path) = self.path() else { return print(text) };
        if path.exists() && !(self.force && path.is_file()) {
            return Err(Error::input(
                Code::FileTaken,
                format!(
                    "--out: found `{}`, which exists, expected the name of a new file\n  help: name another file, or add --force",
                    files::text::line(&path.display().to_string())
                ),
            ));
        }
        Ok(write_whole(path, text.as_bytes())?)
    }
}
