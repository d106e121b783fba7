//! Courses: of one material, or of layers with bars.

use tank::units::Dimension;
use tank::{BarDirection, Behaviour, Course, Layer, LayerKind, Material, Reinforcement};

use super::materials::{MAX_MATERIALS, MAX_NAME, Materials};
use super::tank::{HEIGHT, THICKNESS};
use super::{Limits, Resolver, like_unit, range_fault};
use crate::input::tank::read::{Field, FromNode, list, nearest};
use crate::input::tank::schema;
use crate::input::tank::syntax::join;
use crate::input::tank::values::Length;

/// Most courses a wall may have.
const MAX_COURSES: usize = 200;
/// Most layers a course may have.
const MAX_LAYERS: usize = 20;
/// Most layers of bars a shell may have.
const MAX_BARS: usize = 20;
/// Most names of materials in a message.
const SHOWN_NAMES: usize = 20;

/// What a material is to be used for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Use {
    /// A shell of the wall, the bottom plate.
    Shell,
    /// A layer between two shells.
    Interlayer,
    /// Bars in concrete.
    Bars,
}

/// The material of this name; an unknown name or one of the wrong kind is a fault, a faulty material is not another one.
pub(super) fn material(
    r: &mut Resolver<'_>,
    field: &Field<String>,
    materials: &Materials,
    purpose: Use,
) -> Option<Material> {
    r.echo_given(field);
    let name = field.value.as_ref()?;
    if let Some(material) = materials.get(name) {
        let material = material.clone()?;
        let (fits, what, allowed) = match (purpose, material.behaviour) {
            (Use::Shell, b) => (
                matches!(b, Behaviour::Elastic | Behaviour::Steel(_) | Behaviour::Concrete(_)),
                "a shell",
                "an elastic material, steel or concrete",
            ),
            (Use::Interlayer, b) => (
                matches!(b, Behaviour::Elastic | Behaviour::Interlayer(_)),
                "an interlayer",
                "an elastic material or one with the behaviour interlayer",
            ),
            (Use::Bars, b) => (
                matches!(
                    b,
                    Behaviour::Elastic | Behaviour::Steel(_) | Behaviour::Reinforcement(_)
                ),
                "bars",
                "an elastic material, steel or reinforcement",
            ),
        };
        if fits {
            return Some(material);
        }
        let message = format!(
            "the material `{name}` is {}, not one for {what}",
            material.behaviour.kind()
        );
        r.faults.push(range_fault(field, &message, allowed));
        return None;
    }
    let short = |name: &&str| name.len() <= 4 * MAX_NAME;
    let known: Vec<&str> = (materials.keys().map(String::as_str).filter(short))
        .take(SHOWN_NAMES)
        .collect();
    let allowed = match known.as_slice() {
        [] => "a name from `materials`, which has none".into(),
        names if names.len() < materials.len() => {
            let more = materials.len() - names.len();
            format!("a name from `materials`: {} and {more} more", names.join(", "))
        }
        names => format!("a name from `materials`: {}", list(names, "or")),
    };
    let mut fault = range_fault(field, &format!("unknown material `{name}`"), &allowed);
    if let Some(near) = nearest(name, materials.keys().map(String::as_str).take(MAX_MATERIALS)) {
        fault = fault.help(format!("did you mean \"{near}\"?"));
    }
    r.faults.push(fault);
    None
}

/// All courses; `None` if one is faulty.
pub(super) fn courses(
    r: &mut Resolver<'_>,
    field: &Field<Vec<Field<schema::Course>>>,
    materials: &Materials,
) -> Option<Vec<Course>> {
    let list = field.value.as_ref()?;
    if list.is_empty() || list.len() > MAX_COURSES {
        let fault = range_fault(
            field,
            "too few or too many courses",
            &format!("1 to {MAX_COURSES} courses"),
        );
        r.faults.push(fault.found(format!("{} courses", list.len())));
        return None;
    }
    let mut courses = Vec::with_capacity(list.len());
    for field in list {
        let Some(c) = &field.value else { continue };
        let height = r.number(&c.height, HEIGHT);
        courses.extend(match &c.layers {
            Some(layers) => layered(r, c, height, layers, materials),
            None => uniform(r, field, c, height, materials),
        });
    }
    // A course that dropped out has left a fault; the others still serve the cross-checks if all are there.
    (courses.len() == list.len()).then_some(courses)
}

