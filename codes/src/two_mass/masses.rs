//! Masses of the liquid, their heights, and the sloshing period.

use tank::quantity::Quantity;
use tank::units::Dimension::{Dimensionless, Length, Mass, Time};

use super::{Clauses, Work};
use crate::mechanical::{Lumped, Plan};

/// Proportion from which the impulsive force acts at 3/8 of the depth.
const SHALLOW: f64 = 1.333;
/// Proportion below which the lever with base pressure is 0.45 of the depth.
const SLENDER: f64 = 0.75;
/// Argument from which cosh and sinh would overflow in a difference that is long exact.
const LARGE: f64 = 300.0;

/// Masses [kg] with their heights [m].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Masses {
    /// Impulsive part.
    pub impulsive: Lumped,
    /// Convective part.
    pub convective: Lumped,
}

impl Work<'_> {
    /// Lines of the masses and their heights.
    pub(super) fn masses(&mut self, clauses: &Clauses) -> Masses {
        let r = self.length / self.case.liquid.fill_height;
        let (argument, mass) = match self.plan {
            Plan::Circle => ("3.68/r", "m·0.23·r·tanh(u)"),
            Plan::Rectangle => ("3.16/r", "m·0.264·r·tanh(u)"),
        };
        let sheet = &mut self.sheet;
        sheet.section("Masses and heights");
        let m_i = sheet.calc("m_i", "impulsive mass", "m·tanh(0.866·r)/(0.866·r)", Mass, clauses.masses);
        let name = "argument of the sloshing mode";
        let u = sheet.calc("u", name, argument, Dimensionless, clauses.masses);
        let m_c = sheet.calc("m_c", "convective mass", mass, Mass, clauses.masses);
        let mut height =
            |symbol: &str, name: &str, formula: &str| sheet.calc(symbol, name, formula, Length, clauses.heights);
        let formula = if r < SHALLOW { "(0.5 - 0.09375·r)·H" } else { "0.375·H" };
        let h_i = height("h_i", "height of the impulsive force, wall only", formula);
        let formula = if r < SLENDER { "0.45·H" } else { "(0.866·r/(2·tanh(0.866·r)) - 0.125)·H" };
        let h_ib = height("h_i′", "height of the impulsive force, wall and base", formula);
        let lever = |constant: &str| match u < LARGE {
            true => format!("H·(1 - (cosh(u) - {constant})/(u·sinh(u)))"),
            false => "H·(1 - 1/u)".into(),
        };
        let h_c = height("h_c", "height of the convective force, wall only", &lever("1"));
        let h_cb = height("h_c′", "height of the convective force, wall and base", &lever("2.01"));
        self.out.values.extend([(Quantity::ImpulsiveMass, m_i), (Quantity::ConvectiveMass, m_c)]);
        Masses {
            impulsive: Lumped { mass: m_i, lever: h_i, lever_with_base: h_ib },
            convective: Lumped { mass: m_c, lever: h_c, lever_with_base: h_cb },
        }
    }

    /// Line of the sloshing period [s].
    pub(super) fn sloshing_period(&mut self, clauses: &Clauses) -> f64 {
        let formula = match self.plan {
            Plan::Circle => "2·π·√(D/(3.68·g·tanh(u)))",
            Plan::Rectangle => "2·π·√(L/(3.16·g·tanh(u)))",
        };
        let period = self.sheet.calc("T_c", "sloshing period", formula, Time, clauses.sloshing);
        self.out.values.insert(Quantity::SloshingPeriod, period);
        period
    }
}
