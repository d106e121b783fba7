//! Subjects of a run that were results of their own up to format 3, as parts.

use serde_json::{Map, Value, json};
use tank::units::Dimension;

use crate::part::{
    Amount, Axis, Block, Chart, Fact, Finding, Form, History, Line, Look, Message, Part, Room, Scale, Table,
};
use crate::{Channel, Method, Standing, Transfer};

/// Moves the subjects of a run into its `parts`.
///
/// * `height`: that of the wall [m]
pub(super) fn collect(run: &mut Map<String, Value>, height: Option<f64>) {
    let two = run.get("histories").and_then(Value::as_array).is_some_and(|all| {
        let y = Channel::IsolatorDisplacementY.id();
        all.iter().any(|history| history["id"] == json!(y))
    });
    let mut parts: Vec<Part> = run.remove("isolation").iter().map(|old| isolation(old, two)).collect();
    parts.extend(run.remove("soil").iter().map(soil));
    let transfer = run.remove("transfer").and_then(|old| serde_json::from_value::<Transfer>(old).ok());
    parts.extend(transfer.map(|found| found.part()));
    parts.extend(run.remove("tilt").iter().map(|old| tilt(old, height)));
    if !parts.is_empty() {
        run.insert("parts".into(), serde_json::to_value(parts).unwrap_or_default());
    }
}

/// Moves the base under the moments of the codes into the parts of the results.
pub(super) fn standing(map: &mut Map<String, Value>) {
    let methods = map.get("methods").cloned().unwrap_or_default();
    let methods: Vec<Method> = serde_json::from_value(methods).unwrap_or_default();
    let old = map.remove("standing").and_then(|old| serde_json::from_value::<Standing>(old).ok());
    if let Some(part) = old.map(|found| found.part(&methods)) {
        map.insert("parts".into(), serde_json::to_value([part]).unwrap_or_default());
    }
}

fn number(old: &Value, key: &str) -> f64 {
    old[key].as_f64().unwrap_or_default()
}

/// A list; empty where it is missing or not what it should be.
fn list<T: serde::de::DeserializeOwned>(old: &Value, key: &str) -> Vec<T> {
    serde_json::from_value(old[key].clone()).unwrap_or_default()
}

/// Sentences by how they begin; one that is not `known` as it was written, in English.
fn sentences(old: &Value, key: &str, subject: &str, known: &[(&str, &str)]) -> Block {
    let sentence = |text: String| match known.iter().find(|(begins, _)| text.starts_with(begins)) {
        Some((_, id)) => Message::new(&format!("{subject}-{id}")),
        None => Message::verbatim(&text),
    };
    Block::List { items: list(old, key).into_iter().map(sentence).collect() }
}

/// Values with those on a base that does not move, and those that are not printed in the usual form.
fn values(old: &Value, fixed: &Value, forms: &[(&str, Form)]) -> Block {
    let mut values: Vec<Finding> = list(old, "quantities");
    for value in &mut values {
        value.held = fixed[&value.id].as_f64();
        if let Some((_, form)) = forms.iter().find(|(id, _)| *id == value.id) {
            value.form = *form;
        }
    }
    Block::values("values", values)
}

/// Assumptions on isolators.
const ISOLATION: [(&str, &str); 11] = [
    ("The slab is rigid", "rigid"),
    ("Wall and liquid follow", "follows"),
    ("The tank's mass", "mass"),
    ("Force of the outermost", "outermost"),
    ("Effective period", "cycle"),
    ("Mesh errors", "mesh"),
    ("Lower and upper", "bounded"),
    ("Friction and restoring", "weight"),
    ("Without a vertical", "weight-at-rest"),
    ("Both horizontal", "circle"),
    ("One horizontal", "one-component"),
];

