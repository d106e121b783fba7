//! Limits of validity of the linear engine, tested on a run.

use tank::Case;
use tank::large_wave::LargeWave;
use tank::units::{Dimension, display};
use tank::{PLANE_WALLS, Shape, Support};

use super::analysis::Analysis;
use super::around::Around;
use super::model::Model;
use super::system::Harmonic;
use crate::modes::Kind;
use crate::response::observe::Extreme;
use results::channel::{OnWall, Side};
use results::{Channel, EngineId, Limit};

/// Compressibility matters where the bulging frequency exceeds this share of the acoustic one.
const ACOUSTIC_SHARE: f64 = 0.3;
/// Steps of a record that should lie in a period it excites: linear interpolation then damps the motion there by 3 %
/// (the square of sin(π/10)/(π/10)).
const RECORD_STEPS: f64 = 10.0;

/// Id of the tension at the base of the wall.
pub(crate) const UPLIFT: &str = "uplift_tension";

/// All limits of a run.
///
/// * `around`: with two horizontal components, what both together do
/// * `nonlinear`: crest and trough of a nonlinear liquid, where they count [m]
/// * `record_step`: step of the record [s]
/// * `engine`: the walls of a box are cantilevers in the harmonic engine alone
pub(crate) fn limits(
    case: &Case,
    model: &Model,
    (analysis, around): (&Analysis, Option<&Around>),
    nonlinear: Option<[f64; 2]>,
    (record_step, engine): (f64, EngineId),
) -> Vec<Limit> {
    let mut found = Vec::new();
    let resultant = around.and_then(|a| a.wave).map(|peak| peak.value);
    if let Some(wave) = resultant.or(analysis.wave()) {
        found.extend(waves(case, wave, nonlinear));
    }
    found.extend(suction(case, model, analysis, around));
    found.extend(uplift(case, model, analysis, around));
    if engine == EngineId::Harmonic {
        found.extend(breadth(case));
    }
    let structural = |h: &Harmonic| h.first(Kind::Structural).map(|m| m.omega);
    let fastest = model.systems().filter_map(structural).fold(0.0, f64::max);
    found.push(compressibility(case, fastest / std::f64::consts::TAU));
    let impulsive = model.horizontal.impulsive();
    found.extend(impulsive.map(|found| record(found.dominant.omega, record_step)));
    found
}

/// Wave height against that of small waves, and its crest against the freeboard.
///
/// * `nonlinear`: crest and trough of a nonlinear liquid, where they count [m]
pub(crate) fn waves(case: &Case, wave: f64, nonlinear: Option<[f64; 2]>) -> [Limit; 2] {
    let large = LargeWave::of(case);
    let [crest, trough] = nonlinear.unwrap_or([large.crest(wave), large.trough(wave)]);
    let least = if nonlinear.is_none() && large.excess(wave) > large.fitted() { "at least " } else { "" };
    [
        limit_of(
            "wave_against_radius",
            "Wave height against that of small waves, whose crest is a tenth higher",
            [wave, large.small()],
            Dimension::Length,
            wave <= large.small(),
            || {
                let [high, low] = [crest, trough].map(|value| display(value, Dimension::Length));
                format!("The waves are not small: the crest is {least}{high}, the trough {low}.")
            },
        ),
        limit_of(
            "wave_against_freeboard",
            "Crest of the wave against the freeboard",
            [crest, case.freeboard()],
            Dimension::Length,
            crest <= case.freeboard(),
            || "The liquid overtops the wall or strikes the roof; neither is modelled.".into(),
        ),
    ]
}

/// Breadth of a box against that from which its walls are cantilevers.
fn breadth(case: &Case) -> Option<Limit> {
    let ratio = case.tank.breadth_to_height()?;
    let name = format!("Breadth over the height of the wall against {PLANE_WALLS:.0}");
    let holds = !case.tank.bends_as_plates();
    Some(limit_of("breadth_against_height", name, [ratio, PLANE_WALLS], Dimension::Dimensionless, holds, || {
        "The walls across the shaking bend as plates held at the base and both sides; the engine computes \
         cantilevers: impulsive period and mass, forces and stresses are outside the model, the wave is not."
            .into()
    }))
}

/// Total pressure below the trough: above it the wall is simply dry when the surface sinks.
fn suction(case: &Case, model: &Model, analysis: &Analysis, around: Option<&Around>) -> Option<Limit> {
    let line = model.horizontal.coupled.line(OnWall::Pressure)?;
    let extremes = analysis.line(OnWall::Pressure)?;
    let fall = |(front, back): (Extreme, Extreme)| -front.min.min(back.min);
    let trough = case.liquid.fill_height - analysis.sides(Channel::Wave(Side::Front)).map_or(0.0, fall);
    let mut worst: Option<(f64, f64, f64, String)> = None;
    // The base is tested even if linear waves fall below it.
    for (i, &z) in line.z.iter().enumerate().filter(|(i, z)| *i == 0 || **z < trough) {
        let sides = [("0°", &extremes.front[i]), ("180°", &extremes.back[i])];
        let along = sides.map(|(side, extreme)| (extreme.min, extreme.min_time, side.to_owned()));
        let both = around.and_then(|a| a.suction.get(i)).map(|p| (p.value, p.time, degrees(p.theta)));
        for (least, time, side) in along.into_iter().chain(both) {
            let total = line.probes[i].static_value + least;
            if worst.as_ref().is_none_or(|w| total < w.0) {
                worst = Some((total, z, time, side));
            }
        }
    }
    let (total, z, time, side) = worst?;
    let name = "Smallest total pressure on the wall below the wave trough";
    Some(limit_of("suction", name, [total, 0.0], Dimension::Stress, total >= 0.0, || {
        let place = match (case.tank.shape, side.as_str()) {
            (Shape::Rectangle { .. }, "0°") => "wall at +x".to_owned(),
            (Shape::Rectangle { .. }, _) => "wall at −x".to_owned(),
            _ => format!("θ = {side}"),
        };
        format!(
            "Suction at z = {}, {place}, t = {time:.2} s: the liquid separates from the wall, which the linear \
             engine does not model.",
            display(z, Dimension::Length)
        )
    }))
}

