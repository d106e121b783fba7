//! A base under a moment: how far it turns, and what its rim does there.
//!
//! The curve of a strip is drawn only as far as the answer needs it. Its states stand at places that do not depend on how far that is:
//! close where the rim leaves the ground, then in steps that grow with the distance from it. What lies between the last two states on
//! either side is not used, as slopes there would change with the next state. So an answer depends on what was asked before by rounding only.

use std::cell::{Cell, RefCell};

use crate::curve::Curve;
use crate::error::BaseError;
use crate::foot::{Foot, places};
use crate::march::Point;
use crate::march::{Lifted, Shape};
use crate::model::Base;
use crate::rocking::{Turn, plane_section_by, turned};
use crate::strip::Strip;

/// Steps of the rim as shares of its distance from the ground without load, and from rest to there.
const STEPS: (f64, f64) = (0.4, 1.0 / 6.0);
/// Panels of three Gauss points on the lifted arc, and as many on the rest: a quarter of those of a curve M(ψ), which changes the moment
/// by less than 0.1 %.
const PANELS: usize = 12;
/// The same from the lifted side to the toe of a foot that warps.
const WARPED: usize = 24;
/// Largest uplift in radii: beyond it the plate's rotations are not small.
const LIFT: f64 = 0.2;

/// A base in equilibrium.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// The whole of it.
    pub turn: Turn,
    /// The strip at the lifted side.
    pub rim: Point,
}

/// A point of the plate of a lifted strip.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlatePoint {
    /// Distance inwards from the rim [m]; negative outside the wall.
    pub distance: f64,
    /// Deflection, upwards [m].
    pub deflection: f64,
    /// Pressure of the ground [Pa].
    pub pressure: f64,
    /// Whether the plate has yielded from here to the next point outwards.
    pub yielded: bool,
}

/// A curve and where it starts.
#[derive(Clone, Debug)]
struct Kept {
    curve: Curve,
    /// The plate in each state of the curve.
    shapes: Vec<Shape>,
    /// Uplift at rest [m].
    rest: f64,
    /// The strip at the lower and the upper end: displacements and plastic strains; none after a step that failed.
    ends: [Option<(Vec<f64>, Vec<f64>)>; 2],
}

/// Curves of a base on one ground, kept as far as they were drawn.
#[derive(Clone, Debug)]
pub struct Stands {
    base: Base,
    /// Pressure on the plate [Pa] and the curve under it.
    curves: Vec<(f64, Kept)>,
}

impl Stands {
    /// Curves of a base, none drawn yet.
    pub fn of(base: Base) -> Stands {
        Stands { base, curves: Vec::new() }
    }

    /// The base.
    pub fn base(&self) -> &Base {
        &self.base
    }

    /// Under a moment [N m]; none where the base does not hold it up to a rotation of 0.1 rad.
    ///
    /// * `weight` w_t that holds the wall down [N/m]
    /// * `suction` at the lifted side [Pa]: the plate carries p − p_b cos φ there, and p as at rest on the other side
    pub fn under(&mut self, moment: f64, weight: f64, suction: f64) -> Option<Stand> {
        self.found(weight, suction, &|turn| turn.moment - moment, 1e-10 * moment.abs())
    }

    /// Where the rim leaves the ground.
    ///
    /// * `weight` w_t that holds the wall down [N/m]
    pub fn leaving(&mut self, weight: f64) -> Option<Stand> {
        self.found(weight, 0.0, &|turn| turn.uplift, 1e-9)
    }

    /// At rotations [rad]; those without equilibrium are left out.
    ///
    /// * `weight` w_t that holds the wall down [N/m]
    pub fn at(&mut self, rotations: &[f64], weight: f64) -> Vec<Turn> {
        let base = self.base.clone();
        let turns = self.with(0.0, |drawn| {
            let turn = |rotation: &f64| grown(drawn, &base, weight, *rotation, None).ok();
            Some(rotations.iter().filter_map(turn).collect())
        });
        turns.unwrap_or_default()
    }

