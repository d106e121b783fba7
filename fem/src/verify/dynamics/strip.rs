//! Strip 8.4 of the dissertation, linear: a cantilever wall with the liquid condensed onto it in closed form.
//!
//! Half of a tank of width 2 L with liquid to the height H, antisymmetric motion; wall at x = L as a beam of plane strain
//! with Hermite elements; unknowns are its free deflections and rotations and the amplitudes q_n of N sloshing modes:
//!
//! ```text
//! M = ⎡ M_s + M_a + Sᵀ c S   Sᵀ c ⎤     K = ⎡ K_s   0   ⎤     c_n = k/ω_n²     k = ρ g L/2
//!     ⎣ c S                  c    ⎦         ⎣ 0    k 1 ⎦
//!
//! ω_n² = g k_n tanh k_n H     k_n = (2n−1) π/(2L)     S_n(u) = (2/L) sin(k_n L) ∫₀ᴴ u cosh(k_n z)/cosh(k_n H) dz
//! M_a: ρ Σ_j tanh(l_j L)/l_j (2/H) [∫₀ᴴ u cos(l_j z) dz]²     l_j = (2j−1) π/(2H)
//! ```
//!
//! M_a is the added mass with p = 0 at the surface, q_n the elevation of sloshing mode n relative to what the wall pushes
//! up: q̈_n + ω_n² q_n = −S_n(ü). The liquid is one function of the wall's deflection, without a mesh.

use std::sync::Arc;

use codes::STANDARD_GRAVITY;

use crate::analysis::AnalysisError;
use crate::analysis::damping::{Damping, Rayleigh};
use crate::analysis::failed;
use crate::analysis::frequency::{Reduced, Window};
use crate::analysis::modal::ModalBasis;
use crate::analysis::motion::{Grid, Motion};
use crate::analysis::observable::Observable;
use crate::analysis::scheme::TimeScheme;
use crate::analysis::statics::Statics;
use crate::analysis::system::System;
use crate::analysis::transient::{Load, Settings, Transient, integrate};
use crate::linalg::{Eigen, Kind, Matrix, Ordering, Pattern, Symbolic, Symmetric, dot, generalized_eigen};
use crate::progress::Silent;
use crate::verify::{Reference, Row};

/// The strip with its matrices and modes.
#[derive(Clone, Debug)]
pub struct Strip {
    /// Matrices; the unknowns are deflection and rotation of the wall's free nodes upwards, then q_n.
    pub system: System,
    /// All modes.
    pub modes: Eigen,
    /// Moment at the base of the wall [Nm/m], deflection of its top [m], elevation of the surface at the wall [m].
    pub observables: Vec<Observable>,
    /// Sloshing modes in the model.
    pub sloshing: usize,
    symbolic: Arc<Symbolic>,
}

const HALF_WIDTH: f64 = 2.5;
const DEPTH: f64 = 2.57;
const HEIGHT: f64 = 3.0;
const THICKNESS: f64 = 0.3;
const YOUNG: f64 = 34e9;
const POISSON: f64 = 0.2;
const WALL_DENSITY: f64 = 2950.0;
const LIQUID_DENSITY: f64 = 1019.4;
/// Terms of the added mass: the series converges with j⁻³ and faster.
const TERMS: usize = 60;

/// Gauss points and weights on −1 … 1.
const GAUSS: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// Hermite's cubics at s in 0 … 1 on an element of length l.
fn hermite(s: f64, l: f64) -> [f64; 4] {
    let (s2, s3) = (s * s, s * s * s);
    [
        1.0 - 3.0 * s2 + 2.0 * s3,
        l * (s - 2.0 * s2 + s3),
        3.0 * s2 - 2.0 * s3,
        l * (s3 - s2),
    ]
}