/// Tension at the base of an anchored cylinder's wall, static and seismic, against its anchors.
fn uplift(case: &Case, model: &Model, analysis: &Analysis, around: Option<&Around>) -> Option<Limit> {
    let Shape::Cylinder { radius } = case.tank.shape else { return None };
    let channel = Channel::Base(OnWall::Axial);
    let probe = model.horizontal.coupled.probe(channel)?;
    let (front, back) = analysis.sides(channel)?;
    let (rise, time, side) = match around.and_then(|a| a.axial) {
        Some(peak) => (peak.value, peak.time, degrees(peak.theta)),
        None if front.max >= back.max => (front.max, front.max_time, "0°".to_owned()),
        None => (back.max, back.max_time, "180°".to_owned()),
    };
    let tension = (probe.static_value + rise) * case.tank.course_at(0.0).thickness;
    let capacity = case.tank.anchors.and_then(|a| {
        let spacing = std::f64::consts::TAU * radius / f64::from(a.count.max(1));
        a.capacity.map(|c| c / spacing)
    });
    let limit = capacity.unwrap_or(0.0);
    let place = format!("at θ = {side}, t = {time:.2} s");
    let name = match capacity {
        Some(_) => "Tension at the base of the wall against the anchors",
        None => "Tension at the base of the wall",
    };
    Some(limit_of(UPLIFT, name, [tension, limit], Dimension::LineForce, tension <= limit, || {
        match (capacity, case.tank.support) {
            (_, Support::Unanchored) => format!(
                "The wall lifts off {place}: an unanchored tank uplifts, which the linear engine does not model."
            ),
            (None, _) => format!(
                "The wall pulls {place}; the linear engine holds it down. Give the capacity of the anchors to have it checked."
            ),
            (Some(_), _) => format!("The anchors are overstressed {place}: the wall lifts off."),
        }
    }))
}

/// Largest tension of the foot of a wall that is held down, static and seismic [N/m]; none of a wall without that stress.
pub(super) fn pull(case: &Case, model: &Model, analysis: &Analysis) -> Option<f64> {
    let channel = Channel::Base(OnWall::Axial);
    let rest = model.horizontal.coupled.probe(channel)?.static_value;
    let (front, back) = analysis.sides(channel)?;
    Some((rest + front.max.max(back.max)) * case.tank.course_at(0.0).thickness)
}

/// An angle [rad] in words.
fn degrees(theta: f64) -> String {
    format!("{:.0}°", theta.to_degrees())
}

/// First frequency of wall and liquid [Hz] against the acoustic one.
pub(crate) fn compressibility(case: &Case, fastest: f64) -> Limit {
    let sound = case.liquid.sound();
    let limit = ACOUSTIC_SHARE * sound / (4.0 * case.liquid.fill_height);
    let name =
        format!("First frequency of wall and liquid against 0.3 of the acoustic frequency c/(4H), c = {sound:.0} m/s");
    limit_of("compressibility", name, [fastest, limit], Dimension::Frequency, fastest <= limit, || {
        "The compressibility of the liquid is left out; it lowers such high frequencies by about half the square of \
         the quotient of both."
            .into()
    })
}

/// Step of the record [s] against the period of the wall's mode, whose circular frequency is `omega` [rad/s].
pub(crate) fn record(omega: f64, record_step: f64) -> Limit {
    let limit = std::f64::consts::TAU / omega / RECORD_STEPS;
    let name = "Time step of the record against a tenth of the impulsive period";
    limit_of("record_step", name, [record_step, limit], Dimension::Time, record_step <= limit, || {
        "The record holds little of the motion that excites the wall's mode, and straight lines between its samples \
         damp that part further: the impulsive response is as good as the record there."
            .into()
    })
}

/// A limit of validity; `note` says what follows where it does not hold.
pub(crate) fn limit_of(
    id: &str,
    name: impl Into<String>,
    [value, limit]: [f64; 2],
    dimension: Dimension,
    holds: bool,
    note: impl FnOnce() -> String,
) -> Limit {
    let note = if holds { String::new() } else { note() };
    Limit { id: id.into(), name: name.into(), value, limit, dimension, holds, note }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::test_tanks;

    /// 5 m of breadth and 100 m of breadth over walls 4 m high; a strip and a cylinder have no breadth.
    #[test]
    fn a_narrow_box_exceeds_its_limit() {
        let found = |shape: Shape| {
            let case = test_tanks::case(shape, &[(4.0, 0.3)], (30e9, 0.2, 2500.0), (1000.0, 3.0));
            breadth(&case).map(|limit| (limit.holds, limit.value, limit.note.is_empty()))
        };
        let of = |breadth: f64, strip: bool| Shape::Rectangle { length: 5.0, breadth, strip };
        assert_eq!(found(of(5.0, false)), Some((false, 1.25, false)));
        assert_eq!(found(of(100.0, false)), Some((true, 25.0, true)));
        assert_eq!(found(of(1.0, true)), None);
        assert_eq!(found(Shape::Cylinder { radius: 5.0 }), None);
    }
}
