//! `tank.bottom` and `tank.foundation`.

use ::base::{Plate, Soil, subgrade_modulus};
use files::code::Code;
use tank::units::{Dimension, display};
use tank::{Anchors, FRICTION, FoundationKind, Joint, SIZE, Shape, ShellSupport, Support};

use super::corrosion::{Common, loss};
use super::details::Connections;
use super::materials::Materials;
use super::named::{Use, material};
use super::wall::{CORROSION, THICKNESS};
use crate::input::tank::choice::choice;
use crate::input::tank::given::Given;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::stated::Stated;
use crate::input::tank::values::{Density, Length, Number, Subgrade, Velocity};
use tank::keys::{Absent, Limits, default, without};

object! {
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
            = Absent::Follows("of soil from shear_wave_velocity after Vesic, else 100 MN/m³; of a ring wall or slab 10 000 MN/m³"),
        /// Velocity of shear waves in the soil, at the strains of the earthquake (EN 1998-5:2004 table 4.1). It gives the modulus under the
        /// rim of a tank on soil without stiffness, and the energy that the soil radiates under the rim of a tank that rocks. An anchored
        /// cylinder on a slab moves with it on this soil, a half-space under the soil_layers; of a uniform soil EN 1998-4 A.7 and ASCE 7
        /// chapter 19 stand beside it for information.
        shear_wave_velocity ("250 m/s"): Opt<Velocity> [WAVES]
            = without("the soil under the rim radiates no energy, a slab does not move"),
        /// Density of the soil.
        soil_density ("1900 kg/m3"): Opt<Density> [EARTH]
            = default(Density(1900.0)).because("moist sand or gravel"),
        /// Poisson's ratio of the soil.
        soil_poisson_ratio (0.33): Opt<Number> [Limits::from(0.0).below(0.5)]
            = default(Number(1.0 / 3.0)).shown("1/3").because("drained sand or gravel"),
        /// Material damping ratio of the soil at the strains of the earthquake, under an anchored cylinder on a slab that moves with it.
        soil_damping (0.05): Opt<Number> [Limits::from(0.0).to(0.3)] = without("the soil radiates energy and dissipates none"),
        /// Depth of the underside of a slab below the ground, its edge in contact with the soil all around.
        embedment ("1.5 m"): Opt<Length> [Limits::from(0.0).to(50.0)] = without("the slab lies on the ground"),
        /// Layers of soil from the ground down, over the half-space that shear_wave_velocity describes; for rock below them give that of the rock.
        soil_layers: Opt<Vec<Field<SoilLayer>>> [Limits::ANY.items(0, 20)] = Absent::Without("one soil"),
        /// Thickness of a slab, for its mass where it moves on the soil: concrete of 2500 kg/m³ as wide as the bottom plate; without it the
        /// slab has no mass. Of a ring wall its height, for its weight on the ground.
        thickness ("0.6 m"): Opt<Length> [THICKNESS],
        /// Width of a ring wall, or of the compacted pad under the shell, on the ground; the shell stands on its middle. The toe of a tank that
        /// lifts presses on the ground over the width of a ring wall.
        width ("0.6 m"): Opt<Length> [Limits::above(0.0).to(10.0)]
            = without("the pressure under a ring wall is not checked, API 650 E.6.2.3, EN 1998-5:2004 5.4.1.1"),
        /// What lies between the plate under the shell and a foundation of concrete.
        shell_support ("grouted"): Opt<ShellSupport> = Absent::Follows("not known; API 650 E.7.9 stays open"),
        /// Coefficient of friction between the bottom plate and the ground, the mean that is expected rather than a design value. `0` leaves friction
        /// out: in the time history the tank does not slide, and its bottom plate does not give way along the ground.
        friction (0.4): Opt<Number> [Limits::from(0.0).to(2.0).usual(0.2, 0.8)] = default(Number(FRICTION))
            .because("the largest of API 650 E.7.6; of an unanchored tank, also without tank.foundation"),
    }
}

object! {
    /// A layer of soil.
    SoilLayer {
        /// Thickness of the layer.
        thickness ("6 m"): Field<Length> [Limits::from(0.1).to(500.0)],
        /// Velocity of shear waves at the strains of the earthquake.
        shear_wave_velocity ("180 m/s"): Field<Velocity> [WAVES],
        /// Density.
        density ("1900 kg/m3"): Opt<Density> [EARTH] = Absent::Follows("soil_density"),
        /// Poisson's ratio.
        poisson_ratio (0.33): Opt<Number> [Limits::from(0.0).below(0.5)] = Absent::Follows("soil_poisson_ratio"),
        /// Material damping ratio.
        damping (0.05): Opt<Number> [Limits::from(0.0).to(0.3)] = Absent::Follows("soil_damping"),
    }
}

