//! Masses, levers, frequencies and pressures of the liquid in a rigid upright tank, exact in linear potential flow.
//!
//! Horizontal motion of a rigid tank with ground acceleration `A(t)`; inviscid, incompressible liquid, small waves. The
//! motion splits into an *impulsive* part that follows `A` (surface pressure zero) and *convective* modes, each an
//! oscillator with response acceleration `A_n(t)`. Circle (radius R) and rectangle (half length L) share all resultants,
//! only the radial functions differ. With `a = R or L`, `γ = H/a`, `ζ = z/H`, `ξ = r/R or x/L`, `m` the liquid mass:
//!
//! ```text
//! impulsive     ν_n = (2n+1) π/2, n = 0, 1, …      F_n = I₁(ν_n/γ)/I₁′(ν_n/γ)  |  tanh(ν_n/γ)
//!               p   = ρ H C(ξ,ζ) cos θ A(t)        C at the wall = 2 Σ (−1)ⁿ F_n cos(ν_n ζ)/ν_n²
//!               m_i  = m 2γ Σ F_n/ν_n³
//!               m_i h_i  = m H 2γ Σ F_n (ν_n − (−1)ⁿ)/ν_n⁴                         wall pressure only (EBP)
//!               m_i h_i′ = m H [½ + 2γ Σ F_n (ν_n − 2(−1)ⁿ)/ν_n⁴]                  wall and base pressure (IBP)
//!
//! convective    λ_n: J₁′(λ_n) = 0, n = 1, 2, …  |  λ_n = (2n−1) π/2          x = λ_n γ
//!               w_n = 2/(λ_n² − 1)              |  2/λ_n²                    wave factor, Σ w_n = 1
//!               ω_n² = (g/a) λ_n tanh x
//!               p    = ρ a w_n [J₁(λ_n ξ)/J₁(λ_n) | sin(λ_n ξ)/sin λ_n] cosh(x ζ)/cosh x cos θ A_n(t)
//!               m_n  = m w_n tanh(x)/x
//!               h_n  = H [1 − (cosh x − 1)/(x sinh x)]      h_n′ = H [1 − (cosh x − 2)/(x sinh x)]
//!               surface at the wall: η = (a/g) Σ w_n A_n
//! ```
//!
//! `A_n` is the absolute response acceleration of the mode (of the undamped oscillator `ω_n²` times its displacement).
//! For a rectangle `cos θ` is ±1 on the two walls across the motion; masses refer to the breadth of `m`.
//!
//! Sources: Jacobsen 1949; Housner 1957; EN 1998-4:2006 A.2.1 (circle), A.4 (rectangle, there as graphs). The identities
//! `m_i + Σ m_n = m`, `m_i h_i + Σ m_n h_n = m H/2` and `C γ + Σ p_n/(ρ a) = ξ` (a liquid that is frozen in the first
//! instant) and published four-digit values check the formulas in the tests.

use std::cell::RefCell;
use std::collections::HashMap;
use std::f64::consts::PI;
use std::rc::Rc;

use crate::bessel::{i1_over_i1_prime, i1_prime_scaled, i1_scaled, j, j_prime_zero};
use tank::Shape;

/// Plan of an upright tank, apart from its size.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Plan {
    /// Circular cylinder; lengths refer to the radius R.
    Circle,
    /// Rectangle or plane strip, shaken along its length; lengths refer to the half length L.
    Rectangle,
}

impl From<Shape> for Plan {
    fn from(shape: Shape) -> Plan {
        match shape {
            Shape::Cylinder { .. } => Plan::Circle,
            Shape::Rectangle { .. } => Plan::Rectangle,
        }
    }
}

/// A part of the liquid as a mass on a lever, relative to the liquid mass `m` and the depth `H`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lumped {
    /// Mass over the liquid mass.
    pub mass: f64,
    /// Lever of the wall pressure over H (EBP): moment of the wall just above the base.
    pub lever: f64,
    /// Lever of wall and base pressure over H (IBP): moment below the base plate.
    pub lever_with_base: f64,
}

/// Number of terms of the impulsive series whose remainder is then added in closed form: enough that `F` has reached
/// `1 + γ/(2ν)` (error below 1e-9 in the mass for `γ < 500`).
fn terms(slenderness: f64) -> usize {
    200.max((20.0 * slenderness).ceil().min(10_000.0) as usize)
}

/// `ν_n = (2n+1) π/2` and `(−1)ⁿ`.
fn nu(n: usize) -> (f64, f64) {
    ((n as f64 + 0.5) * PI, if n.is_multiple_of(2) { 1.0 } else { -1.0 })
}