fn uniform(
    r: &mut Resolver<'_>,
    field: &Field<schema::Course>,
    c: &schema::Course,
    height: f64,
    materials: &Materials,
) -> Option<Course> {
    let thickness = match &c.thickness {
        Some(field) => r.number(field, THICKNESS),
        None => {
            missing::<Length, _>(r, field, "thickness");
            f64::NAN
        }
    };
    match &c.material {
        Some(name) => material(r, name, materials, Use::Shell).map(|m| Course::uniform(height, thickness, m)),
        None => {
            missing::<String, _>(r, field, "material");
            None
        }
    }
}

/// Notes that a key is missing.
fn missing<T: FromNode, U>(r: &mut Resolver<'_>, object: &Field<U>, key: &str) {
    // A misspelt key has been noted already, with this one as the suggestion.
    if r.faults.suggest(&format!("did you mean `{key}`?")) || r.faults.suggest("did you mean `layers`?") {
        return;
    }
    let field = Field::<T> {
        value: None,
        span: object.span.start..object.span.start + 1,
        path: join(&object.path, key),
        text: String::new(),
    };
    r.faults.push(
        range_fault(&field, &format!("the key `{key}` is missing"), &T::allowed())
            .help(format!("add \"{key}\": {}, or layers", T::example())),
    );
}

fn layered(
    r: &mut Resolver<'_>,
    c: &schema::Course,
    height: f64,
    field: &Field<Vec<Field<schema::Layer>>>,
    materials: &Materials,
) -> Option<Course> {
    let own = [
        ("thickness", c.thickness.as_ref().map(Field::place)),
        ("material", c.material.as_ref().map(Field::place)),
    ];
    for (key, given) in own {
        if let Some(given) = given {
            r.faults.push(range_fault(
                &given,
                &format!("a course of layers has no {key} of its own"),
                "either thickness and material, or layers",
            ));
        }
    }
    let list = field.value.as_ref()?;
    if list.is_empty() || list.len() > MAX_LAYERS {
        let fault = range_fault(
            field,
            "too few or too many layers",
            &format!("1 to {MAX_LAYERS} layers"),
        );
        r.faults.push(fault.found(format!("{} layers", list.len())));
        return None;
    }
    order(r, field, list);
    let mut layers = Vec::with_capacity(list.len());
    for l in list.iter().filter_map(|f| f.value.as_ref()) {
        layers.extend(layer(r, l, materials));
    }
    let shells = layers.iter().any(|l| l.kind == LayerKind::Shell);
    (shells && layers.len() == list.len()).then(|| Course::layered(height, layers))
}

/// An interlayer stands between two shells, and there is at most one.
fn order(r: &mut Resolver<'_>, field: &Field<Vec<Field<schema::Layer>>>, list: &[Field<schema::Layer>]) {
    // A layer whose kind is unknown may be a shell.
    let between = |f: &Field<schema::Layer>| {
        f.value
            .as_ref()
            .is_some_and(|l| l.kind.value == Some(schema::LayerKind::Interlayer))
    };
    let places: Vec<usize> = (0..list.len()).filter(|&i| between(&list[i])).collect();
    for &i in &places {
        if i > 0 && i + 1 < list.len() && !between(&list[i - 1]) && !between(&list[i + 1]) {
            continue;
        }
        let side = if i == 0 {
            "no shell inside"
        } else if i + 1 == list.len() {
            "no shell outside"
        } else {
            "an interlayer beside it"
        };
        r.faults.push(
            range_fault(
                &list[i],
                "an interlayer stands between two shells",
                "shell, interlayer, shell from inside to outside",
            )
            .found(side),
        );
        return;
    }
    if places.len() > 1 {
        r.faults.push(
            range_fault(
                field,
                "more than one interlayer",
                "at most one, with shells on both sides",
            )
            .found(format!("{} interlayers", places.len())),
        );
    }
}

