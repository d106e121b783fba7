//! Periods and accelerations (E.4, E.6.1.3, E.7.2).

use crate::ec8::simplified::mean_thickness;
use crate::ordinates::{plateau, psa};
use crate::procedure::CodeError;
use crate::sheet::Sheet;
use tank::assessment::Excitation;
use tank::case::{Api650Site, SiteClass};
use tank::units::Dimension::{Density, Dimensionless, Stress, Time};

use super::super::ground_motion::DesignSpectrum;
use super::super::masses::{COEFFICIENT, IMPULSIVE_PERIOD, PERIOD, impulsive_coefficient};
use super::super::site_specific::SiteSpecific;
use super::Run;
use super::factors::{K, R_WC, importance, response_modification};

const E4: &str = "API 650:2020 E.4.4";
const E4_5_1: &str = "API 650:2020 E.4.5.1, figure E.1";
const E4_5_2: &str = "API 650:2020 E.4.5.2";
const E4_6: &str = "API 650:2020 E.4.6.1";
pub(super) const E5: &str = "API 650:2020 E.5.1, table E.4";
pub(super) const E6_1_3: &str = "API 650:2020 E.6.1.3";
pub(super) const E7_2: &str = "API 650:2020 E.7.2";

/// Periods [s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// Impulsive T_i; absent outside figure E.1.
    pub impulsive: Option<f64>,
    /// Convective T_c.
    pub convective: f64,
    /// Equivalent uniform thickness t_u [m].
    pub thickness: f64,
}

/// Accelerations in g.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accelerations {
    /// Impulsive A_i.
    pub a_i: f64,
    /// Convective A_c.
    pub a_c: f64,
    /// Vertical A_v.
    pub a_v: f64,
    /// For the sloshing wave, A_f.
    pub a_f: f64,
}

/// Lines of the design accelerations of a site (E.4.6.1, E.6.1.3, E.7.2), reduced by R_w except A_f.
///
/// S_0, where given, enters through the second form `2.5 Q F_a S_0 I/R_wi` of A_i; the larger counts.
/// Errors: a seismic use group other than 1 to 3.
pub(crate) fn acceleration_lines(
    sheet: &mut Sheet,
    site: &Api650Site,
    spectrum: &DesignSpectrum,
    t_c: f64,
    anchored: bool,
) -> Result<Accelerations, CodeError> {
    site_lines(sheet, site, spectrum, anchored)?;
    sheet.given(&[("T_c", t_c, Time)]);
    sheet.calc("S_DS", "design acceleration, short periods [g]", "Q·F_a·S_s", Dimensionless, E4);
    sheet.calc("S_D1", "design acceleration, one second [g]", "Q·F_v·S_1", Dimensionless, E4);
    let soft = matches!(site.site_class, SiteClass::E | SiteClass::F);
    let plateau = if site.s0.is_some() { "max(S_DS, 2.5·Q·F_a·S_0)·I/R_wi" } else { "S_DS·I/R_wi" };
    let floor = if soft { ", 0.5·S_1·I/R_wi, 0.007)" } else { ", 0.007)" };
    let a_i = sheet.calc("A_i", "impulsive acceleration [g]", &format!("max({plateau}{floor}"), Dimensionless, E4_6);
    let formula =
        if t_c <= spectrum.t_l { "min(K·S_D1/T_c·I/R_wc, A_i)" } else { "min(K·S_D1·T_L/T_c²·I/R_wc, A_i)" };
    let a_c = sheet.calc("A_c", "convective acceleration [g]", formula, Dimensionless, E4_6);
    let a_v = match site.av {
        Some(a_v) => {
            let name = "vertical acceleration as specified [g]";
            sheet.input("A_v", name, a_v, Dimensionless, "site.api650.av")
        }
        None => sheet.calc("A_v", "vertical acceleration [g]", "0.47·S_DS", Dimensionless, E6_1_3),
    };
    let formula = match (site.sug, t_c <= 4.0, t_c <= spectrum.t_l) {
        (3, _, true) => "K·S_D1/T_c",
        (3, _, false) => "K·S_D1·T_L/T_c²",
        (_, true, _) => "K·S_D1·I/T_c",
        (_, false, _) => "K·S_D1·I·4 s/T_c²",
    };
    let a_f = sheet.calc("A_f", "acceleration of the sloshing wave, not reduced [g]", formula, Dimensionless, E7_2);
    Ok(Accelerations { a_i, a_c, a_v, a_f })
}

