//! `tank.bottom` and `tank.foundation`.

use ::base::{Plate, Soil, subgrade_modulus};
use files::code::{Code, Warning};
use tank::FoundationKind;

use super::corrosion::loss;
use super::materials::Materials;
use super::tank::{Anchors, Bottom, Foundation};
use super::wall::{self, Use};
use crate::input::tank::read::Field;
use crate::input::tank::resolver::{Resolver, range_fault};

/// The bottom plate: that under the wall first, the plates within it as `sketch`.
///
/// * `founded`: whether there is a `tank.foundation`, whose ground is that of the plate
pub(super) fn bottom(
    r: &mut Resolver<'_>,
    given: &Bottom,
    materials: &Materials,
    founded: bool,
) -> Option<tank::Bottom> {
    let inner = r.number(&given.thickness);
    let annular = r.optional(&given.annular_thickness);
    let thickness = annular.unwrap_or(inner);
    let corrosion = loss(r, thickness, &given.corrosion_allowance, &given.measured_thickness);
    let width = match (&given.annular_width.given, &given.width.given) {
        (Some(_), Some(field)) => {
            let message = "the width of the annular plate is given twice";
            r.faults.push(range_fault(
                Code::Exclusive,
                field,
                message,
                "either annular_width or width",
            ));
            r.optional(&given.width)
        }
        (Some(field), None) => Some(r.number(field)),
        (None, _) => r.optional(&given.width),
    };
    if let (Some(field), None) = (&given.annular_thickness.given, width) {
        let message = "an annular plate without its width";
        let allowed = "annular_thickness together with annular_width";
        r.faults.push(range_fault(Code::Incomplete, field, message, allowed));
    }
    if let (Some(field), Some(plate)) = (&given.annular_thickness.given, annular)
        && plate < inner
    {
        let message = "the annular plate is thinner than the plates within it";
        r.faults.push(range_fault(
            Code::Contradiction,
            field,
            message,
            "at least tank.bottom.thickness",
        ));
    }
    let projection = r.or_default(&given.projection);
    // The foundation gives the ground, or the kind that it is assumed for.
    let subgrade_modulus = match founded && given.subgrade_modulus.given.is_none() {
        true => None,
        false => r.optional(&given.subgrade_modulus).map(|k| 1e6 * k),
    };
    let material = wall::material(r, &given.material, materials, Use::Shell)?;
    Some(tank::Bottom {
        thickness,
        corrosion,
        width,
        sketch: annular.map(|_| inner),
        projection,
        subgrade_modulus,
        material,
    })
}

/// An annular plate that is wider than the bottom.
pub(super) fn wider_than_the_tank(r: &mut Resolver<'_>, given: &Bottom, plate: &tank::Bottom, radius: f64) {
    let field = given.annular_width.given.as_ref().or(given.width.given.as_ref());
    if let (Some(field), Some(width)) = (field, plate.width)
        && width > radius
    {
        let message = "the annular plate is wider than the bottom";
        let allowed = format!(
            "at most {}, the radius",
            tank::units::display(radius, tank::units::Dimension::Length)
        );
        r.faults
            .push(range_fault(Code::Contradiction, field, message, &allowed));
    }
}

/// Anchors that cannot be springs: a spring without a strength, a strength below its design value, an elongation that comes before yielding.
pub(super) fn anchors(r: &mut Resolver<'_>, given: &Anchors, found: &tank::Anchors) {
    let strength = found.yield_force.or(found.capacity);
    let Some(field) = &given.stiffness.given else {
        let needless = [given.gap.given.as_ref(), given.rupture_elongation.given.as_ref()];
        for field in needless.into_iter().flatten() {
            let message = "anchors without a stiffness do not stretch: this has no effect";
            r.faults.push(range_fault(
                Code::Incomplete,
                field,
                message,
                "together with tank.anchors.stiffness",
            ));
        }
        return;
    };
    if strength.is_none() {
        let message = "anchors with a stiffness and without a strength";
        let allowed = "tank.anchors.capacity or tank.anchors.yield_force beside it";
        r.faults.push(range_fault(Code::Incomplete, field, message, allowed));
    }
    if let (Some(field), Some(yields), Some(capacity)) = (&given.yield_force.given, found.yield_force, found.capacity)
        && yields < capacity
    {
        let message = "an anchor yields below its design capacity";
        r.faults.push(range_fault(
            Code::Contradiction,
            field,
            message,
            "at least tank.anchors.capacity",
        ));
    }
    if let (Some(field), Some(rupture), Some(stiffness), Some(strength)) = (
        &given.rupture_elongation.given,
        found.rupture_elongation,
        found.stiffness,
        strength,
    ) && rupture * stiffness < strength
    {
        let message = "an anchor breaks before it yields";
        let allowed = format!(
            "at least {}, its yield force over its stiffness",
            tank::units::display(strength / stiffness, tank::units::Dimension::Length)
        );
        r.faults
            .push(range_fault(Code::Contradiction, field, message, &allowed));
    }
}

