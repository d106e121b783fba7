//! Strip 8.4 of the dissertation, linear: a cantilever wall with the liquid condensed onto it in closed form.
//!
//! Half of a tank of width 2 L with liquid to the height H, antisymmetric motion ([`engines::strip::liquid`]); wall at x = L
//! as a beam of plane strain with Hermite elements; unknowns are its free deflections and rotations and the amplitudes q_n
//! of N sloshing modes. The liquid is one function of the wall's deflection, without a mesh.

use std::sync::Arc;

use oscillator::STANDARD_GRAVITY;

use engines::strip::liquid::StripLiquid;
use fem::analysis::AnalysisError;
use fem::analysis::damping::{Damping, Rayleigh};
use fem::analysis::modal::ModalBasis;
use fem::analysis::motion::{Grid, Motion};
use fem::analysis::observable::Observable;
use fem::analysis::scheme::TimeScheme;
use fem::analysis::statics::Statics;
use fem::analysis::system::System;
use fem::analysis::transient::{Load, Settings, Transient, integrate};
use fem::linalg::{Eigen, Kind, Matrix, Ordering, Pattern, Symbolic, Symmetric, dot, generalized_eigen};
use fem::progress::Silent;

/// The strip with its matrices and modes.
#[derive(Clone, Debug)]
pub(crate) struct Strip {
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

/// Sloshing modes of [`strip`].
pub(super) const SLOSHING: usize = 12;
pub(super) const HALF_WIDTH: f64 = 2.5;

pub(super) const DEPTH: f64 = 2.57;

pub(super) const HEIGHT: f64 = 3.0;

pub(super) const THICKNESS: f64 = 0.3;

const YOUNG: f64 = 34e9;

const POISSON: f64 = 0.2;

pub(super) const WALL_DENSITY: f64 = 2950.0;

pub(super) const LIQUID_DENSITY: f64 = 1019.4;

pub(super) fn liquid() -> StripLiquid {
    StripLiquid::new(HALF_WIDTH, DEPTH, LIQUID_DENSITY)
}

/// E I/(1 − ν²) of the wall [Nm].
pub(super) fn bending_stiffness() -> f64 {
    YOUNG / (1.0 - POISSON * POISSON) * THICKNESS.powi(3) / 12.0
}

impl Strip {
    /// `wet` elements up to the surface and `dry` above it, `sloshing` sloshing modes.
    ///
    /// Errors: none but those of the eigenvalue solver.
    pub(crate) fn new(wet: usize, dry: usize, sloshing: usize) -> Result<Strip, AnalysisError> {
        // More than 80 lines: assembles one system block by block.
        let mut z: Vec<f64> = (0..=wet).map(|i| DEPTH * i as f64 / wet as f64).collect();
        z.extend((1..=dry).map(|i| DEPTH + (HEIGHT - DEPTH) * i as f64 / dry as f64));
        let wall = 2 * z.len();
        let all = wall + sloshing;
        let (mut m, mut k) = (Matrix::zeros(all, all), Matrix::zeros(all, all));
        let bending = bending_stiffness();
        let density = WALL_DENSITY * THICKNESS;
        for e in 0..z.len() - 1 {
            let l = z[e + 1] - z[e];
            let (stiffness, inertia) = (beam_stiffness(l), beam_mass(l));
            for i in 0..4 {
                for j in 0..4 {
                    k.add(2 * e + i, 2 * e + j, bending * stiffness[i][j]);
                    m.add(2 * e + i, 2 * e + j, density * inertia[i][j]);
                }
            }
        }
        let liquid = liquid().on_wall(&z, sloshing);
        for (sum, part) in [(&mut m, &liquid.mass), (&mut k, &liquid.stiffness)] {
            sum.data.iter_mut().zip(&part.data).for_each(|(a, b)| *a += b);
        }
        // A unit translation moves the clamped base as well.
        let translation: Vec<f64> = (0..all).map(|i| f64::from(i < wall && i % 2 == 0)).collect();
        let inertia = m.times(&translation);
        let base_moment = k.column(1).to_vec();
        let free: Vec<usize> = (2..all).collect();
        let pattern = Arc::new(Pattern::from_cliques(
            free.len(),
            std::iter::once((0..free.len()).collect::<Vec<_>>()).collect::<Vec<_>>().iter().map(Vec::as_slice),
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
        let modes = generalized_eigen(&kd, &md, None)
            .map_err(|source| AnalysisError::Linalg { what: "modes of the strip", source })?;
        let sparse = |v: Vec<f64>| v.into_iter().enumerate().filter(|(_, c)| *c != 0.0).collect();
        let observable =
            |name: &str, displacement| Observable { name: name.to_owned(), displacement, ..Observable::default() };
        let observables = vec![
            observable("moment at the base of the wall", sparse(cut(&base_moment))),
            observable("deflection of the top of the wall", vec![(wall - 4, 1.0)]),
            observable(
                "elevation of the surface at the wall",
                liquid.elevation.iter().enumerate().map(|(n, e)| (wall - 2 + n, *e)).collect(),
            ),
        ];
        let symbolic = Symbolic::new(pattern, &Ordering::MinimumDegree)
            .map_err(|source| AnalysisError::Linalg { what: "the strip", source })?;
        Ok(Strip { system, modes, observables, sloshing, symbolic: Arc::new(symbolic) })
    }

    /// Ratios: sloshing modes 0.5 %, wall modes 2 %.
    pub(crate) fn ratios(&self) -> Vec<f64> {
        (0..self.modes.omega.len()).map(|j| if self.is_sloshing(j) { 0.005 } else { 0.02 }).collect()
    }

    /// Whether more than half of a mode's potential energy is in the surface.
    pub(crate) fn is_sloshing(&self, mode: usize) -> bool {
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
    pub(crate) fn basis(&self, keep: &[usize], missing_mass: bool) -> Result<ModalBasis, AnalysisError> {
        let all: Vec<usize> = (0..self.system.size()).collect();
        let vectors = self.modes.vectors.select(&all, keep);
        let omega: Vec<f64> = keep.iter().map(|&j| self.modes.omega[j]).collect();
        let statics = Statics::new(&self.symbolic, &self.system.stiffness, Kind::Definite)?;
        let still = statics.solve(&self.system.stiffness, &[&self.system.inertia[0]])?;
        let given = missing_mass.then_some(still[0].as_slice());
        ModalBasis::new(&self.system, &omega, &vectors, [given, None, None])
    }

    /// Peaks of the observables by modal superposition.
    pub(super) fn superposed(
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

    /// Peaks of the observables by direct integration with Rayleigh damping.
    pub(super) fn rayleigh(
        &self,
        damping: Rayleigh,
        scheme: TimeScheme,
        load: &Load,
        grid: Grid,
    ) -> Result<Vec<f64>, AnalysisError> {
        let found = self.integrated(Damping::rayleigh(damping), scheme, load, grid)?;
        let scalars = found.observed.scalars;
        Ok(scalars.iter().map(|s| s.extreme.peak().0.abs()).collect())
    }

    /// Direct integration with modal damping of all modes.
    pub(super) fn direct(&self, scheme: TimeScheme, load: &Load, grid: Grid) -> Result<Transient, AnalysisError> {
        let damping = Damping::modal(&self.system.mass, &self.modes, &self.ratios(), Rayleigh::NONE)?;
        self.integrated(damping, scheme, load, grid)
    }

    fn integrated(
        &self,
        damping: Damping,
        scheme: TimeScheme,
        load: &Load,
        grid: Grid,
    ) -> Result<Transient, AnalysisError> {
        let system = self.system.clone().with_damping(damping);
        let mut settings = Settings::new(grid);
        settings.scheme = scheme;
        let load = std::slice::from_ref(load);
        let mut found = integrate(&system, &self.symbolic, load, &settings, &self.observables, &[], &Silent)?;
        Ok(found.remove(0))
    }
}

/// Stiffness of a beam element with unit bending stiffness.
pub(super) fn beam_stiffness(l: f64) -> [[f64; 4]; 4] {
    let (a, b, c, d) = (12.0 / l.powi(3), 6.0 / l.powi(2), 4.0 / l, 2.0 / l);
    [[a, b, -a, b], [b, c, -b, d], [-a, -b, a, -b], [b, d, -b, c]]
}

/// Consistent mass of a beam element with unit mass per length.
pub(super) fn beam_mass(l: f64) -> [[f64; 4]; 4] {
    let f = l / 420.0;
    let (a, b, c, d) = (156.0 * f, 22.0 * l * f, 54.0 * f, 13.0 * l * f);
    let (e, h) = (4.0 * l * l * f, 3.0 * l * l * f);
    [[a, b, c, -d], [b, e, d, -h], [c, d, a, -b], [-d, -h, -b, e]]
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

/// Broad-band shaking of the strip: a record at steps of `dt`, taken in steps of `dt`/`sub_steps`.
pub(super) fn shaking(sub_steps: f64) -> (Grid, Load) {
    let (dt, duration) = (0.02, 16.0);
    let grid = Grid::new(dt, duration, 4.0, dt / sub_steps);
    let ground = ground_motion(dt, duration);
    let load = Load::ground(0, Motion::sampled(dt, &ground, &grid));
    (grid, load)
}

/// The strip of these benchmarks: 14 wet and 3 dry elements, 12 sloshing modes, which leave out 0.05 % of the liquid's mass.
///
/// Errors: none but those of the eigenvalue solver.
pub(super) fn strip() -> Result<Strip, AnalysisError> {
    Strip::new(14, 3, SLOSHING)
}
