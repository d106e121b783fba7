//! The impulsive mode: the structural modes that move most of the mass.
//!
//! Procedures speak of one impulsive mass at one period. The modes of a tank are many; which of them is meant?
//!
//! ```text
//! dominant   a structural mode of period T_1 whose effective mass m_1 is the largest between T_1/√3 and √3 T_1
//! group      every structural mode with  m ≥ ½ m_1  and  T_1/√3 ≤ T ≤ √3 T_1
//! impulsive  of the groups with half of the mass of the heaviest one the lowest
//! period     T_1                         mass   the sum over the group
//! ```
//!
//! The rule stands in [`results::impulsive`]. The lower one counts of two comparable groups: the walls of a box share the mass among several plate modes,
//! and the highest vectors of a reduced space carry what is left of it.
//!
//! A mass on a spring that is tuned to the wall, a heavy roof for one, splits the impulsive mode into two of comparable mass
//! (μ: ratio of the masses, both springs tuned to ω_0):
//!
//! ```text
//! ω² = ω_0² (1 + μ/2 ± √(μ + μ²/4))
//! ```
//!
//! Both limits lie half way between two closed forms. In a perfect split (μ → 0) masses and periods are equal. Of a uniform
//! cantilever that is not split, the second mode has at most 0.31 of the first one's mass (bending, 0.188/0.613; shear 1/9) and
//! at most a third of its period (shear 1/3; bending 1/6.3). The geometric means are √0.31 ≈ ½ and 1/√3.

use tank::units::{Dimension, display};

use crate::modes::{CoupledMode, Kind};

/// A structural mode among the candidates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Member {
    /// Number within its kind, from 1.
    pub number: usize,
    /// Circular frequency [rad/s].
    pub omega: f64,
    /// Effective mass [kg].
    pub mass: f64,
}

/// The impulsive mode of a tank.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Impulsive {
    /// The mode with the largest effective mass.
    pub dominant: Member,
    /// All modes of the group by number, the dominant one among them.
    pub members: Vec<Member>,
}

impl Impulsive {
    /// The impulsive part of the structural ones among coupled modes.
    pub(crate) fn among(modes: &[CoupledMode]) -> Option<Impulsive> {
        let structural = modes.iter().filter(|m| m.kind == Kind::Structural);
        Impulsive::of(structural.map(|m| Member { number: m.number, omega: m.omega, mass: m.effective_mass() }))
    }

    /// The impulsive part of the structural modes of a tank; `None` without one that moves mass.
    pub(crate) fn of(modes: impl Iterator<Item = Member>) -> Option<Impulsive> {
        let modes: Vec<Member> = modes.collect();
        let pairs: Vec<(f64, f64)> = modes.iter().map(|m| (m.omega, m.mass)).collect();
        let (dominant, members) = results::impulsive::group(&pairs)?;
        Some(Impulsive { dominant: modes[dominant], members: members.into_iter().map(|i| modes[i]).collect() })
    }

    /// Period of the dominant mode [s].
    pub(crate) fn period(&self) -> f64 {
        std::f64::consts::TAU / self.dominant.omega
    }

    /// Effective mass of the group [kg].
    pub(crate) fn mass(&self) -> f64 {
        self.members.iter().map(|m| m.mass).sum()
    }

