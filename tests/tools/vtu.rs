//! ParaView files: another program, meshio (PyPI), reads them.

use std::path::Path;
use std::process::Command;

use results::vtu;

#[path = "../cli/vtu_sample.rs"]
mod sample;

/// Reads both parts of the second moment with meshio and checks every array.
const SCRIPT: &str = r#"
import sys, xml.etree.ElementTree as tree
import meshio, numpy as np
folder = sys.argv[1]
sets = tree.parse(folder + "/tank.pvd").getroot().findall("Collection/DataSet")
assert [(float(s.get("timestep")), s.get("part")) for s in sets] == [(t, p) for t in (0, 0.125) for p in "012"]
liquid, wall, bottom = (meshio.read(folder + "/" + s.get("file")) for s in sets[3:])
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
(block,) = bottom.cells
assert block.type == "quad" and block.data.shape == (1, 4)
assert np.ravel(bottom.point_data["contact pressure [Pa]"]).tolist() == [0, 100, 200, 400]
assert np.all(bottom.point_data["displacement [m]"][:, 2] == -0.03125)
assert np.ravel(bottom.cell_data["plastic rotation [rad]"][0]).tolist() == [0.0625]
print("read back")
"#;

pub(crate) fn meshio_reads_what_is_written(python: &Path) {
    let home = tempfile::tempdir().expect("a temporary folder");
    vtu::write(home.path(), &sample::snapshots()).expect("writable");
    let read = Command::new(python).args(["-c", SCRIPT]).arg(home.path()).output().expect("python3 runs");
    assert!(read.status.success(), "{}", String::from_utf8_lossy(&read.stderr));
    assert_eq!(String::from_utf8_lossy(&read.stdout).trim(), "read back");
}
