//! The observer that writes the history of a wall.

use fem::analysis::checkpoint::{CheckpointError, Reader, Writer};
use fem::analysis::march::{Instant, Observe, Range};
use fem::dofs::Dof;
use fem::element::Inspect;
use fem::liquid::separation::{Openings, SeparationCheck};
use fem::state::Gather;
use results::channel::Side;
use results::nonlinear::BaseMoment;

use super::{Cell, EventKind, Picture, Scalar, WallEvent, WallHistory, WallState};
use crate::strip::demand::base_moment;
use crate::strip::liquid::Place;
use crate::strip::model::{BaseReaction, StripModel};
use crate::strip::parameters::{StripError, lost};
use crate::strip::validity::{BarStrain, Validity};

impl StripModel {
    /// Unknowns of the liquid in `field`: those of its face, then the amplitudes.
    fn face_of(&self, field: &[f64]) -> Vec<f64> {
        let mut out: Vec<f64> = self.face_unknowns(field).collect();
        out.extend(self.amplitudes.iter().map(|&e| field[e]));
        out
    }

    /// The same of the accelerations, those of the face with the acceleration `ground` of the ground [m/s²].
    fn face_acceleration(&self, field: &[f64], ground: f64) -> Vec<f64> {
        let mut out = self.face_of(field);
        let each = self.tank.trace().unknowns();
        let face = out[..each * self.face.len()].iter_mut();
        face.step_by(each).for_each(|a| *a += ground);
        out
    }
}

/// Observer of a wall.
pub(in crate::strip) struct WallObserver<'a> {
    strip: &'a StripModel,
    side: Side,
    /// Of a condensed liquid: wet levels, then middles of wet elements.
    places: Vec<Place>,
    bottom: Vec<f64>,
    /// At rest: of a condensed liquid deflections and slopes of its face, then amplitudes; of elements pressures at the wet levels, then displacements
    /// upwards, and the moment of the bottom.
    rest: Vec<f64>,
    history: WallHistory,
    validity: Validity,
    until: f64,
    /// Time between states for pictures, and of the next one [s].
    drawn: Option<[f64; 2]>,
    failure: Option<StripError>,
}

