//! Periods and accelerations (E.4, E.6.1.3, E.7.2).

use crate::procedure::CodeError;
use oscillator::spectrum::ordinates;
use tank::assessment::Excitation;
use tank::case::{Api650Site, SiteClass};
use tank::units::Dimension::{Density, Dimensionless, Length, Stress, Time};

use super::super::basis::{equivalent_thickness, equivalent_thickness_in_numbers};
use super::super::ground_motion::{DesignSpectrum, impulsive_plateau};
use super::super::masses::{impulsive_coefficient, impulsive_period, sloshing_coefficient, sloshing_period};
use super::Run;

const E4: &str = "API 650:2020 E.4.4";
const E4_5_1: &str = "API 650:2020 E.4.5.1, figure E.1";
const E4_5_2: &str = "API 650:2020 E.4.5.2";
const E4_6: &str = "API 650:2020 E.4.6.1";
const E5: &str = "API 650:2020 E.5.1, table E.4";
const E6_1_3: &str = "API 650:2020 E.6.1.3";
const E7_2: &str = "API 650:2020 E.7.2";

/// Factor from 5 % to 0.5 % damping.
const K: f64 = 1.5;
/// Response modification of the convective part.
const R_WC: f64 = 2.0;

/// Periods [s].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Periods {
    /// Impulsive T_i; absent outside figure E.1.
    pub impulsive: Option<f64>,
    /// Convective T_c.
    pub convective: f64,
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

/// Importance factor of the seismic use group: 1.0, 1.25, 1.5. Errors: any other group.
pub fn importance(sug: u8) -> Result<f64, CodeError> {
    match sug {
        1 => Ok(1.0),
        2 => Ok(1.25),
        3 => Ok(1.5),
        _ => Err(CodeError::Data {
            clause: "API 650:2020 E.5.1.2 (site.api650.sug)".into(),
            reason: format!("seismic use group {sug}; allowed are 1, 2 and 3"),
        }),
    }
}

/// Response modification R_wi of the impulsive part: 4.0 mechanically anchored, 3.5 self-anchored.
pub fn response_modification(anchored: bool) -> f64 {
    if anchored { 4.0 } else { 3.5 }
}

