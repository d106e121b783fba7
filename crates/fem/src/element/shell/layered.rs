//! Sections of layers and bars.
//!
//! ```text
//!            ζ ▲ director
//!   ───────────┬───────────  e + t/2        plies are stacked from below, each with its law and quadrature
//!     ply 2    │   ○    ○                   bars at their true depth
//!   ───────────┼───────────
//!     ply 1    │   ○    ○
//!   ───────────┴───────────  e − t/2
//!
//! E(ζ) = ε + ζ κ                                                            order ε_11 ε_22 2ε_12
//! N = Σ w_l σ_l + Σ A_s σ_s a           a = (cos²α, sin²α, cos α sin α) ,  ε_s = a · E(ζ_s)
//! M = Σ w_l ζ_l σ_l + Σ A_s ζ_s σ_s a
//! Q = k ∫ G dζ γ                        elastic; initial G of the laws, k = 5/6 by default
//! ```
//!
//! All components refer to the section's frame, which is that of the shell's [`Axes`](crate::element::shell4::Axes): with the
//! hoop rule a bar of angle 0 is a hoop bar, one of π/2 a vertical one. The concrete that bars displace is not subtracted.
//!
//! Linear laws ([`Law::is_linear`]) are integrated once, when the section is made. A section of linear laws only has no history
//! and costs as much as an elastic one.
//!
//! A point whose layers have all been in their elastic range ([`materials::ElasticRange`]) from the beginning is **whole**: it answers
//! with the constant A, B, D of its layers, and only the outermost ones of each ply are asked whether they stay in their range, which
//! is convex. The first strain outside ends this for good; the layers then take up the histories they would have.
//!
//! History of a point: the energy dissipated so far [J/m²], 1 while it is whole, its strain then (ε, κ), then that of every layer (the
//! initial one while it is whole), then of every bar whose law is not linear, and last what `lasting` keeps.

mod lasting;
mod response;

use std::ops::Range;
use std::sync::Arc;

use lasting::Lasting;
use materials::{Law, LawError, Response};

use super::rule::Rule;
use super::section::{LayerState, SHEAR_CORRECTION, Section, SectionResponse};
use crate::element::{ElementError, Stage, not_negative, positive, require};

pub use lasting::PlyState;

const KIND: &str = "layered section";

/// A part of the thickness with one law.
#[derive(Clone, Debug)]
pub struct Ply {
    /// Law in plane stress.
    pub law: Arc<dyn Law<3>>,
    /// Thickness [m] > 0.
    pub thickness: f64,
    /// Density [kg/m³] ≥ 0.
    pub density: f64,
    /// Quadrature.
    pub rule: Rule,
}

/// Bars of one direction at one depth.
#[derive(Clone, Debug)]
pub struct Bar {
    /// Law along the bar.
    pub law: Arc<dyn Law<1>>,
    /// Area per width [m²/m] > 0.
    pub area: f64,
    /// Distance from the middle of the plies [m], towards the director.
    pub depth: f64,
    /// Direction: angle from axis 1 towards axis 2 [rad].
    pub angle: f64,
    /// Density [kg/m³] ≥ 0; that of the material displaced is not subtracted.
    pub density: f64,
}

/// A quadrature point.
#[derive(Clone, Debug)]
struct Layer {
    law: Arc<dyn Law<3>>,
    depth: f64,
    weight: f64,
    /// Place of its history.
    slots: Range<usize>,
    linear: bool,
    /// Whether its law has an elastic range.
    ranged: bool,
    /// Free strain ε₀.
    free: f64,
    /// 1/(1 + φ), φ its creep coefficient.
    ease: f64,
}

/// Where a ply went.
#[derive(Clone, Debug)]
struct PlyRange {
    layers: Range<usize>,
    /// Depths of its lower and upper face [m].
    faces: [f64; 2],
}

/// A bar, ready for use.
#[derive(Clone, Debug)]
struct Rod {
    law: Arc<dyn Law<1>>,
    depth: f64,
    area: f64,
    angle: f64,
    /// cos²α, sin²α, cos α sin α.
    direction: [f64; 3],
    slots: Range<usize>,
    linear: bool,
    /// Free strain ε₀.
    free: f64,
}

