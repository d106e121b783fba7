//! Waterfalls: how factor after factor leads from the finite elements to a procedure, on a logarithmic axis, where equal
//! factors are equally long.

use super::svg::{Anchor, Svg};
use super::width::{FONT, text_width};
use super::{Figure, HALF};
use crate::methods::Look;
use crate::number::{ratio, significant};
use crate::table::{Table, columns};
use crate::words::{factors, labels};

const ROW: f64 = 13.0;
const TOP: f64 = 22.0;
const GAP: f64 = 7.0;
/// Width of the column of factors.
const FACTORS: f64 = 44.0;
/// Least factor, up or down, that has a separate row.
const SMALL: f64 = 1.02;

/// A waterfall.
#[derive(Clone, Debug, PartialEq)]
pub struct Fall {
    /// Look of the method.
    pub look: Look,
    /// Names and factors in the order of exchange.
    pub steps: Vec<(String, f64)>,
    /// Their product.
    pub ratio: f64,
}

/// A row of the drawing: name, ratio before and after.
struct Row {
    name: String,
    from: f64,
    to: f64,
}

/// Waterfalls of one quantity; `None` without one.
pub fn waterfall(id: &str, title: &str, falls: &[Fall]) -> Option<Figure> {
    if falls.is_empty() {
        return None;
    }
    let rows: Vec<Vec<Row>> = falls.iter().map(rows).collect();
    let all = || rows.iter().flatten().flat_map(|row| [row.from, row.to]);
    let low = all().chain([1.0]).fold(f64::INFINITY, f64::min).ln();
    let high = all().chain([1.0]).fold(0.0, f64::max).ln();
    let widest = rows.iter().flatten().map(|row| text_width(&row.name) * FONT);
    let left = widest.fold(0.0, f64::max).ceil() + 8.0;
    let right = HALF - FACTORS;
    let span = (high - low).max(0.02);
    let at = |value: f64| left + (value.ln() - low) / span * (right - left);
    let lines: usize = rows.iter().map(|rows| rows.len() + 1).sum();
    let height = TOP + ROW * lines as f64 + GAP * falls.len() as f64;

    let mut svg = Svg::new();
    svg.text((0.0, 12.0), Anchor::Start, "ti", title);
    svg.line((at(1.0), TOP), (at(1.0), height - 4.0), "rf");
    let mut y = TOP;
    for (fall, rows) in falls.iter().zip(&rows) {
        svg.text((0.0, y + 10.0), Anchor::Start, "vl", &fall.look.full_label());
        svg.text((HALF, y + 10.0), Anchor::End, "vl", &format!("× {}", ratio(fall.ratio)));
        y += ROW;
        for (number, row) in rows.iter().enumerate() {
            let (a, b) = (at(row.from), at(row.to));
            svg.text((left - 6.0, y + 9.5), Anchor::End, "lb", &row.name);
            let class = format!("bar {}{}", fall.look.class, if fall.look.site { " site" } else { "" });
            svg.rect((a.min(b), y + 2.5), ((a - b).abs().max(1.0), ROW - 5.0), &class);
            // From where the next bar begins, or where the last one ends.
            let next = if number + 1 < rows.len() { ROW } else { ROW - 5.0 };
            svg.line((b, y + 2.5), (b, y + next + 2.5), "gd");
            let factor = format!("× {}", ratio(row.to / row.from));
            svg.text((HALF, y + 9.5), Anchor::End, "mu", &factor);
            y += ROW;
        }
        y += GAP;
    }
    let ends: Vec<String> =
        falls.iter().map(|fall| format!("{} {}", fall.look.full_label(), ratio(fall.ratio))).collect();
    Some(
        Figure::new(id, title, ((HALF, height), svg.into_markup()), table(falls))
            .captioned(factors::CAPTION)
            .described(factors::description(title, &ends.join("; "))),
    )
}

/// Rows of a fall: its larger factors, and the others as one.
fn rows(fall: &Fall) -> Vec<Row> {
    let small = |factor: f64| factor < SMALL && factor > 1.0 / SMALL;
    let others: Vec<f64> = fall.steps.iter().map(|s| s.1).filter(|f| small(*f)).collect();
    let mut before = 1.0;
    let mut rows = Vec::new();
    let large = fall.steps.iter().filter(|s| !small(s.1)).cloned();
    let rest = (!others.is_empty()).then(|| (factors::rest(others.len()), others.iter().product::<f64>()));
    for (name, factor) in large.chain(rest) {
        rows.push(Row { name, from: before, to: before * factor });
        before *= factor;
    }
    rows
}

fn table(falls: &[Fall]) -> Table {
    let mut table = Table::new(columns!["Method", factors::FACTOR, "Factor" => "", labels::RATIO_TO_ENGINE => ""]);
    for fall in falls {
        let mut so_far = 1.0;
        for (name, factor) in &fall.steps {
            so_far *= factor;
            table.row(vec![fall.look.full_label(), name.clone(), significant(*factor, 4), significant(so_far, 4)]);
        }
    }
    table
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every factor is in the data; small factors share one row.
    #[test]
    fn small_factors_share_a_row() {
        let steps = [("a", 0.5), ("b", 1.01), ("c", 0.995), ("d", 1.5)];
        let fall = Fall {
            look: Look { label: "Housner".into(), class: "k-housner".into(), site: false, reference: false },
            steps: steps.iter().map(|s| (s.0.to_owned(), s.1)).collect(),
            ratio: steps.iter().map(|s| s.1).product(),
        };
        let rows = rows(&fall);
        assert_eq!(rows.len(), 3);
        assert_eq!(rows[2].name, "2 smaller factors");
        assert!((rows[2].to - fall.ratio).abs() < 1e-15);
        let figure = waterfall("x", "Title", &[fall]).unwrap();
        assert_eq!(figure.table.rows.len(), 4);
        assert!(figure.description.contains("Housner 0.7"), "{}", figure.description);
        assert!(waterfall("x", "Title", &[]).is_none());
    }
}
