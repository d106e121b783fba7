//! `tank.isolators`.

use files::code::{Code, Warning};
use tank::{Bearing, FoundationKind, Shape, Support};

use super::tank::{Isolation, Isolators, Tank};
use crate::input::tank::key::Absent;
use crate::input::tank::read::{Field, FromNode, Opt};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::syntax::join;
use crate::input::tank::values::Si;

/// Reinforced concrete [kg/m³].
const CONCRETE: f64 = 2500.0;

/// The isolators, of a tank that is held down on a slab.
pub(super) fn isolators(
    r: &mut Resolver<'_>,
    (field, given): (&Field<Isolators>, &Isolators),
    tank: &Tank,
    foundation: Option<&tank::Foundation>,
    shape: Option<Shape>,
) -> Option<tank::Isolators> {
    r.echo_given(&given.kind);
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
    let coefficient = match kind {
        Some(Isolation::Damper) => Some(keys.needed(&given.damper_coefficient, &[Isolation::Damper])),
        _ => keys.r.optional(&given.damper_coefficient),
    };
    let dampers = coefficient.is_some() || given.damper_exponent.given.is_some();
    let exponent = if dampers {
        keys.r.or_default(&given.damper_exponent)
    } else {
        1.0
    };
    let bounds = [&given.lower_bound, &given.upper_bound].map(|bound| keys.r.or_default(bound));
    let displacement_capacity = keys.r.optional(&given.displacement_capacity);
    let slab_mass = keys.r.optional(&given.slab_mass);
    let slab = foundation.filter(|f| f.kind == FoundationKind::Slab);
    if tank.foundation.value().is_none_or(|f| f.kind.value.is_some()) && slab.is_none() {
        let message = "isolators without a slab: the bottom of the tank would not stand on one rigid body";
        let allowed = "\"foundation\": { \"kind\": \"slab\", … }";
        r.faults.push(range_fault(Code::Unsupported, field, message, allowed));
    }
    let waves = tank
        .foundation
        .value()
        .and_then(|f| f.shear_wave_velocity.given.as_ref());
    if let Some(waves) = waves {
        let message = "isolators and soil under one slab: no engine follows both";
        let allowed = "no shear_wave_velocity, or no isolators";
        r.faults.push(range_fault(Code::Unsupported, waves, message, allowed));
    }
    if tank.support.value == Some(Support::Unanchored) {
        let message = "isolators under an unanchored tank: no engine follows uplift and isolators together";
        r.faults.push(range_fault(
            Code::Unsupported,
            field,
            message,
            "\"support\": \"anchored\", or no isolators",
        ));
    }
    if kind == Some(Isolation::FrictionPendulum)
        && let Some(given) = &given.friction_slow.given
        && slow > friction
    {
        let message = "friction at rest above that of fast sliding";
        r.faults.push(range_fault(
            Code::Contradiction,
            given,
            message,
            "at most tank.isolators.friction",
        ));
    }
    if kind == Some(Isolation::LeadRubber)
        && let Some(given) = &given.initial_stiffness.given
        && initial <= stiffness
    {
        let message = "the stiffness before yielding is not above that after it";
        r.faults.push(range_fault(
            Code::Contradiction,
            given,
            message,
            "more than tank.isolators.stiffness",
        ));
    }
    if let (Some(given), None) = (&given.damper_exponent.given, coefficient) {
        let message = "damper_exponent does not apply to a tank without dampers";
        r.faults.push(range_fault(
            Code::DoesNotApply,
            given,
            message,
            "together with damper_coefficient",
        ));
    }
    r.warnings.push(Warning::new(Code::NotUsed, "`tank.isolators` enters the time history of the harmonic engine; the codes' procedures, the response-spectrum method, transfer \
         functions and the other engines take the base as fixed"));
    let thickness = slab.and_then(|slab| slab.thickness);
    let slab_mass = match (slab_mass, thickness) {
        (Some(mass), _) => mass,
        (None, Some(thickness)) => CONCRETE * thickness * shape?.plan_area(),
        (None, None) => {
            let missing = "neither slab_mass nor tank.foundation.thickness";
            r.echo_default("tank.isolators.slab_mass", "0 kg", missing);
            r.warnings.push(Warning::new(
                Code::BaseModel,
                format!("tank.isolators: the slab has no mass, which moves with the tank: {missing}"),
            ));
            0.0
        }
    };
    let bearing = match kind? {
        Isolation::FrictionPendulum => Bearing::FrictionPendulum {
            radius,
            friction,
            slow,
            rate,
            slip,
        },
        Isolation::LeadRubber => Bearing::LeadRubber {
            strength,
            initial,
            yielded: stiffness,
        },
        Isolation::Elastomer => Bearing::Elastomer { stiffness, damping },
        Isolation::Damper => Bearing::Elastomer {
            stiffness,
            damping: 0.0,
        },
    };
    Some(tank::Isolators {
        bearing,
        damper: coefficient.map(|c| [c, exponent]),
        slab_mass,
        slab_thickness: thickness.unwrap_or(0.0),
        bounds,
        displacement_capacity,
    })
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
            let allowed: Vec<String> = kinds
                .iter()
                .map(|kind| format!("\"kind\": \"{}\"", id(*kind)))
                .collect();
            self.r
                .faults
                .push(range_fault(Code::DoesNotApply, given, &message, &allowed.join(" or ")));
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
                let key = option.key.name;
                if !self.r.faults.suggest(&format!("did you mean `{key}`?")) {
                    let place = self.field.span.start..self.field.span.start + 1;
                    let missing = Field::<T>::missing(place, join(&self.field.path, key));
                    let message = format!("the key `{key}` is missing");
                    let fault = range_fault(
                        Code::MissingKey,
                        &missing,
                        &message,
                        &option.key.limits.describe(T::DIMENSION),
                    );
                    let own = option.key.example;
                    let example = match (own.is_empty(), own.parse::<f64>().is_ok()) {
                        (true, _) => T::example(),
                        (false, true) => own.into(),
                        (false, false) => format!("\"{own}\""),
                    };
                    self.r.faults.push(fault.help(format!("add \"{key}\": {example}")));
                }
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
    fn or_default<T: Si + FromNode>(&mut self, option: &Opt<T>, kinds: &[Isolation], used: bool) -> f64 {
        let applies = self.applies(option, kinds);
        match &option.given {
            Some(given) => self.r.number(given),
            None if applies && used => self.r.or_default(option),
            None => 0.0,
        }
    }
}

fn id(kind: Isolation) -> &'static str {
    match kind {
        Isolation::FrictionPendulum => "friction_pendulum",
        Isolation::LeadRubber => "lead_rubber",
        Isolation::Elastomer => "elastomer",
        Isolation::Damper => "damper",
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
