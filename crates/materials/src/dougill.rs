//! Progressively fracturing solid: stiffness that falls along the normal of a surface in strain space, without permanent strain.
//!
//! ```text
//! σ = D ε ,   dσ = D dε − dλ m ,   m = ∂f/∂ε                     Dougill's normality: the lost stress is normal to the surface
//! f(ε) = (√J_2(ε) + α_e I_1(ε))/c ≤ r ,   r: largest f so far, r_0 at first
//! dD = −dg m ⊗ m ,   dg m : ε = dλ                               unloading to the origin, D symmetric
//! α_e = α (1 + ν)/(1 − 2ν) ,   c = (1 + ν) (1/√3 − α)
//! ```
//!
//! The surface is the image of Drucker and Prager's cone in elastic strains, and f is the strain of uniaxial compression: the first loss is at
//! f_0 = E r_0 in uniaxial and at f_bc/f_c f_0 in equibiaxial compression. How much is lost the postulate leaves open. Here the stiffness in the direction
//! m, S = 1/(m : D⁻¹ : m), falls by a factor of r alone:
//!
//! ```text
//! step    D ← D − g m ⊗ m ,   g = (1 − A/A_n)/(m : D_n⁻¹ : m) ,   A(r) = (r_0/r) exp(−(r − r_0)/r_f)
//! ```
//!
//! so that D stays positive definite for any step (Sherman & Morrison: S_new = S_n A/A_n), and a proportional path of strain gives
//! σ = D_0 ε − (1 − A) f/(m : D_0⁻¹ : m) m whatever its steps, with the energy (½ r_0² + r_0 r_f)/(m : D_0⁻¹ : m) dissipated in the end. Dissipation of a step
//! ½ g f² ≥ 0.
//!
//! **Parameters are our own.** The dissertation names the theory of microcracks and prints neither f_0 nor the evolution; r_f sets the energy. Loss in
//! one direction does not reach another: stress across m remains. Strain softens locally: the energy depends on the mesh unless r_f is chosen by
//! its size ([`Fracturing::of_energy`]).
//!
//! Source: Dougill 1976 (fracture surface in strain space, normality, secant to the origin); Bažant & Kim 1979. Checks: rows M15.

use crate::check::{found, positive, within};
use crate::drucker_prager::Cone;
use crate::elastic::Elastic;
use crate::{Law, LawError, PointState, Response, refuse};

const KIND: &str = "fracturing";

/// Slots: r, then D by rows of its upper triangle.
const SLOTS: usize = 22;

type Vector = [f64; 6];
type Matrix = [[f64; 6]; 6];

/// Progressively fracturing solid; `Law<6>`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fracturing {
    elastic: Elastic,
    /// α_e.
    alpha: f64,
    /// c.
    scale: f64,
    /// r_0.
    first: f64,
    /// r_f.
    fall: f64,
}

impl Fracturing {
    /// * `young_modulus` E [Pa] > 0
    /// * `poisson_ratio` ν, −1 < ν < 0.5
    /// * `onset` f_0 [Pa] > 0: uniaxial compression at the first loss, as a positive number
    /// * `biaxial_ratio` f_bc/f_c, 1 to 1.5
    /// * `fall` r_f > 0: strain over which the stiffness falls
    ///
    /// Errors: a parameter out of range.
    pub fn new(
        young_modulus: f64,
        poisson_ratio: f64,
        onset: f64,
        biaxial_ratio: f64,
        fall: f64,
    ) -> Result<Fracturing, LawError> {
        let elastic = Elastic::new(young_modulus, poisson_ratio)?;
        within(KIND, "biaxial_ratio", biaxial_ratio, [1.0, 1.5], "")?;
        let cone = Cone::of_strengths(onset, biaxial_ratio * onset)?;
        positive(KIND, "fall", fall, "")?;
        let nu = poisson_ratio;
        Ok(Fracturing {
            elastic,
            alpha: cone.alpha * (1.0 + nu) / (1.0 - 2.0 * nu),
            scale: (1.0 + nu) * cone.uniaxial(),
            first: onset / young_modulus,
            fall,
        })
    }

