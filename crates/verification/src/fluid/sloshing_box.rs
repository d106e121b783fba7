//! Box of Code_Aster's test V8.21.101: L = 0.8 m, H = 0.3 m, ρ = 1000 kg/m³, c = 1400 m/s, g = 9.81 m/s².
//!
//! ```text
//! sloshing  ω² = (nπg/L) tanh(nπH/L)        acoustic  f = (c/2) √((i/L)² + ((2j − 1)/2H)²)
//! ```
//!
//! Plane elements, K = ρ c². The spectrum of the displacement element has three bands: sloshing (0.9 to a few Hz),
//! rotational modes that the penalty makes (here below 140 Hz: they run at √(K₁/2ρ) = 4.4 m/s and elements of size h
//! carry at most √24/h of it, 173 Hz), acoustic modes. They are classified by their potential energy: lift of the surface, volume, or neither. The penalty is the
//! default; the acoustic modes are found by a shift between them.

use std::sync::Arc;

use super::Source;
use super::tank::{missing, search, sloshing};
use crate::elements::{Fluid4, FreeSurfaceLine, Strip};
use crate::{Answer, Benchmark, Failure, Part, Reference};
use fem::assembly::Assembler;
use fem::chart::Chart;
use fem::dofs::Dof;
use fem::element::{LiquidProperties, RotationPart};
use fem::linalg::{Ordering, Pencil, Search, Sparse, Symbolic, dot};
use fem::mesh::grading::uniform;
use fem::model::{Builder, Model};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "fluid-box",
    title: "Sloshing and acoustic modes of a box",
    model: "Code_Aster V8.21.101: L = 0.8 m, H = 0.3 m, ρ = 1000 kg/m³, c = 1400 m/s, g = 9.81 m/s²; plane \
            `fluid4`, default penalty, modes classified by their energies.",
    ids: &[("V8.21.101", "sloshing and acoustic modes, Code_Aster V8.21.101")],
    parts: &[Part::Fast(sloshing_box)],
};

const LENGTH: f64 = 0.8;

const FILL: f64 = 0.3;

const DENSITY: f64 = 1000.0;

const SOUND: f64 = 1400.0;

const GRAVITY: f64 = 9.81;

fn build(counts: [usize; 2], liquid: LiquidProperties) -> Result<Model, Failure> {
    let plane = Strip { x: uniform(0.0, LENGTH, counts[0])?, z: uniform(0.0, FILL, counts[1])? }.plane()?;
    let mut builder = Builder::new();
    builder.nodes(&plane.nodes);
    for cell in &plane.cells {
        builder.element("liquid", Fluid4::new(cell, Chart::Cartesian, 1.0, liquid)?);
    }
    for &line in &plane.surface {
        let x = line.map(|n| plane.nodes[n][0]);
        let surface = FreeSurfaceLine::new(line, x, Chart::Cartesian, 1.0, DENSITY * GRAVITY)?;
        builder.element("surface", surface);
    }
    plane.bottom_nodes.iter().for_each(|&n| builder.hold(n, Dof::Uz));
    let walls = plane.left_nodes.iter().chain(&plane.right_nodes);
    walls.for_each(|&n| builder.hold(n, Dof::Ux));
    Ok(builder.build()?)
}

/// Five sloshing and two acoustic frequencies [Hz], the number of modes up to the fifth sloshing mode that are not
/// sloshing, and the number of modes between 200 and 1100 Hz.
fn frequencies(counts: [usize; 2]) -> Result<(Vec<f64>, Vec<f64>, usize, usize), Failure> {
    let tau = std::f64::consts::TAU;
    let liquid = LiquidProperties::new(DENSITY, DENSITY * SOUND * SOUND, GRAVITY, 0.5 * LENGTH);
    let model = build(counts, liquid)?;
    let assembler = Assembler::new(&model);
    let (low, _) = search(&model, &assembler, &Search::lowest(5))?;
    let slow: Vec<f64> = (0..5).map(|n| Ok(sloshing(&low, n)? / tau)).collect::<Result<_, Failure>>()?;
    let other = low.iter().filter(|m| m.surface < 0.5).count();
    // The middle of the two frequencies squared.
    let (high, shapes) = search(&model, &assembler, &Search::around(tau * 1320.0, 2))?;
    let none = LiquidProperties { rotation: RotationPart::None, ..liquid };
    let twin = build(counts, none)?;
    let (whole, volume) = (assembler.stiffness(&model)?, assembler.stiffness(&twin)?);
    let fast: Vec<f64> = high
        .iter()
        .enumerate()
        .filter(|(j, mode)| {
            let x = shapes.column(*j);
            dot(x, &volume.times(x)) / dot(x, &whole.times(x)) - mode.surface > 0.5
        })
        .map(|(_, mode)| mode.omega / tau)
        .collect();
    if fast.len() < 2 {
        return Err(missing("two acoustic modes", high.len()));
    }
    let mass = assembler.mass(&model);
    let symbolic = Arc::new(Symbolic::new(assembler.pattern().clone(), &Ordering::MinimumDegree)?);
    let pencil = Sparse::new(&whole, &mass, symbolic);
    let below = |hertz: f64| pencil.count_below((tau * hertz).powi(2));
    let between = below(1100.0)? - below(200.0)?;
    Ok((slow, fast, other, between))
}

/// The seven frequencies on 40 × 15 elements, with their convergence.
///
/// Tolerance 0.5 % as asked on at most 40 × 15.
///
/// Errors: none to be expected.
pub(crate) fn sloshing_box() -> Answer {
    let against = Source { source: "Code_Aster V8.21.101", kind: Reference::Published };
    let meshes = [[10, 4], [20, 8], [40, 15]];
    let found: Vec<_> = meshes.iter().map(|&m| frequencies(m)).collect::<Result<_, _>>()?;
    let published = [0.898250, 1.38452, 1.70952, 1.97551, 2.20885, 1166.67, 1458.33];
    let value = |mesh: usize, n: usize| {
        let (slow, fast, ..) = &found[mesh];
        if n < 5 { slow[n] } else { fast[n - 5] }
    };
    let mut rows = Vec::new();
    for (n, reference) in published.into_iter().enumerate() {
        let what = match n {
            0..5 => format!("40 × 15, sloshing mode {}", n + 1),
            _ => format!("40 × 15, acoustic mode {}", n - 4),
        };
        let mut row = against.row("V8.21.101", what, (reference, value(2, n)), 5e-3, "Hz");
        row.convergence =
            meshes.iter().enumerate().map(|(k, m)| ((m[0] * m[1]) as f64, value(k, n) / reference - 1.0)).collect();
        rows.push(row);
    }
    let own = Source { source: "every mode below the fifth is a sloshing mode", kind: Reference::ClosedForm };
    rows.push(own.row("V8.21.101", "40 × 15, other modes below", (0.0, found[2].2 as f64), 0.0, "modes"));
    let gap = Source { source: "bound of the rotational modes, √(K₁/2ρ) √24/h", ..own };
    rows.push(gap.row("V8.21.101", "40 × 15, modes between 200 and 1100 Hz", (0.0, found[2].3 as f64), 0.0, "modes"));
    Ok(rows)
}
