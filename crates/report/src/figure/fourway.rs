//! The four-way logarithmic spectrum: pseudo-velocity over period with a diagonal grid of displacement and
//! pseudo-acceleration.
//!
//! ```text
//! PSV = ω S_d = S_a / ω ,  ω = 2π/T:   S_d = const is a line of slope −1, S_a = const one of slope +1
//! ```
//!
//! A decade is equally long on both axes, so the diagonals run at 45°.

use tank::units::{Dimension, System};

use super::chart::{Axis, Chart, Frame, Line, Rule};
use super::svg::{Anchor, Svg};
use crate::number::plain;
use files::error::Error;

const DECADE: f64 = 140.0;

/// A curve PSV(T).
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// (T, PSV) in SI.
    pub points: Vec<(f64, f64)>,
    /// CSS classes.
    pub class: String,
    /// Legend text.
    pub label: String,
}

/// Numbers of the grid lines along them, clear of each other.
fn numbers(chart: &Chart, frame: Frame, labels: Vec<Numbered>) -> Svg {
    let mut overlay = Svg::new();
    let mut taken: Vec<(f64, f64)> = Vec::new();
    for (end, start, label) in labels {
        let (a, b) = (chart.place(frame, end), chart.place(frame, start));
        let length = ((a.0 - b.0).powi(2) + (a.1 - b.1).powi(2)).sqrt();
        // Along the line from its right end until clear of other labels.
        let place = (0..6)
            .map(|step| 8.0 + 44.0 * f64::from(step))
            .map(|d| (d, (a.0 + (b.0 - a.0) * d / length, a.1 + (b.1 - a.1) * d / length)))
            .find(|(d, at)| {
                let clear = |t: &(f64, f64)| (t.0 - at.0).hypot(t.1 - at.1) > 46.0;
                d + 40.0 < length && taken.iter().all(clear)
            });
        let Some((_, at)) = place else { continue };
        taken.push(at);
        let degrees = if end.1 > start.1 { -45.0 } else { 45.0 };
        overlay.rotated_text((at.0, at.1 - 2.0), degrees, Anchor::End, "dl halo", &label);
    }
    overlay
}

/// Right and left end of a grid line, and its number.
type Numbered = ((f64, f64), (f64, f64), String);

/// Draws the chart; returns its size and markup.
pub fn draw(curves: &[Curve], rules: Vec<Rule>, gravity: f64) -> Result<((f64, f64), String), Error> {
    let usable = |p: &&(f64, f64)| p.0 > 0.0 && p.1 > 0.0 && p.0.is_finite() && p.1.is_finite();
    let all: Vec<(f64, f64)> = curves.iter().flat_map(|c| c.points.iter().filter(usable).copied()).collect();
    let bound =
        |pick: fn(&(f64, f64)) -> f64, start: f64, join: fn(f64, f64) -> f64| all.iter().map(pick).fold(start, join);
    let t = (nice(bound(|p| p.0, f64::INFINITY, f64::min), false), nice(bound(|p| p.0, 0.0, f64::max), true));
    let top = nice(1.15 * bound(|p| p.1, 0.0, f64::max), true);
    let low = nice(bound(|p| p.1, f64::INFINITY, f64::min), false).max(top / 2e3);
    let v = (low, top);
    let x = Axis::log("Period T", Dimension::Time, t);
    let y = Axis::log("Pseudo-velocity PSV", Dimension::Velocity, v);

    let mut lines = Vec::new();
    let mut labels = Vec::new();
    let length = length();
    for decade in -7..4 {
        for digit in [1.0, 2.0, 5.0] {
            let value = digit * 10f64.powi(decade);
            let class = if digit == 1.0 { "dg" } else { "dg minor" };
            let displacement = |t: f64| std::f64::consts::TAU / t * value * length;
            let acceleration = |t: f64| value * gravity * t / std::f64::consts::TAU;
            if let Some(ends) = clip(t, v, -1.0, displacement(1.0)) {
                if digit == 1.0 {
                    labels.push((ends[1], ends[0], displacement_label(value)));
                }
                lines.push(grid_line(ends, class));
            }
            if let Some(ends) = clip(t, v, 1.0, acceleration(1.0)) {
                if digit == 1.0 {
                    let label = format!("{} g", plain(value, (-decade).max(0) as usize));
                    labels.push((ends[1], ends[0], label));
                }
                lines.push(grid_line(ends, class));
            }
        }
    }
    lines.extend(curves.iter().map(|c| Line {
        points: c.points.iter().filter(usable).copied().collect(),
        class: c.class.clone(),
        label: c.label.clone(),
    }));
    let mut chart = Chart::new(0.0, x, y);
    chart.lines = lines;
    chart.rules = rules;
    let width = 12.0 + DECADE * (t.1 / t.0).log10();
    chart.size = (width + 46.0, 600.0);
    let frame = chart.frame();
    chart.size.0 = frame.left + width;
    let frame = chart.frame();
    let chart = chart.with_plot_height(DECADE * (v.1 / v.0).log10());
    let frame = Frame { bottom: chart.frame().bottom, ..frame };

    let mut markup = chart.draw()?;
    let overlay = numbers(&chart, frame, labels);
    markup.push_str(&overlay.into_markup());
    Ok((chart.size, markup))
}

