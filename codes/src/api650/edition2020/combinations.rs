//! Factors of the loads in each comparison, for the assumptions of the sheet.
//!
//! The annex writes its combinations into its formulas: D (weights), F (hydrostatic), P (design pressure), E_h and E_v (horizontal and
//! vertical earthquake). Vertical motion counts with 0.4 beside the whole horizontal one (E.6.1.3, 5.2.2; recalled).

use super::Run;

impl Run<'_> {
    /// The factors, one assumption.
    pub(super) fn combinations(&mut self) {
        let hoop = match self.pressure() > 0.0 {
            true => {
                "; with the design pressure 1.0 F + 1.0 P and the same root (the annex asks for F_p P, at least 0.4 P)"
            }
            false => "",
        };
        let hold = match self.basis.anchored() {
            true => "anchors 1.0 E_h + 1.0 P − (1 − 0.4 A_v) D".to_string(),
            false => format!("anchorage ratio 1.0 E_h against (1 − 0.4 A_v) D + w_a − {} P", self.f_p()),
        };
        self.out.assumptions.push(format!(
            "Combinations: E_h = √(impulsive² + convective²), all of it with 0.4 of the vertical motion; hoop stress \
             1.0 F ± √(impulsive² + convective² + (0.4 A_v F)²){hoop}; compression (1 + 0.4 A_v) D + 1.0 E_h; {hold}; sliding 1.0 E_h \
             against (1 − 0.4 A_v) (D + F)."
        ));
    }
}
