//! Line charts: axes, grid and curves by plotters, labels and legend placed by hand.

use plotters::prelude::{ChartBuilder, Circle, Color, IntoDrawingArea, IntoFont, LineSeries, PathElement, Polygon};
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::Span;
pub use super::axis::{Axis, titled};
use super::backend::{ClassBackend, GRID, ink};
use super::decimate::decimate;
use super::svg::{Anchor, Svg};
use super::width::{FONT, text_width};
use super::{Figure, HALF, WIDE};
use crate::table::Table;
use files::error::Error;
use tank::units::Dimension;

const LEGEND_LINE: f64 = 16.0;
const SAMPLE: f64 = 24.0;
/// Room below the plot: ticks and axis title.
const BELOW: f64 = 34.0;

/// A curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Points in SI.
    pub points: Vec<(f64, f64)>,
    /// CSS classes: a palette class (`k-fe`) and, where wanted, a width (`thin`).
    pub class: String,
    /// Legend text; empty for none.
    pub label: String,
}

/// A closed area.
#[derive(Clone, Debug, PartialEq)]
pub struct Band {
    /// Corners in SI.
    pub points: Vec<(f64, f64)>,
    /// CSS classes.
    pub class: String,
    /// Legend text; empty for none.
    pub label: String,
}

/// A vertical rule with a short label at its upper end.
#[derive(Clone, Debug, PartialEq)]
pub struct Rule {
    /// Position on the x axis, SI.
    pub x: f64,
    /// Label.
    pub label: String,
}

impl Rule {
    /// Rules at these values of x with their labels.
    pub fn all(marks: &[(f64, String)]) -> Vec<Rule> {
        let rule = |(x, label): &(f64, String)| Rule { x: *x, label: label.clone() };
        marks.iter().map(rule).collect()
    }
}

/// A marked point.
#[derive(Clone, Debug, PartialEq)]
pub struct Mark {
    /// Position in SI.
    pub at: (f64, f64),
    /// Label.
    pub label: String,
    /// CSS classes.
    pub class: String,
}

/// A line chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Width and height in user units.
    pub size: (f64, f64),
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Areas, drawn first.
    pub bands: Vec<Band>,
    /// Curves.
    pub lines: Vec<Line>,
    /// Vertical rules.
    pub rules: Vec<Rule>,
    /// Marked points.
    pub marks: Vec<Mark>,
}

/// Entry of a legend: whether it is an area, classes, text.
type Entry<'a> = (bool, &'a str, &'a str);

/// Where the plot stands within the figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// Left edge.
    pub left: f64,
    /// Upper edge.
    pub top: f64,
    /// Right edge.
    pub right: f64,
    /// Lower edge.
    pub bottom: f64,
}

impl Chart {
    /// An empty chart of this width.
    pub fn new(width: f64, x: Axis, y: Axis) -> Chart {
        Chart { size: (width, 0.0), x, y, bands: Vec::new(), lines: Vec::new(), rules: Vec::new(), marks: Vec::new() }
    }

    /// An empty chart over the time up to `end` [s], as wide as the text.
    pub fn over_time(start: f64, end: f64, y: Axis) -> Chart {
        Chart::new(WIDE, Axis::exact("Time", Dimension::Time, (start, end), 8), y)
    }

    /// The same over time, half as wide as the text.
    pub fn halved(self) -> Chart {
        let x = Axis::exact("Time", Dimension::Time, self.x.range, 5);
        Chart { size: (HALF, self.size.1), x, ..self }
    }

    /// Adds a history from the start of `time`, thinned to what can be seen, with its classes and legend.
    pub fn history(&mut self, time: &[f64], values: &[f64], class: impl Into<String>, label: impl Into<String>) {
        self.line(decimate(&time[..values.len()], values, (WIDE - 60.0) as usize), class, label);
    }

    /// Adds a curve through points in SI, with its classes and legend.
    pub fn line(&mut self, points: Vec<(f64, f64)>, class: impl Into<String>, label: impl Into<String>) {
        self.lines.push(Line { points, class: class.into(), label: label.into() });
    }

    /// Adds an area with these corners in SI, with its classes and legend.
    pub fn band(&mut self, points: Vec<(f64, f64)>, class: impl Into<String>, label: impl Into<String>) {
        self.bands.push(Band { points, class: class.into(), label: label.into() });
    }

    /// Adds a point in SI with its label and classes.
    pub fn mark(&mut self, at: (f64, f64), label: impl Into<String>, class: impl Into<String>) {
        self.marks.push(Mark { at, label: label.into(), class: class.into() });
    }

