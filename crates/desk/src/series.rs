//! `series.csv` as columns.

use serde_json::{Value, json};

/// Most samples of a history; of a longer one every second, third … is taken.
const MOST: usize = 20_000;

/// Columns of a table whose first one is time.
pub(crate) fn columns(text: &str) -> Value {
    let mut lines = text.lines().filter(|line| !line.starts_with('#'));
    let names: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
    let rows: Vec<&str> = lines.filter(|line| !line.is_empty()).collect();
    let every = rows.len().div_ceil(MOST).max(1);
    let mut values: Vec<Vec<Option<f64>>> = vec![Vec::new(); names.len()];
    for row in rows.iter().step_by(every) {
        let cells = row.split(',').map(|cell| cell.parse::<f64>().ok().filter(|value| value.is_finite()));
        for (column, cell) in values.iter_mut().zip(cells.chain(std::iter::repeat(None))) {
            column.push(cell);
        }
    }
    let time = if values.is_empty() { Vec::new() } else { values.remove(0) };
    let column = |head: &&str| match head.split_once(" [") {
        Some((name, unit)) => json!({ "name": name, "unit": unit.trim_end_matches(']') }),
        None => json!({ "name": head, "unit": "" }),
    };
    let columns: Vec<Value> = names.iter().skip(1).map(column).collect();
    json!({ "columns": columns, "time": time, "values": values, "every": every })
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
        let long: String = (0..50_000).map(|i| format!("{i},1\n")).collect();
        let found = columns(&format!("t,x\n{long}"));
        assert_eq!((&found["every"], found["time"].as_array().map(Vec::len)), (&json!(3), Some(16_667)));
    }
}
