//! Sloshing between rigid walls: common parts of cylinders and rectangles.

use super::tank::{lowest, sloshing};
use super::{BULK_MODULUS, GRAVITY, Source};
use crate::elements::{Fluid4, FreeSurfaceLine, Strip};
use crate::{Failure, Reference};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{LiquidProperties, RotationPart, VolumePart};
use fem::mesh::grading::uniform;
use fem::model::Builder;

/// Example 8.1.
pub(super) const RADIUS: f64 = 1.83;

pub(super) const FILL: f64 = 1.525;

pub(super) fn liquid(volume: VolumePart, rotation: RotationPart) -> LiquidProperties {
    LiquidProperties { density: 1.0, bulk_modulus: BULK_MODULUS, volume, rotation }
}

pub(super) const PROTOTYPE: Source =
    Source { source: "independent prototype of the same element", kind: Reference::SecondFormulation };

pub(super) const POTENTIAL: Source =
    Source { source: "potential flow, ω² = (g λ/R) tanh(λ H/R), J_m'(λ) = 0", kind: Reference::ClosedForm };

/// The first two sloshing frequencies between vertical walls at two places: plane, or axisymmetric if the chart is
/// cylindrical and the first place is the axis.
pub(super) fn strip(
    chart: Chart,
    walls: [f64; 2],
    fill: f64,
    counts: [usize; 2],
    rotation: RotationPart,
) -> Result<Vec<f64>, Failure> {
    let plane = Strip { x: uniform(walls[0], walls[1], counts[0])?, z: uniform(0.0, fill, counts[1])? }.plane()?;
    let liquid = liquid(VolumePart::MeanDilatation, rotation);
    let mut builder = Builder::new();
    builder.nodes(&plane.nodes);
    for cell in &plane.cells {
        builder.element("liquid", Fluid4::new(cell, chart, 1.0, liquid)?);
    }
    for &line in &plane.surface {
        let x = line.map(|n| plane.nodes[n][0]);
        builder.element("surface", FreeSurfaceLine::new(line, x, chart, 1.0, GRAVITY)?);
    }
    plane.bottom_nodes.iter().for_each(|&n| builder.hold(n, Dof::Uz));
    let walls = plane.left_nodes.iter().chain(&plane.right_nodes);
    walls.for_each(|&n| builder.hold(n, Dof::Ux));
    let model = builder.build()?;
    let modes = lowest(&model, &Assembler::new(&model), 6)?;
    (0..2).map(|n| sloshing(&modes, n)).collect()
}
