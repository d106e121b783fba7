//! `tank.roof`.

use files::code::Code;
use tank::units::{Dimension, display};
use tank::value::Value;
use tank::{RimSupport, RoofKind, SIZE, Shape, Snow, SnowLoad};

use crate::input::diagnostic::Faults;
use crate::input::tank::choice::{choice, one_of_words, words};
use crate::input::tank::read::{Field, FromNode, Opt, object, wrong_value};
use crate::input::tank::resolver::{Resolver, like_field};
use crate::input::tank::shape::{Book, Shape as Form};
use crate::input::tank::stated::Stated;
use crate::input::tank::syntax::{Kind, Node};
use crate::input::tank::values::{Length, Mass, Number, Stress, echoed};
use tank::keys::{Absent, Limits, default, without};

/// Loads on a roof; the upper bound catches Pa written as kPa.
const LOAD: Limits = Limits::from(0.0).to(20e3).usual(0.0, 8e3);

object! {
    /// Roof, or the mass on top of the wall of an open tank.
    Roof {
        /// Kind of roof. The mass of a floating roof does not load the wall; it displaces its own mass of liquid below the level of
        /// fill_height.
        ///
        /// An open tank has the mass of the girders on top of its wall.
        r#type: Opt<RoofKind> = default(RoofKind::Fixed),
        /// Mass of the roof with what is fixed to it, without a snow load that is given as such. Of a roof on columns all that rests on them
        /// and on the wall.
        mass ("12 t"): Field<Mass> [Limits::from(0.0).to(1e9)],
        /// Height of its centre of mass above the tank bottom, not below the liquid; not of a floating roof. Without it a third of the
        /// rise of a cone, and half of that of a dome, above the wall.
        height ("11 m"): Opt<Length> [SIZE] = without("the top of the wall"),
        /// Height of the crown of a cone or dome above the top of the wall.
        rise ("1.5 m"): Opt<Length> [Limits::above(0.0).to(200.0)],
        /// Radius of the outermost ring of columns under the roof of a cylinder, `0 m` for one column in the middle. Rafters that span from it
        /// to the wall bring the share (1 − ρ)(2 + ρ)/3 of the weight to the wall, ρ being this radius over that of the tank. The inertia of
        /// the whole roof is with the wall.
        columns ("0 m"): Opt<Length> [Limits::from(0.0).to(1000.0)] = Absent::Follows("the wall carries the whole roof"),
        /// Share of the weight of the roof that the wall carries beside columns, instead of their radius.
        shell_share (0.5): Opt<Number> [Limits::from(0.0).to(1.0)],
        /// Mass of an internal floating roof below the fixed one. As that of a floating roof it displaces its own mass of liquid.
        internal_floating ("8 t"): Opt<Mass> [Limits::from(0.0).to(1e9)],
        /// Snow on the roof: a load on plan, `"none"` where no snow falls, or `"included"` where the mass of the roof contains the share of
        /// the code.
        ///
        /// Of a load the codes count a share in the mass of the roof: 10 % of the balanced design snow load by API 650 E.2.2, `snow_combination`
        /// times the characteristic snow load on the roof by EN 1998. An engine counts the largest share of the codes that judge it.
        snow ("1.2 kPa"): Opt<SnowGiven> [LOAD] = Absent::Follows("not known; the share of the snow stays open"),
        /// Share ψ_E = φ ψ_2 of the snow load in the seismic mass of EN 1998, with φ = 1. EN 1990 table A1.1 has ψ_2 = 0.2 for the Nordic
        /// countries and for places above 1000 m, and 0 for others; national annexes differ.
        snow_combination (0.2): Opt<Number> [Limits::from(0.0).to(1.0).clause("EN 1990:2002 table A1.1")] = default(Number(0.2))
            .because("EN 1990:2002 table A1.1: the larger of 0.2 and 0, on the safe side for the mass"),
        /// Live load of the roof on plan. No code counts a share of it with the earthquake: ψ_2 = 0 for roofs in EN 1990 table A1.1
        /// (category H), and W_r of API 650 E.2.2 has none.
        live_load ("1 kPa"): Opt<Stress> [LOAD],
        /// What the roof does to the top edge of the wall of a cylinder, in the pushover, the solid and the nonlinear engine and in the modes that
        /// oval the wall. A stiff wind girder on an open tank may count as round, any other is one of `tank.rings`. The foot of an unanchored cylinder
        /// warps as the edge lets it, also in `base`, in the strips of the codes and in the lifting base of the harmonic engine.
        holds ("round"): Opt<RimSupport> = Absent::Follows("round under a cone or dome, free otherwise"),
        /// Height of the rim and seal of a floating roof, external or internal, above the level of the liquid; the freeboard is less by it.
        rim ("0.8 m"): Opt<Length> [Limits::from(0.0).to(100.0)],
    }
}

