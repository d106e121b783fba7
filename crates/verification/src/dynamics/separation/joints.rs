//! The strip whose liquid has its own normal displacement, joined to the wall.

use super::super::strip::{
    DEPTH, HEIGHT, THICKNESS, WALL_DENSITY, beam_mass, beam_stiffness, bending_stiffness, liquid,
};
use crate::moreau::{Joint, Jointed, MarchReport, Opening};
use fem::analysis::AnalysisError;
use fem::analysis::damping::Rayleigh;
use fem::linalg::Matrix;
use fem::liquid::separation::{Separation, SeparationCheck};
use fem::shape::{gauss, line};

/// Wet and dry elements of the wall, sloshing modes.
pub(super) const MESH: [usize; 3] = [14, 3, 12];

/// Seconds of the record that are run; its peaks come before.
pub(super) const DURATION: f64 = 14.0;

/// When a joint opens.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Criterion {
    /// Never.
    Bonded,
    /// Where the pressure of the displaced particle falls below zero.
    Particle,
    /// Where ρ g (H − z) + p' does: the wrong test.
    Place,
    /// The same, only below the height given.
    PlaceBelow(f64),
}

/// A strip whose liquid has its own displacement.
pub(super) struct Jointing {
    system: Jointed,
    /// Load of a unit ground acceleration, with its sign.
    load: Vec<f64>,
    moment: Vec<(usize, f64)>,
    elevation: Vec<(usize, f64)>,
    /// Height and weight of each joint.
    places: Vec<(f64, f64)>,
}

/// Largest values of a run.
#[derive(Clone, Debug)]
pub(super) struct Peaks {
    /// Moment at the base [Nm/m].
    pub(super) moment: f64,
    /// Elevation at the wall [m].
    pub(super) wave: f64,
    /// Lowest joint that opened [m], and when first.
    pub(super) opened: Option<(f64, f64)>,
    pub(super) report: MarchReport,
    /// The check of the linear result; empty where joints open.
    pub(super) check: Separation,
}

fn dot(row: &[(usize, f64)], x: &[f64]) -> f64 {
    row.iter().map(|&(i, c)| c * x[i]).sum()
}

impl Jointing {
    /// * `penalty` k_n [N/m³]
    /// * `damping` of wall and waves
    pub(super) fn new(penalty: f64, damping: Rayleigh, criterion: Criterion) -> Jointing {
        // More than 80 lines: assembles one system block by block.
        let [wet, dry, sloshing] = MESH;
        let mut z: Vec<f64> = (0..=wet).map(|i| DEPTH * i as f64 / wet as f64).collect();
        z.extend((1..=dry).map(|i| DEPTH + (HEIGHT - DEPTH) * i as f64 / dry as f64));
        let (wall, own) = (2 * z.len(), 2 * (wet + 1));
        let all = wall + own + sloshing;
        let (mut m, mut k) = (Matrix::zeros(all, all), Matrix::zeros(all, all));
        for e in 0..z.len() - 1 {
            let l = z[e + 1] - z[e];
            let (stiffness, inertia) = (beam_stiffness(l), beam_mass(l));
            for i in 0..4 {
                for j in 0..4 {
                    k.add(2 * e + i, 2 * e + j, bending_stiffness() * stiffness[i][j]);
                    m.add(2 * e + i, 2 * e + j, WALL_DENSITY * THICKNESS * inertia[i][j]);
                }
            }
        }
        let liquid = liquid();
        let condensed = liquid.on_wall(&z[..=wet], sloshing);
        for j in 0..own + sloshing {
            for i in 0..own + sloshing {
                m.add(wall + i, wall + j, condensed.mass.get(i, j));
                k.add(wall + i, wall + j, condensed.stiffness.get(i, j));
            }
        }
        // A unit translation moves wall and liquid.
        let translation: Vec<f64> = (0..all).map(|i| f64::from(i < wall + own && i % 2 == 0)).collect();
        let inertia = m.times(&translation);
        // Clamped base: deflection and slope of wall and liquid.
        let free: Vec<usize> = (2..wall).chain(wall + 2..all).collect();
        let mut number = vec![usize::MAX; all];
        free.iter().enumerate().for_each(|(new, &old)| number[old] = new);
        let renumbered = |row: Vec<(usize, f64)>| -> Vec<(usize, f64)> {
            let kept = row.into_iter().map(|(i, c)| (number[i], c));
            kept.filter(|&(i, c)| i != usize::MAX && c != 0.0).collect()
        };
        let weight = liquid.density * liquid.gravity;
        let (mut joints, mut places) = (Vec::new(), Vec::new());
        for e in 0..wet {
            let l = z[e + 1] - z[e];
            for &(x, w) in gauss::FOUR {
                let at = z[e] + 0.5 * l * (1.0 + x);
                let share = 0.5 * l * w;
                let [shape, ..] = line::hermite(x, l);
                let closing = (0..4).flat_map(|i| [(wall + 2 * e + i, shape[i]), (2 * e + i, -shape[i])]).collect();
                let rise = |n: usize| {
                    let kn = liquid.wave_number(n);
                    condensed.elevation[n] * (kn * at).sinh() / (kn * DEPTH).sinh()
                };
                let relief = match criterion {
                    Criterion::Particle => (0..sloshing).map(|n| (wall + own + n, -weight * share * rise(n))).collect(),
                    _ => Vec::new(),
                };
                // A preload larger than any wave keeps the joint closed.
                let exempt = matches!(criterion, Criterion::PlaceBelow(top) if at > top);
                joints.push(Joint {
                    closing: renumbered(closing),
                    stiffness: penalty * share,
                    preload: if exempt { 1e9 } else { weight * (DEPTH - at) * share },
                    relief: renumbered(relief),
                });
                places.push((at, share));
            }
        }
        let pick = |a: &Matrix| {
            let mut out = Matrix::zeros(free.len(), free.len());
            for (j, &from_j) in free.iter().enumerate() {
                for (i, &from_i) in free.iter().enumerate() {
                    out.add(i, j, a.get(from_i, from_j));
                }
            }
            out
        };
        let (mass, stiffness) = (pick(&m), pick(&k));
        let mut viscous = mass.clone();
        for (c, k) in viscous.data.iter_mut().zip(&stiffness.data) {
            *c = damping.mass * *c + damping.stiffness * k;
        }
        let moment = k.column(1).iter().copied().enumerate().collect();
        let elevation = condensed.elevation.iter().enumerate();
        Jointing {
            load: free.iter().map(|&i| -inertia[i]).collect(),
            moment: renumbered(moment),
            elevation: renumbered(elevation.map(|(n, c)| (wall + own + n, *c)).collect()),
            places,
            system: Jointed {
                mass,
                damping: viscous,
                stiffness,
                joints,
                opening: match criterion {
                    Criterion::Bonded => Opening::Bonded,
                    _ => Opening::Unilateral,
                },
            },
        }
    }