impl<'a> WallObserver<'a> {
    /// Stops the run at the first step at or after `until` [s]; keeps a state every `states` [s].
    pub(crate) fn new(strip: &'a StripModel, side: Side, until: Option<f64>, states: Option<f64>) -> WallObserver<'a> {
        let (tank, liquid) = (&strip.tank, &strip.tank.liquid);
        let tolerance = 1e-9 * liquid.depth;
        let mut heights: Vec<f64> = tank.levels.to_vec();
        heights.retain(|z| *z <= liquid.depth + tolerance);
        let wet = heights.len();
        let middles = tank.levels.windows(2).map(|w| 0.5 * (w[0] + w[1]));
        heights.extend(middles.filter(|z| *z < liquid.depth));
        let seen = match &strip.joints {
            Some(joints) => &joints.heights[..],
            None => &heights[..wet],
        };
        // The foot stands on the ground.
        let openings = match (&strip.joints, &strip.chain) {
            (Some(joints), _) => Some(Openings::new(joints.heights.clone(), joints.shares.clone())),
            (_, Some(chain)) if chain.opens => {
                Some(Openings::new(chain.heights[1..].to_vec(), chain.shares[1..].to_vec()))
            }
            _ => None,
        };
        let condensed = strip.chain.is_none();
        let check = SeparationCheck::new(liquid.density * liquid.gravity, liquid.depth, heights[wet..].to_vec());
        WallObserver {
            places: match condensed {
                true => liquid.places(tank.trace(), strip.face_levels(), tank.sloshing, &heights),
                false => Vec::new(),
            },
            bottom: match condensed {
                true => liquid.bottom_moment(tank.trace(), strip.face_levels(), tank.sloshing),
                false => Vec::new(),
            },
            rest: Vec::new(),
            history: WallHistory {
                times: Vec::new(),
                samples: Vec::new(),
                scalars: vec![Vec::new(); Scalar::ALL.len()],
                deflection: vec![(0.0, Range::EMPTY); tank.levels.len()],
                pressure: seen.iter().map(|&z| (z, Range::EMPTY)).collect(),
                cells: vec![Cell::default(); tank.sections.len()],
                events: Vec::new(),
                pictures: Default::default(),
                separation: check,
                openings,
                peak: BaseMoment::default(),
                states: Vec::new(),
                departures: Vec::new(),
            },
            drawn: states.map(|every| [every, 0.0]),
            validity: Validity::default(),
            until: until.unwrap_or(f64::INFINITY),
            failure: None,
            strip,
            side,
        }
    }

    /// Whether the wall has moved too far or the run has left its model, and why that ends it.
    pub(crate) fn lost(&self) -> Option<String> {
        let last = self.history.scalar(Scalar::Deflection).last().copied();
        lost(last.unwrap_or(0.0), self.strip.height()).or(self.validity.stop())
    }

    /// The results so far.
    ///
    /// Errors: those of the elements while it was seen.
    pub(crate) fn finish(self) -> Result<WallHistory, StripError> {
        match self.failure {
            Some(failure) => Err(failure),
            None => Ok(WallHistory { departures: self.validity.found().to_vec(), ..self.history }),
        }
    }

    fn take(&mut self, now: &Instant<'_>) -> Result<(), StripError> {
        let (strip, wall) = (self.strip, self.strip.wall(self.side));
        let fields = &now.state.committed;
        let ground = wall.own(now.ground);
        let sight = self.sight(now);
        let start = self.history.times.is_empty();
        if start {
            self.rest.clone_from(&sight);
        }
        let [elevation, bottom] = self.of_liquid(now, &sight);
        let reaction = strip.base_reaction(wall, now.state, ground)?;
        let [shear, _, moment] = reaction.total();
        let base = strip.lowest_section(wall, now.state)?;
        let values = [
            elevation,
            fields.u[strip.top(wall)],
            shear,
            moment,
            bottom,
            base[1],
            base[0],
            reaction.section[2],
            reaction.damping[2],
            reaction.inertia[2],
            strip.largest_acceleration(wall, &fields.a, ground[0]).0,
        ];

        let history = &mut self.history;
        if moment.abs() > history.peak.reaction.abs() {
            history.peak = base_moment(now.time, &reaction);
        }
        if now.sample.is_some() {
            history.samples.push(history.times.len());
        }
        history.times.push(now.time);
        history.scalars.iter_mut().zip(values).for_each(|(h, v)| h.push(v));
        for (&node, (rest, range)) in wall.nodes.iter().zip(&mut history.deflection) {
            let deflection = strip.model.at_node(&fields.u, node)[Dof::Ux.index()];
            if start {
                *rest = deflection;
            }
            range.include(deflection, now.time);
        }
        self.see_pressures(now, &sight, elevation);
        self.inspect(now, &reaction);
        Ok(())
    }

    /// What is kept of the liquid at rest.
    fn sight(&self, now: &Instant<'_>) -> Vec<f64> {
        let (strip, fields) = (self.strip, &now.state.committed);
        let Some(chain) = &strip.chain else { return strip.face_of(&fields.u) };
        let levels = chain.look(strip, self.side as usize, now.state);
        let mut out: Vec<f64> = levels.iter().map(|level| level.touch.pressure).collect();
        out.extend(levels.iter().map(|level| level.rise));
        out.push(chain.bottom_moment(self.side as usize, fields, now.ground));
        out
    }

    /// Elevation of the surface at the wall, and moment of the dynamic pressure on the bottom.
    fn of_liquid(&self, now: &Instant<'_>, sight: &[f64]) -> [f64; 2] {
        let (strip, fields) = (self.strip, &now.state.committed);
        if strip.chain.is_none() {
            let acceleration = strip.face_acceleration(&fields.a, now.ground[0]);
            return [strip.elevation(&fields.u), dot(&self.bottom, &acceleration)];
        }
        let last = sight.len() - 1;
        [last - 1, last].map(|i| sight[i] - self.rest[i])
    }

    /// Takes in the dynamic pressures, and whether the liquid leaves the wall.
    fn see_pressures(&mut self, now: &Instant<'_>, sight: &[f64], elevation: f64) {
        let (strip, history, fields) = (self.strip, &mut self.history, &now.state.committed);
        if let Some(chain) = &strip.chain {
            let wet = history.pressure.len();
            let change = |i: usize| sight[i] - self.rest[i];
            for (i, (_, range)) in history.pressure.iter_mut().enumerate() {
                range.include(change(i), now.time);
            }
            if let Some(openings) = &mut history.openings {
                let levels = chain.look(strip, self.side as usize, now.state);
                openings.see(now.time, levels[1..].iter().map(|l| (l.touch.gap, l.touch.penetration)));
                return;
            }
            let middle = |i: usize| 0.5 * (change(i) + change(i + 1));
            history.separation.see(now.time, middle, |i| middle(wet + i), elevation);
            return;
        }
        if let (Some(joints), Some(openings)) = (&strip.joints, &mut history.openings) {
            let touches = joints.look(&strip.model, now.state);
            let own = touches.iter().zip(&joints.at_rest);
            for ((touch, at_rest), (_, range)) in own.zip(&mut history.pressure) {
                range.include(touch.pressure - at_rest, now.time);
            }
            openings.see(now.time, touches.iter().map(|t| (t.gap, t.penetration)));
            return;
        }
        let acceleration = strip.face_acceleration(&fields.a, now.ground[0]);
        let moved: Vec<f64> = sight.iter().zip(&self.rest).map(|(u, r)| u - r).collect();
        let liquid = &strip.tank.liquid;
        let pressure = |place: &Place| {
            let depth = (liquid.depth - place.height).max(0.0);
            dot(&place.pressure, &acceleration) + liquid.density * now.ground[2] * depth
        };
        let wet = history.pressure.len();
        for (place, (_, range)) in self.places.iter().zip(&mut history.pressure) {
            range.include(pressure(place), now.time);
        }
        let middles = &self.places[wet..];
        history.separation.see(now.time, |i| pressure(&middles[i]), |i| dot(&middles[i].rise, &moved), elevation);
    }

    /// Keeps a state where one is due.
    fn draw(&mut self, now: &Instant<'_>) {
        let Some([every, next]) = &mut self.drawn else { return };
        if now.time < *next * (1.0 - 1e-9) {
            return;
        }
        while *next <= now.time * (1.0 + 1e-9) {
            *next += *every;
        }
        let (strip, u) = (self.strip, &now.state.committed.u);
        let at = |&node: &usize| {
            let own = strip.model.at_node(u, node);
            [Dof::Ux, Dof::Uz].map(|dof| own[dof.index()])
        };
        let [wet, dry] = &self.history.pictures[1].faces;
        let cracks = wet.iter().zip(dry).map(|(a, b)| a[0].max(b[0])).collect();
        self.history.states.push(WallState {
            time: now.time,
            displacement: strip.wall(self.side).nodes.iter().map(at).collect(),
            surface: strip.surface(self.side, u),
            cracks,
        });
    }

    /// Looks at every fibre.
    fn inspect(&mut self, now: &Instant<'_>, reaction: &BaseReaction) {
        let (strip, moment) = (self.strip, reaction.total()[2]);
        let mut bar = BarStrain::default();
        let mut gather = Gather::default();
        let mut faces = [Vec::new(), Vec::new()];
        let mut seen: [Option<(f64, f64)>; EventKind::ALL.len()] = [None; EventKind::ALL.len()];
        let wall = strip.wall(self.side);
        for (e, (number, section)) in wall.elements.clone().zip(&strip.tank.sections).enumerate() {
            let element = &strip.model.elements()[number];
            let motion = gather.motion(&strip.model, &now.state.committed, &**element);
            let (mut cell, mut widest) = (Cell::default(), [[0.0_f64; 2]; 2]);
            let (mut point, mut cracked) = (usize::MAX, 0);
            let shells = strip.tank.shells.as_ref();
            let layers = shells.map_or(section.layers(), |s| s.rows[e].layers);
            element.material_points(motion, &now.state.old[now.state.history(number)], &mut |fibre| {
                if shells.is_some_and(|s| !s.bends(fibre.point)) {
                    return;
                }
                let state = &fibre.state;
                let mut first = |kind: EventKind| {
                    seen[kind as usize].get_or_insert((fibre.position[2], fibre.depth));
                };
                if fibre.point != point {
                    (point, cracked) = (fibre.point, 0);
                }
                if fibre.layer >= layers {
                    bar.see(fibre);
                    cell.bar_stress = cell.bar_stress.max(fibre.stress[0].abs());
                    cell.bar_plastic_strain = cell.bar_plastic_strain.max(state.plastic_strain);
                    if state.plastic_strain > 0.0 {
                        first(EventKind::BarYield);
                    }
                    if state.damage > 0.0 || state.rupture > 1.0 {
                        first(EventKind::BarRupture);
                    }
                    return;
                }
                cell.utilisation = cell.utilisation.max(state.utilisation);
                cell.plastic_strain = cell.plastic_strain.max(state.plastic_strain);
                if state.plastic_strain > 0.0 {
                    first(EventKind::Yield);
                }
                for crack in state.cracks.iter().flatten() {
                    first(EventKind::Crack);
                    cell.highest_crack = cell.highest_crack.max(fibre.position[2]);
                    let [open, largest] = &mut widest[usize::from(fibre.depth > 0.0)];
                    (*open, *largest) = (open.max(crack.opening), largest.max(crack.largest));
                }
                cracked += u32::from(state.cracks.iter().flatten().next().is_some());
                cell.cracked = cell.cracked.max(f64::from(cracked) / layers as f64);
            });
            self.history.cells[e].include(&cell);
            faces.iter_mut().zip(widest).for_each(|(face, w)| face.push(w));
        }
        self.validity.see((strip, wall), now, reaction, bar);
        for (kind, place) in EventKind::ALL.into_iter().zip(seen) {
            let events = &mut self.history.events;
            if let Some((height, depth)) = place
                && events.iter().all(|e| e.kind != kind)
            {
                events.push(WallEvent { kind, time: now.time, height, depth, base_moment: moment });
            }
        }
        let [worst, last] = &mut self.history.pictures;
        *last = Picture { time: now.time, base_moment: moment, faces };
        if worst.faces[0].is_empty() || moment.abs() > worst.base_moment.abs() {
            worst.clone_from(last);
        }
    }
}

fn dot(row: &[f64], x: &[f64]) -> f64 {
    row.iter().zip(x).map(|(a, b)| a * b).sum()
}

impl Observe for WallObserver<'_> {
    fn see(&mut self, now: &Instant<'_>) {
        if self.failure.is_none() {
            self.failure = self.take(now).err();
            self.draw(now);
        }
    }