    /// The same with the `energy` [J/m³] that a proportional path dissipates in the end along the elastic strains of uniaxial
    /// compression: r_f = energy (m : D_0⁻¹ : m)/r_0 − r_0/2. Crushing energy over the size of an element makes the law
    /// independent of the mesh as far as its strains localise in one element.
    ///
    /// Errors: a parameter out of range; an energy below that of a drop at the first loss, ½ r_0²/(m : D_0⁻¹ : m).
    pub fn of_energy(
        young_modulus: f64,
        poisson_ratio: f64,
        onset: f64,
        biaxial_ratio: f64,
        energy: f64,
    ) -> Result<Fracturing, LawError> {
        // Any r_f: the surface does not depend on it.
        let law = Fracturing::new(young_modulus, poisson_ratio, onset, biaxial_ratio, 1.0)?;
        let nu = poisson_ratio;
        let (_, m, _) = law.surface(&[-law.first, nu * law.first, nu * law.first, 0.0, 0.0, 0.0]);
        let trace = m[0] + m[1] + m[2];
        let square = m.iter().map(|m| m * m).sum::<f64>();
        let under = ((1.0 + nu) * square - nu * trace * trace) / young_modulus;
        let least = 0.5 * law.first * law.first / under;
        if energy.is_nan() || energy <= least || energy.is_infinite() {
            let allowed = format!("above {}, else a smaller element", found(least, "J/m³"));
            return Err(refuse(KIND, "energy", found(energy, "J/m³"), &allowed));
        }
        Ok(Fracturing { fall: (energy - least) * under / law.first, ..law })
    }

    /// Share A(r) of the stiffness that is left along a proportional path.
    pub fn left(&self, r: f64) -> f64 {
        self.first / r * (-(r - self.first) / self.fall).exp()
    }

    /// f, m and ∂m/∂ε.
    pub fn surface(&self, strain: &Vector) -> (f64, Vector, Matrix) {
        let trace = strain[0] + strain[1] + strain[2];
        // J_2 = ½ ε · A ε, A ε = the deviator with half the engineering shears.
        let a: Vector = std::array::from_fn(|i| if i < 3 { strain[i] - trace / 3.0 } else { 0.5 * strain[i] });
        let root = (0.5 * strain.iter().zip(&a).map(|(e, a)| e * a).sum::<f64>()).max(0.0).sqrt();
        let one = |i: usize| if i < 3 { 1.0 } else { 0.0 };
        // Volumetric strain alone has no direction of shear.
        let over = if root > 1e-14 * trace.abs() && root > 0.0 { 0.5 / root } else { 0.0 };
        let m = std::array::from_fn(|i| (a[i] * over + self.alpha * one(i)) / self.scale);
        let bend = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let own = if i == j { if i < 3 { 1.0 } else { 0.5 } } else { 0.0 };
                let matrix = own - one(i) * one(j) / 3.0;
                over * (matrix - 2.0 * over * a[i] * 2.0 * over * a[j] * 0.5) / self.scale
            })
        });
        ((root + self.alpha * trace) / self.scale, m, bend)
    }
}

/// Row of the upper triangle, column ≥ row.
fn slot(i: usize, j: usize) -> usize {
    let (i, j) = if i <= j { (i, j) } else { (j, i) };
    1 + 6 * i - i * (i + 1) / 2 + j
}

fn matrix(history: &[f64]) -> Matrix {
    std::array::from_fn(|i| std::array::from_fn(|j| history[slot(i, j)]))
}

fn times(a: &Matrix, x: &Vector) -> Vector {
    a.map(|row| dot(&row, x))
}

fn dot(a: &Vector, b: &Vector) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// A⁻¹ b by Cholesky's factor; `None` if A is not positive definite.
fn solve(a: &Matrix, b: &Vector) -> Option<Vector> {
    let mut l = [[0.0; 6]; 6];
    for i in 0..6 {
        for j in 0..=i {
            let sum: f64 = a[i][j] - (0..j).map(|k| l[i][k] * l[j][k]).sum::<f64>();
            if i == j {
                if sum.is_nan() || sum <= 0.0 {
                    return None;
                }
                l[i][i] = sum.sqrt();
            } else {
                l[i][j] = sum / l[j][j];
            }
        }
    }
    let mut x = *b;
    for i in 0..6 {
        x[i] = (x[i] - (0..i).map(|k| l[i][k] * x[k]).sum::<f64>()) / l[i][i];
    }
    for i in (0..6).rev() {
        x[i] = (x[i] - (i + 1..6).map(|k| l[k][i] * x[k]).sum::<f64>()) / l[i][i];
    }
    Some(x)
}

