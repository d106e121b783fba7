//! States to write as ParaView files.

use results::{Resultants, Snapshot, Snapshots};

/// Two hexahedra on each other, the two faces of one side and the floor, at two moments; node 3 does not belong to a drawn cell.
pub(crate) fn snapshots() -> Snapshots {
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
        ground: (0..nodes.len()).map(|k| 100.0 * k as f64).collect(),
        plastic: vec![0.5 * time],
        ..Snapshot::default()
    };
    Snapshots {
        liquid: vec![hexahedron(lower, middle), hexahedron(middle, upper)],
        wall: vec![[0, 1, 6, 5], [5, 6, 10, 9]],
        bottom: vec![lower],
        states: vec![state(0.0), state(0.125)],
        nodes,
        ..Snapshots::default()
    }
}
