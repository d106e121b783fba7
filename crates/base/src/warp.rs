//! Warping of the foot: strips side by side under a wall whose foot need not stay plane.
//!
//! ```text
//! w(φ) = w₀ + ψ R cos φ + Σ U_n cos nφ          ∫ F(w) cos nφ dφ + π K_n U_n = 0        n = 2 … 12
//! ```
//!
//! The plate keeps the foot round. A wall that neither stretches nor shears follows a wave of its foot by ovalling: u = U cos nφ, v = n U z/R sin nφ,
//! w = −n² U z/R cos nφ. Its stiffness comes from the hoop force of the liquid, from rings and from the bending of the courses:
//!
//! ```text
//! K_n = n⁴ (n² − 1) ρ g H⁴/(12 R³) + n⁴ (n² − 1)²/R⁶ [Σ E I z² + ∫ D z² dz]
//! ```
//!
//! per length of the circumference. The first term is the work ½ ∫ N_θ (n² − 1) w²/R² dz of the hoop force N_θ = ρ g (H − z) R under a pressure that
//! turns with the wall. The pressure of the motion, −p_b p(z) cos φ, lowers the hoop force on the lifted side and raises it at the toe. Its membrane forces
//! N_θ, N_zθ and N_z couple neighbouring waves, n = m + 1:
//!
//! ```text
//! K_nm = −p_b/(2 R) [c ∫ p z² dz/R² − ½ ∫ p dz]
//! c = n′ m′ − ½ (n m + n² m²) + ½ (n′ m² − m′ n²) + ½ n m (n² + m² − 2)                    n′ = n³ − n
//! ```
//!
//! This is the work ½ N_θ (β² + u_φ²/R²) + ½ N_z (v_z² + w_z²) + N_zθ β w_z, β = (w_φ − v)/R, and the symmetric part of that of the pressure. The
//! membrane between a foot and a rim that both stay round acts in series. Without axial force at the rim, with constant N_zθ and N_θ = 0:
//!
//! ```text
//! 1/K = 1/K_n + R² [∫ dz/(G t) + n²/R² ∫ (L − z)² dz/(E t)]/(n L)²          L: height of the wall
//! ```
//!
//! Under a round rim only the membrane is left.

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::rc::Rc;

use tank::{Case, Shape};

use crate::element::GAUSS;
use crate::error::BaseError;
use crate::rocking::{Turn, lifted};
use dry::Dry;

mod dry;

/// Waves of the foot that are free, from n = 2 on.
pub const WAVES: usize = 11;
/// Centre and waves.
const UNKNOWNS: usize = WAVES + 1;
/// Iterations of Newton's method at one rotation.
const ITERATIONS: usize = 60;
/// Residual over the weight at which the iteration ends, and the largest that is accepted where rounding stops it.
const SETTLED: f64 = 1e-11;
const ROUNDED: f64 = 1e-7;
/// Smallest part of a Newton step: the work of strips and wall is convex, so that some part reduces the residual.
const SHORTEST: f64 = 1e-3;

/// Support that keeps the top edge of the wall round.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Top {
    /// The roof or a stiff girder.
    Round,
    /// Rings on the wall.
    Rings,
    /// Nothing.
    Free,
}

/// Terms of the series of the impulsive pressure.
const TERMS: usize = 60;
/// Halvings of an interval: rounding.
const HALVINGS: usize = 52;
/// Largest bottom pressure of the motion over that at which the wall loses its stiffness against one combination of waves. Under a free rim it is about 0.4
/// of the pressure at rest, where strips and shells of a squat tank begin to differ (`docs/theory/base.md`, section 2).
const COMPARED: f64 = 0.75;

/// Stiffness between waves n = 2, 3, … [N/m²].
type Matrix = [[f64; WAVES]; WAVES];

/// Stiffness of the wall against waves of its foot.
#[derive(Clone, Debug, PartialEq)]
pub struct Warping {
    /// K of a wall that ovals, without pressure of the motion [N/m²].
    free: [f64; WAVES],
    /// Loss between neighbouring waves per Pa of suction p_b at the lifted side [N/m² per Pa].
    sucked: Matrix,
    /// 1/K of the membrane below a round rim [m²/N].
    held: [f64; WAVES],
    top: Top,
    /// Moment of the impulsive pressure on the wall over its bottom pressure [m³].
    lever: f64,
    dry: Dry,
    /// Whether the liquid pulls on the wall where its pressure falls below that of the air.
    pulls: bool,
}

