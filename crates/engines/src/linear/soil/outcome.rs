//! What is reported of a run on soil.

use ::soil::SoilError;
use ::soil::body::Mode;
use ::soil::chain::Chain;
use ::soil::disc::Impedance;
use ::soil::structure::{Effective, OnSoil, Structure};
use fem::linalg::dot;
use fem::progress::Silent;
use results::part::{Amount, Block, Fact, Form, History, Message, Table};
use results::{Channel, Finding, Part};
use tank::Case;
use tank::case::GroundMotion;
use tank::options::LinearOptions as Options;
use tank::units::Dimension;

use super::extend::Rigid;
use super::{CONCRETE, Slab};
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

/// Effective period and damping by each definition, and those on a fixed base, as rows of their table.
///
/// Errors: no convergence.
fn effective(on: &OnSoil, slab: &Slab) -> Result<Vec<Vec<Fact>>, SoilError> {
    let fixed = on.structure.period;
    let row = |id: &str, period: f64, damping: Option<f64>| {
        vec![id.into(), period.into(), (period / fixed).into(), damping.into()]
    };
    let with = |id, found: Effective| row(id, found.period, Some(found.damping));
    let chain = Chain::new(on, [slab.mass(), slab.inertia()])?;
    Ok(vec![
        row("fixed", fixed, Some(on.structure.damping)),
        with("cones", on.effective(Impedance::Cone)?),
        with("veletsos", on.effective(Impedance::Veletsos)?),
        with("complex_mode", chain.complex_mode()?),
        row("static", on.static_period(), None),
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
) -> Result<Option<(Part, Option<usize>)>, FeError> {
    let (Some(slab), true) = (Slab::of(case)?, model.fixed.is_some()) else { return Ok(None) };
    let Some(mode) = impulsive(case, model, &slab) else { return Ok(None) };
    let failed = |e: SoilError| FeError::Analysis(format!("the tank on soil: {e}"));
    let structure = mode.structure();
    let on = OnSoil::new(structure, slab.disc).map_err(failed)?;
    let effective = effective(&on, &slab).map_err(failed)?;
    let fixed_model = model.on_fixed_base();
    let found = analyse(&fixed_model, motion, options, &Silent)?;
    let fixed = found.values(&fixed_model, true);
    let hoop = found.line(OnWall::Hoop).map(LineExtremes::worst);
    let beside = analysis.values(model, true).into_iter().filter_map(|(quantity, value)| {
        let held = fixed.get(&quantity).copied().filter(|held| *held != value)?;
        Some(Finding { held: Some(held), ..Finding::new(quantity.id(), value, quantity.dimension()) })
    });
    let motion = [("base_translation", Channel::FoundationTranslation), ("base_rotation", Channel::FoundationRotation)];
    let motion = motion.into_iter().filter_map(|(id, channel)| {
        let (peak, time) = analysis.sides(channel)?.0.peak();
        Some(Finding { time: Some(time), ..Finding::new(id, peak.abs(), channel.dimension()) })
    });
    let history = |channel: Channel| Block::History(History::new(&channel.id(), "axis", &[channel]));
    let part = Part {
        id: "soil".into(),
        blocks: vec![
            Block::Text(Message::new("soil-about")),
            Block::Note(ground(&slab, &structure)),
            Block::Table(cones(&slab)),
            Block::Table(Table::new("effective", &EFFECTIVE, effective)),
            Block::Note(Message::new("soil-definitions")),
            Block::values("motion", motion.collect()),
            Block::values("beside", beside.collect()),
            history(Channel::FoundationTranslation),
            history(Channel::FoundationRotation),
            assumptions(&slab),
        ],
    };
    Ok(Some((part, hoop)))
}

/// Columns of period and damping.
const EFFECTIVE: [(&str, Dimension, Form); 4] = [
    ("mode", Dimension::Dimensionless, Form::Words),
    ("period", Dimension::Time, Form::Fixed(4)),
    ("ratio", Dimension::Dimensionless, Form::Fixed(3)),
    ("damping", Dimension::Dimensionless, Form::Percent),
];

/// Slab, soil and stiffness.
fn ground(slab: &Slab, structure: &Structure) -> Message {
    let given = |value, unit| Amount::new(value, unit).form(Form::Given);
    let radius = given(slab.disc.radius, Dimension::Length);
    let plate = match slab.thickness > 0.0 {
        true => Message::new("soil-slab")
            .with("thickness", given(slab.thickness, Dimension::Length))
            .with("mass", Amount::new(slab.mass(), Dimension::Mass)),
        false => Message::new("soil-slab-without-mass"),
    };
    let (soil, stiffness) = (slab.disc.soil, slab.disc.stiffness());
    Message::new("soil-ground")
        .with("slab", plate.with("radius", radius))
        .with("velocity", given(soil.shear_wave_velocity, Dimension::Velocity))
        .with("density", given(soil.density, Dimension::Density))
        .with("poisson", Amount::ratio(soil.poisson_ratio).form(Form::Fixed(3)))
        .with("horizontal", Amount::new(stiffness.horizontal, Dimension::LineForce))
        .with("rocking", Amount::new(stiffness.rocking, Dimension::RotationalStiffness))
        .with("mass", Amount::new(structure.mass, Dimension::Mass))
        .with("arm", Amount::new(structure.height, Dimension::Length))
        .with("damping", Amount::percent(structure.damping))
}

/// Springs, dashpots and inertia of the cones.
fn cones(slab: &Slab) -> Table {
    let (stiffness, cones) = (slab.disc.stiffness(), slab.disc.cones());
    let some = |value: f64, unit| Fact::from((value > 0.0).then(|| Amount::new(value, unit)));
    let inertia = |value| some(value, Dimension::RotationalInertia);
    let columns = [
        ("impedance", Dimension::Dimensionless, Form::Words),
        ("spring", Dimension::Dimensionless, Form::Usual),
        ("dashpot", Dimension::Dimensionless, Form::Usual),
        ("inertia", Dimension::Dimensionless, Form::Usual),
    ];
    let rows = vec![
        vec![
            "translation".into(),
            some(stiffness.horizontal, Dimension::LineForce),
            some(cones.horizontal_dashpot, Dimension::Dashpot),
            Fact::None,
        ],
        vec![
            "rocking".into(),
            some(stiffness.rocking, Dimension::RotationalStiffness),
            Fact::None,
            inertia(cones.trapped_inertia),
        ],
        vec![
            "internal".into(),
            Fact::None,
            some(cones.rocking_dashpot, Dimension::RotationalDashpot),
            inertia(cones.internal_inertia),
        ],
    ];
    Table::new("cones", &columns, rows)
}

fn assumptions(slab: &Slab) -> Block {
    let mut items: Vec<Message> =
        ["rigid", "meek", "bottom", "modal", "vertical"].map(|id| Message::new(&format!("soil-{id}"))).to_vec();
    items.push(match slab.thickness > 0.0 {
        true => {
            let density = Amount::new(CONCRETE, Dimension::Density).form(Form::Given);
            Message::new("soil-disc").with("density", density)
        }
        false => Message::new("soil-no-mass"),
    });
    Block::List { items }
}