impl Strip {
    /// `wet` elements up to the surface and `dry` above it, `sloshing` sloshing modes.
    ///
    /// Errors: none but those of the eigenvalue solver.
    pub fn new(wet: usize, dry: usize, sloshing: usize) -> Result<Strip, AnalysisError> {
        let mut z: Vec<f64> = (0..=wet).map(|i| DEPTH * i as f64 / wet as f64).collect();
        z.extend((1..=dry).map(|i| DEPTH + (HEIGHT - DEPTH) * i as f64 / dry as f64));
        let wall = 2 * z.len();
        let all = wall + sloshing;
        let (mut m, mut k) = (Matrix::zeros(all, all), Matrix::zeros(all, all));
        let bending = YOUNG / (1.0 - POISSON * POISSON) * THICKNESS.powi(3) / 12.0;
        // ∫ N(z) f(z) dz over the wet height, for the functions f of the liquid.
        let wave = |n: usize| (2 * n + 1) as f64 * std::f64::consts::FRAC_PI_2 / HALF_WIDTH;
        let depth_wave = |j: usize| (2 * j + 1) as f64 * std::f64::consts::FRAC_PI_2 / DEPTH;
        let mut sloshing_rows = vec![vec![0.0; wall]; sloshing];
        let mut mass_rows = vec![vec![0.0; wall]; TERMS];
        for e in 0..z.len() - 1 {
            let l = z[e + 1] - z[e];
            let first = 2 * e;
            for (i, row) in beam_stiffness(l).iter().enumerate() {
                for (j, v) in row.iter().enumerate() {
                    k.add(first + i, first + j, bending * v);
                }
            }
            // Panels short against the shortest wave of the liquid.
            let panels = 8;
            for p in 0..panels {
                for (x, weight) in GAUSS {
                    let s = (p as f64 + 0.5 * (x + 1.0)) / panels as f64;
                    let (at, w) = (z[e] + s * l, 0.5 * weight * l / panels as f64);
                    let shape = hermite(s, l);
                    for i in 0..4 {
                        for j in 0..4 {
                            m.add(first + i, first + j, WALL_DENSITY * THICKNESS * w * shape[i] * shape[j]);
                        }
                    }
                    if e >= wet {
                        continue;
                    }
                    for (n, row) in sloshing_rows.iter_mut().enumerate() {
                        let kn = wave(n);
                        let f = 2.0 / HALF_WIDTH * (kn * HALF_WIDTH).sin() * (kn * at).cosh() / (kn * DEPTH).cosh();
                        (0..4).for_each(|i| row[first + i] += w * f * shape[i]);
                    }
                    for (j, row) in mass_rows.iter_mut().enumerate() {
                        let f = (depth_wave(j) * at).cos();
                        (0..4).for_each(|i| row[first + i] += w * f * shape[i]);
                    }
                }
            }
        }
        for (j, row) in mass_rows.iter().enumerate() {
            let lj = depth_wave(j);
            let factor = LIQUID_DENSITY * (lj * HALF_WIDTH).tanh() / lj * 2.0 / DEPTH;
            rank_one(&mut m, factor, row);
        }
        let spring = LIQUID_DENSITY * STANDARD_GRAVITY * HALF_WIDTH / 2.0;
        for (n, row) in sloshing_rows.iter().enumerate() {
            let c = spring / (STANDARD_GRAVITY * wave(n) * (wave(n) * DEPTH).tanh());
            rank_one(&mut m, c, row);
            for (i, s) in row.iter().enumerate() {
                m.add(i, wall + n, c * s);
                m.add(wall + n, i, c * s);
            }
            m.add(wall + n, wall + n, c);
            k.add(wall + n, wall + n, spring);
        }
        // A unit translation moves the clamped base as well.
        let translation: Vec<f64> = (0..all).map(|i| f64::from(i < wall && i % 2 == 0)).collect();
        let inertia = m.times(&translation);
        let base_moment = k.column(1).to_vec();
        let free: Vec<usize> = (2..all).collect();
        let pattern = Arc::new(Pattern::from_cliques(
            free.len(),
            std::iter::once((0..free.len()).collect::<Vec<_>>())
                .collect::<Vec<_>>()
                .iter()
                .map(Vec::as_slice),
        ));
        let pick = |a: &Matrix| Symmetric {
            values: (0..free.len())
                .flat_map(|j| (j..free.len()).map(move |i| (i, j)))
                .map(|(i, j)| a.get(i + 2, j + 2))
                .collect(),
            pattern: pattern.clone(),
        };
        let cut = |v: &[f64]| v[2..].to_vec();
        let zero = vec![0.0; free.len()];
        let mut system = System::from_matrices(pick(&m), pick(&k), [cut(&translation), zero.clone(), zero]);
        system.inertia[0] = cut(&inertia);
        let (md, kd) = (system.mass.to_dense(), system.stiffness.to_dense());
        let modes = generalized_eigen(&kd, &md, None).map_err(failed("modes of the strip"))?;
        let sparse = |v: Vec<f64>| v.into_iter().enumerate().filter(|(_, c)| *c != 0.0).collect();
        let observable = |name: &str, displacement| Observable {
            name: name.to_owned(),
            displacement,
            ..Observable::default()
        };
        let observables = vec![
            observable("moment at the base of the wall", sparse(cut(&base_moment))),
            observable("deflection of the top of the wall", vec![(wall - 4, 1.0)]),
            observable(
                "elevation of the surface at the wall",
                (0..sloshing)
                    .map(|n| (wall - 2 + n, (wave(n) * HALF_WIDTH).sin()))
                    .collect(),
            ),
        ];
        let symbolic = Symbolic::new(pattern, &Ordering::MinimumDegree).map_err(failed("the strip"))?;
        Ok(Strip {
            system,
            modes,
            observables,
            sloshing,
            symbolic: Arc::new(symbolic),
        })
    }

