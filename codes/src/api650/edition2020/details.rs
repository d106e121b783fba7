//! Details of the base: shear between shell and bottom (E.7.7), weld and support of the plates under the shell, connections through the
//! bottom (E.7.4).
//!
//! ```text
//! V_max = 2 V/(π D)        τ_w = V_max/(2 · 0.707 a) ≤ 0.8 F_y        two fillet welds with legs a, F_y of the weaker plate
//! ```
//!
//! Legs that are not given are the least of 5.1.5.7. E.7.4, E.7.7, E.7.9 and 5.1.5.7 are recalled. Butt-welded annular plates are those of
//! the public API agenda item 650-1003 (2013); the number that the clause got in the standard is not known here.

use tank::assessment::{CheckStatus, Excitation};
use tank::units::Dimension::{Dimensionless, Length, Stress};
use tank::{BottomConnections, Joint, ShellSupport};

use super::{HoldDown, Run, limit_states};

const E7_4: &str = "API 650:2020 E.7.4";
const E7_7: &str = "API 650:2020 E.7.7";
const E7_9: &str = "API 650:2020 E.7.9";
const WELD: &str = "API 650:2020 E.6.2.1.1, agenda item 650-1003";
/// Thickness of an annular plate above which its welds are butt welds [m]: the larger of 10 mm and 3/8 in.
const BUTT_FROM: f64 = 0.010;
/// S_DS [g] from which tanks of seismic use group III have butt-welded annular plates.
const STRONG: f64 = 0.5;
/// Distance of a connection from the plate that holds the shell down [m]: 300 mm (12 in.), the lesser.
const CLEARANCE: f64 = 0.300;

/// Least leg of a fillet weld between shell and bottom [m] for the thickness of the bottom course [m]; none beyond the table.
fn least_leg(thickness: f64) -> Option<f64> {
    const TABLE: [(f64, f64); 4] = [(0.005, 0.005), (0.020, 0.006), (0.032, 0.008), (0.045, 0.010)];
    let row = TABLE.iter().find(|(up_to, _)| thickness <= up_to * (1.0 + 1e-9))?;
    Some(row.1.min(thickness))
}

