//! `tank.wall_base`.

use files::code::Code;
use tank::Shape;

use crate::input::tank::choice::choice;
use crate::input::tank::read::{Field, Opt, object};
use crate::input::tank::resolver::Resolver;
use crate::input::tank::values::{Number, Stress};
use ::tank::words;
use tank::keys::{Limits, without};

object! {
    /// Joint between the wall of a concrete cylinder and its base. Hoop force, bending and shear of the wall are those of the shell on this
    /// joint.
    WallBase {
        /// What the joint lets the foot of the wall do.
        kind: Field<Joint>,
        /// Radial stiffness of a sliding joint with bearing pads: force per length of the circumference and displacement (G b/t of a pad of
        /// width b and thickness t).
        stiffness ("20 MN/m2"): Opt<Stress> [Limits::from(0.0).to(1e12)] = without("the joint resists by friction alone"),
        /// Coefficient of friction of a sliding joint. Without stiffness the wall is checked free of it and with it, whichever is worse; the
        /// shear of the earthquake along the joint is compared with it.
        friction (0.5): Opt<Number> [Limits::from(0.0).to(2.0)]
            = without("the shear of the earthquake along a sliding joint is not checked"),
    }
}

words! {
    /// Kind of joint.
    pub(crate) Joint as WallJoint {
        /// Monolithic with the base: the foot neither moves nor turns.
        Fixed = "fixed",
        /// The foot turns freely and does not move.
        Hinged = "hinged",
        /// The foot turns freely and moves along the radius; needs stiffness or friction.
        Sliding = "sliding",
    }
}

choice!(Joint);

/// The joint of a tank; that of a metal shell or of a box cannot be chosen.
pub(super) fn wall_base(
    r: &mut Resolver<'_>,
    option: &Opt<WallBase>,
    shape: Option<Shape>,
    metal: bool,
) -> Option<tank::WallBase> {
    let concrete = matches!(shape, Some(Shape::Cylinder { .. })) && !metal;
    let Some(field) = &option.given else {
        if concrete {
            r.echo_default("tank.wall_base.kind", "fixed", "the wall is monolithic with its base");
        }
        return Some(tank::WallBase::Fixed);
    };
    if shape.is_some() && !concrete {
        let message = "wall_base does not apply to a metal shell or to the walls of a box";
        let allowed = "a cylinder of concrete, or no wall_base";
        r.refuse(Code::DoesNotApply, field, message, allowed);
    }
    let given = field.value.as_ref()?;
    r.echo_given(&given.kind);
    let stiffness = r.optional(&given.stiffness);
    let friction = r.optional(&given.friction);
    let kind = given.kind.value?;
    if kind != Joint::Sliding {
        let allowed = "\"kind\": \"sliding\", or a joint without it";
        let message = "stiffness does not apply to a joint that does not slide";
        r.inapplicable(&given.stiffness, message, allowed);
        let message = "friction does not apply to a joint that does not slide";
        r.inapplicable(&given.friction, message, allowed);
    } else if given.stiffness.given.is_none() && given.friction.given.is_none() {
        let message = "a sliding joint without the force with which it resists";
        let allowed = "stiffness or friction beside \"kind\": \"sliding\"; 0 is an answer";
        r.refuse(Code::Incomplete, field, message, allowed);
    }
    Some(match kind {
        Joint::Fixed => tank::WallBase::Fixed,
        Joint::Hinged => tank::WallBase::Hinged,
        Joint::Sliding => tank::WallBase::Sliding { stiffness, friction },
    })
}