    /// Mass that a unit translation of wall and ground sets in motion, without the wall: ιᵀ (M_a + Sᵀ c S) ι [kg/m].
    pub fn liquid_mass(sloshing: usize) -> f64 {
        let integral = |f: &dyn Fn(f64) -> f64| -> f64 {
            let panels = 200;
            (0..panels)
                .flat_map(|p| GAUSS.map(|(x, w)| (p, x, w)))
                .map(|(p, x, w)| {
                    let at = DEPTH * (p as f64 + 0.5 * (x + 1.0)) / panels as f64;
                    0.5 * w * DEPTH / panels as f64 * f(at)
                })
                .sum()
        };
        let mut sum = 0.0;
        for j in 0..400 {
            let l = (2 * j + 1) as f64 * std::f64::consts::FRAC_PI_2 / DEPTH;
            let own = (l * DEPTH).sin() / l;
            sum += LIQUID_DENSITY * (l * HALF_WIDTH).tanh() / l * 2.0 / DEPTH * own * own;
        }
        for n in 0..sloshing {
            let k = (2 * n + 1) as f64 * std::f64::consts::FRAC_PI_2 / HALF_WIDTH;
            let c = LIQUID_DENSITY * HALF_WIDTH / (2.0 * k * (k * DEPTH).tanh());
            let s = 2.0 / HALF_WIDTH * (k * HALF_WIDTH).sin() * integral(&|z| (k * z).cosh() / (k * DEPTH).cosh());
            sum += c * s * s;
        }
        sum
    }

    /// Ratios: sloshing modes 0.5 %, wall modes 2 %.
    pub fn ratios(&self) -> Vec<f64> {
        (0..self.modes.omega.len())
            .map(|j| if self.is_sloshing(j) { 0.005 } else { 0.02 })
            .collect()
    }

    /// Whether more than half of a mode's potential energy is in the surface.
    pub fn is_sloshing(&self, mode: usize) -> bool {
        let phi = self.modes.vectors.column(mode);
        let first = phi.len() - self.sloshing;
        let mut surface = phi.to_vec();
        surface[..first].fill(0.0);
        let image = self.system.stiffness.times(&surface);
        dot(&surface, &image) > 0.5 * self.modes.omega[mode].powi(2)
    }

    /// The modes `keep`, with missing mass or without.
    ///
    /// Errors: those of the static solution.
    pub fn basis(&self, keep: &[usize], missing_mass: bool) -> Result<ModalBasis, AnalysisError> {
        let all: Vec<usize> = (0..self.system.size()).collect();
        let vectors = self.modes.vectors.select(&all, keep);
        let omega: Vec<f64> = keep.iter().map(|&j| self.modes.omega[j]).collect();
        let statics = Statics::new(&self.symbolic, &self.system.stiffness, Kind::Definite)?;
        let still = statics.solve(&self.system.stiffness, &[&self.system.inertia[0]])?;
        let given = missing_mass.then_some(still[0].as_slice());
        ModalBasis::new(&self.system, &omega, &vectors, [given, None, None])
    }

