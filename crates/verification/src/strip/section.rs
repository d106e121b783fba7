//! Cracking and yield of the base section.

use std::sync::Arc;

use materials::bar::Bar;
use materials::concrete::{Compression, Softening, Tension, UniaxialConcrete};

use super::{CONCRETE, G, HEIGHT, PLANE_MODULUS, THICKNESS, law_error, plain_section};
use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::strip::StripError;
use fem::element::beam_section::{CurvaturePoint, FibreSection};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "strip-section",
    title: "Section of the wall of strip 8.4",
    model: "Fibres of 30 cm of concrete with bars of 7.0 cm²/m on each face, under its own weight: moments over \
            curvature.",
    ids: &[("section", "cracking and yield moments of the base section")],
    parts: &[Part::Fast(section)],
};

/// f_t and f_c of the concrete [Pa].
const TENSION: f64 = 3.5e6;

const COMPRESSION: f64 = 35e6;

/// Young's modulus and yield stress of the bars [Pa].
const BAR: [f64; 2] = [210e9, 500e6];

/// Area [m²/m] and depth [m] of the bars of one face.
const BARS: [f64; 2] = [7e-4, 0.115];

/// The section of the dissertation: concrete of 35 N/mm² that softens over the strain `softening`, bars of 7 cm²/m at each
/// face.
pub(super) fn reinforced(layers: usize, softening: f64) -> Result<FibreSection, StripError> {
    with_bars_of(plain_section(Arc::new(concrete(softening)?), layers)?)
}

fn with_bars_of(section: FibreSection) -> Result<FibreSection, StripError> {
    let bar = Bar::new(BAR[0], BAR[1], 2.1e9).map_err(law_error)?;
    let [area, depth] = BARS;
    Ok(section.bars(Arc::new(bar), &[[-depth, area], [depth, area]])?)
}

/// Bending stiffness of the bars of both faces [N m²/m].
pub(super) fn bars_bending() -> f64 {
    let [area, depth] = BARS;
    2.0 * BAR[0] * area * depth * depth
}

/// Concrete that never carries tension.
fn cracked_concrete() -> Result<UniaxialConcrete, StripError> {
    let compression = Compression::Plastic { strength: COMPRESSION };
    UniaxialConcrete::new(PLANE_MODULUS, compression, None).map_err(law_error)
}

/// Softening over this strain; brittle over none.
pub(super) fn softening(strain: f64) -> Softening {
    if strain == 0.0 { Softening::Brittle } else { Softening::Strain { softening_strain: strain } }
}

fn concrete(strain: f64) -> Result<UniaxialConcrete, StripError> {
    let tension = Tension { strength: TENSION, softening: softening(strain), stiffening: None, bond: None };
    let compression = Compression::Plastic { strength: COMPRESSION };
    UniaxialConcrete::new(PLANE_MODULUS, compression, Some(tension)).map_err(law_error)
}

/// Moment at the first point of the line where `reached` holds, interpolated linearly in the value of `reached` around 1.
fn crossing(line: &[CurvaturePoint], reached: impl Fn(&CurvaturePoint) -> f64) -> f64 {
    let at = line.iter().position(|p| reached(p) >= 1.0);
    match at {
        Some(i) if i > 0 => {
            let (a, b) = (&line[i - 1], &line[i]);
            let (ra, rb) = (reached(a), reached(b));
            a.moment + (1.0 - ra) / (rb - ra) * (b.moment - a.moment)
        }
        _ => f64::NAN,
    }
}

