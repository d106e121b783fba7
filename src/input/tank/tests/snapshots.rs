//! `analysis.snapshots`.

use tank::options::linear::{Instant, Peak};

use super::{read, refused, small};

/// Times and names of peaks in one list; other names, times out of range and too many of them are refused with their place.
#[test]
fn snapshots() {
    let of = |given: &str| small(&format!(r#", "analysis": {{ "snapshots": {given} }}"#));
    assert!(read(&small("")).fe.snapshots.is_empty());
    let found =
        read(&of(r#"["1500 ms", "peak wave", "peak base shear", "peak base moment", "peak overturning moment"]"#));
    let peaks = Peak::ALL.map(Instant::Peak);
    assert_eq!(found.fe.snapshots[0], Instant::At(1.5));
    assert_eq!(found.fe.snapshots[1..], peaks);
    let many = format!("[{}]", ["\"1 s\""; 21].join(", "));
    for (given, path, message) in [
        (r#"["peak waves"]"#, "snapshots[0]", "did you mean \"peak wave\"?"),
        (r#"["1 s", "-1 s"]"#, "snapshots[1]", "must not be negative"),
        (r#"["1 m"]"#, "snapshots[0]", "time"),
        ("[3]", "snapshots[0]", "time"),
        (many.as_str(), "snapshots", "at most 20"),
    ] {
        let text = refused(&of(given));
        assert!(text.contains(path) && text.contains(message), "{text}");
    }
}
