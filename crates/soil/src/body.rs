//! A body in its modes on cones: translation and rocking of a rigid foundation under a tank with its liquid.
//!
//! ```text
//! modes        q̈_n + 2 ξ_n ω_n q̇_n + ω_n² q_n = −Γ_n A − Γ_n^ψ ψ̈                     A = a_g + ẍ
//! translation  (m + m_b) A + Σ Γ_n q̈_n + S ψ̈ + C_x ẋ + K_x x = 0
//! rotation     (J + J_b + J_soil) ψ̈ + Σ Γ_n^ψ q̈_n + S A + K_θ ψ + C_θ (ψ̇ − θ̇) = 0
//! internal     M₁ θ̈ + C_θ (θ̇ − ψ̇) = 0
//! ```
//!
//! Γ_n, Γ_n^ψ are the excitation rows of a unit translation and rotation, m, S, J the mass, first and second moment of the body about the
//! foundation; m − Σ Γ_n², … are the shares of modes that are left out and move with the base. One mode with Γ = √m, Γ^ψ = √m h is the
//! structure of [`crate::chain`].
//!
//! Newmark's average acceleration; the modes are eliminated in each step. Source: as [`crate::chain`].

use oscillator::newmark::Newmark;

use crate::disc::Disc;
use crate::error::{SoilError, not_negative, positive};
use crate::structure::Structure;

/// A mode of the body on a fixed base.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// ω [rad/s].
    pub omega: f64,
    /// Damping ratio ξ.
    pub damping: f64,
    /// Participation Γ in a translation [√kg].
    pub translation: f64,
    /// Participation Γ^ψ in a rotation [√kg m].
    pub rotation: f64,
}

/// A body and its slab.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Its modes.
    pub modes: Vec<Mode>,
    /// Mass m [kg].
    pub mass: f64,
    /// First moment S about the foundation [kg m].
    pub first_moment: f64,
    /// Second moment J about the foundation [kg m²].
    pub second_moment: f64,
    /// Mass of the slab m_b [kg].
    pub slab_mass: f64,
    /// Moment of inertia J_b of the slab about its own axis [kg m²].
    pub slab_inertia: f64,
}

/// Histories at each sample.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct History {
    /// Translation x of the foundation [m].
    pub translation: Vec<f64>,
    /// Rotation ψ [rad].
    pub rotation: Vec<f64>,
    /// q̈_n and q_n of each mode, [√kg m/s²] and [√kg m].
    pub modes: Vec<Vec<[f64; 2]>>,
    /// A = a_g + ẍ [m/s²].
    pub acceleration: Vec<f64>,
    /// ψ̈ [rad/s²].
    pub rotational_acceleration: Vec<f64>,
}

impl Mode {
    /// The structure of one mass that this mode is: m = Γ², h = |Γ^ψ/Γ|.
    pub fn structure(&self) -> Structure {
        Structure {
            mass: self.translation * self.translation,
            height: (self.rotation / self.translation).abs(),
            period: std::f64::consts::TAU / self.omega,
            damping: self.damping,
        }
    }
}

/// Displacement, velocity, acceleration.
type Point = [f64; 3];

impl Body {
    /// Errors: a negative mass or damping; modes whose shares exceed the mass or the second moment by more than rounding.
    fn admissible(&self) -> Result<(), SoilError> {
        not_negative("mass of the slab [kg]", self.slab_mass)?;
        not_negative("moment of inertia of the slab [kg m2]", self.slab_inertia)?;
        for mode in &self.modes {
            positive("frequency of a mode [rad/s]", mode.omega)?;
            not_negative("damping ratio of a mode", mode.damping)?;
        }
        let share = |f: &dyn Fn(&Mode) -> f64| self.modes.iter().map(f).sum::<f64>();
        let slack = 1e-9;
        let left = self.mass * (1.0 + slack) - share(&|m| m.translation * m.translation);
        not_negative("mass less that of the modes [kg]", left)?;
        let left = self.second_moment * (1.0 + slack) - share(&|m| m.rotation * m.rotation);
        not_negative("second moment less that of the modes [kg m2]", left)
    }
}