    /// Peaks of the observables by modal superposition.
    fn superposed(
        &self,
        keep: &[usize],
        missing_mass: bool,
        load: &Load,
        grid: Grid,
    ) -> Result<Vec<f64>, AnalysisError> {
        let ratios: Vec<f64> = keep.iter().map(|&j| self.ratios()[j]).collect();
        let basis = self.basis(keep, missing_mass)?;
        let (observed, _) = basis.respond(&ratios, load, grid, &[], &self.observables, &Silent)?;
        Ok(observed.extremes.iter().map(|e| e.peak().0).collect())
    }

    /// Direct integration with modal damping of all modes.
    fn direct(&self, scheme: TimeScheme, load: &Load, grid: Grid) -> Result<Transient, AnalysisError> {
        let damping = Damping::modal(&self.system.mass, &self.modes, &self.ratios(), Rayleigh::NONE)?;
        let system = self.system.clone().with_damping(damping);
        let mut settings = Settings::new(grid);
        settings.scheme = scheme;
        let load = std::slice::from_ref(load);
        let mut found = integrate(
            &system,
            &self.symbolic,
            load,
            &settings,
            &self.observables,
            &[],
            &Silent,
        )?;
        Ok(found.remove(0))
    }
}

/// Stiffness of a beam element with unit bending stiffness.
fn beam_stiffness(l: f64) -> [[f64; 4]; 4] {
    let (a, b, c, d) = (12.0 / l.powi(3), 6.0 / l.powi(2), 4.0 / l, 2.0 / l);
    [[a, b, -a, b], [b, c, -b, d], [-a, -b, a, -b], [b, d, -b, c]]
}

/// A ← A + factor v vᵀ in the first rows and columns.
fn rank_one(a: &mut Matrix, factor: f64, v: &[f64]) {
    for (j, y) in v.iter().enumerate() {
        for (i, x) in v.iter().enumerate() {
            a.add(i, j, factor * x * y);
        }
    }
}

/// Broad-band ground motion without a name: 60 sines from 0.2 to 20 Hz with phases of the golden ratio under a hump, 0.1 g
/// at most.
fn ground_motion(dt: f64, duration: f64) -> Vec<f64> {
    let count = (duration / dt).round() as usize + 1;
    let raw: Vec<f64> = (0..count)
        .map(|i| {
            let t = i as f64 * dt;
            let hump = (std::f64::consts::PI * t / duration).sin().powi(2);
            let sum: f64 = (0..60)
                .map(|k| {
                    let f = 0.2 * 100_f64.powf(f64::from(k) / 59.0);
                    (std::f64::consts::TAU * (f * t + 0.618_033_988_749_895 * f64::from(k * k))).sin()
                })
                .sum();
            hump * sum
        })
        .collect();
    let peak = raw.iter().fold(0.0, |m: f64, a| m.max(a.abs()));
    raw.iter().map(|a| 0.1 * STANDARD_GRAVITY * a / peak).collect()
}