fn grid_line(ends: [(f64, f64); 2], class: &str) -> Line {
    Line { points: ends.to_vec(), class: class.into(), label: String::new() }
}

/// The length whose powers of ten have lines [m].
fn length() -> f64 {
    match System::current() {
        System::Us => 0.0254,
        System::Si | System::Both => 1.0,
    }
}

fn displacement_label(metres: f64) -> String {
    if System::current() == System::Us {
        format!("{} in", plain(metres, 7))
    } else if metres >= 0.999 {
        format!("{} m", plain(metres, 0))
    } else if metres >= 0.000_999 {
        format!("{} mm", plain(1e3 * metres, 0))
    } else {
        format!("{} mm", plain(1e3 * metres, 4))
    }
}

/// The part of v = at_one·T^slope within both ranges, from its left to its right end.
fn clip(t: (f64, f64), v: (f64, f64), slope: f64, at_one: f64) -> Option<[(f64, f64); 2]> {
    let value = |t: f64| at_one * t.powf(slope);
    let period = |v: f64| (v / at_one).powf(1.0 / slope);
    let (a, b) = (period(v.0), period(v.1));
    let left = t.0.max(a.min(b));
    let right = t.1.min(a.max(b));
    (left < right * 0.999).then(|| [(left, value(left)), (right, value(right))])
}

/// The next 1, 2 or 5 × 10ⁿ.
fn nice(value: f64, up: bool) -> f64 {
    if !value.is_finite() || value <= 0.0 {
        return 1.0;
    }
    let power = 10f64.powf(value.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|s| s * power);
    if up {
        steps.into_iter().find(|s| *s >= value * 0.999).unwrap_or(10.0 * power)
    } else {
        steps.into_iter().rev().find(|s| *s <= value * 1.001).unwrap_or(power)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_end_at_round_numbers() {
        assert_eq!(nice(0.37, true), 0.5);
        assert_eq!(nice(0.37, false), 0.2);
        assert_eq!(nice(1.0, true), 1.0);
        assert!((nice(0.02, false) - 0.02).abs() < 1e-12);
    }

    #[test]
    fn diagonals_end_at_the_frame() {
        // S_d = 0.1 m at T = 1 s: PSV = 0.628 m/s; the line leaves the window at PSV = 1 (T = 0.628) and 0.1 (T = 6.28).
        let ends = clip((0.1, 10.0), (0.1, 1.0), -1.0, std::f64::consts::TAU * 0.1).unwrap();
        assert!((ends[0].0 - 0.6283).abs() < 1e-3 && (ends[0].1 - 1.0).abs() < 1e-12);
        assert!((ends[1].0 - std::f64::consts::TAU).abs() < 1e-2 && (ends[1].1 - 0.1).abs() < 1e-12);
        assert!(clip((0.1, 10.0), (0.1, 1.0), -1.0, 1e6).is_none());
    }
}
