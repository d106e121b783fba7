//! Base shear, moments and sloshing wave (E.6.1, E.7.2).

use tank::assessment::Excitation;
use tank::units::Dimension::{Dimensionless, Force, Length, Moment};

use super::super::ground_motion::DesignSpectrum;
use super::Run;
use super::accelerations::Accelerations;

const E6_1: &str = "API 650:2020 E.6.1";
const E6_1_1: &str = "API 650:2020 E.6.1.1";
const E6_1_2_1: &str = "API 650:2020 E.6.1.2.1";
const E6_1_2_2: &str = "API 650:2020 E.6.1.2.2";
const E6_1_5: &str = "API 650:2020 E.6.1.5";
const E7_2: &str = "API 650:2020 E.7.2";

/// Weights [N] and heights [m] that the accelerations act on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Weights {
    /// Shell: weight and height of its centre.
    pub shell: (f64, f64),
    /// Roof: weight and height.
    pub roof: (f64, f64),
    /// Floor: weight.
    pub floor: f64,
    /// Impulsive liquid: weight, heights without and with base pressure.
    pub impulsive: (f64, f64, f64),
    /// Convective liquid: weight, heights without and with base pressure.
    pub convective: (f64, f64, f64),
}

/// Base shear [N] and moments [N·m] with their impulsive and convective parts.
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Forces {
    pub v_i: f64,
    pub v_c: f64,
    pub v: f64,
    pub m_rw_i: f64,
    pub m_rw_c: f64,
    pub m_rw: f64,
    pub m_s_i: f64,
    pub m_s_c: f64,
    pub m_s: f64,
}

impl Weights {
    /// Base shear and moments for accelerations in g (E.6.1, E.6.1.5).
    pub fn forces(&self, a_i: f64, a_c: f64) -> Forces {
        let Weights {
            shell,
            roof,
            floor,
            impulsive,
            convective,
        } = *self;
        let solid = shell.0 * shell.1 + roof.0 * roof.1;
        let (v_i, v_c) = (a_i * (shell.0 + roof.0 + floor + impulsive.0), a_c * convective.0);
        let (m_rw_i, m_rw_c) = (
            a_i * (impulsive.0 * impulsive.1 + solid),
            a_c * convective.0 * convective.1,
        );
        let (m_s_i, m_s_c) = (
            a_i * (impulsive.0 * impulsive.2 + solid),
            a_c * convective.0 * convective.2,
        );
        Forces {
            v_i,
            v_c,
            v: v_i.hypot(v_c),
            m_rw_i,
            m_rw_c,
            m_rw: m_rw_i.hypot(m_rw_c),
            m_s_i,
            m_s_c,
            m_s: m_s_i.hypot(m_s_c),
        }
    }
}

