//! The base of a tank that is not held down, in the section of that name.

use tank::FoundationKind;
use tank::units::{Dimension, display};

use crate::number::{fixed, percent, share, with_unit};
use results::{BaseRun, BaseSpread, GroundOrigin, JointCycles, MissedBand};

/// Title of a quantity.
pub fn quantity(id: &str) -> &str {
    match id {
        "uplift" => "Largest uplift of the rim",
        "base_rotation" => "Largest rotation of the base",
        "plastic_rotation" => "Plastic rotation of the joint there",
        "toe_axial_stress" => "Largest axial stress at the toe, compression",
        "slip" => "Largest slip",
        "slip_residual" => "Slip at the end",
        "slip_path" => "Path of the slip, back and forth",
        "anchor_force" => "Largest force of an anchor",
        "base_shear" => "Base shear",
        "base_moment" => "Moment above the base plate",
        "overturning_moment" => "Overturning moment",
        "sloshing_height" => "Wave height",
        "hoop_stress" => "Largest hoop stress up to the surface at rest",
        "rim_hoop_stress" => "Largest hoop stress of the rim above it",
        "axial_membrane_stress" => "Axial stress at the foot without that at rest",
        other => other,
    }
}

/// Titles of the tables: values, band of the ground, energies.
pub const TABLES: [&str; 3] =
    ["Largest values of the base", "Values on softer and on stiffer ground", "Energies of the lifting base"];
/// Heads of the table of values.
pub const VALUES: [&str; 7] = ["Quantity", "With uplift", "Time", "θ [°]", "z [m]", "Wall held down", "Ratio"];
/// Heads of the table of the band.
pub const BAND: [&str; 8] = [
    "Ground under the rim",
    "Uplift",
    "Rotation of the base",
    "Plastic rotation",
    "Toe stress",
    "Slip",
    "Base shear",
    "Spread",
];
/// Labels of the energies.
pub const ENERGIES: [&str; 8] = [
    "Input of the ground",
    "Damping of wall and liquid",
    "Stored in the base",
    "Plastic joint",
    "Anchors that yield or break",
    "Radiated into the soil",
    "Friction under the bottom plate",
    "Kinetic and stored in wall and liquid",
];
/// Head of the shares.
pub const SHARE: &str = "Share of the input";
/// No number.
pub const NONE: &str = "–";
/// Legend of both sides.
pub const SIDES: [&str; 2] = ["θ = 0°", "θ = 180°"];
/// Legend of the loop and of the backbone.
pub const LOOP: [&str; 2] = ["around the largest rotation", "strips, pressure at rest"];
/// Titles of the figures.
pub const FIGURES: [&str; 7] = [
    "Uplift of the rim over time",
    "Rotation of the base over time",
    "Moment of the base against its rotation",
    "Uplift around the circumference at its largest",
    "Plan of the bottom at the largest uplift",
    "Positions over the cycle of the largest rotation",
    "Largest force of each anchor",
];
/// Legend of the forces of the anchors: force, force at which one yields.
pub const BOLTS: [&str; 2] = ["largest of the run", "yields"];
/// Axes.
pub const AXES: [&str; 5] = ["Uplift", "Rotation", "Moment", "Time", "Force"];

/// Title of the slip over time, and its axis.
pub const SLIP: [&str; 2] = ["Slip of the tank over time", "Slip"];
/// Heads of the pressures of the ground by angle.
pub const PRESSURES: [&str; 2] = ["Contact pressure at the wall", "Largest along this direction"];

/// A pressure of the ground and its place.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Pressed {
    /// Pressure [Pa].
    pub value: f64,
    /// Angle [°].
    pub degrees: f64,
    /// Distance inwards from the wall [m].
    pub inwards: f64,
}

/// In the middle of the plan of the bottom.
pub const ON_THE_GROUND: &str = "on the ground";
/// A position without uplift.
pub const STANDS: &str = "on the ground all round";
/// Heads of the table of positions.
pub const POSITIONS: [&str; 3] = ["Time", "Rim at θ = 0°", "Rim at θ = 180°"];

/// An instant.
pub fn at(time: f64) -> String {
    format!("t = {} s", fixed(time, 2))
}

/// How far a side lifts.
pub fn lifts(by: &str, back: bool) -> String {
    format!("{by} at {}", SIDES[usize::from(back)])
}

/// What the plan of the bottom shows.
pub fn plan(share: f64, time: f64, widest: f64) -> String {
    format!(
        "At t = {} s {} of the bottom is off the ground, up to {} from the rim.",
        fixed(time, 2),
        percent(share),
        display(widest, Dimension::Length)
    )
}