impl Warping {
    /// The wall of a tank at its fill; `None` where the tank is not a cylinder.
    pub fn of(case: &Case) -> Option<Warping> {
        Warping::built(case, false, case.gravity)
    }

    /// * `net`: whether corrosion is deducted from the courses
    pub(crate) fn built(case: &Case, net: bool, gravity: f64) -> Option<Warping> {
        let tank = &case.tank;
        let Shape::Cylinder { radius } = tank.shape else { return None };
        let (height, depth) = (tank.wall_height(), case.liquid.fill_height);
        let (mut bending, mut shearing, mut axial, mut base) = (0.0, 0.0, 0.0, 0.0);
        for course in &tank.courses {
            let (from, to) = (base, base + course.height);
            let (young, nu) = (course.material.youngs_modulus, course.material.poisson_ratio);
            let t = if net { course.net_thickness() } else { course.thickness };
            let cubes = |a: f64, b: f64| (b.powi(3) - a.powi(3)) / 3.0;
            bending += young * t.powi(3) / (12.0 * (1.0 - nu * nu)) * cubes(from, to);
            shearing += 2.0 * (1.0 + nu) * course.height / (young * t);
            axial += cubes(height - to, height - from) / (young * t);
            base = to;
        }
        bending += tank.rings.iter().map(|r| r.material.youngs_modulus * r.inertia * r.height * r.height).sum::<f64>();
        let liquid = case.liquid.density * gravity * depth.powi(4) / (12.0 * radius.powi(3));
        let top = match (tank.roof.holds.is_free(), tank.rings.is_empty()) {
            (false, _) => Top::Round,
            (true, false) => Top::Rings,
            (true, true) => Top::Free,
        };
        let n = |k: usize| (k + 2) as f64;
        let free =
            |k: usize| n(k).powi(4) * (n(k).powi(2) - 1.0) * (liquid + (n(k).powi(2) - 1.0) * bending / radius.powi(6));
        let held = |k: usize| radius * radius * (shearing + (n(k) / radius).powi(2) * axial) / (n(k) * height).powi(2);
        let [level, first, square] = moments(radius / depth).map(|m| m * depth);
        let sucked = |i: usize, j: usize| {
            if i.abs_diff(j) != 1 {
                return 0.0;
            }
            let (n, m) = (n(i.max(j)), n(i.min(j)));
            let cubic = |n: f64| n * (n * n - 1.0);
            let waves = cubic(n) * cubic(m) - 0.5 * (n * m + n * n * m * m)
                + 0.5 * (cubic(n) * m * m - cubic(m) * n * n)
                + 0.5 * n * m * (n * n + m * m - 2.0);
            (waves * square * (depth / radius).powi(2) - 0.5 * level) / (2.0 * radius)
        };
        Some(Warping {
            free: std::array::from_fn(free),
            sucked: std::array::from_fn(|i| std::array::from_fn(|j| sucked(i, j))),
            held: std::array::from_fn(held),
            top,
            lever: PI * radius * depth * first,
            dry: Dry::new(radius, depth, case.liquid.density * gravity * depth),
            pulls: true,
        })
    }

    /// The same wall with liquid that does not pull on it.
    pub(crate) fn without_pull(self) -> Warping {
        Warping { pulls: false, ..self }
    }

    /// Bottom pressure of impulsive liquid whose pressure on the wall has this moment [N m] about the foot [Pa].
    pub(crate) fn suction_with(&self, moment: f64) -> f64 {
        moment / self.lever
    }

    /// Largest bottom pressure of the motion up to which strips agree with shells [Pa]; `None` under a round rim, whose membrane it leaves alone.
    pub(crate) fn largest_suction(&self) -> Option<f64> {
        (self.top != Top::Round).then(|| COMPARED * self.softened())
    }

