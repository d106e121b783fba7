//! Standard input, which is one file only.

use std::io::StdinLock;
use std::sync::atomic::{AtomicBool, Ordering};

use files::code::Code;
use files::error::Error;

static TAKEN: AtomicBool = AtomicBool::new(false);

/// Standard input, once.
///
/// Errors: asked for a second time: two arguments are `-`.
pub(in crate::input) fn take() -> Result<StdinLock<'static>, Error> {
    match TAKEN.swap(true, Ordering::SeqCst) {
        false => Ok(std::io::stdin().lock()),
        true => Err(Error::Input(
            Code::OptionConflict,
            "standard input (`-`) is named for two files\n  help: name a file for one of them".into(),
        )),
    }
}