impl Run<'_> {
    /// Weights, base shear and moments with their lines.
    pub(super) fn forces(&mut self, a: &Accelerations) -> Forces {
        let b = self.basis;
        let (d, h, m) = (b.d, b.h, b.masses);
        let x_r = b.case.tank.roof_height();
        let floor = b.w_f;
        self.out.assumptions.push(match &b.case.tank.bottom {
            Some(_) => "The whole floor has the thickness of the bottom plate under the shell.".into(),
            None => "The floor's weight is left out of the base shear: `tank.bottom` is missing.".to_string(),
        });
        let weights = Weights {
            shell: (b.w_s, b.x_s),
            roof: (b.w_r, x_r),
            floor,
            impulsive: (m.w_i * b.w_p, m.x_i * h, m.x_is * h),
            convective: (m.w_c * b.w_p, m.x_c * h, m.x_cs * h),
        };
        let f = weights.forces(a.a_i, a.a_c);
        let squat = b.squat();
        let sheet = &mut self.sheet;
        sheet.section("Effective masses");
        let terms = [("D", d, Length), ("H", h, Length), ("W_p", b.w_p, Force)];
        let w_i = if squat {
            "W_p·tanh(0.866·D/H)/(0.866·D/H)"
        } else {
            "W_p·(1 - 0.218·D/H)"
        };
        let x_i = if squat { "0.375·H" } else { "(0.5 - 0.094·D/H)·H" };
        let x_is = if squat {
            "0.375·(1 + 1.333·(0.866·D/H/tanh(0.866·D/H) - 1))·H"
        } else {
            "(0.5 + 0.06·D/H)·H"
        };
        sheet.calc(
            "W_i",
            "impulsive weight",
            w_i,
            &terms,
            weights.impulsive.0,
            Force,
            E6_1_1,
        );
        let w_c = "W_p·0.23·D/H·tanh(3.67·H/D)";
        sheet.calc(
            "W_c",
            "convective weight",
            w_c,
            &terms,
            weights.convective.0,
            Force,
            E6_1_1,
        );
        sheet.calc(
            "X_i",
            "height of the impulsive force, ringwall",
            x_i,
            &terms,
            weights.impulsive.1,
            Length,
            E6_1_2_1,
        );
        let u = sheet.calc(
            "u",
            "argument of the sloshing mode",
            "3.67·H/D",
            &terms,
            3.67 * h / d,
            Dimensionless,
            E6_1_2_1,
        );
        let arm = [("u", u, Dimensionless), ("H", h, Length)];
        let x_c = "H·(1 - (cosh(u) - 1)/(u·sinh(u)))";
        sheet.calc(
            "X_c",
            "height of the convective force, ringwall",
            x_c,
            &arm,
            weights.convective.1,
            Length,
            E6_1_2_1,
        );
        sheet.calc(
            "X_is",
            "height of the impulsive force, slab",
            x_is,
            &terms,
            weights.impulsive.2,
            Length,
            E6_1_2_2,
        );
        let x_cs = "H·(1 - (cosh(u) - 1.937)/(u·sinh(u)))";
        sheet.calc(
            "X_cs",
            "height of the convective force, slab",
            x_cs,
            &arm,
            weights.convective.2,
            Length,
            E6_1_2_2,
        );
        sheet.input("W_f", "weight of the floor", floor, Force, "tank.bottom");

        sheet.section("Base shear and moments");
        let terms = [
            ("A_i", a.a_i, Dimensionless),
            ("A_c", a.a_c, Dimensionless),
            ("W_s", b.w_s, Force),
            ("W_r", b.w_r, Force),
            ("W_f", floor, Force),
            ("W_i", weights.impulsive.0, Force),
            ("W_c", weights.convective.0, Force),
            ("X_s", b.x_s, Length),
            ("X_r", x_r, Length),
            ("X_i", weights.impulsive.1, Length),
            ("X_c", weights.convective.1, Length),
            ("X_is", weights.impulsive.2, Length),
            ("X_cs", weights.convective.2, Length),
            ("V_i", f.v_i, Force),
            ("V_c", f.v_c, Force),
            ("M_rwi", f.m_rw_i, Moment),
            ("M_rwc", f.m_rw_c, Moment),
            ("M_si", f.m_s_i, Moment),
            ("M_sc", f.m_s_c, Moment),
        ];
        for (symbol, name, formula, value, dimension, clause) in [
            (
                "V_i",
                "impulsive base shear",
                "A_i·(W_s + W_r + W_f + W_i)",
                f.v_i,
                Force,
                E6_1,
            ),
            ("V_c", "convective base shear", "A_c·W_c", f.v_c, Force, E6_1),
            ("V", "base shear", "√(V_i² + V_c²)", f.v, Force, E6_1),
            (
                "M_rwi",
                "impulsive ringwall moment",
                "A_i·(W_i·X_i + W_s·X_s + W_r·X_r)",
                f.m_rw_i,
                Moment,
                E6_1_5,
            ),
            (
                "M_rwc",
                "convective ringwall moment",
                "A_c·W_c·X_c",
                f.m_rw_c,
                Moment,
                E6_1_5,
            ),
            (
                "M_rw",
                "ringwall moment, just above the bottom",
                "√(M_rwi² + M_rwc²)",
                f.m_rw,
                Moment,
                E6_1_5,
            ),
            (
                "M_si",
                "impulsive slab moment",
                "A_i·(W_i·X_is + W_s·X_s + W_r·X_r)",
                f.m_s_i,
                Moment,
                E6_1_5,
            ),
            (
                "M_sc",
                "convective slab moment",
                "A_c·W_c·X_cs",
                f.m_s_c,
                Moment,
                E6_1_5,
            ),
            (
                "M_s",
                "slab moment, with base pressure",
                "√(M_si² + M_sc²)",
                f.m_s,
                Moment,
                E6_1_5,
            ),
        ] {
            sheet.calc(symbol, name, formula, &terms, value, dimension, clause);
        }
        f
    }

    /// Height of the sloshing wave [m] with its line, and the freeboard.
    pub(super) fn sloshing(&mut self, a: &Accelerations) -> f64 {
        let d = self.basis.d;
        self.sheet.section("Sloshing wave");
        let terms = [("D", d, Length), ("A_f", a.a_f, Dimensionless)];
        let delta = self.sheet.calc(
            "δ_s",
            "height of the sloshing wave",
            "0.42·D·A_f",
            &terms,
            0.42 * d * a.a_f,
            Length,
            E7_2,
        );
        let freeboard = self.basis.case.freeboard();
        let metres = |x| crate::sheet::with_unit(x, Length);
        let (Excitation::Site, Some(site)) = (self.excitation, self.site) else {
            if delta > freeboard {
                self.out.notes.push(format!(
                    "The wave of {} exceeds the freeboard of {}.",
                    metres(delta),
                    metres(freeboard)
                ));
            }
            return delta;
        };
        let s_ds = DesignSpectrum::new(site).map_or(0.0, |s| s.s_ds);
        let share = match site.sug {
            3 => 1.0,
            2 if s_ds >= 0.33 => 0.7,
            _ => {
                self.out.notes.push(format!(
                    "{E7_2}: no freeboard is required for seismic use group {} at S_DS = {s_ds:.3} g; 0.7 δ_s = {} is \
                     recommended, {} is there.",
                    site.sug,
                    metres(0.7 * delta),
                    metres(freeboard)
                ));
                return delta;
            }
        };
        let note = "Less is allowed with a roof or shell designed for the liquid, or with secondary containment.";
        let name = format!("Freeboard, {share} δ_s for seismic use group {}", site.sug);
        self.check(
            "freeboard",
            &name,
            share * delta,
            freeboard,
            Length,
            "API 650:2020 E.7.2, table E.7",
            note,
        );
        delta
    }
}