/// Rows D7, D8, D9, D10 and the comparison of four methods.
///
/// Errors: those of the analyses.
pub fn strip() -> Result<Vec<Row>, AnalysisError> {
    let row = |id: &str, page, what: String, reference, source, kind, computed, tolerance, unit| Row {
        id: id.to_owned(),
        page,
        what,
        reference,
        source,
        kind,
        computed,
        tolerance,
        unit,
        convergence: Vec::new(),
    };
    let model = Strip::new(14, 3, 12)?;
    let mut rows = Vec::new();
    // Twelve sloshing modes leave out 0.05 % of the mass; the series converges with 1/n².
    rows.push(row(
        "D10",
        "Condensed liquid",
        "strip 8.4: liquid mass moved by a translation, 12 sloshing modes".into(),
        LIQUID_DENSITY * HALF_WIDTH * DEPTH,
        "ρ L H",
        Reference::ClosedForm,
        Strip::liquid_mass(12),
        1e-3,
        "kg/m",
    ));

    let (dt, duration) = (0.02, 16.0);
    let ground = ground_motion(dt, duration);
    let grid = Grid::new(dt, duration, 4.0, dt / 8.0);
    let load = Load::ground(0, Motion::sampled(dt, &ground, &grid));
    let all: Vec<usize> = (0..model.modes.omega.len()).collect();
    let (sloshing, wall): (Vec<usize>, Vec<usize>) = all.iter().partition(|&&j| model.is_sloshing(j));
    let exact = model.superposed(&all, false, &load, grid)?;
    let with = |structural: usize, missing| -> Result<f64, AnalysisError> {
        let mut keep = sloshing.clone();
        keep.extend(&wall[..structural]);
        keep.sort_unstable();
        Ok((model.superposed(&keep, missing, &load, grid)?[0] / exact[0] - 1.0).abs())
    };
    // The sheet's figures (72 %, 0.60 %, 0.02 % with missing mass) belong to its own record; what holds for any broad-band
    // record is the order of magnitude.
    for (structural, allowed) in [(1, 0.02), (2, 2e-3), (3, 1e-3)] {
        rows.push(row(
            "D7",
            "Missing mass",
            format!("strip 8.4: error of the base moment, {structural} wall modes with missing mass"),
            0.0,
            "all modes; theory: 0.6 % with one wall mode, 0.02 % with two, for another record",
            Reference::SecondFormulation,
            with(structural, true)?,
            allowed,
            "",
        ));
    }
    let without_wall_mode = with(0, true)?;
    rows.push(row(
        "D7",
        "Missing mass",
        format!(
            "strip 8.4: missing mass is no substitute for the first wall mode (base moment {:.0} % in error): 1 if above 20 %",
            100.0 * without_wall_mode
        ),
        1.0,
        "all modes",
        Reference::SecondFormulation,
        f64::from(without_wall_mode > 0.2),
        0.0,
        "",
    ));

    let fine = Grid::new(dt, duration, 4.0, dt / 32.0);
    let fine_load = Load::ground(0, Motion::sampled(dt, &ground, &fine));
    let trapezoidal = model.direct(TimeScheme::Trapezoidal, &fine_load, fine)?;
    rows.push(row(
        "D9",
        "Energy balance",
        "strip 8.4: residual of the energy balance, trapezoidal rule".into(),
        0.0,
        "closes to rounding whatever the step",
        Reference::ClosedForm,
        trapezoidal.energy.error(),
        1e-10,
        "of the work done",
    ));
    let alpha = model.direct(TimeScheme::GeneralizedAlpha { radius: 0.9 }, &fine_load, fine)?;
    let basis = model.basis(&all, false)?;
    let none = vec![0.0; all.len()];
    let reduced = Reduced::modal(&basis, &model.ratios(), &none)?;
    let frequency = reduced.respond(&load, grid, Window::Exponential(6.0), &model.observables)?;
    let slowest = Window::zeros_for(0.005, model.modes.omega[0]);
    let padded = reduced.respond(&load, grid, slowest, &model.observables)?;
    for (i, observable) in model.observables.iter().enumerate() {
        let direct = |t: &Transient| t.observed.scalars[i].extreme.peak().0;
        for (id, method, value) in [
            ("methods", "trapezoidal rule", direct(&trapezoidal)),
            ("methods", "generalised-α, ρ_∞ = 0.9", direct(&alpha)),
            (
                "D8",
                "frequency domain, exponential window",
                frequency[i].extreme.peak().0,
            ),
            ("D8", "frequency domain, zeros", padded[i].extreme.peak().0),
        ] {
            rows.push(row(
                id,
                "Four methods on one model",
                format!("strip 8.4: {}, {method}", observable.name),
                exact[i],
                "exact modal recurrence",
                Reference::SecondFormulation,
                value,
                5e-3,
                ["Nm/m", "m", "m"][i],
            ));
        }
    }
    Ok(rows)
}
