//! `tank.courses`: of one material, or of layers with bars.

use files::code::Code;
use tank::{HEIGHT, LayerKind};

use super::bars::{Reinforcement, all_bars, bonded};
use super::corrosion::{Common, loss};
use super::materials::Materials;
use super::named::{Use, material};
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, FromNode, Opt, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::values::Length;
use tank::keys::Limits;

/// Wall and plate thicknesses, from a foil up; the smallest follows from the radius.
pub(super) const THICKNESS: Limits = Limits::from(1e-6).to(10.0);

/// Corrosion allowances; less than the thickness.
pub(super) const CORROSION: Limits = Limits::from(0.0).to(10.0);

object! {
    /// A ring of the wall.
    Course {
        /// Height of the ring.
        height ("2.4 m"): Field<Length> [HEIGHT],
        /// Thickness of the wall. Give either this with a material, or layers.
        thickness ("8 mm"): Opt<Length> [THICKNESS],
        /// Name of its material; together with thickness.
        material ("steel"): Opt<String>,
        /// Corrosion allowance; together with thickness. Without it that of the tank. Stresses and resistances of the codes use the thickness without it, masses and
        /// stiffnesses the whole thickness.
        corrosion_allowance ("2 mm"): Opt<Length> [CORROSION],
        /// Measured thickness of a corroded wall, instead of the allowance; thickness is that as built.
        measured_thickness ("6.5 mm"): Opt<Length> [THICKNESS],
        /// Layers of the wall from inside to outside, instead of one thickness and material.
        ///
        /// A shell; shells that touch (a liner on concrete); or two shells with an interlayer between them.
        layers: Opt<Vec<Field<Layer>>> [Limits::ANY.items(1, 20)],
        /// Layers of bars in a wall of concrete; together with thickness and material. Layers have their own.
        reinforcement: Opt<Vec<Field<Reinforcement>>> [Limits::ANY.items(1, 20)],
    }

    /// A layer of the wall.
    Layer {
        /// Kind of layer.
        kind: Field<LayerKind>,
        /// Thickness of the layer.
        thickness ("25 cm"): Field<Length> [THICKNESS],
        /// Name of its material.
        material ("concrete"): Field<String>,
        /// Layers of bars in a concrete shell, for the nonlinear analysis and the checks of EN 1992.
        reinforcement: Opt<Vec<Field<Reinforcement>>> [Limits::ANY.items(1, 20)],
    }
}

choice!(LayerKind);

/// All courses; `None` if one is faulty.
pub(super) fn courses(
    r: &mut Resolver<'_>,
    field: &Field<Vec<Field<Course>>>,
    materials: &Materials,
    corrosion: Option<Common<'_>>,
) -> Option<Vec<tank::Course>> {
    let list = field.value.as_ref()?;
    if !r.sized(field, "courses") {
        return None;
    }
    let mut courses = Vec::with_capacity(list.len());
    for field in list {
        let Some(c) = &field.value else { continue };
        let height = r.number(&c.height);
        courses.extend(match &c.layers.given {
            Some(layers) => layered(r, c, height, layers, materials),
            None => uniform(r, (field, c), height, materials, corrosion),
        });
    }
    // A faulty course was already reported; the cross-checks need all courses.
    (courses.len() == list.len()).then_some(courses)
}

fn uniform(
    r: &mut Resolver<'_>,
    (field, c): (&Field<Course>, &Course),
    height: f64,
    materials: &Materials,
    corrosion: Option<Common<'_>>,
) -> Option<tank::Course> {
    let thickness = match &c.thickness.given {
        Some(field) => r.number(field),
        None => {
            missing(r, field, &c.thickness);
            f64::NAN
        }
    };
    let Some(name) = &c.material.given else {
        missing(r, field, &c.material);
        return None;
    };
    let Some(list) = &c.reinforcement.given else {
        let corrosion = loss(r, thickness, (&c.corrosion_allowance, &c.measured_thickness), corrosion);
        return material(r, name, materials, Use::Shell)
            .map(|material| tank::Course { corrosion, ..tank::Course::uniform(height, thickness, material) });
    };
    let material = material(r, name, materials, Use::Shell);
    let shell = (LayerKind::Shell, material.as_ref().map(|m| m.behaviour), name.text.as_str());
    // `uniform` has reported a thickness that is missing.
    let reinforcement = match &c.thickness.given {
        Some(given) => all_bars(r, list, shell, (given, thickness), materials),
        None => Vec::new(),
    };
    let layer = tank::Layer { kind: LayerKind::Shell, thickness, material: material?, reinforcement };
    let layer = bonded(r, layer, Some(list));
    Some(tank::Course::layered(height, vec![layer]))
}

