//! `analysis.heave`.

use tank::options::linear::Heave;

use super::{read, refused, small};

fn with(heave: &str, support: &str) -> String {
    let file = small(&format!(r#", "analysis": {{ "heave": {heave} }}"#));
    file.replace("\"support\": \"anchored\"", &format!("\"support\": \"{support}\""))
}

/// Not by itself; its damping may be given.
#[test]
fn heave() {
    assert_eq!(read(&small("")).fe.heave, None);
    for (given, damping) in [("{}", None), (r#"{ "damping": 0.3 }"#, Some(0.3))] {
        assert_eq!(read(&with(given, "unanchored")).fe.heave, Some(Heave { damping }));
    }
}

/// A tank that stands fast and a ratio below zero: each with its place and what is allowed.
#[test]
fn heave_that_cannot_be_is_refused() {
    for (given, support, path, allowed) in [
        ("{}", "anchored", "analysis.heave", "unanchored"),
        (r#"{ "damping": -0.1 }"#, "unanchored", "analysis.heave.damping", "0"),
        (r#"{ "damping": 3 }"#, "unanchored", "analysis.heave.damping", "2"),
    ] {
        let text = refused(&with(given, support));
        assert!(text.contains(path) && text.contains(allowed), "{text}");
    }
}