/// Lines of the site's data.
fn site_lines(
    sheet: &mut Sheet,
    site: &Api650Site,
    spectrum: &DesignSpectrum,
    anchored: bool,
) -> Result<(), CodeError> {
    let table = match (site.fa, site.fv) {
        (Some(_), Some(_)) => "site study".to_string(),
        _ => format!("ASCE 7-{:02} table 11.4, site class {:?}", site.asce7 % 100, site.site_class),
    };
    for (symbol, name, value, source) in [
        ("S_s", "mapped acceleration at short periods [g]", site.ss, "site.api650.ss"),
        ("S_1", "mapped acceleration at one second [g]", site.s1, "site.api650.s1"),
        ("Q", "scaling from the mapped to the design level", site.q, "API 650:2020 E.4.6.1"),
        ("F_a", "site coefficient", spectrum.f_a, table.as_str()),
        ("F_v", "site coefficient", spectrum.f_v, table.as_str()),
        ("I", "importance factor of the seismic use group", importance(site.sug)?, E5),
        ("R_wi", "response modification, impulsive", response_modification(anchored), E5),
        ("R_wc", "response modification, convective", R_WC, E5),
        ("K", "factor from 5 % to 0.5 % damping", K, E4_6),
    ] {
        sheet.input(symbol, name, value, Dimensionless, source);
    }
    sheet.input("T_L", "long-period transition", spectrum.t_l, Time, "site.api650.tl");
    if let Some(s_0) = site.s0 {
        sheet.given(&[("S_0", s_0, Dimensionless)]);
    }
    Ok(())
}

