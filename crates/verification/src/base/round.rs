//! A round bottom plate, lifted evenly all around.
//!
//! Source:    plate theory, w = c₀ + c₁ r² + c₂ ln r + c₃ r² ln r − p r⁴/(64 D); an independent program
//! Model:     `base::Strip` with rings in place of beams; elastic
//! Reference: the four constants; F(w) of an independent axisymmetric program with the wall's edge, tank C
//! Tolerance: 2 %: the ground is elastic in the model and rigid in the closed form; rings of another discretisation

use ::base::{Bands, Lifted, Plan, Plate, Rim, Strip, closed};

use super::{TANKS, failure};
use crate::benchmark::{Benchmark, Part};
use crate::{Answer, Reference, Row};

pub(crate) const BENCHMARK: Benchmark = Benchmark {
    id: "base-round",
    title: "Round bottom plate, lifted evenly",
    model: "The whole bottom plate under an uplift that is the same all around, from the rim to the centre.",
    ids: &[("U3", "hold-down force against uplift")],
    parts: &[Part::Fast(rows)],
};

fn rows() -> Answer {
    let mut rows = Vec::new();
    let plate = Plate { thickness: 0.01, young_modulus: 205e9, poisson_ratio: 0.3, yield_stress: None };
    let (pressure, radius) = (128e3, 3.0);
    // Small enough that the rim's hoop forces do not matter.
    let uplift = 0.25e-3;
    let (mut low, mut high) = (1.0, 2.999);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if closed::round(&plate, pressure, radius, middle).0 > uplift {
            low = middle;
        } else {
            high = middle;
        }
    }
    let expected = closed::round(&plate, pressure, radius, low).1;
    let strip = Strip::new(Bands::uniform(plate), Rim::Hinged, radius, 1e12, pressure, Plan::Round).map_err(failure)?;
    let strip = strip.refined(2.0);
    let mut state = Lifted::at_rest(&strip, 0.0).map_err(failure)?;
    state.lift_to(uplift).map_err(failure)?;
    rows.push(Row::new(
        "U3",
        "rim hinged, small uplift",
        (expected, "four constants of the round plate", Reference::ClosedForm),
        state.point().hold_down,
        (0.02, "N/m"),
    ));
    let tank = &TANKS[2];
    let strip = tank.strip(false, 1e8, Plan::Round).map_err(failure)?;
    let mut state = Lifted::at_rest(&strip, tank.weight).map_err(failure)?;
    for (uplift, force) in [
        (1e-3, 38.26),
        (5e-3, 46.27),
        (10e-3, 52.50),
        (20e-3, 61.07),
        (50e-3, 77.60),
        (100e-3, 97.99),
        (200e-3, 138.38),
    ] {
        state.lift_to(uplift).map_err(failure)?;
        rows.push(Row::new(
            "U3",
            format!("tank C: hold-down force at {} mm", 1e3 * uplift),
            (force, "independent axisymmetric program", Reference::SecondFormulation),
            state.point().hold_down / 1e3,
            (0.02, "kN/m"),
        ));
    }
    Ok(rows)
}
