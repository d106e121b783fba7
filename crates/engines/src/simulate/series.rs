//! Time histories as columns of `series.csv`.

use oscillator::record::Record;
use tank::case::GroundMotion;
use tank::units::Dimension;

use super::analysis::Analysis;
use results::{Series, SeriesInfo};

/// Columns of `series.csv`: ground motion, then the scalars.
pub fn histories(motion: &GroundMotion, analysis: &Analysis) -> (Vec<SeriesInfo>, Series) {
    let grid = &analysis.grid;
    let (mut info, mut series) = (Vec::new(), Series::default());
    series.time = (0..grid.samples).map(|k| k as f64 * grid.dt).collect();
    let mut push = |entry: SeriesInfo, column: Vec<f64>| {
        series.ids.push(entry.id.clone());
        series.columns.push(column);
        info.push(entry);
    };
    let times = series.time.clone();
    for (entry, column) in ground_motion(motion, &times) {
        push(entry, column);
    }
    for (scalar, history) in &analysis.scalars {
        let (peak, time) = history.extreme.peak();
        let entry = SeriesInfo {
            id: scalar.id.clone(),
            title: scalar.title.clone(),
            dimension: scalar.dimension,
            static_value: scalar.static_value,
            peak,
            time,
        };
        push(entry, history.values.clone());
    }
    (info, series)
}

/// Columns of the ground motion at the given times, those of a vertical record last.
pub(crate) fn ground_motion(motion: &GroundMotion, times: &[f64]) -> Vec<(SeriesInfo, Vec<f64>)> {
    let records = [("", Some(&motion.horizontal)), ("vertical_", motion.vertical.as_ref())];
    let given = records
        .into_iter()
        .filter_map(|(prefix, record)| Some((prefix, record?)));
    given
        .flat_map(|(prefix, record)| ground(prefix, record, times))
        .collect()
}

/// Acceleration, velocity and displacement of the ground at the given times. After the record the ground moves on
/// without acceleration.
fn ground(prefix: &str, record: &Record, times: &[f64]) -> Vec<(SeriesInfo, Vec<f64>)> {
    let motion = record.motion();
    let end = record.acceleration.len() - 1;
    let (v_end, d_end) = (motion.velocity[end], motion.displacement[end]);
    // Sample at or before each time and the share of the next; `None` after the record.
    let places: Vec<Option<(usize, f64)>> = times
        .iter()
        .map(|t| {
            let steps = t / record.dt;
            let nearest = steps.round();
            let steps = if (nearest - steps).abs() < 1e-6 { nearest } else { steps };
            (steps <= end as f64).then_some((steps as usize, steps.fract()))
        })
        .collect();
    let column = |values: &[f64], after: &dyn Fn(f64) -> f64| -> Vec<f64> {
        let value = |(place, t): (&Option<(usize, f64)>, &f64)| match *place {
            Some((i, share)) if share > 0.0 => values[i] + share * (values[i + 1] - values[i]),
            Some((i, _)) => values[i],
            None => after(t - record.duration()),
        };
        places.iter().zip(times).map(value).collect()
    };
    [
        (
            "ground_acceleration",
            "Ground acceleration",
            Dimension::Acceleration,
            column(&record.acceleration, &|_| 0.0),
        ),
        (
            "ground_velocity",
            "Ground velocity",
            Dimension::Velocity,
            column(&motion.velocity, &|_| v_end),
        ),
        (
            "ground_displacement",
            "Ground displacement",
            Dimension::Length,
            column(&motion.displacement, &|t| d_end + v_end * t),
        ),
    ]
    .into_iter()
    .map(|(id, title, dimension, column)| {
        let peak = (0..column.len()).fold(0, |w, i| if column[i].abs() > column[w].abs() { i } else { w });
        let entry = SeriesInfo {
            id: format!("{prefix}{id}"),
            title: if prefix.is_empty() {
                title.into()
            } else {
                format!("{title}, vertical")
            },
            dimension,
            static_value: 0.0,
            peak: column[peak].abs(),
            time: times[peak],
        };
        (entry, column)
    })
    .collect()
}
