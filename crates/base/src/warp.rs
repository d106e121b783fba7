//! Warping of the foot: what resists the waves of a foot that need not stay plane.
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
//!
//! Wall and liquid that oval have the mass
//!
//! ```text
//! m_n = (n²/R)² ρ Σ (2/H) (∫ z cos α z dz)² I_n(αR)/(α I_n′(αR)) + ∫ ρ_s t [(n⁴ + n²) z²/R² + 1] dz          α = (2 k + 1) π/(2 H)
//! ```
//!
//! of liquid whose surface keeps its pressure: the potential of w in incompressible liquid above a floor at rest.

use std::f64::consts::PI;

use tank::{Case, Shape};

use dry::Dry;

mod dry;

/// Waves of the foot that are free, from n = 2 on.
pub const WAVES: usize = 11;

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
/// Stiffness between waves n = 2, 3, … [N/m²].
pub(crate) type Matrix = [[f64; WAVES]; WAVES];

/// What a wall resists the waves of its foot with.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wall {
    /// Stiffness [N/m²].
    pub(crate) stiffness: Matrix,
    /// Load on the waves [N/m].
    pub(crate) load: [f64; WAVES],
}

/// Stiffness of the wall against waves of its foot.
#[derive(Clone, Debug, PartialEq)]
pub struct Warping {
    /// K of a wall that ovals, without pressure of the motion [N/m²].
    free: [f64; WAVES],
    /// Mass of a wall that ovals and of the liquid that ovals with it [kg/m].
    mass: [f64; WAVES],
    /// Loss between neighbouring waves per Pa of suction p_b at the lifted side [N/m² per Pa].
    sucked: Matrix,
    /// 1/K of the membrane below a round rim [m²/N].
    held: [f64; WAVES],
    top: Top,
    /// Moment of the impulsive pressure on the wall over its bottom pressure [m³].
    lever: f64,
    /// Radius and depth [m], and pressure at rest at the foot [Pa].
    fill: [f64; 3],
    /// Liquid that does not pull on the wall where its pressure falls below that of the air.
    dry: Option<Dry>,
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
        let (mut areal, mut leaning) = (0.0, 0.0);
        for course in &tank.courses {
            let (from, to) = (base, base + course.height);
            let (young, nu) = (course.material.youngs_modulus, course.material.poisson_ratio);
            let t = if net { course.net_thickness() } else { course.thickness };
            let cubes = |a: f64, b: f64| (b.powi(3) - a.powi(3)) / 3.0;
            bending += young * t.powi(3) / (12.0 * (1.0 - nu * nu)) * cubes(from, to);
            shearing += 2.0 * (1.0 + nu) * course.height / (young * t);
            axial += cubes(height - to, height - from) / (young * t);
            areal += course.material.density * t * course.height;
            leaning += course.material.density * t * cubes(from, to);
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
        let ovals = ovalling(radius, depth);
        let mass = |k: usize| {
            let n = n(k);
            let tall = n.powi(4) / (radius * radius);
            tall * case.liquid.density * ovals[k] + (tall + (n / radius).powi(2)) * leaning + areal
        };
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
            mass: std::array::from_fn(mass),
            sucked: std::array::from_fn(|i| std::array::from_fn(|j| sucked(i, j))),
            held: std::array::from_fn(held),
            top,
            lever: PI * radius * depth * first,
            fill: [radius, depth, case.liquid.density * gravity * depth],
            dry: None,
        })
    }

    /// The same wall with liquid that does not pull on it.
    pub(crate) fn without_pull(self) -> Warping {
        Warping { dry: Some(Dry::new(self.fill)), ..self }
    }

    /// The same wall in a motion that is too short for its rim to leave the circle.
    pub(crate) fn round(&self) -> Warping {
        Warping { top: Top::Round, ..self.clone() }
    }

    /// Mass of a wave of a wall that ovals [kg/m], from n = 2 on.
    pub(crate) fn mass(&self, wave: usize) -> f64 {
        self.mass[wave]
    }

    /// 1/K of the membrane below a round rim [m²/N].
    pub(crate) fn membrane(&self, wave: usize) -> f64 {
        self.held[wave]
    }

    /// K of a wall that ovals [N/m²], without pressure of the motion.
    pub(crate) fn ovalling(&self, wave: usize) -> f64 {
        self.free[wave]
    }

    /// Forces [N/m] of a wall that ovals by `waves` [m], under a bottom pressure that is lower by `suction` cos φ [Pa].
    pub(crate) fn forces(&self, waves: &[f64; WAVES], suction: f64) -> [f64; WAVES] {
        std::array::from_fn(|i| {
            let coupled: f64 = self.sucked[i].iter().zip(waves).map(|(own, u)| own * u).sum();
            self.free[i] * waves[i] - suction * coupled
        })
    }

    /// Bottom pressure of impulsive liquid whose pressure on the wall has this moment [N m] about the foot [Pa].
    pub(crate) fn suction_with(&self, moment: f64) -> f64 {
        moment / self.lever
    }

    /// Bottom pressure of the motion at which the wall loses its stiffness [Pa]; `None` under a round rim, whose membrane it leaves alone.
    pub(crate) fn softening(&self) -> Option<f64> {
        (self.top != Top::Round).then(|| self.softened())
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
        let still = self.under(0.0).stiffness;
        std::array::from_fn(|k| still[k][k])
    }

    /// The wall under a bottom pressure that is lower by `suction` cos φ [Pa].
    pub(crate) fn under(&self, suction: f64) -> Wall {
        let mut stiffness = [[0.0; WAVES]; WAVES];
        let mut load = [0.0; WAVES];
        if self.top == Top::Round {
            (0..WAVES).for_each(|k| stiffness[k][k] = 1.0 / self.held[k]);
            return Wall { stiffness, load };
        }
        for i in 0..WAVES {
            for j in 0..WAVES {
                stiffness[i][j] = if i == j { self.free[i] } else { -suction * self.sucked[i][j] };
            }
        }
        if let Some(dry) = &self.dry {
            let added;
            (load, added) = dry.at(suction);
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
        Wall { stiffness, load }
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

/// The same pressure at places ζ, 1 at the foot.
fn shape(ratio: f64, places: impl Iterator<Item = f64>) -> Vec<f64> {
    let terms: Vec<(f64, f64)> = terms(ratio).collect();
    let foot: f64 = terms.iter().map(|(_, share)| share).sum();
    places.map(|zeta| terms.iter().map(|(alpha, share)| share * (alpha * zeta).cos()).sum::<f64>() / foot).collect()
}

/// α H and (−1)^k/(α H)² I₁(α R)/I₁′(α R) of its terms.
fn terms(ratio: f64) -> impl Iterator<Item = (f64, f64)> {
    (0..TERMS).map(move |k| {
        let alpha = (2.0 * k as f64 + 1.0) * PI / 2.0;
        let sign = if k % 2 == 0 { 1.0 } else { -1.0 };
        (alpha, sign * bessel::<2>(alpha * ratio)[1] / (alpha * alpha))
    })
}

/// Σ (2/H) (∫ z cos α z dz)² I_n(αR)/(α I_n′(αR)) [m⁴], from n = 2 on.
fn ovalling(radius: f64, depth: f64) -> [f64; WAVES] {
    let mut sums = [0.0; WAVES];
    for k in 0..TERMS {
        let alpha = (2.0 * k as f64 + 1.0) * PI / (2.0 * depth);
        let sign = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
        let lever = sign * depth / alpha - 1.0 / (alpha * alpha);
        let ratios = bessel::<{ WAVES + 2 }>(alpha * radius);
        sums.iter_mut().zip(&ratios[2..]).for_each(|(sum, ratio)| *sum += 2.0 / depth * lever * lever * ratio / alpha);
    }
    sums
}

/// I_n(x)/I_n′(x) for n = 0, 1, …: I_n+1/I_n falls from order to order as a continued fraction (Abramowitz & Stegun 9.6.26); beyond x = 50 the first terms of
/// Debye's (9.7.7, 9.7.9).
fn bessel<const N: usize>(x: f64) -> [f64; N] {
    if x > 50.0 {
        return std::array::from_fn(|n| {
            let square = x * x + (n * n) as f64;
            1.0 / (square.sqrt() / x - 0.5 * x / square)
        });
    }
    let (mut ratios, mut ratio) = ([0.0; N], 0.0);
    // Each order beyond x takes a factor of 4 and more from the error of the first.
    for n in (0..N + 30 + x as usize).rev() {
        ratio = 1.0 / (2.0 * (n + 1) as f64 / x + ratio);
        if let Some(own) = ratios.get_mut(n) {
            *own = 1.0 / (ratio + n as f64 / x);
        }
    }
    ratios
}

#[cfg(test)]
mod tests;
