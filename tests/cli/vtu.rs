//! ParaView files: one collection and a well-formed file for every part and moment. `tests/tools` reads them with meshio.

use results::vtu;

use crate::compare::{stderr, tankcheck};
use crate::vtu_sample::snapshots;

#[test]
fn files_are_well_formed() {
    let home = tempfile::tempdir().expect("a temporary folder");
    vtu::write(home.path(), &snapshots()).expect("writable");
    let files = std::fs::read_dir(home.path()).expect("readable").count();
    assert_eq!(files, 7);
    for entry in std::fs::read_dir(home.path()).expect("readable").flatten() {
        let text = std::fs::read_to_string(entry.path()).expect("text");
        roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{:?}: {e}", entry.path()));
    }
}

/// The bottom of a tank that lifts in the harmonic engine: pressures of the ground where it rests, none where it is off it.
#[test]
fn a_lifting_bottom_is_written() {
    let home = tempfile::tempdir().expect("a temporary folder");
    let [out, paraview] = ["out", "paraview"].map(|name| home.path().join(name));
    let run = tankcheck(&[
        "compare",
        "examples/09_slender_unanchored/tank.json",
        "--quake",
        "examples/records/elcentro.csv",
        "--no-mesh-error",
        "--no-report",
        "--out",
        out.to_str().expect("text"),
        "--vtu",
        paraview.to_str().expect("text"),
        "--vtu-every",
        "5",
    ]);
    assert!(stderr(&run).contains("tank.pvd"), "{}", stderr(&run));
    let list = std::fs::read_to_string(paraview.join("tank.pvd")).expect("text");
    let list = roxmltree::Document::parse(&list).expect("XML");
    let sets = list.descendants().filter(|n| n.has_tag_name("DataSet"));
    let files: Vec<&str> = sets.filter_map(|n| n.attribute("file")).collect();
    let of = |part: &str| files.iter().filter(|f| f.starts_with(part)).count();
    assert!(of("bottom_") > 4 && of("wall_") == of("bottom_") && of("surface_") == of("bottom_"), "{files:?}");
    for file in files.iter().filter(|f| f.starts_with("bottom_")) {
        let text = std::fs::read_to_string(paraview.join(file)).expect("text");
        let grid = roxmltree::Document::parse(&text).expect("XML");
        let names: Vec<&str> = grid.descendants().filter_map(|n| n.attribute("Name")).collect();
        for name in ["displacement [m]", "contact pressure [Pa]", "plastic rotation [rad]"] {
            assert!(names.contains(&name), "{names:?}");
        }
    }
    // What the engine does not compute is not written.
    let text = std::fs::read_to_string(paraview.join("wall_0001.vtu")).expect("text");
    for (name, there) in
        [("n_phi [N/m]", true), ("seismic pressure [Pa]", true), ("q_v [N/m]", false), ("m_phi [N]", false)]
    {
        assert_eq!(text.contains(&format!("Name=\"{name}\"")), there, "{name}");
    }
}
