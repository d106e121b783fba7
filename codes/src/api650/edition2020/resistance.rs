//! Resistance to overturning, shell compression, anchors, sliding and uplift (E.6.2, E.7).

use tank::assessment::Excitation;
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Moment, Stress};

use super::super::hold_down as hd;
use super::Run;
use super::accelerations::Accelerations;
use super::forces::Forces;

const E6_2_1_1: &str = "API 650:2020 E.6.2.1.1";
const E6_2_1_1_2: &str = "API 650:2020 E.6.2.1.1.2";
const E6_2_1_2: &str = "API 650:2020 E.6.2.1.2";
const E6_2_2: &str = "API 650:2020 E.6.2.2";
const E6_2_2_3: &str = "API 650:2020 E.6.2.2.3";
const E7_3: &str = "API 650:2020 E.7.3.1";
const E7_6: &str = "API 650:2020 E.7.6";
const E7_7: &str = "API 650:2020 E.7.7";

/// Share of the design pressure that counts with the earthquake.
const F_P: f64 = 0.4;

impl Run<'_> {
    /// All of the resistance; returns the axial membrane stress of the ringwall moment [Pa].
    pub(super) fn resistance(&mut self, a: &Accelerations, forces: &Forces) -> f64 {
        let b = self.basis;
        let m_rw = forces.m_rw;
        self.sheet.section("Shell compression and overturning");
        b.weight_line(&mut self.sheet, E6_2_1_1);
        let terms = [("M_rw", m_rw, Moment), ("D", b.d, Length), ("t_s", b.t_s, Length)];
        let axial = 1.273 * m_rw / (b.d * b.d) / b.t_s;
        let name = "axial membrane stress of the ringwall moment, linear over the section";
        self.sheet
            .calc("σ_M", name, "1.273·M_rw/D²/t_s", &terms, axial, Stress, E6_2_2);
        if b.anchored() {
            self.compression_linear(a, m_rw);
            self.anchor_uplift(a, m_rw);
        } else {
            match b.bottom() {
                Ok((thickness, f_y)) => self.self_anchored(a, m_rw, thickness, f_y),
                Err(missing) => self.not_checked(E6_2_1_1, "anchorage ratio and shell compression", &missing),
            }
        }
        self.sliding(a, forces);
        axial
    }

    /// Anchorage ratio, compression and annulus of a self-anchored tank.
    fn self_anchored(&mut self, a: &Accelerations, m_rw: f64, thickness: f64, f_y: f64) {
        let b = self.basis;
        let (d, h) = (b.d, b.h);
        let g_e = b.g * (1.0 - 0.4 * a.a_v);
        if g_e <= 0.0 {
            self.out.notes.push(format!(
                "{E6_2_1_1}: A_v = {:.3} g leaves no effective weight (1 - 0.4 A_v ≤ 0); no anchorage ratio.",
                a.a_v
            ));
            return;
        }
        let sheet = &mut self.sheet;
        let terms = [("G", b.g, Dimensionless), ("A_v", a.a_v, Dimensionless)];
        let name = "effective specific gravity";
        sheet.calc("G_e", name, "G·(1 - 0.4·A_v)", &terms, g_e, Dimensionless, E6_2_1_1);
        let t_a = thickness.min(b.t_s);
        let name = "thickness of the annulus that counts (at most t_s)";
        sheet.input("t_a", name, t_a, Length, E6_2_1_1_2);
        sheet.input("F_y", "yield strength of the annulus", f_y, Stress, "tank.bottom");
        let limit = hd::plate_limit(g_e, h, d);
        let force = hd::plate_force(t_a, f_y, g_e, h);
        let w_a = force.min(limit);
        let terms = [
            ("t_a", t_a, Length),
            ("F_y", f_y, Stress),
            ("H", h, Length),
            ("G_e", g_e, Dimensionless),
            ("D", d, Length),
        ];
        let formula = "min(99·t_a·√(F_y·H·G_e), 201.1·H·D·G_e)";
        sheet.calc(
            "w_a",
            "hold-down force of the annulus per length [N/m]",
            formula,
            &terms,
            w_a,
            LineForce,
            E6_2_1_1,
        );
        let pressure = self.pressure();
        let w_int = pressure * d / 4.0;
        let resisting = b.w_t * (1.0 - 0.4 * a.a_v) + w_a - F_P * w_int;
        let j = hd::anchorage_ratio(m_rw, d, resisting);
        let sheet = &mut self.sheet;
        let terms = [("P", pressure, Stress), ("D", d, Length)];
        sheet.calc(
            "w_int",
            "uplift of the design pressure per length",
            "P·D/4",
            &terms,
            w_int,
            LineForce,
            E6_2_1_1,
        );
        let terms = [
            ("M_rw", m_rw, Moment),
            ("D", d, Length),
            ("w_t", b.w_t, LineForce),
            ("A_v", a.a_v, Dimensionless),
            ("w_a", w_a, LineForce),
            ("w_int", w_int, LineForce),
        ];
        let formula = "M_rw/(D²·(w_t·(1 - 0.4·A_v) + w_a - 0.4·w_int))";
        sheet.calc("J", "anchorage ratio", formula, &terms, j, Dimensionless, E6_2_1_1);
        let state = if j <= hd::NO_UPLIFT {
            "J ≤ 0.785: the shell does not lift."
        } else if j <= hd::NOT_SELF_ANCHORED {
            "0.785 < J ≤ 1.54: the shell lifts; self-anchored if the compression is allowed."
        } else {
            "J > 1.54: not self-anchored; thicken the annulus or anchor the tank."
        };
        let limit_j = hd::NOT_SELF_ANCHORED;
        self.check(
            "anchorage_ratio",
            "Anchorage ratio J",
            j,
            limit_j,
            Dimensionless,
            E6_2_1_1,
            state,
        );
        if self.excitation == Excitation::Record {
            self.out
                .notes
                .push(format!("{E6_2_1_1}, J = {j:.3} with the unreduced moment: {state}"));
        }
        if j <= hd::NO_UPLIFT {
            self.compression_linear(a, m_rw);
        } else if j <= hd::NOT_SELF_ANCHORED {
            self.compression_lifting(a, w_a, j);
        } else {
            self.not_checked(E6_2_2, "shell compression", "it has no value for J above 1.54");
        }
        if j <= hd::NOT_SELF_ANCHORED {
            // Where the limit of w_a counts, the thickness that gives it.
            let t_w = t_a * (w_a / force).min(1.0);
            self.annulus(f_y, g_e, t_a, t_w, j > hd::NO_UPLIFT);
        }
    }

    /// Width of the annulus and uplift.
    fn annulus(&mut self, f_y: f64, g_e: f64, t_a: f64, t_w: f64, lifts: bool) {
        let (d, h) = (self.basis.d, self.basis.h);
        let width = hd::annulus_width(t_w, f_y, g_e, h).min(0.035 * d).max(0.45);
        let terms = [
            ("t", t_w, Length),
            ("F_y", f_y, Stress),
            ("H", h, Length),
            ("G_e", g_e, Dimensionless),
            ("D", d, Length),
        ];
        let name = "width of the annulus inside the shell that w_a needs (t gives w_a)";
        let formula = "max(min(0.01723·t·√(F_y/(H·G_e)), 0.035·D), 0.45 m)";
        self.sheet.calc("L", name, formula, &terms, width, Length, E6_2_1_1_2);
        self.out.notes.push(format!(
            "{E6_2_1_1_2}: the bottom plate of this thickness must reach {} inside the shell; its width is not part of the input.",
            crate::sheet::with_unit(width, Length)
        ));
        if lifts {
            let y_u = hd::uplift(f_y, width, t_a);
            let terms = [("F_y", f_y, Stress), ("L", width, Length), ("t_a", t_a, Length)];
            let name = "uplift of the shell for the flexibility of piping";
            self.sheet
                .calc("y_u", name, "12.1·10⁻¹²·F_y·L²/t_a", &terms, y_u, Length, E7_3);
        }
    }

    /// Compression where the whole ring bears: no uplift, or anchored.
    fn compression_linear(&mut self, a: &Accelerations, m_rw: f64) {
        let b = self.basis;
        let sigma = (b.w_t * (1.0 + 0.4 * a.a_v) + 1.273 * m_rw / (b.d * b.d)) / b.t_s;
        let terms = [
            ("w_t", b.w_t, LineForce),
            ("A_v", a.a_v, Dimensionless),
            ("M_rw", m_rw, Moment),
            ("D", b.d, Length),
            ("t_s", b.t_s, Length),
        ];
        let formula = "(w_t·(1 + 0.4·A_v) + 1.273·M_rw/D²)/t_s";
        self.sheet.calc(
            "σ_c",
            "compression of the bottom course",
            formula,
            &terms,
            sigma,
            Stress,
            E6_2_2,
        );
        self.compression_check(sigma);
    }

    /// Compression of a self-anchored tank that lifts.
    fn compression_lifting(&mut self, a: &Accelerations, w_a: f64, j: f64) {
        let b = self.basis;
        let sigma = ((b.w_t * (1.0 + 0.4 * a.a_v) + w_a) * hd::figure_e5_fit(j) - w_a) / b.t_s;
        let terms = [
            ("w_t", b.w_t, LineForce),
            ("A_v", a.a_v, Dimensionless),
            ("w_a", w_a, LineForce),
            ("J", j, Dimensionless),
            ("t_s", b.t_s, Length),
        ];
        let formula = "((w_t·(1 + 0.4·A_v) + w_a)/(0.607 - 0.18667·J^2.3) - w_a)/t_s";
        self.sheet.calc(
            "σ_c",
            "compression of the bottom course",
            formula,
            &terms,
            sigma,
            Stress,
            E6_2_2,
        );
        self.compression_check(sigma);
    }

    fn compression_check(&mut self, sigma: f64) {
        let allowable = self.basis.allowable_compression(&mut self.sheet, "F_C", E6_2_2_3);
        match allowable {
            Ok(f_c) => {
                let name = "Compression of the bottom course";
                self.check("shell_compression", name, sigma, f_c, Stress, E6_2_2_3, "");
            }
            Err(missing) => self.not_checked(E6_2_2_3, "shell compression", &missing),
        }
    }

    /// Anchors of a mechanically anchored tank.
    fn anchor_uplift(&mut self, a: &Accelerations, m_rw: f64) {
        let b = self.basis;
        self.sheet.section("Anchors");
        let pressure = self.pressure();
        let w_int = pressure * b.d / 4.0;
        let w_ab = 1.273 * m_rw / (b.d * b.d) - b.w_t * (1.0 - 0.4 * a.a_v) + w_int;
        let terms = [
            ("M_rw", m_rw, Moment),
            ("D", b.d, Length),
            ("w_t", b.w_t, LineForce),
            ("A_v", a.a_v, Dimensionless),
            ("P", pressure, Stress),
        ];
        let formula = "1.273·M_rw/D² - w_t·(1 - 0.4·A_v) + P·D/4";
        self.sheet
            .calc("w_AB", "uplift per length", formula, &terms, w_ab, LineForce, E6_2_1_2);
        if self.excitation == Excitation::Site {
            let note = "Attachment and embedment: the lesser of 3 P_AB and the anchor's yield force (E.7.1 has 4 times for \
                        connections; the texts differ).";
            b.anchors(&mut self.sheet, &mut self.out, w_ab, "w_AB", E6_2_1_2, note);
        }
    }

    /// Sliding resistance and local shear.
    fn sliding(&mut self, a: &Accelerations, forces: &Forces) {
        let b = self.basis;
        let v = forces.v;
        self.sheet.section("Sliding");
        let shear = 2.0 * v / (std::f64::consts::PI * b.d);
        let terms = [("V", v, Force), ("D", b.d, Length)];
        let name = "largest tangential shear at the base per length";
        self.sheet
            .calc("V_max", name, "2·V/(π·D)", &terms, shear, LineForce, E7_7);
        let Some(site) = self.site else {
            self.not_checked(E7_6, "sliding", "`site.api650` (friction) is missing");
            return;
        };
        let mu = site.friction.min(0.4);
        if site.friction > 0.4 {
            self.out.notes.push(format!(
                "{E7_6}: friction {} is taken as 0.4, the largest allowed.",
                site.friction
            ));
        }
        let v_s = sliding_resistance(mu, b.w_s + b.w_r + b.w_f + b.w_p, a.a_v);
        let terms = [
            ("μ", mu, Dimensionless),
            ("W_s", b.w_s, Force),
            ("W_r", b.w_r, Force),
            ("W_f", b.w_f, Force),
            ("W_p", b.w_p, Force),
            ("A_v", a.a_v, Dimensionless),
        ];
        let formula = "μ·(W_s + W_r + W_f + W_p)·(1 - 0.4·A_v)";
        self.sheet
            .calc("V_s", "sliding resistance", formula, &terms, v_s, Force, E7_6);
        if b.anchored() {
            self.out.notes.push(format!(
                "{E7_6}: the sliding check is for self-anchored tanks; V_s is shown for information."
            ));
        } else {
            self.check("sliding", "Sliding on the foundation", v, v_s, Force, E7_6, "");
        }
    }
}

/// Sliding resistance `μ W (1 − 0.4 A_v)` [N] of the total weight W [N].
pub(super) fn sliding_resistance(friction: f64, weight: f64, a_v: f64) -> f64 {
    friction * weight * (1.0 - 0.4 * a_v)
}