    /// The plate where the rim is lifted by `uplift` [m], from the centre outwards; linear between the states of the curve, none beyond them.
    pub fn plate(&mut self, uplift: f64) -> Option<Vec<PlatePoint>> {
        let (rim, modulus) = (self.base.radius, self.base.modulus);
        self.with(0.0, |drawn| {
            let drawn = drawn.borrow();
            let first = drawn.first()?;
            let points = first.kept.curve.points();
            let after = points.partition_point(|p| p.uplift < uplift);
            let (low, high) = (points.get(after.checked_sub(1)?)?, points.get(after)?);
            let t = (uplift - low.uplift) / (high.uplift - low.uplift);
            let (from, to) = (&first.kept.shapes[after - 1], &first.kept.shapes[after]);
            let plate = first.strip.nodes.iter().enumerate().map(|(i, node)| {
                let deflection = from.deflections[i] + t * (to.deflections[i] - from.deflections[i]);
                PlatePoint {
                    distance: rim - node,
                    deflection,
                    pressure: modulus * (-deflection).max(0.0),
                    yielded: to.yielded.get(i).copied().unwrap_or(false),
                }
            });
            Some(plate.collect())
        })
    }

    fn found(&mut self, weight: f64, suction: f64, goal: &dyn Fn(&Turn) -> f64, settled: f64) -> Option<Stand> {
        let base = self.base.clone();
        self.with(suction, |drawn| {
            let last = Cell::new(None);
            let at = |rotation| {
                let turn = grown(drawn, &base, weight, rotation, last.get().as_ref())?;
                last.set(Some(turn));
                Ok(turn)
            };
            let turn = turned(&at, goal, settled)?;
            let rim = drawn.borrow().last()?.kept.curve.at(turn.uplift);
            Some(Stand { turn, rim })
        })
    }

    /// An answer from the curves at rest and, with suction, under that; what it makes them grow is kept.
    fn with<T>(&mut self, suction: f64, question: impl FnOnce(&RefCell<Vec<Drawn>>) -> Option<T>) -> Option<T> {
        let base = &self.base;
        let mut pressures = vec![base.pressure];
        if suction > 0.0 {
            pressures.push(base.pressure - suction);
        }
        let strips: Vec<Strip> = pressures.iter().map(|p| base.coarse_strip(*p)).collect::<Result<_, _>>().ok()?;
        let mut drawn = Vec::with_capacity(strips.len());
        for strip in &strips {
            let kept = self.curves.iter().find(|(own, _)| *own == strip.pressure());
            drawn.push(Drawn::of(strip, base.weight, kept.map(|(_, kept)| kept.clone())).ok()?);
        }
        let drawn = RefCell::new(drawn);
        let answer = question(&drawn);
        let curves = drawn.into_inner().into_iter().map(Drawn::keep).collect::<Vec<_>>();
        for (pressure, kept) in curves {
            self.curves.retain(|(own, _)| *own != pressure);
            self.curves.push((pressure, kept));
        }
        answer
    }
}

/// The base at a rotation, on curves that grow until they hold it: that at rest, and where there is one that under suction.
///
/// * `last`: a turn that is close to it
fn grown(
    drawn: &RefCell<Vec<Drawn>>,
    base: &Base,
    weight: f64,
    rotation: f64,
    last: Option<&Turn>,
) -> Result<Turn, BaseError> {
    let radius = base.radius;
    loop {
        let tried = {
            let curves = drawn.borrow();
            let from = curves.iter().map(|d| d.range().0).fold(f64::NEG_INFINITY, f64::max);
            let to = curves.iter().map(|d| d.range().1).fold(f64::INFINITY, f64::min);
            let hold = |w: f64, cos: f64| {
                let rest = curves[0].kept.curve.hold(w);
                match curves.get(1) {
                    Some(low) if cos > 0.0 => {
                        let low = low.kept.curve.hold(w);
                        [0, 1].map(|i| rest[i] + cos * (low[i] - rest[i]))
                    }
                    _ => rest,
                }
            };
            let force = |w: f64, cos: f64| hold(w, cos)[0];
            let plane = || plane_section_by(PANELS, radius, weight, (from, to), rotation, &force);
            match &base.warping {
                Some(warping) => {
                    // The pressures of the codes stand still on the wall.
                    let wall = warping.under(0.0);
                    let foot = Foot { radius, weight, wall, places: places(WARPED), strips: &hold };
                    let near = last.map(|turn| foot.at(rotation, turn, (from, to)));
                    match near {
                        Some(Ok(turn)) => Ok(turn),
                        Some(Err(beyond @ BaseError::BeyondCurve { .. })) => Err(beyond),
                        _ => plane().and_then(|plane| foot.at(rotation, &plane, (from, to))),
                    }
                }
                None => plane(),
            }
        };
        let Err(BaseError::BeyondCurve { wanted, from, to, .. }) = tried else { return tried };
        let up = wanted > 0.5 * (from + to);
        if up && to > LIFT * radius {
            return tried;
        }
        for curve in drawn.borrow_mut().iter_mut() {
            let (low, high) = curve.range();
            if (up && high <= to) || (!up && low >= from) {
                curve.grow(up)?;
            }
        }
    }
}

