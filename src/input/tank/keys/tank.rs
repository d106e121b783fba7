//! `tank` and `liquid`.

use files::code::{Code, Warning};
use tank::units::Dimension;
use tank::{FoundationKind, Joint, Presence, RoofKind, Shape, ShellSupport, Snow, Support};

use super::base;
use super::details::Connections;
use super::isolators::isolators;
use super::joint::{WallBase, wall_base};
use super::materials::Materials;
use super::wall::{self, CORROSION, Course, HEIGHT, THICKNESS};
use crate::input::tank::key::{Absent, Limits, default, without};
use crate::input::tank::read::{Field, Opt, choice, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::stated::Stated;
use crate::input::tank::syntax::join;
use crate::input::tank::values::{Density, Force, Length, LineForce, Mass, Number, Stress, Subgrade, Velocity, Whole};

/// Plan dimensions and the height of the roof, from the smallest laboratory tank up; the upper bound catches mm written as m.
const SIZE: Limits = Limits::from(1e-3).to(1000.0);
/// Forces of an anchor, from one of a model up.
const FORCE: Limits = Limits::from(1.0).to(1e9);
/// Displacements of pipes.
const DISPLACEMENT: Limits = Limits::from(0.0).to(10.0);
/// Liquids, from hydrogen (71 kg/m³) to mercury (13 600 kg/m³): `1 kg/m3` for water is a slip of the unit.
const LIQUID_DENSITY: Limits = Limits::above(50.0).to(15_000.0).usual(400.0, 2000.0);

object! {
    /// An upright tank on the ground.
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
        /// Joint between the wall of a concrete cylinder and its base.
        wall_base: Opt<WallBase> = Absent::Follows("fixed: the wall is monolithic with its base"),
        /// Mass on top of the wall. Without it, and without `"none"`, checks that need to know of a roof are open.
        roof: Stated<Roof> = Absent::Follows("no mass"),
        /// Bottom plate under the wall, needed by the anchorage and uplift checks.
        bottom: Stated<Bottom> = Absent::Without("checks of uplift and anchorage are left out"),
        /// What the tank stands on: the ground under the rim of the bottom plate, and the soil. Without it, and without `"none"` (the tank stands
        /// on the ground as it is), checks that need to know of a foundation are open.
        foundation: Stated<Foundation>,
        /// Isolators between the slab and the ground; the foundation is then a slab.
        isolators: Opt<Isolators>,
        /// Anchor bolts, needed by the anchorage checks.
        anchors: Stated<Anchors>,
        /// Gas or vapour above the liquid while the earthquake acts.
        pressure: Opt<Pressure> = Absent::Follows("neither overpressure nor vacuum: an atmospheric tank"),
        /// Pipes that are connected to the tank, needed by the checks of their displacement; `"none"` if there are none.
        pipes: Stated<Pipes> = Absent::Without("displacements of pipes are not checked, EN 1998-4:2006 4.5.2.3"),
        /// Equipment within the liquid that wall or bottom carry.
        internals ("none"): Opt<Presence> = Absent::Follows("not known; API 650 E.7.5 stays open"),
        /// Structures that are connected to the tank, such as walkways to another tank.
        adjacent_structures ("none"): Opt<Presence> = Absent::Follows("not known; API 650 E.7.8 stays open"),
    }

    /// Gas or vapour above the liquid while the earthquake acts, against the atmosphere.
    Pressure {
        /// Largest overpressure.
        internal ("2 kPa"): Opt<Stress> [Limits::from(0.0).to(1e6).usual(0.0, 50e3)] = default(Stress(0.0)).because("no overpressure"),
        /// Largest vacuum, as a positive number.
        vacuum ("0.5 kPa"): Opt<Stress> [Limits::from(0.0).to(101_325.0).usual(0.0, 6.9e3)] = default(Stress(0.0)).because("no vacuum"),
    }

    /// Pipes that are connected to the tank; of several the one with the least reserve.
    Pipes {
        /// Distance from the connection to the first support of the pipe that is fixed to the ground.
        support_distance ("12 m"): Opt<Length> [SIZE] = without("displacements of pipes are not checked, EN 1998-4:2006 4.5.1.3"),
        /// Displacement of the connection against that support that the pipe and its connection can bear without yielding, a
        /// design value.
        allowable_displacement ("60 mm"): Opt<Length> [Limits::from(0.0).to(10.0)]
            = without("displacements of pipes are not checked, EN 1998-4:2006 4.5.2.3"),
        /// Displacement upwards, relative to the foundation, that the pipes allow.
        uplift ("100 mm"): Opt<Length> [DISPLACEMENT] = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
        /// Displacement downwards, relative to the foundation.
        settlement ("25 mm"): Opt<Length> [DISPLACEMENT]
            = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
        /// Displacement horizontally, radial and tangential.
        horizontal ("50 mm"): Opt<Length> [DISPLACEMENT]
            = without("the flexibility of the pipes is not checked, API 650 E.7.3"),
    }

    /// Roof, or the mass on top of the wall of an open tank.
    Roof {
        /// How the roof is carried. The mass of a floating roof does not load the wall; it displaces its own mass of liquid below the
        /// level of fill_height.
        ///
        /// Of an open tank the mass is that of the girders on top of the wall.
        r#type: Opt<RoofKind> = default(RoofKind::Fixed),
        /// Mass of the roof with its loads.
        mass ("12 t"): Field<Mass> [Limits::from(0.0).to(1e9)],
        /// Height of its centre of mass above the tank bottom, not below the liquid; not of a floating roof.
        height ("11 m"): Opt<Length> [SIZE] = without("the top of the wall"),
        /// Snow on the roof.
        snow ("none"): Opt<Snow> = Absent::Follows("not known; the share of the snow stays open"),
        /// Height of a floating roof's rim and seal above the level of the liquid; the freeboard is less by it.
        rim ("0.8 m"): Opt<Length> [Limits::from(0.0).to(100.0)],
    }

    /// Bottom plate under the wall.
    Bottom {
        /// Thickness of the bottom plate; of the plates within the annular plate where annular_thickness is given.
        thickness ("8 mm"): Field<Length> [THICKNESS],
        /// Corrosion allowance; it does not resist uplift.
        corrosion_allowance ("1 mm"): Opt<Length> [CORROSION],
        /// Measured thickness of a corroded plate, instead of the allowance; thickness is that as built.
        measured_thickness ("6.5 mm"): Opt<Length> [THICKNESS],
        /// Thickness of the annular plate under the wall; together with annular_width.
        annular_thickness ("12 mm"): Opt<Length> [THICKNESS] = Absent::Follows("that of the bottom plate"),
        /// Width of the annular plate, from the inside of the shell towards the centre.
        annular_width ("1.2 m"): Opt<Length> [SIZE] = Absent::Follows("width"),
        /// The same for a plate of `thickness` under the wall. Give one of the widths.
        width ("0.9 m"): Opt<Length> [SIZE] = without("the width is not checked, API 650 E.6.2.1.1.2"),
        /// Weld between the plates under the shell.
        annular_weld ("butt"): Opt<Joint> = Absent::Follows("not known"),
        /// Leg of each of the two fillet welds between shell and bottom.
        shell_weld ("8 mm"): Opt<Length> [THICKNESS] = Absent::Follows("the least of API 650 5.1.5.7 for the thickness of the shell"),
        /// Connections through the bottom: least distance from the inside of the shell to the edge of a reinforcement, or "none".
        connections ("1.5 m"): Opt<Connections> = Absent::Follows("not known; API 650 E.7.4 stays open"),
        /// Projection of the plate outside the wall; it rests on the ground without liquid on it.
        projection ("50 mm"): Opt<Length> [Limits::from(0.0).to(1.0)] = default(Length(0.0)),
        /// Subgrade modulus of the ground under the wall in MN/m³: compacted gravel 100, ring wall, slab or rock 10 000.
        subgrade_modulus (100): Opt<Number> [Limits::from(1.0).to(1e6)]
            = without("without tank.foundation: uplift and toe on ground of 33 to 300 and of 10 000 MN/m³, the worst decides, EN 1998-4:2006 A.9"),
        /// Name of its material.
        material ("steel"): Field<String>,
    }

    /// Foundation, and the soil below it.
    Foundation {
        /// Kind of foundation.
        kind: Field<FoundationKind>,
        /// Modulus of the ground under the rim of the bottom plate, pressure over settlement. The rim loads a strip some decimetres
        /// wide, so it is much stiffer than a plate-load test of the whole bottom.
        stiffness ("100 MN/m3"): Opt<Subgrade> [Limits::from(1e6).to(1e12)]
            = Absent::Follows("from shear_wave_velocity after Vesic; else 100 MN/m³ of soil, 10 000 MN/m³ of a ring wall or slab"),
        /// Velocity of shear waves in the soil, at the strains of the earthquake (EN 1998-5:2004 table 4.1). It gives the modulus under the
        /// rim of a tank on soil without stiffness, and the energy that the soil radiates under the rim of a tank that rocks. An anchored
        /// cylinder on a slab moves with it on this soil, a uniform half-space, in the harmonic engine; EN 1998-4 A.7 and ASCE 7 chapter 19
        /// stand beside it for information.
        shear_wave_velocity ("250 m/s"): Opt<Velocity> [Limits::from(50.0).to(3000.0)]
            = without("the soil under the rim radiates no energy, a slab does not move"),
        /// Density of the soil.
        soil_density ("1900 kg/m3"): Opt<Density> [Limits::from(1000.0).to(3000.0).usual(1400.0, 2500.0)]
            = default(Density(1900.0)).because("moist sand or gravel"),
        /// Poisson's ratio of the soil.
        soil_poisson_ratio (0.33): Opt<Number> [Limits::from(0.0).below(0.5)]
            = default(Number(1.0 / 3.0)).shown("1/3").because("drained sand or gravel"),
        /// Thickness of a slab, for its mass where it moves on the soil: concrete of 2500 kg/m³ as wide as the bottom plate; without it the
        /// slab has no mass. Of a ring wall its height, for its weight on the ground.
        thickness ("0.6 m"): Opt<Length> [THICKNESS],
        /// Width of a ring wall, or of the compacted pad under the shell, on the ground; the shell stands on its middle. The toe of a tank that
        /// lifts presses on the ground over the width of a ring wall.
        width ("0.6 m"): Opt<Length> [Limits::above(0.0).to(10.0)]
            = without("the pressure under a ring wall is not checked, API 650 E.6.2.3, EN 1998-5:2004 5.4.1.1"),
        /// What lies between the plate under the shell and a foundation of concrete.
        shell_support ("grouted"): Opt<ShellSupport> = Absent::Follows("not known; API 650 E.7.9 stays open"),
        /// Coefficient of friction between the bottom plate and the ground, the mean that is expected rather than a design value.
        friction (0.4): Opt<Number> [Limits::from(1e-3).to(2.0).usual(0.2, 0.8)] = without("the tank does not slide in the time history"),
    }

    /// Isolators under the slab. Forces and stiffnesses are those of all bearings or dampers together; of a strip, per metre of breadth.
    Isolators {
        /// Kind of bearing.
        kind: Field<Isolation>,
        /// Radius of the concave surface of friction pendulums, which need it.
        radius ("2.24 m"): Opt<Length> [Limits::from(0.05).to(100.0)],
        /// Coefficient of friction of friction pendulums in fast sliding; they need it.
        friction (0.05): Opt<Number> [Limits::from(1e-4).to(0.5)],
        /// Coefficient of friction at rest; not above that of fast sliding.
        friction_slow (0.03): Opt<Number> [Limits::from(1e-4).to(0.5)] = Absent::Follows("friction"),
        /// Rate a of the friction with the speed v in s/m, friction − (friction − friction_slow) exp(−a v).
        friction_rate (50): Opt<Number> [Limits::from(0.0).to(1000.0)] = default(Number(50.0)).because("20 to 100 s/m"),
        /// Elastic displacement of friction pendulums before they slide.
        slip ("1 mm"): Opt<Length> [Limits::from(1e-5).to(0.02)] = default(Length(1e-3)).because("it gives sticking a stiffness"),
        /// Characteristic strength of lead-rubber bearings, the force at no displacement; they need it.
        strength ("5 MN"): Opt<Force> [Limits::from(1.0).to(1e12)],
        /// Stiffness: of lead-rubber bearings after yielding, of elastomers, and of the bearings beside dampers. All but friction
        /// pendulums need it.
        stiffness ("60 MN/m"): Opt<LineForce> [Limits::from(1.0).to(1e15)],
        /// Stiffness of lead-rubber bearings before yielding, above that after it.
        initial_stiffness ("600 MN/m"): Opt<LineForce> [Limits::from(1.0).to(1e15)] = Absent::Follows("10 times stiffness"),
        /// Damping ratio of elastomers at the period of the mass above them on their stiffness; they need it.
        damping (0.12): Opt<Number> [Limits::from(0.0).to(0.5)],
        /// Coefficient C of viscous dampers in N (s/m)^α: their force is C |v|^α. The kind `damper` needs it; any other may have dampers
        /// beside its bearings.
        damper_coefficient (5e6): Opt<Number> [Limits::from(1.0).to(1e13)] = Absent::Follows("no dampers"),
        /// Exponent α of the dampers.
        damper_exponent (0.5): Opt<Number> [Limits::from(0.1).to(2.0)] = default(Number(1.0)).because("linear dampers"),
        /// Mass on the isolators besides the tank.
        slab_mass ("900 t"): Opt<Mass> [Limits::from(0.0).to(1e10)]
            = Absent::Follows("tank.foundation.thickness under the tank, of 2500 kg/m³"),
        /// Strength, stiffness, friction and damper coefficient of the lower bound over the nominal ones.
        lower_bound (0.6): Opt<Number> [Limits::from(0.1).to(1.0)] = default(Number(0.6)).because("ASCE 7-16 17.2.8.4 without tests"),
        /// The same of the upper bound.
        upper_bound (1.8): Opt<Number> [Limits::from(1.0).to(5.0)] = default(Number(1.8)).because("ASCE 7-16 17.2.8.4 without tests"),
        /// Displacement that bearings, joints and pipes have room for.
        displacement_capacity ("250 mm"): Opt<Length> [Limits::from(1e-4).to(5.0)]
            = without("the displacement of the isolators is given without a check"),
    }

    /// Anchor bolts.
    Anchors {
        /// Number of anchors around the circumference.
        count (36): Field<Whole> [Limits::count(1, 10_000)],
        /// Design tension capacity of one anchor.
        capacity ("120 kN"): Opt<Force> [FORCE]
            = without("the force of an anchor is given without a check"),
        /// Design tension capacity of the attachment of one anchor to the shell and of its embedment, the lesser.
        attachment_capacity ("300 kN"): Opt<Force> [FORCE]
            = without("the attachment of the anchors is not checked, API 650 E.6.2.1.2"),
        /// Stiffness of one anchor with its chair and embedment, force over elongation: E A/l of the bolt between nut and anchor plate, less
        /// what chair and concrete give way. With it, and with tank.bottom, the base lifts on its anchors in the time history of the
        /// harmonic engine where one yields.
        stiffness ("80 MN/m"): Opt<LineForce> [Limits::from(1e4).to(1e12)]
            = Absent::Follows("the wall is held down also where an anchor yields"),
        /// Force at which one anchor yields, at least capacity.
        yield_force ("150 kN"): Opt<Force> [FORCE] = Absent::Follows("capacity"),
        /// Play of the nut: the uplift of the rim before the anchor pulls.
        gap ("1 mm"): Opt<Length> [Limits::from(0.0).to(0.1)] = Absent::Follows("no play"),
        /// Elongation at which one anchor breaks, play not counted; the uniform elongation of its steel over the free length.
        rupture_elongation ("40 mm"): Opt<Length> [Limits::from(1e-6).to(10.0)] = Absent::Follows("anchors do not break"),
    }

    /// The stored liquid.
    Liquid {
        /// Density.
        density: Field<Density> [LIQUID_DENSITY],
        /// Depth of the liquid above the tank bottom.
        fill_height ("9 m"): Field<Length> [HEIGHT],
    }
}

