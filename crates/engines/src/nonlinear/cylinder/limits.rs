//! Limits of validity of a nonlinear cylinder, tested on a run.

use tank::units::{Dimension, display};

use super::march::Cylinder;
use super::points::Look;
use super::recorded::{WAVE_BACK, WAVE_FRONT};
use super::watch::Watch;
use crate::linear::limits::{self, limit_of};
use results::Limit;

/// Displacements of the wall beyond this share of the radius change the liquid's domain, and with it the added mass, by as much
/// (p ~ ρ R ẅ); the liquid is that of the undeformed tank.
const SMALL_DISPLACEMENT: f64 = 0.05;
/// Widest crack [m] at which bars still count as bonded and the tank as tight: more than three times the widest crack that EN
/// 1992-1-1, table 7.1N, allows anywhere (0.4 mm). Beyond, slip of the bars and loss of liquid, neither of which is modelled, matter.
const WIDE_CRACK: f64 = 1.3e-3;

/// All limits of a run.
///
/// * `worst`: largest values of every cell
pub(super) fn limits(cylinder: &Cylinder<'_>, watch: &Watch<'_>, worst: &Look) -> Vec<Limit> {
    let (case, tank) = (cylinder.case, &cylinder.tank);
    let recorder = &watch.recorder;
    let rise = |k: usize| {
        let rest = recorder.histories[k].first().copied().unwrap_or(0.0);
        (recorder.ranges[k].max - rest).max(0.0)
    };
    let sides = rise(WAVE_FRONT).max(rise(WAVE_BACK));
    let mut found = limits::waves(case, sides.max(watch.seen.two.wave().value), None).to_vec();
    found.push(displacement(tank.radius, watch.seen.displacement));
    found.extend(suction(watch));
    let cracks = worst.crack_width.iter().flatten().copied();
    if worst.crack_width.iter().any(|face| !face.is_empty()) {
        found.push(crack(cracks.fold(0.0, f64::max)));
    }
    found.push(limits::compressibility(case, tank.wall_omega / std::f64::consts::TAU));
    if let Some(motion) = &case.ground_motion {
        found.push(limits::record(tank.wall_omega, motion.horizontal.dt));
    }
    found
}

fn displacement(radius: f64, (value, time): (f64, f64)) -> Limit {
    let limit = SMALL_DISPLACEMENT * radius;
    let name = format!("Radial displacement of the wall against {SMALL_DISPLACEMENT} of the radius");
    limit_of("wall_displacement", name, [value, limit], Dimension::Length, value <= limit, || {
        format!("The liquid is that of the undeformed tank: its pressure after {time:.2} s is indicative only.")
    })
}

fn crack(value: f64) -> Limit {
    let name = "Widest crack against that at which slip of bars and loss of liquid matter";
    limit_of("crack_width", name, [value, WIDE_CRACK], Dimension::Length, value <= WIDE_CRACK, || {
        "Bars are bonded in the model and the wall is tight: crack widths and the demand after this crack are \
         indicative only."
            .into()
    })
}

/// Lowest pressure of a displaced particle under the trough, where the model keeps the liquid at the wall.
fn suction(watch: &Watch<'_>) -> Option<Limit> {
    if watch.openings.is_some() {
        return None;
    }
    let found = watch.separation.result();
    let below = |(height, pressure): &(f64, f64)| *height < found.trough && pressure.is_finite();
    let lowest = watch.separation.lowest_pressures().filter(below);
    let (height, value) = lowest.min_by(|a, b| a.1.total_cmp(&b.1))?;
    let name = "Smallest pressure of the liquid at the wall below the wave trough";
    Some(limit_of("suction", name, [value, 0.0], Dimension::Stress, value >= 0.0, || {
        format!(
            "Suction at z = {}: the liquid would separate from the wall if air entered; the model keeps it in contact \
             (`contact` opening models the separation).",
            display(height, Dimension::Length)
        )
    }))
}
