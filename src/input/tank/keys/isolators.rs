//! `tank.isolators`.

use files::code::Code;
use tank::{Bearing, FoundationKind, Shape, Support};

use super::base::Foundation;
use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, FromNode, Opt, object};
use crate::input::tank::resolver::{Resolved, Resolver, Si};
use crate::input::tank::values::{Force, Length, LineForce, Mass, Number};
use ::tank::words;
use tank::keys::{Absent, Limits, default, without};

/// Reinforced concrete [kg/m³].
const CONCRETE: f64 = 2500.0;

object! {
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
}

words! {
    /// Kind of isolators.
    pub(crate) Isolation {
        /// Friction pendulums: a slider on a concave surface; needs radius and friction.
        FrictionPendulum = "friction_pendulum",
        /// Lead-rubber bearings, bilinear; needs strength and stiffness.
        LeadRubber = "lead_rubber",
        /// Elastomeric bearings, linear; needs stiffness and damping.
        Elastomer = "elastomer",
        /// Viscous dampers beside linear bearings without damping; needs damper_coefficient and stiffness.
        Damper = "damper",
    }
}

choice!(Isolation);

/// The isolators, of a tank that is held down on a slab.
pub(super) fn isolators(
    r: &mut Resolver<'_>,
    field: &Field<Isolators>,
    (ground, foundation): (Option<&Foundation>, Option<&tank::Foundation>),
    (shape, support): (Option<Shape>, Option<Support>),
) -> Option<tank::Isolators> {
    let given = field.value.as_ref()?;
    r.echo_given(&given.kind);
    let bearing = bearing(r, field, given);
    let damper = damper(r, field, given);
    let bounds = [&given.lower_bound, &given.upper_bound].map(|bound| r.or_default(bound));
    let displacement_capacity = r.optional(&given.displacement_capacity);
    let slab_mass = r.optional(&given.slab_mass);
    let slab = foundation.filter(|f| f.kind == FoundationKind::Slab);
    unsupported(r, field, (ground, slab.is_some()), support);
    contradictions(r, given, bearing, damper);
    r.warn(Code::NotUsed, "`tank.isolators` enters the time histories of the linear engines and of the nonlinear cylinder; the codes' procedures, the \
         response-spectrum method, transfer functions, nonlinear strips, `ida` and `push` take the base as fixed");
    let thickness = slab.and_then(|slab| slab.thickness);
    let slab_mass = match (slab_mass, thickness) {
        (Some(mass), _) => mass,
        (None, Some(thickness)) => CONCRETE * thickness * shape?.plan_area(),
        (None, None) => {
            let missing = "neither slab_mass nor tank.foundation.thickness";
            r.echo_default("tank.isolators.slab_mass", "0 kg", missing);
            let text = format!("tank.isolators: the slab has no mass, which moves with the tank: {missing}");
            r.warn(Code::BaseModel, text);
            0.0
        }
    };
    Some(tank::Isolators {
        bearing: bearing?,
        damper,
        slab_mass,
        slab_thickness: thickness.unwrap_or(0.0),
        bounds,
        displacement_capacity,
    })
}

/// The bearings of the kind.
fn bearing(r: &mut Resolver<'_>, field: &Field<Isolators>, given: &Isolators) -> Option<Bearing> {
    let kind = given.kind.value;
    let mut keys = Keys { r, field, kind };
    let pendulum = &[Isolation::FrictionPendulum][..];
    let rubber = &[Isolation::LeadRubber][..];
    let springs = &[Isolation::LeadRubber, Isolation::Elastomer, Isolation::Damper][..];
    let radius = keys.needed(&given.radius, pendulum);
    let friction = keys.needed(&given.friction, pendulum);
    let slow = keys.follows(&given.friction_slow, friction, pendulum);
    let rate = keys.or_default(&given.friction_rate, pendulum, given.friction_slow.given.is_some());
    let slip = keys.or_default(&given.slip, pendulum, true);
    let strength = keys.needed(&given.strength, rubber);
    let stiffness = keys.needed(&given.stiffness, springs);
    let initial = keys.follows(&given.initial_stiffness, 10.0 * stiffness, rubber);
    let damping = keys.needed(&given.damping, &[Isolation::Elastomer]);
    Some(match kind? {
        Isolation::FrictionPendulum => Bearing::FrictionPendulum { radius, friction, slow, rate, slip },
        Isolation::LeadRubber => Bearing::LeadRubber { strength, initial, yielded: stiffness },
        Isolation::Elastomer => Bearing::Elastomer { stiffness, damping },
        Isolation::Damper => Bearing::Elastomer { stiffness, damping: 0.0 },
    })
}

/// Coefficient and exponent of the dampers, which all kinds may have and the kind `damper` needs.
fn damper(r: &mut Resolver<'_>, field: &Field<Isolators>, given: &Isolators) -> Option<[f64; 2]> {
    let kind = given.kind.value;
    let coefficient = match kind {
        Some(Isolation::Damper) => {
            Some(Keys { r, field, kind }.needed(&given.damper_coefficient, &[Isolation::Damper]))
        }
        _ => r.optional(&given.damper_coefficient),
    };
    let dampers = coefficient.is_some() || given.damper_exponent.given.is_some();
    let exponent = dampers.then(|| r.or_default(&given.damper_exponent))?;
    coefficient.map(|coefficient| [coefficient, exponent])
}

