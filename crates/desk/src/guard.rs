//! What is asked of a request before anything is read: a name of this machine as `Host`, on changes also as `Origin`. A page of another site
//! can make a browser send requests here; it cannot know the token, and its requests bear its own origin or, after a change of its name's
//! address, its own host.

use axum::extract::{Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

/// Bytes of a token.
const TOKEN: usize = 24;

/// A random token, as hexadecimal digits.
///
/// Errors: a system without random numbers.
pub(crate) fn token() -> std::io::Result<String> {
    let mut bytes = [0; TOKEN];
    getrandom::fill(&mut bytes).map_err(|e| std::io::Error::other(e.to_string()))?;
    Ok(bytes.iter().map(|byte| format!("{byte:02x}")).collect())
}

/// What a page may load and do: its own files alone, no script or style within markup.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; connect-src 'self'; \
    font-src 'self'; frame-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";
/// The same of a report: its own styles, no script.
const OF_REPORT: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:; font-src data:; base-uri 'none'; form-action 'none'; \
    frame-ancestors 'self'; sandbox allow-popups";
/// The same of a report with a viewer: its own scripts in a place without an origin.
const OF_VIEWER: &str = "default-src 'none'; script-src 'unsafe-inline' blob: data:; style-src 'unsafe-inline'; img-src data: blob:; \
    connect-src data: blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'; sandbox allow-scripts allow-downloads";

/// What a file of a result may do.
pub(crate) fn policy(name: &str) -> &'static str {
    if name == "interactive.html" { OF_VIEWER } else { OF_REPORT }
}

/// Rejects what does not come from the desk's own page, and says to the browser what the page may do.
pub(crate) async fn guard(State(port): State<u16>, request: Request, next: Next) -> Response {
    let own = [format!("127.0.0.1:{port}"), format!("localhost:{port}")];
    let named = text(request.headers(), header::HOST);
    let mut response = if !named.is_some_and(|host| own.iter().any(|name| name == host)) {
        (StatusCode::FORBIDDEN, "the desk answers to 127.0.0.1 and localhost alone\n").into_response()
    } else if request.method() != Method::GET && !from_here(request.headers(), &own) {
        (StatusCode::FORBIDDEN, "the request comes from another page\n").into_response()
    } else {
        next.run(request).await
    };
    let headers = response.headers_mut();
    let fixed = [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::CACHE_CONTROL, "no-store"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
    ];
    for (name, value) in fixed {
        headers.insert(name, HeaderValue::from_static(value));
    }
    headers.entry(header::CONTENT_SECURITY_POLICY).or_insert(HeaderValue::from_static(POLICY));
    response
}

/// Whether the desk's own page, or a program other than a browser, asked for a change.
fn from_here(headers: &HeaderMap, own: &[String; 2]) -> bool {
    let origin = text(headers, header::ORIGIN);
    let site = text(headers, HeaderName::from_static("sec-fetch-site"));
    origin.is_none_or(|origin| own.iter().any(|name| origin.strip_prefix("http://") == Some(name)))
        && site.is_none_or(|site| site == "same-origin" || site == "none")
}

/// A header that stands there once, as text.
fn text(headers: &HeaderMap, name: HeaderName) -> Option<&str> {
    let mut all = headers.get_all(name).iter();
    // A header that is given twice counts as unknown: this program and a proxy might each read another one.
    match (all.next(), all.next()) {
        (Some(one), None) => Some(one.to_str().unwrap_or("?")),
        (Some(_), Some(_)) => Some("?"),
        _ => None,
    }
}
