//! Table 5.4: the strip of (5.69), 5 × 5 m, as a spatial element one element thin in the cylindrical chart.
//!
//! ```text
//! Δθ = const   sector of 1°, 5 m ≤ r ≤ 10 m, 1 × 8 × 8     J₁(ka) Y₁(kb) = J₁(kb) Y₁(ka)      ω² = g k tanh(k H)
//! Δr = const   sector of 1° at r = 286.5 m, 8 × 1 × 8       k = π/(r Δθ)
//! ```
//!
//! The figure with the radii is not in the text at hand: "radial distance 5.0 m" is read as the inner radius. Each model
//! is compared with the exact frequency of its geometry; that of the sector of a ring differs from the strip's by
//! 0.9 %, which is why the dissertation sees up to 3 % "from the geometry".

use nalgebra::Matrix3;

use super::tank::{lowest, sloshing};
use super::{BULK_MODULUS, GRAVITY, Source};
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{Fluid8, FreeSurface, LiquidProperties};
use fem::mesh::Rectangle;
use fem::mesh::grading::uniform;
use fem::model::Builder;

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-disc",
    title: "Degenerate discs of table 5.4",
    model: "Strip of (5.69), 5 × 5 m, as spatial elements one element thin in the cylindrical chart: a sector of \
            1° and a ring of one element.",
    ids: &[("table-5.4", "discs one element thin, dissertation table 5.4")],
    parts: &[Part::Fast(degenerate_discs)],
};

const FILL: f64 = 5.0;

const ANGLE: f64 = std::f64::consts::PI / 180.0;

/// First sloshing frequency of a sector between rigid walls.
fn frequency(r: [f64; 2], counts: [usize; 3]) -> Result<f64, Failure> {
    // A block in (r, θ, z).
    let block = Rectangle {
        x: uniform(r[0], r[1], counts[0])?,
        y: uniform(0.0, ANGLE, counts[1])?,
        z: uniform(0.0, FILL, counts[2])?,
    }
    .block()?;
    let chart = Chart::Cylindrical;
    let liquid = LiquidProperties::new(1.0, BULK_MODULUS, GRAVITY, 2.5);
    let mut builder = Builder::new();
    for (node, &place) in block.nodes.iter().enumerate() {
        builder.node(chart.position(place));
        let (s, c) = place[1].sin_cos();
        builder.frame(node, Matrix3::new(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0));
    }
    for cell in &block.cells {
        builder.element("liquid", Fluid8::new(cell, chart, liquid)?);
    }
    for face in &block.surface.faces {
        builder.element("surface", FreeSurface::new(face, chart, GRAVITY)?);
    }
    for side in &block.x_walls {
        side.nodes.iter().for_each(|&n| builder.hold(n, Dof::Ux));
    }
    for side in &block.y_walls {
        side.nodes.iter().for_each(|&n| builder.hold(n, Dof::Uy));
    }
    block.bottom.nodes.iter().for_each(|&n| builder.hold(n, Dof::Uz));
    let model = builder.build()?;
    sloshing(&lowest(&model, &Assembler::new(&model), 3)?, 0)
}

/// ω² = g k tanh(k H).
fn exact(k: f64) -> f64 {
    (GRAVITY * k * (k * FILL).tanh()).sqrt()
}

/// The two spatial models of table 5.4.
///
/// Errors: none to be expected.
pub(crate) fn degenerate_discs() -> Answer {
    let against = Source { source: "potential flow in the sector", kind: Reference::ClosedForm };
    let printed =
        Source { source: "dissertation, (5.69); \"about 3 %\" for the spatial models", kind: Reference::Dissertation };
    // First root of J₁(x) Y₁(2x) = J₁(2x) Y₁(x): x = 3.19658 (Abramowitz & Stegun 1964, table 9.7).
    let ring = exact(3.19658 / 5.0);
    let arc = exact(std::f64::consts::PI / (286.5 * ANGLE));
    let mut rows = Vec::new();
    for (name, reference, r, counts) in
        [("Δθ = const", ring, [5.0, 10.0], [8, 1, 8]), ("Δr = const", arc, [286.45, 286.55], [1, 8, 8])]
    {
        let coarse = frequency(r, counts.map(|n: usize| n.div_ceil(2)))?;
        let found = frequency(r, counts)?;
        // 8 elements along half a wave: (π/8)²/24 = 0.64 % is the error of linear elements.
        let mut row = against.row("table-5.4", format!("{name}, ω₁"), (reference, found), 6.4e-3, "rad/s");
        row.convergence = vec![(16.0, coarse / reference - 1.0), (64.0, found / reference - 1.0)];
        rows.push(row);
        rows.push(printed.row("table-5.4", format!("{name}, ω₁"), (2.5, found), 0.03, "rad/s"));
    }
    Ok(rows)
}
