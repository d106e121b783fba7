//! What a nonlinear run of a strip is asked for, taken step by step.

use super::parting::PartingObserver;
use super::validity::{BarStrain, Departure, Validity, first_of};
use super::{BaseReaction, StripError, StripModel, lost};
use crate::analysis::checkpoint::{CheckpointError, Reader, Writer};
use crate::analysis::march::{Instant, Observe};
use crate::element::Inspect;
use crate::liquid::separation::Parting;
use crate::state::Gather;

/// A moment at the base and what it is made of [N].
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BaseMoment {
    /// Time [s].
    pub time: f64,
    /// The reaction, sum of the parts.
    pub reaction: f64,
    /// Stresses of the lowest element, extrapolated to the base.
    pub section: f64,
    /// Viscous damping.
    pub damping: f64,
    /// Inertia of the lowest element and dynamic pressure on it.
    pub inertia: f64,
    /// Pressure at rest that acts on the base itself.
    pub load: f64,
}

impl BaseMoment {
    /// The moments of a reaction at the time `time` [s].
    pub fn of(time: f64, reaction: &BaseReaction) -> BaseMoment {
        BaseMoment {
            time,
            reaction: reaction.total()[2],
            section: reaction.section[2],
            damping: reaction.damping[2],
            inertia: reaction.inertia[2],
            load: reaction.load[2],
        }
    }

    pub(super) fn array(&self) -> [f64; 6] {
        [
            self.time,
            self.reaction,
            self.section,
            self.damping,
            self.inertia,
            self.load,
        ]
    }

    pub(super) fn from_array([time, reaction, section, damping, inertia, load]: [f64; 6]) -> BaseMoment {
        BaseMoment {
            time,
            reaction,
            section,
            damping,
            inertia,
            load,
        }
    }
}

/// The first crack of a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FirstCrack {
    /// Time [s].
    pub time: f64,
    /// Height of the section [m].
    pub height: f64,
    /// Moment at the base then [N].
    pub base_moment: f64,
}

/// Largest values of a run, and what the wall has become.
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
    /// What that moment is made of.
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
    /// When the liquid first parts from the wall, or would; known at the end of a run.
    pub parting: Option<Parting>,
    /// Limits of the model that were passed, the first of each kind by time.
    pub departures: Vec<Departure>,
}

