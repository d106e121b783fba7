//! `series.csv` as columns.

use serde_json::{Value, json};

/// Most samples of a history. A longer one is read in groups, of which each keeps its smallest and largest value: no peak is lost.
const MOST: usize = 20_000;

/// Columns of a table whose first one is time.
pub(crate) fn columns(text: &str) -> Value {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let rows: Vec<&str> = lines.filter(|line| !line.is_empty()).collect();
    let every = if rows.len() > MOST { rows.len().div_ceil(MOST / 2) } else { 1 };
    let mut values: Vec<Vec<Option<f64>>> = vec![Vec::new(); names.len()];
    for row in &rows {
        let cells = row.split(',').map(|cell| cell.parse::<f64>().ok().filter(|value| value.is_finite()));
        for (column, cell) in values.iter_mut().zip(cells.chain(std::iter::repeat(None))) {
            column.push(cell);
        }
    }
    let mut time = if values.is_empty() { Vec::new() } else { values.remove(0) };
    if every > 1 {
        values = values.iter().map(|column| column.chunks(every).flat_map(extremes).collect()).collect();
        time = time.chunks(every).flat_map(ends).collect();
    }
    let column = |head: &&str| match head.split_once(" [") {
        Some((name, unit)) => json!({ "name": name, "unit": unit.trim_end_matches(']') }),
        None => json!({ "name": head, "unit": "" }),
    };
    let columns: Vec<Value> = names.iter().skip(1).map(column).collect();
    json!({ "columns": columns, "time": time, "values": values, "every": every })
}

/// Smallest and largest value of a group in the order in which they come; as many as [`ends`].
fn extremes(group: &[Option<f64>]) -> Vec<Option<f64>> {
    let by = |a: &(usize, f64), b: &(usize, f64)| a.1.total_cmp(&b.1);
    let known = || group.iter().enumerate().filter_map(|(i, value)| value.map(|value| (i, value)));
    let (Some(low), Some(high)) = (known().min_by(by), known().max_by(by)) else {
        return vec![None; group.len().min(2)];
    };
    let (first, second) = if low.0 <= high.0 { (low.1, high.1) } else { (high.1, low.1) };
    [Some(first), Some(second)].into_iter().take(group.len()).collect()
}

/// Times of the two values of a group: its beginning and its middle.
fn ends(group: &[Option<f64>]) -> Vec<Option<f64>> {
    if group.len() < 2 { group.to_vec() } else { vec![group[0], group[group.len() / 2]] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_are_as_long_as_the_table() {
        let found = columns("time_s,a [m/s2],b\n0,1,2\n0.5,NaN,\n1,-3e2,4\n");
        assert_eq!(found["time"], json!([0.0, 0.5, 1.0]));
        assert_eq!(found["columns"], json!([{ "name": "a", "unit": "m/s2" }, { "name": "b", "unit": "" }]));
        assert_eq!(found["values"], json!([[1.0, null, -300.0], [2.0, null, 4.0]]));
    }

    /// A peak of one sample in a long history, and a group of one sample at its end.
    #[test]
    fn long_histories_keep_their_peaks() {
        let row = |i: u32| match i {
            23_456 => format!("{i},9,-1\n"),
            34_567 => format!("{i},-7,-1\n"),
            _ => format!("{i},{},\n", i % 3),
        };
        let found = columns(&format!("t,x,y\n{}", (0..50_001).map(row).collect::<String>()));
        let numbers = |value: &Value| value.as_array().unwrap().iter().filter_map(Value::as_f64).collect::<Vec<_>>();
        let (time, x, y) = (numbers(&found["time"]), numbers(&found["values"][0]), numbers(&found["values"][1]));
        assert_eq!(found["every"], json!(6));
        assert_eq!((time.len(), x.len()), (16_668, 16_668));
        assert_eq!((x.iter().copied().fold(0.0, f64::max), x.iter().copied().fold(0.0, f64::min)), (9.0, -7.0));
        assert!(time.is_sorted() && (time[0], time[1]) == (0.0, 3.0));
        assert_eq!(y, [-1.0; 4]);
    }
}