/// Design accelerations of a site (E.4.6.1, E.6.1.3, E.7.2), reduced by R_w except A_f.
///
/// S_0, where given, enters through the second form `2.5 Q F_a S_0 I/R_wi` of A_i; the larger counts.
/// Errors: a seismic use group other than 1 to 3.
pub fn design_accelerations(
    site: &Api650Site,
    spectrum: &DesignSpectrum,
    t_c: f64,
    anchored: bool,
) -> Result<Accelerations, CodeError> {
    let i = importance(site.sug)?;
    let r_wi = response_modification(anchored);
    let plateau = spectrum.s_ds.max(2.5 * site.q * spectrum.f_a * site.s0.unwrap_or(0.0));
    let mut a_i = (plateau * i / r_wi).max(0.007);
    if matches!(site.site_class, SiteClass::E | SiteClass::F) {
        a_i = a_i.max(0.5 * site.s1 * i / r_wi);
    }
    let shape = |t_l: f64| if t_c <= t_l { 1.0 / t_c } else { t_l / (t_c * t_c) };
    let a_f = match site.sug {
        3 => K * spectrum.s_d1 * shape(spectrum.t_l),
        _ => K * spectrum.s_d1 * i * shape(4.0),
    };
    Ok(Accelerations {
        a_i,
        a_c: (K * spectrum.s_d1 * shape(spectrum.t_l) * i / R_WC).min(a_i),
        a_v: site.av.unwrap_or(0.47 * spectrum.s_ds),
        a_f,
    })
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
        let t_u = equivalent_thickness(&case.tank, h);
        let name = "equivalent uniform thickness of the wetted shell";
        let formula = "Σt_k·((H - z_k)² - (H - z_k+1)²)/H²";
        let numbers = equivalent_thickness_in_numbers(&case.tank, h);
        sheet.step(
            "t_u",
            name,
            formula,
            &numbers,
            t_u,
            Length,
            "API 650:2020 E.4.5.1, weighted as EN 1998-4 A.3.2.2",
        );
        let impulsive = impulsive_period(d, h, rho, t_u, e);
        match (impulsive, impulsive_coefficient(h / d)) {
            (Some(t_i), Some(c_i)) => {
                let name = "coefficient of the impulsive period at H/D";
                sheet.input("C_i", name, c_i, Dimensionless, E4_5_1);
                let terms = [
                    ("C_i", c_i, Dimensionless),
                    ("H", h, Length),
                    ("ρ", rho, Density),
                    ("t_u", t_u, Length),
                    ("D", d, Length),
                    ("E", e, Stress),
                ];
                let formula = "C_i·H·√(ρ)/√(2·t_u/D·E)";
                sheet.calc("T_i", "impulsive period", formula, &terms, t_i, Time, E4_5_1);
            }
            _ => self.out.notes.push(format!(
                "{E4_5_1}: no impulsive period, H/D = {:.3} lies outside the figure (0.15 to 1.5).",
                h / d
            )),
        }
        let k_s = sloshing_coefficient(d / h);
        let terms = [("H", h, Length), ("D", d, Length)];
        let formula = "0.578/√(tanh(3.68·H/D))";
        self.sheet.calc(
            "K_s",
            "sloshing coefficient",
            formula,
            &terms,
            k_s,
            Dimensionless,
            E4_5_2,
        );
        let t_c = sloshing_period(d, d / h);
        let terms = [("K_s", k_s, Dimensionless), ("D", d, Length)];
        let name = "period of the first sloshing mode (D in m)";
        self.sheet.calc("T_c", name, "1.8·K_s·√(D)", &terms, t_c, Time, E4_5_2);
        Periods {
            impulsive,
            convective: t_c,
        }
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
        let spectrum = DesignSpectrum::new(site)?;
        let anchored = self.basis.anchored();
        let a = design_accelerations(site, &spectrum, t_c, anchored)?;
        let (i, r_wi) = (importance(site.sug)?, response_modification(anchored));
        let DesignSpectrum {
            f_a,
            f_v,
            s_ds,
            s_d1,
            t_l,
            ..
        } = spectrum;
        let table = match (site.fa, site.fv) {
            (Some(_), Some(_)) => "site study".to_string(),
            _ => format!(
                "ASCE 7-{:02} table 11.4, site class {:?}",
                site.asce7 % 100,
                site.site_class
            ),
        };
        let sheet = &mut self.sheet;
        for (symbol, name, value, source) in [
            (
                "S_s",
                "mapped acceleration at short periods [g]",
                site.ss,
                "site.api650.ss",
            ),
            (
                "S_1",
                "mapped acceleration at one second [g]",
                site.s1,
                "site.api650.s1",
            ),
            (
                "Q",
                "scaling from the mapped to the design level",
                site.q,
                "API 650:2020 E.4.6.1",
            ),
            ("F_a", "site coefficient", f_a, table.as_str()),
            ("F_v", "site coefficient", f_v, table.as_str()),
            ("I", "importance factor of the seismic use group", i, E5),
            ("R_wi", "response modification, impulsive", r_wi, E5),
            ("R_wc", "response modification, convective", R_WC, E5),
            ("K", "factor from 5 % to 0.5 % damping", K, E4_6),
        ] {
            sheet.input(symbol, name, value, Dimensionless, source);
        }
        sheet.input("T_L", "long-period transition", t_l, Time, "site.api650.tl");
        let dimensionless = |symbol, value| (symbol, value, Dimensionless);
        let terms = [
            dimensionless("Q", site.q),
            dimensionless("F_a", f_a),
            dimensionless("S_s", site.ss),
        ];
        sheet.calc(
            "S_DS",
            "design acceleration, short periods [g]",
            "Q·F_a·S_s",
            &terms,
            s_ds,
            Dimensionless,
            E4,
        );
        let terms = [
            dimensionless("Q", site.q),
            dimensionless("F_v", f_v),
            dimensionless("S_1", site.s1),
        ];
        sheet.calc(
            "S_D1",
            "design acceleration, one second [g]",
            "Q·F_v·S_1",
            &terms,
            s_d1,
            Dimensionless,
            E4,
        );

        let soft = matches!(site.site_class, SiteClass::E | SiteClass::F);
        let plateau = if site.s0.is_some() {
            "max(S_DS, 2.5·Q·F_a·S_0)·I/R_wi"
        } else {
            "S_DS·I/R_wi"
        };
        let floor = if soft { ", 0.5·S_1·I/R_wi, 0.007)" } else { ", 0.007)" };
        let terms = [
            dimensionless("S_DS", s_ds),
            dimensionless("Q", site.q),
            dimensionless("F_a", f_a),
            dimensionless("S_0", site.s0.unwrap_or(0.0)),
            dimensionless("S_1", site.s1),
            dimensionless("I", i),
            dimensionless("R_wi", r_wi),
        ];
        let formula = format!("max({plateau}{floor}");
        sheet.calc(
            "A_i",
            "impulsive acceleration [g]",
            &formula,
            &terms,
            a.a_i,
            Dimensionless,
            E4_6,
        );
        let terms = [
            dimensionless("K", K),
            dimensionless("S_D1", s_d1),
            ("T_c", t_c, Time),
            ("T_L", t_l, Time),
            dimensionless("I", i),
            dimensionless("R_wc", R_WC),
            dimensionless("A_i", a.a_i),
        ];
        let formula = if t_c <= t_l {
            "min(K·S_D1/T_c·I/R_wc, A_i)"
        } else {
            "min(K·S_D1·T_L/T_c²·I/R_wc, A_i)"
        };
        sheet.calc(
            "A_c",
            "convective acceleration [g]",
            formula,
            &terms,
            a.a_c,
            Dimensionless,
            E4_6,
        );
        match site.av {
            Some(a_v) => sheet.input(
                "A_v",
                "vertical acceleration as specified [g]",
                a_v,
                Dimensionless,
                "site.api650.av",
            ),
            None => {
                let terms = [dimensionless("S_DS", s_ds)];
                sheet.calc(
                    "A_v",
                    "vertical acceleration [g]",
                    "0.47·S_DS",
                    &terms,
                    a.a_v,
                    Dimensionless,
                    E6_1_3,
                )
            }
        };
        let formula = match (site.sug, t_c <= 4.0, t_c <= t_l) {
            (3, _, true) => "K·S_D1/T_c",
            (3, _, false) => "K·S_D1·T_L/T_c²",
            (_, true, _) => "K·S_D1·I/T_c",
            (_, false, _) => "K·S_D1·I·4 s/T_c²",
        };
        sheet.calc(
            "A_f",
            "acceleration of the sloshing wave, not reduced [g]",
            formula,
            &terms,
            a.a_f,
            Dimensionless,
            E7_2,
        );
        self.out.assumptions.push(format!(
            "Design spectrum of ASCE 7 at 5 % damping; forces reduced by R_wi = {r_wi} ({} tank) and R_wc = {R_WC}.",
            if anchored {
                "mechanically anchored"
            } else {
                "self-anchored"
            }
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
            return Err(CodeError::Data {
                clause: E4_6.into(),
                reason: "no record given".into(),
            });
        };
        let (record, damping, g) = (&motion.horizontal, case.damping, case.gravity);
        let percent = |ratio: f64| format!("{} % damping", crate::sheet::number(100.0 * ratio));
        let source = format!("API 650:2020 E.4.6.2 (R_w = 1, I = 1), spectrum of `{}`", record.name);
        let (impulsive, name) = match periods.impulsive {
            Some(t_i) => (
                ordinates(record, t_i, damping.impulsive).psa,
                "spectral acceleration at T_i".to_string(),
            ),
            None => {
                let (at, psa) = impulsive_plateau(record, damping.impulsive);
                (
                    psa,
                    format!("largest spectral acceleration of the impulsive range, at T = {at:.3} s"),
                )
            }
        };
        let convective = ordinates(record, periods.convective, damping.sloshing).psa;
        let sheet = &mut self.sheet;
        let name = format!("impulsive acceleration: {name}, {} [g]", percent(damping.impulsive));
        let a_i = sheet.input("A_i", &name, impulsive / g, Dimensionless, &source);
        let name = format!(
            "convective acceleration: spectral acceleration at T_c, {} [g]",
            percent(damping.sloshing)
        );
        let a_c = sheet.input("A_c", &name, convective / g, Dimensionless, &source);
        let a_v = motion
            .vertical
            .as_ref()
            .map_or(0.0, |v| impulsive_plateau(v, damping.impulsive).1 / g);
        let name = match &motion.vertical {
            Some(_) => {
                "vertical acceleration: largest spectral acceleration of the vertical record, T = 0 and 0.05 to 0.5 s [g]"
            }
            None => "vertical acceleration: no vertical record [g]",
        };
        sheet.input("A_v", name, a_v, Dimensionless, E6_1_3);
        let a_f = sheet.calc(
            "A_f",
            "acceleration of the sloshing wave [g]",
            "A_c",
            &[("A_c", a_c, Dimensionless)],
            a_c,
            Dimensionless,
            E7_2,
        );
        self.out.assumptions.push(format!(
            "A_i and A_c are spectral accelerations of the record with the damping of the case, unreduced (R_w = 1, I = 1, K = 1), \
             to stand beside a linear time history; the annex's own spectrum has 5 % ({} % here) and 0.5 % ({} % here).",
            crate::sheet::number(100.0 * damping.impulsive),
            crate::sheet::number(100.0 * damping.sloshing)
        ));
        Ok(Accelerations { a_i, a_c, a_v, a_f })
    }
}