choice!(RoofKind, RimSupport);

/// Snow, as written.
#[derive(Clone, Copy, Debug)]
pub(crate) enum SnowGiven {
    /// A word.
    Word(Snow),
    /// A load [Pa].
    Load(f64),
}

impl Value for SnowGiven {
    type Domain = SnowGiven;
    fn domain(self) -> SnowGiven {
        self
    }
}

echoed!(SnowGiven);

impl FromNode for SnowGiven {
    fn from_node(node: &Node, faults: &mut Faults) -> Option<Self> {
        // A text without a digit is a word.
        if let Kind::Text(text) = &node.kind
            && !text.contains(|c: char| c.is_ascii_digit())
        {
            return one_of_words(node, &words::<Snow>(), faults).map(SnowGiven::Word);
        }
        let Stress(load) = Stress::from_node(node, faults)?;
        if !LOAD.hold(load) {
            let (message, allowed) = (LOAD.message(load), LOAD.describe(Dimension::Stress));
            faults.push(wrong_value(Code::OutOfRange, node, message, &allowed));
            return None;
        }
        Some(SnowGiven::Load(load))
    }
    fn allowed() -> String {
        format!("\"none\", \"included\", or {}", Dimension::Stress.allowed())
    }
    fn example() -> String {
        "\"1.2 kPa\"".into()
    }
    fn shape(book: &mut Book) -> Form {
        Form::Either("none", Box::new(Form::Either("included", Box::new(Stress::shape(book)))))
    }
}

/// What the file says of snow in a word.
pub(super) fn snow(r: &mut Resolver<'_>, stated: &Stated<Roof>) -> Option<Snow> {
    match r.optional(&stated.value()?.snow)? {
        SnowGiven::Word(word) => Some(word),
        SnowGiven::Load(_) => None,
    }
}