impl Run<'_> {
    /// Shear stress of the welds between shell and bottom.
    ///
    pub(super) fn shear_transfer(&mut self) {
        if self.excitation != Excitation::Site {
            return;
        }
        let (b, id) = (self.basis, limit_states::SHEAR.id);
        let shell = &b.case.tank.courses[0].material;
        if !shell.is_metal() {
            let reason = "the shell is not welded to its bottom: `wall_material`";
            return self.without_comparison(id, CheckStatus::NotApplicable, reason, None);
        }
        let bottom = b.case.tank.bottom.as_ref().map(|plate| &plate.material);
        let mut weakest = f64::INFINITY;
        for material in [Some(shell), bottom].into_iter().flatten() {
            match material.yield_strength {
                Some(f_y) => weakest = weakest.min(f_y),
                None => return self.missing(id, &format!("materials.{}.yield_strength", material.name)),
            }
        }
        const GIVEN: &str = "tank.bottom.shell_weld";
        let name = "leg of each of the two fillet welds between shell and bottom";
        match b.case.tank.details.shell_weld {
            Some(leg) => self.sheet.input("a_w", name, leg, Length, GIVEN),
            None => match least_leg(b.t_s) {
                Some(leg) => {
                    let source = "the least for the thickness of the shell";
                    self.sheet.look_up("a_w", name, source, leg, Length, "API 650:2020 5.1.5.7")
                }
                None => return self.missing(id, GIVEN),
            },
        };
        self.sheet.given(&[("F_y", weakest, Stress)]);
        let name = "shear stress of the welds";
        let tau = self.sheet.calc("τ_w", name, "V_max/(2·0.707·a_w)", Stress, E7_7);
        let name = "80 % of the yield strength of the weaker plate";
        let allowed = self.sheet.calc("τ_a", name, "0.8·F_y", Stress, E7_7);
        let name = "Shear of the weld between shell and bottom";
        self.check(id, name, tau, allowed, Stress, E7_7, "");
    }

    /// A detail that is as the clause wants it, or not: deviations from it against none.
    fn detail(&mut self, id: &str, name: &str, sound: bool, clause: &str, note: &str) {
        let (found, allowed) = if sound { (0.0, 1.0) } else { (1.0, 0.0) };
        self.check(id, name, found, allowed, Dimensionless, clause, note);
    }

    /// Welds of the annular plates of a self-anchored tank.
    pub(super) fn annular_weld(&mut self) {
        let (id, Some(site)) = (limit_states::ANNULAR_WELD.id, self.site) else { return };
        if self.excitation != Excitation::Site || self.basis.anchored() {
            return;
        }
        let thickness = self.basis.case.tank.bottom.as_ref().map_or(0.0, |plate| plate.thickness);
        let important = site.sug == 3 && self.short_period(site) >= STRONG;
        if !important && thickness <= BUTT_FROM {
            let reason = "seismic use group III with S_DS of at least 0.5 g, or an annular plate thicker than 10 mm, asks for it";
            return self.without_comparison(id, CheckStatus::NotApplicable, reason, None);
        }
        let why = match important {
            true => "butt welds are required in seismic use group III from S_DS = 0.5 g on",
            false => "butt welds are required of annular plates thicker than 10 mm",
        };
        let name = "Lap welds of the annular plates";
        match self.basis.case.tank.details.annular_weld {
            Some(joint) => self.detail(id, name, joint == Joint::Butt, WELD, why),
            None => {
                let path = "tank.bottom.annular_weld";
                let reason = format!("`{path}` is missing; {why}");
                self.without_comparison(id, CheckStatus::NotChecked, &reason, Some(path));
            }
        }
    }

    /// What a shell on concrete stands on.
    pub(super) fn shell_support(&mut self) {
        let id = limit_states::SUPPORT.id;
        let required = |state: &tank::assessment::LimitState| {
            state.id == id && state.requirement == tank::assessment::Requirement::Required
        };
        if self.excitation != Excitation::Site || !limit_states::all(self.basis.case).iter().any(required) {
            return;
        }
        let details = self.basis.case.tank.details;
        let Some(support) = details.shell_support else { return self.missing(id, "tank.foundation.shell_support") };
        let name = "Supports of the shell that the clause excludes";
        if self.basis.anchored() {
            let note = "a mechanically anchored tank stands on shims and grout";
            return self.detail(id, name, support == ShellSupport::Grouted, E7_9, note);
        }
        let (sound, note) = match (support, details.annular_weld) {
            (ShellSupport::Shims, _) => {
                let reason = "the local pressure of shims without grout on shell and concrete is not checked";
                return self.without_comparison(id, CheckStatus::NotChecked, reason, None);
            }
            (ShellSupport::Grouted, _) => (true, "shims and grout"),
            (ShellSupport::Padding, _) => (true, "a pad"),
            (ShellSupport::ButtWelded, Some(Joint::Butt)) => (true, "butt-welded plates on the concrete"),
            (ShellSupport::ButtWelded, Some(Joint::Lap)) => (false, "plates directly on the concrete are butt-welded"),
            (ShellSupport::ButtWelded, None) => return self.missing(id, "tank.bottom.annular_weld"),
        };
        self.detail(id, name, sound, E7_9, note);
    }

    /// Distance of connections through the bottom of a self-anchored tank from its shell.
    pub(super) fn bottom_connections(&mut self) {
        let id = limit_states::CONNECTIONS.id;
        if self.excitation != Excitation::Site || self.basis.anchored() {
            return;
        }
        let given = match self.basis.case.tank.details.bottom_connections {
            Some(BottomConnections::None) => {
                let reason = "no connection passes through the bottom, by the tank file";
                return self.without_comparison(id, CheckStatus::NotApplicable, reason, None);
            }
            Some(BottomConnections::Within(distance)) => Some(distance),
            None => None,
        };
        let needed = match self.hold_down.clone() {
            HoldDown::Needless => {
                let reason = "the weight alone keeps the shell down: no bottom plate lifts";
                return self.without_comparison(id, CheckStatus::NotApplicable, reason, None);
            }
            HoldDown::Unknown(reason, input) => {
                return self.without_comparison(id, CheckStatus::NotChecked, &reason, input.as_deref());
            }
            HoldDown::Width => {
                self.sheet.given(&[("c", CLEARANCE, Length)]);
                let name = "least distance of a reinforcement in the bottom from the shell, c = 300 mm";
                self.sheet.section("Connections through the bottom");
                self.sheet.calc("L_c", name, "L + c", Length, E7_4)
            }
        };
        match given {
            Some(distance) => {
                let name = "Distance of bottom connections from the shell";
                self.check(id, name, needed, distance, Length, E7_4, "");
            }
            None => {
                let path = "tank.bottom.connections";
                let needed = crate::sheet::with_unit(needed, Length);
                let reason = format!("`{path}` is missing; {needed} from the shell are needed");
                self.without_comparison(id, CheckStatus::NotChecked, &reason, Some(path));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::least_leg;

    /// 5.1.5.7: 5, 6, 8 and 10 mm up to 5, 20, 32 and 45 mm of shell (3/16, 1/4, 5/16 and 3/8 in.).
    #[test]
    fn least_legs() {
        for (shell, leg) in
            [(0.003, 0.003), (0.005, 0.005), (0.014, 0.006), (0.020, 0.006), (0.0201, 0.008), (0.045, 0.010)]
        {
            assert_eq!(least_leg(shell), Some(leg), "{shell}");
        }
        assert_eq!(least_leg(0.046), None);
    }
}
