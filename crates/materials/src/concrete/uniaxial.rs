//! Concrete along one axis: fibres of beams, rings, strips.
//!
//! ```text
//! u = ε − ε_p
//! u ≥ 0   σ = (1 − d_t) E u          up to the largest u so far; beyond it the crack opens: u = e + t(e)/E
//! u < 0   σ = (1 − d_c) E_c u        up to the most compressive ε so far; beyond it the envelope
//! ```
//!
//! with the traction t(e) of [`Tension`] and the envelope of [`Compression`]; E_c = 1.05 E for Sargin's curve, else E. Damage
//! d_t, d_c are secants: a crack closes at ε_p and reopens towards its largest opening. ε_p moves with compression only, and
//! carries the crack with it.
//!
//! Every branch is explicit, except the opening of an exponential crack: one scalar equation, three to four Newton steps.
//! The tangent is that of the branch, negative in softening; [`UniaxialConcrete::secant`] is the stiffness of the straight
//! line back, never negative, for a global matrix where Newton's method stalls.

mod compression;

pub use compression::PostPeak;

use compression::Envelope;

use super::tension::{Tension, Traction};
use crate::check::positive;
use crate::{Crack, Law, LawError, PointState, Response, refuse};

/// Name in errors and files.
const KIND: &str = "uniaxial-concrete";

/// Slots of the history.
const PLASTIC: usize = 0; // ε_p ≤ 0
const SHORTEST: usize = 1; // most compressive strain, ≤ 0
const CRUSHED: usize = 2; // d_c
const LONGEST: usize = 3; // largest u of an opened crack
const CRACKED: usize = 4; // d_t
const SLOTS: usize = 5;

/// Compression of an axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Compression {
    /// Linear elastic.
    Elastic,
    /// Elastic, ideally plastic at f_c.
    Plastic {
        /// Compressive strength f_c [Pa] > 0.
        strength: f64,
    },
    /// Sargin's curve with the plastic strains of Karsan & Jirsa.
    Sargin {
        /// Compressive strength f_c [Pa] > 0.
        strength: f64,
        /// Strain ε_c1 at the peak, > f_c/(1.05 E); see [`super::peak_strain`].
        peak_strain: f64,
        /// After the peak.
        post_peak: PostPeak,
    },
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Compressed {
    Elastic,
    Plastic { strength: f64 },
    Sargin(Envelope),
}

/// Concrete along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UniaxialConcrete {
    young_modulus: f64,
    /// Modulus of compression before damage [Pa].
    compressive_modulus: f64,
    compressed: Compressed,
    /// Compressive strength [Pa], or infinite.
    strength: f64,
    traction: Traction,
    /// f_t/E.
    cracking_strain: f64,
}

impl UniaxialConcrete {
    /// * `young_modulus`: E [Pa] > 0
    /// * `compression`: law below ε_p
    /// * `tension`: law above it; `None`: zero tensile strength and energy
    ///
    /// Errors: a parameter out of range, f_t ≥ f_c, an element too large for its fracture energy (the message gives
    /// the largest size).
    pub fn new(
        young_modulus: f64,
        compression: Compression,
        tension: Option<Tension>,
    ) -> Result<UniaxialConcrete, LawError> {
        positive(KIND, "youngs_modulus", young_modulus, "Pa")?;
        let strength = match compression {
            Compression::Elastic => f64::INFINITY,
            Compression::Plastic { strength } | Compression::Sargin { strength, .. } => {
                positive(KIND, "compressive_strength", strength, "Pa")?;
                strength
            }
        };
        let compressed = match compression {
            Compression::Elastic => Compressed::Elastic,
            Compression::Plastic { strength } => Compressed::Plastic { strength },
            Compression::Sargin { strength, peak_strain, post_peak } => {
                Compressed::Sargin(Envelope::new(KIND, young_modulus, strength, peak_strain, post_peak)?)
            }
        };
        let traction = match &tension {
            None => Traction::none(),
            Some(tension) => Traction::new(KIND, young_modulus, tension)?,
        };
        if traction.strength >= strength {
            return Err(refuse(
                KIND,
                "tensile_strength",
                format!("{} Pa", traction.strength),
                &format!("below the compressive strength, {strength} Pa"),
            ));
        }
        Ok(UniaxialConcrete {
            young_modulus,
            compressive_modulus: match &compressed {
                Compressed::Sargin(envelope) => envelope.initial,
                _ => young_modulus,
            },
            compressed,
            strength,
            traction,
            cracking_strain: traction.strength / young_modulus,
        })
    }

    /// Young's modulus E [Pa].
    pub fn young_modulus(&self) -> f64 {
        self.young_modulus
    }

    /// Whether a crack loses its traction suddenly: the energy then depends on mesh and step, and results should
    /// state this.
    pub fn is_brittle(&self) -> bool {
        self.traction.brittle()
    }

