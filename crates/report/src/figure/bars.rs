//! Horizontal bars of one quantity over all methods, the finite-element value as a line through all of them.

use tank::units::Dimension;

use super::Figure;
use super::chart::titled;
use super::svg::{Anchor, Svg};
use super::width::{FONT, text_width};
use crate::methods::Look;
use crate::number::{Scale, ratio};
use crate::table::{Table, columns};
use crate::words::{figures, labels};

const ROW: f64 = 17.0;
const TOP: f64 = 24.0;
const WIDTH: f64 = super::HALF;

/// A bar.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Look of the method.
    pub look: Look,
    /// Value in SI.
    pub value: f64,
    /// Ratio to the finite-element value.
    pub ratio: Option<f64>,
    /// Whether it depends on what the model of its engine cannot say.
    pub outside: bool,
    /// Whether it is a wave higher than the freeboard.
    pub overtops: bool,
    /// Whether it is divided by the factor of a code.
    pub divided: bool,
}

/// Bars of one quantity, in the unit that suits `all` its values (SI): the same for each figure of the quantity; `None`
/// without a finite value.
///
/// * `divided`: which methods divide, and by what, in sentences; empty if none does
pub fn bars(
    id: &str,
    (title, divided): (&str, &str),
    dimension: Dimension,
    bars: &[Bar],
    all: impl IntoIterator<Item = f64>,
) -> Option<Figure> {
    let bars: Vec<&Bar> = bars.iter().filter(|b| b.value.is_finite()).collect();
    let largest = bars.iter().fold(0.0_f64, |m, b| m.max(b.value.abs()));
    if bars.is_empty() || largest == 0.0 {
        return None;
    }
    let scale = Scale::sharing(dimension, all, largest);
    let labels = bars.iter().map(|b| text_width(&b.look.full_label()) * FONT).fold(0.0, f64::max);
    let left = labels.ceil() + 8.0;
    let right = WIDTH - 86.0;
    let height = TOP + ROW * bars.len() as f64 + 4.0;
    let at = |value: f64| left + value.abs() / largest * (right - left);

    let mut svg = Svg::new();
    svg.text((0.0, 12.0), Anchor::Start, "ti", &titled(title, scale.symbol()));
    let mut table = Table::new(columns![
        "Method", "Excitation", title => scale.symbol(), labels::RATIO_TO_ENGINE => "",
    ]);
    for (i, bar) in bars.iter().enumerate() {
        let y = TOP + ROW * i as f64;
        let class = if bar.look.site { "bar site" } else { "bar" };
        svg.text((left - 6.0, y + 10.5), Anchor::End, "lb", &bar.look.full_label());
        svg.rect((left, y + 2.0), (at(bar.value) - left, ROW - 6.0), &format!("{class} {}", bar.look.class));
        let mut text = scale.text(bar.value);
        if bar.overtops {
            text.push('*');
        }
        if bar.divided {
            text.push('†');
        }
        svg.text((WIDTH - 38.0, y + 10.5), Anchor::End, "vl", &text);
        if bar.outside {
            svg.text((WIDTH, y + 10.5), Anchor::End, "vl", "✗");
        }
        let compared = bar.ratio.map_or("–".to_owned(), ratio);
        if let (Some(_), false, false) = (bar.ratio, bar.look.reference, bar.outside) {
            svg.text((WIDTH, y + 10.5), Anchor::End, "mu", &format!("× {compared}"));
        }
        table.row(vec![bar.look.label.clone(), if bar.look.site { "site" } else { "record" }.into(), text, compared]);
    }
    if let Some(fe) = bars.iter().find(|b| b.look.reference) {
        svg.line((at(fe.value), TOP - 2.0), (at(fe.value), height - 4.0), "rf");
    }
    svg.line((left, TOP - 2.0), (left, height - 4.0), "ax");

    let all: Vec<String> = bars.iter().map(|b| format!("{} {}", b.look.full_label(), scale.text(b.value))).collect();
    let description = figures::by_method(title, &all.join("; "), scale.symbol());
    Some(
        Figure::new(id, title, ((WIDTH, height), svg.into_markup()), table)
            .captioned(figures::by_methods(bars.iter().any(|b| b.look.site), bars.iter().any(|b| b.overtops), divided))
            .described(description),
    )
}