    /// Bottom pressure of the motion at which the wall loses its stiffness against one combination of waves [Pa]: the smallest root of det K, a tridiagonal
    /// matrix, by bisection on its pivots. The membrane in series does not change the root.
    fn softened(&self) -> f64 {
        let stable = |suction: f64| {
            let mut pivot = self.free[0];
            (1..WAVES).all(|k| {
                pivot = self.free[k] - (suction * self.sucked[k][k - 1]).powi(2) / pivot;
                pivot > 0.0
            })
        };
        let (mut low, mut high) = (0.0, (self.free[0] * self.free[1]).sqrt() / self.sucked[1][0].abs());
        for _ in 0..HALVINGS {
            let middle = 0.5 * (low + high);
            if stable(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }

    /// K of n = 2, 3, … at rest [N/m²].
    pub fn stiffness(&self) -> [f64; WAVES] {
        let (still, _) = self.under(0.0);
        std::array::from_fn(|k| still[k][k])
    }

    /// K [N/m²] and the load on the waves [N/m] under a bottom pressure that is lower by `suction` cos φ [Pa].
    fn under(&self, suction: f64) -> (Matrix, [f64; WAVES]) {
        let mut stiffness = [[0.0; WAVES]; WAVES];
        let mut load = [0.0; WAVES];
        if self.top == Top::Round {
            (0..WAVES).for_each(|k| stiffness[k][k] = 1.0 / self.held[k]);
            return (stiffness, load);
        }
        for i in 0..WAVES {
            for j in 0..WAVES {
                stiffness[i][j] = if i == j { self.free[i] } else { -suction * self.sucked[i][j] };
            }
        }
        if !self.pulls {
            let added;
            (load, added) = self.dry.at(suction);
            stiffness.iter_mut().flatten().zip(added.iter().flatten()).for_each(|(to, own)| *to += own);
        }
        // Ovalling F and membrane H in series: (1 + F H) f = F U − q.
        let mut left = stiffness;
        for (i, row) in left.iter_mut().enumerate() {
            row.iter_mut().zip(&self.held).for_each(|(own, held)| *own *= held);
            row[i] += 1.0;
        }
        for k in 0..WAVES {
            for i in (0..WAVES).filter(|i| *i != k) {
                let factor = left[i][k] / left[k][k];
                for j in 0..WAVES {
                    left[i][j] -= factor * left[k][j];
                    stiffness[i][j] -= factor * stiffness[k][j];
                }
                load[i] -= factor * load[k];
            }
        }
        for k in 0..WAVES {
            stiffness[k].iter_mut().for_each(|v| *v /= left[k][k]);
            load[k] /= left[k][k];
        }
        (stiffness, load)
    }

    /// Support of the top edge.
    pub fn top(&self) -> Top {
        self.top
    }
}

/// ∫ p dζ, ∫ p ζ dζ and ∫ p ζ² dζ of the impulsive pressure p(ζ) on a rigid wall over that at its foot, ζ = z/H.
///
/// ```text
/// p ∝ Σ (−1)^k/α² I₁(α R)/I₁′(α R) cos α z          α = (2 k + 1) π/(2 H)
/// ```
///
/// * `ratio`: R/H
fn moments(ratio: f64) -> [f64; 3] {
    let (mut foot, mut sums) = (0.0, [0.0; 3]);
    for (alpha, share) in terms(ratio) {
        foot += share;
        // ∫ cos α ζ, ∫ ζ cos α ζ and ∫ ζ² cos α ζ with cos α = 0 and sin α = ±1, the sign of the share.
        sums[0] += share.abs() / alpha;
        sums[1] += share.abs() / alpha - share / (alpha * alpha);
        sums[2] += share.abs() * (1.0 / alpha - 2.0 / alpha.powi(3));
    }
    sums.map(|sum| sum / foot)
}

/// The same pressure at ζ, 1 at the foot.
fn shape(ratio: f64, zeta: f64) -> f64 {
    let (mut foot, mut here) = (0.0, 0.0);
    for (alpha, share) in terms(ratio) {
        foot += share;
        here += share * (alpha * zeta).cos();
    }
    here / foot
}

/// α H and (−1)^k/(α H)² I₁(α R)/I₁′(α R) of its terms.
fn terms(ratio: f64) -> impl Iterator<Item = (f64, f64)> {
    (0..TERMS).map(move |k| {
        let alpha = (2.0 * k as f64 + 1.0) * PI / 2.0;
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        (alpha, sign * bessel(alpha * ratio) / (alpha * alpha))
    })
}

/// I₁(x)/I₁′(x): power series; beyond x = 50 the first terms in 1/x.
fn bessel(x: f64) -> f64 {
    if x > 50.0 {
        return 1.0 + 0.5 / x;
    }
    let (mut term, mut over_x, mut slope) = (0.5, 0.5, 0.5);
    for k in 1..200 {
        let k = f64::from(k);
        term *= 0.25 * x * x / (k * (k + 1.0));
        over_x += term;
        slope += (2.0 * k + 1.0) * term;
    }
    x * over_x / slope
}

/// A foot that warps, for any law of its rim.
pub(crate) struct Foot<'a> {
    /// Radius R [m].
    pub(crate) radius: f64,
    /// Weight w_t of wall and roof [N/m].
    pub(crate) weight: f64,
    /// Stiffness of the wall.
    pub(crate) warping: &'a Warping,
    /// Pressure at rest less the bottom pressure at the lifted side [Pa].
    pub(crate) suction: f64,
    /// Places around at which the law is asked.
    pub(crate) places: Rc<[Place]>,
    /// Pull on the wall [N/m] and its slope [N/m²] as functions of the uplift [m] and of the cosine of the angle from the lifted side.
    pub(crate) hold: &'a dyn Fn(f64, f64) -> [f64; 2],
}

/// A place around, from the lifted side to the toe.
pub(crate) struct Place {
    /// Cosine of its angle.
    cos: f64,
    /// Angle that it stands for [rad].
    width: f64,
    /// 1, cos 2φ, cos 3φ, …
    forms: [f64; UNKNOWNS],
}

thread_local! {
    /// The places of each number of panels that was asked for.
    static PLACES: RefCell<BTreeMap<usize, Rc<[Place]>>> = const { RefCell::new(BTreeMap::new()) };
}

/// The Gauss points of panels from the lifted side to the toe, three in each.
pub(crate) fn places(panels: usize) -> Rc<[Place]> {
    let width = PI / panels as f64;
    let place = |panel: usize, (x, weight): (f64, f64)| {
        let cos = ((panel as f64 + x) * width).cos();
        let mut forms = [1.0; UNKNOWNS];
        let (mut before, mut last) = (1.0, cos);
        for form in &mut forms[1..] {
            (before, last) = (last, 2.0 * cos * last - before);
            *form = last;
        }
        Place { cos, width: weight * width, forms }
    };
    let made = || (0..panels).flat_map(|panel| GAUSS.map(|point| place(panel, point))).collect();
    PLACES.with_borrow_mut(|kept| Rc::clone(kept.entry(panels).or_insert_with(made)))
}

/// Sums over half of the circumference, over R.
#[derive(Default)]
struct Sums {
    /// Forces on the unknowns [N/m].
    force: [f64; UNKNOWNS],
    /// Their derivatives [N/m²].
    slope: [[f64; UNKNOWNS]; UNKNOWNS],
    /// ∫ F cos φ dφ [N/m].
    moment: f64,
}

impl Foot<'_> {
    /// The base at a rotation ψ [rad], starting from a turn close to it.
    ///
    /// Errors: the rim leaves the range of uplifts of the law [m]; no equilibrium.
    pub(crate) fn at(&self, rotation: f64, start: &Turn, (from, to): (f64, f64)) -> Result<Turn, BaseError> {
        let mut unknowns = [start.centre; UNKNOWNS];
        unknowns[1..].copy_from_slice(&start.waves);
        let sums = self.settle(rotation, &mut unknowns, 0)?;
        let mut waves = [0.0; WAVES];
        waves.copy_from_slice(&unknowns[1..]);
        let mut turn = Turn {
            rotation,
            moment: 2.0 * self.radius * self.radius * sums.moment,
            centre: unknowns[0],
            uplift: 0.0,
            toe_force: 0.0,
            pull: 0.0,
            lifted_angle: 0.0,
            waves,
        };
        let rim = turn.around(self.radius);
        let lowest = rim.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = rim.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        // The toe first: where it is pressed too deep, the lifted side may be out of range as well.
        for wanted in [lowest, highest] {
            if wanted < from || wanted > to {
                return Err(BaseError::BeyondCurve { rotation, wanted, from, to });
            }
        }
        let (high, low) = (rim[0], rim[rim.len() - 1]);
        turn.uplift = high;
        turn.toe_force = -(self.hold)(low, -1.0)[0];
        turn.pull = (self.hold)(high, 1.0)[0];
        turn.lifted_angle = lifted(&rim);
        Ok(turn)
    }

