//! Options and depths that a linear model can have.

use tank::Case;

use crate::FeError;
use tank::options::LinearOptions as Options;
use tank::options::linear::{Dashpots, WallPlace};

/// Allowed range of [`Options::refine`].
const REFINE: std::ops::RangeInclusive<f64> = 0.25..=16.0;

/// Checks the options that concern the model.
///
/// Errors: the first option out of range.
pub(crate) fn check_options(case: &Case, options: &Options) -> Result<(), FeError> {
    let out_of_range = |option: &str, found: String, allowed: String| FeError::Option {
        option: option.into(),
        found,
        allowed,
    };
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
        return Err(out_of_range(
            "gauges",
            format!("{r} m"),
            format!("{} m to {half_length} m", -half_length),
        ));
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
    Err(FeError::Option {
        option: "liquid.fill_height".into(),
        found: format!("{} m", case.liquid.fill_height),
        allowed: format!("at least {least} m for finite elements, a ten-thousandth of the height of the wall"),
    })
}
