//! `corrosion_allowance` and `measured_thickness` of a course or plate.

use crate::input::tank::read::{Field, Opt};
use crate::input::tank::resolver::{Resolver, like_field};
use crate::input::tank::values::Length;
use files::code::Code;

/// The allowance of the whole tank.
#[derive(Clone, Copy)]
pub(super) struct Common<'a> {
    field: &'a Field<Length>,
    /// [m]
    loss: f64,
}

impl<'a> Common<'a> {
    /// That of the file, if there is one.
    pub(super) fn of(r: &mut Resolver<'_>, given: &'a Opt<Length>) -> Option<Common<'a>> {
        given.given.as_ref().map(|field| Common { field, loss: r.number(field) })
    }
}

/// Thickness that corrosion takes [m], from the allowance of the plate, a measurement, or the allowance of the tank; 0 without them.
///
/// * `thickness`: of the plate as built [m]; NaN where it is not given
pub(super) fn loss(
    r: &mut Resolver<'_>,
    thickness: f64,
    (allowance, measured): (&Opt<Length>, &Opt<Length>),
    common: Option<Common<'_>>,
) -> f64 {
    let allowed = |field: &Field<Length>, loss: f64, r: &mut Resolver<'_>| {
        // A value that is faulty was reported.
        if loss < thickness || !thickness.is_finite() || loss.is_nan() {
            return loss;
        }
        // The allowance of the tank is reported for the first such plate alone.
        if r.faults.list().iter().all(|fault| fault.code != Code::Contradiction || *fault.path != field.path) {
            let allowed = format!("less than {}, the thickness", like_field(field, thickness));
            r.refuse(Code::Contradiction, field, "the corrosion allowance takes the whole plate", &allowed);
        }
        0.0
    };
    match (&allowance.given, &measured.given) {
        (None, None) => common.map_or(0.0, |common| allowed(common.field, common.loss, r)),
        (Some(field), None) => {
            let loss = r.number(field);
            allowed(field, loss, r)
        }
        (None, Some(field)) => {
            let measured = r.number(field);
            if measured <= thickness || !thickness.is_finite() {
                return (thickness - measured).max(0.0);
            }
            let allowed = format!("at most {}, the thickness", like_field(field, thickness));
            let message = "the measured plate is thicker than the plate as built";
            r.refuse(Code::Contradiction, field, message, &allowed);
            0.0
        }
        (Some(_), Some(field)) => {
            let message = "corrosion is given twice";
            let allowed = "either corrosion_allowance or measured_thickness";
            r.refuse(Code::Exclusive, field, message, allowed);
            0.0
        }
    }
}