    /// Force [N] and moment [N m] of the strips with the centre of the foot held at a height [m]; `waves` is updated to the equilibrium there.
    ///
    /// Errors: no equilibrium.
    pub(crate) fn held(&self, rotation: f64, centre: f64, waves: &mut [f64; WAVES]) -> Result<(f64, f64), BaseError> {
        let mut unknowns = [centre; UNKNOWNS];
        unknowns[1..].copy_from_slice(waves);
        let sums = self.settle(rotation, &mut unknowns, 1)?;
        waves.copy_from_slice(&unknowns[1..]);
        let force = sums.force[0] - PI * self.weight;
        Ok((2.0 * self.radius * force, 2.0 * self.radius * self.radius * sums.moment))
    }

    /// Newton's method on all unknowns except the first `held`.
    fn settle(&self, rotation: f64, unknowns: &mut [f64; UNKNOWNS], held: usize) -> Result<Sums, BaseError> {
        let reach = rotation * self.radius;
        let scale = PI * self.weight.abs().max(f64::MIN_POSITIVE);
        let size = |sums: &Sums| sums.force[held..].iter().map(|f| f * f).sum::<f64>().sqrt() / scale;
        let wall = self.warping.under(self.suction);
        let mut found = self.sums(&wall, unknowns, reach);
        for _ in 0..ITERATIONS {
            let off = size(&found);
            if off <= SETTLED {
                return Ok(found);
            }
            let step = solve(&found, held);
            // The law stiffens and softens: the step is halved until the residual decreases.
            let mut share = 1.0;
            loop {
                let next: [f64; UNKNOWNS] = std::array::from_fn(|i| unknowns[i] - share * step[i]);
                let there = self.sums(&wall, &next, reach);
                if size(&there) < off {
                    (*unknowns, found) = (next, there);
                    break;
                }
                share *= 0.5;
                if share < SHORTEST {
                    if off <= ROUNDED {
                        return Ok(found);
                    }
                    (*unknowns, found) = (next, there);
                    break;
                }
            }
        }
        if size(&found) <= ROUNDED {
            return Ok(found);
        }
        let (name, allowed) = ("rotation of a foot that warps", "one with an equilibrium");
        Err(BaseError::Parameter { name, value: rotation, allowed })
    }

