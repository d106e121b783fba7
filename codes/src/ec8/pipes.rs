//! Displacement of pipes between the tank and their first support on the ground.
//!
//! ```text
//! Δ = x d_g/x_0        x_0 = 500 m        d_g = 0.025 a_g S T_C T_D (EN 1998-1 3.2.2.4)        Δ + w ≤ allowed
//! ```
//!
//! x is the distance of the support from the connection, w the largest uplift of the wall. The allowed displacement is a design value of
//! pipe and connection; 4.5.2.3 asks the connection for an overstrength of 1.3 over the pipe, which that value has to contain. The sum
//! stands for ground and uplift at right angles. Sliding is left out, it has its own check; so is the displacement of the wall against
//! its base.
//!
//! Source: EN 1998-4:2006 4.5.1.3 and 4.5.2.3, recalled.

use super::demand::Edition;
use super::limit_states::PIPES;
use super::spectrum::{ElasticSpectrum, EnvSpectrum};
use super::work::Work;
use tank::assessment::CheckStatus;
use tank::units::Dimension::*;

/// Paths of what the check needs.
const PATH: &str = "tank.pipes";
const DISTANCE: &str = "tank.pipes.support_distance";
const ALLOWED: &str = "tank.pipes.allowable_displacement";

/// Writes the check, or what is missing. Needs the uplift.
pub(super) fn assess(work: &mut Work) {
    let Some(pipes) = work.case.tank.pipes else { return work.missing(PIPES.id, PATH) };
    let Some(distance) = pipes.support_distance else { return work.missing(PIPES.id, DISTANCE) };
    let Some(allowed) = pipes.allowable_displacement else { return work.missing(PIPES.id, ALLOWED) };
    let Some((factor, clause, [ag, soil, t_c, t_d])) = ground(work) else { return work.missing(PIPES.id, "site.ec8") };
    let uplift = match work.base.uplift() {
        Ok(uplift) => uplift,
        Err(reason) => {
            let reason = format!("the uplift is not known: {reason}");
            return work.without_comparison(PIPES.id, CheckStatus::NotChecked, &reason, None);
        }
    };
    let main = work.edition.main("4.5.1.3");
    work.sheet.section("Displacement of pipes");
    work.sheet.given(&[("a_g", ag, Acceleration), ("S", soil, Dimensionless), ("T_C", t_c, Time), ("T_D", t_d, Time)]);
    let formula = format!("{factor}·a_g·S·T_C·T_D");
    let name = "design displacement of the ground";
    work.sheet.calc("d_g", name, &formula, Length, clause);
    let name = "distance of the first support";
    work.sheet.input("x_s", name, distance, Length, DISTANCE);
    let name = "displacement of the ground between tank and support";
    work.sheet.calc("Δ", name, "x_s·d_g/(500 m)", Length, &main);
    work.sheet.given(&[("w", uplift, Length)]);
    let name = "with the largest uplift of the wall";
    let demand = work.sheet.calc("Δ_w", name, "Δ + w", Length, &work.edition.main("4.5.2.3"));
    let clause = work.edition.main("4.5.2.3");
    let name = "Displacement of a pipe against its support";
    let note = "without sliding and deformation of the wall";
    work.check(PIPES.named(name), demand, allowed, &clause, note);
}

/// Factor of d_g, its clause, and a_g [m/s²], S, T_C, T_D [s] of the site.
fn ground(work: &Work) -> Option<(&'static str, &'static str, [f64; 4])> {
    let site = work.demand.site?;
    match work.edition {
        Edition::En2006 => {
            let s = ElasticSpectrum::new(&site).ok()?;
            let [_, t_c, t_d] = s.corners;
            Some(("0.025", "EN 1998-1:2004 3.2.2.4", [s.ag, s.soil, t_c, t_d]))
        }
        Edition::Env1998 => {
            let s = EnvSpectrum::new(&site).ok()?;
            let [_, t_c, t_d] = s.corners;
            Some(("0.05", "ENV 1998-1-1:1994 4.2.2", [s.ag, s.soil, t_c, t_d]))
        }
    }
}

#[cfg(test)]
mod tests;
