//! Nodes of the wall: course joints, the liquid level, stiffening rings, and a fine layer above the clamped base.

use tank::{Shape, Tank};

use fem::liquid::scaled;

/// Elements over the height of the default mesh, outside the layer at the base.
const ELEMENTS: f64 = 30.0;

/// Elements of the default mesh within the layer at the base.
const BASE_ELEMENTS: f64 = 16.0;

/// Depth of the layer at the base in units of √(R t): three quarters of the decay length 2π/λ · 0.6 of the edge bending.
const BASE_LAYER: f64 = 3.0;

/// Share of the height of the wall within which a ring makes no node beside another; its place is exact without.
const NEAR_RING: f64 = 1e-3;

/// Heights of the wall nodes [m], from 0 to the top, with the index of each element's course.
///
/// Nodes lie at every course joint, at the liquid level `fill_height` and at stiffening rings. The layer of 3 √(R t) above the base (t of the
/// lowest course) has 16 elements, the wall as a whole 30; both counts are multiplied by `refine`. A strip has no
/// edge bending and no layer.
pub fn wall_nodes(tank: &Tank, fill_height: f64, refine: f64) -> (Vec<f64>, Vec<usize>) {
    let height = tank.wall_height();
    let layer = match tank.shape {
        Shape::Cylinder { radius } => (BASE_LAYER * (radius * tank.courses[0].thickness).sqrt()).min(height),
        Shape::Rectangle { .. } => 0.0,
    };
    let mut joints = vec![0.0];
    for course in &tank.courses {
        joints.push(joints[joints.len() - 1] + course.height);
    }
    *joints.last_mut().expect("the base is always there") = height;

    // Breakpoints closer than this are merged; otherwise elements between them become slivers.
    let merge = 1e-6 * height;
    let mut cuts = joints.clone();
    for extra in [fill_height.min(height), layer] {
        if cuts.iter().all(|c| (c - extra).abs() > merge) {
            cuts.push(extra);
        }
    }
    for ring in &tank.rings {
        if cuts.iter().all(|c| (c - ring.height).abs() > NEAR_RING * height) && ring.height < height {
            cuts.push(ring.height);
        }
    }
    cuts.sort_by(f64::total_cmp);

    let coarse = height / scaled(ELEMENTS, refine) as f64;
    let fine = layer / scaled(BASE_ELEMENTS, refine) as f64;
    let (mut nodes, mut course) = (vec![0.0], Vec::new());
    for pair in cuts.windows(2) {
        let middle = 0.5 * (pair[0] + pair[1]);
        let size = if middle < layer { fine.min(coarse) } else { coarse };
        let count = ((pair[1] - pair[0]) / size - 1e-9).ceil().max(1.0) as usize;
        let owner = joints.windows(2).position(|j| middle < j[1]).unwrap_or(tank.courses.len() - 1);
        for k in 1..=count {
            let last = k == count;
            nodes.push(if last { pair[1] } else { pair[0] + (pair[1] - pair[0]) * k as f64 / count as f64 });
            course.push(owner);
        }
    }
    (nodes, course)
}

#[cfg(test)]
mod tests {
    use super::*;
    use tank::{Course, Material, Roof, Support};

    fn tank() -> Tank {
        let material = Material {
            family: Some(tank::Family::Aluminium),
            name: "aluminium".into(),
            youngs_modulus: 69e9,
            poisson_ratio: 0.32,
            density: 2750.0,
            yield_strength: None,
            allowable_stress: None,
            behaviour: Default::default(),
            volume_change: Default::default(),
        };
        let course = |thickness| Course {
            height: 0.915,
            thickness,
            corrosion: 0.0,
            material: material.clone(),
            layers: Vec::new(),
        };
        Tank {
            details: tank::Details::default(),
            shape: Shape::Cylinder { radius: 1.83 },
            support: Support::Anchored,
            courses: vec![course(2.03e-3), course(1.27e-3)],
            roof: Roof::default(),
            bottom: None,
            wall_base: tank::WallBase::Fixed,
            foundation: None,
            isolators: None,
            staging: None,
            rings: Vec::new(),
            attachments: Vec::new(),
            subsoil: tank::Subsoil::default(),
            insulation: None,
            anchors: None,
            pressure: Default::default(),
            pipes: None,
        }
    }

    #[test]
    fn nodes_lie_where_the_wall_changes() {
        let (nodes, course) = wall_nodes(&tank(), 1.525, 1.0);
        assert_eq!(nodes.len(), course.len() + 1);
        for z in [0.0, 0.915, 1.525, 1.83] {
            assert!(nodes.iter().any(|n| (n - z).abs() < 1e-12), "no node at {z}");
        }
        let layer = 3.0 * (1.83_f64 * 2.03e-3).sqrt();
        assert_eq!(nodes.iter().filter(|&&z| z <= layer * (1.0 + 1e-9)).count(), 17);
        for (pair, &c) in nodes.windows(2).zip(&course) {
            assert!(pair[1] > pair[0]);
            assert_eq!(c, usize::from(pair[0] > 0.914), "course of the element above {}", pair[0]);
        }
    }
}
