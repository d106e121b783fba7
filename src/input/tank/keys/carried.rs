//! What the wall carries below its roof: `tank.rings`, `tank.attachments`, `tank.insulation`.

use files::code::Code;
use tank::units::{Dimension, display};
use tank::{Attachment, Course, Insulation, Shape, Tank};

use super::materials::Materials;
use super::named::{Use, material};
use super::wall::THICKNESS;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, FromNode, Opt, object};
use crate::input::tank::resolver::{Resolver, like_field};
use crate::input::tank::values::{Area, Length, SecondMoment};
use tank::keys::Limits;

/// Slack for heights that are sums of decimal fractions.
const ROUNDING: f64 = 1e-9;

object! {
    /// A stiffening ring, a wind girder or the top angle, around the wall of a cylinder. Its section is given by area and inertia, or is a
    /// flat plate of this width and thickness.
    Ring {
        /// Height above the tank bottom, within the height of the wall.
        height ("8 m"): Field<Length> [Limits::from(0.0).to(1000.0)],
        /// Area of the section; together with inertia. Count the part of the wall that works with the ring in neither of them: the wall is
        /// in the model.
        area ("24 cm2"): Opt<Area> [Limits::above(0.0).to(1.0)],
        /// Second moment of the section about the vertical axis through its centroid, for bending in the plane of the ring.
        inertia ("820 cm4"): Opt<SecondMoment> [Limits::above(0.0).to(1.0)],
        /// Width of a flat plate, from the wall outwards or inwards; together with thickness.
        width ("200 mm"): Opt<Length> [Limits::above(0.0).to(10.0)],
        /// Thickness of a flat plate.
        thickness ("10 mm"): Opt<Length> [THICKNESS],
        /// Name of its material.
        material ("steel"): Field<String>,
    }
}

/// Height of the wall [m], if it is known.
pub(super) fn wall_height(courses: Option<&[Course]>) -> Option<f64> {
    courses.map(|courses| courses.iter().map(|course| course.height).sum())
}

/// A height within the wall [m]; NaN if it is not.
fn height(r: &mut Resolver<'_>, field: &Field<Length>, wall: Option<f64>, what: &str) -> f64 {
    let height = r.number(field);
    if let Some(wall) = wall.filter(|wall| height > wall * (1.0 + ROUNDING)) {
        let allowed = format!("at most {}, the height of the wall", like_field(field, wall));
        r.refuse(Code::Contradiction, field, &format!("{what} is above the wall"), &allowed);
    }
    height
}

/// The rings of a cylinder.
///
/// * `wall`: its height [m]
pub(super) fn rings(
    r: &mut Resolver<'_>,
    option: &Opt<Vec<Field<Ring>>>,
    (shape, wall): (Option<Shape>, Option<f64>),
    materials: &Materials,
) -> Vec<tank::Ring> {
    if matches!(shape, Some(Shape::Rectangle { .. })) {
        let message =
            "rings do not apply to a rectangle: its walls bend as plates, and their stiffeners are not modelled";
        r.inapplicable(option, message, "a cylinder, or no rings");
        return Vec::new();
    }
    let Some(field) = &option.given else { return Vec::new() };
    r.at_most(field, "rings");
    let mut rings = Vec::new();
    for one in field.value.iter().flatten() {
        let Some(given) = &one.value else { continue };
        let height = height(r, &given.height, wall, "the ring");
        let section = section(r, one, given);
        let material = material(r, &given.material, materials, Use::Ring);
        rings.extend(section.zip(material).map(|((area, inertia), material)| tank::Ring {
            height,
            area,
            inertia,
            material,
        }));
    }
    rings
}

/// Area [m²] and second moment [m⁴] of a ring; `None` if they are not both known.
fn section(r: &mut Resolver<'_>, field: &Field<Ring>, ring: &Ring) -> Option<(f64, f64)> {
    let shape = ring.area.given.is_some() || ring.inertia.given.is_some();
    let plate = ring.width.given.is_some() || ring.thickness.given.is_some();
    match (shape, plate) {
        (true, true) => {
            let message = "the section of the ring is given twice";
            r.refuse(Code::Exclusive, field, message, "either area and inertia, or width and thickness");
            None
        }
        (false, true) => {
            let (width, thickness) = (
                needed(r, field, &ring.width, " of a flat plate")?,
                needed(r, field, &ring.thickness, " of a flat plate")?,
            );
            let (b, t) = (r.number(width), r.number(thickness));
            Some((b * t, t * b.powi(3) / 12.0))
        }
        (false, false) => {
            let message = ": the section of a ring is area and inertia, or width and thickness";
            r.missing(field, &ring.area, message, &Area::allowed(), "\"24 cm2\", \"inertia\": \"820 cm4\"");
            None
        }
        (true, false) => {
            let (area, inertia) =
                (needed(r, field, &ring.area, " of a section")?, needed(r, field, &ring.inertia, " of a section")?);
            Some((r.number(area), r.number(inertia)))
        }
    }
}

/// A key that the section needs; reports its absence.
fn needed<'o, T: FromNode>(
    r: &mut Resolver<'_>,
    object: &Field<Ring>,
    option: &'o Opt<T>,
    why: &str,
) -> Option<&'o Field<T>> {
    if option.given.is_none() {
        r.missing(object, option, why, &T::allowed(), &format!("\"{}\"", option.key.example));
    }
    option.given.as_ref()
}

/// The masses at heights.
///
/// * `wall`: its height [m]
pub(super) fn attachments(
    r: &mut Resolver<'_>,
    option: &Opt<Vec<Field<Given<Attachment>>>>,
    wall: Option<f64>,
) -> Vec<Attachment> {
    let Some(field) = &option.given else { return Vec::new() };
    r.at_most(field, "attachments");
    let mut attachments = Vec::new();
    for given in field.value.iter().flatten().filter_map(|one| one.value.as_ref()) {
        let (name, mass) = (r.text(&given.name), r.number(&given.mass));
        let height = height(r, &given.height, wall, "the attachment");
        attachments.extend(name.map(|name| Attachment { name, mass, height }));
    }
    attachments
}

/// The insulation; its top is that of a course.
pub(super) fn insulation(
    r: &mut Resolver<'_>,
    option: &Opt<Given<Insulation>>,
    courses: Option<&[Course]>,
) -> Option<Insulation> {
    let given = option.value()?;
    let found = given.resolve(r)?;
    let (Some(field), Some(up_to), Some(courses)) = (&given.height.given, found.height, courses) else {
        return Some(found);
    };
    let mut top = 0.0;
    let tops: Vec<f64> = (courses.iter())
        .map(|course| {
            top += course.height;
            top
        })
        .collect();
    if up_to.is_finite() && !tops.iter().any(|top| (top - up_to).abs() <= ROUNDING * top) {
        let known: Vec<String> = tops.iter().map(|top| like_field(field, *top)).collect();
        let known = tank::keys::list(&known.iter().map(String::as_str).collect::<Vec<_>>(), "or");
        let allowed = format!("the top of a course: {known}");
        r.refuse(Code::Contradiction, field, "the insulation ends within a course", &allowed);
    }
    Some(found)
}

/// The tank with the insulation in the mass of its courses.
pub(super) fn insulated(r: &mut Resolver<'_>, mut tank: Tank) -> Tank {
    let Some(insulation) = tank.insulation else { return tank };
    insulation.cover(&mut tank.courses);
    let mass = display(tank.insulation_mass(), Dimension::Mass);
    r.remarks.push(format!("tank.insulation: the mass of the courses contains that of the insulation, {mass}"));
    tank
}
