//! What limit states ask of isolators: their displacement, and the force of the outermost bearing.

use std::f64::consts::TAU;

use ::soil::isolated::History;
use tank::Isolators;
use tank::demand::{Demands, Isolation, Peak};

use super::Setup;

/// Largest |value| with its time step.
pub(super) fn largest(values: impl Iterator<Item = f64>) -> (f64, usize) {
    let pick = |best: (f64, usize), (i, v): (usize, f64)| if v.abs() > best.0 { (v.abs(), i) } else { best };
    values.enumerate().fold((0.0, 0), pick)
}

/// Size of a vector.
pub(super) fn size(v: &[f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

/// What limit states ask of isolators, without bounds.
///
/// * `demands`: those of the tank under the motion of the slab
pub(super) fn isolation(setup: &Setup, given: &Isolators, history: &History, demands: &Demands) -> Isolation {
    let (displacement, step) = largest(history.displacement.iter().map(size));
    let [x, y] = history.displacement.get(step).copied().unwrap_or_default();
    Isolation {
        displacement: Peak { value: displacement, time: step as f64 * setup.step, theta: y.atan2(x).rem_euclid(TAU) },
        bearing_share: outermost(setup, given, history, demands),
        bounds: Vec::new(),
    }
}

/// Smallest force of the outermost bearing over that at rest, on the side to which the slab accelerates.
///
/// N/N_0 = 1 + a_v/g − M c A/(W I) with c A/I = 4/R of a disc and 3/L of a rectangle of length 2 L.
fn outermost(setup: &Setup, given: &Isolators, history: &History, demands: &Demands) -> Option<Peak> {
    let (moment, shear) = (demands.overturning_moment.as_ref()?, demands.base_shear.as_ref()?);
    let along = [demands.history(moment), demands.history(shear)];
    let across = demands.transverse(moment).zip(demands.transverse(shear));
    let up = demands.vertical.as_ref().map(|terms| demands.history(terms));
    let thickness = given.slab_thickness;
    let arm = if setup.round { 4.0 } else { 3.0 } / setup.radius;
    let weight = setup.mass * setup.gravity;
    let mut least: Option<Peak> = None;
    for (k, &time) in demands.times.iter().enumerate() {
        let step = ((time / setup.step).round() as usize).min(history.acceleration.len() - 1);
        let a = history.acceleration[step];
        let at = |m: f64, v: f64, a: f64| m + v * thickness + 0.5 * given.slab_mass * a * thickness;
        let x = at(along[0][k], along[1][k], a[0]);
        let y = across.as_ref().map_or(0.0, |(m, v)| at(m[k], v[k], a[1]));
        let lift = up.as_ref().map_or(0.0, |up| up[k] / setup.gravity);
        let value = 1.0 + lift - x.hypot(y) * arm / weight;
        if least.is_none_or(|smallest| value < smallest.value) {
            let theta = y.atan2(x).rem_euclid(TAU);
            least = Some(Peak { value, time, theta });
        }
    }
    least
}