    fn sums(&self, (stiffness, load): &(Matrix, [f64; WAVES]), unknowns: &[f64; UNKNOWNS], reach: f64) -> Sums {
        let mut sums = Sums::default();
        sums.force[0] = PI * self.weight;
        for (i, row) in stiffness.iter().enumerate() {
            sums.force[i + 1] -= 0.5 * PI * load[i];
            for (j, own) in row.iter().enumerate() {
                sums.force[i + 1] += 0.5 * PI * own * unknowns[j + 1];
                sums.slope[i + 1][j + 1] = 0.5 * PI * own;
            }
        }
        for Place { cos, width, forms } in self.places.iter() {
            let uplift = reach * cos + forms.iter().zip(unknowns).map(|(f, u)| f * u).sum::<f64>();
            let [force, slope] = (self.hold)(uplift, *cos).map(|f| f * width);
            sums.moment += force * cos;
            for i in 0..UNKNOWNS {
                sums.force[i] += force * forms[i];
                let own = slope * forms[i];
                for (to, form) in sums.slope[i][..=i].iter_mut().zip(forms) {
                    *to += own * form;
                }
            }
        }
        for i in 0..UNKNOWNS {
            for j in i + 1..UNKNOWNS {
                sums.slope[i][j] = sums.slope[j][i];
            }
        }
        sums
    }
}

/// The Newton step of all unknowns except the first `held`, by elimination without pivoting: the matrix is positive definite.
fn solve(sums: &Sums, held: usize) -> [f64; UNKNOWNS] {
    let (mut a, mut b) = (sums.slope, sums.force);
    b[..held].fill(0.0);
    for k in held..UNKNOWNS {
        for i in k + 1..UNKNOWNS {
            let factor = a[i][k] / a[k][k];
            for j in k..UNKNOWNS {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (held..UNKNOWNS).rev() {
        let known: f64 = (k + 1..UNKNOWNS).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

#[cfg(test)]
mod tests;
