//! Both walls after a run: events, end, loops, energies, cost.

use fem::analysis::march::{Collapse, Outcome};
use fem::dofs::Dof;
use tank::Case;
use tank::units::{Dimension, display, significant};

use super::history::{EventKind, Scalar};
use super::model::StripModel;
use super::run::WallRun;
use super::validity::first_of;
use results::channel::Side;
use results::nonlinear::{
    BaseMoment, Columns, Count, Departure, End, Energies, Event, EventKind as Kind, Loop, LoopAxis, Nonlinear, WallGrid,
};

/// Names of the walls.
pub(super) const WALLS: [&str; 2] = ["wall at θ = 0°", "wall at θ = 180°"];
/// Their angles from the direction of shaking [rad].
const ANGLES: [f64; 2] = [0.0, std::f64::consts::PI];
/// Names of the faces.
pub(super) const FACES: [&str; 2] = ["inner face", "outer face"];

/// The departure of the wall at the angle `theta` [rad].
fn at(found: &Departure, theta: f64) -> Departure {
    Departure { theta: Some(theta), ..found.clone() }
}

/// Both walls after a run.
pub(super) struct Walls<'a> {
    pub case: &'a Case,
    pub model: &'a StripModel,
    pub runs: &'a [WallRun; 2],
    /// Breadth of the tank [m].
    pub breadth: f64,
    /// Samples that both walls have.
    pub samples: usize,
}

