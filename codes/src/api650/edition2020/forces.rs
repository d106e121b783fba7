//! Base shear, moments and sloshing wave (E.6.1, E.7.2).

use tank::assessment::{CheckStatus, Excitation};
use tank::units::Dimension::{Dimensionless, Force, Length, Moment};

use super::super::masses::{ARGUMENT, charts};
use super::{Run, limit_states};

const E6_1: &str = "API 650:2020 E.6.1";
const E6_1_1: &str = "API 650:2020 E.6.1.1";
const E6_1_2_1: &str = "API 650:2020 E.6.1.2.1";
const E6_1_2_2: &str = "API 650:2020 E.6.1.2.2";
const E6_1_5: &str = "API 650:2020 E.6.1.5";
const E7_2: &str = "API 650:2020 E.7.2";

/// Base shear [N], moments [N·m] and the liquid's weights [N].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Forces {
    /// Base shear V.
    pub v: f64,
    /// Ringwall moment M_rw.
    pub m_rw: f64,
    /// Slab moment M_s.
    pub m_s: f64,
    /// Impulsive weight W_i.
    pub w_i: f64,
    /// Convective weight W_c.
    pub w_c: f64,
    /// Height X_i [m] of the impulsive force above the bottom, ringwall.
    pub x_i: f64,
    /// Height X_c [m] of the convective force above the bottom, ringwall.
    pub x_c: f64,
    /// Height X_is [m] of the impulsive force, slab.
    pub x_is: f64,
    /// Height X_cs [m] of the convective force, slab.
    pub x_cs: f64,
}

impl Run<'_> {
    /// Weights, base shear and moments with their lines.
    pub(super) fn forces(&mut self) -> Forces {
        let b = self.basis;
        self.out.assumptions.push(match &b.case.tank.bottom {
            Some(_) => "The whole floor has the thickness of the bottom plate under the shell.".into(),
            None => "The floor's weight is left out of the base shear: `tank.bottom` is missing.".to_string(),
        });
        let sheet = &mut self.sheet;
        sheet.section("Effective masses");
        let charts = charts(b.d / b.h);
        let w_i = sheet.calc("W_i", "impulsive weight", charts.w_i, Force, E6_1_1);
        let w_c = sheet.calc("W_c", "convective weight", charts.w_c, Force, E6_1_1);
        let name = "height of the impulsive force, ringwall";
        let x_i = sheet.calc("X_i", name, charts.x_i, Length, E6_1_2_1);
        let name = "argument of the sloshing mode";
        sheet.calc("u", name, ARGUMENT, Dimensionless, E6_1_2_1);
        let name = "height of the convective force, ringwall";
        let x_c = sheet.calc("X_c", name, charts.x_c, Length, E6_1_2_1);
        let name = "height of the impulsive force, slab";
        let x_is = sheet.calc("X_is", name, charts.x_is, Length, E6_1_2_2);
        let name = "height of the convective force, slab";
        let x_cs = sheet.calc("X_cs", name, charts.x_cs, Length, E6_1_2_2);
        sheet.input("W_f", "weight of the floor", b.w_f, Force, "tank.bottom");

        sheet.section("Base shear and moments");
        let formula = "A_i·(W_s + W_r + W_f + W_i)";
        sheet.calc("V_i", "impulsive base shear", formula, Force, E6_1);
        sheet.calc("V_c", "convective base shear", "A_c·W_c", Force, E6_1);
        let v = sheet.calc("V", "base shear", "√(V_i² + V_c²)", Force, E6_1);
        let formula = "A_i·(W_i·X_i + W_s·X_s + W_r·X_r)";
        sheet.calc("M_rwi", "impulsive ringwall moment", formula, Moment, E6_1_5);
        sheet.calc("M_rwc", "convective ringwall moment", "A_c·W_c·X_c", Moment, E6_1_5);
        let (name, formula) = ("ringwall moment, just above the bottom", "√(M_rwi² + M_rwc²)");
        let m_rw = sheet.calc("M_rw", name, formula, Moment, E6_1_5);
        let formula = "A_i·(W_i·X_is + W_s·X_s + W_r·X_r)";
        sheet.calc("M_si", "impulsive slab moment", formula, Moment, E6_1_5);
        sheet.calc("M_sc", "convective slab moment", "A_c·W_c·X_cs", Moment, E6_1_5);
        let (name, formula) = ("slab moment, with base pressure", "√(M_si² + M_sc²)");
        let m_s = sheet.calc("M_s", name, formula, Moment, E6_1_5);
        Forces { v, m_rw, m_s, w_i, w_c, x_i, x_c, x_is, x_cs }
    }

    /// Height of the sloshing wave [m] with its line, and the freeboard.
    pub(super) fn sloshing(&mut self) -> f64 {
        self.sheet.section("Sloshing wave");
        let delta = self.sheet.calc("δ_s", "height of the sloshing wave", "0.42·D·A_f", Length, E7_2);
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
        let s_ds = self.short_period(site);
        let share = match site.sug {
            3 => 1.0,
            2 if s_ds >= 0.33 => 0.7,
            _ => {
                let reason = format!(
                    "no freeboard is required for seismic use group {} at S_DS = {s_ds:.3} g; 0.7 δ_s = {} is recommended, {} is \
                     available",
                    site.sug,
                    metres(0.7 * delta),
                    metres(freeboard)
                );
                if 0.7 * delta > freeboard {
                    self.out.notes.push(format!(
                        "{E7_2}: the recommended freeboard of {} is more than the {} there are.",
                        metres(0.7 * delta),
                        metres(freeboard)
                    ));
                }
                self.without_comparison(limit_states::FREEBOARD.id, CheckStatus::NotApplicable, &reason, None);
                return delta;
            }
        };
        let note = "Less is allowed with a roof or shell designed for the liquid, or with secondary containment.";
        let name = format!("Freeboard, {share} δ_s for seismic use group {}", site.sug);
        self.check(
            limit_states::FREEBOARD.id,
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
