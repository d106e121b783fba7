//! The page: modules, styles and libraries, embedded in the program.

use axum::http::header;
use axum::response::{IntoResponse, Response};

/// Names and bytes of all files, listed by the build.
pub(crate) static FILES: &[(&str, &[u8])] = &include!(concat!(env!("OUT_DIR"), "/page.rs"));

/// A file of the page.
pub(crate) fn file(name: &str) -> Option<Response> {
    let kind = match name.rsplit_once('.')?.1 {
        "html" => "text/html; charset=utf-8",
        "js" => "text/javascript; charset=utf-8",
        "css" => "text/css; charset=utf-8",
        "svg" => "image/svg+xml",
        "woff2" => "font/woff2",
        _ => return None,
    };
    let bytes =
        changed(name).or_else(|| FILES.iter().find(|(own, _)| *own == name).map(|(_, bytes)| bytes.to_vec()))?;
    Some(([(header::CONTENT_TYPE, kind)], bytes).into_response())
}

/// While the page is being written: the file as it is on the disk, so that the program need not be built for each change.
#[cfg(debug_assertions)]
fn changed(name: &str) -> Option<Vec<u8>> {
    let folder = std::env::var_os("TANKCHECK_DESK_PAGE")?;
    let plain = name.split('/').all(|part| !part.is_empty() && !part.starts_with('.'));
    plain.then(|| std::fs::read(std::path::Path::new(&folder).join(name)).ok()).flatten()
}

#[cfg(not(debug_assertions))]
fn changed(_: &str) -> Option<Vec<u8>> {
    None
}
