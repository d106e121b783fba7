//! Modes of a tank in three dimensions for a list, wave number by wave number.

use std::collections::BTreeMap;

use fem::linalg::dot;
use fem::progress::Progress;
use results::{Mode, ModeShape};
use tank::Case;
use tank::options::LinearOptions as Options;
use tank::options::solid::SolidOptions;

use super::model::TankModel;
use super::poles::poles;
use super::rows::{Observer, Row, sparse_dot};
use super::search::search;
use super::system::System;
use super::{reduce, spectrum};
use crate::FeError;
use crate::checks::check_options;
use crate::damping::Damper;
use crate::modes::Kind;

/// Largest circumferential wave number that is searched for modes.
const MOST_WAVES: u32 = 24;

/// Largest circumferential wave number that [`modes`] looks for on the mesh of a case.
///
/// Errors: a mesh that cannot be built.
pub fn most_waves(case: &Case, options: &Options, solid: &SolidOptions) -> Result<u32, FeError> {
    let tank = TankModel::new(case, options, solid)?;
    Ok(spectrum::most_waves(&tank).min(MOST_WAVES))
}

/// The `count` lowest modes of each kind (`sloshing`, `structural`), named by circumferential and axial wave number.
///
/// Errors: as [`super::simulate`].
pub fn modes(
    case: &Case,
    options: &Options,
    solid: &SolidOptions,
    count: usize,
    progress: &dyn Progress,
) -> Result<Vec<Mode>, FeError> {
    check_options(case, options)?;
    progress.stage("mesh, matrices and factors", 1);
    let tank = TankModel::new(case, options, solid)?;
    let system = System::new(&tank.model, &tank.assembler, &poles(case, solid), solid.memory_limit_mib << 20)?;
    progress.advance(1);
    let most = spectrum::most_waves(&tank).min(MOST_WAVES);
    let damper = Damper::new(case, &options.damping)?;
    let mut found: Vec<Mode> = Vec::new();
    for (n, modes) in (0..).zip(search(&tank, &system, (most, count), progress)?) {
        let participation = match n {
            0 | 1 => Some(reduce::rigid_motion(&tank, &system, n)?.1),
            2 if !tank.is_round() => Some(reduce::rigid_motion(&tank, &system, n)?.1),
            _ => None,
        };
        // Modes of the rotation penalty of a displacement liquid are not modes of the tank.
        for kind in [Kind::Sloshing, Kind::Structural] {
            for (k, mode) in modes.iter().filter(|m| m.kind == kind).take(count).enumerate() {
                let gamma = participation.as_ref().map_or(0.0, |load| dot(load, &mode.vector));
                found.push(Mode {
                    harmonic: n,
                    axial: mode.waves.filter(|_| kind != Kind::Sloshing).map(|w| w.axial),
                    kind: kind.id().into(),
                    number: k + 1,
                    omega: mode.omega,
                    period: std::f64::consts::TAU / mode.omega,
                    damping: damper.ratio(kind, mode.omega),
                    participation: gamma,
                    effective_mass: gamma * gamma,
                    effective_height: 0.0,
                    shape: shape(&tank, &mode.vector),
                });
            }
        }
    }
    found.sort_by(|a, b| a.omega.total_cmp(&b.omega));
    let mut left = BTreeMap::new();
    found.retain(|m| {
        let taken: &mut usize = left.entry(m.kind.clone()).or_insert(0);
        *taken += 1;
        *taken <= count
    });
    Ok(found)
}

/// Shape of a mode at θ = 0.
fn shape(tank: &TankModel, x: &[f64]) -> ModeShape {
    let observer = Observer { tank, harmonic: 1 };
    let value = |row: Row| sparse_dot(&row.displacement, x);
    let mut shape = ModeShape {
        z: tank.wall.z.clone(),
        wall: (0..tank.wall.z.len()).map(|level| value(observer.radial_displacement(level))).collect(),
        r: tank.division.radii.clone(),
        surface: tank.division.radii.iter().map(|&r| value(observer.elevation(r))).collect(),
    };
    let all = || shape.wall.iter().chain(&shape.surface);
    let peak = all().fold(0.0_f64, |m, v| m.max(v.abs()));
    if peak > 0.0 {
        let all = shape.wall.iter_mut().chain(&mut shape.surface);
        all.for_each(|v| *v /= peak);
    }
    shape
}
