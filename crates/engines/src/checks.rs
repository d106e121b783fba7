//! Options and depths that a linear model can have.

use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::{Case, Shape};

use crate::FeError;
use tank::options::LinearOptions as Options;
use tank::options::linear::{Dashpots, WallPlace};

/// Allowed range of [`Options::refine`].
const REFINE: std::ops::RangeInclusive<f64> = 0.25..=16.0;

/// Checks the options that concern the model.
///
/// Errors: the first option out of range.
pub(crate) fn check_options(case: &Case, options: &Options) -> Result<(), FeError> {
    let out_of_range =
        |option: &str, found: String, allowed: String| FeError::Option { option: option.into(), found, allowed };
    if !REFINE.contains(&options.refine) {
        let allowed = format!("{} to {}", REFINE.start(), REFINE.end());
        return Err(out_of_range("refine", options.refine.to_string(), allowed));
    }
    if options.wave_modes == 0 {
        return Err(out_of_range("wave_modes", "0".into(), "1 or more".into()));
    }
    check_depth(case)?;
    let half_length = case.tank.shape.half_length();
    if let Some(r) = options.gauges.iter().find(|r| r.is_nan() || r.abs() > half_length) {
        return Err(out_of_range("gauges", format!("{r} m"), format!("{} m to {half_length} m", -half_length)));
    }
    let height = case.tank.wall_height();
    if let Some(z) = options.stations.iter().find(|z| !(0.0..=height).contains(*z)) {
        return Err(out_of_range("stations", format!("{z} m"), format!("0 m to {height} m")));
    }
    let outside = |place: &&WallPlace| !(0.0..=height).contains(&place.z) || !place.theta.is_finite();
    if let Some(place) = options.force_stations.iter().find(outside) {
        let found = format!("{} m, {} rad", place.z, place.theta);
        let allowed = format!("0 m to {height} m, a finite angle");
        return Err(out_of_range("analysis.force_stations", found, allowed));
    }
    let ring = |ring: &&Dashpots| {
        !(ring.z > 0.0 && ring.z <= height && ring.coefficient >= 0.0 && ring.coefficient.is_finite())
    };
    if let Some(ring) = options.dashpots.iter().find(ring) {
        let found = format!("{} m, {} N s/m", ring.z, ring.coefficient);
        let allowed = format!("above 0 m to {height} m, a coefficient from 0");
        return Err(out_of_range("analysis.damping.dashpots", found, allowed));
    }
    Ok(())
}

/// Least depth of the liquid over the height of the wall: nodes of the wall closer than a millionth of its height are one.
const SHALLOWEST: f64 = 1e-4;

/// Checks that the liquid is deep enough to be meshed.
///
/// Errors: a liquid that only covers the bottom.
pub(crate) fn check_depth(case: &Case) -> Result<(), FeError> {
    let least = SHALLOWEST * case.tank.wall_height();
    if case.liquid.fill_height >= least {
        return Ok(());
    }
    Err(FeError::option(
        "liquid.fill_height",
        format!("{} m", case.liquid.fill_height),
        format!("at least {least} m for finite elements, a ten-thousandth of the height of the wall"),
    ))
}

/// The ground motion of a case.
///
/// Errors: no ground motion; an invalid record.
pub(crate) fn checked_motion(case: &Case) -> Result<&GroundMotion, FeError> {
    let motion = case.ground_motion.as_ref().ok_or(FeError::NoRecord)?;
    check_record("horizontal record", &motion.horizontal)?;
    if let Some(transverse) = &motion.transverse {
        check_record("record along y", transverse)?;
        if matches!(case.tank.shape, Shape::Rectangle { strip: true, .. }) {
            return Err(FeError::Unsupported(
                "--quake-y: a strip has no walls across the other direction; remove --quake-y".into(),
            ));
        }
    }
    if let Some(vertical) = &motion.vertical {
        check_record("vertical record", vertical)?;
    }
    Ok(motion)
}

fn check_record(which: &str, record: &Record) -> Result<(), FeError> {
    let refuse =
        |found: String, allowed: &str| Err(FeError::Option { option: which.into(), found, allowed: allowed.into() });
    if record.acceleration.len() < 2 {
        return refuse(format!("{} samples", record.acceleration.len()), "2 samples or more");
    }
    if !(record.dt > 0.0 && record.dt.is_finite()) {
        return refuse(format!("time step {} s", record.dt), "a positive time step");
    }
    match record.acceleration.iter().position(|a| !a.is_finite()) {
        Some(i) => refuse(format!("{} at sample {}", record.acceleration[i], i + 1), "finite accelerations"),
        None => Ok(()),
    }
}
