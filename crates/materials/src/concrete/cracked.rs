//! Concrete of a layer: crack strains across two orthogonal axes, plastic compression.
//!
//! ```text
//! ε = ε_e + ε_p + ε_cr ,  σ = C ε_e
//! ```
//!
//! When the larger principal stress exceeds f_t, its axes n, s are fixed; a second crack can only open across s.
//! Lateral compression lowers the strength of a crack that begins, f = f_t (1 − 0.8 |σ_2|/f_c) (theory sheet of this
//! project, after Kupfer, Hilsdorf & Rüsch 1969); the crack keeps that strength and the whole fracture energy. The
//! traction is that of [`super::Tension`].
//!
//! ```text
//! τ = β G γ_e ,  β = b + (1 − b) exp(−m/e_b)        m: the larger of both largest openings
//! ```
//!
//! β never recovers. If it followed the present opening, a cycle of strain could create energy; with the history it
//! is damage, of dissipation −½ G γ_e² dβ ≥ 0. Small e_b: fixed cracks that keep much shear lock, the principal
//! tension between them exceeds f_t (de Borst & Nauta 1985, Rots 1988).
//!
//! Compression: Drucker-Prager cone (f_c, f_bc) or the envelope of Kupfer and Gerstle (`surface.rs`), associated, ideally plastic;
//! dissipation k dλ on the cone.
//!
//! ## Steps
//!
//! 1. An uncracked point is elastic if its elastic stress is inside the cone and below the strength.
//! 2. Cracks without plastic flow, `local.rs`: explicit for closed cracks and cracks on their secant, one scalar
//!    equation for one that opens further.
//! 3. If the cone is exceeded, all six unknowns, `flow.rs`.
//! 4. If that fails, the strain increment in 2, 4, 8 substeps. The tangent is then taken by central differences of
//!    the whole sequence (six of them), equal to the chain rule over the substeps with 1e-6 accuracy.
//!
//! Where a crack begins, its axes and strength depend on this step's strain. The stress and the tangent are then
//! coaxial with the strain ε − ε_p: the shear modulus in the axes is (σ_n − σ_s)/(2 (a_n − a_s)), and the derivative
//! of the strength is included. Otherwise the tangent of the first step after cracking is not consistent.
//!
//! The options are those of the theory sheet: brittle cracks, tension stiffening, and axes that rotate with the
//! strain until a crack is wider than 2 f_t/E.

mod flow;
mod frame;
mod local;
mod parameters;
mod range;
mod step;

pub use parameters::{CrackAxes, CrackedParameters, Envelope, ShearRetention};

use frame::Frame;

use super::surface::Surface;
use super::tension::Traction;
use crate::drucker_prager::Cone;
use crate::{Crack, ElasticRange, Law, LawError, PointState, Response};

/// Name in errors and files.
const KIND: &str = "cracked-concrete";

// Slots of the history; zero initially.
const PLASTIC: usize = 0; // ε_p, three components in the plane
const STRAIN: usize = 3; // committed strain, three components
const AXIS: usize = 6; // n = (c, s); (0, 0): whole
const STRENGTH: usize = 8; // of the cracks n, s; 0: none
const LARGEST: usize = 10; // largest openings
const TRACTION: usize = 12; // tractions at them
const SHEAR: usize = 14; // 1 − β
const EQUIVALENT: usize = 15; // accumulated equivalent plastic strain
const PARTS: usize = 16; // parts of the last step, 0 before the first
const SLOTS: usize = 17;

/// Tolerance on the cone, as a share of k: a stress returned to it stays elastic when evaluated again.
const ON_CONE: f64 = 1e-11;

/// Cracking concrete of a layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CrackedConcrete {
    young_modulus: f64,
    poisson_ratio: f64,
    /// E/(1 − ν²).
    plane_modulus: f64,
    shear_modulus: f64,
    strength: f64,
    surface: Surface,
    traction: Traction,
    retention: ShearRetention,
    /// Opening up to which the axes rotate.
    turning: f64,
    /// Sides of the cell along axes 1 and 2 [m].
    sides: Option<[f64; 2]>,
}

impl CrackedConcrete {
    /// Errors: a parameter out of range; an element too large for its fracture energy (the message gives the largest
    /// size).
    pub fn new(parameters: &CrackedParameters) -> Result<CrackedConcrete, LawError> {
        let traction = parameters.check(KIND)?;
        let CrackedParameters {
            young_modulus: young,
            poisson_ratio: nu,
            compressive_strength,
            biaxial_ratio,
            retention,
            axes,
            envelope,
            sides,
            ..
        } = *parameters;
        Ok(CrackedConcrete {
            young_modulus: young,
            poisson_ratio: nu,
            plane_modulus: young / (1.0 - nu * nu),
            shear_modulus: 0.5 * young / (1.0 + nu),
            strength: compressive_strength,
            surface: match envelope {
                Envelope::DruckerPrager => {
                    Surface::Cone(Cone::of_strengths(compressive_strength, biaxial_ratio * compressive_strength)?)
                }
                Envelope::Kupfer => Surface::Kupfer([compressive_strength, biaxial_ratio]),
            },
            traction,
            retention,
            turning: match axes {
                CrackAxes::Fixed => 0.0,
                CrackAxes::Turning => 2.0 * traction.strength / young,
            },
            sides,
        })
    }

