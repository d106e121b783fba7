//! Liquid of half a rectangular tank in plane, antisymmetric motion, condensed onto its wall in closed form.
//!
//! Liquid of width 2 L and depth H; the wall at x = L moves by u(z) along x, the one at x = −L by the same. The first part
//! of the flow has no pressure at the surface, the rest is a sum of sloshing modes with elevation q_n at the wall's side:
//!
//! ```text
//! M = ⎡ M_a + Sᵀ c S   Sᵀ c ⎤     K = ⎡ 0   0   ⎤     c_n = k/ω_n²     k = ρ g L/2
//!     ⎣ c S            c    ⎦         ⎣ 0   k 1 ⎦
//!
//! ω_n² = g k_n tanh k_n H     k_n = (2n−1) π/(2L)     S_n(u) = (2/L) sin(k_n L) ∫₀ᴴ u cosh(k_n z)/cosh(k_n H) dz
//! M_a: ρ Σ_j tanh(l_j L)/l_j (2/H) [∫₀ᴴ u cos(l_j z) dz]²     l_j = (2j−1) π/(2H)
//! ```
//!
//! so that q̈_n + ω_n² q_n = −S_n(ü), and the surface at the wall stands at Σ q_n sin(k_n L). The wall is any line of
//! cubic (Hermite) deflections; the liquid is a function of that deflection, without a mesh. Per metre of tank.
//!
//! Source: linear potential flow between rigid ends (Lamb 1932, §§ 239, 257), expanded as for walls that move.

mod places;

pub use places::Place;

use oscillator::STANDARD_GRAVITY;

use fem::linalg::Matrix;
use fem::shape::gauss;
use fem::shape::line::hermite;

/// Terms of the added mass: the series converges with j⁻³ and faster.
const TERMS: usize = 60;
/// Panels of five Gauss points an element of the wall: short against the shortest wave of the series.
const PANELS: usize = 8;

/// Unknowns of the wetted face.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Trace {
    /// Deflection and slope at each level, cubic between them: a wall of beams.
    Cubic,
    /// Deflection at each level, linear between them: a separate face.
    Linear,
}

impl Trace {
    /// Unknowns a level.
    pub fn unknowns(self) -> usize {
        match self {
            Trace::Cubic => 2,
            Trace::Linear => 1,
        }
    }

    /// Shape functions of an element of this length at s from 0 to 1, over the unknowns of its two levels.
    fn shape(self, s: f64, length: f64) -> Vec<f64> {
        match self {
            Trace::Cubic => hermite(2.0 * s - 1.0, length)[0].to_vec(),
            Trace::Linear => vec![1.0 - s, s],
        }
    }
}

/// Liquid between two walls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StripLiquid {
    /// Half the width between the walls, L [m].
    pub half_width: f64,
    /// Depth H [m].
    pub depth: f64,
    /// Density ρ [kg/m³].
    pub density: f64,
    /// Gravity g [m/s²].
    pub gravity: f64,
}

/// The condensed liquid on a wall: the unknowns of each level upwards, then q_n.
#[derive(Clone, Debug, PartialEq)]
pub struct WallLiquid {
    /// M [kg/m, …].
    pub mass: Matrix,
    /// K [N/m², …].
    pub stiffness: Matrix,
    /// c_n [kg/m].
    pub modal_masses: Vec<f64>,
    /// ω_n [rad/s].
    pub omega: Vec<f64>,
    /// Elevation of the surface at the wall as a row over q_n.
    pub elevation: Vec<f64>,
    /// ∫₀ᴴ N dz over the unknowns of the face: area that it gives way.
    pub area: Vec<f64>,
    /// Nodal forces of the hydrostatic pressure ρ g (H − z) [N/m, N].
    pub hydrostatic: Vec<f64>,
}

/// Integrals over the deflection: rows over the unknowns of the face.
struct Parts {
    /// S_n.
    sloshing_rows: Vec<Vec<f64>>,
    /// ∫₀ᴴ u cos(l_j z) dz.
    mass_rows: Vec<Vec<f64>>,
    area: Vec<f64>,
    hydrostatic: Vec<f64>,
}

impl StripLiquid {
    /// Liquid under standard gravity.
    pub fn new(half_width: f64, depth: f64, density: f64) -> StripLiquid {
        StripLiquid { half_width, depth, density, gravity: STANDARD_GRAVITY }
    }

    /// k_n of antisymmetric sloshing mode `n`, from 0 [1/m].
    pub fn wave_number(&self, n: usize) -> f64 {
        (2 * n + 1) as f64 * std::f64::consts::FRAC_PI_2 / self.half_width
    }

    /// ω_n in a rigid tank [rad/s].
    pub fn sloshing_frequency(&self, n: usize) -> f64 {
        let k = self.wave_number(n);
        (self.gravity * k * (k * self.depth).tanh()).sqrt()
    }