impl Demand {
    /// Takes in a committed step; returns the reaction at the base and the worst bar.
    ///
    /// Errors: those of the elements.
    fn see(&mut self, strip: &StripModel, now: &Instant<'_>) -> Result<(BaseReaction, BarStrain), StripError> {
        let (time, state) = (now.time, now.state);
        let u = &state.committed.u;
        self.wave = self.wave.max(strip.elevation(u).abs());
        let deflection = u[strip.top()].abs();
        if deflection > self.deflection {
            (self.deflection, self.deflection_time) = (deflection, time);
        }
        let reaction = strip.base_reaction(state, now.ground)?;
        let moment = reaction.total()[2].abs();
        if moment > self.base_moment {
            (self.base_moment, self.parts) = (moment, BaseMoment::of(time, &reaction));
        }
        self.section_moment = self.section_moment.max(strip.lowest_section(state)?[1].abs());
        let (mut gather, mut bar) = (Gather::default(), BarStrain::default());
        let beams = strip.model.elements().iter().zip(&strip.tank.sections).enumerate();
        for (e, (element, section)) in beams {
            let motion = gather.motion(&strip.model, &state.committed, &**element);
            element.material_points(motion, &state.old[state.history(e)], &mut |fibre| {
                if fibre.layer >= section.layers() {
                    bar.see(fibre);
                    self.bar_stress = self.bar_stress.max(fibre.stress[0].abs());
                    self.bar_plastic_strain = self.bar_plastic_strain.max(fibre.state.plastic_strain);
                    return;
                }
                self.plastic_strain = self.plastic_strain.max(fibre.state.plastic_strain);
                for crack in fibre.state.cracks.iter().flatten() {
                    let height = fibre.position[2];
                    self.highest_crack = self.highest_crack.max(height);
                    self.largest_crack = self.largest_crack.max(crack.largest);
                    self.first_crack.get_or_insert(FirstCrack {
                        time,
                        height,
                        base_moment: moment,
                    });
                }
            });
        }
        Ok((reaction, bar))
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
            parts: stronger.parts,
            section_moment: a.section_moment.max(b.section_moment),
            first_crack: first,
            highest_crack: a.highest_crack.max(b.highest_crack),
            largest_crack: a.largest_crack.max(b.largest_crack),
            plastic_strain: a.plastic_strain.max(b.plastic_strain),
            bar_stress: a.bar_stress.max(b.bar_stress),
            bar_plastic_strain: a.bar_plastic_strain.max(b.bar_plastic_strain),
            parting: earlier(a.parting, b.parting, |p| p.time),
            departures: first_of(&a.departures, &b.departures),
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

/// Observer that keeps the demand.
pub(super) struct DemandObserver<'a> {
    strip: &'a StripModel,
    demand: Demand,
    parting: PartingObserver,
    validity: Validity,
    failure: Option<StripError>,
}

impl<'a> DemandObserver<'a> {
    /// Of a wall of `strip`.
    pub(crate) fn new(strip: &'a StripModel) -> DemandObserver<'a> {
        DemandObserver {
            strip,
            demand: Demand::default(),
            parting: PartingObserver::new(strip),
            validity: Validity::default(),
            failure: None,
        }
    }

    /// What was seen.
    ///
    /// Errors: those of the elements while it was seen.
    pub(crate) fn finish(self) -> Result<Demand, StripError> {
        match self.failure {
            Some(failure) => Err(failure),
            None => Ok(Demand {
                parting: self.parting.first(),
                departures: self.validity.found().to_vec(),
                ..self.demand
            }),
        }
    }
}

impl Observe for DemandObserver<'_> {
    fn see(&mut self, now: &Instant<'_>) {
        match self.demand.see(self.strip, now) {
            Ok((reaction, bar)) => self.validity.see(self.strip, now, &reaction, bar),
            Err(error) => self.failure = self.failure.take().or(Some(error)),
        }
        self.parting.see(self.strip, now);
    }

    fn stop(&self) -> Option<String> {
        lost(self.demand.deflection, self.strip.height()).or(self.validity.stop())
    }

    fn save(&self, to: &mut Writer) {
        let d = &self.demand;
        to.numbers(&[
            d.wave,
            d.deflection,
            d.deflection_time,
            d.base_moment,
            d.highest_crack,
            d.largest_crack,
            d.plastic_strain,
            d.bar_stress,
            d.bar_plastic_strain,
            d.section_moment,
        ]);
        to.numbers(&d.parts.array());
        self.validity.save(to);
        let first = d.first_crack.map(|c| vec![c.time, c.height, c.base_moment]);
        to.numbers(&first.unwrap_or_default());
        self.parting.save(to);
    }

    fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        let mut values = [0.0; 10];
        from.numbers_into("demands", &mut values)?;
        let mut parts = [0.0; 6];
        from.numbers_into("parts of the moment", &mut parts)?;
        self.validity.restore(from)?;
        let first = from.numbers("the first crack")?;
        let [
            wave,
            deflection,
            deflection_time,
            base_moment,
            highest_crack,
            largest_crack,
            plastic_strain,
            bar_stress,
            bar_plastic_strain,
            section_moment,
        ] = values;
        self.demand = Demand {
            wave,
            deflection,
            deflection_time,
            base_moment,
            parts: BaseMoment::from_array(parts),
            section_moment,
            first_crack: match first[..] {
                [time, height, base_moment] => Some(FirstCrack {
                    time,
                    height,
                    base_moment,
                }),
                _ => None,
            },
            highest_crack,
            largest_crack,
            plastic_strain,
            bar_stress,
            bar_plastic_strain,
            parting: None,
            departures: Vec::new(),
        };
        self.parting.restore(from)
    }
}