    /// The figure of the chart.
    pub fn figure(&self, id: impl Into<String>, title: impl Into<String>, table: Table) -> Result<Figure, Error> {
        Ok(Figure::new(id, title, (self.size, self.draw()?), table))
    }

    /// Where the plot will stand.
    pub fn frame(&self) -> Frame {
        Frame {
            left: (self.y.widest_label() + 10.0).max(34.0),
            top: self.above(),
            right: self.size.0 - 12.0,
            bottom: self.size.1 - BELOW,
        }
    }

    /// Room above the plot: legend, labels of the rules, title of the vertical axis.
    fn above(&self) -> f64 {
        let rules = if self.rules.is_empty() { 0.0 } else { 15.0 };
        20.0 + LEGEND_LINE * self.legend_rows().len() as f64 + rules
    }

    /// Makes the figure so high that the plot itself has this height.
    pub fn with_plot_height(mut self, height: f64) -> Chart {
        self.size.1 = self.above() + height + BELOW;
        self
    }

    /// Point of the figure that stands for a point in SI.
    pub fn place(&self, frame: Frame, at: (f64, f64)) -> (f64, f64) {
        let part = |axis: &Axis, v: f64| (axis.position(v) - axis.range.0) / (axis.range.1 - axis.range.0);
        (
            frame.left + part(&self.x, at.0) * (frame.right - frame.left),
            frame.bottom - part(&self.y, at.1) * (frame.bottom - frame.top),
        )
    }

    /// Draws the chart.
    pub fn draw(&self) -> Result<String, Error> {
        let mut svg = Svg::new();
        let frame = self.frame();
        self.plot(&mut svg, frame).map_err(Error::Report)?;
        self.annotate(&mut svg, frame);
        self.legend(&mut svg);
        Ok(svg.into_markup())
    }

    /// Axes, grid, areas, curves and marks through plotters.
    fn plot(&self, svg: &mut Svg, frame: Frame) -> Result<(), String> {
        let (grid, light, axis, label) = (0, 1, 2, 3);
        let mut classes: Vec<String> = ["gr", "gm", "ax", "tk"].map(String::from).to_vec();
        let first = classes.len();
        classes.extend(self.bands.iter().map(|b| format!("ar {}", b.class)));
        classes.extend(self.lines.iter().map(|l| format!("ln {}", l.class)));
        classes.extend(self.marks.iter().map(|m| format!("dot {}", m.class)));
        classes.push("rl".into());
        let rule = classes.len() - 1;

        let px = |v: f64| (v * GRID).round() as u32;
        let failed = |e: &dyn std::fmt::Display| format!("figure: {e}");
        let root = ClassBackend::new(svg, self.size.0, self.size.1, &classes).into_drawing_area();
        let mut chart = ChartBuilder::on(&root)
            .margin_top(px(frame.top))
            .margin_right(px(self.size.0 - frame.right))
            .margin_bottom(px(BELOW - 20.0))
            .x_label_area_size(px(20.0))
            .y_label_area_size(px(frame.left))
            .build_cartesian_2d(Span::of(&self.x), Span::of(&self.y))
            .map_err(|e| failed(&e))?;
        let text = |h, v| ("sans-serif", FONT * GRID).into_font().color(&ink(label)).pos(Pos::new(h, v));
        let (x, y) = (&self.x, &self.y);
        chart
            .configure_mesh()
            .bold_line_style(ink(grid))
            .light_line_style(ink(light))
            .axis_style(ink(axis))
            .x_label_style(text(HPos::Center, VPos::Top))
            .y_label_style(text(HPos::Right, VPos::Center))
            .x_label_formatter(&|p| x.label_at(*p))
            .y_label_formatter(&|p| y.label_at(*p))
            .set_all_tick_mark_size(px(3.0))
            .draw()
            .map_err(|e| failed(&e))?;
        let at = |p: &(f64, f64)| (x.position(p.0), y.position(p.1));
        for (i, band) in self.bands.iter().enumerate() {
            let corners: Vec<(f64, f64)> = band.points.iter().map(at).collect();
            chart.draw_series(std::iter::once(Polygon::new(corners, ink(first + i)))).map_err(|e| failed(&e))?;
        }
        for r in self.rules.iter().filter(|r| x.holds(r.x)) {
            let ends = [(x.position(r.x), y.range.0), (x.position(r.x), y.range.1)];
            chart.draw_series(std::iter::once(PathElement::new(ends.to_vec(), ink(rule)))).map_err(|e| failed(&e))?;
        }
        for (i, line) in self.lines.iter().enumerate() {
            let style = ink(first + self.bands.len() + i);
            for piece in pieces(&line.points, x, y) {
                chart.draw_series(LineSeries::new(piece, style)).map_err(|e| failed(&e))?;
            }
        }
        for (i, mark) in self.marks.iter().enumerate() {
            let style = ink(first + self.bands.len() + self.lines.len() + i);
            chart
                .draw_series(std::iter::once(Circle::new(at(&mark.at), px(3.2), style.filled())))
                .map_err(|e| failed(&e))?;
        }
        Ok(())
    }