    /// Modulus [Pa] of the straight line from the present point back to ε_p; equals σ/(ε − ε_p).
    ///
    /// * `strain`: ε; its sign from ε_p chooses tension or compression
    /// * `history`: as [`Law::respond`] has written it for this strain
    pub fn secant(&self, strain: f64, history: &[f64]) -> f64 {
        if strain >= history[PLASTIC] {
            (1.0 - history[CRACKED]) * self.young_modulus
        } else {
            (1.0 - history[CRUSHED]) * self.compressive_modulus
        }
    }

    /// [`Law::respond`] without its error: every strain has a stress.
    ///
    /// * `strain`: ε
    /// * `old`, `new`: committed and new history, five slots each
    // In a loop over fibres a response through memory costs three times the law.
    #[inline(always)]
    pub fn update(&self, strain: f64, old: &[f64], new: &mut [f64]) -> Response<1> {
        let (old, new) = (&old[..SLOTS], &mut new[..SLOTS]);
        new.copy_from_slice(old);
        let u = strain - old[PLASTIC];
        if u >= 0.0 {
            if u <= old[LONGEST].max(self.cracking_strain) {
                return straight((1.0 - old[CRACKED]) * self.young_modulus, u);
            }
            return self.open(u, old, new);
        }
        if strain >= old[SHORTEST] {
            return straight((1.0 - old[CRUSHED]) * self.compressive_modulus, u);
        }
        match &self.compressed {
            Compressed::Elastic => straight(self.young_modulus, u),
            Compressed::Plastic { strength } => {
                let limit = -strength / self.young_modulus;
                if u >= limit {
                    return straight(self.young_modulus, u);
                }
                new[PLASTIC] = strain - limit;
                new[SHORTEST] = strain;
                Response { stress: [-strength], tangent: [[0.0]], dissipation: strength * (limit - u) }
            }
            Compressed::Sargin(envelope) => {
                let s = -strain;
                let (sigma, slope) = envelope.at(s);
                let elastic = envelope.recoverable(s, sigma);
                let elastic_old = old[PLASTIC] - old[SHORTEST];
                let sigma_old = (1.0 - old[CRUSHED]) * self.compressive_modulus * elastic_old;
                new[PLASTIC] = elastic - s;
                new[SHORTEST] = strain;
                new[CRUSHED] = 1.0 - sigma / (self.compressive_modulus * elastic);
                Response {
                    stress: [-sigma],
                    tangent: [[slope]],
                    dissipation: envelope.work((-old[SHORTEST], sigma_old), (s, sigma))
                        - 0.5 * (sigma * elastic - sigma_old * elastic_old),
                }
            }
        }
    }

    /// The crack opens beyond its largest opening.
    #[inline(always)]
    fn open(&self, u: f64, old: &[f64], new: &mut [f64]) -> Response<1> {
        let young = self.young_modulus;
        let m_old = old[CRACKED] * old[LONGEST];
        let (m, t, slope) = self.traction.opened(u, young, m_old);
        let before = if old[CRACKED] > 0.0 {
            self.traction.dissipated(m_old, old[LONGEST] * (1.0 - old[CRACKED]) * young)
        } else {
            0.0
        };
        new[LONGEST] = u;
        new[CRACKED] = m / u;
        let dissipation = if self.traction.brittle() {
            // Energy stored in the uncracked concrete.
            if old[CRACKED] > 0.0 { 0.0 } else { 0.5 * self.traction.strength * self.cracking_strain }
        } else {
            self.traction.dissipated(m, t) - before
        };
        Response { stress: [t], tangent: [[slope]], dissipation }
    }
}

/// σ = E u.
#[inline(always)]
fn straight(modulus: f64, u: f64) -> Response<1> {
    Response { stress: [modulus * u], tangent: [[modulus]], dissipation: 0.0 }
}

impl Law<1> for UniaxialConcrete {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        SLOTS
    }

    #[inline(always)]
    fn respond(&self, strain: &[f64; 1], old: &[f64], new: &mut [f64]) -> Result<Response<1>, LawError> {
        if strain[0].is_nan() {
            return Err(LawError::NoConvergence { law: KIND, increment: strain[0] });
        }
        Ok(self.update(strain[0], old, new))
    }

    fn inspect(&self, strain: &[f64; 1], history: &[f64]) -> PointState {
        let mut new = [0.0; SLOTS];
        let stress = self.update(strain[0], history, &mut new).stress[0];
        let largest = new[CRACKED] * new[LONGEST];
        let opening = new[CRACKED] * (strain[0] - new[PLASTIC]).max(0.0);
        // A crack has its remaining strength.
        let left = if new[CRACKED] > 0.0 {
            new[LONGEST] * (1.0 - new[CRACKED]) * self.young_modulus
        } else {
            self.traction.strength
        };
        let utilisation = match stress {
            s if s > 0.0 => s / left,
            s if s < 0.0 => -s / self.strength,
            _ => 0.0,
        };
        PointState {
            plastic_strain: -new[PLASTIC],
            utilisation,
            cracks: [(new[CRACKED] > 0.0).then_some(Crack { angle: 0.0, opening, largest }), None],
            damage: new[CRACKED].max(new[CRUSHED]),
            ..PointState::default()
        }
    }
}
