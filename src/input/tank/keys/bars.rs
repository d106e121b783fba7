//! `reinforcement` of a wall and of its layers.

use files::code::Code;
use tank::units::Dimension;
use tank::{BarDirection, Behaviour, LayerKind, STRESS};

use super::materials::Materials;
use super::named::{Use, material};
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::{Resolver, like_unit, range_fault};
use crate::input::tank::values::{Length, LineArea, Stress};
use tank::keys::{Absent, Limits};

/// Bars: more than a tenth of a metre of steel is not reinforcement.
const AREA: Limits = Limits::from(1e-6).to(0.1);
/// Diameters of bars.
const DIAMETER: Limits = Limits::from(3e-3).to(60e-3);
/// Distances between bars.
const SPACING: Limits = Limits::from(0.02).to(1.0);
/// Distances of bars from a face.
const COVER: Limits = Limits::above(0.0).to(10.0);

object! {
    /// A layer of bars. Give its area (and the diameter), or diameter and spacing; and its distance either from the inner or from the
    /// outer face of the shell.
    Reinforcement {
        /// Direction of the bars.
        direction: Field<BarDirection>,
        /// Area of steel per metre of wall.
        area ("15 cm2/m"): Opt<LineArea> [AREA] = Absent::Follows("that of diameter and spacing; needed without them"),
        /// Diameter of a bar, needed by the crack width of EN 1992.
        diameter ("16 mm"): Opt<Length> [DIAMETER] = Absent::Follows("without it the crack width is not checked"),
        /// Distance from bar to bar; together with diameter.
        spacing ("150 mm"): Opt<Length> [SPACING] = Absent::Follows("that of area and diameter"),
        /// Distance of the axis of the bars from the inner face of their shell.
        from_inner ("4 cm"): Opt<Length> [COVER],
        /// Distance of the axis of the bars from the outer face of their shell.
        from_outer ("4 cm"): Opt<Length> [COVER],
        /// Prestress of the bars where the layer round them has no strain, after losses by friction, anchorage and relaxation; the wall that it shortens takes
        /// its part of it. Acts in walls of shells in the state at rest of the nonlinear engine.
        prestress ("1000 MPa"): Opt<Stress> [STRESS] = Absent::Follows("the bars are without prestress"),
        /// Name of their material.
        material ("bars"): Field<String>,
    }
}

choice!(BarDirection);

/// A layer whose concrete has a bond law: its bars need a diameter, and cracks a spacing.
pub(super) fn bonded(
    r: &mut Resolver<'_>,
    mut layer: tank::Layer,
    bars: Option<&Field<Vec<Field<Reinforcement>>>>,
) -> tank::Layer {
    let Behaviour::Concrete(concrete) = layer.material.behaviour else { return layer };
    if concrete.bond.is_perfect() {
        return layer;
    }
    let name = layer.material.name.clone();
    let list = bars.and_then(|field| field.value.as_ref()).map_or(&[][..], Vec::as_slice);
    for field in list {
        if field.value.as_ref().is_some_and(|b| b.diameter.given.is_none()) {
            let message = format!("the bond of `{name}` needs the diameter of the bars");
            r.faults.push(
                range_fault(Code::MissingKey, field, &message, "a diameter from 3 mm to 60 mm")
                    .help("add \"diameter\": \"16 mm\""),
            );
        }
    }
    if concrete.crack_spacing.is_none()
        && let Some(spacing) = layer.mean_crack_spacing()
    {
        let text = tank::units::display(spacing, Dimension::Length);
        r.remarks.push(format!(
            "materials.{name}: crack_spacing {text} (mean spacing of stabilised cracks, CEB-FIP Model Code 1990)"
        ));
        layer.material.behaviour = Behaviour::Concrete(tank::Concrete { crack_spacing: Some(spacing), ..concrete });
    }
    layer
}