    /// Axis titles and the labels of rules and marks.
    fn annotate(&self, svg: &mut Svg, frame: Frame) {
        let rules = if self.rules.is_empty() { 0.0 } else { 15.0 };
        svg.text((1.0, frame.top - rules - 8.0), Anchor::Start, "at", &self.y.title);
        svg.text((frame.right, self.size.1 - 4.0), Anchor::End, "at", &self.x.title);
        let mut free_from = f64::NEG_INFINITY;
        let mut rules: Vec<&Rule> = self.rules.iter().filter(|r| self.x.holds(r.x)).collect();
        rules.sort_by(|a, b| a.x.total_cmp(&b.x));
        for rule in rules {
            let (x, _) = self.place(frame, (rule.x, 0.0_f64.max(f64::MIN_POSITIVE)));
            let width = text_width(&rule.label) * FONT;
            let left = (x - width / 2.0).max(free_from).min(frame.right - width).max(frame.left + 2.0);
            svg.symbol_text((left, frame.top - 5.0), "lb", &rule.label);
            free_from = left + width + 5.0;
        }
        for mark in &self.marks {
            let (x, y) = self.place(frame, mark.at);
            let width = text_width(&mark.label) * FONT;
            let (anchor, dx) = if x + 8.0 + width > frame.right { (Anchor::End, -7.0) } else { (Anchor::Start, 7.0) };
            let y = y.clamp(frame.top + 10.0, frame.bottom - 4.0);
            if !mark.label.is_empty() {
                svg.text((x + dx, y + 3.5), anchor, "lb halo", &mark.label);
            }
        }
    }

    fn legend_items(&self) -> Vec<Entry<'_>> {
        let bands = self.bands.iter().map(|b| (true, b.class.as_str(), b.label.as_str()));
        let lines = self.lines.iter().map(|l| (false, l.class.as_str(), l.label.as_str()));
        lines.chain(bands).filter(|(_, _, label)| !label.is_empty()).collect()
    }

    fn legend_rows(&self) -> Vec<Vec<(f64, Entry<'_>)>> {
        let mut rows: Vec<Vec<_>> = Vec::new();
        let mut x = f64::INFINITY;
        for item in self.legend_items() {
            let width = SAMPLE + 6.0 + text_width(item.2) * FONT + 14.0;
            if x + width - 14.0 > self.size.0 {
                rows.push(Vec::new());
                x = 1.0;
            }
            if let Some(row) = rows.last_mut() {
                row.push((x, item));
            }
            x += width;
        }
        rows
    }

    fn legend(&self, svg: &mut Svg) {
        for (i, row) in self.legend_rows().into_iter().enumerate() {
            let y = LEGEND_LINE * i as f64 + 8.0;
            for (x, (area, class, label)) in row {
                if area {
                    svg.rect((x, y - 5.0), (SAMPLE, 10.0), &format!("ar {class}"));
                } else {
                    svg.line((x, y), (x + SAMPLE, y), &format!("ln {class}"));
                }
                svg.text((x + SAMPLE + 6.0, y + 3.8), Anchor::Start, "lb", label);
            }
        }
    }
}

/// The parts of a curve that lie within the axes' ranges in x (and are finite).
fn pieces(points: &[(f64, f64)], x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
    let mut out = Vec::new();
    let mut piece = Vec::new();
    for &(px, py) in points {
        let (dx, dy) = (x.position(px), y.position(py));
        if x.holds(px) && dx.is_finite() && dy.is_finite() && y.holds(py) {
            piece.push((dx, dy));
        } else if !piece.is_empty() {
            out.push(std::mem::take(&mut piece));
        }
    }
    if !piece.is_empty() {
        out.push(piece);
    }
    out
}
