//! C8: the strip whose joint of liquid and wall may open, in the march of nonlinear walls.
//!
//! Source:    dissertation 8.4, table 8.15; theory sheet of this project
//! Model:     elastic fibre walls, clamped; liquid condensed onto a separate face, linear between levels; a joint at each level
//! Expected:  * closed, the strip without joint
//!            * with the trapezoidal rule the march is Moreau's scheme, which [`crate::moreau`] solves on dense matrices
//!              by trial of sets: the same histories to rounding
//!            * other spectral radii and steps: for comparison, since impacts do not converge
//! Tolerance: (1/14)² at rest and 5·10⁻³ in motion for the face of 14 elements and the penalty; 10⁻⁴ between the two solvers in the first tenth
//!            of a second after the first opening

use oscillator::record::Record;

use super::{elastic_section, tank};
use crate::moreau::{Joint, Jointed, Opening};
use crate::{Answer, Reference, Row};
use engines::strip::{Contact, Scalar, Side, StripDamping, StripError, StripModel, StripQuake, WallHistory};
use fem::analysis::damping::Rayleigh;
use fem::analysis::newton::Options;
use fem::analysis::scheme::TimeScheme;
use fem::element::fibre_beam;
use fem::linalg::Matrix;
use fem::progress::Silent;

/// Step [s].
const STEP: f64 = 1.25e-3;

/// Time after the first opening in which two solvers are compared [s]: a difference grows at every touch, from the last digit to
/// per cents in a second of hard impacts.
const TOUCHES: f64 = 0.1;

/// k_n [N/m³] of the comparison with trials of sets, which cycle for ever on stiffer joints.
const SOFT: f64 = 1e9;

/// Elastic strip with the Rayleigh damping of table 8.15's linear result.
fn model(contact: Contact) -> Result<StripModel, StripError> {
    let options = fibre_beam::Options { second_order: false, ..fibre_beam::Options::default() };
    let mut tank = tank(elastic_section()?, 14, 1.0, options)?;
    tank.contact = contact;
    let damping = Rayleigh::fit((2.39, 0.01), (3.53, 0.01), false).map_err(fem::analysis::AnalysisError::from)?;
    StripModel::new(&tank, StripDamping::Rayleigh(damping))
}

/// Parameters of a run.
#[derive(Clone, Copy)]
struct Case<'a> {
    record: &'a Record,
    /// End [s].
    until: f64,
    scale: f64,
    radius: f64,
    step: f64,
}

fn run(model: &StripModel, case: Case<'_>) -> Result<WallHistory, StripError> {
    let Case { record, until, scale, radius, step } = case;
    let mut scaled = record.clone();
    scaled.acceleration.iter_mut().for_each(|a| *a *= scale);
    let mut quake = StripQuake::new(scaled, step);
    quake.until = Some(until);
    quake.scheme = TimeScheme::GeneralizedAlpha { radius };
    quake.newton = Options::for_contact();
    Ok(model.single(&quake, Side::Front, &Silent)?.history)
}

/// Largest change of the moment at the base and of the elevation since the state at rest.
fn peaks(history: &WallHistory) -> [f64; 2] {
    [Scalar::SectionMoment, Scalar::Elevation].map(|s| {
        let rest = history.at_rest(s);
        history.scalar(s).iter().fold(0.0, |m: f64, v| m.max((v - rest).abs()))
    })
}

/// Lowest height that opened [m], first time of any [s], widest gap [m].
fn opened(history: &WallHistory) -> Option<[f64; 3]> {
    let places = history.openings.as_ref()?.places();
    let lowest = places.iter().map(|p| p.height).fold(f64::INFINITY, f64::min);
    let first = places.iter().map(|p| p.first).fold(f64::INFINITY, f64::min);
    let widest = places.iter().map(|p| p.widest).fold(0.0, f64::max);
    lowest.is_finite().then_some([lowest, first, widest])
}

