//! Resistance to overturning, shell compression, anchors, sliding and uplift (E.6.2, E.7).

use tank::assessment::{CheckStatus, Excitation};
use tank::units::Dimension::{Dimensionless, Force, Length, LineForce, Stress};

use super::super::basis::softer;
use super::super::hold_down as hd;
use super::accelerations::Accelerations;
use super::forces::Forces;
use super::{HoldDown, Run, limit_states};
use crate::base_state::{BaseState, Lift};
use crate::lifted;

const E6_2_1_1: &str = "API 650:2020 E.6.2.1.1";
const E6_2_1_1_2: &str = "API 650:2020 E.6.2.1.1.2";
const E6_2_1_2: &str = "API 650:2020 E.6.2.1.2";
const E6_2_2: &str = "API 650:2020 E.6.2.2";
const E6_2_2_3: &str = "API 650:2020 E.6.2.2.3";
const E7_3: &str = "API 650:2020 E.7.3.1";
const E7_6: &str = "API 650:2020 E.7.6";
const E7_7: &str = "API 650:2020 E.7.7";

/// Load and hold-down of the ring of the shell.
#[derive(Clone, Copy)]
struct Load {
    /// Vertical acceleration [g].
    a_v: f64,
    /// Ringwall moment [N·m].
    m_rw: f64,
    /// Weight of shell and roof per length [N/m].
    w_t: f64,
}

