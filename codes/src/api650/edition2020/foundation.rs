//! Overturning of the foundation and pressure on the ground (E.6.2.3).
//!
//! ```text
//! 0.5 D (W_p + W_f + W_T + W_fd + W_g)/M_s ≥ 2        without vertical acceleration
//! ```
//!
//! Pressure on the ground, against a given allowable one:
//!
//! ```text
//! slab            rigid, of diameter D, without tension: W/A ± M_s/(π D³/32) while it is pressed everywhere
//! ring or pad     q_rw/b + ½ p_i + W_fd/(π D b), the shell on the middle of its width b; and p_i within it
//! p_i             product with the vertical motion, and the base pressure of M_s − M_rw
//! ```
//!
//! The annex has ring walls proportioned for the largest compression of the shell and slabs for the slab moment; how the product shares
//! in it is derived. The design of the concrete itself is that of its own code.
//!
//! W_T is taken as shell and roof: the nomenclature of the annex counts product and bottom in it a second time. The annex states the
//! ratio for mechanically anchored tanks; here every tank meets it. Recalled, not compared with the printed standard.

use tank::FoundationKind;
use tank::assessment::{CheckStatus, Excitation};
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Moment, Stress};

use super::accelerations::Accelerations;
use super::forces::Forces;
use super::{Run, limit_states};
use crate::ec8::bearing::{largest_pressure, leaves_kern};

const E6_2_3: &str = "API 650:2020 E.6.2.3";
const DERIVED: &str = "API 650:2020 E.6.1.5, derived";

impl Run<'_> {
    /// Demands on the foundation: load of the shell on a ring wall with M_rw, pressure under a slab with M_s.
    fn demands(&mut self) {
        if self.excitation != Excitation::Site {
            return;
        }
        let sheet = &mut self.sheet;
        sheet.section("Demands on the foundation");
        if self.compression.is_some() {
            let name = "largest load of the shell on a ring wall per length, with M_rw";
            sheet.calc("q_rw", name, "σ_c·t_s", LineForce, DERIVED);
        }
        let name = "largest pressure under a slab of diameter D, linear";
        let formula = "(W_p + W_f + W_s + W_r)·(1 + 0.4·A_v)·4/(π·D²) + 32·M_s/(π·D³)";
        sheet.calc("p_s", name, formula, Stress, DERIVED);
        let name = "smallest pressure under it; negative: the slab lifts on one side without its own weight";
        let formula = "(W_p + W_f + W_s + W_r)·(1 - 0.4·A_v)·4/(π·D²) - 32·M_s/(π·D³)";
        sheet.calc("p_s0", name, formula, Stress, DERIVED);
    }

    /// Pressure on the ground against the allowable one.
    fn bearing(&mut self, a: &Accelerations, forces: &Forces) {
        let (b, id) = (self.basis, limit_states::BEARING.id);
        let Some(allowed) = self.site.and_then(|site| site.bearing_capacity) else {
            return self.missing(id, "site.api650.bearing_capacity");
        };
        let Some(foundation) = b.case.tank.foundation else { return self.missing(id, "tank.foundation") };
        let own = self.site.and_then(|site| site.foundation_weight).unwrap_or(0.0);
        self.sheet.given(&[("W_fd", own, Force)]);
        self.sheet.section("Pressure on the ground");
        self.sheet.input("p_a", "allowable pressure", allowed, Stress, "site.api650.bearing_capacity");
        let (pressure, note) = match foundation.kind {
            FoundationKind::Slab => {
                let weight = b.w_p + b.w_f + b.w_s + b.w_r;
                let under = |sign: f64| weight * (1.0 + sign * 0.4 * a.a_v) + own;
                let shape = b.case.tank.shape;
                let rests = !leaves_kern(shape, under(-1.0), forces.m_s);
                let name = "largest pressure under a rigid slab of diameter D";
                let pressure = if rests {
                    let formula = "((W_p + W_f + W_s + W_r)·(1 + 0.4·A_v) + W_fd)·4/(π·D²) + 32·M_s/(π·D³)";
                    self.sheet.calc("p_g", name, formula, Stress, DERIVED)
                } else {
                    let largest = |sign| largest_pressure(shape, under(sign), forces.m_s);
                    let source = "plane pressure without tension, the vertical motion up or down";
                    let value = largest(1.0).max(largest(-1.0));
                    self.sheet.look_up("p_g", name, source, value, Stress, DERIVED)
                };
                (pressure, "a slab as wide as the tank; a wider one presses less")
            }
            FoundationKind::RingWall | FoundationKind::Soil => {
                let Some(width) = foundation.width else { return self.missing(id, "tank.foundation.width") };
                let Some(sigma) = self.compression else {
                    let reason = "the compression of the shell is not known";
                    return self.without_comparison(id, CheckStatus::NotChecked, reason, None);
                };
                let name = "pressure of the liquid on the bottom, with that of the earthquake at its edge";
                let formula = match b.case.tank.roof.on_columns > 0.0 {
                    true => "(W_p + W_f + W_r - W_rs)·(1 + 0.4·A_v)·4/(π·D²) + 32·(M_s - M_rw)/(π·D³)",
                    false => "(W_p + W_f)·(1 + 0.4·A_v)·4/(π·D²) + 32·(M_s - M_rw)/(π·D³)",
                };
                self.sheet.calc("p_i", name, formula, Stress, DERIVED);
                self.sheet.given(&[("q_rw", sigma * b.t_s, LineForce), ("b_f", width, Length)]);
                let name = "pressure under the ring wall or pad, the larger of that and of the pressure within it";
                let formula = "max(q_rw/b_f + 0.5·p_i + W_fd/(π·D·b_f), p_i)";
                let pressure = self.sheet.calc("p_g", name, formula, Stress, DERIVED);
                (pressure, "the shell on the middle of the ring wall or pad")
            }
        };
        self.check(id, "Pressure on the ground", pressure, allowed, Stress, E6_2_3, note);
    }

    /// Overturning of tank and foundation about the toe; not checked without the weight of the foundation.
    pub(super) fn foundation(&mut self, a: &Accelerations, forces: &Forces) {
        self.demands();
        if self.excitation == Excitation::Site {
            self.bearing(a, forces);
        }
        let Some(weight) = self.site.and_then(|site| site.foundation_weight) else {
            return self.missing(limit_states::FOUNDATION.id, "site.api650.foundation_weight");
        };
        let sheet = &mut self.sheet;
        sheet.section("Overturning of the foundation");
        let name = "weight of the foundation and of the soil on it, W_fd + W_g";
        sheet.input("W_fd", name, weight, Force, "site.api650.foundation_weight");
        let name = "resisting moment of all weights about the edge of the tank";
        let formula = "0.5·D·(W_p + W_f + W_s + W_r + W_fd)";
        let resisting = sheet.calc("M_R", name, formula, Moment, E6_2_3);
        let name = "twice the slab moment";
        let demand = sheet.calc("M_2", name, "2·M_s", Moment, E6_2_3);
        let ratio = sheet.calc("S", "stability ratio", "M_R/M_s", Dimensionless, E6_2_3);
        let note = format!("stability ratio {ratio:.2}, at least 2 is required");
        let (id, name) = (limit_states::FOUNDATION.id, "Overturning of the foundation");
        self.check(id, name, demand, resisting, Moment, E6_2_3, &note);
    }
}