/// Deflections of the top and elevations, relative to rest, by Moreau's scheme on the dense matrices of the same model; and
/// whether any joint is open, step by step.
fn by_moreau(model: &StripModel, case: Case<'_>) -> Result<[Vec<f64>; 3], StripError> {
    let Case { record, until, scale, .. } = case;
    let joints = model.joints.as_ref().map_or(&[][..], |j| &j.elements[..]);
    let system = &model.system;
    let mut stiffness = system.stiffness.to_dense();
    let mut rows = Vec::new();
    let list = model.joints.as_ref();
    for (e, joint) in joints {
        for point in joint.points() {
            let element = &*model.model.elements()[*e];
            let equation = |i: usize| model.model.dofs().equation(element.nodes()[i], element.dofs(i)[0]);
            let renumbered = |row: &[(usize, f64)]| -> Vec<(usize, f64)> {
                row.iter().filter_map(|&(i, c)| Some((equation(i)?, c))).collect()
            };
            let closing = renumbered(&point.closing);
            for &(j, y) in &closing {
                for &(i, x) in &closing {
                    stiffness.add(i, j, -point.stiffness * x * y);
                }
            }
            let k = rows.len();
            let rest = list.map_or(0.0, |l| l.at_rest[k] * l.shares[k]);
            rows.push(Joint { closing, stiffness: point.stiffness, preload: rest, relief: renumbered(&point.relief) });
        }
    }
    // C with the stiffness of the joints left out, as the model has it.
    let n = system.size();
    let mut damping = Matrix::zeros(n, n);
    for j in 0..n {
        let unit: Vec<f64> = (0..n).map(|i| f64::from(u8::from(i == j))).collect();
        let column = system.damping.times(&system.mass, &system.stiffness, &unit);
        damping.column_mut(j).copy_from_slice(&column);
    }
    let jointed =
        Jointed { mass: system.mass.to_dense(), damping, stiffness, joints: rows, opening: Opening::Unilateral };
    let ground = |t: f64| {
        let place = t / record.dt;
        let i = place.floor() as usize;
        let at = |i: usize| record.acceleration.get(i).copied().unwrap_or(0.0);
        scale * (at(i) + (place - i as f64) * (at(i + 1) - at(i)))
    };
    let load = |t: f64| -> Vec<f64> { system.inertia[0].iter().map(|m| -m * ground(t)).collect() };
    let top = model.top(&model.walls[0]);
    let mut out = [vec![0.0], vec![0.0], vec![0.0]];
    let step = STEP;
    jointed.march(step, (until / step).round() as usize, &load, |m| {
        out[0].push(m.displacement[top]);
        out[1].push(model.elevation(m.displacement));
        out[2].push(f64::from(u8::from(m.open.contains(&true))));
    })?;
    Ok(out)
}

