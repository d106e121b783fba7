//! Traction across a crack.
//!
//! ```text
//! t(e) = f_t exp(−e/e_f)                 e = m, the largest opening strain so far
//! t(e) = t(m) e/m                        e < m: secant, closes at e = 0
//! e_f  = G_f/(f_t h)                     so that ∫ t de = G_f/h
//! ```
//!
//! Tension stiffening replaces the tail by b_ts f_t, up to the strain ε_y at which the crossing bar yields; from
//! there it falls linearly to zero at 2 ε_y (the sources of the theory sheet stop it at yield; a jump does not
//! converge).
//!
//! [`Bond`] instead adds the mean stress b(e) that the bars hand over between cracks: t(e) = f_t exp(−e/e_f) + b(e).
//!
//! The recoverable energy of a crack is ½ t(m) e²/m. The rest of the work is a function of m alone,
//!
//! ```text
//! D(m) = ∫₀ᵐ t de − ½ m t(m) ,   D' = ½ (t − m t') ≥ 0
//! ```
//!
//! so that the dissipation of a step is exact, D(m_new) − D(m_old), and G_f/h in the end.
//!
//! In series with the elastic concrete, u = e + t(e)/E; there is one e for every u when −t' < E, which for the exponential
//! reads e_f > f_t/E, or h < E G_f/f_t².
//!
//! Source: Bažant & Oh 1983 (energy and size), Rots 1988 (crack strain, secant unloading).

use super::SIZE_MARGIN;
use super::bond::{Bond, Curve};
use crate::check::{found, positive};
use crate::{LawError, refuse};

/// How the traction of a crack falls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Softening {
    /// At once to zero. The energy depends on mesh and step: results with it are for comparison with older calculations.
    Brittle,
    /// Exponential, by energy.
    Energy {
        /// Fracture energy G_f [N/m] > 0; see [`super::fracture_energy`].
        fracture_energy: f64,
        /// Size h of the element normal to the crack [m], at most 0.98 E G_f/f_t². In reinforced layers the crack spacing if
        /// that is smaller.
        size: f64,
    },
    /// Exponential, by strain: e_f > f_t/(0.98 E). Right for one element size only.
    Strain {
        /// Strain e_f at which the traction is f_t/e.
        softening_strain: f64,
    },
}

/// Concrete between cracks of a reinforced layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stiffening {
    /// Share b_ts of f_t that stays, from 0 (fatigue) to below 1; 0.2 to 0.4 under short loading.
    pub share: f64,
    /// Strain ε_y at which the crossing bar yields, > 0; may be infinite.
    pub yield_strain: f64,
}

/// Tension of concrete.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tension {
    /// Tensile strength f_t [Pa] > 0.
    pub strength: f64,
    /// Softening after cracking.
    pub softening: Softening,
    /// Tension stiffening by the bars; not together with [`Softening::Brittle`].
    pub stiffening: Option<Stiffening>,
    /// Bond of the bars; not together with [`Softening::Brittle`] or a stiffening.
    pub bond: Option<Bond>,
}

/// Traction over opening, checked.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Traction {
    /// f_t [Pa].
    pub strength: f64,
    /// e_f; 0: brittle.
    pub softening_strain: f64,
    /// Tail b_ts f_t [Pa]; 0: none.
    tail: f64,
    /// Opening at which the tail begins; infinite without tail.
    tail_from: f64,
    /// ε_y.
    yield_strain: f64,
    /// Whether e_f follows from the fracture energy.
    by_energy: bool,
    /// b(e).
    bond: Option<Curve>,
}

