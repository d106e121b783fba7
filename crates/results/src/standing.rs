//! The base of an unanchored tank under the moments of the codes, as a part of the results.

use serde::Deserialize;
use tank::Quantity;
use tank::units::Dimension;

use crate::Method;
use crate::part::{Amount, Axis, Block, Chart, Fact, Form, Line, Look, Message, Part, Room, Scale, Table};

/// The base on all grounds under the largest moment of the procedures.
#[derive(Clone, Debug, Deserialize)]
pub struct Standing {
    /// Largest moment just above the bottom plate [N m].
    pub moment: f64,
    /// Id of its method.
    pub method: String,
    /// Weight that holds the wall down, as the sheet of the method takes it [N/m]; none of results of earlier versions, which have that at
    /// rest.
    #[serde(default)]
    pub weight: Option<f64>,
    /// Bottom pressure of the motion over that at rest, and the largest for which the strips hold, where they do not.
    #[serde(default)]
    pub softened: Option<[f64; 2]>,
    /// The grounds, the softest first.
    pub grounds: Vec<StandingGround>,
    /// The lifted plate on the ground that decides and lifts most.
    #[serde(default)]
    pub plate: Option<StandingPlate>,
}

/// The base on one ground.
#[derive(Clone, Debug, Deserialize)]
pub struct StandingGround {
    /// Modulus k [N/m³].
    pub modulus: f64,
    /// Whether checks are decided on it.
    pub decides: bool,
    /// Rotation [rad] and moment [N m], both rising.
    pub curve: Vec<[f64; 2]>,
    /// What the base does under the moment; none where it does not hold it.
    #[serde(default)]
    pub values: Option<StandingValues>,
}

/// A base under a moment.
#[derive(Clone, Copy, Debug, Deserialize)]
pub struct StandingValues {
    /// Rotation ψ [rad].
    pub rotation: f64,
    /// Uplift of the rim [m].
    pub uplift: f64,
    /// Lifted width [m].
    pub lifted_width: f64,
    /// Plastic rotation of the joint [rad].
    pub plastic_rotation: f64,
    /// Axial stress at the toe, compression [Pa].
    pub toe_axial_stress: f64,
}

/// The plate at the lifted side.
#[derive(Clone, Debug, Deserialize)]
pub struct StandingPlate {
    /// Modulus of the ground [N/m³].
    pub modulus: f64,
    /// Distance inwards from the rim [m], deflection upwards [m], pressure of the ground [Pa], from the inside outwards.
    pub points: Vec<[f64; 3]>,
    /// Stretches of the plate that have yielded, by their distances from the rim [m].
    pub yielded: Vec<[f64; 2]>,
}

/// Looks of the curves, the softest ground first.
const CURVES: [Look; 4] = [Look::Soft, Look::Main, Look::Hard, Look::Rock];

impl Standing {
    /// What is reported, beside the moments of `methods`.
    pub fn part(&self, methods: &[Method]) -> Part {
        let moments = self.moments(methods);
        let governing = moments.iter().find(|(method, _)| method.id == self.method);
        let label = governing.map_or(self.method.as_str(), |(method, _)| method.label.as_str());
        let id = if self.weight.is_some() { "standing-with-weight" } else { "standing-moment" };
        let about = Message::new(id)
            .with("moment", Amount::new(self.moment, Dimension::Moment))
            .with("method", Message::verbatim(label))
            .with("weight", self.weight.map(|weight| Amount::new(weight, Dimension::LineForce)));
        let plate = self.plate.iter().flat_map(|plate| [plate.lifted(), plate.pressed()]);
        let softened = self.softened.map(|[share, limit]| {
            let number = |value| Amount::new(value, Dimension::Dimensionless);
            Block::Text(Message::new("standing-softened").with("share", number(share)).with("limit", number(limit)))
        });
        let texts = [Block::Text(Message::new("standing-about")), Block::Text(about)];
        let first = [Block::Table(self.table()), Block::Chart(self.turning(&moments))];
        let texts = texts.into_iter().chain(softened);
        Part { id: "standing".into(), blocks: texts.chain(first).chain(plate.map(Block::Chart)).collect() }
    }