fn layer(r: &mut Resolver<'_>, l: &schema::Layer, materials: &Materials) -> Option<Layer> {
    r.echo_given(&l.kind);
    let thickness = r.number(&l.thickness, THICKNESS);
    let (kind, purpose) = match l.kind.value {
        Some(schema::LayerKind::Shell) => (LayerKind::Shell, Use::Shell),
        Some(schema::LayerKind::Interlayer) => (LayerKind::Interlayer, Use::Interlayer),
        None => return None,
    };
    let material = material(r, &l.material, materials, purpose);
    let mut reinforcement = Vec::new();
    if let Some(field) = &l.reinforcement
        && let Some(list) = &field.value
    {
        let fault = match (kind, material.as_ref().map(|m| m.behaviour)) {
            (LayerKind::Interlayer, _) => Some("bars in an interlayer"),
            (_, Some(Behaviour::Steel(_))) => Some("bars in a layer of steel"),
            (_, Some(Behaviour::Elastic)) => Some("bars in an elastic layer"),
            _ => None,
        };
        if let Some(message) = fault {
            let found = format!("layer of `{}`", l.material.text);
            r.faults
                .push(range_fault(field, message, "bars in shells of concrete only").found(found));
        } else if list.is_empty() || list.len() > MAX_BARS {
            r.faults.push(
                range_fault(field, "too few or too many layers of bars", &format!("1 to {MAX_BARS}"))
                    .found(list.len().to_string()),
            );
        } else {
            for field in list {
                reinforcement.extend(bars(r, field, &l.thickness, thickness, materials));
            }
        }
    }
    Some(Layer {
        kind,
        thickness,
        material: material?,
        reinforcement,
    })
}

/// One layer of bars in a shell of this thickness [m].
fn bars(
    r: &mut Resolver<'_>,
    field: &Field<schema::Reinforcement>,
    shell: &Field<Length>,
    thickness: f64,
    materials: &Materials,
) -> Option<Reinforcement> {
    let b = field.value.as_ref()?;
    r.echo_given(&b.direction);
    // More than a tenth of a metre of steel is no reinforcement.
    let area = r.number(&b.area, Limits::above(0.0).to(0.1));
    let given = match (&b.from_inner, &b.from_outer) {
        (Some(f), None) => Some((f, false)),
        (None, Some(f)) => Some((f, true)),
        _ => None,
    };
    let depth = match given {
        None => {
            r.faults.push(range_fault(
                field,
                "one distance from a face is wanted",
                "either from_inner or from_outer",
            ));
            f64::NAN
        }
        Some((f, from_outer)) => {
            let distance = r.number(f, Limits::above(0.0).to(10.0));
            if distance >= thickness {
                let allowed = format!(
                    "less than {}, the thickness of the shell",
                    like_unit(f, thickness, Dimension::Length)
                );
                let message = "the bars lie outside their shell";
                r.faults
                    .push(range_fault(f, message, &allowed).help(format!("the shell is given as {}", shell.text)));
            }
            if from_outer { thickness - distance } else { distance }
        }
    };
    let material = material(r, &b.material, materials, Use::Bars);
    let direction = match b.direction.value {
        Some(schema::BarDirection::Hoop) => BarDirection::Hoop,
        Some(schema::BarDirection::Vertical) => BarDirection::Vertical,
        None => return None,
    };
    Some(Reinforcement {
        direction,
        area,
        depth,
        material: material?,
    })
}