impl Law<6> for Fracturing {
    fn kind(&self) -> &'static str {
        KIND
    }

    fn history_len(&self) -> usize {
        SLOTS
    }

    fn init_history(&self, slots: &mut [f64]) {
        slots[0] = self.first;
        let moduli = self.elastic.solid();
        for i in 0..6 {
            for j in i..6 {
                slots[slot(i, j)] = moduli[i][j];
            }
        }
    }

    fn respond(&self, strain: &Vector, old: &[f64], new: &mut [f64]) -> Result<Response<6>, LawError> {
        new.copy_from_slice(old);
        let before = matrix(old);
        let stress = times(&before, strain);
        let (f, m, bend) = self.surface(strain);
        let failed = || LawError::NoConvergence { law: KIND, increment: f - old[0] };
        if !f.is_finite() {
            return Err(failed());
        }
        if f <= old[0] * (1.0 + 1e-14) {
            return Ok(Response { stress, tangent: before, dissipation: 0.0 });
        }
        let soft = solve(&before, &m).ok_or_else(failed)?;
        let under = dot(&m, &soft);
        let left = self.left(f) / self.left(old[0]);
        let g = (1.0 - left) / under;
        // ∂g: of A(f), and of m.
        let rate = left * (1.0 / f + 1.0 / self.fall) / under;
        let turn = times(&bend, &soft);
        let by: Vector = std::array::from_fn(|j| rate * m[j] - 2.0 * g / under * turn[j]);
        let mut tangent = before;
        for i in 0..6 {
            for j in 0..6 {
                tangent[i][j] -= f * m[i] * by[j] + g * (m[i] * m[j] + f * bend[i][j]);
                if j >= i {
                    new[slot(i, j)] -= g * m[i] * m[j];
                }
            }
        }
        new[0] = f;
        Ok(Response {
            stress: std::array::from_fn(|i| stress[i] - g * f * m[i]),
            tangent,
            dissipation: 0.5 * g * f * f,
        })
    }

    fn inspect(&self, strain: &Vector, history: &[f64]) -> PointState {
        PointState {
            utilisation: (self.surface(strain).0 / history[0]).max(0.0),
            damage: 1.0 - self.left(history[0]),
            ..PointState::default()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> Fracturing {
        Fracturing::new(34e9, 0.2, 20e6, 1.16, 2e-3).unwrap()
    }

    /// f of the elastic strains of uniaxial compression σ is σ/E, of equibiaxial 1.16 σ the same; m is its gradient and ∂m/∂ε the next.
    #[test]
    fn surface_and_its_derivatives() {
        let law = law();
        let (e, nu) = (34e9, 0.2);
        let uniaxial = [-20e6 / e, nu * 20e6 / e, nu * 20e6 / e, 0.0, 0.0, 0.0];
        assert!((law.surface(&uniaxial).0 * e / 20e6 - 1.0).abs() < 1e-14);
        let b = 1.16 * 20e6 / e;
        let equibiaxial = [-b * (1.0 - nu), -b * (1.0 - nu), 2.0 * nu * b, 0.0, 0.0, 0.0];
        assert!((law.surface(&equibiaxial).0 * e / 20e6 - 1.0).abs() < 1e-14);
        let strain = [-1e-3, 3e-4, 2e-4, 4e-4, -2e-4, 1e-4];
        let (_, m, bend) = law.surface(&strain);
        for j in 0..6 {
            let (mut up, mut down) = (strain, strain);
            (up[j], down[j]) = (strain[j] + 1e-8, strain[j] - 1e-8);
            let ((a, m_a, _), (b, m_b, _)) = (law.surface(&up), law.surface(&down));
            assert!(((a - b) / 2e-8 - m[j]).abs() < 1e-7);
            for i in 0..6 {
                let found = (m_a[i] - m_b[i]) / 2e-8;
                assert!((found - bend[i][j]).abs() < 1e-3 / 1e-3 * 1e-2, "{found} {}", bend[i][j]);
            }
        }
    }

    /// A proportional path: the closed form, in one step and in a hundred.
    #[test]
    fn proportional_path() {
        let law = law();
        let unit = [-1.0, 0.25, 0.1, 0.3, 0.0, -0.2];
        let moduli = law.elastic.solid();
        let (_, m, _) = law.surface(&unit);
        let under = dot(&m, &solve(&moduli, &m).unwrap());
        for steps in [1, 100] {
            let mut old = [0.0; SLOTS];
            law.init_history(&mut old);
            let mut new = old;
            let mut stress = [0.0; 6];
            for k in 1..=steps {
                let strain = unit.map(|x| 3e-3 * x * f64::from(k) / f64::from(steps));
                stress = law.respond(&strain, &old, &mut new).unwrap().stress;
                old = new;
            }
            let strain = unit.map(|x| 3e-3 * x);
            let f = law.surface(&strain).0;
            let whole = times(&moduli, &strain);
            for i in 0..6 {
                let exact = whole[i] - (1.0 - law.left(f)) * f / under * m[i];
                assert!((stress[i] - exact).abs() < 1e-9 * 34e6, "{i}: {} {exact}", stress[i]);
            }
        }
    }
}