/// Rows of C8 in the march, for `record` (El Centro; 0.348 g at `scale` 1) up to the time `until` [s].
///
/// Errors: those of the models.
pub(crate) fn contact(record: &Record, until: f64) -> Answer {
    // More than 80 lines: variants of one run, each with its rows and the reason of its tolerance.
    let mut rows = Vec::new();
    let own = |what: String, reference: (f64, &'static str), computed, (tolerance, unit)| {
        let reference = (reference.0, reference.1, Reference::SecondFormulation);
        Row::new("C8", what, reference, computed, (tolerance, unit))
    };
    let joined = |opens, penalty| model(Contact::Joined { opens, penalty });
    let tight = model(Contact::Bonded)?;
    let case = Case { record, until, scale: 1.0, radius: 1.0, step: STEP };
    let bonded = run(&tight, case)?;
    let closed = run(&joined(false, None)?, case)?;
    let without = "strip without joint";
    for (scalar, what, tolerance, unit) in [
        // A pressure that is handed over at the nodes bends the elements less: (1/14)².
        (Scalar::Deflection, "deflection of the top", 5.1e-3, "m"),
        // The total and its moment are exact.
        (Scalar::Moment, "moment at the base", 1e-9, "N"),
        (Scalar::Shear, "shear force at the base", 1e-9, "N/m"),
    ] {
        rows.push(own(
            format!("march, bonded joint at rest: {what}"),
            (bonded.at_rest(scalar), without),
            closed.at_rest(scalar),
            (tolerance, unit),
        ));
    }
    for (i, (what, unit)) in [("moment at the base", "N"), ("wave", "m")].into_iter().enumerate() {
        rows.push(own(
            format!("march, bonded joint: {what}"),
            (peaks(&bonded)[i], without),
            peaks(&closed)[i],
            // The joint shifts the frequency of the wall by half of 10⁻³, the face by 10⁻³, in a lightly damped resonance.
            (5e-3, unit),
        ));
    }
    let (soft, stiff) = (joined(true, Some(SOFT))?, joined(true, None)?);
    for scale in [1.0, 2.874] {
        let case = Case { scale, ..case };
        let at = format!("march with opening joint, {:.3} g", 0.348 * scale);
        let linear = peaks(&run(&tight, case)?);
        let found = run(&soft, case)?;
        let [deflection, elevation, open] = by_moreau(&soft, case)?;
        let change = |s: Scalar| -> Vec<f64> {
            let rest = found.at_rest(s);
            found.scalar(s).iter().map(|v| v - rest).collect()
        };
        // Number of the step of equal time.
        let steps: Vec<usize> = found.times.iter().map(|t| (t / STEP).round() as usize).collect();
        let first = opened(&found).map_or(until, |o| o[1]);
        for (name, reference, values) in [
            ("deflection of the top", deflection, change(Scalar::Deflection)),
            ("wave", elevation, change(Scalar::Elevation)),
        ] {
            let largest = reference.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            let apart = |end: f64| {
                let seen = found.times.iter().zip(&steps).zip(&values).filter(|((t, _), _)| **t <= end);
                seen.map(|((_, &i), v)| (reference[i] - v).abs()).fold(0.0, f64::max) / largest
            };
            let early = first + TOUCHES;
            for (what, end, tolerance) in [
                (format!("until {early:.2} s"), early, 1e-4),
                ("in the whole run".to_owned(), f64::INFINITY, f64::INFINITY),
            ] {
                rows.push(own(
                    format!("{at}: {name}, largest difference over the peak {what}"),
                    (0.0, "Moreau's scheme, dense, sets by trial"),
                    apart(end),
                    (tolerance, ""),
                ));
            }
        }
        let found = run(&stiff, case)?;
        if let Some([lowest, first, widest]) = opened(&found) {
            let by_series = if scale == 1.0 { 0.08 } else { 1.55 };
            rows.push(own(
                format!(
                    "{at}: depth to which it opens (first at {first:.2} s, widest {:.3} mm; {} steps with an open point)",
                    1e3 * widest,
                    open.iter().sum::<f64>()
                ),
                (by_series, "rigid wall, series (theory sheet)"),
                stiff.tank.liquid.depth - lowest,
                (f64::INFINITY, "m"),
            ));
        }
        let mut shown = |radius: f64, step: f64, history: &WallHistory| {
            for (what, (value, reference)) in ["moment", "wave"].into_iter().zip(peaks(history).into_iter().zip(linear))
            {
                rows.push(own(
                    format!("{at}, spectral radius {radius}, {} ms: {what} over the bonded one", 1e3 * step),
                    (1.0, "bonded; shown, impacts have no limit"),
                    value / reference,
                    (f64::INFINITY, ""),
                ));
            }
        };
        shown(1.0, STEP, &found);
        for (radius, step) in [(0.9, STEP), (0.5, STEP), (0.9, 0.5 * STEP)] {
            shown(radius, step, &run(&stiff, Case { radius, step, ..case })?);
        }
    }
    Ok(rows)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_hold() {
        crate::row::assert_held(&contact(&crate::test_record(), 4.0).unwrap());
    }
}