    /// Peaks under the ground motion `sign` × `samples` at steps of `dt`, marched at `h`.
    pub(super) fn run(&self, samples: &[f64], dt: f64, sign: f64, h: f64) -> Result<Peaks, AnalysisError> {
        let ground = |t: f64| -> f64 {
            let place = t / dt;
            let i = place.floor() as usize;
            let at = |i: usize| samples.get(i).copied().unwrap_or(0.0);
            sign * (at(i) + (place - i as f64) * (at(i + 1) - at(i)))
        };
        let steps = (DURATION / h).round() as usize;
        let weight = liquid().density * liquid().gravity;
        let heights = self.places.iter().map(|p| p.0).collect();
        let mut check = SeparationCheck::new(weight, DEPTH, heights);
        let [_, _, sloshing] = MESH;
        let rises: Vec<Vec<f64>> = self
            .places
            .iter()
            .map(|&(at, _)| {
                let rise = |n: usize| {
                    let kn = liquid().wave_number(n);
                    (kn * at).sinh() / (kn * DEPTH).sinh()
                };
                (0..sloshing).map(rise).collect()
            })
            .collect();
        let (mut moment, mut wave) = (0.0_f64, 0.0_f64);
        let mut opened: Option<(f64, f64)> = None;
        let load = |t: f64| -> Vec<f64> {
            let a = ground(t);
            self.load.iter().map(|p| a * p).collect()
        };
        let report = self.system.march(h, steps, &load, |m| {
            let x = m.displacement;
            moment = moment.max(dot(&self.moment, x).abs());
            let elevation = dot(&self.elevation, x);
            wave = wave.max(elevation.abs());
            for (i, _) in m.open.iter().enumerate().filter(|(_, open)| **open) {
                let z = self.places[i].0;
                if opened.is_none_or(|(lowest, _)| z < lowest) {
                    opened = Some((z, m.time));
                }
            }
            let pressure = |i: usize| {
                let joint = &self.system.joints[i];
                joint.stiffness * dot(&joint.closing, x) / self.places[i].1
            };
            let rise = |i: usize| {
                let terms = self.elevation.iter().zip(&rises[i]);
                terms.map(|(&(k, c), r)| c * r * x[k]).sum()
            };
            // The check is one of the linear result.
            if self.system.opening == Opening::Bonded {
                check.see(m.time, pressure, rise, elevation);
            }
        })?;
        Ok(Peaks { moment, wave, opened, report, check: check.result() })
    }

    /// The worse of both walls.
    pub(super) fn both(&self, samples: &[f64], dt: f64, h: f64) -> Result<[Peaks; 2], AnalysisError> {
        Ok([self.run(samples, dt, 1.0, h)?, self.run(samples, dt, -1.0, h)?])
    }
}

pub(super) fn worse(pair: &[Peaks; 2]) -> (f64, f64) {
    (pair[0].moment.max(pair[1].moment), pair[0].wave.max(pair[1].wave))
}