/// Section of layers and bars.
#[derive(Clone, Debug)]
pub struct LayeredSection {
    layers: Vec<Layer>,
    plies: Vec<PlyRange>,
    rods: Vec<Rod>,
    /// Number of history variables: none if all laws are linear.
    history: usize,
    /// Tangent of the linear laws and of transverse shear.
    constant: [[f64; 8]; 8],
    /// The same with the layers that have an elastic range.
    whole: [[f64; 8]; 8],
    /// Outermost layers of each ply with an elastic range.
    outermost: Vec<usize>,
    thickness: f64,
    eccentricity: f64,
    inertia: [f64; 3],
    shear: f64,
    /// Free strains and creep, where there are any.
    lasting: Option<Lasting>,
}

impl LayeredSection {
    /// `plies` from below (against the director) to above, centred on the reference surface, with `bars`.
    ///
    /// Errors: no ply; a parameter out of range, a bar outside the plies; a law that fails at zero strain or has no shear
    /// stiffness.
    pub fn new(plies: &[Ply], bars: &[Bar]) -> Result<LayeredSection, ElementError> {
        LayeredSection::eccentric(plies, bars, 0.0)
    }

    /// The same with the middle of the plies at ζ = `eccentricity` [m] from the reference surface, along the director.
    ///
    /// Errors: those of [`LayeredSection::new`], an eccentricity that is not finite.
    pub fn eccentric(plies: &[Ply], bars: &[Bar], eccentricity: f64) -> Result<LayeredSection, ElementError> {
        check(!plies.is_empty(), "number of plies", 0.0, "1 or more")?;
        check(eccentricity.is_finite(), "eccentricity", eccentricity, "finite")?;
        for ply in plies {
            let (t, rho) = (ply.thickness, ply.density);
            check(positive(t), "thickness", t, "> 0 and finite")?;
            check(not_negative(rho), "density", rho, "≥ 0 and finite")?;
        }
        let thickness: f64 = plies.iter().map(|p| p.thickness).sum();
        for bar in bars {
            let (area, depth, rho) = (bar.area, bar.depth, bar.density);
            check(positive(area), "bar area", area, "> 0 and finite")?;
            let inside = depth.abs() <= 0.5 * thickness;
            check(inside, "depth of a bar", depth, "inside the plies, at most half their thickness")?;
            check(bar.angle.is_finite(), "angle of a bar", bar.angle, "finite")?;
            check(not_negative(rho), "density of a bar", rho, "≥ 0 and finite")?;
        }
        let mut section = LayeredSection {
            layers: Vec::new(),
            plies: Vec::new(),
            rods: Vec::new(),
            history: 0,
            constant: [[0.0; 8]; 8],
            whole: [[0.0; 8]; 8],
            outermost: Vec::new(),
            thickness,
            eccentricity,
            inertia: [0.0; 3],
            shear: 0.0,
            lasting: None,
        };
        let mut bottom = eccentricity - 0.5 * thickness;
        for ply in plies {
            section.stack(ply, bottom)?;
            bottom += ply.thickness;
        }
        bars.iter().try_for_each(|bar| section.reinforce(bar))?;
        section.with_shear_factor(SHEAR_CORRECTION)
    }

    /// The same with Q = `factor` ∫G dζ γ: 5/6 for a homogeneous section, less for cracked concrete.
    ///
    /// Errors: a factor that is not positive.
    pub fn with_shear_factor(mut self, factor: f64) -> Result<LayeredSection, ElementError> {
        check(positive(factor), "shear factor", factor, "> 0 and finite")?;
        for i in 6..8 {
            self.constant[i][i] = factor * self.shear;
            self.whole[i][i] = factor * self.shear;
        }
        Ok(self)
    }

    /// Thickness of all plies [m].
    pub fn thickness(&self) -> f64 {
        self.thickness
    }