    fn stop(&self) -> Option<String> {
        let last = self.history.times.last().copied().unwrap_or(0.0);
        let other = (last >= self.until).then(|| "the other wall has collapsed".into());
        self.lost().or(other)
    }

    fn save(&self, to: &mut Writer) {
        let h = &self.history;
        to.numbers(&self.rest);
        to.numbers(&h.times);
        to.numbers(&h.samples.iter().map(|&i| i as f64).collect::<Vec<_>>());
        h.scalars.iter().for_each(|s| to.numbers(s));
        let ranges = h.deflection.iter().chain(&h.pressure);
        to.numbers(&ranges.flat_map(|(x, r)| [*x, r.min, r.min_time, r.max, r.max_time]).collect::<Vec<_>>());
        to.numbers(&h.cells.iter().flat_map(Cell::array).collect::<Vec<_>>());
        let event = |e: &WallEvent| [e.kind as usize as f64, e.time, e.height, e.depth, e.base_moment];
        to.numbers(&h.events.iter().flat_map(event).collect::<Vec<_>>());
        for picture in &h.pictures {
            to.numbers(&[picture.time, picture.base_moment]);
            for face in &picture.faces {
                to.numbers(&face.iter().flatten().copied().collect::<Vec<_>>());
            }
        }
        let peak = &h.peak;
        to.numbers(&[peak.time, peak.reaction, peak.section, peak.damping, peak.inertia, peak.load]);
        self.validity.save(to);
        h.separation.save(to);
        if let Some(openings) = &h.openings {
            openings.save(to);
        }
        let Some([_, next]) = self.drawn else { return };
        to.number(next);
        to.count(h.states.len());
        for state in &h.states {
            to.number(state.time);
            to.numbers(state.displacement.as_flattened());
            to.numbers(&state.surface);
            to.numbers(&state.cracks);
        }
    }

