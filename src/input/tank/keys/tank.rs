//! `tank` and `liquid`.

use files::code::Code;
use tank::units::Dimension;
use tank::{Anchors, Attachment, Insulation, Pipes, Presence, Pressure, SIZE, Shape, Staging, Support};

use super::base::{self, Above, Bottom, Foundation};
use super::carried::{self, Ring};
use super::corrosion::Common;
use super::isolators::{Isolators, isolators};
use super::joint::{WallBase, wall_base};
use super::materials::Materials;
use super::roof::{Roof, roof, snow};
use super::staging;
use super::temperature::TEMPERATURE;
use super::wall::{self, CORROSION, Course};
use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::stated::Stated;
use crate::input::tank::values::{Length, Temperature};
use ::tank::words;
use tank::keys::{Absent, Limits, default};

object! {
    /// An upright tank, on the ground unless it has a staging.
    Tank {
        /// Plan shape.
        shape: Field<Plan>,
        /// Inner radius of a cylinder, which needs it.
        radius ("10 m"): Opt<Length> [SIZE],
        /// Inner length of a rectangle in the direction of shaking (the whole length); a rectangle needs it. For shaking along the other
        /// direction exchange length and breadth.
        length ("20 m"): Opt<Length> [SIZE],
        /// Inner breadth of a rectangle across the direction of shaking. Give either this or strip.
        breadth ("8 m"): Opt<Length> [SIZE],
        /// True for a strip 1 m wide of a long rectangular tank (plane strain); results are per metre of breadth.
        strip (true): Opt<bool> = default(false),
        /// How the wall stands on the ground.
        support: Field<Support>,
        /// Rings of the wall with constant thickness, from the base up. Their heights add up to the height of the wall.
        courses: Field<Vec<Field<Course>>> [Limits::ANY.items(1, 200)],
        /// Corrosion allowance of every course and of the bottom plate that state neither their own nor a measured thickness.
        corrosion_allowance ("1 mm"): Opt<Length> [CORROSION],
        /// Design temperature of wall and bottom. Above 93 °C (carbon steel) or 40 °C (other metals) each material states its values there as
        /// `hot`.
        design_temperature ("90 degC"): Opt<Temperature> [TEMPERATURE] = Absent::Follows("values at room temperature hold"),
        /// Joint between the wall of a concrete cylinder and its base.
        wall_base: Opt<WallBase> = Absent::Follows("fixed: the wall is monolithic with its base"),
        /// Mass on top of the wall. Without it, and without `"none"`, checks that need to know of a roof are open.
        roof: Stated<Roof> = Absent::Follows("no mass"),
        /// Stiffening rings, wind girders and the top angle of a cylinder. Their mass counts with the wall; the finite-element engines have
        /// their stiffness too, the formulas of the codes have not.
        rings: Opt<Vec<Field<Ring>>> [Limits::ANY.items(0, 200)],
        /// Masses that the wall carries at heights: ladders, stairs, platforms, walkways, nozzles.
        attachments: Opt<Vec<Field<Given<Attachment>>>> [Limits::ANY.items(0, 1000)],
        /// Insulation of the wall.
        insulation: Opt<Given<Insulation>>,
        /// Bottom plate under the wall, needed by the anchorage and uplift checks.
        bottom: Stated<Bottom> = Absent::Without("checks of uplift and anchorage are left out"),
        /// What the tank stands on: the ground under the rim of the bottom plate, and the soil. Without it, and without `"none"` (the tank stands
        /// on the ground as it is), checks that need to know of a foundation are open.
        foundation: Stated<Foundation>,
        /// Isolators between the slab and the ground; the foundation is then a slab.
        isolators: Opt<Isolators>,
        /// Staging of an elevated tank. The procedure of IS 1893-2 alone covers one; every other procedure and the finite-element engines refuse
        /// the tank.
        staging: Opt<Given<Staging>> = Absent::Follows("the tank stands on the ground"),
        /// Anchor bolts, needed by the anchorage checks.
        anchors: Stated<Given<Anchors>>,
        /// Gas or vapour above the liquid while the earthquake acts.
        pressure: Opt<Given<Pressure>> = Absent::Follows("neither overpressure nor vacuum: an atmospheric tank"),
        /// Pipes that are connected to the tank, needed by the checks of their displacement; `"none"` if there are none.
        pipes: Stated<Given<Pipes>> = Absent::Without("displacements of pipes are not checked, EN 1998-4:2006 4.5.2.3"),
        /// Equipment within the liquid that wall or bottom carry.
        internals ("none"): Opt<Presence> = Absent::Follows("not known; API 650 E.7.5 stays open"),
        /// Structures that are connected to the tank, such as walkways to another tank.
        adjacent_structures ("none"): Opt<Presence> = Absent::Follows("not known; API 650 E.7.8 stays open"),
    }
}

