//! ParaView files of [`Snapshots`]: a collection `tank.pvd` of unstructured grids, one for every part and moment. A part without cells has none.
//!
//! ```text
//! tank.pvd ─┬─ liquid_0000.vtu   hexahedra: displacement at nodes, pressure in cells
//!           ├─ surface_0000.vtu  quadrilaterals: displacement at nodes
//!           ├─ wall_0000.vtu     quadrilaterals: displacement at nodes, stress resultants and seismic pressure in cells
//!           └─ bottom_0000.vtu   quadrilaterals: displacement and contact pressure at nodes, plastic rotation in cells
//! ```
//!
//! The format is VTK's XML, version 1.0: every array inline as base64 of its length in bytes (UInt64) and its values in
//! little-endian order. Coordinates are undeformed; ParaView's filter *Warp By Vector* shows the motion.

use std::fmt::Write;
use std::path::Path;

use super::base64::base64;
use super::{Snapshot, Snapshots, put};
use files::Kind;
use files::error::Error;

/// Name of the collection.
pub const COLLECTION: &str = "tank.pvd";

/// VTK's numbers of cell types.
const QUAD: u8 = 9;
const HEXAHEDRON: u8 = 12;

/// The folder of the files.
pub const FOLDER: Kind = Kind { id: "compare --vtu", option: "--vtu", names: owns, keeps: |_| false };

/// Whether we write files of this name.
fn owns(name: &str) -> bool {
    let stem = name.strip_suffix(".vtu").unwrap_or("");
    let number = ["liquid_", "surface_", "wall_", "bottom_"].iter().find_map(|part| stem.strip_prefix(part));
    name == COLLECTION || number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()))
}