/// Rows of the base section under the weight of the wall: moment at the first crack without and with bars, yield moment.
///
/// Errors: those of the section.
pub(crate) fn section() -> Answer {
    let axial = -CONCRETE * G * THICKNESS * HEIGHT;
    // Cracking at κ = 6.8e-4, yield at 1.2e-2 1/m.
    let curvatures: Vec<f64> = (0..4000).map(|i| 5e-6 * f64::from(i)).collect();
    let edge = |p: &CurvaturePoint| (p.strain + 0.5 * THICKNESS * p.curvature) * PLANE_MODULUS / TENSION;
    let plain_inertia = THICKNESS.powi(3) / 12.0;
    let cracking = (TENSION - axial / THICKNESS) * plain_inertia / (0.5 * THICKNESS);
    // Transformed section, the concrete that the bars displace not taken off.
    let (n, [area, depth]) = (BAR[0] / PLANE_MODULUS, BARS);
    let with_bars = (TENSION - axial / (THICKNESS + 2.0 * n * area)) * (plain_inertia + 2.0 * n * area * depth * depth)
        / (0.5 * THICKNESS);
    let mut rows = Vec::new();
    let layers = 30;
    // The edge between the last fibre and the surface: by the strain of the edge itself, so the layers do not matter until
    // the first fibre cracks, which is later.
    let plain = plain_section(Arc::new(concrete(3e-4)?), layers)?.moment_curvature(axial, &curvatures[..400])?;
    let reinforced = reinforced(layers, 3e-4)?.moment_curvature(axial, &curvatures)?;
    rows.push(Row::new(
        "section",
        "strip 8.4, base section without bars: moment when the edge reaches f_t",
        (cracking, "(f_t + N/A) h²/6", Reference::ClosedForm),
        crossing(&plain, edge),
        (1e-3, "Nm/m"),
    ));
    rows.push(Row::new(
        "section",
        "strip 8.4, base section with bars: moment when the edge reaches f_t",
        (with_bars, "transformed section", Reference::ClosedForm),
        crossing(&reinforced, edge),
        (1e-3, "Nm/m"),
    ));
    let yields = |line: &[CurvaturePoint]| {
        let bar = line[0].fibres.len() - 1;
        crossing(line, |p| p.fibres[bar].strain * BAR[0] / BAR[1])
    };
    let no_tension = with_bars_of(plain_section(Arc::new(cracked_concrete()?), 100)?)?;
    let cracked = no_tension.moment_curvature(axial, &curvatures)?;
    let reference = (cracked_yield(axial), "cracked section without tension", Reference::ClosedForm);
    rows.push(Row::new(
        "section",
        "strip 8.4, base section, concrete without tension: moment when the bars yield",
        reference,
        yields(&cracked),
        // The layer at the neutral axis: a tenth of the compression zone's depth, squared.
        (5e-3, "Nm/m"),
    ));
    rows.push(Row::new(
        "section",
        "strip 8.4, base section, softening concrete: moment when the bars yield (reference without tension)",
        reference,
        yields(&reinforced),
        (f64::INFINITY, "Nm/m"),
    ));
    Ok(rows)
}

/// Moment of the cracked elastic section when the bars of the tensile face reach f_y, with the compression zone found by
/// bisection of the normal force.
fn cracked_yield(axial: f64) -> f64 {
    let [area, depth] = BARS;
    let yield_strain = BAR[1] / BAR[0];
    // x: depth of the compression zone from the face at −h/2.
    let state = |x: f64| {
        let curvature = yield_strain / (0.5 * THICKNESS + depth - x);
        let force = |zeta: f64| area * BAR[0] * curvature * (zeta + 0.5 * THICKNESS - x);
        let concrete = -0.5 * PLANE_MODULUS * curvature * x * x;
        let normal = concrete + force(depth) + force(-depth);
        let moment = concrete * (x / 3.0 - 0.5 * THICKNESS) + depth * (force(depth) - force(-depth));
        (normal, moment)
    };
    let (mut low, mut high) = (0.0, 0.5 * THICKNESS);
    for _ in 0..100 {
        let x = 0.5 * (low + high);
        if state(x).0 > axial {
            low = x;
        } else {
            high = x;
        }
    }
    state(low).1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Without normal force and with bars of the tensile face alone the neutral axis is the root of ½ b x² = n A_s (d − x);
    /// here the bars of the other face lie near the axis and change little.
    #[test]
    fn cracked_section_by_hand() {
        let (n, [area, depth]) = (BAR[0] / PLANE_MODULUS, BARS);
        let d = 0.5 * THICKNESS + depth;
        let x = -n * area + ((n * area).powi(2) + 2.0 * n * area * d).sqrt();
        let moment = area * BAR[1] * (d - x / 3.0);
        let found = cracked_yield(0.0);
        assert!((found / moment - 1.0).abs() < 0.01, "{found} {moment}");
    }
}