fn isolation(old: &Value, two: bool) -> Part {
    let amount = |key, unit| Amount::new(number(old, key), unit);
    let isolators = Message::new("isolation-isolators")
        .with("kind", old["kind"].as_str().unwrap_or_default())
        .with("dampers", if old["dampers"] == json!(true) { "yes" } else { "no" })
        .with("slab", amount("slab_mass", Dimension::Mass))
        .with("mass", amount("mass", Dimension::Mass))
        .with("step", amount("step", Dimension::Time).form(Form::Given));
    let forms = [("effective_damping", Form::Percent), ("bearing_share", Form::Fixed(2))];
    let mut channels = vec![Channel::IsolatorDisplacement];
    channels.extend(two.then_some(Channel::IsolatorDisplacementY));
    let columns = [
        ("factor", Dimension::Dimensionless, Form::Given),
        ("isolator_displacement", Dimension::Length, Form::Usual),
        ("isolator_force", Dimension::Force, Form::Usual),
        ("effective_period", Dimension::Time, Form::Usual),
        ("effective_damping", Dimension::Dimensionless, Form::Percent),
        ("base_shear", Dimension::Force, Form::Usual),
        ("sloshing_height", Dimension::Length, Form::Usual),
    ];
    let row = |old: Value| columns.map(|(id, ..)| Fact::from(number(&old, id))).to_vec();
    let bands = list(old, "band").into_iter().map(row).collect();
    let energy = &old["energy"];
    let balance = Message::new("isolation-balance")
        .with("error", Amount::ratio(number(energy, "error").max(1e-16)).form(Form::Significant(1)))
        .with("superposition", Amount::percent(number(old, "superposition")));
    let x = Axis::new("displacement", Dimension::Length, Scale::Free);
    let y = Axis::new("force", Dimension::Force, Scale::Free);
    let cycles = Line::new(Fact::None, Look::Thin, list(old, "cycles"));
    Part {
        id: "isolation".into(),
        blocks: vec![
            Block::Text(Message::new("isolation-beside")),
            Block::Note(isolators),
            values(old, &old["fixed"], &forms),
            Block::History(History::new("isolator_displacement", "displacement", &channels)),
            Block::Chart(Chart::new("loop", x, y, vec![cycles])),
            Block::Table(Table::new("band", &columns, bands)),
            Block::Note(Message::new("isolation-bounds")),
            Block::Table(Table::energies(["input", "viscous", "isolators", "body"].map(|id| (id, number(energy, id))))),
            Block::Note(balance),
            sentences(old, "assumptions", "isolation", &ISOLATION),
        ],
    }
}

/// Assumptions on soil.
const SOIL: [(&str, &str); 6] = [
    ("The slab is rigid", "rigid"),
    ("Soil as cones", "meek"),
    ("The bottom pressure", "bottom"),
    ("Modal damping", "modal"),
    ("Vertical motion", "vertical"),
    ("Without `tank.", "no-mass"),
];

/// Slab and soil under it.
fn ground(old: &Value) -> Message {
    let amount = |key: &str, unit| Amount::new(number(old, key), unit);
    let given = |key: &str, unit| amount(key, unit).form(Form::Given);
    let plate = match number(old, "thickness") > 0.0 {
        true => Message::new("soil-slab")
            .with("thickness", given("thickness", Dimension::Length))
            .with("mass", amount("slab_mass", Dimension::Mass)),
        false => Message::new("soil-slab-without-mass"),
    };
    Message::new("soil-ground")
        .with("slab", plate.with("radius", given("radius", Dimension::Length)))
        .with("velocity", given("shear_wave_velocity", Dimension::Velocity))
        .with("density", given("density", Dimension::Density))
        .with("poisson", amount("poisson_ratio", Dimension::Dimensionless).form(Form::Fixed(3)))
        .with("horizontal", amount("horizontal", Dimension::LineForce))
        .with("rocking", amount("rocking", Dimension::RotationalStiffness))
        .with("mass", amount("impulsive_mass", Dimension::Mass))
        .with("arm", amount("impulsive_arm", Dimension::Length))
        .with("damping", Amount::percent(number(old, "fixed_damping")))
}

