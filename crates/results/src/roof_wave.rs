//! The wave and the roof, as a part of the results.

use tank::units::Dimension;

use crate::part::{Amount, Block, Fact, Form, Message, Part, Table};

/// A wave that presses on a fixed roof, by a method.
#[derive(Clone, Debug)]
pub struct Pressed {
    /// Label of the method.
    pub label: String,
    /// Whether under the spectrum of the site, not the record.
    pub site: bool,
    /// Crest [m].
    pub crest: f64,
    /// Distance from the axis from which it presses [m].
    pub from: f64,
    /// Pressure of the liquid at rest [Pa].
    pub pressure: f64,
    /// Share of the convective mass that moves with the tank.
    pub share: f64,
    /// That mass [kg]; none of a method without a convective mass.
    pub mass: Option<f64>,
    /// Its force with the impulsive acceleration of the method [N].
    pub shear: Option<f64>,
    /// The same over the base shear of the method.
    pub of_shear: Option<f64>,
    /// Velocity at which the surface meets the roof [m/s].
    pub speed: f64,
    /// Angle between surface and roof [rad].
    pub angle: f64,
    /// Range of the pressure of impact [Pa].
    pub impact: [f64; 2],
}

/// A sloshing mode under a floating roof.
#[derive(Clone, Copy, Debug)]
pub struct Carried {
    /// Period of the free surface [s].
    pub free: f64,
    /// The same with the mass of the roof [s].
    pub loaded: f64,
    /// Its wave at the wall [m]; none without a spectrum there.
    pub wave: Option<f64>,
}

/// What the second mode does to a floating roof.
#[derive(Clone, Copy, Debug)]
pub struct Bent {
    /// Radial curvature at the wall [1/m].
    pub curvature: f64,
    /// Mean shortening of the radius of a membrane.
    pub shortening: f64,
}

impl Pressed {
    /// Method and excitation.
    fn name(&self) -> Message {
        let id = if self.site { "roof_wave-site" } else { "roof_wave-record" };
        Message::new(id).with("method", Message::verbatim(&self.label))
    }
}

/// The part of a fixed roof; none where no wave reaches it.
///
/// * `freeboard`: [m]
pub fn fixed(freeboard: f64, pressed: &[Pressed]) -> Option<Part> {
    let highest = pressed.iter().max_by(|a, b| a.crest.total_cmp(&b.crest))?;
    let about = Message::new("roof_wave-reached")
        .with("crest", Amount::new(highest.crest, Dimension::Length))
        .with("method", highest.name())
        .with("freeboard", Amount::new(freeboard, Dimension::Length));
    let columns = [
        ("method", Dimension::Dimensionless, Form::Words),
        ("crest", Dimension::Length, Form::Usual),
        ("from", Dimension::Length, Form::Usual),
        ("pressure", Dimension::Stress, Form::Usual),
        ("stopped", Dimension::Dimensionless, Form::Percent),
        ("mass", Dimension::Mass, Form::Usual),
        ("shear", Dimension::Force, Form::Usual),
        ("of_shear", Dimension::Dimensionless, Form::Percent),
    ];
    let rest = |one: &Pressed| -> Vec<Fact> {
        let known = [one.crest, one.from, one.pressure, one.share].map(Fact::from);
        let open = [one.mass, one.shear, one.of_shear].map(Fact::from);
        std::iter::once(one.name().into()).chain(known).chain(open).collect()
    };
    let impact = [
        ("method", Dimension::Dimensionless, Form::Words),
        ("speed", Dimension::Velocity, Form::Usual),
        ("angle", Dimension::Angle, Form::Degrees(1)),
        ("least", Dimension::Stress, Form::Usual),
        ("most", Dimension::Stress, Form::Usual),
    ];
    let blow = |one: &Pressed| -> Vec<Fact> {
        let values = [one.speed, one.angle, one.impact[0], one.impact[1]].map(Fact::from);
        std::iter::once(one.name().into()).chain(values).collect()
    };
    let blocks = vec![
        Block::Text(about),
        Block::Table(Table::new("at_rest", &columns, pressed.iter().map(rest).collect())),
        Block::Note(Message::new("roof_wave-stopped")),
        Block::Table(Table::new("impact", &impact, pressed.iter().map(blow).collect())),
        Block::Note(Message::new("roof_wave-range")),
    ];
    Some(Part { id: "roof_wave".into(), blocks })
}

/// The part of a floating roof with its first two modes.
///
/// * `mass`: of the roof per area [kg/m²]
pub fn floating(mass: f64, modes: [Carried; 2], bent: Option<Bent>) -> Part {
    let columns = [
        ("mode", Dimension::Dimensionless, Form::Given),
        ("free", Dimension::Time, Form::Usual),
        ("loaded", Dimension::Time, Form::Usual),
        ("wave", Dimension::Length, Form::Usual),
    ];
    let row = |(i, mode): (usize, &Carried)| -> Vec<Fact> {
        vec![Fact::from((i + 1) as f64), mode.free.into(), mode.loaded.into(), mode.wave.into()]
    };
    let mut blocks = vec![
        Block::Text(Message::new("roof_wave-carried").with("mass", Amount::new(mass, Dimension::AreaMass))),
        Block::Table(Table::new("modes", &columns, modes.iter().enumerate().map(row).collect())),
    ];
    if let (Some(bent), Some(wave)) = (bent, modes[1].wave) {
        let curvature = Amount::new(1.0 / bent.curvature, Dimension::Length);
        let about = Message::new("roof_wave-bent")
            .with("wave", Amount::new(wave, Dimension::Length))
            .with("radius", curvature)
            .with("shortening", Amount::ratio(bent.shortening).form(Form::Significant(2)));
        blocks.push(Block::Text(about));
    }
    blocks.push(Block::Note(Message::new("roof_wave-assumed")));
    Part { id: "roof_wave".into(), blocks }
}
