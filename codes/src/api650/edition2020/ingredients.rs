//! What the quantities of the annex are made of.

use tank::assessment::Excitation;
use tank::case::Combination;
use tank::factor::Factor;
use tank::ingredients::{Ingredients, Ordinate, Recipe, Response, Rule, Share};
use tank::quantity::Quantity;

use super::Run;
use super::accelerations::{Accelerations, Periods};
use super::factors::{K, R_WC, importance, response_modification};
use super::forces::Forces;
use crate::api650::ground_motion::DesignSpectrum;
use crate::api650::ingredients::{Action, Liquid, axial, ladders, resultant, wave};
use crate::ordinates::plateau;

impl Run<'_> {
    /// The ingredients of the quantities.
    pub(super) fn ingredients(&self, periods: &Periods, a: &Accelerations, forces: &Forces) -> Vec<Ingredients> {
        let basis = &self.basis;
        let g = basis.case.gravity;
        let (m_i, m_c) = (forces.w_i / g, forces.w_c / g);
        let ordinates = match self.excitation {
            Excitation::Record => Some(self.of_record(periods, a)),
            Excitation::Site => self.of_site(periods, a),
        };
        let mut all = ladders(basis, periods.convective, m_i, m_c);
        if let Some(period) = periods.impulsive {
            all.push(Ingredients {
                quantity: Quantity::ImpulsivePeriod,
                recipe: Recipe::UniformWall {
                    thickness: periods.thickness,
                    modulus: basis.case.tank.courses[0].material.youngs_modulus,
                    period,
                },
            });
        }
        let Some([impulsive, convective, of_wave]) = ordinates else { return all };
        let action = Action { impulsive, convective, combination: Combination::Srss };
        let roof = basis.case.tank.roof_height();
        for (quantity, x_i, x_c) in [
            (Quantity::BaseShear, 1.0, 1.0),
            (Quantity::BaseMoment, forces.x_i, forces.x_c),
            (Quantity::OverturningMoment, forces.x_is, forces.x_cs),
        ] {
            let liquid = Liquid { impulsive: Share::new(m_i, x_i), convective: Share::new(m_c, x_c) };
            all.push(resultant(basis, &action, quantity, liquid, roof));
        }
        all.extend(axial(basis, &all));
        let largest = self.largest_hoop(a);
        let hoop = Response::hoop(
            (action.impulsive, largest.impulsive / g),
            (action.convective, largest.convective / g),
            Combination::Srss,
        );
        let along: Vec<_> =
            (largest.along.iter()).map(|&(z, impulsive, convective)| (z, impulsive / g, convective / g)).collect();
        let hoop = Response { vertical: largest.vertical, ..hoop.along(&along) };
        all.push(Ingredients::response(Quantity::HoopStress, hoop));
        all.push(wave(of_wave, 0.42 * basis.d / g));
        all
    }

    /// Ordinates of impulsive part, convective part and wave under a record.
    fn of_record(&self, periods: &Periods, a: &Accelerations) -> [Ordinate; 3] {
        let case = self.basis.case;
        let (damping, g) = (case.damping, case.gravity);
        let at = |value: f64| Ordinate::at(periods.convective, damping.sloshing, value * g);
        let impulsive = Ordinate::at(0.0, damping.impulsive, a.a_i * g);
        let impulsive = match (periods.impulsive, &case.ground_motion) {
            (Some(period), _) => Ordinate { period: Some(period), ..impulsive },
            (None, motion) => Ordinate {
                rule: Rule::Plateau,
                period: motion.as_ref().map(|motion| plateau(&motion.horizontal, damping.impulsive).0),
                ..impulsive
            },
        };
        [impulsive, at(a.a_c), at(a.a_f)]
    }

    /// The same under the site's spectrum: bounds are what importance, R_w, K and T_L do not explain.
    fn of_site(&self, periods: &Periods, a: &Accelerations) -> Option<[Ordinate; 3]> {
        let site = self.site?;
        let spectrum = DesignSpectrum::new(site).ok()?;
        let (i, g, t_c) = (importance(site.sug).ok()?, self.basis.case.gravity, periods.convective);
        let r_wi = response_modification(self.basis.anchored());
        let ordinate = |period, base: f64, value: f64, factors: &[(Factor, f64)]| {
            let product: f64 = factors.iter().map(|f| f.1).product();
            let mut factors = factors.to_vec();
            factors.push((Factor::Bounds, value / (base * product)));
            Ordinate { period, base: base * g, factors, ..Ordinate::at(0.0, 0.05, 0.0) }
        };
        let one_second = spectrum.s_d1 / t_c;
        let long = (spectrum.t_l / t_c).min(1.0);
        let of_impulsive = [(Factor::Importance, i), (Factor::BehaviourFactor, 1.0 / r_wi)];
        let of_convective = [
            (Factor::DampingCorrection, K),
            (Factor::LongPeriod, long),
            (Factor::Importance, i),
            (Factor::BehaviourFactor, 1.0 / R_WC),
        ];
        // Group 3 has T_L and no importance factor, the others 4 s and the factor.
        let of_wave = match site.sug {
            3 => [(Factor::DampingCorrection, K), (Factor::LongPeriod, long), (Factor::Importance, 1.0)],
            _ => [(Factor::DampingCorrection, K), (Factor::LongPeriod, (4.0 / t_c).min(1.0)), (Factor::Importance, i)],
        };
        Some([
            ordinate(periods.impulsive, spectrum.s_ds, a.a_i, &of_impulsive),
            ordinate(Some(t_c), one_second, a.a_c, &of_convective),
            ordinate(Some(t_c), one_second, a.a_f, &of_wave),
        ])
    }
}
