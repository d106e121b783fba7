//! Thinning of long series for drawing: smallest and largest value of every pixel column, in their order.

/// Points of `(time, values)` that draw the same picture on `columns` pixel columns; never drops an extreme value.
pub fn decimate(time: &[f64], values: &[f64], columns: usize) -> Vec<(f64, f64)> {
    let n = time.len().min(values.len());
    if n <= 4 * columns.max(1) {
        return time.iter().copied().zip(values.iter().copied()).collect();
    }
    let (start, span) = (time[0], time[n - 1] - time[0]);
    let column = |t: f64| (((t - start) / span * columns as f64) as usize).min(columns - 1);
    let mut points = Vec::with_capacity(4 * columns);
    let mut first = 0;
    while first < n {
        let here = column(time[first]);
        let mut last = first;
        let (mut low, mut high) = (first, first);
        while last + 1 < n && column(time[last + 1]) == here {
            last += 1;
            if values[last] < values[low] {
                low = last;
            }
            if values[last] > values[high] {
                high = last;
            }
        }
        let mut keep = [first, low.min(high), low.max(high), last].to_vec();
        keep.dedup();
        points.extend(keep.into_iter().map(|i| (time[i], values[i])));
        first = last + 1;
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_survive() {
        let time: Vec<f64> = (0..20_000).map(|i| i as f64 * 0.005).collect();
        let mut values: Vec<f64> = time.iter().map(|t| (37.0 * t).sin()).collect();
        values[12_345] = 5.0;
        values[777] = -4.0;
        let points = decimate(&time, &values, 400);
        assert!(points.len() <= 1600);
        assert!(points.contains(&(time[12_345], 5.0)));
        assert!(points.contains(&(time[777], -4.0)));
        assert!(points.windows(2).all(|w| w[0].0 <= w[1].0));
        assert_eq!(points[0], (time[0], values[0]));
        assert_eq!(points[points.len() - 1], (time[19_999], values[19_999]));
    }

    #[test]
    fn short_series_stay_as_they_are() {
        assert_eq!(decimate(&[0.0, 1.0], &[2.0, 3.0], 100), vec![(0.0, 2.0), (1.0, 3.0)]);
        assert!(decimate(&[], &[], 100).is_empty());
    }
}
