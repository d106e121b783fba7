//! Overturning of the foundation (E.6.2.3).
//!
//! ```text
//! 0.5 D (W_p + W_f + W_T + W_fd + W_g)/M_s ≥ 2        without vertical acceleration
//! ```
//!
//! W_T is taken as shell and roof: the nomenclature of the annex counts product and bottom in it a second time. The annex states the
//! ratio for mechanically anchored tanks; here every tank meets it. Recalled, not compared with the printed standard.

use tank::units::Dimension::{Dimensionless, Force, Length, Moment};

use super::forces::Forces;
use super::{Run, limit_states};

const E6_2_3: &str = "API 650:2020 E.6.2.3";

impl Run<'_> {
    /// Overturning of tank and foundation about the toe; not checked without the weight of the foundation.
    pub(super) fn foundation(&mut self, forces: &Forces) {
        let b = self.basis;
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