    /// Stiffness of every sloshing mode, k = ρ g L/2 [N/m²].
    pub fn spring(&self) -> f64 {
        0.5 * self.density * self.gravity * self.half_width
    }

    /// c_n = k/ω_n² [kg/m].
    pub fn modal_mass(&self, n: usize) -> f64 {
        self.spring() / self.sloshing_frequency(n).powi(2)
    }

    /// l_j of term `j`, from 0 [1/m].
    fn depth_wave(&self, j: usize) -> f64 {
        (2 * j + 1) as f64 * std::f64::consts::FRAC_PI_2 / self.depth
    }

    /// Integrand of S_n at the height `z`.
    fn sloshing_shape(&self, n: usize, z: f64) -> f64 {
        let (k, l) = (self.wave_number(n), self.half_width);
        2.0 / l * (k * l).sin() * (k * z).cosh() / (k * self.depth).cosh()
    }

    /// Factor of [∫ u cos(l_j z) dz]² in M_a.
    fn added_mass(&self, j: usize) -> f64 {
        let l = self.depth_wave(j);
        self.density * (l * self.half_width).tanh() / l * 2.0 / self.depth
    }

    /// Liquid on a wall whose nodes stand at `levels` [m], ascending from the bottom; it may rise above the surface.
    /// `sloshing`: number of sloshing modes.
    pub fn on_wall(&self, levels: &[f64], sloshing: usize) -> WallLiquid {
        self.on(Trace::Cubic, levels, sloshing)
    }

    /// Liquid on a face with the unknowns of `trace` at `levels` [m]; else as [`StripLiquid::on_wall`].
    pub fn on(&self, trace: Trace, levels: &[f64], sloshing: usize) -> WallLiquid {
        let wall = trace.unknowns() * levels.len();
        let all = wall + sloshing;
        let Parts { sloshing_rows, mass_rows, area, hydrostatic } = self.parts(trace, levels, sloshing);
        let (mut mass, mut stiffness) = (Matrix::zeros(all, all), Matrix::zeros(all, all));
        for (j, row) in mass_rows.iter().enumerate() {
            rank_one(&mut mass, self.added_mass(j), row);
        }
        for (n, row) in sloshing_rows.iter().enumerate() {
            let c = self.modal_mass(n);
            rank_one(&mut mass, c, row);
            for (i, s) in row.iter().enumerate() {
                mass.add(i, wall + n, c * s);
                mass.add(wall + n, i, c * s);
            }
            mass.add(wall + n, wall + n, c);
            stiffness.add(wall + n, wall + n, self.spring());
        }
        WallLiquid {
            mass,
            stiffness,
            modal_masses: (0..sloshing).map(|n| self.modal_mass(n)).collect(),
            omega: (0..sloshing).map(|n| self.sloshing_frequency(n)).collect(),
            elevation: (0..sloshing).map(|n| (self.wave_number(n) * self.half_width).sin()).collect(),
            area,
            hydrostatic,
        }
    }

    /// Integrals over the deflection.
    fn parts(&self, trace: Trace, levels: &[f64], sloshing: usize) -> Parts {
        let each = trace.unknowns();
        let wall = each * levels.len();
        let mut sloshing_rows = vec![vec![0.0; wall]; sloshing];
        let mut mass_rows = vec![vec![0.0; wall]; TERMS];
        let (mut area, mut hydrostatic) = (vec![0.0; wall], vec![0.0; wall]);
        for (e, ends) in levels.windows(2).enumerate() {
            let (length, wet) = (ends[1] - ends[0], ends[1].min(self.depth) - ends[0]);
            if wet <= 0.0 {
                break;
            }
            for p in 0..PANELS {
                for &(x, weight) in gauss::FIVE {
                    let s = wet / length * (p as f64 + 0.5 * (x + 1.0)) / PANELS as f64;
                    let (z, dz) = (ends[0] + s * length, 0.5 * weight * wet / PANELS as f64);
                    let shape = trace.shape(s, length);
                    let add = |row: &mut [f64], f: f64| {
                        let own = &mut row[each * e..each * (e + 2)];
                        own.iter_mut().zip(&shape).for_each(|(r, n)| *r += dz * f * n);
                    };
                    for (n, row) in sloshing_rows.iter_mut().enumerate() {
                        add(row, self.sloshing_shape(n, z));
                    }
                    for (j, row) in mass_rows.iter_mut().enumerate() {
                        add(row, (self.depth_wave(j) * z).cos());
                    }
                    add(&mut area, 1.0);
                    add(&mut hydrostatic, self.density * self.gravity * (self.depth - z));
                }
            }
        }
        Parts { sloshing_rows, mass_rows, area, hydrostatic }
    }

