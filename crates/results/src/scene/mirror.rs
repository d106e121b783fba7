//! A whole tank from its half y ≥ 0.

use crate::{DrawnMode, Resultants, Snapshot, Snapshots};

/// The whole of a half; none of a tank that is whole. Its liquid stays half.
pub(super) fn whole(half: &Snapshots) -> Option<Snapshots> {
    if !half.half {
        return None;
    }
    let size = half.nodes.iter().flatten().fold(0.0_f64, |m, v| m.max(v.abs()));
    // The image of a node on the plane is the node.
    let mut images = Vec::new();
    let mut image = vec![0; half.nodes.len()];
    for (node, place) in half.nodes.iter().enumerate() {
        image[node] = match place[1].abs() <= 1e-9 * size {
            true => node,
            false => {
                images.push(node);
                half.nodes.len() + images.len() - 1
            }
        };
    }
    let points = |own: &[[f64; 3]]| -> Vec<[f64; 3]> {
        let mirrored = images.iter().map(|&n| [own[n][0], -own[n][1], own[n][2]]);
        own.iter().copied().chain(mirrored).collect()
    };
    // Backwards, so that the outer face stays the outer one.
    let cells = |own: &[[usize; 4]]| -> Vec<[usize; 4]> {
        let mirrored = own.iter().map(|[a, b, c, d]| [b, a, d, c].map(|n| image[*n]));
        own.iter().copied().chain(mirrored).collect()
    };
    let state = |own: &Snapshot| Snapshot {
        time: own.time,
        displacement: points(&own.displacement),
        pressure: own.pressure.clone(),
        on_wall: twice(&own.on_wall),
        resultants: own.resultants.iter().copied().chain(own.resultants.iter().map(turned)).collect(),
        cracks: twice(&own.cracks),
        ground: own.ground.iter().copied().chain(images.iter().filter_map(|n| own.ground.get(*n)).copied()).collect(),
        plastic: twice(&own.plastic),
    };
    let mode = |own: &DrawnMode| DrawnMode {
        title: own.title.clone(),
        frequency: own.frequency,
        displacement: points(&own.displacement),
    };
    Some(Snapshots {
        nodes: points(&half.nodes),
        liquid: half.liquid.clone(),
        wall: cells(&half.wall),
        thickness: twice(&half.thickness),
        surface: cells(&half.surface),
        bottom: cells(&half.bottom),
        sides: cells(&half.sides),
        whole: half.whole,
        half: false,
        modes: half.modes.iter().map(mode).collect(),
        states: half.states.iter().map(state).collect(),
    })
}

fn twice(values: &[f64]) -> Vec<f64> {
    values.iter().chain(values).copied().collect()
}

/// Shears change their sign.
fn turned(own: &Resultants) -> Resultants {
    Resultants { n_phi_v: -own.n_phi_v, m_phi_v: -own.m_phi_v, ..*own }
}
