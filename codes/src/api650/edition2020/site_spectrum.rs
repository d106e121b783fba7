//! Accelerations from the user's spectrum (E.4.6.2) with their lines.
//!
//! ```text
//! A_i = S_DS I/R_wi                    not below 0.007, on site classes E and F not below 0.5 S_1 I/R_wi
//! A_c = K S_a(T_c) I/R_wc              not above A_i
//! A_f = K S_a(T_c) I                   seismic use group III: without I
//! ```
//!
//! E.4.6.2 also allows S_a at the impulsive period in place of S_DS; the plateau is not below it. A_f by the ordinate at T_c replaces
//! S_D1/T_c and its branches beyond 4 s and T_L, which hold for the shape of ASCE 7 only.

use super::super::ground_motion::DesignSpectrum;
use super::super::site_specific::SiteSpecific;
use super::Run;
use super::accelerations::{Accelerations, E5, E6_1_3, E7_2};
use super::factors::{K, R_WC, importance, response_modification};
use crate::hazard;
use crate::procedure::CodeError;
use tank::case::{Api650Site, SiteClass};
use tank::hazard::SpectrumForm;
use tank::units::Dimension::{Dimensionless, Time};

const E4_6_2: &str = "API 650:2020 E.4.6.2";
const FLOOR: &str = "ASCE 7 21.3";
const SHORT: &str = "ASCE 7 21.4";

impl Run<'_> {
    /// Design acceleration at short periods S_DS [g]; zero if the site's data are inadmissible, which the accelerations report.
    pub(super) fn short_period(&self, site: &Api650Site) -> f64 {
        match SiteSpecific::new(&self.basis.case.site, site) {
            Ok(Some(own)) => own.short_period(),
            Ok(None) => DesignSpectrum::new(site).map_or(0.0, |s| s.s_ds),
            Err(_) => 0.0,
        }
    }

    /// Accelerations from the user's spectrum.
    ///
    /// * `t_c`: convective period [s]
    pub(super) fn own_accelerations(
        &mut self,
        site: &Api650Site,
        own: &SiteSpecific,
        t_c: f64,
    ) -> Result<Accelerations, CodeError> {
        hazard::covers(self.basis.case.site.spectrum.as_ref(), "sloshing", t_c)?;
        let anchored = self.basis.anchored();
        let i = importance(site.sug)?;
        let r_wi = response_modification(anchored);
        let sheet = &mut self.sheet;
        for (symbol, name, value, source) in [
            ("I", "importance factor of the seismic use group", i, E5),
            ("R_wi", "response modification, impulsive", r_wi, E5),
            ("R_wc", "response modification, convective", R_WC, E5),
            ("K", "factor from 5 % to 0.5 % damping", K, E4_6_2),
        ] {
            sheet.input(symbol, name, value, Dimensionless, source);
        }
        sheet.input("T_c", "period of the first sloshing mode", t_c, Time, "above");
        let s_02 = self.ordinate(own, "S_a(0.2)", 0.2);
        let (at, _) = own.largest();
        let s_max = self.ordinate(own, "S_a,max", at);
        let s_ac = self.ordinate(own, "S_a(T_c)", t_c);
        let soft = own.mapped.is_some() && matches!(site.site_class, SiteClass::E | SiteClass::F);
        let sheet = &mut self.sheet;
        if soft {
            let name = "mapped acceleration at one second [g]";
            sheet.input("S_1", name, site.s1, Dimensionless, "site.api650.s1");
        }
        sheet.given(&[("S_02", s_02, Dimensionless), ("S_max", s_max, Dimensionless), ("S_ac", s_ac, Dimensionless)]);
        let mut line = |symbol: &'static str, name: &str, formula: &str, clause: &str| {
            sheet.calc(symbol, name, formula, Dimensionless, clause)
        };
        let name = "design acceleration, short periods [g]";
        line("S_DS", name, "max(S_02, 0.9·S_max)", SHORT);
        let floor = if soft { ", 0.5·S_1·I/R_wi, 0.007)" } else { ", 0.007)" };
        let formula = format!("max(S_DS·I/R_wi{floor}");
        let a_i = line("A_i", "impulsive acceleration [g]", &formula, E4_6_2);
        let a_c = line("A_c", "convective acceleration [g]", "min(K·S_ac·I/R_wc, A_i)", E4_6_2);
        let formula = if site.sug == 3 { "K·S_ac" } else { "K·S_ac·I" };
        let name = "acceleration of the sloshing wave, not reduced [g]";
        let a_f = line("A_f", name, formula, E7_2);
        let a_v = match site.av {
            Some(_) => None,
            None => Some(line("A_v", "vertical acceleration [g]", "0.47·S_DS", E6_1_3)),
        };
        let a_v = a_v.unwrap_or_else(|| {
            let name = "vertical acceleration as specified [g]";
            let given = site.av.unwrap_or_default();
            self.sheet.input("A_v", name, given, Dimensionless, "site.api650.av")
        });
        let support = if anchored { "mechanically anchored" } else { "self-anchored" };
        let limit = match own.mapped {
            Some(_) => "not less than 80 % of the spectrum of the mapped values (ASCE 7 21.3)",
            None => {
                "without lower limit, because the mapped accelerations are not given (ASCE 7 21.3 asks for 80 % of their spectrum)"
            }
        };
        self.out.assumptions.push(format!(
            "The user's spectrum is that of the design earthquake (Q is not applied), brought to 5 % damping by η of EN 1998-1 3.2.2.2, \
             {limit}; forces reduced by R_wi = {r_wi} ({support} tank) and R_wc = {R_WC}; K = {K} takes 5 % to 0.5 % damping."
        ));
        let form = self.basis.case.site.spectrum.as_ref().map(|own| &own.form);
        if let (Some(SpectrumForm::Table { vertical: Some(_), .. }), None) = (form, site.av) {
            self.out.notes.push(
                "The vertical rows of the user's spectrum are not used: E.6.1.3 has 0.47 S_DS; `site.api650.av` gives another value."
                    .into(),
            );
        }
        if site.s0.is_some() {
            self.out.notes.push("S_0 of `site.api650` is not used beside the user's spectrum.".into());
        }
        Ok(Accelerations { a_i, a_c, a_v, a_f })
    }

    /// Lines of an ordinate of the user's spectrum with its lower limit; returns it [g].
    fn ordinate(&mut self, own: &SiteSpecific, symbol: &str, period: f64) -> f64 {
        let at = crate::sheet::with_unit(period, Time);
        let sheet = &mut self.sheet;
        let name = format!("the user's spectrum at T = {at} [g]");
        let source = "user's spectrum at 5 % damping over g";
        let given = sheet.look_up("S_u", &name, source, own.own(period), Dimensionless, E4_6_2);
        if own.mapped.is_none() {
            let name = format!("acceleration at T = {at} [g]");
            return sheet.calc(symbol, &name, "S_u", Dimensionless, E4_6_2);
        }
        let name = format!("spectrum of the mapped values at T = {at} [g]");
        let source = "Q·F_a·S_s and Q·F_v·S_1 with the shape of ASCE 7 11.4.5";
        let mapped = sheet.look_up("S_m", &name, source, own.mapped(period), Dimensionless, "API 650:2020 E.4.4");
        let which =
            if given >= 0.8 * mapped { "the user's spectrum governs" } else { "80 % of the mapped spectrum govern" };
        let name = format!("acceleration at T = {at} [g]: {which}");
        sheet.calc(symbol, &name, "max(S_u, 0.8·S_m)", Dimensionless, FLOOR)
    }
}