/// A curve that grows.
struct Drawn<'a> {
    strip: &'a Strip,
    /// Weight under which the strip rests [N/m].
    weight: f64,
    kept: Kept,
    /// The strip at the lower and the upper end, once it is there.
    ends: [Option<Lifted<'a>>; 2],
}

impl<'a> Drawn<'a> {
    fn of(strip: &'a Strip, weight: f64, kept: Option<Kept>) -> Result<Drawn<'a>, BaseError> {
        if let Some(mut kept) = kept {
            let ends = std::mem::take(&mut kept.ends).map(|end| end.map(|parts| Lifted::of_parts(strip, parts)));
            return Ok(Drawn { strip, weight, kept, ends });
        }
        let rest = Lifted::at_rest(strip, weight)?;
        let mut drawn = Drawn {
            strip,
            weight,
            kept: Kept {
                curve: Curve::through(vec![rest.point()]),
                shapes: vec![rest.shape()],
                rest: rest.uplift(),
                ends: [None, None],
            },
            ends: [Some(rest.clone()), Some(rest)],
        };
        for up in [false, true, false, true] {
            drawn.grow(up)?;
        }
        Ok(drawn)
    }

    /// Pressure on the plate [Pa], and the curve with its ends.
    fn keep(self) -> (f64, Kept) {
        let ends = self.ends.map(|end| end.map(Lifted::into_parts));
        (self.strip.pressure(), Kept { ends, ..self.kept })
    }

    /// Without the outermost steps.
    fn range(&self) -> (f64, f64) {
        let points = self.kept.curve.points();
        (points[1].uplift, points[points.len() - 2].uplift)
    }

    /// One step further.
    fn grow(&mut self, up: bool) -> Result<(), BaseError> {
        let mut points = self.kept.curve.points().to_vec();
        let mut state = match self.ends[usize::from(up)].take() {
            Some(state) => state,
            None => self.again(&points, up)?,
        };
        let end = state.uplift();
        let least = (STEPS.1 * self.kept.rest.abs()).max(1e-3 * self.strip.thickness());
        let step = least.max(STEPS.0 * end.abs());
        state.lift_to(if up { end + step } else { end - step })?;
        let place = if up { points.len() } else { 0 };
        points.insert(place, state.point());
        self.kept.shapes.insert(place, state.shape());
        self.kept.curve = Curve::through(points);
        self.ends[usize::from(up)] = Some(state);
        Ok(())
    }

    /// The end of a curve that was kept, over its states: a plate that yields remembers its way.
    fn again(&self, points: &[Point], up: bool) -> Result<Lifted<'a>, BaseError> {
        let mut state = Lifted::at_rest(self.strip, self.weight)?;
        let rest = self.kept.rest;
        let mut way: Vec<f64> =
            points.iter().map(|p| p.uplift).filter(|w| if up { *w > rest } else { *w < rest }).collect();
        if !up {
            way.reverse();
        }
        for uplift in way {
            state.lift_to(uplift)?;
        }
        Ok(state)
    }
}

#[cfg(test)]
mod tests;
