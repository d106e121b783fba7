//! A small SVG writer: coordinates with one decimal, text escaped, looks by CSS class only.

use std::fmt::Write;

pub use files::text::xml as escape;

/// Horizontal anchor of a text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the point.
    Start,
    /// The text is centred on the point.
    Middle,
    /// The text ends at the point.
    End,
}

/// SVG markup under construction.
#[derive(Clone, Debug, Default)]
pub struct Svg {
    markup: String,
}

impl Svg {
    /// An empty drawing.
    pub fn new() -> Svg {
        Svg::default()
    }

    /// The markup.
    pub fn into_markup(self) -> String {
        self.markup
    }

    /// Appends markup of another writer.
    pub fn append(&mut self, markup: &str) {
        self.markup.push_str(markup);
    }

    /// A straight line.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), class: &str) {
        let _ = write!(
            self.markup,
            r#"<path class="{}" d="M{} {}L{} {}"/>"#,
            escape(class),
            n(from.0),
            n(from.1),
            n(to.0),
            n(to.1)
        );
    }

    /// A polyline, or a polygon if `closed`.
    pub fn path(&mut self, points: &[(f64, f64)], closed: bool, class: &str) {
        if points.len() < 2 {
            return;
        }
        let _ = write!(
            self.markup,
            r#"<path class="{}" d="{}{}"/>"#,
            escape(class),
            path_data(points),
            if closed { "Z" } else { "" }
        );
    }

    /// A smooth curve through points: Catmull and Rom's cubics, with the slopes of the chords beside each point.
    pub fn curve(&mut self, points: &[(f64, f64)], class: &str) {
        let Some(&first) = points.first().filter(|_| points.len() > 2) else { return self.path(points, false, class) };
        let at = |i: usize| points.get(i).copied().unwrap_or(first);
        let mut data = format!("M{} {}", n(first.0), n(first.1));
        for i in 0..points.len() - 1 {
            let (before, from, to, after) =
                (at(i.saturating_sub(1)), at(i), at(i + 1), at((i + 2).min(points.len() - 1)));
            let near = |a: f64, b: f64, c: f64| a + (c - b) / 6.0;
            let handles = [
                (near(from.0, before.0, to.0), near(from.1, before.1, to.1)),
                (near(to.0, after.0, from.0), near(to.1, after.1, from.1)),
                to,
            ];
            let texts = handles.map(|(x, y)| format!("{} {}", n(x), n(y)));
            let _ = write!(data, "C{}", texts.join(" "));
        }
        let _ = write!(self.markup, r#"<path class="{}" d="{data}"/>"#, escape(class));
    }

    /// A rectangle.
    ///
    /// * `corner`: the upper left one
    pub fn rect(&mut self, corner: (f64, f64), (width, height): (f64, f64), class: &str) {
        let _ = write!(
            self.markup,
            r#"<rect class="{}" x="{}" y="{}" width="{}" height="{}"/>"#,
            escape(class),
            n(corner.0),
            n(corner.1),
            n(width.max(0.0)),
            n(height.max(0.0))
        );
    }

    /// A circle.
    pub fn circle(&mut self, centre: (f64, f64), radius: f64, class: &str) {
        let _ = write!(
            self.markup,
            r#"<circle class="{}" cx="{}" cy="{}" r="{}"/>"#,
            escape(class),
            n(centre.0),
            n(centre.1),
            n(radius)
        );
    }

    /// A text on the baseline at `at`.
    pub fn text(&mut self, at: (f64, f64), anchor: Anchor, class: &str, text: &str) {
        self.rotated_text(at, 0.0, anchor, class, text);
    }

    /// A text whose `_` begins a subscript that ends with the word (`T_c1 = 2.1 s`).
    pub fn symbol_text(&mut self, at: (f64, f64), class: &str, text: &str) {
        let _ = write!(self.markup, r#"<text class="{}" x="{}" y="{}">"#, escape(class), n(at.0), n(at.1));
        let (base, rest) = text.split_once('_').unwrap_or((text, ""));
        let (sub, tail) = rest.split_once(' ').map_or((rest, ""), |(s, t)| (s, t));
        self.markup.push_str(&escape(base));
        if !sub.is_empty() {
            let _ = write!(self.markup, r#"<tspan class="sub" dy="2">{}</tspan>"#, escape(sub));
        }
        if !tail.is_empty() {
            let _ = write!(self.markup, r#"<tspan dy="-2"> {}</tspan>"#, escape(tail));
        }
        self.markup.push_str("</text>");
    }

    /// A text turned by `degrees` (clockwise) about its anchor point.
    pub fn rotated_text(&mut self, at: (f64, f64), degrees: f64, anchor: Anchor, class: &str, text: &str) {
        let _ = write!(self.markup, r#"<text class="{}" x="{}" y="{}""#, escape(class), n(at.0), n(at.1));
        match anchor {
            Anchor::Start => {}
            Anchor::Middle => self.markup.push_str(r#" text-anchor="middle""#),
            Anchor::End => self.markup.push_str(r#" text-anchor="end""#),
        }
        if degrees != 0.0 {
            let _ = write!(self.markup, r#" transform="rotate({} {} {})""#, n(degrees), n(at.0), n(at.1));
        }
        let _ = write!(self.markup, ">{}</text>", escape(text));
    }
}

/// Path data of a polyline: relative moves with one decimal, accumulated without drift.
pub fn path_data(points: &[(f64, f64)]) -> String {
    let mut data = String::with_capacity(8 * points.len());
    let mut last = (0, 0);
    for (i, &(x, y)) in points.iter().enumerate() {
        let here = (tenth(x), tenth(y));
        if i == 0 {
            let _ = write!(data, "M{} {}", tenths(here.0), tenths(here.1));
            if points.len() > 1 {
                data.push('l');
            }
        } else {
            let (dx, dy) = (here.0 - last.0, here.1 - last.1);
            if i > 1 && dx >= 0 {
                data.push(' ');
            }
            data.push_str(&tenths(dx));
            if dy >= 0 {
                data.push(' ');
            }
            data.push_str(&tenths(dy));
        }
        last = here;
    }
    data
}

/// A coordinate in tenths. Far outside any page it stops, so that differences stay in range.
fn tenth(v: f64) -> i64 {
    (v * 10.0).round().clamp(-1e12, 1e12) as i64
}

/// A whole number of tenths as the shortest decimal (`-.3`, `12`, `4.5`).
fn tenths(value: i64) -> String {
    let sign = if value < 0 { "-" } else { "" };
    let (whole, rest) = (value.abs() / 10, value.abs() % 10);
    match (whole, rest) {
        (0, 0) => "0".into(),
        (_, 0) => format!("{sign}{whole}"),
        (0, _) => format!("{sign}.{rest}"),
        _ => format!("{sign}{whole}.{rest}"),
    }
}

/// A coordinate with one decimal.
pub fn n(value: f64) -> String {
    tenths(tenth(value))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_through_points_of_a_line_is_the_line() {
        let mut svg = Svg::new();
        svg.curve(&[(0.0, 0.0), (6.0, 12.0), (12.0, 24.0)], "a");
        // Handles on the line: a third of the half chord at the ends, of the chord inside.
        assert_eq!(svg.into_markup(), r#"<path class="a" d="M0 0C1 2 4 8 6 12C8 16 11 22 12 24"/>"#);
    }

    #[test]
    fn path_data_is_short_and_does_not_drift() {
        assert_eq!(path_data(&[(1.0, 2.0), (1.54, 1.8), (12.0, 2.0), (11.0, 2.0)]), "M1 2l.5-.2 10.5 .2-1 0");
        // A third of a tenth per step: after 30 steps the end point is still right to the last printed digit.
        let points: Vec<(f64, f64)> = (0..=30).map(|i| (i as f64 / 30.0, 0.0)).collect();
        let sum: f64 = path_data(&points).split(['l', ' ']).skip(2).step_by(2).map(|t| t.parse::<f64>().unwrap()).sum();
        assert!((sum - 1.0).abs() < 1e-12);
    }

    /// Extreme values still give path data that a viewer can read.
    #[test]
    fn path_data_far_off_the_page_is_finite() {
        let far = path_data(&[(1e300, -1e300), (-1e300, 0.0), (f64::NAN, f64::INFINITY)]);
        assert_eq!(far, "M100000000000 -100000000000l-200000000000 100000000000 100000000000 100000000000");
    }

    #[test]
    fn text_is_escaped() {
        let mut svg = Svg::new();
        svg.text((0.0, 0.0), Anchor::Start, "t", "<script>&\"'");
        assert_eq!(svg.into_markup(), r#"<text class="t" x="0" y="0">&lt;script&gt;&amp;&quot;&#39;</text>"#);
    }
}
