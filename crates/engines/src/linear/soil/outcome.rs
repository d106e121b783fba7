//! What is reported of a run on soil.

use ::soil::SoilError;
use ::soil::chain::Chain;
use ::soil::disc::Impedance;
use ::soil::structure::{Effective, OnSoil, Structure};
use fem::progress::Silent;
use results::part::{Amount, Block, Fact, Form, History, Message, Table};
use results::{Channel, Finding, Part};
use tank::Case;
use tank::case::GroundMotion;
use tank::options::LinearOptions as Options;
use tank::units::Dimension;

use super::ground::Ground;
use super::under::{fixed, impulsive};
use super::{CONCRETE, Slab};
use crate::FeError;
use crate::linear::analysis::{Analysis, LineExtremes, analyse};
use crate::linear::model::Model;
use results::channel::OnWall;

/// Effective period and damping by each definition, and those on a fixed base, as rows of their table.
///
/// Errors: no convergence.
fn effective(structure: &Structure, slab: &Slab) -> Result<Vec<Vec<Fact>>, SoilError> {
    let fixed = structure.period;
    let row = |id: &str, period: f64, damping: Option<f64>| {
        vec![id.into(), period.into(), (period / fixed).into(), damping.into()]
    };
    let with = |id, found: Effective| row(id, found.period, Some(found.damping));
    let own = row("fixed", fixed, Some(structure.damping));
    if let Some(soil) = &slab.embedded {
        return Ok(vec![own, with("layers", soil.effective(structure)?)]);
    }
    let on = &OnSoil::new(*structure, slab.disc)?;
    let chain = Chain::new(on, [slab.mass(), slab.inertia()])?;
    Ok(vec![
        own,
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
    let Some(mode) = impulsive(case, model.held(), &model.damper, &slab) else { return Ok(None) };
    let structure = mode.structure();
    let ground = Ground::of(&slab, Some(mode))?;
    let fixed_model = model.on_fixed_base();
    let found = analyse(&fixed_model, motion, options, &Silent)?;
    let fixed = found.values(&fixed_model, true);
    let hoop = found.line(OnWall::Hoop).map(LineExtremes::worst);
    let beside = analysis.values(model, true).into_iter().filter_map(|(quantity, value)| {
        let held = fixed.get(&quantity).copied().filter(|held| *held != value)?;
        Some(Finding { held: Some(held), ..Finding::new(quantity.id(), value, quantity.dimension()) })
    });
    let motion = MOTION.into_iter().filter_map(|(id, channel)| {
        let (peak, time) = analysis.sides(channel)?.0.peak();
        Some(Finding { time: Some(time), ..Finding::new(id, peak.abs(), channel.dimension()) })
    });
    let values = vec![Block::values("motion", motion.collect()), Block::values("beside", beside.collect())];
    let part = blocks((&slab, &structure, &ground), ["soil-about", "soil-modal"], values)?;
    Ok(Some((part, hoop)))
}

/// What is reported of a run of another model with its slab moving, whose largest translation and rotation with their times are `motion`; `None`
/// without an impulsive mode.
///
/// Errors: those of the model on a fixed base; no effective period.
pub(crate) fn part(
    case: &Case,
    (slab, ground): (&Slab, &Ground),
    motion: [(f64, f64); 2],
) -> Result<Option<Part>, FeError> {
    let Some(mode) = fixed(case, slab)? else { return Ok(None) };
    let motion = MOTION.into_iter().zip(motion).map(|((id, channel), (peak, time))| Finding {
        time: Some(time),
        ..Finding::new(id, peak, channel.dimension())
    });
    let values = vec![Block::values("motion", motion.collect())];
    let said = ["soil-about-nonlinear", "soil-relative"];
    blocks((slab, &mode.structure(), ground), said, values).map(Some)
}

/// The slab's motion among the values.
const MOTION: [(&str, Channel); 2] =
    [("base_translation", Channel::FoundationTranslation), ("base_rotation", Channel::FoundationRotation)];

/// The part with these values and with what is said of the run and of its damping.
///
/// Errors: no effective period.
fn blocks(
    (slab, structure, ground): (&Slab, &Structure, &Ground),
    [about, damping]: [&str; 2],
    values: Vec<Block>,
) -> Result<Part, FeError> {
    let failed = |e: SoilError| FeError::Analysis(format!("the tank on soil: {e}"));
    let effective = effective(structure, slab).map_err(failed)?;
    let history = |channel: Channel| Block::History(History::new(&channel.id(), "axis", &[channel]));
    let mut blocks = vec![
        Block::Text(Message::new(about)),
        Block::Note(described(slab, structure)),
        Block::Table(springs(ground)),
        Block::Table(Table::new("effective", &EFFECTIVE, effective)),
        Block::Note(definitions(ground)),
    ];
    blocks.extend(values);
    blocks.push(history(Channel::FoundationTranslation));
    blocks.push(history(Channel::FoundationRotation));
    blocks.push(assumptions(slab, damping));
    Ok(Part { id: "soil".into(), blocks })
}

/// Columns of period and damping.
const EFFECTIVE: [(&str, Dimension, Form); 4] = [
    ("mode", Dimension::Dimensionless, Form::Words),
    ("period", Dimension::Time, Form::Fixed(4)),
    ("ratio", Dimension::Dimensionless, Form::Fixed(3)),
    ("damping", Dimension::Dimensionless, Form::Percent),
];

/// Slab, soil and stiffness.
fn described(slab: &Slab, structure: &Structure) -> Message {
    let given = |value, unit| Amount::new(value, unit).form(Form::Given);
    let radius = given(slab.disc.radius, Dimension::Length);
    let plate = match slab.thickness > 0.0 {
        true => Message::new("soil-slab")
            .with("thickness", given(slab.thickness, Dimension::Length))
            .with("mass", Amount::new(slab.mass(), Dimension::Mass)),
        false => Message::new("soil-slab-without-mass"),
    };
    let (soil, stiffness) = (slab.disc.soil, slab.disc.stiffness());
    let ground = match &slab.embedded {
        None => Message::new("soil-ground")
            .with("density", given(soil.density, Dimension::Density))
            .with("poisson", Amount::ratio(soil.poisson_ratio).form(Form::Fixed(3)))
            .with("horizontal", Amount::new(stiffness.horizontal, Dimension::LineForce))
            .with("rocking", Amount::new(stiffness.rocking, Dimension::RotationalStiffness)),
        Some(embedded) => Message::new("soil-ground-layers")
            .with("layers", Amount::ratio(embedded.layers.len() as f64).form(Form::Given))
            .with("embedment", given(embedded.embedment, Dimension::Length))
            .with("hysteresis", Amount::percent(embedded.below.damping)),
    };
    ground
        .with("slab", plate.with("radius", radius))
        .with("velocity", given(soil.shear_wave_velocity, Dimension::Velocity))
        .with("mass", Amount::new(structure.mass, Dimension::Mass))
        .with("arm", Amount::new(structure.height, Dimension::Length))
        .with("damping", Amount::percent(structure.damping))
}

/// What is said of the damping ratios: how their definitions differ, or to which frequency springs and dashpots belong.
fn definitions(ground: &Ground) -> Message {
    match ground.omega {
        None => Message::new("soil-definitions"),
        Some(omega) => {
            let period = Amount::new(std::f64::consts::TAU / omega, Dimension::Time).form(Form::Fixed(4));
            Message::new("soil-at-frequency").with("period", period)
        }
    }
}

/// Springs, dashpots and inertia of the ground.
fn springs(ground: &Ground) -> Table {
    let some = |value: f64, unit| Fact::from((value > 0.0).then(|| Amount::new(value, unit)));
    let inertia = |value| some(value, Dimension::RotationalInertia);
    let columns = [
        ("impedance", Dimension::Dimensionless, Form::Words),
        ("spring", Dimension::Dimensionless, Form::Usual),
        ("dashpot", Dimension::Dimensionless, Form::Usual),
        ("inertia", Dimension::Dimensionless, Form::Usual),
    ];
    let mut rows = vec![
        vec![
            "translation".into(),
            some(ground.spring[0][0], Dimension::LineForce),
            some(ground.dashpot[0][0], Dimension::Dashpot),
            Fact::None,
        ],
        vec![
            "rocking".into(),
            some(ground.spring[1][1], Dimension::RotationalStiffness),
            some(ground.dashpot[1][1], Dimension::RotationalDashpot),
            inertia(ground.trapped_inertia),
        ],
    ];
    if let Some([mass, dashpot]) = ground.inner {
        let dashpot = some(dashpot, Dimension::RotationalDashpot);
        rows.push(vec!["internal".into(), Fact::None, dashpot, inertia(mass)]);
    }
    Table::new("cones", &columns, rows)
}

fn assumptions(slab: &Slab, damping: &str) -> Block {
    let said = |ids: &[&str]| -> Vec<Message> { ids.iter().map(|id| Message::new(&format!("soil-{id}"))).collect() };
    let mut items = match &slab.embedded {
        None => said(&["rigid", "meek"]),
        Some(soil) => {
            let given = |value| Amount::new(value, Dimension::Length).form(Form::Given);
            let layered = Message::new("soil-layered")
                .with("layers", Amount::ratio(soil.layers.len() as f64).form(Form::Given))
                .with("embedment", given(soil.embedment));
            vec![Message::new("soil-rigid-layers"), layered]
        }
    };
    items.extend(said(&["bottom"]));
    items.push(Message::new(damping));
    items.extend(said(&["vertical"]));
    items.push(match slab.thickness > 0.0 {
        true => {
            let density = Amount::new(CONCRETE, Dimension::Density).form(Form::Given);
            Message::new("soil-disc").with("density", density)
        }
        false => Message::new("soil-no-mass"),
    });
    Block::List { items }
}
