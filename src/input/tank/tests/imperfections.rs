//! `analysis.imperfections`.

use tank::imperfection::{Imperfection, Profile, Wave};

use super::{read, refused, small};

/// Waves in SI for both engines; what is missing, too much or elsewhere is named with its path.
#[test]
fn imperfections() {
    let of = |list: &str| small(&format!(r#", "analysis": {{ "imperfections": {list} }}"#));
    let file = read(&of(r#"[ { "n": 5, "amplitude": "3 mm", "shape": "linear", "phase": "36 deg" },
             { "n": 2, "amplitude": "-1 mm", "shape": [["0 m", 0], ["4 m", 0.5], ["8 m", 1]] },
             { "n": 0, "amplitude": "1 mm", "shape": "sine_3" } ]"#));
    let parts = &file.solid.imperfections.parts;
    let expected = Wave { n: 5, amplitude: 0.003, profile: Profile::Linear, phase: std::f64::consts::PI / 5.0 };
    assert_eq!(parts[0], Imperfection::Wave(expected));
    let points = Profile::Points(vec![[0.0, 0.0], [4.0, 0.5], [8.0, 1.0]]);
    let profile = |part: &Imperfection| match part {
        Imperfection::Wave(wave) => wave.profile.clone(),
        Imperfection::Table(_) => Profile::Constant,
    };
    assert_eq!((profile(&parts[1]), profile(&parts[2])), (points, Profile::Sine(3)));
    assert_eq!(file.nonlinear.imperfections, file.solid.imperfections);
    assert!(file.solid.about_loaded_state());
    assert!(!read(&small("")).solid.about_loaded_state());
    for (list, path, message) in [
        (r#"[{ "n": 3 }]"#, "analysis.imperfections[0]", "no amplitude"),
        (r#"[{ "n": 3, "amplitude": "3 mm", "table": "w.csv" }]"#, "[0].n", "exclude each other"),
        (r#"[{ "n": 3, "amplitude": "3 mm", "shape": "cubic" }]"#, "[0].shape", "half_sine"),
        (r#"[{ "n": 3, "amplitude": "3 mm", "shape": "sine_0" }]"#, "[0].shape", "sine_k"),
        (r#"[{ "n": 3, "amplitude": "700 mm" }]"#, "analysis.imperfections", "twentieth of its radius"),
        (r#"[{ "table": "nowhere.csv" }]"#, "[0].table", "nowhere.csv"),
    ] {
        let message_found = refused(&of(list));
        assert!(message_found.contains(path) && message_found.contains(message), "{message_found}");
    }
}
