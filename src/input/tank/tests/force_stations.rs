//! `analysis.force_stations`.

use tank::options::linear::WallPlace;

use super::{read, refused, small};

/// Places with and without an angle; places outside the tank, twice the same and faulty values are named with their path.
#[test]
fn force_stations() {
    let of = |given: &str| small(&format!(r#", "analysis": {{ "force_stations": {given} }}"#));
    assert!(read(&small("")).fe.force_stations.is_empty());
    let found = read(&of(r#"[{ "z": "50 cm" }, { "z": "0 m", "theta": "90 deg" }]"#));
    let place = |z, theta| WallPlace { z, theta };
    assert_eq!(found.fe.force_stations, [place(0.5, 0.0), place(0.0, std::f64::consts::FRAC_PI_2)]);
    for (given, path, message) in [
        (r#"[{ "z": "8.1 m" }]"#, "force_stations[0].z", "the height of the wall"),
        (r#"[{ "z": "-1 m" }]"#, "force_stations[0].z", "0"),
        (r#"[{ "theta": "0 deg" }]"#, "force_stations[0]", "z"),
        (r#"[{ "z": "1 m", "theta": "400 deg" }]"#, "force_stations[0].theta", "360 deg"),
        (r#"[{ "z": "1 m" }, { "z": "1 m", "theta": "0 deg" }]"#, "force_stations[1]", "different places"),
    ] {
        let text = refused(&of(given));
        assert!(text.contains(path) && text.contains(message), "{text}");
    }
}
