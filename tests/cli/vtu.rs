//! ParaView files: another program reads what we write.

use std::process::Command;

use tankcheck::results::{Resultants, Snapshot, Snapshots, vtu};

/// Two hexahedra on each other and the two faces of one side, at two moments; node 3 belongs to nothing drawn.
fn snapshots() -> Snapshots {
    let mut nodes = Vec::new();
    for z in 0..3 {
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 2.0), (0.0, 2.0)] {
            nodes.push([x, y, 0.5 * f64::from(z)]);
        }
        if z == 0 {
            nodes.insert(3, [9.0, 9.0, 9.0]);
        }
    }
    let lower = [0, 1, 2, 4];
    let middle = [5, 6, 7, 8];
    let upper = [9, 10, 11, 12];
    let hexahedron = |a: [usize; 4], b: [usize; 4]| [a[0], a[1], a[2], a[3], b[0], b[1], b[2], b[3]];
    let state = |time: f64| Snapshot {
        time,
        displacement: nodes.iter().map(|p| [time * p[2], 0.0, -0.25 * time]).collect(),
        pressure: vec![1000.0 * time, -7.5],
        resultants: (0..2)
            .map(|k| Resultants {
                n_phi: 1.0 + f64::from(k),
                n_v: 2.0,
                n_phi_v: 3.0,
                m_phi: 4.0,
                m_v: 5.0,
                m_phi_v: 6.0,
                q_v: 7.0 * time,
            })
            .collect(),
    };
    Snapshots {
        liquid: vec![hexahedron(lower, middle), hexahedron(middle, upper)],
        wall: vec![[0, 1, 6, 5], [5, 6, 10, 9]],
        states: vec![state(0.0), state(0.125)],
        nodes,
    }
}

/// Reads both parts of the second moment with meshio and checks every array.
const SCRIPT: &str = r#"
import sys, xml.etree.ElementTree as tree
import meshio, numpy as np
folder = sys.argv[1]
sets = tree.parse(folder + "/tank.pvd").getroot().findall("Collection/DataSet")
assert [(float(s.get("timestep")), s.get("part")) for s in sets] == [(0, "0"), (0, "1"), (0.125, "0"), (0.125, "1")]
liquid, wall = (meshio.read(folder + "/" + s.get("file")) for s in sets[2:])
assert liquid.points.shape == (12, 3) and wall.points.shape == (6, 3)
(block,) = liquid.cells
assert block.type == "hexahedron" and block.data.shape == (2, 8)
corners = liquid.points[block.data[1]]
assert np.array_equal(corners[0], [0, 0, 0.5]) and np.array_equal(corners[6], [1, 2, 1.0])
volume = np.prod(corners.max(axis=0) - corners.min(axis=0))
assert volume == 1.0
u = liquid.point_data["displacement [m]"]
assert np.array_equal(u[:, 0], 0.125 * liquid.points[:, 2]) and np.all(u[:, 2] == -0.03125)
assert np.array_equal(np.ravel(liquid.cell_data["pressure [Pa]"][0]), [125.0, -7.5])
(block,) = wall.cells
assert block.type == "quad" and block.data.shape == (2, 4)
names = ["n_phi [N/m]", "n_v [N/m]", "n_phi_v [N/m]", "m_phi [N]", "m_v [N]", "m_phi_v [N]", "q_v [N/m]"]
values = [np.ravel(wall.cell_data[name][0]).tolist() for name in names]
assert values == [[1, 2], [2, 2], [3, 3], [4, 4], [5, 5], [6, 6], [0.875, 0.875]], values
print("read back")
"#;

#[test]
fn meshio_reads_what_is_written() {
    let home = tempfile::tempdir().expect("a temporary folder");
    vtu::write(home.path(), &snapshots()).expect("writable");
    let files = std::fs::read_dir(home.path()).expect("readable").count();
    assert_eq!(files, 5);
    for entry in std::fs::read_dir(home.path()).expect("readable").flatten() {
        let text = std::fs::read_to_string(entry.path()).expect("text");
        roxmltree::Document::parse(&text).unwrap_or_else(|e| panic!("{:?}: {e}", entry.path()));
    }
    let has_meshio = Command::new("python3")
        .args(["-c", "import meshio, numpy"])
        .output()
        .is_ok_and(|o| o.status.success());
    if !has_meshio {
        println!("not run: python3 with meshio (PyPI) is not installed");
        return;
    }
    let read = Command::new("python3")
        .args(["-c", SCRIPT])
        .arg(home.path())
        .output()
        .expect("python3 runs");
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    assert_eq!(String::from_utf8_lossy(&read.stdout).trim(), "read back");
}
