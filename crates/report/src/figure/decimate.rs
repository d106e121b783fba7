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

/// Points of a curve that need not run from left to right (a loop): the first, the last, the extremes of both
/// coordinates, and every one that is at least a `part` of the curve's extent away from the one kept before it.
pub fn thin(points: &[[f64; 2]], part: f64) -> Vec<(f64, f64)> {
    let finite: Vec<[f64; 2]> = points.iter().copied().filter(|p| p[0].is_finite() && p[1].is_finite()).collect();
    let Some(last) = finite.len().checked_sub(1) else { return Vec::new() };
    let mut extremes = vec![0, last];
    let mut room = [0.0; 2];
    for k in 0..2 {
        let order = |a: &usize, b: &usize| finite[*a][k].total_cmp(&finite[*b][k]);
        let ends = [(0..=last).min_by(order), (0..=last).max_by(order)].map(|i| i.unwrap_or(0));
        room[k] = part * (finite[ends[1]][k] - finite[ends[0]][k]);
        extremes.extend(ends);
    }
    extremes.sort_unstable();
    let mut kept = finite[0];
    let mut out = Vec::new();
    for (i, p) in finite.iter().enumerate() {
        let far = (0..2).any(|k| (p[k] - kept[k]).abs() > room[k]);
        if far || extremes.binary_search(&i).is_ok() {
            out.push((p[0], p[1]));
            kept = *p;
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn loops_keep_their_shape() {
        let points: Vec<[f64; 2]> = (0..20_000)
            .map(|i| {
                let t = f64::from(i) * 1e-3;
                [t.sin() * (1.0 + 0.1 * t), t.cos()]
            })
            .collect();
        let thinned = thin(&points, 0.01);
        assert!(thinned.len() < 3000 && thinned.len() > 300, "{}", thinned.len());
        let most = |v: &mut dyn Iterator<Item = f64>| v.fold(0.0_f64, |m, x| m.max(x.abs()));
        assert_eq!(most(&mut thinned.iter().map(|p| p.0)), most(&mut points.iter().map(|p| p[0])));
        assert_eq!(thinned[thinned.len() - 1], (points[19_999][0], points[19_999][1]));
        assert!(thin(&[], 0.01).is_empty());
        assert_eq!(thin(&[[1.0, 2.0], [f64::NAN, 0.0]], 0.01), [(1.0, 2.0)]);
    }

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