impl Traction {
    /// Errors: a parameter out of range; with the largest admissible size where the element is too large.
    pub(crate) fn new(law: &'static str, young_modulus: f64, tension: &Tension) -> Result<Traction, LawError> {
        let f_t = tension.strength;
        positive(law, "tensile_strength", f_t, "Pa")?;
        let softening_strain = match tension.softening {
            Softening::Brittle => 0.0,
            Softening::Energy { fracture_energy, size } => {
                positive(law, "fracture_energy", fracture_energy, "N/m")?;
                positive(law, "size", size, "m")?;
                let bound = SIZE_MARGIN * young_modulus * fracture_energy / (f_t * f_t);
                if size > bound {
                    return Err(refuse(
                        law,
                        "size",
                        found(size, "m"),
                        &format!("at most {bound:.4} m (0.98 E G_f/f_t²: a larger element snaps back when it cracks)"),
                    ));
                }
                fracture_energy / (f_t * size)
            }
            Softening::Strain { softening_strain } => {
                positive(law, "softening_strain", softening_strain, "")?;
                let bound = f_t / (SIZE_MARGIN * young_modulus);
                if softening_strain < bound {
                    return Err(refuse(
                        law,
                        "softening_strain",
                        softening_strain.to_string(),
                        &format!("at least {bound:.3e} (f_t/(0.98 E): a steeper branch snaps back)"),
                    ));
                }
                softening_strain
            }
        };
        let mut traction = Traction {
            strength: f_t,
            softening_strain,
            tail: 0.0,
            tail_from: f64::INFINITY,
            yield_strain: f64::INFINITY,
            by_energy: matches!(tension.softening, Softening::Energy { .. }),
            bond: None,
        };
        if let Some(bond) = &tension.bond {
            if softening_strain == 0.0 || tension.stiffening.is_some() {
                let allowed = "with softening that is not brittle, without tension stiffening";
                return Err(refuse(law, "bond", "given".to_owned(), allowed));
            }
            traction.bond = Some(bond.curve(law, [young_modulus, f_t, softening_strain])?);
        }
        if let Some(Stiffening { share, yield_strain }) = tension.stiffening {
            if !(0.0..1.0).contains(&share) {
                return Err(refuse(law, "stiffening", share.to_string(), "from 0 to below 1"));
            }
            if share > 0.0 {
                let from = -softening_strain * share.ln();
                // Beyond the beginning of the tail, so that the pieces come in order; the fall b f_t/ε_y is then no snap-back.
                if softening_strain == 0.0
                    || yield_strain.is_nan()
                    || yield_strain <= from
                    || share * f_t > SIZE_MARGIN * young_modulus * yield_strain
                {
                    return Err(refuse(
                        law,
                        "stiffening",
                        format!("up to the strain {yield_strain}"),
                        &format!("up to a strain > {from:.3e}, with softening that is not brittle"),
                    ));
                }
                traction.tail = share * f_t;
                traction.tail_from = from;
                traction.yield_strain = yield_strain;
            }
        }
        Ok(traction)
    }

    /// Neither strength nor energy.
    pub(crate) fn none() -> Traction {
        Traction {
            strength: 0.0,
            softening_strain: 0.0,
            tail: 0.0,
            tail_from: f64::INFINITY,
            yield_strain: f64::INFINITY,
            by_energy: false,
            bond: None,
        }
    }

    /// Whether the traction drops suddenly.
    pub(crate) fn brittle(&self) -> bool {
        self.softening_strain == 0.0 && self.strength > 0.0
    }

    /// Traction and slope [Pa] at a first opening e ≥ 0.
    #[inline]
    pub(crate) fn at(&self, e: f64) -> (f64, f64) {
        if e <= self.tail_from {
            if self.softening_strain == 0.0 {
                return if e > 0.0 { (0.0, 0.0) } else { (self.strength, 0.0) };
            }
            let t = self.strength * (-e / self.softening_strain).exp();
            let slope = -t / self.softening_strain;
            return match &self.bond {
                None => (t, slope),
                Some(curve) => {
                    let (b, rate) = curve.at(e);
                    (t + b, slope + rate)
                }
            };
        }
        let y = self.yield_strain;
        if e <= y {
            (self.tail, 0.0)
        } else if e < 2.0 * y {
            (self.tail * (2.0 - e / y), -self.tail / y)
        } else {
            (0.0, 0.0)
        }
    }

    /// The same crack with a strength reduced by lateral compression; the fracture energy stays, if energy is given, and the bond.
    pub(crate) fn reduced(&self, strength: f64) -> Traction {
        let share = strength / self.strength;
        let stretch = if self.by_energy { 1.0 / share } else { 1.0 };
        Traction {
            strength,
            softening_strain: self.softening_strain * stretch,
            tail: self.tail * share,
            tail_from: self.tail_from * stretch,
            ..*self
        }
    }

    /// The same crack smeared over a length shorter by `stretch` ≥ 1: its strains grow, if energy is given. Bond and the yield of bars stay.
    pub(crate) fn stretched(&self, stretch: f64) -> Traction {
        if !self.by_energy {
            return *self;
        }
        // The tail begins before the bars yield.
        let most = 0.999 * self.yield_strain / self.tail_from;
        let stretch = if most.is_finite() { stretch.min(most.max(1.0)) } else { stretch };
        Traction { softening_strain: self.softening_strain * stretch, tail_from: self.tail_from * stretch, ..*self }
    }