/// What the colours of the plan show.
pub fn pressed(rest: f64, most: &Pressed, colour: f64) -> String {
    let stress = |value: f64| display(value, Dimension::Stress);
    let place = match most.inwards > 0.0 {
        true => format!(", {} inside the wall", display(most.inwards, Dimension::Length)),
        false => " under the wall".to_owned(),
    };
    let above = match most.value > colour * (1.0 + 1e-9) {
        true => format!(" The brightest colour is {} and more.", stress(colour)),
        false => String::new(),
    };
    format!(
        "Colours: contact pressure of the ground, without colour off it; {} under the whole liquid at rest; the largest is {} at θ = {}°{place}.{above}",
        stress(rest),
        stress(most.value),
        fixed(most.degrees, 0)
    )
}

/// Cycles of the joint against its limit [rad].
pub fn joint(joint: &JointCycles, limit: f64) -> String {
    if joint.range <= 0.0 {
        return "The joint between wall and bottom plate does not yield when it lifts.".into();
    }
    let counts: Vec<String> = joint
        .counts
        .iter()
        .map(|[share, number]| format!("{} of at least {} rad", plain_count(*number), fixed(share * limit, 2)))
        .collect();
    format!(
        "Cycles of the joint's plastic rotation (rainflow, at θ = {}°): largest range {}, limit {} rad; cycles: {}. The rotation is that of the first uplift          to each height; a joint that is set down again turns back at most to zero, so the ranges are upper bounds.",
        fixed(joint.degrees, 0),
        rotation(joint.range),
        fixed(limit, 2),
        counts.join(", ")
    )
}

/// A number of cycles; half cycles count as halves.
fn plain_count(number: f64) -> String {
    if number.fract() == 0.0 { fixed(number, 0) } else { fixed(number, 1) }
}

/// What the positions show.
pub fn cycle(factor: f64) -> String {
    format!("Displacements are drawn {factor} times; the surface of the liquid is drawn level.")
}

/// A value whose limit is exceeded.
pub fn beyond(value: &str, limit: f64) -> String {
    format!("{value} (above {} rad)", fixed(limit, 2))
}

/// A rotation in rad.
pub fn rotation(value: f64) -> String {
    format!("{} rad", fixed(value, 5))
}

/// Ground, hysteretic share and time step.
pub fn ground(run: &BaseRun) -> String {
    let origin = match run.origin {
        GroundOrigin::Given => "given",
        GroundOrigin::Waves => "from the velocity of shear waves, after Vesic",
        GroundOrigin::Assumed(FoundationKind::Soil) => "assumed for soil without data",
        GroundOrigin::Assumed(_) => "assumed for concrete",
    };
    format!(
        "Ground under the rim {} ({origin}); hysteretic share {}; time step {}.",
        display(run.modulus, Dimension::Subgrade),
        share(run.hysteretic),
        display(run.step, Dimension::Time)
    )
}

/// Spread of runs that should agree.
pub fn spread(spread: &BaseSpread) -> String {
    let value = percent(spread.relative());
    match spread.repeats() {
        true => value,
        false => {
            let [low, high] = spread.uplift.map(|v| display(v, Dimension::Length));
            format!("{value}: uplift {low} to {high}")
        }
    }
}

/// What the anchors went through.
pub fn anchors(run: &results::AnchorRun) -> String {
    let broken = match (run.broken, run.rupture_elongation) {
        (0, None) => "they are taken not to break".to_owned(),
        (0, Some(limit)) => format!("none breaks, which one does at {}", display(limit, Dimension::Length)),
        (n, _) => format!("{n} break"),
    };
    format!(
        "{} of {} anchors yield at {} each, with a stiffness of {}; at the end the largest plastic elongation is {}; {broken}. The check of the \
         anchors takes the tension of the wall on their spacing, or their own force if that is larger, of one that yields as if it stayed \
         elastic: an anchor that yields fails it.",
        run.yielded,
        run.count,
        display(run.yield_force, Dimension::Force),
        display(run.stiffness, Dimension::LineForce),
        display(run.plastic_elongation, Dimension::Length)
    )
}

/// Grounds of the band without a run, one sentence each.
pub fn missed(run: &BaseRun) -> Vec<String> {
    let sentence = |missed: &MissedBand| {
        format!(
            "No run on ground of {} under the rim: {}.",
            display(missed.modulus, Dimension::Subgrade),
            missed.reason
        )
    };
    run.missed.iter().map(sentence).collect()
}

/// Error of the energy balance.
pub fn balance(run: &BaseRun) -> String {
    format!(
        "The balance of energy closes within {} of the input. Base shear and moment of the superposed modes, whose values are reported, and of \
         the march of the base agree within {}.{}",
        percent(run.energy.error),
        percent(run.superposition),
        match run.energy.base_elastic < 0.0 {
            true => " Stored energy counts from rest: where it is negative, the base stores less at the end.",
            false => "",
        }
    )
}

/// Description of a figure with the extremes of its curve.
pub fn description(title: &str, dimension: Dimension, values: impl Iterator<Item = f64>) -> String {
    let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| (low.min(v), high.max(v)));
    format!("{title}, from {} to {}.", with_unit(low, dimension), with_unit(high, dimension))
}