/// Plan shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plan {
    /// Circle.
    Cylinder,
    /// Rectangle.
    Rectangle,
}

/// Kind of isolators.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Isolation {
    /// Friction pendulums.
    FrictionPendulum,
    /// Lead-rubber bearings.
    LeadRubber,
    /// Elastomers.
    Elastomer,
    /// Viscous dampers.
    Damper,
}

choice! {
    /// Kind of isolators.
    Isolation {
        /// Friction pendulums: a slider on a concave surface; needs radius and friction.
        FrictionPendulum = "friction_pendulum",
        /// Lead-rubber bearings, bilinear; needs strength and stiffness.
        LeadRubber = "lead_rubber",
        /// Elastomeric bearings, linear; needs stiffness and damping.
        Elastomer = "elastomer",
        /// Viscous dampers beside linear bearings without damping; needs damper_coefficient and stiffness.
        Damper = "damper",
    }

    /// Plan shape.
    Plan {
        /// Circular cylinder with a radius.
        Cylinder = "cylinder",
        /// Rectangle with a length in the direction of shaking, and a breadth or strip.
        Rectangle = "rectangle",
    }

    /// Kind of foundation.
    FoundationKind {
        /// The bottom plate lies on soil or on a pad of gravel.
        Soil = "soil",
        /// A ring of concrete under the wall, soil within it.
        RingWall = "ring_wall",
        /// A stiff slab or raft of concrete under the whole bottom.
        Slab = "slab",
    }

    /// How a roof is carried.
    RoofKind {
        /// By the wall.
        Fixed = "fixed",
        /// By the liquid.
        Floating = "floating",
        /// There is none.
        Open = "open",
    }

    /// Support of the wall.
    Support {
        /// Held down; the wall is clamped at its base.
        Anchored = "anchored",
        /// Resting on its bottom plate. The codes have their rules for uplift; `compare` lifts and, with friction, slides a cylinder on
        /// `tank.bottom` and `tank.foundation`.
        Unanchored = "unanchored",
    }
}

