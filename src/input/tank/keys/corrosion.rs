//! `corrosion_allowance` and `measured_thickness` of a course or plate.

use crate::input::tank::read::Opt;
use crate::input::tank::resolver::{Resolver, like_field};
use crate::input::tank::values::Length;
use files::code::Code;

/// Thickness that corrosion takes [m], from the allowance or from a measurement; 0 without either.
///
/// * `thickness`: of the plate as built [m]; NaN where it is not given
pub(super) fn loss(r: &mut Resolver<'_>, thickness: f64, allowance: &Opt<Length>, measured: &Opt<Length>) -> f64 {
    match (&allowance.given, &measured.given) {
        (None, None) => 0.0,
        (Some(field), None) => {
            let loss = r.number(field);
            if loss < thickness || !thickness.is_finite() {
                return loss;
            }
            let allowed = format!("less than {}, the thickness", like_field(field, thickness));
            let message = "the corrosion allowance takes the whole plate";
            r.refuse(Code::Contradiction, field, message, &allowed);
            0.0
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
