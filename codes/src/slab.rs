//! A tank on a rigid slab on the surface of a uniform soil: static stiffness, effective period, damping. For information: no check uses them.
//!
//! ```text
//! K_x = 8 G r/(2 − ν)     K_θ = 8 G r³/(3 (1 − ν))     G = ρ_s V_s²
//! T*/T = √(1 + k/(α_x K_x) + k h²/(α_θ K_θ))           k = m (2π/T)²
//! ```
//!
//! m, h: impulsive mass with wall and roof, and its arm with the pressure on the base, which turns the slab. G is that at the strains of the
//! earthquake. Functions of the frequency: [`soil::disc`], Veletsos & Verbic 1973.

use soil::disc::{Disc, Impedance, Soil};
use soil::structure::{Effective, OnSoil, Structure};
use tank::case::Case;
use tank::units::Dimension::*;
use tank::{FoundationKind, Shape, Support};

use crate::sheet::Sheet;

/// Largest damping ratio of a tank on soil that is put in: the definitions part ways above it.
pub(crate) const MOST_DAMPING: f64 = 0.25;

/// A part of the mass: [kg], [m].
type Part = [f64; 2];

/// A tank on soil, with the lines of its stiffness on the sheet.
pub(crate) struct Slab {
    pub on: OnSoil,
    /// k [N/m].
    pub k: f64,
    /// K_x [N/m], K_θ [N m].
    pub ground: [f64; 2],
    /// T* with α = 1 [s].
    pub period: f64,
}

/// Whether a case has a slab on the surface of a uniform soil of known velocity of shear waves; its material damping is left out.
pub(crate) fn is_on_soil(case: &Case) -> bool {
    let foundation = case.tank.foundation;
    matches!(case.tank.shape, Shape::Cylinder { .. })
        && foundation.is_some_and(|f| f.kind == FoundationKind::Slab && f.shear_wave_velocity.is_some())
        && case.tank.subsoil.layers.is_empty()
        && case.tank.subsoil.embedment == 0.0
}

/// Whether it is held to its slab.
pub(crate) fn is_anchored(case: &Case) -> bool {
    case.tank.support == Support::Anchored
}

/// Lines of the slab and its soil: radius, velocity of shear waves, density, Poisson's ratio.
fn inputs(sheet: &mut Sheet, [r, velocity, rho, nu]: [f64; 4]) {
    for (symbol, name, value, dimension, source) in [
        ("r", "radius of the slab, that of the bottom plate", r, Length, "tank.radius, tank.bottom.projection"),
        (
            "V_s",
            "velocity of shear waves at the strains of the earthquake",
            velocity,
            Velocity,
            "tank.foundation.shear_wave_velocity",
        ),
        ("ρ_s", "density of the soil", rho, Density, "tank.foundation.soil_density"),
        ("ν_s", "Poisson's ratio of the soil", nu, Dimensionless, "tank.foundation.soil_poisson_ratio"),
    ] {
        sheet.input(symbol, name, value, dimension, source);
    }
}

/// Lines of mass, arm, stiffness and static period; `None` without a slab on soil.
///
/// * `parts`: impulsive mass, wall, roof, with their heights, and the symbols of the first
/// * `period`: T on a fixed base [s]
pub(crate) fn lines(sheet: &mut Sheet, case: &Case, parts: [Part; 3], period: f64, clause: &str) -> Option<Slab> {
    let (Shape::Cylinder { radius }, Some(foundation)) = (case.tank.shape, case.tank.foundation) else { return None };
    let velocity = foundation.shear_wave_velocity.filter(|_| is_on_soil(case))?;
    sheet.section("Soil under the slab (information)");
    let [(m_i, h_i), (m_w, h_w), (m_r, h_r)] = parts.map(|[m, h]| (m, h));
    let r = radius + case.tank.bottom.as_ref().map_or(0.0, |bottom| bottom.projection);
    let (rho, nu) = (foundation.soil_density, foundation.soil_poisson_ratio);
    inputs(sheet, [r, velocity, rho, nu]);
    sheet.given(&[
        ("m_i", m_i, Mass),
        ("h_i′", h_i, Length),
        ("m_w", m_w, Mass),
        ("h_w", h_w, Length),
        ("m_r", m_r, Mass),
        ("h_r", h_r, Length),
        ("T_i", period, Time),
    ]);
    let mut values = Vec::new();
    for (symbol, name, formula, dimension) in [
        ("G", "shear modulus of the soil", "ρ_s·V_s²", Stress),
        ("K_x", "horizontal stiffness of the slab on a half-space", "8·G·r/(2 - ν_s)", LineForce),
        ("K_θ", "its rocking stiffness", "8·G·r³/(3·(1 - ν_s))", Moment),
        ("m_e", "impulsive mass with wall and roof", "m_i + m_w + m_r", Mass),
        ("h_e", "its arm with the pressure on the base", "(m_i·h_i′ + m_w·h_w + m_r·h_r)/m_e", Length),
        ("k_e", "its stiffness on a fixed base", "m_e·(2·π/T_i)²", LineForce),
        ("T_e0", "its period on static springs", "T_i·√(1 + k_e/K_x·(1 + K_x·h_e²/K_θ))", Time),
    ] {
        let value = sheet.calc(symbol, name, formula, dimension, clause);
        values.push(value);
    }
    let [_, k_x, k_theta, mass, height, k, on_springs] = values[..] else { return None };
    let soil = Soil { density: rho, shear_wave_velocity: velocity, poisson_ratio: nu, damping: 0.0, depth: None };
    let structure = Structure { mass, height, period, damping: case.damping.impulsive };
    let on = OnSoil::new(structure, Disc::new(r, soil).ok()?).ok()?;
    Some(Slab { on, k, ground: [k_x, k_theta], period: on_springs })
}

impl Slab {
    /// Real and imaginary parts of the impedance over the static stiffness at a period [s], of translation and rocking.
    pub(crate) fn factors(&self, period: f64) -> [[f64; 2]; 2] {
        let omega = std::f64::consts::TAU / period;
        let x = self.on.disc.horizontal(omega, Impedance::Veletsos) / self.ground[0];
        let theta = self.on.disc.rocking(omega, Impedance::Veletsos) / self.ground[1];
        [[x.re, x.im], [theta.re, theta.im]]
    }

    /// Period and damping of the complex stiffness.
    pub(crate) fn effective(&self) -> Option<Effective> {
        self.on.effective(Impedance::Veletsos).ok()
    }
}