/// A plate that is thicker than the lowest course: the joint then yields in the wall, which the strips do not follow.
pub(super) fn thicker_than_the_wall(r: &mut Resolver<'_>, field: &Field<Bottom>, plate: &tank::Bottom, course: f64) {
    if plate.thickness > course {
        r.warnings.push(Warning::new(Code::BaseModel, format!(
            "{}: the plate under the wall ({} mm) is thicker than the lowest course ({} mm): in an uplift the wall yields before the \
             plate, which the model of the base leaves elastic",
            field.path,
            1e3 * plate.thickness,
            1e3 * course
        )));
    }
}

/// Least modulus of loose sand under a plate of 0.3 m [N/m³] (Bowles 1996, table 9-1, recalled).
const LOOSE_SAND: f64 = 5e6;
/// Largest modulus of the ground under a rim [N/m³], as that of `stiffness`.
const HARDEST: f64 = 1e12;

/// The modulus that the velocity of shear waves gives under a plate has the limits of one that is given.
pub(super) fn ground_of_waves(
    r: &mut Resolver<'_>,
    given: &Foundation,
    ground: &tank::Foundation,
    plate: &tank::Bottom,
) {
    let (Some(field), Some(velocity), FoundationKind::Soil) = (
        &given.shear_wave_velocity.given,
        ground.shear_wave_velocity,
        ground.kind,
    ) else {
        return;
    };
    if ground.stiffness.or(plate.subgrade_modulus).is_some() {
        return;
    }
    let soil = Soil::of_waves(velocity, ground.soil_density, ground.soil_poisson_ratio);
    let rim = Plate {
        thickness: plate.net_thickness(),
        young_modulus: plate.material.youngs_modulus,
        poisson_ratio: plate.material.poisson_ratio,
        yield_stress: None,
    };
    if let Ok(k) = subgrade_modulus(soil, &rim)
        && k > HARDEST
    {
        let text = |k: f64| tank::units::display(k, tank::units::Dimension::Subgrade);
        let message = format!("these waves give the ground under the rim {}", text(k));
        let allowed = format!("at most {}, or tank.foundation.stiffness", text(HARDEST));
        r.faults.push(range_fault(Code::OutOfRange, field, &message, &allowed));
    }
}

/// The foundation.
///
/// * `isolated`: whether its slab stands on isolators
pub(super) fn foundation(
    r: &mut Resolver<'_>,
    given: &Foundation,
    bottom: Option<&Bottom>,
    isolated: bool,
) -> Option<tank::Foundation> {
    r.echo_given(&given.kind);
    let stiffness = r.optional(&given.stiffness);
    if let (Some(_), Some(field)) = (stiffness, bottom.and_then(|b| b.subgrade_modulus.given.as_ref())) {
        let message = "the ground under the rim is given twice";
        let allowed = "either tank.foundation.stiffness or tank.bottom.subgrade_modulus";
        r.faults.push(range_fault(Code::Exclusive, field, message, allowed));
    }
    if let (Some(k), Some(field)) = (stiffness, &given.stiffness.given)
        && k < LOOSE_SAND
    {
        r.warnings.push(Warning::new(
            Code::BaseModel,
            format!(
                "{}: {} is softer than loose sand under a plate of 0.3 m (5 MN/m³ and more; the rim loads a strip as narrow)",
                field.path,
                tank::units::display(k, tank::units::Dimension::Subgrade)
            ),
        ));
    }
    let shear_wave_velocity = r.optional(&given.shear_wave_velocity);
    let soil_density = r.or_default(&given.soil_density);
    let soil_poisson_ratio = r.or_default(&given.soil_poisson_ratio);
    let thickness = r.optional(&given.thickness);
    let friction = r.optional(&given.friction);
    // Assumed to be left out of a ring wall alone.
    let width = match (given.kind.value, &given.width.given) {
        (Some(FoundationKind::RingWall), _) | (_, Some(_)) => r.optional(&given.width),
        _ => None,
    };
    let kind = given.kind.value?;
    if let Some(field) = &given.width.given
        && kind == FoundationKind::Slab
    {
        let message = "width does not apply to this foundation";
        r.faults.push(range_fault(
            Code::DoesNotApply,
            field,
            message,
            "\"kind\": \"ring_wall\" or \"soil\"",
        ));
    }
    if let Some(field) = &given.thickness.given
        && kind == FoundationKind::Soil
    {
        let message = "thickness does not apply to a tank on soil";
        let allowed = "\"kind\": \"slab\" or \"ring_wall\"";
        r.faults.push(range_fault(Code::DoesNotApply, field, message, allowed));
    }
    // The mass of a slab moves with it on the soil.
    let reason = match (kind, shear_wave_velocity) {
        (FoundationKind::Soil, _) | (FoundationKind::Slab, Some(_)) => None,
        (FoundationKind::Slab, None) if isolated => None,
        (FoundationKind::Slab, None) => {
            Some("the mass of a slab counts together with shear_wave_velocity or isolators alone")
        }
        (FoundationKind::RingWall, _) if width.is_some() => None,
        (FoundationKind::RingWall, _) => Some("the thickness of a ring wall counts together with its width alone"),
    };
    if let (Some(field), Some(reason)) = (&given.thickness.given, reason) {
        r.warnings.push(Warning::new(
            Code::NotUsed,
            format!("{}: not used: {reason}", field.path),
        ));
    }
    Some(tank::Foundation {
        kind,
        width,
        stiffness,
        shear_wave_velocity,
        soil_density,
        soil_poisson_ratio,
        thickness,
        friction,
    })
}
