//! Demand of a nonlinear run of a strip: the largest values of its history.

use fem::analysis::march::Range;
use fem::liquid::separation::Parting;
use results::FirstCrack;
use results::nonlinear::{BaseMoment, Departure};

use super::history::{Cell, EventKind, Scalar, WallHistory};
use super::model::BaseReaction;
use super::validity::first_of;

/// The moments at the base of a reaction at the time `time` [s]; wall and largest moment of the section are not known yet.
pub(super) fn base_moment(time: f64, reaction: &BaseReaction) -> BaseMoment {
    BaseMoment {
        time,
        reaction: reaction.total()[2],
        section: reaction.section[2],
        damping: reaction.damping[2],
        inertia: reaction.inertia[2],
        load: reaction.load[2],
        ..BaseMoment::default()
    }
}

/// Largest values of a run, and the final state of the wall.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Demand {
    /// Largest elevation of the surface at the wall, up or down [m].
    pub wave: f64,
    /// Largest deflection of the top, the state at rest included [m].
    pub deflection: f64,
    /// Its time [s].
    pub deflection_time: f64,
    /// Largest moment that the ground exerts on the base, damping, inertia and pressure of the lowest element included [N].
    pub base_moment: f64,
    /// Parts of that moment.
    pub parts: BaseMoment,
    /// Largest bending moment of the lowest section, the integral of its stresses [N].
    pub section_moment: f64,
    /// The first crack.
    pub first_crack: Option<FirstCrack>,
    /// Highest section with a crack [m]; 0 without any.
    pub highest_crack: f64,
    /// Largest opening strain of any crack.
    pub largest_crack: f64,
    /// Largest plastic strain of any layer.
    pub plastic_strain: f64,
    /// Largest stress of any bar [Pa].
    pub bar_stress: f64,
    /// Largest plastic strain of any bar.
    pub bar_plastic_strain: f64,
    /// When the liquid first separates from the wall, or would if it could; set at the end of a run.
    pub parting: Option<Parting>,
    /// Largest length of the wetted wall that the liquid has left at once, where it may [m].
    pub open: Option<f64>,
    /// Value at rest and range of every [`Scalar`], of one wall alone.
    pub ranges: Vec<(Scalar, f64, Range)>,
    /// Limits of the model that were passed, the first of each kind by time.
    pub departures: Vec<Departure>,
}

impl Demand {
    /// The largest values of a history.
    pub(super) fn of(history: &WallHistory) -> Demand {
        let largest = |scalar: Scalar| -> (f64, f64) {
            let values = history.scalar(scalar).iter().zip(&history.times);
            values.fold((0.0, 0.0), |most, (v, &time)| if v.abs() > most.0 { (v.abs(), time) } else { most })
        };
        let (deflection, deflection_time) = largest(Scalar::Deflection);
        let cells = |value: fn(&Cell) -> f64| history.cells.iter().map(value).fold(0.0, f64::max);
        let [_, last] = &history.pictures;
        let cracks = last.faces.iter().flatten().map(|[_, largest]| *largest);
        let first_crack = history.events.iter().find(|e| e.kind == EventKind::Crack);
        Demand {
            wave: largest(Scalar::Elevation).0,
            deflection,
            deflection_time,
            base_moment: history.peak.reaction.abs(),
            parts: history.peak.clone(),
            section_moment: largest(Scalar::SectionMoment).0,
            first_crack: first_crack.map(|e| FirstCrack {
                time: e.time,
                height: e.height,
                base_moment: e.base_moment.abs(),
            }),
            highest_crack: cells(|c| c.highest_crack),
            largest_crack: cracks.fold(0.0, f64::max),
            plastic_strain: cells(|c| c.plastic_strain),
            bar_stress: cells(|c| c.bar_stress),
            bar_plastic_strain: cells(|c| c.bar_plastic_strain),
            parting: Parting::first(&history.separation, history.openings.as_ref()),
            open: history.openings.as_ref().map(|o| o.open().iter().copied().fold(0.0, f64::max)),
            ranges: Scalar::ALL.map(|scalar| history.range(scalar)).to_vec(),
            departures: history.departures.clone(),
        }
    }

    /// The worse of two walls in every quantity; the first crack and the first parting are the earlier ones.
    pub fn worse(&self, other: &Demand) -> Demand {
        let (a, b) = (self, other);
        let first = earlier(a.first_crack, b.first_crack, |c| c.time);
        let larger = if a.deflection >= b.deflection { a } else { b };
        let stronger = if a.base_moment >= b.base_moment { a } else { b };
        Demand {
            wave: a.wave.max(b.wave),
            deflection: larger.deflection,
            deflection_time: larger.deflection_time,
            base_moment: stronger.base_moment,
            parts: stronger.parts.clone(),
            section_moment: a.section_moment.max(b.section_moment),
            first_crack: first,
            highest_crack: a.highest_crack.max(b.highest_crack),
            largest_crack: a.largest_crack.max(b.largest_crack),
            plastic_strain: a.plastic_strain.max(b.plastic_strain),
            bar_stress: a.bar_stress.max(b.bar_stress),
            bar_plastic_strain: a.bar_plastic_strain.max(b.bar_plastic_strain),
            parting: earlier(a.parting, b.parting, |p| p.time),
            open: a.open.zip(b.open).map(|(a, b)| a.max(b)).or(a.open).or(b.open),
            ranges: Vec::new(),
            departures: first_of(a.departures.iter().chain(&b.departures).cloned()),
        }
    }
}

/// The one that came first.
fn earlier<T>(a: Option<T>, b: Option<T>, time: impl Fn(&T) -> f64) -> Option<T> {
    match (a, b) {
        (Some(a), Some(b)) => Some(if time(&a) <= time(&b) { a } else { b }),
        (a, b) => a.or(b),
    }
}
