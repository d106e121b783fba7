//! From the layers of a wall to the levels and sections of its strip.

use std::sync::Arc;

use fem::element::beam_section::FibreSection;
use materials::Law;
use materials::elastic::Elastic;
use materials::von_mises::VonMises;
use tank::Case;
use tank::{BarDirection, Behaviour, Course, Layer, LayerKind};

use crate::FeError;
use crate::error::failed;
use crate::nonlinear::laws::{bar_law, quadrature, refused, uniaxial_concrete, unsupported};
use tank::options::nonlinear::{NonlinearOptions, ThicknessRule};

/// Share of the bending stiffness below which a leaf other than the main one is not modelled.
const NEGLIGIBLE: f64 = 1e-2;

/// Nodes over the wall: every joint of the courses and the surface is one, elements of nearly equal length.
pub(crate) fn levels(case: &Case, elements: u32) -> Vec<f64> {
    let mut marks = vec![0.0, case.liquid.fill_height];
    let mut top = 0.0;
    for course in &case.tank.courses {
        top += course.height;
        marks.push(top);
    }
    marks.sort_by(f64::total_cmp);
    // Marks closer than this are merged.
    marks.dedup_by(|b, a| (*b - *a).abs() < 1e-6 * top);
    let longest = top / f64::from(elements.max(1));
    let mut z = vec![0.0];
    for ends in marks.windows(2) {
        let count = ((ends[1] - ends[0]) / longest).round().max(1.0);
        z.extend((1..=count as usize).map(|i| ends[0] + (ends[1] - ends[0]) * i as f64 / count));
    }
    z
}

/// Course at the height `z` [m].
pub(super) fn course_at(case: &Case, z: f64) -> &Course {
    let mut top = 0.0;
    let courses = &case.tank.courses;
    let above = |c: &&Course| {
        top += c.height;
        z < top
    };
    courses.iter().find(above).unwrap_or(&courses[courses.len() - 1])
}

/// The leaf of a wall that bends: the stiffest one between interlayers.
///
/// Errors: a wall without layers, or with two leaves of similar stiffness.
pub(crate) fn main_leaf(layers: &[Layer]) -> Result<&[Layer], FeError> {
    let leaves: Vec<&[Layer]> = layers.split(|l| l.kind == LayerKind::Interlayer).collect();
    let stiffness = |leaf: &[Layer]| -> f64 {
        let height: f64 = leaf.iter().map(|l| l.thickness).sum();
        leaf.iter().map(|l| l.material.youngs_modulus).fold(0.0, f64::max) * height.powi(3)
    };
    let all: f64 = leaves.iter().map(|leaf| stiffness(leaf)).sum();
    let Some(main) = leaves.iter().copied().max_by(|a, b| stiffness(a).total_cmp(&stiffness(b))) else {
        return unsupported("a wall without layers");
    };
    if stiffness(main) < (1.0 - NEGLIGIBLE) * all {
        return unsupported(
            "the strip engine models one bending leaf; both leaves of this sandwich contribute to the stiffness",
        );
    }
    Ok(main)
}

/// Section of a wall of 1 m breadth on an element of length `element` [m]: the leaf that carries the bending, the others as
/// mass.
pub(crate) fn section(layers: &[Layer], element: f64, options: &NonlinearOptions) -> Result<FibreSection, FeError> {
    let main = main_leaf(layers)?;
    let mass = |layers: &[Layer]| -> f64 { layers.iter().map(|l| l.material.density * l.thickness).sum() };
    let own = mass(main);
    let mut section = FibreSection::new(own).and_then(|s| s.with_attached_mass(mass(layers) - own)).map_err(failed)?;
    // ζ from the middle of the leaf, towards the outside.
    let height: f64 = main.iter().map(|l| l.thickness).sum();
    let mut inner = -0.5 * height;
    let mut bars: Vec<(Arc<dyn Law<1>>, [f64; 2])> = Vec::new();
    for layer in main {
        let (law, rule) = fibre_law(layer, element, options)?;
        let centre = inner + 0.5 * layer.thickness;
        section = match rule {
            ThicknessRule::MidPoint(n) => section.rectangle(law, [1.0, layer.thickness], centre, n as usize),
            rule => section.fibres(law, &fibres(rule, centre, layer.thickness)?),
        }
        .map_err(failed)?;
        for bar in layer.reinforcement.iter().filter(|b| b.direction == BarDirection::Vertical) {
            bars.push((bar_law(&bar.material)?, [inner + bar.depth, bar.area]));
        }
        inner += layer.thickness;
    }
    for (law, fibre) in bars {
        section = section.bars(law, &[fibre]).map_err(failed)?;
    }
    Ok(section)
}

/// Depths and areas of a quadrature over a layer of 1 m breadth.
fn fibres(rule: ThicknessRule, centre: f64, thickness: f64) -> Result<Vec<[f64; 2]>, FeError> {
    let rule = quadrature(rule);
    let points = rule.points().map_err(failed)?;
    Ok(points.iter().map(|&(x, w)| [centre + 0.5 * thickness * x, 0.5 * thickness * w]).collect())
}

/// Law of a fibre along the wall, and its quadrature. Plane strain across the strip: E/(1 − ν²).
fn fibre_law(
    layer: &Layer,
    element: f64,
    options: &NonlinearOptions,
) -> Result<(Arc<dyn Law<1>>, ThicknessRule), FeError> {
    let material = &layer.material;
    let nu = material.poisson_ratio;
    let young = material.youngs_modulus / (1.0 - nu * nu);
    Ok(match material.behaviour {
        Behaviour::Elastic | Behaviour::Interlayer(_) => {
            (Arc::new(Elastic::new(young, 0.0).map_err(refused)?), options.integration.elastic)
        }
        Behaviour::Steel(steel) => {
            // In plane strain a plate yields at 2/√3 of its strength.
            let strength = 2.0 / 3.0_f64.sqrt() * steel.yield_strength;
            let law = VonMises::new(young, 0.0, strength, steel.tangent_modulus, steel.kinematic_share);
            (Arc::new(law.map_err(refused)?), options.integration.steel)
        }
        Behaviour::Concrete(concrete) => {
            (Arc::new(uniaxial_concrete(&concrete, young, layer, element)?), options.integration.concrete)
        }
        Behaviour::Reinforcement(_) => return unsupported(format!("`{}` is for bars, not for a layer", material.name)),
    })
}
