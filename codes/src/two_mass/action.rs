//! Accelerations of the parts.

use tank::ingredients::{Ordinate, Rule};
use tank::units::Dimension::Dimensionless;

use super::{Clauses, Impulsive, Periods, Work};
use crate::ordinates::{plateau, psa};
use crate::procedure::CodeError;

/// Accelerations of the parts with what they are made of; the sheet has them in g, as A_i, A_c, A_w and A_v.
pub(crate) struct Action {
    /// Impulsive part.
    pub impulsive: Ordinate,
    /// Convective part.
    pub convective: Ordinate,
    /// Convective part for the wave, not reduced.
    pub wave: Ordinate,
    /// Vertical acceleration [m/s²].
    pub vertical: f64,
}

impl Work<'_> {
    /// Lines of the accelerations of the record's spectrum.
    pub(super) fn of_record(&mut self, periods: &Periods, clauses: &Clauses) -> Result<Action, CodeError> {
        let case = self.case;
        // `applies` has asked before.
        let Some(motion) = &case.ground_motion else {
            return Err(CodeError::Data { clause: clauses.action.into(), reason: "no record given".into() });
        };
        let (record, damping, g) = (&motion.horizontal, case.damping, case.gravity);
        let source = format!("spectrum of `{}`", record.name);
        let percent = |ratio: f64| format!("{} % damping", crate::sheet::number(100.0 * ratio));
        let spectrum = "spectrum of the record over g";
        let impulsive = match periods.impulsive {
            Some(Impulsive { period, .. }) => {
                Ordinate::at(period, damping.impulsive, psa(record, period, damping.impulsive))
            }
            None => {
                let (period, largest) = plateau(record, damping.impulsive);
                Ordinate { rule: Rule::Plateau, ..Ordinate::at(period, damping.impulsive, largest) }
            }
        };
        let name = match periods.impulsive {
            Some(_) => {
                format!("impulsive acceleration: spectral acceleration at T_i, {} [g]", percent(damping.impulsive))
            }
            None => format!(
                "impulsive acceleration: largest spectral acceleration of the impulsive range, {} [g]",
                percent(damping.impulsive)
            ),
        };
        let sheet = &mut self.sheet;
        sheet.look_up("A_i", &name, spectrum, impulsive.value() / g, Dimensionless, &source);
        let period = periods.convective;
        let convective = Ordinate::at(period, damping.sloshing, psa(record, period, damping.sloshing));
        let name = format!("convective acceleration: spectral acceleration at T_c, {} [g]", percent(damping.sloshing));
        sheet.look_up("A_c", &name, spectrum, convective.value() / g, Dimensionless, &source);
        sheet.calc("A_w", "acceleration of the sloshing wave [g]", "A_c", Dimensionless, clauses.wave);
        let vertical = match &motion.vertical {
            Some(vertical) => {
                let largest = plateau(vertical, damping.impulsive).1;
                let name = "vertical acceleration: largest spectral acceleration of the vertical record, T = 0 and 0.05 to 0.5 s [g]";
                sheet.look_up("A_v", name, spectrum, largest / g, Dimensionless, &source);
                largest
            }
            None => sheet.input("A_v", "vertical acceleration: no vertical record [g]", 0.0, Dimensionless, &source),
        };
        Ok(Action { impulsive, wave: convective.clone(), convective, vertical })
    }
}