    fn restore(&mut self, from: &mut Reader) -> Result<(), CheckpointError> {
        let h = &mut self.history;
        self.rest = from.numbers("the state at rest")?;
        h.times = from.numbers("times")?;
        h.samples = from.numbers("samples")?.into_iter().map(|i| i as usize).collect();
        for scalar in &mut h.scalars {
            scalar.resize(h.times.len(), 0.0);
            from.numbers_into("a history", scalar)?;
        }
        let count = h.deflection.len() + h.pressure.len();
        let mut ranges = vec![0.0; 5 * count];
        from.numbers_into("ranges", &mut ranges)?;
        for ((x, range), r) in h.deflection.iter_mut().chain(&mut h.pressure).zip(ranges.chunks_exact(5)) {
            *x = r[0];
            *range = Range { min: r[1], min_time: r[2], max: r[3], max_time: r[4] };
        }
        let mut cells = vec![0.0; Cell::COUNT * h.cells.len()];
        from.numbers_into("cells", &mut cells)?;
        h.cells = cells.chunks_exact(Cell::COUNT).map(Cell::of).collect();
        let events = from.numbers("events")?;
        let kind = |k: f64| EventKind::ALL.into_iter().find(|e| *e as usize as f64 == k);
        let event =
            |e: &[f64]| Some(WallEvent { kind: kind(e[0])?, time: e[1], height: e[2], depth: e[3], base_moment: e[4] });
        h.events = events.chunks_exact(5).filter_map(event).collect();
        for picture in &mut h.pictures {
            let mut head = [0.0; 2];
            from.numbers_into("a picture", &mut head)?;
            [picture.time, picture.base_moment] = head;
            for face in &mut picture.faces {
                let cracks = from.numbers("cracks")?;
                *face = cracks.chunks_exact(2).map(|c| [c[0], c[1]]).collect();
            }
        }
        let mut peak = [0.0; 6];
        from.numbers_into("parts of the moment", &mut peak)?;
        let [time, reaction, section, damping, inertia, load] = peak;
        h.peak = BaseMoment { time, reaction, section, damping, inertia, load, ..BaseMoment::default() };
        self.validity.restore(from)?;
        h.separation.restore(from)?;
        if let Some(openings) = &mut h.openings {
            openings.restore(from)?;
        }
        let Some([_, next]) = &mut self.drawn else { return Ok(()) };
        *next = from.number()?;
        h.states.clear();
        for _ in 0..from.count()? {
            h.states.push(WallState {
                time: from.number()?,
                displacement: from.numbers("displacements of a picture")?.as_chunks::<2>().0.to_vec(),
                surface: from.numbers("the surface of a picture")?,
                cracks: from.numbers("cracks of a picture")?,
            });
        }
        Ok(())
    }
}