words! {
    /// Plan shape.
    pub(crate) Plan {
        /// Circular cylinder with a radius.
        Cylinder = "cylinder",
        /// Rectangle with a length in the direction of shaking, and a breadth or strip.
        Rectangle = "rectangle",
    }
}

choice!(Plan, Support);

/// The tank.
pub(super) fn tank(r: &mut Resolver<'_>, field: &Field<Tank>, materials: &Materials) -> Option<tank::Tank> {
    let t = field.value.as_ref()?;
    let shape = shape(r, field, t);
    r.echo_given(&t.support);
    let support = t.support.value;
    let corrosion = Common::of(r, &t.corrosion_allowance);
    let courses = wall::courses(r, &t.courses, materials, corrosion);
    let roof = roof(r, &t.roof, shape);
    let wall = carried::wall_height(courses.as_deref());
    let rings = carried::rings(r, &t.rings, (shape, wall), materials);
    let attachments = carried::attachments(r, &t.attachments, wall);
    let insulation = carried::insulation(r, &t.insulation, courses.as_deref());
    for none in [&t.foundation.none, &t.bottom.none, &t.anchors.none, &t.pipes.none] {
        none.iter().for_each(|field| r.echo_none(field));
    }
    if t.bottom.given.is_none() && t.bottom.none.is_none() {
        r.not_given(&t.bottom);
    }
    let above = Above { courses: courses.as_deref(), shape, support, isolated: t.isolators.given.is_some(), corrosion };
    let (bottom, foundation) = base::base(r, (&t.bottom, &t.foundation), &above, materials);
    let ground = (t.foundation.value(), foundation.as_ref());
    let moves = matches!(shape, Some(Shape::Cylinder { .. }))
        && support == Some(Support::Anchored)
        && t.isolators.given.is_none()
        && foundation.is_some_and(|f| f.kind == tank::FoundationKind::Slab && f.shear_wave_velocity.is_some());
    let subsoil = base::subsoil(r, t.foundation.value(), foundation.as_ref(), moves);
    let isolators = t.isolators.given.as_ref().and_then(|field| isolators(r, field, ground, (shape, support)));
    let anchors = t.anchors.value().and_then(|given| base::anchors(r, given));
    let staging = staging::staging(r, &t.staging, shape, &t.support);
    if t.staging.given.is_some() {
        staging::on_ground(r, &t.foundation, "a tank on a staging has no foundation of its own");
        staging::on_ground(r, &t.isolators, "isolators are under the slab of a tank on the ground");
        staging::on_ground(r, &t.anchors, "anchors hold a tank on the ground");
        staging::on_ground(r, &t.bottom, "the floor of the container is tank.staging.floor_mass");
    }
    let pressure = pressure(r, &t.pressure);
    let pipes = pipes(r, &t.pipes);
    if support == Some(Support::Unanchored)
        && let Some(anchors) = &t.anchors.given
    {
        let message = "anchors do not apply to an unanchored tank";
        let allowed = "\"support\": \"anchored\", or a tank without anchors";
        r.refuse(Code::DoesNotApply, anchors, message, allowed);
    }
    let metal = courses.as_ref().is_none_or(|courses| tank::is_metal(courses));
    if !metal {
        let message = "a corrosion allowance of the tank does not apply to a wall that is not of plates";
        r.inapplicable(&t.corrosion_allowance, message, "no corrosion_allowance, or one of `tank.bottom`");
    }
    let wall_base = wall_base(r, &t.wall_base, shape, metal);
    let tank = tank::Tank {
        shape: shape?,
        support: support?,
        courses: courses?,
        wall_base: wall_base?,
        roof,
        rings,
        attachments,
        insulation,
        bottom,
        foundation,
        subsoil,
        isolators,
        staging,
        anchors,
        pressure,
        pipes,
        details: details(r, t),
    };
    if tank.corrodes() {
        let remark = "tank: finite elements and Housner's procedure use the thicknesses as built; the codes' stresses and resistances those \
                      less corrosion";
        r.remarks.push(remark.into());
    }
    Some(tank)
}