/// Reports a missing key of a course without layers.
fn missing<T: FromNode, U>(r: &mut Resolver<'_>, object: &Field<U>, option: &Opt<T>) {
    if !r.faults.suggest("did you mean `layers`?") {
        let example = format!("{}, or layers", T::example());
        r.missing(object, option, "", &T::allowed(), &example);
    }
}

fn layered(
    r: &mut Resolver<'_>,
    c: &Course,
    height: f64,
    field: &Field<Vec<Field<Layer>>>,
    materials: &Materials,
) -> Option<tank::Course> {
    let own = [
        ("thickness", c.thickness.place()),
        ("material", c.material.place()),
        ("reinforcement", c.reinforcement.place()),
        ("corrosion_allowance", c.corrosion_allowance.place()),
        ("measured_thickness", c.measured_thickness.place()),
    ];
    for (key, given) in own {
        if let Some(given) = given {
            let message = format!("{key} does not apply to a course with layers");
            let allowed = "either thickness and material, or layers";
            r.refuse(Code::DoesNotApply, &given, &message, allowed);
        }
    }
    let list = field.value.as_ref()?;
    if !r.sized(field, "layers") {
        return None;
    }
    order(r, field, list);
    let mut layers = Vec::with_capacity(list.len());
    for l in list.iter().filter_map(|f| f.value.as_ref()) {
        layers.extend(layer(r, l, materials));
    }
    let shells = layers.iter().any(|l| l.kind == LayerKind::Shell);
    (shells && layers.len() == list.len()).then(|| tank::Course::layered(height, layers))
}

/// An interlayer is between two shells, and there is at most one.
fn order(r: &mut Resolver<'_>, field: &Field<Vec<Field<Layer>>>, list: &[Field<Layer>]) {
    // A layer whose kind is unknown may be a shell.
    let between = |f: &Field<Layer>| f.value.as_ref().is_some_and(|l| l.kind.value == Some(LayerKind::Interlayer));
    let places: Vec<usize> = (0..list.len()).filter(|&i| between(&list[i])).collect();
    for &i in &places {
        if i > 0 && i + 1 < list.len() && !between(&list[i - 1]) && !between(&list[i + 1]) {
            continue;
        }
        let side = if i == 0 {
            "an interlayer without a shell inside"
        } else if i + 1 == list.len() {
            "an interlayer without a shell outside"
        } else {
            "an interlayer next to it"
        };
        let message = "an interlayer must be between two shells";
        let allowed = "shell, interlayer, shell from inside to outside";
        let fault = range_fault(Code::Incomplete, &list[i], message, allowed);
        r.faults.push(fault.found(side));
        return;
    }
    if places.len() > 1 {
        let message = "more than one interlayer";
        let allowed = "at most one, with shells on both sides";
        let fault = range_fault(Code::ItemCount, field, message, allowed);
        r.faults.push(fault.found(format!("{} interlayers", places.len())));
    }
}

fn layer(r: &mut Resolver<'_>, l: &Layer, materials: &Materials) -> Option<tank::Layer> {
    r.echo_given(&l.kind);
    let thickness = r.number(&l.thickness);
    let kind = l.kind.value?;
    let purpose = match kind {
        LayerKind::Shell => Use::Shell,
        LayerKind::Interlayer => Use::Interlayer,
    };
    let material = material(r, &l.material, materials, purpose);
    let shell = (kind, material.as_ref().map(|m| m.behaviour), l.material.text.as_str());
    let reinforcement = match &l.reinforcement.given {
        Some(list) => all_bars(r, list, shell, (&l.thickness, thickness), materials),
        None => Vec::new(),
    };
    let layer = tank::Layer { kind, thickness, material: material?, reinforcement };
    Some(bonded(r, layer, l.reinforcement.given.as_ref()))
}
