//! `record`: processing of the accelerogram.

use crate::input::records::Processing;
use crate::input::tank::read::{Opt, object};
use crate::input::tank::resolver::{Resolver, range_fault};
use crate::input::tank::values::{Acceleration, Number, Time};
use ::tank::keys::{Limits, without};
use files::code::Code;

object! {
    /// Processing of the accelerogram, in this order: scale, stretch the time axis, resample.
    Record {
        /// Scale to this peak ground acceleration; above 5 g with --allow-implausible only. Give either this or scale_by.
        scale_to ("0.3 g"): Opt<Acceleration> [Limits::from(1e-4).to(10.0 * tank::STANDARD_GRAVITY)]
            = without("not scaled to a peak"),
        /// Multiply the accelerations by this. A negative factor reverses the shaking; 0 is rejected.
        scale_by (1.5): Opt<Number> [Limits::from(-1000.0).to(1000.0)] = without("1"),
        /// Multiply the time axis by this (a model at length scale 1:3 needs 1/sqrt(3) = 0.57735).
        time_factor (0.57735): Opt<Number> [Limits::from(1e-3).to(1e3)] = without("1"),
        /// Resample to this time step by linear interpolation.
        resample ("0.005 s"): Opt<Time> [Limits::from(1e-5).to(1.0)] = without("time step of the record"),
    }
}

/// Processing of the record.
pub(super) fn record(r: &mut Resolver<'_>, option: &Opt<Record>) -> Processing {
    let Some(given) = option.or_absent() else { return Processing::default() };
    let scale_to = r.optional(&given.scale_to);
    let scale_by = r.optional(&given.scale_by);
    if let (Some(factor), Some(field)) = (scale_by, &given.scale_by.given) {
        if factor == 0.0 {
            let message = "a factor of 0 removes all motion";
            r.refuse(Code::OutOfRange, field, message, "any other number");
        } else if given.scale_to.given.is_some() && factor != 1.0 && factor.is_finite() {
            let message = "scale_to and scale_by exclude each other";
            let allowed = "either scale_to or scale_by (1.0 together with scale_to)";
            let fault = range_fault(Code::Exclusive, field, message, allowed);
            r.faults.push(fault.help("remove scale_by to scale to the peak, or scale_to to scale by a factor"));
        }
    }
    Processing {
        scale_to,
        scale_by,
        time_factor: r.optional(&given.time_factor),
        resample: r.optional(&given.resample),
    }
}
