//! Displacements of the pipes' attachments (E.7.3, table E.8).
//!
//! | displacement | mechanically anchored | self-anchored |
//! |---|---|---|
//! | upwards, while the anchors hold | 25 mm (1 in.) | 25 mm (1 in.) for J ≤ 0.785, 100 mm (4 in.) above |
//! | downwards | 13 mm (1/2 in.) | 13 mm (1/2 in.) on a ring wall or mat, 25 mm (1 in.) on a berm |
//! | horizontal, radial and tangential | 13 mm (1/2 in.) | 50 mm (2 in.) |
//!
//! Both units are printed, rounded each for itself; who follows either follows the table, so the lesser value counts (13 mm: 12.7 mm).
//! The same values stand in ASCE 7, table 15.7-1. They are minima: where the uplift y_u of E.7.3.1 is larger, it counts. A self-anchored tank
//! without `tank.foundation`, or on soil, takes the value of a berm. Recalled, not compared with the printed standard.

use super::limit_states::PIPING;
use tank::FoundationKind;
use tank::assessment::{CheckStatus, Excitation};
use tank::units::Dimension::Length;

use super::Run;
use crate::base_state::BaseState;

const TABLE_E8: &str = "API 650:2020 E.7.3, table E.8";

/// The less demanding of both printed values of a least displacement [m].
fn least(millimetres: f64, inches: f64) -> f64 {
    const INCH: f64 = 0.0254;
    f64::min(millimetres / 1e3, inches * INCH)
}

/// Least displacements of table E.8 [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Displacements {
    /// Upwards; none where the uplift is not known.
    pub up: Option<f64>,
    /// Downwards.
    pub down: f64,
    /// Horizontally.
    pub horizontal: f64,
}

/// The displacements that the pipes must allow; `stiff`: on a ring wall or mat.
pub(super) fn required(anchored: bool, stiff: bool, base: &BaseState) -> Displacements {
    let (half, one) = (least(13.0, 0.5), least(25.0, 1.0));
    let up = match base {
        BaseState::Bears => Some(one),
        BaseState::Lifts(lift) => Some(lift.uplift.max(least(100.0, 4.0))),
        BaseState::Unknown(_) => None,
    };
    match anchored {
        true => Displacements { up, down: half, horizontal: half },
        false => Displacements { up, down: if stiff { half } else { one }, horizontal: least(50.0, 2.0) },
    }
}

impl Run<'_> {
    /// The displacements that the pipes allow against table E.8.
    pub(super) fn piping(&mut self) {
        if self.excitation != Excitation::Site {
            return;
        }
        let anchored = self.basis.anchored();
        let foundation = self.basis.case.tank.foundation.as_ref().map(|f| f.kind);
        let stiff = foundation.is_some_and(|kind| kind != FoundationKind::Soil);
        let required = required(anchored, stiff, &self.base);
        self.sheet.section("Displacements of the pipes");
        let up = match &self.base {
            BaseState::Lifts(lift) if lift.uplift > least(100.0, 4.0) => {
                "y_u, which is more than the 100 mm of table E.8"
            }
            BaseState::Lifts(_) => "J above 0.785",
            _ => "no uplift",
        };
        let down = match (anchored, stiff) {
            (true, _) => "mechanically anchored",
            (false, true) => "on a ring wall or mat",
            (false, false) => "on a berm; half of it on a ring wall or mat",
        };
        let pipes = self.basis.case.tank.pipes.unwrap_or_default();
        let parts = [
            ("u_z", "uplift", required.up, pipes.uplift, up),
            ("u_s", "settlement", Some(required.down), pipes.settlement, down),
            ("u_h", "horizontal", Some(required.horizontal), pipes.horizontal, ""),
        ];
        let mut open: Option<(String, Option<String>)> = None;
        for (part, (symbol, key, demand, capacity, note)) in PIPING.parts.iter().zip(parts) {
            let name = part.name.trim_start_matches("Pipes, ");
            let path = format!("tank.pipes.{key}");
            if let Some(demand) = demand {
                let source = match (&self.base, key) {
                    (BaseState::Lifts(lift), "uplift") if lift.uplift >= demand => "y_u of the shell",
                    _ => "table E.8, the lesser of its values in mm and in inches",
                };
                let line = format!("{name} that the pipes must allow");
                self.sheet.look_up(symbol, &line, source, demand, Length, TABLE_E8);
            }
            match (demand, capacity) {
                (Some(demand), Some(capacity)) => {
                    let check = part.of(demand, capacity, TABLE_E8, note);
                    self.out.checks.push(check.of(PIPING.id));
                }
                (Some(demand), None) => {
                    let needed = crate::sheet::with_unit(demand, Length);
                    let reason = format!("`{path}` is missing; the pipes must allow {needed} of {name}");
                    open.get_or_insert((reason, Some(path)));
                }
                (None, _) => {
                    if let BaseState::Unknown(reason) = &self.base {
                        open.get_or_insert((format!("the uplift is not known: {reason}"), None));
                    }
                }
            }
        }
        if let Some((reason, path)) = open {
            let (id, status) = (PIPING.id, CheckStatus::NotChecked);
            self.without_comparison(id, status, &reason, path.as_deref());
        }
    }
}