/// The roof; a floating one does not load the wall.
pub(super) fn roof(r: &mut Resolver<'_>, stated: &Stated<Roof>, shape: Option<Shape>) -> tank::Roof {
    if let Some(field) = &stated.none {
        r.echo_none(field);
    } else if stated.given.is_none() {
        r.echo_default("tank.roof.mass", "0 kg", "no roof stated");
    }
    let Some(given) = stated.value() else { return tank::Roof::default() };
    let kind = r.or_default(&given.r#type);
    let mass = r.number(&given.mass);
    if kind != RoofKind::Cone && kind != RoofKind::Dome {
        let message = "rise does not apply to a roof that is neither a cone nor a dome";
        r.inapplicable(&given.rise, message, "\"type\": \"cone\" or \"dome\", or a roof without rise");
    }
    if !kind.is_fixed() {
        unfixed(r, given, kind);
    }
    // Its echo stands with the answers about the construction.
    let snow = match given.snow.value() {
        Some(SnowGiven::Load(load)) => Some(*load),
        Some(SnowGiven::Word(_)) | None => None,
    };
    let internal = given.internal_floating.given.as_ref().map_or(0.0, |field| r.number(field));
    let floats = kind == RoofKind::Floating || given.internal_floating.given.is_some();
    let rim = given.rim.given.as_ref().map_or(0.0, |rim| if floats { r.number(rim) } else { 0.0 });
    if kind == RoofKind::Floating {
        let message = "height does not apply to a floating roof";
        r.inapplicable(&given.height, message, "no height: the roof is on the liquid");
        let holds = holds(r, given, kind, shape);
        return tank::Roof { afloat: mass, kind, rim, holds, ..tank::Roof::default() };
    }
    if !floats {
        let message = "rim does not apply to a roof that does not float";
        r.inapplicable(&given.rim, message, "\"type\": \"floating\", internal_floating, or a roof without rim");
    }
    let snow = snow.map(|load| {
        let combination = r.or_default(&given.snow_combination);
        SnowLoad { load, combination, bare: mass, mass: 0.0 }
    });
    if snow.is_none() && kind.is_fixed() {
        let message = "snow_combination does not apply to a roof without a snow load";
        r.inapplicable(&given.snow_combination, message, "\"snow\": \"1.2 kPa\", or no snow_combination");
    }
    let (on_columns, columns) = columns(r, given, kind, shape);
    let holds = holds(r, given, kind, shape);
    let roof = tank::Roof {
        holds,
        mass,
        height: height(r, given, kind),
        kind,
        rise: rise(r, given, kind, shape),
        on_columns,
        columns,
        snow,
        live_load: given.live_load.given.as_ref().map(|field| r.number(field)),
        afloat: internal,
        rim,
    };
    if on_columns > 0.0 {
        r.remarks.push(format!(
            "tank.roof: columns carry {:.0} % of the weight of the roof, {}; the columns themselves, which stand in the liquid, are not checked",
            100.0 * on_columns,
            display(on_columns * mass, Dimension::Mass)
        ));
    }
    roof
}

/// What it does to the top edge of the wall.
fn holds(r: &mut Resolver<'_>, given: &Roof, kind: RoofKind, shape: Option<Shape>) -> RimSupport {
    if matches!(shape, Some(Shape::Rectangle { .. })) {
        r.inapplicable(&given.holds, "holds does not apply to a rectangle", "a cylinder, or a roof without holds");
        return RimSupport::Free;
    }
    let usual = match kind {
        RoofKind::Cone | RoofKind::Dome => RimSupport::Round,
        _ => RimSupport::Free,
    };
    given.holds.given.as_ref().map_or(usual, |field| {
        r.echo_given(field);
        field.value.unwrap_or(usual)
    })
}

/// Height of the centre of mass [m], if it is given.
fn height(r: &mut Resolver<'_>, given: &Roof, kind: RoofKind) -> Option<f64> {
    let rises = given.rise.given.is_some() && given.height.given.is_none();
    let why = match kind {
        RoofKind::Cone if rises => "a third of the rise above the top of the wall",
        RoofKind::Dome if rises => "half of the rise above the top of the wall",
        _ => return r.optional(&given.height),
    };
    r.echo_default(&given.height.path, "not given", why);
    None
}

/// Reports the keys of a fixed roof that are given of another.
fn unfixed(r: &mut Resolver<'_>, given: &Roof, kind: RoofKind) {
    let what = match kind {
        RoofKind::Floating => "a floating roof",
        _ => "an open tank",
    };
    let load = given.snow.given.as_ref().filter(|field| matches!(field.value, Some(SnowGiven::Load(_))));
    let keys = [
        ("columns", given.columns.place()),
        ("shell_share", given.shell_share.place()),
        ("internal_floating", given.internal_floating.place()),
        ("a snow load", load.map(Field::place)),
        ("snow_combination", given.snow_combination.place()),
        ("live_load", given.live_load.place()),
    ];
    for (key, place) in keys {
        if let Some(place) = place {
            let message = format!("{key} does not apply to {what}");
            r.refuse(Code::DoesNotApply, &place, &message, "a fixed roof: \"type\": \"fixed\", \"cone\" or \"dome\"");
        }
    }
}

/// Rise of a cone or dome [m].
fn rise(r: &mut Resolver<'_>, given: &Roof, kind: RoofKind, shape: Option<Shape>) -> Option<f64> {
    let field = given.rise.given.as_ref().filter(|_| matches!(kind, RoofKind::Cone | RoofKind::Dome))?;
    let rise = r.number(field);
    let half = shape.map_or(f64::INFINITY, Shape::half_length);
    if rise > half {
        let allowed = format!("at most {}, that of a hemisphere", like_field(field, half));
        r.refuse(Code::Contradiction, field, "the roof is higher than the radius of the tank", &allowed);
    }
    Some(rise)
}

/// Share of the weight that columns carry, and the radius of their outermost ring [m].
fn columns(r: &mut Resolver<'_>, given: &Roof, kind: RoofKind, shape: Option<Shape>) -> (f64, Option<f64>) {
    if !kind.is_fixed() {
        return (0.0, None);
    }
    if let (Some(_), Some(field)) = (&given.columns.given, &given.shell_share.given) {
        let message = "the share of the wall in the weight of the roof is given twice";
        r.refuse(Code::Exclusive, field, message, "either columns or shell_share");
        return (0.0, None);
    }
    if kind == RoofKind::Dome {
        let allowed = "a dome that the wall carries, or \"type\": \"cone\" or \"fixed\"";
        r.inapplicable(&given.columns, "columns do not apply to a dome", allowed);
        r.inapplicable(&given.shell_share, "shell_share does not apply to a dome", allowed);
        return (0.0, None);
    }
    if let Some(field) = &given.shell_share.given {
        return (1.0 - r.number(field), None);
    }
    let Some(field) = &given.columns.given else { return (0.0, None) };
    let ring = r.number(field);
    match shape {
        None => (0.0, None),
        Some(Shape::Rectangle { .. }) => {
            let message = "columns on a circle do not apply to a rectangle";
            r.refuse(Code::DoesNotApply, field, message, "shell_share, the share that the walls carry");
            (0.0, None)
        }
        Some(Shape::Cylinder { radius }) if ring >= radius => {
            let allowed = format!("less than {}, the radius", like_field(field, radius));
            r.refuse(Code::Contradiction, field, "the columns are not within the tank", &allowed);
            (0.0, None)
        }
        Some(Shape::Cylinder { radius }) => (1.0 - tank::Roof::share_of_wall(ring / radius), Some(ring)),
    }
}