    /// Distance of their middle from the reference surface [m].
    pub fn eccentricity(&self) -> f64 {
        self.eccentricity
    }

    /// Depths ζ of the layers, in their order [m].
    pub fn depths(&self) -> Vec<f64> {
        self.layers.iter().map(|l| l.depth).collect()
    }

    fn stack(&mut self, ply: &Ply, bottom: f64) -> Result<(), ElementError> {
        let (half, len) = (0.5 * ply.thickness, ply.law.history_len());
        let middle = bottom + half;
        let linear = ply.law.is_linear();
        let virgin = at_rest(&*ply.law)?;
        let shear = virgin.tangent[2][2];
        check(shear > 0.0, "shear modulus of a law", shear, "> 0")?;
        self.shear += shear * ply.thickness;
        let moduli = ply.law.elastic_range().filter(|_| !linear).map(|range| range.moduli());
        let first = self.layers.len();
        for (x, w) in ply.rule.points()? {
            let (depth, weight) = (middle + half * x, half * w);
            let slots = if linear { 0..0 } else { self.reserve(len) };
            if linear {
                add_layer(&virgin.tangent, depth, weight, &mut self.constant);
                add_layer(&virgin.tangent, depth, weight, &mut self.whole);
            }
            if let Some(moduli) = &moduli {
                add_layer(moduli, depth, weight, &mut self.whole);
            }
            let (law, ranged) = (ply.law.clone(), moduli.is_some());
            self.layers.push(Layer { law, depth, weight, slots, linear, ranged, free: 0.0, ease: 1.0 });
        }
        self.plies.push(PlyRange { layers: first..self.layers.len(), faces: [bottom, bottom + ply.thickness] });
        if moduli.is_some() {
            self.outermost.extend([first, self.layers.len() - 1]);
        }
        let mass = ply.density * ply.thickness;
        self.inertia[0] += mass;
        self.inertia[1] += mass * middle;
        self.inertia[2] += mass * (middle * middle + half * half / 3.0);
        Ok(())
    }

    fn reinforce(&mut self, bar: &Bar) -> Result<(), ElementError> {
        let (sine, cosine) = bar.angle.sin_cos();
        let linear = bar.law.is_linear();
        let len = bar.law.history_len();
        let rod = Rod {
            law: bar.law.clone(),
            depth: self.eccentricity + bar.depth,
            area: bar.area,
            angle: bar.angle,
            direction: [cosine * cosine, sine * sine, cosine * sine],
            slots: if linear { 0..0 } else { self.reserve(len) },
            linear,
            free: 0.0,
        };
        let virgin = at_rest(&*bar.law)?;
        if linear {
            rod.add_tangent(virgin.tangent[0][0], &mut self.constant);
            rod.add_tangent(virgin.tangent[0][0], &mut self.whole);
        }
        let mass = bar.density * bar.area;
        self.inertia[0] += mass;
        self.inertia[1] += mass * rod.depth;
        self.inertia[2] += mass * rod.depth * rod.depth;
        self.rods.push(rod);
        Ok(())
    }

    /// Room for a history, after that of the point itself.
    fn reserve(&mut self, len: usize) -> Range<usize> {
        let start = self.history.max(response::HEAD);
        self.history = start + len;
        start..self.history
    }
}

impl Rod {
    fn strain(&self, strain: &[f64; 8]) -> f64 {
        (0..3).map(|i| self.direction[i] * (strain[i] + self.depth * strain[3 + i])).sum()
    }

    /// b = (a, ζ a): tangent += A E b bᵀ.
    fn add_tangent(&self, modulus: f64, out: &mut [[f64; 8]; 8]) {
        let b = self.weights();
        for i in 0..6 {
            for j in 0..6 {
                out[i][j] += self.area * modulus * b[i] * b[j];
            }
        }
    }

    fn weights(&self) -> [f64; 6] {
        std::array::from_fn(|i| self.direction[i % 3] * if i < 3 { 1.0 } else { self.depth })
    }
}