/// Tanks that no engine follows on isolators.
fn unsupported(
    r: &mut Resolver<'_>,
    field: &Field<Isolators>,
    (ground, on_slab): (Option<&Foundation>, bool),
    support: Option<Support>,
) {
    if ground.is_none_or(|f| f.kind.value.is_some()) && !on_slab {
        let message = "isolators without a slab: the bottom of the tank would not stand on one rigid body";
        let allowed = "\"foundation\": { \"kind\": \"slab\", … }";
        r.refuse(Code::Unsupported, field, message, allowed);
    }
    if let Some(waves) = ground.and_then(|f| f.shear_wave_velocity.given.as_ref()) {
        let message = "isolators and soil under one slab: no engine follows both";
        let allowed = "no shear_wave_velocity, or no isolators";
        r.refuse(Code::Unsupported, waves, message, allowed);
    }
    if support == Some(Support::Unanchored) {
        let message = "isolators under an unanchored tank: no engine follows uplift and isolators together";
        let allowed = "\"support\": \"anchored\", or no isolators";
        r.refuse(Code::Unsupported, field, message, allowed);
    }
}

/// Values that are valid one by one but not together.
fn contradictions(r: &mut Resolver<'_>, given: &Isolators, bearing: Option<Bearing>, damper: Option<[f64; 2]>) {
    match (bearing, &given.friction_slow.given, &given.initial_stiffness.given) {
        (Some(Bearing::FrictionPendulum { friction, slow, .. }), Some(field), _) if slow > friction => {
            let message = "friction at rest above that of fast sliding";
            let allowed = "at most tank.isolators.friction";
            r.refuse(Code::Contradiction, field, message, allowed);
        }
        (Some(Bearing::LeadRubber { initial, yielded, .. }), _, Some(field)) if initial <= yielded => {
            let message = "the stiffness before yielding is not above that after it";
            let allowed = "more than tank.isolators.stiffness";
            r.refuse(Code::Contradiction, field, message, allowed);
        }
        _ => {}
    }
    if let (Some(field), None) = (&given.damper_exponent.given, damper) {
        let message = "damper_exponent does not apply to a tank without dampers";
        r.refuse(Code::DoesNotApply, field, message, "together with damper_coefficient");
    }
}

/// The keys of a kind.
struct Keys<'a, 'f> {
    r: &'a mut Resolver<'f>,
    field: &'a Field<Isolators>,
    kind: Option<Isolation>,
}

impl Keys<'_, '_> {
    /// Whether the kind has a key; a key of another kind is a fault.
    fn applies<T>(&mut self, option: &Opt<T>, kinds: &[Isolation]) -> bool {
        let Some(kind) = self.kind else { return false };
        let applies = kinds.contains(&kind);
        if let (false, Some(given)) = (applies, &option.given) {
            let message = format!("{} does not apply to a {}", option.key.name, words(kind));
            let allowed: Vec<String> =
                kinds.iter().map(|kind| format!("\"kind\": \"{}\"", kind.written().unwrap_or_default())).collect();
            self.r.refuse(Code::DoesNotApply, given, &message, &allowed.join(" or "));
        }
        applies
    }

    /// A number that these kinds need; NaN without.
    fn needed<T: Si + FromNode>(&mut self, option: &Opt<T>, kinds: &[Isolation]) -> f64 {
        let applies = self.applies(option, kinds);
        match (&option.given, applies) {
            (Some(given), _) => self.r.number(given),
            (None, false) => f64::NAN,
            (None, true) => {
                let own = option.key.example;
                let example = match (own.is_empty(), own.parse::<f64>().is_ok()) {
                    (true, _) => T::example(),
                    (false, true) => own.into(),
                    (false, false) => format!("\"{own}\""),
                };
                let allowed = option.key.limits.describe(T::DIMENSION);
                self.r.missing(self.field, option, "", &allowed, &example);
                f64::NAN
            }
        }
    }

    /// A number that follows another.
    fn follows<T: Si + FromNode>(&mut self, option: &Opt<T>, value: f64, kinds: &[Isolation]) -> f64 {
        let applies = self.applies(option, kinds);
        match &option.given {
            Some(given) => self.r.number(given),
            None => {
                if let (Absent::Follows(words), true) = (&option.key.absent, applies) {
                    self.r.echo_default(&option.path, words, "not given");
                }
                value
            }
        }
    }

    /// A number or its default, which the report lists if it is `used`.
    fn or_default<T: Si + Resolved<Domain = f64>>(&mut self, option: &Opt<T>, kinds: &[Isolation], used: bool) -> f64 {
        let applies = self.applies(option, kinds);
        match &option.given {
            Some(given) => self.r.number(given),
            None if applies && used => self.r.or_default(option),
            None => 0.0,
        }
    }
}

fn words(kind: Isolation) -> &'static str {
    match kind {
        Isolation::FrictionPendulum => "friction pendulum",
        Isolation::LeadRubber => "lead-rubber bearing",
        Isolation::Elastomer => "bearing of the kind elastomer",
        Isolation::Damper => "damper",
    }
}
