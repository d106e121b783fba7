//! Instants at which states are drawn: peaks of histories, and the times of `analysis.snapshots`.

use crate::FeError;
use results::channel::Side;
use results::{Channel, Run};
use tank::options::linear::{Instant, Peak};

/// The history of a peak, and its title in pictures.
fn history(peak: Peak) -> (Channel, &'static str) {
    match peak {
        Peak::Wave => (Channel::Wave(Side::Front), "largest wave at θ = 0°"),
        Peak::BaseShear => (Channel::BaseShear, "largest base shear"),
        Peak::BaseMoment => (Channel::BaseMoment, "largest base moment"),
        Peak::OverturningMoment => (Channel::OverturningMoment, "largest overturning moment"),
    }
}

/// Title and time [s] of the largest absolute value of a history; none if the run does not have it.
fn moment(result: &Run, peak: Peak) -> Option<(String, f64)> {
    let (channel, title) = history(peak);
    let id = channel.id();
    let series = result.histories.iter().find(|series| series.id == id)?;
    Some((title.to_owned(), series.time))
}

/// Moments of the largest base moment and of the largest wave at the wall.
pub(super) fn extreme_moments(result: &Run) -> Vec<(String, f64)> {
    [Peak::BaseMoment, Peak::Wave].into_iter().filter_map(|peak| moment(result, peak)).collect()
}

/// The moments of `analysis.snapshots`, title and time [s].
///
/// * `end`: end of the histories [s]
///
/// Errors: a time after the end of the histories; the peak of a history that the run does not have.
pub(super) fn asked(result: &Run, end: f64, instants: &[Instant]) -> Result<Vec<(String, f64)>, FeError> {
    let refused =
        |i: usize, found: String, allowed: String| FeError::option(format!("analysis.snapshots[{i}]"), found, allowed);
    let resolve = |(i, instant): (usize, &Instant)| match *instant {
        Instant::At(time) if time > end * (1.0 + 1e-9) => {
            Err(refused(i, format!("{time} s"), format!("at most {end:.3} s, the end of record and free vibration")))
        }
        Instant::At(time) => Ok((format!("at t = {time:.3} s"), time)),
        Instant::Peak(peak) => moment(result, peak)
            .ok_or_else(|| refused(i, peak.name().into(), "a time, or the peak of a history of this run".into())),
    };
    instants.iter().enumerate().map(resolve).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use results::{EngineId, SeriesInfo};

    /// Every name leads to the time of the largest absolute value of its own history, and a time to itself.
    #[test]
    fn peaks_are_those_of_their_histories() {
        let mut run = Run::new(EngineId::Solid);
        for (k, peak) in Peak::ALL.into_iter().enumerate() {
            let info = SeriesInfo::of(history(peak).0, 0.0, (-1.0, 2.0 + k as f64));
            run.histories.push(info);
        }
        let mut all = vec![Instant::At(1.25)];
        all.extend(Peak::ALL.map(Instant::Peak));
        let found = asked(&run, 10.0, &all).expect("within the histories");
        let times: Vec<f64> = found.iter().map(|(_, time)| *time).collect();
        assert_eq!(times, [1.25, 2.0, 3.0, 4.0, 5.0]);
        // The pictures of a run without `snapshots` are not drawn twice.
        let extremes = extreme_moments(&run);
        assert_eq!(extremes, [found[3].clone(), found[1].clone()]);
    }

    #[test]
    fn late_times_and_missing_histories_are_refused() {
        let run = Run::new(EngineId::Solid);
        let late = asked(&run, 10.0, &[Instant::At(10.1)]).expect_err("late").to_string();
        assert!(late.contains("10.1 s") && late.contains("10.000 s"), "{late}");
        let missing = asked(&run, 10.0, &[Instant::Peak(Peak::Wave)]).expect_err("no history");
        assert!(missing.to_string().contains("peak wave"), "{missing}");
    }
}