    /// The procedures with a moment, under the excitation of the largest.
    fn moments<'a>(&self, methods: &'a [Method]) -> Vec<(&'a Method, f64)> {
        let value = |m: &Method| m.quantities.get(Quantity::BaseMoment.id()).map(|v| v.value);
        let largest = |m: &&Method| m.id == self.method && value(m) == Some(self.moment);
        let excitation = methods.iter().find(largest).map(|m| m.excitation);
        let clauses = |m: &Method| m.steps.iter().any(|s| !s.clause.is_empty());
        let procedures = methods.iter().filter(|m| Some(m.excitation) == excitation && clauses(m));
        procedures.filter_map(|m| Some((m, value(m)?))).collect()
    }

    fn table(&self) -> Table {
        let columns = [
            ("ground", Dimension::Dimensionless, Form::Words),
            ("rotation", Dimension::Angle, Form::Fixed(5)),
            ("uplift", Dimension::Length, Form::Usual),
            ("lifted_width", Dimension::Length, Form::Usual),
            ("plastic_rotation", Dimension::Angle, Form::Fixed(5)),
            ("toe_axial_stress", Dimension::Stress, Form::Usual),
        ];
        let row = |ground: &StandingGround| {
            let modulus = Amount::new(ground.modulus, Dimension::Subgrade);
            let name = match ground.decides {
                true => modulus.into(),
                false => Message::new("standing-information").with("ground", modulus).into(),
            };
            let values = match &ground.values {
                Some(v) => {
                    [v.rotation, v.uplift, v.lifted_width, v.plastic_rotation, v.toe_axial_stress].map(Fact::from)
                }
                None => ["not-held"; 5].map(Fact::from),
            };
            std::iter::once(name).chain(values).collect()
        };
        Table::new("grounds", &columns, self.grounds.iter().map(row).collect())
    }

    /// Moment against rotation on each ground, with the moments of the codes.
    fn turning(&self, moments: &[(&Method, f64)]) -> Chart {
        let curves = self.grounds.iter().map(|ground| &ground.curve);
        let end = curves.flatten().map(|point| point[0]).fold(0.0, f64::max);
        let grounds = self.grounds.iter().enumerate().map(|(i, ground)| {
            let modulus = Amount::new(ground.modulus, Dimension::Subgrade);
            Line::new(modulus, CURVES[i.min(CURVES.len() - 1)].clone(), ground.curve.clone())
        });
        let codes = moments.iter().map(|(method, moment)| {
            let look = Look::Method(method.figure_key.clone());
            Line::new(Message::verbatim(&method.label), look, vec![[0.0, *moment], [end, *moment]])
        });
        // Between the first three, k/3, k and 3k.
        let area = match self.grounds.as_slice() {
            [soft, _, hard, ..] => {
                let corners = soft.curve.iter().chain(hard.curve.iter().rev()).copied();
                Some(Line::new(Fact::None, Look::Other, corners.collect()))
            }
            _ => None,
        };
        let x = Axis::new("rotation", Dimension::Angle, Scale::Zero);
        let y = Axis::new("moment", Dimension::Moment, Scale::Zero);
        Chart {
            room: Room::Wide,
            areas: area.into_iter().collect(),
            ..Chart::new("moment_rotation", x, y, grounds.chain(codes).collect())
        }
    }
}

impl StandingPlate {
    /// The plate, its yielded parts and the ground without load.
    fn lifted(&self) -> Chart {
        let points: Vec<[f64; 2]> = self.points.iter().map(|p| [p[0], p[1]]).collect();
        let ends = [points.first(), points.last()].into_iter().flatten();
        let level = ends.map(|p| [p[0], 0.0]).collect();
        let yielded = self.yielded.iter().enumerate().map(|(i, [from, to])| {
            let inside = |p: &&[f64; 2]| p[0] <= *from && p[0] >= *to;
            let label = (i == 0).then_some("yielded");
            Line::new(label, Look::Yielded, points.iter().filter(inside).copied().collect())
        });
        let first = [Line::new("level", Look::Level, level), Line::new("plate", Look::Main, points.clone())];
        let modulus = Amount::new(self.modulus, Dimension::Subgrade);
        let x = Axis::new("distance", Dimension::Length, Scale::Zero);
        let y = Axis::new("deflection", Dimension::Length, Scale::Zero);
        Chart {
            title: Some(Message::new("standing-lifted")),
            caption: Some(Message::new("standing-exaggerated").with("ground", modulus)),
            ..Chart::new("plate", x, y, first.into_iter().chain(yielded).collect())
        }
    }

    /// The pressure of the ground.
    fn pressed(&self) -> Chart {
        let points: Vec<[f64; 2]> = self.points.iter().map(|p| [p[0], p[2]]).collect();
        let ends = [points.first(), points.last()].map(|p| p.map(|p| [p[0], 0.0]));
        let corners = ends[0].into_iter().chain(points.iter().copied()).chain(ends[1]);
        let area = Line::new(Fact::None, Look::Other, corners.collect());
        let x = Axis::new("distance", Dimension::Length, Scale::Zero);
        let y = Axis::new("pressure", Dimension::Stress, Scale::Zero);
        Chart {
            title: Some(Message::new("standing-pressed")),
            areas: vec![area],
            ..Chart::new("pressure", x, y, vec![Line::new(Fact::None, Look::Ground, points)])
        }
    }
}