/// Writes collection and grids into an existing folder.
///
/// Errors: a file that cannot be written.
pub fn write(folder: &Path, snapshots: &Snapshots) -> Result<(), Error> {
    let put = |name: &str, text: &str| put(&folder.join(name), text.as_bytes());
    let mut list = String::new();
    for (i, state) in snapshots.states.iter().enumerate() {
        let parts = [
            (!snapshots.liquid.is_empty()).then(|| (format!("liquid_{i:04}.vtu"), liquid(snapshots, state))),
            (!snapshots.surface.is_empty()).then(|| (format!("surface_{i:04}.vtu"), surface(snapshots, state))),
            (!snapshots.wall.is_empty()).then(|| (format!("wall_{i:04}.vtu"), wall(snapshots, state))),
            (!snapshots.bottom.is_empty()).then(|| (format!("bottom_{i:04}.vtu"), bottom(snapshots, state))),
        ];
        for (part, (name, text)) in parts.iter().flatten().enumerate() {
            put(name, text)?;
            let time = state.time;
            let _ = writeln!(list, r#"    <DataSet timestep="{time}" part="{part}" file="{name}"/>"#);
        }
    }
    let head = r#"<?xml version="1.0"?>
<VTKFile type="Collection" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <Collection>
"#;
    put(COLLECTION, &format!("{head}{list}  </Collection>\n</VTKFile>\n"))
}

fn liquid(snapshots: &Snapshots, state: &Snapshot) -> String {
    grid(snapshots, state, HEXAHEDRON, &snapshots.liquid, None, &[("pressure [Pa]", state.pressure.clone())])
}

fn surface(snapshots: &Snapshots, state: &Snapshot) -> String {
    grid(snapshots, state, QUAD, &snapshots.surface, None, &[])
}

fn bottom(snapshots: &Snapshots, state: &Snapshot) -> String {
    let arrays = [("plastic rotation [rad]", state.plastic.clone())];
    let ground = ("contact pressure [Pa]", state.ground.as_slice());
    grid(snapshots, state, QUAD, &snapshots.bottom, Some(ground), &arrays)
}

fn wall(snapshots: &Snapshots, state: &Snapshot) -> String {
    let of = |value: fn(&super::Resultants) -> f64| state.resultants.iter().map(value).collect();
    let mut arrays: Vec<(&str, Vec<f64>)> = vec![
        ("n_phi [N/m]", of(|r| r.n_phi)),
        ("n_v [N/m]", of(|r| r.n_v)),
        ("n_phi_v [N/m]", of(|r| r.n_phi_v)),
        ("m_phi [N]", of(|r| r.m_phi)),
        ("m_v [N]", of(|r| r.m_v)),
        ("m_phi_v [N]", of(|r| r.m_phi_v)),
        ("q_v [N/m]", of(|r| r.q_v)),
    ];
    if !state.on_wall.is_empty() {
        arrays.push(("seismic pressure [Pa]", state.on_wall.clone()));
    }
    if !state.cracks.is_empty() {
        arrays.push(("crack opening strain", state.cracks.clone()));
    }
    // Those that the engine does not compute.
    arrays.retain(|(_, values)| values.iter().any(|v| !v.is_nan()));
    grid(snapshots, state, QUAD, &snapshots.wall, None, &arrays)
}

/// One grid with the nodes its cells use.
///
/// * `scalar`: name and values of every node, besides the displacement
fn grid<const N: usize>(
    snapshots: &Snapshots,
    state: &Snapshot,
    kind: u8,
    cells: &[[usize; N]],
    scalar: Option<(&str, &[f64])>,
    arrays: &[(&str, Vec<f64>)],
) -> String {
    // Numbers of the nodes within this part, by first use.
    let mut own = vec![usize::MAX; snapshots.nodes.len()];
    let mut used = Vec::new();
    for &node in cells.iter().flatten() {
        if own[node] == usize::MAX {
            own[node] = used.len();
            used.push(node);
        }
    }
    let points = used.iter().flat_map(|&n| snapshots.nodes[n]);
    let displacement = used.iter().flat_map(|&n| state.displacement[n]);
    let connectivity = cells.iter().flatten().map(|&n| own[n] as i64);
    let offsets = (1..=cells.len()).map(|c| (c * N) as i64);
    let mut text = String::new();
    let _ = write!(
        text,
        r#"<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian" header_type="UInt64">
  <UnstructuredGrid>
    <Piece NumberOfPoints="{}" NumberOfCells="{}">
      <Points>
        {}
      </Points>
      <Cells>
        {}
        {}
        {}
      </Cells>
      <PointData>
        {}{}
      </PointData>
      <CellData>
"#,
        used.len(),
        cells.len(),
        array("Float64", "Points", 3, points.flat_map(f64::to_le_bytes)),
        array("Int64", "connectivity", 1, connectivity.flat_map(i64::to_le_bytes)),
        array("Int64", "offsets", 1, offsets.flat_map(i64::to_le_bytes)),
        array("UInt8", "types", 1, std::iter::repeat_n(kind, cells.len())),
        array("Float64", "displacement [m]", 3, displacement.flat_map(f64::to_le_bytes)),
        scalar.map_or_else(String::new, |(name, values)| {
            let own = used.iter().flat_map(|&n| values[n].to_le_bytes());
            format!("\n        {}", array("Float64", name, 1, own))
        }),
    );
    for (name, values) in arrays {
        let bytes = values.iter().flat_map(|v| v.to_le_bytes());
        let _ = writeln!(text, "        {}", array("Float64", name, 1, bytes));
    }
    text.push_str("      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n");
    text
}

/// A data array, inline and binary.
fn array(kind: &str, name: &str, components: usize, values: impl Iterator<Item = u8>) -> String {
    let values: Vec<u8> = values.collect();
    let mut bytes = (values.len() as u64).to_le_bytes().to_vec();
    bytes.extend(values);
    format!(
        r#"<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="binary">{}</DataArray>"#,
        base64(&bytes)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn own_files_are_known_by_name() {
        for name in ["tank.pvd", "liquid_0000.vtu", "wall_12345.vtu", "bottom_0001.vtu", "surface_0002.vtu"] {
            assert!(owns(name), "{name}");
        }
        for name in ["tank.vtu", "wall_.vtu", "wall_1.vtu.bak", "mesh_0000.vtu", "wall_a.vtu"] {
            assert!(!owns(name), "{name}");
        }
    }
}
