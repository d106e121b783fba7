//! The page: modules, styles and libraries, embedded in the program.

use axum::http::header;
use axum::response::{IntoResponse, Response};

/// Files of `page/`, as the browser asks for them.
macro_rules! files {
    ($($name:literal)+) => {
        &[$(($name, include_bytes!(concat!("../page/", $name)))),+]
    };
}

/// All files of the page.
pub(crate) const FILES: &[(&str, &[u8])] = files!["index.html"];

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

#[cfg(test)]
mod tests {
    use super::*;

    /// A file of the folder that is not embedded would be missing in the program alone.
    #[test]
    fn every_file_of_the_page_is_embedded() {
        let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("page");
        let mut found = Vec::new();
        let mut open = vec![root.clone()];
        while let Some(folder) = open.pop() {
            for entry in std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
                if entry.is_dir() {
                    open.push(entry);
                } else {
                    found.push(entry.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/"));
                }
            }
        }
        // Licences, versions and their script are for developers.
        found.retain(|name| [".html", ".js", ".css", ".svg"].iter().any(|end| name.ends_with(end)));
        found.sort();
        let mut known: Vec<&str> = FILES.iter().map(|(name, _)| *name).collect();
        known.sort_unstable();
        assert_eq!(known, found);
    }
}
