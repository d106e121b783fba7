//! A law of solids as one of layers: the strain through the thickness that leaves σ_33 = 0.
//!
//! ```text
//! σ_33(ε_11, ε_22, ε_33, γ_12) = 0 gives ε_33 ,   γ_23 = γ_13 = 0
//! C_ij ← C_ij − C_i3 C_3j/C_33                    condensed tangent; C_ij where C_33 vanishes (its row does as well)
//! ```
//!
//! Newton's method from the committed ε_33 in a bracket of σ_33's sign: in an associated law σ_33 never falls with ε_33, so that bisection
//! always ends. Transverse shears stay with the shell: the law has to be without coupling of them to the plane, which isotropic laws and
//! those of [`crate::dougill`] in a plane state are.
//!
//! Source: de Borst 1991; Klinkel & Govindjee 2002. Checks: rows M17; the suite of laws.

use crate::{Law, LawError, PointState, Response};

/// Components of the solid that are those of the layer.
const PLANE: [usize; 3] = [0, 1, 3];
/// Component through the thickness.
const THROUGH: usize = 2;
/// |σ_33| over the largest stress that counts as zero.
const ZERO: f64 = 1e-12;
/// The same where rounding of the strain decides, beside a jump of the slope.
const NEARLY: f64 = 1e-7;
/// C_33 over the largest diagonal term that counts as zero.
const FLAT: f64 = 1e-9;

/// A law of solids in plane stress; `Law<3>`.
///
/// History: ε_33, then that of the law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlaneStress<L> {
    law: L,
}

impl<L: Law<6>> PlaneStress<L> {
    /// The law in plane stress.
    pub fn new(law: L) -> PlaneStress<L> {
        PlaneStress { law }
    }

    /// The law of the solid.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// ε_33 and the answer of the solid.
    fn solve(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<(f64, Response<6>), LawError> {
        let mut through = old[0];
        // Where σ_33 is known to be negative, and positive.
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut reach = 1e-3 * strain.iter().fold(1e-6_f64, |m, e| m.max(e.abs()));
        let mut last = f64::NAN;
        for _ in 0..200 {
            let response = self.law.respond(&solid(strain, through), &old[1..], &mut new[1..])?;
            let normal = response.stress[THROUGH];
            let largest = response.stress.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
            let stuck = through == last;
            if normal.abs() <= ZERO * largest || (stuck && normal.abs() <= NEARLY * largest) || largest == 0.0 {
                return Ok((through, response));
            }
            if !normal.is_finite() || stuck {
                break;
            }
            if normal < 0.0 {
                low = through;
            } else {
                high = through;
            }
            last = through;
            let slope = response.tangent[THROUGH][THROUGH];
            let newton = through - normal / slope;
            through = if slope > 0.0 && newton > low && newton < high {
                newton
            } else if low.is_finite() && high.is_finite() {
                0.5 * (low + high)
            } else {
                reach *= 2.0;
                through - normal.signum() * reach
            };
        }
        Err(LawError::NoConvergence { law: self.law.kind(), increment: through - old[0] })
    }
}

fn solid(strain: &[f64; 3], through: f64) -> [f64; 6] {
    [strain[0], strain[1], through, strain[2], 0.0, 0.0]
}

impl<L: Law<6>> Law<3> for PlaneStress<L> {
    fn kind(&self) -> &'static str {
        self.law.kind()
    }

    fn history_len(&self) -> usize {
        1 + self.law.history_len()
    }

    fn init_history(&self, slots: &mut [f64]) {
        slots[0] = 0.0;
        self.law.init_history(&mut slots[1..]);
    }

    fn respond(&self, strain: &[f64; 3], old: &[f64], new: &mut [f64]) -> Result<Response<3>, LawError> {
        let (through, found) = self.solve(strain, old, new)?;
        new[0] = through;
        let c = &found.tangent;
        let largest = (0..6).fold(0.0_f64, |m, i| m.max(c[i][i].abs()));
        let pivot = c[THROUGH][THROUGH];
        let over = if pivot.abs() > FLAT * largest { 1.0 / pivot } else { 0.0 };
        Ok(Response {
            stress: PLANE.map(|i| found.stress[i]),
            tangent: PLANE.map(|i| PLANE.map(|j| c[i][j] - c[i][THROUGH] * c[THROUGH][j] * over)),
            dissipation: found.dissipation,
        })
    }

    fn inspect(&self, strain: &[f64; 3], history: &[f64]) -> PointState {
        self.law.inspect(&solid(strain, history[0]), &history[1..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drucker_prager::DruckerPrager;
    use crate::elastic::Elastic;

    /// An elastic solid has the stiffness of the elastic layer.
    #[test]
    fn elastic() {
        let law = Elastic::new(34e9, 0.2).unwrap();
        let layer = PlaneStress::new(law);
        let strain = [1e-4, -3e-4, 2e-4];
        let found = layer.respond(&strain, &[0.0], &mut [0.0]).unwrap();
        let exact: Response<3> = law.respond(&strain, &[], &mut []).unwrap();
        for i in 0..3 {
            assert!((found.stress[i] - exact.stress[i]).abs() < 1e-9 * 1e7);
            for j in 0..3 {
                assert!((found.tangent[i][j] - exact.tangent[i][j]).abs() < 1e-9 * 34e9);
            }
        }
    }

    /// The cone has its own return in plane stress, another derivation (two scalar equations): stress and tangent along a path that turns.
    #[test]
    fn cone_against_its_own_return() {
        let law = DruckerPrager::new(34e9, 0.2, 35e6, 1.16 * 35e6).unwrap();
        let layer = PlaneStress::new(law);
        let mut own = vec![0.0; Law::<3>::history_len(&law)];
        let mut solid = vec![0.0; layer.history_len()];
        let (mut own_new, mut solid_new) = (own.clone(), solid.clone());
        for i in 1..=60 {
            let t = f64::from(i) / 60.0;
            let strain = [-2.5e-3 * t, -1.5e-3 * t * t, 1.5e-3 * (3.0 * t).sin()];
            let exact: Response<3> = law.respond(&strain, &own, &mut own_new).unwrap();
            let found = layer.respond(&strain, &solid, &mut solid_new).unwrap();
            for k in 0..3 {
                // Both returns stop at 1e-11 of the stress.
                assert!((found.stress[k] - exact.stress[k]).abs() < 1e-8 * 35e6, "{i} {k}");
                for j in 0..3 {
                    let (a, b) = (found.tangent[k][j], exact.tangent[k][j]);
                    assert!((a - b).abs() < 1e-6 * 34e9, "{i} {k} {j}: {a} {b}");
                }
            }
            own.copy_from_slice(&own_new);
            solid.copy_from_slice(&solid_new);
        }
    }
}
