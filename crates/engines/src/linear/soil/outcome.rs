//! What is reported of a run on soil.

use ::soil::SoilError;
use ::soil::body::Mode;
use ::soil::chain::Chain;
use ::soil::disc::Impedance;
use ::soil::structure::{Effective, OnSoil};
use fem::linalg::dot;
use fem::progress::Silent;
use results::{BaseQuantity, Channel, EffectiveMode, SoilRun, Value};
use tank::Case;
use tank::case::GroundMotion;
use tank::options::LinearOptions as Options;
use tank::units::Dimension;

use super::extend::Rigid;
use super::{Slab, words};
use crate::FeError;
use crate::linear::analysis::{Analysis, LineExtremes, analyse};
use crate::linear::model::Model;
use results::channel::OnWall;

/// The impulsive mode as a structure of one mass, with the arm about the underside of the slab; `None` without such a mode.
pub(crate) fn impulsive(case: &Case, model: &Model, slab: &Slab) -> Option<Mode> {
    let held = model.held();
    let omega = held.impulsive()?.dominant.omega;
    let mode = held.modes.iter().find(|mode| mode.omega == omega)?;
    let rigid = Rigid::of(&held.coupled, case, slab)?;
    Some(Mode {
        omega,
        damping: model.damper.of(mode),
        translation: mode.participation,
        rotation: dot(&mode.vector, &rigid.moment),
    })
}

/// Effective period and damping by each definition.
///
/// Errors: no convergence.
fn effective(on: &OnSoil, slab: &Slab) -> Result<Vec<EffectiveMode>, SoilError> {
    let with = |id: &str, found: Effective| EffectiveMode {
        id: id.into(),
        period: found.period,
        damping: Some(found.damping),
    };
    let chain = Chain::new(on, [slab.mass(), slab.inertia()])?;
    Ok(vec![
        with("cones", on.effective(Impedance::Cone)?),
        with("veletsos", on.effective(Impedance::Veletsos)?),
        with("complex_mode", chain.complex_mode()?),
        EffectiveMode {
            id: "static".into(),
            period: on.static_period(),
            damping: None,
        },
    ])
}

/// The run on soil beside that on a fixed base; `None` without soil.
///
/// Errors: as [`analyse`]; no effective period.
pub(crate) fn outcome(
    case: &Case,
    model: &Model,
    analysis: &Analysis<'_>,
    motion: &GroundMotion,
    options: &Options,
) -> Result<Option<(SoilRun, Option<usize>)>, FeError> {
    let (Some(slab), true) = (Slab::of(case)?, model.fixed.is_some()) else {
        return Ok(None);
    };
    let Some(mode) = impulsive(case, model, &slab) else {
        return Ok(None);
    };
    let failed = |e: SoilError| FeError::Analysis(format!("the tank on soil: {e}"));
    let structure = mode.structure();
    let on = OnSoil::new(structure, slab.disc).map_err(failed)?;
    let effective = effective(&on, &slab).map_err(failed)?;
    let fixed_model = model.on_fixed_base();
    let found = analyse(&fixed_model, motion, options, &Silent)?;
    let fixed = found.values(&fixed_model, true);
    let hoop = found.line(OnWall::Hoop).map(LineExtremes::worst);
    let beside = analysis
        .values(model, true)
        .into_iter()
        .filter_map(|(quantity, value)| {
            let dimension = quantity.dimension();
            let other = *fixed.get(&quantity)?;
            (other != value).then(|| results::OnSoil {
                id: quantity.id().into(),
                soil: Value { value, dimension },
                fixed: Value {
                    value: other,
                    dimension,
                },
            })
        });
    let quantity = |id: &str, value: f64, dimension, time| BaseQuantity {
        id: id.into(),
        value: Value { value, dimension },
        time,
        degrees: None,
        z: None,
    };
    let mut quantities = vec![
        quantity("effective_period", effective[0].period, Dimension::Time, None),
        quantity(
            "effective_damping",
            effective[0].damping.unwrap_or(structure.damping),
            Dimension::Dimensionless,
            None,
        ),
    ];
    for (id, channel) in [
        ("base_translation", Channel::FoundationTranslation),
        ("base_rotation", Channel::FoundationRotation),
    ] {
        let found = analysis.sides(channel).map(|(front, _)| front.peak());
        quantities.extend(found.map(|(peak, time)| quantity(id, peak.abs(), channel.dimension(), Some(time))));
    }
    let stiffness = slab.disc.stiffness();
    let cones = slab.disc.cones();
    let soil = slab.disc.soil;
    let run = SoilRun {
        shear_wave_velocity: soil.shear_wave_velocity,
        density: soil.density,
        poisson_ratio: soil.poisson_ratio,
        radius: slab.disc.radius,
        thickness: slab.thickness,
        slab_mass: slab.mass(),
        horizontal: stiffness.horizontal,
        rocking: stiffness.rocking,
        horizontal_dashpot: cones.horizontal_dashpot,
        rocking_dashpot: cones.rocking_dashpot,
        internal_inertia: cones.internal_inertia,
        trapped_inertia: cones.trapped_inertia,
        fixed_period: structure.period,
        fixed_damping: structure.damping,
        impulsive_mass: structure.mass,
        impulsive_arm: structure.height,
        effective,
        quantities,
        beside: beside.collect(),
        assumptions: words::assumptions(&slab),
    };
    Ok(Some((run, hoop)))
}
