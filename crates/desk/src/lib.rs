//! `tankcheck desk`: a page that the program itself serves on loopback, to enter, check and look at tanks in a browser.
//!
//! ```text
//! browser ── HTTP on 127.0.0.1 ── guard ── api ─┬─ office   questions that take milliseconds, answered in the process (check, sheet, record)
//!                                               ├─ folder   files below the opened folder, and no others
//!                                               └─ runs     long computations: the program itself as a child, one at a time
//! ```
//!
//! The crate computes nothing. Questions go to an [`Office`], long runs are the commands that a terminal would take, so that what the desk
//! shows can be repeated there. All addresses begin with a random token; `guard` says what else is asked of a request.
//!
//! The page is `page/`: modules, styles and libraries as the browser reads them, embedded in the program.

mod api;
mod folder;
mod guard;
mod interactive;
mod keeping;
mod office;
mod page;
mod runs;
mod series;

use std::net::{Ipv4Addr, SocketAddr};
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Duration;

pub use folder::Folder;
pub use interactive::{MOST_SCENE, Shown, interactive};
pub use office::{Named, Office, Question, RecordChoice, Refused, Tank};

/// What the desk is opened with.
#[derive(Clone, Debug)]
pub struct Opening {
    /// The opened folder.
    pub folder: PathBuf,
    /// File in it that is shown first.
    pub tank: Option<String>,
    /// Ports, of which the first that is free is taken; 0 for any.
    pub ports: Vec<u16>,
    /// The program that runs are made with.
    pub program: PathBuf,
    /// Version, for the page.
    pub version: &'static str,
}

/// Pause between two looks at whether the desk shall close.
const LOOK: Duration = Duration::from_millis(50);

/// Serves the desk until `stop` says so; runs that still compute are then ended as by Ctrl-C.
///
/// * `opened`: gets the address, with its token
///
/// Errors: the path is not a folder, the port is taken, or the system has no random numbers.
pub fn serve(
    opening: Opening,
    office: Arc<dyn Office>,
    opened: impl FnOnce(&str),
    stop: impl Fn() -> bool,
) -> std::io::Result<()> {
    let folder = Folder::open(&opening.folder)?;
    let token = guard::token()?;
    let runtime = tokio::runtime::Builder::new_current_thread().enable_all().max_blocking_threads(8).build()?;
    runtime.block_on(async {
        let addresses: Vec<SocketAddr> =
            opening.ports.iter().map(|port| SocketAddr::from((Ipv4Addr::LOCALHOST, *port))).collect();
        let listener = tokio::net::TcpListener::bind(addresses.as_slice()).await?;
        let port = listener.local_addr()?.port();
        let runs = runs::Runs::new(opening.program.clone(), folder.root().to_owned());
        let desk = Arc::new(api::Desk { opening, folder, office, runs: runs.clone() });
        opened(&format!("http://127.0.0.1:{port}/{token}/"));
        let server = axum::serve(listener, api::router(desk, &token, port));
        let serving = tokio::spawn(async move { server.await });
        while !stop() && !serving.is_finished() {
            tokio::time::sleep(LOOK).await;
        }
        serving.abort();
        runs.close();
        Ok(())
    })
}