impl Walls<'_> {
    pub(super) fn nonlinear(&self) -> Nonlinear {
        let levels = &self.model.tank.levels;
        Nonlinear {
            grid: WallGrid {
                columns: Columns::Walls { names: WALLS.map(String::from).to_vec() },
                z: levels.clone(),
                surface: self.case.liquid.fill_height,
            },
            extremes: Vec::new(),
            maps: self.maps(),
            cracks: self.cracks(),
            loops: self.loops(),
            energies: self.energies(),
            cost: self.cost(),
            moments: self.moments(),
            departures: self.departures(),
        }
    }

    /// Largest moment at the base of each wall.
    fn moments(&self) -> Vec<BaseMoment> {
        let walls = self.runs.iter().zip(WALLS);
        walls
            .map(|(run, name)| {
                let section = run.history.scalar(Scalar::SectionMoment).iter();
                BaseMoment {
                    place: name.into(),
                    largest_section: section.fold(0.0, |most, m| m.abs().max(most)),
                    ..run.history.peak.clone()
                }
            })
            .collect()
    }

    /// Limits of the model that were exceeded, the first of each kind by time.
    pub(super) fn departures(&self) -> Vec<Departure> {
        let walls = self.runs.iter().zip(ANGLES);
        first_of(walls.flat_map(|(run, theta)| run.history.departures.iter().map(move |d| at(d, theta))))
    }

    /// The limit of the model that stopped the run of a wall.
    pub(super) fn left(&self, wall: usize) -> Option<Departure> {
        let history = &self.runs[wall].history;
        let found = history.departures.iter().find(|d| d.kind.stops())?;
        Some(at(found, ANGLES[wall]))
    }

    /// The wall whose run ends first prematurely: it collapses, or exceeds a limit of the model.
    pub(super) fn collapsed(&self) -> Option<usize> {
        let collapsed = (0..2).filter(|&w| self.runs[w].collapsed());
        collapsed.min_by(|&a, &b| self.runs[a].run.time.total_cmp(&self.runs[b].run.time))
    }

    /// Largest share of weight and hydrostatic pressure that was carried, if not all of it.
    pub(super) fn load_factor(&self, wall: usize) -> Option<f64> {
        match &self.runs[wall].run.outcome {
            Outcome::Collapsed(collapse) => collapse.load_factor,
            _ => None,
        }
    }

    pub(super) fn interrupted(&self) -> bool {
        self.runs.iter().any(|r| r.run.outcome == Outcome::Interrupted)
    }

    /// Time that both walls have reached [s].
    pub(super) fn time(&self) -> f64 {
        self.runs.iter().map(|r| r.run.time).fold(f64::INFINITY, f64::min)
    }

    /// How the run ended.
    pub(super) fn end(&self) -> End {
        if self.interrupted() {
            return End::Interrupted { time: self.time() };
        }
        let Some(wall) = self.collapsed() else { return End::Completed };
        if let Some(left) = self.left(wall) {
            return End::Left { time: left.time, departure: left };
        }
        let (run, lost) = (&self.runs[wall].run, &self.runs[wall].lost);
        let (reason, place) = match (&run.outcome, lost) {
            (Outcome::Collapsed(collapse), _) => (collapse.failure.to_string(), self.place_of(wall, collapse)),
            (_, Some(lost)) => (lost.clone(), WALLS[wall].to_owned()),
            // A collapsed wall has one of the two reasons.
            _ => (String::new(), WALLS[wall].to_owned()),
        };
        let load_factor = self.load_factor(wall);
        End::Collapsed { time: if load_factor.is_some() { -1.0 } else { run.time }, load_factor, reason, place }
    }

    fn place_of(&self, wall: usize, collapse: &Collapse) -> String {
        let height = |node: usize| display(self.model.model.nodes()[node][2], Dimension::Length);
        let wall = match (&self.model.chain, collapse.worst) {
            (Some(chain), Some((node, _))) => chain.wall_of(self.model, node).unwrap_or(wall),
            _ => wall,
        };
        match (collapse.worst, collapse.element) {
            (Some((_, Dof::Amplitude)), _) => format!("{}, surface of the liquid", WALLS[wall]),
            (Some((node, dof)), _) => {
                let force = match dof {
                    Dof::Ux => "horizontal force",
                    Dof::Uz => "vertical force",
                    _ => "moment",
                };
                format!("{}, z = {}, {force}", WALLS[wall], height(node))
            }
            (None, Some(element)) if element < self.model.tank.sections.len() => {
                let [a, b] = [element, element + 1].map(|i| display(self.model.tank.levels[i], Dimension::Length));
                format!("{}, between z = {a} and {b}", WALLS[wall])
            }
            _ => WALLS[wall].to_owned(),
        }
    }

    /// First events of each kind, on either wall, by time.
    pub(super) fn events(&self) -> Vec<Event> {
        let mut events = Vec::new();
        for (wall, run) in self.runs.iter().enumerate() {
            for event in &run.history.events {
                let (kind, title) = match event.kind {
                    EventKind::Crack => (Kind::FirstCrack, "first crack"),
                    EventKind::Yield if self.cracks_at_all() => {
                        (Kind::FirstYield, "concrete at its compressive strength")
                    }
                    EventKind::Yield => (Kind::FirstYield, "first yield"),
                    EventKind::BarYield => (Kind::FirstBarYield, "first bar yields"),
                    EventKind::BarRupture => (Kind::BarRupture, "first bar beyond its rupture strain"),
                };
                events.push(Event {
                    kind,
                    title: title.into(),
                    time: event.time,
                    place: format!(
                        "{}, z = {}, {}",
                        WALLS[wall],
                        display(event.height, Dimension::Length),
                        FACES[usize::from(event.depth > 0.0)]
                    ),
                    note: format!(
                        "moment at the base of the wall then {}",
                        display(event.base_moment.abs(), Dimension::LineMoment)
                    ),
                });
            }
            events.extend(self.parting(wall));
            let separation = run.history.separation.result();
            let places = separation.places.iter().filter(|p| p.below_trough);
            if let Some(first) = places.clone().min_by(|a, b| a.first.total_cmp(&b.first)) {
                let lowest = separation.lowest_below_trough().unwrap_or(first);
                let worst = places.min_by(|a, b| a.pressure.total_cmp(&b.pressure)).unwrap_or(first);
                events.push(Event {
                    kind: Kind::LowPressure,
                    title: "pressure of the liquid below atmospheric".into(),
                    time: first.first,
                    place: format!("{}, z = {}", WALLS[wall], display(first.height, Dimension::Length)),
                    note: format!(
                        "down to z = {}, lowest {} at z = {} after {:.2} s; the model keeps the liquid in contact with the wall",
                        display(lowest.height, Dimension::Length),
                        display(worst.pressure, Dimension::Stress),
                        display(worst.height, Dimension::Length),
                        worst.time
                    ),
                });
            }
        }
        events.sort_by(|a, b| a.time.total_cmp(&b.time));
        events
    }

    /// When the liquid separates from the wall, where it may.
    fn parting(&self, wall: usize) -> Option<Event> {
        let places = self.runs[wall].history.openings.as_ref()?.places();
        let first = places.iter().min_by(|a, b| a.first.total_cmp(&b.first))?;
        let lowest = places.iter().map(|p| p.height).fold(f64::INFINITY, f64::min);
        let widest = places.iter().max_by(|a, b| a.widest.total_cmp(&b.widest))?;
        let length = |x: f64| display(x, Dimension::Length);
        Some(Event {
            kind: Kind::Separation,
            title: "the liquid separates from the wall".into(),
            time: first.first,
            place: format!("{}, z = {}", WALLS[wall], length(first.height)),
            note: format!(
                "down to z = {}; widest {} at z = {} after {:.2} s; open there in {} % of the steps",
                length(lowest),
                length(widest.widest),
                length(widest.height),
                widest.time,
                significant(100.0 * widest.share, 2)
            ),
        })
    }

    fn loops(&self) -> Vec<Loop> {
        let axis = |title: &str, dimension| LoopAxis { title: title.into(), dimension };
        let points = |run: &WallRun, x: Scalar, y: Scalar| -> Vec<[f64; 2]> {
            let (x, y) = (run.history.scalar(x), run.history.scalar(y));
            let samples = run.history.samples.iter().take(self.samples);
            samples.map(|&i| [x[i], y[i]]).collect()
        };
        let mut loops = Vec::new();
        for (wall, run) in self.runs.iter().enumerate() {
            loops.push(Loop {
                id: format!("moment_curvature_{}", Side::BOTH[wall].id()),
                title: format!("Lowest section of the {}", WALLS[wall]),
                x: axis("curvature", Dimension::Curvature),
                y: axis("bending moment", Dimension::LineMoment),
                points: points(run, Scalar::Curvature, Scalar::SectionMoment),
            });
        }
        for (wall, run) in self.runs.iter().enumerate() {
            loops.push(Loop {
                id: format!("shear_displacement_{}", Side::BOTH[wall].id()),
                title: format!("Base shear of the {}", WALLS[wall]),
                x: axis("deflection of the top", Dimension::Length),
                y: axis("shear force at the base", Dimension::LineForce),
                points: points(run, Scalar::Deflection, Scalar::Shear),
            });
        }
        loops
    }

    /// Runs that were marches of their own: both, or one of a model that holds both walls.
    fn marched(&self) -> &[WallRun] {
        &self.runs[..self.model.marches()]
    }

    /// Energies of the whole tank.
    fn energies(&self) -> Energies {
        let sum = |value: fn(&fem::analysis::march::Energies) -> f64| -> Vec<f64> {
            let at = |i: usize| {
                let own = self.marched().iter().map(|r| r.run.balance.samples.get(i).map(value));
                own.sum::<Option<f64>>().map(|sum| self.breadth * sum)
            };
            (0..self.samples).map_while(at).collect()
        };
        let history = &self.runs[0].history;
        let samples = history.samples.iter().take(self.samples);
        Energies {
            time: samples.map(|&i| history.times[i]).collect(),
            input: sum(|e| e.input),
            kinetic: sum(|e| e.kinetic),
            internal: sum(|e| e.internal),
            damping: sum(|e| e.damping),
            numerical: sum(|e| e.numerical),
            hysteretic: sum(|e| e.hysteretic),
            error: self.runs.iter().map(|r| r.run.balance.error()).fold(0.0, f64::max),
        }
    }

    fn cost(&self) -> Vec<Count> {
        let sum = |label: &str, value: fn(&WallRun) -> u64| Count {
            label: label.into(),
            value: self.marched().iter().map(|r| value(r) as f64).sum(),
            dimension: Dimension::Dimensionless,
        };
        let shortest = self.runs.iter().map(|r| r.run.shortest).fold(f64::INFINITY, f64::min);
        let mut out = vec![
            sum("steps, both walls", |r| r.run.cost.steps),
            sum("steps halved", |r| r.run.cuts),
            sum("iterations of Newton's method", |r| r.run.cost.iterations),
            sum("factorisations", |r| r.run.cost.factors),
        ];
        if shortest.is_finite() {
            out.push(Count { label: "shortest step".into(), value: shortest, dimension: Dimension::Time });
        }
        out
    }
}