/// `F_n`, the ratio of pressure to normal gradient of the impulsive term at the wall.
fn wall_ratio(plan: Plan, argument: f64) -> f64 {
    match plan {
        Plan::Circle => i1_over_i1_prime(argument),
        Plan::Rectangle => argument.tanh(),
    }
}

/// Impulsive mass and levers of a rigid tank.
///
/// * `slenderness`: γ = H/R or H/L, positive
///
/// Known values: circle γ = 1: 0.5478, 0.4042, 0.7210; rectangle γ = 1: 0.5000, 0.4047, 0.8093.
///
/// This thread remembers the last ones, as it does of an [`ImpulsiveField`].
pub fn impulsive(plan: Plan, slenderness: f64) -> Lumped {
    let key = (plan, slenderness.to_bits());
    if let Some(known) = LUMPED.with_borrow(|last| last.iter().find(|(of, _)| *of == key).map(|(_, known)| *known)) {
        return known;
    }
    let found = summed(plan, slenderness);
    LUMPED.with_borrow_mut(|last| {
        if last.len() == FIELDS {
            last.remove(0);
        }
        last.push((key, found));
    });
    found
}

fn summed(plan: Plan, slenderness: f64) -> Lumped {
    let gamma = slenderness;
    let (mut cubes, mut wall, mut both) = (0.0, 0.0, 0.0);
    let count = terms(gamma);
    for n in 0..count {
        let (nu, sign) = nu(n);
        let f = wall_ratio(plan, nu / gamma);
        cubes += f / nu.powi(3);
        wall += f * (nu - sign) / nu.powi(4);
        both += f * (nu - 2.0 * sign) / nu.powi(4);
    }
    // Remainder of Σ F/ν³ by the midpoint rule with F = 1 + γ/(2ν) (circle) or 1; the alternating parts are below 1e-11.
    let end = count as f64 * PI;
    let rest = match plan {
        Plan::Circle => 1.0 / (2.0 * PI * end * end) + gamma / (6.0 * PI * end.powi(3)),
        Plan::Rectangle => 1.0 / (2.0 * PI * end * end),
    };
    let mass = 2.0 * gamma * (cubes + rest);
    Lumped {
        mass,
        lever: 2.0 * gamma * (wall + rest) / mass,
        lever_with_base: (0.5 + 2.0 * gamma * (both + rest)) / mass,
    }
}

/// Eigenvalue `λ_n` of the `n`-th sloshing mode, `n ≥ 1`: 1.84118, 5.33144, … (circle); π/2, 3π/2, … (rectangle).
pub fn eigenvalue(plan: Plan, n: usize) -> f64 {
    match plan {
        Plan::Circle => j_prime_zero(1, n),
        Plan::Rectangle => (n as f64 - 0.5) * PI,
    }
}

/// Wave factor `w_n`: surface elevation at the wall is `w_n a A_n/g`; 0.8368, 0.0729, 0.0278 … (circle), 0.8106, 0.0901 …
/// (rectangle). The sum over all modes is 1.
pub fn wave_factor(plan: Plan, n: usize) -> f64 {
    let square = eigenvalue(plan, n).powi(2);
    match plan {
        Plan::Circle => 2.0 / (square - 1.0),
        Plan::Rectangle => 2.0 / square,
    }
}

/// Mass and levers of the `n`-th sloshing mode (`n ≥ 1`).
///
/// * `slenderness`: γ = H/R or H/L, positive
///
/// Known values: circle γ = 1, n = 1: 0.4322, 0.6056, 0.7824; rectangle: 0.4733, 0.5825, 0.8591.
pub fn convective(plan: Plan, slenderness: f64, n: usize) -> Lumped {
    let eigenvalue = eigenvalue(plan, n);
    let x = eigenvalue * slenderness;
    Lumped {
        mass: wave_factor(plan, n) * x.tanh() / x,
        lever: convective_lever(x, 1.0),
        lever_with_base: convective_lever(x, 2.0),
    }
}

/// `1 − (cosh x − c)/(x sinh x)`: lever of a sloshing mode over H with `c = 1` (EBP) or `c = 2` (IBP).
///
/// Written as `1 − tanh(x/2)/x + (c − 1)/(x sinh x)`, which neither cancels nor overflows.
pub fn convective_lever(x: f64, c: f64) -> f64 {
    1.0 - (0.5 * x).tanh() / x + (c - 1.0) / (x * x.sinh())
}

