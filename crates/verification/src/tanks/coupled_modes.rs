//! F9 to F11 and F16: liquid and flexible wall.
//!
//! The references of F9 and F11 are converged values of independent three-dimensional and harmonic assemblies (theory
//! manual, section on coupled frequencies), those of F10 the published coefficients C_i of Malhotra, Wenk & Wieland 2000.

use std::f64::consts::PI;

use crate::{Answer, Benchmark, Part, Reference, Row};
use engines::harmonic::build;
use engines::modes::{CoupledMode, Kind, solve};
use engines::{FeError, Options};
use tank::Shape;
use tank::reference::{broad, case, material, slender};

/// The page.
pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "coupled-modes",
    title: "Coupled modes of wall and liquid",
    model: "Harmonic engine: potential liquid condensed to the wall, shell of revolution clamped at the base, \
            default mesh. Tanks 8.1 and 8.3 of the dissertation, and a steel tank of R = 10 m, 10 mm at eight \
            slendernesses.",
    ids: &[
        ("F9", "first bulging mode of tanks 8.1 and 8.3"),
        ("F10", "first bulging mode over the slenderness"),
        ("F11", "effective masses of the first sloshing and bulging modes"),
        ("F16", "no spurious mode below the first bulging mode"),
    ],
    parts: &[Part::Fast(rows), Part::Fast(published_rows)],
};

const ASSEMBLIES: &str = "converged independent assemblies";

const MALHOTRA: &str = "C_i of Malhotra, Wenk & Wieland 2000 (EN 1998-4:2006 table A.2)";

fn modes(case: &tank::Case) -> Result<Vec<CoupledMode>, FeError> {
    let coupled = build(case, &Options::default(), 1)?;
    solve(&coupled, Some(coupled.surface.unknowns.len() + 3))
}

fn first(modes: &[CoupledMode], kind: Kind) -> Result<&CoupledMode, FeError> {
    modes
        .iter()
        .find(|m| m.kind == kind)
        .ok_or_else(|| FeError::Eigen(format!("no {} mode among the lowest {}", kind.id(), modes.len())))
}

fn row(
    id: &str,
    what: String,
    source: &'static str,
    (reference, tolerance): (f64, f64),
    computed: f64,
    unit: &'static str,
) -> Row {
    let kind = if source == MALHOTRA { Reference::Published } else { Reference::SecondFormulation };
    Row::new(id, what, (reference, source, kind), computed, (tolerance, unit))
}

/// A uniform steel tank R = 10 m, s = 10 mm, filled to the top.
fn full_steel_tank(aspect: f64) -> tank::Case {
    let depth = 10.0 * aspect;
    case(Shape::Cylinder { radius: 10.0 }, &[(depth, 0.01)], &material(210e9, 0.3, 7850.0), (1000.0, depth))
}

/// H/R, first bulging frequency of [`full_steel_tank`] [rad/s], C_i.
const SERIES: [(f64, f64, f64); 8] = [
    (0.3, 103.31, 9.28),
    (0.5, 74.07, 7.74),
    (0.7, 58.68, 6.97),
    (1.0, 44.87, 6.36),
    (1.5, 31.29, 6.06),
    (2.0, 22.94, 6.21),
    (2.5, 17.40, 6.56),
    (3.0, 13.56, 7.03),
];

/// Rows against independent assemblies.
pub(crate) fn rows() -> Answer {
    let mut rows = Vec::new();
    let tank = broad(1000.0);
    let found = modes(&tank)?;
    let bulging = first(&found, Kind::Structural)?;
    let what = "tank 8.1, first bulging mode".to_string();
    rows.push(row("F9", what, ASSEMBLIES, (164.67, 0.003), bulging.omega, "rad/s"));
    let deep = modes(&slender(1e4 / 9.81, 5.0))?;
    let what = "tank 8.3, H = 5 m, ρ = 10/9.81, first bulging mode".to_string();
    rows.push(row("F9", what, ASSEMBLIES, (86.91, 0.003), first(&deep, Kind::Structural)?.omega, "rad/s"));
    for (aspect, reference, _) in SERIES {
        let computed = first(&modes(&full_steel_tank(aspect))?, Kind::Structural)?.omega;
        let what = format!("steel R 10 m, 10 mm, H/R = {aspect}: first bulging mode");
        rows.push(row("F10", what, ASSEMBLIES, (reference, 0.003), computed, "rad/s"));
    }
    let mass = |mode: &CoupledMode| mode.participation.powi(2) / tank.liquid_mass();
    let sloshing = first(&found, Kind::Sloshing)?;
    let what = |kind: &str| format!("tank 8.1, effective mass of {kind} mode 1 / liquid mass");
    rows.push(row("F11", what("sloshing"), ASSEMBLIES, (0.4973, 0.005), mass(sloshing), "1"));
    rows.push(row("F11", what("bulging"), ASSEMBLIES, (0.475, 0.005), mass(bulging), "1"));
    let misplaced = found.iter().filter(|m| m.omega < bulging.omega * (1.0 - 1e-9) && m.surface_share <= 0.5).count();
    let what = "tank 8.1, structural modes below the first bulging mode".to_string();
    rows.push(row("F16", what, "no spurious mode exists in this formulation", (0.0, 0.0), misplaced as f64, "1"));
    Ok(rows)
}

/// Rows against published coefficients.
pub(crate) fn published_rows() -> Answer {
    SERIES
        .into_iter()
        .map(|(aspect, _, c)| {
            let computed = first(&modes(&full_steel_tank(aspect))?, Kind::Structural)?.omega;
            // T = C_i √ρ H / (√(s/R) √E)
            let period = c * 1000.0_f64.sqrt() * 10.0 * aspect / ((0.01_f64 / 10.0).sqrt() * 210e9_f64.sqrt());
            let what = format!("steel R 10 m, 10 mm, H/R = {aspect}: first bulging mode");
            Ok(row("F10", what, MALHOTRA, (2.0 * PI / period, 0.02), computed, "rad/s"))
        })
        .collect()
}