/// The tank.
pub(super) fn tank(r: &mut Resolver<'_>, field: &Field<Tank>, materials: &Materials) -> Option<tank::Tank> {
    let t = field.value.as_ref()?;
    let shape = shape(r, field, t);
    r.echo_given(&t.support);
    let support = t.support.value;
    let courses = wall::courses(r, &t.courses, materials);
    let roof = match &t.roof.given {
        Some(field) => field
            .value
            .as_ref()
            .map_or_else(tank::Roof::default, |given| roof(r, given)),
        None => {
            match &t.roof.none {
                Some(field) => r.echo_none(field),
                None => r.echo_default("tank.roof.mass", "0 kg", "no roof stated"),
            }
            tank::Roof::default()
        }
    };
    for none in [&t.foundation.none, &t.bottom.none, &t.anchors.none, &t.pipes.none] {
        none.iter().for_each(|field| r.echo_none(field));
    }
    if t.bottom.given.is_none() && t.bottom.none.is_none() {
        r.not_given(&t.bottom);
    }
    let bottom = t
        .bottom
        .value()
        .and_then(|given| base::bottom(r, given, materials, t.foundation.given.is_some()));
    if let (Some(field), Some(plate)) = (&t.bottom.given, &bottom)
        && let Some(first) = courses.as_ref().and_then(|c| c.first())
        && support == Some(Support::Unanchored)
    {
        base::thicker_than_the_wall(r, field, plate, first.thickness);
    }
    if let (Some(given), Some(plate), Some(tank::Shape::Cylinder { radius })) = (t.bottom.value(), &bottom, shape) {
        base::wider_than_the_tank(r, given, plate, radius);
    }
    let foundation = (t.foundation.value())
        .and_then(|given| base::foundation(r, given, t.bottom.value(), t.isolators.given.is_some()));
    if let (Some(given), Some(ground), Some(plate)) = (t.foundation.value(), &foundation, &bottom) {
        base::ground_of_waves(r, given, ground, plate);
    }
    let isolators = (t.isolators.given.as_ref())
        .zip(t.isolators.value())
        .and_then(|(field, given)| isolators(r, (field, given), t, foundation.as_ref(), shape));
    let anchors = t.anchors.value().map(|anchors| tank::Anchors {
        count: r.count(&anchors.count).unwrap_or(0),
        capacity: r.optional(&anchors.capacity),
        attachment_capacity: r.optional(&anchors.attachment_capacity),
        stiffness: r.optional(&anchors.stiffness),
        yield_force: r.optional(&anchors.yield_force),
        gap: r.optional(&anchors.gap),
        rupture_elongation: r.optional(&anchors.rupture_elongation),
    });
    if let (Some(found), Some(given)) = (&anchors, t.anchors.value()) {
        base::anchors(r, given, found);
    }
    let pressure = pressure(r, &t.pressure);
    for (given, text) in [
        (
            pressure.internal > 0.0,
            "`tank.pressure.internal` enters the checks of EN 1998-4 and API 650; the finite-element engines leave it out",
        ),
        (
            pressure.vacuum > 0.0,
            "`tank.pressure.vacuum` enters the checks of EN 1998-4 alone; API 650 (annex V) and the finite-element engines leave it out",
        ),
    ] {
        if given {
            r.warnings.push(Warning::new(Code::NotUsed, text));
        }
    }
    if t.pipes.given.is_none() && t.pipes.none.is_none() {
        r.not_given(&t.pipes);
    }
    let pipes = t.pipes.value().map(|pipes| tank::Pipes {
        support_distance: r.optional(&pipes.support_distance),
        allowable_displacement: r.optional(&pipes.allowable_displacement),
        uplift: r.optional(&pipes.uplift),
        settlement: r.optional(&pipes.settlement),
        horizontal: r.optional(&pipes.horizontal),
    });
    if support == Some(Support::Unanchored)
        && let Some(anchors) = &t.anchors.given
    {
        r.faults.push(range_fault(
            Code::DoesNotApply,
            anchors,
            "anchors do not apply to an unanchored tank",
            "\"support\": \"anchored\", or a tank without anchors",
        ));
    }
    let metal = courses.as_ref().is_none_or(|courses| tank::is_metal(courses));
    let wall_base = wall_base(r, &t.wall_base, shape, metal);
    let tank = tank::Tank {
        shape: shape?,
        support: support?,
        courses: courses?,
        wall_base: wall_base?,
        roof,
        bottom,
        foundation,
        isolators,
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

/// The roof; a floating one does not load the wall.
fn roof(r: &mut Resolver<'_>, given: &Roof) -> tank::Roof {
    let kind = r.choice(&given.r#type);
    let mass = r.number(&given.mass);
    if kind == RoofKind::Floating {
        if let Some(height) = &given.height.given {
            r.faults.push(range_fault(
                Code::DoesNotApply,
                height,
                "height does not apply to a floating roof",
                "no height: the roof is on the liquid",
            ));
        }
        return tank::Roof {
            afloat: mass,
            kind,
            rim: given.rim.given.as_ref().map_or(0.0, |rim| r.number(rim)),
            ..tank::Roof::default()
        };
    }
    if let Some(rim) = &given.rim.given {
        r.faults.push(range_fault(
            Code::DoesNotApply,
            rim,
            "rim does not apply to a roof that does not float",
            "\"type\": \"floating\", or a roof without rim",
        ));
    }
    tank::Roof {
        mass,
        height: r.optional(&given.height),
        kind,
        ..tank::Roof::default()
    }
}

/// Answers about the construction.
fn details(r: &mut Resolver<'_>, t: &Tank) -> tank::Details {
    let bottom = t.bottom.value();
    tank::Details {
        internals: r.word(&t.internals),
        adjacent_structures: r.word(&t.adjacent_structures),
        snow: t.roof.value().and_then(|roof| r.word(&roof.snow)),
        shell_support: t.foundation.value().and_then(|f| r.word(&f.shell_support)),
        annular_weld: bottom.and_then(|b| r.word(&b.annular_weld)),
        shell_weld: bottom.and_then(|b| r.optional(&b.shell_weld)),
        bottom_connections: bottom.and_then(|b| r.word(&b.connections)).map(|c| c.0),
    }
}

/// Pressure above the liquid; none unless given.
fn pressure(r: &mut Resolver<'_>, option: &Opt<Pressure>) -> tank::Pressure {
    match option.value() {
        Some(given) => tank::Pressure {
            internal: r.or_default(&given.internal),
            vacuum: r.or_default(&given.vacuum),
        },
        None => {
            r.echo_default("tank.pressure", "0 kPa", "atmospheric tank");
            tank::Pressure::default()
        }
    }
}

fn shape(r: &mut Resolver<'_>, field: &Field<Tank>, t: &Tank) -> Option<Shape> {
    r.echo_given(&t.shape);
    let kind = t.shape.value?;
    let (word, foreign) = match kind {
        Plan::Cylinder => ("cylinder", vec![&t.length, &t.breadth]),
        Plan::Rectangle => ("rectangle", vec![&t.radius]),
    };
    let allowed = match kind {
        Plan::Cylinder => "radius for a cylinder",
        Plan::Rectangle => "length and breadth (or strip) for a rectangle",
    };
    for option in foreign {
        if let Some(given) = &option.given {
            let message = format!("{} does not apply to a {word}", option.key.name);
            r.faults.push(range_fault(Code::DoesNotApply, given, &message, allowed));
        }
    }
    match kind {
        Plan::Cylinder => {
            if let Some(strip) = &t.strip.given {
                r.faults.push(range_fault(
                    Code::DoesNotApply,
                    strip,
                    "strip does not apply to a cylinder",
                    allowed,
                ));
            }
            Some(Shape::Cylinder {
                radius: required(r, field, &t.radius),
            })
        }
        Plan::Rectangle => {
            let length = required(r, field, &t.length);
            if let Some(strip) = &t.strip.given {
                r.echo_given(strip);
            }
            let strip = t.strip.value() == Some(&true);
            let breadth = match (&t.breadth.given, strip) {
                (Some(breadth), true) => {
                    r.faults.push(range_fault(
                        Code::DoesNotApply,
                        breadth,
                        "breadth does not apply to a strip",
                        "either breadth or \"strip\": true",
                    ));
                    f64::NAN
                }
                (None, true) => {
                    r.echo_default("tank.breadth", "1 m", "strip: results are per metre of breadth");
                    1.0
                }
                (_, false) => required(r, field, &t.breadth),
            };
            Some(Shape::Rectangle { length, breadth, strip })
        }
    }
}

/// A dimension that the shape requires.
fn required(r: &mut Resolver<'_>, tank: &Field<Tank>, option: &Opt<Length>) -> f64 {
    let key = option.key.name;
    match &option.given {
        Some(field) => r.number(field),
        // A misspelt key was already reported with this one as the suggestion.
        None if r.faults.suggest(&format!("did you mean `{key}`?")) => f64::NAN,
        None => {
            let alternative = if key == "breadth" { ", or \"strip\": true" } else { "" };
            let missing = Field::<Length>::missing(tank.span.start..tank.span.start + 1, join(&tank.path, key));
            let allowed = option.key.limits.describe(Dimension::Length);
            r.faults.push(
                range_fault(
                    Code::MissingKey,
                    &missing,
                    &format!("the key `{key}` is missing"),
                    &allowed,
                )
                .help(format!("add \"{key}\": \"1.83 m\"{alternative}")),
            );
            f64::NAN
        }
    }
}

/// The liquid.
pub(super) fn liquid(r: &mut Resolver<'_>, field: &Field<Liquid>) -> Option<tank::Liquid> {
    let l = field.value.as_ref()?;
    Some(tank::Liquid {
        density: r.number(&l.density),
        fill_height: r.number(&l.fill_height),
    })
}