/// Runs the body from rest.
///
/// * `ground`: acceleration a_g [m/s²], linear between samples `h` [s] apart; `parts` ≥ 1 steps to a sample
///
/// Errors: a time step that is not above 0; modes whose shares exceed the mass or the second moment by more than rounding.
pub fn march(body: &Body, disc: &Disc, ground: &[f64], h: f64, parts: usize) -> Result<History, SoilError> {
    positive("time step [s]", h)?;
    body.admissible()?;
    let parts = parts.max(1);
    let n = Newmark::average_acceleration(h / parts as f64);
    let cones = disc.cones();
    let k = [cones.stiffness.horizontal, cones.stiffness.rocking, 0.0];
    let rows = |m: &Mode| [m.translation, m.rotation, 0.0];
    let rate = |m: &Mode| 1.0 / (1.0 + 2.0 * n.a7 * m.damping * m.omega + m.omega * m.omega / n.a0);
    let damper = cones.rocking_dashpot;
    let c = [[cones.horizontal_dashpot, 0.0, 0.0], [0.0, damper, -damper], [0.0, -damper, damper]];
    let mass = [
        [body.mass + body.slab_mass, body.first_moment, 0.0],
        [body.first_moment, body.second_moment + body.slab_inertia + cones.trapped_inertia, 0.0],
        [0.0, 0.0, cones.internal_inertia],
    ];
    let share = |f: &dyn Fn(&Mode) -> f64| body.modes.iter().map(f).sum::<f64>();
    // The system of the step, in accelerations: M − Σ r_n Γ Γᵀ + a₇ C + K/a₀.
    let mut system = [[0.0; 3]; 3];
    let mut carried = mass;
    for i in 0..3 {
        for j in 0..3 {
            carried[i][j] -= share(&|m| rate(m) * rows(m)[i] * rows(m)[j]);
            system[i][j] = carried[i][j] + n.a7 * c[i][j] + if i == j { k[i] / n.a0 } else { 0.0 };
        }
    }
    // At rest, with no force in the ground, the masses keep still in space; a massless foundation has no acceleration to start from.
    let mut base = [[0.0; 3]; 3];
    base[0][2] = -ground.first().copied().unwrap_or(0.0);
    let mut modes: Vec<Point> = vec![[0.0; 3]; body.modes.len()];
    let mut out = History { modes: vec![Vec::new(); modes.len()], ..History::default() };
    out.push(ground.first().copied().unwrap_or(0.0), &base, &modes);
    for pair in ground.windows(2) {
        let mut load = pair[0];
        for part in 1..=parts {
            load = pair[0] + (pair[1] - pair[0]) * part as f64 / parts as f64;
            let predicted = base.map(|p| predict(&n, &p));
            let own = |m: &Mode, p: &Point| {
                let [u, v] = predict(&n, p);
                -(2.0 * m.damping * m.omega * v + m.omega * m.omega * u) * rate(m)
            };
            let mut rhs = [0.0; 3];
            for i in 0..3 {
                rhs[i] = -carried[i][0] * load - k[i] * predicted[i][0] - dot(c[i], predicted.map(|p| p[1]));
                rhs[i] -= body.modes.iter().zip(&modes).map(|(m, p)| rows(m)[i] * own(m, p)).sum::<f64>();
            }
            let a = solve(system, rhs);
            for (m, p) in body.modes.iter().zip(&mut modes) {
                let q = own(m, p) - rate(m) * (m.translation * (load + a[0]) + m.rotation * a[1]);
                take(&n, p, q);
            }
            for i in 0..3 {
                take(&n, &mut base[i], a[i]);
            }
        }
        out.push(load, &base, &modes);
    }
    Ok(out)
}

impl History {
    fn push(&mut self, ground: f64, base: &[Point; 3], modes: &[Point]) {
        self.translation.push(base[0][0]);
        self.rotation.push(base[1][0]);
        self.acceleration.push(ground + base[0][2]);
        self.rotational_acceleration.push(base[1][2]);
        for (list, p) in self.modes.iter_mut().zip(modes) {
            list.push([p[2], p[0]]);
        }
    }
}

fn predict(n: &Newmark, p: &Point) -> [f64; 2] {
    [n.predict_displacement(p[0], p[1], p[2]), n.predict_velocity(p[1], p[2])]
}

fn take(n: &Newmark, p: &mut Point, acceleration: f64) {
    let [u, v] = predict(n, p);
    *p = [u + acceleration / n.a0, v + n.a7 * acceleration, acceleration];
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Gauss without exchange of rows: the matrix of a step is positive definite.
fn solve(mut a: [[f64; 3]; 3], mut b: [f64; 3]) -> [f64; 3] {
    for k in 0..3 {
        for i in k + 1..3 {
            let factor = a[i][k] / a[k][k];
            for j in k..3 {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..3).rev() {
        let known: f64 = (k + 1..3).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}
