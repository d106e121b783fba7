//! The mode that sets the damping of a cylinder, and the damping.

use fem::analysis::damping::{Damping, Rayleigh};
use fem::linalg::dot;
use fem::liquid::WallLiquid;
use tank::imperfection::Imperfections;
use tank::options::nonlinear::{Damping as Wanted, MassProportionalAt, NonlinearOptions};
use tank::{Case, Support};

use super::super::contact::JOINT;
use super::super::elements::WALL;
use super::super::floor::FLOOR;
use super::super::slab::SLAB;
use super::super::standing::ANCHOR;
use super::CylinderModel;
use crate::FeError;
use crate::error::failed;
use crate::nonlinear::bottom::{GROUND, KEY};

/// Iterations that find the first mode of wall and liquid, at most: each makes the second mode smaller to a ninth or less.
/// More would amplify rounding in modes of higher wave number, whose frequencies are lower in thin shells.
const ITERATIONS: usize = 8;
/// Relative change of ω² at which they end.
const SETTLED: f64 = 1e-6;

impl CylinderModel {
    /// ω of the mode of wall and liquid that sets the damping [rad/s].
    pub(super) fn damped_mode(&self, case: &Case, options: &NonlinearOptions) -> Result<f64, FeError> {
        match self.imperfections.is_empty() {
            // As in the harmonic engine, the mode of the wall held at its foot sets the damping of a tank on its bottom. In the state without weight
            // the ground carries nothing, and the first mode would be that of a tank that hangs on its plate.
            true if self.standing.is_some() => {
                let mut held = case.clone();
                held.tank.support = Support::Anchored;
                held.tank.anchors = None;
                Ok(CylinderModel::new(&held, options)?.wall_omega)
            }
            true => self.first_wall_mode(),
            // Inverse iteration does not stay in one harmonic of an imperfect wall: that of the perfect one gives the damping.
            false => {
                let perfect = NonlinearOptions { imperfections: Imperfections::NONE, ..options.clone() };
                Ok(CylinderModel::new(case, &perfect)?.wall_omega)
            }
        }
    }

    /// Forces of a unit horizontal acceleration of the ground on wall and liquid, the surface free of pressure: those of the
    /// impulsive liquid, of the wall and of the roof, without the sloshing liquid.
    fn impulsive_load(&self) -> Vec<f64> {
        let mut load = self.system.inertia[0].clone();
        let mut follow = vec![0.0; load.len()];
        for &e in &self.amplitudes {
            follow[e] = -load[e] / self.amplitude_mass(e);
        }
        for (f, m) in load.iter_mut().zip(self.mass_times(&follow)) {
            *f += m;
        }
        self.amplitudes.iter().for_each(|&e| load[e] = 0.0);
        load
    }

    /// Inverse iteration from the impulsive load: on a round tank it stays among the modes in which the tank moves sideways. The
    /// amplitudes follow the wall as without gravity; their masses are 1 and uncoupled.
    fn first_wall_mode(&self) -> Result<f64, FeError> {
        let solver = self.static_solver()?;
        let mut load = self.impulsive_load();
        let mut omega2 = 0.0;
        for _ in 0..ITERATIONS {
            let mut x = solver(&load)?;
            self.amplitudes.iter().for_each(|&e| x[e] = 0.0);
            let potential = dot(&x, &self.stiffness_times(&x));
            let pushed = self.mass_times(&x);
            for &e in &self.amplitudes {
                x[e] = -pushed[e] / self.amplitude_mass(e);
            }
            let mut moved = self.mass_times(&x);
            self.amplitudes.iter().for_each(|&e| moved[e] = 0.0);
            let kinetic = dot(&x, &moved);
            let next = potential / kinetic;
            if !(next > 0.0 && next.is_finite()) {
                return Err(FeError::NotPositiveDefinite {
                    matrix: "stiffness of the wall in the static state".into(),
                    cause: "a wall without support or a layer without stiffness".into(),
                });
            }
            let done = (next / omega2 - 1.0).abs() < SETTLED;
            omega2 = next;
            let scale = 1.0 / kinetic.sqrt();
            load = moved.iter().map(|v| v * scale).collect();
            if done {
                break;
            }
        }
        Ok(omega2.sqrt())
    }

    /// M x.
    fn mass_times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.system.mass.times(x);
        self.assembler.add_operator_mass(&self.model, x, &mut y);
        y
    }

    /// K x.
    fn stiffness_times(&self, x: &[f64]) -> Vec<f64> {
        let mut y = self.system.stiffness.times(x);
        let on_stiffness = |_| [0.0, 1.0];
        self.assembler.add_operator_products(&self.model, on_stiffness, x, &mut y);
        y
    }

    /// Mass of a sloshing amplitude; those of an operator are normalised.
    fn amplitude_mass(&self, equation: usize) -> f64 {
        match &self.liquid {
            WallLiquid::Dense(_) => self.system.mass.get(equation, equation),
            WallLiquid::Circular(_) => 1.0,
        }
    }

    pub(super) fn set_damping(&mut self, wanted: Wanted) -> Result<(), FeError> {
        let all = match wanted {
            Wanted::ByGroup { wall, .. } => {
                let own = Rayleigh::stiffness_proportional(self.wall_omega, wall);
                for (to, name) in self.rayleigh.iter_mut().zip(self.model.groups()) {
                    if name == WALL {
                        *to = own;
                    }
                }
                self.wall_ratio = wall;
                self.system.damping =
                    Damping::by_group(&self.assembler, &self.model, &self.rayleigh, false).map_err(failed)?;
                return Ok(());
            }
            Wanted::Rayleigh { first, second, allow_negative } => Rayleigh::fit(first, second, allow_negative)
                .map_err(|e| FeError::option("damping", e.to_string(), "coefficients ≥ 0, or allow_negative"))?,
            Wanted::MassProportional { ratio, at } => {
                let omega = match at {
                    MassProportionalAt::FirstSloshing => self.sloshing_omega,
                    MassProportionalAt::Frequency(omega) => omega,
                };
                Rayleigh::mass_proportional(omega, ratio)
            }
        };
        self.rayleigh.fill(all);
        self.wall_ratio = all.ratio(self.wall_omega);
        self.system.damping = match self.contact() || self.slab.is_some() {
            false => Damping::rayleigh(all),
            true => {
                // An open joint must not pull through damping either; the soil has its own.
                let groups = self.rayleigh.iter_mut().zip(self.model.groups());
                groups
                    .filter(|(_, name)| [JOINT, GROUND, KEY, FLOOR, ANCHOR, SLAB].contains(&name.as_str()))
                    .for_each(|(own, _)| *own = Rayleigh::NONE);
                Damping::by_group(&self.assembler, &self.model, &self.rayleigh, false).map_err(failed)?
            }
        };
        Ok(())
    }
}