/// Circular frequency of the `n`-th sloshing mode [rad/s].
///
/// * `half_length`: R or L [m]; `depth`: H [m]; `gravity`: g [m/s²]
///
/// Known value: R = 1.83 m, H = 1.525 m, g = 9.81 m/s², n = 1: 2.9987 rad/s.
pub fn sloshing_omega(plan: Plan, n: usize, half_length: f64, depth: f64, gravity: f64) -> f64 {
    let eigenvalue = eigenvalue(plan, n);
    (gravity / half_length * eigenvalue * (eigenvalue * depth / half_length).tanh()).sqrt()
}

/// Pressure of a sloshing mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConvectiveField {
    plan: Plan,
    eigenvalue: f64,
    wave_factor: f64,
    /// `x = λ γ`.
    x: f64,
}

impl ConvectiveField {
    /// The `n`-th mode (`n ≥ 1`) at slenderness γ = H/a.
    pub fn new(plan: Plan, slenderness: f64, n: usize) -> ConvectiveField {
        let eigenvalue = eigenvalue(plan, n);
        ConvectiveField { plan, eigenvalue, wave_factor: wave_factor(plan, n), x: eigenvalue * slenderness }
    }

    /// `p/(ρ a A_n)` at the wall, `w cosh(xζ)/cosh x`; equals the wave factor at the surface.
    pub fn wall(&self, zeta: f64) -> f64 {
        self.wave_factor * cosh_ratio(self.x, zeta)
    }

    /// `p/(ρ a A_n)` at `ξ = r/R` or `x/L` (0 ≤ ξ ≤ 1) and `ζ = z/H`, in the direction of motion.
    pub fn at(&self, xi: f64, zeta: f64) -> f64 {
        let radial = match self.plan {
            Plan::Circle => j(1, self.eigenvalue * xi) / j(1, self.eigenvalue),
            Plan::Rectangle => (self.eigenvalue * xi).sin() / self.eigenvalue.sin(),
        };
        radial * self.wall(zeta)
    }

    /// Moment at height ζ of the wall pressure above it, `M(z)/(m H A_n)`; at ζ = 0 mass × lever (EBP).
    pub fn moment_above(&self, zeta: f64) -> f64 {
        let x = self.x;
        self.wave_factor * ((1.0 - zeta) * x.tanh() / x - (1.0 - cosh_ratio(x, zeta)) / (x * x))
    }

    /// Shear at height ζ of the wall pressure above it, `Q(z)/(m A_n)`; at ζ = 0 the mass ratio.
    pub fn shear_above(&self, zeta: f64) -> f64 {
        let x = self.x;
        // (sinh x − sinh xζ)/cosh x, without overflow.
        let sinh_ratio = (-x * (1.0 - zeta)).exp() * -(-2.0 * x * zeta).exp_m1() / (1.0 + (-2.0 * x).exp());
        self.wave_factor * (x.tanh() - sinh_ratio) / x
    }
}

/// `cosh(xζ)/cosh(x)` for 0 ≤ ζ ≤ 1, without overflow.
pub fn cosh_ratio(x: f64, zeta: f64) -> f64 {
    (-x * (1.0 - zeta)).exp() * (1.0 + (-2.0 * x * zeta).exp()) / (1.0 + (-2.0 * x).exp())
}

/// Impulsive pressure of a rigid tank, `p = ρ H C(ξ,ζ) cos θ A`.
///
/// The series converges like 1/ν²; with 1000 terms `C` is exact to 1e-6 except within H/1000 of the surface (1e-4).
///
/// A field depends on the shape of the liquid alone. This thread remembers the last ones with their sums: two editions ask for the same heights of
/// one tank, and a study again for every record and scale.
#[derive(Clone, Debug)]
pub struct ImpulsiveField {
    plan: Plan,
    slenderness: f64,
    /// `2 (−1)ⁿ F_n/ν_n²`.
    wall: Rc<Vec<f64>>,
    /// Sum and height ζ → value.
    known: Rc<RefCell<HashMap<(Sum, u64), f64>>>,
}

/// The sums of a field over the height.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Sum {
    Wall,
    Moment,
    Shear,
}

/// Fields and impulsive masses that a thread remembers.
const FIELDS: usize = 8;
/// Values of a field that are remembered: more heights than a procedure looks at.
const VALUES: usize = 4096;

thread_local! {
    /// The last fields, the newest last.
    static LAST: RefCell<Vec<ImpulsiveField>> = const { RefCell::new(Vec::new()) };
    /// The last impulsive masses, by plan and slenderness, the newest last.
    static LUMPED: RefCell<Vec<((Plan, u64), Lumped)>> = const { RefCell::new(Vec::new()) };
}

