//! Overturning of the foundation (E.6.2.3).
//!
//! ```text
//! 0.5 D (W_p + W_f + W_T + W_fd + W_g)/M_s ≥ 2        without vertical acceleration
//! ```
//!
//! The demands on a ring wall (M_rw) and on a slab (M_s) are printed for its design: the shell's compression per length, and the
//! pressures under a rigid slab of diameter D on elastic ground, W/A ± M/W with W = π D³/32.
//!
//! W_T is taken as shell and roof: the nomenclature of the annex counts product and bottom in it a second time. The annex states the
//! ratio for mechanically anchored tanks; here every tank meets it. Recalled, not compared with the printed standard.

use tank::assessment::Excitation;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Moment, Stress};

use super::accelerations::Accelerations;
use super::forces::Forces;
use super::{Run, limit_states};

const E6_2_3: &str = "API 650:2020 E.6.2.3";
const DERIVED: &str = "API 650:2020 E.6.1.5, derived";

impl Run<'_> {
    /// Demands on the foundation: load of the shell on a ring wall with M_rw, pressure under a slab with M_s.
    fn demands(&mut self, a: &Accelerations, forces: &Forces) {
        if self.excitation != Excitation::Site {
            return;
        }
        let b = self.basis;
        let sheet = &mut self.sheet;
        sheet.section("Demands on the foundation");
        if let Some(sigma) = self.compression {
            let terms = [("σ_c", sigma, Stress), ("t_s", b.t_s, Length)];
            let name = "largest load of the shell on a ring wall per length, with M_rw";
            sheet.calc("q_rw", name, "σ_c·t_s", &terms, LineForce, DERIVED);
        }
        let terms = [
            ("D", b.d, Length),
            ("W_p", b.w_p, Force),
            ("W_f", b.w_f, Force),
            ("W_s", b.w_s, Force),
            ("W_r", b.w_r, Force),
            ("A_v", a.a_v, Dimensionless),
            ("M_s", forces.m_s, Moment),
        ];
        let name = "largest pressure under a slab of diameter D, linear";
        let formula = "(W_p + W_f + W_s + W_r)·(1 + 0.4·A_v)·4/(π·D²) + 32·M_s/(π·D³)";
        sheet.calc("p_s", name, formula, &terms, Stress, DERIVED);
        let name = "smallest pressure under it; negative: the slab lifts on one side without its own weight";
        let formula = "(W_p + W_f + W_s + W_r)·(1 - 0.4·A_v)·4/(π·D²) - 32·M_s/(π·D³)";
        sheet.calc("p_s0", name, formula, &terms, Stress, DERIVED);
    }

    /// Overturning of tank and foundation about the toe; not checked without the weight of the foundation.
    pub(super) fn foundation(&mut self, a: &Accelerations, forces: &Forces) {
        let b = self.basis;
        self.demands(a, forces);
        let Some(weight) = self.site.and_then(|site| site.foundation_weight) else {
            return self.missing(limit_states::FOUNDATION, "site.api650.foundation_weight");
        };
        let sheet = &mut self.sheet;
        sheet.section("Overturning of the foundation");
        let name = "weight of the foundation and of the soil on it, W_fd + W_g";
        sheet.input("W_fd", name, weight, Force, "site.api650.foundation_weight");
        let mut terms = vec![
            ("D", b.d, Length),
            ("W_p", b.w_p, Force),
            ("W_f", b.w_f, Force),
            ("W_s", b.w_s, Force),
            ("W_r", b.w_r, Force),
            ("W_fd", weight, Force),
            ("M_s", forces.m_s, Moment),
        ];
        let name = "resisting moment of all weights about the edge of the tank";
        let formula = "0.5·D·(W_p + W_f + W_s + W_r + W_fd)";
        let resisting = sheet.calc("M_R", name, formula, &terms, Moment, E6_2_3);
        terms.push(("M_R", resisting, Moment));
        let name = "twice the slab moment";
        let demand = sheet.calc("M_2", name, "2·M_s", &terms, Moment, E6_2_3);
        let ratio = sheet.calc("S", "stability ratio", "M_R/M_s", &terms, Dimensionless, E6_2_3);
        let note = format!("stability ratio {ratio:.2}, at least 2 is required");
        let (id, name) = (limit_states::FOUNDATION, "Overturning of the foundation");
        self.check(id, name, demand, resisting, Moment, E6_2_3, &note);
    }
}