/// Layers of bars in a shell.
///
/// * `(kind, behaviour, name)`: of the shell and its material
/// * `thickness`: of the shell, as given and in m
pub(super) fn all_bars(
    r: &mut Resolver<'_>,
    field: &Field<Vec<Field<Reinforcement>>>,
    (kind, behaviour, name): (LayerKind, Option<Behaviour>, &str),
    thickness: (&Field<Length>, f64),
    materials: &Materials,
) -> Vec<tank::Reinforcement> {
    let mut reinforcement = Vec::new();
    let Some(list) = &field.value else { return reinforcement };
    let fault = match (kind, behaviour) {
        (LayerKind::Interlayer, _) => Some("bars in an interlayer"),
        (_, Some(Behaviour::Steel(_))) => Some("bars in a layer of steel"),
        (_, Some(Behaviour::Elastic)) => Some("bars in an elastic layer"),
        _ => None,
    };
    if let Some(message) = fault {
        let found = format!("layer of `{name}`");
        r.faults.push(range_fault(Code::DoesNotApply, field, message, "bars in shells of concrete only").found(found));
    } else if r.sized(field, "layers of bars") {
        for field in list {
            reinforcement.extend(bars(r, field, thickness, materials));
        }
    }
    reinforcement
}

/// Area of a layer of bars per length of wall [m²/m]; NaN if it is not given.
fn area(r: &mut Resolver<'_>, field: &Field<Reinforcement>, b: &Reinforcement) -> (f64, Option<f64>) {
    let diameter = b.diameter.given.as_ref().map(|f| r.number(f));
    let spacing = b.spacing.given.as_ref().map(|f| r.number(f));
    let of_bars = diameter.zip(spacing).map(|(d, s)| std::f64::consts::PI * d * d / (4.0 * s));
    match (&b.area.given, of_bars) {
        (None, Some(area)) => (area, diameter),
        (Some(given), _) if spacing.is_none() => (r.number(given), diameter),
        _ => {
            let allowed = "either area (and diameter), or diameter and spacing";
            r.refuse(Code::Exclusive, field, "not exactly one area of the bars", allowed);
            (f64::NAN, diameter)
        }
    }
}

/// One layer of bars in a shell; its thickness as given and in m.
fn bars(
    r: &mut Resolver<'_>,
    field: &Field<Reinforcement>,
    (shell, thickness): (&Field<Length>, f64),
    materials: &Materials,
) -> Option<tank::Reinforcement> {
    let b = field.value.as_ref()?;
    r.echo_given(&b.direction);
    let (area, diameter) = area(r, field, b);
    let given = match (&b.from_inner.given, &b.from_outer.given) {
        (Some(f), None) => Some((f, false)),
        (None, Some(f)) => Some((f, true)),
        _ => None,
    };
    let depth = match given {
        None => {
            let message = "not exactly one distance from a face";
            r.refuse(Code::Exclusive, field, message, "either from_inner or from_outer");
            f64::NAN
        }
        Some((f, from_outer)) => {
            let distance = r.number(f);
            if distance >= thickness {
                let allowed =
                    format!("less than {}, the thickness of the shell", like_unit(f, thickness, Dimension::Length));
                let message = "the bars are outside their shell";
                r.faults.push(
                    range_fault(Code::Contradiction, f, message, &allowed)
                        .help(format!("the shell is given as {}", shell.text)),
                );
            }
            if from_outer { thickness - distance } else { distance }
        }
    };
    let material = material(r, &b.material, materials, Use::Bars)?;
    let prestress = prestress(r, &b.prestress, &material);
    Some(tank::Reinforcement { direction: b.direction.value?, area, depth, diameter, prestress, material })
}

/// Prestress [Pa]; 0 if it is not given. Prestressed bars must be elastic.
fn prestress(r: &mut Resolver<'_>, option: &Opt<Stress>, material: &tank::Material) -> f64 {
    let Some(field) = &option.given else { return 0.0 };
    let stress = r.number(field);
    if let Behaviour::Reinforcement(bar) = material.behaviour
        && stress >= bar.yield_strength
    {
        let allowed =
            format!("less than the yield strength, {}", like_unit(field, bar.yield_strength, Dimension::Stress));
        r.refuse(Code::Contradiction, field, "the bars yield under their prestress", &allowed);
    }
    r.remarks.push(format!(
        "{}: acts in the state at rest of the nonlinear engine; code procedures and linear engines leave it out",
        option.path
    ));
    stress
}