/// Terms kept by [`ImpulsiveField`].
const FIELD_TERMS: usize = 1000;

impl ImpulsiveField {
    /// Field at slenderness γ = H/a.
    pub fn new(plan: Plan, slenderness: f64) -> ImpulsiveField {
        let same = |field: &&ImpulsiveField| field.plan == plan && field.slenderness.to_bits() == slenderness.to_bits();
        if let Some(known) = LAST.with_borrow(|last| last.iter().find(same).cloned()) {
            return known;
        }
        let field = ImpulsiveField::computed(plan, slenderness);
        LAST.with_borrow_mut(|last| {
            if last.len() == FIELDS {
                last.remove(0);
            }
            last.push(field.clone());
        });
        field
    }

    fn computed(plan: Plan, slenderness: f64) -> ImpulsiveField {
        let wall = (0..FIELD_TERMS)
            .map(|n| {
                let (nu, sign) = nu(n);
                2.0 * sign * wall_ratio(plan, nu / slenderness) / (nu * nu)
            })
            .collect();
        ImpulsiveField { plan, slenderness, wall: Rc::new(wall), known: Rc::default() }
    }

    /// A sum at a height, found once.
    fn remembered(&self, sum: Sum, zeta: f64, find: impl FnOnce() -> f64) -> f64 {
        let key = (sum, zeta.to_bits());
        if let Some(value) = self.known.borrow().get(&key) {
            return *value;
        }
        let value = find();
        let mut known = self.known.borrow_mut();
        if known.len() >= VALUES {
            known.clear();
        }
        known.insert(key, value);
        value
    }

    /// `C` at the wall, `p/(ρ H A)`. Known values (circle, γ = 1): 0.7403 at the base, 0.6178 at mid-height.
    pub fn wall(&self, zeta: f64) -> f64 {
        if zeta >= 1.0 {
            return 0.0;
        }
        self.remembered(Sum::Wall, zeta, || self.sum(zeta, |_, cosine, _| cosine))
    }

    /// Moment at height ζ of the wall pressure above it, `M(z)/(m H A)`; at ζ = 0 mass × lever (EBP).
    pub fn moment_above(&self, zeta: f64) -> f64 {
        let zeta = zeta.min(1.0);
        let term = |nu: f64, cosine: f64, sign: f64| (1.0 - zeta) * sign / nu - cosine / (nu * nu);
        self.remembered(Sum::Moment, zeta, || self.slenderness * self.sum(zeta, term))
    }

    /// Shear at height ζ of the wall pressure above it, `Q(z)/(m A)`; at ζ = 0 the mass ratio.
    pub fn shear_above(&self, zeta: f64) -> f64 {
        let zeta = zeta.min(1.0);
        let term = |n: usize| {
            let (nu, sign) = nu(n);
            self.wall[n] * (sign - (nu * zeta).sin()) / nu
        };
        self.remembered(Sum::Shear, zeta, || self.slenderness * (0..self.wall.len()).map(term).sum::<f64>())
    }

    /// `C` at `ξ = r/R` or `x/L` (0 ≤ ξ ≤ 1) and ζ, in the direction of motion.
    pub fn at(&self, xi: f64, zeta: f64) -> f64 {
        (0..self.wall.len())
            .map(|n| {
                let (nu, sign) = nu(n);
                let y = nu / self.slenderness;
                let decay = (-y * (1.0 - xi)).exp();
                let radial = match self.plan {
                    Plan::Circle => decay * i1_scaled(y * xi) / i1_prime_scaled(y),
                    Plan::Rectangle => decay * -(-2.0 * y * xi).exp_m1() / (1.0 + (-2.0 * y).exp()),
                };
                2.0 * sign / (nu * nu) * radial * (nu * zeta).cos()
            })
            .sum()
    }

    /// `Σ wall[n] term(ν_n, cos ν_n ζ, (−1)ⁿ)` with the cosines by Chebyshev's recurrence.
    fn sum(&self, zeta: f64, term: impl Fn(f64, f64, f64) -> f64) -> f64 {
        let twice = 2.0 * (PI * zeta).cos();
        let mut before = (0.5 * PI * zeta).cos(); // cos(−ν_0 ζ)
        let mut cosine = before;
        let mut sum = 0.0;
        for (n, coefficient) in self.wall.iter().enumerate() {
            let (nu, sign) = nu(n);
            sum += coefficient * term(nu, cosine, sign);
            (before, cosine) = (cosine, twice * cosine - before);
        }
        sum
    }
}

#[cfg(test)]
mod tests;
