//! Accelerations from the user's table with their lines: another damping by η, importance by γ_I ([`crate::hazard`]).

use crate::hazard::{CLAUSE, ordinate, scaled};
use crate::sheet::{Sheet, number, with_unit};
use tank::hazard::SpectrumTable;
use tank::units::Dimension::{self, Acceleration, Dimensionless, Time};

/// The user's table as the seismic action of an edition.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tabulated<'a> {
    /// Horizontal spectrum.
    pub horizontal: &'a SpectrumTable,
    /// Vertical spectrum.
    pub vertical: Option<&'a SpectrumTable>,
    /// Damping ratio of the ordinates ξ_t.
    pub damping: f64,
    /// a_vg over the peak ground acceleration, where there is no vertical table.
    pub vertical_ratio: f64,
    /// Importance factor γ_I.
    pub importance: f64,
    /// Damping correction η of the edition.
    pub correction: fn(f64) -> f64,
    /// Its formula for a damping in per cent, `%` in its place.
    pub correction_formula: &'static str,
    /// Its clause.
    pub clause: &'static str,
}

/// Damping correction of EN 1998-1:2004 on the sheet.
pub(super) const EN_CORRECTION: &str = "max(√(10/(5 + %)), 0.55)";
/// Damping correction of the pre-standard on the sheet.
pub(super) const ENV_CORRECTION: &str = "max(√(7/(2 + %)), 0.7)";

impl Tabulated<'_> {
    /// Peak horizontal ground acceleration γ_I S_t(0) [m/s²].
    pub(super) fn peak(&self) -> f64 {
        self.importance * self.horizontal.peak()
    }

    /// Peak vertical ground acceleration [m/s²].
    pub(super) fn vertical_peak(&self) -> f64 {
        match self.vertical {
            Some(table) => self.importance * table.peak(),
            None => self.vertical_ratio * self.peak(),
        }
    }

    /// η(ξ)/η(ξ_t).
    fn ratio(&self, damping: f64) -> f64 {
        (self.correction)(damping) / (self.correction)(self.damping)
    }

    /// Horizontal acceleration [m/s²] at a period [s] and damping.
    pub(super) fn horizontal(&self, period: f64, damping: f64) -> f64 {
        self.importance * scaled(self.horizontal, period, self.ratio(damping))
    }

    /// Vertical acceleration [m/s²] at a period [s] and damping; none without a vertical table.
    pub(super) fn vertical(&self, period: f64, damping: f64) -> Option<f64> {
        let table = self.vertical?;
        Some(self.importance * scaled(table, period, self.ratio(damping)))
    }

    /// Lines of the ground motion.
    pub(super) fn describe(&self, sheet: &mut Sheet, vertical: bool) {
        let table = self.horizontal;
        let rows = format!("{} rows up to {}", table.rows().len(), with_unit(table.longest(), Time));
        let name = "ground acceleration of the table, T = 0";
        sheet.look_up("S_0", name, &rows, table.peak(), Acceleration, CLAUSE);
        let name = "damping ratio of the table";
        sheet.input("ξ_t", name, self.damping, Dimensionless, CLAUSE);
        let name = "importance factor";
        sheet.input("γ_I", name, self.importance, Dimensionless, "site.ec8.importance");
        let name = "peak ground acceleration, on the ground of the site";
        sheet.calc("a_g", name, "γ_I·S_0", Acceleration, CLAUSE);
        match self.vertical {
            _ if !vertical => {}
            Some(table) => {
                let name = "vertical ground acceleration of the table, T = 0";
                sheet.look_up("S_v0", name, "vertical rows", table.peak(), Acceleration, CLAUSE);
                let name = "vertical ground acceleration";
                sheet.calc("a_vg", name, "γ_I·S_v0", Acceleration, CLAUSE);
            }
            None => {
                sheet.given(&[("k_v", self.vertical_ratio, Dimensionless)]);
                let name = "vertical ground acceleration";
                sheet.calc("a_vg", name, "k_v·a_g", Acceleration, "site.spectrum.vertical_ratio");
            }
        }
    }

    /// Line `symbol` of the horizontal acceleration over q, with those of its parts; returns it [m/s²].
    ///
    /// * `part`: of the response ("impulsive")
    /// * `(period, damping, q)`: T [s], ξ, behaviour factor
    pub(super) fn line(
        &self,
        sheet: &mut Sheet,
        (symbol, part): (&str, &str),
        (period, damping, q): (f64, f64, f64),
    ) -> f64 {
        let table = self.horizontal;
        let at = with_unit(period, Time);
        let name = format!("{part} ordinate of the table at T = {at}");
        let source = "linear between the rows of the table";
        sheet.look_up("S_t", &name, source, ordinate(table, period), Acceleration, CLAUSE);
        sheet.given(&[("ξ", 100.0 * damping, Dimensionless), ("ξ_t", 100.0 * self.damping, Dimensionless)]);
        let [wanted, given] = ["ξ", "ξ_t"].map(|symbol| self.correction_formula.replace('%', symbol));
        let formula = format!("{wanted}/{given}");
        let name = "from the damping of the table to that of the part, ξ in per cent";
        sheet.calc("η′", name, &formula, Dimensionless, self.clause);
        let (largest_at, largest) = table.largest();
        let formula = if period >= largest_at {
            "γ_I·S_t·η′"
        } else {
            sheet.given(&[("S_p", largest, Acceleration)]);
            "γ_I·(S_t + (η′ - 1)·S_p·max(S_t - S_0, 0)/(S_p - S_0))"
        };
        let formula = if q == 1.0 { formula.to_string() } else { format!("{formula}/q") };
        let name = format!("{part} spectral acceleration, ξ = {} %", number(100.0 * damping));
        sheet.calc(symbol, &name, &formula, Dimension::Acceleration, self.clause)
    }
}