choice!(FoundationKind);

/// Velocity of shear waves, from soft clay to rock.
const WAVES: Limits = Limits::from(50.0).to(3000.0);
/// Density of soil.
const EARTH: Limits = Limits::from(1000.0).to(3000.0).usual(1400.0, 2500.0);

/// What the tank is like above its bottom.
pub(super) struct Above<'a> {
    pub courses: Option<&'a [tank::Course]>,
    pub shape: Option<Shape>,
    pub support: Option<Support>,
    /// Whether the slab stands on isolators.
    pub isolated: bool,
    /// Corrosion allowance of the tank.
    pub corrosion: Option<Common<'a>>,
}

/// Bottom plate and foundation.
pub(super) fn base(
    r: &mut Resolver<'_>,
    (given_bottom, given_foundation): (&Stated<Bottom>, &Stated<Foundation>),
    above: &Above<'_>,
    materials: &Materials,
) -> (Option<tank::Bottom>, Option<tank::Foundation>) {
    let founded = given_foundation.given.is_some();
    let bottom = (given_bottom.value()).and_then(|given| bottom(r, given, materials, (founded, above.corrosion)));
    if let (Some(field), Some(plate)) = (&given_bottom.given, &bottom)
        && let Some(first) = above.courses.and_then(|c| c.first())
        && above.support == Some(Support::Unanchored)
    {
        thicker_than_the_wall(r, field, plate, first.thickness);
    }
    if let (Some(given), Some(plate), Some(Shape::Cylinder { radius })) = (given_bottom.value(), &bottom, above.shape) {
        wider_than_the_tank(r, given, plate, radius);
    }
    let kind = [above.isolated, above.support == Some(Support::Unanchored)];
    let foundation = (given_foundation.value()).and_then(|given| foundation(r, given, given_bottom.value(), kind));
    if let (Some(given), Some(ground), Some(plate)) = (given_foundation.value(), &foundation, &bottom) {
        ground_of_waves(r, given, ground, plate);
    }
    (bottom, foundation)
}