impl Run<'_> {
    /// Periods with their lines.
    pub(super) fn periods(&mut self) -> Periods {
        let (b, case) = (self.basis, self.basis.case);
        let (d, h) = (b.d, b.h);
        let sheet = &mut self.sheet;
        sheet.section("Periods");
        let e = case.tank.courses[0].material.youngs_modulus;
        let rho = case.liquid.density;
        let name = "equivalent uniform thickness of the wetted shell";
        let clause = "API 650:2020 E.4.5.1, weighted as EN 1998-4 A.3.2.2";
        let t_u = mean_thickness(sheet, "t_u", name, &case.tank, h, clause);
        let impulsive = impulsive_coefficient(h / d).map(|c_i| {
            let (name, source) = ("coefficient of the impulsive period", "figure E.1 at H/D");
            sheet.look_up("C_i", name, source, c_i, Dimensionless, E4_5_1);
            sheet.given(&[("ρ", rho, Density), ("E", e, Stress)]);
            sheet.calc("T_i", "impulsive period", IMPULSIVE_PERIOD, Time, E4_5_1)
        });
        if impulsive.is_none() {
            self.out.notes.push(format!(
                "{E4_5_1}: no impulsive period, H/D = {:.3} lies outside the figure (0.15 to 1.5).",
                h / d
            ));
        }
        let name = "sloshing coefficient";
        sheet.calc("K_s", name, COEFFICIENT, Dimensionless, E4_5_2);
        let name = "period of the first sloshing mode (D in m)";
        let t_c = sheet.calc("T_c", name, PERIOD, Time, E4_5_2);
        Periods { impulsive, convective: t_c, thickness: t_u }
    }

    /// Accelerations with their lines.
    pub(super) fn accelerations(&mut self, periods: &Periods) -> Result<Accelerations, CodeError> {
        self.sheet.section("Ground motion");
        match (self.excitation, self.site) {
            (Excitation::Site, Some(site)) => self.site_accelerations(site, periods.convective),
            _ => self.record_accelerations(periods),
        }
    }

    fn site_accelerations(&mut self, site: &Api650Site, t_c: f64) -> Result<Accelerations, CodeError> {
        if let Some(own) = SiteSpecific::new(&self.basis.case.site, site)? {
            return self.own_accelerations(site, &own, t_c);
        }
        let spectrum = DesignSpectrum::new(site)?;
        let anchored = self.basis.anchored();
        let a = acceleration_lines(&mut self.sheet, site, &spectrum, t_c, anchored)?;
        let r_wi = response_modification(anchored);
        self.out.assumptions.push(format!(
            "Design spectrum of ASCE 7 at 5 % damping; forces reduced by R_wi = {r_wi} ({} tank) and R_wc = {R_WC}.",
            if anchored { "mechanically anchored" } else { "self-anchored" }
        ));
        if let Some(s0) = site.s0.filter(|s0| (s0 / (0.4 * site.ss) - 1.0).abs() > 0.01) {
            self.out.notes.push(format!(
                "S_0 = {s0} g is not 0.4 S_s = {:.4} g; the larger of the two forms of A_i is used.",
                0.4 * site.ss
            ));
        }
        if site.asce7 == 2016 && site.site_class == SiteClass::D && site.s1 >= 0.2 && site.fv.is_none() {
            self.out.notes.push(
                "ASCE 7-16 11.4.8 asks for a ground motion analysis on site class D from S_1 = 0.2 g on; its exceptions \
                 were not examined."
                    .into(),
            );
        }
        Ok(a)
    }

    fn record_accelerations(&mut self, periods: &Periods) -> Result<Accelerations, CodeError> {
        let case = self.basis.case;
        // `applies` has asked before.
        let Some(motion) = &case.ground_motion else {
            return Err(CodeError::Data { clause: E4_6.into(), reason: "no record given".into() });
        };
        let (record, damping, g) = (&motion.horizontal, case.damping, case.gravity);
        let percent = |ratio: f64| format!("{} % damping", crate::sheet::number(100.0 * ratio));
        let source = format!("API 650:2020 E.4.6.2 (R_w = 1, I = 1), spectrum of `{}`", record.name);
        let (impulsive, name) = match periods.impulsive {
            Some(t_i) => (psa(record, t_i, damping.impulsive), "spectral acceleration at T_i".to_string()),
            None => {
                let (at, psa) = plateau(record, damping.impulsive);
                (psa, format!("largest spectral acceleration of the impulsive range, at T = {at:.3} s"))
            }
        };
        let convective = psa(record, periods.convective, damping.sloshing);
        let sheet = &mut self.sheet;
        let spectrum = "spectrum of the record over g";
        let name = format!("impulsive acceleration: {name}, {} [g]", percent(damping.impulsive));
        let a_i = sheet.look_up("A_i", &name, spectrum, impulsive / g, Dimensionless, &source);
        let name = format!("convective acceleration: spectral acceleration at T_c, {} [g]", percent(damping.sloshing));
        let a_c = sheet.look_up("A_c", &name, spectrum, convective / g, Dimensionless, &source);
        let a_v = match &motion.vertical {
            Some(vertical) => {
                let name = "vertical acceleration: largest spectral acceleration of the vertical record, T = 0 and 0.05 to 0.5 s [g]";
                let value = plateau(vertical, damping.impulsive).1 / g;
                sheet.look_up("A_v", name, spectrum, value, Dimensionless, E6_1_3)
            }
            None => {
                let name = "vertical acceleration: no vertical record [g]";
                sheet.input("A_v", name, 0.0, Dimensionless, E6_1_3)
            }
        };
        let name = "acceleration of the sloshing wave [g]";
        let a_f = sheet.calc("A_f", name, "A_c", Dimensionless, E7_2);
        self.out.assumptions.push(format!(
            "A_i and A_c are spectral accelerations of the record with the damping of the case, unreduced (R_w = 1, I = 1, K = 1), \
             to stand beside a linear time history; the annex's own spectrum has 5 % ({} % here) and 0.5 % ({} % here).",
            crate::sheet::number(100.0 * damping.impulsive),
            crate::sheet::number(100.0 * damping.sloshing)
        ));
        Ok(Accelerations { a_i, a_c, a_v, a_f })
    }
}
