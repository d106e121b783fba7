//! The wave at the wall with more sloshing modes than count for it.
//!
//! The sum of all modes does not converge where the surface meets the wall, so that five modes count. In a very broad tank, whose
//! first modes are slow, or under a record that shakes at the frequency of a higher one, that leaves something out: it is reported.

use tank::units::{Dimension, display};

use super::model::Scalar;
use crate::probe::{ModeSelection, Probe};
use crate::response::observe::Extreme;
use crate::response::superpose::Observable;

/// Sloshing modes of the second sum.
const MORE: usize = 8;
/// Difference from which it is reported.
const APART: f64 = 0.05;

/// The wave at both sides with a number of sloshing modes.
pub(super) struct Further {
    modes: usize,
    sides: Vec<Vec<(usize, f64, Probe)>>,
}

/// The waves among `scalars` with eight and with all of the `kept` sloshing modes, where these are more than the `counted` ones.
pub(super) fn further(scalars: &[Scalar<'_>], counted: usize, kept: usize) -> Vec<Further> {
    let mut counts = vec![MORE.min(kept), kept];
    counts.dedup();
    let sides = |modes: usize| {
        let waves = scalars.iter().filter(|s| s.channel.is_wave_at_wall());
        let selected = |&(system, factor, probe): &(usize, f64, &Probe)| {
            let probe = Probe { modes: ModeSelection::FirstSloshing(modes), ..probe.clone() };
            (system, factor, probe)
        };
        waves.map(|s| s.observable.iter().map(selected).collect()).collect()
    };
    let counts = counts.into_iter().filter(|&modes| modes > counted);
    counts.map(|modes| Further { modes, sides: sides(modes) }).collect()
}

impl Further {
    /// What is observed, side by side.
    pub(super) fn observables(&self) -> impl Iterator<Item = Observable<'_>> {
        self.sides.iter().map(|side| side.iter().map(|(system, factor, probe)| (*system, *factor, probe)).collect())
    }
}

/// Number of modes and largest rise [m] of each, from the extremes of all observables in their order.
pub(super) fn rises(further: &[Further], extremes: &[Extreme]) -> Vec<(usize, f64)> {
    let mut rest = extremes.iter();
    let rise = |f: &Further| {
        let own = rest.by_ref().take(f.sides.len());
        (f.modes, own.map(|e| e.max).fold(0.0, f64::max))
    };
    further.iter().map(rise).collect()
}

/// A note where the wave with further modes differs by more than 5 % from that of the counted ones.
pub(super) fn note(wave: Option<f64>, counted: usize, others: &[(usize, f64)]) -> Option<String> {
    let wave = wave.filter(|w| *w > 0.0)?;
    if others.iter().all(|(_, other)| (other / wave - 1.0).abs() <= APART) {
        return None;
    }
    let text = |(modes, rise): &(usize, f64)| format!("{} with {modes}", display(*rise, Dimension::Length));
    let others: Vec<String> = others.iter().map(text).collect();
    Some(format!(
        "The wave height depends on the number of sloshing modes: {} with the {counted} that count, {} (all that are kept are the \
         last). The sum of all modes does not converge where the surface meets the wall; `wave_modes` chooses their number.",
        display(wave, Dimension::Length),
        others.join(", ")
    ))
}

#[cfg(test)]
mod tests {
    use oscillator::record::Record;
    use oscillator::sdof::exact;
    use tank::Shape;
    use tank::case::GroundMotion;

    use super::*;
    use crate::harmonic::test_tanks;
    use crate::linear::analysis::analyse;
    use crate::linear::model::Model;
    use tank::options::LinearOptions;

    /// Zeros of J₁'.
    const ZEROS: [f64; 8] =
        [1.841_184, 5.331_443, 8.536_316, 11.706_005, 14.863_589, 18.015_528, 21.164_370, 24.311_327];

    /// A rigid cylinder, R = 20 m, 2 m deep, under two cycles at the frequency of its seventh mode, against
    ///
    /// ```text
    /// η(R, t) = Σ 2R/((ξ_n² − 1) g) ω_n² u_n(t)        ω_n² = g ξ_n/R tanh(ξ_n H/R), u_n an oscillator under a_g
    /// ```
    ///
    /// by the recurrence of the oscillator crate (Lamb 1932, §191; EC8-4 A.2.1.3: 0.837 R S_e/g for n = 1). A wall of steel 20 cm
    /// thick is not quite rigid, and the eighth mode on a mesh of refinement 4 (20 quadratic elements for four waves) is right within
    /// 0.1 %: 2 %.
    #[test]
    fn waves_with_five_and_eight_modes_are_those_of_the_closed_form() {
        let (radius, depth, g) = (20.0, 2.0, tank::STANDARD_GRAVITY);
        let mut case =
            test_tanks::case(Shape::Cylinder { radius }, &[(3.0, 0.2)], (210e9, 0.3, 7850.0), (1000.0, depth));
        let omega = ZEROS.map(|xi| (g * xi / radius * (xi * depth / radius).tanh()).sqrt());
        let dt = 0.02;
        let shaken = (2.0 * std::f64::consts::TAU / omega[6] / dt) as usize;
        let acceleration: Vec<f64> = (0..=shaken).map(|i| 0.5 * (omega[6] * dt * i as f64).sin()).collect();
        case.ground_motion = Some(GroundMotion {
            horizontal: Record {
                name: "two cycles".into(),
                dt,
                acceleration: acceleration.clone(),
                processing: Vec::new(),
            },
            transverse: None,
            vertical: None,
        });
        let options = LinearOptions { refine: 4.0, mesh_error: false, ..LinearOptions::default() };
        let model = Model::new(&case, &options, false, crate::harmonic::Places::Usual).unwrap();
        let motion = case.ground_motion.as_ref().unwrap();
        let found = analyse(&model, motion, &options, &fem::progress::Silent).unwrap();
        let mut ground = acceleration;
        ground.resize(found.grid.samples, 0.0);
        let expected = |modes: usize| {
            let mut sum = vec![0.0_f64; ground.len()];
            for (xi, omega) in ZEROS.into_iter().zip(omega).take(modes) {
                let factor = 2.0 * radius / ((xi * xi - 1.0) * g) * omega * omega;
                let history = exact(&ground, dt, omega, case.damping.sloshing);
                sum.iter_mut().zip(&history.u).for_each(|(s, u)| *s += factor * u);
            }
            sum.into_iter().fold(0.0_f64, |m, v| m.max(v.abs()))
        };
        let five = found.wave().unwrap();
        let (modes, eight) = found.waves[0];
        assert_eq!(modes, 8);
        for (found, expected) in [(five, expected(5)), (eight, expected(8))] {
            assert!((found / expected - 1.0).abs() < 0.02, "{found} {expected}");
        }
        let text = note(Some(five), 5, &found.waves);
        assert_eq!(text.is_some(), found.waves.iter().any(|(_, w)| (w / five - 1.0).abs() > APART));
    }

    #[test]
    fn a_note_stands_above_five_per_cent_only() {
        assert_eq!(note(Some(1.0), 5, &[(8, 1.04), (12, 0.96)]), None);
        let text = note(Some(1.0), 5, &[(8, 1.04), (12, 1.07)]).unwrap();
        assert!(text.contains("with the 5") && text.contains("with 8") && text.contains("with 12"), "{text}");
    }
}
