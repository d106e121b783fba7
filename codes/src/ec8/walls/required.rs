//! Areas of bars that the ultimate limit state needs where none are given.

use super::place::{Place, Situation};
use super::section::concrete;
use crate::ec8::work::Work;
use crate::en1992::required::area;
use crate::en1992::section::Face;
use crate::sheet::with_unit;
use tank::BarDirection;
use tank::units::Dimension::*;

/// Strength assumed where none is known: f_ck of C30/37 [Pa].
const STRENGTH: f64 = 30e6;
/// Yield strength assumed, f_yk of B500 [Pa].
const YIELD: f64 = 500e6;
/// Distance of the bars from their face that is assumed [m], at most a fifth of the wall.
const COVER: f64 = 0.05;

/// Writes the largest area of each direction and face; returns them in words.
pub(super) fn assess(work: &mut Work, places: &[&Place]) -> String {
    let factors = work.case.procedures.concrete;
    work.sheet.section("Bars that the wall needs (ultimate limit state)");
    let mut words = Vec::new();
    for (direction, what, symbol) in
        [(BarDirection::Hoop, "horizontal", "a_h"), (BarDirection::Vertical, "vertical", "a_v")]
    {
        for (face, side, index) in [(Face::Inner, "inner", "i"), (Face::Outer, "outer", "o")] {
            let mut governing: Option<(Option<f64>, &Place)> = None;
            let seismic = |p: &&&Place| p.direction == direction && p.factors.situation == Situation::Seismic;
            for place in places.iter().filter(seismic) {
                let needed = needed(place, factors.gamma_c, factors.gamma_s, face);
                let larger = match (needed, governing.as_ref().map(|g| g.0)) {
                    (_, None) | (None, Some(Some(_))) => true,
                    (Some(a), Some(Some(b))) => a > b,
                    (_, Some(None)) => false,
                };
                if larger {
                    governing = Some((needed, place));
                }
            }
            let Some((needed, place)) = governing else { continue };
            let Some(needed) = needed else {
                words.push(format!("{what} {side}: the concrete crushes, a thicker wall"));
                continue;
            };
            let name = format!("{what} bars, {side} face, {}", place.describe());
            let source = format!(
                "n = {}, m = {}, f_yk = 500 MPa, {} from the face",
                with_unit(place.n, LineForce),
                with_unit(place.m, LineMoment),
                with_unit(cover(place), Length)
            );
            let symbol = format!("{symbol},{index}");
            work.sheet.look_up(&symbol, &name, &source, needed, LineArea, "EN 1992-1-1:2004 6.1");
            words.push(format!("{what} {side} {}", with_unit(needed, LineArea)));
        }
    }
    words.join(", ")
}

fn cover(place: &Place) -> f64 {
    COVER.min(0.2 * place.course.total_thickness())
}

fn needed(place: &Place, gamma_c: f64, gamma_s: f64, face: Face) -> Option<f64> {
    let strength = concrete(place.course).1.unwrap_or(STRENGTH);
    let design = (strength / gamma_c, YIELD / gamma_s);
    area(place.course.total_thickness(), cover(place), design, (place.n, place.m), face)
}