    /// ∂t/∂f_t at the opening e, along [`Traction::reduced`].
    pub(crate) fn by_strength(&self, e: f64) -> f64 {
        if self.softening_strain == 0.0 {
            return if e > 0.0 { 0.0 } else { 1.0 };
        }
        if e > self.tail_from {
            return self.at(e).0 / self.strength;
        }
        let x = e / self.softening_strain;
        (-x).exp() * if self.by_energy { 1.0 - x } else { 1.0 }
    }

    /// D(m) [J/m³]: energy dissipated by a crack of largest opening m; `traction` is t(m).
    #[inline]
    pub(crate) fn dissipated(&self, m: f64, traction: f64) -> f64 {
        let work = if let Some(curve) = &self.bond {
            self.softening_strain * (self.strength - (traction - curve.at(m).0)) + curve.work(m)
        } else if m <= self.tail_from {
            self.softening_strain * (self.strength - traction)
        } else {
            let y = self.yield_strain;
            let fade = (m.min(2.0 * y) - y).max(0.0);
            self.softening_strain * (self.strength - self.tail)
                + self.tail * (m.min(y) - self.tail_from)
                + if fade > 0.0 { self.tail * fade * (1.0 - 0.5 * fade / y) } else { 0.0 }
        };
        work - 0.5 * m * traction
    }

    /// Opening, traction and slope dt/du when the strain u = e + t(e)/E ≥ f_t/E grows beyond all it has been;
    /// `start` is an opening not far off.
    ///
    /// The exponential needs the root of x + a exp(−x) = u/e_f, a = f_t/(E e_f) < 1. The left side is convex and grows, so
    /// Newton's method converges from anywhere, and after the first step from above; near the root Halley's takes over.
    #[inline]
    pub(crate) fn opened(&self, u: f64, young_modulus: f64, start: f64) -> (f64, f64, f64) {
        let e_f = self.softening_strain;
        if e_f == 0.0 {
            return (u, 0.0, 0.0);
        }
        if u > self.tail_from + self.tail / young_modulus {
            let y = self.yield_strain;
            if u <= y + self.tail / young_modulus {
                return (u - self.tail / young_modulus, self.tail, 0.0);
            }
            if u >= 2.0 * y {
                return (u, 0.0, 0.0);
            }
            // u = e + (tail/E)(2 − e/y)
            let a = self.tail / young_modulus;
            let e = (u - 2.0 * a) / (1.0 - a / y);
            let slope = -self.tail / y;
            return (e, self.tail * (2.0 - e / y), slope / (1.0 + slope / young_modulus));
        }
        let (mut u_line, mut divisor, mut start) = (u, 1.0, start);
        if let Some(curve) = &self.bond {
            // On a piece b = b_0 + k e: (1 + k/E) e + (f/E) exp(−e/e_f) = u − b_0/E.
            let strain = |e: f64| e + self.at(e).0 / young_modulus;
            let (mut low, mut high) = (0, Curve::PIECES);
            while low < high {
                let middle = (low + high).div_ceil(2);
                if strain(curve.begins(middle)) <= u {
                    low = middle;
                } else {
                    high = middle - 1;
                }
            }
            let (value, slope) = curve.line(low);
            (u_line, divisor) = (u - value / young_modulus, 1.0 + slope / young_modulus);
            start = start.max(curve.begins(low));
        }
        let a = self.strength / (young_modulus * e_f * divisor);
        let v = u_line / (e_f * divisor);
        let mut x = start / e_f;
        // Halley's step near the root, where it is cubic: its error is (step)³ (f''/2f')². 40 is never reached.
        for _ in 0..40 {
            let q = a * (-x).exp();
            let (f, slope) = (x + q - v, 1.0 - q);
            let (square, bend) = (slope * slope, 0.5 * f * q);
            let step = if bend.abs() < 0.25 * square { f * slope / (square - bend) } else { f / slope };
            x = (x - step).max(0.0);
            if step.abs() < 1e-5 && bend.abs() < 1e-5 * square {
                break;
            }
        }
        // From equilibrium, not from the exponential: u = e + t/E holds to rounding.
        let t = (young_modulus * (u - x * e_f)).max(0.0);
        let slope = match &self.bond {
            None => -t / e_f,
            Some(_) => self.at(x * e_f).1,
        };
        (x * e_f, t, slope / (1.0 + slope / young_modulus))
    }
}
