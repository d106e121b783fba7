//! `analysis.heave`.

use tank::options::linear::Heave;

use super::{read, refused, small};

const BOTTOM: &str = r#", "bottom": { "thickness": "6 mm", "material": "steel" }"#;

fn with(heave: &str, support: &str, bottom: &str) -> String {
    let file = small(&format!(r#", "analysis": {{ "heave": {heave} }}"#));
    file.replace("\"support\": \"anchored\"", &format!("\"support\": \"{support}\"{bottom}"))
}

/// Not by itself; its damping may be given.
#[test]
fn heave() {
    assert_eq!(read(&small("")).fe.heave, None);
    for (given, damping) in [("{}", None), (r#"{ "damping": 0.3 }"#, Some(0.3))] {
        assert_eq!(read(&with(given, "unanchored", BOTTOM)).fe.heave, Some(Heave { damping }));
    }
}

/// A tank that stands fast, one without a plate, and a ratio below zero: each with its place and what is allowed.
#[test]
fn heave_that_cannot_be_is_refused() {
    for (given, support, bottom, path, allowed) in [
        ("{}", "anchored", BOTTOM, "analysis.heave", "unanchored"),
        ("{}", "unanchored", "", "analysis.heave", "tank.bottom"),
        (r#"{ "damping": -0.1 }"#, "unanchored", BOTTOM, "analysis.heave.damping", "0"),
        (r#"{ "damping": 3 }"#, "unanchored", BOTTOM, "analysis.heave.damping", "2"),
    ] {
        let text = refused(&with(given, support, bottom));
        assert!(text.contains(path) && text.contains(allowed), "{text}");
    }
}