    /// Mass that a unit translation of tank and wall sets in motion, ιᵀ (M_a + Sᵀ c S) ι [kg/m]; the liquid's own, ρ L H,
    /// with all modes.
    pub fn translated_mass(&self, sloshing: usize) -> f64 {
        let mut sum = 0.0;
        for j in 0..400 {
            let l = self.depth_wave(j);
            let own = (l * self.depth).sin() / l;
            sum += self.added_mass(j) * own * own;
        }
        for n in 0..sloshing {
            let k = self.wave_number(n);
            // ∫ cosh(k z)/cosh(k H) dz = tanh(k H)/k.
            let s = 2.0 / self.half_width * (k * self.half_width).sin() * (k * self.depth).tanh() / k;
            sum += self.modal_mass(n) * s * s;
        }
        sum
    }

    /// Part of it that moves with the wall when the surface carries no pressure and cannot push back, ιᵀ M_a ι [kg/m].
    pub fn impulsive_mass(&self) -> f64 {
        self.translated_mass(0)
    }
}

/// A ← A + factor v vᵀ in the first rows and columns.
fn rank_one(a: &mut Matrix, factor: f64, v: &[f64]) {
    for (j, y) in v.iter().enumerate().filter(|(_, y)| **y != 0.0) {
        for (i, x) in v.iter().enumerate() {
            a.add(i, j, factor * x * y);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn liquid() -> StripLiquid {
        StripLiquid::new(2.5, 2.57, 1000.0)
    }

    /// A rigid wall: M_a, S and the weight have closed forms, wherever the nodes stand and although the wall rises above
    /// the surface in the middle of an element.
    #[test]
    fn rigid_wall() {
        let on_wall = liquid().on_wall(&[0.0, 0.4, 1.1, 1.9, 2.4, 3.0], 6);
        let translation: Vec<f64> = (0..18).map(|i| f64::from(i < 12 && i % 2 == 0)).collect();
        let mass: f64 = on_wall.mass.times(&translation).iter().zip(&translation).map(|(a, b)| a * b).sum();
        // The series of M_a in the matrix has 60 terms, that of the mass 400: the rest is Σ 16 ρ H²/(2j−1)³ π³.
        assert!((mass / liquid().translated_mass(6) - 1.0).abs() < 2e-5, "{mass}");
        let g = STANDARD_GRAVITY;
        let force: f64 = on_wall.hydrostatic.iter().step_by(2).sum();
        assert!((force / (0.5 * 1000.0 * g * 2.57 * 2.57) - 1.0).abs() < 1e-12);
        let area: f64 = on_wall.area.iter().step_by(2).sum();
        assert!((area - 2.57).abs() < 1e-12);
        // Moment about the bottom: force times height, plus the moments.
        let levels = [0.0, 0.4, 1.1, 1.9, 2.4, 3.0];
        let moment: f64 = (0..6).map(|i| on_wall.hydrostatic[2 * i] * levels[i] + on_wall.hydrostatic[2 * i + 1]).sum();
        assert!((moment / (1000.0 * g * 2.57_f64.powi(3) / 6.0) - 1.0).abs() < 1e-12);
    }

    /// A slow acceleration a tilts the surface: the elevation at the wall tends to −a L/g (the sign of S).
    #[test]
    fn slow_acceleration_tilts_the_surface() {
        let on_wall = liquid().on_wall(&[0.0, 1.0, 2.0, 2.57], 200);
        let translation: Vec<f64> = (0..208).map(|i| f64::from(i < 8 && i % 2 == 0)).collect();
        let force = on_wall.mass.times(&translation);
        // k q = −c S ι a.
        let elevation: f64 = (0..200).map(|n| -force[8 + n] / liquid().spring() * on_wall.elevation[n]).sum();
        // Σ 8/((2n−1) π)² up to n = 200 lacks 4/(π² 400) = 1e-3.
        let exact = -liquid().half_width / STANDARD_GRAVITY;
        assert!((elevation / exact - 1.0).abs() < 2e-3, "{elevation} {exact}");
    }

    /// Sloshing 2.3863 and 4.2999 rad/s, impulsive mass 3.342 t per wall (theory of the strip 8.4).
    #[test]
    fn strip_of_the_dissertation() {
        let liquid = StripLiquid { gravity: 9.81, ..StripLiquid::new(2.5, 2.57, 1e4 / 9.81) };
        assert!((liquid.sloshing_frequency(0) - 2.3863).abs() < 5e-4, "{}", liquid.sloshing_frequency(0));
        assert!((liquid.sloshing_frequency(1) - 4.2999).abs() < 5e-4, "{}", liquid.sloshing_frequency(1));
        assert!((liquid.impulsive_mass() - 3342.0).abs() < 0.5 * 10.0, "{}", liquid.impulsive_mass());
        // All modes: the liquid's own mass; the series lacks 2 ρ/L Σ k_n⁻³ beyond n modes.
        let own = liquid.density * liquid.half_width * liquid.depth;
        assert!((liquid.translated_mass(1000) / own - 1.0).abs() < 1e-6);
        let rest: f64 = (12..1000).map(|n| 2.0 * liquid.density / 2.5 / liquid.wave_number(n).powi(3)).sum();
        assert!((liquid.translated_mass(12) + rest - own).abs() < 0.01);
    }
}