fn soil(old: &Value) -> Part {
    let some = |key, unit| {
        let amount = Amount::new(number(old, key), unit);
        Fact::from(Some(amount).filter(|amount| amount.value > 0.0))
    };
    let free = |id| (id, Dimension::Dimensionless, Form::Usual);
    let words = |id| (id, Dimension::Dimensionless, Form::Words);
    let inertia = |key| some(key, Dimension::RotationalInertia);
    let cones = [
        [
            "translation".into(),
            some("horizontal", Dimension::LineForce),
            some("horizontal_dashpot", Dimension::Dashpot),
            Fact::None,
        ],
        ["rocking".into(), some("rocking", Dimension::RotationalStiffness), Fact::None, inertia("trapped_inertia")],
        [
            "internal".into(),
            Fact::None,
            some("rocking_dashpot", Dimension::RotationalDashpot),
            inertia("internal_inertia"),
        ],
    ];
    let fixed = number(old, "fixed_period");
    let row = |id: &str, period: f64, damping: Option<f64>| {
        vec![id.into(), period.into(), (period / fixed).into(), damping.into()]
    };
    let modes: Vec<Value> = list(old, "effective");
    let modes = modes
        .iter()
        .map(|mode| row(mode["id"].as_str().unwrap_or_default(), number(mode, "period"), mode["damping"].as_f64()));
    let effective = std::iter::once(row("fixed", fixed, Some(number(old, "fixed_damping")))).chain(modes);
    let columns = [
        words("mode"),
        ("period", Dimension::Time, Form::Fixed(4)),
        ("ratio", Dimension::Dimensionless, Form::Fixed(3)),
        ("damping", Dimension::Dimensionless, Form::Percent),
    ];
    let all: Vec<Finding> = list(old, "quantities");
    let beside: Vec<Value> = list(old, "beside");
    let beside = beside.iter().filter_map(|both| {
        let value: crate::Value = serde_json::from_value(both["soil"].clone()).ok()?;
        Some(Finding {
            held: both["fixed"]["value"].as_f64(),
            ..Finding::new(both["id"].as_str()?, value.value, value.dimension)
        })
    });
    let history = |channel: Channel| Block::History(History::new(&channel.id(), "axis", &[channel]));
    Part {
        id: "soil".into(),
        blocks: vec![
            Block::Text(Message::new("soil-about")),
            Block::Note(ground(old)),
            Block::Table(Table::new(
                "cones",
                &[words("impedance"), free("spring"), free("dashpot"), free("inertia")],
                cones.map(Vec::from).to_vec(),
            )),
            Block::Table(Table::new("effective", &columns, effective.collect())),
            Block::Note(Message::new("soil-definitions")),
            Block::values("motion", all.into_iter().filter(|found| found.time.is_some()).collect()),
            Block::values("beside", beside.collect()),
            history(Channel::FoundationTranslation),
            history(Channel::FoundationRotation),
            sentences(old, "assumptions", "soil", &SOIL),
        ],
    }
}

fn tilt(old: &Value, height: Option<f64>) -> Part {
    let value = |id, dimension| Finding::new(id, number(old, id), dimension);
    let (r, surface): (Vec<f64>, Vec<f64>) = (list(old, "r"), list(old, "surface"));
    let rise = surface.iter().fold(0.0, |most: f64, rise| most.max(rise.abs()));
    let resultants = vec![
        Finding { form: Form::Degrees(2), ..value("angle", Dimension::Angle) },
        value("base_shear", Dimension::Force),
        value("base_moment", Dimension::Moment),
        value("overturning_moment", Dimension::Moment),
        Finding::new("rise", rise, Dimension::Length),
    ];
    let mut blocks = vec![Block::Note(Message::new("tilt-rest")), Block::values("resultants", resultants)];
    if let Block::List { items } = sentences(old, "notes", "tilt", &[]) {
        blocks.extend(items.into_iter().map(Block::Text));
    }
    blocks.push(Block::Note(Message::new("tilt-over-height")));
    blocks.extend(list::<Value>(old, "lines").iter().filter_map(|line| both_sides(line, height)).map(Block::Chart));
    let columns = ["r", "rise"].map(|id| (id, Dimension::Length, Form::Usual));
    let rows = r.into_iter().zip(surface).map(|(r, rise)| vec![r.into(), rise.into()]);
    blocks.push(Block::Series(Table::new("surface", &columns, rows.collect())));
    Part { id: "tilt".into(), blocks }
}

/// A line of the tilted tank over the height.
fn both_sides(old: &Value, height: Option<f64>) -> Option<Chart> {
    let (id, z): (&str, Vec<f64>) = (old["id"].as_str()?, list(old, "z"));
    let unit: Dimension = serde_json::from_value(old["dimension"].clone()).ok()?;
    let side = |key: &str, look| {
        let points = list::<f64>(old, key).into_iter().zip(&z);
        Line::new(key, look, points.map(|(value, z)| [value, *z]).collect())
    };
    let title = match id {
        "pressure" => "tilt-on-wall-pressure".to_owned(),
        id => format!("on-wall-{id}"),
    };
    let top = height.or(z.last().copied()).filter(|_| z.len() > 1)?;
    let y = Axis::new("height", Dimension::Length, Scale::Range([0.0, top]));
    let lines = vec![side("low", Look::Main), side("high", Look::Other)];
    Some(Chart {
        title: Some(Message::new("tilt-chart").with("of", Message::new(&title))),
        room: Room::Tall,
        ..Chart::new(id, Axis::new(&title, unit, Scale::Zero), y, lines)
    })
}