/// The pipes.
fn pipes(r: &mut Resolver<'_>, stated: &Stated<Given<Pipes>>) -> Option<Pipes> {
    if stated.given.is_none() && stated.none.is_none() {
        r.not_given(stated);
    }
    stated.value()?.resolve(r)
}

/// Answers about the construction.
fn details(r: &mut Resolver<'_>, t: &Tank) -> tank::Details {
    let bottom = t.bottom.value();
    tank::Details {
        internals: r.optional(&t.internals),
        adjacent_structures: r.optional(&t.adjacent_structures),
        snow: snow(r, &t.roof),
        shell_support: t.foundation.value().and_then(|f| r.optional(&f.shell_support)),
        annular_weld: bottom.and_then(|b| r.optional(&b.annular_weld)),
        shell_weld: bottom.and_then(|b| r.optional(&b.shell_weld)),
        bottom_connections: bottom.and_then(|b| r.optional(&b.connections)),
        design_temperature: None,
    }
}

/// Pressure above the liquid; none unless given.
fn pressure(r: &mut Resolver<'_>, option: &Opt<Given<Pressure>>) -> Pressure {
    let Some(given) = option.value() else {
        r.echo_default("tank.pressure", "0 kPa", "atmospheric tank");
        return Pressure::default();
    };
    let found = given.resolve(r).unwrap_or_default();
    for (pressure, text) in [
        (
            found.internal,
            "`tank.pressure.internal` enters the checks of EN 1998-4 and API 650; the finite-element engines leave it out",
        ),
        (
            found.vacuum,
            "`tank.pressure.vacuum` enters the checks of EN 1998-4 alone; API 650 (annex V) and the finite-element engines leave it out",
        ),
    ] {
        if pressure > 0.0 {
            r.warn(Code::NotUsed, text);
        }
    }
    found
}

/// The plan.
fn shape(r: &mut Resolver<'_>, field: &Field<Tank>, t: &Tank) -> Option<Shape> {
    r.echo_given(&t.shape);
    match t.shape.value? {
        Plan::Cylinder => {
            let allowed = "radius for a cylinder";
            r.inapplicable(&t.length, "length does not apply to a cylinder", allowed);
            r.inapplicable(&t.breadth, "breadth does not apply to a cylinder", allowed);
            r.inapplicable(&t.strip, "strip does not apply to a cylinder", allowed);
            Some(Shape::Cylinder { radius: required(r, field, &t.radius) })
        }
        Plan::Rectangle => {
            let allowed = "length and breadth (or strip) for a rectangle";
            r.inapplicable(&t.radius, "radius does not apply to a rectangle", allowed);
            let length = required(r, field, &t.length);
            if let Some(strip) = &t.strip.given {
                r.echo_given(strip);
            }
            let strip = t.strip.value() == Some(&true);
            let breadth = match (strip, &t.breadth.given) {
                (false, _) => required(r, field, &t.breadth),
                (true, None) => {
                    r.echo_default("tank.breadth", "1 m", "strip: results are per metre of breadth");
                    1.0
                }
                (true, Some(_)) => {
                    let message = "breadth does not apply to a strip";
                    r.inapplicable(&t.breadth, message, "either breadth or \"strip\": true");
                    f64::NAN
                }
            };
            Some(Shape::Rectangle { length, breadth, strip })
        }
    }
}

/// A dimension that the shape requires.
fn required(r: &mut Resolver<'_>, tank: &Field<Tank>, option: &Opt<Length>) -> f64 {
    if let Some(field) = &option.given {
        return r.number(field);
    }
    let alternative = if option.key.name == "breadth" { ", or \"strip\": true" } else { "" };
    let allowed = option.key.limits.describe(Dimension::Length);
    r.missing(tank, option, "", &allowed, &format!("\"1.83 m\"{alternative}"));
    f64::NAN
}
