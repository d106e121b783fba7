//! Liquid that does not pull on the wall.
//!
//! ```text
//! Δp(φ, z) = ⟨p_b p(z) cos φ − ρ g (H − z)⟩ = Σ D_m(z) cos mφ
//! π q_n = −n²/R ∫∫ Δp z cos nφ dz dφ
//! ```
//!
//! Next to the surface the pressure of the motion exceeds that at rest from p_b/p = 0.17 on in a broad tank (0.10 in a slender one). Where liquid only
//! presses, Δp is added to the linear pressure on the lifted side. It presses the wall outwards there, and a wall that ovals (w = −n² U z/R cos nφ)
//! presses the middle of the lifted side down. Δp also changes the stiffness: with N_θ = R Δp and the N_zθ and N_z in equilibrium with it, the work of
//! second order of [`super`] gives for each m = |n − k| or n + k
//!
//! ```text
//! π R K_nk = (n′k′ A/R² + n k B) I_css − m² A/(2 R²) (n k I_css + n²k² I_ccc) + m A/(2 R²) (n′k² I_ssc + k′n² I_scs)
//!            + ½ (n′k + k′n) A/R² I_css − ½ (n² + k²) B I_ccc          A = ∫ D_m z² dz ,  B = ∫ D_m dz
//! ```
//!
//! with I_css = ∫ cos mφ sin nφ sin kφ dφ and so on. m = 1 is the matrix of [`super`].

use std::f64::consts::PI;

use super::{Matrix, WAVES, shape};

/// Places over the depth and over half of the circumference, midpoints.
const LEVELS: usize = 100;
const PLACES: usize = 90;
/// Waves of Δp that couple waves of the foot.
const HARMONICS: usize = 2 * (WAVES + 1) + 1;

/// A wall from which the liquid parts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dry {
    radius: f64,
    depth: f64,
    /// Pressure at the foot at rest [Pa].
    pressure: f64,
    /// p(z) at the levels, 1 at the foot.
    shape: Vec<f64>,
}

impl Dry {
    /// * R and H [m], and ρ g H [Pa]
    pub(super) fn new([radius, depth, pressure]: [f64; 3]) -> Dry {
        Dry { radius, depth, pressure, shape: shape(radius / depth, (0..LEVELS).map(level)) }
    }

    /// Load q_n on the waves [N/m] and what Δp adds to their stiffness [N/m²], of a wall that ovals under a suction p_b [Pa].
    pub(super) fn at(&self, suction: f64) -> ([f64; WAVES], Matrix) {
        let (mut lever, mut level_sums, mut squares) = ([0.0; HARMONICS], [0.0; HARMONICS], [0.0; HARMONICS]);
        let width = PI / PLACES as f64;
        for (i, shape) in self.shape.iter().enumerate() {
            let (zeta, dz) = (level(i), self.depth / LEVELS as f64);
            let rest = self.pressure * (1.0 - zeta);
            for j in 0..PLACES {
                let phi = (j as f64 + 0.5) * width;
                let missing = suction * shape * phi.cos() - rest;
                if missing <= 0.0 {
                    continue;
                }
                for m in 0..HARMONICS {
                    let share = if m == 0 { 1.0 } else { 2.0 };
                    let part = share / PI * missing * (m as f64 * phi).cos() * width * dz;
                    lever[m] += part * zeta * self.depth;
                    level_sums[m] += part;
                    squares[m] += part * (zeta * self.depth).powi(2);
                }
            }
        }
        let n = |k: usize| (k + 2) as f64;
        let load = std::array::from_fn(|k| -n(k) * n(k) / self.radius * lever[k + 2]);
        let added = |i: usize, j: usize| {
            let of = |m: usize| coupled(i + 2, j + 2, m, self.radius, [level_sums[m], squares[m]]);
            let (apart, sum) = (i.abs_diff(j), i + j + 4);
            of(apart) + of(sum)
        };
        (load, std::array::from_fn(|i| std::array::from_fn(|j| added(i, j))))
    }
}

/// ζ = z/H of a level.
fn level(i: usize) -> f64 {
    (i as f64 + 0.5) / LEVELS as f64
}

/// What a wave m of the pressure adds to the stiffness between the waves n and k of the foot [N/m²].
///
/// * `sums`: ∫ D_m dz [N/m] and ∫ D_m z² dz [N m]
pub(super) fn coupled(n: usize, k: usize, m: usize, radius: f64, [sum, square]: [f64; 2]) -> f64 {
    let is = |a: bool| f64::from(u8::from(a));
    // Over π.
    let (apart, total) = (is(m == n.abs_diff(k)), is(m == n + k));
    let half = if m == 0 { 1.0 } else { 0.5 };
    let (css, ccc) = (half * (apart - total), half * (apart + total));
    let mixed = |n: usize, k: usize| if m == 0 { 0.0 } else { 0.5 * (is(m.abs_diff(n) == k) - is(m + n == k)) };
    let (ssc, scs) = (mixed(n, k), mixed(k, n));
    let square = square / (radius * radius);
    let cubic = |n: f64| n * (n * n - 1.0);
    let (n, k, m) = (n as f64, k as f64, m as f64);
    let hoop = (cubic(n) * cubic(k) * square + n * k * sum) * css;
    let axial = -0.5 * m * m * square * (n * k * css + n * n * k * k * ccc);
    let shear = 0.5 * m * square * (cubic(n) * k * k * ssc + cubic(k) * n * n * scs);
    let turning = 0.5 * (cubic(n) * k + cubic(k) * n) * square * css - 0.5 * (n * n + k * k) * sum * ccc;
    (hoop + axial + shear + turning) / radius
}
