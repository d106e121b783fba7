//! A run of the strip in words: mesh, integration, envelopes, limits, notes.

use fem::analysis::damping::RatioRow;
use tank::units::{Dimension, display, significant};

use super::describe;
use super::simulate::Report;
use super::walls::WALLS;
use crate::linear::limits::limit_of;
use results::channel::OnWall;
use results::{Balance, Envelope, Labelled, Limit};
use tank::options::nonlinear::Damping;

/// Damping of the wall below which there is a note.
const UNDAMPED: f64 = 0.005;

impl Report<'_> {
    /// At θ = 0.
    pub(super) fn envelopes(&self) -> Vec<Envelope> {
        let history = &self.walls.runs[0].history;
        if history.times.is_empty() {
            return Vec::new();
        }
        let liquid = &self.strip.model.tank.liquid;
        let weight = liquid.density * liquid.gravity;
        vec![
            Envelope {
                id: OnWall::Pressure.id().into(),
                title: OnWall::Pressure.title().into(),
                dimension: OnWall::Pressure.dimension(),
                z: history.pressure.iter().map(|(z, _)| *z).collect(),
                static_: history.pressure.iter().map(|(z, _)| weight * (liquid.depth - z).max(0.0)).collect(),
                min: history.pressure.iter().map(|(_, r)| r.min).collect(),
                max: history.pressure.iter().map(|(_, r)| r.max).collect(),
            },
            Envelope {
                id: OnWall::Displacement.id().into(),
                title: "Deflection of the wall".into(),
                dimension: OnWall::Displacement.dimension(),
                z: self.strip.model.tank.levels.clone(),
                static_: history.deflection.iter().map(|(rest, _)| *rest).collect(),
                min: history.deflection.iter().map(|(rest, r)| r.min - rest).collect(),
                max: history.deflection.iter().map(|(rest, r)| r.max - rest).collect(),
            },
        ]
    }

    pub(super) fn mesh(&self) -> Vec<Labelled> {
        let model = &self.strip.model;
        let (elements, points) = (model.tank.sections.len(), describe::points(&model.tank));
        let wall = match model.tank.shells {
            None => format!("{elements} fibre beams a wall, two sections an element, {points} fibres a section"),
            Some(_) => format!(
                "{elements} elements a wall, each of four-node shells and the layer between them; {points} layers in the leaf \
                 that bends"
            ),
        };
        vec![
            label("wall elements", wall),
            label("liquid", describe::liquid(model)),
            label(
                "unknowns",
                match model.chain {
                    None => format!("{} a wall", model.model.dofs().len()),
                    Some(_) => format!("{} of walls and liquid", model.model.dofs().len()),
                },
            ),
        ]
    }

    pub(super) fn integration(&self) -> Vec<Labelled> {
        let (model, quake) = (&self.strip.model, &self.strip.quake);
        let grid = model.grid(quake);
        let mut out = vec![
            label(
                "method",
                format!(
                    "generalised-α with ρ∞ = {}, Newton's method; starts from static equilibrium",
                    self.options.spectral_radius
                ),
            ),
            label(
                "time step",
                format!(
                    "{} s, halved up to {} times where Newton's method does not converge; histories are stored at the record's step \
                     of {} s",
                    significant(grid.h(), 3),
                    quake.halvings,
                    significant(grid.dt, 4)
                ),
            ),
            label("duration", self.strip.span.text()),
            label(
                "damping",
                format!(
                    "{}: {} % in the first sloshing mode, {} % in the first mode of wall and liquid, on the initial stiffness \
                     of the wall",
                    match self.options.damping {
                        Damping::ByGroup { .. } => "wall stiffness-proportional, a ratio for every sloshing mode",
                        Damping::Rayleigh { .. } => "Rayleigh",
                        Damping::MassProportional { .. } => "mass-proportional",
                    },
                    significant(100.0 * model.ratios[0].ratio, 3),
                    significant(100.0 * model.wall_ratio(), 3)
                ),
            ),
            label(
                "wave height",
                match model.chain {
                    None => format!("first {} sloshing modes", model.tank.sloshing),
                    Some(_) => "displacement of the liquid at the wall".to_owned(),
                },
            ),
        ];
        if let Some(chain) = &model.chain {
            out.push(label("contact of liquid and wall", describe::contact(chain, &model.tank)));
        }
        if let Some(joints) = &model.joints {
            let penetration = self.walls.runs.iter().filter_map(|r| r.history.openings.as_ref());
            let penetration = penetration.map(|o| o.penetration()).fold(0.0, f64::max);
            out.push(label(
                "contact of liquid and wall",
                format!(
                    "opens; a joint at every wet level, stiffness {} N/m³, penetration at most {}; its force is evaluated at \
                     the end of the step",
                    significant(joints.penalty, 3),
                    display(penetration, Dimension::Length)
                ),
            ));
        }
        if self.walls.interrupted() {
            out.push(label("interrupted", format!("histories and extremes end at {:.2} s", self.walls.time())));
        }
        out
    }

    /// Liquid and walls in a rigid translation, against their masses.
    pub(super) fn mass_balance(&self) -> Vec<Balance> {
        let model = &self.strip.model;
        let liquid = match &model.chain {
            Some(chain) => 0.5 * chain.liquid_mass(model),
            None => model.condensed_mass(),
        };
        let lengths = model.tank.levels.windows(2).map(|w| w[1] - w[0]);
        let walls: f64 = lengths.zip(&model.tank.sections).map(|(l, s)| l * s.mass()).sum();
        let walls = walls + model.tank.carried.iter().map(|(mass, _)| mass).sum::<f64>();
        let all = self.case.liquid_mass() + self.case.tank.wall_mass();
        vec![Balance {
            label: "base shear of a rigid translation against the mass of liquid and walls".into(),
            error: 2.0 * self.walls.breadth * (liquid + walls) / all - 1.0,
        }]
    }

    /// Lowest pressure of a particle at the wall, below the trough.
    pub(super) fn suction(&self) -> Option<Limit> {
        let mut worst: Option<(f64, f64, f64, &str)> = None;
        for (run, name) in self.walls.runs.iter().zip(WALLS) {
            let found = run.history.separation.result();
            let places = run.history.separation.lowest_pressures();
            for (number, (height, pressure)) in places.enumerate() {
                // The lowest place is tested even if linear waves fall below it.
                if (height < found.trough || number == 0)
                    && pressure.is_finite()
                    && worst.is_none_or(|w| pressure < w.0)
                {
                    let seen = found.places.iter().find(|p| p.number == number);
                    worst = Some((pressure, height, seen.map_or(0.0, |p| p.time), name));
                }
            }
        }
        let (value, z, time, name) = worst?;
        let label = "Smallest pressure of the liquid at the wall below the wave trough";
        Some(limit_of("suction", label, [value, 0.0], Dimension::Stress, value >= 0.0, || {
            format!(
                "Suction at z = {}, {name}, t = {time:.2} s: the liquid would separate from the wall if air entered; the \
                 model keeps it in contact.",
                display(z, Dimension::Length)
            )
        }))
    }

    fn collapse(&self, wall: usize) -> String {
        match self.walls.load_factor(wall) {
            Some(factor) => format!(
                "The {} does not carry its weight and the hydrostatic pressure, only {} % of them. There is no response.",
                WALLS[wall],
                significant(100.0 * factor, 3)
            ),
            None => format!(
                "Collapse: the {} fails after {:.3} s. All numbers are those until then and are lower bounds; the other \
                 wall is not computed further.",
                WALLS[wall], self.walls.runs[wall].run.time
            ),
        }
    }

    pub(super) fn notes(&self) -> Vec<String> {
        let model = &self.strip.model;
        let collapsed = self.walls.collapsed().filter(|wall| self.walls.left(*wall).is_none());
        let mut notes: Vec<String> = collapsed.map(|wall| self.collapse(wall)).into_iter().collect();
        if self.walls.interrupted() {
            notes.push(format!(
                "Interrupted: all numbers are those until {:.2} s; maps and events of each wall are those of its last step.",
                self.walls.time()
            ));
        }
        let negative: Vec<&RatioRow> = model.ratios.iter().filter(|r| r.ratio < 0.0).collect();
        if !negative.is_empty() {
            notes.push(format!(
                "Rayleigh damping with a negative coefficient: the ratio is negative at {} of {} modes.",
                negative.len(),
                model.ratios.len()
            ));
        }
        if model.wall_ratio() < UNDAMPED {
            notes.push(format!(
                "The first mode of wall and liquid has a damping ratio of {} % only.",
                significant(100.0 * model.wall_ratio(), 2)
            ));
        }
        if self.motion.vertical.as_ref().is_some_and(|v| v.dt != self.motion.horizontal.dt) {
            notes.push(
                "The records differ in their time step: the vertical one is linearised within the steps of the analysis."
                    .into(),
            );
        }
        notes
    }
}

fn label(label: &str, text: String) -> Labelled {
    Labelled { label: label.into(), text }
}
