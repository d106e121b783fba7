//! Time histories of two engines in one file.

use results::Series;

/// Appends the columns of `other`, their ids prefixed, at the times of `series`, and after these at its own; between its own
/// samples `other` is linear. After its end (an interrupted run, a shorter free vibration) a column is not a number.
pub(crate) fn append(series: &mut Series, other: &Series, prefix: &str) {
    extend(series, &other.time);
    let same = series.time == other.time;
    for (id, column) in other.ids.iter().zip(&other.columns) {
        series.ids.push(format!("{prefix}{id}"));
        series.columns.push(if same {
            column.clone()
        } else {
            series.time.iter().map(|&t| at(&other.time, column, t)).collect()
        });
    }
}

/// Adds the times after the last one of `series`, at which its columns are not numbers.
fn extend(series: &mut Series, time: &[f64]) {
    let Some(&end) = series.time.last() else { return };
    // A rounding beyond the last sample is the last sample.
    let slack = 1e-9 * end.abs().max(1.0);
    let later = &time[time.partition_point(|&t| t <= end + slack)..];
    series.time.extend(later);
    for column in &mut series.columns {
        column.resize(series.time.len(), f64::NAN);
    }
}

/// Value of a sampled function at a time.
fn at(time: &[f64], values: &[f64], t: f64) -> f64 {
    // A rounding beyond the last sample is the last sample.
    let slack = 1e-9 * t.abs().max(1.0);
    match time.partition_point(|&s| s < t - slack) {
        i if i == time.len() => f64::NAN,
        i if (time[i] - t).abs() <= slack => values[i],
        0 => values[0],
        i => {
            let part = (t - time[i - 1]) / (time[i] - time[i - 1]);
            values[i - 1] + part * (values[i] - values[i - 1])
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn series(time: &[f64], values: &[f64]) -> Series {
        Series { time: time.to_vec(), ids: vec!["base_shear".into()], columns: vec![values.to_vec()] }
    }

    #[test]
    fn equal_times_are_copied_and_others_interpolated() {
        let mut both = series(&[0.0, 1.0, 2.0, 3.0], &[0.0, 1.0, 4.0, 9.0]);
        append(&mut both, &series(&[0.0, 1.0, 2.0, 3.0], &[0.0, 2.0, 8.0, 18.0]), "a_");
        append(&mut both, &series(&[0.0, 0.5, 2.0], &[0.0, 1.0, 4.0]), "b_");
        assert_eq!(both.ids, ["base_shear", "a_base_shear", "b_base_shear"]);
        assert_eq!(both.columns[1], [0.0, 2.0, 8.0, 18.0]);
        assert_eq!(both.columns[2][..3], [0.0, 2.0, 4.0]);
        assert!(both.columns[2][3].is_nan());
    }

    #[test]
    fn a_longer_history_adds_its_times() {
        let mut both = series(&[0.0, 1.0], &[0.0, 1.0]);
        append(&mut both, &series(&[0.0, 1.0, 2.0, 3.0], &[0.0, 2.0, 8.0, 18.0]), "a_");
        assert_eq!(both.time, [0.0, 1.0, 2.0, 3.0]);
        assert_eq!(both.columns[1], [0.0, 2.0, 8.0, 18.0]);
        assert_eq!(both.columns[0][..2], [0.0, 1.0]);
        assert!(both.columns[0][2..].iter().all(|v| v.is_nan()));
    }
}
