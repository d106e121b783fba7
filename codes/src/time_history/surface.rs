//! The surface of the liquid: freeboard, and impact on the roof.

use tank::assessment::{Check, CheckStatus};
use tank::demand::Surface;
use tank::large_wave::LargeWave;
use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length};

use super::limit_states::{FREEBOARD, ROOF};
use super::work::Work;
use crate::sheet::with_unit;

/// Why a crest that stays within the freeboard does not show that it holds.
const TOO_HIGH: &str = "the wave is so high that the factor of its crest is too low, and the crest a lower bound";

const BREAKS: &str = "the wave breaks, which the nonlinear liquid does not follow: its crest is a lower bound";

/// The crest of the largest wave against the freeboard; where the factor of the crest is too low, nothing holds by it.
pub(super) fn assess(work: &mut Work<'_>) {
    let Some(wave) = work.demands.wave else {
        for id in [FREEBOARD.id, ROOF.id] {
            work.without(id, CheckStatus::NotChecked, "the engine does not give the wave", None);
        }
        return;
    };
    let linear = work.factor * wave.value;
    let freeboard = work.case.freeboard();
    let clause = work.clause(FREEBOARD.id);
    let large = LargeWave::of(work.case);
    work.sheet.section("Freeboard");
    let name = "largest rise of the surface at the wall";
    work.sheet.input("d", name, linear, Length, "the run of the engine");
    let rise = match work.demands.surface {
        Surface::Linear => {
            let name = "excess of the crest over a small wave, c d/R";
            work.sheet.input("e", name, large.excess(linear), Dimensionless, "potential flow of third order");
            work.sheet.calc("d_c", "crest of the wave", "d·(1 + e)", Length, "potential flow of third order")
        }
        Surface::Nonlinear | Surface::Stopped => linear,
    };
    work.sheet.input("h_f", "freeboard", freeboard, Length, "tank.courses, liquid");
    let note = "the crest of the wave needs this freeboard if the liquid must neither spill nor strike the roof";
    let check = Check::new(FREEBOARD.id, "Freeboard", rise, freeboard, Length, &clause, note)
        .at(Some(wave.time), None, Some(wave.theta))
        .with_error(work.mesh_error(Quantity::SloshingHeight));
    let bound = match work.demands.surface {
        Surface::Linear => (large.excess(linear) > large.fitted()).then_some(TOO_HIGH),
        Surface::Nonlinear => None,
        Surface::Stopped => Some(BREAKS),
    };
    let holds = check.holds();
    work.checks.push(match bound.filter(|_| holds) {
        Some(reason) => check.left_open(reason.to_owned()),
        None => check,
    });
    let roof = work.case.tank.roof.mass > 0.0;
    let (status, reason) = match (rise > freeboard, roof) {
        (false, _) => (CheckStatus::NotApplicable, "the wave does not reach the top of the wall".to_owned()),
        (true, false) => (CheckStatus::NotApplicable, "the tank has no roof".to_owned()),
        (true, true) => {
            let above = with_unit(rise - freeboard, Length);
            let reason =
                format!("the wave rises {above} above the wall and presses on the roof, whose resistance is not known");
            (CheckStatus::NotChecked, reason)
        }
    };
    work.without(ROOF.id, status, &reason, None);
}