    /// Whether a crack loses its traction suddenly: the energy then depends on mesh and step, and results should
    /// state this.
    pub fn is_brittle(&self) -> bool {
        self.traction.brittle()
    }

    /// Number of substeps of the last step; usually 1, 0 before the first step.
    pub fn parts(&self, history: &[f64]) -> usize {
        history[PARTS] as usize
    }

    /// β and dβ/dm.
    #[inline]
    fn shear_factor(&self, largest: f64) -> (f64, f64) {
        let ShearRetention { least, strain } = self.retention;
        let x = (1.0 - least) * (-largest / strain).exp();
        (least + x, -x / strain)
    }

    /// Strength of a new crack under the lateral stress σ_2 [Pa], and its derivative by σ_2.
    fn beginning(&self, beside: f64) -> (f64, f64) {
        let f_t = self.traction.strength;
        if beside >= 0.0 {
            return (f_t, 0.0);
        }
        // Compression beyond f_c occurs only with lateral compression; the bound keeps the strength positive.
        let share = (-beside / self.strength).min(1.0);
        (f_t * (1.0 - 0.8 * share), if share < 1.0 { 0.8 * f_t / self.strength } else { 0.0 })
    }

    /// Elastic response of a whole point, if it is one.
    #[inline]
    fn whole(&self, a: &[f64; 3]) -> Option<[f64; 3]> {
        let (c, nu) = (self.plane_modulus, self.poisson_ratio);
        let stress = [c * (a[0] + nu * a[1]), c * (a[1] + nu * a[0]), self.shear_modulus * a[2]];
        let (mean, half) = (0.5 * (stress[0] + stress[1]), 0.5 * (stress[0] - stress[1]));
        let radius = (half * half + stress[2] * stress[2]).sqrt();
        let (most, least) = (mean + radius, mean - radius);
        if most > 0.0 && most > self.beginning(least).0 {
            return None;
        }
        (self.surface.at(&stress).1 <= ON_CONE * self.surface.scale()).then_some(stress)
    }

    fn elastic_moduli(&self) -> [[f64; 3]; 3] {
        let (c, nu) = (self.plane_modulus, self.poisson_ratio);
        [[c, nu * c, 0.0], [nu * c, c, 0.0], [0.0, 0.0, self.shear_modulus]]
    }
}

impl Law<3> for CrackedConcrete {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        SLOTS
    }

    fn elastic_range(&self) -> Option<&dyn ElasticRange<3>> {
        Some(self)
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        match self.part(strain, &old[..SLOTS], &mut new[..SLOTS]) {
            Some(response) => Ok(response),
            None => self.in_parts(strain, &old[..SLOTS], &mut new[..SLOTS]),
        }
    }

    fn inspect(&self, strain: &[f64; 3], history: &[f64]) -> PointState {
        let mut new = [0.0; SLOTS];
        let Ok(response) = self.respond(strain, history, &mut new) else { return PointState::default() };
        let (_, f) = self.surface.at(&response.stress);
        let mut state = PointState {
            plastic_strain: new[EQUIVALENT],
            utilisation: (1.0 + f / self.surface.scale()).max(0.0),
            ..PointState::default()
        };
        if new[AXIS] == 0.0 && new[AXIS + 1] == 0.0 {
            let t = &response.stress;
            let (mean, half) = (0.5 * (t[0] + t[1]), 0.5 * (t[0] - t[1]));
            let radius = (half * half + t[2] * t[2]).sqrt();
            let most = (mean + radius) / self.beginning(mean - radius).0;
            state.utilisation = state.utilisation.max(most);
            return state;
        }
        let frame = Frame { c: new[AXIS], s: new[AXIS + 1] };
        // At a point at rest openings follow from the elastic strain, ε_cr = ε − ε_p − C⁻¹ σ.
        let a: [f64; 3] = std::array::from_fn(|i| strain[i] - new[PLASTIC + i]);
        let local = frame.strain(&a);
        let tensor = [response.stress[0], response.stress[1], 2.0 * response.stress[2]];
        let stress = frame.strain(&tensor);
        for i in 0..2 {
            if new[STRENGTH + i] == 0.0 {
                continue;
            }
            let largest = new[LARGEST + i];
            let elastic = (stress[i] - self.poisson_ratio * stress[1 - i]) / self.young_modulus;
            let left = new[TRACTION + i];
            state.cracks[i] = Some(Crack {
                angle: frame.angle() + if i == 1 { std::f64::consts::FRAC_PI_2 } else { 0.0 },
                opening: (local[i] - elastic).clamp(0.0, largest),
                largest,
            });
            if stress[i] > 0.0 && left > 0.0 {
                state.utilisation = state.utilisation.max(stress[i] / left);
            }
            // Loss of the secant modulus across the crack.
            state.damage = state.damage.max(largest / (largest + left / self.young_modulus));
        }
        state
    }
}