impl Run<'_> {
    /// All of the resistance; returns the axial membrane stress of the ringwall moment [Pa].
    pub(super) fn resistance(&mut self, a: &Accelerations, forces: &Forces) -> f64 {
        let b = self.basis;
        let m_rw = forces.m_rw;
        self.sheet.section("Shell compression and overturning");
        let w_t = b.weight_line(&mut self.sheet, E6_2_1_1);
        let name = "axial membrane stress of the ringwall moment, linear over the section";
        let formula = "1.273·M_rw/D²/t_s";
        let axial = self.sheet.calc("σ_M", name, formula, Stress, E6_2_2);
        let load = Load { a_v: a.a_v, m_rw, w_t };
        if b.anchored() {
            self.compression_linear();
            self.anchor_uplift();
            self.base = BaseState::on_anchors(&self.out.checks);
        } else {
            match b.bottom() {
                Ok((thickness, f_y)) => self.self_anchored(&load, thickness, f_y),
                Err(input) if !self.weight_alone(&load) => {
                    self.base = BaseState::Unknown(format!("`{input}` is missing"));
                    self.hold_down = HoldDown::Unknown(format!("`{input}` is missing"), Some(input.clone()));
                    self.missing(limit_states::ANCHORAGE.id, &input);
                    self.missing(limit_states::ANNULUS.id, &input);
                    self.missing(limit_states::COMPRESSION.id, &input);
                }
                Err(_) => {}
            }
        }
        self.sliding(forces);
        axial
    }

    /// Anchorage ratio and compression without the data of the bottom plate (w_a = 0), where the weight alone keeps the shell down;
    /// false where it does not.
    fn weight_alone(&mut self, load: &Load) -> bool {
        let d = self.basis.d;
        let resisting = load.w_t * (1.0 - 0.4 * load.a_v) - self.f_p() * self.pressure() * d / 4.0;
        if load.m_rw > 0.0 && (resisting <= 0.0 || load.m_rw / (d * d * resisting) > hd::NO_UPLIFT) {
            return false;
        }
        self.pressure_uplift();
        let (name, formula) = match load.m_rw > 0.0 {
            true => ("anchorage ratio of the weight alone, w_a = 0", hd::WEIGHT_ALONE),
            false => ("anchorage ratio: no moment", "0"),
        };
        let j = self.sheet.calc("J", name, formula, Dimensionless, E6_2_1_1);
        let note = "J ≤ 0.785 with w_a = 0: the weight alone keeps the shell down; the bottom plate is not needed";
        let (id, limit) = (limit_states::ANCHORAGE.id, hd::NOT_SELF_ANCHORED);
        self.check(id, "Anchorage ratio J", j, limit, Dimensionless, E6_2_1_1, note);
        self.compression_linear();
        let reason = "the weight alone keeps the shell down (J ≤ 0.785): w_a is not needed";
        self.without_comparison(limit_states::ANNULUS.id, CheckStatus::NotApplicable, reason, None);
        true
    }

    /// Line of the uplift of the design pressure; returns it [N/m].
    fn pressure_uplift(&mut self) -> f64 {
        self.sheet.given(&[("P", self.pressure(), Stress)]);
        let name = "uplift of the design pressure per length";
        self.sheet.calc("w_int", name, "P·D/4", LineForce, E6_2_1_1)
    }

    /// Leaves everything open where the vertical acceleration A_v [g] takes the weight away.
    fn weightless(&mut self, a_v: f64) {
        let reason = format!("A_v = {a_v:.3} g leaves no effective weight (1 - 0.4 A_v ≤ 0)");
        self.base = BaseState::Unknown(reason.clone());
        self.hold_down = HoldDown::Unknown(reason.clone(), None);
        for id in [limit_states::ANCHORAGE.id, limit_states::ANNULUS.id, limit_states::COMPRESSION.id] {
            self.without_comparison(id, CheckStatus::NotChecked, &reason, None);
        }
    }

    /// Anchorage ratio, compression and annulus of a self-anchored tank.
    fn self_anchored(&mut self, load: &Load, thickness: f64, f_y: f64) {
        let b = self.basis;
        let h = b.h;
        let &Load { a_v, m_rw, w_t } = load;
        if 1.0 - 0.4 * a_v <= 0.0 {
            return self.weightless(a_v);
        }
        let sheet = &mut self.sheet;
        let (name, formula) = ("effective specific gravity", "G·(1 - 0.4·A_v)");
        let g_e = sheet.calc("G_e", name, formula, Dimensionless, E6_2_1_1);
        let t_a = thickness.min(b.t_s);
        let name = "thickness of the annulus that counts (at most t_s)";
        sheet.input("t_a", name, t_a, Length, E6_2_1_1_2);
        sheet.input("F_y", "yield strength of the annulus", f_y, Stress, "tank.bottom");
        let name = "hold-down force of the annulus per length";
        let w_a = sheet.calc("w_a", name, hd::HOLD_DOWN, LineForce, E6_2_1_1);
        let w_int = self.pressure_uplift();
        let f_p = self.f_p();
        let sheet = &mut self.sheet;
        let (name, formula) = hd::anchorage(m_rw, w_t * (1.0 - 0.4 * a_v) + w_a - f_p * w_int);
        let j = sheet.calc("J", name, formula, Dimensionless, E6_2_1_1);
        let weight_alone = w_t * (1.0 - 0.4 * a_v) - f_p * w_int;
        let held = if weight_alone > 0.0 {
            let name = "the same without w_a";
            sheet.calc("J_0", name, hd::WEIGHT_ALONE, Dimensionless, E6_2_1_1) <= hd::NO_UPLIFT
        } else {
            false
        };
        self.strips(m_rw, w_t * (1.0 - 0.4 * a_v) - f_p * w_int);
        let state = if j <= hd::NO_UPLIFT {
            "J ≤ 0.785: the shell does not lift."
        } else if j <= hd::NOT_SELF_ANCHORED {
            "0.785 < J ≤ 1.54: the shell lifts; self-anchored if the compression is allowed."
        } else {
            "J > 1.54: not self-anchored; thicken the annulus or anchor the tank."
        };
        let limit_j = hd::NOT_SELF_ANCHORED;
        self.check(limit_states::ANCHORAGE.id, "Anchorage ratio J", j, limit_j, Dimensionless, E6_2_1_1, state);
        if self.excitation == Excitation::Record {
            self.out.notes.push(format!("{E6_2_1_1}, J = {j:.3} with the unreduced moment: {state}"));
        }
        if j <= hd::NO_UPLIFT {
            self.compression_linear();
        } else if j <= hd::NOT_SELF_ANCHORED {
            self.compression_lifting();
        } else {
            self.base = BaseState::Unknown("the tank is not stable, J is above 1.54".into());
            let reason = "the annex has no compression for J above 1.54: the tank is not stable";
            self.without_comparison(limit_states::COMPRESSION.id, CheckStatus::NotChecked, reason, None);
            let reason = "no width holds down a shell with J above 1.54: the tank is not stable";
            self.hold_down = HoldDown::Unknown(reason.into(), None);
            self.without_comparison(limit_states::ANNULUS.id, CheckStatus::NotChecked, reason, None);
        }
        if j <= hd::NOT_SELF_ANCHORED {
            // Where the limit of w_a counts, the thickness that gives it.
            let t_w = t_a * (w_a / hd::plate_force(t_a, f_y, g_e, h)).min(1.0);
            let width = self.annulus(t_w, j > hd::NO_UPLIFT);
            if held {
                let reason = "the weight alone keeps the shell down (J_0 ≤ 0.785): w_a is not needed";
                self.without_comparison(limit_states::ANNULUS.id, CheckStatus::NotApplicable, reason, None);
            } else {
                self.hold_down = HoldDown::Width;
                self.annulus_width(width);
            }
        }
    }

    /// The base of strips under the ringwall moment M_rw, beside J and w_a; it decides nothing.
    ///
    /// * `weight`: that holds the shell down [N/m]
    fn strips(&mut self, m_rw: f64, weight: f64) {
        let case = self.basis.case;
        self.out.hold_down = Some(weight);
        let notes = lifted::information(&mut self.sheet, case, ("M_rw", m_rw), weight, E6_2_1_1);
        self.out.notes.extend(notes);
        self.sheet.section("Shell compression and annulus");
    }

    /// Width of the annulus that w_a needs [m], and uplift.
    fn annulus(&mut self, t_w: f64, lifts: bool) -> f64 {
        self.sheet.given(&[("t", t_w, Length)]);
        let name = "width of the annulus inside the shell that w_a needs (t gives w_a)";
        let width = self.sheet.calc("L", name, hd::ANNULUS, Length, E6_2_1_1_2);
        if lifts {
            let plate = self.basis.case.tank.bottom.as_ref().map(|plate| &plate.material);
            self.sheet.given(&[("E", plate.map_or(0.0, |material| material.youngs_modulus), Stress)]);
            let formula = if plate.is_some_and(softer) { hd::UPLIFT_ALUMINIUM } else { hd::UPLIFT };
            let name = "uplift of the shell for the flexibility of piping";
            let uplift = self.sheet.calc("y_u", name, formula, Length, E7_3);
            let toe = self.compression.unwrap_or_default() * self.basis.t_s;
            self.base = BaseState::Lifts(Lift { uplift, toe });
        }
        width
    }

    /// The needed width L [m] against the width of the plate.
    fn annulus_width(&mut self, needed: f64) {
        const PATH: &str = "tank.bottom.width";
        let id = limit_states::ANNULUS.id;
        match self.basis.case.tank.bottom.as_ref().and_then(|plate| plate.width) {
            Some(width) => {
                let (name, note) = ("Width of the annular plate", "L inside the shell");
                self.check(id, name, needed, width, Length, E6_2_1_1_2, note);
            }
            None => {
                let needed = crate::sheet::with_unit(needed, Length);
                let reason = format!("`{PATH}` is missing; {needed} inside the shell are needed");
                self.without_comparison(id, CheckStatus::NotChecked, &reason, Some(PATH));
            }
        }
    }

    /// Compression where the whole ring bears: no uplift, or anchored.
    fn compression_linear(&mut self) {
        let name = "compression of the bottom course";
        let formula = "(w_t·(1 + 0.4·A_v) + 1.273·M_rw/D²)/t_s";
        let sigma = self.sheet.calc("σ_c", name, formula, Stress, E6_2_2);
        self.compression_check(sigma);
    }

    /// Compression of a self-anchored tank that lifts.
    fn compression_lifting(&mut self) {
        let name = "compression of the bottom course";
        let sigma = self.sheet.calc("σ_c", name, hd::LIFTING, Stress, E6_2_2);
        self.compression_check(sigma);
    }

    fn compression_check(&mut self, sigma: f64) {
        let allowable = self.basis.allowable_compression(&mut self.sheet, "F_C", E6_2_2_3, true);
        self.compression = Some(sigma);
        match allowable {
            Ok(f_c) => {
                let name = "Compression of the bottom course";
                self.check(limit_states::COMPRESSION.id, name, sigma, f_c, Stress, E6_2_2_3, "");
            }
            Err(input) => self.missing(limit_states::COMPRESSION.id, &input),
        }
    }

    /// Anchors of a mechanically anchored tank.
    fn anchor_uplift(&mut self) {
        let b = self.basis;
        self.sheet.section("Anchors");
        self.sheet.given(&[("P", self.pressure(), Stress)]);
        let formula = "1.273·M_rw/D² - w_t·(1 - 0.4·A_v) + P·D/4";
        let name = "uplift per length";
        let w_ab = self.sheet.calc("w_AB", name, formula, LineForce, E6_2_1_2);
        if self.excitation == Excitation::Site {
            let note = "Attachment and embedment: the lesser of 3 P_AB and the anchor's yield force (E.7.1 has 4 times for \
                        connections; the texts differ).";
            match b.anchors(&mut self.sheet, w_ab, "w_AB", E6_2_1_2, note) {
                Ok(check) => self.out.checks.push(check),
                Err((CheckStatus::NotChecked, input)) => self.missing(limit_states::ANCHORS.id, &input),
                Err((status, reason)) => self.without_comparison(limit_states::ANCHORS.id, status, &reason, None),
            }
            self.anchor_attachment(w_ab);
            self.anchor_count(w_ab);
            self.anchor_spacing();
        }
    }

    /// Sliding resistance and local shear.
    fn sliding(&mut self, forces: &Forces) {
        let b = self.basis;
        let v = forces.v;
        self.sheet.section("Sliding");
        let name = "largest tangential shear at the base per length";
        self.sheet.calc("V_max", name, "2·V/(π·D)", LineForce, E7_7);
        self.shear_transfer();
        let Some(site) = self.site else { return };
        let mu = site.friction.min(0.4);
        if site.friction > 0.4 {
            self.out.notes.push(format!("{E7_6}: friction {} is taken as 0.4, the largest allowed.", site.friction));
        }
        self.sheet.given(&[("μ", mu, Dimensionless)]);
        let formula = "μ·(W_s + W_r + W_f + W_p)·(1 - 0.4·A_v)";
        let name = "sliding resistance";
        let v_s = self.sheet.calc("V_s", name, formula, Force, E7_6);
        if b.anchored() {
            self.out
                .notes
                .push(format!("{E7_6}: the sliding check is for self-anchored tanks; V_s is shown for information."));
        } else {
            self.check(limit_states::SLIDING.id, "Sliding on the foundation", v, v_s, Force, E7_6, "");
        }
    }
}