/// The bottom plate: that under the wall first, the plates within it as `sketch`.
///
/// * `founded`: whether there is a `tank.foundation`, whose ground is that of the plate
/// * `common`: corrosion allowance of the tank
fn bottom(
    r: &mut Resolver<'_>,
    given: &Bottom,
    materials: &Materials,
    (founded, common): (bool, Option<Common<'_>>),
) -> Option<tank::Bottom> {
    let inner = r.number(&given.thickness);
    let annular = r.optional(&given.annular_thickness);
    let thickness = annular.unwrap_or(inner);
    let corrosion = loss(r, thickness, (&given.corrosion_allowance, &given.measured_thickness), common);
    let width = match (&given.annular_width.given, &given.width.given) {
        (Some(_), Some(field)) => {
            let message = "the width of the annular plate is given twice";
            r.refuse(Code::Exclusive, field, message, "either annular_width or width");
            r.optional(&given.width)
        }
        (Some(field), None) => Some(r.number(field)),
        (None, _) => r.optional(&given.width),
    };
    if let (Some(field), None) = (&given.annular_thickness.given, width) {
        let message = "an annular plate without its width";
        let allowed = "annular_thickness together with annular_width";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
    if let (Some(field), Some(plate)) = (&given.annular_thickness.given, annular)
        && plate < inner
    {
        let message = "the annular plate is thinner than the plates within it";
        r.refuse(Code::Contradiction, field, message, "at least tank.bottom.thickness");
    }
    let projection = r.or_default(&given.projection);
    // The foundation gives the ground, or the kind that it is assumed for.
    let subgrade_modulus = match founded && given.subgrade_modulus.given.is_none() {
        true => None,
        false => r.optional(&given.subgrade_modulus).map(|k| 1e6 * k),
    };
    let material = material(r, &given.material, materials, Use::Shell)?;
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
fn wider_than_the_tank(r: &mut Resolver<'_>, given: &Bottom, plate: &tank::Bottom, radius: f64) {
    let field = given.annular_width.given.as_ref().or(given.width.given.as_ref());
    if let (Some(field), Some(width)) = (field, plate.width)
        && width > radius
    {
        let message = "the annular plate is wider than the bottom";
        let allowed = format!("at most {}, the radius", display(radius, Dimension::Length));
        r.refuse(Code::Contradiction, field, message, &allowed);
    }
}

/// The anchors.
pub(super) fn anchors(r: &mut Resolver<'_>, given: &Given<Anchors>) -> Option<Anchors> {
    let found = given.resolve(r)?;
    springs(r, given, &found);
    Some(found)
}

/// Anchors that cannot be springs: a spring without a strength, a strength below its design value, an elongation that comes before yielding.
fn springs(r: &mut Resolver<'_>, given: &Given<Anchors>, found: &Anchors) {
    let strength = found.yield_force.or(found.capacity);
    let Some(field) = &given.stiffness.given else {
        let needless = [given.gap.given.as_ref(), given.rupture_elongation.given.as_ref()];
        for field in needless.into_iter().flatten() {
            let message = "anchors without a stiffness do not stretch: this has no effect";
            r.refuse(Code::Incomplete, field, message, "together with tank.anchors.stiffness");
        }
        return;
    };
    if strength.is_none() {
        let message = "anchors with a stiffness and without a strength";
        let allowed = "tank.anchors.capacity or tank.anchors.yield_force beside it";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
    if let (Some(field), Some(yields), Some(capacity)) = (&given.yield_force.given, found.yield_force, found.capacity)
        && yields < capacity
    {
        let message = "an anchor yields below its design capacity";
        r.refuse(Code::Contradiction, field, message, "at least tank.anchors.capacity");
    }
    if let (Some(field), Some(rupture), Some(stiffness), Some(strength)) =
        (&given.rupture_elongation.given, found.rupture_elongation, found.stiffness, strength)
        && rupture * stiffness < strength
    {
        let message = "an anchor breaks before it yields";
        let allowed = format!(
            "at least {}, its yield force over its stiffness",
            display(strength / stiffness, Dimension::Length)
        );
        r.refuse(Code::Contradiction, field, message, &allowed);
    }
}

/// A plate that is thicker than the lowest course: the joint then yields in the wall, which the strips do not follow.
fn thicker_than_the_wall(r: &mut Resolver<'_>, field: &Field<Bottom>, plate: &tank::Bottom, course: f64) {
    if plate.thickness > course {
        r.warn(Code::BaseModel, format!(
            "{}: the plate under the wall ({} mm) is thicker than the lowest course ({} mm): in an uplift the wall yields before the \
             plate, which the model of the base leaves elastic",
            field.path,
            1e3 * plate.thickness,
            1e3 * course
        ));
    }
}

/// Least modulus of loose sand under a plate of 0.3 m [N/m³] (Bowles 1996, table 9-1, recalled).
const LOOSE_SAND: f64 = 5e6;
/// Largest modulus of the ground under a rim [N/m³], as that of `stiffness`.
const HARDEST: f64 = 1e12;

/// The modulus that the velocity of shear waves gives under a plate has the limits of one that is given.
fn ground_of_waves(r: &mut Resolver<'_>, given: &Foundation, ground: &tank::Foundation, plate: &tank::Bottom) {
    let (Some(field), Some(velocity), FoundationKind::Soil) =
        (&given.shear_wave_velocity.given, ground.shear_wave_velocity, ground.kind)
    else {
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
        let text = |k: f64| display(k, Dimension::Subgrade);
        let message = format!("these waves give the ground under the rim {}", text(k));
        let allowed = format!("at most {}, or tank.foundation.stiffness", text(HARDEST));
        r.refuse(Code::OutOfRange, field, &message, &allowed);
    }
}

/// Least coefficient of friction that is not left out.
const LEAST: f64 = 1e-3;

/// The coefficient of friction; none where it is left out, or not given of an anchored tank.
fn friction(r: &mut Resolver<'_>, given: &Foundation, unanchored: bool) -> Option<f64> {
    let mu = match &given.friction.given {
        None if !unanchored => return None,
        _ => r.or_default(&given.friction),
    };
    if let (Some(field), true) = (&given.friction.given, mu > 0.0 && mu < LEAST) {
        let message = format!("{mu} is too small for a coefficient of friction");
        r.refuse(Code::OutOfRange, field, &message, "at least 0.001, or 0 without friction");
    }
    (mu > 0.0).then_some(mu)
}

/// The foundation.
///
/// * `isolated`: whether its slab stands on isolators; `unanchored`: whether the tank may slide
fn foundation(
    r: &mut Resolver<'_>,
    given: &Foundation,
    bottom: Option<&Bottom>,
    [isolated, unanchored]: [bool; 2],
) -> Option<tank::Foundation> {
    r.echo_given(&given.kind);
    let stiffness = r.optional(&given.stiffness);
    if let (Some(_), Some(field)) = (stiffness, bottom.and_then(|b| b.subgrade_modulus.given.as_ref())) {
        let message = "the ground under the rim is given twice";
        let allowed = "either tank.foundation.stiffness or tank.bottom.subgrade_modulus";
        r.refuse(Code::Exclusive, field, message, allowed);
    }
    if let (Some(k), Some(field)) = (stiffness, &given.stiffness.given)
        && k < LOOSE_SAND
    {
        r.warn(Code::BaseModel,
            format!(
                "{}: {} is softer than loose sand under a plate of 0.3 m (5 MN/m³ and more; the rim loads a strip as narrow)",
                field.path,
                display(k, Dimension::Subgrade)
            ));
    }
    let shear_wave_velocity = r.optional(&given.shear_wave_velocity);
    let soil_density = r.or_default(&given.soil_density);
    let soil_poisson_ratio = r.or_default(&given.soil_poisson_ratio);
    let thickness = r.optional(&given.thickness);
    let friction = friction(r, given, unanchored);
    // Assumed to be left out of a ring wall alone.
    let width = match (given.kind.value, &given.width.given) {
        (Some(FoundationKind::RingWall), _) | (_, Some(_)) => r.optional(&given.width),
        _ => None,
    };
    let kind = given.kind.value?;
    if kind == FoundationKind::Slab {
        let message = "width does not apply to this foundation";
        r.inapplicable(&given.width, message, "\"kind\": \"ring_wall\" or \"soil\"");
    }
    if kind == FoundationKind::Soil {
        let message = "thickness does not apply to a tank on soil";
        r.inapplicable(&given.thickness, message, "\"kind\": \"slab\" or \"ring_wall\"");
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
        r.warn(Code::NotUsed, format!("{}: not used: {reason}", field.path));
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

/// What the soil under a slab is besides a uniform half-space.
///
/// * `moves`: whether the slab moves on soil
pub(super) fn subsoil(
    r: &mut Resolver<'_>,
    given: Option<&Foundation>,
    foundation: Option<&tank::Foundation>,
    moves: bool,
) -> tank::Subsoil {
    let Some(given) = given else { return tank::Subsoil::default() };
    // Under other tanks nothing is said of what is not given.
    let mut number = |option: &Opt<Number>| (moves || option.given.is_some()).then(|| r.optional(option)).flatten();
    let damping = number(&given.soil_damping).unwrap_or(0.0);
    let said = moves || given.embedment.given.is_some();
    let embedment = said.then(|| r.optional(&given.embedment)).flatten().unwrap_or(0.0);
    let mut layers = Vec::new();
    if let Some(field) = &given.soil_layers.given {
        r.at_most(field, "layers of soil");
        for one in field.value.iter().flatten().filter_map(|field| field.value.as_ref()) {
            layers.push(tank::SoilLayer {
                thickness: r.number(&one.thickness),
                shear_wave_velocity: r.number(&one.shear_wave_velocity),
                density: r.optional(&one.density).or(foundation.map(|f| f.soil_density)).unwrap_or(f64::NAN),
                poisson_ratio: r
                    .optional(&one.poisson_ratio)
                    .or(foundation.map(|f| f.soil_poisson_ratio))
                    .unwrap_or(f64::NAN),
                damping: r.optional(&one.damping).unwrap_or(damping),
            });
        }
    }
    // An unknown kind of foundation is already a fault.
    if foundation.is_none() {
        return tank::Subsoil::default();
    }
    if !moves {
        let allowed = "an anchored cylinder on \"kind\": \"slab\" with shear_wave_velocity, without isolators";
        r.inapplicable(&given.soil_damping, "soil_damping is for a slab that moves on its soil", allowed);
        r.inapplicable(&given.embedment, "embedment is for a slab that moves on its soil", allowed);
        r.inapplicable(&given.soil_layers, "soil_layers are for a slab that moves on its soil", allowed);
        return tank::Subsoil::default();
    }
    tank::Subsoil { damping, embedment, layers }
}
