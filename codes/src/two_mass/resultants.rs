//! Base shear, moments and the wave with its freeboard.

use tank::assessment::Excitation;
use tank::quantity::Quantity;
use tank::units::Dimension::{Force, Length, Moment};

use super::{Clauses, Work};
use crate::limit_state::common::FREEBOARD;

impl Work<'_> {
    /// Lines of base shear and moments; adds the quantities.
    ///
    /// * `share`: share ε of the wall, where it has a line
    pub(super) fn resultants(&mut self, share: Option<f64>, clauses: &Clauses) {
        let wall = if share.is_some() { "ε·m_w" } else { "m_w" };
        let tank = &self.case.tank;
        let of_wall = share.unwrap_or(1.0) * tank.thick_wall().0;
        let [heading, shear, above, below] = match tank.staging {
            None => [
                "Base shear and moments",
                "base shear",
                "moment just above the base",
                "moment below the base, with base pressure",
            ],
            Some(_) => [
                "Shear and moments at the bottom of the wall",
                "shear of wall and liquid",
                "moment just above the bottom",
                "moment below the bottom, with its pressure",
            ],
        };
        self.sheet.section(heading);
        for (symbol, name, quantity, dimension, clause, [at_wall, at_liquid, roof, sloshing]) in [
            ("Q", shear, Quantity::BaseShear, Force, clauses.shear, ["", "", "", ""]),
            ("M", above, Quantity::BaseMoment, Moment, clauses.moments, ["·h_w", "·h_i", "·h_r", "·h_c"]),
            ("M′", below, Quantity::OverturningMoment, Moment, clauses.moments, ["·h_w", "·h_i′", "·h_r", "·h_c′"]),
        ] {
            let mut part = |index: &str, what: &str, formula: &str| {
                let (symbol, name) = (format!("{symbol}_{index}"), format!("{name}, {what}"));
                self.sheet.calc(&symbol, &name, formula, dimension, clause);
                symbol
            };
            let impulsive = format!("A_i·g·(m_i{at_liquid} + {wall}{at_wall} + m_r{roof})");
            let convective = format!("A_c·g·m_c{sloshing}");
            let (i, c) = (part("i", "impulsive", &impulsive), part("c", "convective", &convective));
            let value = self.sheet.calc(symbol, name, &format!("√({i}² + {c}²)"), dimension, clause);
            self.out.values.insert(quantity, value);
        }
        self.out.values.insert(Quantity::WallMass, of_wall);
        if tank.roof.mass > 0.0 {
            self.out.values.insert(Quantity::RoofMass, tank.roof.mass);
        }
    }

    /// Line of the wave, and the freeboard under the spectrum of the site.
    pub(super) fn wave(&mut self, clauses: &Clauses) {
        self.sheet.section("Wave height");
        let formula = format!("A_w·{}/2", self.symbol());
        let height = self.sheet.calc("d_max", "height of the sloshing wave", &formula, Length, clauses.wave);
        self.out.values.insert(Quantity::SloshingHeight, height);
        if self.excitation == Excitation::Site {
            let note = "the wave needs this freeboard if the liquid must neither spill nor strike the roof";
            let check = FREEBOARD.check().of(height, self.case.freeboard(), clauses.wave, note);
            self.out.checks.push(match &self.doubt {
                Some(reason) => check.left_open(reason.clone()),
                None => check,
            });
        }
    }
}