/// tangent += w [C, ζ C; ζ C, ζ² C].
fn add_layer(c: &[[f64; 3]; 3], depth: f64, weight: f64, out: &mut [[f64; 8]; 8]) {
    for i in 0..3 {
        for j in 0..3 {
            // The tangents of non-associated laws are not symmetric: their symmetric part.
            let w = 0.5 * weight * (c[i][j] + c[j][i]);
            out[i][j] += w;
            out[i][j + 3] += w * depth;
            out[i + 3][j] += w * depth;
            out[i + 3][j + 3] += w * depth * depth;
        }
    }
}

fn at_depth(strain: &[f64; 8], depth: f64) -> [f64; 3] {
    std::array::from_fn(|i| strain[i] + depth * strain[3 + i])
}

fn at_rest<const N: usize>(law: &dyn Law<N>) -> Result<Response<N>, ElementError> {
    let mut old = vec![0.0; law.history_len()];
    law.init_history(&mut old);
    let mut new = old.clone();
    law.respond(&[0.0; N], &old, &mut new).map_err(failed)
}

fn failed(source: LawError) -> ElementError {
    ElementError::Law { kind: KIND, source }
}

fn check(ok: bool, parameter: &'static str, found: f64, allowed: &'static str) -> Result<(), ElementError> {
    require(ok, KIND, parameter, found, allowed)
}

impl Section for LayeredSection {
    fn history_len(&self) -> usize {
        self.history
    }

    fn init_history(&self, slots: &mut [f64]) {
        slots.fill(0.0);
        if self.history > 0 {
            slots[response::WHOLE] = f64::from(u8::from(!self.outermost.is_empty()));
        }
        for layer in self.layers.iter().filter(|l| !l.linear) {
            layer.law.init_history(&mut slots[layer.slots.clone()]);
        }
        for rod in self.rods.iter().filter(|r| !r.linear) {
            rod.law.init_history(&mut slots[rod.slots.clone()]);
        }
    }

    fn respond(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        self.integrate::<true>(strain, old, new, out)
    }

    fn resist(
        &self,
        strain: &[f64; 8],
        old: &[f64],
        new: &mut [f64],
        out: &mut SectionResponse,
    ) -> Result<(), ElementError> {
        self.integrate::<false>(strain, old, new, out)
    }

    fn stage(&self, stage: Stage, history: &mut [f64]) {
        if let Some(lasting) = &self.lasting {
            lasting.set(stage, history);
        }
    }

    fn dissipated(&self, history: &[f64]) -> f64 {
        history.first().copied().unwrap_or(0.0)
    }

    fn inspect(&self, strain: &[f64; 8], history: &[f64], see: &mut dyn FnMut(LayerState)) {
        let mut room = Vec::new();
        let point = self.lasting.as_ref().map(|lasting| lasting.point(history, true));
        for (number, layer) in self.layers.iter().enumerate() {
            let at = layer.strain(strain, point.as_ref());
            let own = layer.past(history, point.as_ref(), &mut room);
            // The law has already responded to a committed state.
            let stress = layer.law.respond(&at, own, &mut own.to_vec()).map_or([0.0; 3], |r| r.stress);
            see(LayerState {
                layer: number,
                depth: layer.depth,
                angle: 0.0,
                strain: at,
                stress,
                state: layer.law.inspect(&at, own),
            });
        }
        for (number, rod) in self.rods.iter().enumerate() {
            let at = rod.own_strain(strain, point.as_ref());
            let own = &history[rod.slots.clone()];
            let stress = rod.law.respond(&[at], own, &mut own.to_vec()).map_or(0.0, |r| r.stress[0]);
            see(LayerState {
                layer: self.layers.len() + number,
                depth: rod.depth,
                angle: rod.angle,
                strain: [at, 0.0, 0.0],
                stress: [stress, 0.0, 0.0],
                state: rod.law.inspect(&[at], own),
            });
        }
    }

    fn inertia(&self) -> [f64; 3] {
        self.inertia
    }

    fn shear_stiffness(&self) -> f64 {
        self.shear
    }
}

#[cfg(test)]
pub(crate) mod tests;