    /// The group in words, where it is not the first structural mode alone.
    pub(crate) fn note(&self) -> Option<String> {
        let named = |m: &Member| {
            format!(
                "mode {} ({}, {})",
                m.number,
                display(std::f64::consts::TAU / m.omega, Dimension::Time),
                display(m.mass, Dimension::Mass)
            )
        };
        if self.members.len() > 1 {
            let all: Vec<String> = self.members.iter().map(named).collect();
            return Some(format!(
                "The impulsive mode is split: structural {} have comparable effective masses and close periods. The impulsive mass \
                 is that of all, the impulsive period that of mode {}, which has most of it.",
                all.join(" and "),
                self.dominant.number
            ));
        }
        (self.dominant.number > 1).then(|| {
            format!(
                "The impulsive period and mass are those of structural {}: it has the largest effective mass; the modes below it \
                 move less.",
                named(&self.dominant)
            )
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonic::test_tanks;
    use crate::{Options, Simulation, simulate};
    use oscillator::record::Record;
    use results::Mode;
    use tank::case::GroundMotion;
    use tank::{Case, Quantity, Shape};

    /// Plate modes of a box with what is left of the mass in a high one: the first plate mode is meant, with the second beside it.
    #[test]
    fn a_high_rest_is_not_the_impulsive_mode() {
        let modes = [(183.3, 32.8), (263.8, 21.8), (460.7, 13.1), (804.0, 48.1)];
        let members = modes.into_iter().zip(1..).map(|((omega, mass), number)| Member { number, omega, mass });
        let found = Impulsive::of(members).unwrap();
        assert_eq!(found.dominant.number, 1);
        assert_eq!(found.members.len(), 2);
    }

    /// Modes of a mass 1 on a spring 1 that carries a mass μ on a spring μ f²: closed form of the 2 × 2 eigenvalue problem.
    fn pair(mu: f64, f: f64) -> [Member; 2] {
        let [a, b, c] = [1.0 + mu * f * f, -mu.sqrt() * f * f, f * f];
        let root = (0.25 * (a - c).powi(2) + b * b).sqrt();
        [(1, -root), (2, root)].map(|(number, root)| {
            let lambda = 0.5 * (a + c) + root;
            let (x, y) = (b, lambda - a);
            let gamma = (x + mu.sqrt() * y) / x.hypot(y);
            Member { number, omega: lambda.sqrt(), mass: gamma * gamma }
        })
    }

    /// ω² = 1 + μ/2 ± √(μ + μ²/4), the masses add up to 1 + μ: all of it where the pair is tuned.
    #[test]
    fn a_tuned_pair_is_one_group_with_the_whole_mass() {
        for mu in [0.01_f64, 0.02, 0.04] {
            let modes = pair(mu, 1.0);
            for (mode, sign) in modes.iter().zip([-1.0, 1.0]) {
                let expected = 1.0 + 0.5 * mu + sign * (mu + 0.25 * mu * mu).sqrt();
                assert!((mode.omega.powi(2) - expected).abs() < 1e-12);
            }
            let found = Impulsive::of(modes.into_iter()).unwrap();
            assert_eq!(found.members.len(), 2, "{mu}");
            assert!((found.mass() - 1.0 - mu).abs() < 1e-12);
            assert_eq!(found.period(), std::f64::consts::TAU / modes[0].omega);
            let note = found.note().unwrap();
            assert!(note.contains("mode 1") && note.contains("mode 2"), "{note}");
        }
    }

    /// Uncoupled in the limit: a roof on a soft support (f = 0.1) is the first mode with its own small mass; the second has the
    /// wall's, 1 within f². A stiff support (f = 10) makes one mass of both, 1 + μ.
    #[test]
    fn a_detuned_pair_is_not_split() {
        let soft = Impulsive::of(pair(0.05, 0.1).into_iter()).unwrap();
        assert_eq!((soft.dominant.number, soft.members.len()), (2, 1));
        assert!((soft.mass() - 1.0).abs() < 0.02);
        assert!((soft.dominant.omega - 1.0).abs() < 0.01);
        assert!(soft.note().unwrap().contains("structural mode 2"));
        let stiff = Impulsive::of(pair(0.05, 10.0).into_iter()).unwrap();
        assert_eq!((stiff.dominant.number, stiff.members.len()), (1, 1));
        assert!((stiff.mass() - 1.05).abs() < 1e-3);
        assert_eq!(stiff.note(), None);
    }

    /// Modes of a uniform cantilever, which nothing splits: masses of bending 0.613, 0.188, 0.065 with periods 1, 1/6.27, 1/17.5; of
    /// shear 8/π²/(2 n − 1)² with periods 1/(2 n − 1).
    #[test]
    fn higher_modes_of_a_cantilever_are_no_members() {
        let of = |values: &[(f64, f64)]| {
            let modes = values.iter().enumerate();
            Impulsive::of(modes.map(|(i, &(omega, mass))| Member { number: i + 1, omega, mass })).unwrap()
        };
        assert_eq!(of(&[(1.0, 0.613), (6.27, 0.188), (17.5, 0.065)]).members.len(), 1);
        assert_eq!(of(&[(1.0, 0.811), (3.0, 0.090), (5.0, 0.032)]).members.len(), 1);
    }

    /// A steel tank with a roof [m, m, m, kg] and its response to a pulse.
    fn roofed(radius: f64, wall: (f64, f64), fill: f64, roof: f64) -> Simulation {
        let shape = Shape::Cylinder { radius };
        let mut case: Case = test_tanks::case(shape, &[wall], (205e9, 0.3, 7850.0), (1000.0, fill));
        case.tank.roof.mass = roof;
        case.ground_motion = Some(GroundMotion {
            horizontal: Record {
                name: "pulse".into(),
                dt: 0.01,
                acceleration: (0..50).map(|k| (f64::from(k) / 49.0 * std::f64::consts::PI).sin()).collect(),
                processing: Vec::new(),
            },
            transverse: None,
            vertical: None,
        });
        let options = Options { mesh_error: false, ..Options::default() };
        simulate(&case, &options).unwrap()
    }

    fn structural(found: &Simulation) -> Vec<Mode> {
        let modes = found.result.modes.iter();
        modes.filter(|m| m.kind == "structural" && m.harmonic == 1).cloned().collect()
    }

    /// A roof of 200 t on a thin wall above the liquid is the first structural mode; the liquid of 2500 t moves with the second. Without
    /// the roof the liquid's mode is the first, and nearly the same: what couples them is less than the square of the ratio of their
    /// frequencies, (0.135/0.27)² = ¼ of the roof's tenth of the mass.
    #[test]
    fn a_heavy_roof_is_not_the_impulsive_mode() {
        let (with, without) = (roofed(10.0, (12.0, 8e-3), 8.0, 200e3), roofed(10.0, (12.0, 8e-3), 8.0, 0.0));
        let modes = structural(&with);
        assert!(modes[0].effective_mass < 0.2 * modes[1].effective_mass);
        assert_eq!(with.values[&Quantity::ImpulsivePeriod], modes[1].period);
        assert_eq!(with.values[&Quantity::ImpulsiveMass], modes[1].effective_mass);
        assert_eq!(without.values[&Quantity::ImpulsivePeriod], structural(&without)[0].period);
        for (quantity, tolerance) in [(Quantity::ImpulsivePeriod, 0.05), (Quantity::ImpulsiveMass, 0.1)] {
            let ratio = with.values[&quantity] / without.values[&quantity];
            assert!((ratio - 1.0).abs() < tolerance, "{quantity:?}: {ratio}");
        }
        let named = |s: &Simulation| s.notes.iter().any(|n| n.contains("structural mode 2"));
        assert!(named(&with) && !named(&without));
    }

    /// On a slender tank, half full, wall and liquid share the mass: the group has what its members have, and its note names them.
    #[test]
    fn a_split_mode_is_a_group() {
        let found = roofed(5.0, (20.0, 8e-3), 6.0, 50e3);
        let modes = structural(&found);
        let largest = modes.iter().max_by(|a, b| a.effective_mass.total_cmp(&b.effective_mass)).unwrap();
        let shared: Vec<&Mode> = modes
            .iter()
            .filter(|m| m.effective_mass >= 0.5 * largest.effective_mass)
            .filter(|m| (m.period / largest.period).ln().abs() <= 3.0_f64.sqrt().ln())
            .collect();
        assert!(shared.len() > 1, "{modes:?}");
        let sum: f64 = shared.iter().map(|m| m.effective_mass).sum();
        assert!((found.values[&Quantity::ImpulsiveMass] / sum - 1.0).abs() < 1e-12);
        let note = found.notes.iter().find(|n| n.starts_with("The impulsive mode is split"));
        for mode in shared {
            assert!(note.unwrap().contains(&format!("mode {} (", mode.number)), "{note:?}");
        }
    }
}
