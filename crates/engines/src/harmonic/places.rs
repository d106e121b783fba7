//! Places on the wall at which outputs over the height are observed.

use super::wall::Wall;

/// How close the places are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Places {
    /// As in the results: nodes, and mid-points of long elements.
    Usual,
    /// Mid-points of all elements too: a largest value lies between two places, and a second mesh with the same places would
    /// not see what both miss.
    Dense,
}

/// A place on the wall: height, and the elements whose rows are averaged there.
pub(super) struct Place {
    /// Height [m].
    pub(super) z: f64,
    /// Elements and their coordinates ξ.
    pub(super) at: Vec<(usize, f64)>,
}

/// Wall nodes, mid-points of long elements (of all if `places` asks for it), and both sides of a course joint.
pub(super) fn places(wall: &Wall, places: Places) -> Vec<Place> {
    let long = match places {
        Places::Usual => 0.5 * wall.nodes[wall.nodes.len() - 1] / 30.0,
        Places::Dense => 0.0,
    };
    let mut found = Vec::new();
    for (e, element) in wall.elements.iter().enumerate() {
        let joint = e > 0 && {
            let below = &wall.elements[e - 1];
            below.thickness != element.thickness || below.material != element.material
        };
        let z = element.bottom;
        match e {
            0 => found.push(Place { z, at: vec![(0, -1.0)] }),
            _ if joint => {
                found.push(Place { z, at: vec![(e - 1, 1.0)] });
                found.push(Place { z, at: vec![(e, -1.0)] });
            }
            _ => found.push(Place { z, at: vec![(e - 1, 1.0), (e, -1.0)] }),
        }
        if element.length > long {
            found.push(Place { z: z + 0.5 * element.length, at: vec![(e, 0.0)] });
        }
    }
    let top = wall.elements.len() - 1;
    found.push(Place { z: wall.nodes[top + 1], at: vec![(top, 1.0)] });
    found
}
